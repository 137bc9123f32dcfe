#pragma once
// The list of a scene's objects, beside its picture: a row each with a switch, a palette of new ones, and the questions
// about one or two that are chosen. What it changes is a version of the scene (Player::show_version), so that undo
// knows it.

#include <functional>
#include <vector>

#include "viz/window/column.h"

namespace isect::viz {

constexpr std::size_t few_objects = 12;  ///< they need no search

/// Whether the list has the place of the pseudocode: in a scene that can be changed, where no line is on show.
bool lists_objects(WindowSession&);
void objects_panel(WindowSession&, const Rect&);
/// What rows and buttons ask for: it is done after all are drawn, as it changes them.
using Afterwards = std::vector<std::function<void()>>;
/// Draws the rows in view, and one beyond them at each end, to which the keyboard can move. (object_rows.cpp)
void object_list(WindowSession&, const Rect&, Afterwards&);
/// Draws the values of a scene's step, and the answers of all its steps, each to be opened. (scene_answers.cpp)
void scene_answers(Column&, Player&);

}  // namespace isect::viz
