#pragma once
// How a scene file is written: text for the help of `isect scene` and for its page.

#include <string>

namespace isect::program::scene {

std::string how_written();

}  // namespace isect::program::scene
