#include <isect/point_line.h>

#include <cmath>
#include <limits>

#include "bench/random_rays.h"
#include "bench/rational.h"
#include "tests/catch.h"
#include "tests/core/common.h"
#include "tests/core/point_line_pairs.h"
#include "tests/settings.h"

namespace point_line_test {
using namespace isect;
using bench::Numbers, bench::Random;
using namespace tests::point_line_pairs;
using tests::at, tests::inf, tests::not_a_number;

TEMPLATE_TEST_CASE_SIG("a point lies on a ray, in line with it, or on a side of it", "[point_line]",
                       FLOATS_AND_DIMENSIONS) {
  const auto where = [](double x, double y, Interval<S> range = semi_infinite<S>) {
    return beside(at<S, N>(x, y), Ray<S, N>{at<S, N>(1, 1), at<S, N>(2, 1), range});
  };
  const Beside left = N == 2 ? Beside::left : Beside::aside, right = N == 2 ? Beside::right : Beside::aside;
  CHECK(where(1, 1) == Beside::on);
  CHECK(where(5, 3) == Beside::on);
  CHECK(where(-1, 0) == Beside::before);
  CHECK(where(-1, 0, infinite<S>) == Beside::on);
  CHECK(where(5, 3, {0, 2}) == Beside::on);
  CHECK(where(5, 3, {0, std::nextafter(S(2), S(0))}) == Beside::beyond);
  CHECK(where(5, 3, {2, 2}) == Beside::on);
  CHECK(where(5, 3, {3, 1}) == Beside::before);  // an empty range
  CHECK(where(5, 3, {2, 1}) == Beside::beyond);
  CHECK(where(5, 3, {S(inf), S(inf)}) == Beside::before);
  CHECK(where(1, 2) == left);
  CHECK(where(1, 0) == right);
  CHECK(where(5, static_cast<double>(std::nextafter(S(3), S(4)))) == left);
  CHECK(where(5, static_cast<double>(std::nextafter(S(3), S(2)))) == right);
  for (const double bad : {not_a_number, inf, -inf}) {
    CHECK(where(bad, 1) == Beside::aside);
    CHECK(beside(at<S, N>(1, 1), Ray<S, N>{at<S, N>(1, 1), at<S, N>(bad, 1)}) == Beside::aside);
  }
  CHECK(where(1, 1, {S(not_a_number), 1}) == Beside::aside);
  const Ray<S, N> point = {at<S, N>(1, 1), at<S, N>(0, -0.), {3, 4}};
  CHECK(beside(at<S, N>(1, 1), point) == Beside::on);
  CHECK(beside(at<S, N>(1, 2), point) == Beside::aside);
  CHECK(beside(at<S, N>(1, 1), Ray<S, N>{point.origin, point.direction, {4, 3}}) == Beside::aside);
}

TEMPLATE_TEST_CASE_SIG("a point beside a segment, whose ends are as given", "[point_line]", FLOATS_AND_DIMENSIONS) {
  const Segment<S, N> diagonal = {at<S, N>(0.1, 0.1), at<S, N>(0.7, 0.7)};
  const auto where = [&](double x, double y) { return beside(at<S, N>(x, y), diagonal); };
  CHECK(where(0.1, 0.1) == Beside::on);
  CHECK(where(0.7, 0.7) == Beside::on);
  CHECK(where(0.3, 0.3) == Beside::on);
  CHECK(where(0.05, 0.05) == Beside::before);
  CHECK(where(0.9, 0.9) == Beside::beyond);
  CHECK(where(0.3, 0.3 + 1e-7) == (N == 2 ? Beside::left : Beside::aside));
  const S beyond = std::nextafter(S(0.7), S(1));
  CHECK(beside(at<S, N>(static_cast<double>(beyond), static_cast<double>(beyond)), diagonal) == Beside::beyond);
  const Segment<S, N> point = {at<S, N>(0.1, 0.1), at<S, N>(0.1, 0.1)};
  CHECK(beside(at<S, N>(0.1, 0.1), point) == Beside::on);
  CHECK(beside(at<S, N>(0.1, 0.2), point) == Beside::aside);
  CHECK(beside(at<S, N>(0.1, not_a_number), diagonal) == Beside::aside);
}

TEST_CASE("in space a point that is aside in one coordinate alone is aside", "[point_line]") {
  const Ray<double, 3> ray = {{0, 0, 0}, {1, 2, 3}};
  CHECK(beside<double, 3>({2, 4, 6}, ray) == Beside::on);
  CHECK(beside<double, 3>({std::nextafter(2, 3), 4, 6}, ray) == Beside::aside);
  CHECK(beside<double, 3>({2, std::nextafter(4, 3), 6}, ray) == Beside::aside);
  CHECK(beside<double, 3>({2, 4, std::nextafter(6, 7)}, ray) == Beside::aside);
  const Ray<double, 3> along_z = {{0.1, 0.1, 0}, {0, 0, 1}};
  CHECK(beside<double, 3>({0.1, 0.1, 5}, along_z) == Beside::on);
  CHECK(beside<double, 3>({0.1, 0.1, -5e-324}, along_z) == Beside::before);
}

TEST_CASE("point and line: the events tell the signs", "[point_line]") {
  Record<point_line::Event> record;
  beside<double, 2>({3, 0}, Ray<double, 2>{{0, 0}, {1, 0}, {0, 2}}, record);
  std::vector<point_line::Event> told;
  for (const point_line::Event& event : record.events)
    if (!std::holds_alternative<Fallback>(event)) told.push_back(event);
  REQUIRE(told.size() == 2);
  CHECK(std::get<point_line::Side>(told[0]).sign == 0);
  CHECK(std::get<point_line::Along>(told[1]).from_hi == 1);
}

TEMPLATE_TEST_CASE_SIG("point and line: every verdict is that of rational arithmetic", "[point_line]",
                       FLOATS_AND_DIMENSIONS) {
  std::array<int, 6> seen = {};
  for (const Numbers numbers : bench::all_numbers_and_ends) {
    Random random(tests::seed() + static_cast<int>(numbers));
    for (int i = 0; i < tests::cases(2000, 200000); ++i) {
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      const Case<S, N> c = draw<S, N>(random, numbers);
      if (!finite(c.point) || !finite(c.ray)) continue;
      const Beside where = beside(c.point, c.ray);
      REQUIRE(where ==
              truth<S, N>(c.point, c.ray.origin, oracle::rational(c.ray.direction), cast<double>(c.ray.range)));
      ++seen[static_cast<std::size_t>(where)];
      Record<point_line::Event> record;
      REQUIRE(beside(c.point, c.ray, record) == where);

      const Segment<S, N> segment = {c.ray.origin, random.one_in(4) ? c.point : bench::vector<S, N>(random, numbers)};
      using oracle::operator-;
      REQUIRE(beside(c.point, segment) ==
              truth<S, N>(c.point, segment.p, oracle::rational(segment.q) - oracle::rational(segment.p), {0, 1}));
    }
  }
  for (const Beside where : {Beside::on, Beside::before, Beside::beyond})
    CHECK(seen[static_cast<std::size_t>(where)] > 100);
  CHECK(seen[static_cast<std::size_t>(N == 2 ? Beside::left : Beside::aside)] > 1000);
  if (N == 2) CHECK(seen[static_cast<std::size_t>(Beside::right)] > 1000);
}

}  // namespace point_line_test
