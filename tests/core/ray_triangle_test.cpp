#include <isect/methods/ray_triangle.h>
#include <isect/ray_triangle.h>

#include <cmath>
#include <limits>

#include <isect/counted.h>
#include <isect/orient.h>
#include "bench/random_rays.h"
#include "bench/ray_triangle/oracle.h"
#include "tests/catch.h"
#include "tests/core/common.h"
#include "tests/settings.h"

namespace ray_triangle_test {
using namespace isect;
using bench::Numbers;
using bench::Random;
using tests::inf, tests::not_a_number;

namespace {

template <class S>
Point<S, 3> at(double x, double y, double z) {
  return Point<double, 3>(x, y, z).cast<S>();
}
/// (0, 0, 0), (4, 0, 0), (0, 4, 0).
template <class S>
Triangle<S, 3> floor_tile(double size = 4) {
  return {{at<S>(0, 0, 0), at<S>(size, 0, 0), at<S>(0, size, 0)}};
}
/// The ray down onto (x, y, 0), from z = 2.
template <class S>
Ray<S, 3> down(double x, double y) {
  return {at<S>(x, y, 2), at<S>(0, 0, -1)};
}

template <class S>
bool identical(const RayTriangle<S>& a, const RayTriangle<S>& b) {
  return a.coplanar == b.coplanar && a.location == b.location && a.t == b.t && a.u == b.u && a.v == b.v;
}
template <class S>
bool same_verdicts(const RayTriangle<S>& a, const RayTriangle<S>& b) {
  return a.coplanar == b.coplanar && a.location == b.location && a.t.has_value() == b.t.has_value();
}

template <class S>
struct Case {
  Ray<S, 3> ray;
  Triangle<S, 3> triangle;
};

/// Any triangle, and a ray from anywhere or aimed: at a vertex, an edge, or inside, ending there at times.
template <class S>
Case<S> draw(Random& random, Numbers numbers) {
  const auto any = [&] { return bench::vector<S, 3>(random, numbers); };
  Case<S> c = {bench::ray<S, 3>(random, numbers), {any(), any(), any()}};
  auto& [p, q, r] = c.triangle.vertices;
  if (random.one_in(20)) r = p + (q - p) * 2;
  if (random.one_in(10)) r = p + (q - p) / 4, r[random.below(3)] = p[1];  // a needle
  if (!finite(r)) r = any();
  if (random.one_in(3)) return c;
  const S i = static_cast<S>(random.integer(-1, 5)) / 4, j = static_cast<S>(random.integer(0, 4)) / 4;
  Point<S, 3> target = p;
  if (!random.one_in(3)) target += (q - p) * (random.one_in(2) ? i : i / 2);
  if (target != p && random.one_in(2)) target += (r - p) * (j / 2);
  const Vector<S, 3> d = target - c.ray.origin;
  if (!finite(d)) return c;
  c.ray.direction = d;
  if (random.one_in(6)) c.ray.origin = target, c.ray.direction = q - r;  // in the plane
  if (!finite(c.ray.direction)) c.ray.direction = any();
  if (random.one_in(4)) c.ray.range.hi = S(1), c.ray.range.lo = std::min(c.ray.range.lo, S(1));
  return c;
}

}  // namespace

TEMPLATE_TEST_CASE("a ray meets a triangle from either side", "[ray_triangle]", float, double) {
  using S = TestType;
  const auto r = intersect(down<S>(1, 2), floor_tile<S>());
  CHECK(r);
  CHECK(r.location == Location::in);
  CHECK(r.t == S(2));
  CHECK(r.u == S(0.25));
  CHECK(r.v == S(0.5));
  CHECK(intersect(Ray<S, 3>{at<S>(1, 2, -3), at<S>(0, 0, 2)}, floor_tile<S>()).t == S(1.5));
  CHECK(intersects(down<S>(1, 2), floor_tile<S>()));
}

TEMPLATE_TEST_CASE("edges and vertices belong to the triangle", "[ray_triangle]", float, double) {
  using S = TestType;
  for (const auto& [x, y] : {std::pair{1., 0.}, {0., 1.}, {2., 2.}, {0., 0.}, {4., 0.}, {0., 4.}}) {
    const auto r = intersect(down<S>(x, y), floor_tile<S>());
    CHECK(r.t == S(2));
    CHECK(r.location == Location::on);
    CHECK(r.u == S(x / 4));
    CHECK(r.v == S(y / 4));
  }
  for (const auto& [x, y] : {std::pair{1., -1e-30}, {2., 2.001}, {-1., 0.}, {5., 0.}}) {
    CHECK_FALSE(intersect(down<S>(x, y), floor_tile<S>()));
    CHECK(intersect(down<S>(x, y), floor_tile<S>()).location == Location::out);
  }
}

TEMPLATE_TEST_CASE("a triangle behind or beyond is missed", "[ray_triangle]", float, double) {
  using S = TestType;
  const Ray<S, 3> up = {at<S>(1, 1, 2), at<S>(0, 0, 1)};
  CHECK_FALSE(intersect(up, floor_tile<S>()));
  CHECK(intersect(up, floor_tile<S>()).location == Location::in);
  CHECK(intersect(line_through<S, 3>(at<S>(1, 1, 2), at<S>(1, 1, 3)), floor_tile<S>()).t == S(-2));
  CHECK(intersect(segment<S, 3>(at<S>(1, 1, 2), at<S>(1, 1, 0)), floor_tile<S>()).t == S(1));
  CHECK_FALSE(intersect(segment<S, 3>(at<S>(1, 1, 2), at<S>(1, 1, 0.001)), floor_tile<S>()));
  CHECK(intersect(Ray<S, 3>{at<S>(1, 1, 0), at<S>(0, 0, 1)}, floor_tile<S>()).t == S(0));
}

TEMPLATE_TEST_CASE("a coplanar ray, a point and a flat triangle have answers", "[ray_triangle]", float, double) {
  using S = TestType;
  const auto within = intersect(Ray<S, 3>{at<S>(-1, 1, 0), at<S>(1, 0, -0.)}, floor_tile<S>());
  CHECK((!within && within.coplanar));
  const auto beside = intersect(Ray<S, 3>{at<S>(-1, 1, 1), at<S>(1, 0, 0)}, floor_tile<S>());
  CHECK((!beside && !beside.coplanar));
  CHECK(intersect(Ray<S, 3>{at<S>(1, 1, 0), at<S>(0, 0, 0)}, floor_tile<S>()).coplanar);
  CHECK_FALSE(intersect(Ray<S, 3>{at<S>(1, 1, 1), at<S>(0, 0, 0)}, floor_tile<S>()).coplanar);
  const Triangle<S, 3> needle = {{at<S>(0, 0, 0), at<S>(1, 1, 0), at<S>(3, 3, 0)}};
  for (const auto& r : {intersect(down<S>(1, 1), needle), intersect(down<S>(1, 2), needle)})
    CHECK((!r && !r.coplanar && r.location == Location::out));
}

TEMPLATE_TEST_CASE("NaN, infinities and an empty range meet nothing", "[ray_triangle]", float, double) {
  using S = TestType;
  for (const double bad : {not_a_number, inf, -inf}) {
    CHECK_FALSE(intersect(Ray<S, 3>{at<S>(1, 1, bad), at<S>(0, 0, -1)}, floor_tile<S>()));
    CHECK_FALSE(intersect(Ray<S, 3>{at<S>(1, 1, 1), at<S>(0, bad, -1)}, floor_tile<S>()));
    CHECK_FALSE(intersect(down<S>(1, 1), floor_tile<S>(bad)));
    CHECK_FALSE(intersects(down<S>(1, 1), floor_tile<S>(bad)));
  }
  CHECK_FALSE(intersect(Ray<S, 3>{at<S>(1, 1, 2), at<S>(0, 0, -1), {S(3), S(1)}}, floor_tile<S>()));
}

TEST_CASE("triangles of any size are met", "[ray_triangle]") {
  for (const double k : {1e-300, 1e-160, 1., 1e160, 1e300}) {
    const auto r = intersect(Ray<double, 3>{{k, 2 * k, k}, {0, 0, -k}}, floor_tile<double>(4 * k));
    CHECK(r.t == 1);
    CHECK(r.u == .25);
    CHECK(r.v == .5);
    CHECK(intersect(Ray<double, 3>{{2 * k, 2 * k, k}, {0, 0, -k}}, floor_tile<double>(4 * k)).location == Location::on);
    const double off = 2 * k * (1 + 1e-15);
    CHECK_FALSE(intersect(Ray<double, 3>{{2 * k, off, k}, {0, 0, -k}}, floor_tile<double>(4 * k)));
  }
}

TEST_CASE("the method of Moller and Trumbore agrees on ordinary rays", "[ray_triangle]") {
  Random random(tests::seed());
  int hits = 0;
  for (int i = 0; i < 4000; ++i) {
    const Ray<double, 3> ray = {random.in_box<3>(2), random.in_box<3>(1)};
    const Triangle<double, 3> x = {{random.in_box<3>(2), random.in_box<3>(2), random.in_box<3>(2)}};
    INFO("seed " << tests::seed() << ", case " << i);
    const auto naive = ray_triangle::moller_trumbore(ray, x);
    const auto exact = intersect(ray, x);
    REQUIRE(naive.has_value() == exact.t.has_value());
    if (!naive) continue;
    ++hits;
    REQUIRE(naive->t == Approx(*exact.t).margin(1e-12));
    REQUIRE(naive->u == Approx(exact.u).margin(1e-9));
    REQUIRE(naive->v == Approx(exact.v).margin(1e-9));
  }
  CHECK(hits > 100);
  using C = Counted<double>;
  tally() = {};
  const Triangle<C, 3> x = {
      {Point<C, 3>(C(0), C(0), C(0)), Point<C, 3>(C(4), C(0), C(0)), Point<C, 3>(C(0), C(4), C(0))}};
  CHECK(ray_triangle::moller_trumbore<C>({{C(1), C(1), C(1)}, {C(0), C(0), C(-1)}, {C(0), C(9)}}, x));
  CHECK(tally().div == 3);
}

TEMPLATE_TEST_CASE("ray and triangle: every answer is that of rational arithmetic", "[ray_triangle][random]", float,
                   double) {
  using S = TestType;
  int hits = 0, misses = 0, on = 0, out_of_range = 0, coplanar = 0;
  double worst = 0;
  const int count = tests::cases(1000, 200000);
  for (const Numbers numbers : bench::all_numbers) {
    Random random(tests::seed() + static_cast<int>(numbers));
    for (int i = 0; i < count; ++i) {
      const Case<S> c = draw<S>(random, numbers);
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      const RayTriangle<S> r = intersect(c.ray, c.triangle);
      const oracle::RayTriangle expected = oracle::ray_triangle(c.ray, c.triangle);
      REQUIRE(r.coplanar == expected.coplanar);
      REQUIRE(r.location == expected.location);
      REQUIRE(r.t.has_value() == expected.hit);
      REQUIRE(intersects(c.ray, c.triangle) == expected.hit);
      hits += expected.hit, misses += r.location == Location::out, on += r.location == Location::on;
      out_of_range += !r && r.location != Location::out, coplanar += r.coplanar;
      if (!r) continue;
      REQUIRE((c.ray.range.lo <= *r.t && *r.t <= c.ray.range.hi));
      REQUIRE((0 <= r.u && r.u <= 1 && 0 <= r.v && r.v <= 1));
      worst = std::max(
          {worst, oracle::ulps(*r.t, expected.t), oracle::ulps(r.u, expected.u), oracle::ulps(r.v, expected.v)});
    }
  }
  CHECK(worst <= 2);
  for (const int often : {hits, misses, on, out_of_range, coplanar}) CHECK(often > count / 8);
}

TEMPLATE_TEST_CASE("no ray leaves a closed surface unnoticed", "[ray_triangle][random]", float, double) {
  using S = TestType;
  int slipped = 0;
  const int count = tests::cases(4000, 500000);
  Random random(tests::seed());
  for (int i = 0; i < count; ++i) {
    const Numbers numbers = random.one_in(2) ? Numbers::decimal : Numbers::ordinary;
    const Point<S, 3> far = random.one_in(2) ? at<S>(1000, -3000, 500) : at<S>(0, 0, 0);
    Point<S, 3> v[4];
    for (Point<S, 3>& p : v) p = far + bench::vector<S, 3>(random, numbers);
    const Point<S, 3> inside = (v[0] + v[1] + v[2] + v[3]) / S(4);
    const Triangle<S, 3> faces[] = {
        {{v[0], v[1], v[2]}}, {{v[0], v[3], v[1]}}, {{v[1], v[3], v[2]}}, {{v[2], v[3], v[0]}}};
    bool is_inside = true;  // rounding may have moved it out of a needle
    int sides[4];
    for (int k = 0; k < 4; ++k) {
      const auto& [a, b, c] = faces[k].vertices;
      const auto wide = [](const Point<S, 3>& p) { return Point<double, 3>(p.template cast<double>()); };
      sides[k] = orient3d(wide(a), wide(b), wide(c), wide(inside));
      is_inside &= sides[k] != 0 && sides[k] == sides[0];
    }
    if (!is_inside) continue;

    INFO("seed " << tests::seed() << ", case " << i);
    const Point<S, 3> target =
        random.one_in(2) ? v[0] : Point<S, 3>(v[0] + (v[1] - v[0]) * static_cast<S>(random.unit()));
    const Ray<S, 3> ray = {inside, target - inside};
    if (ray.direction == Vector<S, 3>::Zero()) continue;
    int hits = 0, naive = 0;
    for (const auto& face : faces)
      hits += intersects(ray, face), naive += ray_triangle::moller_trumbore(ray, face).has_value();
    REQUIRE(hits > 0);
    slipped += naive == 0;
  }
  CHECK(slipped > 0);  // through the naive surface
}

TEMPLATE_TEST_CASE("ray and triangle: vertex order, axes, mirroring, scale and a listener change no verdict",
                   "[ray_triangle][property]", float, double) {
  using S = TestType;
  for (const Numbers numbers : bench::all_numbers) {
    Random random(tests::seed() + 100 + static_cast<int>(numbers));
    for (int i = 0; i < 300; ++i) {
      const Case<S> c = draw<S>(random, numbers);
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      const RayTriangle<S> r = intersect(c.ray, c.triangle);
      Record<ray_triangle::Event<S>> record;
      REQUIRE(identical(intersect(c.ray, c.triangle, record), r));

      const auto& [p, q, s] = c.triangle.vertices;
      REQUIRE(same_verdicts(intersect(c.ray, Triangle<S, 3>{{q, s, p}}), r));
      const RayTriangle<S> swapped = intersect(c.ray, Triangle<S, 3>{{p, s, q}});
      REQUIRE(same_verdicts(swapped, r));
      if (r) REQUIRE((swapped.u == r.v && swapped.v == r.u));

      const Ray<S, 3> mirrored = {c.ray.origin, -c.ray.direction, {-c.ray.range.hi, -c.ray.range.lo}};
      REQUIRE(same_verdicts(intersect(mirrored, c.triangle), r));

      const auto turn = [](const Vector<S, 3>& x) { return Vector<S, 3>(x[2], -x[0], x[1]); };
      REQUIRE(same_verdicts(intersect(Ray<S, 3>{turn(c.ray.origin), turn(c.ray.direction), c.ray.range},
                                      Triangle<S, 3>{{turn(p), turn(q), turn(s)}}),
                            r));
      if (numbers != Numbers::grid) continue;
      const S k = std::ldexp(S(1), random.integer(-20, 20));
      const Triangle<S, 3> scaled = {{Point<S, 3>(p * k), Point<S, 3>(q * k), Point<S, 3>(s * k)}};
      REQUIRE(same_verdicts(intersect(Ray<S, 3>{c.ray.origin * k, c.ray.direction * k, c.ray.range}, scaled), r));
      const Vector<S, 3> by = at<S>(64, -128, 32);
      const Triangle<S, 3> moved = {{Point<S, 3>(p + by), Point<S, 3>(q + by), Point<S, 3>(s + by)}};
      REQUIRE(same_verdicts(intersect(Ray<S, 3>{c.ray.origin + by, c.ray.direction, c.ray.range}, moved), r));
    }
  }
}

TEMPLATE_TEST_CASE("every hit lies on the triangle", "[ray_triangle][property]", float, double) {
  using S = TestType;
  Random random(tests::seed());
  for (int i = 0; i < 4000; ++i) {
    const Case<S> c = draw<S>(random, i % 2 ? Numbers::decimal : Numbers::distant);
    INFO("seed " << tests::seed() << ", case " << i);
    const RayTriangle<S> r = intersect(c.ray, c.triangle);
    if (!r) continue;
    const auto& [p, q, s] = c.triangle.vertices;
    const S eps = std::numeric_limits<S>::epsilon(),
            size = std::max({p.cwiseAbs().maxCoeff(), q.cwiseAbs().maxCoeff(), s.cwiseAbs().maxCoeff()});
    const S bound =
        4 * eps * (c.ray.origin.cwiseAbs().maxCoeff() + std::abs(*r.t) * c.ray.direction.cwiseAbs().maxCoeff()) +
        16 * eps * size;
    REQUIRE((c.ray.at(*r.t) - (p + r.u * (q - p) + r.v * (s - p))).cwiseAbs().maxCoeff() <= bound);
  }
}

}  // namespace ray_triangle_test
