#pragma once
// An answer of isect::intersect against the truth: wrong verdicts by name, errors of t in ulps.

#include <algorithm>
#include <iomanip>
#include <sstream>
#include <string>

#include <isect/ray_sphere.h>
#include "bench/oracle.h"
#include "bench/ray_sphere/families.h"

namespace isect::bench {

/// What isect::intersect promises of every t.
inline constexpr double promised_ulps = 2.5;

struct Judgement {
  const char* wrong = nullptr;  ///< the first verdict or promise that does not hold
  double ulps = 0;              ///< the largest error of any t
};

template <class S>
Judgement judge(const Interval<S>& range, const RaySphere<S>& answer, const oracle::RaySphere& truth) {
  if (answer.line_roots != truth.line_roots) return {"line_roots"};
  if (answer.origin != truth.origin) return {"origin"};
  if (answer.surface.has_value() != truth.surface.has_value()) return {"surface"};
  if (answer.solid.has_value() != truth.enter.has_value()) return {"solid"};

  Judgement judgement;
  const auto measure = [&](S t, const oracle::Real& real) {
    judgement.ulps = std::max(judgement.ulps, oracle::ulps(t, real));
  };
  if (truth.line_roots > 0) {
    if (!(answer.roots.lo <= answer.roots.hi)) return {"order of the roots"};
    measure(answer.roots.lo, truth.t0);
    measure(answer.roots.hi, truth.t1);
  } else if (answer.roots.lo <= answer.roots.hi) {
    return {"roots of a line that has none"};
  }
  if (truth.surface) {
    if (!range.contains(*answer.surface)) return {"surface outside the range"};
    measure(*answer.surface, *truth.surface);
  }
  if (truth.enter) {
    if (!(answer.solid->lo <= answer.solid->hi)) return {"order of the solid's ends"};
    if (!range.contains(answer.solid->lo) || !range.contains(answer.solid->hi)) return {"solid outside the range"};
    measure(answer.solid->lo, *truth.enter);
    measure(answer.solid->hi, *truth.leave);
  }
  return judgement;
}

/// The case in full precision, as hexadecimal numbers to paste into a test.
template <class S, int N>
std::string text(const RaySphereCase<S, N>& c) {
  std::ostringstream out;
  out << std::hexfloat;
  const auto vector = [&out](const char* name, const Vector<S, N>& v) {
    out << name << '{';
    for (int i = 0; i < N; ++i) out << (i > 0 ? ", " : "") << v[i];
    out << '}';
  };
  vector("origin ", c.ray.origin);
  vector(" direction ", c.ray.direction);
  out << " range {" << c.ray.range.lo << ", " << c.ray.range.hi << '}';
  vector(" center ", c.sphere.center);
  out << " radius " << c.sphere.radius;
  return out.str();
}

}  // namespace isect::bench
