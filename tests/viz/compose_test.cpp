#include "viz/compose/compose.h"

#include <algorithm>
#include <numbers>

#include "tests/catch.h"
#include "tests/viz/drawn.h"
#include "viz/compose/halos.h"
#include "viz/compose/outlines.h"
#include "viz/compose/visibility.h"
#include "viz/solids.h"
#include "viz/text/text.h"

namespace compose_test {
using namespace isect::viz;

namespace {

Scene crowded() {
  Scene s;
  s.items = {Ball{{0, 0, 0}, 1, Role::second}, Ball{{1.6, 0.2, 0.4}, 0.8, Role::first}};
  for (int i = 0; i < 6; ++i) {
    const Vec3 p = {0.12 * i - 0.3, 0.05 * i, 0};
    s.items.push_back(Dot{p, Mark::disc, Role::text});
    s.items.push_back(Label{p, "*t*_" + std::to_string(i), Role::text});
  }
  s.items.push_back(Line{{-2, -1, 0}, {2, 1, 0}, Role::first, Pen::solid});
  s.items.push_back(Label{{-2, -1, 0}, "*q*", Role::text, Vec3(2, 1, 0)});
  return s;
}

}  // namespace

TEST_CASE("labels of a crowded scene neither meet nor leave the picture", "[compose]") {
  const Scene scene = crowded();
  for (const auto& [w, h] : {std::pair{480.0, 360.0}, {960.0, 600.0}, {1920.0, 1080.0}}) {
    const Camera camera = frame({}, {&scene}, w / h);
    const Composed composed = compose(scene, View(camera, w, h), theme(ThemeName::screen, w, h));
    REQUIRE(composed.labels.size() == 7);
    for (std::size_t i = 0; i < composed.labels.size(); ++i) {
      const TextBox& b = composed.labels[i].box;
      CHECK(b.left >= 0);
      CHECK(b.top >= 0);
      CHECK(b.right <= w);
      CHECK(b.bottom <= h);
      for (std::size_t j = 0; j < i; ++j) CHECK_FALSE(meet(b, composed.labels[j].box));
    }
  }
}

TEST_CASE("the placed box is the box that the drawn text covers", "[compose]") {
  const Scene scene = crowded();
  const Composed composed = compose(scene, View(frame({}, {&scene}, 1.6), 960, 600), theme(ThemeName::print, 960, 600));
  const std::vector<Text> texts = all<Text>(composed.shapes);
  REQUIRE(texts.size() == composed.labels.size());
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const TextBox box = measure(texts[i]);
    CHECK(box.left == Approx(composed.labels[i].box.left));
    CHECK(box.bottom == Approx(composed.labels[i].box.bottom));
  }
}

TEST_CASE("framing keeps every item inside, whatever the shape of the picture", "[compose]") {
  const Scene scene = crowded();
  for (const double aspect : {0.5, 1.0, 2.5}) {
    for (const bool perspective : {false, true}) {
      Camera start;
      start.perspective = perspective;
      const View view(frame(start, {&scene}, aspect), 600 * aspect, 600);
      for (const Item& item : scene.items) {
        const Ball* ball = std::get_if<Ball>(&item);
        if (ball == nullptr) continue;
        for (const Vec3& d : {view.right(), view.up()}) {
          for (const double side : {-1.0, 1.0}) {
            const Vec2 p = view.project(ball->center + side * ball->radius * d).at;
            CHECK(p.x() > 0);
            CHECK(p.x() < view.width());
            CHECK(p.y() > 0);
            CHECK(p.y() < view.height());
          }
        }
      }
    }
  }
}

