#include <isect/kdop_kdop.h>

#include <cmath>

#include "bench/rational.h"
#include "bench/simple_shapes.h"
#include "tests/catch.h"
#include "tests/core/common.h"
#include "tests/settings.h"

namespace kdop_kdop_test {
using namespace isect;
using namespace isect::oracle;
using tests::at, tests::inf, tests::not_a_number;

namespace {

template <class S, int N>
std::vector<Vector<S, N>> octagon_normals() {
  return {at<S, N>(1, 0), at<S, N>(0, 1), at<S, N>(1, 1), at<S, N>(1, -1)};
}

/// The k-DOP around some points, each projection as the scalar rounds it.
template <class S, int N>
Kdop<S, N> around(const std::vector<Vector<S, N>>& normals, const std::vector<Point<S, N>>& points) {
  Kdop<S, N> k = {normals, {}};
  for (const Vector<S, N>& n : normals) {
    Interval<S> slab = {std::numeric_limits<S>::infinity(), -std::numeric_limits<S>::infinity()};
    for (const Point<S, N>& p : points) slab = {std::min(slab.lo, n.dot(p)), std::max(slab.hi, n.dot(p))};
    k.slabs.push_back(slab);
  }
  return k;
}

/// The first slab whose intervals are disjoint.
template <class S, int N, class Trace = NoTrace>
std::optional<int> separating_slab(const Kdop<S, N>& a, const Kdop<S, N>& b, Trace&& trace = {}) {
  return kdop_kdop::detail::first_apart(a, b, trace);
}

template <class S, int N>
std::optional<int> separation(const Kdop<S, N>& a, const Kdop<S, N>& b) {
  const std::optional<int> slab = separating_slab(a, b);
  CHECK(separating_slab(b, a) == slab);
  CHECK(may_intersect(a, b) == !slab);
  return slab;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("k-DOPs are separated by a slab, or may intersect", "[kdop_kdop]", FLOATS_AND_DIMENSIONS) {
  const std::vector<Vector<S, N>> normals = octagon_normals<S, N>();
  const auto segment = [&](double ax, double ay, double bx, double by) {
    return around<S, N>(normals, {at<S, N>(ax, ay), at<S, N>(bx, by)});
  };
  const Kdop<S, N> a = segment(0, 2, 2, 0);
  CHECK(separation(a, segment(3, 0, 5, 0)) == 0);
  CHECK(separation(a, segment(2, 2, 1, 2)) == 2);   // boxes overlap, the diagonal separates
  CHECK_FALSE(separation(a, segment(1, 1, 2, 2)));  // touch
  CHECK_FALSE(separation(a, a));
}

TEST_CASE("a true may be wrong, as another direction separates", "[kdop_kdop]") {
  using P = Point<double, 2>;
  const auto normals = octagon_normals<double, 2>();
  const Kdop<double, 2> a = around<double, 2>(normals, {P(0, 0), P(4, 2)}),
                        b = around<double, 2>(normals, {P(1, 1), P(4, 2.5)});
  CHECK(may_intersect(a, b));  // yet x - 2 y is at least 0 on one segment, at most -1 on the other
}

TEMPLATE_TEST_CASE_SIG("two k-DOPs: what is empty, NaN or infinite meets nothing", "[kdop_kdop]",
                       FLOATS_AND_DIMENSIONS) {
  const Kdop<S, N> good = around<S, N>(octagon_normals<S, N>(), {at<S, N>(-1, -1), at<S, N>(1, 1)});
  CHECK(may_intersect(good, good));
  for (const double bad : {not_a_number, inf, -inf, 7.})
    for (std::size_t i = 0; i < good.slabs.size(); ++i) {
      Kdop<S, N> k = good;
      k.slabs[i].lo = S(bad);
      CHECK_FALSE(may_intersect(good, k));
      CHECK_FALSE(may_intersect(k, k));
      k = good;
      k.slabs[i].hi = S(-bad);
      CHECK_FALSE(may_intersect(k, good));
    }
  Kdop<S, N> k = good;
  k.normals[1][0] = S(inf);
  CHECK_FALSE(may_intersect(k, k));
  CHECK(may_intersect(Kdop<S, N>{}, Kdop<S, N>{}));  // all of space, twice
}

TEMPLATE_TEST_CASE_SIG("an ulp decides, at any size", "[kdop_kdop]", FLOATS_AND_DIMENSIONS) {
  constexpr int most = std::numeric_limits<S>::max_exponent - 4;
  for (const int e : {-most, 0, most}) {
    const S end = std::ldexp(S(1), e);
    const Kdop<S, N> a = {{at<S, N>(1, 1)}, {{S(0), end}}}, touching = {a.normals, {{end, 2 * end}}},
                     apart = {a.normals, {{std::nextafter(end, 2 * end), 2 * end}}};
    CHECK_FALSE(separation(a, touching));
    CHECK(separation(a, apart) == 0);
  }
}

TEST_CASE("the events tell each slab up to the one that separates", "[kdop_kdop]") {
  Record<kdop_kdop::Event<double>> record;
  const auto normals = octagon_normals<double, 2>();
  const Kdop<double, 2> a = {normals, {{0, 1}, {0, 1}, {0, 1}, {0, 1}}},
                        b = {normals, {{0, 1}, {2, 3}, {4, 5}, {0, 1}}};
  CHECK(separating_slab(a, b, record) == 1);
  REQUIRE(record.events.size() == 2);
  const auto& last = std::get<kdop_kdop::Slab<double>>(record.events[1]);
  CHECK((last.slab == 1 && last.disjoint && last.b == Interval<double>{2, 3}));
}

TEST_CASE("integer normals keep all touches along a diagonal plane, unit normals lose many", "[kdop_kdop]") {
  const std::vector<Vector<double, 3>> whole = {{1, 1, 1}}, unit = {Vector<double, 3>(1, 1, 1) / std::sqrt(3.)};

  bench::Random random(tests::seed());
  const int count = tests::cases(5000, 1000000);
  int parted = 0;
  for (int i = 0; i < count; ++i) {
    // two segments on a grid of 1/16, on either side of the plane x + y + z = sum; one end of each lies in it
    const int sum = random.integer(-2000, 2000);
    const auto point = [&](int beyond) {
      const int x = random.integer(-2000, 2000), y = random.integer(-2000, 2000);
      return Point<double, 3>(Vector<double, 3>(x, y, sum + beyond - x - y) / 16);
    };
    const std::vector<Point<double, 3>> below = {point(0), point(-random.below(90))},
                                        above = {point(random.below(90)), point(0)};
    INFO("seed " << tests::seed() << ", case " << i);
    if (separating_slab(around(whole, below), around(whole, above))) FAIL("a touch is lost");
    parted += separating_slab(around(unit, below), around(unit, above)).has_value();
  }
  CHECK(parted > count / 10);
  CHECK(parted < count / 2);
}

TEMPLATE_TEST_CASE_SIG("slabs are compared as rational numbers are", "[kdop_kdop]", FLOATS_AND_DIMENSIONS) {
  bench::Random random(tests::seed());
  int separated = 0, together = 0;
  for (const bench::Numbers numbers : bench::all_numbers)
    for (int i = 0; i < tests::cases(1500, 125000); ++i) {
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      Kdop<S, N> a = {octagon_normals<S, N>(), {}}, b = a;
      std::optional<int> truth;
      for (int slab = 0; slab < 4; ++slab) {
        a.slabs.push_back(bench::interval<S>(random, numbers));
        b.slabs.push_back(bench::interval<S>(random, numbers));
        if (random.one_in(2)) b.slabs.back().lo = a.slabs.back().hi;
        const Rational a_lo = a.slabs.back().lo, a_hi = a.slabs.back().hi, b_lo = b.slabs.back().lo,
                       b_hi = b.slabs.back().hi;
        const Rational lo = a_lo > b_lo ? a_lo : b_lo, hi = a_hi < b_hi ? a_hi : b_hi;
        if (lo > hi && !truth) truth = slab;
      }
      if (separating_slab(a, b) != truth || separating_slab(b, a) != truth) FAIL("wrong");
      if (may_intersect(a, b) != !truth) FAIL("wrong");
      separated += truth.has_value(), together += !truth;
    }
  CHECK(std::min(separated, together) > 500);
}

}  // namespace kdop_kdop_test
