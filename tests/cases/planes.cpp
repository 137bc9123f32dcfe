// Planes against balls, boxes and rays.

#include "bench/ray_plane/families.h"
#include "bench/ray_plane/oracle.h"
#include "tests/cases/shapes.h"

namespace isect::cases {

namespace {

using oracle::dot, oracle::rational, oracle::operator*;

/// Decides by the point of the plane nearest to the center.
template <class S, int N>
Case plane_and_ball(const Plane<S, N>& plane, const Sphere<S, N>& ball) {
  const auto n = rational(plane.normal);
  const Rational h = dot(n, rational(ball.center)) + Rational(plane.d), r = ball.radius;
  const auto foot = Rational(h / dot(n, n)) * n;
  const int clear = r < 0 ? 1 : oracle::sign(dot(foot, foot) - r * r);
  const Relation relation = clear > 0 ? Relation::disjoint : clear == 0 ? Relation::touching : Relation::overlapping;
  return {both(fields(plane), fields(ball)), related(relation), is_f32<S>};
}

/// Decides by all corners.
template <class S, int N>
Case plane_and_box(const Plane<S, N>& plane, const Aabb<S, N>& box) {
  bool above = false, below = false, within = false;
  for (int corner = 0; corner < 1 << N; ++corner) {
    Rational h = plane.d;
    for (int i = 0; i < N; ++i) h += Rational(plane.normal[i]) * Rational((corner >> i & 1 ? box.hi : box.lo)[i]);
    above |= h > 0, below |= h < 0, within |= h == 0;
  }
  Relation relation = above && below ? Relation::overlapping : within ? Relation::touching : Relation::disjoint;
  if (empty(box)) relation = Relation::disjoint;
  return {both(fields(plane), fields(box)), related(relation), is_f32<S>};
}

/// A plane through x, up to rounding and a few ulp.
template <class S, int N>
Plane<S, N> plane_through(Random& random, Numbers numbers, const Point<double, N>& x) {
  const Numbers of_normal = random.one_in(2) ? Numbers::grid : numbers;
  const Vector<S, N> normal = bench::vector<S, N>(random, of_normal);
  const double d = -normal.template cast<double>().dot(x);
  return {normal, bench::moved(static_cast<S>(d), random.integer(-1, 1))};
}
template <class S, int N>
bool usable(const Plane<S, N>& plane) {
  return finite(plane) && !plane.normal.isZero(0);
}

template <class S, int N>
Case ray_and_plane(Ray<S, N> ray, const Plane<S, N>& plane) {
  const Json in = both(fields(ray), fields(plane));
  const oracle::RayPlane truth = oracle::ray_plane(ray, plane);
  ray.range = {S(0), S(1)};
  const Json expected = {{"parallel", truth.parallel},
                         {"coplanar", truth.coplanar},
                         {"line_hit", truth.line || truth.coplanar},
                         {"t", truth.line ? json(nearest(*truth.line)) : Json(nullptr)},
                         {"ray_hit", truth.meets},
                         {"segment_hit_0_1", oracle::ray_plane(ray, plane).meets}};
  return {in, expected, is_f32<S>};
}

}  // namespace

CaseFile plane_sphere() {
  CaseFile file("plane_sphere");
  const auto add = [&](const char* note, Plane<double, 2> plane, Sphere<double, 2> ball) {
    file.add(note, plane_and_ball(plane, ball));
  };
  add("touching, by 3, 4 and 5", {{3, 4}, -10}, {{0, 0}, 2});
  add("an ulp apart", {{3, 4}, -10}, {{0, 0}, std::nextafter(2., 0.)});
  add("a ball of radius 0 in the plane", {{1, 1}, -3}, {{1, 2}, 0});
  add("a ball of radius -0 in the plane", {{1, 1}, -3}, {{1, 2}, -0.});
  add("an empty ball", {{1, 0}, 0}, {{0, 0}, -1});
  add("a normal whose square vanishes", {{3e-300, 4e-300}, -10e-300}, {{0, 0}, 2});
  add("a normal whose square overflows", {{3e300, 4e300}, -1e301}, {{0, 0}, 2});
  add("a height that overflows", {{most, most}, most}, {{most, most}, 1});
  by_numbers(file, 4, [&]<class S>(Random& random, Numbers numbers) -> std::optional<Case> {
    Sphere<S, 3> ball = {bench::vector<S, 3>(random, numbers), S(0)};
    Plane<S, 3> plane = plane_through<S, 3>(random, numbers, bench::vector<double, 3>(random, numbers));
    if (random.one_in(3)) plane.normal = Vector<S, 3>::Unit(random.below(3));  // so that some touch
    const Vector<double, 3> n = plane.normal.template cast<double>();
    const double height = std::abs(n.dot(ball.center.template cast<double>()) + double(plane.d)) / n.stableNorm();
    ball.radius = bench::moved(static_cast<S>(height), random.integer(-1, 1));
    if (!finite(ball) || !usable(plane)) return {};
    return plane_and_ball(plane, ball);
  });
  return file;
}

CaseFile plane_box() {
  CaseFile file("plane_box");
  const auto add = [&](const char* note, Plane<double, 2> plane, Aabb<double, 2> box) {
    file.add(note, plane_and_box(plane, box));
  };
  add("at a corner", {{1, 1}, -2}, {{-1, -1}, {1, 1}});
  add("beyond the corner by an ulp", {{1, 1}, -std::nextafter(2., 3.)}, {{-1, -1}, {1, 1}});
  add("beyond the corner by what the sum rounds away", {{1, 1}, -1}, {{0, -1}, {1, -0x1p-60}});
  add("along a face", {{0, .1}, -.1}, {{-1, -1}, {1, 1}});
  add("through a point", {{.1, -.1}, 0}, {{.3, .3}, {.3, .3}});
  add("an inverted box is empty", {{1, 0}, 0}, {{1, 1}, {-1, -1}});
  add("products that overflow", {{most, -most}, 0}, {{-most, -most}, {most, most}});
  add("products that vanish", {{least, least}, 0}, {{least, least}, {1, 1}});
  by_numbers(file, 4, [&]<class S>(Random& random, Numbers numbers) -> std::optional<Case> {
    const auto a = bench::vector<S, 3>(random, numbers), b = bench::vector<S, 3>(random, numbers);
    const Aabb<S, 3> box = {a.cwiseMin(b), a.cwiseMax(b)};
    Point<double, 3> corner;
    for (int i = 0; i < 3; ++i) corner[i] = random.one_in(2) ? box.lo[i] : box.hi[i];
    const Plane<S, 3> plane = plane_through<S, 3>(random, numbers, corner);
    if (!usable(plane)) return {};
    return plane_and_box(plane, box);
  });
  return file;
}

CaseFile ray_plane() {
  CaseFile file("ray_plane");
  using P = Point<double, 3>;
  const auto add = [&](const char* note, P origin, P direction, P normal, double d,
                       Interval<double> range = semi_infinite<double>) {
    file.add(note, ray_and_plane<double, 3>({origin, direction, range}, {normal, d}));
  };
  const float n = 0.57735026F;
  add("a plane far away: floats give .125", {1e6, 1e6, 1e6}, {n, n, n}, {n, n, n}, -1732050.9F);
  add("in the plane", {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, -1);
  add("in the plane, an empty range", {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, -1, {1, 0});
  add("parallel, an ulp beside the plane", {std::nextafter(1., 2.), 0, 0}, {0, 1, 0}, {1, 0, 0}, -1);
  add("parallel but for rounding", {0, 0, 1}, {.1, .2, -.3}, {1, 1, 1}, 0);
  add("no direction, in the plane", {1, 0, 0}, {0, -0., 0}, {1, 0, 0}, -1);
  add("from the plane", {1, 0, 0}, {1, 0, 0}, {1, 0, 0}, -1);
  add("behind by the smallest number", {least, 0, 0}, {1, 0, 0}, {1, 0, 0}, -0.);
  add("a segment that ends in the plane", {0, 0, 0}, {1, 1, 0}, {1, 0, 0}, -1, {0, 1});
  add("a segment that ends an ulp before the plane", {0, 0, 0}, {1, 1, 0}, {1, 0, 0}, -std::nextafter(1., 2.), {0, 1});
  add("products that overflow", {0, 0, 0}, {1e200, 0, 0}, {1e200, 0, 0}, -1e300);
  add("products that vanish", {0, 0, 0}, {1e-200, 0, 0}, {1e-200, 0, 0}, -1e-300);
  add("t is beyond the largest number", {0, 0, 0}, {1e-200, 0, 0}, {1, 0, 0}, -1e200);
  const auto ask = [](const auto& c) { return ray_and_plane(c.ray, c.plane); };
  by_families(file, 8, bench::ray_plane_draws<double>, bench::ray_plane_draws<float>, ask);
  return file;
}

}  // namespace isect::cases
