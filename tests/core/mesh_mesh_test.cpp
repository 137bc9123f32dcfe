#include <isect/mesh_mesh.h>

#include <array>

#include <isect/convex_hull_3d.h>
#include <isect/half_spaces.h>
#include "bench/random.h"
#include "tests/catch.h"
#include "tests/core/cell_solids.h"
#include "tests/settings.h"

// Two oracles that share nothing with the header: solids of cells, whose relations are counted, and hulls, which lie as
// their half-spaces do.

namespace mesh_mesh_test {
using namespace isect;

namespace {

using bench::Random;

Relation turned_round(Relation r) {
  return r == Relation::a_inside_b ? Relation::b_inside_a : r == Relation::b_inside_a ? Relation::a_inside_b : r;
}

/// A frame of small whole numbers that keeps volumes, times a power of two.
Eigen::Matrix3d any_frame(Random& random) {
  Eigen::Matrix3d frame = Eigen::Matrix3d::Identity();
  for (int i = random.below(4); i > 0; --i) {
    Eigen::Matrix3d shear = Eigen::Matrix3d::Identity();
    const int row = random.below(3);
    shear(row, (row + random.integer(1, 2)) % 3) = random.integer(-2, 2);
    frame = shear * frame;
  }
  constexpr int powers[] = {0, 0, 0, -1070, -500, 300, 1015};
  return frame * std::ldexp(1.0, powers[random.below(7)]);
}

TriangleMesh<double> box(const Point<double, 3>& lo, const Point<double, 3>& hi) {
  Random random(1);
  TriangleMesh<double> mesh = tests::surface_of({{0, 0, 0}}, 1, {0, 0, 0}, random, true);
  for (Point<double, 3>& v : mesh.vertices) v = lo + v.cwiseProduct(hi - lo);
  return mesh;
}

TriangleMesh<double> joined(TriangleMesh<double> a, const TriangleMesh<double>& b) {
  const int first = static_cast<int>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const auto& [p, q, r] : b.triangles) a.triangles.push_back({p + first, q + first, r + first});
  return a;
}

}  // namespace

TEST_CASE("solids of cells lie as their cells tell", "[mesh_mesh]") {
  Random random(tests::seed());
  std::array<int, 6> seen = {};
  for (int round = 0; round < tests::cases(800, 50000); ++round) {
    const int size_a = random.integer(1, 3), size_b = random.integer(1, 3);
    const tests::Cell from_a = {0, 0, 0},
                      from_b = {random.integer(-2, 3), random.integer(-2, 3), random.integer(-1, 2)};
    const tests::Cells a = tests::random_cells(random, random.integer(1, 3), size_a, from_a);
    tests::Cells b = tests::random_cells(random, random.integer(1, 3), size_b, from_b);
    int size = size_b;
    tests::Cell from = from_b;
    if (random.one_in(4)) {  // nearly the same
      b = a, size = 1, from = from_a;
      for (int i = random.below(3); i > 0 && !b.empty(); --i) {
        if (random.one_in(2))
          b.erase(b.begin());
        else
          b.insert({random.integer(-1, 3), random.integer(0, 2), random.integer(0, 2)});
      }
    }
    TriangleMesh<double> mesh_a = tests::surface_of(a, size_a, from_a, random),
                         mesh_b = tests::surface_of(b, size, from, random);
    const Eigen::Matrix3d frame = any_frame(random);
    tests::move(mesh_a, frame), tests::move(mesh_b, frame);
    const Relation truth = tests::relation(a, b);
    CAPTURE(round, a.size(), b.size(), static_cast<int>(truth));
    REQUIRE(bounds_solid(mesh_a));
    REQUIRE(bounds_solid(mesh_b));
    REQUIRE(relate(mesh_a, mesh_b) == truth);
    REQUIRE(relate(mesh_b, mesh_a) == turned_round(truth));
    ++seen[static_cast<std::size_t>(truth)];
  }
  CAPTURE(seen);
  for (const int count : seen) CHECK(count > 15);
}

TEST_CASE("meshes of hulls lie as their half-spaces do", "[mesh_mesh]") {
  Random random(tests::seed());
  std::array<int, 6> seen = {};
  for (int round = 0; round < tests::cases(300, 10000); ++round) {
    const int kind = random.below(3);
    const auto coordinate = [&]() -> double {
      return kind == 0 ? random.integer(0, 3) : kind == 1 ? random.integer(0, 4) / 10. : random.uniform(0, 2);
    };
    std::vector<Point<double, 3>> a, b;
    for (int i = random.integer(4, 9); i > 0; --i) a.emplace_back(coordinate(), coordinate(), coordinate());
    for (int i = random.integer(4, 9); i > 0; --i) b.emplace_back(coordinate(), coordinate(), coordinate());
    if (random.one_in(3)) b.insert(b.end(), a.begin(), a.begin() + random.integer(1, static_cast<int>(a.size())));
    if (random.one_in(4)) b.insert(b.end(), a.begin(), a.end());
    if (random.one_in(6)) b = a;
    if (random.one_in(3))  // beside it, or on its side
      for (Point<double, 3>& p : b) p[0] += kind == 0 ? random.integer(2, 4) : random.uniform(.2, 2);
    if (random.one_in(2)) std::swap(a, b);
    const Hull3<double> hull_a = convex_hull(a), hull_b = convex_hull(b);
    if (hull_a.dimension < 3 || hull_b.dimension < 3) continue;
    const TriangleMesh<double> mesh_a = {hull_a.vertices, hull_a.triangles},
                               mesh_b = {hull_b.vertices, hull_b.triangles};
    const Relation truth = relate(half_spaces_of(hull_a), half_spaces_of(hull_b));
    CAPTURE(round, static_cast<int>(truth));
    REQUIRE(bounds_solid(mesh_a));
    REQUIRE(relate(mesh_a, mesh_b) == truth);
    ++seen[static_cast<std::size_t>(truth)];
  }
  CAPTURE(seen);
  for (const int count : seen) CHECK(count > 3);
}

