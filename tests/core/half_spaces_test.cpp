#include <isect/capsule_half_spaces.h>
#include <isect/half_spaces.h>
#include <isect/ray_half_spaces.h>
#include <isect/sphere_half_spaces.h>
#include <isect/triangle_half_spaces.h>

#include <numbers>
#include <random>

#include <isect/aabb_aabb.h>
#include <isect/obb_obb.h>
#include <isect/sphere_aabb.h>
#include <isect/triangle_aabb.h>
#include "bench/half_spaces/oracle.h"
#include "tests/catch.h"
#include "tests/core/common.h"
#include "tests/settings.h"

namespace half_spaces_test {
using namespace isect;
using tests::inf, tests::not_a_number;

namespace {

using Vec = Vector<double, 3>;

/// Draws whole numbers, so that much touches, or any numbers.
struct Draw {
  std::mt19937_64 random{tests::seed()};
  bool whole = true;

  double number(int lo, int hi) {
    if (whole) return std::uniform_int_distribution<int>(lo, hi)(random);
    return std::uniform_real_distribution<double>(lo, hi)(random);
  }
  Vec vector(int reach) { return {number(-reach, reach), number(-reach, reach), number(-reach, reach)}; }

  Aabb<double, 3> box() {
    const Vec a = vector(4), b = vector(4);
    return {a.cwiseMin(b), a.cwiseMax(b)};
  }
  Obb<double, 3> obb() {
    Obb<double, 3> box = {vector(3), {}, {number(0, 2), number(0, 2), number(0, 2)}};
    do
      for (int i = 0; i < 3; ++i) box.axes.col(i) = vector(1);
    while (box.axes.determinant() == 0);
    return box;
  }
  Kdop<double, 3> kdop() {
    Kdop<double, 3> k = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {1, -1, 1}}, {}};
    for (std::size_t i = 0; i < k.normals.size(); ++i) {
      const double lo = number(-4, 3);
      k.slabs.push_back({lo, lo + number(0, 4)});
    }
    return k;
  }
  /// A truncated pyramid anywhere.
  Frustum<double> frustum() {
    const Vec eye = vector(3);
    const auto plane = [&](const Vec& n, double d) { return Plane<double, 3>{n, d - n.dot(eye)}; };
    const double near = number(1, 2), far = near + number(1, 3);
    return {{plane({1, 0, 1}, 0), plane({-1, 0, 1}, 0), plane({0, 1, 2}, 0), plane({0, -1, 2}, 0),
             plane({0, 0, 1}, -near), plane({0, 0, -1}, far)}};
  }
  Triangle<double, 3> triangle() { return {{vector(4), vector(4), vector(4)}}; }
};

/// The pyramid |x| <= z and |y| <= z for z from 1 to 4.
Frustum<double> pyramid() {
  const auto plane = [](const Vec& n, double d) { return Plane<double, 3>{n, d}; };
  return {{plane({1, 0, 1}, 0), plane({-1, 0, 1}, 0), plane({0, 1, 1}, 0), plane({0, -1, 1}, 0), plane({0, 0, 1}, -1),
           plane({0, 0, -1}, 4)}};
}

/// A solid in the core's form and in the oracle's.
struct Solid {
  HalfSpaces core;
  oracle::Sides sides;
};
template <class Shape>
Solid solid(const Shape& shape) {
  return {half_spaces_of(shape), oracle::sides(shape)};
}
Solid any_solid(Draw& draw, int kind) {
  if (kind == 0) return solid(draw.box());
  if (kind == 1) return solid(draw.obb());
  if (kind == 2) return solid(draw.kdop());
  return solid(draw.frustum());
}

/// Calls f(draw, round) with whole numbers, then with any numbers.
template <class F>
void rounds(int count, const F& f) {
  Draw draw;
  for (const bool whole : {true, false}) {
    draw.whole = whole;
    for (int round = 0; round < tests::cases(count, 20 * count); ++round) f(draw, round);
  }
}

}  // namespace

