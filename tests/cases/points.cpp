// Points against points, intervals, boxes, balls, capsules, lines and planes.

#include "bench/aabb_aabb/families.h"
#include "bench/orient2d/families.h"
#include "bench/orient2d/oracle.h"
#include "bench/point_point/families.h"
#include "bench/simple_shapes.h"
#include "bench/sphere_capsule/oracle.h"
#include "tests/cases/shapes.h"
#include "tests/core/point_line_pairs.h"
#include "tests/core/point_obb_pairs.h"

namespace isect::cases {

namespace {

using oracle::dot, oracle::rational, oracle::operator-;

using P2 = Point<double, 2>;
using P3 = Point<double, 3>;

template <class S>
Case turn(const Point<S, 2>& a, const Point<S, 2>& b, const Point<S, 2>& c) {
  return {{{"a", json<S, 2>(a)}, {"b", json<S, 2>(b)}, {"c", json<S, 2>(c)}},
          {{"sign", oracle::orientation(a, b, c)}},
          is_f32<S>};
}

/// Comparisons of doubles are exact, so this is the definition.
template <class S>
Relation relation(const Interval<S>& a, const Interval<S>& b) {
  if (!(a.lo <= a.hi) || !(b.lo <= b.hi) || a.hi < b.lo || b.hi < a.lo) return Relation::disjoint;
  if (a.lo == b.lo && a.hi == b.hi) return Relation::equal;
  if (b.lo <= a.lo && a.hi <= b.hi) return Relation::a_inside_b;
  if (a.lo <= b.lo && b.hi <= a.hi) return Relation::b_inside_a;
  return a.hi == b.lo || b.hi == a.lo ? Relation::touching : Relation::overlapping;
}
template <class S>
Case intervals(const Interval<S>& a, const Interval<S>& b) {
  const Json in = {{"a", json(a)}, {"b", json(b)}};
  for (const S x : {a.lo, a.hi, b.lo, b.hi})
    if (std::isnan(x)) return policy(in, is_f32<S>);
  return {in, related(relation(a, b)), is_f32<S>};
}

template <class S, int N>
Case points(const Point<S, N>& p, const Point<S, N>& q, S tolerance) {
  Json in = {{"a", json<S, N>(p)}, {"b", json<S, N>(q)}};
  if (tolerance != 0) in["tol"] = json(tolerance);
  if (!finite(p) || !finite(q) || !std::isfinite(tolerance)) return policy(in, is_f32<S>);
  const auto f = rational(p) - rational(q);
  const bool near = tolerance >= 0 && dot(f, f) <= Rational(tolerance) * Rational(tolerance);
  return {in, {{"equal", near}}, is_f32<S>};
}

template <class S, int N>
Case in_box(const Point<S, N>& p, const Aabb<S, N>& box) {
  Location where = Location::in;
  for (int i = 0; i < N; ++i) {
    if (!(box.lo[i] <= p[i] && p[i] <= box.hi[i])) where = Location::out;
    if (where == Location::in && (p[i] == box.lo[i] || p[i] == box.hi[i])) where = Location::on;
  }
  return {both({{"point", json<S, N>(p)}}, fields(box)), {{"location", word(where)}}, is_f32<S>};
}

template <class S, int N>
Case in_ball(const Point<S, N>& p, const Sphere<S, N>& ball) {
  const auto f = rational(p) - rational(ball.center);
  const Rational r = ball.radius, depth = r * r - dot(f, f);
  const Location where = depth < 0 || r < 0 ? Location::out : depth == 0 ? Location::on : Location::in;
  return {both({{"point", json<S, N>(p)}}, fields(ball)), {{"location", word(where)}}, is_f32<S>};
}

template <class S, int N>
Case in_obb(const Point<S, N>& p, const Obb<S, N>& box) {
  const Location where = tests::point_obb_pairs::oracle_locate(p, box);
  return {both({{"point", json<S, N>(p)}}, json(box)), {{"location", word(where)}}, is_f32<S>};
}

template <class S, int N>
Case in_capsule(const Point<S, N>& p, const Capsule<S, N>& capsule) {
  const Rational d2 = oracle::distance2<N>(rational(p), oracle::stretch(capsule)), r = capsule.radius;
  const Location where = !oracle::at_most(d2, r) ? Location::out : d2 == r * r ? Location::on : Location::in;
  return {both({{"point", json<S, N>(p)}}, fields(capsule)), {{"location", word(where)}}, is_f32<S>};
}

template <class S, int N>
Case beside_line(const Point<S, N>& p, const Ray<S, N>& ray) {
  constexpr const char* words[] = {"on", "before", "beyond", "left", "right", "aside"};
  const Beside where =
      tests::point_line_pairs::truth<S, N>(p, ray.origin, rational(ray.direction), cast<double>(ray.range));
  return {both({{"point", json<S, N>(p)}}, fields(ray)), {{"where", words[static_cast<int>(where)]}}, is_f32<S>};
}

template <class S, int N>
Case beside_plane(const Point<S, N>& p, const Plane<S, N>& plane) {
  Rational height = plane.d;
  for (int i = 0; i < N; ++i) height += Rational(plane.normal[i]) * Rational(p[i]);
  return {both({{"point", json<S, N>(p)}}, fields(plane)), {{"side", oracle::sign(height)}}, is_f32<S>};
}

}  // namespace

CaseFile orient2d() {
  CaseFile file("orient2d");
  const auto add = [&](const char* note, P2 a, P2 b, P2 c) { file.add(note, turn<double>(a, b, c)); };
  add("two equal points: a fused product gives 1.6e-17", {.1, .7}, {.3, -.9}, {.3, -.9});
  add("all three points equal", {.1, .7}, {.1, .7}, {.1, .7});
  add("a small number beside a large one", {1e-300, 1e-300}, {1e300, 1e300}, {0, 0});
  add("the same, turned by the last digit", {1e-300, std::nextafter(1e-300, 1)}, {1e300, 1e300}, {0, 0});
  add("the smallest numbers there are", {0, 0}, {least, 0}, {0, least});
  add("the smallest numbers on a line", {0, 0}, {least, least}, {2 * least, 2 * least});
  add("the largest numbers there are", {-most, -most}, {most, most}, {most, -most});
  add("differences overflow, on a line", {-most, -most}, {most, most}, {0, -0.});
  add("the same, one point moved by the least number", {-most, -most}, {most, most}, {0, least});
  add("zeros of either sign", {0, -0.}, {-0., 0}, {1, 1});
  const auto ask = [](const auto& c) { return turn(c.a, c.b, c.c); };
  by_families(file, 6, bench::orient2d_draws<double>, bench::orient2d_draws<float>, ask);
  return file;
}

CaseFile interval_interval() {
  CaseFile file("interval_interval");
  const auto add = [&](const char* note, Interval<double> a, Interval<double> b) { file.add(note, intervals(a, b)); };
  add("a touch that centers and half-lengths miss", {.1, .7}, {.7, .9});
  add("an inverted interval is empty", {1, -1}, {-5, 5});
  add("[inf, -inf] is empty", {inf, -inf}, {-inf, inf});
  add("the whole line twice", {-inf, inf}, {-inf, inf});
  add("half-lines that touch", {-inf, .3}, {.3, inf});
  add("half-lines, an ulp apart", {-inf, .3}, {std::nextafter(.3, 1), inf});
  add("zeros of either sign touch", {-1, -0.}, {0, 1});
  add("points", {.3, .3}, {.3, .3});
  add("a point at the end of an interval lies in it", {.3, .3}, {.3, .5});
  add("the sum of the ends overflows", {most / 2, most}, {-most, most / 2});
  add("halves of the smallest number vanish", {0, least}, {least, 2 * least});
  const auto ask = [](const auto& c) { return intervals(c.a, c.b); };
  by_families(file, 6, bench::interval_draws<double>, bench::interval_draws<float>, ask);
  return file;
}

CaseFile point_point() {
  CaseFile file("point_point");
  const auto add = [&](const char* note, P3 p, P3 q, double tolerance = 0) {
    file.add(note, points<double, 3>(p, q, tolerance));
  };
  add("0.1 + 0.2 is not 0.3", {.1 + .2, 0, 0}, {.3, 0, 0});
  add("1e16 + 1 is 1e16", {1e16 + 1, 0, 0}, {1e16, 0, 0});
  add("zeros of either sign are equal", {0, -0., 0}, {-0., 0, -0.});
  add("apart by the smallest number", {0, 0, 0}, {0, least, 0});
  add("the same, which is the tolerance", {0, 0, 0}, {0, least, 0}, least);
  add("the square of the distance vanishes", {0, 0, 0}, {3e-170, 4e-170, 0}, 4e-170);
  add("the square of the distance overflows", {0, 0, 0}, {3e170, 4e170, 0}, 4e170);
  add("the distance overflows", {-most, 0, 0}, {most, 0, 0}, most);
  add("a distance of 5 is within 5", {0, 3, 0}, {4, 0, 0}, 5);
  add("a negative tolerance is never kept", {1, 1, 1}, {1, 1, 1}, -1);
  const auto ask = [](const auto& c) { return points(c.p, c.q, c.tolerance); };
  by_families(file, 6, bench::point_point_draws<double>, bench::point_point_draws<float>, ask);
  return file;
}

CaseFile point_box() {
  CaseFile file("point_box");
  file.add("the box is a point", in_box<double, 2>({.1, .1}, {{.1, .1}, {.1, .1}}));
  file.add("inside a box without thickness", in_box<double, 3>({.5, .5, 0}, {{0, 0, -0.}, {1, 1, 0}}));
  file.add("an inverted box is empty", in_box<double, 2>({0, 0}, {{1, -1}, {-1, 1}}));
  file.add("the largest numbers there are", in_box<double, 2>({most, 0}, {{-most, -most}, {most, most}}));
  by_numbers(file, 4, [&]<class S>(Random& random, Numbers numbers) -> std::optional<Case> {
    const auto a = bench::vector<S, 3>(random, numbers), b = bench::vector<S, 3>(random, numbers);
    const Aabb<S, 3> box = {a.cwiseMin(b), a.cwiseMax(b)};
    Point<S, 3> p = bench::vector<S, 3>(random, numbers);
    for (int i = 0; i < 3; ++i)
      if (!random.one_in(4)) p[i] = random.one_in(3) ? box.lo[i] / 2 + box.hi[i] / 2 : (random.one_in(2) ? a : b)[i];
    if (random.one_in(2)) p[0] = bench::moved(p[0], random.integer(-1, 1));
    return in_box(p, box);
  });
  return file;
}

CaseFile point_sphere() {
  CaseFile file("point_sphere");
  file.add("exactly on: 0.6 and 0.8 are not", in_ball<double, 2>({.6, .8}, {{0, 0}, 1}));
  file.add("exactly on, in whole numbers", in_ball<double, 3>({1, 2, 2}, {{0, 0, 0}, 3}));
  file.add("a ball of radius 0 is its center", in_ball<double, 2>({.1, .2}, {{.1, .2}, 0}));
  file.add("beside a ball of radius 0 by the smallest number", in_ball<double, 2>({least, 0}, {{0, 0}, 0}));
  file.add("a negative radius: an empty ball", in_ball<double, 2>({0, 0}, {{0, 0}, -1}));
  file.add("the distance overflows", in_ball<double, 2>({-most, 0}, {{most, 0}, most}));
  by_numbers(file, 4, [&]<class S>(Random& random, Numbers numbers) -> std::optional<Case> {
    Sphere<S, 3> ball = {bench::vector<S, 3>(random, numbers), S(0)};
    Point<S, 3> p = bench::vector<S, 3>(random, numbers);
    if (random.one_in(3)) p[1] = ball.center[1], p[2] = ball.center[2];
    const double distance = (p - ball.center).template cast<double>().stableNorm();
    ball.radius = bench::moved(static_cast<S>(distance), random.integer(-1, 1));
    if (!finite(ball)) return {};
    return in_ball(p, ball);
  });
  return file;
}

CaseFile point_obb() {
  CaseFile file("point_obb");
  const Obb<double, 2> skew = {{0, 0}, Eigen::Matrix2d{{1, 1}, {0, 1}}, {1, 1}};
  file.add("axes that are not orthogonal are taken literally", in_obb<double, 2>({2, 1}, skew));
  file.add("beyond a skew corner by an ulp", in_obb<double, 2>({std::nextafter(2., 3.), 1}, skew));
  const Obb<double, 2> turned = {{0, 0}, Eigen::Matrix2d{{.6, -.8}, {.8, .6}}, {1, 1}};
  file.add("a corner of a box turned by 0.6 and 0.8, as rounded", in_obb<double, 2>({-.2, 1.4}, turned));
  by_numbers(file, 4, [&]<class S>(Random& random, Numbers numbers) -> std::optional<Case> {
    const Obb<S, 3> box = bench::obb<S, 3>(random, numbers);
    const Point<S, 3> p = tests::point_obb_pairs::near(random, box, numbers);
    if (!finite(p) || !finite(box)) return {};
    return in_obb(p, box);
  });
  return file;
}

CaseFile point_capsule() {
  CaseFile file("point_capsule");
  const auto add = [&](const char* note, P3 p, Capsule<double, 3> capsule) {
    file.add(note, in_capsule<double, 3>(p, capsule));
  };
  const Capsule<double, 3> lying = {{-3, 0, 0}, {3, 0, 0}, 5}, thin = {{.1, .1, 0}, {.7, .7, 0}, 0};
  add("on the side, by 3, 4 and 5", {1, 3, 4}, lying);
  add("an ulp outside the side", {1, 3, std::nextafter(4., 5.)}, lying);
  add("an ulp inside the side", {1, 3, std::nextafter(4., 3.)}, lying);
  add("on an end", {6, 4, 0}, lying);
  add("an ulp outside an end", {std::nextafter(6., 7.), 4, 0}, lying);
  add("where the side meets an end", {3, 0, -5}, lying);
  add("on the axis of radius 0, which is on", {.3, .3, 0}, thin);
  add("beside the axis of radius 0 by the least", {.3, .3, least}, thin);
  add("an axis without length", {4, 0, 3}, {{0, 0, 0}, {0, 0, 0}, 5});
  add("a point on a point", {.1, .2, .3}, {{.1, .2, .3}, {.1, .2, .3}, 0});
  add("an empty capsule", {0, 0, 0}, {{-3, 0, 0}, {3, 0, 0}, -1});
  add("sizes of 1e300", {1e300, 3e300, 4e300}, {{-3e300, 0, 0}, {3e300, 0, 0}, 5e300});
  add("sizes of 1e-300", {1e-300, 3e-300, 4e-300}, {{-3e-300, 0, 0}, {3e-300, 0, 0}, 5e-300});
  by_numbers(file, 4, [&]<class S>(Random& random, Numbers numbers) -> std::optional<Case> {
    Capsule<S, 3> capsule = bench::capsule<S, 3>(random, numbers);
    const Point<S, 3> p = bench::vector<S, 3>(random, numbers);
    const Rational d2 = oracle::distance2<3>(rational(p), oracle::stretch(capsule));
    if (random.one_in(2))
      capsule.radius = bench::moved(static_cast<S>(std::sqrt(static_cast<double>(d2))), random.integer(-2, 2));
    if (!finite(capsule)) return {};
    return in_capsule(p, capsule);
  });
  return file;
}

CaseFile point_line() {
  CaseFile file("point_line");
  const auto add = [&](const char* note, P2 p, P2 origin, P2 direction,
                       Interval<double> range = semi_infinite<double>) {
    file.add(note, beside_line<double, 2>(p, {origin, direction, range}));
  };
  add("on a ray", {5, 3}, {1, 1}, {2, 1});
  add("an ulp left of it", {5, std::nextafter(3., 4.)}, {1, 1}, {2, 1});
  add("an ulp right of it", {5, std::nextafter(3., 2.)}, {1, 1}, {2, 1});
  add("before its start", {-1, 0}, {1, 1}, {2, 1});
  add("before the start of a ray, on the line", {-1, 0}, {1, 1}, {2, 1}, {-inf, inf});
  add("on its start", {1, 1}, {1, 1}, {2, 1});
  add("on the end of a segment", {5, 3}, {1, 1}, {2, 1}, {0, 2});
  add("an ulp beyond the end of a segment", {5, 3}, {1, 1}, {2, 1}, {0, std::nextafter(2., 0.)});
  add("tenths on the diagonal", {.3, .3}, {.1, .1}, {.6, .6}, {0, 1});
  add("tenths: the sum of .1 and .2 is not .3", {.1 + .2, .3}, {0, 0}, {.3, .3});
  add("Kettner's: nearly on the line", {.5, .5 + 0x1p-53}, {12, 12}, {12, 12}, {-inf, inf});
  add("no direction, on the point", {.1, .7}, {.1, .7}, {0, -0.});
  add("no direction, beside the point", {.1, .7}, {.1, std::nextafter(.7, 1)}, {0, 0});
  add("an empty range", {5, 3}, {1, 1}, {2, 1}, {2, 1});
  add("1e-300 beside 1e300", {1e300, 1e-300}, {0, 0}, {1e300, 1e-300});
  add("1e-300 beside 1e300, an ulp off", {1e300, std::nextafter(1e-300, 1)}, {0, 0}, {1e300, 1e-300});
  add("a product that vanishes", {least, 0}, {0, 0}, {least, least});
  file.add("in space, on the line", beside_line<double, 3>({2, 4, 6}, {{0, 0, 0}, {1, 2, 3}}));
  file.add("in space, an ulp aside", beside_line<double, 3>({2, 4, std::nextafter(6., 7.)}, {{0, 0, 0}, {1, 2, 3}}));
  file.add("in space, beyond the end", beside_line<double, 3>({2, 4, 6}, {{0, 0, 0}, {1, 2, 3}, {0, 1}}));
  by_numbers(file, 4, [&]<class S>(Random& random, Numbers numbers) -> std::optional<Case> {
    if (random.one_in(3)) {
      const auto c = tests::point_line_pairs::draw<S, 3>(random, numbers);
      return finite(c.point) && finite(c.ray) ? std::optional(beside_line(c.point, c.ray)) : std::nullopt;
    }
    const auto c = tests::point_line_pairs::draw<S, 2>(random, numbers);
    return finite(c.point) && finite(c.ray) ? std::optional(beside_line(c.point, c.ray)) : std::nullopt;
  });
  return file;
}

CaseFile point_plane() {
  CaseFile file("point_plane");
  const auto add = [&](const char* note, P3 p, Plane<double, 3> plane) {
    file.add(note, beside_plane<double, 3>(p, plane));
  };
  add("in the plane", {1, 2, 2}, {{1, 2, 2}, -9});
  add("an ulp before it", {1, 2, std::nextafter(2., 3.)}, {{1, 2, 2}, -9});
  add("an ulp behind it", {std::nextafter(1., 0.), 2, 2}, {{1, 2, 2}, -9});
  add("tenths that cancel", {.3, -.3, 0}, {{.1, .1, .1}, 0});
  add("tenths that do not quite cancel", {.1, .2, -.3}, {{1, 1, 1}, 0});
  add("products that overflow and cancel", {1e300, 1e300, 0}, {{1e300, -1e300, 0}, 0});
  add("products that overflow and leave the least", {1e300, 1e300, 0}, {{1e300, -1e300, 0}, least});
  add("products that vanish", {-1e-300, 0, 0}, {{1e-300, 0, 0}, 0});
  add("far away", {1e8, 1e8, 1}, {{1, -1, 1e-8}, -1e-8});
  add("a plane through the origin", {0, -0., 0}, {{1, 2, 3}, -0.});
  by_numbers(file, 4, [&]<class S>(Random& random, Numbers numbers) -> std::optional<Case> {
    Plane<S, 3> plane = {bench::vector<S, 3>(random, numbers), bench::number<S>(random, numbers)};
    const Point<S, 3> p = bench::vector<S, 3>(random, numbers);
    if (random.one_in(2))
      plane.d = -static_cast<S>(plane.normal.template cast<double>().dot(p.template cast<double>()));
    if (!finite(plane) || plane.normal.isZero(0)) return {};
    return beside_plane(p, plane);
  });
  return file;
}

}  // namespace isect::cases
