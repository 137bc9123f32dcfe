#include <isect/many/bvh_ray.h>

#include <limits>
#include <set>

#include "bench/random_rays.h"
#include "bench/rational.h"
#include "tests/catch.h"
#include "tests/core/box_families.h"
#include "tests/settings.h"

namespace bvh_ray_test {
using namespace isect;
using bench::Random;

namespace {

/// Primitives that are their boxes, tested exactly: the hit is where the ray enters.
template <class S, int N>
auto solid(const Ray<S, N>& ray, const std::vector<Aabb<S, N>>& boxes) {
  return [&](int i) -> std::optional<S> {
    const auto common = intersect(ray, boxes[i]);
    return common ? std::optional(common->lo) : std::nullopt;
  };
}

template <class S, int N>
std::optional<BvhHit<S>> brute_force(const Ray<S, N>& ray, const std::vector<Aabb<S, N>>& boxes) {
  std::optional<BvhHit<S>> closest;
  for (int i = 0; i < static_cast<int>(boxes.size()); ++i) {
    const auto common = intersect(ray, boxes[i]);
    if (common && (!closest || common->lo < closest->t)) closest = BvhHit<S>{common->lo, i};
  }
  return closest;
}

/// A ray from anywhere, or aimed at a corner, an edge, a face or the inside of one of the boxes; some along an axis.
template <class S, int N>
Ray<S, N> aimed(Random& random, const std::vector<Aabb<S, N>>& boxes, bench::Numbers numbers) {
  Ray<S, N> ray = bench::ray<S, N>(random, numbers);
  if (boxes.empty()) return ray;
  const auto some = [&]() -> const Aabb<S, N>& { return boxes[random.below(static_cast<int>(boxes.size()))]; };
  const auto inside = [&](const Aabb<S, N>& box) {
    Point<S, N> p;
    for (int i = 0; i < N; ++i) {
      const S lo = box.lo[i], hi = box.hi[i];
      p[i] = random.one_in(3) ? lo / 2 + hi / 2 : random.one_in(2) ? lo : hi;
    }
    return p;
  };
  if (random.one_in(3)) ray.origin = inside(some());
  if (random.one_in(4)) return ray;
  const Vector<S, N> d = inside(some()) - ray.origin;
  if (finite(d)) ray.direction = random.one_in(3) ? Vector<S, N>(d / 3) : d;
  for (int i = 0; i < N; ++i)
    if (random.one_in(8)) ray.direction[i] = random.one_in(2) ? S(0) : -S(0);
  if (random.one_in(4)) ray.range = {ray.range.lo, std::max(ray.range.lo, S(1))};
  return ray;
}

/// The boxes and the rays of one random round.
template <class S, int N>
struct Round {
  std::vector<Aabb<S, N>> boxes;
  Bvh<S, N> tree;
  bench::Numbers numbers;
};
template <class S, int N>
Round<S, N> draw(Random& random) {
  Round<S, N> round;
  round.numbers = bench::all_numbers[random.below(static_cast<int>(std::size(bench::all_numbers)))];
  const auto layout = tests::all_layouts[random.below(static_cast<int>(std::size(tests::all_layouts)))];
  const int count = random.one_in(5) ? random.below(6) : random.below(200);
  const bool by_numbers = random.one_in(2);
  round.boxes = by_numbers ? tests::some_boxes<S, N>(random, round.numbers, count)
                           : tests::some_boxes<S, N>(random, layout, count);
  if (!by_numbers) round.numbers = bench::Numbers::grid;
  if (random.one_in(4)) tests::spoil(random, round.boxes, 6);
  round.tree = build_bvh(round.boxes, {random.integer(1, 4), 1});
  return round;
}

template <class S>
Ray<S, 2> along_x(double y) {
  return {{S(-10), static_cast<S>(y)}, {S(2), S(0)}};
}
template <class S>
std::vector<Aabb<S, 2>> three() {
  return {{{S(4), S(0)}, {S(5), S(1)}}, {{S(0), S(0)}, {S(1), S(1)}}, {{S(8), S(0)}, {S(9), S(1)}}};
}

}  // namespace

TEMPLATE_TEST_CASE("a ray hits the nearest of three boxes", "[bvh_ray]", float, double) {
  using S = TestType;
  const auto boxes = three<S>();
  const Bvh<S, 2> tree = build_bvh(boxes);
  const Ray<S, 2> ray = along_x<S>(0.5);
  CHECK(closest_hit(tree, ray, solid(ray, boxes)) == BvhHit<S>{S(5), 1});
  CHECK(any_hit(tree, ray, solid(ray, boxes)));
}
TEMPLATE_TEST_CASE("a ray that grazes the boxes hits, and one beside them misses", "[bvh_ray]", float, double) {
  using S = TestType;
  const auto boxes = three<S>();
  const Bvh<S, 2> tree = build_bvh(boxes);
  const Ray<S, 2> graze = along_x<S>(1), miss = along_x<S>(1.25);
  CHECK(closest_hit(tree, graze, solid(graze, boxes)) == BvhHit<S>{S(5), 1});
  CHECK(!closest_hit(tree, miss, solid(miss, boxes)));
  CHECK(!any_hit(tree, miss, solid(miss, boxes)));
}
TEMPLATE_TEST_CASE("a ray from inside a box hits it at its origin", "[bvh_ray]", float, double) {
  using S = TestType;
  const auto boxes = three<S>();
  const Bvh<S, 2> tree = build_bvh(boxes);
  const Ray<S, 2> inside = {{S(4.5), S(0.5)}, {S(1), S(0)}}, behind = {{S(20), S(0.5)}, {S(1), S(0)}};
  CHECK(closest_hit(tree, inside, solid(inside, boxes)) == BvhHit<S>{S(0), 0});
  CHECK(!closest_hit(tree, behind, solid(behind, boxes)));
}
TEMPLATE_TEST_CASE("the range of a segment ends where it ends, both ends included", "[bvh_ray]", float, double) {
  using S = TestType;
  const auto boxes = three<S>();
  const Bvh<S, 2> tree = build_bvh(boxes);
  Ray<S, 2> ray = along_x<S>(0.5);
  ray.range = {S(0), S(5)};
  CHECK(closest_hit(tree, ray, solid(ray, boxes)) == BvhHit<S>{S(5), 1});
  ray.range.hi = std::nextafter(S(5), S(0));
  CHECK(!closest_hit(tree, ray, solid(ray, boxes)));
  ray.range = {S(9.5), S(100)};
  CHECK(closest_hit(tree, ray, solid(ray, boxes)) == BvhHit<S>{S(9.5), 2});
  ray.range = {S(9), S(7)};
  CHECK(!closest_hit(tree, ray, solid(ray, boxes)));
  CHECK(!any_hit(tree, ray, solid(ray, boxes)));
}
TEMPLATE_TEST_CASE("of equal hits the least index counts", "[bvh_ray]", float, double) {
  using S = TestType;
  std::vector<Aabb<S, 2>> boxes;
  for (int i = 0; i < 50; ++i) boxes.push_back({{S(0), static_cast<S>(-i)}, {S(1), static_cast<S>(i)}});
  std::reverse(boxes.begin() + 10, boxes.end());
  const Ray<S, 2> ray = along_x<S>(20);
  CHECK(closest_hit(build_bvh(boxes, {1}), ray, solid(ray, boxes)) == BvhHit<S>{S(5), 10});
}
TEMPLATE_TEST_CASE("NaN and infinite rays, zero directions and empty hierarchies have answers", "[bvh_ray]", float,
                   double) {
  using S = TestType;
  using Limits = std::numeric_limits<S>;
  const auto boxes = three<S>();
  const Bvh<S, 2> tree = build_bvh(boxes), none;
  Ray<S, 2> ray = along_x<S>(0.5);
  CHECK(!closest_hit(none, ray, solid(ray, boxes)));
  CHECK(!any_hit(none, ray, solid(ray, boxes)));
  ray.origin[1] = Limits::quiet_NaN();
  CHECK(!closest_hit(tree, ray, [](int) { return std::optional(S(0)); }));
  ray = along_x<S>(0.5), ray.direction[0] = Limits::infinity();
  CHECK(!any_hit(tree, ray, [](int) { return std::optional(S(0)); }));
  ray = along_x<S>(0.5), ray.range.lo = Limits::quiet_NaN();
  CHECK(!any_hit(tree, ray, [](int) { return std::optional(S(0)); }));

  const Ray<S, 2> point = {{S(5), S(1)}, {S(0), -S(0)}};
  CHECK(closest_hit(tree, point, solid(point, boxes)) == BvhHit<S>{S(0), 0});
}

TEST_CASE("a listener hears every visit, prune, test and new closest hit", "[bvh_ray]") {
  std::vector<Aabb<double, 2>> boxes;
  for (int i = 0; i < 8; ++i) boxes.push_back({{4.0 * i, 0}, {4.0 * i + 1, 1}});
  const Bvh<double, 2> tree = build_bvh(boxes, {1});
  const Ray<double, 2> ray = {{-1, 0.5}, {1, 0}}, steep = {{-1, 0.5}, {0.1, 1}};
  Record<bvh_ray::Event<double>> record;
  bvh_ray::Counts counts, missed;
  closest_hit(tree, ray, solid(ray, boxes), record);
  closest_hit(tree, ray, solid(ray, boxes), counts);
  closest_hit(tree, steep, solid(steep, boxes), missed);
  CHECK(counts.visited == 4);  // the way down to the first box
  CHECK(counts.farther == 3);  // the far child at each step
  CHECK(counts.missed == 0);
  CHECK(counts.tested == 1);
  CHECK(missed.missed == 1);
  CHECK(missed.visited == 0);
  CHECK(record.events.size() == 4 + 3 + 2);
  CHECK(std::get<bvh_ray::Visited<double>>(record.events[0]).entry == 1);
}

TEMPLATE_TEST_CASE_SIG("the closest hit is that of asking every primitive", "[bvh_ray]", ((class S, int N), S, N),
                       (float, 2), (float, 3), (double, 2), (double, 3)) {
  Random random(tests::seed());
  int hits = 0, misses = 0, wrong = 0;
  for (int i = 0; i < tests::cases(60, 20'000); ++i) {
    const Round<S, N> round = draw<S, N>(random);
    INFO("seed " << tests::seed() << ", round " << i);
    for (int j = 0; j < 12; ++j) {
      const Ray<S, N> ray = aimed<S, N>(random, round.boxes, round.numbers);
      const auto hit = solid(ray, round.boxes);
      const auto truth = brute_force(ray, round.boxes);
      bvh_ray::Counts counts;
      wrong += closest_hit(round.tree, ray, hit) != truth;
      wrong += closest_hit(round.tree, ray, hit, counts) != truth;
      wrong += any_hit(round.tree, ray, hit) != truth.has_value();
      wrong += counts.visited > static_cast<long>(round.tree.nodes.size());
      ++(truth ? hits : misses);
    }
    REQUIRE(wrong == 0);
  }
  CHECK(hits > 100);
  CHECK(misses > 50);
}

TEMPLATE_TEST_CASE_SIG("only what cannot hold the closest hit is pruned, and nothing is forgotten", "[bvh_ray]",
                       ((class S, int N), S, N), (float, 2), (float, 3), (double, 2), (double, 3)) {
  Random random(tests::seed());
  for (int i = 0; i < tests::cases(100, 5000); ++i) {
    const Round<S, N> round = draw<S, N>(random);
    const Ray<S, N> ray = aimed<S, N>(random, round.boxes, round.numbers);
    Record<bvh_ray::Event<S>> record;
    const auto closest = closest_hit(round.tree, ray, solid(ray, round.boxes), record);
    if (!finite(ray) || empty(ray.range)) continue;
    std::multiset<int> primitives;
    INFO("seed " << tests::seed() << ", round " << i);
    for (const auto& event : record.events) {
      if (const auto* tested = std::get_if<bvh_ray::Tested<S>>(&event)) primitives.insert(tested->primitive);
      const auto* pruned = std::get_if<bvh_ray::Pruned>(&event);
      if (!pruned) continue;
      std::vector<int> below = {pruned->node};
      while (!below.empty()) {
        const BvhNode<S, N> node = round.tree.nodes[below.back()];
        below.pop_back();
        if (!node.leaf()) below.insert(below.end(), {node.first, node.first + 1});
        for (int k = node.first; k < node.first + node.count; ++k) {
          const int primitive = round.tree.primitives[k];
          const auto t = solid(ray, round.boxes)(primitive);
          if (t) REQUIRE(closest->t < *t);
          primitives.insert(primitive);
        }
      }
    }
    REQUIRE(primitives.size() == round.tree.primitives.size());
    REQUIRE(std::set<int>(primitives.begin(), primitives.end()).size() == primitives.size());
  }
}

TEMPLATE_TEST_CASE_SIG("a box's entry says no where may_intersect does, and never comes late", "[bvh_ray]",
                       ((class S, int N), S, N), (float, 2), (float, 3), (double, 2), (double, 3)) {
  Random random(tests::seed());
  int yes = 0, no = 0;
  for (int i = 0; i < tests::cases(20'000, 1'000'000); ++i) {
    const auto numbers = bench::all_numbers[random.below(static_cast<int>(std::size(bench::all_numbers)))];
    const auto boxes = tests::some_boxes<S, N>(random, numbers, 1);
    const Ray<S, N> ray = aimed<S, N>(random, boxes, numbers);
    const auto prepared = ray_aabb::prepare(ray);
    if (!(prepared.range.lo <= prepared.range.hi)) continue;
    const auto entry = bvh_ray::detail::entry(prepared, ray.range.hi, boxes[0]);
    INFO("seed " << tests::seed() << ", case " << i);
    REQUIRE(entry.has_value() == may_intersect(ray, boxes[0]));
    const auto truth = intersect(ray, boxes[0]);
    if (truth) {
      REQUIRE(entry.has_value());
      REQUIRE(*entry <= ray.range.hi);
      if (std::isfinite(truth->lo)) REQUIRE(*entry <= bvh_ray::detail::beyond(truth->lo));
    }
    ++(entry ? yes : no);
  }
  CHECK(yes > 1000);
  CHECK(no > 1000);
}

TEMPLATE_TEST_CASE_SIG("signed permutations of the axes and powers of two change no hit", "[bvh_ray]",
                       ((class S, int N), S, N), (float, 2), (float, 3), (double, 2), (double, 3)) {
  Random random(tests::seed());
  for (int i = 0; i < tests::cases(200, 20'000); ++i) {
    const auto boxes = tests::some_boxes<S, N>(random, bench::Numbers::grid, 40);
    const Ray<S, N> ray = aimed<S, N>(random, boxes, bench::Numbers::grid);
    const auto moved_point = [&](const Vector<S, N>& p) {  // the last axis first, turned round, and twice as large
      Vector<S, N> q;
      for (int k = 0; k < N; ++k) q[(k + 1) % N] = 2 * (k == 0 ? -p[k] : p[k]);
      return q;
    };
    std::vector<Aabb<S, N>> moved_boxes;
    for (const auto& box : boxes) {
      const Point<S, N> a = moved_point(box.lo), b = moved_point(box.hi);
      moved_boxes.push_back({a.cwiseMin(b), a.cwiseMax(b)});
    }
    const Ray<S, N> turned = {moved_point(ray.origin), moved_point(ray.direction), ray.range};
    INFO("seed " << tests::seed() << ", case " << i);
    REQUIRE(closest_hit(build_bvh(boxes), ray, solid(ray, boxes)) ==
            closest_hit(build_bvh(moved_boxes), turned, solid(turned, moved_boxes)));
  }
}

}  // namespace bvh_ray_test
