#pragma once

#include "viz/player/player.h"

namespace isect::viz {

/// Returns the handle's name as markup.
std::string name_of(const Player&, const Handle&);
/// Whether the handle's name stands at it. If there are many handles, their names would hide too much: they are shown
/// for the pointer and the keyboard's ring.
bool is_named(const Player&, const Handle&);
/// Whether each handle is drawn, and may be named; of more than these only the one under the pointer, or with the
/// keyboard's ring, is.
inline bool draws_handles(const Scene& scene) { return scene.handles.size() <= 400; }
/// The scene with a name at each handle that is named and has none yet. An arrow's name moves from
/// its tip to its handle. Names at handles keep off their rings. A scene of many objects has only the names of those it
/// is about.
Scene with_names(const Player&);

}  // namespace isect::viz