TEST_CASE("two convex solids lie as their corners tell", "[half_spaces]") {
  std::array<int, 6> seen = {};
  rounds(300, [&](Draw& draw, int round) {
    Solid a = any_solid(draw, round % 4);
    const Solid b = any_solid(draw, round / 4 % 4);
    if (round % 6 == 0) {  // small ones
      const Vec lo = draw.vector(2);
      a = solid(Aabb<double, 3>{lo, lo + Vec(draw.number(0, 1), draw.number(0, 1), 0.5)});
    }
    const Relation truth = oracle::relation(a.sides, b.sides);
    CAPTURE(round, draw.whole);
    REQUIRE(relate(a.core, b.core) == truth);
    REQUIRE(relate(b.core, a.core) == reversed(truth));
    REQUIRE(intersects(a.core, b.core) == (truth != Relation::disjoint));
    ++seen[static_cast<std::size_t>(truth)];
  });
  for (const Relation r : {Relation::disjoint, Relation::a_inside_b, Relation::touching, Relation::overlapping})
    CHECK(seen[static_cast<std::size_t>(r)] > 0);
}

/// The solid with sums of its faces added, which change nothing: many touch it in a corner or an edge.
HalfSpaces with_more_faces(Draw& draw, const HalfSpaces& solid, int more) {
  HalfSpaces result = solid;
  const auto level = [&](std::size_t i) { return std::get<half_spaces::Level>(solid.faces[i].form); };
  for (int k = 0; k < more; ++k) {
    half_spaces::Level sum = {Vec::Zero(), draw.random() % 4 == 0 ? 1.0 : 0.0};
    for (int term = 0; term < 3; ++term) {
      const half_spaces::Level one = level(draw.random() % solid.faces.size());
      const double weight = static_cast<double>(draw.random() % 3);
      sum.normal += weight * one.normal, sum.d += weight * one.d;
    }
    result.faces.insert(result.faces.begin() + static_cast<long>(draw.random() % (result.faces.size() + 1)), {sum});
  }
  return result;
}

TEST_CASE("a solid lies alike however many faces it is given by", "[half_spaces]") {
  std::array<int, 6> seen = {};
  Draw draw;
  for (int round = 0; round < tests::cases(300, 6000); ++round) {
    const auto drawn = [&](int kind) {
      return kind == 0   ? half_spaces_of(draw.box())
             : kind == 1 ? half_spaces_of(draw.kdop())
                         : half_spaces_of(draw.frustum());
    };
    const HalfSpaces a = drawn(round % 3), b = round % 20 == 0 ? a : drawn(round / 3 % 3);
    const Relation truth = relate(a, b);
    const HalfSpaces many_a = with_more_faces(draw, a, 30), many_b = with_more_faces(draw, b, 60);
    CAPTURE(round);
    REQUIRE(relate(many_a, many_b) == truth);
    REQUIRE(relate(many_b, a) == reversed(truth));
    const Triangle<double, 3> t = draw.triangle();
    REQUIRE(relate(t, many_a) == relate(t, a));
    REQUIRE(intersects(t, many_a) == (relate(t, a) != Relation::disjoint));
    const Sphere<double, 3> ball = {draw.vector(3), draw.number(0, 3)};
    if (round % 10 == 0) {
      REQUIRE(relate(ball, many_a) == relate(ball, a));
      const Capsule<double, 3> capsule = {draw.vector(3), draw.vector(3), draw.number(0, 3)};
      REQUIRE(relate(capsule, with_more_faces(draw, a, 6)) == relate(capsule, a));
    }
    ++seen[static_cast<std::size_t>(truth)];
  }
  for (const Relation r : {Relation::disjoint, Relation::equal, Relation::touching, Relation::overlapping})
    CHECK(seen[static_cast<std::size_t>(r)] > 0);
}

