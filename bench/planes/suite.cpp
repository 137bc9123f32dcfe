// A plane against balls, boxes, solids and segments: whether they meet, by naive code and exactly.

#include <isect/half_spaces.h>
#include <isect/plane_aabb.h>
#include <isect/plane_sphere.h>
#include <isect/segment_plane.h>

#include "bench/half_spaces/bodies.h"
#include "bench/pair_suite.h"
#include "bench/peer_shapes.h"

namespace isect::bench::planes_suite {
namespace {

using Wall = Plane<double, 3>;
using oracle::Rational, oracle::rational;

template <class Point>
Rational height(const Wall& w, const Point& x) {
  return oracle::dot(rational(w.normal), x) + Rational(w.d);
}

void balls(Session& session) {
  using Ball = Sphere<double, 3>;
  const auto by_distance = [](const Wall& w, const Ball& b) {
    return std::abs(w.normal.dot(b.center) + w.d) <= b.radius * w.normal.norm();
  };
  const auto truly = [](const Wall& w, const Ball& b) {
    const Rational h = height(w, rational(b.center)), n2 = oracle::dot(rational(w.normal), rational(w.normal));
    return Rational(h * h / n2) <= Rational(b.radius) * Rational(b.radius);
  };
  PairContest<Wall, Ball>(session, "plane-sphere")
      .run(
          by_distance, [](const Wall& w, const Ball& b) { return intersects(w, b); }, truly, peers::meet_by_cgal);
}

void boxes(Session& session) {
  using Box = Aabb<double, 3>;
  const auto by_center = [](const Wall& w, const Box& b) {
    const Vector<double, 3> half = (b.hi - b.lo) / 2;
    return std::abs(w.normal.dot((b.lo + b.hi) / 2) + w.d) <= w.normal.cwiseAbs().dot(half);
  };
  const auto truly = [](const Wall& w, const Box& b) {
    bool above = false, below = false;
    for (int corner = 0; corner < 8; ++corner) {
      Rational h = w.d;
      for (int i = 0; i < 3; ++i) h += Rational(w.normal[i]) * Rational((corner >> i & 1 ? b.hi : b.lo)[i]);
      above |= h >= 0, below |= h <= 0;
    }
    return above && below;
  };
  PairContest<Wall, Box>(session, "plane-aabb")
      .run(
          by_center, [](const Wall& w, const Box& b) { return intersects(w, b); }, truly, peers::meet_by_cgal);
}

void solids(Session& session) {
  const auto by_corners = [](const Wall& w, const Body& b) {
    double lo = std::numeric_limits<double>::infinity(), hi = -lo;
    for (const Point<double, 3>& x : b.corners) {
      const double h = w.normal.dot(x) + w.d;
      lo = std::min(lo, h), hi = std::max(hi, h);
    }
    return lo <= 0 && hi >= 0;
  };
  const auto truly = [](const Wall& w, const Body& b) {
    bool above = false, below = false;
    for (const oracle::Place& x : oracle::corners(sides_of(b))) {
      const Rational h = height(w, x);
      above |= h >= 0, below |= h <= 0;
    }
    return above && below;
  };
  PairContest<Wall, Body>(session, "plane-half-spaces", 1 << 10)  // no peer asks this
      .run(
          by_corners, [](const Wall& w, const Body& b) { return relate(w, b.core) != Relation::disjoint; }, truly);
}

void segments(Session& session) {
  using Edge = Segment<double, 3>;
  const auto by_quotient = [](const Edge& s, const Wall& w) {
    const double along = w.normal.dot(s.q - s.p), before = -(w.normal.dot(s.p) + w.d);
    if (along == 0) return before == 0;
    const double t = before / along;
    return 0 <= t && t <= 1;
  };
  const auto truly = [](const Edge& s, const Wall& w) {
    const Rational p = height(w, rational(s.p)), q = height(w, rational(s.q));
    return p == q ? p == 0 : Rational(p / (p - q)) >= 0 && Rational(p / (p - q)) <= 1;
  };
  PairContest<Edge, Wall>(session, "segment-plane")
      .run(
          by_quotient, [](const Edge& s, const Wall& w) { return intersects(s, w); }, truly, peers::meet_by_cgal);
}

}  // namespace

void measure(Session& session) {
  balls(session);
  boxes(session);
  solids(session);
  segments(session);
}

}  // namespace isect::bench::planes_suite
