#include <isect/ray_capsule.h>

#include <isect/capsule_capsule.h>
#include "bench/capsule_capsule/oracle.h"
#include "bench/sphere_capsule/families.h"
#include "tests/catch.h"
#include "tests/core/motion.h"
#include "tests/settings.h"

namespace ray_capsule_test {
using namespace isect;
using oracle::Rational;

namespace {

constexpr double inf = std::numeric_limits<double>::infinity(), nan_ = std::numeric_limits<double>::quiet_NaN();

template <class S, int N>
Vector<S, N> at(double x, double y) {
  Vector<S, N> p = Vector<S, N>::Zero();
  p[0] = S(x), p[1] = S(y);
  return p;
}
template <class S, int N>
Ray<S, N> ray(double x, double y, double dx, double dy, double lo = 0, double hi = inf) {
  return {at<S, N>(x, y), at<S, N>(dx, dy), {S(lo), S(hi)}};
}
/// From (-3, 0) to (3, 0).
template <class S, int N>
Capsule<S, N> lying(double radius) {
  return {at<S, N>(-3, 0), at<S, N>(3, 0), S(radius)};
}

/// Checked with the ends of the capsule swapped, and with the ray turned round.
template <class S, int N>
bool met(const Ray<S, N>& ray, const Capsule<S, N>& c) {
  const bool hit = intersects(ray, c);
  CHECK(intersects(ray, Capsule<S, N>{c.q, c.p, c.radius}) == hit);
  CHECK(intersects(Ray<S, N>{ray.origin, -ray.direction, {-ray.range.hi, -ray.range.lo}}, c) == hit);
  return hit;
}

/// The square of the ray's distance from the axis. An end that is at infinity may as well lie beside the axis' ends:
/// the points of the line that are nearest to the axis lie between theirs.
template <class S, int N>
Rational distance2(const Ray<S, N>& ray, const Capsule<S, N>& capsule) {
  using namespace oracle;
  const Stretch<N> axis = stretch(capsule);
  const Coordinates<N> o = rational(ray.origin), d = rational(ray.direction);
  const Rational dd = dot(d, d);
  if (dd == 0) return oracle::distance2<N>(o, axis);
  const Rational tp = dot(axis.p - o, d) / dd, tq = dot(axis.at(1) - o, d) / dd;
  const bool from = std::isfinite(ray.range.lo), to = std::isfinite(ray.range.hi);
  Rational lo = from ? Rational(ray.range.lo) : std::min(tp, tq), hi = to ? Rational(ray.range.hi) : std::max(tp, tq);
  if (!from && lo > hi) lo = hi;
  if (!to && hi < lo) hi = lo;
  return oracle::distance2<N>(Stretch<N>{o + lo * d, (hi - lo) * d}, axis);
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("a ray meets a capsule from its side, at its ends, and from within", "[ray_capsule]",
                       FLOATS_AND_DIMENSIONS) {
  const Capsule<S, N> c = lying<S, N>(2);
  CHECK(met(ray<S, N>(1, 5, 0, -1), c));
  CHECK_FALSE(met(ray<S, N>(1, 5, 0, 1), c));
  CHECK(met(ray<S, N>(1, 5, 0, 1, -inf), c));
  CHECK(met(ray<S, N>(-9, 2, 1, 0), c));  // along the side
  CHECK(met(ray<S, N>(9, 0, -1, 0), c));
  CHECK_FALSE(met(ray<S, N>(9, 0, 1, 0), c));
  CHECK(met(ray<S, N>(0, 1, 1, 1), c));             // from within
  CHECK(met(ray<S, N>(0, 0, 1, 0, -0.5, 0.5), c));  // all of it within
  CHECK(met(ray<S, N>(1, 5, 0, -1, 0, 3), c));      // ends on the side
  CHECK_FALSE(met(ray<S, N>(1, 5, 0, -1, 0, 2.75), c));
  CHECK(met(ray<S, N>(1, 5, 0, -1, 7, 8), c));  // begins there
  CHECK_FALSE(met(ray<S, N>(1, 5, 0, -1, 7.25, 8), c));
  CHECK(met(ray<S, N>(9, 4, -1, 0, 3), lying<S, N>(5)));  // 3, 4, 5 from the end
  CHECK_FALSE(met(ray<S, N>(9, 4, -1, 0, 0, 2.75), lying<S, N>(5)));
  CHECK(met(ray<S, N>(1, 0, 0, 1), lying<S, N>(0)));  // a segment
  CHECK(met(ray<S, N>(3, 5, 0, -1), lying<S, N>(0)));
  CHECK_FALSE(met(ray<S, N>(std::nextafter(S(3), S(4)), 5, 0, -1), lying<S, N>(0)));
  CHECK_FALSE(met(ray<S, N>(1, 0, 0, 1), lying<S, N>(-1)));
}

TEMPLATE_TEST_CASE_SIG("ray and capsule: an ulp decides at the side and at an end", "[ray_capsule]",
                       FLOATS_AND_DIMENSIONS) {
  const S less = std::nextafter(S(2), S(0));
  CHECK(met(ray<S, N>(-9, 2, 1, 0), lying<S, N>(2)));
  CHECK_FALSE(met(ray<S, N>(-9, 2, 1, 0), lying<S, N>(less)));
  CHECK(met(ray<S, N>(5, -9, 0, 1), lying<S, N>(2)));  // tangent to the end
  CHECK_FALSE(met(ray<S, N>(5, -9, 0, 1), lying<S, N>(less)));
  const Capsule<S, N> slanted = {at<S, N>(-8, -6), at<S, N>(12, 9), S(5)};  // along (4, 3)
  CHECK(met(ray<S, N>(-3, 4, 8, 6), slanted));                              // 5 beside it
  CHECK_FALSE(met(ray<S, N>(-3, 4, 8, 6), Capsule<S, N>{slanted.p, slanted.q, std::nextafter(S(5), S(0))}));
}

TEMPLATE_TEST_CASE_SIG("ray and capsule: no direction, no range, nothing finite", "[ray_capsule]",
                       FLOATS_AND_DIMENSIONS) {
  const Capsule<S, N> c = lying<S, N>(2);
  for (const double lo : {-inf, 0.0, 5.0}) {
    CHECK(met(ray<S, N>(1, 2, 0, 0, lo), c));  // a point
    CHECK_FALSE(met(ray<S, N>(1, 2.5, 0, 0, lo), c));
  }
  CHECK_FALSE(met(ray<S, N>(1, 5, 0, -1, 1, 0), c));
  CHECK_FALSE(met(ray<S, N>(1, 5, 0, -1, inf, inf), c));
  CHECK_FALSE(met(ray<S, N>(1, 5, 0, -1, nan_, inf), c));
  for (const double bad : {nan_, inf, -inf}) {
    CHECK_FALSE(intersects(ray<S, N>(bad, 5, 0, -1), c));
    CHECK_FALSE(intersects(ray<S, N>(1, 5, 0, bad), c));
    CHECK_FALSE(intersects(ray<S, N>(1, 5, 0, -1), lying<S, N>(bad)));
    CHECK_FALSE(intersects(ray<S, N>(1, 5, 0, -1), Capsule<S, N>{at<S, N>(bad, 0), at<S, N>(3, 0), S(2)}));
  }
}

TEST_CASE("ray and capsule: in space lines pass each other", "[ray_capsule]") {
  const Capsule<double, 3> c = {{-3, 0, 0}, {3, 0, 0}, 2};
  CHECK(met(Ray<double, 3>{{1, -9, 2}, {0, 1, 0}, {0, inf}}, c));
  CHECK_FALSE(met(Ray<double, 3>{{1, -9, std::nextafter(2, 3)}, {0, 1, 0}, {0, inf}}, c));
  CHECK_FALSE(met(Ray<double, 3>{{1, -9, 2}, {0, 1, 0}, {0, std::nextafter(9, 0)}}, c));
  CHECK(met(Ray<double, 3>{{1, -9, 2}, {0, 1, 0}, {9, inf}}, c));
  CHECK_FALSE(met(Ray<double, 3>{{5.5, -9, 0}, {0, 1, 0}, {-inf, inf}}, c));
}

TEST_CASE("ray and capsule: the events tell each distance that was compared", "[ray_capsule]") {
  using namespace ray_capsule;
  Record<Event> record;
  intersects(Ray<double, 2>{{1, 5}, {0, -1}, {0, 4}}, {{-3, 0}, {3, 0}, 0.5}, record);
  REQUIRE(record.events.size() == 5);
  for (const int i : {0, 1}) CHECK(std::get<End>(record.events[static_cast<std::size_t>(i)]).end == 2 + i);
  for (const int i : {2, 3}) CHECK(std::get<End>(record.events[static_cast<std::size_t>(i)]).end == i - 2);
  CHECK_FALSE(std::get<Between>(record.events[4]).holds);
  record.events.clear();
  intersects(Ray<double, 2>{{1, 5}, {0, -1}, {0, inf}}, {{-3, 0}, {3, 0}, 0.5}, record);
  CHECK(std::get<Between>(record.events.back()).sign == -1);
}

TEMPLATE_TEST_CASE_SIG("ray and capsule: verdicts are those of rational arithmetic", "[ray_capsule]",
                       FLOATS_AND_DIMENSIONS) {
  bench::Random random(tests::seed());
  int hits = 0, misses = 0, touches = 0;
  for (const bench::Numbers numbers : bench::all_numbers)
    for (int i = 0; i < tests::cases(1500, 125000); ++i) {
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      Capsule<S, N> capsule = bench::capsule<S, N>(random, numbers);
      Ray<S, N> line = {bench::vector<S, N>(random, numbers), bench::vector<S, N>(random, numbers)};
      const auto along_an_axis = [&](Vector<S, N>& x) {
        for (int k = 0, kept = random.below(N); k < N; ++k)
          if (k != kept) x[k] = 0;
      };
      if (random.one_in(3)) along_an_axis(line.direction);
      if (random.one_in(3)) {
        Vector<S, N> axis = capsule.q - capsule.p;
        along_an_axis(axis);
        capsule.q = capsule.p + axis;
      }
      if (random.one_in(4)) line.direction = capsule.q - capsule.p;
      if (random.one_in(8)) line.origin = capsule.p / 2 + capsule.q / 2;
      if (random.one_in(20)) line.direction.setZero();
      const auto end = [&] { return static_cast<S>(random.integer(-8, 8)) / 4; };
      const S first = end(), last = end();
      line.range = {random.one_in(3) ? -std::numeric_limits<S>::infinity() : std::min(first, last),
                    random.one_in(2) ? std::numeric_limits<S>::infinity() : std::max(first, last)};
      if (!finite(line) || !finite(capsule)) continue;
      const Rational d2 = distance2(line, capsule);
      if (random.one_in(2))
        capsule.radius = bench::moved(static_cast<S>(std::sqrt(static_cast<double>(d2))), random.integer(-2, 2));
      if (!finite(capsule)) continue;

      const Rational r = capsule.radius;
      const bool hit = intersects(line, capsule);
      if (hit != oracle::at_most(d2, r)) FAIL("wrong");
      Record<ray_capsule::Event> record;
      if (intersects(line, capsule, record) != hit) FAIL("not the same when traced");
      if (numbers <= bench::Numbers::distant) {
        const tests::Motion<N> move = tests::motion<N>(random);
        const Ray<S, N> moved = {move(line.origin), move(Point<S, N>(line.direction)), line.range};
        if (intersects(moved, move(capsule)) != hit) FAIL("not the same when moved");
      }
      (hit ? hits : misses) += 1;
      touches += r > 0 && d2 == r * r;
    }
  CHECK(hits > 2000);
  CHECK(misses > 2000);
  CHECK(touches > 40);
}

}  // namespace ray_capsule_test
