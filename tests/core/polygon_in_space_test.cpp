#include <isect/point_capsule.h>
#include <isect/point_cone.h>
#include <isect/point_cylinder.h>
#include <isect/point_sphere.h>
#include <isect/polygon_in_space.h>
#include <isect/ray_outline.h>

#include <array>
#include <cmath>
#include <limits>

#include "bench/cylinder_half_spaces/oracle.h"
#include "tests/catch.h"
#include "tests/core/common.h"
#include "tests/core/polyominoes.h"
#include "tests/settings.h"

namespace polygon_in_space_test {
using namespace isect;
using tests::inf, tests::not_a_number;

namespace {

using bench::Random;
using tests::Frame, tests::Squares, tests::locate;
using P = Point<double, 3>;

constexpr int n = 3;  // squares reach from (0, 0) to (n, n)

struct Case {
  Frame frame;
  Squares squares;
  TriangulatedPolygon<double> polygon;

  explicit Case(Random& random) : Case(Frame::draw(random), random) {}
  Case(const Frame& f, Random& random)
      : frame(f), squares(tests::random_squares(random, n)), polygon(triangulated(outline_in(f, squares, random))) {}
};

/// How two sets lie, from a grid of points so fine that it has a point in each part of either.
struct Seen {
  bool meet = false, a_in_b = true, b_in_a = true, within = false;

