#include <isect/methods/plane_aabb.h>
#include <isect/plane_aabb.h>

#include <isect/counted.h>
#include "bench/rational.h"
#include "bench/simple_shapes.h"
#include "tests/catch.h"
#include "tests/core/common.h"
#include "tests/core/motion.h"
#include "tests/settings.h"

namespace plane_aabb_test {
using namespace isect;
using namespace isect::oracle;
using tests::at, tests::inf, tests::not_a_number;

namespace {

template <class S, int N>
Aabb<S, N> cube(double lo, double hi) {
  return {Point<S, N>::Constant(S(lo)), Point<S, N>::Constant(S(hi))};
}

template <class S, int N>
Relation related(const Plane<S, N>& plane, const Aabb<S, N>& box) {
  const Relation r = relate(plane, box);
  CHECK(intersects(plane, box) == (r != Relation::disjoint));
  if (r != Relation::disjoint) CHECK(side(plane, box) == 0);
  return r;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("a plane misses a box, touches it, or cuts it, and an ulp decides", "[plane_aabb]",
                       FLOATS_AND_DIMENSIONS) {
  const Aabb<S, N> box = cube<S, N>(-1, 1);
  const auto plane = [](S d) { return Plane<S, N>{at<S, N>(1, -1), d}; };
  CHECK(related(plane(3), box) == Relation::disjoint);
  CHECK(side(plane(3), box) == 1);
  CHECK(side(plane(-3), box) == -1);
  CHECK(related(plane(2), box) == Relation::touching);
  CHECK(related(plane(-2), box) == Relation::touching);
  CHECK(related(plane(std::nextafter(S(2), S(3))), box) == Relation::disjoint);
  CHECK(related(plane(std::nextafter(S(2), S(1))), box) == Relation::overlapping);
  CHECK(related(plane(0), box) == Relation::overlapping);
  CHECK(related(Plane<S, N>{at<S, N>(0, 1), S(-1)}, box) == Relation::touching);  // along a face
}

TEMPLATE_TEST_CASE_SIG("a plane touches a flat box in it, and a point", "[plane_aabb]", FLOATS_AND_DIMENSIONS) {
  Aabb<S, N> plate = cube<S, N>(-1, 1);
  plate.lo[1] = plate.hi[1] = S(0.1);
  CHECK(related(Plane<S, N>{at<S, N>(0, 1), -S(0.1)}, plate) == Relation::touching);
  CHECK(related(Plane<S, N>{at<S, N>(1, 0), S(0)}, plate) == Relation::overlapping);
  CHECK(related(Plane<S, N>{at<S, N>(1, 1), S(-2)}, cube<S, N>(1, 1)) == Relation::touching);
}

TEMPLATE_TEST_CASE_SIG("plane and box: the normal may have any length, and lengths any size", "[plane_aabb]",
                       FLOATS_AND_DIMENSIONS) {
  constexpr int most = std::numeric_limits<S>::max_exponent - 4;
  for (const int e : {-most, -most / 2, 0, most / 2, most}) {
    const double k = std::ldexp(1.0, e);
    CHECK(related(Plane<S, N>{at<S, N>(k, k), S(-2 * k)}, cube<S, N>(-1, 1)) == Relation::touching);
    CHECK(related(Plane<S, N>{at<S, N>(k, k), S(-3 * k)}, cube<S, N>(-1, 1)) == Relation::disjoint);
    CHECK(related(Plane<S, N>{at<S, N>(1, 1), S(-2 * k)}, cube<S, N>(-k, k)) == Relation::touching);
    CHECK(related(Plane<S, N>{at<S, N>(1, 1), S(-k)}, cube<S, N>(-k, k)) == Relation::overlapping);
  }
}

TEMPLATE_TEST_CASE_SIG("plane and box: a zero normal is no plane, and what is empty, NaN or infinite meets nothing",
                       "[plane_aabb]", FLOATS_AND_DIMENSIONS) {
  const Aabb<S, N> box = cube<S, N>(-1, 1);
  const Plane<S, N> good = {at<S, N>(1, 0), S(0)};
  const auto nothing = [](const Plane<S, N>& plane, const Aabb<S, N>& b) {
    CHECK(related(plane, b) == Relation::disjoint);
    CHECK(side(plane, b) == 0);
  };
  for (const double d : {-1, 0, 1}) nothing({at<S, N>(0, -0.0), S(d)}, box);
  nothing(good, cube<S, N>(1, -1));
  for (const double bad : {not_a_number, inf, -inf}) {
    nothing({at<S, N>(1, bad), S(0)}, box);
    nothing({at<S, N>(1, 0), S(bad)}, box);
    nothing(good, {at<S, N>(bad, 0), box.hi});
    nothing(good, {box.lo, at<S, N>(0, bad)});
  }
}

TEST_CASE("the two corners in doubles are fooled where the sum rounds", "[plane_aabb]") {
  const Plane<double, 2> plane = {{1, 1}, -1};
  const Aabb<double, 2> below = {{0, -1}, {1, -0x1p-60}};
  CHECK(relate(plane, below) == Relation::disjoint);
  CHECK(side(plane, below) == -1);
  CHECK(plane_aabb::corners(plane, below) == 0);
}

TEST_CASE("the two corners cost two dot products", "[plane_aabb]") {
  using C = Counted<double>;
  tally() = {};
  CHECK(plane_aabb::corners<C, 3>({{1., 1., 1.}, -1.}, {{0., 0., 0.}, {1., 1., 1.}}) == 0);
  CHECK(tally() == Tally{.mul = 6, .add = 6, .compare = 8});
}

TEST_CASE("the events tell the corners and the signs", "[plane_aabb]") {
  Record<plane_aabb::Event<double, 2>> record;
  const Plane<double, 2> plane = {{1, -1}, 0.5};
  const Aabb<double, 2> box = {{0, 0}, {1, 2}};
  plane_aabb::corners(plane, box, record);
  const auto& corners = std::get<plane_aabb::Corners<double, 2>>(record.events.at(0));
  CHECK((corners.least == Point<double, 2>(0, 2) && corners.greatest == Point<double, 2>(1, 0)));
  CHECK((corners.at_least == -1.5 && corners.at_greatest == 1.5));
  relate(plane, box, record);
  const auto& decision = std::get<plane_aabb::Decision>(record.events.at(1));
  CHECK((decision.least == -1 && decision.greatest == 1));
}

TEMPLATE_TEST_CASE_SIG("plane and box: verdicts are those of rational arithmetic", "[plane_aabb]",
                       FLOATS_AND_DIMENSIONS) {
  bench::Random random(tests::seed());
  int seen[6] = {}, sides[3] = {};
  for (const bench::Numbers numbers : bench::all_numbers)
    for (int i = 0; i < tests::cases(1500, 125000); ++i) {
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      Aabb<S, N> box = bench::box<S, N>(random, numbers);
      if (random.one_in(20)) box.hi = box.lo;
      const bool whole = random.one_in(2);
      Plane<S, N> plane = {bench::vector<S, N>(random, whole ? bench::Numbers::grid : numbers),
                           bench::number<S>(random, numbers)};
      Point<double, N> corner;
      for (int axis = 0; axis < N; ++axis) corner[axis] = random.one_in(2) ? box.lo[axis] : box.hi[axis];
      const double d = -plane.normal.template cast<double>().dot(corner);
      if (random.one_in(2)) plane.d = bench::moved(static_cast<S>(d), random.integer(-2, 2));
      if (!finite(plane) || plane.normal.isZero(0) || empty(box)) continue;

      bool above = false, below = false, in_plane = false;  // among all corners
      for (int k = 0; k < 1 << N; ++k) {
        Rational h = plane.d;
        for (int axis = 0; axis < N; ++axis)
          h += Rational(plane.normal[axis]) * Rational((k >> axis & 1 ? box.hi : box.lo)[axis]);
        above |= h > 0, below |= h < 0, in_plane |= h == 0;
      }
      const Relation truth = above && below ? Relation::overlapping
                             : in_plane     ? Relation::touching
                                            : Relation::disjoint;
      if (relate(plane, box) != truth) FAIL("wrong");
      if (intersects(plane, box) != (truth != Relation::disjoint)) FAIL("wrong: intersects");
      if (side(plane, box) != (truth != Relation::disjoint ? 0 : above ? 1 : -1)) FAIL("wrong: side");
      const Plane<S, N> turned = {-plane.normal, -plane.d};
      if (side(turned, box) != -side(plane, box)) FAIL("not opposite when turned around");
      if (numbers <= bench::Numbers::distant) {
        const tests::Motion<N> move = tests::motion<N>(random);
        if (relate(move(plane), move(box)) != truth) FAIL("not the same when moved");
      }
      ++seen[static_cast<int>(truth)], ++sides[side(plane, box) + 1];
    }
  for (const Relation r : {Relation::disjoint, Relation::touching, Relation::overlapping})
    CHECK(seen[static_cast<int>(r)] > 200);
  for (const int count : sides) CHECK(count > 300);
}

}  // namespace plane_aabb_test
