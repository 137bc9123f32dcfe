// Polygons in space, cut into triangles, against points, lines, triangles, solids and each other: whether they meet, by
// naive code (any triangle that meets it) and exactly.

#include <isect/polygon_in_space.h>

#include "bench/cylinder_half_spaces/oracle.h"
#include "bench/line_triangle/oracle.h"
#include "bench/naive_triangles.h"
#include "bench/pair_suite.h"
#include "bench/separating_axes.h"
#include "bench/sphere_triangle/oracle.h"
#include "bench/straight_lines.h"

namespace isect::bench::polygons_in_space_suite {
namespace {

using P = Point<double, 3>;
using Three = Triangle<double, 3>;
using Outline = TriangulatedPolygon<double>;
using oracle::Rational, oracle::rational;

template <class Meets>
bool any_triangle(const Outline& polygon, const Meets& meets) {
  for (int i = 0; i < static_cast<int>(polygon.triangles.size()); ++i)
    if (meets(triangle(polygon, i))) return true;
  return false;
}

// Whether a triangle meets the other shape, by naive code; and in rationals.

bool naively(const Three& x, const Sphere<double, 3>& b) { return naive::meet(b, x); }
bool naively(const Three& x, const Capsule<double, 3>& c) { return naive::meet(c, x); }
bool naively(const Three& x, const Body& b) { return !separated(convex(x), b); }
bool naively(const Three& x, const Three& y) { return !separated(convex(x), convex(y)); }
bool naively(const Three& x, const P& p) { return naive::nearest(p, x) == p; }
bool naively(const Three& x, const Line<3>& l) { return naive::crosses(l.p, l.d, l.most, x); }
bool naively(const Three& x, const Outline& b) {
  return any_triangle(b, [&](const Three& y) { return naively(x, y); });
}
/// Whether the axis crosses the triangle, or the nearest point to the axis' middle lies within the solid.
bool about_axis(const Three& x, const P& p, const P& q, double at_p, double at_q) {
  const Vector<double, 3> along = q - p;
  const P near = naive::nearest((p + q) / 2, x);
  const double t = (near - p).dot(along) / along.squaredNorm(), radius = at_p + t * (at_q - at_p);
  return naive::crosses(p, along, 1, x) ||
         (0 <= t && t <= 1 && (near - p - t * along).squaredNorm() <= radius * radius);
}
bool naively(const Three& x, const Cylinder<double>& c) { return about_axis(x, c.p, c.q, c.radius, c.radius); }
bool naively(const Three& x, const Cone<double>& c) { return about_axis(x, c.apex, c.base, 0, c.radius); }

bool truly(const Three& x, const Capsule<double, 3>& c) {
  const Rational r = c.radius;
  return oracle::distance2(oracle::stretch(c), x) <= Rational(r * r);
}
bool truly(const Three& x, const Sphere<double, 3>& b) {
  return truly(x, Capsule<double, 3>{b.center, b.center, b.radius});
}
bool truly(const Three& x, const P& p) { return truly(x, Capsule<double, 3>{p, p, 0}); }
bool truly(const Three& x, const Body& b) { return oracle::relation(x, oracle::sides(b.core)) != Relation::disjoint; }
bool truly(const Three& x, const Three& y) { return oracle::relation(x, oracle::sides(y)) != Relation::disjoint; }
bool truly(const Three& x, const Outline& b) {
  return any_triangle(b, [&](const Three& y) { return truly(x, y); });
}
bool truly(const Three& x, const TrueLine<3>& l) {
  const oracle::Corners v = oracle::corners(x);
  return oracle::dot(l.d, l.d) == 0 ? oracle::in_triangle(l.p, v) : oracle::first_hit(l.p, l.d, l.range, v).has_value();
}
template <class Solid>
bool truly_round(const Three& x, const Solid& solid) {
  const HalfSpaces plate = half_spaces_of(x);
  return oracle::RoundAndSides(oracle::round_solid(solid), oracle::sides(plate)).relation() != Relation::disjoint;
}
bool truly(const Three& x, const Cylinder<double>& c) { return truly_round(x, c); }
bool truly(const Three& x, const Cone<double>& c) { return truly_round(x, c); }

/// The form of a shape that the core takes.
template <class Shape>
const Shape& in_core(const Shape& x) {
  return x;
}
const HalfSpaces& in_core(const Body& x) { return x.core; }

bool has_triangles(const Outline& x) { return !empty(x); }

// CGAL's polygons are plane, and FCL has triangles only: no peer answers this.

/// The polygon comes first.
template <class Shape>
void against(Session& session, const char* test, long most, bool (*wanted)(const Outline&, const Shape&)) {
  PairContest<Outline, Shape>(session, test, most)
      .only(wanted)
      .run([](const Outline& a,
              const Shape& b) { return any_triangle(a, [&](const Three& x) { return naively(x, b); }); },
           [](const Outline& a, const Shape& b) { return relate(a, in_core(b)) != Relation::disjoint; },
           [](const Outline& a, const Shape& b) {
             return any_triangle(a, [&](const Three& x) { return truly(x, b); });
           });
}

template <class Straight>
void along(Session& session, const char* test) {
  PairContest<Straight, Outline>(session, test, 1 << 10)
      .only([](const Straight&, const Outline& b) { return has_triangles(b); })
      .run(
          [](const Straight& s, const Outline& b) {
            const Line<3> l = line(s);
            return any_triangle(b, [&](const Three& x) { return naively(x, l); });
          },
          [](const Straight& s, const Outline& b) { return first_hit(s, b).has_value(); },
          [](const Straight& s, const Outline& b) {
            const TrueLine<3> l = true_line(s);
            return any_triangle(b, [&](const Three& x) { return truly(x, l); });
          });
}

void points(Session& session) {
  PairContest<P, Outline>(session, "point-polygon-in-space", 1 << 10)
      .only([](const P&, const Outline& b) { return has_triangles(b); })
      .run([](const P& p, const Outline& b) { return any_triangle(b, [&](const Three& x) { return naively(x, p); }); },
           [](const P& p, const Outline& b) { return locate(p, b) != Location::out; },
           [](const P& p, const Outline& b) { return any_triangle(b, [&](const Three& x) { return truly(x, p); }); });
}

}  // namespace

void measure(Session& session) {
  const auto any = [](const Outline& a, const auto&) { return has_triangles(a); };
  const auto round = [](const Outline& a, const auto& b) { return has_triangles(a) && !empty(b) && b.radius > 0; };
  points(session);
  along<Ray<double, 3>>(session, "ray-polygon-in-space");
  along<Segment<double, 3>>(session, "segment-polygon-in-space");
  against<Sphere<double, 3>>(session, "polygon-in-space-sphere", 1 << 9, any);
  against<Capsule<double, 3>>(session, "polygon-in-space-capsule", 1 << 9, any);
  against<Cylinder<double>>(session, "polygon-in-space-cylinder", 1 << 6, round);
  against<Cone<double>>(session, "polygon-in-space-cone", 1 << 6, round);
  against<Body>(session, "polygon-in-space-half-spaces", 1 << 7, any);
  against<Three>(session, "polygon-in-space-triangle", 1 << 8, any);
  against<Outline>(session, "polygon-in-space-polygon-in-space", 1 << 7,
                   [](const Outline& a, const Outline& b) { return has_triangles(a) && has_triangles(b); });
}

}  // namespace isect::bench::polygons_in_space_suite