TEST_CASE("a line through a ball is dashed where it is hidden and solid elsewhere", "[compose]") {
  Scene scene;
  scene.items = {Ball{{0, 0, 0}, 1, Role::second}, Line{{-3, 0, 0}, {3, 0, 0}, Role::first, Pen::solid}};
  const Theme style = theme(ThemeName::print, 960, 600);
  const View view(frame({}, {&scene}, 1.6), 960, 600);
  const Composed composed = compose(scene, view, style);
  double dashed = 0, solid = 0;
  for (const Stroke& s : all<Stroke>(composed.shapes)) {
    if (s.colour.b != style.ink(Role::first).b) continue;
    const double length = (std::get<Vec2>(s.path.segments.back()) - s.path.start).norm();
    (s.dash[0] > 0 ? dashed : solid) += length;
  }
  CHECK(dashed > 0);
  CHECK(solid > dashed);
  CHECK(dashed + solid == Approx((view.project({3, 0, 0}).at - view.project({-3, 0, 0}).at).norm()));
}

namespace {

double length(const Path& path) {
  std::vector<Vec2> points = flatten(path, 0.5);
  if (path.closed) points.push_back(points.front());
  double sum = 0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += (points[i] - points[i - 1]).norm();
  return sum;
}

/// How long the dashed lines of the first object are, and the solid ones.
std::pair<double, double> dashed_and_solid(const Scene& scene, const View& view) {
  const Theme style = theme(ThemeName::print, view.width(), view.height());
  const Colour ink = style.ink(Role::first);
  std::pair<double, double> sum = {0, 0};
  for (const Stroke& s : all<Stroke>(compose(scene, view, style).shapes))
    if (s.colour.r == ink.r && s.colour.g == ink.g && s.colour.b == ink.b)
      (s.dash[0] > 0 ? sum.first : sum.second) += length(s.path);
  return sum;
}

std::vector<Item> capsule(const Vec3& p, const Vec3& q, double radius, Role role) {
  return {Line{p, q, role, Pen::construction, "**C**"}, Ball{p, radius, role, "**C**"}, Ball{q, radius, role, "**C**"}};
}

Solid box(const Vec3& middle, double half, Role role) {
  return solid(isect::Aabb<double, 3>{middle - Vec3::Constant(half), middle + Vec3::Constant(half)}, role);
}

/// One content of every kind, of radius 1 at most.
std::vector<std::vector<Item>> contents(const Vec3& at) {
  const auto from = [&](double x, double y, double z) -> Vec3 { return at + Vec3(x, y, z); };
  return {{Ball{at, 0.9, Role::first}},
          {box(at, 0.5, Role::first)},
          capsule(from(-0.4, 0, 0), from(0.4, 0.2, 0), 0.3, Role::first),
          {Line{from(-0.8, -0.3, 0), from(0.8, 0.3, 0.2), Role::first}},
          {Line{from(-0.8, -0.3, 0), from(0.8, 0.3, 0.2), Role::first, Pen::solid, "**s**"}},
          {Arrow{from(-0.8, -0.3, 0), from(0.8, 0.3, 0.2), Role::first}},
          {Chain{{from(-0.5, 0, 0), from(0, 0.5, 0), from(0.5, 0, 0.5)}, true, Role::first}},
          {Circle{at, 0.8, Role::first, Pen::solid, false, {1, 2, 3}}},
          {Region{.rings = {{from(-0.6, -0.4, 0), from(0.6, -0.4, 0.2), from(0, 0.7, -0.2)}}, .role = Role::first}}};
}

std::vector<std::vector<Item>> containers() {
  return {{Ball{{0, 0, 0}, 2.5, Role::second}},
          {box({0, 0, 0}, 2, Role::second)},
          capsule({-2, 0, 0}, {2, 0, 0}, 1.6, Role::second)};
}

Scene together(const std::vector<Item>& a, const std::vector<Item>& b) {
  Scene scene;
  scene.items = a;
  scene.items.insert(scene.items.end(), b.begin(), b.end());
  return scene;
}

}  // namespace

