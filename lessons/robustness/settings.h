#pragma once
// What is put under the microscope: a naive test and the exact one, asked of one floating-point neighbour after
// another.

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "viz/lesson.h"

namespace isect::lessons::robustness_lesson {

/// Verdicts are -1, 0 or 1: left, on, right; or no, touching, yes.
struct Setting {
  std::string title;                  ///< "On which side of a line?"
  std::string naive;                  ///< the text under test
  std::string cell;                   ///< what one cell is
  std::string why;                    ///< why it fails, in one or two sentences
  std::vector<std::string> verdicts;  ///< of -1, 0, 1
  viz::Scene scene;                   ///< the situation at its own size
  std::function<int(int i, int j)> truth,
      answer;  ///< for the neighbour i to the right and j up, from -half to half
};

inline constexpr int half = 32;  ///< cells on either side of the middle one

/// `test` is one of tests(); `scalar` float or double; the point may be moved.
Setting setting(const std::string& test, const std::string& scalar, const viz::Vec3& p);
const std::vector<std::string>& tests();
viz::Vec3 standard_point(const std::string& test);

/// `look`: the neighbour that is asked about, so many to the right and up. (telling.cpp)
viz::Walk tell(const std::string& scalar, const Setting&, const std::array<int, 2>& look);

}  // namespace isect::lessons::robustness_lesson
