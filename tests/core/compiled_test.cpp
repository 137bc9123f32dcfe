// The compiled library says what the headers say: its shapes have the numbers they were made of.

#include <isect/compiled.h>

#include <random>
#include <stdexcept>
#include <utility>

#include <isect/ask_any.h>
#include <isect/convex_hull_3d.h>
#include "tests/catch.h"
#include "tests/settings.h"

namespace compiled_test {
using namespace isect;
using compiled::Shape, compiled::Shape2, compiled::Shape3;

namespace {

/// A shape of the library and the same of the core.
template <int N>
using Both = std::pair<Shape<N>, AnyShape<double, N>>;

template <int N>
struct Draw {
  using P = std::array<double, N>;
  std::mt19937_64 random{tests::seed()};

  double number(int lo, int hi) { return std::uniform_int_distribution<int>(4 * lo, 4 * hi)(random) / 4.0; }
  P point() {
    P p;
    for (double& x : p) x = number(-3, 3);
    return p;
  }
  std::vector<P> points(int count) {
    std::vector<P> all;
    while (count-- > 0) all.push_back(point());
    return all;
  }
  std::vector<Both<N>> all();
};

template <std::size_t N>
Point<double, N> v(const std::array<double, N>& p) {
  return Point<double, N>(p.data());
}
template <std::size_t N>
Ring<double, N> ring(const std::vector<std::array<double, N>>& points) {
  Ring<double, N> all;
  for (const auto& p : points) all.push_back(v(p));
  return all;
}

std::vector<Both<2>> further(Draw<2>& draw) {
  const auto outer = draw.points(5), hole = draw.points(3);
  return {{Shape2::polygon({outer, hole}), Polygon<double, 2>{{ring(outer), ring(hole)}}}};
}
std::vector<Both<3>> further(Draw<3>& draw) {
  std::vector<Both<3>> all;
  const auto p = draw.point(), q = draw.point();
  const double radius = draw.number(0, 2);
  all.emplace_back(Shape3::cylinder(p, q, radius), Cylinder<double>{v(p), v(q), radius});
  all.emplace_back(Shape3::cone(p, q, radius), Cone<double>{v(p), v(q), radius});

  const std::vector<std::array<double, 3>> outline = {{-2, 0, 1}, {2, -1, 1}, {0, 0, 1}, {2, 3, 1}};
  all.emplace_back(Shape3::polygon(outline), triangulated(ring(outline)));

  const auto corners = draw.points(4);
  const std::vector<std::array<int, 3>> faces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  all.emplace_back(Shape3::mesh(corners, faces), TriangleMesh<double>{ring(corners), faces});
  if (Hull3<double> hull = convex_hull(ring(corners)); hull.dimension == 3)
    all.emplace_back(Shape3::hull(corners), std::move(hull));

  std::array<Shape3::Plane, 6> planes = {{{{2, 0, 1}, 1}, {{-2, 0, 1}, 1}, {{0, 2, 1}, 1}, {{0, -2, 1}, 1}}};
  planes[4] = {{0, 0, 1}, draw.number(0, 2)}, planes[5] = {{0, 0, -1}, draw.number(1, 3)};
  Frustum<double> frustum;
  for (std::size_t i = 0; i < 6; ++i) frustum.planes[i] = {v(planes[i].normal), planes[i].d};
  all.emplace_back(Shape3::frustum(planes), frustum);
  return all;
}

template <int N>
std::vector<Both<N>> Draw<N>::all() {
  using Made = Shape<N>;
  const P p = point(), q = point(), r = point();
  const double number = this->number(0, 2);
  Obb<double, N> obb = {v(p), Eigen::Matrix<double, N, N>::Identity(), v(q).cwiseAbs()};
  obb.axes(0, 1) = 1;
  std::array<P, N> axes;
  P half;
  Kdop<double, N> kdop;
  std::vector<typename Made::Slab> slabs;
  for (int i = 0; i < N; ++i) {
    const auto k = static_cast<std::size_t>(i);
    for (int j = 0; j < N; ++j) axes[k][static_cast<std::size_t>(j)] = obb.axes(j, i);
    half[k] = obb.half[i];
    slabs.push_back({axes[k], {-number, number + i}});
    kdop.normals.push_back(v(axes[k])), kdop.slabs.push_back({-number, number + i});
  }
  std::vector<Both<N>> shapes = {
      {Made::point(p), v(p)},
      {Made::segment(p, q), Segment<double, N>{v(p), v(q)}},
      {Made::ray(p, q), Ray<double, N>{v(p), v(q)}},
      {Made::ray(p, q, {-1, 2}), Ray<double, N>{v(p), v(q), {-1, 2}}},
      {Made::plane(p, number), Plane<double, N>{v(p), number}},
      {Made::sphere(p, number), Sphere<double, N>{v(p), number}},
      {Made::capsule(p, q, number), Capsule<double, N>{v(p), v(q), number}},
      {Made::aabb(p, q), Aabb<double, N>{v(p), v(q)}},
      {Made::obb(p, axes, half), obb},
      {Made::kdop(slabs), kdop},
      {Made::triangle(p, q, r), Triangle<double, N>{{v(p), v(q), v(r)}}},
  };
  for (Both<N>& more : further(*this)) shapes.push_back(std::move(more));
  return shapes;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("any two shapes of the compiled library get the core's answer", "[compiled]", ((int N), N), 2,
                       3) {
  Draw<N> draw;
  int meet = 0;
  for (int round = 0; round < tests::cases(40, 4000); ++round) {
    const std::vector<Both<N>> some = draw.all(), others = draw.all();
    for (const auto& [a, as_core] : some)
      for (const auto& [b, bs_core] : others) {
        INFO("seed " << tests::seed() << ", round " << round << ", kinds " << as_core.index() << " and "
                     << bs_core.index());
        const std::optional<Answer> answer = ask(a, b);
        CHECK(answer == std::optional<Answer>(ask_any(as_core, bs_core)));
        meet += answer && answer->meet;
      }
  }
  CHECK(meet > 1000);
}

TEST_CASE("a copy of a compiled shape outlives the first, and one that was moved from can be assigned to",
          "[compiled]") {
  Shape3 ball = Shape3::sphere({0, 0, 0}, 1);
  const Shape3 point = Shape3::point({0, 0, 1});
  const Shape3 copy = ball;
  Shape3 moved = std::move(ball);
  ball = Shape3::sphere({0, 0, 5}, 1);
  CHECK(ask(copy, point)->location == Location::on);
  CHECK(ask(moved, point)->location == Location::on);
  CHECK(ask(ball, point)->location == Location::out);
  moved = ball;
  CHECK(ask(moved, point)->location == Location::out);
}

TEST_CASE("the compiled library refuses a mesh with an index of no vertex and a flat hull", "[compiled]") {
  CHECK_THROWS_AS(Shape3::mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 3}}), std::invalid_argument);
  CHECK_THROWS_AS(Shape3::mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, -1}}), std::invalid_argument);
  CHECK_THROWS_AS(Shape3::hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}), std::invalid_argument);
  CHECK_THROWS_AS(Shape3::hull({}), std::invalid_argument);
}

}  // namespace compiled_test
