#include "viz/formats/facet_layers.h"

#include <algorithm>
#include <numeric>

#include "bench/random.h"
#include "tests/catch.h"
#include "viz/compose/locate_point.h"

namespace facet_layers_test {
using namespace isect::viz;
using isect::Location;

namespace {

void add(Facets& facets, const Vec2& a, const Vec2& b, const Vec2& c) {
  facets.corners.insert(facets.corners.end(), {a, b, c});
  facets.colours.push_back(hex(static_cast<unsigned>(facets.colours.size())));
}

/// The last facet in this order that holds p; -1: none.
int seen(const Facets& facets, const std::vector<int>& order, const Vec2& p) {
  int last = -1;
  for (const int i : order)
    if (const Vec2* t = &facets.corners[3 * static_cast<std::size_t>(i)]; locate(t[0], t[1], t[2], p) == Location::in)
      last = i;
  return last;
}

}  // namespace

TEST_CASE("drawn layer by layer, in whatever order within them, facets look as one after the other", "[facets]") {
  isect::bench::Random random(20261127);
  for (int round = 0; round < 40; ++round) {
    Facets facets;
    const int n = 2 + random.below(60);
    for (int i = 0; i < n; ++i) {
      const Vec2 at = random.in_box<2>(40);
      add(facets, at, at + random.in_box<2>(20), at + random.in_box<2>(20));
    }
    const std::vector<int> layer = layers(facets);
    REQUIRE(layer.size() == facets.colours.size());
    std::vector<int> painted(layer.size());
    std::iota(painted.begin(), painted.end(), 0);
    std::vector<int> by_layer(painted.rbegin(), painted.rend());  // turned round within a layer
    std::ranges::stable_sort(by_layer, {}, [&](int i) { return layer[static_cast<std::size_t>(i)]; });
    int covered = 0, wrong = 0;
    for (int k = 0; k < 500; ++k) {
      const Vec2 p = random.in_box<2>(60);
      const int above = seen(facets, painted, p);
      covered += above >= 0, wrong += above != seen(facets, by_layer, p);
    }
    CHECK(wrong == 0);
    CHECK(covered > 0);
  }
}

TEST_CASE("facets that share a side or a corner are of one layer, and one on them of the next", "[facets]") {
  Facets fan;
  for (int k = 0; k < 48; ++k) {
    const auto rim = [](int i) -> Vec2 { return {31.4 * std::cos(i * M_PI / 24), 17.3 * std::sin(i * M_PI / 24)}; };
    add(fan, {0.1, 0.3}, rim(k), rim(k + 1));
  }
  std::rotate(fan.corners.begin(), fan.corners.begin() + 3 * 7, fan.corners.end());
  CHECK(layers(fan) == std::vector<int>(48, 0));
  add(fan, {-1, -1}, {1, -1}, {0, 1});
  add(fan, {90, 90}, {91, 90}, {90, 91});
  add(fan, {2, 2}, {5, 5}, {8, 8});  // without area: it hides nothing
  const std::vector<int> layer = layers(fan);
  CHECK((layer[48] == 1 && layer[49] == 0 && layer[50] == 0));
}

TEST_CASE("whichever way facets turn, and where one lies in another, they overlap", "[facets]") {
  Facets facets;
  add(facets, {0, 0}, {20, 0}, {0, 20});
  add(facets, {2, 2}, {2, 4}, {4, 2});
  add(facets, {1, 1}, {9, 1}, {1, 9});
  add(facets, {0, 0}, {0, 20}, {20, 0});
  CHECK(layers(facets) == std::vector{0, 1, 2, 3});
}

TEST_CASE("where facets are too many each has a layer of its own", "[facets]") {
  Facets facets;
  for (std::size_t i = 0; i <= most_layered; ++i) {
    const double x = 2.0 * static_cast<double>(i);
    add(facets, {x, 0}, {x + 1, 0}, {x, 1});
  }
  CHECK(layers(facets).back() == static_cast<int>(most_layered));
  facets.corners.resize(facets.corners.size() - 3), facets.colours.pop_back();
  CHECK(layers(facets).back() == 0);
  CHECK(layers({}).empty());
}

}  // namespace facet_layers_test
