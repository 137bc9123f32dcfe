#pragma once
// The questions of a lesson or a playlist, with their pictures, for the files of learning platforms.

#include "app/figures/figure_maker.h"
#include "app/pages/paper.h"
#include "app/platforms/quiz_formats.h"

namespace isect::program::platforms {

/// Returns how its pictures look: on white, twice as fine as a usual screen. `theme` and `width` as on the command
/// line. Throws viz::BadInput.
Style sheet_style(const std::string& theme, const std::string& width);
/// Draws the pictures, each without the data by which isect opens it again, as these name the setting, which may be the
/// answer. `paper`: its parts' steps all ask; `maker`: of that style. On a terminal progress is shown.
QuizSheet sheet_of(const Paper&, FigureMaker&);

}  // namespace isect::program::platforms
