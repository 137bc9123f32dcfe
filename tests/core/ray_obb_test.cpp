#include <isect/methods/ray_obb.h>
#include <isect/ray_obb.h>

#include <cmath>
#include <limits>

#include <isect/ray_aabb.h>
#include "bench/ray_obb/families.h"
#include "bench/ray_obb/oracle.h"
#include "tests/catch.h"
#include "tests/core/common.h"
#include "tests/core/ray_obb_pairs.h"
#include "tests/settings.h"

namespace ray_obb_test {
using namespace isect;
using bench::Numbers;
using bench::Random;
using oracle::Rational;
using namespace tests::ray_obb_pairs;
using tests::at, tests::inf, tests::not_a_number;

namespace {

template <class S>
std::optional<Interval<S>> between(double lo, double hi) {
  return Interval<S>{static_cast<S>(lo), static_cast<S>(hi)};
}

/// The unit box about the origin, with axes times `length`.
template <class S, int N>
Obb<S, N> cube(double half = 1, double length = 1) {
  const Eigen::Matrix<S, N, N> axes = Eigen::Matrix<S, N, N>::Identity() * static_cast<S>(length);
  return {at<S, N>(0), axes, Vector<S, N>::Constant(static_cast<S>(half / length))};
}
/// The box { |x + y| <= 2, |x - y| <= 2, |z| <= 2 }: axes (1, 1) and (-1, 1) at 45 degrees, not of unit length.
template <class S, int N>
Obb<S, N> diamond() {
  Obb<S, N> box = cube<S, N>();
  box.axes(0, 0) = box.axes(1, 0) = box.axes(1, 1) = S(1), box.axes(0, 1) = S(-1);
  if (N == 3) box.half[N - 1] = S(2);
  return box;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("a ray enters and leaves an aligned box", "[ray_obb]", FLOATS_AND_DIMENSIONS) {
  for (const double length : {1., 0.25, 8.}) {
    CHECK(intersect<S, N>({at<S, N>(-3), at<S, N>(1)}, cube<S, N>(1, length)) == between<S>(2, 4));
    CHECK_FALSE(intersects<S, N>({at<S, N>(3), at<S, N>(1)}, cube<S, N>(1, length)));
    CHECK(intersect<S, N>({at<S, N>(0), at<S, N>(1)}, cube<S, N>(1, length)) == between<S>(0, 1));
    CHECK(intersect(line_through<S, N>(at<S, N>(3), at<S, N>(4)), cube<S, N>(1, length)) == between<S>(-4, -2));
  }
}

TEMPLATE_TEST_CASE_SIG("a ray touches a turned box at its corner and misses beyond it", "[ray_obb]",
                       FLOATS_AND_DIMENSIONS) {
  CHECK(intersect<S, N>({at<S, N>(-3), at<S, N>(1)}, diamond<S, N>()) == between<S>(1, 5));
  CHECK(intersect<S, N>({at<S, N>(-3, 2), at<S, N>(1)}, diamond<S, N>()) == between<S>(3, 3));
  const S above = std::nextafter(S(2), S(3));
  CHECK_FALSE(intersect<S, N>({at<S, N>(-3, static_cast<double>(above)), at<S, N>(1)}, diamond<S, N>()));
  // along a face
  CHECK(intersect<S, N>({at<S, N>(2), at<S, N>(-1, 1)}, diamond<S, N>()) == between<S>(0, 2));
  CHECK_FALSE(intersect<S, N>({at<S, N>(static_cast<double>(above)), at<S, N>(-1, 1)}, diamond<S, N>()));
}

TEMPLATE_TEST_CASE_SIG("skew axes are taken literally", "[ray_obb]", FLOATS_AND_DIMENSIONS) {
  Obb<S, N> box = cube<S, N>();
  box.axes(0, 1) = S(1);  // the second axis is (1, 1): a parallelogram with corners (2, 1), (0, 1), (-2, -1), (0, -1)
  CHECK(intersect<S, N>({at<S, N>(-5, 1), at<S, N>(1)}, box) == between<S>(5, 7));
  CHECK(intersect<S, N>({at<S, N>(-5, -1), at<S, N>(1)}, box) == between<S>(3, 5));
  CHECK(intersect<S, N>({at<S, N>(-2, 1), at<S, N>(0, -1)}, box) == between<S>(2, 2));
}

TEMPLATE_TEST_CASE_SIG("mirrored axes make the same box, dependent ones none", "[ray_obb]", FLOATS_AND_DIMENSIONS) {
  const Ray<S, N> ray = {at<S, N>(-3), at<S, N>(1)};
  Obb<S, N> box = cube<S, N>();
  box.axes.col(1) *= S(-1);
  CHECK(intersect(ray, box) == between<S>(2, 4));
  box.axes.col(1) = box.axes.col(0);
  CHECK_FALSE(intersect(ray, box));
  box.axes.col(1) *= S(0);
  CHECK_FALSE(intersect(ray, box));
}

TEMPLATE_TEST_CASE_SIG("points and flat boxes have answers", "[ray_obb]", FLOATS_AND_DIMENSIONS) {
  CHECK(intersect<S, N>({at<S, N>(2), at<S, N>(0, -0.)}, diamond<S, N>()) == semi_infinite<S>);
  CHECK_FALSE(intersect<S, N>({at<S, N>(2, 1), at<S, N>(0)}, diamond<S, N>()));
  Obb<S, N> flat = diamond<S, N>();
  flat.half[0] = S(0);  // x + y = 0
  CHECK(intersect<S, N>({at<S, N>(-3), at<S, N>(1)}, flat) == between<S>(3, 3));
  CHECK(intersect<S, N>({at<S, N>(-3, 1), at<S, N>(1)}, flat) == between<S>(2, 2));
  CHECK_FALSE(intersect<S, N>({at<S, N>(-3, 1.5), at<S, N>(1)}, flat));
}

TEMPLATE_TEST_CASE_SIG("ray and OBB: an empty box or range, infinities and NaN meet nothing", "[ray_obb]",
                       FLOATS_AND_DIMENSIONS) {
  const Ray<S, N> ray = {at<S, N>(-3), at<S, N>(1)};
  CHECK_FALSE(intersect(ray, cube<S, N>(-1)));
  CHECK_FALSE(intersect<S, N>({ray.origin, ray.direction, {S(9), S(1)}}, cube<S, N>()));
  for (const double bad : {not_a_number, inf, -inf}) {
    CHECK_FALSE(intersect<S, N>({at<S, N>(0, bad), at<S, N>(1)}, cube<S, N>()));
    CHECK_FALSE(intersect<S, N>({at<S, N>(0), at<S, N>(1, bad)}, cube<S, N>()));
    CHECK_FALSE(intersect(ray, cube<S, N>(bad)));
    CHECK_FALSE(intersect(ray, cube<S, N>(1, bad)));
    Obb<S, N> box = cube<S, N>();
    box.center[1] = static_cast<S>(bad);
    CHECK_FALSE(intersect(ray, box));
  }
  CHECK_FALSE(intersect<S, N>({at<S, N>(0), at<S, N>(1), {static_cast<S>(not_a_number), S(1)}}, cube<S, N>()));
}

TEST_CASE("oriented boxes of any size are met where they are", "[ray_obb]") {
  for (const double size : {1e-300, 1e-150, 1., 1e150, 1e300}) {
    Obb<double, 3> box = diamond<double, 3>();
    box.half *= size;
    CHECK(intersect<double, 3>({{-3 * size, 2 * size, 0}, {size, 0, 0}}, box));
    CHECK_FALSE(intersect<double, 3>({{-3 * size, 2 * size * (1 + 1e-15), 0}, {size, 0, 0}}, box));
    box = diamond<double, 3>();
    box.axes *= size;
    CHECK(intersect<double, 3>({{-3 * size, 2 * size, 0}, {1e-300, 0, 0}}, box));
  }
}

TEST_CASE("a listener finds the very ends that are found without it, in a box of 1e-156", "[ray_obb]") {
  Obb<double, 2> box = cube<double, 2>();
  box.center = {-2.913414348125081e-157, 0};
  box.axes << 0.6, -0.8, 0.8, 0.6;
  box.half = {5.826828696250162e-157, 8.740243044375242e-157};
  const Ray<double, 2> line = {{0, -8.740243044375242e-157}, {0, 1e-323}, {-inf, inf}};
  Record<ray_obb::Event> record;
  CHECK(intersect(line, box, record) == intersect(line, box));
}

TEMPLATE_TEST_CASE_SIG("ray and OBB: every answer is that of rational arithmetic", "[ray_obb][random]",
                       FLOATS_AND_DIMENSIONS) {
  int hits = 0, misses = 0, touches = 0;
  double worst = 0;
  const int count = tests::cases(300, 90000);
  for (const Numbers numbers : bench::all_numbers) {
    Random random(tests::seed() + static_cast<int>(numbers));
    for (int i = 0; i < count; ++i) {
      const Case<S, N> c = draw<S, N>(random, numbers);
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      const std::optional<Interval<S>> t = intersect(c.ray, c.box);
      REQUIRE(first_hit(c.ray, c.box) == (t ? std::optional<S>(t->lo) : std::nullopt));
      const auto expected = oracle::ray_obb(c.ray, c.box);
      REQUIRE(t.has_value() == expected.has_value());
      hits += t.has_value(), misses += !t;
      if (!t) continue;
      REQUIRE((c.ray.range.lo <= t->lo && t->lo <= t->hi && t->hi <= c.ray.range.hi));
      if (c.ray.direction == Vector<S, N>::Zero()) {
        REQUIRE(*t == c.ray.range);
        continue;
      }
      touches += expected->first == expected->second;
      worst = std::max({worst, oracle::ulps(t->lo, expected->first), oracle::ulps(t->hi, expected->second)});
    }
  }
  CHECK(worst <= 2);
  for (const int often : {hits, misses, touches}) CHECK(often > count / 4);
}

TEMPLATE_TEST_CASE("ray and OBB: the measured families are decided rightly, and break the naive method", "[ray_obb]",
                   float, double) {
  const int cases = tests::cases(150, 20000);
  for (const auto& drawn : bench::ray_obb_draws<TestType>) {
    Random random(tests::seed());
    int naive_wrong = 0, hits = 0;
    for (int i = 0; i < cases; ++i) {
      INFO("seed " << tests::seed() << ", family " << drawn.name << ", case " << i);
      const auto [ray, box] = drawn.draw(random);
      const auto truth = oracle::ray_obb(ray, box);
      const auto part = intersect(ray, box);
      REQUIRE(part.has_value() == truth.has_value());
      REQUIRE(intersects(ray, box) == truth.has_value());
      if (part) REQUIRE(oracle::ulps(part->lo, truth->first) <= 2);
      naive_wrong += ray_obb::projections(ray, box).has_value() != truth.has_value(), hits += truth.has_value();
    }
    INFO(drawn.name);
    CHECK((naive_wrong > 0) == drawn.hard());
    const bool invalid = drawn.name == std::string_view("invalid");
    CHECK((invalid ? hits == 0 : cases / 10 < hits && hits < cases));
  }
}

TEMPLATE_TEST_CASE_SIG("the identity's box is the aligned box", "[ray_obb][property]", FLOATS_AND_DIMENSIONS) {
  int hits = 0;
  for (const Numbers numbers : bench::all_numbers) {
    Random random(tests::seed() + static_cast<int>(numbers));
    for (int i = 0; i < 200; ++i) {
      Case<S, N> c = draw<S, N>(random, numbers);
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      c.box.axes = Eigen::Matrix<S, N, N>::Identity();
      const Aabb<S, N> box = {c.box.center - c.box.half, c.box.center + c.box.half};
      const bool exact = Point<S, N>(c.box.center - box.lo) == c.box.half &&
                         Point<S, N>(box.hi - c.box.center) == c.box.half &&
                         Point<S, N>(box.lo + c.box.half) == c.box.center && numbers == Numbers::grid;
      if (!exact) continue;
      REQUIRE(intersects(c.ray, c.box) == intersects(c.ray, box));
      hits += intersects(c.ray, box);
    }
  }
  CHECK(hits > 20);
}

TEMPLATE_TEST_CASE_SIG("ray and OBB: listening, mirroring, swapping axes, scaling and moving change no answer",
                       "[ray_obb][property]", FLOATS_AND_DIMENSIONS) {
  for (const Numbers numbers : bench::all_numbers) {
    Random random(tests::seed() + 100 + static_cast<int>(numbers));
    for (int i = 0; i < 100; ++i) {
      const Case<S, N> c = draw<S, N>(random, numbers);
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      const std::optional<Interval<S>> t = intersect(c.ray, c.box);
      REQUIRE(first_hit(c.ray, c.box) == (t ? std::optional<S>(t->lo) : std::nullopt));

      Record<ray_obb::Event> record;
      REQUIRE(intersect(c.ray, c.box, record) == t);

      Case<S, N> tiny = c;  // in any unit of length
      const S unit = static_cast<S>(std::is_same_v<S, float> ? 0x1p-110 : 0x1p-500);
      tiny.ray.origin *= unit, tiny.ray.direction *= unit, tiny.box.center *= unit, tiny.box.half *= unit;
      REQUIRE(intersect(tiny.ray, tiny.box, record) == intersect(tiny.ray, tiny.box));

      const Ray<S, N> mirrored = {c.ray.origin, -c.ray.direction, {-c.ray.range.hi, -c.ray.range.lo}};
      REQUIRE(intersects(mirrored, c.box) == t.has_value());

      Case<S, N> turned = c;  // the frame
      for (Vector<S, N>* v : {&turned.ray.origin, &turned.ray.direction, &turned.box.center}) v->reverseInPlace();
      turned.box.axes = c.box.axes.colwise().reverse();
      REQUIRE(intersects(turned.ray, turned.box) == t.has_value());

      Case<S, N> renamed = c;  // the axes
      renamed.box.axes.col(0).swap(renamed.box.axes.col(1));
      renamed.box.axes.col(0) *= S(-1);
      std::swap(renamed.box.half[0], renamed.box.half[1]);
      REQUIRE(intersects(renamed.ray, renamed.box) == t.has_value());

      if (numbers != Numbers::grid) continue;
      Case<S, N> scaled = c;
      const S by = std::ldexp(S(1), random.integer(-8, 8));
      scaled.ray.origin *= by, scaled.ray.direction *= by, scaled.box.center *= by, scaled.box.half *= by;
      REQUIRE(intersects(scaled.ray, scaled.box) == t.has_value());

      Case<S, N> moved = c;
      const Vector<S, N> shift = at<S, N>(random.integer(-1000, 1000), random.integer(-1000, 1000));
      moved.ray.origin += shift, moved.box.center += shift;
      if (moved.ray.origin - shift == c.ray.origin) REQUIRE(intersects(moved.ray, moved.box) == t.has_value());
    }
  }
}

}  // namespace ray_obb_test
