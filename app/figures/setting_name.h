#pragma once
// The name of a setting made by hand, so that its figures have a folder of their own.

#include <string>

#include "viz/lesson.h"

namespace isect::program {

/// Returns "+origin=-4,1,0+radius=1.25": what `to` changes in `from`, by name; empty if it changes nothing. It suits a
/// file's name, and is short: a long one ends in a digest. The same change has the same name, another change another.
std::string name_of_change(const viz::Parameters& from, const viz::Parameters& to);
/// Returns a text as a part of a file's name, by the same rules: as it is, or its beginning and a digest.
std::string plain_name(const std::string& text);

}  // namespace isect::program
