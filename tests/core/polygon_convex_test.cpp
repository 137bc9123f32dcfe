#include <isect/polygon_convex.h>

#include <array>
#include <limits>

#include "bench/half_spaces/oracle.h"
#include "bench/random.h"
#include "tests/catch.h"
#include "tests/core/polyominoes.h"
#include "tests/settings.h"

namespace polygon_convex_test {
using namespace isect;

namespace {

using bench::Random;
using tests::Square, tests::Squares;
using P = Point<double, 2>;

constexpr int n = 3;  // squares reach from (0, 0) to (n, n)

/// Rings around rectangles, which run along each other, or one ring around squares, perhaps with a hole.
struct Case {
  Squares ringed, odd;  ///< the squares whose sides belong to the set; those that are in it
  Polygon<double, 2> polygon;

  explicit Case(Random& random) {
    if (random.one_in(2)) {  // one outline, as is usual, perhaps with a hole
      odd = ringed = tests::random_squares(random, n);
      add(tests::outline_of(odd), random);
      if (random.one_in(2) && odd.contains({1, 1})) {
        odd.erase({1, 1});
        add({{1, 1}, {1, 2}, {2, 2}, {2, 1}}, random);
      }
      return;
    }
    for (int i = random.integer(1, 5); i > 0; --i) {
      const int x = random.below(n), y = random.below(n), to_x = random.integer(x + 1, n),
                to_y = random.integer(y + 1, n);
      add({{x, y}, {to_x, y}, {to_x, to_y}, {x, to_y}}, random);
      for (int u = x; u < to_x; ++u)
        for (int v = y; v < to_y; ++v) {
          ringed.insert({u, v});
          if (!odd.erase({u, v})) odd.insert({u, v});
        }
    }
  }

  /// Whether a side of unit length belongs to a ring.
  bool has_side(const Square& p, const Square& q) const {
    for (const Ring<double, 2>& ring : polygon.rings)
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const P &a = ring[i], &b = ring[(i + 1) % ring.size()];
        const P middle((p[0] + q[0]) / 2., (p[1] + q[1]) / 2.);
        if ((a.cwiseMin(b).array() <= middle.array()).all() && (middle.array() <= a.cwiseMax(b).array()).all() &&
            (a.x() == b.x() ? middle.x() == a.x() : middle.y() == a.y()))
          return true;
      }
    return false;
  }
  Location locate(double x, double y) const { return isect::locate(P(x, y), polygon); }  // tested by itself

 private:
  void add(std::vector<Square> ring, Random& random) {
    if (random.one_in(2)) std::ranges::reverse(ring);
    std::rotate(ring.begin(), ring.begin() + random.below(static_cast<int>(ring.size())), ring.end());
    polygon.rings.emplace_back();
    for (const auto& [x, y] : ring) polygon.rings.back().emplace_back(x, y);
  }
};

struct Seen {
  bool meet = false, a_in_b = true, b_in_a = true, within = false;

  void point(Location in_a, Location in_b) {
    const bool a = in_a != Location::out, b = in_b != Location::out;
    meet |= a && b, a_in_b &= !a || b, b_in_a &= a || !b;
    within |= in_a == Location::in && in_b == Location::in;
  }
  Relation relation() const {
    if (!meet) return Relation::disjoint;
    if (a_in_b) return b_in_a ? Relation::equal : Relation::a_inside_b;
    return b_in_a ? Relation::b_inside_a : within ? Relation::overlapping : Relation::touching;
  }
};

/// Turns x and scales it, by whole numbers and a power of two.
struct Pose {
  int a = 1, b = 0;
  double unit = 1;

