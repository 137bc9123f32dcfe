#pragma once
// What is put under the microscope: a naive test and the exact one, asked of one floating-point neighbour after
// another.

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "lessons/shared/microscope.h"
#include "viz/lesson.h"

namespace isect::lessons::robustness_lesson {

/// Verdicts are -1, 0 or 1: left, on, right; or no, touching, yes.
struct Setting {
  std::string title;                  ///< "On which side of a line?"
  std::string naive;                  ///< the text under test
  std::string cell;                   ///< what one cell is
  std::string given;                  ///< what stays as it is: with it, and the point, each verdict can be checked
  std::string why;                    ///< why it fails, in one or two sentences
  std::string consequence;            ///< how a wrong verdict harms code that relies on it
  std::string measured;               ///< the suite whose measurements show the cost of exactness
  bool has_on = false;                ///< the naive test can answer 0, too: then missing a 0 is an error as well
  std::vector<std::string> verdicts;  ///< of -1, 0, 1
  viz::Scene scene;                   ///< the situation at its own size
  std::function<int(int i, int j)> truth,
      answer;  ///< for the neighbour i to the right and j up, from -half to half

  /// A verdict where no legend stands beside it: "right" alone would be a handle, or the word for correct.
  std::string in_words(int verdict) const {
    const std::string& word = verdicts.at(static_cast<std::size_t>(verdict + 1));
    return word == "left" || word == "right" ? word + " of the line" : word;
  }
};

inline constexpr int half = microscope::half;

/// `test` is one of tests(); `scalar` float or double; the point may be moved.
Setting setting(const std::string& test, const std::string& scalar, const viz::Vec3& p);
const std::vector<std::string>& tests();
viz::Vec3 standard_point(const std::string& test);

/// How the naive test errs on a neighbour. Since a yes/no test cannot say "touching", there either answer is right.
enum class Fault { none, called_on, wrong_side };
Fault fault(const Setting&, int truth, int answer);

/// `look` is the neighbour that the question is about, in steps to the right and up. (telling.cpp)
viz::Walk tell(const std::string& scalar, const Setting&, const std::array<int, 2>& look);

/// The text before the first step, and the card after the last one. (closing.cpp)
const std::string& opening();
const viz::Closing& closing();

}  // namespace isect::lessons::robustness_lesson
