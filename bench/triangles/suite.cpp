// Triangles against balls, capsules and each other: whether they meet, by naive code and exactly.

#include <isect/sphere_triangle.h>
#include <isect/triangle_half_spaces.h>

#include "bench/naive_triangles.h"
#include "bench/pair_suite.h"
#include "bench/peer_shapes.h"
#include "bench/separating_axes.h"
#include "bench/sphere_triangle/oracle.h"

namespace isect::bench::triangles_suite {
namespace {

using Ball = Sphere<double, 3>;
using Rod = Capsule<double, 3>;
using Three = Triangle<double, 3>;
using oracle::Rational;

void balls(Session& session) {
  const auto truly = [](const Ball& s, const Three& x) {
    const oracle::Place c = oracle::rational(s.center);
    return oracle::distance2(oracle::Stretch<3>{c, {0, 0, 0}}, x) <= Rational(s.radius) * Rational(s.radius);
  };
  PairContest<Ball, Three>(session, "sphere-triangle", 1 << 11)  // CGAL's sphere is a surface: no peer asks this
      .run([](const Ball& s, const Three& x) { return naive::meet(s, x); },
           [](const Ball& s, const Three& x) { return intersects(s, x); }, truly);
}

void capsules(Session& session) {
  const auto truly = [](const Rod& s, const Three& x) {
    return oracle::distance2(oracle::stretch(s), x) <= Rational(s.radius) * Rational(s.radius);
  };
  PairContest<Rod, Three>(session, "capsule-triangle", 1 << 11)  // no peer asks this
      .run([](const Rod& s, const Three& x) { return naive::meet(s, x); },
           [](const Rod& s, const Three& x) { return intersects(s, x); }, truly);
}

void triangles(Session& session) {
  const auto by_axes = [](const Three& a, const Three& b) { return !separated(convex(a), convex(b)); };
  const auto truly = [](const Three& a, const Three& b) { return !oracle::clipped(a, oracle::sides(b)).empty(); };
  PairContest<Three, Three>(session, "triangle-triangle", 1 << 11)
      .run(
          by_axes, [](const Three& a, const Three& b) { return intersects(a, b); }, truly, peers::meet_by_cgal);
}

}  // namespace

void measure(Session& session) {
  balls(session);
  capsules(session);
  triangles(session);
}

}  // namespace isect::bench::triangles_suite
