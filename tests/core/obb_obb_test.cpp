// Oriented box against oriented box: cases by name, properties, and hard families against projections of all corners
// and against the vertices of the common part, in rationals.

#include <isect/obb_obb.h>

#include <algorithm>
#include <limits>
#include <vector>

#include <isect/counted.h>
#include <isect/methods/obb_obb.h>
#include "bench/obb_obb/families.h"
#include "bench/obb_obb/oracle.h"
#include "bench/random_obb.h"
#include "tests/catch.h"
#include "tests/core/common.h"
#include "tests/settings.h"

namespace obb_obb_test {
using namespace isect;
using oracle::obb::Exactly;
using tests::at, tests::inf, tests::not_a_number;

namespace {

/// Half-lengths 2, 1, 1 along the frame's axes.
template <class S, int N>
Obb<S, N> brick(const Point<S, N>& center = at<S, N>(0)) {
  Obb<S, N> box = {center, Eigen::Matrix<S, N, N>::Identity(), Vector<S, N>::Ones()};
  box.half[0] = 2;
  return box;
}

/// The direction that an axis names.
template <int N>
oracle::Coordinates<N> direction_of(const obb_obb::Axis& axis, const Exactly<N>& a, const Exactly<N>& b) {
  const auto& u = axis.kind == obb_obb::Kind::face_of_b ? b.axes : a.axes;
  const int i = axis.i;
  if constexpr (N == 2)
    return {-u[1 - i][1], u[1 - i][0]};
  else
    return axis.kind == obb_obb::Kind::edges ? oracle::cross(a.axes[i], b.axes[axis.j])
                                             : oracle::cross(u[(i + 1) % 3], u[(i + 2) % 3]);
}

/// Two boxes that lie close: of like axes, corner at corner, edge at edge or face at face, up to an ulp.
template <class S, int N>
std::array<Obb<S, N>, 2> close_pair(bench::Random& random, bench::Numbers numbers) {
  Obb<S, N> a = bench::obb<S, N>(random, numbers), b = bench::obb<S, N>(random, numbers);
  if (random.one_in(4)) a.half[0] *= S(1e5), a.half[N - 1] *= S(0.01);  // slender
  if (random.one_in(4)) a.axes = bench::rotation<S, N>(random, 3);
  if (random.one_in(2)) b.axes = a.axes * bench::permutation<S, N>(random);
  if (random.one_in(2)) b.axes = b.axes * bench::rotation<S, N>(random, random.magnitude(-12, -6));
  if (random.one_in(4)) b.half = a.half;
  const S places[] = {S(-1), S(1), S(-1), S(1), S(0), static_cast<S>(random.uniform(-1, 1))};
  Vector<S, N> s, t;
  for (int i = 0; i < N; ++i) s[i] = a.half[i] * places[random.below(6)], t[i] = b.half[i] * places[random.below(6)];
  b.center = a.center + a.axes * s + b.axes * t;                                    // a point of A at a point of B
  if (random.one_in(3)) b.center = a.center + a.axes * s / 2, b.half = a.half / 2;  // one in the other, nearly
  if (random.one_in(8)) {
    const Eigen::Matrix<S, N, N> order = bench::permutation<S, N>(random);
    b = {a.center, a.axes * order, (order.transpose() * a.half).cwiseAbs()};  // the same set
  }
  if (random.one_in(2)) std::swap(a, b);
  const int axis = random.below(N);
  if (random.one_in(2)) b.center[axis] = bench::moved(b.center[axis], random.integer(-2, 2));
  return {a, b};
}

template <class S, int N>
std::array<Obb<S, N>, 2> pair(bench::Random& random, bench::Numbers numbers) {
  if (!random.one_in(4)) return close_pair<S, N>(random, numbers);
  return {bench::obb<S, N>(random, numbers), bench::obb<S, N>(random, numbers)};
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("boxes side by side are disjoint, touch or overlap", "[obb_obb]", FLOATS_AND_DIMENSIONS) {
  const Obb<S, N> a = brick<S, N>();
  CHECK(relate(a, brick<S, N>(at<S, N>(4.5))) == Relation::disjoint);
  CHECK(relate(a, brick<S, N>(at<S, N>(4))) == Relation::touching);
  CHECK(relate(a, brick<S, N>(at<S, N>(4, 2))) == Relation::touching);
  CHECK(relate(a, brick<S, N>(at<S, N>(3, 1))) == Relation::overlapping);
  CHECK(relate(a, brick<S, N>(at<S, N>(std::nextafter(S(4), S(5))))) == Relation::disjoint);
  CHECK(relate(a, brick<S, N>(at<S, N>(std::nextafter(S(4), S(0))))) == Relation::overlapping);
  CHECK_FALSE(intersects(a, brick<S, N>(at<S, N>(std::nextafter(S(4), S(5))))));
  CHECK(intersects(a, brick<S, N>(at<S, N>(4, 2))));
}

TEMPLATE_TEST_CASE_SIG("a box within another is inside, its faces touching or not", "[obb_obb]",
                       FLOATS_AND_DIMENSIONS) {
  Obb<S, N> small = brick<S, N>(at<S, N>(0.5));
  small.half *= S(0.5);
  CHECK(relate(small, brick<S, N>()) == Relation::a_inside_b);
  CHECK(relate(brick<S, N>(), small) == Relation::b_inside_a);
  small.center[0] = 1;
  CHECK(relate(small, brick<S, N>()) == Relation::a_inside_b);
  small.center[0] = std::nextafter(S(1), S(2));
  CHECK(relate(small, brick<S, N>()) == Relation::overlapping);
  small.axes.col(0) = at<S, N>(0.6, 0.8), small.axes.col(1) = at<S, N>(-0.8, 0.6), small.center[0] = 0;
  small.half.setConstant(S(0.5));
  CHECK(relate(small, brick<S, N>()) == Relation::a_inside_b);
}

TEMPLATE_TEST_CASE_SIG("the same set is equal, whatever its axes' order, signs and lengths", "[obb_obb]",
                       FLOATS_AND_DIMENSIONS) {
  Obb<S, N> other = brick<S, N>();
  other.axes.col(0) = at<S, N>(0, -4), other.axes.col(1) = at<S, N>(0.5);
  other.half[0] = S(0.25), other.half[1] = 4;
  CHECK(relate(brick<S, N>(), other) == Relation::equal);
  CHECK(intersects(brick<S, N>(), other));
}

TEMPLATE_TEST_CASE_SIG("a turned box touches with its corner", "[obb_obb]", FLOATS_AND_DIMENSIONS) {
  Obb<S, N> diamond = {at<S, N>(4), Eigen::Matrix<S, N, N>::Identity(), Vector<S, N>::Ones()};
  diamond.axes.col(0) = at<S, N>(1, 1), diamond.axes.col(1) = at<S, N>(-1, 1);  // corners 2 away from the center
  CHECK(relate(brick<S, N>(), diamond) == Relation::touching);
  diamond.center[0] = std::nextafter(S(4), S(5));
  CHECK(relate(brick<S, N>(), diamond) == Relation::disjoint);
  diamond.center = at<S, N>(3.5, 2.5);  // past the corner: only the diamond's own normal separates
  CHECK(relate(brick<S, N>(), diamond) == Relation::disjoint);
  const auto axis = separating_axis(brick<S, N>(), diamond);
  REQUIRE(axis);
  CHECK(axis->kind == obb_obb::Kind::face_of_b);
}

TEMPLATE_TEST_CASE_SIG("flat boxes and points are met where they are", "[obb_obb]", FLOATS_AND_DIMENSIONS) {
  Obb<S, N> plate = brick<S, N>(at<S, N>(1)), point = brick<S, N>();
  plate.half[0] = 0, point.half.setZero();
  CHECK(relate(plate, brick<S, N>()) == Relation::a_inside_b);
  plate.half[1] = 3;
  CHECK(relate(plate, brick<S, N>()) == Relation::overlapping);  // it sticks out
  plate.center[0] = S(2);
  CHECK(relate(plate, brick<S, N>()) == Relation::touching);
  plate.center[0] = std::nextafter(S(2), S(3));
  CHECK(relate(plate, brick<S, N>()) == Relation::disjoint);

  CHECK(relate(point, brick<S, N>()) == Relation::a_inside_b);
  CHECK(relate(point, point) == Relation::equal);
  point.center = at<S, N>(2, 1);
  CHECK(relate(brick<S, N>(), point) == Relation::b_inside_a);
  point.center = at<S, N>(2, std::nextafter(1.0f, 2.0f));
  CHECK(relate(brick<S, N>(), point) == Relation::disjoint);
}

TEMPLATE_TEST_CASE_SIG("nothing meets empty boxes, dependent axes, NaN and infinity", "[obb_obb]",
                       FLOATS_AND_DIMENSIONS) {
  std::vector<Obb<S, N>> nothings(2, brick<S, N>());
  nothings[0].half[1] = -1;
  nothings[1].axes.col(1) = nothings[1].axes.col(0);
  for (const S bad : {static_cast<S>(not_a_number), static_cast<S>(inf), static_cast<S>(-inf)})
    for (int i = 0; i < N; ++i) {
      Obb<S, N> center = brick<S, N>(), axes = brick<S, N>(), half = brick<S, N>();
      center.center[i] = bad, axes.axes(i, 0) = bad, half.half[i] = bad;
      nothings.insert(nothings.end(), {center, axes, half});
    }
  for (const Obb<S, N>& nothing : nothings)
    for (const Obb<S, N>& other : {brick<S, N>(), nothing}) {
      CHECK_FALSE(intersects(nothing, other));
      CHECK_FALSE(intersects(other, nothing));
      CHECK(relate(nothing, other) == Relation::disjoint);
      CHECK(relate(other, nothing) == Relation::disjoint);
      CHECK_FALSE(separating_axis(nothing, other));
    }
}

TEMPLATE_TEST_CASE_SIG("two OBBs: sizes from tiny to huge give the same verdict", "[obb_obb]", FLOATS_AND_DIMENSIONS) {
  constexpr int most = std::numeric_limits<S>::max_exponent - 4;
  for (const int e : {-most, -most / 2, most / 2, most}) {
    const double k = std::ldexp(1.0, e);
    const auto scaled = [&](double x, double y) {
      Obb<S, N> box = brick<S, N>(at<S, N>(k * x, k * y));
      box.half *= static_cast<S>(k);
      return box;
    };
    CHECK(relate(scaled(0, 0), scaled(4, 1)) == Relation::touching);
    CHECK(relate(scaled(0, 0), scaled(3.9, 1)) == Relation::overlapping);
    CHECK(relate(scaled(0, 0), scaled(4.1, 1)) == Relation::disjoint);
    CHECK_FALSE(intersects(scaled(0, 0), scaled(4.1, 1)));
  }
}

TEST_CASE("crossed edges separate where no face does", "[obb_obb]") {
  // two bars, their edges at right angles, turned so that they point at each other
  const double c = std::sqrt(0.5);
  Obb<double, 3> a = {{0, 0, 0}, Eigen::Matrix3d::Identity(), {5, 1, 1}}, b = a;
  a.axes << 1, 0, 0, 0, c, -c, 0, c, c;  // along x, an edge on top
  b.axes << 0, c, -c, 1, 0, 0, 0, c, c;  // along y, an edge below
  b.center = {0, 0, 2.829};
  CHECK_FALSE(intersects(a, b));
  const auto axis = separating_axis(a, b);
  REQUIRE(axis);
  CHECK(axis->kind == obb_obb::Kind::edges);
  b.center[2] = 2.828;
  CHECK(relate(a, b) == Relation::overlapping);
}

TEST_CASE("two OBBs: the published hard cases are decided rightly", "[obb_obb]") {
  SECTION("a corner a hair off a face (MathGeoLib issue 12)") {
    const Obb<double, 3> a = {{.5, .5, .5}, Eigen::Matrix3d::Identity(), {.5, .5, .5}};
    Obb<double, 3> b = {{1, 0.36602540378444004, -1.3660254037844402}, {}, {1, 1, 1}};
    b.axes << 0, 0, 1, -0.5, 0.86602540378444, 0, -0.86602540378444, -0.5, 0;
    CHECK_FALSE(intersects(a, b));
  }
  SECTION("slender boxes with a gap, which an absolute epsilon closes") {
    const Obb<double, 3> a = {{0, 0, 0}, Eigen::Matrix3d::Identity(), {1e5, .01, .01}};
    Obb<double, 3> b = a;
    b.center[1] = 0.12;
    CHECK_FALSE(intersects(a, b));
    CHECK(obb_obb::gottschalk(a, b, 1e-6));
    CHECK_FALSE(obb_obb::gottschalk(a, b, 1e-12));
  }
}

namespace {

/// Moves b beside a, up to rounding, so that their faces touch.
template <class S, int N>
void set_beside(const Obb<S, N>& a, Obb<S, N>& b) {
  b.axes = a.axes;
  b.center = a.center + (a.half[0] + b.half[0]) * a.axes.col(0);
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("verdicts are those of rational projections", "[obb_obb]", FLOATS_AND_DIMENSIONS) {
  int count[6] = {};
  const int cases = tests::cases(60, 8000);
  for (const bench::Numbers numbers : bench::all_numbers) {
    bench::Random random(tests::seed() + static_cast<unsigned>(numbers));
    for (int i = 0; i < cases; ++i) {
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      auto [a, b] = pair<S, N>(random, numbers);
      if (random.one_in(8)) set_beside(a, b);
      if (!finite(a) || !finite(b)) continue;
      const Exactly<N> exact_a(a), exact_b(b);
      const Relation truth = by_projection(exact_a, exact_b);
      REQUIRE(relate(a, b) == truth);
      REQUIRE(relate(b, a) == reversed(truth));
      REQUIRE(intersects(a, b) == (truth != Relation::disjoint));
      ++count[static_cast<int>(truth)];

      const auto axis = separating_axis(a, b);
      REQUIRE((axis.has_value() || !exists(exact_a) || !exists(exact_b)) == (truth == Relation::disjoint));
      if (axis) REQUIRE(along(direction_of(*axis, exact_a, exact_b), exact_a, exact_b) == 1);
    }
  }
  CHECK(*std::min_element(std::begin(count), std::end(count)) > cases / 20);
}

TEMPLATE_TEST_CASE_SIG("verdicts are those of the common part's vertices", "[obb_obb]", FLOATS_AND_DIMENSIONS) {
  bench::Random random(tests::seed());
  int count[6] = {};
  const int cases = tests::cases(N == 2 ? 300 : 80, N == 2 ? 40000 : 1500);
  for (int i = 0; i < cases; ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    const bench::Numbers numbers = bench::all_numbers[random.below(8)];
    auto [a, b] = pair<S, N>(random, random.one_in(2) ? bench::Numbers::grid : numbers);
    for (int k = 0; k < N; ++k)
      if (random.one_in(4)) (random.one_in(2) ? a : b).half[k] = 0;  // flat boxes: are the axes enough?
    if (random.one_in(4)) set_beside(a, b);
    if (!finite(a) || !finite(b)) continue;
    const Relation truth = by_vertices(Exactly<N>(a), Exactly<N>(b));
    REQUIRE(relate(a, b) == truth);
    REQUIRE(intersects(a, b) == (truth != Relation::disjoint));
    ++count[static_cast<int>(truth)];
  }
  for (const Relation r : {Relation::disjoint, Relation::touching, Relation::overlapping})
    CHECK(count[static_cast<int>(r)] > 0);
}

TEMPLATE_TEST_CASE_SIG("two OBBs: exact motions, orders of axes and listeners change nothing", "[obb_obb]",
                       FLOATS_AND_DIMENSIONS) {
  bench::Random random(tests::seed());
  for (int i = 0; i < 500; ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    const auto [a, b] = pair<S, N>(random, random.one_in(2) ? bench::Numbers::grid : bench::Numbers::ordinary);
    const Relation relation = relate(a, b);
    Record<obb_obb::Event<N>> record;
    CHECK(relate(a, b, record) == relation);
    CHECK(intersects(a, b, record) == (relation != Relation::disjoint));

    const Eigen::Matrix<S, N, N> turn = bench::permutation<S, N>(random);
    const auto turned = [&](const Obb<S, N>& x) -> Obb<S, N> { return {turn * x.center, turn * x.axes, x.half}; };
    CHECK(relate<S, N>(turned(a), turned(b)) == relation);
    const auto reordered = [&](const Obb<S, N>& x) -> Obb<S, N> {
      return {x.center, x.axes * turn, (turn.transpose() * x.half).cwiseAbs()};
    };
    CHECK(relate<S, N>(a, reordered(b)) == relation);
    CHECK(relate<S, N>(a, reordered(a)) == relate(a, a));
    const S k = std::ldexp(S(1), random.integer(0, 20));
    const auto scaled = [&](const Obb<S, N>& x) -> Obb<S, N> { return {k * x.center, x.axes, k * x.half}; };
    CHECK(relate<S, N>(scaled(a), scaled(b)) == relation);
    CHECK(relate<S, N>({a.center, k * a.axes, a.half / k}, b) == relation);
  }
}

TEMPLATE_TEST_CASE("the first pass settles ordinary boxes, and is right about all it settles", "[obb_obb]", float,
                   double) {
  using S = TestType;
  bench::Random random(tests::seed());
  int open = 0, overlap = 0;
  const int cases = tests::cases(1000, 100000);
  for (int i = 0; i < cases; ++i) {
    const auto box = [&]() -> Obb<S, 3> {
      const Point<double, 3> center = random.in_box<3>(2), half = random.in_box<3>(1).cwiseAbs();
      return {center.cast<S>(), bench::rotation<S, 3>(random, 3), half.cast<S>()};
    };
    const Obb<S, 3> a = box(), b = box();
    const obb_obb::detail::FirstPass first = obb_obb::detail::first_pass(a, b, NoTrace{});
    const bool truth = !obb_obb::detail::settle<3>(in_doubles(a), in_doubles(b), ~0u, NoTrace{}).separating;
    if (first.overlap) CHECK(truth);
    if (first.separating) CHECK_FALSE(truth);
    open += !first.overlap && !first.separating, overlap += first.overlap;
  }
  CHECK(open <= (std::is_same_v<S, float> ? cases / 500 : 0));
  CHECK(overlap > cases / 20);
  CHECK(overlap < cases - cases / 20);
}

TEMPLATE_TEST_CASE("an axis that the first pass does not leave open neither separates nor touches", "[obb_obb]", float,
                   double) {
  using S = TestType;
  bench::Random random(tests::seed());
  int closed = 0, open = 0;
  for (const auto& drawn : bench::obb_obb_draws<S>)
    for (int i = 0; i < tests::cases(300, 30000); ++i) {
      bench::OrientedBoxes<S> c = drawn.draw(random);
      if (random.one_in(2))  // axes as skew as the first pass takes them
        for (S& x : c.a.axes.reshaped()) x += static_cast<S>(random.magnitude(-18, -4));
      const obb_obb::detail::FirstPass first = obb_obb::detail::first_pass(c.a, c.b, NoTrace{});
      if (first.separating) continue;
      const Obb<double, 3> a = in_doubles(c.a), b = in_doubles(c.b);
      for (const obb_obb::Axis& axis : obb_obb::detail::all_axes<3>()) {
        const bool is_open = (first.open >> obb_obb::detail::place<3>(axis) & 1) != 0;
        is_open ? ++open : ++closed;
        INFO(drawn.name << ", seed " << tests::seed() << ", case " << i);
        if (!is_open) REQUIRE(sign_of([&]<class W>() -> W { return obb_obb::detail::gap<W>(a, b, axis); }) < 0);
      }
    }
  CHECK(closed > 0);
  CHECK(open > 0);
}

TEST_CASE("boxes with the same axes, in any order and direction, are asked by those alone", "[obb_obb]") {
  bench::Random random(tests::seed());
  for (int i = 0; i < tests::cases(2000, 200000); ++i) {
    Obb<double, 3> a, b;
    a.axes = random.one_in(2) ? Eigen::Matrix3d(Eigen::Matrix3d::Identity()) : bench::rotation<double, 3>(random, 3);
    if (random.one_in(3)) a.axes.col(0) += a.axes.col(1);  // not at right angles
    b.axes = a.axes * bench::permutation<double, 3>(random);
    for (int k = 0; k < 3; ++k) {
      a.half[k] = random.integer(1, 3), b.half[k] = random.integer(1, 3);
      b.center[k] = random.integer(-6, 6);
    }
    a.center = Point<double, 3>::Zero();
    REQUIRE(obb_obb::detail::same_axes(a, b));
    Record<obb_obb::Event<3>> all;
    REQUIRE(relate(a, b) == relate(a, b, all));
    b.axes(0, 0) = std::nextafter(b.axes(0, 0), 2.);
    REQUIRE_FALSE(obb_obb::detail::same_axes(a, b));
    REQUIRE(relate(a, b) == relate(a, b, all));
  }
}

TEST_CASE("the events tell each axis, an open one twice, and a witness", "[obb_obb]") {
  using Tested = obb_obb::Tested<3>;
  const Obb<double, 3> a = brick<double, 3>();
  Record<obb_obb::Event<3>> record;
  CHECK_FALSE(intersects(a, brick<double, 3>({0, 3, 0}), record));
  REQUIRE(record.events.size() == 2);
  const Tested& last = std::get<Tested>(record.events[1]);
  CHECK(last.axis == obb_obb::Axis{obb_obb::Kind::face_of_a, 1});
  CHECK(last.distance == 3);
  CHECK(last.radius_a == 1);
  CHECK(last.radius_b == 1);
  CHECK(last.sign == 1);

  record.events.clear();
  CHECK(intersects(a, brick<double, 3>({3, 1, 0}), record));
  REQUIRE(record.events.size() == 7);
  CHECK(std::get<obb_obb::Witness<3>>(record.events[6]).p == Point<double, 3>(2, 1, 0));

  record.events.clear();
  CHECK(intersects(a, brick<double, 3>({4, 0, 0}), record));  // touching is left open by doubles
  CHECK_FALSE(std::get<Tested>(record.events[0]).sign);
  const auto exactly_touching = [](const auto& event) {
    const Tested* tested = std::get_if<Tested>(&event);
    return tested != nullptr && tested->sign == 0;
  };
  CHECK(std::count_if(record.events.begin(), record.events.end(), exactly_touching) == 4);  // faces and products
}

TEST_CASE("the classical test counts, and tells its axes", "[obb_obb]") {
  using C = Counted<double>;
  Record<obb_obb::Compared<double>> record;
  CHECK(obb_obb::gottschalk(brick<double, 3>(), brick<double, 3>({3, 0, 0}), 1e-12, record));
  CHECK(record.events.size() == 15);
  const Obb<C, 3> a = {Point<C, 3>::Zero(), Eigen::Matrix<C, 3, 3>::Identity(), Vector<C, 3>::Ones()};
  tally() = {};
  CHECK(obb_obb::gottschalk(a, a, C(1e-12)));
  CHECK(tally().mul > 100);
  CHECK(tally().div == 0);
}

}  // namespace obb_obb_test
