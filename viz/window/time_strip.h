#pragma once
// The strip below a scene whose shapes move: time is scrubbed there, and runs.

#include "viz/window/window_session.h"

namespace isect::viz {

/// Returns the height of the strip: the same in all steps of a walk; 0 where nothing moves.
float time_room(const Player&, const Rect& whole);
/// Draws a button, the line of time with first contact on it, and where the scene stands; nothing of it while a step
/// shows no motion, and in the second of two panes (not `lead`), which follows the first.
void time_strip(Player&, Ui&, const Rect&, bool lead);
/// Shows first contact or, where that is on show or not known, the begin.
void go_to_contact(Player&, Toast&);
/// Lets time run, or stops it.
void run_time(Player&, Toast&);

}  // namespace isect::viz
