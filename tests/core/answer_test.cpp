#include <isect/answer.h>
#include <isect/any_shape.h>
#include <isect/ask.h>

#include <limits>
#include <random>

#include <isect/ray_triangle.h>
#include "tests/catch.h"
#include "tests/core/common.h"
#include "tests/settings.h"

namespace answer_test {
using namespace isect;
using tests::inf, tests::not_a_number;

namespace {

/// Draws small whole numbers, so that much touches, or any numbers.
template <int N>
struct Draw {
  std::mt19937_64 random{tests::seed()};
  bool whole = true;

  using Vec = Vector<double, N>;
  int integer(int lo, int hi) { return std::uniform_int_distribution<int>(lo, hi)(random); }
  double number(int lo, int hi) {
    return whole ? integer(lo, hi) : std::uniform_real_distribution<double>(lo, hi)(random);
  }
  Vec vector(int reach) {
    Vec v;
    for (int i = 0; i < N; ++i) v[i] = number(-reach, reach);
    return v;
  }
  Vec direction() {
    Vec v = vector(2);
    while (v.isZero(0)) v = vector(2);
    return v;
  }
  Aabb<double, N> box() {
    const Vec a = vector(4), b = vector(4);
    return {a.cwiseMin(b), a.cwiseMax(b)};
  }
  Obb<double, N> obb() {
    Obb<double, N> box;
    box.center = vector(3);
    for (int i = 0; i < N; ++i) box.half[i] = number(0, 2);
    do
      for (int i = 0; i < N; ++i) box.axes.col(i) = vector(1);
    while (box.axes.determinant() == 0);
    return box;
  }
  Kdop<double, N> kdop() {
    Kdop<double, N> k;
    for (int i = 0; i < N; ++i) k.normals.push_back(Vec::Unit(i));
    k.normals.push_back(Vec::Ones());
    for (std::size_t i = 0; i < k.normals.size(); ++i) {
      const double lo = number(-4, 3);
      k.slabs.push_back({lo, lo + number(0, 4)});
    }
    return k;
  }
  Ray<double, N> ray() {
    const int kind = integer(0, 2);
    return {vector(4), direction(),
            kind == 0   ? infinite<double>
            : kind == 1 ? semi_infinite<double>
                        : Interval<double>{-1, 2}};
  }
  /// A tetrahedron that has a volume, or a cut-off corner of space.
  TriangleMesh<double> tetrahedron() requires(N == 3) {
    TriangleMesh<double> mesh = {{}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
    for (int i = 0; i < 4; ++i) mesh.vertices.push_back(vector(4));
    return mesh;
  }
  Hull3<double> hull() requires(N == 3) {
    Hull3<double> hull;
    do hull = convex_hull(tetrahedron().vertices);
    while (hull.dimension < 3);
    return hull;
  }
  Frustum<double> frustum() requires(N == 3) {
    const auto plane = [&](const Vec& n, double d) { return Plane<double, 3>{n, d}; };
    const Vec eye = vector(2);
    const auto at = [&](const Vec& n, double d) { return plane(n, d - n.dot(eye)); };
    return {{at({2, 0, 1}, 0), at({-2, 0, 1}, 0), at({0, 2, 1}, 0), at({0, -2, 1}, 0), at({0, 0, 1}, -1),
             at({0, 0, -1}, 3)}};
  }

  /// A polygon of four to six corners, flat or folded, convex or not.
  TriangulatedPolygon<double> polygon() requires(N == 3) {
    const Vec from = vector(3), u = direction();
    const bool folded = integer(0, 3) == 0;
    for (;;) {
      const Vec v = direction();
      Ring<double, 3> ring;
      for (int i = integer(4, 6); i > 0; --i) {
        ring.push_back(from + integer(-2, 2) * u + integer(-2, 2) * v);
        if (folded) ring.back()[integer(0, 2)] += integer(-1, 1);
      }
      if (auto made = triangulated(ring); !empty(made)) return made;
    }
  }
  Cylinder<double> cylinder() requires(N == 3) { return {vector(4), vector(4), number(0, 3)}; }
  Cone<double> cone() requires(N == 3) { return {vector(4), vector(4), number(0, 3)}; }

  /// One shape of each kind.
  std::vector<AnyShape<double, N>> all() {
    std::vector<AnyShape<double, N>> shapes = {Point<double, N>(vector(4)),
                                               Segment<double, N>{vector(4), vector(4)},
                                               ray(),
                                               Plane<double, N>{direction(), number(-4, 4)},
                                               Sphere<double, N>{vector(4), number(0, 3)},
                                               Capsule<double, N>{vector(4), vector(4), number(0, 2)},
                                               box(),
                                               obb(),
                                               kdop(),
                                               Triangle<double, N>{{vector(4), vector(4), vector(4)}},
                                               half_spaces_of(kdop())};
    if constexpr (N == 2) {
      Polygon<double, 2> polygon = {{{}, {}}};
      for (int i = 0; i < 5; ++i) polygon.rings[0].push_back(vector(4));
      for (int i = 0; i < 3; ++i) polygon.rings[1].push_back(vector(3));
      shapes.push_back(polygon);
    } else {
      shapes.push_back(frustum()), shapes.push_back(hull()), shapes.push_back(tetrahedron());
      shapes.push_back(polygon()), shapes.push_back(cylinder()), shapes.push_back(cone());
    }
    return shapes;
  }
};

template <int N>
bool is_line(const AnyShape<double, N>& x) {
  return std::holds_alternative<Segment<double, N>>(x) || std::holds_alternative<Ray<double, N>>(x);
}

/// The answer; an empty one where the question is not decided.
template <class A, class B>
Answer answered(const A& a, const B& b) {
  return std::optional<Answer>(ask(a, b)).value_or(Answer());
}

/// Calls check(a, b) for shapes of every two kinds, with whole numbers and others.
template <int N, class Check>
void each_pair(int rounds, const Check& check) {
  Draw<N> draw;
  for (int round = 0; round < rounds; ++round) {
    draw.whole = round % 4 != 3;
    const auto some = draw.all(), others = draw.all();
    for (const auto& a : some)
      for (const auto& b : others) {
        INFO("seed " << tests::seed() << ", round " << round << ", kinds " << a.index() << " and " << b.index());
        check(a, b);
      }
  }
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("any two shapes are answered in both orders, each the other turned round", "[answer]",
                       ((int N), N), 2, 3) {
  each_pair<N>(tests::cases(40, 4000), [](const auto& a, const auto& b) {
    const std::optional<Answer> found = ask(a, b), turned = ask(b, a);
    CHECK(found.has_value() == turned.has_value());
    if (!found || !turned) return;
    const Answer& forth = *found;
    Answer back = reversed(*turned);
    if (is_line<N>(a) && is_line<N>(b)) {
      CHECK(forth.t.has_value() == back.t.has_value());
      back.t = forth.t;  // each has its own
    }
    if (forth.triangles && a.index() == b.index()) {
      CHECK((*forth.triangles > 0) == (*back.triangles > 0));
      back.triangles = forth.triangles;  // A's, and B's
    }
    CHECK(forth == back);
  });
}

TEMPLATE_TEST_CASE_SIG("what an answer says agrees with itself", "[answer]", ((int N), N), 2, 3) {
  each_pair<N>(tests::cases(40, 4000), [](const auto& a, const auto& b) {
    const Answer x = answered(a, b);
    if (x.relation) CHECK(x.meet == (x.relation != Relation::disjoint));
    if (x.location) CHECK(x.meet == (x.location != Location::out));
    if (x.triangles) CHECK((x.meet || x.triangles == 0));
    if (x.t || x.part || x.one_point) CHECK(x.meet);
    if (x.part) CHECK((x.part->lo <= x.part->hi && x.t == x.part->lo));
  });
}

TEMPLATE_TEST_CASE_SIG("a box, an oriented box and a k-DOP of the same points get the same answers", "[answer]",
                       ((int N), N), 2, 3) {
  Draw<N> draw;
  for (int round = 0; round < tests::cases(60, 6000); ++round) {
    const Aabb<double, N> box = draw.box();
    const Vector<double, N> sum = box.lo + box.hi, size = box.hi - box.lo;
    const Obb<double, N> obb = {sum / 2, Eigen::Matrix<double, N, N>::Identity(), size / 2};
    Kdop<double, N> kdop;
    for (int i = 0; i < N; ++i) kdop.normals.push_back(Vector<double, N>::Unit(i)), kdop.slabs.push_back(box.along(i));
    for (const AnyShape<double, N>& other : draw.all()) {
      INFO("seed " << tests::seed() << ", round " << round << ", kind " << other.index());
      const Answer by_box = answered(box, other);
      for (const Answer& same : {answered(obb, other), answered(kdop, other)}) {
        CHECK(same.meet == by_box.meet);
        if (same.relation && by_box.relation) CHECK(same.relation == by_box.relation);
        CHECK(same.part.has_value() == by_box.part.has_value());
      }
    }
  }
}

TEMPLATE_TEST_CASE_SIG("a point, a ball of radius 0 and a segment without length meet the same shapes", "[answer]",
                       ((int N), N), 2, 3) {
  Draw<N> draw;
  for (int round = 0; round < tests::cases(200, 20000); ++round) {
    const Point<double, N> p = draw.vector(4);
    for (const AnyShape<double, N>& other : draw.all()) {
      INFO("seed " << tests::seed() << ", round " << round << ", kind " << other.index());
      const Answer at = ask(p, other);
      const bool of_triangles = ask(Sphere<double, N>{p, 0}, other).triangles.has_value();  // what is within meets none
      const bool meets = of_triangles ? at.location == Location::on : at.meet;
      CHECK(ask(Segment<double, N>{p, p}, other).meet == meets);
      CHECK(ask(Sphere<double, N>{p, 0}, other).meet == meets);
      if (const std::optional<Answer> capsule = ask(Capsule<double, N>{p, p, 0}, other)) CHECK(capsule->meet == meets);
    }
  }
}

TEST_CASE("an answer is what the pair's own test says", "[answer]") {
  Draw<3> draw;
  for (int round = 0; round < tests::cases(300, 30000); ++round) {
    draw.whole = round % 4 != 3;
    const Sphere<double, 3> ball = {draw.vector(4), draw.number(0, 3)}, other = {draw.vector(4), draw.number(0, 3)};
    const Aabb<double, 3> box = draw.box();
    const Ray<double, 3> ray = draw.ray();
    const Triangle<double, 3> triangle = {{draw.vector(4), draw.vector(4), draw.vector(4)}};
    const Plane<double, 3> plane = {draw.direction(), draw.number(-4, 4)};
    const Segment<double, 3> segment = {draw.vector(4), draw.vector(4)};
    const HalfSpaces hull = half_spaces_of(draw.hull());
    const Cylinder<double> cylinder = draw.cylinder();
    const Cone<double> cone = draw.cone();
    CHECK(ask(ball, other).relation == relate(ball, other));
    CHECK(ask(box, ball).relation == reversed(relate(ball, box)));
    CHECK(ask(box, triangle).relation == reversed(relate(triangle, box)));
    CHECK(ask(hull, ball).relation == reversed(relate(ball, hull)));
    CHECK(ask(box, hull).relation == relate(half_spaces_of(box), hull));
    CHECK(ask(ball.center, box).location == locate(ball.center, box));
    CHECK(ask(plane, ball.center).side == side(plane, ball.center));
    CHECK(ask(ray, box).part == intersect(ray, box));
    CHECK(ask(segment, hull).part == intersect(segment, hull));
    const RaySphere<double> in_ball = intersect(ray, ball);
    CHECK((ask(ball, ray).part == in_ball.solid && ask(ball, ray).tangent == (in_ball.line_roots == 1)));
    CHECK(ask(ray, triangle).t == first_hit(ray, triangle));
    CHECK(ask(segment, plane).t == intersect(segment, plane).t);
    CHECK(ask(cylinder, ball).relation == reversed(relate(ball, cylinder)));
    CHECK(ask(plane, cone).relation == relate(plane, cone));
    CHECK(ask(cone, ball.center).location == locate(ball.center, cone));
    CHECK(ask(ray, cylinder).part == intersect(ray, cylinder));
    CHECK(ask(segment, cone).t == first_hit(segment, cone));
    CHECK(ask(hull, cone).relation == reversed(relate(cone, hull)));
    CHECK(ask(cylinder, box).relation == relate(cylinder, half_spaces_of(box)));
  }
}

TEST_CASE("what no test decides is not compiled, or answered by nothing", "[answer]") {
  using Ball = Sphere<double, 3>;
  using Bar = Capsule<double, 3>;
  using Pipe = Cylinder<double>;
  STATIC_REQUIRE(is_decided<Pipe, Ball>);
  STATIC_REQUIRE(!is_decided<Pipe, Bar>);
  STATIC_REQUIRE(!is_decided<Bar, Pipe>);
  STATIC_REQUIRE(std::is_same_v<AnswerOf<AnyShape<double, 2>, AnyShape<double, 2>>, Answer>);
  STATIC_REQUIRE(std::is_same_v<AnswerOf<Segment<double, 3>, AnyShape<double, 3>>, Answer>);
  STATIC_REQUIRE(std::is_same_v<AnswerOf<Bar, AnyShape<double, 3>>, std::optional<Answer>>);

  const Pipe pipe = {{0, 0, 0}, {0, 0, 4}, 1};
  const Bar bar = {{0, 0, 1}, {0, 0, 3}, 0.5};
  const AnyShape<double, 3> one = pipe, other = bar, ball = Ball{{0, 0, 2}, 0.5};
  CHECK(!ask(one, other));
  CHECK(!ask(other, pipe));
  CHECK(ask(one, ball) == Answer{.meet = true, .relation = Relation::b_inside_a});
  CHECK(ask(bar, ball) == Answer{.meet = true, .relation = Relation::b_inside_a});

  std::vector<std::pair<std::size_t, std::size_t>> open;  // by their places in AnyShape
  Draw<3> draw;
  const auto all = draw.all();
  for (const auto& a : all)
    for (const auto& b : all)
      if (a.index() <= b.index() && !ask(a, b)) open.emplace_back(a.index(), b.index());
  enum : std::size_t { capsule = 5, cylinder = 15, cone };
  const std::vector<std::pair<std::size_t, std::size_t>> known = {
      {capsule, cylinder}, {capsule, cone}, {cylinder, cylinder}, {cylinder, cone}, {cone, cone}};
  CHECK(open == known);
}

TEST_CASE("a triangle meets a cylinder and a cone as a segment, a plate and a mesh do", "[answer]") {
  Draw<3> draw;
  const auto ask_all = [&](const auto& round) {
    using V = Point<double, 3>;
    const V p = draw.vector(4), q = draw.vector(4);
    CHECK(ask(Triangle<double, 3>{{p, q, V(p / 2 + q / 2)}}, round).meet == ask(Segment<double, 3>{p, q}, round).meet);
    CHECK(ask(Triangle<double, 3>{{p, p, p}}, round).meet == ask(p, round).meet);
    Aabb<double, 3> plate = {p.cwiseMin(q), p.cwiseMax(q)};
    plate.hi[2] = plate.lo[2];
    const TriangleMesh<double> halves = {
        {plate.lo, {plate.hi[0], plate.lo[1], plate.lo[2]}, plate.hi, {plate.lo[0], plate.hi[1], plate.lo[2]}},
        {{0, 1, 2}, {0, 2, 3}}};
    const Answer of_mesh = ask(halves, round);
    CHECK(of_mesh.meet == ask(plate, round).meet);
    CHECK(!of_mesh.relation);
    CHECK(of_mesh.triangles == ask(triangle(halves, 0), round).meet + ask(triangle(halves, 1), round).meet);
  };
  for (int round = 0; round < tests::cases(200, 20000); ++round) {
    draw.whole = round % 4 != 3;
    INFO("seed " << tests::seed() << ", round " << round);
    ask_all(draw.cylinder());
    ask_all(draw.cone());
  }
}

TEST_CASE("planes, tangency and lines are told apart", "[answer]") {
  using P = Plane<double, 3>;
  const P floor = {{0, 2, 0}, 0};
  const auto both = [](const P& a, const P& b) { return std::pair(ask(a, b).relation, ask(a, b).parallel); };
  CHECK(both(floor, {{0, -3, 0}, 0}) == std::pair(std::optional(Relation::equal), true));
  CHECK(both(floor, {{0, 1, 0}, 1e-300}) == std::pair(std::optional(Relation::disjoint), true));
  CHECK(both(floor, {{1e-300, 1, 0}, 0}) == std::pair(std::optional(Relation::overlapping), false));
  CHECK(both(floor, {{0, 0, 0}, 0}) == std::pair(std::optional(Relation::disjoint), false));
  CHECK(ask(Plane<double, 2>{{1, 2}, 3}, Plane<double, 2>{{2, 4}, 6}).relation == Relation::equal);

  const Sphere<double, 3> ball = {{0, 0, 0}, 5};
  CHECK(ask(ball, Sphere<double, 3>{{3, 0, 0}, 2}).tangent);
  CHECK(!ask(ball, Sphere<double, 3>{{3, 0, 0}, 1}).tangent);
  CHECK(ask(ball, Sphere<double, 3>{{3, 4, 0}, 0}).tangent);
  CHECK(ask(Capsule<double, 3>{{0, 1, 0}, {0, 3, 0}, 1}, floor).relation == Relation::touching);
  CHECK(ask(Capsule<double, 3>{{0, 2, 0}, {0, 3, 0}, 1}, floor).relation == Relation::disjoint);
  CHECK(ask(Capsule<double, 3>{{0, -2, 0}, {0, 3, 0}, 1}, floor).relation == Relation::overlapping);
  CHECK(ask(Capsule<double, 3>{{0, -2, 0}, {0, 0, 0}, 0}, floor).relation == Relation::touching);

  const Triangle<double, 3> on = {{Point<double, 3>{0, 0, 0}, Point<double, 3>{1, 0, 0}, Point<double, 3>{0, 0, 1}}};
  CHECK((ask(floor, on).coplanar && ask(floor, on).side == 0));
  const Triangle<double, 3> above = {{Point<double, 3>{0, 0, 0}, Point<double, 3>{1, 1, 0}, Point<double, 3>{0, 2, 1}}};
  CHECK((ask(above, floor).relation == Relation::touching && ask(above, floor).side == 1));

  const Ray<double, 2> x_axis = {{0, 0}, {1, 0}};
  CHECK(ask(Point<double, 2>{3, 1}, x_axis).side == 1);
  CHECK((ask(Point<double, 2>{-3, 0}, x_axis).side == 0 && !ask(Point<double, 2>{-3, 0}, x_axis).meet));
  const Segment<double, 2> a = {{1, -1}, {1, 1}}, b = {{-1, 0}, {1, 0}}, c = {{0.5, 0}, {4, 0}};
  CHECK((ask(a, b).one_point && ask(a, b).t == 0.5));
  CHECK((ask(b, c).meet && !ask(b, c).one_point && ask(b, c).t == 0.75));
}

TEST_CASE("in the plane, what is convex lies within a polygon, in a hole of it, or across an edge", "[answer]") {
  const Polygon<double, 2> frame = {{{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{3, 3}, {6, 3}, {6, 6}, {3, 6}}}};
  const auto kdop = [](double x, double y, double half) {
    return Kdop<double, 2>{{{3, 1}, {-1, 3}},
                           {{3 * x + y - half, 3 * x + y + half}, {3 * y - x - half, 3 * y - x + half}}};
  };
  for (const double half : {0.0, 0.25, 1.0}) {  // its corners are not doubles
    CHECK(ask(frame, kdop(1.5, 1.5, half)).meet);
    CHECK(!ask(frame, kdop(4.5, 4.5, half)).meet);
    CHECK(!ask(kdop(-2, 4, half), frame).meet);
    CHECK(ask(kdop(3, 4, half), frame).meet);
  }
  CHECK(ask(frame, Obb<double, 2>{{1.5, 1.5}, Eigen::Matrix2d::Identity(), {1, 1}}).meet);
  CHECK(!ask(frame, Obb<double, 2>{{4.5, 4.5}, Eigen::Matrix2d::Identity(), {1.25, 1.25}}).meet);
  CHECK(ask(frame, Obb<double, 2>{{4.5, 4.5}, Eigen::Matrix2d::Identity(), {1.5, 1}}).meet);
  CHECK(ask(Sphere<double, 2>{{1.5, 1.5}, 1}, frame).meet);
  CHECK(!ask(Sphere<double, 2>{{4.5, 4.5}, 1.25}, frame).meet);
  CHECK(ask(Sphere<double, 2>{{4.5, 4.5}, 1.5}, frame).meet);
  CHECK(ask(Aabb<double, 2>{{1, 1}, {2, 2}}, frame).relation == Relation::a_inside_b);
  CHECK(ask(Aabb<double, 2>{{1, 1}, {1, 2}}, frame).relation == Relation::a_inside_b);  // no more than a segment
  CHECK(ask(Aabb<double, 2>{{1, 1}, {1, 12}}, frame).relation == Relation::overlapping);
}

TEST_CASE("an open mesh holds no point but those on it", "[answer]") {
  TriangleMesh<double> mesh = {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}},
                               {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  const Point<double, 3> within = {1, 1, 1}, on = {1, 1, 0};
  CHECK(ask(within, mesh).location == Location::in);
  CHECK(ask(Sphere<double, 3>{within, 0.25}, mesh) == Answer{.relation = Relation::a_inside_b, .triangles = 0});
  CHECK(ask(Sphere<double, 3>{on, 0.25}, mesh) ==
        Answer{.meet = true, .relation = Relation::overlapping, .triangles = 1});
  const Obb<double, 3> small = {within, Eigen::Matrix3d::Identity(), {0.25, 0.25, 0.25}};
  CHECK(ask(small, mesh) == Answer{.relation = Relation::a_inside_b, .triangles = 0});
  CHECK(ask(mesh, mesh).triangles == 4);
  CHECK(ask(Ray<double, 3>{{1, 1, -1}, {0, 0, 2}}, mesh) == Answer{.meet = true, .t = 0.5, .triangles = 2});
  mesh.triangles.pop_back();
  CHECK(ask(within, mesh) == Answer{});
  CHECK(ask(small, mesh) == Answer{.triangles = 0});
  CHECK(ask(Sphere<double, 3>{within, 0.25}, mesh) == Answer{.triangles = 0});
  CHECK(ask(mesh, on).location == Location::on);
}

TEMPLATE_TEST_CASE_SIG("NaN and infinite coordinates meet nothing", "[answer]", ((int N), N), 2, 3) {
  Draw<N> draw;
  for (int round = 0; round < 20; ++round)
    for (const double wrong : {not_a_number, inf}) {
      Point<double, N> bad = draw.vector(4);
      bad[draw.integer(0, N - 1)] = wrong;
      Kdop<double, N> kdop = draw.kdop();
      kdop.slabs[0].hi = wrong;
      std::vector<AnyShape<double, N>> all = {
          bad,
          Segment<double, N>{draw.vector(4), bad},
          Ray<double, N>{bad, draw.direction()},
          Plane<double, N>{draw.direction(), wrong},
          Sphere<double, N>{bad, 1},
          Capsule<double, N>{draw.vector(4), bad, 1},
          Aabb<double, N>{draw.vector(4), bad},
          Obb<double, N>{bad, Eigen::Matrix<double, N, N>::Identity(), Vector<double, N>::Ones()},
          kdop,
          Triangle<double, N>{{bad, draw.vector(4), draw.vector(4)}}};
      if constexpr (N == 3) {
        all.push_back(Cylinder<double>{draw.vector(4), bad, 1});
        all.push_back(Cone<double>{draw.vector(4), bad, 1});
      }
      for (const auto& a : all)
        for (const auto& b : draw.all()) {
          INFO("seed " << tests::seed() << ", round " << round << ", kinds " << a.index() << " and " << b.index());
          CHECK(!answered(a, b).meet);
          CHECK(!answered(b, a).meet);
        }
    }
}

TEST_CASE("floats are asked as doubles are", "[answer]") {
  Draw<3> draw;
  for (int round = 0; round < 100; ++round) {
    const Sphere<double, 3> ball = {draw.vector(4), draw.number(0, 3)};
    const Aabb<double, 3> box = draw.box();
    const Segment<double, 3> segment = {draw.vector(4), draw.vector(4)};
    const Ray<double, 3> ray = draw.ray();
    CHECK(ask(cast<float>(ball), cast<float>(box)) == ask(ball, box));
    CHECK(ask(cast<float>(segment), cast<float>(ray)).meet == ask(segment, ray).meet);
    CHECK(ask(cast<float>(segment), cast<float>(ball)).meet == ask(segment, ball).meet);
  }
}

}  // namespace answer_test
