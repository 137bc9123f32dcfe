// Slabs in floating point: right where edges lie apart, and wrong where they don't.

#include <isect/methods/slab_map.h>

#include <isect/point_polygon.h>
#include "bench/point_polygon/families.h"
#include "bench/point_polygon/oracle.h"
#include "tests/catch.h"
#include "tests/settings.h"

namespace slab_map_methods_test {
using namespace isect;
using namespace isect::bench;
using slab_map::Abscissa;
using slab_map::make_naive_slabs;
using slab_map::slabs_naive;

namespace {

/// How many points of the family the slabs put on the wrong side of the boundary.
template <class S>
int wrong(const char* name, Abscissa form, int count) {
  const PolygonFamily<S> family = polygon_family<S>(name, 64);
  const auto map = make_naive_slabs(family.rings.at(0), form);
  Random random(stream(tests::seed(), name));
  int sum = 0;
  for (int i = 0; i < count; ++i) {
    const PolygonCase<S> c = family.draw(random);
    const Location truth = oracle::location(c.point, *c.ring);
    sum += truth != Location::on && slabs_naive(c.point, map) != (truth == Location::in);
  }
  return sum;
}

}  // namespace

TEMPLATE_TEST_CASE("both forms locate points away from edges", "[slab_map_methods]", float, double) {
  using S = TestType;
  const Ring<S, 2> square = {{0, 0}, {4, 0}, {4, 4}, {0, 4}}, notched = {{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}};
  for (const Abscissa form : {Abscissa::line, Abscissa::interpolated}) {
    CHECK(slabs_naive(Point<S, 2>(1, 1), make_naive_slabs(square, form)));
    CHECK_FALSE(slabs_naive(Point<S, 2>(5, 1), make_naive_slabs(square, form)));
    CHECK_FALSE(slabs_naive(Point<S, 2>(1, -1), make_naive_slabs(square, form)));
    CHECK_FALSE(slabs_naive(Point<S, 2>(1, 5), make_naive_slabs(square, form)));
    CHECK_FALSE(slabs_naive(Point<S, 2>(2, 2), make_naive_slabs(notched, form)));
    CHECK(slabs_naive(Point<S, 2>(0.5, 2), make_naive_slabs(notched, form)));
    CHECK_FALSE(slabs_naive(Point<S, 2>(0, 0), make_naive_slabs(Ring<S, 2>{}, form)));
    CHECK(wrong<S>("ordinary", form, 5000) == 0);
  }
}

TEMPLATE_TEST_CASE("both are wrong near edges, and among edges that nearly coincide", "[slab_map_methods][failure]",
                   float, double) {
  using S = TestType;
  for (const char* name : {"near-edge", "near-vertical", "coincident"})
    for (const Abscissa form : {Abscissa::line, Abscissa::interpolated}) {
      INFO(name);
      CHECK(wrong<S>(name, form, 5000) > 10);
    }
  // a line that is nearly horizontal has a slope and an intercept too large to subtract
  CHECK(wrong<S>("near-horizontal", Abscissa::line, 5000) > wrong<S>("near-horizontal", Abscissa::interpolated, 5000));
}

TEST_CASE("the events tell the slab and the edges compared", "[slab_map_methods]") {
  const Ring<double, 2> square = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  Record<slab_map::NaiveEvent<double>> record;
  CHECK(slabs_naive(Point<double, 2>(1, 1), make_naive_slabs(square, Abscissa::line), record));
  REQUIRE(record.events.size() == 3);
  CHECK(std::get<slab_map::NaiveSlabFound>(record.events[0]).slab == 0);
  CHECK(std::get<slab_map::AbscissaCompared<double>>(record.events[1]).x == 4);
  CHECK(std::get<slab_map::AbscissaCompared<double>>(record.events[2]).left);
}

}  // namespace slab_map_methods_test
