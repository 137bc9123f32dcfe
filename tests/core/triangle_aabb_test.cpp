// Triangle against axis-aligned box: cases by name, properties, and hard families against clipping in rationals.

#include <isect/triangle_aabb.h>

#include <algorithm>
#include <bit>
#include <limits>

#include <isect/counted.h>
#include <isect/methods/triangle_aabb.h>
#include "bench/random_obb.h"
#include "bench/triangle_aabb/families.h"
#include "bench/triangle_aabb/oracle.h"
#include "tests/catch.h"
#include "tests/core/common.h"
#include "tests/core/triangle_box_pairs.h"
#include "tests/settings.h"

namespace triangle_aabb_test {
using namespace isect;
using namespace tests::triangle_box_pairs;
using tests::inf, tests::not_a_number;

namespace {

/// (x, y), or (x, y, z).
template <class S, int N>
Point<S, N> at(double x, double y, double z = 0) {
  Point<S, N> p;
  p[0] = static_cast<S>(x), p[1] = static_cast<S>(y);
  if constexpr (N == 3) p[2] = static_cast<S>(z);
  return p;
}

/// [-1, 1] in all directions.
template <class S, int N>
Aabb<S, N> cube() {
  return {Point<S, N>::Constant(-1), Point<S, N>::Constant(1)};
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("a triangle is inside, across, at or away from a box", "[triangle_aabb]",
                       FLOATS_AND_DIMENSIONS) {
  const auto with = [](double x) {
    return relate<S, N>({{at<S, N>(x, 0), at<S, N>(x + 1, 0), at<S, N>(x, 1)}}, cube<S, N>());
  };
  CHECK(with(0) == Relation::a_inside_b);
  CHECK(with(0.5) == Relation::overlapping);
  CHECK(with(1) == Relation::touching);
  CHECK(with(std::nextafter(1.0f, 2.0f)) == Relation::disjoint);
  CHECK(with(-2) == Relation::touching);
  CHECK(with(-2.5) == Relation::disjoint);
}

TEMPLATE_TEST_CASE_SIG("an edge that passes a corner by is told by its normal alone", "[triangle_aabb]",
                       FLOATS_AND_DIMENSIONS) {
  const auto with = [](S y) {  // the hypotenuse runs from (y, 0) to (0, y)
    return relate<S, N>({{at<S, N>(y, 0), at<S, N>(0, y), at<S, N>(y, y)}}, cube<S, N>());
  };
  CHECK(with(2) == Relation::touching);
  CHECK(with(std::nextafter(S(2), S(3))) == Relation::disjoint);
  CHECK(with(std::nextafter(S(2), S(0))) == Relation::overlapping);
}

TEMPLATE_TEST_CASE_SIG("degenerate triangles are segments and points", "[triangle_aabb]", FLOATS_AND_DIMENSIONS) {
  const auto with = [](const Point<S, N>& p, const Point<S, N>& q) {
    const Relation r = relate<S, N>({{p, q, q}}, cube<S, N>());
    CHECK(relate<S, N>({{p, q, p}}, cube<S, N>()) == r);
    CHECK(intersects<S, N>({{q, q, p}}, cube<S, N>()) == (r != Relation::disjoint));
    return r;
  };
  CHECK(with(at<S, N>(0, 0), at<S, N>(1, 1)) == Relation::a_inside_b);
  CHECK(with(at<S, N>(2, 0), at<S, N>(0, 2)) == Relation::touching);
  CHECK(with(at<S, N>(2, 0.5), at<S, N>(0, 2.5)) == Relation::disjoint);
  CHECK(with(at<S, N>(1, 0), at<S, N>(3, 0)) == Relation::touching);
  CHECK(with(at<S, N>(0, 0), at<S, N>(3, 0)) == Relation::overlapping);
  CHECK(with(at<S, N>(1, 1), at<S, N>(1, 1)) == Relation::a_inside_b);
  CHECK(with(at<S, N>(1, 1.5), at<S, N>(1, 1.5)) == Relation::disjoint);
}

TEMPLATE_TEST_CASE_SIG("flat boxes lie in a triangle, overlap it, or touch it", "[triangle_aabb]",
                       FLOATS_AND_DIMENSIONS) {
  const Triangle<S, N> triangle = {{at<S, N>(0, 0), at<S, N>(4, 0), at<S, N>(0, 4)}};
  const auto with = [&](double x, double y, double X, double Y) {
    return relate<S, N>(triangle, {at<S, N>(x, y), at<S, N>(X, Y)});
  };
  CHECK(with(1, 1, 2, 2) == Relation::b_inside_a);
  CHECK(with(2, 2, 2, 2) == Relation::b_inside_a);
  CHECK(with(3, 3, 3, 3) == Relation::disjoint);
  CHECK(with(1, 1, 1, 5) == Relation::overlapping);
  CHECK(with(1, 3, 1, 5) == Relation::touching);
  CHECK(with(-1, 0, 5, 0) == Relation::touching);
  if constexpr (N == 3) {
    CHECK(relate<S, N>(triangle, {at<S, N>(1, 1, -1), at<S, N>(1, 1, 1)}) ==
          Relation::overlapping);                                                                 // a rod through it
    CHECK(relate<S, N>(triangle, {at<S, N>(1, 1, 0), at<S, N>(1, 1, 1)}) == Relation::touching);  // on it
    CHECK(relate<S, N>(triangle, {at<S, N>(0, 1, -1), at<S, N>(0, 1, 1)}) == Relation::touching);
    CHECK(relate<S, N>(triangle, {at<S, N>(1, -9, -1), at<S, N>(1, 9, 1)}) == Relation::overlapping);  // a plate
    CHECK(relate<S, N>(triangle, {at<S, N>(1, -9, 0), at<S, N>(1, 9, 1)}) == Relation::touching);
  }
  CHECK(relate<S, N>({{at<S, N>(1, 1), at<S, N>(2, 1), at<S, N>(1, 1)}}, {at<S, N>(1, 1), at<S, N>(2, 1)}) ==
        Relation::equal);
}

TEMPLATE_TEST_CASE_SIG("nothing meets an empty box, NaN or infinity", "[triangle_aabb]", FLOATS_AND_DIMENSIONS) {
  const Triangle<S, N> triangle = {{at<S, N>(0, 0), at<S, N>(1, 0), at<S, N>(0, 1)}};
  Aabb<S, N> inverted = cube<S, N>();
  inverted.lo[1] = 2;
  CHECK_FALSE(intersects(triangle, inverted));
  CHECK(relate(triangle, inverted) == Relation::disjoint);
  for (const S bad : {static_cast<S>(not_a_number), static_cast<S>(inf), static_cast<S>(-inf)})
    for (int k = 0; k < N; ++k) {
      Triangle<S, N> t = triangle;
      t.vertices[k][k] = bad;
      Aabb<S, N> lo = cube<S, N>(), hi = cube<S, N>();
      lo.lo[k] = bad, hi.hi[k] = bad;
      CHECK_FALSE(intersects(t, cube<S, N>()));
      CHECK_FALSE(intersects(triangle, lo));
      CHECK_FALSE(intersects_interior(triangle, hi));
      CHECK(relate(triangle, hi) == Relation::disjoint);
    }
}

TEMPLATE_TEST_CASE_SIG("triangle and box: sizes from tiny to huge give the same verdict", "[triangle_aabb]",
                       FLOATS_AND_DIMENSIONS) {
  constexpr int most = std::numeric_limits<S>::max_exponent - 4;
  for (const int e : {-most, -most / 2, most / 2, most}) {
    const double k = std::ldexp(1.0, e);
    const Aabb<S, N> box = {Point<S, N>::Constant(static_cast<S>(-k)), Point<S, N>::Constant(static_cast<S>(k))};
    const auto with = [&](double y) {
      return relate<S, N>({{at<S, N>(k * y, 0), at<S, N>(0, k * y), at<S, N>(k * y, k * y)}}, box);
    };
    CHECK(with(2) == Relation::touching);
    CHECK(with(2.125) == Relation::disjoint);
    CHECK(with(1.875) == Relation::overlapping);
  }
}

TEST_CASE("a triangle in a face of the box only touches its interior's rim", "[triangle_aabb]") {
  const Triangle<double, 3> triangle = {{at<double, 3>(0, 0, 1), at<double, 3>(1, 0, 1), at<double, 3>(0, 1, 1)}};
  CHECK(relate(triangle, cube<double, 3>()) == Relation::a_inside_b);
  CHECK_FALSE(intersects_interior(triangle, cube<double, 3>()));
  const Triangle<double, 3> wide = {{at<double, 3>(-9, -9, 1), at<double, 3>(9, -9, 1), at<double, 3>(0, 9, 1)}};
  CHECK(relate(wide, cube<double, 3>()) == Relation::touching);
}

TEMPLATE_TEST_CASE_SIG("verdicts are those of clipping in rationals", "[triangle_aabb]", FLOATS_AND_DIMENSIONS) {
  int count[6] = {};
  const int cases = tests::cases(150, 20000);
  for (const bench::Numbers numbers : bench::all_numbers) {
    bench::Random random(tests::seed() + static_cast<unsigned>(numbers));
    for (int i = 0; i < cases; ++i) {
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      const auto [triangle, box] = pair<S, N>(random, numbers);
      if (!finite(triangle)) continue;
      const Relation truth = oracle::triangle_aabb::relation(triangle, box);
      REQUIRE(relate(triangle, box) == truth);
      REQUIRE(intersects(triangle, box) == (truth != Relation::disjoint));
      const bool inner = truth != Relation::disjoint &&
                         oracle::triangle_aabb::reaches_inside(oracle::triangle_aabb::common(triangle, box), box);
      REQUIRE(intersects_interior(triangle, box) == inner);
      ++count[static_cast<int>(truth)];
    }
  }
  CHECK(*std::min_element(std::begin(count), std::end(count)) > cases / 20);
}

TEMPLATE_TEST_CASE("triangle and box: the measured families are decided rightly, and break the naive test",
                   "[triangle_aabb]", float, double) {
  const int cases = tests::cases(150, 20000);
  for (const auto& drawn : bench::triangle_aabb_draws<TestType>) {
    bench::Random random(tests::seed());
    int naive_wrong = 0, meet = 0;
    for (int i = 0; i < cases; ++i) {
      INFO("seed " << tests::seed() << ", family " << drawn.name << ", case " << i);
      const auto [triangle, box] = drawn.draw(random);
      const bool valid = finite(triangle) && finite(box) && !empty(box);
      const bool truth = valid && !oracle::triangle_aabb::common(triangle, box).empty();
      REQUIRE(intersects(triangle, box) == truth);
      naive_wrong += triangle_aabb::akenine_moller(triangle, box) != truth, meet += truth;
    }
    INFO(drawn.name);
    const bool harmless = !drawn.hard() || drawn.name == std::string_view("grid");  // no rounding among small integers
    CHECK((naive_wrong > 0) == !harmless);
    const bool invalid = drawn.name == std::string_view("invalid");
    CHECK((invalid ? meet == 0 : cases / 10 < meet && meet < cases));
  }
}

TEMPLATE_TEST_CASE_SIG("exact motions, orders of vertices and listeners change nothing", "[triangle_aabb]",
                       FLOATS_AND_DIMENSIONS) {
  bench::Random random(tests::seed());
  for (int i = 0; i < 500; ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    const bench::Numbers numbers = random.one_in(2) ? bench::Numbers::grid : bench::Numbers::ordinary;
    const auto [triangle, box] = pair<S, N>(random, numbers);
    const auto& [a, b, c] = triangle.vertices;
    const Relation relation = relate(triangle, box);
    Record<triangle_aabb::Event<N>> record;
    CHECK(relate(triangle, box, record) == relation);
    CHECK(relate<S, N>({{b, c, a}}, box) == relation);
    CHECK(relate<S, N>({{b, a, c}}, box) == relation);
    const Eigen::Matrix<S, N, N> turn = bench::permutation<S, N>(random);
    const Point<S, N> p = turn * box.lo, q = turn * box.hi;
    CHECK(relate<S, N>({{turn * a, turn * b, turn * c}}, {p.cwiseMin(q), p.cwiseMax(q)}) == relation);
    const S k = std::ldexp(S(1), random.integer(0, 20));
    CHECK(relate<S, N>({{k * a, k * b, k * c}}, {k * box.lo, k * box.hi}) == relation);
  }
}

TEST_CASE("the events tell each axis, up to the one that separates", "[triangle_aabb]") {
  Record<triangle_aabb::Event<3>> record;
  const Triangle<double, 3> triangle = {{at<double, 3>(0, 2), at<double, 3>(1, 2), at<double, 3>(0, 3)}};
  CHECK_FALSE(intersects(triangle, cube<double, 3>(), record));
  REQUIRE(record.events.size() == 2);
  const auto& last = std::get<triangle_aabb::Tested<3>>(record.events[1]);
  CHECK(last.axis == triangle_aabb::Axis{triangle_aabb::Kind::box_normal, 1});
  CHECK(last.triangle == Interval<double>{2, 3});
  CHECK(last.box == Interval<double>{-1, 1});
  CHECK(last.sign == 1);
}

TEST_CASE("the classical test is right for ordinary shapes, counts, and rounds", "[triangle_aabb]") {
  bench::Random random(tests::seed());
  for (int i = 0; i < 1000; ++i) {
    const Point<double, 3> p = random.in_box<3>(1), q = random.in_box<3>(1);
    const Aabb<double, 3> box = {p.cwiseMin(q), p.cwiseMax(q)};
    Triangle<double, 3> triangle;
    for (Point<double, 3>& v : triangle.vertices) v = random.in_box<3>(1);
    CHECK(triangle_aabb::akenine_moller(triangle, box) == intersects(triangle, box));
  }
  // the box's center is not a double: half an ulp decides
  const Triangle<double, 3> plate = {{at<double, 3>(.7, 0, 0), at<double, 3>(.7, 1, 0), at<double, 3>(.7, 0, 1)}};
  const double before = std::nextafter(.7, 0);
  int wrong = 0;
  for (int i = 1; i < 100; ++i) {
    const Aabb<double, 3> box = {at<double, 3>(-i * .1, 0, 0), at<double, 3>(before, 1, 1)};
    CHECK_FALSE(intersects(plate, box));
    wrong += triangle_aabb::akenine_moller(plate, box);
  }
  CHECK(wrong > 0);

  using C = Counted<double>;
  const Triangle<C, 3> t = {{Point<C, 3>::Zero(), Point<C, 3>::Ones(), Point<C, 3>(C(1), C(0), C(0))}};
  Record<triangle_aabb::Compared<C>> record;
  tally() = {};
  CHECK(triangle_aabb::akenine_moller<C>(t, {Point<C, 3>::Zero(), Point<C, 3>::Ones()}, record));
  CHECK(record.events.size() == 13);
  CHECK(tally().mul > 100);
}

/// Whether the shapes overlap along all axes that are not among the `open` ones.
template <int N>
bool no_closed_axis_touches(const Triangle<double, N>& triangle, const Aabb<double, N>& box, unsigned open) {
  for (const triangle_aabb::Axis& axis : triangle_aabb::detail::all_axes<N>()) {
    if ((open & 1) == 0 && triangle_aabb::detail::gap(triangle, box, axis, NoTrace{}).value_or(-1) >= 0) return false;
    open >>= 1;
  }
  return true;
}

TEST_CASE("an axis that the first pass does not leave open neither separates nor touches", "[triangle_aabb]") {
  bench::Random random(tests::seed());
  int few = 0;
  for (const auto& drawn : bench::triangle_aabb_draws<double>)
    for (int i = 0; i < tests::cases(500, 50000); ++i) {
      INFO(drawn.name << ", seed " << tests::seed() << ", case " << i);
      const auto [triangle, box] = drawn.draw(random);
      if (triangle_aabb::detail::meaningless(triangle, box)) continue;
      const triangle_aabb::detail::FirstPass first = triangle_aabb::detail::first_pass(triangle, box);
      if (first.sign == 1) continue;
      REQUIRE(no_closed_axis_touches(triangle, box, first.open));
      few += !first.sign && std::popcount(first.open) < 5;
    }
  CHECK(few > 0);
}

TEMPLATE_TEST_CASE_SIG("the first pass settles ordinary shapes, and is right about all it settles", "[triangle_aabb]",
                       ((int N), N), 2, 3) {
  bench::Random random(tests::seed());
  int open = 0, apart = 0, overlap = 0;
  const int cases = tests::cases(2000, 200000);
  for (int i = 0; i < cases; ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    const auto vertex = [&] { return Point<double, N>(random.in_box<N>(1.5)); };
    const Point<double, N> a = vertex(), b = vertex(), c = vertex(), p = vertex(), q = vertex();
    const Triangle<double, N> triangle = {
        {a, b, random.one_in(4) ? a + (b - a) * random.unit() : c}};  // or none to speak of
    const Aabb<double, N> box = {p.cwiseMin(q), p.cwiseMax(q)};
    const auto [sign, left] = triangle_aabb::detail::first_pass(triangle, box);
    if (sign) REQUIRE(*sign == triangle_aabb::detail::settle(triangle, box, ~0u, NoTrace{}));
    if (!sign) REQUIRE(no_closed_axis_touches(triangle, box, left));
    open += !sign, apart += sign == 1, overlap += sign == -1;
  }
  CHECK(open < cases / 3);  // of flat triangles, those that are not apart
  CHECK(apart > cases / 10);
  CHECK(overlap > cases / 10);
}

TEST_CASE("the first pass leaves open what is too large, and nobody asks it about infinity or NaN", "[triangle_aabb]") {
  const Aabb<double, 3> box = {{-1, -1, -1}, {1, 1, 1}};
  const Triangle<double, 3> beside = {
      {Point<double, 3>(5, 5, 5), Point<double, 3>(6, 5, 5), Point<double, 3>(5, 6, 5)}};
  const Triangle<double, 3> within = {
      {Point<double, 3>(0, 0, 0), Point<double, 3>(0.5, 0, 0), Point<double, 3>(0, 0.5, 0)}};
  CHECK(triangle_aabb::detail::first_pass(beside, box).sign == 1);
  CHECK(triangle_aabb::detail::first_pass(within, box).sign == -1);
  const double infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  for (int k = 0; k < 9; ++k) {
    for (const double large : {1e300, -1e300}) {
      Triangle<double, 3> triangle = beside;
      triangle.vertices[k / 3][k % 3] = large;
      CHECK_FALSE(triangle_aabb::detail::first_pass(triangle, box).sign);
    }
    for (const double bad : {infinity, -infinity, nan})
      for (Triangle<double, 3> triangle : {beside, within}) {
        triangle.vertices[k / 3][k % 3] = bad;
        CHECK_FALSE(intersects(triangle, box));
        CHECK(relate(triangle, box) == Relation::disjoint);
      }
  }
}

}  // namespace triangle_aabb_test