TEST_CASE("a capsule lies to a plane solid of forty sides as to its nearest side", "[half_spaces]") {
  Kdop<double, 2> round;  // sides at a distance of 1000, some rounded
  for (int i = 0; i < 20; ++i) {
    const double turn = i * std::numbers::pi / 20;
    round.normals.push_back({std::round(1e6 * std::cos(turn)) / 1e6, std::round(1e6 * std::sin(turn)) / 1e6});
    round.slabs.push_back({-1000, 1000});
  }
  round.normals[0] = {1, 0};
  const HalfSpaces solid = half_spaces_of(round);
  const auto at = [&](double x, double r) { return relate(Capsule<double, 2>{{x, -3}, {x, 3}, r}, solid); };
  CHECK(at(1005, 5) == Relation::touching);
  CHECK(at(1005, std::nextafter(5, 0)) == Relation::disjoint);
  CHECK(at(1005, std::nextafter(5, 6)) == Relation::overlapping);
  CHECK(at(0, 5) == Relation::a_inside_b);
  CHECK(at(0, 2000) == Relation::b_inside_a);
}

TEST_CASE("hulls of a thousand corners lie as their corners tell", "[half_spaces]") {
  Draw draw;
  std::vector<Vec> points;
  for (int i = 0; i < 1000; ++i) {
    const double turn = 2.399963229728653 * i, z = 1 - (i + 0.5) / 500, r = std::sqrt(1 - z * z);
    points.emplace_back(1000 * Vec(r * std::cos(turn), r * std::sin(turn), z).array().round().matrix());
  }
  const auto hull_at = [&](const Vec& shift, double scale) {
    std::vector<Vec> moved;
    for (const Vec& p : points) moved.push_back(scale * p + shift);
    return half_spaces_of(convex_hull(moved));
  };
  const HalfSpaces whole = hull_at(Vec::Zero(), 1);
  const Vec top = *std::ranges::max_element(points, {}, [](const Vec& p) { return p.z(); });
  const Vec low = *std::ranges::min_element(points, {}, [](const Vec& p) { return p.z(); });
  CHECK(relate(whole, hull_at(Vec::Zero(), 2)) == Relation::a_inside_b);
  CHECK(relate(hull_at(Vec::Zero(), 2), whole) == Relation::b_inside_a);
  CHECK(relate(whole, hull_at(top, 1)) == Relation::overlapping);
  const Vec beyond = top - low;  // corner on corner
  CHECK(relate(whole, hull_at(beyond, 1)) == Relation::touching);
  CHECK(relate(whole, hull_at(beyond + Vec(0, 0, 1), 1)) == Relation::disjoint);
  CHECK(relate(whole, hull_at(beyond - Vec(0, 0, 1), 1)) == Relation::overlapping);
}

TEST_CASE("boxes and oriented boxes lie as half-spaces as their own tests say", "[half_spaces]") {
  rounds(150, [](Draw& draw, int round) {
    const Aabb<double, 3> a = draw.box(), b = draw.box();
    const Obb<double, 3> p = draw.obb(), q = draw.obb();
    CAPTURE(round, draw.whole);
    REQUIRE(relate(half_spaces_of(a), half_spaces_of(b)) == relate(a, b));
    REQUIRE(relate(half_spaces_of(p), half_spaces_of(q)) == relate(p, q));
    REQUIRE(relate(half_spaces_of(a), half_spaces_of(a)) == Relation::equal);
  });
}

