#pragma once

#include <cmath>
#include <string>

#include "viz/lesson.h"

namespace isect::lessons {

/// As many digits as tell the number from `other`.
inline std::string digits(double x, double other) {
  if (x == 0 && std::signbit(x)) return "−0";
  return x != other && viz::shown(x) == viz::shown(other) ? viz::to_text(x) : viz::shown(x);
}

}  // namespace isect::lessons
