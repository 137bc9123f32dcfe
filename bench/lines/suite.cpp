// Rays and segments against solids, triangles and each other: whether they meet, by naive code and exactly.

#include <isect/line_line.h>
#include <isect/line_triangle.h>
#include <isect/ray_capsule.h>
#include <isect/ray_cone.h>
#include <isect/ray_cylinder.h>
#include <isect/ray_half_spaces.h>
#include <isect/segment_sphere.h>

#include <isect/methods/ray_cone.h>
#include <isect/methods/ray_cylinder.h>

#include "bench/half_spaces/bodies.h"
#include "bench/line_triangle/oracle.h"
#include "bench/naive_triangles.h"
#include "bench/pair_suite.h"
#include "bench/peer_shapes.h"
#include "bench/ray_capsule/oracle.h"
#include "bench/ray_cylinder/oracle.h"
#include "bench/straight_lines.h"

namespace isect::bench::lines_suite {
namespace {

using Beam = Ray<double, 3>;
using Edge = Segment<double, 3>;
using Vec = Vector<double, 3>;
using oracle::Rational, oracle::rational, oracle::operator+;

/// The squared distance of a line and a segment (Ericson, 2005, 5.1.9).
double distance2(const Line<3>& a, const Point<double, 3>& p, const Point<double, 3>& q, double most = 1) {
  const Vec e = q - p, r = a.p - p;
  const double aa = a.d.squaredNorm(), ee = e.squaredNorm(), f = e.dot(r), c = a.d.dot(r), b = a.d.dot(e);
  double s = 0, t = 0;
  if (aa == 0) {
    t = ee > 0 ? std::clamp(f / ee, 0., most) : 0;
  } else if (ee == 0) {
    s = std::clamp(-c / aa, 0., a.most);
  } else {
    const double determinant = aa * ee - b * b;
    s = determinant != 0 ? std::clamp((b * f - c * ee) / determinant, 0., a.most) : 0;
    t = (b * s + f) / ee;
    if (t < 0) t = 0, s = std::clamp(-c / aa, 0., a.most);
    if (t > most) t = most, s = std::clamp((b * most - c) / aa, 0., a.most);
  }
  return (a.p + s * a.d - (p + t * e)).squaredNorm();
}

template <class Straight>
void capsules(Session& session, const char* test) {
  using Rod = Capsule<double, 3>;
  const auto by_distance = [](const Straight& s, const Rod& c) {
    return distance2(line(s), c.p, c.q) <= c.radius * c.radius;
  };
  const auto truly = [](const Straight& s, const Rod& c) {
    const TrueLine<3> l = true_line(s);
    if (oracle::dot(l.d, l.d) == 0)
      return oracle::at_most(oracle::distance2<3>(l.p, oracle::stretch(c)), Rational(c.radius));
    return oracle::line_in_capsule(s, c).meets(l.range);
  };
  PairContest<Straight, Rod>(session, test)  // no peer asks this
      .run(
          by_distance, [](const Straight& s, const Rod& c) { return intersects(s, c); }, truly);
}

bool by_quadratic(const Beam& ray, const Cylinder<double>& x) { return ray_cylinder::quadratic(ray, x).has_value(); }
bool by_quadratic(const Beam& ray, const Cone<double>& x) { return ray_cone::quadratic(ray, x).has_value(); }

template <class Round>
void round_solids(Session& session, const char* test) {
  const auto truly = [](const Edge& s, const Round& x) {
    const oracle::RoundSolid solid = oracle::round_solid(x);
    if (s.p == s.q) return solid.locate(rational(s.p)) != Location::out;
    return solid.exists && oracle::line_in(s, x).meets({0, 1});
  };
  PairContest<Edge, Round>(session, test)  // no peer asks this
      .run([](const Edge& s, const Round& x) { return by_quadratic(segment<double, 3>(s.p, s.q), x); },
           [](const Edge& s, const Round& x) { return intersects(s, x); }, truly);
}

/// Clips the line by plane after plane, as Cyrus and Beck do.
template <class Straight>
void solids(Session& session, const char* test) {
  const auto by_planes = [](const Straight& s, const Body& b) {
    const Line<3> l = line(s);
    double lo = 0, hi = l.most;
    for (const Plane<double, 3>& plane : b.planes) {
      const double height = plane.normal.dot(l.p) + plane.d, rate = plane.normal.dot(l.d);
      if (rate > 0) lo = std::max(lo, -height / rate);
      if (rate < 0) hi = std::min(hi, -height / rate);
      if (rate == 0 && height < 0) return false;
    }
    return lo <= hi;
  };
  const auto truly = [](const Straight& s, const Body& b) {
    const TrueLine<3> l = true_line(s);
    const Rational far = boost::multiprecision::pow(boost::multiprecision::mpz_int(2), 5000);  // beyond every solid
    return oracle::part(l.p, l.p + l.d, sides_of(b), 0, std::isinf(l.range.hi) ? far : Rational(1)).has_value();
  };
  PairContest<Straight, Body>(session, test)  // no peer asks this
      .run(
          by_planes, [](const Straight& s, const Body& b) { return intersects(s, b.core); }, truly);
}

void balls(Session& session) {
  using Ball = Sphere<double, 3>;
  const auto by_foot = [](const Edge& s, const Ball& b) {
    return distance2(line(s), b.center, b.center) <= b.radius * b.radius;
  };
  const auto truly = [](const Edge& s, const Ball& b) {
    return oracle::at_most(oracle::distance2<3>(rational(b.center), oracle::stretch(Capsule<double, 3>{s.p, s.q, 0})),
                           Rational(b.radius));
  };
  PairContest<Edge, Ball>(session, "segment-sphere")  // CGAL's sphere is a surface: no peer asks this
      .run(
          by_foot, [](const Edge& s, const Ball& b) { return intersects(s, b); }, truly);
}

template <class Straight>
void triangles(Session& session, const char* test) {
  using Three = Triangle<double, 3>;
  const auto moller_trumbore = [](const Straight& s, const Three& x) {
    const Line<3> l = line(s);
    return naive::crosses(l.p, l.d, l.most, x);
  };
  const auto truly = [](const Straight& s, const Three& x) {
    const TrueLine<3> l = true_line(s);
    const oracle::Corners v = oracle::corners(x);
    if (oracle::dot(l.d, l.d) == 0) return oracle::in_triangle(l.p, v);
    return oracle::first_hit(l.p, l.d, l.range, v).has_value();
  };
  PairContest<Straight, Three>(session, test)
      .run(
          moller_trumbore, [](const Straight& s, const Three& x) { return first_hit(s, x).has_value(); }, truly,
          peers::meet_by_cgal);
}

/// Segment against segment. The naive test accepts a distance of 1e-9 of the length: doubles rarely meet exactly.
void lines(Session& session) {
  const auto by_distance = [](const Edge& a, const Edge& b) {
    const double size2 = (a.q - a.p).squaredNorm() + (b.q - b.p).squaredNorm();
    return distance2(line(a), b.p, b.q) <= 1e-18 * size2;
  };
  const auto truly = [](const Edge& a, const Edge& b) {
    const oracle::Stretch<3> first = oracle::stretch(Capsule<double, 3>{a.p, a.q, 0});
    return oracle::distance2<3>(first, oracle::stretch(Capsule<double, 3>{b.p, b.q, 0})) == 0;
  };
  PairContest<Edge, Edge>(session, "line-line")
      .run(
          by_distance, [](const Edge& a, const Edge& b) { return intersect(a, b).meets(); }, truly,
          peers::meet_by_cgal);
}

}  // namespace

void measure(Session& session) {
  capsules<Beam>(session, "ray-capsule");
  capsules<Edge>(session, "segment-capsule");
  round_solids<Cylinder<double>>(session, "segment-cylinder");
  round_solids<Cone<double>>(session, "segment-cone");
  solids<Beam>(session, "ray-half-spaces");
  solids<Edge>(session, "segment-half-spaces");
  balls(session);
  triangles<Beam>(session, "ray-triangle line-triangle");
  triangles<Edge>(session, "segment-triangle");
  lines(session);
}

}  // namespace isect::bench::lines_suite
