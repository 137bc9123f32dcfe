#include <isect/methods/kdop_kdop.h>

#include <isect/fit.h>
#include <isect/kdop_kdop.h>
#include "bench/kdop_kdop/families.h"
#include "tests/catch.h"
#include "tests/settings.h"

namespace kdop_kdop_methods_test {
using namespace isect;
using namespace isect::kdop_kdop;

TEST_CASE("unit normals point the same way and have length 1, but for rounding", "[kdop_kdop_methods]") {
  const auto normals = directions<double, 3>(26), unit = unit_normals(normals);
  REQUIRE(unit.size() == normals.size());
  for (std::size_t i = 0; i < unit.size(); ++i) {
    CHECK(std::abs(unit[i].norm() - 1) < 1e-15);
    CHECK(unit[i].dot(normals[i]) > 0);
  }
}

TEST_CASE("slabs go from the least product to the largest", "[kdop_kdop_methods]") {
  Record<FitEvent<double>> record;
  const std::vector<Point<double, 2>> points = {{0, 0}, {3, 1}, {1, 4}};
  const auto kdop = rounded_kdop<double, 2>(points, {{1, 0}, {1, 1}}, record);
  CHECK(kdop.slabs[0] == Interval<double>{0, 3});
  CHECK(kdop.slabs[1] == Interval<double>{0, 5});
  REQUIRE(record.events.size() == 6);
  CHECK(std::get<Projected<double>>(record.events[4]).so_far == Interval<double>{0, 4});
}

TEMPLATE_TEST_CASE("unit normals part tetrahedra that touch on a grid, integer normals do not", "[kdop_kdop_methods]",
                   float, double) {
  using S = TestType;
  const auto normals = directions<S, 3>(14), unit = unit_normals(normals);
  bench::Random random(tests::seed());
  int parted = 0;
  for (int i = 0; i < tests::cases(500, 20000); ++i) {
    const auto [p, q] = bench::kdop_kdop_families::grid<S>(random);
    if (!bench::true_slabs_overlap<S>({p, q}, normals)) continue;  // parted along another normal
    const std::vector<Point<S, 3>> a(p.begin(), p.end()), b(q.begin(), q.end());
    REQUIRE(may_intersect(rounded_kdop(a, normals), rounded_kdop(b, normals)));
    REQUIRE(may_intersect(fit_kdop(a, normals), fit_kdop(b, normals)));
    parted += !may_intersect(rounded_kdop(a, unit), rounded_kdop(b, unit));
  }
  CHECK(parted > 20);
}

}  // namespace kdop_kdop_methods_test
