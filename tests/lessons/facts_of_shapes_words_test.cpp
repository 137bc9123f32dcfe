// Facts about boxes, polygons, meshes and motions that stand in captions and in solutions of exercises. Each is
// computed here.

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <isect/aabb_aabb.h>
#include <isect/clip_polygon.h>
#include <isect/convex_hull.h>
#include <isect/many/slab_map.h>
#include <isect/many/trapezoid_map.h>
#include <isect/methods/aabb_aabb.h>
#include <isect/methods/motion.h>
#include <isect/methods/nearest_features.h>
#include <isect/orient.h>
#include <isect/point_mesh.h>
#include <isect/ray_plane.h>
#include <isect/sphere_sphere.h>
#include <isect/triangle_aabb.h>
#include <Eigen/Geometry>
#include "bench/random.h"
#include "lessons/bounding_volumes/object.h"
#include "lessons/crossings/situations.h"
#include "tests/lessons/words.h"
#include "viz/text/rich_text.h"

namespace facts_of_shapes_words_test {
using namespace isect;
using namespace isect::viz;
using namespace isect::tests;
using isect::test::Contains;
using Box2d = Aabb<double, 2>;

namespace {

/// An 8-DOP of the plane, with integer bounds.
struct Dop {
  static constexpr std::array<std::array<int, 2>, 4> normals = {{{1, 0}, {0, 1}, {1, 1}, {1, -1}}};
  std::array<int, 4> lo = {}, hi = {};

