#include <isect/mesh_convex.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "bench/random.h"
#include "tests/catch.h"
#include "tests/core/cell_solids.h"
#include "tests/settings.h"

// Solids of cells: what lies in them is counted, and their distances are minima of whole numbers.

namespace mesh_convex_test {
using namespace isect;

namespace {

using bench::Random;
using tests::Cell;
using tests::Cells;

constexpr int n = 4;  // cells reach from 0 to n on each axis

struct Drawn {
  Cells cells;
  TriangleMesh<double> mesh;
};
Drawn draw(Random& random) {
  Drawn d;
  const int size = random.integer(1, 2);
  while (d.cells.empty()) d.cells = tests::random_cells(random, n / size, size, {0, 0, 0});
  d.mesh = tests::surface_of(d.cells, size, {0, 0, 0}, random);
  return d;
}

/// The box from lo to hi, which may be flat or a point, given by twice its coordinates.
struct Reach {
  std::array<int, 3> lo, hi;
};
/// Four times the square of the least distance to a cell; below, of the greatest.
int least(const Reach& r, const Cell& c) {
  int sum = 0;
  for (int i = 0; i < 3; ++i) {
    const int way = std::max({0, r.lo[i] - 2 * c[i] - 2, 2 * c[i] - r.hi[i]});
    sum += way * way;
  }
  return sum;
}
int greatest(const Reach& r, const Cell& c) {
  int sum = 0;
  for (int i = 0; i < 3; ++i) {
    const int way = std::max({0, r.lo[i] - 2 * c[i], 2 * c[i] + 2 - r.hi[i]});
    sum += way * way;
  }
  return sum;
}

/// Twice the distance to the cells, rounded.
int twice_to(const Cells& cells, const Reach& r) {
  int square = 1 << 20;
  for (const Cell& c : cells) square = std::min(square, least(r, c));
  return static_cast<int>(std::lround(std::sqrt(square)));
}

/// How the cells lie to the set of points within a radius of `r`. `twice` is twice the radius; the true one is a little
/// less if `beside` is -1, or more if it is 1.
Relation truth(const Cells& cells, const Reach& r, int twice, int beside) {
  int to_solid = 1 << 20, to_rest = 1 << 20, far = 0;
  for (int i = 0; i < 1000; ++i) {
    const Cell c = {i % 10 - 3, i / 10 % 10 - 3, i / 100 - 3};
    if (cells.contains(c))
      to_solid = std::min(to_solid, least(r, c)), far = std::max(far, greatest(r, c));
    else
      to_rest = std::min(to_rest, least(r, c));
  }
  const auto order = [&](int distance) { return distance != twice * twice ? distance - twice * twice : -beside; };
  if (order(to_solid) > 0) return Relation::disjoint;
  if (order(far) <= 0) return Relation::a_inside_b;
  if (order(to_rest) >= 0) return Relation::b_inside_a;
  return order(to_solid) == 0 ? Relation::touching : Relation::overlapping;
}

Point<double, 3> half(const std::array<int, 3>& twice) { return {twice[0] / 2., twice[1] / 2., twice[2] / 2.}; }

}  // namespace

TEST_CASE("balls and capsules lie to solids of cells as far as they are from the cells", "[mesh_convex]") {
  Random random(tests::seed());
  std::array<int, 6> seen = {};
  for (int round = 0; round < tests::cases(800, 50000); ++round) {
    const Drawn d = draw(random);
    Reach r;
    for (int i = 0; i < 3; ++i) r.lo[i] = r.hi[i] = random.integer(-1, 2 * n + 1);
    const bool ball = random.one_in(2);
    if (!ball) r.hi[random.below(3)] += random.integer(1, 4);
    int twice = random.one_in(4) ? random.integer(1, 16) : random.integer(1, 5);
    if (random.one_in(4)) twice = twice_to(d.cells, r);
    if (!ball) twice = std::max(twice, 1);
    if (ball && random.one_in(20)) twice = 0;
    const int beside = twice == 0 ? 0 : random.integer(-1, 1);
    const double radius = beside == 0 ? twice / 2. : std::nextafter(twice / 2., beside * 100.);
    const Relation expected = truth(d.cells, r, twice, beside);
    CAPTURE(round, ball, radius, r.lo, r.hi, static_cast<int>(expected));
    if (ball)
      REQUIRE(relate(d.mesh, Sphere<double, 3>{half(r.lo), radius}) == expected);
    else
      REQUIRE(relate(d.mesh, Capsule<double, 3>{half(r.lo), half(r.hi), radius}) == expected);
    ++seen[static_cast<std::size_t>(expected)];
  }
  CAPTURE(seen);
  CHECK(seen[static_cast<std::size_t>(Relation::equal)] == 0);
  for (const Relation r :
       {Relation::disjoint, Relation::a_inside_b, Relation::b_inside_a, Relation::touching, Relation::overlapping})
    CHECK(seen[static_cast<std::size_t>(r)] > 10);
}

TEST_CASE("boxes lie to solids of cells as their cells do", "[mesh_convex]") {
  Random random(tests::seed());
  std::array<int, 6> seen = {};
  for (int round = 0; round < tests::cases(800, 50000); ++round) {
    const Drawn d = draw(random);
    Cell lo, hi;
    for (int i = 0; i < 3; ++i) lo[i] = random.integer(-1, n), hi[i] = lo[i] + random.integer(1, 3);
    if (random.one_in(5)) lo = {0, 0, 0}, hi = {n, n, n};
    Cells box;
    for (int x = lo[0]; x < hi[0]; ++x)
      for (int y = lo[1]; y < hi[1]; ++y)
        for (int z = lo[2]; z < hi[2]; ++z) box.insert({x, y, z});
    const Relation expected = tests::relation(d.cells, box);
    const Aabb<double, 3> aligned = {{double(lo[0]), double(lo[1]), double(lo[2])},
                                     {double(hi[0]), double(hi[1]), double(hi[2])}};
    const Vector<double, 3> size = aligned.hi - aligned.lo;
    Obb<double, 3> oriented = {(aligned.lo + aligned.hi) / 2, Eigen::Matrix3d::Zero(), {}};
    const int turn = random.below(3);  // its axes in another order, and the halves with them
    for (int i = 0; i < 3; ++i) {
      oriented.axes((i + turn) % 3, i) = random.one_in(2) ? -1 : 1;
      oriented.half[i] = size[(i + turn) % 3] / 2;
    }
    std::vector<Point<double, 3>> corners;
    for (int i = 0; i < 8; ++i)
      corners.emplace_back(i & 1 ? hi[0] : lo[0], i & 2 ? hi[1] : lo[1], i & 4 ? hi[2] : lo[2]);
    CAPTURE(round, lo, hi, static_cast<int>(expected));
    REQUIRE(relate(d.mesh, aligned) == expected);
    REQUIRE(relate(d.mesh, oriented) == expected);
    REQUIRE(relate(d.mesh, convex_hull(corners)) == expected);
    ++seen[static_cast<std::size_t>(expected)];
  }
  for (const int count : seen) CHECK(count > 3);
}

TEST_CASE("a box between neighbouring numbers has an inside", "[mesh_convex]") {
  Random random(1);
  const TriangleMesh<double> cube = tests::surface_of({{0, 0, 0}}, 1, {0, 0, 0}, random);
  const double below = std::nextafter(1, 0), above = std::nextafter(1, 2);
  CHECK(relate(cube, Aabb<double, 3>{{below, below, below}, {1, 1, 1}}) == Relation::b_inside_a);
  CHECK(relate(cube, Aabb<double, 3>{{1, below, below}, {above, 1, 1}}) == Relation::touching);
  CHECK(relate(cube, Aabb<double, 3>{{below, below, below}, {above, 1, 1}}) == Relation::overlapping);
  TriangleMesh<double> sliver = cube;
  for (auto& v : sliver.vertices) v = Point<double, 3>(below, below, below) + v * (1 - below);
  CHECK(relate(sliver, Aabb<double, 3>{{below, below, below}, {1, 1, 1}}) == Relation::equal);
  CHECK(relate(sliver, Aabb<double, 3>{{0, 0, 0}, {1, 1, 1}}) == Relation::a_inside_b);
}

TEST_CASE("what has no point or no volume is disjoint from a solid", "[mesh_convex]") {
  Random random(1);
  const TriangleMesh<double> cube = tests::surface_of({{0, 0, 0}}, 1, {0, 0, 0}, random);
  CHECK(relate(cube, Sphere<double, 3>{{.5, .5, .5}, -1}) == Relation::disjoint);
  CHECK(relate(cube, Sphere<double, 3>{{.5, .5, NAN}, 1}) == Relation::disjoint);
  CHECK(relate(cube, Aabb<double, 3>{{1, 1, 1}, {0, 0, 0}}) == Relation::disjoint);
  CHECK(relate(TriangleMesh<double>{}, Sphere<double, 3>{{.5, .5, .5}, 1}) == Relation::disjoint);
  CHECK(relate(cube, Sphere<double, 3>{{.5, 1, .5}, 0}) == Relation::b_inside_a);
}

}  // namespace mesh_convex_test
