#include <isect/methods/clip_segment.h>

#include <cmath>
#include <limits>

#include <isect/counted.h>
#include "bench/random.h"
#include "tests/catch.h"
#include "tests/settings.h"

namespace clip_segment_methods_test {
using namespace isect;
using bench::Random;

TEMPLATE_TEST_CASE_SIG("on a grid Liang and Barsky's range is the exact one", "[clip_segment_methods][random]",
                       FLOATS_AND_DIMENSIONS) {
  using clip_segment::LiangBarskyEvent;
  Random random(tests::seed());
  int kept = 0, lost = 0, trivial = 0, parallel = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto number = [&] { return static_cast<S>(random.integer(-4, 4)); };
    Segment<S, N> s;
    Aabb<S, N> box;
    for (int k = 0; k < N; ++k) s.p[k] = number(), s.q[k] = number(), box.lo[k] = S(-2), box.hi[k] = S(1);
    Record<LiangBarskyEvent<S>> record;
    const auto naive = clip_segment::liang_barsky(s, box, record), exact = clip(s, box);
    INFO("seed " << tests::seed() << ", case " << i);
    REQUIRE(naive.has_value() == exact.has_value());  // equal quotients of small integers round alike
    REQUIRE(naive == clip_segment::liang_barsky(s, box));
    (naive ? kept : lost) += 1;
    trivial += record.events.size() == 1;
    for (const auto& event : record.events)
      if (const auto* e = std::get_if<clip_segment::Narrowed<S>>(&event)) parallel += e->heading == 0;
    if (!naive) continue;
    REQUIRE(std::abs(naive->lo - exact->lo) <= std::numeric_limits<S>::epsilon());
    REQUIRE(std::abs(naive->hi - exact->hi) <= std::numeric_limits<S>::epsilon());
  }
  for (const int often : {kept, lost, trivial, parallel}) CHECK(often > 1000);
}

TEST_CASE("Liang and Barsky's method counts its operations, and rounding may decide it", "[clip_segment_methods]") {
  using C = Counted<double>;
  const Aabb<double, 2> box = {{-2, -1}, {2, 1}};
  const auto counted = [&](const Segment<double, 2>& s) {
    tally() = {};
    clip_segment::liang_barsky(cast<C>(s), cast<C>(box));
    return tally();
  };
  CHECK(counted({{-1, 0}, {1, 1}}).div == 0);
  CHECK(counted({{-3, 0}, {-3, 1}}).div == 0);
  CHECK(counted({{-3, 0}, {3, 0.5}}).div == 4);
  // through the corner (2, 1) for certain, but 0.1, 0.7 and their like are rounded
  int wrong = 0;
  for (int i = 1; i < 40; ++i)
    for (int j = 1; j < 40; ++j) {
      const double x = 0.1 * i, y = 0.7 * j;
      const Segment<double, 2> s = {{2 - x, 1 + y}, {2 + 3 * x, 1 - 3 * y}};
      wrong += clip_segment::liang_barsky(s, box).has_value() != clip(s, box).has_value();
    }
  CHECK(wrong > 0);
}

}  // namespace clip_segment_methods_test
