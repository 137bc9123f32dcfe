#pragma once
// Two bodies that move at constant velocities, in rationals: for tests of what the lesson of moving bodies says.

#include <cmath>
#include <string>

#include "bench/rational.h"
#include "tests/lessons/words.h"

namespace isect::tests::moving {

using namespace viz;
using oracle::Rational;

inline const std::string id = "moving-bodies";

inline double number(const Parameters& p, const char* name) { return std::get<double>(p.at(name)); }
inline double coordinate(const Parameters& p, const char* name, int i) { return std::get<Vec3>(p.at(name))[i]; }
inline bool are_balls(const Parameters& p) {
  return text(p, "method") == "balls" || text(p, "method") == "conservative";
}

/// When nothing new happens any more.
inline const Rational long_after = Rational(1e300) * Rational(1e300);

/// The times at which boxes meet, by dividing; none if `in` is after `out`.
struct Times {
  Rational in, out;
  bool meet() const { return in <= out; }
};
inline Times on_axis(const Parameters& p, int i) {
  const double a = coordinate(p, "a", i), b = coordinate(p, "b", i), r_a = number(p, "r_a"), r_b = number(p, "r_b");
  const Rational d = Rational(coordinate(p, "v_b", i)) - Rational(coordinate(p, "v_a", i));
  const Rational lo = Rational(a - r_a) - Rational(b + r_b), hi = Rational(a + r_a) - Rational(b - r_b);
  if (d == 0) return lo <= 0 && hi >= 0 ? Times{-long_after, long_after} : Times{long_after, -long_after};
  return d > 0 ? Times{lo / d, hi / d} : Times{hi / d, lo / d};
}
/// The times from `begin` to `end` at which the boxes meet.
inline Times boxes(const Parameters& p, const Rational& begin, const Rational& end) {
  Times all = {begin, end};
  for (int i = 0; i < 2; ++i) {
    const Times here = on_axis(p, i);
    if (here.in > all.in) all.in = here.in;
    if (here.out < all.out) all.out = here.out;
  }
  return all;
}

/// Two balls seen from a: the squared distance less the square of the reach is A t^2 + 2 B t + C.
struct Balls {
  Rational a = 0, b = 0, c;

  explicit Balls(const Parameters& p) {
    const Rational reach = Rational(number(p, "r_a")) + Rational(number(p, "r_b"));
    c = -reach * reach;
    for (int i = 0; i < 2; ++i) {
      const Rational l = Rational(coordinate(p, "b", i)) - Rational(coordinate(p, "a", i));
      const Rational d = Rational(coordinate(p, "v_b", i)) - Rational(coordinate(p, "v_a", i));
      a += d * d, b += l * d, c += l * l;
    }
  }
  Rational discriminant() const { return b * b - a * c; }
  Rational at(const Rational& t) const { return a * t * t + 2 * b * t + c; }
  bool meet(const Rational& duration) const {
    if (c <= 0) return true;
    if (b >= 0 || discriminant() < 0) return false;
    return at(duration) <= 0 || b + a * duration >= 0;
  }
  /// First contact, if there is one after the start.
  double first() const {
    return static_cast<double>(c) / (std::sqrt(static_cast<double>(discriminant())) - static_cast<double>(b));
  }
};

/// Whether the bodies meet by this time.
inline bool meet(const Parameters& p, const Rational& duration) {
  return are_balls(p) ? Balls(p).meet(duration) : boxes(p, 0, duration).meet();
}
/// When bodies that meet first do so.
inline double first_contact_of(const Parameters& p) {
  if (!are_balls(p)) return static_cast<double>(boxes(p, 0, number(p, "duration")).in);
  return Balls(p).c <= 0 ? 0 : Balls(p).first();
}

/// Whether a text has the number as it is shown; its fifth digit may depend on the last bit.
inline bool shows(const std::string& told, double x) {
  for (const double near : {x, x * (1 - 1e-12), x * (1 + 1e-12)})
    if (says(told, shown(near))) return true;
  return false;
}

/// Calls look(setting, walk) on the presets of this method and on random settings of it; empty: of all.
template <class Look>
void over_settings(const std::string& method, int how_many, const Look& look) {
  for (const Preset& p : lesson(id).presets)
    if (method.empty() || p.group == method) look(p.parameters, lesson(id).walk(p.parameters));
  on_random_settings(id, how_many, [&](Parameters p, const Walk&) {
    if (!method.empty()) p["method"] = method;
    look(p, lesson(id).walk(p));
  });
}

}  // namespace isect::tests::moving