  static Pose draw(Random& random) {
    Pose pose;
    if (random.one_in(2)) pose.a = 4, pose.b = 3;
    if (random.one_in(3)) pose.unit = random.one_in(2) ? 0x1p-1050 : 0x1p500;
    return pose;
  }
  P operator()(const P& x) const { return unit * P(a * x[0] - b * x[1], b * x[0] + a * x[1]); }
  Polygon<double, 2> operator()(Polygon<double, 2> polygon) const {
    for (Ring<double, 2>& ring : polygon.rings)
      for (P& x : ring) x = (*this)(x);
    return polygon;
  }
  /// The box from lo to hi on each axis, unbounded where an end is not finite.
  HalfSpaces box(const P& lo, const P& hi) const {
    HalfSpaces solid = {{}, 2};
    for (int i = 0; i < 2; ++i)
      for (const int up : {-1, 1}) {
        const double end = up > 0 ? hi[i] : lo[i];
        if (!std::isfinite(end)) continue;
        const Vector<double, 3> normal = i == 0 ? Vector<double, 3>(a, b, 0) : Vector<double, 3>(-b, a, 0);
        solid.faces.push_back({half_spaces::Level{-up * normal, up * end * (a * a + b * b) * unit}});
      }
    return solid;
  }
};

void expect_all_seen(const std::array<int, 6>& seen) {
  for (std::size_t i = 0; i < seen.size(); ++i) {
    INFO("relation " << i << ": " << seen[i]);
    CHECK(seen[i] > 0);
  }
}

}  // namespace

TEST_CASE("a polygon lies to half-spaces as its points do", "[polygon_convex]") {
  Random random(tests::seed());
  std::array<int, 6> seen = {};
  for (int i = 0; i < tests::cases(1500, 60000); ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    const Case c(random);
    P lo, hi;
    for (int k = 0; k < 2; ++k) {
      lo[k] = random.integer(-1, 2 * n) / 2., hi[k] = lo[k] + random.integer(1, random.one_in(2) ? 3 : 2 * n) / 2.;
      if (random.one_in(12)) hi[k] = std::numeric_limits<double>::infinity();
    }
    if (random.one_in(8)) {  // about the whole
      lo = {0, 0}, hi = {0, 0};
      for (const auto& [x, y] : c.ringed) lo = lo.cwiseMin(P(x, y)), hi = hi.cwiseMax(P(x + 1, y + 1));
    }
    Seen of;
    for (double x = -1; x <= n + 1; x += 0.25)
      for (double y = -1; y <= n + 1; y += 0.25) {
        const bool in = lo[0] <= x && x <= hi[0] && lo[1] <= y && y <= hi[1],
                   within = lo[0] < x && x < hi[0] && lo[1] < y && y < hi[1];
        of.point(c.locate(x, y), within ? Location::in : in ? Location::on : Location::out);
      }
    if (!std::isfinite(hi.sum())) of.b_in_a = false;
    const Pose pose = Pose::draw(random);
    const Relation expected = of.relation();
    CAPTURE(static_cast<int>(expected));
    REQUIRE(relate(pose(c.polygon), pose.box(lo, hi)) == expected);
    REQUIRE(intersects(pose(c.polygon), pose.box(lo, hi)) == of.meet);
    ++seen[static_cast<std::size_t>(expected)];
  }
  expect_all_seen(seen);
}

TEST_CASE("a polygon lies to balls and capsules as squares and sides do, in rationals", "[polygon_convex]") {
  Random random(tests::seed());
  std::array<int, 6> seen = {};
  for (int i = 0; i < tests::cases(120, 20000); ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    const Case c(random);
    const P p(random.integer(-1, 2 * n + 1) / 2., random.integer(-1, 2 * n + 1) / 2.);
    const P way(random.integer(-2, 2) / 2., random.integer(-2, 2) / 2.), q = random.one_in(2) ? p : P(p + way);
    const double radius = random.one_in(4) ? random.integer(1, 20) / 2. : random.integer(1, 5) / 4.;
    const Capsule<double, 3> body = {{p[0], p[1], 0}, {q[0], q[1], 0}, radius};
    const auto to = [&](double x0, double y0, double x1, double y1) {
      return oracle::relation(body, oracle::sides(Aabb<double, 3>{{x0, y0, 0}, {x1, y1, 0}}));
    };
    bool within = false, leaves = false, meet = false, held = true;
    for (int x = -1; x <= n; ++x)
      for (int y = -1; y <= n; ++y) {
        const Relation r = to(x, y, x + 1, y + 1);
        const bool inside = r == Relation::overlapping || r == Relation::b_inside_a || r == Relation::a_inside_b;
        (c.odd.contains({x, y}) ? within : leaves) |= inside;
        for (const Square& end : {Square{x + 1, y}, Square{x, y + 1}}) {
          if (!c.has_side({x, y}, end)) continue;
          const Relation of_side = to(x, y, end[0], end[1]);
          meet |= of_side != Relation::disjoint, held &= of_side == Relation::b_inside_a;
        }
      }
    const bool holds = within && !leaves;
    const Relation expected = held     ? Relation::a_inside_b
                              : holds  ? Relation::b_inside_a
                              : within ? Relation::overlapping
                              : meet   ? Relation::touching
                                       : Relation::disjoint;
    CAPTURE(static_cast<int>(expected));
    const Capsule<double, 2> flat = {p, q, radius};
    REQUIRE(relate(c.polygon, flat) == expected);
    REQUIRE(intersects(c.polygon, flat) == (expected != Relation::disjoint));
    if (p == q) REQUIRE(relate(c.polygon, Sphere<double, 2>{p, radius}) == expected);
    ++seen[static_cast<std::size_t>(expected)];
  }
  seen[static_cast<std::size_t>(Relation::equal)] = 1;  // no ball is a polygon
  expect_all_seen(seen);
}