  explicit Dop(const std::vector<std::array<int, 2>>& points) {
    for (std::size_t i = 0; i < 4; ++i) {
      std::vector<int> along;
      for (const auto& p : points) along.push_back(normals[i][0] * p[0] + normals[i][1] * p[1]);
      lo[i] = std::ranges::min(along), hi[i] = std::ranges::max(along);
    }
  }
  /// Whether it contains (x, y) / 2.
  bool contains_half(int x, int y) const {
    bool in = true;
    for (std::size_t i = 0; i < 4; ++i) {
      const int along = normals[i][0] * x + normals[i][1] * y;
      in = in && 2 * lo[i] <= along && along <= 2 * hi[i];
    }
    return in;
  }
};

}  // namespace

TEST_CASE("in the plane tight k-DOPs are apart only if one of their normals says so", "[words]") {
  CHECK(told("bounding-volumes", "In the plane the normals are enough, where each bound is tight."));
  bench::Random random = random_of("octagons");
  int apart = 0;
  for (int k = 0; k < 200; ++k) {
    const auto dop = [&] {
      std::vector<std::array<int, 2>> points;
      for (int i = 0; i < 3; ++i) {
        const int x = random.integer(0, 8), y = random.integer(0, 8);
        points.push_back({x, y});
      }
      return Dop(points);
    };
    const Dop a = dop(), b = dop();
    bool overlap = true, common = false;
    for (std::size_t i = 0; i < 4; ++i) overlap = overlap && a.lo[i] <= b.hi[i] && b.lo[i] <= a.hi[i];
    for (int x = 0; x <= 16; ++x)  // what they share has a vertex, and its coordinates are halves
      for (int y = 0; y <= 16; ++y) common = common || (a.contains_half(x, y) && b.contains_half(x, y));
    CHECK(overlap == common);
    apart += !common;
  }
  CHECK(apart > 0);
}

TEST_CASE("comparisons take an empty box for one that meets others", "[words]") {
  CHECK(solved_with("aabb-aabb", "With exchanged ends a box is empty"));
  const Box2d a = {{0, 0}, {4, 4}}, exchanged = {{3, 3}, {1, 1}};
  for (int i = 0; i < 2; ++i) CHECK((a.lo[i] <= exchanged.hi[i] && exchanged.lo[i] <= a.hi[i]));
  CHECK_FALSE(intersects(a, exchanged));
}

TEST_CASE("a ball of radius 0 and its point are equal", "[words]") {
  CHECK(solved_with("relations", "A ball of radius 0 is a point itself"));
  const Sphere<double, 3> point = {{1, 2, 3}, 0}, other = {{1, 2, 4}, 0};
  CHECK(relate(point, point) == Relation::equal);
  CHECK(relate(point, other) == Relation::disjoint);
}

TEST_CASE("counting says OUT of the highest vertex, whatever it says elsewhere on the boundary", "[words]") {
  int seen = 0;
  for (const Preset& p : lesson("crossings").presets)
    for (const Step& s : lesson("crossings").walk(p.parameters).steps) {
      if (!says(s.caption, "Of the highest vertex it would say OUT")) continue;
      ++seen;
      CHECK_THAT(s.caption, Contains("Counting alone would say IN"));
    }
  CHECK(seen > 0);
  for (const Preset& p : lesson("crossings").presets) {
    INFO(p.id);
    Vec2 top(0, -INFINITY);
    const lessons::crossings_lesson::Setup setup(p.parameters);
    for (const Ring<double, 2>& ring : setup.polygon.rings)
      for (const auto& v : ring)
        if (v.y() > top.y()) top = v;
    const Walk walk =
        with("crossings", p.id, {{"rule", "half-open"}, {"p", to_text(Setting(Vec3(top.x(), top.y(), 0)))}});
    const Step* const on = find(walk, "on");
    REQUIRE(on);
    CHECK_THAT(on->caption, Contains("Counting alone would say OUT, "));
  }
}

TEST_CASE("of a shape with dents no axis may separate what its convex parts show to be apart", "[words]") {
  CHECK(solved_with("collision", "into convex parts (a compound)"));
  const std::array<Box2d, 2> parts = {Box2d{{0, 0}, {4, 1}}, Box2d{{0, 0}, {1, 4}}};  // an L
  const Box2d other = {{1.5, 1.5}, {2, 2}};
  for (const Box2d& part : parts) CHECK_FALSE(intersects(part, other));
  for (int k = 0; k < 360; ++k) {
    const Vec2 n(std::cos(k), std::sin(k));
    const auto reach = [&](const Box2d& box) {
      Interval<double> all = {INFINITY, -INFINITY};
      for (const Vec2& corner :
           {Vec2(box.lo), Vec2(box.hi), Vec2(box.lo.x(), box.hi.y()), Vec2(box.hi.x(), box.lo.y())})
        all = {std::min(all.lo, n.dot(corner)), std::max(all.hi, n.dot(corner))};
      return all;
    };
    const Interval<double> first = reach(parts[0]), second = reach(parts[1]), x = reach(other);
    CHECK((std::min(first.lo, second.lo) <= x.hi && x.lo <= std::max(first.hi, second.hi)));
  }
}

TEST_CASE("at 120 Hz the body and the wall of the exercise tunnel above the told speed", "[words]") {
  CHECK(solved_with("collision", "= 66 m/s still can"));
  const auto tunnels = [](double speed, int tests_a_second) {
    const double step = speed / tests_a_second, duration = 12.0 / tests_a_second;
    const Moving<Aabb, double, 2> wall = {{{0, -1}, {0.45, 1}}, {0, 0}};
    bool unseen = false;
    for (int k = 0; k < 200; ++k) {
      const double x = -1 - step * k / 200;
      const Moving<Aabb, double, 2> body = {{{x, -0.05}, {x + 0.1, 0.05}}, {speed, 0}};
      unseen = unseen || (contact(body, wall, duration) && discrete_hits(body, wall, duration, 12).empty());
    }
    return unseen;
  };
  CHECK_FALSE(tunnels(30, 60));
  CHECK_FALSE(tunnels(65, 120));
  CHECK(tunnels(67, 120));
}

TEST_CASE("bridges of a clipped polygon have no area", "[words]") {
  CHECK(told("clipping", "bridges do no harm: they have no area"));
  const Ring<double, 2> u = {{0, 0}, {6, 0}, {6, 4}, {4, 4}, {4, 2}, {2, 2}, {2, 4}, {0, 4}};
  const Ring<double, 2> kept = clip(u, Box2d{{-1, 3}, {7, 5}});
  double twice = 0;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const auto &p = kept[i], &q = kept[(i + 1) % kept.size()];
    twice += p.x() * q.y() - p.y() * q.x();
  }
  CHECK(twice / 2 == Approx(4));  // two pieces, 2 by 1 each
}

TEST_CASE("points behind the eye come out mirrored", "[words]") {
  CHECK(solved_with("clipping", "would come out mirrored"));
  const Plane<double, 3> image = {{0, 0, 1}, -1};  // the eye is the origin, so w is z
  for (const Vec3& p : {Vec3(3, 1, 2), Vec3(3, 1, -2), Vec3(-1, 5, -4)}) {
    const auto t = intersect(Ray<double, 3>{{0, 0, 0}, p}, image).line;
    REQUIRE(t);
    CHECK((*t * p - p / p.z()).norm() < 1e-15);  // what the division shows lies on the line through eye and p
    CHECK((*t < 0) == (p.z() < 0));              // on the other side of the eye
  }
}

