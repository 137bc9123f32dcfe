#include <isect/clip_segment.h>

#include <cmath>
#include <limits>

#include "bench/clip_segment/oracle.h"
#include "bench/random_rays.h"
#include "tests/catch.h"
#include "tests/core/common.h"
#include "tests/settings.h"

namespace clip_segment_test {
using namespace isect;
using bench::Numbers;
using bench::Random;
using oracle::Rational;
using tests::at, tests::inf, tests::not_a_number;

namespace {

/// x >= where.
template <class S, int N>
Plane<S, N> beyond(double where) {
  return {at<S, N>(1), static_cast<S>(-where)};
}
template <class S>
std::optional<Interval<S>> between(double lo, double hi) {
  return Interval<S>{static_cast<S>(lo), static_cast<S>(hi)};
}

/// A stretch of a line p + t (p1 - p), or p + t d, beside a plane that it often crosses at an end.
template <class S, int N>
struct Case {
  Ray<S, N> ray;
  Segment<S, N> segment;
  Plane<S, N> plane;
};
template <class S, int N>
Case<S, N> draw(Random& random, Numbers numbers) {
  Case<S, N> c;
  c.ray = bench::ray<S, N>(random, numbers);
  c.segment = {c.ray.origin, bench::vector<S, N>(random, numbers)};
  if (random.one_in(10)) c.segment.q = c.segment.p;
  c.plane = {bench::direction<S, N>(random, numbers), bench::number<S>(random, numbers)};
  if (random.one_in(2)) return c;
  const S t = random.one_in(2) ? c.ray.range.lo : c.ray.range.hi;
  const Point<S, N> x = random.one_in(2) ? c.segment.q : c.ray.at(std::isinf(t) ? S(0) : t);
  const S d = -c.plane.normal.dot(x);
  if (std::isfinite(d)) c.plane.d = d;
  return c;
}

/// How far the ends of a stretch are from the truth; infinite ends must be so.
template <class S>
double distance(const Interval<S>& kept, const oracle::Kept& expected) {
  const auto at = [](S t, const std::optional<Rational>& end) {
    if (!end) return std::isinf(t) ? 0 : inf;
    return oracle::ulps(t, *end);
  };
  return std::max(at(kept.lo, expected.lo), at(kept.hi, expected.hi));
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("a half-space keeps the part on its side", "[clip_segment]", FLOATS_AND_DIMENSIONS) {
  const Ray<S, N> up = {at<S, N>(-2), at<S, N>(2)}, down = {at<S, N>(4), at<S, N>(-2)};
  const S infinity = infinite<S>.hi;
  CHECK(clip(up, beyond<S, N>(1)) == Interval<S>{S(1.5), infinity});
  CHECK(clip(down, beyond<S, N>(1)) == between<S>(0, 1.5));
  CHECK(clip(up, beyond<S, N>(-3)) == semi_infinite<S>);
  CHECK_FALSE(clip(down, beyond<S, N>(5)));
  CHECK(clip(down, beyond<S, N>(4)) == between<S>(0, 0));
  CHECK(clip(line_through<S, N>(at<S, N>(0), at<S, N>(1)), beyond<S, N>(3)) == Interval<S>{S(3), infinity});
  CHECK(clip(segment<S, N>(at<S, N>(0), at<S, N>(4)), beyond<S, N>(4)) == between<S>(1, 1));
  CHECK(clip(Segment<S, N>{at<S, N>(0), at<S, N>(4)}, beyond<S, N>(1)) == between<S>(0.25, 1));
  CHECK_FALSE(clip(Segment<S, N>{at<S, N>(0), at<S, N>(4)}, beyond<S, N>(4.001)));
}

TEMPLATE_TEST_CASE_SIG("parallel rays and points are kept or not", "[clip_segment]", FLOATS_AND_DIMENSIONS) {
  CHECK(clip<S, N>(Ray<S, N>{at<S, N>(1), at<S, N>(0, 1)}, beyond<S, N>(1)) == semi_infinite<S>);
  CHECK(clip<S, N>(Ray<S, N>{at<S, N>(2), at<S, N>(0, 0)}, beyond<S, N>(1)) == semi_infinite<S>);
  CHECK_FALSE(clip<S, N>(Ray<S, N>{at<S, N>(0.5), at<S, N>(-0., 1)}, beyond<S, N>(1)));
  CHECK(clip(Segment<S, N>{at<S, N>(1), at<S, N>(1)}, beyond<S, N>(1)) == between<S>(0, 1));
}

TEMPLATE_TEST_CASE_SIG("a box keeps the part inside", "[clip_segment]", FLOATS_AND_DIMENSIONS) {
  const Aabb<S, N> box = {Point<S, N>::Constant(S(-1)), Point<S, N>::Constant(S(1))};
  CHECK(clip(Ray<S, N>{at<S, N>(-3), at<S, N>(1)}, box) == between<S>(2, 4));
  CHECK(clip(Segment<S, N>{at<S, N>(-3), at<S, N>(1)}, box) == between<S>(0.5, 1));
  CHECK(clip(Segment<S, N>{at<S, N>(-3), at<S, N>(-1)}, box) == between<S>(1, 1));
  CHECK(clip(Segment<S, N>{at<S, N>(0), at<S, N>(1, 1)}, box) == between<S>(0, 1));
  CHECK(clip(Segment<S, N>{at<S, N>(-2, 0), at<S, N>(0, 2)}, box) == between<S>(0.5, 0.5));  // a corner
  CHECK_FALSE(clip(Segment<S, N>{at<S, N>(-2, 0.01), at<S, N>(0, 2)}, box));
  CHECK(clip(Segment<S, N>{at<S, N>(1), at<S, N>(1)}, box) == between<S>(0, 1));
}

TEMPLATE_TEST_CASE_SIG("empty, infinite and NaN shapes keep nothing", "[clip_segment]", FLOATS_AND_DIMENSIONS) {
  const Ray<S, N> ray = {at<S, N>(2), at<S, N>(1)};
  const Segment<S, N> whole = {at<S, N>(2), at<S, N>(3)};
  CHECK_FALSE(clip(ray, Plane<S, N>{at<S, N>(0), S(1)}));
  CHECK_FALSE(clip(whole, Plane<S, N>{at<S, N>(0), S(1)}));
  CHECK_FALSE(clip(Ray<S, N>{at<S, N>(2), at<S, N>(1), {S(1), S(0)}}, beyond<S, N>(1)));
  CHECK_FALSE(clip(whole, Aabb<S, N>{at<S, N>(9), at<S, N>(0)}));
  for (const double bad : {not_a_number, inf, -inf}) {
    CHECK_FALSE(clip(ray, beyond<S, N>(bad)));
    CHECK_FALSE(clip(whole, beyond<S, N>(bad)));
    CHECK_FALSE(clip(Ray<S, N>{at<S, N>(2, bad), at<S, N>(1)}, beyond<S, N>(1)));
    CHECK_FALSE(clip(Segment<S, N>{at<S, N>(2), at<S, N>(2, bad)}, beyond<S, N>(1)));
    CHECK_FALSE(clip(Segment<S, N>{at<S, N>(2), at<S, N>(2, bad)}, Aabb<S, N>{at<S, N>(0), at<S, N>(9)}));
  }
}

TEST_CASE("a segment's end points count as they are, whatever their difference rounds to", "[clip_segment]") {
  // q - p rounds to -1e16: the rounded segment ends at 0, the true one at 1
  const Segment<double, 2> s = {{1e16 + 2, 0}, {1, 0}};
  CHECK(clip(s, Plane<double, 2>{{-1, 0}, 1}) == between<double>(1, 1));
  CHECK_FALSE(clip(s, Plane<double, 2>{{-1, 0}, .5}));
  CHECK_FALSE(clip(s, Aabb<double, 2>{{0, -1}, {.5, 1}}));
  for (const double k : {1e-300, 1., 1e300})
    CHECK(clip(Segment<double, 2>{{-k, 0}, {k, 0}}, Plane<double, 2>{{k, 0}, 0}) == between<double>(.5, 1));
}

TEMPLATE_TEST_CASE_SIG("segment and box: every answer is that of rational arithmetic", "[clip_segment][random]",
                       FLOATS_AND_DIMENSIONS) {
  using oracle::operator+;
  int kept = 0, lost = 0, whole = 0, points = 0;
  double worst = 0;
  const int count = tests::cases(500, 65000);
  for (const Numbers numbers : bench::all_numbers) {
    Random random(tests::seed() + static_cast<int>(numbers));
    for (int i = 0; i < count; ++i) {
      const Case<S, N> c = draw<S, N>(random, numbers);
      if (c.plane.normal == Vector<S, N>::Zero()) continue;
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      const auto o = oracle::rational<S, N>(c.ray.origin), d = oracle::rational<S, N>(c.ray.direction);
      const Interval<S> unit = {S(0), S(1)};
      const Rational h_0 = oracle::height<S, N>(c.plane, o), h_d = oracle::height<S, N>(c.plane, o + d);
      const std::optional<oracle::Kept> expected[] = {oracle::kept_above(c.ray.range, h_0, h_d),
                                                      oracle::clipped(c.segment, c.plane)};
      const std::optional<Interval<S>> got[] = {clip(c.ray, c.plane), clip(c.segment, c.plane)};
      const Interval<S> ranges[] = {c.ray.range, unit};
      for (int k = 0; k < 2; ++k) {
        REQUIRE(got[k].has_value() == expected[k].has_value());
        kept += got[k].has_value(), lost += !got[k];
        if (!got[k]) continue;
        REQUIRE((ranges[k].lo <= got[k]->lo && got[k]->lo <= got[k]->hi && got[k]->hi <= ranges[k].hi));
        worst = std::max(worst, distance(*got[k], *expected[k]));
        whole += *got[k] == ranges[k], points += got[k]->lo == got[k]->hi;
      }
      // mirrored: the other half-space keeps the rest
      const auto other = clip(c.ray, Plane<S, N>{-c.plane.normal, -c.plane.d});
      if (ray_range::has_points(c.ray.range)) REQUIRE((other || got[0]));
      Record<clip_segment::Event> record;
      REQUIRE(clip(c.ray, c.plane, record) == got[0]);
    }
  }
  CHECK(worst <= 2);
  for (const int often : {kept, lost, whole, points}) CHECK(often > count / 8);
}

TEMPLATE_TEST_CASE_SIG("segments are clipped at boxes as rational arithmetic clips them", "[clip_segment][random]",
                       FLOATS_AND_DIMENSIONS) {
  int kept = 0, lost = 0, touches = 0;
  double worst = 0;
  const int count = tests::cases(500, 65000);
  for (const Numbers numbers : bench::all_numbers) {
    Random random(tests::seed() + static_cast<int>(numbers));
    for (int i = 0; i < count; ++i) {
      const Point<S, N> a = bench::vector<S, N>(random, numbers), b = bench::vector<S, N>(random, numbers);
      const Aabb<S, N> box = {a.cwiseMin(b), a.cwiseMax(b)};
      Segment<S, N> s = {bench::vector<S, N>(random, numbers), bench::vector<S, N>(random, numbers)};
      for (int k = 0; k < N; ++k)  // ends on faces, edges and corners
        if (random.one_in(3)) s.q[k] = random.one_in(2) ? box.lo[k] : box.hi[k];
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      const std::optional<oracle::Kept> expected = oracle::clipped(s, box);
      const auto got = clip(s, box);
      REQUIRE(got.has_value() == expected.has_value());
      kept += got.has_value(), lost += !got;
      if (!got) continue;
      worst = std::max(worst, distance(*got, *expected));
      touches += *expected->lo == *expected->hi;
    }
  }
  CHECK(worst <= 2);
  for (const int often : {kept, lost, touches}) CHECK(often > count / 8);
}

TEMPLATE_TEST_CASE_SIG("an outcode names the sides that a point lies beyond", "[clip_segment]", FLOATS_AND_DIMENSIONS) {
  const Aabb<S, N> box = {Point<S, N>::Constant(S(-1)), Point<S, N>::Constant(S(1))};
  CHECK(clip_segment::outcode(at<S, N>(1, -1), box) == 0);
  CHECK(clip_segment::outcode(at<S, N>(-2, 0), box) == 1);
  CHECK(clip_segment::outcode(at<S, N>(2, 0), box) == 2);
  CHECK(clip_segment::outcode(at<S, N>(2, -2), box) == 6);
  CHECK(clip_segment::outcode(at<S, N>(0, 2), box) == 8);
}

}  // namespace clip_segment_test
