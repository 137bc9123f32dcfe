// A point in shapes: whether it lies within, on the boundary or outside, by naive code and exactly.

#include <isect/point_aabb.h>
#include <isect/point_capsule.h>
#include <isect/point_kdop.h>
#include <isect/point_mesh.h>
#include <isect/point_obb.h>
#include <isect/point_plane.h>
#include <isect/point_sphere.h>

#include "bench/half_spaces/bodies.h"
#include "bench/naive_triangles.h"
#include "bench/pair_suite.h"
#include "bench/peer_shapes.h"

namespace isect::bench::points_suite {
namespace {

using P = Point<double, 3>;
using oracle::Rational, oracle::rational, oracle::operator-;

/// The location by the depth inside: 0 is on the boundary.
template <class Number>
Location by_depth(const Number& depth) {
  return depth > 0 ? Location::in : depth == 0 ? Location::on : Location::out;
}

/// CGAL's answer.
constexpr peers::ByCgal asks_side = {
    "bounded_side", [](const auto& p, const auto& shape) { return by_depth(static_cast<int>(shape.bounded_side(p))); }};

void boxes(Session& session) {
  using Box = Aabb<double, 3>;
  const auto by_center = [](const P& p, const Box& b) {
    const Vector<double, 3> half = (b.hi - b.lo) / 2;
    return by_depth((half - (p - (b.lo + b.hi) / 2).cwiseAbs()).minCoeff());
  };
  const auto truly = [](const P& p, const Box& b) {
    Rational depth = Rational(b.hi[0]) - Rational(p[0]);
    for (int i = 0; i < 3; ++i)
      depth = std::min({depth, Rational(b.hi[i]) - Rational(p[i]), Rational(p[i]) - Rational(b.lo[i])});
    return by_depth(depth);
  };
  PairContest<P, Box>(session, "point-aabb")
      .run(
          by_center, [](const P& p, const Box& b) { return locate(p, b); }, truly, asks_side);
}

void turned_boxes(Session& session) {
  using Box = Obb<double, 3>;
  const auto projected = [](const P& p, const Box& b) {
    return by_depth((b.half - (b.axes.transpose() * (p - b.center)).cwiseAbs()).minCoeff());
  };
  const auto truly = [](const P& p, const Box& b) {
    const oracle::Sides sides = oracle::sides(b);
    Rational depth = sides[0].at(rational(p));
    for (const oracle::Side& s : sides) depth = std::min(depth, s.at(rational(p)));
    return by_depth(depth);
  };
  PairContest<P, Box>(session, "point-obb")
      .run(
          projected, [](const P& p, const Box& b) { return locate(p, b); }, truly);  // no peer asks this
}

void balls(Session& session) {
  using Ball = Sphere<double, 3>;
  const auto by_squares = [](const P& p, const Ball& b) {
    return by_depth(b.radius * b.radius - (p - b.center).squaredNorm());
  };
  const auto truly = [](const P& p, const Ball& b) {
    return by_depth(
        Rational(Rational(b.radius) * Rational(b.radius) - oracle::distance2<3>(rational(p), rational(b.center))));
  };
  PairContest<P, Ball>(session, "point-sphere")
      .run(
          by_squares, [](const P& p, const Ball& b) { return locate(p, b); }, truly, asks_side);
}

void capsules(Session& session) {
  using Rod = Capsule<double, 3>;
  const auto by_foot = [](const P& p, const Rod& c) {
    const Vector<double, 3> d = c.q - c.p;
    const double length2 = d.squaredNorm(), t = length2 > 0 ? std::clamp((p - c.p).dot(d) / length2, 0., 1.) : 0;
    return by_depth(c.radius * c.radius - (p - (c.p + t * d)).squaredNorm());
  };
  const auto truly = [](const P& p, const Rod& c) {
    return by_depth(
        Rational(Rational(c.radius) * Rational(c.radius) - oracle::distance2<3>(rational(p), oracle::stretch(c))));
  };
  PairContest<P, Rod>(session, "point-capsule")
      .run(
          by_foot, [](const P& p, const Rod& c) { return locate(p, c); }, truly);  // no peer asks this
}

void kdops(Session& session) {
  using Slabs = Kdop<double, 3>;
  const auto by_heights = [](const P& p, const Slabs& k) {
    double depth = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < k.slabs.size(); ++i) {
      const double height = k.normals[i].dot(p);
      depth = std::min({depth, height - k.slabs[i].lo, k.slabs[i].hi - height});
    }
    return by_depth(depth);
  };
  const auto truly = [](const P& p, const Slabs& k) {
    const oracle::Sides sides = oracle::sides(k);
    Rational depth = sides[0].at(rational(p));
    for (const oracle::Side& s : sides) depth = std::min(depth, s.at(rational(p)));
    for (const Interval<double>& slab : k.slabs)
      if (slab.lo > slab.hi) depth = -1;
    return by_depth(depth);
  };
  PairContest<P, Slabs>(session, "point-kdop")
      .run(
          by_heights, [](const P& p, const Slabs& k) { return locate(p, k); }, truly);  // no peer asks this
}

/// A plane has no inside: the sign of the height.
void planes(Session& session) {
  using Wall = Plane<double, 3>;
  const auto by_height = [](const P& p, const Wall& w) {
    const double height = w.normal.dot(p) + w.d;
    return (height > 0) - (height < 0);
  };
  const auto truly = [](const P& p, const Wall& w) {
    return truth_of_sign(oracle::sign(Rational(oracle::dot(rational(w.normal), rational(p)) + Rational(w.d))));
  };
  PairContest<P, Wall>(session, "plane-point")
      .run(
          by_height, [](const P& p, const Wall& w) { return side(w, p); }, truly,
          peers::ByCgal{"oriented_side",
                        [](const auto& x, const auto& w) { return static_cast<int>(w.oriented_side(x)); }});
}

/// Decides by the parity of a ray's crossings.
void meshes(Session& session) {
  const auto truly = [](const P& p, const Star& s) {
    return std::ranges::any_of(tetrahedra_of(s),
                               [&](const oracle::Sides& sides) { return oracle::holds(sides, rational(p)); });
  };
  PairContest<P, Star>(session, "point-mesh", 1 << 11)
      .run([](const P& p, const Star& s) { return naive::inside(p, s.mesh); },
           [](const P& p, const Star& s) { return locate(p, s.mesh) != Location::out; }, truly);
}

}  // namespace

void measure(Session& session) {
  boxes(session);
  turned_boxes(session);
  balls(session);
  capsules(session);
  kdops(session);
  planes(session);
  meshes(session);
}

}  // namespace isect::bench::points_suite
