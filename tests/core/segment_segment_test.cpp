#include <isect/segment_segment.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/catch.h"
#include "tests/core/common.h"
#include "tests/core/segment_pairs.h"
#include "tests/settings.h"

namespace segment_segment_test {
using namespace isect;
using bench::Numbers;
using bench::Random;
using oracle::Rational;
using segment_segment::Meeting;
using namespace tests::segment_pairs;
using tests::inf, tests::not_a_number;

namespace {

template <class S>
Segment<S, 2> line(double px, double py, double qx, double qy) {
  const Segment<double, 2> s = {{px, py}, {qx, qy}};
  return cast<S>(s);
}
template <class S>
Segment<S, 2> flipped(const Segment<S, 2>& a) {
  return {a.q, a.p};
}

template <class S>
bool identical(const SegmentSegment<S>& a, const SegmentSegment<S>& b) {
  if (a.shared && b.shared && (a.shared->p != b.shared->p || a.shared->q != b.shared->q)) return false;
  return a.relation == b.relation && a.point == b.point && a.shared.has_value() == b.shared.has_value();
}

template <class S>
bool is_end(const Pair<S>& c, const Point<S, 2>& x) {
  return x == c.a.p || x == c.a.q || x == c.b.p || x == c.b.q;
}

}  // namespace

TEMPLATE_TEST_CASE("two segments cross", "[segment_segment]", float, double) {
  using S = TestType;
  const auto r = intersect(line<S>(-1, -1, 3, 3), line<S>(-2, 2, 2, -2));
  CHECK(r);
  CHECK(r.relation == Meeting::cross);
  CHECK(r.point == Point<S, 2>(0, 0));
  CHECK_FALSE(r.shared);
  CHECK(intersect(line<S>(0, 0, 4, 2), line<S>(0, 2, 4, 0)).point == Point<S, 2>(2, 1));
}

TEMPLATE_TEST_CASE("segments beside each other are disjoint", "[segment_segment]", float, double) {
  using S = TestType;
  for (const auto& b : {line<S>(0, 1, 4, 1), line<S>(5, -1, 5, 1), line<S>(1, 1, 2, 9), line<S>(5, 0, 7, 0),
                        line<S>(4.001, 0, 4.002, 1)}) {
    const auto r = intersect(line<S>(0, 0, 4, 0), b);
    CHECK((!r && r.relation == Meeting::disjoint && !r.point && !r.shared));
    CHECK_FALSE(intersects(line<S>(0, 0, 4, 0), b));
  }
  CHECK_FALSE(intersects(line<S>(0, 0, 4, 4), line<S>(1, 0, 4, 3.99)));  // the boxes overlap
}

TEMPLATE_TEST_CASE("an end on the other segment touches, and is given exactly", "[segment_segment]", float, double) {
  using S = TestType;
  const auto middle = intersect(line<S>(0, 0, 4, 0), line<S>(1, 0, 2, 5));
  CHECK(middle.relation == Meeting::touch);
  CHECK(middle.point == Point<S, 2>(1, 0));
  const auto corner = intersect(line<S>(0, 0, 4, 0), line<S>(4, 0, 4, 5));
  CHECK(corner.relation == Meeting::touch);
  CHECK(corner.point == Point<S, 2>(4, 0));
  const auto straight_on = intersect(line<S>(0, 0, 4, 0), line<S>(9, 0, 4, -0.));
  CHECK(straight_on.relation == Meeting::touch);
  CHECK(straight_on.point == Point<S, 2>(4, 0));
}

TEMPLATE_TEST_CASE("segments of one line share a stretch", "[segment_segment]", float, double) {
  using S = TestType;
  for (const auto& b : {line<S>(1, 2, 9, 18), line<S>(9, 18, 1, 2)}) {
    const auto r = intersect(line<S>(0, 0, 3, 6), b);
    CHECK(r.relation == Meeting::overlap);
    CHECK_FALSE(r.point);
    REQUIRE(r.shared);
    CHECK(r.shared->p == Point<S, 2>(1, 2));
    CHECK(r.shared->q == Point<S, 2>(3, 6));
  }
  const auto upright = intersect(line<S>(1, 5, 1, 0), line<S>(1, 3, 1, 2));
  REQUIRE(upright.shared);
  CHECK(upright.shared->p == Point<S, 2>(1, 2));
  CHECK(upright.shared->q == Point<S, 2>(1, 3));
  CHECK(intersect(line<S>(1, 5, 1, 0), line<S>(1, 5, 1, 0)).relation == Meeting::overlap);
}

TEMPLATE_TEST_CASE("a segment may be a point", "[segment_segment]", float, double) {
  using S = TestType;
  const auto point = line<S>(1, 1, 1, 1);
  CHECK(intersect(point, line<S>(0, 0, 3, 3)).relation == Meeting::touch);
  CHECK(intersect(line<S>(0, 0, 1, 1), point).point == Point<S, 2>(1, 1));
  CHECK(intersect(point, point).relation == Meeting::touch);
  CHECK_FALSE(intersect(point, line<S>(2, 2, 3, 3)));
  CHECK_FALSE(intersect(point, line<S>(0, 0, 3, 2)));
  CHECK_FALSE(intersect(point, line<S>(2, 1, 2, 1)));
}

TEMPLATE_TEST_CASE("two segments: NaN and infinities meet nothing", "[segment_segment]", float, double) {
  using S = TestType;
  for (const double bad : {not_a_number, inf, -inf}) {
    CHECK_FALSE(intersect(line<S>(bad, 0, 1, 1), line<S>(0, 1, 1, 0)));
    CHECK_FALSE(intersect(line<S>(0, 0, 1, 1), line<S>(0, 1, 1, bad)));
    CHECK_FALSE(intersects(line<S>(0, bad, 1, 1), line<S>(0, 1, 1, 0)));
  }
}

TEST_CASE("segments of any size cross where they cross", "[segment_segment]") {
  for (const double k : {1e-300, 1e-160, 1., 1e160, 1e300}) {
    const auto r = intersect<double>({{-k, -k}, {3 * k, 3 * k}}, {{0, 2 * k}, {2 * k, 0}});
    CHECK(r.relation == Meeting::cross);
    CHECK((*r.point)[0] == Approx(k).epsilon(1e-15));
    CHECK(intersect<double>({{-k, -k}, {3 * k, 3 * k}}, {{k, k}, {2 * k, 0}}).relation == Meeting::touch);
    CHECK_FALSE(intersects<double>({{-k, -k}, {3 * k, 3 * k}}, {{k, k * (1 - 1e-15)}, {2 * k, 0}}));
  }
}

TEMPLATE_TEST_CASE("two segments: every answer is that of rational arithmetic", "[segment_segment][random]", float,
                   double) {
  using S = TestType;
  int seen[4] = {};
  double worst = 0;
  const int count = tests::cases(2000, 320000);
  for (const Numbers numbers : bench::all_numbers) {
    Random random(tests::seed() + static_cast<int>(numbers));
    for (int i = 0; i < count; ++i) {
      const Pair<S> c = draw<S>(random, numbers);
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      const SegmentSegment<S> r = intersect(c.a, c.b);
      const Truth expected = truth(c);
      REQUIRE(r.relation == expected.relation);
      REQUIRE(intersects(c.a, c.b) == (expected.relation != Meeting::disjoint));
      REQUIRE(r.point.has_value() == (r.relation == Meeting::touch || r.relation == Meeting::cross));
      REQUIRE(r.shared.has_value() == (r.relation == Meeting::overlap));
      ++seen[static_cast<int>(r.relation)];
      if (r.relation == Meeting::touch) {
        REQUIRE(is_end(c, *r.point));
        REQUIRE(oracle::rational<S, 2>(*r.point) == expected.points[0]);
      } else if (r.relation == Meeting::cross) {
        for (int k = 0; k < 2; ++k) worst = std::max(worst, oracle::ulps((*r.point)[k], expected.points[0][k]));
      } else if (r.relation == Meeting::overlap) {
        const P p = oracle::rational<S, 2>(r.shared->p), q = oracle::rational<S, 2>(r.shared->q);
        const std::vector<P>& ends = expected.points;
        REQUIRE(((p == ends[0] && q == ends[1]) || (p == ends[1] && q == ends[0])));
      }
    }
  }
  CHECK(worst <= 2);
  for (const int often : seen) CHECK(often > count / 8);
}

TEMPLATE_TEST_CASE("order, orientation, axes, scale and a listener change no answer", "[segment_segment][property]",
                   float, double) {
  using S = TestType;
  for (const Numbers numbers : bench::all_numbers) {
    Random random(tests::seed() + 100 + static_cast<int>(numbers));
    for (int i = 0; i < 400; ++i) {
      const Pair<S> c = draw<S>(random, numbers);
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      const SegmentSegment<S> r = intersect(c.a, c.b);
      Record<segment_segment::Event> record;
      REQUIRE(identical(intersect(c.a, c.b, record), r));

      REQUIRE(intersect(c.b, c.a).relation == r.relation);
      REQUIRE(intersect(flipped(c.a), c.b).relation == r.relation);
      REQUIRE(intersect(c.a, flipped(c.b)).relation == r.relation);
      if (r.relation != Meeting::cross) REQUIRE(identical(intersect(c.b, flipped(c.a)), r));

      const auto turned = [](const Segment<S, 2>& s) {
        return Segment<S, 2>{Point<S, 2>(-s.p[1], s.p[0]), Point<S, 2>(-s.q[1], s.q[0])};
      };
      REQUIRE(intersect(turned(c.a), turned(c.b)).relation == r.relation);

      if (numbers != Numbers::grid && numbers != Numbers::distant) continue;
      const S k = std::ldexp(S(1), random.integer(-30, 30));
      const Vector<S, 2> by(static_cast<S>(random.integer(-99, 99)), static_cast<S>(random.integer(-99, 99)));
      const auto scaled = [&](const Segment<S, 2>& s) { return Segment<S, 2>{s.p * k, s.q * k}; };
      const auto shifted = [&](const Segment<S, 2>& s) { return Segment<S, 2>{s.p + by, s.q + by}; };
      const auto exact = [&](const Segment<S, 2>& s) {
        const Segment<S, 2> m = shifted(s), n = scaled(s);
        return m.p - by == s.p && m.q - by == s.q && n.p / k == s.p && n.q / k == s.q && numbers == Numbers::grid;
      };
      if (!exact(c.a) || !exact(c.b)) continue;
      REQUIRE(intersect(scaled(c.a), scaled(c.b)).relation == r.relation);
      if (c.b.p == c.b.p.array().round().matrix() && c.b.q == c.b.q.array().round().matrix() &&
          c.a.p == c.a.p.array().round().matrix() && c.a.q == c.a.q.array().round().matrix())
        REQUIRE(intersect(shifted(c.a), shifted(c.b)).relation == r.relation);
    }
  }
}

TEST_CASE("the sides that were not asked are not told", "[segment_segment]") {
  Record<segment_segment::Event> record;
  intersect(Segment<double, 2>{{0, 0}, {4, 1}}, {{1, 1}, {2, 3}}, record);  // both left of a
  const auto apart = std::get<segment_segment::Sides>(record.events.back());
  CHECK((apart.r == 1 && apart.s == 1 && !apart.p && !apart.q));
  record.events.clear();
  intersects(Segment<double, 2>{{0, 0}, {4, 1}}, {{1, 1}, {2, -3}}, record);
  const auto crossed = std::get<segment_segment::Sides>(record.events.back());
  CHECK((crossed.r == 1 && crossed.s == -1 && crossed.p == -1 && crossed.q == 1));
}

}  // namespace segment_segment_test
