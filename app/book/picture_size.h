#pragma once
// How large the pictures of a page are, in points.

#include <string>

#include "viz/compose.h"

namespace isect::program::book {

/// Of a scene's picture; height 0: what a chart needs. Its texts have 9, which are 11 pixels where a phone has 330
/// across.
viz::PaperSize picture_size(const viz::Scene&);
/// The attributes of its <figure>: a wider picture is moved rather than made smaller where there is less room.
std::string attributes_of_picture(double width, double height);

}  // namespace isect::program::book
