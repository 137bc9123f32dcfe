#include <isect/point_kdop.h>

#include "bench/rational.h"
#include "bench/simple_shapes.h"
#include "tests/catch.h"
#include "tests/core/common.h"
#include "tests/settings.h"

namespace point_kdop_test {
using namespace isect;
using namespace isect::oracle;
using tests::at, tests::inf, tests::not_a_number;

namespace {

/// |x| <= 1, |y| <= 1, |x + y| <= 1
template <class S, int N>
Kdop<S, N> hexagon() {
  const Interval<S> slab = {S(-1), S(1)};
  return {{at<S, N>(1, 0), at<S, N>(0, 1), at<S, N>(1, 1)}, {slab, slab, slab}};
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("a point lies in a k-DOP, on a face, or outside", "[point_kdop]", FLOATS_AND_DIMENSIONS) {
  const Kdop<S, N> k = hexagon<S, N>();
  CHECK(locate(at<S, N>(0, 0), k) == Location::in);
  CHECK(locate(at<S, N>(0.5, 0.5), k) == Location::on);
  CHECK(locate(at<S, N>(1, -1), k) == Location::on);
  CHECK(locate(at<S, N>(0.5, std::nextafter(S(0.5), S(1))), k) == Location::out);
  CHECK(locate(at<S, N>(0.5, std::nextafter(S(0.5), S(0))), k) == Location::in);
  CHECK(locate(at<S, N>(2, -1), k) == Location::out);
}

TEST_CASE("the last bit of a slanted projection decides", "[point_kdop]") {
  const double y = 0x1p-60;  // 1 + y rounds to 1
  const Kdop<double, 2> k = {{{1, 1}}, {{-1, 1}}};
  CHECK(locate<double, 2>({1, y}, k) == Location::out);
  CHECK(locate<double, 2>({1, -y}, k) == Location::in);
  CHECK(locate<double, 2>({1, 0}, k) == Location::on);
}

TEMPLATE_TEST_CASE_SIG("a flat slab has no interior, an inverted one no point", "[point_kdop]", FLOATS_AND_DIMENSIONS) {
  Kdop<S, N> k = hexagon<S, N>();
  k.slabs[2] = {S(0), S(-0.0)};
  CHECK(locate(at<S, N>(0.5, -0.5), k) == Location::on);
  CHECK(locate(at<S, N>(0.5, 0.25), k) == Location::out);
  k.slabs[2] = {S(1), S(-1)};
  CHECK(locate(at<S, N>(0, 0), k) == Location::out);
}

TEMPLATE_TEST_CASE_SIG("point and k-DOP: a zero normal bounds nothing, or everything", "[point_kdop]",
                       FLOATS_AND_DIMENSIONS) {
  Kdop<S, N> k = hexagon<S, N>();
  k.normals[2] = at<S, N>(0, -0.0);
  CHECK(locate(at<S, N>(0.9, 0.9), k) == Location::in);
  k.slabs[2] = {S(0), S(1)};
  CHECK(locate(at<S, N>(0.9, 0.9), k) == Location::in);
  k.slabs[2] = {S(1), S(2)};
  CHECK(locate(at<S, N>(0.9, 0.9), k) == Location::out);
  CHECK(locate(at<S, N>(0.9, 0.9), Kdop<S, N>{}) == Location::in);
}

TEMPLATE_TEST_CASE_SIG("point and k-DOP: NaN and infinite coordinates are outside", "[point_kdop]",
                       FLOATS_AND_DIMENSIONS) {
  for (const double bad : {not_a_number, inf, -inf}) {
    Kdop<S, N> k = hexagon<S, N>();
    CHECK(locate(at<S, N>(bad, 0), k) == Location::out);
    k.normals[1][0] = S(bad);
    CHECK(locate(at<S, N>(0, 0), k) == Location::out);
    k = hexagon<S, N>();
    k.slabs[0].lo = S(bad);
    CHECK(locate(at<S, N>(0, 0), k) == Location::out);
    k = hexagon<S, N>();
    k.slabs[0].hi = S(bad);
    CHECK(locate(at<S, N>(0, 0), k) == Location::out);
  }
}

TEST_CASE("the events tell each slab up to the one that shuts the point out", "[point_kdop]") {
  Record<point_kdop::Event> record;
  locate(Point<double, 2>(0.5, 2), hexagon<double, 2>(), record);
  REQUIRE(record.events.size() == 2);
  const auto& last = std::get<point_kdop::Slab>(record.events[1]);
  CHECK((last.slab == 1 && last.from_lo == 1 && last.from_hi == 1));
}

TEMPLATE_TEST_CASE_SIG("point and k-DOP: locations are those of rational arithmetic", "[point_kdop]",
                       FLOATS_AND_DIMENSIONS) {
  bench::Random random(tests::seed());
  int seen[3] = {};
  for (const bench::Numbers numbers : bench::all_numbers)
    for (int i = 0; i < tests::cases(1500, 125000); ++i) {
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      const Point<S, N> p = bench::vector<S, N>(random, numbers);
      Kdop<S, N> k;
      for (int slab = random.integer(1, 3); slab > 0; --slab) {
        const bool whole = random.one_in(2);
        k.normals.push_back(bench::vector<S, N>(random, whole ? bench::Numbers::grid : numbers));
        const double projection = k.normals.back().template cast<double>().dot(p.template cast<double>());
        const S near = bench::moved(static_cast<S>(projection), random.integer(-1, 1));
        const S other = bench::number<S>(random, numbers), third = bench::number<S>(random, numbers);
        k.slabs.push_back(random.one_in(3) ? Interval<S>{std::min(other, third), std::max(other, third)}
                                           : Interval<S>{std::min(near, other), std::max(near, other)});
      }
      if (!finite(k)) continue;

      Location truth = Location::in;
      for (std::size_t j = 0; j < k.slabs.size(); ++j) {
        const Rational at = dot(rational(k.normals[j]), rational(p)), lo = k.slabs[j].lo, hi = k.slabs[j].hi;
        if (at < lo || at > hi)
          truth = Location::out;
        else if ((at == lo || at == hi) && truth == Location::in && (k.normals[j].array() != 0).any())
          truth = Location::on;
      }
      if (locate(p, k) != truth) FAIL("wrong");

      Kdop<S, N> reordered = k;
      std::reverse(reordered.normals.begin(), reordered.normals.end());
      std::reverse(reordered.slabs.begin(), reordered.slabs.end());
      for (std::size_t j = 0; j < k.slabs.size(); ++j) {
        reordered.normals[j] = -reordered.normals[j];
        reordered.slabs[j] = {-reordered.slabs[j].hi, -reordered.slabs[j].lo};
      }
      if (locate(p, reordered) != truth) FAIL("not the same with the slabs turned around");
      ++seen[static_cast<int>(truth)];
    }
  for (const int count : seen) CHECK(count > 500);
}

}  // namespace point_kdop_test
