#pragma once
// Which presets a check is about.

#include <string>
#include <vector>

#include "app/checks/baselines.h"

namespace isect::program {

struct CheckChoice {
  std::vector<Excerpt> presets;
  std::vector<Failure> broken;  ///< presets that can't be read
  Baselines::Reach reach;
};
/// Returns the presets asked for, walked: of the lessons, or of a user's own folder `dir` if it is not empty. Throws
/// viz::BadInput or viz::FileError.
CheckChoice check_choice(const Program&, Selection asked, const std::string& dir);

}  // namespace isect::program