TEST_CASE("what lies in a body is drawn as without it, whatever both are, and what reaches out is hidden within",
          "[compose]") {
  Camera camera;
  camera.half_height = 5;
  const View view(camera, 800, 800);
  for (const std::vector<Item>& container : containers()) {
    for (const std::vector<Item>& content : contents({0, 0, 0})) {
      CAPTURE(container.front().index(), content.front().index());
      const auto [dashed, drawn] = dashed_and_solid(together({}, content), view);
      const auto [dashed_inside, drawn_inside] = dashed_and_solid(together(container, content), view);
      CHECK(dashed_inside == Approx(dashed).margin(1e-6));
      CHECK(drawn_inside == Approx(drawn).epsilon(2e-3));  // a ball alone has a true circle
    }
    const double edge = std::holds_alternative<Ball>(container.front())    ? 2.5
                        : std::holds_alternative<Solid>(container.front()) ? 2
                                                                           : 3.6;
    for (const std::vector<Item>& content : contents({edge, 0, 0})) {
      CAPTURE(container.front().index(), content.front().index());
      const auto [dashed, drawn] = dashed_and_solid(together({}, content), view);
      const auto [dashed_between, drawn_between] = dashed_and_solid(together(container, content), view);
      CHECK(dashed_between > dashed + 10);
      CHECK(drawn_between < drawn - 10);
      CHECK(drawn_between > 10);
    }
  }
}

TEST_CASE("a capsule is one body: it hides by its middle, too, and has one outline", "[compose]") {
  Camera front;
  front.azimuth = 0, front.elevation = 0, front.half_height = 4;
  for (const bool perspective : {false, true}) {
    front.perspective = perspective;
    const View view(front, 600, 600);
    const auto dashed = [&](double z) {
      const Line behind = {{0, -3, z}, {0, 3, z}, Role::first};
      return dashed_and_solid(together(capsule({-2, 0, 0}, {2, 0, 0}, 1, Role::second), {behind}), view).first;
    };
    CHECK(dashed(-2) == Approx((view.project({0, 1, -2}).at - view.project({0, -1, -2}).at).norm()).epsilon(0.2));
    CHECK(dashed(0) == Approx((view.project({0, 1, 0}).at - view.project({0, -1, 0}).at).norm()).epsilon(0.2));
    CHECK(dashed(2) == 0);

    // Two straight sides of length 4 and a circle of radius 1, of which nothing is hidden
    const std::vector<Vec3> chain = outline(isect::Capsule<double, 3>{{-2, 0, 0}, {2, 0, 0}, 1}, view);
    double around = 0;
    for (std::size_t i = 0; i < chain.size(); ++i)
      around += (view.project(chain[(i + 1) % chain.size()]).at - view.project(chain[i]).at).norm();
    CHECK(around / view.scale_at(Vec3::Zero()) == Approx(8 + 2 * std::numbers::pi).epsilon(perspective ? 0.05 : 1e-3));
    const auto [hidden, seen] = dashed_and_solid(together(capsule({-2, 0, 0}, {2, 0, 0}, 1, Role::first), {}), view);
    CHECK(seen >= around * 0.999);
  }
}

TEST_CASE("a named line is hidden where it runs behind a mesh or in it", "[compose]") {
  Mesh wall;
  wall.vertices = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  wall.triangles = {{0, 1, 2}, {0, 2, 3}};
  Camera front;
  front.azimuth = 0, front.elevation = 0, front.half_height = 3;
  const View view(front, 600, 600);
  const auto dashed = [&](double z, const std::string& name) {
    Scene scene;
    scene.items = {wall, Line{{-2, 0.1, z}, {2, 0.1, z}, Role::first, Pen::solid, name}};
    double hidden = 0;
    for (const Stroke& s : all<Stroke>(compose(scene, view, theme(ThemeName::screen, 600, 600)).shapes))
      if (s.dash[0] > 0)
        for (std::size_t i = 0; i < s.path.segments.size(); ++i)
          hidden +=
              (std::get<Vec2>(s.path.segments[i]) - (i == 0 ? s.path.start : std::get<Vec2>(s.path.segments[i - 1])))
                  .norm();
    return hidden;
  };
  const double width = (view.project({1, 0.1, -1}).at - view.project({-1, 0.1, -1}).at).norm();
  CHECK(dashed(-1, "**r**") == Approx(width).epsilon(1e-3));
  CHECK(dashed(1, "**r**") == 0);
  CHECK(dashed(-1, "") == 0);  // part of a lesson's picture, which is drawn over its mesh
}

