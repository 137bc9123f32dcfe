#include <isect/sphere_capsule.h>

#include "bench/sphere_capsule/families.h"
#include "bench/sphere_capsule/oracle.h"
#include "tests/catch.h"
#include "tests/core/common.h"
#include "tests/core/motion.h"
#include "tests/settings.h"

namespace sphere_capsule_test {
using namespace isect;
using tests::at, tests::inf, tests::not_a_number;

namespace {

template <class S, int N>
Sphere<S, N> ball(double x, double y, double radius) {
  return {at<S, N>(x, y), S(radius)};
}
/// A capsule from (-k, 0) to (k, 0).
template <class S, int N>
Capsule<S, N> lying(double k, double radius) {
  return {at<S, N>(-k, 0), at<S, N>(k, 0), S(radius)};
}

/// The relation, checked with the ends of the capsule swapped, too.
template <class S, int N>
Relation related(const Sphere<S, N>& a, const Capsule<S, N>& b) {
  const Relation r = relate(a, b);
  CHECK(intersects(a, b) == (r != Relation::disjoint));
  CHECK(relate(a, Capsule<S, N>{b.q, b.p, b.radius}) == r);
  return r;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("a ball and a capsule lie in one of six ways", "[sphere_capsule]", FLOATS_AND_DIMENSIONS) {
  const Capsule<S, N> capsule = lying<S, N>(3, 2);
  CHECK(related(ball<S, N>(1, 4, 1), capsule) == Relation::disjoint);
  CHECK(related(ball<S, N>(1, 4, 2), capsule) == Relation::touching);  // a side
  CHECK(related(ball<S, N>(6, 4, 3), capsule) == Relation::touching);  // an end
  CHECK(related(ball<S, N>(1, 4, 3), capsule) == Relation::overlapping);
  CHECK(related(ball<S, N>(1, 1, 1), capsule) == Relation::a_inside_b);
  CHECK(related(ball<S, N>(3, 0, 2), capsule) == Relation::a_inside_b);  // the end itself
  CHECK(related(ball<S, N>(1, 0, 6), capsule) == Relation::b_inside_a);
  CHECK(related(ball<S, N>(0, 0, 2), lying<S, N>(0, 2)) == Relation::equal);
}

TEMPLATE_TEST_CASE_SIG("sphere and capsule: an ulp decides at the side, at an end, and within", "[sphere_capsule]",
                       FLOATS_AND_DIMENSIONS) {
  const auto less = [](double x) { return std::nextafter(S(x), S(0)); };
  const auto more = [](double x) { return std::nextafter(S(x), S(100)); };
  const Capsule<S, N> capsule = lying<S, N>(3, 2);
  CHECK(related(ball<S, N>(1, 4, less(2)), capsule) == Relation::disjoint);
  CHECK(related(ball<S, N>(1, 4, more(2)), capsule) == Relation::overlapping);
  CHECK(related(ball<S, N>(6, 4, less(3)), capsule) == Relation::disjoint);
  CHECK(related(ball<S, N>(6, 4, more(3)), capsule) == Relation::overlapping);
  CHECK(related(ball<S, N>(1, 1, more(1)), capsule) == Relation::overlapping);
  CHECK(related(ball<S, N>(1, 0, less(6)), capsule) == Relation::overlapping);
  CHECK(related(ball<S, N>(more(1), 0, 6), capsule) == Relation::overlapping);
}

TEMPLATE_TEST_CASE_SIG("a slanted side is touched on integers", "[sphere_capsule]", FLOATS_AND_DIMENSIONS) {
  const Capsule<S, N> slanted = {at<S, N>(-8, -6), at<S, N>(12, 9), S(3)};  // along (4, 3)
  CHECK(related(ball<S, N>(-3, 4, 2), slanted) == Relation::touching);      // 5 (-3, 4) / 5 beside 0
  CHECK(related(ball<S, N>(-3, 4, std::nextafter(S(2), S(0))), slanted) == Relation::disjoint);
}

TEMPLATE_TEST_CASE_SIG("sphere and capsule: a point and a segment are sets like others", "[sphere_capsule]",
                       FLOATS_AND_DIMENSIONS) {
  const Capsule<S, N> segment = lying<S, N>(3, 0);
  CHECK(related(ball<S, N>(1, 0, 1), segment) == Relation::overlapping);  // pierced
  CHECK(related(ball<S, N>(1, 2, 2), segment) == Relation::touching);
  CHECK(related(ball<S, N>(0, 4, 5), segment) == Relation::b_inside_a);
  CHECK(related(ball<S, N>(1, 0, 0), segment) == Relation::a_inside_b);
  CHECK(related(ball<S, N>(3, 0, -0.0), segment) == Relation::a_inside_b);
  CHECK(related(ball<S, N>(std::nextafter(S(3), S(4)), 0, 0), segment) == Relation::disjoint);
  CHECK(related(ball<S, N>(4, 3, 0), lying<S, N>(0, 5)) == Relation::a_inside_b);
  CHECK(related(ball<S, N>(0, 0, 0), lying<S, N>(0, -0.0)) == Relation::equal);
}

TEMPLATE_TEST_CASE_SIG("sphere and capsule: what is empty, NaN or infinite meets nothing", "[sphere_capsule]",
                       FLOATS_AND_DIMENSIONS) {
  const Capsule<S, N> capsule = lying<S, N>(3, 2);
  const Sphere<S, N> good = ball<S, N>(0, 0, 9);
  CHECK(related(ball<S, N>(0, 0, -1), capsule) == Relation::disjoint);
  CHECK(related(good, lying<S, N>(3, -1)) == Relation::disjoint);
  CHECK(related(ball<S, N>(0, 0, -1), lying<S, N>(0, -1)) == Relation::disjoint);
  for (const double bad : {not_a_number, inf, -inf}) {
    CHECK(related(ball<S, N>(0, 0, bad), capsule) == Relation::disjoint);
    CHECK(related(good, lying<S, N>(3, bad)) == Relation::disjoint);
    for (int i = 0; i < N; ++i) {
      Sphere<S, N> sphere = good;
      Capsule<S, N> p = capsule, both = capsule;
      sphere.center[i] = p.p[i] = both.p[i] = both.q[i] = S(bad);
      CHECK(related(sphere, capsule) == Relation::disjoint);
      CHECK(related(good, p) == Relation::disjoint);
      CHECK(related(good, both) == Relation::disjoint);
      CHECK(related(sphere, both) == Relation::disjoint);
    }
  }
}

TEMPLATE_TEST_CASE_SIG("sphere and capsule: lengths of any size give the same verdict", "[sphere_capsule]",
                       FLOATS_AND_DIMENSIONS) {
  constexpr int most = std::numeric_limits<S>::max_exponent - 4;
  for (const int e : {-most, -most / 2, most / 2, most}) {
    const double k = std::ldexp(1.0, e);
    const Capsule<S, N> capsule = lying<S, N>(3 * k, 2 * k);
    CHECK(related(ball<S, N>(k, 4 * k, k), capsule) == Relation::disjoint);
    CHECK(related(ball<S, N>(k, 4 * k, 2 * k), capsule) == Relation::touching);
    CHECK(related(ball<S, N>(6 * k, 4 * k, 3 * k), capsule) == Relation::touching);
    CHECK(related(ball<S, N>(k, 4 * k, 3 * k), capsule) == Relation::overlapping);
    CHECK(related(ball<S, N>(k, k, k), capsule) == Relation::a_inside_b);
    CHECK(related(ball<S, N>(k, 0, 6 * k), capsule) == Relation::b_inside_a);
  }
  const S top = std::numeric_limits<S>::max(), least = std::numeric_limits<S>::denorm_min();
  CHECK(related(ball<S, N>(0, top, top), lying<S, N>(top, 0)) == Relation::touching);
  CHECK(related(ball<S, N>(0, top, top / 2), lying<S, N>(top, top / 2)) == Relation::touching);
  CHECK(related(ball<S, N>(0, top, 0), lying<S, N>(top, std::nextafter(top, S(0)))) == Relation::disjoint);
  CHECK(related(ball<S, N>(0, least, least), lying<S, N>(least, 0)) == Relation::touching);
  CHECK(related(ball<S, N>(0, least, 0), lying<S, N>(top, least)) == Relation::a_inside_b);
  CHECK(related(ball<S, N>(0, 2 * least, 0), lying<S, N>(top, least)) == Relation::disjoint);
}

TEST_CASE("sphere and capsule: the events tell the nearest point, the signs and each fallback", "[sphere_capsule]") {
  using namespace sphere_capsule;
  Record<Event> record;
  const Capsule<double, 2> capsule = {{-3, 0}, {3, 0}, 2};
  intersects(Sphere<double, 2>{{1, 4.5}, 1}, capsule, record);
  REQUIRE(record.events.size() == 1);
  CHECK(std::get<Reach>(record.events[0]).nearest == Nearest::between);
  CHECK(std::get<Reach>(record.events[0]).sign == 1);

  record.events.clear();
  relate(Sphere<double, 2>{{6, 4}, 3}, capsule, record);
  CHECK(std::holds_alternative<Fallback>(record.events.front()));  // touching
  CHECK(std::get<Reach>(record.events.at(record.events.size() - 2)).nearest == Nearest::q);
  CHECK(std::get<Reach>(record.events.at(record.events.size() - 2)).sign == 0);
  CHECK_FALSE(std::get<Contained>(record.events.back()).ball);

  record.events.clear();
  relate(Sphere<double, 2>{{-4, 0}, 9}, capsule, record);
  CHECK(std::get<Reach>(record.events.front()).nearest == Nearest::p);
  CHECK(std::get<Contained>(record.events.back()).capsule);
}

TEMPLATE_TEST_CASE_SIG("sphere and capsule: relations are those of rational arithmetic", "[sphere_capsule]",
                       FLOATS_AND_DIMENSIONS) {
  bench::Random random(tests::seed());
  int seen[6] = {};
  for (const bench::Numbers numbers : bench::all_numbers)
    for (int i = 0; i < tests::cases(1500, 125000); ++i) {
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      Sphere<S, N> sphere = bench::ball<S, N>(random, numbers);
      Capsule<S, N> capsule = bench::capsule<S, N>(random, numbers);
      if (random.one_in(4)) sphere.center = capsule.p / 2 + capsule.q / 2;
      if (random.one_in(10)) sphere.center = random.one_in(2) ? capsule.p : capsule.q;
      if (random.one_in(2)) sphere.radius = bench::critical_radius(random, sphere.center, capsule);
      if (random.one_in(30)) capsule = {sphere.center, sphere.center, sphere.radius};
      if (random.one_in(20)) {  // beside each other, up to rounding
        capsule.q = sphere.center = capsule.p;
        capsule.q[0] += capsule.radius, sphere.center[1] += sphere.radius + capsule.radius;
      }
      if (!finite(sphere) || !finite(capsule)) continue;

      const Relation r = relate(sphere, capsule);
      if (r != oracle::relation(sphere, capsule)) FAIL("wrong");
      if (intersects(sphere, capsule) != (r != Relation::disjoint)) FAIL("not the same by intersects");
      Record<sphere_capsule::Event> record;
      if (relate(sphere, capsule, record) != r) FAIL("not the same when traced");
      if (numbers <= bench::Numbers::distant) {
        const tests::Motion<N> move = tests::motion<N>(random);
        if (relate(move(sphere), move(capsule)) != r) FAIL("not the same when moved");
      }
      ++seen[static_cast<int>(r)];
    }
  for (const int count : seen) CHECK(count > 50);
}

}  // namespace sphere_capsule_test