TEST_CASE("thin sets lie as half-spaces as their own tests say", "[half_spaces]") {
  std::mt19937_64 random(tests::seed());
  const auto number = [&](int lo, int hi) -> double { return std::uniform_int_distribution<int>(lo, hi)(random); };
  const auto vector = [&]() -> Vec { return {number(-2, 2), number(-2, 2), number(-2, 2)}; };
  const auto box = [&]() -> Aabb<double, 3> {
    const Vec p = vector(), q = vector();
    return {p.cwiseMin(q), p.cwiseMax(q)};
  };
  const auto tilted = [&]() -> Obb<double, 3> {
    const Eigen::Matrix3d axes[] = {Eigen::Matrix3d::Identity(), Eigen::Matrix3d{{1, 1, 0}, {-1, 1, 0}, {0, 0, 1}},
                                    Eigen::Matrix3d{{2, 0, 1}, {0, 1, 0}, {1, 0, 3}}};
    return {vector(), axes[random() % 3], {number(0, 2), number(0, 2), number(0, 2)}};
  };
  std::array<int, 6> seen = {};
  for (int round = 0; round < tests::cases(1500, 50000); ++round) {
    CAPTURE(round);
    const Aabb<double, 3> a = box(), b = round % 50 == 0 ? a : box();
    const Relation boxes = relate(a, b);
    REQUIRE(relate(half_spaces_of(a), half_spaces_of(b)) == boxes);
    const Obb<double, 3> p = tilted(), q = tilted();
    const Relation tilts = relate(p, q);
    REQUIRE(relate(half_spaces_of(p), half_spaces_of(q)) == tilts);
    const Segment<double, 3> s = {vector(), vector()}, t = {vector(), vector()};
    const Relation segments = relate(Capsule<double, 3>{s.p, s.q, 0}, Capsule<double, 3>{t.p, t.q, 0});
    REQUIRE(relate(half_spaces_of(s), half_spaces_of(t)) == segments);
    Triangle<double, 3> triangle = {{vector(), vector(), vector()}};
    if (round % 5 == 0) triangle.vertices[2] = triangle.vertices[round % 2];
    const Relation with_box = relate(triangle, a);
    REQUIRE(relate(triangle, half_spaces_of(a)) == with_box);
    const Relation with_ball = relate(Sphere<double, 3>{s.p, number(0, 3)}, a);
    for (const Relation r : {boxes, tilts, segments, with_box, with_ball}) ++seen[static_cast<std::size_t>(r)];
  }
  CHECK(*std::ranges::min_element(seen) > 0);
}

TEST_CASE("an ulp decides how a box lies to a frustum, a ball and a capsule", "[half_spaces]") {
  // Beyond an edge of the frustum, where no single plane of it has the box beside it
  const Frustum<double> frustum = pyramid();
  const auto box_at = [](double x) { return half_spaces_of(Aabb<double, 3>{{x, x, -1}, {x + 1, x + 1, x}}); };
  CHECK(relate(box_at(2), half_spaces_of(frustum)) == Relation::touching);
  CHECK(relate(half_spaces_of(Aabb<double, 3>{{2, 2, -1}, {3, 3, std::nextafter(2, 0)}}), half_spaces_of(frustum)) ==
        Relation::disjoint);
  CHECK(relate(half_spaces_of(Aabb<double, 3>{{2, 2, -1}, {3, 3, std::nextafter(2, 3)}}), half_spaces_of(frustum)) ==
        Relation::overlapping);

  const HalfSpaces box = half_spaces_of(Aabb<double, 3>{{0, 0, 0}, {4, 4, 4}});
  const Vec corner(6, 7, 10);  // 2, 3, 6 from the corner: 7 away
  CHECK(relate(Sphere<double, 3>{corner, 7}, box) == Relation::touching);
  CHECK(relate(Sphere<double, 3>{corner, std::nextafter(7, 0)}, box) == Relation::disjoint);
  CHECK(relate(Sphere<double, 3>{corner, std::nextafter(7, 8)}, box) == Relation::overlapping);
  const Capsule<double, 3> beside = {{7, 8, -10}, {7, 8, 20}, 5};  // 3, 4 from an edge
  CHECK(relate(beside, box) == Relation::touching);
  CHECK(relate(Capsule<double, 3>{beside.p, beside.q, std::nextafter(5, 0)}, box) == Relation::disjoint);
  CHECK(relate(Capsule<double, 3>{beside.p, beside.q, std::nextafter(5, 6)}, box) == Relation::overlapping);
  CHECK(relate(Capsule<double, 3>{{2, 2, -10}, {2, 2, 20}, 9}, box) == Relation::b_inside_a);
  CHECK(relate(Capsule<double, 3>{{1, 2, 2}, {3, 2, 2}, 1}, box) == Relation::a_inside_b);
}

TEST_CASE("a ball lies to a solid as its distance tells", "[half_spaces]") {
  std::array<int, 6> seen = {};
  rounds(240, [&](Draw& draw, int round) {
    const Solid s = any_solid(draw, round % 4);
    const Sphere<double, 3> ball = {draw.vector(6), draw.number(0, round % 3 == 0 ? 9 : 3)};
    const Relation truth = oracle::relation({ball.center, ball.center, ball.radius}, s.sides);
    CAPTURE(round, draw.whole);
    REQUIRE(relate(ball, s.core) == truth);
    REQUIRE(intersects(ball, s.core) == (truth != Relation::disjoint));
    ++seen[static_cast<std::size_t>(truth)];
  });
  for (const Relation r :
       {Relation::disjoint, Relation::a_inside_b, Relation::b_inside_a, Relation::touching, Relation::overlapping})
    CHECK(seen[static_cast<std::size_t>(r)] > 0);
}

