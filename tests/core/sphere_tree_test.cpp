#include <isect/sphere_tree.h>

#include <limits>

#include "bench/random_rays.h"
#include "bench/rational.h"
#include "tests/catch.h"
#include "tests/settings.h"

namespace sphere_tree_test {
using namespace isect;
using bench::Random;
using oracle::Rational;

namespace {

using Pairs = std::vector<IndexPair>;

template <class T>
std::vector<T> sorted(std::vector<T> all) {
  std::sort(all.begin(), all.end());
  return all;
}

template <class S, int N>
std::vector<Sphere<S, N>> draw(Random& random, bench::Numbers numbers, int count) {
  std::vector<Sphere<S, N>> spheres;
  for (int i = 0; i < count; ++i) {
    const S radius = std::abs(bench::number<S>(random, numbers));
    spheres.push_back({bench::vector<S, N>(random, numbers), random.one_in(2) ? radius : radius / 16});
    if (random.one_in(8)) spheres.back() = spheres[random.below(i + 1)];
    if (random.one_in(30)) spheres.back().radius = random.one_in(2) ? S(-1) : std::numeric_limits<S>::quiet_NaN();
    if (random.one_in(40)) spheres.back().center[0] = std::numeric_limits<S>::infinity();
  }
  return spheres;
}

/// |centers| + r <= R, squared.
template <class S, int N>
bool contains(const Sphere<S, N>& outer, const Sphere<S, N>& inner) {
  if (std::isinf(outer.radius)) return true;
  const Rational rest = Rational(outer.radius) - Rational(inner.radius);
  Rational distance2 = 0;
  for (int i = 0; i < N; ++i) {
    const Rational difference = Rational(outer.center[i]) - Rational(inner.center[i]);
    distance2 += difference * difference;
  }
  return rest >= 0 && distance2 <= rest * rest;
}

template <class S, int N>
Sphere<S, N> ball(double x, double radius) {
  Sphere<S, N> sphere = {Point<S, N>::Zero(), static_cast<S>(radius)};
  sphere.center[0] = static_cast<S>(x);
  return sphere;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("no spheres make no nodes, and one is the root", "[sphere_tree]", ((class S, int N), S, N),
                       (float, 2), (float, 3), (double, 2), (double, 3)) {
  const std::vector<Sphere<S, N>> none;
  CHECK(build_sphere_tree(none).nodes.empty());
  CHECK(overlapping_pairs(build_sphere_tree(none)).empty());
  const Ray<S, N> ray = {Point<S, N>::Zero(), Vector<S, N>::Ones()};
  CHECK(hits(build_sphere_tree(none), ray).empty());
  const SphereTree<S, N> one = build_sphere_tree(std::vector{ball<S, N>(0, 1)});
  REQUIRE(one.nodes.size() == 1);
  CHECK(one.nodes[0].leaf());
  CHECK(hits(one, ray) == std::vector<int>{0});
}

TEMPLATE_TEST_CASE_SIG("the sphere around two just holds both, or is the larger one", "[sphere_tree]",
                       ((class S, int N), S, N), (float, 2), (float, 3), (double, 2), (double, 3)) {
  const Sphere<S, N> both = sphere_tree::detail::around(ball<S, N>(0, 1), ball<S, N>(8, 3));
  CHECK(both.center == ball<S, N>(5, 6).center);
  CHECK(both.radius == S(6));
  CHECK(sphere_tree::detail::around(ball<S, N>(0, 9), ball<S, N>(3, 1)).radius == S(9));
  CHECK(sphere_tree::detail::around(ball<S, N>(3, 1), ball<S, N>(0, 9)).center == ball<S, N>(0, 9).center);
  const S most = std::numeric_limits<S>::max();
  CHECK(std::isinf(sphere_tree::detail::around(ball<S, N>(-1, most), ball<S, N>(1, most)).radius));
  const S least = std::numeric_limits<S>::denorm_min();
  CHECK(sphere_tree::detail::around(ball<S, N>(0, 0), Sphere<S, N>{Point<S, N>::Constant(least), S(0)}).radius <=
        4 * least);
}

TEMPLATE_TEST_CASE_SIG("a row of touching balls has the pairs of neighbours", "[sphere_tree]", ((class S, int N), S, N),
                       (float, 2), (float, 3), (double, 2), (double, 3)) {
  std::vector<Sphere<S, N>> row;
  for (int i = 0; i < 33; ++i) row.push_back(ball<S, N>(2 * i, 1));
  const SphereTree<S, N> tree = build_sphere_tree(row);
  CHECK(tree.nodes.size() == 65);
  Pairs neighbours;
  for (int i = 0; i < 32; ++i) neighbours.push_back({i, i + 1});
  CHECK(sorted(overlapping_pairs(tree)) == neighbours);

  Ray<S, N> across = {Point<S, N>::Constant(S(-5)), Vector<S, N>::Zero()};
  across.origin[0] = 31, across.direction[1] = 1;
  for (int i = 2; i < N; ++i) across.origin[i] = 0;
  CHECK(sorted(hits(tree, across)) == std::vector<int>{15, 16});  // tangent to both
}

TEST_CASE("a listener hears every visit, prune and find of a sphere tree", "[sphere_tree]") {
  std::vector<Sphere<double, 2>> row;
  for (int i = 0; i < 4; ++i) row.push_back(ball<double, 2>(10 * i, 1));
  const SphereTree<double, 2> tree = build_sphere_tree(row);
  Record<sphere_tree::Event> record;
  CHECK(hits(tree, Ray<double, 2>{{0, -5}, {0, 1}}, record) == std::vector<int>{0});
  // root, left, leaf 0 found; leaf 1 and right pruned
  CHECK(record.events.size() == 6);
  CHECK(std::get<sphere_tree::Visited>(record.events[0]).a == 0);
  CHECK(std::get<sphere_tree::Pruned>(record.events.back()).a == 2);
  record.events.clear();
  CHECK(overlapping_pairs(tree, record).empty());
  CHECK(!record.events.empty());
}

TEMPLATE_TEST_CASE_SIG("every ball of a tree contains all spheres below it, and the answers are those of brute force",
                       "[sphere_tree]", ((class S, int N), S, N), (float, 2), (float, 3), (double, 2), (double, 3)) {
  Random random(tests::seed());
  long pairs = 0, met = 0, missed = 0, infinite_balls = 0;
  for (int round = 0; round < tests::cases(50, 3000); ++round) {
    const bool to_the_end = round % 10 == 0;  // of the numbers of S
    const auto numbers = to_the_end ? bench::Numbers::huge : bench::all_numbers[round % std::size(bench::all_numbers)];
    auto spheres = draw<S, N>(random, numbers, random.below(60));
    if (to_the_end) {
      const S factor = sizeof(S) == 4 ? S(2) : static_cast<S>(0x1p28);
      for (auto& sphere : spheres) sphere = {sphere.center * factor, sphere.radius * factor};
    }
    INFO("seed " << tests::seed() << ", round " << round << ", numbers " << int(numbers));
    const SphereTree<S, N> tree = build_sphere_tree(spheres);

    std::size_t leaves = 0;
    for (const auto& node : tree.nodes) {
      leaves += node.leaf();
      infinite_balls += std::isinf(node.ball.radius);
      if (node.leaf()) continue;
      std::vector<int> below = {node.left, node.left + 1};
      while (!below.empty()) {
        const auto child = tree.nodes[below.back()];
        below.pop_back();
        if (!child.leaf()) below.insert(below.end(), {child.left, child.left + 1});
        if (!std::isinf(child.ball.radius)) REQUIRE(contains(node.ball, child.ball));
        if (std::isinf(child.ball.radius)) REQUIRE(std::isinf(node.ball.radius));
      }
    }
    REQUIRE(tree.nodes.size() == (leaves ? 2 * leaves - 1 : 0));

    Pairs truth;
    for (int i = 0; i < static_cast<int>(spheres.size()); ++i)
      for (int j = i + 1; j < static_cast<int>(spheres.size()); ++j)
        if (intersects(spheres[i], spheres[j])) truth.push_back({i, j});
    Record<sphere_tree::Event> record;
    REQUIRE(sorted(overlapping_pairs(tree)) == truth);
    REQUIRE(sorted(overlapping_pairs(tree, record)) == truth);
    pairs += static_cast<long>(truth.size());

    for (int k = 0; k < 4; ++k) {
      const Ray<S, N> ray = bench::ray<S, N>(random, numbers);
      std::vector<int> meet;
      for (int i = 0; i < static_cast<int>(spheres.size()); ++i)
        if (intersect(ray, spheres[i])) meet.push_back(i);
      REQUIRE(sorted(hits(tree, ray)) == meet);
      met += static_cast<long>(meet.size()), missed += static_cast<long>(spheres.size() - meet.size());
    }
  }
  CHECK(pairs > 1000);
  CHECK(met > 500);
  CHECK(missed > 500);
  CHECK(infinite_balls > 0);
}

TEST_CASE("a tree of n spheres is lg n deep, rounded up, wherever they lie", "[sphere_tree]") {
  Random random(bench::stream(tests::seed(), "deep"));
  INFO("seed " << tests::seed());
  for (const bench::Numbers numbers : bench::all_numbers)
    for (const int n : {1, 2, 3, 64, 65, 1000, 4097}) {
      std::vector<Sphere<double, 3>> spheres;
      while (static_cast<int>(spheres.size()) < n)
        spheres.push_back(
            {bench::vector<double, 3>(random, numbers), std::abs(bench::number<double>(random, numbers))});
      const SphereTree<double, 3> tree = build_sphere_tree(spheres);
      std::vector<int> level(tree.nodes.size(), 0);
      for (std::size_t i = 0; i < tree.nodes.size(); ++i)  // children stand behind their parents
        if (!tree.nodes[i].leaf()) level[tree.nodes[i].left] = level[tree.nodes[i].left + 1] = level[i] + 1;
      const int deepest = *std::max_element(level.begin(), level.end());
      INFO(n << " spheres, " << deepest << " levels");
      CHECK((tree.nodes.size() == 2 * spheres.size() - 1 && 1 << deepest >= n && (n == 1 || 1 << (deepest - 1) < n)));
    }
}

}  // namespace sphere_tree_test
