// Convex solids as half-spaces bound them: against each other, points, balls, capsules and triangles, by naive code and
// exactly; and what a view volume has of balls and boxes.

#include <isect/aabb_frustum.h>
#include <isect/capsule_half_spaces.h>
#include <isect/half_spaces.h>
#include <isect/sphere_frustum.h>
#include <isect/sphere_half_spaces.h>
#include <isect/triangle_half_spaces.h>

#include "bench/half_spaces/bodies.h"
#include "bench/pair_suite.h"
#include "bench/separating_axes.h"

namespace isect::bench::solids_suite {
namespace {

using P = Point<double, 3>;
using Ball = Sphere<double, 3>;
using Rod = Capsule<double, 3>;
using Three = Triangle<double, 3>;
using oracle::Rational, oracle::rational;

void points(Session& session) {
  const auto by_heights = [](const P& p, const Body& b) {
    double least = std::numeric_limits<double>::infinity();
    for (const Plane<double, 3>& plane : b.planes) least = std::min(least, plane.normal.dot(p) + plane.d);
    return least > 0 ? Location::in : least == 0 ? Location::on : Location::out;
  };
  const auto truly = [](const P& p, const Body& b) {
    const oracle::Sides sides = sides_of(b);
    Rational least = sides[0].at(rational(p));
    for (const oracle::Side& s : sides) least = std::min(least, s.at(rational(p)));
    return least > 0 ? Location::in : least == 0 ? Location::on : Location::out;
  };
  PairContest<P, Body>(session, "point-half-spaces")  // no peer asks this
      .run(
          by_heights, [](const P& p, const Body& b) { return locate(p, b.core); }, truly);
}

void bodies(Session& session) {
  const auto by_axes = [](const Body& a, const Body& b) {
    return !separated(Convex{a.corners, a.normals, a.edges}, Convex{b.corners, b.normals, b.edges});
  };
  const auto truly = [](const Body& a, const Body& b) {
    return !oracle::corners(oracle::both(sides_of(a), sides_of(b))).empty();
  };
  PairContest<Body, Body>(session, "half-spaces-half-spaces", 1 << 8)  // no peer takes planes
      .run(
          by_axes, [](const Body& a, const Body& b) { return intersects(a.core, b.core); }, truly);
}

/// The test of view-volume culling: apart if all that lies within r of these points is beyond one plane.
template <class Points>
bool beyond_no_plane(const Points& points, double r, const Body& b) {
  return std::ranges::all_of(b.planes, [&](const Plane<double, 3>& plane) {
    return std::ranges::any_of(points,
                               [&](const P& p) { return plane.normal.dot(p) + plane.d >= -r * plane.normal.norm(); });
  });
}

void balls(Session& session) {
  const auto truly = [](const Ball& s, const Body& b) {
    const oracle::Sides sides = sides_of(b);  // of a solid without a point at times
    return !oracle::corners(sides).empty() &&
           oracle::distance2(rational(s.center), sides) <= Rational(s.radius) * Rational(s.radius);
  };
  PairContest<Ball, Body>(session, "sphere-half-spaces", 1 << 8)  // no peer asks this
      .run([](const Ball& s, const Body& b) { return beyond_no_plane(std::array{s.center}, s.radius, b); },
           [](const Ball& s, const Body& b) { return intersects(s, b.core); }, truly);
}

void capsules(Session& session) {
  const auto truly = [](const Rod& c, const Body& b) {
    const oracle::Sides sides = sides_of(b);
    return !oracle::corners(sides).empty() &&
           oracle::distance2(oracle::stretch(c), sides) <= Rational(c.radius) * Rational(c.radius);
  };
  PairContest<Rod, Body>(session, "capsule-half-spaces", 1 << 6)  // no peer asks this
      .run(
          [](const Rod& c, const Body& b) {
            return beyond_no_plane(std::array{c.p, c.q}, c.radius, b);
          },
          [](const Rod& c, const Body& b) { return intersects(c, b.core); }, truly);
}

void triangles(Session& session) {
  const auto by_axes = [](const Three& x, const Body& b) {
    return !separated(convex(x), Convex{b.corners, b.normals, b.edges});
  };
  const auto truly = [](const Three& x, const Body& b) { return !oracle::clipped(x, sides_of(b)).empty(); };
  PairContest<Three, Body>(session, "triangle-half-spaces", 1 << 10)  // no peer asks this
      .run(
          by_axes, [](const Three& x, const Body& b) { return intersects(x, b.core); }, truly);
}

/// Decides by each plane: the shape is outside if it is beyond one, and inside if it is within all.
template <class Shape, class Beyond, class Within>
Culling culled(const Shape& shape, const Frustum<double>& f, const Beyond& beyond, const Within& within) {
  Culling result = Culling::inside;
  for (const Plane<double, 3>& plane : f.planes) {
    if (beyond(shape, plane)) return Culling::outside;
    if (!within(shape, plane)) result = Culling::crossing;
  }
  return result;
}

void seen_balls(Session& session) {
  const auto reach = [](const Ball& s, const Plane<double, 3>& w) { return s.radius * w.normal.norm(); };
  const auto by_distance = [reach](const Ball& s, const Frustum<double>& f) {
    const auto height = [](const Ball& b, const Plane<double, 3>& w) { return w.normal.dot(b.center) + w.d; };
    return culled(
        s, f, [&](const Ball& b, const auto& w) { return height(b, w) < -reach(b, w); },
        [&](const Ball& b, const auto& w) { return height(b, w) >= reach(b, w); });
  };
  const auto truly = [](const Ball& s, const Frustum<double>& f) {
    const auto far = [](const Ball& b, const Plane<double, 3>& w, int side, bool touches) {  // beyond r on that side
      const oracle::Place n = rational(w.normal);
      const Rational h = oracle::dot(n, rational(b.center)) + Rational(w.d), r = b.radius;
      const Rational over = h * h / oracle::dot(n, n) - r * r;
      return oracle::sign(h) * side >= 0 && (touches ? over >= 0 : over > 0);
    };
    return culled(
        s, f, [&](const Ball& b, const auto& w) { return far(b, w, -1, false); },
        [&](const Ball& b, const auto& w) { return far(b, w, 1, true); });
  };
  PairContest<Ball, Frustum<double>>(session, "sphere-frustum")  // no peer asks this
      .run([by_distance](const Ball& s, const Frustum<double>& f) { return static_cast<int>(by_distance(s, f)); },
           [](const Ball& s, const Frustum<double>& f) { return static_cast<int>(cull(s, f)); }, truly);
}

void seen_boxes(Session& session) {
  using Box = Aabb<double, 3>;
  const auto by_center = [](const Box& box, const Frustum<double>& f) {
    const P center = (box.lo + box.hi) / 2;
    const Vector<double, 3> half = (box.hi - box.lo) / 2;
    const auto height = [&](const Plane<double, 3>& w) { return w.normal.dot(center) + w.d; };
    return culled(
        box, f, [&](const Box&, const auto& w) { return height(w) + w.normal.cwiseAbs().dot(half) < 0; },
        [&](const Box&, const auto& w) { return height(w) - w.normal.cwiseAbs().dot(half) >= 0; });
  };
  const auto truly = [](const Box& box, const Frustum<double>& f) {
    const auto below = [](const Box& b, const Plane<double, 3>& w) {
      int corners = 0;
      for (int k = 0; k < 8; ++k) {
        Rational h = w.d;
        for (int i = 0; i < 3; ++i) h += Rational(w.normal[i]) * Rational((k >> i & 1 ? b.hi : b.lo)[i]);
        corners += h < 0;
      }
      return corners;
    };
    return culled(
        box, f, [&](const Box& b, const auto& w) { return below(b, w) == 8; },
        [&](const Box& b, const auto& w) { return below(b, w) == 0; });
  };
  PairContest<Box, Frustum<double>>(session, "aabb-frustum")  // no peer asks this
      .run([by_center](const Box& b, const Frustum<double>& f) { return static_cast<int>(by_center(b, f)); },
           [](const Box& b, const Frustum<double>& f) { return static_cast<int>(cull(b, f)); }, truly);
}

}  // namespace

void measure(Session& session) {
  points(session);
  bodies(session);
  balls(session);
  capsules(session);
  triangles(session);
  seen_balls(session);
  seen_boxes(session);
}

}  // namespace isect::bench::solids_suite