TEST_CASE("a capsule lies to a solid as its segment's distance tells", "[half_spaces]") {
  std::array<int, 6> seen = {};
  rounds(120, [&](Draw& draw, int round) {
    const Solid s = any_solid(draw, round % 4);
    const Capsule<double, 3> capsule = {draw.vector(6), draw.vector(6), draw.number(0, round % 3 == 0 ? 9 : 3)};
    const Relation truth = oracle::relation(capsule, s.sides);
    CAPTURE(round, draw.whole);
    REQUIRE(relate(capsule, s.core) == truth);
    REQUIRE(intersects(capsule, s.core) == (truth != Relation::disjoint));
    ++seen[static_cast<std::size_t>(truth)];
  });
  for (const Relation r : {Relation::disjoint, Relation::b_inside_a, Relation::touching, Relation::overlapping})
    CHECK(seen[static_cast<std::size_t>(r)] > 0);
}

TEST_CASE("a triangle lies to a solid as what is left of it, clipped", "[half_spaces]") {
  std::array<int, 6> seen = {};
  rounds(600, [&](Draw& draw, int round) {
    const Solid s = any_solid(draw, round % 4);
    Triangle<double, 3> triangle = draw.triangle();
    if (round % 7 == 0) triangle.vertices[2] = triangle.vertices[round % 14 == 0];  // a segment
    const Relation truth = oracle::relation(triangle, s.sides);
    CAPTURE(round, draw.whole);
    REQUIRE(relate(triangle, s.core) == truth);
    REQUIRE(intersects(triangle, s.core) == (truth != Relation::disjoint));
    ++seen[static_cast<std::size_t>(truth)];
  });
  for (const Relation r : {Relation::disjoint, Relation::a_inside_b, Relation::touching, Relation::overlapping})
    CHECK(seen[static_cast<std::size_t>(r)] > 0);
}

TEST_CASE("two triangles in space meet where something is left of one, clipped by the other", "[half_spaces]") {
  int met = 0, apart = 0;
  rounds(600, [&](Draw& draw, int round) {
    const Triangle<double, 3> a = draw.triangle();
    Triangle<double, 3> b = draw.triangle();
    if (round % 3 == 0)
      for (Vec& v : b.vertices) v.z() = 0;
    if (round % 6 == 0) b.vertices[2] = b.vertices[0];
    Triangle<double, 3> lying = a;
    if (round % 9 == 0)
      for (Vec& v : lying.vertices) v.z() = 0;
    const auto area = [](const Triangle<double, 3>& x) {
      const auto& [p, q, r] = x.vertices;
      return (q - p).cross(r - p).squaredNorm() > 0;
    };
    if (!area(lying)) return;
    const bool truth = !oracle::clipped(b, oracle::sides(lying)).empty();
    CAPTURE(round, draw.whole);
    REQUIRE(intersects(lying, b) == truth);
    REQUIRE(intersects(b, lying) == truth);
    ++(truth ? met : apart);
  });
  CHECK(met > 20);
  CHECK(apart > 20);
  const auto segment = [](const Vec& p, const Vec& q) { return Triangle<double, 3>{{p, q, p}}; };
  CHECK(intersects(segment({0, 0, 0}, {2, 2, 0}), segment({0, 2, 0}, {2, 0, 0})));
  CHECK_FALSE(intersects(segment({0, 0, 0}, {2, 2, 0}), segment({0, 2, 1}, {2, 0, 1})));
}

