#pragma once
// Mistakes by name: wrong implementations whose answers are held against those of a program. Which one it made is found
// by its answers alone; its source is never read.

#include <string>
#include <string_view>
#include <vector>

#include "app/grade/answers.h"

namespace isect::grade {

struct Mistake {
  std::string task, name;
  Truth (*answer)(const Numbers&);  ///< what a program that makes it says, in doubles
};
/// Returns the mistakes of all tasks; a task may have none.
const std::vector<Mistake>& mistakes();

/// How well a mistake explains the answers of a program.
struct Fit {
  std::string name;
  int same = 0, answered = 0;     ///< of all answers, those that are the mistake's
  int same_wrong = 0, wrong = 0;  ///< of the wrong ones
};
/// Returns the mistakes that explain at least nine in ten of the wrong answers and of all answers, the best first,
/// three at most. `lines`: the program's answers to the first cases; `right`: whether each is right.
std::vector<Fit> fits(const Task&, const std::vector<Case>&, const std::vector<std::string_view>& lines,
                      const std::vector<bool>& right);

std::vector<Mistake> volume_mistakes();
std::vector<Mistake> ray_mistakes();

}  // namespace isect::grade
