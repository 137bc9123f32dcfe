#include <isect/methods/ray_polygon.h>
#include <isect/ray_polygon.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <isect/counted.h>
#include <isect/ray_triangle.h>
#include "bench/random_rays.h"
#include "bench/ray_polygon/oracle.h"
#include "tests/catch.h"
#include "tests/core/common.h"
#include "tests/settings.h"

namespace ray_polygon_test {
/// A double that counts how often it is looked at.
struct Watched {
  double value = 0;
  static inline long looks = 0;
  operator double() const { return ++looks, value; }
};
}  // namespace ray_polygon_test
template <>
struct Eigen::NumTraits<ray_polygon_test::Watched> : Eigen::NumTraits<double> {};

namespace ray_polygon_test {
using namespace isect;
using bench::Numbers;
using bench::Random;
using tests::inf, tests::not_a_number;

namespace {

template <class S>
Point<S, 3> at(double x, double y, double z = 0) {
  return Point<double, 3>(x, y, z).cast<S>();
}
/// An L of the plane z = 0: [0, 4]^2 without (2, 4]^2.
template <class S>
Ring<S, 3> angle() {
  return {at<S>(0, 0), at<S>(4, 0), at<S>(4, 2), at<S>(2, 2), at<S>(2, 4), at<S>(0, 4)};
}
template <class S>
Ring<S, 3> square(double lo, double hi) {
  return {at<S>(lo, lo), at<S>(hi, lo), at<S>(hi, hi), at<S>(lo, hi)};
}
/// The ray down onto (x, y, 0), from z = 2.
template <class S>
Ray<S, 3> down(double x, double y) {
  return {at<S>(x, y, 2), at<S>(0, 0, -1)};
}
template <class S>
bool identical(const RayPolygon<S>& a, const RayPolygon<S>& b) {
  return a.flat == b.flat && a.coplanar == b.coplanar && a.line == b.line && a.location == b.location && a.t == b.t;
}
template <class S>
bool same_verdicts(const RayPolygon<S>& a, const RayPolygon<S>& b) {
  return a.flat == b.flat && a.coplanar == b.coplanar && a.line.has_value() == b.line.has_value() &&
         a.location == b.location && a.t.has_value() == b.t.has_value();
}

template <class S>
struct Case {
  Ray<S, 3> ray;
  Ring<S, 3> ring;
};

/// A ring in a plane, as nearly as S can represent, or anywhere; and a ray from anywhere or aimed: at a vertex, an
/// edge, or a point of the plane, ending there at times.
template <class S>
Case<S> draw(Random& random, Numbers numbers) {
  const auto any = [&] { return bench::vector<S, 3>(random, numbers); };
  Case<S> c = {bench::ray<S, 3>(random, numbers), {}};
  const Point<S, 3> corner = any();
  Vector<S, 3> u = any(), v = any();
  if (random.one_in(2))
    u = at<S>(random.integer(-2, 2), random.integer(-2, 2), random.integer(-2, 2)),
    v = at<S>(1, random.integer(-2, 2), 0);
  const auto in_plane = [&](double x, double y) {
    return Point<S, 3>(corner + u * static_cast<S>(x) + v * static_cast<S>(y));
  };
  const bool planar = !random.one_in(4);
  for (int i = random.integer(random.one_in(8) ? 0 : 3, 7); i > 0; --i) {
    const Point<S, 3> x = planar ? in_plane(random.integer(-2, 2), random.integer(-2, 2)) : any();
    c.ring.push_back(finite(x) ? x : any());
  }
  if (c.ring.empty() || random.one_in(4)) return c;

  const int n = static_cast<int>(c.ring.size()), i = random.below(n);
  Point<S, 3> target = c.ring[i];
  if (random.one_in(3)) target = in_plane(random.integer(-4, 4) / 2., random.integer(-4, 4) / 2.);
  if (random.one_in(3))
    target = c.ring[i] + (c.ring[(i + 1) % n] - c.ring[i]) * static_cast<S>(random.integer(0, 4) / 4.);
  const Vector<S, 3> d = target - c.ray.origin;
  if (!finite(d)) return c;
  c.ray.direction = d;
  if (random.one_in(8)) c.ray.origin = target, c.ray.direction = u;
  if (random.one_in(4)) c.ray.range.hi = S(1), c.ray.range.lo = std::min(c.ray.range.lo, S(1));
  return c;
}

}  // namespace

TEMPLATE_TEST_CASE("a ray meets a polygon from either side", "[ray_polygon]", float, double) {
  using S = TestType;
  const auto r = intersect(down<S>(1, 3), angle<S>());
  CHECK(r);
  CHECK(r.location == Location::in);
  CHECK(r.t == S(2));
  CHECK(r.line == S(2));
  CHECK(intersect(Ray<S, 3>{at<S>(1, 3, -3), at<S>(0, 0, 2)}, angle<S>()).t == S(1.5));
  CHECK_FALSE(intersect(down<S>(3, 3), angle<S>()));  // in the notch
  CHECK(intersect(down<S>(3, 3), angle<S>()).line == S(2));
  Ring<S, 3> reversed = angle<S>();
  std::reverse(reversed.begin(), reversed.end());
  CHECK(intersect(down<S>(1, 3), reversed).t == S(2));
}

TEMPLATE_TEST_CASE("edges and vertices belong to the polygon", "[ray_polygon]", float, double) {
  using S = TestType;
  for (const auto& [x, y] : {std::pair{0., 0.}, {4., 1.}, {3., 2.}, {2., 2.}, {2., 3.}, {1., 4.}, {0., 1.}}) {
    CHECK(intersect(down<S>(x, y), angle<S>()).location == Location::on);
    CHECK(intersect(down<S>(x, y), angle<S>()).t == S(2));
  }
  for (const auto& [x, y] : {std::pair{-1e-30, 1.}, {4.001, 1.}, {3., 2.001}, {5., 0.}})
    CHECK(intersect(down<S>(x, y), angle<S>()).location == Location::out);
}

TEMPLATE_TEST_CASE("a polygon behind or beyond is missed", "[ray_polygon]", float, double) {
  using S = TestType;
  const Ray<S, 3> up = {at<S>(1, 1, 2), at<S>(0, 0, 1)};
  const auto r = intersect(up, angle<S>());
  CHECK((!r && r.location == Location::in && r.line == S(-2)));
  CHECK(intersect(line_through<S, 3>(at<S>(1, 1, 2), at<S>(1, 1, 3)), angle<S>()).t == S(-2));
  CHECK(intersect(segment<S, 3>(at<S>(1, 1, 2), at<S>(1, 1, 0)), angle<S>()).t == S(1));
  CHECK_FALSE(intersect(segment<S, 3>(at<S>(1, 1, 2), at<S>(1, 1, 0.001)), angle<S>()));
  CHECK_FALSE(intersect(Ray<S, 3>{at<S>(1, 1, 2), at<S>(0, 0, -1), {S(5), S(1)}}, angle<S>()));
}

TEMPLATE_TEST_CASE("holes and islands follow the fill rule", "[ray_polygon]", float, double) {
  using S = TestType;
  const Polygon<S, 3> nested = {{square<S>(0, 8), square<S>(2, 6), square<S>(3, 5)}};
  CHECK(intersect(down<S>(1, 1), nested).location == Location::in);
  CHECK(intersect(down<S>(2.5, 2.5), nested).location == Location::out);
  CHECK(intersect(down<S>(4, 4), nested).location == Location::in);
  CHECK(intersect(down<S>(2, 3), nested).location == Location::on);
  CHECK(intersect(down<S>(2.5, 2.5), nested, FillRule::nonzero).t == S(2));
}

TEMPLATE_TEST_CASE("a coplanar ray, a point and a flat polygon have answers", "[ray_polygon]", float, double) {
  using S = TestType;
  const auto within = intersect(Ray<S, 3>{at<S>(-1, 1), at<S>(1, 0, -0.)}, angle<S>());
  CHECK((!within && within.coplanar && !within.line && !within.flat));
  CHECK_FALSE(intersect(Ray<S, 3>{at<S>(-1, 1, 1), at<S>(1, 0)}, angle<S>()).coplanar);
  CHECK(intersect(Ray<S, 3>{at<S>(1, 1), at<S>(0, 0)}, angle<S>()).coplanar);
  for (const Ring<S, 3>& ring : {Ring<S, 3>{}, Ring<S, 3>{at<S>(0, 0)}, Ring<S, 3>{at<S>(0, 0), at<S>(1, 1)},
                                 Ring<S, 3>{at<S>(0, 0), at<S>(1, 1), at<S>(3, 3)},
                                 Ring<S, 3>{at<S>(0, 0), at<S>(2, 2), at<S>(2, 0), at<S>(0, 2)}}) {
    const auto r = intersect(down<S>(0, 0), ring);
    CHECK((!r && r.flat && !r.coplanar && !r.line));
  }
  CHECK(intersect(down<S>(0, 0), Polygon<S, 3>{}).flat);
}

TEMPLATE_TEST_CASE("a plane is found from collinear first vertices", "[ray_polygon]", float, double) {
  using S = TestType;
  const Ring<S, 3> ring = {at<S>(0, 0), at<S>(1, 0), at<S>(2, 0), at<S>(2, 2)};
  CHECK(intersect(down<S>(1.5, 1), ring).location == Location::in);
  CHECK(intersect(down<S>(1, 1), ring).location == Location::on);
}

TEMPLATE_TEST_CASE("ray and polygon: NaN and infinities meet nothing", "[ray_polygon]", float, double) {
  using S = TestType;
  for (const double bad : {not_a_number, inf, -inf}) {
    CHECK_FALSE(intersect(Ray<S, 3>{at<S>(1, 1, bad), at<S>(0, 0, -1)}, angle<S>()));
    CHECK_FALSE(intersect(Ray<S, 3>{at<S>(1, 1, 1), at<S>(0, bad, -1)}, angle<S>()));
    CHECK_FALSE(intersect(down<S>(1, 1), square<S>(0, bad)));
    CHECK_FALSE(intersect(down<S>(1, 1), Polygon<S, 3>{{square<S>(0, 4), square<S>(2, bad)}}));
  }
}

TEST_CASE("polygons of any size are met", "[ray_polygon]") {
  for (const double k : {1e-300, 1e-160, 1., 1e160, 1e300}) {
    const auto at_size = [&](double x, double y) {
      return intersect(Ray<double, 3>{{x * k, y * k, k}, {0, 0, -k / 2}}, square<double>(0, 4 * k));
    };
    CHECK(at_size(1, 3).t == 2);
    CHECK(at_size(4, 3).location == Location::on);
    CHECK(at_size(4.0000000000000009, 3).location == Location::out);
  }
}

TEST_CASE("an outline along the axes is looked at a few times, however many signs doubles leave open",
          "[ray_polygon]") {
  const auto looks_per_vertex = [](int teeth) {
    Ring<Watched, 3> comb;
    const auto add = [&](double x, double y) { comb.push_back({Watched{x}, Watched{y}, Watched{0}}); };
    for (int i = 0; i < teeth; ++i) add(4. * i, 0), add(4. * i, 1), add(4. * i + 2, 1), add(4. * i + 2, 0);
    add(4. * teeth, 0), add(4. * teeth, -1), add(0, -1);

    Watched::looks = 0;
    const Ray<double, 3> ray = {{-1, 1, 5}, {0, 0, -1}};  // in line with the tips of all teeth
    const ray_polygon::detail::Crossing<Watched> crossing(ray, comb);
    Record<ray_polygon::Event<double>> record;
    const int axis = ray_polygon::detail::steepest(crossing, record);
    CHECK(axis == 2);
    const std::span<const Ring<Watched, 3>> rings(&comb, 1);
    CHECK(ray_polygon::detail::locate(crossing, -1, axis, rings, FillRule::even_odd, record) == Location::out);
    CHECK(std::ranges::count_if(record.events,
                                [](const auto& event) { return std::holds_alternative<Fallback>(event); }) > 2 * teeth);
    return static_cast<double>(Watched::looks) / static_cast<double>(comb.size());
  };
  const double few = looks_per_vertex(10), many = looks_per_vertex(1000);
  CHECK(few < 100);
  CHECK(many < 1.1 * few);
}

TEST_CASE("the note's projection agrees on ordinary rays", "[ray_polygon]") {
  Random random(tests::seed());
  int hits = 0;
  for (int i = 0; i < 4000; ++i) {
    const Ray<double, 3> ray = {random.in_box<3>(2), random.in_box<3>(1)};
    const Point<double, 3> c = random.in_box<3>(1), u = random.in_box<3>(2), v = random.in_box<3>(2);
    const Ring<double, 3> ring = {c, c + u, c + u + v, c + 0.3 * u + 0.2 * v, c + v};
    INFO("seed " << tests::seed() << ", case " << i);
    const auto naive = ray_polygon::projected(ray, ring);
    const auto exact = intersect(ray, ring);
    REQUIRE(naive.has_value() == exact.t.has_value());
    if (naive) REQUIRE(*naive == Approx(*exact.t).margin(1e-12));
    hits += naive.has_value();
  }
  CHECK(hits > 50);
  using C = Counted<double>;
  tally() = {};
  const auto point = [](double x, double y, double z) { return Point<C, 3>(C(x), C(y), C(z)); };
  const Ring<C, 3> ring = {point(0, 0, 0), point(4, 0, 0), point(0, 4, 0)};
  CHECK(ray_polygon::projected<C>({point(1, 1, 1), point(0, 0, -1), {C(0), C(9)}}, ring));
  CHECK(tally().div >= 2);
}

TEMPLATE_TEST_CASE("ray and polygon: every answer is that of rational arithmetic", "[ray_polygon][random]", float,
                   double) {
  using S = TestType;
  int hits = 0, out = 0, on = 0, out_of_range = 0, coplanar = 0, flat = 0;
  double worst = 0;
  const int count = tests::cases(500, 150000);
  for (const Numbers numbers : bench::all_numbers) {
    Random random(tests::seed() + static_cast<int>(numbers));
    for (int i = 0; i < count; ++i) {
      const Case<S> c = draw<S>(random, numbers);
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      const RayPolygon<S> r = intersect(c.ray, c.ring);
      const oracle::RayPolygon expected = oracle::ray_polygon(c.ray, c.ring);
      REQUIRE(r.flat == expected.flat);
      REQUIRE(r.coplanar == expected.coplanar);
      REQUIRE(r.line.has_value() == (!expected.flat && !expected.parallel));
      REQUIRE(r.location == expected.location);
      REQUIRE(r.t.has_value() == expected.hit);
      hits += expected.hit, out += r.location == Location::out, on += r.location == Location::on;
      out_of_range += !r && r.location != Location::out, coplanar += r.coplanar, flat += r.flat;
      if (r.line) worst = std::max(worst, oracle::ulps(*r.line, expected.t));
      if (!r) continue;
      REQUIRE((c.ray.range.lo <= *r.t && *r.t <= c.ray.range.hi));
      worst = std::max(worst, oracle::ulps(*r.t, expected.t));
    }
  }
  CHECK(worst <= 2);
  for (const int often : {hits, out, on, out_of_range, coplanar, flat}) CHECK(often > count / 8);
}

TEMPLATE_TEST_CASE("triangles are met as ray_triangle meets them", "[ray_polygon][property]", float, double) {
  using S = TestType;
  int hits = 0;
  for (const Numbers numbers : bench::all_numbers) {
    Random random(tests::seed() + 50 + static_cast<int>(numbers));
    for (int i = 0; i < 300; ++i) {
      Case<S> c = draw<S>(random, numbers);
      while (c.ring.size() < 3) c.ring.push_back(bench::vector<S, 3>(random, numbers));
      c.ring.resize(3);
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      const RayPolygon<S> r = intersect(c.ray, c.ring);
      const RayTriangle<S> triangle = intersect(c.ray, Triangle<S, 3>{{c.ring[0], c.ring[1], c.ring[2]}});
      REQUIRE(r.coplanar == triangle.coplanar);
      REQUIRE(r.location == triangle.location);
      REQUIRE(r.t.has_value() == triangle.t.has_value());
      hits += r.t.has_value();
    }
  }
  CHECK(hits > 50);
}

TEMPLATE_TEST_CASE("no ray slips between neighbours of one plane", "[ray_polygon][random]", float, double) {
  using S = TestType;
  int slipped = 0, both = 0;
  const int count = tests::cases(3000, 300000);
  Random random(tests::seed());
  for (int i = 0; i < count; ++i) {
    const Numbers grid = Numbers::grid;
    const Point<S, 3> corner = bench::vector<S, 3>(random, grid);
    const Vector<S, 3> u = bench::vector<S, 3>(random, grid), v = bench::vector<S, 3>(random, grid);
    const auto in_plane = [&](double x, double y) {
      return Point<S, 3>(corner + u * static_cast<S>(x) + v * static_cast<S>(y));
    };
    const Point<S, 3> a = in_plane(0, 0), b = in_plane(7, 3);
    const Ring<S, 3> left = {a, b, in_plane(4, 9), in_plane(-1, 5)}, right = {b, a, in_plane(5, -2), in_plane(9, 0)};
    const Point<S, 3> target = a + (b - a) * static_cast<S>(random.uniform(0.01, 0.99));
    const Point<S, 3> origin = 50 * bench::vector<S, 3>(random, Numbers::ordinary);
    const Ray<S, 3> ray = {origin, (target - origin) * static_cast<S>(random.uniform(0.1, 10))};
    INFO("seed " << tests::seed() << ", case " << i);
    const RayPolygon<S> one = intersect(ray, left), two = intersect(ray, right);
    // nearly along the plane the rounded ray may leave the polygons
    if (one.flat || std::abs(u.cross(v).normalized().dot(ray.direction.normalized())) < S(0.01)) continue;
    REQUIRE((one || two));
    both += one && two;
    if (one && two) REQUIRE(one.location == Location::on);
    slipped += !ray_polygon::projected(ray, left) && !ray_polygon::projected(ray, right);
  }
  CHECK(slipped > 0);  // through the naive ones
}

TEMPLATE_TEST_CASE("ray and polygon: vertex order, axes, mirroring, scale and a listener change no verdict",
                   "[ray_polygon][property]", float, double) {
  using S = TestType;
  for (const Numbers numbers : bench::all_numbers) {
    Random random(tests::seed() + 100 + static_cast<int>(numbers));
    for (int i = 0; i < 200; ++i) {
      const Case<S> c = draw<S>(random, numbers);
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      const RayPolygon<S> r = intersect(c.ray, c.ring);
      Record<ray_polygon::Event<S>> record;
      REQUIRE(identical(intersect(c.ray, c.ring, FillRule::even_odd, record), r));
      REQUIRE(identical(intersect(c.ray, Polygon<S, 3>{{c.ring}}), r));

      const Ray<S, 3> mirrored = {c.ray.origin, -c.ray.direction, {-c.ray.range.hi, -c.ray.range.lo}};
      REQUIRE(same_verdicts(intersect(mirrored, c.ring), r));

      if (c.ring.empty()) continue;
      Ring<S, 3> reversed = c.ring;  // except vertex 0, which holds the plane
      std::reverse(reversed.begin() + 1, reversed.end());
      REQUIRE(same_verdicts(intersect(c.ray, reversed), r));

      if (numbers != Numbers::grid) continue;
      const S k = std::ldexp(S(1), random.integer(-20, 20));
      const Vector<S, 3> by = at<S>(64, -128, 32);
      Case<S> scaled = c, moved = c, flipped = c;
      scaled.ray.origin *= k, scaled.ray.direction *= k, moved.ray.origin += by;
      flipped.ray.origin[1] *= S(-1), flipped.ray.direction[1] *= S(-1);
      for (Point<S, 3>& v : scaled.ring) v *= k;
      for (Point<S, 3>& v : moved.ring) v += by;
      for (Point<S, 3>& v : flipped.ring) v[1] *= S(-1);
      REQUIRE(same_verdicts(intersect(scaled.ray, scaled.ring), r));
      REQUIRE(same_verdicts(intersect(moved.ray, moved.ring), r));
      REQUIRE(same_verdicts(intersect(flipped.ray, flipped.ring), r));
    }
  }
}

}  // namespace ray_polygon_test
