#pragma once
// How a scene file is written, for whoever writes one: in the help of `isect scene` and on its page.

#include <string>

namespace isect::program::scene {

std::string how_written();

}  // namespace isect::program::scene