TEST_CASE("a point clamped in an oriented box's own frame is the one that no corner lies before", "[words]") {
  CHECK(solved_with("sphere-aabb", "Clamp them to ± its half-lengths, and go back."));
  bench::Random random = random_of("frames");
  for (int k = 0; k < 50; ++k) {
    const Vec3 axis = random.heading<3>(), half = random.in_box<3>(1).cwiseAbs(), centre = random.in_box<3>(1);
    const double angle = random.uniform(0, 3);
    const Eigen::Matrix3d axes = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
    const Vec3 c = random.in_box<3>(3), own = axes.transpose() * (c - centre);
    const Vec3 p = centre + axes * own.cwiseMax(-half).cwiseMin(half);
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 side((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1, (corner & 4) != 0 ? 1 : -1);
      const Vec3 at = centre + axes * side.cwiseProduct(half);
      CHECK((c - p).dot(at - p) <= 1e-9);
    }
  }
}

TEST_CASE("sorted by angle around an interior point the vertices turn left", "[words]") {
  CHECK(solved_with("convex-polygon", "by angle around an interior point"));
  bench::Random random = random_of("angles");
  Ring<double, 2> points;
  for (int i = 0; i < 30; ++i) points.push_back(random.in_box<2>(1));
  Ring<double, 2> ring = convex_hull(points);
  Vec2 middle(0, 0);
  for (const auto& v : ring) middle += v / static_cast<double>(ring.size());
  std::ranges::sort(ring, {}, [](const Point<double, 2>& v) { return v.x(); });
  std::ranges::sort(ring, {},
                    [&](const Point<double, 2>& v) { return std::atan2(v.y() - middle.y(), v.x() - middle.x()); });
  for (std::size_t i = 0, n = ring.size(); i < n; ++i)
    CHECK(orient2d(ring[i], ring[(i + 1) % n], ring[(i + 2) % n]) > 0);
}

TEST_CASE("axes that are turned a little, many times, drift, and can be renewed", "[words]") {
  CHECK(solved_with("obb-obb", "Renew them by Gram and Schmidt"));
  const Eigen::Matrix3f turn = Eigen::AngleAxisf(1e-3F, Eigen::Vector3f(1, 2, 3).normalized()).toRotationMatrix();
  Eigen::Matrix3f axes = Eigen::Matrix3f::Identity();
  for (int k = 0; k < 20000; ++k) axes = (turn * axes).eval();
  const auto fault = [](const Eigen::Matrix3f& m) { return (m.transpose() * m - Eigen::Matrix3f::Identity()).norm(); };
  const Eigen::Vector3f u = axes.col(0).normalized(), v = (axes.col(1) - u * u.dot(axes.col(1))).normalized();
  Eigen::Matrix3f renewed;
  renewed << u, v, u.cross(v);
  CHECK(fault(renewed) < 1e-6F);
  CHECK(fault(axes) > 10 * fault(renewed));
}

TEST_CASE("a ray through an instance's inverse matrix keeps its places", "[words]") {
  CHECK(solved_with("ray-tracing", "do not normalise d: then t stays the same."));
  Eigen::Matrix3d matrix;
  matrix << 2, 1, 0, 0, 3, 1, 1, 0, 2;
  const Vec3 shift(1, -2, 3), o(4, 5, 6), d(-1, 2, 0.5);
  const Vec3 own_o = matrix.inverse() * (o - shift), own_d = matrix.inverse() * d;
  for (const double t : {0.0, 0.5, 3.0}) CHECK((matrix * (own_o + t * own_d) + shift - (o + t * d)).norm() < 1e-12);
}

TEST_CASE("a box that meets no triangle of a closed mesh lies on one side of it, with all of its points", "[words]") {
  CHECK(told("bounding-volumes", "b is connected and meets no triangle, so it lies on one side of the surface."));
  const Parameters& p = preset(lesson("bounding-volumes"), "within").parameters;
  const auto mesh = lessons::bounding_volumes_lesson::object(text(p, "object"), std::get<Vec3>(p.at("tip")));
  bench::Random random = random_of("sides");
  int inside = 0, outside = 0;
  for (int k = 0; k < 60; ++k) {
    const Vec3 near = k % 2 == 0 ? std::get<Vec3>(p.at("q")) : Vec3(0, 0, 0);
    const Vec3 shift = random.in_box<3>(k % 2 == 0 ? 0.0625 : 1.5), half = random.in_box<3>(0.125).cwiseAbs();
    const Vec3 middle = near + shift;
    const Aabb<double, 3> box = {middle - half, middle + half};
    bool meets = false;
    for (int i = 0; i < static_cast<int>(mesh.triangles.size()); ++i)
      meets = meets || intersects(triangle(mesh, i), box);
    if (meets) continue;
    const Location side = locate(middle, mesh);
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 at((corner & 1) != 0 ? box.hi.x() : box.lo.x(), (corner & 2) != 0 ? box.hi.y() : box.lo.y(),
                    (corner & 4) != 0 ? box.hi.z() : box.lo.z());
      CHECK(locate(at, mesh) == side);
    }
    ++(side == Location::in ? inside : outside);
  }
  CHECK((inside > 0 && outside > 0));
}

