#include <isect/mesh_convex.h>

#include <cmath>
#include <optional>

#include "bench/cylinder_half_spaces/oracle.h"
#include "bench/random.h"
#include "tests/catch.h"
#include "tests/core/cell_solids.h"
#include "tests/settings.h"

// Half-spaces, cylinders and cones beside solids of cells: what each cell has in common with the body, by rationals,
// tells how the solid lies.

namespace mesh_half_spaces_test {
using namespace isect;

namespace {

using bench::Random;
using half_spaces::Level;
using tests::Cell;
using tests::Cells;
using P = Point<double, 3>;

constexpr int n = 3;  // cells reach from 0 to n on each axis

/// How a solid of cells (A) lies to a body (B) that reaches from lo to hi: of_cell(sides) tells how a cell (A) does.
template <class OfCell>
Relation truth(const Cells& cells, const Cell& lo, const Cell& hi, const OfCell& of_cell) {
  bool touched = false, cut = false, leaves = false;
  std::size_t held = 0;
  for (int x = lo[0] - 1; x <= hi[0]; ++x)
    for (int y = lo[1] - 1; y <= hi[1]; ++y)
      for (int z = lo[2] - 1; z <= hi[2]; ++z) {
        const Relation r = of_cell(oracle::sides(Aabb<double, 3>{P(x, y, z), P(x + 1, y + 1, z + 1)}));
        const bool inside = r != Relation::disjoint && r != Relation::touching;
        if (!cells.contains({x, y, z})) {
          leaves |= inside;
          continue;
        }
        touched |= r != Relation::disjoint, cut |= inside;
        held += r == Relation::a_inside_b || r == Relation::equal;
      }
  if (!touched) return Relation::disjoint;
  if (held == cells.size()) return leaves ? Relation::a_inside_b : Relation::equal;
  if (cut && !leaves) return Relation::b_inside_a;
  return cut ? Relation::overlapping : Relation::touching;
}

Cells some_cells(Random& random) {
  Cells cells;
  while (cells.empty()) cells = tests::random_cells(random, n, 1, {0, 0, 0});
  if (random.one_in(2)) {
    cells.clear();
    for (int i = 0; i < n * n * n; ++i) cells.insert({i % n, i / n % n, i / n / n});
    if (random.one_in(3)) cells.erase({1, 1, 1});
  }
  return cells;
}

/// A box whose faces lean, so that its corners are quotients, and a slab across it.
HalfSpaces leaning_box(Random& random) {
  HalfSpaces solid;
  const auto number = [&] { return random.integer(-1, 2 * n + 1) / 2.; };
  const P center(number(), number(), number());
  const int lean = random.one_in(3) ? 0 : 1;
  for (int i = 0; i < 3; ++i)
    for (const int side : {-1, 1}) {
      Vector<double, 3> normal;
      for (int k = 0; k < 3; ++k) normal[k] = k == i ? 3 * side : random.integer(-lean, lean);
      solid.faces.push_back({Level{normal, -normal.dot(center) + 3 * random.integer(1, 2) / 2.}});
    }
  if (random.one_in(3)) {
    const Vector<double, 3> normal(random.integer(-1, 1), random.integer(-1, 1), 1);
    solid.faces.push_back({Level{normal, 1 - normal.dot(center)}});
  }
  for (std::size_t i = solid.faces.size(); i > 1; --i)
    std::swap(solid.faces[i - 1], solid.faces[random.below(static_cast<int>(i))]);
  return solid;
}

template <class Solid>
Solid round_solid(Random& random) {
  const auto half = [&] { return random.integer(-1, 2 * n + 1) / 2.; };
  const P p(half(), half(), half());
  P q = p;
  while (q == p) {
    if (random.one_in(2))
      q[random.below(3)] += random.integer(-2, 2);
    else
      q += P(random.integer(-1, 1), random.integer(-1, 1), random.integer(-1, 1));
  }
  return {p, q, random.integer(1, 2) / 2.};
}

template <class Shape, class OfCell>
void ask(const Shape& body, Random& random, std::array<int, 6>& seen, const P& lo, const P& hi, const OfCell& of_cell) {
  const Cells cells = some_cells(random);
  const TriangleMesh<double> mesh = tests::surface_of(cells, 1, {0, 0, 0}, random);
  Cell from, to;
  for (int i = 0; i < 3; ++i) from[i] = static_cast<int>(std::floor(lo[i])), to[i] = static_cast<int>(std::ceil(hi[i]));
  const Relation expected = truth(cells, from, to, of_cell);
  CAPTURE(static_cast<int>(expected));
  REQUIRE(relate(mesh, body) == expected);
  ++seen[static_cast<std::size_t>(expected)];
}

}  // namespace

TEST_CASE("half-spaces lie to solids of cells as each cell lies to them", "[mesh_convex]") {
  Random random(tests::seed());
  std::array<int, 6> seen = {};
  for (int i = 0; i < tests::cases(80, 10000); ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    const HalfSpaces body = leaning_box(random);
    const oracle::Sides sides = oracle::sides(body);
    const std::vector<oracle::Place> corners = oracle::corners(sides);
    P lo = P::Constant(100), hi = -lo;
    for (const oracle::Place& corner : corners)
      for (int k = 0; k < 3; ++k) {
        const double x = static_cast<double>(corner[static_cast<std::size_t>(k)]);
        lo[k] = std::min(lo[k], x - 1e-9), hi[k] = std::max(hi[k], x + 1e-9);
      }
    ask(body, random, seen, lo, hi, [&](const oracle::Sides& cell) { return oracle::relation(cell, sides); });
  }
  CAPTURE(seen);
  for (const Relation r : {Relation::disjoint, Relation::touching, Relation::overlapping, Relation::b_inside_a})
    CHECK(seen[static_cast<std::size_t>(r)] > 1);
}

TEMPLATE_TEST_CASE("cylinders and cones lie to solids of cells as each cell lies to them", "[mesh_convex]",
                   Cylinder<double>, Cone<double>) {
  Random random(tests::seed());
  std::array<int, 6> seen = {};
  for (int i = 0; i < tests::cases(80, 10000); ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    const TestType body = round_solid<TestType>(random);
    const auto& [p, q, radius] = body;
    const P reach = P::Constant(radius);
    ask(body, random, seen, p.cwiseMin(q) - reach, p.cwiseMax(q) + reach,
        [&](const oracle::Sides& cell) { return reversed(oracle::relation(body, cell)); });
  }
  CAPTURE(seen);
  for (const Relation r : {Relation::disjoint, Relation::touching, Relation::overlapping, Relation::b_inside_a})
    CHECK(seen[static_cast<std::size_t>(r)] > 1);
}

TEST_CASE("the inner point of a solid lies before all its faces", "[mesh_convex]") {
  Random random(tests::seed());
  int found = 0;
  for (int i = 0; i < tests::cases(500, 50000); ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    const HalfSpaces solid = leaning_box(random);
    const std::optional<InnerPoint> inner = inner_point(solid);
    REQUIRE(inner.has_value() == has_volume(solid));  // it is bounded
    if (!inner) continue;
    ++found;
    const Components<Exact, 3> to_origin = inner->way_to<Exact>(P(0, 0, 0)), to_unit = inner->way_to<Exact>(P(1, 0, 0));
    const Exact weight = to_unit[0] - to_origin[0];
    REQUIRE(weight.sign() > 0);
    for (const half_spaces::Face& face : solid.faces) {
      const inequalities::Row<Exact> row = half_spaces::detail::row<Exact>(face);
      REQUIRE((row[3] * weight - row[0] * to_origin[0] - row[1] * to_origin[1] - row[2] * to_origin[2]).sign() > 0);
    }
  }
  CHECK(found > 100);
  CHECK_FALSE(inner_point({{{Level{{1, 0, 0}, 0}}}}));
  CHECK_FALSE(inner_point(half_spaces_of(Aabb<double, 3>{{0, 0, 0}, {1, 1, 0}})));
}

TEST_CASE("a cylinder or a cone that begins or ends on the surface may lie in the solid", "[mesh_convex]") {
  Random random(1);
  const TriangleMesh<double> cube = tests::surface_of({{0, 0, 0}}, 1, {0, 0, 0}, random);
  const P low(.5, .5, 0), middle(.5, .5, .5), high(.5, .5, 1);
  for (const auto& [p, q] : {std::pair(low, middle), {middle, low}, {middle, high}, {low, high}, {high, low}}) {
    CHECK(relate(cube, Cylinder<double>{p, q, .5}) == Relation::b_inside_a);
    CHECK(relate(cube, Cone<double>{p, q, .5}) == Relation::b_inside_a);
    const P up(0, 0, 1);
    CHECK(relate(cube, Cylinder<double>{p + up, q + up, .5}) ==
          (p == low || q == low ? Relation::touching : Relation::disjoint));
  }
}

TEST_CASE("a body that no double lies in is in the solid or out of it", "[mesh_convex]") {
  Random random(1);
  const TriangleMesh<double> box = tests::surface_of({{0, 0, 0}, {1, 0, 0}}, 1, {0, 0, 0}, random);
  const auto plate = [](double a, double b, double side) {  // a <= 15 x <= b
    HalfSpaces solid = half_spaces_of(Aabb<double, 3>{{-9, side - 1, .25}, {9, side, .5}});
    solid.faces.push_back({Level{{15, 0, 0}, -a}}), solid.faces.push_back({Level{{-15, 0, 0}, b}});
    return solid;
  };
  const double above = std::nextafter(15, 16);
  REQUIRE(15 * (std::nextafter(1, 2) - 1) > above - 15);  // what follows 1 is beyond the plate, which begins at 1
  CHECK(relate(box, plate(15, above, 1)) == Relation::b_inside_a);
  CHECK(relate(box, plate(15, above, 1.5)) == Relation::overlapping);
  CHECK(relate(box, plate(15, above, 2)) == Relation::touching);
  CHECK(relate(box, plate(15, above, 3)) == Relation::disjoint);
  CHECK(relate(box, plate(15, 15, 1)) == Relation::disjoint);  // no volume
  CHECK(relate(box, plate(30, 31, 1)) == Relation::touching);
}

TEST_CASE("a body may be the solid, or hold it", "[mesh_convex]") {
  Random random(1);
  const TriangleMesh<double> cube = tests::surface_of({{0, 0, 0}}, 1, {0, 0, 0}, random);
  const double below = std::nextafter(1, 0), above = std::nextafter(1, 2);
  const auto box = [](double hi) { return half_spaces_of(Aabb<double, 3>{{0, 0, 0}, {1, 1, hi}}); };
  CHECK(relate(cube, box(1)) == Relation::equal);
  CHECK(relate(cube, box(above)) == Relation::a_inside_b);
  CHECK(relate(cube, box(below)) == Relation::b_inside_a);
  const auto cylinder = [](double top) { return Cylinder<double>{{-3, 0, 0}, {-3, 0, top}, 5}; };  // its side at x = 2
  CHECK(relate(cube, cylinder(1)) == Relation::a_inside_b);
  CHECK(relate(cube, cylinder(below)) == Relation::overlapping);
  const auto cone = [](double apex) { return Cone<double>{{0, 0, apex}, {0, 0, 0}, 4}; };  // half as wide half-way up
  CHECK(relate(cube, cone(2)) == Relation::a_inside_b);
  CHECK(relate(cube, cone(above)) == Relation::overlapping);
}

TEST_CASE("a body without end lies in no solid", "[mesh_convex]") {
  Random random(1);
  const TriangleMesh<double> cube = tests::surface_of({{0, 0, 0}}, 1, {0, 0, 0}, random);
  const auto half = [](double d) { return HalfSpaces{{{Level{{0, 0, 1}, d}}}}; };
  CHECK(relate(cube, HalfSpaces{}) == Relation::a_inside_b);
  CHECK(relate(cube, half(0)) == Relation::a_inside_b);
  CHECK(relate(cube, half(-.5)) == Relation::overlapping);
  CHECK(relate(cube, half(-1)) == Relation::touching);
  CHECK(relate(cube, half(-2)) == Relation::disjoint);
  const auto wedge = [](double x) {
    return HalfSpaces{{{Level{{1, 0, 0}, -x}}, {Level{{0, 1, 0}, 0}}, {Level{{0, 0, 1}, 0}}}};
  };
  CHECK(relate(cube, wedge(0)) == Relation::a_inside_b);
  CHECK(relate(cube, wedge(1)) == Relation::touching);
  CHECK(relate(cube, wedge(2)) == Relation::disjoint);
  CHECK(relate(TriangleMesh<double>{}, half(0)) == Relation::disjoint);
  CHECK(relate(cube, Cylinder<double>{{0, 0, 0}, {0, 0, 1}, 0}) == Relation::disjoint);
  CHECK(relate(cube, Cone<double>{{0, 0, 0}, {0, 0, NAN}, 1}) == Relation::disjoint);
}

}  // namespace mesh_half_spaces_test
