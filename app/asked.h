#pragma once
// A question as a figure: what is drawn while it is open (viz/asking.h).

#include <string>

#include "app/piece.h"

namespace isect::program {

/// Whether anything is drawn while the question before `step` is open: a chart stands where it was told.
bool has_picture(const viz::Walk&, int step);
/// "ray-sphere/two-roots/03-foot-question": the file of what is drawn before that step, without its ending.
std::string file_of_question(const Excerpt&, int step);
/// The excerpt with one step more at the end of its walk: what is shown while the question before `step` is open. So it
/// is framed and laid out as the walk's own steps are, and lies where they do.
Excerpt asking(const Excerpt&, int step);
Piece piece_of_question(const Excerpt&, int step);

}  // namespace isect::program
