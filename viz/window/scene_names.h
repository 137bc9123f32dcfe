#pragma once

#include "viz/player.h"

namespace isect::viz {

/// The scene with a name at each handle that has none, but for those that are one of many. An arrow's name moves from
/// its tip to its handle. Names at handles keep off their rings.
Scene with_names(const Player&);

}  // namespace isect::viz
