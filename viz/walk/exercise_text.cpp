#include "viz/walk/exercise_text.h"

#include <fmt/format.h>

namespace isect::viz {

std::string solution_head(const Exercise& e) { return e.program.empty() ? "Solution" : "Correction"; }

std::string found_text(const Exercise& e, const Parameters& parameters) {
  if (!e.verdicts) return {};
  const TwoVerdicts said = e.verdicts(parameters);
  return fmt::format("The program says {}, the exact test {}.", said.program, said.exact);
}

}  // namespace isect::viz
