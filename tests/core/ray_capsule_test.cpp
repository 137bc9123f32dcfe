#include <isect/ray_capsule.h>

#include <isect/capsule_capsule.h>
#include "bench/capsule_capsule/oracle.h"
#include "bench/ray_capsule/oracle.h"
#include "bench/sphere_capsule/families.h"
#include "tests/catch.h"
#include "tests/core/common.h"
#include "tests/core/motion.h"
#include "tests/core/ray_capsule_pairs.h"
#include "tests/settings.h"

namespace ray_capsule_test {
using namespace isect;
using oracle::Rational;
using tests::at, tests::inf, tests::not_a_number;

namespace {

template <class S, int N>
Ray<S, N> ray(double x, double y, double dx, double dy, double lo = 0, double hi = inf) {
  return {at<S, N>(x, y), at<S, N>(dx, dy), {S(lo), S(hi)}};
}
/// A capsule from (-3, 0) to (3, 0).
template <class S, int N>
Capsule<S, N> lying(double radius) {
  return {at<S, N>(-3, 0), at<S, N>(3, 0), S(radius)};
}

/// Whether they meet, checked with the ends of the capsule swapped, and with the ray reversed.
template <class S, int N>
bool met(const Ray<S, N>& ray, const Capsule<S, N>& c) {
  const bool hit = intersects(ray, c);
  CHECK(intersects(ray, Capsule<S, N>{c.q, c.p, c.radius}) == hit);
  CHECK(intersects(Ray<S, N>{ray.origin, -ray.direction, {-ray.range.hi, -ray.range.lo}}, c) == hit);
  return hit;
}

/// The square of the ray's distance from the axis. An infinite end may be replaced by one beside the axis' ends: the
/// points of the line that are nearest to the axis lie between them.
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
  CHECK_FALSE(met(ray<S, N>(1, 5, 0, -1, not_a_number, inf), c));
  for (const double bad : {not_a_number, inf, -inf}) {
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

TEMPLATE_TEST_CASE_SIG("the part of a ray in a capsule, by its side and by its ends", "[ray_capsule]",
                       FLOATS_AND_DIMENSIONS) {
  const Capsule<S, N> c = lying<S, N>(2);
  const auto part = [&](const Ray<S, N>& line, const Capsule<S, N>& capsule) {
    const auto found = intersect(line, capsule);
    CHECK(intersect(line, Capsule<S, N>{capsule.q, capsule.p, capsule.radius}) == found);
    CHECK(first_hit(line, capsule) == (found ? std::optional(found->lo) : std::nullopt));
    return found;
  };
  using Part = Interval<S>;
  CHECK(part(ray<S, N>(1, 5, 0, -1), c) == Part{3, 7});                // through both sides
  CHECK(part(ray<S, N>(1, 5, 0, -1, 4, 6), c) == Part{4, 6});          // all of it within
  CHECK(part(ray<S, N>(1, 5, 0, -1, -inf), c) == Part{3, 7});          // the line
  CHECK(part(ray<S, N>(1, 0, 0, -4), c) == Part{0, S(0.5)});           // from within, in units of the direction
  CHECK(part(ray<S, N>(-9, 0, 1, 0), c) == Part{4, 14});               // through both ends
  CHECK(part(ray<S, N>(9, 0, -1, 0), c) == Part{4, 14});               // and turned round
  CHECK(part(ray<S, N>(-9, 2, 1, 0), c) == Part{6, 12});               // along the side
  CHECK(part(ray<S, N>(5, -9, 0, 1), c) == Part{9, 9});                // tangent to an end
  CHECK(part(ray<S, N>(3, -9, 0, 1), c) == Part{7, 11});               // where side and end meet
  CHECK(part(ray<S, N>(-8, -4, 1, 1), lying<S, N>(5)) == Part{1, 9});  // in by an end, on 3, 4, 5; out by the side
  CHECK(part(ray<S, N>(1, 5, 0, -1), lying<S, N>(0)) == Part{5, 5});   // a segment
  CHECK(part(ray<S, N>(-9, 0, 1, 0), lying<S, N>(0)) == Part{6, 12});  // along it
  const Capsule<S, N> ball = {at<S, N>(1, 1), at<S, N>(1, 1), S(5)};
  CHECK(part(ray<S, N>(-9, 4, 1, 0), ball) == Part{6, 14});
  CHECK(part(ray<S, N>(-9, 1, 1, 0), Capsule<S, N>{ball.p, ball.q, S(0)}) == Part{10, 10});  // a point
  CHECK(part(ray<S, N>(1, 2, 0, 0, -3, 8), c) == Part{-3, 8});                               // no direction
  CHECK_FALSE(part(ray<S, N>(1, 3, 0, 0, -3, 8), c));
  CHECK_FALSE(part(ray<S, N>(1, 5, 0, -1, 8), c));
  CHECK_FALSE(part(ray<S, N>(1, 5, 0, -1, 0, S(2.5)), c));
  CHECK_FALSE(part(ray<S, N>(1, 5, 0, -1, 6, 5), c));
  CHECK_FALSE(part(ray<S, N>(1, 5, 0, -1, not_a_number), c));
  for (const double bad : {not_a_number, inf, -1.0}) CHECK_FALSE(part(ray<S, N>(1, 5, 0, -1), lying<S, N>(bad)));
}

TEMPLATE_TEST_CASE_SIG("a segment keeps both its ends as it enters a capsule", "[ray_capsule]", FLOATS_AND_DIMENSIONS) {
  // q - p is rounded in S: as a ray it would end a hair before or behind q
  const Segment<S, N> segment = {at<S, N>(1e8, 0), at<S, N>(1 / 3., 0)};
  const Capsule<S, N> touched = {at<S, N>(0, 0), at<S, N>(-1, 0), S(1 / 3.)};
  CHECK(intersect(segment, touched) == Interval<S>{1, 1});
  CHECK(intersects(segment, touched));
  CHECK_FALSE(intersects(segment, Capsule<S, N>{touched.p, touched.q, std::nextafter(S(1 / 3.), S(0))}));
  CHECK_FALSE(first_hit(segment, Capsule<S, N>{touched.p, touched.q, std::nextafter(S(1 / 3.), S(0))}));
  const Segment<S, N> point = {at<S, N>(1, 2), at<S, N>(1, 2)};
  CHECK(intersect(point, lying<S, N>(2)) == Interval<S>{0, 1});
  CHECK_FALSE(intersect(point, lying<S, N>(1)));
  CHECK_FALSE(intersect(Segment<S, N>{at<S, N>(not_a_number, 0), at<S, N>(0, 0)}, lying<S, N>(1)));
}

TEST_CASE("ray and capsule: the events tell by which piece a line enters and leaves", "[ray_capsule]") {
  using namespace ray_capsule;
  const auto told = [](const Ray<double, 3>& line) {
    Record<Event> record;
    intersect(line, {{-3, 0, 0}, {3, 0, 0}, 2}, record);
    std::vector<Piece> pieces;
    for (const Event& event : record.events)
      if (const auto* passage = std::get_if<Passage>(&event)) pieces.push_back(passage->through);
    return pieces;
  };
  using Pieces = std::vector<Piece>;
  CHECK(told({{-9, 0, 0}, {1, 0, 0}}) == Pieces{Piece::p, Piece::q});
  CHECK(told({{9, 1, 1}, {-1, 0, 0}}) == Pieces{Piece::q, Piece::p});
  CHECK(told({{1, 9, 0}, {0, -1, 0}}) == Pieces{Piece::side, Piece::side});
  CHECK(told({{0, 9, 0}, {1, -3, 0}}) == Pieces{Piece::side, Piece::q});
  CHECK(told({{-9, -9, 1}, {1, 1, 0}}) == Pieces{Piece::side, Piece::side});
  CHECK(told({{-9, 3, 0}, {3, -1, 0}}) == Pieces{Piece::p, Piece::q});
  CHECK(told({{-9, -4, 0}, {2, 1, 0}}) == Pieces{Piece::p, Piece::side});
  CHECK(told({{4, -9, 0}, {0, 1, 0}}) == Pieces{Piece::q, Piece::q});
  CHECK(told({{0, 0, 0}, {0, 1, 0}}) == Pieces{Piece::side});  // from within
}

TEMPLATE_TEST_CASE_SIG("ray and capsule: where the line enters and leaves is what rational arithmetic says",
                       "[ray_capsule]", FLOATS_AND_DIMENSIONS) {
  using namespace tests::ray_capsule_pairs;
  std::array<int, 3> entered = {};
  int hits = 0, misses = 0, from_within = 0, touches = 0;
  for (const Numbers numbers : bench::all_numbers_and_ends) {
    Random random(tests::seed() + static_cast<int>(numbers));
    for (int i = 0; i < tests::cases(600, 60000); ++i) {
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      const Case<S, N> c = draw<S, N>(random, numbers, i % 2 == 0);
      if (!finite(c.ray) || !finite(c.capsule) || c.ray.direction.isZero(0) || empty(c.ray.range)) continue;
      const oracle::LineInConvex truth = oracle::line_in_capsule(c.ray, c.capsule);
      const Interval<double> range = cast<double>(c.ray.range);
      const auto part = intersect(c.ray, c.capsule);
      REQUIRE(part.has_value() == (c.capsule.radius >= 0 && truth.meets(range)));
      REQUIRE(first_hit(c.ray, c.capsule) == (part ? std::optional(part->lo) : std::nullopt));
      REQUIRE(intersects(c.ray, c.capsule) == part.has_value());
      Record<ray_capsule::Event> record;
      REQUIRE(intersect(c.ray, c.capsule, record) == part);
      (part ? hits : misses) += 1;
      if (!part) continue;
      REQUIRE((range.lo <= part->lo && part->lo <= part->hi && part->hi <= range.hi));
      for (const bool last : {false, true}) {
        const S end = last ? c.ray.range.hi : c.ray.range.lo, t = last ? part->hi : part->lo;
        const bool within = std::isfinite(end) && truth.holds(Rational(end));
        REQUIRE((within ? t == end : truth.is_within(t, last, 0.6)));
        from_within += within;
      }
      touches += part->lo == part->hi && range.lo < range.hi;
      for (const ray_capsule::Event& event : record.events)
        if (const auto* passage = std::get_if<ray_capsule::Passage>(&event))
          ++entered[static_cast<std::size_t>(passage->through)];
    }
  }
  for (const int often : entered) CHECK(often > 100);
  for (const int often : {hits, misses, from_within}) CHECK(often > 500);
  CHECK(touches > 40);
}

TEMPLATE_TEST_CASE_SIG("segment and capsule: both ends as given, as rational arithmetic says", "[ray_capsule]",
                       FLOATS_AND_DIMENSIONS) {
  using namespace tests::ray_capsule_pairs;
  int hits = 0, misses = 0;
  for (const Numbers numbers : bench::all_numbers_and_ends) {
    Random random(tests::seed() + 50 + static_cast<int>(numbers));
    for (int i = 0; i < tests::cases(300, 30000); ++i) {
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      const Capsule<S, N> capsule = bench::capsule<S, N>(random, numbers);
      const Segment<S, N> segment = {bench::vector<S, N>(random, numbers),
                                     random.one_in(4) ? capsule.q : bench::vector<S, N>(random, numbers)};
      if (segment.p == segment.q) continue;
      const oracle::LineInConvex truth = oracle::line_in_capsule(segment, capsule);
      const auto part = intersect(segment, capsule);
      REQUIRE(part.has_value() == (capsule.radius >= 0 && truth.meets({0, 1})));
      REQUIRE(intersects(segment, capsule) == part.has_value());
      REQUIRE(intersects(Capsule<S, N>{segment.p, segment.q, S(0)}, capsule) == part.has_value());
      REQUIRE(first_hit(segment, capsule) == (part ? std::optional(part->lo) : std::nullopt));
      (part ? hits : misses) += 1;
      if (!part) continue;
      REQUIRE((truth.holds(0) ? part->lo == 0 : truth.is_within(part->lo, false, 0.6)));
      REQUIRE((truth.holds(1) ? part->hi == 1 : truth.is_within(part->hi, true, 0.6)));
    }
  }
  for (const int often : {hits, misses}) CHECK(often > 300);
}

}  // namespace ray_capsule_test
