// The kinds of items, each by the shapes it becomes.

#include <algorithm>
#include <cmath>
#include <set>

#include <isect/convex_hull_3d.h>
#include "tests/catch.h"
#include "tests/viz/pixels.h"
#include "viz/compose/compose.h"
#include "viz/compose/small_multiples.h"
#include "viz/solids.h"
#include "viz/text/text.h"

namespace items_test {
using namespace isect;
using namespace isect::viz;

namespace {

Camera straight_on() {
  Camera camera;
  camera.azimuth = camera.elevation = 0;
  return camera;
}

struct Drawn {
  Theme style;
  View view;
  Composed composed;

  template <class T>
  std::vector<T> all() const {
    std::vector<T> found;
    for (const Shape& s : composed.shapes)
      if (const T* t = std::get_if<T>(&s)) found.push_back(*t);
    return found;
  }
  double length(Role role, bool dashed) const {
    double sum = 0;
    for (const Stroke& s : all<Stroke>()) {
      if (s.colour.b != style.ink(role).b || (s.dash[0] > 0) != dashed) continue;
      std::vector<Vec2> points = flatten(s.path);
      if (s.path.closed) points.push_back(points.front());
      for (std::size_t i = 1; i < points.size(); ++i) sum += (points[i] - points[i - 1]).norm();
    }
    return sum;
  }
};

Drawn drawn(const std::vector<Item>& items, ThemeName name = ThemeName::print, const Camera& camera = straight_on()) {
  const Scene scene = {items, {}, {}};
  const Theme style = theme(name, 480, 300);
  const View view(frame(camera, {&scene}, 1.6), 480, 300);
  return {style, view, compose(scene, view, style)};
}

const Aabb<double, 3> box = {{-1, -1, -1}, {1, 1, 1}};

}  // namespace

TEST_CASE("a solid shows its front faces, the darker the less light falls on them", "[items]") {
  Camera camera;  // front, right and top
  const Drawn d = drawn({solid(box, Role::first)}, ThemeName::print, camera);
  std::vector<double> alphas;
  for (const Fill& fill : d.all<Fill>()) alphas.push_back(fill.colour.a);
  REQUIRE(alphas.size() == 3);
  std::sort(alphas.begin(), alphas.end());
  CHECK(alphas[0] == Approx(d.style.fill_alpha * (1.9 - 1.45 * 0.793)).epsilon(0.01));  // the top
  CHECK(alphas[2] == Approx(d.style.fill_alpha * 1.9));                                 // turned away from the light
  CHECK(d.length(Role::first, true) > 0);
  CHECK(d.length(Role::first, false) > 2.5 * d.length(Role::first, true));
}

TEST_CASE("a box behind another is dashed there, a ball too", "[items]") {
  const Item screen = solid(Aabb<double, 3>{{0, -3, 2}, {3, 3, 3}}, Role::second);
  const Drawn boxes = drawn({solid(box, Role::first), screen});
  CHECK(boxes.length(Role::first, true) > 0.4 * boxes.length(Role::first, false));
  const Drawn ball = drawn({Ball{{0, 0, 0}, 1, Role::hit}, screen});
  const double rim = 3.14159 * ball.view.scale_at({0, 0, 0});
  CHECK(ball.length(Role::hit, true) > rim);  // half the silhouette, and half of the equator
}

TEST_CASE("a triangulated box has twelve edges still", "[items]") {
  std::vector<Vec3> corners = solid(box, Role::first).vertices;
  const Solid hull = solid(convex_hull<double>(std::span<const Vec3>(corners)), Role::first);
  CHECK(hull.faces.size() == 12);
  const auto strokes = [](const Solid& s) { return drawn({s}, ThemeName::print, Camera{}).all<Stroke>().size(); };
  CHECK(strokes(hull) == 12);
  CHECK(strokes(solid(box, Role::first)) == 12);
}

TEST_CASE("what two objects share has the thickest outline, dashed where it is hidden", "[items]") {
  const Drawn d = drawn({solid(box, Role::second), Circle{{0, 0, 0}, 2, Role::hit, Pen::thick}});
  double widest = 0;
  for (const Stroke& s : d.all<Stroke>()) widest = std::max(widest, s.width);
  CHECK(widest == d.style.sizes.shared);
  CHECK(d.length(Role::hit, true) == 0);  // the circle runs round the box, before the eye
  const Drawn behind = drawn({solid(box, Role::second), Circle{{0, 0, -2}, 1.2, Role::hit, Pen::thick}});
  CHECK(behind.length(Role::hit, true) > 0);
  CHECK(behind.length(Role::hit, false) > 0);
}

TEST_CASE("a region is filled by the even-odd rule, in both back ends' one shape", "[items]") {
  const Region ring = {{{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}, {{1, 1, 0}, {3, 1, 0}, {3, 3, 0}, {1, 3, 0}}},
                       Role::hit};
  const Drawn d = drawn({ring});
  REQUIRE(d.all<Fill>().size() == 1);
  CHECK(d.all<Fill>()[0].more.size() == 1);
  const Picture p = offscreen().render({480, 300, d.style.background, d.composed.shapes});
  const auto red = [&](const Vec3& at) {
    const Vec2 q = d.view.project(at).at;
    return channel(p, static_cast<int>(q.x()), static_cast<int>(q.y()), 0);
  };
  CHECK(red({2, 2, 0}) == 255);
  CHECK(red({0.5, 2, 0}) < 200);
  CHECK(red({3.5, 3.5, 0}) < 200);
  CHECK(d.length(Role::hit, false) == Approx(24 * d.view.scale_at({0, 0, 0})));
}

TEST_CASE("grey print hatches the second object's areas, and those alone", "[items]") {
  for (const Role role : {Role::first, Role::second}) {
    const std::vector<Item> items = {Region{{{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}}}, role},
                                     Circle{{2, 2, 0}, 1, role, Pen::solid, true}, solid(box, role)};
    for (const ThemeName name : {ThemeName::grey, ThemeName::print})
      for (const Fill& fill : drawn(items, name).all<Fill>())
        CHECK((fill.hatch_gap > 0) == (role == Role::second && name == ThemeName::grey));
  }
}

