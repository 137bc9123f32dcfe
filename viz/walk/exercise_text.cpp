#include "viz/walk/exercise_text.h"

#include "viz/lang/message.h"

namespace isect::viz {

std::string solution_head(const Exercise& e) { return e.program.empty() ? tr("Solution") : tr("Correction"); }

std::string found_text(const Exercise& e, const Parameters& parameters) {
  if (!e.verdicts) return {};
  const TwoVerdicts said = e.verdicts(parameters);
  return tr("The program says {program}, the exact test {exact}.", {{"program", said.program}, {"exact", said.exact}});
}

}  // namespace isect::viz
