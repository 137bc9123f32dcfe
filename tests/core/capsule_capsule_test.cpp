#include <isect/capsule_capsule.h>

#include <utility>

#include <isect/parts/unit_of_length.h>
#include <isect/sphere_capsule.h>
#include "bench/capsule_capsule/families.h"
#include "bench/capsule_capsule/oracle.h"
#include "tests/catch.h"
#include "tests/core/common.h"
#include "tests/core/motion.h"
#include "tests/settings.h"

namespace capsule_capsule_test {
using namespace isect;
using tests::inf, tests::not_a_number;

namespace {

template <class S, int N>
Capsule<S, N> capsule(double px, double py, double qx, double qy, double radius) {
  Capsule<S, N> c = {Point<S, N>::Zero(), Point<S, N>::Zero(), S(radius)};
  c.p[0] = S(px), c.p[1] = S(py);
  c.q[0] = S(qx), c.q[1] = S(qy);
  return c;
}
/// A capsule from (-k, 0) to (k, 0).
template <class S, int N>
Capsule<S, N> lying(double k, double radius) {
  return capsule<S, N>(-k, 0, k, 0, radius);
}
template <class S, int N>
Capsule<S, N> turned(const Capsule<S, N>& c) {
  return {c.q, c.p, c.radius};
}

/// The relation, checked in both orders, and with the ends swapped.
template <class S, int N>
Relation related(const Capsule<S, N>& a, const Capsule<S, N>& b) {
  const Relation r = relate(a, b);
  CHECK(relate(b, a) == reversed(r));
  CHECK(relate(turned(a), b) == r);
  CHECK(relate(a, turned(b)) == r);
  CHECK(intersects(a, b) == (r != Relation::disjoint));
  CHECK(intersects(b, a) == (r != Relation::disjoint));
  return r;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("two capsules lie in one of six ways", "[capsule_capsule]", FLOATS_AND_DIMENSIONS) {
  const Capsule<S, N> a = lying<S, N>(3, 2);
  CHECK(related(a, capsule<S, N>(1, 4, 5, 7, 1)) == Relation::disjoint);
  CHECK(related(a, capsule<S, N>(1, 4, 5, 7, 2)) == Relation::touching);  // an end at the side
  CHECK(related(a, capsule<S, N>(6, 4, 9, 9, 3)) == Relation::touching);  // two ends
  CHECK(related(a, capsule<S, N>(1, 4, 5, 7, 3)) == Relation::overlapping);
  CHECK(related(a, capsule<S, N>(0, -9, 1, 9, 1)) == Relation::overlapping);  // a cross
  CHECK(related(capsule<S, N>(-3, 1, 3, -1, 1), a) == Relation::a_inside_b);
  CHECK(related(a, capsule<S, N>(1, 1, 2, -1, 1)) == Relation::b_inside_a);
  CHECK(related(a, lying<S, N>(-3, 2)) == Relation::equal);
}

TEMPLATE_TEST_CASE_SIG("two capsules: an ulp decides at the side, at the ends, and within", "[capsule_capsule]",
                       FLOATS_AND_DIMENSIONS) {
  const auto less = [](double x) { return std::nextafter(S(x), S(0)); };
  const auto more = [](double x) { return std::nextafter(S(x), S(100)); };
  const Capsule<S, N> a = lying<S, N>(3, 2);
  CHECK(related(a, capsule<S, N>(1, 4, 5, 7, less(2))) == Relation::disjoint);
  CHECK(related(a, capsule<S, N>(1, 4, 5, 7, more(2))) == Relation::overlapping);
  CHECK(related(a, capsule<S, N>(6, 4, 9, 9, less(3))) == Relation::disjoint);
  CHECK(related(a, capsule<S, N>(6, 4, 9, 9, more(3))) == Relation::overlapping);
  CHECK(related(a, capsule<S, N>(-3, 1, 3, -1, more(1))) == Relation::overlapping);
  CHECK(related(a, lying<S, N>(3, less(2))) == Relation::b_inside_a);
  CHECK(related(a, lying<S, N>(less(3), 2)) == Relation::b_inside_a);
}

TEMPLATE_TEST_CASE_SIG("parallel capsules touch along their sides, or at their ends", "[capsule_capsule]",
                       FLOATS_AND_DIMENSIONS) {
  const Capsule<S, N> a = lying<S, N>(3, 2), slanted = capsule<S, N>(0, 0, 40, 30, 3);
  CHECK(related(a, capsule<S, N>(-1, 4, 9, 4, 2)) == Relation::touching);
  CHECK(related(a, capsule<S, N>(-1, 4, 9, 4, 1)) == Relation::disjoint);
  CHECK(related(a, capsule<S, N>(6, 4, 9, 4, 3)) == Relation::touching);
  CHECK(related(a, capsule<S, N>(8, 0, 9, 0, 3)) == Relation::touching);  // one behind the other
  CHECK(related(a, capsule<S, N>(7, 0, 9, 0, 3)) == Relation::overlapping);
  CHECK(related(slanted, capsule<S, N>(1, 7, 29, 28, 2)) == Relation::touching);  // (-3, 4) beside it
  CHECK(related(slanted, capsule<S, N>(1, 7, 29, 28, std::nextafter(S(2), S(0)))) == Relation::disjoint);
}

TEMPLATE_TEST_CASE("capsules that pass each other in space touch between the ends", "[capsule_capsule]", float,
                   double) {
  using S = TestType;
  const Capsule<S, 3> a = {{-4, 0, 0}, {4, 0, 0}, 2};
  const auto above = [](S x, S y, S radius) -> Capsule<S, 3> { return {{x, y, 5}, {-x, -y, 5}, radius}; };
  for (const auto& [x, y] : {std::pair<S, S>{0, 3}, {2, 3}, {S(0.1), S(0.7)}}) {
    CHECK(related(a, above(x, y, 3)) == Relation::touching);
    CHECK(related(a, above(x, y, std::nextafter(S(3), S(0)))) == Relation::disjoint);
    CHECK(related(a, above(x, y, std::nextafter(S(3), S(9)))) == Relation::overlapping);
  }
  CHECK(related(a, {{0, 1, 5}, {0, 3, 5}, 3}) == Relation::disjoint);  // past the line, but not past the segment
}

TEMPLATE_TEST_CASE_SIG("segments overlap where they cross or share a stretch, and touch at an end", "[capsule_capsule]",
                       FLOATS_AND_DIMENSIONS) {
  const Capsule<S, N> a = lying<S, N>(3, 0), wide = lying<S, N>(3, 2);
  CHECK(related(a, capsule<S, N>(0, -1, 1, 1, 0)) == Relation::overlapping);
  CHECK(related(a, capsule<S, N>(0, 0, 1, 1, 0)) == Relation::touching);
  CHECK(related(a, capsule<S, N>(3, 0, 4, 1, 0)) == Relation::touching);
  CHECK(related(a, capsule<S, N>(3, -1, 3, 1, 0)) == Relation::touching);
  CHECK(related(a, capsule<S, N>(3, 0, 4, 0, 0)) == Relation::touching);
  CHECK(related(a, capsule<S, N>(1, 0, 4, 0, 0)) == Relation::overlapping);
  CHECK(related(a, capsule<S, N>(1, 0, 2, 0, 0)) == Relation::b_inside_a);
  CHECK(related(a, capsule<S, N>(4, 0, 5, 0, 0)) == Relation::disjoint);
  CHECK(related(a, lying<S, N>(-3, -0.0)) == Relation::equal);
  CHECK(related(wide, a) == Relation::b_inside_a);
  CHECK(related(wide, capsule<S, N>(0, 0, 9, 0, 0)) == Relation::overlapping);  // pierced
  CHECK(related(capsule<S, N>(1, 1, 1, 1, 0), capsule<S, N>(1, 1, 1, 1, 0)) == Relation::equal);
  CHECK(related(capsule<S, N>(1, 0, 1, 0, 0), a) == Relation::a_inside_b);
}

TEMPLATE_TEST_CASE_SIG("two capsules: what is empty, NaN or infinite meets nothing", "[capsule_capsule]",
                       FLOATS_AND_DIMENSIONS) {
  const Capsule<S, N> good = lying<S, N>(3, 2);
  CHECK(related(good, lying<S, N>(3, -1)) == Relation::disjoint);
  CHECK(related(lying<S, N>(3, -1), lying<S, N>(3, -1)) == Relation::disjoint);
  for (const double bad : {not_a_number, inf, -inf}) {
    CHECK(related(good, lying<S, N>(3, bad)) == Relation::disjoint);
    CHECK(related(lying<S, N>(3, bad), lying<S, N>(3, bad)) == Relation::disjoint);
    for (int i = 0; i < N; ++i) {
      Capsule<S, N> one = good, both = good;
      one.p[i] = both.p[i] = both.q[i] = S(bad);
      for (const Capsule<S, N>& wrong : {one, both}) {
        CHECK(related(good, wrong) == Relation::disjoint);
        CHECK(related(wrong, wrong) == Relation::disjoint);
      }
    }
  }
}

TEMPLATE_TEST_CASE_SIG("two capsules: lengths of any size give the same verdict", "[capsule_capsule]",
                       FLOATS_AND_DIMENSIONS) {
  constexpr int most = std::numeric_limits<S>::max_exponent - 4;
  for (const int e : {-most, -most / 2, most / 2, most}) {
    const double k = std::ldexp(1.0, e);
    const Capsule<S, N> a = lying<S, N>(3 * k, 2 * k);
    CHECK(related(a, capsule<S, N>(k, 4 * k, 5 * k, 7 * k, k)) == Relation::disjoint);
    CHECK(related(a, capsule<S, N>(k, 4 * k, 5 * k, 7 * k, 2 * k)) == Relation::touching);
    CHECK(related(a, capsule<S, N>(-k, 4 * k, 7 * k, 4 * k, 2 * k)) == Relation::touching);
    CHECK(related(a, capsule<S, N>(k, 4 * k, 5 * k, 7 * k, 3 * k)) == Relation::overlapping);
    CHECK(related(a, capsule<S, N>(0, -4 * k, k, 4 * k, k)) == Relation::overlapping);
    CHECK(related(a, capsule<S, N>(-3 * k, k, 3 * k, -k, k)) == Relation::b_inside_a);
  }
  const S top = std::numeric_limits<S>::max(), least = std::numeric_limits<S>::denorm_min();
  CHECK(related(lying<S, N>(top, 0), capsule<S, N>(0, -top, 0, top, 0)) == Relation::overlapping);
  CHECK(related(lying<S, N>(top, top), capsule<S, N>(-top, top, top, top, 0)) == Relation::b_inside_a);
  CHECK(related(lying<S, N>(top, top / 2), capsule<S, N>(-top, top, top, top, top / 2)) == Relation::touching);
  CHECK(related(lying<S, N>(top, 0), capsule<S, N>(-top, least, top, least, 0)) == Relation::disjoint);
  CHECK(related(lying<S, N>(top, 0), capsule<S, N>(-top, least, top, least, least)) == Relation::a_inside_b);
}

TEST_CASE("nearly parallel capsules are told apart where both segments are long", "[capsule_capsule]") {
  const Capsule<double, 3> a = {{-1e8, 0, 0}, {1e8, 0, 0}, 1};
  const auto over = [](double tilt, double radius) -> Capsule<double, 3> {
    return {{-1e8, 0, 3 - tilt}, {1e8, 0, 3 + tilt}, radius};
  };
  CHECK(related(a, over(0, 2)) == Relation::touching);
  CHECK(related(a, over(1e-8, 2)) == Relation::overlapping);  // the lower end
  CHECK(related(a, over(1e-8, std::nextafter(2., 0.))) == Relation::overlapping);
  CHECK(related(a, over(0, std::nextafter(2., 0.))) == Relation::disjoint);
  CHECK(related(a, {{-1e8, -1e-8, 3}, {1e8, 1e-8, 3}, 2}) == Relation::touching);  // crossing above, at a grain's angle
  CHECK(related(a, {{-1e8, -1e-8, 3}, {1e8, 1e-8, 3}, std::nextafter(2., 0.)}) == Relation::disjoint);
}

TEST_CASE("two capsules: the events tell what was nearest, and where it was settled", "[capsule_capsule]") {
  using namespace capsule_capsule;
  Record<Event> record;
  const Capsule<double, 3> a = {{-3, 0, 0}, {3, 0, 0}, 2};
  intersects(a, {{0, -3, 4}, {1, 3, 4}, 1}, record);
  REQUIRE(record.events.size() == 1);
  CHECK((std::get<Between>(record.events[0]).holds && std::get<Between>(record.events[0]).sign == 1));

  record.events.clear();
  relate(a, {{5, 4, 0}, {9, 9, 0.5}, 1}, record);
  REQUIRE(record.events.size() == 5);
  CHECK_FALSE(std::get<Between>(record.events[0]).holds);
  for (int i = 0; i < 4; ++i) CHECK(std::get<End>(record.events[i + 1]).end == i);
  CHECK(std::get<End>(record.events[2]).nearest == Nearest::p);  // q of a and p of b: each is the other's nearest
  CHECK(std::get<End>(record.events[3]).nearest == Nearest::q);

  record.events.clear();
  relate(a, {{-3, 1, 0}, {3, -1, 0}, 1}, record);
  CHECK(std::holds_alternative<Contained>(record.events.back()));
  CHECK((!std::get<Contained>(record.events.back()).a && std::get<Contained>(record.events.back()).b));
}

TEMPLATE_TEST_CASE_SIG("a capsule with both ends at one point is the ball", "[capsule_capsule]",
                       FLOATS_AND_DIMENSIONS) {
  bench::Random random(tests::seed());
  for (const bench::Numbers numbers : bench::all_numbers)
    for (int i = 0; i < tests::cases(300, 20000); ++i) {
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      const Capsule<S, N> b = bench::capsule<S, N>(random, numbers);
      Sphere<S, N> ball = bench::ball<S, N>(random, numbers);
      if (random.one_in(2)) ball.radius = bench::critical_radius(random, ball.center, b);
      const Capsule<S, N> a = {ball.center, ball.center, ball.radius};
      if (relate(a, b) != relate(ball, b)) FAIL("not the same");
    }
}

TEMPLATE_TEST_CASE_SIG("two capsules: relations are those of rational arithmetic", "[capsule_capsule]",
                       FLOATS_AND_DIMENSIONS) {
  bench::Random random(tests::seed());
  int seen[6] = {};
  for (const bench::Numbers numbers : bench::all_numbers)
    for (int i = 0; i < tests::cases(1500, 125000); ++i) {
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      Capsule<S, N> a = bench::capsule<S, N>(random, numbers), b = bench::capsule<S, N>(random, numbers);
      if (random.one_in(4)) {  // parallel, or nearly
        const Vector<S, N> aside = bench::vector<S, N>(random, numbers);
        a = {b.p + aside, b.q + aside, a.radius};
      }
      if (random.one_in(10)) a = {b.q, random.one_in(2) ? b.p : a.q, b.radius};
      if (random.one_in(2)) a.radius = bench::critical_radius(random, a, b);
      if (random.one_in(20)) {  // beside each other, up to rounding
        a.q = b.p = b.q = a.p;
        a.q[0] += a.radius, b.p[1] += a.radius + b.radius, b.q[1] = b.p[1];
      }
      if (!finite(a) || !finite(b)) continue;

      const Relation r = relate(a, b);
      if (r != oracle::relation(a, b)) FAIL("wrong");
      if (relate(b, a) != reversed(r)) FAIL("not consistent");
      if (intersects(a, b) != (r != Relation::disjoint)) FAIL("not the same by intersects");
      Record<capsule_capsule::Event> record;
      if (relate(a, b, record) != r) FAIL("not the same when traced");
      if (numbers <= bench::Numbers::distant) {
        const tests::Motion<N> move = tests::motion<N>(random);
        if (relate(move(a), move(b)) != r) FAIL("not the same when moved");
      }
      ++seen[static_cast<int>(r)];
    }
  for (const int count : seen) CHECK(count > 50);
}

TEST_CASE("capsules in their own unit of length lie as they did, and keep every bit", "[capsule_capsule]") {
  using Ends = Capsule<double, 3>;
  const auto in_own = [](const Ends& a, const Ends& b) {
    return in_own_unit(a, b, [](const Ends& x, const Ends& y) { return std::pair(x, y); });
  };
  const auto same = [](const Ends& x, const Ends& y) { return x.p == y.p && x.q == y.q && x.radius == y.radius; };
  const Ends a = {{1, 2, 3}, {4, 5, 6}, 1}, b = {{7, 8, 9}, {1, 0, 0}, 0.5};
  CHECK(same(in_own(a, b).first, a));  // of ordinary size
  for (const int power : {-1000, -200, 200, 1000}) {
    const auto scaled = [&](Ends x) {
      bench::scale(power, x.p, x.q, x.radius);
      return x;
    };
    const auto [x, y] = in_own(scaled(a), scaled(b));
    CHECK((same(x, {a.p / 8, a.q / 8, a.radius / 8}) && same(y, {b.p / 8, b.q / 8, b.radius / 8})));
  }

  // 1e300 away and 1e-300 thick: no unit holds both, so the shapes stay as they are
  const double large = 1e300, small = 1e-300;
  const Ends far = {{large, 0, 0}, {large, 1, 0}, small}, thin = {{large, 0, small}, {large, 1, small}, 0};
  CHECK(same(in_own(far, thin).first, far));
  CHECK(relate(far, thin) == Relation::b_inside_a);
  CHECK(relate(far, Ends{{large, 0, 2 * small}, {large, 1, 2 * small}, small / 2}) == Relation::disjoint);
}

}  // namespace capsule_capsule_test