TEST_CASE("a circle in space is the ellipse its points project to", "[items]") {
  const Vec3 n = Vec3(1, 2, 0.5);
  const Drawn d = drawn({Circle{{1, 0, 0}, 2, Role::first, Pen::solid, true, n}}, ThemeName::print, Camera{});
  const std::vector<Vec2> rim = flatten(d.all<Fill>().at(0).path);
  REQUIRE(rim.size() > 20);
  for (const Vec2& p : rim) {  // each lies on the plane and at the radius, where the viewing ray meets the plane
    const View::ViewingRay line = d.view.viewing_ray(p);
    const double t = n.dot(Vec3(1, 0, 0) - line.origin) / n.dot(line.direction);
    CHECK((line.origin + t * line.direction - Vec3(1, 0, 0)).norm() == Approx(2).epsilon(2e-3));
  }
}

TEST_CASE("a span has a dot at an end of its own and an arrow head where it goes on", "[items]") {
  const auto heads = [](bool from, bool to) {
    const Drawn d = drawn({Span{{0, 0, 0}, {4, 0, 0}, Role::first, Pen::thick, from, to}});
    int count = 0;
    for (const Fill& fill : d.all<Fill>()) count += fill.path.segments.size() == 3;  // the notched head
    return count;
  };
  CHECK(heads(false, false) == 0);
  CHECK(heads(true, false) == 1);
  CHECK(heads(true, true) == 2);
}

