#pragma once
// The sizes of the pictures of a page, in points.

#include <string>

#include "viz/compose/compose.h"

namespace isect::program::book {

/// Returns the size of a scene's picture; height 0: as a chart needs. Its texts have 9 pt, which are 11 pixels on a
/// phone 330 pixels wide.
viz::PaperSize picture_size(const viz::Scene&);
/// Returns the attributes of its <figure>: if there is less room, a wider picture is scrolled rather than made smaller.
std::string attributes_of_picture(double width);

}  // namespace isect::program::book