TEST_CASE("an empty box from infinity to minus infinity has a gap to others, and adds nothing to them", "[words]") {
  CHECK(solved_with("aabb-aabb", "So store an empty box with the ends min = ∞ and max = −∞."));
  CHECK(told("intervals", "Best stored as [∞, −∞], an empty one has a gap to each bounded one."));
  const Box2d empty = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
  for (const Box2d& box : {Box2d{{0, 0}, {4, 4}}, Box2d{{-1e300, 2}, {1e300, 2}}}) {
    CHECK(empty.lo.x() > box.hi.x());
    CHECK(box.lo.x() > empty.hi.x());
    CHECK_FALSE(aabb_aabb::by_axis(empty, box));
    CHECK_FALSE(intersects(box, empty));
    CHECK(box.lo.cwiseMin(empty.lo) == box.lo);
    CHECK(box.hi.cwiseMax(empty.hi) == box.hi);
  }
}

TEST_CASE("on the ray between two wedges the far edges of both give one verdict", "[words]") {
  const Walk on_ray = with("convex-polygon", "on-vertex", {{"p", "-1,0,0"}});
  CHECK_THAT(find(on_ray, "bisect-1")->caption, Contains("The wedges on both sides give the same verdict"));
  CHECK(solved_with("convex-polygon", "On a ray between two wedges either gives the same verdict."));
  const Ring<double, 2> v = {{0, 0}, {8, -4}, {16, 0}, {18, 8}, {12, 16}, {0, 18}, {-6, 8}};
  for (std::size_t mid = 2; mid + 2 < v.size(); ++mid)
    for (const double t : {0.5, 1.0, 1.5}) {
      const Vec2 p = v[0] + t * (v[mid] - v[0]);  // exact
      const int before = orient2d(v[mid - 1], v[mid], p), after = orient2d(v[mid], v[mid + 1], p);
      CHECK(before == after);
      CHECK(before == (t < 1 ? 1 : t == 1 ? 0 : -1));
    }
}

TEST_CASE("vertices of one height share a line of slabs, and of one x they are ordered as by a shear", "[words]") {
  CHECK(told("concave-polygon", "Two vertices at one height would part a slab of width 0: it is left out"));
  CHECK(told("concave-polygon", "Vertices of one x are ordered by y, as if the plane had been sheared a little."));
  const Ring<double, 2> ring = {{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}};
  CHECK(make_slab_map(ring).slabs.size() == 3 + 1);  // three heights, and what ends them
  Ring<double, 2> sheared = ring;
  for (auto& v : sheared) v.x() += v.y() / 64;
  CHECK(make_trapezoid_map(ring).trapezoids.size() == make_trapezoid_map(sheared).trapezoids.size());
}

TEST_CASE("of disjoint convex polygons a vertex is among the nearest features, of tetrahedra perhaps none", "[words]") {
  CHECK(solved_with("distance", "So a vertex is among the nearest features. In space two edges may be nearest alone"));
  bench::Random random = random_of("features");
  for (int k = 0; k < 100; ++k) {
    const auto polygon = [&](const Vec2& middle) {
      Ring<double, 2> points;
      for (int i = 0; i < 6; ++i) points.push_back(middle + random.in_box<2>(1));
      return convex_hull(points);
    };
    const Ring<double, 2> a = polygon(Vec2(0, 0)), b = polygon(Vec2(2.5, 1));
    double edges = INFINITY, vertices = INFINITY;
    for (std::size_t i = 0; i < a.size(); ++i)
      for (std::size_t j = 0; j < b.size(); ++j) {
        const Segment<double, 2> e = {a[i], a[(i + 1) % a.size()]}, f = {b[j], b[(j + 1) % b.size()]};
        edges = std::min(edges, nearest_features::distance2<double, 2>(e, f));
        vertices = std::min(
            {vertices, nearest_features::distance2<double, 2>(e.p, f), nearest_features::distance2<double, 2>(f.p, e)});
      }
    CHECK(vertices == Approx(edges));
  }
  // Edges of tetrahedra below z = 0 and above z = 1. No other point of these reaches those planes.
  const Segment<double, 3> below = {{-1, 0, 0}, {1, 0, 0}}, above = {{0, -1, 1}, {0, 1, 1}};
  CHECK(nearest_features::distance2<double, 3>(below, above) == 1);
  for (const Vec3& end : {above.p, above.q}) CHECK(nearest_features::distance2<double, 3>(end, below) > 1);
  for (const Vec3& end : {below.p, below.q}) CHECK(nearest_features::distance2<double, 3>(end, above) > 1);
}

}  // namespace facts_of_shapes_words_test
