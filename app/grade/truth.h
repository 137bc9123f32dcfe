#pragma once
// The true answer of a case, from the core as `isect query` gives it.

#include <optional>
#include <string>

#include "app/grade/cases.h"
#include "app/grade/task.h"

namespace isect::grade {

/// Which sets count: closed ones, or as the lecture note has it where that differs (Task::note).
enum class Convention { closed, note };

struct Truth {
  bool yes = true;                   ///< they meet; the ray hits
  std::string location = {};         ///< of Output::location
  std::vector<double> numbers = {};  ///< t; t_in, t_out; corners; pairs; of Output::nearest a t for each, NaN: none
};

/// Returns nothing where the core has no answer, such as for a polygon without area.
std::optional<Truth> truth(const Task&, const Numbers&, Convention = Convention::closed);
/// Returns the line that a program should answer.
std::string answer_line(const Task&, const Truth&);

}  // namespace isect::grade
