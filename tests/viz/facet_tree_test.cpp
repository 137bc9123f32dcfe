// Facets found by a hierarchy are those found by asking all.

#include "viz/compose/facet_tree.h"

#include <algorithm>
#include <array>
#include <memory>
#include <numbers>
#include <random>

#include "tests/catch.h"
#include "viz/compose/locate_point.h"
#include "viz/compose/visibility.h"

namespace facet_tree_test {
using namespace isect::viz;

namespace {

/// A torus of 2 n^2 facets.
Mesh torus(int n) {
  Mesh mesh;
  const auto angle = [n](int i) { return 2 * std::numbers::pi * i / n; };
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k) {
      const double out = 2 + 0.7 * std::cos(angle(k));
      mesh.vertices.emplace_back(out * std::cos(angle(i)), 0.7 * std::sin(angle(k)), out * std::sin(angle(i)));
      const int next = (i + 1) % n, up = (k + 1) % n;
      mesh.triangles.push_back({i * n + k, i * n + up, next * n + up});
      mesh.triangles.push_back({i * n + k, next * n + up, next * n + k});
    }
  return mesh;
}

std::array<Vec2, 3> seen(const Mesh& mesh, const std::array<int, 3>& t, const View& view) {
  return {view.project(mesh.vertices[t[0]]).at, view.project(mesh.vertices[t[1]]).at,
          view.project(mesh.vertices[t[2]]).at};
}

/// The facets on both sides of the segment, within its rectangle: all are asked.
std::vector<int> across(const Mesh& mesh, const View& view, const Vec3& from, const Vec3& to) {
  const Vec2 p = view.project(from).at, q = view.project(to).at, lo = p.cwiseMin(q), hi = p.cwiseMax(q);
  const auto side = [&](const Vec2& x) { return (q - p).x() * (x - p).y() - (q - p).y() * (x - p).x(); };
  std::vector<int> found;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const std::array<Vec2, 3> x = seen(mesh, mesh.triangles[i], view);
    const Vec2 least = x[0].cwiseMin(x[1]).cwiseMin(x[2]), most = x[0].cwiseMax(x[1]).cwiseMax(x[2]);
    if ((most.array() < lo.array()).any() || (hi.array() < least.array()).any()) continue;
    const auto [left, right] = std::minmax({side(x[0]), side(x[1]), side(x[2])});
    if (left <= 0 && right >= 0) found.push_back(static_cast<int>(i));
  }
  return found;
}

/// Orthographic, from afar in perspective, and with the eye within the mesh.
std::vector<View> views() {
  std::vector<View> all;
  for (const double half_height : {3.0, 0.3})
    for (const bool perspective : {false, true}) {
      Camera camera;
      camera.half_height = half_height, camera.perspective = perspective;
      all.emplace_back(camera, 800, 600);
    }
  return all;
}

}  // namespace

TEST_CASE("of a mesh of 20,000 facets few are asked whether they may hide a line, and none is missed", "[facet_tree]") {
  const Mesh mesh = torus(100);
  REQUIRE(mesh.triangles.size() == 20'000);
  const SortedMesh sorted = {&mesh, facet_tree(mesh)};
  std::mt19937 random(16);
  std::uniform_real_distribution<double> anywhere(-3, 3);
  const auto point = [&] {
    const double x = anywhere(random), y = anywhere(random), z = anywhere(random);
    return Vec3(x, y, z);
  };
  for (const View& view : views()) {
    const bool perspective = view.camera().perspective;
    CAPTURE(perspective, view.camera().half_height);
    constexpr int lines = 24;
    long boxes = 0, asked = 0, found = 0;
    for (int i = 0; i < lines; ++i) {
      const Vec3 from = point(), to = i % 2 ? point() : Vec3(from + point() / 30);
      const FacetsFound some = facets_across(sorted, view, from, to);
      CHECK(some.facets == across(mesh, view, from, to));
      boxes += some.boxes, asked += some.asked, found += static_cast<long>(some.facets.size());
    }
    if (view.camera().half_height < 1)
      continue;  // the eye is within the mesh, or the lines lead far out of the picture
    CHECK(found > 0);
    CHECK(asked < lines * 20'000 / 8);
    CHECK(boxes < lines * 20'000 / 8);
  }

  // A line through vertices, whose facets it only touches
  const View view = views().front();
  const Vec3 &vertex = mesh.vertices[0], &other = mesh.vertices[5 * 100 + 5];
  CHECK(facets_across(sorted, view, vertex, other).facets == across(mesh, view, vertex, other));
  CHECK(facets_across(sorted, view, vertex, vertex).facets == across(mesh, view, vertex, vertex));

  long boxes = 0, asked = 0;
  int covered = 0;
  for (int i = 0; i < 40; ++i) {
    const Vec2 place = view.project(point()).at;
    const FacetsFound over = facet_over(sorted, view, place);
    const bool any = std::ranges::any_of(mesh.triangles, [&](const std::array<int, 3>& t) {
      const std::array<Vec2, 3> x = seen(mesh, t, view);
      return locate(x[0], x[1], x[2], place) == isect::Location::in;
    });
    CHECK(over.facets.empty() != any);
    covered += any, boxes += over.boxes, asked += over.asked;
  }
  CHECK((covered > 0 && covered < 40));
  CHECK((boxes < 40 * 500 && asked < 40 * 500));
}

TEST_CASE("behind thousands of facets the stretches of a line are hidden as their points are", "[facet_tree]") {
  const Mesh mesh = torus(40);
  Occluders all;
  for (const auto& [a, b, c] : mesh.triangles)
    all.screens.push_back({{{mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]}}});
  int hidden_ones = 0, seen_ones = 0;
  for (const View& view : views())
    for (const auto& [from, to] : {std::pair{Vec3(-3, -0.37, 0.21), Vec3(3, 0.43, -1.13)},
                                   {Vec3(-1.9, 0.9, -2.7), Vec3(1.7, -0.9, 2.9)},
                                   {Vec3(0.11, -2, 0.23), Vec3(0.07, 2, -0.19)}})
      for (const Stretch& part : stretches(from, to, view, all)) {
        const Vec3 way = part.points.back() - part.points.front();
        if (way.norm() < 1e-4) continue;
        for (const double share : {0.01, 0.37, 0.99}) {
          const Vec3 p = part.points.front() + share * way;
          if (view.camera().perspective && !(view.project(p).depth > 0.01)) continue;
          CAPTURE(view.camera().perspective, view.camera().half_height, p.x(), p.y(), p.z());
          CHECK(hidden(p, view, all) == part.hidden);
        }
        ++(part.hidden ? hidden_ones : seen_ones);
      }
  CHECK(hidden_ones > 6);
  CHECK(seen_ones > 6);
}

TEST_CASE("a mesh that comes again has the same hierarchy, one that has moved another", "[facet_tree]") {
  const Mesh mesh = torus(12);
  Mesh again = mesh, moved = mesh;
  moved.vertices[7].x() += 0.25;
  const std::shared_ptr<const FacetTree> tree = facet_tree(mesh);
  CHECK(facet_tree(again) == tree);
  CHECK(facet_tree(moved) != tree);
  CHECK(facet_tree(mesh) == tree);
  Mesh turned = mesh;
  std::swap(turned.triangles[0], turned.triangles[1]);
  CHECK(facet_tree(turned) != tree);
  const std::size_t facets = 2 * 12 * 12;
  CHECK(tree->primitives.size() == facets);
}

}  // namespace facet_tree_test
