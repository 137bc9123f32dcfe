#include <isect/many/bvh.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "tests/catch.h"
#include "tests/core/box_families.h"
#include "tests/settings.h"

namespace bvh_test {
using namespace isect;
using bench::Random;

namespace {

template <class S, int N>
bool same(const Aabb<S, N>& a, const Aabb<S, N>& b) {
  return a.lo == b.lo && a.hi == b.hi;
}
template <class S, int N>
bool same(const Bvh<S, N>& a, const Bvh<S, N>& b) {
  const auto equal = [](const BvhNode<S, N>& x, const BvhNode<S, N>& y) {
    return same(x.box, y.box) && x.first == y.first && x.count == y.count;
  };
  return a.primitives == b.primitives &&
         std::equal(a.nodes.begin(), a.nodes.end(), b.nodes.begin(), b.nodes.end(), equal);
}

/// Boxes of side 1 with these lower x.
template <class S, int N>
std::vector<Aabb<S, N>> row(const std::vector<double>& starts) {
  std::vector<Aabb<S, N>> boxes;
  for (const double x : starts) {
    Aabb<S, N> box = {Point<S, N>::Zero(), Point<S, N>::Ones()};
    box.lo[0] += static_cast<S>(x), box.hi[0] += static_cast<S>(x);
    boxes.push_back(box);
  }
  return boxes;
}

/// What is wrong with a hierarchy over these boxes; nothing if it is sound.
template <class S, int N>
const char* flaw(const Bvh<S, N>& bvh, const std::vector<Aabb<S, N>>& boxes, const BvhOptions& options = {}) {
  std::vector<int> usable;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    if (finite(boxes[i]) && (boxes[i].lo.array() <= boxes[i].hi.array()).all()) usable.push_back(static_cast<int>(i));
  std::vector<int> held = bvh.primitives;
  std::sort(held.begin(), held.end());
  if (held != usable) return "not every usable primitive is there once";
  if (usable.empty()) return bvh.nodes.empty() ? nullptr : "nodes of nothing";
  if (bvh.nodes.size() > 2 * usable.size() - 1) return "too many nodes";
  if (bytes(bvh) > (2 * usable.size() - 1) * sizeof(BvhNode<S, N>) + usable.size() * sizeof(int))
    return "too much memory";

  std::vector<int> seen(bvh.nodes.size(), 0), depth(bvh.nodes.size(), 0);
  int next = 0;
  std::vector<int> stack = {0};
  while (!stack.empty()) {
    const int index = stack.back();
    const BvhNode<S, N>& node = bvh.nodes[index];
    stack.pop_back();
    if (++seen[index] > 1) return "a node with two parents";
    if (depth[index] > 71) return "too deep";
    Aabb<S, N> all;
    if (node.leaf()) {
      if (node.first != next) return "leaves overlap or leave gaps";
      next += node.count;
      if (node.count > options.largest_leaf) return "a large leaf";
      all = boxes[bvh.primitives[node.first]];
      for (int i = node.first; i < next; ++i) {
        const Aabb<S, N>& box = boxes[bvh.primitives[i]];
        all = {all.lo.cwiseMin(box.lo), all.hi.cwiseMax(box.hi)};
      }
    } else {
      const BvhNode<S, N>&a = bvh.nodes[node.first], &b = bvh.nodes[node.first + 1];
      depth[node.first] = depth[node.first + 1] = depth[index] + 1;
      all = {a.box.lo.cwiseMin(b.box.lo), a.box.hi.cwiseMax(b.box.hi)};
      stack.push_back(node.first + 1);
      stack.push_back(node.first);
    }
    if (!same(all, node.box)) return "a box that is not that of its content";
  }
  if (std::count(seen.begin(), seen.end(), 1) != static_cast<long>(seen.size())) return "a node without a parent";
  return nullptr;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("a hierarchy of nothing has no nodes", "[bvh]", ((class S, int N), S, N), (float, 2), (float, 3),
                       (double, 2), (double, 3)) {
  const Bvh<S, N> none = build_bvh(std::vector<Aabb<S, N>>());
  CHECK(none.nodes.empty());
  CHECK(statistics(none).depth == 0);
  CHECK(statistics(none).nodes == 0);
  CHECK(statistics(none).cost == 0);
}

TEMPLATE_TEST_CASE_SIG("one primitive is a leaf at the root", "[bvh]", ((class S, int N), S, N), (float, 2), (float, 3),
                       (double, 2), (double, 3)) {
  const auto boxes = row<S, N>({3});
  const Bvh<S, N> one = build_bvh(boxes);
  REQUIRE(one.nodes.size() == 1);
  CHECK(one.nodes[0].leaf());
  CHECK(same(one.nodes[0].box, boxes[0]));
  CHECK(statistics(one).cost == 1);
}

TEMPLATE_TEST_CASE_SIG("a leaf for less than one primitive holds one", "[bvh]", ((class S, int N), S, N), (float, 2),
                       (float, 3), (double, 2), (double, 3)) {
  for (const auto& boxes : {row<S, N>({3}), row<S, N>({3, 3, 3}), row<S, N>({1, 2, 5, 9})})
    for (const int least : {0, -1}) {
      const Bvh<S, N> bvh = build_bvh(boxes, {.largest_leaf = least}), one = build_bvh(boxes, {.largest_leaf = 1});
      CHECK(statistics(bvh).largest_leaf == 1);
      CHECK(bvh.primitives == one.primitives);
      CHECK(bvh.nodes.size() == one.nodes.size());
    }
}

TEMPLATE_TEST_CASE_SIG("two heaps far apart are split between them", "[bvh]", ((class S, int N), S, N), (float, 2),
                       (float, 3), (double, 2), (double, 3)) {
  const auto boxes = row<S, N>({0, 100, 1, 101, 2, 102});
  Record<bvh::Event<S>> record;
  const Bvh<S, N> tree = build_bvh(boxes, {}, record);
  const auto& split = std::get<bvh::Split<S>>(record.events.at(0));
  CHECK(split.node == 0);
  CHECK(split.axis == 0);
  CHECK(split.left == 3);
  CHECK(split.right == 3);
  CHECK(!split.median);
  CHECK(split.at > 3);
  CHECK(split.at < 100);
  CHECK(tree.primitives == std::vector<int>{0, 2, 4, 1, 3, 5});
}

TEMPLATE_TEST_CASE_SIG("primitives with equal centers are halved by index", "[bvh]", ((class S, int N), S, N),
                       (float, 2), (float, 3), (double, 2), (double, 3)) {
  const auto boxes = row<S, N>(std::vector<double>(1024, 5));
  Record<bvh::Event<S>> record;
  const Bvh<S, N> tree = build_bvh(boxes, {1}, record);
  CHECK(flaw(tree, boxes, {1}) == nullptr);
  CHECK(statistics(tree).depth == 10);
  CHECK(std::get<bvh::Split<S>>(record.events.at(0)).median);
  CHECK(std::is_sorted(tree.primitives.begin(), tree.primitives.end()));
}

TEMPLATE_TEST_CASE_SIG("what is empty, NaN or infinite is left out", "[bvh]", ((class S, int N), S, N), (float, 2),
                       (float, 3), (double, 2), (double, 3)) {
  using Limits = std::numeric_limits<S>;
  auto boxes = row<S, N>({0, 1, 2, 3, 4});
  boxes[0].lo[1] = Limits::quiet_NaN();
  boxes[1].hi[0] = Limits::infinity();
  boxes[2].lo[0] = -Limits::infinity();
  std::swap(boxes[3].lo, boxes[3].hi);
  const Bvh<S, N> tree = build_bvh(boxes);
  CHECK(tree.primitives == std::vector<int>{4});
  CHECK(flaw(tree, boxes) == nullptr);
  boxes.resize(4);
  CHECK(build_bvh(boxes).nodes.empty());
}

TEMPLATE_TEST_CASE_SIG("boxes of the largest and the least sizes are split", "[bvh]", ((class S, int N), S, N),
                       (float, 2), (float, 3), (double, 2), (double, 3)) {
  using Limits = std::numeric_limits<S>;
  std::vector<Aabb<S, N>> huge, tiny;
  for (int i = -8; i < 8; ++i) {
    const auto between = [&](S a, S b) { return Aabb<S, N>{Point<S, N>::Constant(a), Point<S, N>::Constant(b)}; };
    huge.push_back(between(Limits::max() / 8 * static_cast<S>(i), Limits::max() / 8 * static_cast<S>(i + 1)));
    tiny.push_back(between(Limits::denorm_min() * static_cast<S>(i), Limits::denorm_min() * static_cast<S>(i + 1)));
  }
  for (const auto& boxes : {huge, tiny}) {
    const Bvh<S, N> tree = build_bvh(boxes, {1});
    CHECK(flaw(tree, boxes, {1}) == nullptr);
    CHECK(statistics(tree).depth <= 5);
  }
}

TEMPLATE_TEST_CASE_SIG("centers at powers of two make no deep hierarchy", "[bvh]", ((class S, int N), S, N), (float, 2),
                       (float, 3), (double, 2), (double, 3)) {
  constexpr int most = std::numeric_limits<S>::max_exponent - 2;
  std::vector<Aabb<S, N>> boxes;
  for (int i = -most; i < most; ++i)
    for (int copy = 0; copy < 3; ++copy) {
      const Point<S, N> p = Point<S, N>::Constant(std::ldexp(S(1), i));
      boxes.push_back({p, p});
    }
  for (const int largest : {1, 4}) {
    const Bvh<S, N> tree = build_bvh(boxes, {largest});
    CHECK(flaw(tree, boxes, {largest}) == nullptr);
    CHECK(statistics(tree).depth <= 40 + 13);
    if (sizeof(S) == 8) CHECK(statistics(tree).depth > 40);
  }
}

TEMPLATE_TEST_CASE_SIG("building a hierarchy looks at O(n lg n) boxes, however they lie", "[bvh]",
                       ((class S, int N), S, N), (float, 2), (double, 3)) {
  const auto looked_at = [](const std::vector<Aabb<S, N>>& boxes) {
    Record<bvh::Event<S>> record;
    build_bvh(boxes, {1}, record);
    double count = 0;
    for (const auto& event : record.events) {
      if (const auto* split = std::get_if<bvh::Split<S>>(&event)) count += split->left + split->right;
      if (const auto* leaf = std::get_if<bvh::Leaf>(&event)) count += leaf->count;
    }
    return count;
  };
  Random random(tests::seed());
  constexpr int most = std::numeric_limits<S>::max_exponent - 2;
  for (const int n : {1000, 10'000, 100'000}) {
    std::vector<Aabb<S, N>> even, equal(n, {Point<S, N>::Zero(), Point<S, N>::Ones()}), powers;
    for (int i = 0; i < n; ++i) {
      const Point<S, N> p = random.in_box<N>(1).template cast<S>();
      even.push_back({p, p});
      const Point<S, N> q = Point<S, N>::Constant(std::ldexp(S(1), i % (2 * most) - most));
      powers.push_back({q, q});
    }
    const double levels = std::log2(n);
    INFO(n << " boxes");
    CHECK(looked_at(even) <= 2 * n * levels);
    CHECK(looked_at(equal) <= n * (2 + levels));
    CHECK(looked_at(powers) <= n * (41 + levels));
    CHECK(looked_at(powers) > n * levels);
  }
}

TEST_CASE("the statistics of a small hierarchy can be done by hand", "[bvh]") {
  const auto boxes = row<double, 2>({0, 100, 1, 101});  // 102 x 1, parts of 2 x 1
  const BvhStatistics s = statistics(build_bvh(boxes, {2, 1}));
  CHECK(s.nodes == 3);
  CHECK(s.leaves == 2);
  CHECK(s.depth == 1);
  CHECK(s.primitives == 4);
  CHECK(s.least_leaf == 2);
  CHECK(s.largest_leaf == 2);
  CHECK(s.cost == Approx(1 + 4 * 3.0 / 103));
  CHECK(s.bytes == 3 * sizeof(BvhNode<double, 2>) + 4 * sizeof(int));
}

TEST_CASE("a node takes the bytes that are stated", "[bvh]") {
  CHECK(sizeof(BvhNode<double, 3>) == 56);
  CHECK(sizeof(BvhNode<float, 3>) == 32);
}

TEST_CASE("a cheap visit splits smaller leaves than a dear one", "[bvh]") {
  Random random(tests::seed());
  const auto boxes = tests::some_boxes<double, 3>(random, tests::Layout::uniform, 1000);
  const auto leaves = [&](double visit) { return statistics(build_bvh(boxes, {8, visit})).leaves; };
  CHECK(leaves(0.1) > leaves(1));
  CHECK(leaves(1) > leaves(10));
}

TEMPLATE_TEST_CASE_SIG("every hierarchy is sound, the same each time, and told as it was built", "[bvh]",
                       ((class S, int N), S, N), (float, 2), (float, 3), (double, 2), (double, 3)) {
  Random random(tests::seed());
  for (int round = 0; round < tests::cases(40, 4000); ++round) {
    const bool by_layout = random.one_in(2);
    const auto layout = tests::all_layouts[random.below(static_cast<int>(std::size(tests::all_layouts)))];
    const auto numbers = bench::all_numbers[random.below(static_cast<int>(std::size(bench::all_numbers)))];
    const int count = random.one_in(4) ? random.below(8) : random.below(400);
    INFO("seed " << tests::seed() << ", round " << round << ", by layout " << by_layout << " " << int(layout)
                 << ", numbers " << int(numbers) << ", " << count << " boxes");
    auto boxes =
        by_layout ? tests::some_boxes<S, N>(random, layout, count) : tests::some_boxes<S, N>(random, numbers, count);
    if (random.one_in(3)) tests::spoil(random, boxes, 5);
    const BvhOptions options = {random.integer(1, 6), random.uniform(0, 3)};

    Record<bvh::Event<S>> record;
    const Bvh<S, N> tree = build_bvh(boxes, options, record);
    const char* wrong = flaw(tree, boxes, options);
    INFO((wrong ? wrong : "sound"));
    REQUIRE(wrong == nullptr);
    REQUIRE(same(tree, build_bvh(boxes, options)));
    REQUIRE(record.events.size() == tree.nodes.size());
    for (const auto& event : record.events) {
      if (const auto* leaf = std::get_if<bvh::Leaf>(&event)) {
        REQUIRE(tree.nodes[leaf->node].first == leaf->first);
        REQUIRE(tree.nodes[leaf->node].count == leaf->count);
      } else {
        const auto& split = std::get<bvh::Split<S>>(event);
        REQUIRE(!tree.nodes[split.node].leaf());
        REQUIRE(split.left > 0);
        REQUIRE(split.right > 0);
        REQUIRE(tree.nodes[split.node].box.along(split.axis).contains(split.at));
      }
    }
  }
}

TEST_CASE("what a split sends left has its center there, what it sends right as well", "[bvh]") {
  Random random(tests::seed());
  const auto boxes = tests::some_boxes<double, 3>(random, tests::Layout::uniform, 500);
  Record<bvh::Event<double>> record;
  const Bvh<double, 3> tree = build_bvh(boxes, {1}, record);
  for (const auto& event : record.events) {
    const auto* split = std::get_if<bvh::Split<double>>(&event);
    if (!split) continue;
    for (const int side : {0, 1}) {
      std::vector<int> below = {tree.nodes[split->node].first + side}, held;
      while (!below.empty()) {
        const BvhNode<double, 3> node = tree.nodes[below.back()];
        below.pop_back();
        if (!node.leaf()) below.insert(below.end(), {node.first, node.first + 1});
        for (int i = node.first; i < node.first + node.count; ++i) held.push_back(tree.primitives[i]);
      }
      REQUIRE(static_cast<int>(held.size()) == (side == 0 ? split->left : split->right));
      for (const int i : held) {
        const double center = (boxes[i].lo[split->axis] + boxes[i].hi[split->axis]) / 2;
        REQUIRE((side == 0 ? split->at - center : center - split->at) >= -1e-12);
      }
    }
  }
}

TEMPLATE_TEST_CASE_SIG("boxes in another scale by a power of two make the same hierarchy", "[bvh]",
                       ((class S, int N), S, N), (float, 2), (float, 3), (double, 2), (double, 3)) {
  Random random(tests::seed());
  for (const auto layout : tests::all_layouts) {
    if (layout == tests::Layout::tailed) continue;  // near the ends of the range, scaling rounds
    const auto boxes = tests::some_boxes<S, N>(random, layout, 300);
    auto scaled = boxes;
    for (auto& box : scaled) box.lo *= S(1024), box.hi *= S(1024);
    const Bvh<S, N> a = build_bvh(boxes), b = build_bvh(scaled);
    CHECK(a.primitives == b.primitives);
    CHECK(a.nodes.size() == b.nodes.size());
  }
}

TEST_CASE("a million boxes make a hierarchy within the stated memory", "[bvh]") {
  Random random(tests::seed());
  const int count = tests::cases(30'000, 1'000'000);
  for (const auto layout : {tests::Layout::uniform, tests::Layout::duplicate, tests::Layout::tailed}) {
    const auto boxes = tests::some_boxes<float, 3>(random, layout, count);
    const Bvh<float, 3> tree = build_bvh(boxes);
    CHECK(flaw(tree, boxes) == nullptr);
    CHECK(bytes(tree) <= 68u * boxes.size());
  }
}

}  // namespace bvh_test