  void point(Location in_a, bool in_b, bool within_b) {
    meet |= in_a != Location::out && in_b;
    a_in_b &= in_a == Location::out || in_b;
    b_in_a &= in_a != Location::out || !in_b;
    within |= in_a == Location::in && within_b;
  }
  Relation relation() const {
    if (!meet) return Relation::disjoint;
    if (a_in_b) return b_in_a ? Relation::equal : Relation::a_inside_b;
    return b_in_a ? Relation::b_inside_a : within ? Relation::overlapping : Relation::touching;
  }
};
constexpr double step = 0.25;  // bodies end at halves
template <class Use>
void at_all_points(const Use& use) {
  for (double x = -2; x <= n + 2; x += step)
    for (double y = -2; y <= n + 2; y += step) use(x, y);
}

using Bounds = std::array<double, 3>;

/// How squares in z = 0 (A) lie to the box from lo to hi (B).
Relation truth(const Squares& squares, const Bounds& lo, const Bounds& hi) {
  Seen seen;
  const bool reached = lo[2] <= 0 && 0 <= hi[2], crossed = lo[2] == hi[2] || (lo[2] < 0 && 0 < hi[2]);
  at_all_points([&](double x, double y) {
    const auto between = [](double a, double v, double b) { return a == b ? v == a : a < v && v < b; };
    const bool in = reached && lo[0] <= x && x <= hi[0] && lo[1] <= y && y <= hi[1];
    seen.point(locate(x, y, squares), in, crossed && between(lo[0], x, hi[0]) && between(lo[1], y, hi[1]));
  });
  if (lo[2] < hi[2]) seen.b_in_a = false;
  return seen.relation();
}

std::pair<Bounds, Bounds> bounds(Random& random) {
  Bounds lo = {}, hi = {};
  for (std::size_t i = 0; i < 3; ++i) {
    lo[i] = random.integer(i == 2 ? -2 : -1, i == 2 ? 1 : 2 * n) / 2.;
    hi[i] = lo[i] + (random.one_in(3) ? 0 : random.integer(0, i == 2 ? 3 : 2 * n) / 2.);
    if (i == 2 && random.one_in(2)) lo[i] = hi[i] = 0;
  }
  if (random.one_in(5)) lo[0] = lo[1] = random.integer(-1, 1) / 2., hi[0] = hi[1] = n;  // about all
  return {lo, hi};
}

/// How the polygon lies to a solid, by its squares in rationals; of_square(sides) says how the solid (A) lies to one,
/// is_inside(p) whether a point is inside it. A square of the solid lies on its border as a whole if its middle does.
template <class OfSquare, class IsInside>
Relation truth(const Frame& frame, const Squares& squares, const OfSquare& of_square, const IsInside& is_inside) {
  std::size_t held = 0;
  bool touched = false, cut = false;
  for (const auto& [x, y] : squares) {
    const Bounds lo = {double(x), double(y), 0}, hi = {x + 1., y + 1., 0};
    const Relation r = of_square(oracle::sides(frame.box(lo, hi)));
    held += r == Relation::b_inside_a;
    touched |= r != Relation::disjoint;
    cut |= r == Relation::overlapping || (r == Relation::b_inside_a && is_inside(frame.at(x + 0.5, y + 0.5)));
  }
  return held == squares.size() ? Relation::a_inside_b
         : cut                  ? Relation::overlapping
         : touched              ? Relation::touching
                                : Relation::disjoint;
}

void expect_seen(const std::array<int, 6>& seen, std::initializer_list<Relation> which, int least) {
  for (const Relation r : which) {
    INFO("relation " << static_cast<int>(r) << ": " << seen[static_cast<std::size_t>(r)]);
    CHECK(seen[static_cast<std::size_t>(r)] >= least);
  }
}

}  // namespace

TEST_CASE("a polygon of squares lies to boxes, plates, segments and points as its points do", "[polygon_in_space]") {
  Random random(tests::seed());
  std::array<int, 6> seen = {};
  for (int i = 0; i < tests::cases(500, 40000); ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    const Case c(random);
    const auto [lo, hi] = bounds(random);
    const Relation expected = truth(c.squares, lo, hi);
    CAPTURE(static_cast<int>(expected));
    REQUIRE(relate(c.polygon, c.frame.box(lo, hi)) == expected);
    ++seen[static_cast<std::size_t>(expected)];
  }
  using enum Relation;
  expect_seen(seen, {disjoint, a_inside_b, b_inside_a, touching, overlapping}, 10);
}

TEST_CASE("two polygons of squares in one plane lie as their points do", "[polygon_in_space]") {
  Random random(tests::seed());
  std::array<int, 6> seen = {};
  for (int i = 0; i < tests::cases(250, 20000); ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    const Case a(random);
    Case b(a.frame, random);
    if (random.one_in(4)) {  // another telling of the same one, or a part of it
      b.squares = a.squares;
      if (random.one_in(2))
        b.squares.erase(*std::next(b.squares.begin(), random.below(static_cast<int>(b.squares.size()))));
      if (b.squares.empty() || tests::outline_of(b.squares).empty()) continue;
      b.polygon = triangulated(outline_in(b.frame, b.squares, random));
    }
    Seen of;
    at_all_points([&](double x, double y) {
      const Location in_b = locate(x, y, b.squares);
      of.point(locate(x, y, a.squares), in_b != Location::out, in_b == Location::in);
    });
    const Relation expected = of.relation();
    CAPTURE(static_cast<int>(expected));
    REQUIRE(relate(a.polygon, b.polygon) == expected);
    REQUIRE(relate(b.polygon, a.polygon) == reversed(expected));
    ++seen[static_cast<std::size_t>(expected)];
  }
  using enum Relation;
  expect_seen(seen, {disjoint, equal, a_inside_b, b_inside_a, touching, overlapping}, 5);
}

TEST_CASE("two polygons of squares in two planes meet along the line of both", "[polygon_in_space]") {
  Random random(tests::seed());
  std::array<int, 6> seen = {};
  for (int i = 0; i < tests::cases(250, 20000); ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    const Case a(random);
    // B stands on the line y = height, its second axis along the third, from `low` on.
    const double height = random.integer(0, 2 * n) / 2., low = -random.integer(0, 2 * n) / 2.;
    Frame across = a.frame;
    across.origin += height * a.frame.axes[1] + low * a.frame.axes[2];
    across.axes = {a.frame.axes[0], a.frame.axes[2], a.frame.axes[1]};
    const Case b(across, random);
    Seen of;
    for (double x = -1; x <= n + 1; x += step) {
      const Location in_b = locate(x, -low, b.squares);
      of.point(locate(x, height, a.squares), in_b != Location::out, in_b == Location::in);
    }
    of.a_in_b = of.b_in_a = false;
    const Relation expected = of.relation();
    CAPTURE(static_cast<int>(expected));
    REQUIRE(relate(a.polygon, b.polygon) == expected);
    ++seen[static_cast<std::size_t>(expected)];
  }
  using enum Relation;
  expect_seen(seen, {disjoint, touching, overlapping}, 10);
}

TEST_CASE("a polygon of squares lies to a triangle as squares, sides and corners of its grid do",
          "[polygon_in_space]") {
  Random random(tests::seed());
  std::array<int, 6> seen = {};
  for (int i = 0; i < tests::cases(80, 5000); ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    const Case c(random);
    const bool flat = random.one_in(2);
    const int u = random.below(n), v = random.below(n), reach = random.one_in(4) ? n : random.integer(1, 2);
    const auto corner = [&] {
      const int x = u + random.integer(0, reach), y = v + random.integer(0, reach);
      return c.frame.at(x, y, flat ? 0 : random.integer(-1, 1));
    };
    const Triangle<double, 3> x = {{corner(), corner(), corner()}};
    const oracle::Sides sides = oracle::sides(triangle_half_spaces::detail::solid_of(x, 3, NoTrace()));

    // Squares, sides between them and corners, as sets of their own: of the plane near the triangle, then all others.
    bool met = false, within = false, b_in_a = flat, a_in_b = true;
    const auto cell = [&](double x0, double y0, double x1, double y1) {
      const oracle::Sides own = oracle::sides(c.frame.box({x0, y0, 0}, {x1, y1, 0}));
      const std::vector<oracle::Place> common = oracle::corners(oracle::both(own, sides));
      if (common.empty()) return;
      const oracle::Place inner = oracle::middle(common);
      const Location where = locate((x0 + x1) / 2, (y0 + y1) / 2, c.squares);
      met |= where != Location::out;
      if (!oracle::holds_within(own, inner)) return;
      within |= where == Location::in && oracle::holds_within(sides, inner);
      b_in_a &= where != Location::out;
    };
    for (int gx = u; gx <= u + reach; ++gx)
      for (int gy = v; gy <= v + reach; ++gy)
        cell(gx, gy, gx + 1, gy + 1), cell(gx, gy, gx + 1, gy), cell(gx, gy, gx, gy + 1), cell(gx, gy, gx, gy);
    for (const P& p : c.polygon.outline) a_in_b &= oracle::holds(sides, oracle::rational(p));
    const Relation expected = !met     ? Relation::disjoint
                              : a_in_b ? (b_in_a ? Relation::equal : Relation::a_inside_b)
                              : b_in_a ? Relation::b_inside_a
                              : within ? Relation::overlapping
                                       : Relation::touching;
    CAPTURE(static_cast<int>(expected));
    REQUIRE(relate(c.polygon, x) == expected);
    ++seen[static_cast<std::size_t>(expected)];
  }
  using enum Relation;
  expect_seen(seen, {disjoint, b_inside_a, touching, overlapping}, 2);
}

TEST_CASE("a polygon of squares lies to round solids as each of its squares does", "[polygon_in_space]") {
  Random random(tests::seed());
  std::array<int, 6> seen = {};
  for (int i = 0; i < tests::cases(120, 10000); ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    Frame frame = Frame::draw(random);
    frame.unit = 1;  // the oracles of round solids take their time
    const Case c(frame, random);
    const auto place = [&](int lo, int hi) {
      return c.frame.at(random.integer(-2, 2 * n + 2) / 2., random.integer(-2, 2 * n + 2) / 2.,
                        random.integer(lo, hi) / 2.);
    };
    const P p = place(-3, 3), q = place(-3, 3);
    const double radius = random.integer(1, random.one_in(3) ? 40 : 5) / 2.;
    const auto expect = [&](const auto& solid, const auto& of_square) {
      const Relation expected =
          truth(c.frame, c.squares, of_square, [&](const P& x) { return isect::locate(x, solid) == Location::in; });
      CAPTURE(static_cast<int>(expected));
      REQUIRE(relate(c.polygon, solid) == expected);
      ++seen[static_cast<std::size_t>(expected)];
    };
    const auto of_capsule = [](const Capsule<double, 3>& x) {
      return [x](const oracle::Sides& square) { return oracle::relation(x, square); };
    };
    expect(Sphere<double, 3>{p, radius}, of_capsule({p, p, radius}));
    expect(Capsule<double, 3>{p, q, radius}, of_capsule({p, q, radius}));
    if (p == q) continue;
    const auto of_round = [](const auto& x) {
      return [k = oracle::round_solid(x)](const oracle::Sides& square) {
        return oracle::RoundAndSides(k, square).relation();
      };
    };
    expect(Cylinder<double>{p, q, radius}, of_round(Cylinder<double>{p, q, radius}));
    expect(Cone<double>{p, q, radius}, of_round(Cone<double>{p, q, radius}));
  }
  using enum Relation;
  expect_seen(seen, {disjoint, a_inside_b, touching, overlapping}, 2);
}

TEST_CASE("a solid that ends at a diagonal overlaps the polygon", "[polygon_in_space]") {
  const TriangulatedPolygon<double> x = triangulated(Ring<double, 3>{{0, 0, 0}, {4, 0, 0}, {4, 2, 0}, {0, 2, 0}});
  for (const double up : {-1, 1})
    for (const double right : {-1, 1}) {  // one triangle lies in the cylinder, the other touches its end, or both
      const P middle(2, 1, 0), way(-right * up, 2 * up, 0);
      CHECK(relate(x, Cylinder<double>{middle, middle + 3 * way, 3}) == Relation::overlapping);
      CHECK(relate(x, Cylinder<double>{middle - 3 * way, middle + 3 * way, 9}) == Relation::a_inside_b);
    }
}

TEST_CASE("a polygon in the plane of a cylinder's end, or of a cone's base, touches it", "[polygon_in_space]") {
  Random random(tests::seed());
  std::array<int, 6> seen = {};
  for (int i = 0; i < tests::cases(60, 2000); ++i) {
    Frame frame = Frame::draw(random);
    frame.unit = 1;
    frame.axes = {P(1, 0, 0), P(0, 1, 0), P(0, 0, 1)};
    const Case c(frame, random);
    const P p = frame.at(random.integer(0, 2 * n) / 2., random.integer(0, 2 * n) / 2.),
            up(0, 0, random.one_in(2) ? 1 : -1);
    const double radius = random.integer(1, 8) / 2.;
    const bool held =
        std::ranges::all_of(c.polygon.outline, [&](const P& v) { return (v - p).squaredNorm() <= radius * radius; });
    for (const Relation r :
         {relate(c.polygon, Cylinder<double>{p, p + up, radius}),
          relate(c.polygon, Cylinder<double>{p + up, p, radius}), relate(c.polygon, Cone<double>{p + up, p, radius})}) {
      CHECK(r != Relation::overlapping);
      CHECK((r == Relation::a_inside_b) == held);
      ++seen[static_cast<std::size_t>(r)];
    }
  }
  expect_seen(seen, {Relation::a_inside_b, Relation::touching}, 10);
}

TEST_CASE("a polygon of 200 corners lies to others as their corners tell", "[polygon_in_space]") {
  Ring<double, 3> stairs;
  for (int i = 0; i < 100; ++i) stairs.push_back({double(i), 0, double(i)}), stairs.push_back({i + 1., 0, double(i)});
  stairs.push_back({100, 0, 100}), stairs.push_back({0, 0, 100});
  const TriangulatedPolygon<double> x = triangulated(stairs);
  REQUIRE(x.triangles.size() == 200);
  Ring<double, 3> turned = stairs;
  std::rotate(turned.begin(), turned.begin() + 77, turned.end());
  CHECK(relate(x, triangulated(turned)) == Relation::equal);
  CHECK(relate(x, Triangle<double, 3>{{P(0, 0, 50), P(10, 0, 60), P(0, 0, 90)}}) == Relation::b_inside_a);
  for (P& v : turned) v.y() = 1;
  CHECK(relate(x, triangulated(turned)) == Relation::disjoint);
}

TEST_CASE("round solids without a radius are points and segments beside a polygon", "[polygon_in_space]") {
  Random random(tests::seed());
  const auto as_point = [](const Case& c, double x, double y, double z) {
    return truth(c.squares, {x, y, z}, {x, y, z});
  };
  for (int i = 0; i < 60; ++i) {
    const Case c(random);
    const double x = random.integer(-1, 2 * n + 1) / 2., y = random.integer(-1, 2 * n + 1) / 2.,
                 z = random.one_in(4) ? 1 : 0;
    const P p = c.frame.at(x, y, z), q = c.frame.at(x + 1, y, z);
    const Relation segment = truth(c.squares, {x, y, z}, {x + 1, y, z});
    CHECK(relate(c.polygon, Sphere<double, 3>{p, 0}) == as_point(c, x, y, z));
    CHECK(relate(c.polygon, Capsule<double, 3>{p, p, 0}) == as_point(c, x, y, z));
    CHECK(relate(c.polygon, Capsule<double, 3>{p, q, 0}) == segment);
    CHECK(relate(c.polygon, Cylinder<double>{p, q, 0}) == segment);
    CHECK(relate(c.polygon, Cone<double>{q, p, 0}) == segment);
    CHECK(relate(c.polygon, Cylinder<double>{p, p, 0}) == Relation::disjoint);
    CHECK(isect::locate(p, c.polygon) == (as_point(c, x, y, z) == Relation::disjoint ? Location::out : Location::on));
  }
}

TEST_CASE("a line first meets a polygon in space where it meets the outline's inside", "[polygon_in_space]") {
  Random random(tests::seed());
  int hits = 0, in_plane = 0;
  for (int i = 0; i < tests::cases(600, 60000); ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    const Case c(random);
    const double z = random.one_in(2) ? 0 : random.integer(-2, 2);
    const auto place = [&](double height) {
      return c.frame.at(random.integer(-2, 2 * n + 4) / 2., random.integer(-2, 2 * n + 4) / 2., height);
    };
    const P o = place(z), to = place(z == 0 ? 0 : random.integer(-2, 2));
    const Ray<double, 3> ray = {o, to - o, {0, random.one_in(2) ? inf : random.integer(0, 3) / 2.}};
    const Segment<double, 3> segment = {o, to};
    const Polygon<double, 3> plain = {{c.polygon.outline}};
    const auto same = [](const std::optional<double>& x, const std::optional<double>& y) {
      return x.has_value() == y.has_value() && (!x || std::abs(*x - *y) <= 4e-16 * std::abs(*y));
    };
    const auto t = first_hit(ray, c.polygon);
    CHECK(same(t, first_hit(ray, plain)));
    CHECK(same(first_hit(segment, c.polygon), first_hit(segment, plain)));
    hits += t.has_value(), in_plane += t && z == 0;
  }
  CHECK((hits > 100 && in_plane > 50));
}

TEMPLATE_TEST_CASE("a folded polygon is the surface of its triangles", "[polygon_in_space]", float, double) {
  using S = TestType;
  // Over the arrow (0, 0), (4, 0), (4, 4), (3, 1): folded along the diagonal from (3, 1) to (4, 0), or to (4, 4), ...
  const TriangulatedPolygon<S> fold = triangulated(Ring<S, 3>{{0, 0, 0}, {4, 0, 0}, {4, 4, 4}, {3, 1, 0}});
  REQUIRE(fold.triangles.size() == 2);
  CHECK(fold.convex.empty());
  CHECK(off_plane(fold.outline) > 0);
  const auto plate = [](S z, S lo, S hi) -> HalfSpaces { return half_spaces_of(Aabb<S, 3>{{lo, lo, z}, {hi, hi, z}}); };
  CHECK(relate(fold, plate(0, -9, 9)) == Relation::overlapping);  // along the flat part, which goes on above
  CHECK(relate(fold, plate(1, -9, 9)) == Relation::overlapping);  // across the other
  CHECK(relate(fold, plate(4, -9, 9)) == Relation::touching);     // at its tip
  CHECK(relate(fold, plate(-1, -9, 9)) == Relation::disjoint);
  CHECK(relate(fold, Triangle<S, 3>{{fold.outline[0], fold.outline[1], fold.outline[3]}}) == Relation::b_inside_a);
  CHECK(relate(fold, fold) == Relation::equal);
  TriangulatedPolygon<S> turned = fold;
  std::ranges::reverse(turned.outline);
  CHECK(relate(fold, triangulated(turned.outline)) == Relation::equal);
  CHECK(relate(fold, half_spaces_of(Aabb<S, 3>{{0, 0, 0}, {4, 4, 4}})) == Relation::a_inside_b);
  CHECK(relate(fold, half_spaces_of(Aabb<S, 3>{{0, 0, 1}, {4, 4, 4}})) == Relation::overlapping);
  CHECK(relate(fold, half_spaces_of(Aabb<S, 3>{{0, 0, 4}, {4, 4, 5}})) == Relation::touching);
  // Seen from above a square, folded along the diagonal from (4, 0) to (0, 4)
  const TriangulatedPolygon<S> tent = triangulated(Ring<S, 3>{{0, 0, 0}, {4, 0, 0}, {4, 4, 4}, {0, 4, 0}});
  CHECK(tent.convex.empty());
  CHECK(relate(tent, plate(0, -9, 9)) == Relation::overlapping);
  CHECK(relate(tent, plate(0, 0, 4)) == Relation::overlapping);
  CHECK(relate(tent, plate(0, 3, 4)) == Relation::disjoint);
  CHECK(relate(tent, Triangle<S, 3>{{Point<S, 3>{0, 0, 0}, Point<S, 3>{1, 0, 0}, Point<S, 3>{0, 1, 0}}}) ==
        Relation::b_inside_a);
}

TEST_CASE("a polygon that is empty, and what is not finite or empty, is disjoint", "[polygon_in_space]") {
  const Ring<double, 3> l = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 4, 0}, {2, 2, 0}, {0, 2, 0}};
  const TriangulatedPolygon<double> some = triangulated(l),
                                    none = triangulated(Ring<double, 3>{l[0], l[2], l[1], l[3]});
  Ring<double, 3> bad = l;
  bad[2].z() = not_a_number;
  const auto square = triangulated(Ring<double, 3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  CHECK_FALSE(square.convex.empty());
  REQUIRE(empty(none));
  REQUIRE(empty(triangulated(bad)));
  REQUIRE(empty(triangulated(Ring<double, 3>{})));
  REQUIRE(empty(triangulated(Ring<double, 3>{{inf, 0, 0}, {1, 0, 0}, {0, 1, 0}})));
  for (const auto& x : {none, triangulated(bad)}) {
    CHECK(relate(x, some) == Relation::disjoint);
    CHECK(relate(some, x) == Relation::disjoint);
    CHECK(relate(x, x) == Relation::disjoint);
    CHECK(relate(x, square) == Relation::disjoint);
    CHECK(relate(square, x) == Relation::disjoint);
    CHECK(relate(x, half_spaces_of(Aabb<double, 3>{{-9, -9, -9}, {9, 9, 9}})) == Relation::disjoint);
    CHECK(relate(x, Sphere<double, 3>{{0, 0, 0}, 9}) == Relation::disjoint);
    CHECK(isect::locate(l[0], x) == Location::out);
    CHECK_FALSE(first_hit(Ray<double, 3>{{1, 1, 1}, {0, 0, -1}}, x));
  }
  for (const auto& x : {some, square}) {
    for (const double r : {-1., not_a_number, inf}) {
      CHECK(relate(x, Sphere<double, 3>{{0, 0, 0}, r}) == Relation::disjoint);
      CHECK(relate(x, Capsule<double, 3>{{0, 0, 0}, {1, 0, 0}, r}) == Relation::disjoint);
      CHECK(relate(x, Cylinder<double>{{0, 0, 0}, {1, 0, 0}, r}) == Relation::disjoint);
      CHECK(relate(x, Cone<double>{{0, 0, 0}, {1, 0, 0}, r}) == Relation::disjoint);
    }
    CHECK(relate(x, Cone<double>{{0, 0, 0}, {0, 0, 0}, 1}) == Relation::disjoint);
    CHECK(relate(x, Triangle<double, 3>{{P(0, 0, 0), P(1, 0, not_a_number), P(0, 1, 0)}}) == Relation::disjoint);
    CHECK(relate(x, half_spaces_of(Aabb<double, 3>{{1, 0, 0}, {0, 1, 1}})) == Relation::disjoint);
    CHECK(isect::locate(P(0, 0, not_a_number), x) == Location::out);
    CHECK_FALSE(first_hit(Ray<double, 3>{{0, 0, not_a_number}, {0, 0, 1}}, x));
  }
}

}  // namespace polygon_in_space_test
