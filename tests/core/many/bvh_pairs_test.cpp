#include <isect/many/bvh_pairs.h>

#include <set>

#include "tests/catch.h"
#include "tests/core/box_families.h"
#include "tests/settings.h"

namespace bvh_pairs_test {
using namespace isect;
using bench::Random;

namespace {

using Pairs = std::vector<IndexPair>;

Pairs sorted(Pairs pairs) {
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

template <class S, int N>
Pairs brute_force(const std::vector<Aabb<S, N>>& boxes) {
  Pairs pairs;
  for (int i = 0; i < static_cast<int>(boxes.size()); ++i)
    for (int j = i + 1; j < static_cast<int>(boxes.size()); ++j)
      if (intersects(boxes[i], boxes[j])) pairs.push_back({i, j});
  return pairs;
}
template <class S, int N>
Pairs brute_force(const std::vector<Aabb<S, N>>& a, const std::vector<Aabb<S, N>>& b) {
  Pairs pairs;
  for (int i = 0; i < static_cast<int>(a.size()); ++i)
    for (int j = 0; j < static_cast<int>(b.size()); ++j)
      if (intersects(a[i], b[j])) pairs.push_back({i, j});
  return pairs;
}

template <class S, int N>
std::vector<Aabb<S, N>> draw(Random& random) {
  const auto layout = tests::all_layouts[random.below(static_cast<int>(std::size(tests::all_layouts)))];
  const auto numbers = bench::all_numbers[random.below(static_cast<int>(std::size(bench::all_numbers)))];
  const int count = random.one_in(5) ? random.below(6) : random.below(120);
  auto boxes = random.one_in(3) ? tests::some_boxes<S, N>(random, numbers, count)
                                : tests::some_boxes<S, N>(random, layout, count);
  if (random.one_in(4)) tests::spoil(random, boxes, 6);
  return boxes;
}

/// The unit cells of a row: neighbours touch.
template <class S, int N>
std::vector<Aabb<S, N>> cells(int count, int from = 0) {
  std::vector<Aabb<S, N>> boxes;
  for (int i = from; i < from + count; ++i) {
    Aabb<S, N> box = {Point<S, N>::Zero(), Point<S, N>::Ones()};
    box.lo[0] = static_cast<S>(i), box.hi[0] = static_cast<S>(i + 1);
    boxes.push_back(box);
  }
  return boxes;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("no boxes and one box make no pairs", "[bvh_pairs]", ((class S, int N), S, N), (float, 2),
                       (float, 3), (double, 2), (double, 3)) {
  const std::vector<Aabb<S, N>> none, one = cells<S, N>(1);
  CHECK(overlapping_pairs(build_bvh(none), none).empty());
  CHECK(overlapping_pairs(build_bvh(one), one).empty());
  CHECK(overlapping_pairs(build_bvh(none), none, build_bvh(one), one).empty());
  CHECK(overlapping_pairs(build_bvh(one), one, build_bvh(none), none).empty());
  CHECK(overlapping_pairs(build_bvh(one), one, build_bvh(one), one) == Pairs{{0, 0}});
}

TEMPLATE_TEST_CASE_SIG("the cells of a row touch their neighbours", "[bvh_pairs]", ((class S, int N), S, N), (float, 2),
                       (float, 3), (double, 2), (double, 3)) {
  const auto boxes = cells<S, N>(100), later = cells<S, N>(10, 100);
  const Bvh<S, N> tree = build_bvh(boxes), other = build_bvh(later);
  Pairs neighbours;
  for (int i = 0; i < 99; ++i) neighbours.push_back({i, i + 1});
  CHECK(sorted(overlapping_pairs(tree, boxes)) == neighbours);
  CHECK(overlapping_pairs(tree, boxes, other, later) == Pairs{{99, 0}});
  CHECK(overlapping_pairs(other, later, tree, boxes) == Pairs{{0, 99}});
}

TEMPLATE_TEST_CASE_SIG("equal boxes make all pairs", "[bvh_pairs]", ((class S, int N), S, N), (float, 2), (float, 3),
                       (double, 2), (double, 3)) {
  const std::vector<Aabb<S, N>> boxes(50, {Point<S, N>::Zero(), Point<S, N>::Zero()});
  CHECK(overlapping_pairs(build_bvh(boxes), boxes).size() == 50 * 49 / 2);
  CHECK(overlapping_pairs(build_bvh(boxes), boxes, build_bvh(boxes), boxes).size() == 50 * 50);
}

TEST_CASE("a listener hears every visit, prune and test", "[bvh_pairs]") {
  const auto boxes = cells<double, 2>(4), far = cells<double, 2>(4, 100);
  const Bvh<double, 2> tree = build_bvh(boxes, {1}), other = build_bvh(far, {1});
  bvh_pairs::Counts apart, self;
  report_pairs(
      tree, boxes, other, far, [](int, int) {}, apart);
  CHECK(apart.pruned == 1);
  CHECK(apart.visited == 0);
  CHECK(apart.tested == 0);
  report_pairs(
      tree, boxes, [](int, int) {}, self);
  CHECK(self.tested == 3);
  Record<bvh_pairs::Event> record;
  report_pairs(
      tree, boxes, other, far, [](int, int) {}, record);
  REQUIRE(record.events.size() == 1);
  CHECK(std::get<bvh_pairs::Pruned>(record.events[0]).a == 0);
}

TEST_CASE("far fewer tests than all pairs find few pairs among many boxes", "[bvh_pairs]") {
  Random random(tests::seed());
  auto boxes = tests::some_boxes<double, 3>(random, tests::Layout::uniform, 4000);
  for (auto& box : boxes) box.hi = box.lo + (box.hi - box.lo) / 2;
  bvh_pairs::Counts counts;
  report_pairs(
      build_bvh(boxes), boxes, [](int, int) {}, counts);
  CHECK(counts.visited + counts.pruned + counts.tested < 4000 * 3999 / 2 / 20);
}

TEMPLATE_TEST_CASE_SIG("the pairs are those of brute force, each once", "[bvh_pairs]", ((class S, int N), S, N),
                       (float, 2), (float, 3), (double, 2), (double, 3)) {
  Random random(tests::seed());
  long self = 0, between = 0, none = 0;
  for (int round = 0; round < tests::cases(150, 15'000); ++round) {
    const auto a = draw<S, N>(random), b = draw<S, N>(random);
    INFO("seed " << tests::seed() << ", round " << round << ", " << a.size() << " and " << b.size() << " boxes");
    const BvhOptions options = {random.integer(1, 5), 1};
    const Bvh<S, N> first = build_bvh(a, options), second = build_bvh(b, options);
    const Pairs own = overlapping_pairs(first, a), cross = overlapping_pairs(first, a, second, b);
    REQUIRE(sorted(own) == brute_force(a));
    REQUIRE(sorted(cross) == brute_force(a, b));
    self += static_cast<long>(own.size()), between += static_cast<long>(cross.size());
    none += cross.empty();

    Pairs turned = overlapping_pairs(second, b, first, a);
    for (auto& [i, j] : turned) std::swap(i, j);
    REQUIRE(sorted(turned) == sorted(cross));

    Pairs heard;
    Record<bvh_pairs::Event> record;
    report_pairs(
        first, a,
        [&](int i, int j) {
          heard.push_back({i, j});
        },
        record);
    REQUIRE(heard == own);
    Pairs met;
    for (const auto& event : record.events)
      if (const auto* tested = std::get_if<bvh_pairs::Tested>(&event); tested && tested->meet)
        met.push_back({std::min(tested->i, tested->j), std::max(tested->i, tested->j)});
    REQUIRE(met == own);
  }
  CHECK(self > 1000);
  CHECK(between > 1000);
  CHECK(none > 3);
}

}  // namespace bvh_pairs_test
