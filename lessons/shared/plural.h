#pragma once

#include <string>

#include "viz/lesson.h"

namespace isect::lessons {

/// A count as all numbers are shown: 2345, 48 528 with a thin space.
inline std::string counted(long long n) { return viz::shown(static_cast<double>(n)); }

/// "1 test", "3 tests", "2 boxes", "4 vertices"
inline std::string plural(long long n, const std::string& one) {
  std::string word = one;
  if (n != 1 && word.ends_with("ex"))
    word.replace(word.size() - 2, 2, "ices");
  else if (n != 1)
    word += word.ends_with("x") ? "es" : "s";
  return counted(n) + " " + word;
}

}  // namespace isect::lessons
