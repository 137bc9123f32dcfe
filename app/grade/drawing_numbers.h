#pragma once
// Numbers of cases, drawn one after the other.

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "app/grade/cases.h"
#include "bench/random_shapes.h"

namespace isect::grade {

using Kind = bench::Numbers;
using bench::Random;

/// x moved by `steps` ulps; 0 by those of 1.
inline double beside(double x, int steps) { return x == 0 ? std::ldexp(steps, -52) : bench::moved(x, steps); }

/// A case in the making: each function appends what it draws.
class Draw {
 public:
  Draw(Random& source, Kind of) : random(source), kind(of) {}

  double number() {
    const double n = bench::number<double>(random, kind);
    return kind == Kind::nudged && std::abs(n) < 0.5 ? std::ldexp(random.integer(-2, 2), -52) : n;  // beside 0
  }
  /// A size from 0 on; small where positions are far away.
  double size() {
    if (kind == Kind::ordinary) return random.uniform(0.2, 0.8);
    return kind == Kind::distant ? random.integer(0, 4) : std::abs(number());
  }
  void put(std::initializer_list<double> more) { x.insert(x.end(), more); }
  void put(const Numbers& more) { x.insert(x.end(), more.begin(), more.end()); }
  void point(int width) {
    for (int i = 0; i < width; ++i) x.push_back(number());
  }
  /// Not 0, and no place: it is never far away.
  void direction(int width) {
    const Kind kept = kind;
    if (kind == Kind::distant) kind = Kind::grid;
    const std::size_t first = x.size();
    do {
      x.resize(first);
      point(width);
    } while (std::all_of(x.begin() + static_cast<std::ptrdiff_t>(first), x.end(), [](double n) { return n == 0; }));
    kind = kept;
  }
  /// The least corner, then the greatest.
  void box(int width) {
    const std::size_t first = x.size();
    point(2 * width);
    for (int i = 0; i < width; ++i)
      if (double& lo = x[first + i], &hi = x[first + width + i]; lo > hi) std::swap(lo, hi);
  }
  void ball() {
    point(3);
    x.push_back(size());
  }

  Random& random;
  Kind kind;
  Numbers x = {};
};

/// Returns a task's own families behind the first of the common ones.
inline std::vector<Family> with_own(std::vector<Family> common, const std::vector<Family>& own) {
  common.insert(common.begin() + 1, own.begin(), own.end());
  return common;
}

/// Families that differ in their numbers only, of whatever `make` draws.
template <Numbers (*make)(Random&, Kind)>
std::vector<Family> of_all_numbers() {
  return {
      {"ordinary", "shapes of ordinary sizes", [](Random& r) { return make(r, Kind::ordinary); }},
      {"small whole numbers", "shapes that touch, coincide and line up", [](Random& r) { return make(r, Kind::grid); }},
      {"an ulp apart", "small whole numbers, up to two ulps off", [](Random& r) { return make(r, Kind::nudged); }},
      {"tenths", "multiples of 0.1, as people type them", [](Random& r) { return make(r, Kind::decimal); }},
      {"far from the origin", "small shapes around 1e8", [](Random& r) { return make(r, Kind::distant); }},
      {"huge", "sizes whose squares overflow", [](Random& r) { return make(r, Kind::huge); }},
      {"tiny", "sizes whose squares vanish", [](Random& r) { return make(r, Kind::tiny); }},
  };
}

}  // namespace isect::grade