namespace {

/// A square of 2 n^2 facets from (-half, -half, 0) to (half, half, 0).
Mesh wall(int n, double half) {
  Mesh mesh;
  for (int i = 0; i <= n; ++i)
    for (int k = 0; k <= n; ++k) mesh.vertices.emplace_back(half * (2.0 * i / n - 1), half * (2.0 * k / n - 1), 0);
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k) {
      const int a = i * (n + 1) + k, b = a + n + 1;
      mesh.triangles.push_back({a, b, b + 1}), mesh.triangles.push_back({a, b + 1, a + 1});
    }
  return mesh;
}

}  // namespace

TEST_CASE("a mesh of 20,000 facets hides what lies behind it, and a solid before it is cut out of it", "[compose]") {
  Camera front;
  front.azimuth = 0, front.elevation = 0, front.half_height = 3;
  for (const bool perspective : {false, true}) {
    CAPTURE(perspective);
    front.perspective = perspective;
    const View view(front, 600, 600);
    const auto dashed = [&](int n, double z) {
      const Line line = {{-2, 0.107, z}, {2, 0.107, z}, Role::first, Pen::solid, "**r**"};
      Mesh behind = wall(n, 1);
      behind.role = Role::second;
      return dashed_and_solid(together({behind}, {line}), view).first;
    };
    CHECK(dashed(100, -1) == Approx(dashed(1, -1)).epsilon(1e-6));  // as behind a mesh of two facets
    CHECK(dashed(1, -1) > 100);
    CHECK(dashed(100, 1) == 0);
  }
  front.perspective = false;
  const auto cut_out = [&](int n, double x) {
    const Theme style = theme(ThemeName::grey, 600, 600);
    const Vec3 at(x, 0.027, 0.5);
    const Scene scene = together({wall(n, 2)}, {box(at, 0.1, Role::second)});
    int found = 0;
    for (const Fill& fill : all<Fill>(compose(scene, View(front, 600, 600), style).shapes))
      found += fill.colour.a == 1 && fill.colour.r == style.background.r;
    return found;
  };
  CHECK(cut_out(100, 0.013) > 0);
  CHECK(cut_out(100, 0.013) == cut_out(1, 0.013));
  CHECK(cut_out(100, 2.5) == 0);
}

TEST_CASE("grey print hatches the second object, other themes shade it", "[compose]") {
  Scene scene;
  scene.items = {Ball{{0, 0, 0}, 1, Role::second}};
  const View view(frame({}, {&scene}, 1.6), 960, 600);
  const auto hatched = [&](ThemeName name) {
    const std::vector<Fill> fills = all<Fill>(compose(scene, view, theme(name, 960, 600)).shapes);
    return std::any_of(fills.begin(), fills.end(), [](const Fill& f) { return f.hatch_gap > 0; });
  };
  CHECK(hatched(ThemeName::grey));
  CHECK_FALSE(hatched(ThemeName::print));
  CHECK_FALSE(hatched(ThemeName::dark));
}

TEST_CASE("a figure's picture stands still when formula and verdict come and go", "[compose]") {
  Step bare, full;
  bare.scene = full.scene = crowded();
  full.formula = "*q*^2 = *r*^2 − *m*^2";
  full.verdict = {Verdict::Kind::yes, "hit"};
  const Camera camera = frame({}, {&bare.scene}, 1.6);
  const View a = figure(bare, camera, ThemeName::print, 960, 600).view;
  const View b = figure(full, camera, ThemeName::print, 960, 600).view;
  CHECK(a.height() == b.height());
  CHECK((a.corner() - b.corner()).norm() == 0);
}

