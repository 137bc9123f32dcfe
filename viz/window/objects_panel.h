#pragma once
// The list of a scene's objects, beside its picture: a row each with a switch, a palette of new ones, and the questions
// about one or two that are chosen. What it changes is a version of the scene (Player::show_version), so that undo
// knows it.

#include "viz/window/column.h"

namespace isect::viz {

/// Whether the list has the place of the pseudocode: in a scene that can be changed, where no line is on show.
bool lists_objects(WindowSession&);
void objects_panel(WindowSession&, const Rect&);
/// Draws the values of a scene's step, and the answers of all its steps, each to be opened.
void scene_answers(Column&, Player&);

}  // namespace isect::viz
