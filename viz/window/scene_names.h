#pragma once

#include "viz/player.h"

namespace isect::viz {

/// As markup.
std::string name_of(const Player&, const Handle&);
/// Whether the handle's name stands at it. So many would hide more than they tell: the pointer and the keyboard's ring
/// ask for one.
bool is_named(const Player&, const Handle&);
/// The scene with a name at each handle that is named and has none yet. An arrow's name moves from
/// its tip to its handle. Names at handles keep off their rings. A scene of many objects has the names of those that it
/// is about.
Scene with_names(const Player&);

}  // namespace isect::viz