TEST_CASE("the part of a ray in a solid is that of its clipping", "[half_spaces]") {
  int met = 0;
  rounds(400, [&](Draw& draw, int round) {
    const Solid s = any_solid(draw, round % 4);
    const Segment<double, 3> segment = {draw.vector(6), draw.vector(6)};
    const auto truth = oracle::part(oracle::rational(segment.p), oracle::rational(segment.q), s.sides);
    const auto found = intersect(segment, s.core);
    REQUIRE(intersects(segment, s.core) == found.has_value());
    REQUIRE(first_hit(segment, s.core) == (found ? std::optional<double>(found->lo) : std::nullopt));
    CAPTURE(round, draw.whole);
    REQUIRE(found.has_value() == truth.has_value());
    if (!found) return;
    ++met;
    REQUIRE(std::abs(found->lo - truth->first.convert_to<double>()) <= 1e-15);
    REQUIRE(std::abs(found->hi - truth->second.convert_to<double>()) <= 1e-15);
    if (!draw.whole) return;
    const Ray<double, 3> line = {segment.p, segment.q - segment.p, infinite<double>};
    REQUIRE(intersect(line, s.core).has_value());
  });
  CHECK(met > 60);
  const HalfSpaces box = half_spaces_of(Aabb<double, 3>{{0, 0, 0}, {1, 1, 1}});
  const auto along = intersect(Ray<double, 3>{{-2, 1, 1}, {2, 0, 0}}, box);  // an edge
  REQUIRE(along);
  CHECK(along->lo == 1);
  CHECK(along->hi == 1.5);
  CHECK_FALSE(intersect(Ray<double, 3>{{-2, std::nextafter(1, 2), 1}, {2, 0, 0}}, box));
  CHECK_FALSE(intersect(Ray<double, 3>{{-2, 1, 1}, {2, 0, 0}, {0, std::nextafter(1, 0)}}, box));
  CHECK(intersect(Ray<double, 3>{{-2, 1, 1}, {2, 0, 0}, {0, 1}}, box));
  CHECK(intersect(Ray<double, 3>{{0.5, 0.5, 0.5}, {0, 0, 0}}, box));
}

TEST_CASE("a plane cuts a solid, touches it, or has it on one side", "[half_spaces]") {
  const HalfSpaces box =
      half_spaces_of(Obb<double, 3>{{0, 0, 0}, Eigen::Matrix3d{{3, -4, 0}, {4, 3, 0}, {0, 0, 5}}, {1, 1, 1}});
  CHECK(relate(Plane<double, 3>{{1, 0, 0}, 6}, box) == Relation::overlapping);  // it reaches 7
  CHECK(relate(Plane<double, 3>{{1, 0, 0}, -7}, box) == Relation::touching);
  CHECK(relate(Plane<double, 3>{{-1, 0, 0}, -7}, box) == Relation::touching);
  CHECK(relate(Plane<double, 3>{{1, 0, 0}, -std::nextafter(7, 8)}, box) == Relation::disjoint);
  CHECK(relate(Plane<double, 3>{{1, 0, 0}, -std::nextafter(7, 0)}, box) == Relation::overlapping);
  const HalfSpaces flat = half_spaces_of(Aabb<double, 3>{{0, 0, 1}, {1, 1, 1}});
  CHECK(relate(Plane<double, 3>{{0, 0, 1}, -1}, flat) == Relation::touching);
  CHECK(relate(Plane<double, 3>{{0, 0, 0}, 0}, box) == Relation::disjoint);
}

TEST_CASE("where a point lies in a frustum is the sign of each plane", "[half_spaces]") {
  const HalfSpaces frustum = half_spaces_of(pyramid());
  CHECK(locate<double, 3>({0, 0, 2}, frustum) == Location::in);
  CHECK(locate<double, 3>({2, 0, 2}, frustum) == Location::on);
  CHECK(locate<double, 3>({std::nextafter(2, 3), 0, 2}, frustum) == Location::out);
  CHECK(locate<double, 3>({0, 0, 0.5}, frustum) == Location::out);
  CHECK(locate<double, 3>({0, 0, not_a_number}, frustum) == Location::out);
}

