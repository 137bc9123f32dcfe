#pragma once
// What a reader's hand does to the camera of a player. Each movement can be undone.

#include "viz/player/player.h"

namespace isect::viz {

/// Turns by a movement of the pointer; a flat lesson does not turn.
void orbit(Player&, const Vec2& pixels);
/// Moves the view so that what was under `from` comes under `to`.
void pan(Player&, const View&, const Vec2& from, const Vec2& to);
/// Scales about a place of the picture; `factor` > 1: closer.
void zoom(Player&, const View&, const Vec2& at, double factor);
/// Glides to the lesson's opening direction, or the step's own, with the whole walk in view. Then the camera counts as
/// not moved.
void frame_all(Player&);
/// Glides to where the whole scene and all of its handles are in view, in the reader's direction.
void frame_shown(Player&);
/// Sets perspective, which a flat lesson has none of.
void set_perspective(Player&, bool);

}  // namespace isect::viz