TEST_CASE("a solid within a hollow one touches its wall by an ulp or not at all", "[mesh_mesh]") {
  const TriangleMesh<double> hollow = joined(box({0, 0, 0}, {9, 9, 9}), box({3, 3, 3}, {6, 6, 6}));
  REQUIRE(bounds_solid(hollow));
  const double six = std::nextafter(6, 0), above = std::nextafter(6, 7);
  CHECK(relate(hollow, box({4, 4, 4}, {5, 5, 5})) == Relation::disjoint);
  CHECK(relate(hollow, box({4, 4, 4}, {5, 5, six})) == Relation::disjoint);
  CHECK(relate(hollow, box({4, 4, 4}, {5, 5, 6})) == Relation::touching);
  CHECK(relate(hollow, box({4, 4, 4}, {5, 5, above})) == Relation::overlapping);
  CHECK(relate(hollow, box({3, 3, 3}, {6, 6, 6})) == Relation::touching);
  CHECK(relate(hollow, box({1, 1, 1}, {2, 2, 2})) == Relation::b_inside_a);
  CHECK(relate(hollow, box({1, 1, 1}, {2, 2, 3})) == Relation::b_inside_a);
  CHECK(relate(hollow, box({0, 0, 0}, {9, 9, 9})) == Relation::a_inside_b);
  CHECK(relate(hollow, box({1, 1, 1}, {8, 8, 8})) == Relation::overlapping);
  CHECK(relate(hollow, hollow) == Relation::equal);
  CHECK(relate(hollow, TriangleMesh<double>{}) == Relation::disjoint);
}

TEST_CASE("an octahedron in a box meets it in single points", "[mesh_mesh]") {
  TriangleMesh<double> inner;
  inner.vertices = {{2, 1, 1}, {0, 1, 1}, {1, 2, 1}, {1, 0, 1}, {1, 1, 2}, {1, 1, 0}};
  for (const int z : {4, 5})
    for (const auto& [x, y] : {std::pair{0, 2}, {2, 1}, {1, 3}, {3, 0}}) inner.triangles.push_back({x, y, z});
  REQUIRE(bounds_solid(inner));
  CHECK(relate(inner, box({0, 0, 0}, {2, 2, 2})) == Relation::a_inside_b);
  CHECK(relate(box({0, 0, 0}, {2, 2, 2}), inner) == Relation::b_inside_a);
  CHECK(relate(inner, box({2, 0, 0}, {4, 2, 2})) == Relation::touching);
  CHECK(relate(inner, joined(box({-3, -3, -3}, {5, 5, 5}), box({0, 0, 0}, {2, 2, 2}))) == Relation::touching);
}

TEST_CASE("a mesh that crosses itself bounds no solid", "[mesh_mesh]") {
  const TriangleMesh<double> cube = box({0, 0, 0}, {2, 2, 2});
  CHECK(bounds_solid(cube));
  CHECK(bounds_solid(joined(cube, box({3, 0, 0}, {4, 2, 2}))));
  CHECK_FALSE(bounds_solid(joined(cube, cube)));
  CHECK_FALSE(bounds_solid(joined(cube, box({1, 1, 1}, {4, 4, 4}))));
  CHECK_FALSE(bounds_solid(joined(cube, box({2, .5, .5}, {4, 1, 1}))));  // on a face of the other
  CHECK(bounds_solid(joined(cube, box({2, 2, 2}, {4, 4, 4}))));          // they share a corner
  CHECK_FALSE(bounds_solid(joined(cube, box({2, 2, 1}, {4, 4, 2}))));    // half of an edge
  TriangleMesh<double> open = cube;
  open.triangles.pop_back();
  CHECK_FALSE(crosses_itself(open));
  CHECK_FALSE(bounds_solid(open));
  TriangleMesh<double> folded = {{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {.5, .5, 0}}, {{0, 1, 2}, {0, 1, 3}}};
  CHECK(crosses_itself(folded));
  folded.vertices[3] = {.5, -.5, 0};
  CHECK_FALSE(crosses_itself(folded));
  TriangleMesh<double> fan = {{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {1, 1, -1}, {1, 1, 1}}, {{0, 1, 2}, {0, 3, 4}}};
  CHECK(crosses_itself(fan));  // beyond their common corner
  fan.vertices[3] = {-1, -1, -1}, fan.vertices[4] = {-1, -1, 1};
  CHECK_FALSE(crosses_itself(fan));
}

}  // namespace mesh_mesh_test
