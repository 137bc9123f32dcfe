#include "app/grade/mistakes.h"

#include <algorithm>

namespace isect::grade {

const std::vector<Mistake>& mistakes() {
  static const std::vector<Mistake> all = [] {
    std::vector<Mistake> made = volume_mistakes();
    for (Mistake& mistake : ray_mistakes()) made.push_back(std::move(mistake));
    return made;
  }();
  return all;
}

std::vector<Fit> fits(const Task& task, const std::vector<Case>& cases, const std::vector<std::string_view>& lines,
                      const std::vector<bool>& right) {
  std::vector<Fit> found;
  for (const Mistake& mistake : mistakes()) {
    if (mistake.task != task.id) continue;
    Fit fit = {mistake.name};
    for (std::size_t i = 0; i < std::min({cases.size(), lines.size(), right.size()}); ++i) {
      const bool same = marked(task, mistake.answer(cases[i].numbers), lines[i]).fault.empty();
      ++fit.answered, fit.same += same;
      if (!right[i]) ++fit.wrong, fit.same_wrong += same;
    }
    if (fit.wrong > 0 && fit.same_wrong * 10 >= fit.wrong * 9 && fit.same * 10 >= fit.answered * 9)
      found.push_back(std::move(fit));
  }
  std::stable_sort(found.begin(), found.end(), [](const Fit& a, const Fit& b) { return a.same > b.same; });
  // one that explains all is told alone, with its equals
  const auto worse = [&found](const Fit& fit) {
    return fit.same < found.front().same && found.front().same == found.front().answered;
  };
  found.erase(std::remove_if(found.begin(), found.end(), worse), found.end());
  if (found.size() > 3) found.resize(3);
  return found;
}

}  // namespace isect::grade