TEMPLATE_TEST_CASE("polygons, balls and half-spaces: points, segments, nothing at all", "[polygon_convex]", float,
                   double) {
  using S = TestType;
  const S nan_ = std::numeric_limits<S>::quiet_NaN();
  const Polygon<S, 2> frame = {{{{0, 0}, {6, 0}, {6, 6}, {0, 6}}, {{2, 2}, {4, 2}, {4, 4}, {2, 4}}}};
  // The same polygon as one ring: an edge leads into the hole and back
  const Polygon<S, 2> key = {{{{0, 0}, {6, 0}, {6, 6}, {0, 6}, {0, 0}, {2, 2}, {2, 4}, {4, 4}, {4, 2}, {2, 2}}}};
  for (const Polygon<S, 2>& x : {frame, key}) {
    CHECK(relate(x, Sphere<S, 2>{{1, 1}, 1}) == Relation::b_inside_a);  // on the edge, which divides nothing
    CHECK(relate(x, Sphere<S, 2>{{3, 3}, 1}) == Relation::touching);
    CHECK(relate(x, Sphere<S, 2>{{3, 3}, S(0.5)}) == Relation::disjoint);
    CHECK(relate(x, Sphere<S, 2>{{3, 3}, 5}) == Relation::a_inside_b);
    CHECK(relate(x, Sphere<S, 2>{{3, 3}, 0}) == Relation::disjoint);
    CHECK(relate(x, Sphere<S, 2>{{2, 3}, 0}) == Relation::b_inside_a);
    CHECK(relate(x, Capsule<S, 2>{{1, 3}, {3, 3}, 0}) == Relation::overlapping);
    CHECK(relate(x, Capsule<S, 2>{{1, 1}, {1, 5}, 0}) == Relation::b_inside_a);
    for (const S radius : {S(-1), nan_, std::numeric_limits<S>::infinity()}) {
      CHECK(relate(x, Sphere<S, 2>{{1, 1}, radius}) == Relation::disjoint);
      CHECK_FALSE(intersects(x, Sphere<S, 2>{{1, 1}, radius}));
    }
    CHECK(relate(x, Capsule<S, 2>{{1, 1}, {nan_, 5}, 1}) == Relation::disjoint);
    const HalfSpaces flat = half_spaces_of(Aabb<S, 2>{{1, 1}, {5, 1}}),
                     none = half_spaces_of(Aabb<S, 2>{{1, 0}, {0, 1}});
    CHECK(relate(x, flat) == Relation::disjoint);  // as stated
    CHECK(intersects(x, flat));
    CHECK(relate(x, none) == Relation::disjoint);
    CHECK_FALSE(intersects(x, none));
  }
  Polygon<S, 2> bad = frame;
  bad.rings[1][2][0] = nan_;
  for (const Polygon<S, 2>& x : {bad, Polygon<S, 2>{}, Polygon<S, 2>{{{}}}}) {
    CHECK(relate(x, Sphere<S, 2>{{1, 1}, 9}) == Relation::disjoint);
    CHECK(relate(x, half_spaces_of(Aabb<S, 2>{{-9, -9}, {9, 9}})) == Relation::disjoint);
    CHECK_FALSE(intersects(x, half_spaces_of(Aabb<S, 2>{{-9, -9}, {9, 9}})));
  }
}

}  // namespace polygon_convex_test
