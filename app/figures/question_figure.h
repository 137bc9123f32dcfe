#pragma once
// A question as a figure: the picture while it is open (viz/walk/question_scene.h).

#include <string>

#include "app/figures/figure_info.h"
#include "app/figures/figure_maker.h"

namespace isect::program {

/// Whether anything is drawn while the question before `step` is open: a chart stays where it was told.
bool has_picture(const viz::Walk&, int step);
/// Returns "ray-sphere/two-roots/03-foot-question": the file of the picture before that step, without its ending.
std::string file_of_question(const Excerpt&, int step);
FigureInfo info_of_question(const Excerpt&, int step);
/// Draws what is shown while the question before `step` is open, framed and laid out as the walk's own steps are.
viz::Drawing draw_question(FigureMaker&, const Excerpt&, int step);

}  // namespace isect::program
