#include <isect/point_aabb.h>

#include "bench/rational.h"
#include "bench/simple_shapes.h"
#include "tests/catch.h"
#include "tests/core/common.h"
#include "tests/core/motion.h"
#include "tests/settings.h"

namespace point_aabb_test {
using namespace isect;
using namespace isect::oracle;
using tests::inf, tests::not_a_number;

namespace {

template <class S, int N>
Aabb<S, N> cube(double lo, double hi) {
  return {Point<S, N>::Constant(S(lo)), Point<S, N>::Constant(S(hi))};
}

/// The middle of [0, 2]^N except in one coordinate.
template <class S, int N>
Location at(int axis, S x) {
  Point<S, N> p = Point<S, N>::Ones();
  p[axis] = x;
  return locate(p, cube<S, N>(0, 2));
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("a point lies in a box, on a face, or outside", "[point_aabb]", FLOATS_AND_DIMENSIONS) {
  for (int axis = 0; axis < N; ++axis) {
    CHECK(at<S, N>(axis, 1) == Location::in);
    CHECK(at<S, N>(axis, 2) == Location::on);
    CHECK(at<S, N>(axis, S(-0.0)) == Location::on);
    CHECK(at<S, N>(axis, 3) == Location::out);
    CHECK(at<S, N>(axis, std::nextafter(S(2), S(1))) == Location::in);
    CHECK(at<S, N>(axis, std::nextafter(S(2), S(3))) == Location::out);
    CHECK(at<S, N>(axis, -std::numeric_limits<S>::denorm_min()) == Location::out);
    CHECK(at<S, N>(axis, std::numeric_limits<S>::denorm_min()) == Location::in);
    for (const double bad : {not_a_number, inf, -inf}) CHECK(at<S, N>(axis, S(bad)) == Location::out);
  }
  CHECK(locate<S, N>(Point<S, N>::Zero(), cube<S, N>(0, 2)) == Location::on);  // a corner
}

TEMPLATE_TEST_CASE_SIG("a flat box has no interior", "[point_aabb]", FLOATS_AND_DIMENSIONS) {
  Aabb<S, N> plate = cube<S, N>(0, 2);
  plate.lo[1] = plate.hi[1] = 1;
  CHECK(locate<S, N>(Point<S, N>::Ones(), plate) == Location::on);
  CHECK(locate<S, N>(Point<S, N>::Ones(), cube<S, N>(1, 1)) == Location::on);
  CHECK(locate<S, N>(Point<S, N>::Zero(), plate) == Location::out);
}

TEMPLATE_TEST_CASE_SIG("every point is outside an empty box, and one with NaN or infinite coordinates", "[point_aabb]",
                       FLOATS_AND_DIMENSIONS) {
  const Point<S, N> p = Point<S, N>::Ones();
  CHECK(locate(p, cube<S, N>(2, 0)) == Location::out);
  for (int axis = 0; axis < N; ++axis)
    for (const double bad : {not_a_number, inf, -inf})
      for (const bool low : {true, false}) {
        Aabb<S, N> box = cube<S, N>(0, 2);
        (low ? box.lo : box.hi)[axis] = S(bad);
        CHECK(locate(p, box) == Location::out);
      }
}

TEST_CASE("the events tell each axis up to the first that shuts the point out", "[point_aabb]") {
  Record<point_aabb::Event<double>> record;
  locate<double, 3>({0, 5, 1}, {{0, 0, 0}, {2, 2, 2}}, record);
  REQUIRE(record.events.size() == 2);
  const auto& first = std::get<point_aabb::Axis<double>>(record.events[0]);
  CHECK((first.axis == 0 && first.location == Location::on));
  const auto& last = std::get<point_aabb::Axis<double>>(record.events[1]);
  CHECK((last.x == 5 && last.interval == Interval<double>{0, 2} && last.location == Location::out));
}

TEMPLATE_TEST_CASE_SIG("point and box: locations are those of rational arithmetic", "[point_aabb]",
                       FLOATS_AND_DIMENSIONS) {
  bench::Random random(tests::seed());
  int seen[3] = {};
  for (const bench::Numbers numbers : bench::all_numbers)
    for (int i = 0; i < tests::cases(1500, 125000); ++i) {
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      const Aabb<S, N> box = bench::box<S, N>(random, numbers);
      Point<S, N> p = bench::vector<S, N>(random, numbers);
      for (int axis = 0; axis < N; ++axis) {
        if (random.one_in(2)) p[axis] = box.lo[axis] / 2 + box.hi[axis] / 2;
        if (random.one_in(8)) p[axis] = bench::moved(box.hi[axis], random.integer(-1, 1));
      }

      // the least of the distances to all faces, inwards
      Rational depth = Rational(box.hi[0]) - Rational(p[0]);
      bool holds_something = true;
      for (int axis = 0; axis < N; ++axis) {
        const Rational x = p[axis], lo = box.lo[axis], hi = box.hi[axis];
        for (const Rational& d : {Rational(x - lo), Rational(hi - x)})
          if (d < depth) depth = d;
        holds_something &= lo <= hi;
      }
      const Location truth = depth < 0 || !holds_something ? Location::out : depth == 0 ? Location::on : Location::in;
      if (locate(p, box) != truth) FAIL("wrong");
      if (numbers <= bench::Numbers::distant) {
        const tests::Motion<N> move = tests::motion<N>(random);
        if (locate(move(p), move(box)) != truth) FAIL("not the same when moved");
      }
      ++seen[static_cast<int>(truth)];
    }
  for (const int count : seen) CHECK(count > 500);
}

}  // namespace point_aabb_test
