#include <isect/methods/segment_segment.h>

#include <isect/counted.h>
#include "bench/random.h"
#include "tests/catch.h"
#include "tests/settings.h"

namespace segment_segment_methods_test {
using namespace isect;
using bench::Random;
using segment_segment::Meeting;

TEST_CASE("parameters agree on ordinary segments", "[segment_segment_methods]") {
  Random random(tests::seed());
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    const Segment<double, 2> a = {random.in_box<2>(1), random.in_box<2>(1)},
                             b = {random.in_box<2>(1), random.in_box<2>(1)};
    INFO("seed " << tests::seed() << ", case " << i);
    const auto naive = segment_segment::parametric_naive(a, b);
    const auto exact = intersect(a, b);
    REQUIRE(naive.has_value() == (exact.relation == Meeting::cross));
    if (naive) REQUIRE((*naive - *exact.point).norm() < 1e-10);
    hits += naive.has_value();
  }
  CHECK(hits > 200);
  using C = Counted<double>;
  tally() = {};
  CHECK(segment_segment::parametric_naive<C>({{C(0), C(0)}, {C(2), C(2)}}, {{C(0), C(2)}, {C(2), C(0)}}));
  CHECK(tally().div == 2);
}

}  // namespace segment_segment_methods_test
