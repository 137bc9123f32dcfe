// Ray against plane: the note's formula, the one by a point of the plane, and the exact call.

#include <isect/ray_plane.h>

#include <isect/methods/ray_plane.h>
#include "bench/pair_contest.h"
#include "bench/ray_plane/families.h"
#include "bench/ray_plane/oracle.h"
#include "bench/session.h"
#ifdef ISECT_PEERS
#include "bench/ray_plane/peers.h"
#endif

namespace isect::bench::ray_plane_suite {
namespace {

template <class S>
using Case = RayPlaneCase<S>;

/// t is a quotient of two sums: each magnifies an error by the sizes of its terms over its own. A ray in the plane
/// has no t: that is a no.
template <class S>
Truth truth(const Case<S>& c) {
  const oracle::RayPlane meeting = oracle::ray_plane(c.ray, c.plane);
  if (!meeting.meets || !meeting.line) return {};
  const oracle::Real t = oracle::real(*meeting.line);
  const Vector<double, 3> n = c.plane.normal.template cast<double>(), o = c.ray.origin.template cast<double>(),
                          d = c.ray.direction.template cast<double>();
  const double along = std::abs(n.dot(d)), sizes = n.cwiseAbs().dot(o.cwiseAbs()) + std::abs(double(c.plane.d));
  return {1, t, sizes / (std::abs(t.nearest) * along) + n.cwiseAbs().dot(d.cwiseAbs()) / along};
}

/// How far the point at t lies off the plane, over the sizes of what is summed.
template <class S>
double residual(const Case<S>& c, double t) {
  using oracle::Rational, oracle::operator+, oracle::operator*;
  if (!std::isfinite(t)) return 0;
  const auto p = oracle::rational<S, 3>(c.ray.origin) + Rational(t) * oracle::rational<S, 3>(c.ray.direction);
  const auto n = oracle::rational<S, 3>(c.plane.normal);
  Rational size = abs(Rational(c.plane.d));
  for (int i = 0; i < 3; ++i) size += abs(Rational(n[i] * p[i]));
  return size == 0 ? 0 : std::abs(static_cast<double>(Rational((oracle::dot(n, p) + Rational(c.plane.d)) / size)));
}

template <class S>
void compete(Session& session, const NamedDraw<Case<S>>& drawn) {
  CaseFamily<Case<S>> family = family_of<S, Case<S>>("ray-plane", drawn, truth<S>);
  family.residual = residual<S>;
  Contest<S, Case<S>> contest(session, family);
  contest.enter("textbook", [](const Case<S>& c) { return ray_plane::textbook(c.ray, c.plane); }).standard();
  const auto towards = [](S epsilon) {
    return [epsilon](const Case<S>& c) { return ray_plane::towards_point(c.ray, c.plane.normal, c.point, epsilon); };
  };
  contest.enter("by a point", towards(S(0)));
  contest.enter("by a point, epsilon 1e-6", towards(S(1e-6)));
  contest.enter("exact", [](const Case<S>& c) { return intersect(c.ray, c.plane).t; })
      .exact()
      .fallback(
          [](const Case<S>& c) { return fell_back([&](const auto& trace) { intersect(c.ray, c.plane, trace); }); });
#ifdef ISECT_PEERS
  peers::ray_plane<S>(contest, drawn.name);
#endif
  contest.run();
}

}  // namespace

void measure(Session& session) {
  session.aim({.work = "ray-plane with t",
               .test = "ray-plane",
               .theirs = "naive",
               .at_most = 1.5,
               .limit =
                   "Each sum of three products that t is made of may be off by more than 2 ulp in doubles, so both "
                   "are found in two doubles: 42 operations in place of 12, and 26 for their bounds."});
  session.aim_on_hard_input("ray-plane",
                            "Where n.d, or n.o less the plane's offset, cancels to its last bit, t to 2 ulp takes "
                            "three doubles: 1,450 instructions. The naive call is 30.");
  for (const auto& drawn : ray_plane_draws<double>) compete<double>(session, drawn);
  for (const auto& drawn : ray_plane_draws<float>) compete<float>(session, drawn);
}

}  // namespace isect::bench::ray_plane_suite