TEST_CASE("a mesh is opaque, sorted from far to near, its far side left out", "[items]") {
  Mesh mesh;
  mesh.vertices = solid(box, Role::first).vertices;
  mesh.triangles = convex_hull<double>(std::span<const Vec3>(mesh.vertices)).triangles;
  const Hull3<double> hull = convex_hull<double>(std::span<const Vec3>(mesh.vertices));
  mesh.vertices = hull.vertices;
  const Drawn d = drawn({mesh}, ThemeName::print, Camera{});
  REQUIRE(d.all<Facets>().size() == 1);
  CHECK(d.all<Fill>().empty());
  const Facets facets = d.all<Facets>().front();
  CHECK((facets.colours.size() == 6 && facets.corners.size() == 18));
  for (const Colour& colour : facets.colours) CHECK(colour.a == 1);
  CHECK(d.composed.objects.at(static_cast<std::size_t>(facets.object)).kind == "mesh");

  const View view(Camera{}, 480, 300);
  const Vec3 towards = -view.forward();
  Mesh two;
  for (const double off : {1.0, -1.0})
    for (const Vec3& p : {Vec3(-view.right()), view.right(), view.up()}) two.vertices.push_back(p + off * towards);
  two.triangles = {{0, 1, 2}, {3, 4, 5}};
  const Facets both = drawn({two}, ThemeName::print, Camera{}).all<Facets>().front();
  REQUIRE(both.colours.size() == 2);
  const Facets turned = [&] {
    std::swap(two.triangles[0], two.triangles[1]);
    return drawn({two}, ThemeName::print, Camera{}).all<Facets>().front();
  }();
  CHECK(both.corners == turned.corners);
}

TEST_CASE("framing keeps each kind of item inside the picture", "[items]") {
  Raster raster;
  raster.corner = {5, 5, 0}, raster.across = {1, 0, 0}, raster.down = {0, -1, 0}, raster.cells = {{}};
  const std::vector<Item> kinds = {solid(box, Role::first),
                                   Circle{{3, 0, 0}, 2},
                                   Chain{{{0, 0, 0}, {9, 1, 0}, {4, 5, 0}}},
                                   Span{{0, 0, 0}, {0, 7, 0}},
                                   Region{{{{0, 0, 0}, {4, 0, 3}, {4, 4, 0}}}},
                                   raster};
  for (const Item& kind : kinds) {
    for (const bool perspective : {false, true}) {
      Camera camera;
      camera.perspective = perspective;
      const Drawn d = drawn({kind}, ThemeName::print, camera);
      for (const Stroke& stroke : d.all<Stroke>())
        for (const Vec2& p : flatten(stroke.path)) {
          CHECK((p.x() > 0 && p.x() < 480));
          CHECK((p.y() > 0 && p.y() < 300));
        }
    }
  }
}

TEST_CASE("labels keep off the outlines of every kind of item", "[items]") {
  Raster raster;
  raster.across = {3, 0, 0}, raster.down = {0, -3, 0}, raster.cells = {{}};
  const std::vector<Item> kinds = {solid(box, Role::first), Circle{{0, 0, 0}, 1}, Chain{{{-2, 0, 0}, {2, 0, 0}}},
                                   Region{{{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}}}}, raster};
  for (const Item& kind : kinds) {
    for (const Vec3& at : {Vec3(0, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)}) {
      const Drawn d = drawn({kind, Label{at, "*t*_{max}", Role::text}, Dot{{6, 3, 0}}, Dot{{-6, -3, 0}}});
      REQUIRE(d.composed.labels.size() == 1);
      const TextBox& b = d.composed.labels[0].box;
      for (const Stroke& stroke : d.all<Stroke>()) {
        if (stroke.width == d.style.sizes.leader) continue;
        std::vector<Vec2> points = flatten(stroke.path);
        if (stroke.path.closed) points.push_back(points.front());
        for (std::size_t i = 1; i < points.size(); ++i)
          for (int k = 0; k <= 20; ++k) {
            const Vec2 p = points[i - 1] + k / 20.0 * (points[i] - points[i - 1]);
            CHECK_FALSE((p.x() > b.left && p.x() < b.right && p.y() > b.top && p.y() < b.bottom));
          }
      }
    }
  }
}

