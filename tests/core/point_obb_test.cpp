// Point against oriented box: cases by name, properties, and hard families against rational coordinates.

#include <isect/point_obb.h>

#include <algorithm>
#include <limits>

#include "tests/catch.h"
#include "tests/core/common.h"
#include "tests/core/point_obb_pairs.h"
#include "tests/settings.h"

namespace point_obb_test {
using namespace isect;
using namespace tests::point_obb_pairs;
using tests::at, tests::inf, tests::not_a_number;

namespace {

/// Half-lengths 2, 1, 1 along the frame's axes.
template <class S, int N>
Obb<S, N> brick() {
  Obb<S, N> box = {at<S, N>(0), Eigen::Matrix<S, N, N>::Identity(), Vector<S, N>::Ones()};
  box.half[0] = 2;
  return box;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("a point is in, on or out of a box", "[point_obb]", FLOATS_AND_DIMENSIONS) {
  CHECK(locate(at<S, N>(0), brick<S, N>()) == Location::in);
  CHECK(locate(at<S, N>(1.5, 0.5), brick<S, N>()) == Location::in);
  CHECK(locate(at<S, N>(2, 0.5), brick<S, N>()) == Location::on);
  CHECK(locate(at<S, N>(-2, -1), brick<S, N>()) == Location::on);
  CHECK(locate(at<S, N>(2.5, 0), brick<S, N>()) == Location::out);
  CHECK(locate(at<S, N>(0, -1.5), brick<S, N>()) == Location::out);
}

TEMPLATE_TEST_CASE_SIG("point and OBB: an ulp decides", "[point_obb]", FLOATS_AND_DIMENSIONS) {
  CHECK(locate(at<S, N>(std::nextafter(S(2), S(0))), brick<S, N>()) == Location::in);
  CHECK(locate(at<S, N>(std::nextafter(S(2), S(3))), brick<S, N>()) == Location::out);
}

TEMPLATE_TEST_CASE_SIG("axes of any length and skew are taken literally", "[point_obb]", FLOATS_AND_DIMENSIONS) {
  Obb<S, N> box = brick<S, N>();
  box.axes.col(0) *= S(3);
  box.axes.col(1) = at<S, N>(1, 1);  // a parallelogram
  CHECK(locate(at<S, N>(7, 1), box) == Location::on);
  CHECK(locate(at<S, N>(-5, 1), box) == Location::on);
  CHECK(locate(at<S, N>(-5.5, 1), box) == Location::out);
  CHECK(locate(at<S, N>(6.5, 0.75), box) == Location::in);
}

TEMPLATE_TEST_CASE_SIG("a turned box is decided by its rounded axes", "[point_obb]", FLOATS_AND_DIMENSIONS) {
  Obb<S, N> box = brick<S, N>();
  box.axes.col(0) = at<S, N>(0.6, 0.8), box.axes.col(1) = at<S, N>(-0.8, 0.6);
  CHECK(locate(at<S, N>(0.6, 0.8), box) == Location::in);
  CHECK(locate(Point<S, N>(S(2) * box.axes.col(0)), box) == Location::on);  // a power of two times the axis: exact
  CHECK(locate(at<S, N>(-0.9, 1.3), box) == Location::out);
}

TEMPLATE_TEST_CASE_SIG("the points of a flat box lie on it", "[point_obb]", FLOATS_AND_DIMENSIONS) {
  Obb<S, N> box = brick<S, N>();
  box.half[1] = 0;
  CHECK(locate(at<S, N>(1), box) == Location::on);
  CHECK(locate(at<S, N>(1, std::numeric_limits<S>::denorm_min()), box) == Location::out);
  box.half.setZero();
  CHECK(locate(at<S, N>(-0.0, 0), box) == Location::on);
  CHECK(locate(at<S, N>(1), box) == Location::out);
}

TEMPLATE_TEST_CASE_SIG("empty boxes, dependent axes, NaN and infinity hold no point", "[point_obb]",
                       FLOATS_AND_DIMENSIONS) {
  Obb<S, N> empty_box = brick<S, N>(), no_box = brick<S, N>();
  empty_box.half[1] = -1;
  CHECK(locate(at<S, N>(0), empty_box) == Location::out);
  no_box.axes.col(1) = no_box.axes.col(0);
  CHECK(locate(at<S, N>(0), no_box) == Location::out);
  for (const S bad : {static_cast<S>(not_a_number), static_cast<S>(inf), static_cast<S>(-inf)}) {
    CHECK(locate(at<S, N>(bad), brick<S, N>()) == Location::out);
    for (int i = 0; i < N; ++i) {
      Obb<S, N> center = brick<S, N>(), axes = brick<S, N>(), half = brick<S, N>();
      center.center[i] = bad, axes.axes(0, i) = bad, half.half[i] = bad;
      CHECK(locate(at<S, N>(0), center) == Location::out);
      CHECK(locate(at<S, N>(0), axes) == Location::out);
      CHECK(locate(at<S, N>(0), half) == Location::out);
    }
  }
}

TEMPLATE_TEST_CASE_SIG("point and OBB: sizes from tiny to huge give the same verdict", "[point_obb]",
                       FLOATS_AND_DIMENSIONS) {
  constexpr int most = std::numeric_limits<S>::max_exponent - 4;
  for (const int e : {-most, -most / 2, most / 2, most}) {
    const double k = std::ldexp(1.0, e);
    Obb<S, N> box = brick<S, N>();
    box.half *= static_cast<S>(k);
    CHECK(locate(at<S, N>(2 * k, k), box) == Location::on);
    CHECK(locate(at<S, N>(std::nextafter(static_cast<S>(2 * k), S(0)), 0), box) == Location::in);
    Obb<S, N> stretched = brick<S, N>();
    stretched.axes *= static_cast<S>(k);  // the corners move as far, by the axes' length
    CHECK(locate(at<S, N>(2 * k, k), stretched) == Location::on);
    CHECK(locate(at<S, N>(2 * k, 1.5 * k), stretched) == Location::out);
  }
}

TEMPLATE_TEST_CASE_SIG("locations are those of rational coordinates", "[point_obb]", FLOATS_AND_DIMENSIONS) {
  for (const bench::Numbers numbers : bench::all_numbers) {
    bench::Random random(tests::seed() + static_cast<unsigned>(numbers));
    int count[3] = {};
    const int cases = tests::cases(1500, 125000);
    for (int i = 0; i < cases; ++i) {
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      const Obb<S, N> box = bench::obb<S, N>(random, numbers);
      const Point<S, N> x = near(random, box, numbers);
      if (!finite(x)) continue;
      const Location location = locate(x, box);
      REQUIRE(location == oracle_locate(x, box));
      ++count[static_cast<int>(location)];
    }
    CHECK(std::min({count[0], count[1], count[2]}) > cases / 100);
  }
}

TEMPLATE_TEST_CASE_SIG("point and OBB: exact motions, orders of axes and listeners change nothing", "[point_obb]",
                       FLOATS_AND_DIMENSIONS) {
  bench::Random random(tests::seed());
  for (int i = 0; i < 2000; ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    const bench::Numbers numbers = random.one_in(2) ? bench::Numbers::grid : bench::Numbers::ordinary;
    const Obb<S, N> box = bench::obb<S, N>(random, numbers);
    const Point<S, N> x = near(random, box, numbers);
    const Location location = locate(x, box);

    Record<point_obb::Event> record;
    CHECK(locate(x, box, record) == location);

    const Eigen::Matrix<S, N, N> turn = bench::permutation<S, N>(random);
    CHECK(locate<S, N>(turn * x, {turn * box.center, turn * box.axes, box.half}) == location);
    const Vector<S, N> half = (turn.transpose() * box.half).cwiseAbs();
    CHECK(locate<S, N>(x, {box.center, box.axes * turn, half}) == location);  // the same box, its axes reordered
    const S k = std::ldexp(S(1), random.integer(0, 20));  // up: a subnormal loses bits on the way down
    CHECK(locate<S, N>(k * x, {k * box.center, box.axes, k * box.half}) == location);
    CHECK(locate<S, N>(k * x, {k * box.center, k * box.axes, box.half}) == location);
    CHECK(locate<S, N>(x, {box.center, k * box.axes, box.half / k}) == location);
  }
}

TEST_CASE("the events tell each slab, the last one that of the verdict", "[point_obb]") {
  Record<point_obb::Event> record;
  CHECK(locate<double, 3>({0, 5, 0}, brick<double, 3>(), record) == Location::out);
  REQUIRE(record.events.size() == 2);
  CHECK(std::get<point_obb::Slab>(record.events[0]).sign == -1);
  CHECK(std::get<point_obb::Slab>(record.events[1]).axis == 1);
  CHECK(std::get<point_obb::Slab>(record.events[1]).sign == 1);
}

}  // namespace point_obb_test