TEST_CASE("a solid seen on a mesh is cut out of its shades, one beside it is not", "[compose]") {
  const auto opaque_paper = [](const Vec3& at) {
    Scene scene;
    scene.items = {Mesh{{{-2, -2, 0}, {2, -2, 0}, {0, 2, 0}}, {{0, 1, 2}}},
                   solid(isect::Aabb<double, 3>{at - Vec3::Constant(0.1), at + Vec3::Constant(0.1)}, Role::second)};
    const Theme style = theme(ThemeName::grey, 960, 600);
    const View view(Camera{.azimuth = 0, .elevation = 0, .half_height = 3}, 960, 600);
    int found = 0;
    for (const Fill& fill : all<Fill>(compose(scene, view, style).shapes))
      found += fill.colour.a == 1 && fill.colour.r == style.background.r;
    return found;
  };
  CHECK(opaque_paper({0, 0, 0.5}) > 0);
  CHECK(opaque_paper({2.5, 0, 0.5}) == 0);
}

TEST_CASE("what is drawn in yellow has an edge, hidden or not hidden by others, but on a dark screen", "[compose]") {
  for (const bool solid_behind : {false, true})
    for (const ThemeName name : {ThemeName::screen, ThemeName::grey, ThemeName::dark}) {
      Scene scene;
      scene.items = {Chain{{{-1, -1, 1}, {1, -1, 1}, {0, 1, 1}}, true, Role::highlight, Pen::highlight}};
      if (solid_behind)
        scene.items.push_back(solid(isect::Aabb<double, 3>{{-0.5, -0.5, -1}, {0.5, 0.5, 0}}, Role::second));
      const Theme style = theme(name, 960, 600);
      const View view(Camera{.azimuth = 0.3, .elevation = 0.3, .half_height = 3}, 960, 600);
      const Colour text = style.ink(Role::text), yellow = style.ink(Role::highlight);
      int edges = 0, cores = 0;
      for (const Stroke& s : all<Stroke>(compose(scene, view, style).shapes)) {
        cores += s.colour.r == yellow.r && s.colour.b == yellow.b && s.width == style.sizes.highlight;
        edges += s.colour.r == text.r && s.colour.b == text.b && s.width > style.sizes.highlight;
      }
      CHECK(cores > 0);
      CHECK(edges == (name == ThemeName::dark ? 0 : cores));
    }
}

TEST_CASE("a line that is left out leaves a gap in what lies below it", "[compose]") {
  Scene scene;
  scene.items = {Line{{-2, 0, 0}, {2, 0, 0}, Role::first, Pen::solid},
                 Line{{-1, 0, 0}, {1, 0, 0}, Role::construction, Pen::excluded}};
  for (const ThemeName name : {ThemeName::screen, ThemeName::grey, ThemeName::dark}) {
    const Theme style = theme(name, 960, 600);
    const std::vector<Stroke> strokes = all<Stroke>(compose(scene, View({.half_height = 3}, 960, 600), style).shapes);
    REQUIRE(strokes.size() == 3);
    CHECK(strokes[1].colour.r == style.background.r);
    CHECK(strokes[1].width > strokes[0].width);
    CHECK(strokes[1].width > strokes[2].width);
    CHECK(strokes[2].dash[0] > strokes[2].dash[1]);
    CHECK(strokes[2].dash[1] >= style.sizes.ray);  // so that the gap is seen
  }
}

TEST_CASE("a handle does not cover what is marked in its place", "[compose]") {
  const Theme style = theme(ThemeName::screen, 960, 600);
  const auto discs = [&](const Dot& dot) {
    Scene scene;
    scene.items = {dot};
    scene.handles = {{.parameter = "v", .at = Vec3::Zero(), .role = Role::second}};
    int count = 0;
    const Colour ink = style.ink(Role::second);
    for (const Fill& fill : all<Fill>(compose(scene, View({.half_height = 3}, 960, 600), style, true).shapes))
      count += fill.colour == ink;
    return count;
  };
  CHECK(discs({Vec3(1, 0, 0), Mark::disc, Role::hit}) == 1);
  CHECK(discs({Vec3::Zero(), Mark::disc, Role::second}) == 2);
  CHECK(discs({Vec3::Zero(), Mark::disc, Role::hit}) == 0);
  CHECK(discs({Vec3::Zero(), Mark::uncounted, Role::construction}) == 0);
  CHECK(discs({Vec3::Zero(), Mark::diamond, Role::highlight}) == 0);
}

