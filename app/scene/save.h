#pragma once
// Other numbers written into the text of a scene file, and nothing else of it changed: comments and layout stay.

#include <string>

#include "app/scene/file.h"

namespace isect::program::scene {

/// `text` is what `file` was read from. Throws viz::BadInput where a number stands in another file.
std::string with_numbers(const std::string& text, const File& file, const viz::Parameters&);

}  // namespace isect::program::scene
