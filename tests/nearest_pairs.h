#pragma once
// The features at which two segments are nearest, in rationals: by the places of points, which divisions find.

#include <algorithm>
#include <vector>

#include <isect/nearest_features.h>
#include "bench/capsule_capsule/oracle.h"
#include "bench/random.h"

namespace isect::tests {

using oracle::Rational;
using Stretch3 = oracle::Stretch<3>;

/// Whole coordinates up to 3 in size: ends that coincide, parallel segments and ties are frequent.
inline Point<double, 3> whole_point(bench::Random& random) {
  return {double(random.integer(-3, 3)), double(random.integer(-3, 3)), double(random.integer(-3, 3))};
}
inline Segment<double, 3> whole_segment(bench::Random& random) { return {whole_point(random), whole_point(random)}; }

inline Stretch3 stretch(const Segment<double, 3>& x) { return oracle::stretch(Capsule<double, 3>{x.p, x.q, 0}); }

inline point_segment::Nearest feature(const Stretch3& x, const Rational& t) {
  using point_segment::Nearest;
  const bool a_point = oracle::dot(x.d, x.d) == 0;
  return t <= 0 || a_point ? Nearest::p : t >= 1 ? Nearest::q : Nearest::between;
}
inline Rational place(const oracle::Coordinates<3>& c, const Stretch3& x) {
  using oracle::operator-;
  const Rational length2 = oracle::dot(x.d, x.d);
  return length2 == 0 ? Rational(0) : Rational(oracle::dot(c - x.p, x.d) / length2);
}

/// Where the lines come nearest to each other: the places on both.
struct LinePlaces {
  Rational determinant, on_a, on_b;  ///< the places are 0 if the determinant is
};
inline LinePlaces places_of_lines(const Stretch3& a, const Stretch3& b) {
  using oracle::operator-;
  const oracle::Coordinates<3> w = b.p - a.p;
  const Rational uu = oracle::dot(a.d, a.d), uv = oracle::dot(a.d, b.d), vv = oracle::dot(b.d, b.d);
  LinePlaces found = {uu * vv - uv * uv, 0, 0};
  if (found.determinant == 0) return found;
  found.on_a = (oracle::dot(a.d, w) * vv - uv * oracle::dot(b.d, w)) / found.determinant;
  found.on_b = (found.on_a * uv - oracle::dot(b.d, w)) / vv;
  return found;
}

/// All pairs of features that contain a pair of nearest points which is an end of the set of such pairs.
inline std::vector<nearest_features::Pair> pairs_in_rationals(const Stretch3& a, const Stretch3& b) {
  const Rational least = oracle::distance2<3>(a, b);
  std::vector<nearest_features::Pair> all;
  const auto candidate = [&](const Rational& s, const Rational& t) {
    const nearest_features::Pair pair = {feature(a, s), feature(b, t)};
    if (oracle::distance2(a.at(s), b.at(t)) == least && std::find(all.begin(), all.end(), pair) == all.end())
      all.push_back(pair);
  };
  for (const int end : {0, 1}) {
    candidate(end, place(a.at(end), b));
    candidate(place(b.at(end), a), end);
  }
  const LinePlaces lines = places_of_lines(a, b);
  if (lines.determinant != 0) candidate(lines.on_a, lines.on_b);
  return all;
}

}  // namespace isect::tests