TEST_CASE("a name at a handle keeps off its ring, whether that is drawn here or over the picture", "[compose]") {
  const Theme style = theme(ThemeName::screen, 960, 600);
  const View view({.half_height = 3}, 960, 600);
  for (const bool at_handle : {true, false}) {
    Scene scene;
    scene.items = {Ball{Vec3::Zero(), 1, Role::second}, Label{Vec3::Zero(), "b", Role::second, {}, at_handle}};
    const Composed composed = compose(scene, view, style);
    REQUIRE(composed.labels.size() == 1);
    const TextBox& b = composed.labels[0].box;
    const Vec2 p = view.project(Vec3::Zero()).at;
    const double off =
        std::hypot(std::max({b.left - p.x(), p.x() - b.right, 0.0}), std::max({b.top - p.y(), p.y() - b.bottom, 0.0}));
    CHECK((off >= style.sizes.handle_ring) == at_handle);
  }
}

TEST_CASE("the ring of a yellow handle is seen on white", "[compose]") {
  Scene scene;
  scene.handles = {{.parameter = "v", .at = Vec3::Zero(), .role = Role::highlight}};
  for (const ThemeName name : {ThemeName::screen, ThemeName::grey, ThemeName::dark}) {
    const Theme style = theme(name, 960, 600);
    const std::vector<Stroke> rings =
        all<Stroke>(compose(scene, View({.half_height = 3}, 960, 600), style, true).shapes);
    REQUIRE(rings.size() == 1);
    CHECK(contrast_ratio(rings[0].colour, style.background) > 3);
  }
}

TEST_CASE("a note stands on its point, or where something else is, beside it with a leader that ends there",
          "[compose]") {
  const Vec3 at(0.3, 0.2, 0);
  Scene scene;
  scene.items = {Region{.rings = {{{-2, -1, 0}, {2, -1, 0}, {2, 1, 0}, {-2, 1, 0}}}},
                 Label{at, "a note", Role::text, at}};
  Camera front;
  front.azimuth = 0, front.elevation = 0, front.half_height = 1.5;
  const View view(front, 400, 300);
  const Vec2 point = view.project(at).at;
  const auto placed = [&] { return compose(scene, view, theme(ThemeName::print, 400, 300)).labels.back(); };
  const PlacedLabel alone = placed();
  CHECK((alone.box.left + alone.box.right) / 2 == Approx(point.x()));
  CHECK((alone.box.top + alone.box.bottom) / 2 == Approx(point.y()));
  CHECK_FALSE(alone.leads_to);

  scene.items.push_back(Line{at - Vec3(0.4, 0, 0), at + Vec3(0.4, 0, 0), Role::first, Pen::solid});
  scene.items.push_back(Dot{at});
  const PlacedLabel beside = placed();
  REQUIRE(beside.leads_to);
  CHECK((*beside.leads_to - point).norm() < 1e-9);
  CHECK_FALSE((beside.box.left <= point.x() && point.x() <= beside.box.right && beside.box.top <= point.y() &&
               point.y() <= beside.box.bottom));
}

TEST_CASE("a ball is brightest where it faces the light, on light ground as on dark", "[compose]") {
  Scene scene;
  scene.items = {Ball{{0, 0, 0}, 1, Role::second}};
  const View view(frame({}, {&scene}, 1.6), 960, 600);
  for (const ThemeName name : {ThemeName::screen, ThemeName::print, ThemeName::dark}) {
    const Theme style = theme(name, 960, 600);
    const std::vector<Gradient> balls = all<Gradient>(compose(scene, view, style).shapes);
    REQUIRE(!balls.empty());  // the first may be its shadow
    const auto brightness = [&](const Colour& c) {
      const Colour& b = style.background;
      return (b.r + b.g + b.b) * (1 - c.a) + (c.r + c.g + c.b) * c.a;
    };
    CHECK(brightness(balls.back().inner) > brightness(balls.back().outer));
  }
}

}  // namespace compose_test