TEST_CASE("solids of the plane are prisms without ends", "[half_spaces]") {
  const HalfSpaces square = half_spaces_of(Aabb<double, 2>{{0, 0}, {4, 4}});
  const HalfSpaces tilted = half_spaces_of(Obb<double, 2>{{5, 2}, Eigen::Matrix2d{{1, -1}, {1, 1}}, {0.5, 0.5}});
  CHECK(relate(square, tilted) == Relation::touching);
  CHECK(relate(half_spaces_of(Aabb<double, 2>{{0, 0}, {9, 9}}), tilted) == Relation::b_inside_a);
  CHECK(relate(Sphere<double, 2>{{7, 8}, 5}, square) == Relation::touching);
  CHECK(relate(Sphere<double, 2>{{2, 2}, 2}, square) == Relation::a_inside_b);
  CHECK(relate(Sphere<double, 2>{{2, 2}, 3}, square) == Relation::b_inside_a);
  CHECK(relate(Capsule<double, 2>{{2, 8}, {20, 8}, 4}, square) == Relation::touching);
  CHECK(relate(Capsule<double, 2>{{1, 2}, {3, 2}, 1}, square) == Relation::a_inside_b);
  CHECK(relate(Triangle<double, 2>{{{{4, 4}, {6, 4}, {6, 9}}}}, square) == Relation::touching);
  CHECK(locate<double, 2>({4, 2}, square) == Location::on);
}

TEST_CASE("a hull is the half-spaces of its facets", "[half_spaces]") {
  const Hull3<double> hull = convex_hull(std::vector<Vec>{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {1, 1, 1}});
  const HalfSpaces tetrahedron = half_spaces_of(hull);
  CHECK(locate<double, 3>({1, 1, 1}, tetrahedron) == Location::in);
  CHECK(locate<double, 3>({1, 1, 2}, tetrahedron) == Location::on);
  CHECK(locate<double, 3>({2, 2, 1}, tetrahedron) == Location::out);
  CHECK(relate(half_spaces_of(Aabb<double, 3>{{1, 1, 2}, {5, 5, 5}}), tetrahedron) == Relation::touching);
}

TEST_CASE("what is empty, unbounded or not finite is no common point, or no part of a ball", "[half_spaces]") {
  const HalfSpaces box = half_spaces_of(Aabb<double, 3>{{0, 0, 0}, {1, 1, 1}});
  const HalfSpaces empty_slabs = half_spaces_of(Kdop<double, 3>{{{1, 0, 0}, {-1, 0, 0}}, {{1, 2}, {1, 2}}});
  CHECK_FALSE(has_a_point(empty_slabs));
  CHECK(relate(box, empty_slabs) == Relation::disjoint);
  CHECK(relate(Sphere<double, 3>{{0, 0, 0}, 9}, empty_slabs) == Relation::disjoint);
  CHECK(relate(Capsule<double, 3>{{0, 0, 0}, {1, 0, 0}, 9}, empty_slabs) == Relation::disjoint);
  for (const double bad : {not_a_number, inf, -inf}) {
    CHECK(relate(half_spaces_of(Aabb<double, 3>{{bad, 0, 0}, {1, 1, 1}}), box) == Relation::disjoint);
    CHECK(relate(Sphere<double, 3>{{bad, 0, 0}, 9}, box) == Relation::disjoint);
    CHECK(relate(Capsule<double, 3>{{bad, 0, 0}, {0, 0, 0}, 9}, box) == Relation::disjoint);
    CHECK(relate(Triangle<double, 3>{{{{bad, 0, 0}, {0, 0, 0}, {1, 0, 0}}}}, box) == Relation::disjoint);
  }
  CHECK_FALSE(has_a_point(half_spaces_of(Obb<double, 3>{{0, 0, 0}, Eigen::Matrix3d::Zero(), {1, 1, 1}})));
  // Above z = 0 and between x = 0 and 1: corners, but no end
  const HalfSpaces endless = {
      {{half_spaces::Level{{1, 0, 0}, 0}}, {half_spaces::Level{{0, 1, 0}, 0}}, {half_spaces::Level{{0, 0, 1}, 0}}}};
  CHECK(relate(Sphere<double, 3>{{0, 0, 0}, 9}, endless) == Relation::overlapping);
  CHECK(relate(Capsule<double, 3>{{0, 0, 0}, {1, 0, 0}, 9}, endless) == Relation::overlapping);
}

}  // namespace half_spaces_test
