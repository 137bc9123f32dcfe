#include <isect/aabb_aabb.h>
#include <isect/methods/aabb_aabb.h>

#include <isect/counted.h>
#include "bench/aabb_aabb/oracle.h"
#include "bench/simple_shapes.h"
#include "tests/catch.h"
#include "tests/core/common.h"
#include "tests/core/motion.h"
#include "tests/settings.h"

namespace aabb_aabb_test {
using namespace isect;
using tests::inf, tests::not_a_number;

namespace {

/// A box from lo to hi on the first axis, from y to y + height on the others.
template <class S, int N>
Aabb<S, N> bar(double lo, double hi, double y = 0, double height = 1) {
  Aabb<S, N> b = {Point<S, N>::Constant(S(y)), Point<S, N>::Constant(S(y + height))};
  b.lo[0] = S(lo), b.hi[0] = S(hi);
  return b;
}

template <class S, int N>
Relation related(const Aabb<S, N>& a, const Aabb<S, N>& b) {
  const Relation r = relate(a, b);
  CHECK(relate(b, a) == reversed(r));
  CHECK(intersects(a, b) == (r != Relation::disjoint));
  CHECK(intersects(b, a) == (r != Relation::disjoint));
  CHECK(interiors_intersect(a, b) == interiors_intersect(b, a));
  return r;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("two boxes lie in one of six ways", "[aabb_aabb]", FLOATS_AND_DIMENSIONS) {
  const Aabb<S, N> a = bar<S, N>(0, 2, 0, 2);
  CHECK(related(a, bar<S, N>(3, 4)) == Relation::disjoint);
  CHECK(related(a, bar<S, N>(2, 4)) == Relation::touching);
  CHECK(related(a, bar<S, N>(1, 4)) == Relation::overlapping);
  CHECK(related(a, bar<S, N>(0, 1)) == Relation::b_inside_a);
  CHECK(related(a, bar<S, N>(-1, 3, -1, 4)) == Relation::a_inside_b);
  CHECK(related(a, bar<S, N>(0, 2, 0, 2)) == Relation::equal);
  CHECK(interiors_intersect(a, bar<S, N>(0, 1)));
  CHECK_FALSE(interiors_intersect(a, bar<S, N>(2, 4)));
}

TEMPLATE_TEST_CASE_SIG("boxes that overlap on one axis only are disjoint, whichever axis it is", "[aabb_aabb]",
                       FLOATS_AND_DIMENSIONS) {
  for (int axis = 0; axis < N; ++axis) {
    const Aabb<S, N> a = {Point<S, N>::Zero(), Point<S, N>::Ones()};
    Aabb<S, N> b = {Point<S, N>::Constant(2), Point<S, N>::Constant(3)};
    b.lo[axis] = 0;
    CHECK(related(a, b) == Relation::disjoint);
    CHECK_FALSE(aabb_aabb::by_axis(a, b));
  }
}

TEMPLATE_TEST_CASE_SIG("boxes touch in a face, an edge or a corner, and an ulp parts them", "[aabb_aabb]",
                       FLOATS_AND_DIMENSIONS) {
  const Aabb<S, N> a = {Point<S, N>::Zero(), Point<S, N>::Constant(S(0.7))};
  for (int shared = 1; shared <= N; ++shared) {
    Aabb<S, N> b = {Point<S, N>::Zero(), Point<S, N>::Ones()};
    for (int i = 0; i < shared; ++i) b.lo[i] = S(0.7);
    CHECK(related(a, b) == Relation::touching);
    b.lo[0] = std::nextafter(b.lo[0], S(1));
    CHECK(related(a, b) == Relation::disjoint);
    for (int i = 0; i < shared; ++i) b.lo[i] = std::nextafter(S(0.7), S(0));
    CHECK(related(a, b) == Relation::overlapping);
  }
}

TEMPLATE_TEST_CASE_SIG("flat boxes have their interior within the plane that they span", "[aabb_aabb]",
                       FLOATS_AND_DIMENSIONS) {
  const Aabb<S, N> a = bar<S, N>(0, 2, 0, 2);
  CHECK(related(a, bar<S, N>(1, 1, 1, 0)) == Relation::b_inside_a);   // a point inside
  CHECK(related(a, bar<S, N>(2, 2, 2, 0)) == Relation::b_inside_a);   // a corner
  CHECK(related(a, bar<S, N>(1, 1, 1, 3)) == Relation::overlapping);  // a plate that sticks out
  CHECK(related(a, bar<S, N>(1, 1, 2, 3)) == Relation::touching);     // its edge on a face
  CHECK(related(a, bar<S, N>(2, 2, 1, 3)) == Relation::touching);     // on a face
  CHECK(interiors_intersect(a, bar<S, N>(1, 1, 0, 1)));
  CHECK_FALSE(interiors_intersect(a, bar<S, N>(2, 2, 0, 1)));
  CHECK(related(bar<S, N>(1, 1, 0, 2), bar<S, N>(1, 1, 1, 2)) == Relation::overlapping);  // in one plane
  CHECK(related(bar<S, N>(1, 1, 0, 2), bar<S, N>(1, 1, 2, 2)) == Relation::touching);
  CHECK(related(bar<S, N>(1, 1, 0, 2), bar<S, N>(0, 2, 1, 0)) == Relation::overlapping);  // a rod through a plate
  CHECK(related(bar<S, N>(1, 1, 0, 2), bar<S, N>(1, 2, 1, 0)) == Relation::touching);
  CHECK(related(bar<S, N>(1, 1, 0, 0), bar<S, N>(1, 1, -0.0, 0)) == Relation::equal);
}

TEMPLATE_TEST_CASE_SIG("inverted boxes, NaN and infinite coordinates meet nothing", "[aabb_aabb]",
                       FLOATS_AND_DIMENSIONS) {
  const Aabb<S, N> good = bar<S, N>(-1, 2, -1, 3);
  for (const double bad : {not_a_number, inf, -inf, 5., -5.})
    for (int i = 0; i < N; ++i)
      for (const bool low : {true, false}) {
        if ((low && bad == -5) || (!low && bad == 5)) continue;
        Aabb<S, N> a = good;
        (low ? a.lo : a.hi)[i] = S(bad);
        CHECK(related(a, good) == Relation::disjoint);
        CHECK(related(a, a) == Relation::disjoint);
        CHECK_FALSE(interiors_intersect(a, good));
        CHECK_FALSE(interiors_intersect(a, a));
      }
  const Aabb<S, N> all = {Point<S, N>::Constant(S(-inf)), Point<S, N>::Constant(S(inf))};
  CHECK(related(all, good) == Relation::disjoint);
  const Aabb<S, N> crossed = {Point<S, N>::Constant(S(inf)), Point<S, N>::Constant(S(-inf))};
  CHECK(related(crossed, all) == Relation::disjoint);
}

TEMPLATE_TEST_CASE_SIG("boxes whose widths overflow are boxes", "[aabb_aabb]", FLOATS_AND_DIMENSIONS) {
  const S most = std::numeric_limits<S>::max(), least = std::numeric_limits<S>::denorm_min();
  const Aabb<S, N> all = {Point<S, N>::Constant(-most), Point<S, N>::Constant(most)};
  CHECK(related(all, all) == Relation::equal);
  CHECK(related(all, bar<S, N>(0, least, 0, least)) == Relation::b_inside_a);
  CHECK(related(bar<S, N>(-most, 0), bar<S, N>(0, most)) == Relation::touching);
  CHECK(related(bar<S, N>(-most, 0), bar<S, N>(least, most)) == Relation::disjoint);
}

TEST_CASE("the note's loop says yes after the last axis only, and no at the first disjoint one", "[aabb_aabb]") {
  using Box = Aabb<double, 3>;
  Record<aabb_aabb::Event<double, 3>> record;
  const Box a = {{0, 0, 0}, {1, 1, 1}}, b = {{0.5, 2, 0}, {2, 3, 1}};
  CHECK_FALSE(aabb_aabb::by_axis(a, b, record));
  REQUIRE(record.events.size() == 2);
  CHECK_FALSE(std::get<aabb_aabb::Axis<double>>(record.events[0]).disjoint);
  const auto& last = std::get<aabb_aabb::Axis<double>>(record.events[1]);
  CHECK((last.axis == 1 && last.disjoint && last.a == a.along(1) && last.b == b.along(1)));

  record.events.clear();
  CHECK(aabb_aabb::by_axis(a, a, record));
  CHECK(record.events.size() == 3);

  CHECK(aabb_aabb::by_axis(a, Box{{1, 1, 1}, {0, 0, 0}}));  // naive: an inverted box
  CHECK(aabb_aabb::by_axis(
      a, Box{{not_a_number, not_a_number, not_a_number}, {not_a_number, not_a_number, not_a_number}}));
}

TEST_CASE("the note's loop needs six comparisons for a yes, one at best for a no", "[aabb_aabb]") {
  using Box = Aabb<Counted<double>, 3>;
  const Box a = {{0., 0., 0.}, {1., 1., 1.}}, right = {{2., 0., 0.}, {3., 1., 1.}};
  tally() = {};
  aabb_aabb::by_axis(a, a);
  CHECK(tally() == Tally{.compare = 6});
  tally() = {};
  aabb_aabb::by_axis(right, a);
  CHECK(tally() == Tally{.compare = 1});
}

TEST_CASE("relate tells the shared box", "[aabb_aabb]") {
  Record<aabb_aabb::Event<double, 2>> record;
  relate<double, 2>({{0, 0}, {2, 2}}, {{1, 1}, {3, 3}}, record);
  REQUIRE(record.events.size() == 1);
  const Aabb<double, 2> common = std::get<aabb_aabb::Common<double, 2>>(record.events[0]).common;
  CHECK((common.lo == Point<double, 2>(1, 1) && common.hi == Point<double, 2>(2, 2)));
}

TEMPLATE_TEST_CASE_SIG("two boxes: relations are those of the sets of points", "[aabb_aabb]", FLOATS_AND_DIMENSIONS) {
  bench::Random random(tests::seed());
  int seen[6] = {};
  for (const bench::Numbers numbers : bench::all_numbers)
    for (int i = 0; i < tests::cases(1500, 125000); ++i) {
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      const Aabb<S, N> a = bench::box<S, N>(random, numbers);
      Aabb<S, N> b = bench::box<S, N>(random, numbers);
      if (random.one_in(3)) b = a;
      for (int j = 0; j < N; ++j) {
        if (random.one_in(3)) b.lo[j] = random.one_in(3) ? a.lo[j] : std::min(b.lo[j], a.hi[j]);
        if (random.one_in(3)) b.hi[j] = random.one_in(3) ? a.hi[j] : std::max(b.hi[j], a.lo[j]);
      }
      if (random.one_in(50)) b.hi[random.below(N)] = std::numeric_limits<S>::infinity();

      const Relation truth = finite(b) ? oracle::by_points(a, b) : Relation::disjoint;
      const Relation r = relate(a, b);
      if (r != truth) FAIL("wrong");
      if (relate(b, a) != reversed(r) || intersects(a, b) != (r != Relation::disjoint)) FAIL("not consistent");
      if (r == Relation::overlapping && !interiors_intersect(a, b)) FAIL("no interiors");
      if ((r == Relation::touching || r == Relation::disjoint) && interiors_intersect(a, b)) FAIL("interiors");
      if (intersects(a, b) && !aabb_aabb::by_axis(a, b)) FAIL("the note's loop misses");

      if (numbers <= bench::Numbers::distant) {
        const tests::Motion<N> move = tests::motion<N>(random);
        if (relate(move(a), move(b)) != r) FAIL("not the same when moved");
      }
      ++seen[static_cast<int>(r)];
    }
  for (const int count : seen) CHECK(count > 100);
}

}  // namespace aabb_aabb_test