TEST_CASE("a grid puts drawings of one scale in rows and columns, their headings on one line", "[items]") {
  const std::vector<Inset> insets = {{{Ball{{0, 0, 0}, 1}}, "disjoint", "first"},
                                     {{Ball{{5, 5, 5}, 0.5}, Dot{{5, 5, 5}}}, "g", "second"},
                                     {{solid(box, Role::first)}, "third", ""}};
  Camera camera;
  const std::vector<Item> items = small_multiples(insets, 2, camera);
  const Drawn d = drawn(items, ThemeName::print, camera);
  REQUIRE(d.composed.labels.size() == 5);
  const std::vector<Text> texts = d.all<Text>();
  const auto text = [&](const std::string& markup) {
    return *std::find_if(texts.begin(), texts.end(), [&](const Text& t) { return t.markup == markup; });
  };
  CHECK(text("disjoint").at.y() == Approx(text("g").at.y()));
  CHECK(text("first").at.y() == Approx(text("second").at.y()));
  CHECK(text("disjoint").at.x() == Approx(text("third").at.x()));
  CHECK(text("third").at.y() > text("first").at.y());
  const Ball& ball = std::get<Ball>(items[0]);
  CHECK(ball.radius == 1);
  const Dot& dot = *std::get_if<Dot>(
      &*std::find_if(items.begin(), items.end(), [](const Item& item) { return std::holds_alternative<Dot>(item); }));
  CHECK(d.view.project(dot.at).at.x() == Approx(text("g").at.x()));  // moved with its inset, to its middle
}

TEST_CASE("small multiples stand in the number of columns in which they are largest", "[items]") {
  const Camera camera = {.azimuth = 0, .elevation = 0};
  const std::vector<Inset> insets(6, {{Ball{{0, 0, 0}, 1}}, "disjoint", ""});
  const Scene own = arrangeable(insets, 3, camera);
  REQUIRE(own.items.size() == small_multiples(insets, 3, camera).size());
  const auto rows = [](const Scene& scene) {
    std::set<double> heights;
    for (const Item& item : scene.items)
      if (const Ball* ball = std::get_if<Ball>(&item)) heights.insert(std::round(1000 * ball->center.y()));
    return heights.size();
  };
  CHECK(rows(own) == 2);
  CHECK_FALSE(arranged(own, camera, 1.25));  // none is larger
  CHECK(rows(arranged(own, camera, 8).value()) == 1);
  CHECK(rows(arranged(own, camera, 0.2).value()) == 6);
  CHECK(rows(arranged(own, camera, 0.6).value()) == 3);
  for (const double aspect : {0.2, 0.6, 3.0, 8.0}) {
    const Scene best = arranged(own, camera, aspect).value();
    CHECK(frame(camera, {&best}, aspect).half_height * 1.05 < frame(camera, {&own}, aspect).half_height);
  }
  Scene moves = own;
  moves.handles = {{.parameter = "x", .kind = Handle::Kind::point, .at = Vec3::Zero()}};
  CHECK_FALSE(arranged(moves, camera, 8));
  Scene items = own;
  items.grid.reset();
  CHECK_FALSE(arranged(items, camera, 8));
}

TEST_CASE("a handle along a direction sets a number", "[items]") {
  Lesson lesson;
  lesson.parameters = {{"x", "", "", 0.0, -2, 2}};
  Parameters parameters = {{"x", 0.0}};
  const Handle handle = {.parameter = "x", .kind = Handle::Kind::along, .at = {1, 0, 0}, .anchor = {1, 0, 0}};
  drag(lesson, parameters, handle, {-0.5, 7, 0});
  CHECK(std::get<double>(parameters.at("x")) == -1.5);
  drag(lesson, parameters, handle, {-9, 0, 0});
  CHECK(std::get<double>(parameters.at("x")) == -2);
}

}  // namespace items_test
