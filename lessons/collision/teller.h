#pragma once
// What the three ways to find pairs share: a step for each test, and what they cost together.

#include "lessons/collision/methods.h"
#include "lessons/shared/script.h"

namespace isect::lessons::collision_lesson {

class Teller {
 protected:
  Teller(const Boxes&, const std::string& title, std::vector<std::string> lines);

  viz::Step& add(const std::string& slug, const std::string& title, int line, const std::string& caption,
                 const std::string& formula = {});
  /// A pair was tested; `yes` and `no` are the lines that say so.
  viz::Step& tested(int i, int j, bool overlap, int yes, int no);
  void total(int line, const std::string& caption);

  const Boxes& boxes_;
  Script script_;
  Drawn drawn_;
  int tests_ = 0;
};

}  // namespace isect::lessons::collision_lesson
