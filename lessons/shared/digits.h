#pragma once

#include <fmt/format.h>

#include <string>

#include "viz/lesson.h"

namespace isect::lessons {

/// The number with as many digits as distinguish it from `other`.
inline std::string digits(double x, double other) {
  return x != other && viz::shown(x) == viz::shown(other) ? viz::to_text(x) : viz::shown_with_sign(x);
}

/// "(−2, 1.5)", each number as it is shown.
inline std::string coordinates(const viz::Vec2& p) {
  return fmt::format("({}, {})", viz::shown(p.x()), viz::shown(p.y()));
}
inline std::string coordinates(const viz::Vec3& p) {
  return fmt::format("({}, {}, {})", viz::shown(p.x()), viz::shown(p.y()), viz::shown(p.z()));
}

/// The number as it is shown, but a power of ten without its factor 1: "10⁻⁶".
inline std::string as_power(double x) {
  const std::string text = viz::shown(x), one = "1\u2009·\u2009";
  return text.starts_with(one) ? text.substr(one.size()) : text;
}

/// "*d* = 3 > *R* = 2": both with as many digits as distinguish them. If rounding hides the true order, which is
/// `sign`, the text says so instead. Either name may be empty. `unit` follows both numbers.
inline std::string ordered(const std::string& left, double a, const std::string& sign, double b,
                           const std::string& right, const std::string& unit = {}) {
  if (sign == "=") a = b;  // they are equal, whatever rounding made of one of them
  const bool seen = sign == "=" || (sign == ">" ? a > b : a < b);
  if (!seen)
    return left + " " + sign + " " + right + ", rounded to " + digits(a, b) + unit + " and " + digits(b, a) + unit;
  return left + " = " + digits(a, b) + unit + " " + sign + " " + right + " = " + digits(b, a) + unit;
}

}  // namespace isect::lessons
