#include <isect/methods/ray_aabb.h>
#include <isect/ray_aabb.h>

#include <cmath>
#include <limits>

#include <isect/counted.h>
#include "bench/random_rays.h"
#include "bench/ray_aabb/oracle.h"
#include "tests/catch.h"
#include "tests/core/common.h"
#include "tests/settings.h"

namespace ray_aabb_test {
using namespace isect;
using bench::Numbers;
using bench::Random;
using oracle::Rational;
using tests::at, tests::inf, tests::not_a_number;

namespace {

template <class S, int N>
Aabb<S, N> cube(double half = 1) {
  return {Point<S, N>::Constant(static_cast<S>(-half)), Point<S, N>::Constant(static_cast<S>(half))};
}
template <class S>
std::optional<Interval<S>> between(double lo, double hi) {
  return Interval<S>{static_cast<S>(lo), static_cast<S>(hi)};
}

template <class S, int N>
struct Case {
  Ray<S, N> ray;
  Aabb<S, N> box;
};

/// Any box, and a ray from anywhere or aimed: at a corner, an edge, a face or a point inside, ending there at times.
template <class S, int N>
Case<S, N> draw(Random& random, Numbers numbers) {
  const Point<S, N> a = bench::vector<S, N>(random, numbers), b = bench::vector<S, N>(random, numbers);
  Case<S, N> c = {bench::ray<S, N>(random, numbers), {a.cwiseMin(b), a.cwiseMax(b)}};
  if (random.one_in(20)) c.box = {a, b};  // inverted, mostly
  if (random.one_in(3)) return c;
  Point<S, N> target;
  for (int i = 0; i < N; ++i) {
    const S lo = c.box.lo[i], hi = c.box.hi[i];
    target[i] = random.one_in(3) ? lo / 2 + hi / 2 : random.one_in(2) ? lo : hi;
  }
  for (int i = 0; i < N; ++i)
    if (random.one_in(6)) c.ray.origin[i] = random.one_in(2) ? c.box.lo[i] : c.box.hi[i];
  const S slower = random.one_in(2) ? S(1) : static_cast<S>(random.integer(1, 9)) / 10;
  const Vector<S, N> d = (target - c.ray.origin) * slower;
  if (finite(d)) c.ray.direction = d;
  if (random.one_in(4)) c.ray.range.hi = S(1), c.ray.range.lo = std::min(c.ray.range.lo, S(1));
  return c;
}

/// Whether the ray is a point, whose answer is the range as it is.
template <class S, int N>
bool is_point(const Ray<S, N>& ray) {
  return ray.direction == Vector<S, N>::Zero();
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("a ray towards a box enters and leaves it", "[ray_aabb]", FLOATS_AND_DIMENSIONS) {
  CHECK(intersect<S, N>({at<S, N>(-3), at<S, N>(1)}, cube<S, N>()) == between<S>(2, 4));
  CHECK(intersect<S, N>({at<S, N>(3), at<S, N>(-2)}, cube<S, N>()) == between<S>(1, 2));
  CHECK(intersects<S, N>({at<S, N>(-3), at<S, N>(1)}, cube<S, N>()));
}

TEMPLATE_TEST_CASE_SIG("a ray from inside starts there", "[ray_aabb]", FLOATS_AND_DIMENSIONS) {
  CHECK(intersect<S, N>({at<S, N>(0), at<S, N>(1)}, cube<S, N>()) == between<S>(0, 1));
  CHECK(intersect<S, N>({at<S, N>(0), at<S, N>(1), infinite<S>}, cube<S, N>()) == between<S>(-1, 1));
}

TEMPLATE_TEST_CASE_SIG("a box behind is missed by the ray, not by the line", "[ray_aabb]", FLOATS_AND_DIMENSIONS) {
  const Ray<S, N> ray = {at<S, N>(3), at<S, N>(1)};
  CHECK_FALSE(intersect(ray, cube<S, N>()));
  CHECK(intersect(line_through<S, N>(at<S, N>(3), at<S, N>(4)), cube<S, N>()) == between<S>(-4, -2));
}

TEMPLATE_TEST_CASE_SIG("a segment meets what it reaches", "[ray_aabb]", FLOATS_AND_DIMENSIONS) {
  const auto from = at<S, N>(-3);
  CHECK(intersect(segment<S, N>(from, at<S, N>(-1)), cube<S, N>()) == between<S>(1, 1));
  CHECK_FALSE(intersect(segment<S, N>(from, at<S, N>(-1.0001)), cube<S, N>()));
  CHECK(intersect(segment<S, N>(from, at<S, N>(1)), cube<S, N>()) == between<S>(0.5, 1));
}

TEMPLATE_TEST_CASE_SIG("a ray along a face or through a corner touches", "[ray_aabb]", FLOATS_AND_DIMENSIONS) {
  for (const double zero : {0., -0.})
    for (const double y : {-1., 1.}) {
      CHECK(intersect<S, N>({at<S, N>(-3, y), at<S, N>(1, zero)}, cube<S, N>()) == between<S>(2, 4));
      CHECK(intersect<S, N>({at<S, N>(3, y), at<S, N>(-1, zero)}, cube<S, N>()) == between<S>(2, 4));
    }
  CHECK(intersect<S, N>({at<S, N>(-2, 0), at<S, N>(1, 1)}, cube<S, N>()) == between<S>(1, 1));
  CHECK_FALSE(intersect<S, N>({at<S, N>(-2.001, 0), at<S, N>(1, 1)}, cube<S, N>()));
}

TEST_CASE("the report's rays hit: a zero component on a slab, a negative zero", "[ray_aabb]") {
  const Aabb<double, 3> box = {{0, 0, 0}, {1, 1, 1}};
  CHECK(intersect<double, 3>({{1, .5, -1}, {0, 0, 1}}, box) == between<double>(1, 2));
  CHECK(intersect<double, 3>({{.5, .5, -1}, {-0., 0, 1}}, box) == between<double>(1, 2));
  CHECK(may_intersect(Ray<double, 3>{{1, .5, -1}, {0, 0, 1}}, box));
  CHECK(may_intersect(Ray<double, 3>{{1, .5, -1}, {-0., -0., 1}}, box));
  CHECK_FALSE(may_intersect(Ray<double, 3>{{2, .5, -1}, {-0., 0, 1}}, box));
}

TEMPLATE_TEST_CASE_SIG("ray and box: a zero direction makes the ray a point", "[ray_aabb]", FLOATS_AND_DIMENSIONS) {
  CHECK(intersect<S, N>({at<S, N>(1, 1), at<S, N>(0, -0.)}, cube<S, N>()) == semi_infinite<S>);
  CHECK(intersect<S, N>({at<S, N>(1), at<S, N>(0), {S(2), S(5)}}, cube<S, N>()) == between<S>(2, 5));
  CHECK_FALSE(intersect<S, N>({at<S, N>(1.5), at<S, N>(0)}, cube<S, N>()));
}

TEMPLATE_TEST_CASE_SIG("a box without thickness is met", "[ray_aabb]", FLOATS_AND_DIMENSIONS) {
  CHECK(intersect<S, N>({at<S, N>(-3), at<S, N>(1)}, {at<S, N>(1), at<S, N>(1)}) == between<S>(4, 4));
  CHECK_FALSE(intersect<S, N>({at<S, N>(-3), at<S, N>(1)}, {at<S, N>(1, 1), at<S, N>(1, 1)}));
}

TEMPLATE_TEST_CASE_SIG("ray and box: an empty box or range, infinities and NaN meet nothing", "[ray_aabb]",
                       FLOATS_AND_DIMENSIONS) {
  const Ray<S, N> ray = {at<S, N>(-3), at<S, N>(1)};
  const auto never = [](const Ray<S, N>& r, const Aabb<S, N>& b) { return !intersect(r, b) && !may_intersect(r, b); };
  CHECK(never(ray, cube<S, N>(-1)));
  CHECK(never({ray.origin, ray.direction, {S(9), S(1)}}, cube<S, N>()));
  for (const double bad : {not_a_number, inf, -inf}) {
    CHECK(never({at<S, N>(0, bad), at<S, N>(1)}, cube<S, N>()));
    CHECK(never({at<S, N>(0), at<S, N>(1, bad)}, cube<S, N>()));
    Aabb<S, N> box = cube<S, N>();
    box.hi[1] = static_cast<S>(bad);
    CHECK_FALSE(intersect(ray, box));
  }
  CHECK(never(ray, cube<S, N>(not_a_number)));
  CHECK(never({at<S, N>(0), at<S, N>(1), {static_cast<S>(not_a_number), S(1)}}, cube<S, N>()));
  CHECK_FALSE(intersect(ray, cube<S, N>(inf)));
  const S infinity = static_cast<S>(inf);
  CHECK_FALSE(intersect<S, N>({at<S, N>(0), at<S, N>(0), {infinity, infinity}}, cube<S, N>()));
}

TEST_CASE("boxes and directions of any size meet where they meet", "[ray_aabb]") {
  for (const double size : {1e-300, 1e-150, 1., 1e150, 1e300})
    for (const double speed : {1e-308, 1e-300, 1., 1e300}) {
      const Ray<double, 3> ray = {{-3 * size, size, 0}, {speed, 0, 0}};
      const auto t = intersect(ray, cube<double, 3>(size));
      REQUIRE(t);
      CHECK(oracle::ulps(t->lo, (Rational(3 * size) - Rational(size)) / Rational(speed)) <= 4);
      CHECK(may_intersect(ray, cube<double, 3>(size)));
      CHECK_FALSE(intersect<double, 3>({{-3 * size, size * (1 + 1e-15), 0}, {speed, 0, 0}}, cube<double, 3>(size)));
    }
  const double most = std::numeric_limits<double>::max();
  CHECK(intersect<double, 2>({{-most, -most}, {most, most}}, cube<double, 2>(most)) == between<double>(0, 2));
}

TEST_CASE("the slab method agrees on ordinary rays", "[ray_aabb]") {
  Random random(tests::seed());
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    const Ray<double, 3> ray = {random.in_box<3>(2), random.in_box<3>(1)};
    INFO("seed " << tests::seed() << ", case " << i);
    const auto naive = ray_aabb::slabs_naive(ray, cube<double, 3>()), exact = intersect(ray, cube<double, 3>());
    REQUIRE(naive.has_value() == exact.has_value());
    if (!exact) continue;
    ++hits;
    REQUIRE(naive->lo == Approx(exact->lo));
    REQUIRE(naive->hi == Approx(exact->hi));
  }
  CHECK(hits > 200);
  using C = Counted<double>;
  tally() = {};
  CHECK(ray_aabb::slabs_naive<C, 2>({{C(-3), C(0)}, {C(1), C(1)}, {C(0), C(9)}}, {{C(-1), C(-9)}, {C(1), C(9)}}));
  CHECK(tally().div == 4);
}

TEMPLATE_TEST_CASE_SIG("ray and box: every answer is that of rational arithmetic", "[ray_aabb][random]",
                       FLOATS_AND_DIMENSIONS) {
  int hits = 0, misses = 0, touches = 0, may_miss = 0;
  double worst = 0;
  const int count = tests::cases(600, 130000);
  for (const Numbers numbers : bench::all_numbers) {
    Random random(tests::seed() + static_cast<int>(numbers));
    for (int i = 0; i < count; ++i) {
      const Case<S, N> c = draw<S, N>(random, numbers);
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      const std::optional<Interval<S>> t = intersect(c.ray, c.box);
      REQUIRE(first_hit(c.ray, c.box) == (t ? std::optional<S>(t->lo) : std::nullopt));
      const auto expected = empty(c.ray.range) ? std::nullopt : oracle::ray_aabb(c.ray, c.box);
      REQUIRE(t.has_value() == expected.has_value());
      const bool may = may_intersect(c.ray, c.box);
      hits += t.has_value(), misses += !t, may_miss += !may;
      if (!t) continue;
      REQUIRE(may);
      REQUIRE((c.ray.range.lo <= t->lo && t->lo <= t->hi && t->hi <= c.ray.range.hi));
      if (is_point(c.ray)) {
        REQUIRE(*t == c.ray.range);
        continue;
      }
      touches += expected->first == expected->second;
      worst = std::max({worst, oracle::ulps(t->lo, expected->first), oracle::ulps(t->hi, expected->second)});
    }
  }
  CHECK(worst <= 4);
  for (const int often : {hits, misses, touches, may_miss}) CHECK(often > count / 4);
}

TEMPLATE_TEST_CASE_SIG("the conservative test misses no ray that is aimed at an edge or a corner", "[ray_aabb][random]",
                       FLOATS_AND_DIMENSIONS) {
  Random random(tests::seed());
  int needless = 0, hits = 0, naive = 0;
  const int count = tests::cases(20000, 1000000);
  for (int i = 0; i < count; ++i) {
    const Point<S, N> a = bench::vector<S, N>(random, Numbers::ordinary),
                      b = bench::vector<S, N>(random, Numbers::ordinary);
    const Aabb<S, N> box = {a.cwiseMin(b), a.cwiseMax(b)};
    Point<S, N> target = random.one_in(2) ? box.lo : box.hi;
    if (random.one_in(2)) target[0] = box.lo[0] / 2 + box.hi[0] / 2;
    const Point<S, N> origin = 4 * bench::vector<S, N>(random, Numbers::ordinary);
    const S length = static_cast<S>(random.uniform(0.1, 10));
    const Ray<S, N> ray = {origin, (target - origin) * length};
    INFO("seed " << tests::seed() << ", case " << i);
    const bool hit = intersects(ray, box), may = may_intersect(ray, box);
    if (hit) REQUIRE(may);
    hits += hit, needless += may && !hit, naive += hit && !ray_aabb::slabs_naive(ray, box);
  }
  CHECK(hits > count / 4);
  CHECK(needless > 0);
  CHECK(needless < count / 2);
  CHECK(naive > count / 1000);  // the textbook's test misses some
}

TEMPLATE_TEST_CASE_SIG("ray and box: listening, mirroring, swapping axes, scaling and moving change no answer",
                       "[ray_aabb][property]", FLOATS_AND_DIMENSIONS) {
  for (const Numbers numbers : bench::all_numbers) {
    Random random(tests::seed() + 100 + static_cast<int>(numbers));
    for (int i = 0; i < 300; ++i) {
      const Case<S, N> c = draw<S, N>(random, numbers);
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      const std::optional<Interval<S>> t = intersect(c.ray, c.box);
      REQUIRE(first_hit(c.ray, c.box) == (t ? std::optional<S>(t->lo) : std::nullopt));

      Record<ray_aabb::Event> record;
      REQUIRE(intersect(c.ray, c.box, record) == t);

      const Ray<S, N> mirrored = {c.ray.origin, -c.ray.direction, {-c.ray.range.hi, -c.ray.range.lo}};
      REQUIRE(intersects(mirrored, c.box) == t.has_value());

      Case<S, N> turned = c;
      for (Vector<S, N>* v : {&turned.ray.origin, &turned.ray.direction, &turned.box.lo, &turned.box.hi}) {
        std::swap((*v)[0], (*v)[N - 1]);
        (*v)[1] = -(*v)[1];
      }
      std::swap(turned.box.lo[1], turned.box.hi[1]);
      REQUIRE(intersects(turned.ray, turned.box) == t.has_value());

      const S by = std::ldexp(S(1), random.integer(-8, 8));
      Case<S, N> scaled = c;
      scaled.ray.origin *= by, scaled.ray.direction *= by, scaled.box.lo *= by, scaled.box.hi *= by;
      const bool exact = scaled.ray.origin / by == c.ray.origin && scaled.ray.direction / by == c.ray.direction &&
                         scaled.box.lo / by == c.box.lo && scaled.box.hi / by == c.box.hi;
      if (exact) REQUIRE(intersects(scaled.ray, scaled.box) == t.has_value());

      if (numbers != Numbers::grid) continue;
      Case<S, N> moved = c;
      const Vector<S, N> shift = at<S, N>(random.integer(-1000, 1000), random.integer(-1000, 1000));
      moved.ray.origin += shift, moved.box.lo += shift, moved.box.hi += shift;
      if (moved.ray.origin - shift == c.ray.origin) REQUIRE(intersects(moved.ray, moved.box) == t.has_value());
    }
  }
}

TEMPLATE_TEST_CASE_SIG("both ends of the stretch lie in the box", "[ray_aabb][property]", FLOATS_AND_DIMENSIONS) {
  Random random(tests::seed());
  for (int i = 0; i < 4000; ++i) {
    const Case<S, N> c = draw<S, N>(random, i % 2 ? Numbers::decimal : Numbers::distant);
    INFO("seed " << tests::seed() << ", case " << i);
    const std::optional<Interval<S>> stretch = intersect(c.ray, c.box);
    if (!stretch) continue;
    for (const S t : {stretch->lo, stretch->hi}) {
      if (std::isinf(t)) continue;
      const S near = 4 * std::numeric_limits<S>::epsilon() *
                     (c.ray.origin.cwiseAbs().maxCoeff() + std::abs(t) * c.ray.direction.cwiseAbs().maxCoeff());
      const Point<S, N> x = c.ray.at(t);
      REQUIRE(((x - c.box.lo).array() >= -near).all());
      REQUIRE(((c.box.hi - x).array() >= -near).all());
    }
  }
}

}  // namespace ray_aabb_test
