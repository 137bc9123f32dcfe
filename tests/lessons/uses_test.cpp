// The lessons on what intersection detection is used for: their last word is that of the core's exact tests.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include <isect/clip_polygon.h>
#include <isect/clip_segment.h>
#include <isect/point_sphere.h>
#include "lessons/culling/culled.h"
#include "lessons/lessons.h"
#include "lessons/picking/objects.h"
#include "lessons/ray_tracing/tracer.h"
#include "tests/catch.h"
#include "tests/viz/pixels.h"
#include "viz/compose/compose.h"
#include "viz/player/pick.h"
#include "viz/player/reader_state.h"
#include "viz/solids.h"
#include "viz/walk/closing.h"

namespace uses_test {
using namespace isect;
using namespace isect::viz;

namespace {

const Lesson& lesson(const std::string& id) { return lesson_named(lessons::all_lessons(), id); }
Walk walk_of(const std::string& id, const std::string& preset_id) {
  return lesson(id).walk(preset(lesson(id), preset_id).parameters);
}

double value(const Step& step, const std::string& name) {
  for (const Value& v : step.values)
    if (v.name == name) return v.value;
  throw std::runtime_error("no value " + name);
}
Point<double, 2> at(const Parameters& p, const char* name) { return std::get<Vec3>(p.at(name)).head<2>(); }

const Aabb<double, 2> clipping_box = {{-2, -1.25}, {2, 1.25}};

}  // namespace

TEST_CASE("a segment's lesson ends with the exact range, and each side narrows it", "[clipping lesson]") {
  int inner = 0, points = 0, none = 0;
  for (const Preset& p : lesson("clipping").presets) {
    if (p.group != "segment") continue;
    INFO(p.id);
    const Walk walk = lesson("clipping").walk(p.parameters);
    const auto truth = clip(Segment<double, 2>{at(p.parameters, "p"), at(p.parameters, "q")}, clipping_box);
    const Step& last = walk.steps[outcome(walk)];
    CHECK((last.verdict.kind != Verdict::Kind::no) == truth.has_value());
    none += !truth;
    double lo = 0, hi = 1;
    for (const Step& s : walk.steps) {
      const auto in = std::ranges::find(s.values, "*t*_{in}", &Value::name);
      const auto out = std::ranges::find(s.values, "*t*_{out}", &Value::name);
      if (in == s.values.end() || out == s.values.end()) continue;
      CHECK((lo <= in->value && out->value <= hi));
      lo = in->value, hi = out->value;
    }
    if (!truth || last.counters.div == 0) continue;
    CHECK_THAT(lo, Catch::Matchers::WithinAbs(truth->lo, 1e-15));
    CHECK_THAT(hi, Catch::Matchers::WithinAbs(truth->hi, 1e-15));
    REQUIRE(last.scene.axis);
    REQUIRE(last.scene.axis->shared);
    CHECK(*last.scene.axis->shared == Vec2(truth->lo, truth->hi));
    inner += truth->lo < truth->hi, points += truth->lo == truth->hi;
  }
  for (const int seen : {inner, points, none}) CHECK(seen > 0);
}

TEST_CASE("trivial answers cost no division, others one a side at most", "[clipping lesson]") {
  const auto last = [](const char* id) { return walk_of("clipping", id).steps.back(); };
  for (const char* trivial : {"inside", "beyond-one-side"}) {
    CHECK(last(trivial).counters.div == 0);
    CHECK(last(trivial).counters.early_out);
  }
  CHECK(last("both-ends-cut").counters.div == 4);
  CHECK(last("along-a-side").counters.div == 2);  // the other two sides run along the line
  CHECK(last("past-a-corner").counters.early_out);
  CHECK(last("at-a-corner").verdict.kind == Verdict::Kind::on);
  CHECK(last("along-a-side").verdict.kind == Verdict::Kind::on);
}

TEST_CASE("slabs by reciprocals lose a segment along an upper side, and nothing else here", "[clipping lesson]") {
  for (const Preset& p : lesson("clipping").presets) {
    INFO(p.id);
    std::string wrong;
    for (const Opinion& o : lesson("clipping").opinions(p.parameters))
      if (!o.agrees) wrong += o.method + ";";
    const std::string lost = p.id == "along-a-side"             ? "slabs, min and max;"
                             : p.id == "slabs-top"              ? "slabs, min and max;slabs, min and max exchanged;"
                             : p.id.starts_with("slabs-bottom") ? "slabs, min and max exchanged;"
                                                                : "";
    CHECK(wrong == lost);
  }
  Parameters along = preset(lesson("clipping"), "along-a-side").parameters;
  for (const char* end : {"p", "q"}) std::get<Vec3>(along.at(end)).y() = clipping_box.lo.y();
  for (const Opinion& o : lesson("clipping").opinions(along)) CHECK(o.agrees);  // there NaN falls the other way
}

TEST_CASE("a polygon's lesson ends with the exact test's ring", "[clipping lesson]") {
  for (const Preset& p : lesson("clipping").presets) {
    if (p.group != "polygon") continue;
    INFO(p.id);
    Ring<double, 2> ring;
    for (const char* name : {"p", "q", "r", "s"}) ring.push_back(at(p.parameters, name));
    const Ring<double, 2> truth = clip(ring, clipping_box);
    const Walk walk = lesson("clipping").walk(p.parameters);
    const Step& last = walk.steps[outcome(walk)];
    CHECK((last.verdict.kind == Verdict::Kind::no) == truth.empty());
    if (truth.empty()) continue;
    bool drawn = false;
    for (const Item& item : last.scene.items)
      if (const auto* region = std::get_if<Region>(&item)) {
        if (region->role != Role::hit) continue;
        drawn = true;
        REQUIRE(region->rings[0].size() == truth.size());
        for (std::size_t i = 0; i < truth.size(); ++i) CHECK(region->rings[0][i].head<2>() == truth[i]);
      }
    CHECK(drawn);
    CHECK(value(last, "vertices") == static_cast<double>(truth.size()));
  }
  const auto kind = [](const char* id) { return walk_of("clipping", id).steps.back().verdict.kind; };
  CHECK(kind("polygon-at-a-corner") == Verdict::Kind::on);
  CHECK(kind("polygon-along-a-side") == Verdict::Kind::on);
  CHECK(value(walk_of("clipping", "cut").steps.back(), "vertices") == 8);
  CHECK(value(walk_of("clipping", "around").steps.back(), "vertices") == 4);
}

namespace {

/// How a picture shows each volume but the frustum itself: the volume, and its role.
std::vector<std::pair<lessons::culling_lesson::Volume, Role>> volumes(const Scene& scene) {
  std::vector<std::pair<lessons::culling_lesson::Volume, Role>> all;
  for (const Item& item : scene.items) {
    if (const auto* ball = std::get_if<Ball>(&item))
      all.emplace_back(Sphere<double, 3>{ball->center, ball->radius}, ball->role);
    const auto* solid = std::get_if<Solid>(&item);
    if (!solid || solid->role == Role::first) continue;
    Aabb<double, 3> box = {solid->vertices[0], solid->vertices[0]};
    for (const Vec3& v : solid->vertices) box.lo = box.lo.cwiseMin(v), box.hi = box.hi.cwiseMax(v);
    all.emplace_back(box, solid->role);
  }
  return all;
}

Culling exact(const lessons::culling_lesson::Volume& volume, const Frustum<double>& view) {
  return std::visit([&](const auto& v) { return cull(v, view); }, volume);
}

}  // namespace

TEST_CASE("every volume is coloured by the core's own answer", "[culling lesson]") {
  std::map<Culling, int> seen;
  for (const Preset& p : lesson("culling").presets) {
    INFO(p.id);
    const Walk walk = lesson("culling").walk(p.parameters);
    const Frustum<double> view = lessons::culling_lesson::frustum(std::get<Vec3>(p.parameters.at("eye")));
    const int shown = p.id == "hierarchy" ? outcome(walk) - 1 : outcome(walk);
    const auto all = volumes(walk.steps[shown].scene);
    CHECK(all.size() == (p.id == "hierarchy" ? 16 : p.id == "scene" ? 10 : 1));
    int drawn = 0;
    for (const auto& [volume, role] : all) {
      const Culling truth = exact(volume, view);
      CHECK(role == lessons::culling_lesson::role_of(truth));
      drawn += truth != Culling::outside;
      ++seen[truth];
    }
    const Step& last = walk.steps.back();
    if (p.id == "hierarchy") {
      CHECK(value(last, "drawn") == drawn);
      CHECK(value(last, "tests") < 16);
      CHECK(value(last, "hierarchy, 4096 boxes") < 4096 / 2);
      continue;
    }
    if (p.id == "scene") {
      CHECK(value(last, "outside") == 10 - drawn);
      CHECK_THAT(last.verdict.text, isect::test::Contains(std::to_string(drawn) + " of 10"));
      continue;
    }
    const Culling asked = exact(all.front().first, view);
    CHECK(last.verdict.kind == (asked == Culling::inside    ? Verdict::Kind::yes
                                : asked == Culling::outside ? Verdict::Kind::no
                                                            : Verdict::Kind::on));
  }
  for (const Culling c : {Culling::outside, Culling::inside, Culling::crossing}) CHECK(seen[c] > 2);
}

TEST_CASE("beyond an edge no plane rejects a box that has no point of the frustum", "[culling lesson]") {
  const Parameters& p = preset(lesson("culling"), "beyond-an-edge").parameters;
  const Vec3& center = std::get<Vec3>(p.at("p"));
  const double size = std::get<double>(p.at("size"));
  const Frustum<double> view = lessons::culling_lesson::frustum(std::get<Vec3>(p.at("eye")));
  const Aabb<double, 3> box = {center - Vec3::Constant(size), center + Vec3::Constant(size)};
  CHECK(cull(box, view) == Culling::crossing);
  CHECK_FALSE(lessons::culling_lesson::meet(box, view));
  int inside = 0;
  for (int i = 0; i <= 32; ++i)
    for (int j = 0; j <= 32; ++j)
      for (int k = 0; k <= 32; ++k) {
        const Vec3 x = box.lo + size / 16 * Vec3(i, j, k);
        bool in = true;
        for (const Plane<double, 3>& plane : view.planes) in = in && plane.normal.dot(x) + plane.d >= 0;
        inside += in;
      }
  CHECK(inside == 0);
  CHECK_THAT(walk_of("culling", "beyond-an-edge").steps.back().verdict.text, isect::test::Contains("not visible"));
  const CaseMap& map = *lesson("culling").map;
  CHECK(map.branches[map.branch(p)] == "false positive");
  CHECK(lessons::culling_lesson::meet({{0, 0, 0}, {1, 1, 1}}, view));
  CHECK(lessons::culling_lesson::meet({{-9, -9, -9}, {9, 9, 9}}, view));
}

TEST_CASE("under a hierarchy the same boxes are drawn as one by one", "[culling lesson]") {
  const Vec3 eye = {-4, 0, 0};
  const Frustum<double> view = lessons::culling_lesson::frustum(eye);
  for (const int n : {16, 256, 4096}) {
    const auto boxes = lessons::culling_lesson::many(n, eye);
    const auto found = lessons::culling_lesson::culled(build_bvh(boxes), boxes, view);
    std::vector<int> drawn = found.drawn, expected;
    std::ranges::sort(drawn);
    for (int i = 0; i < n; ++i)
      if (cull(boxes[i], view) != Culling::outside) expected.push_back(i);
    CHECK(drawn == expected);
    CHECK_FALSE(expected.empty());
    if (n > 16) CHECK(found.tests < n / 2);
  }
}

TEST_CASE("the first plane that rejects a volume ends its test", "[culling lesson]") {
  const auto planes = [](const Parameters& p) {
    const Walk walk = lesson("culling").walk(p);
    return std::ranges::count_if(walk.steps, [](const Step& s) { return s.slug.starts_with("plane-"); });
  };
  CHECK(planes(preset(lesson("culling"), "inside").parameters) == 6);
  Parameters p = preset(lesson("culling"), "outside").parameters;
  CHECK(planes(p) == 1);
  p["p"] = Vec3(-3, 0, 0), p["size"] = 0.25;  // between the eye and the near plane
  CHECK(planes(p) == 5);
  CHECK(lesson("culling").walk(p).steps.back().verdict.kind == Verdict::Kind::no);
  const Step last = walk_of("culling", "outside").steps.back();
  CHECK(last.counters.early_out);
  CHECK((last.counters.mul > 0 && last.counters.mul < walk_of("culling", "inside").steps.back().counters.mul));
}

namespace {

using namespace lessons::ray_tracing_lesson;
using lessons::viewing::Object;

/// A ball of many facets, counter-clockwise seen from outside.
Mesh mesh_of(const Sphere<double, 3>& ball, Role role) {
  const int around = 96, down = 48;
  Mesh mesh{{}, {}, role};
  for (int j = 0; j <= down; ++j)
    for (int i = 0; i < around; ++i) {
      const double u = 2 * std::numbers::pi * i / around, v = std::numbers::pi * j / down;
      const Vec3 n = {std::sin(v) * std::sin(u), std::cos(v), std::sin(v) * std::cos(u)};
      mesh.vertices.push_back(ball.center + ball.radius * n);
    }
  for (int j = 0; j < down; ++j)
    for (int i = 0; i < around; ++i) {
      const int a = j * around + i, b = j * around + (i + 1) % around, c = a + around, d = b + around;
      mesh.triangles.push_back({a, c, d});
      mesh.triangles.push_back({a, d, b});
    }
  return mesh;
}

Mesh mesh_of(const lessons::viewing::Shape& shape, Role role) {
  if (const auto* ball = std::get_if<Sphere<double, 3>>(&shape)) return mesh_of(*ball, role);
  if (const auto* ring = std::get_if<Ring<double, 3>>(&shape)) return {*ring, {{0, 1, 2}, {0, 2, 3}}, role};
  const Solid box = solid(std::get<Aabb<double, 3>>(shape), role);
  Mesh mesh{box.vertices, {}, role};
  for (const std::vector<int>& f : box.faces) {
    mesh.triangles.push_back({f[0], f[1], f[2]});
    mesh.triangles.push_back({f[0], f[2], f[3]});
  }
  return mesh;
}

/// The object whose ink the pixel has, whatever its share of paper; -1: paper.
int object_of(const Picture& picture, int x, int y, const std::vector<Object>& objects, const Theme& theme) {
  const auto vector = [&](const Colour& c) -> Vec3 {
    return Vec3(theme.background.r - c.r, theme.background.g - c.g, theme.background.b - c.b);
  };
  Vec3 seen;
  for (int k = 0; k < 3; ++k) seen[k] = channel(picture, x, y, k) / 255.0;
  seen = vector({seen[0], seen[1], seen[2], 1});
  if (seen.norm() < 0.03) return -1;
  int best = -1;
  double nearest = 0;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const double along = vector(theme.ink(objects[i].role)).normalized().dot(seen.normalized());
    if (along > nearest) nearest = along, best = static_cast<int>(i);
  }
  return best;
}

}  // namespace

TEST_CASE("the traced picture shows what the rasteriser draws, pixel by pixel", "[ray-tracing lesson]") {
  const lessons::viewing::World world(scene_objects());
  const lessons::viewing::Eye eye(columns, rows);
  const Image image = trace(world, eye, {-1, 2.25, -1.5});

  // Opaque meshes in painter's order: the floor, then what stands on it, far to near. A pixel is sampled in its middle.
  constexpr int fine = 9;
  std::vector<int> order = {4, 2, 0, 1, 3};
  Scene scene;
  for (const int i : order) scene.items.emplace_back(mesh_of(world.object(i).shape, world.object(i).role));
  const Theme style = theme(ThemeName::print, columns * fine, rows * fine);
  const View view(lessons::viewing::eye_camera(), columns * fine, rows * fine);
  const Drawing drawing = {columns * fine, rows * fine, style.background, compose(scene, view, style).shapes};
  const Picture picture = offscreen().render(drawing);

  const auto traced = [&](int x, int y) {
    const auto& hit = image.pixels[y * columns + x].hit;
    return hit ? hit->primitive : -1;
  };
  int agree = 0, inner = 0;
  std::map<int, int> shown;
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x) {
      const int mine = traced(x, y);
      const int drawn = object_of(picture, x * fine + fine / 2, y * fine + fine / 2, world.objects, style);
      bool silhouette = false;  // a neighbour shows something else
      for (int j = std::max(y - 1, 0); j <= std::min(y + 1, rows - 1); ++j)
        for (int i = std::max(x - 1, 0); i <= std::min(x + 1, columns - 1); ++i)
          silhouette = silhouette || traced(i, j) != mine;
      INFO("pixel " << x << ", " << y << ": traced " << mine << ", drawn " << drawn);
      if (!silhouette) CHECK(mine == drawn);
      inner += !silhouette, agree += mine == drawn;
      ++shown[mine];
    }
  const double share = 1.0 * agree / (columns * rows);
  INFO("share of pixels that agree: " << share);
  CHECK(share > 0.99);
  CHECK(inner > columns * rows / 2);
  CHECK(shown.size() == 6);  // all five, and the sky
  for (const auto& [object, count] : shown) CHECK(count > 50);
}

TEST_CASE("each pixel of the lesson's picture is the closest of all hits, shaded", "[ray-tracing lesson]") {
  const lessons::viewing::World world(scene_objects());
  const Vec3 lamp = {-1, 2.25, -1.5};
  const lessons::viewing::Eye eye(columns, rows);
  const Image image = trace(world, eye, lamp);
  int lit = 0, shadow = 0, away = 0, sky = 0;
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x) {
      const Traced& t = image.pixels[y * columns + x];
      const auto ray = eye.through(eye.on_plane({x + 0.5, y + 0.5}));
      std::optional<double> least;
      for (const Object& o : world.objects)
        if (const auto hit = lessons::viewing::first_hit(ray, o.shape); hit && (!least || *hit < *least)) least = hit;
      REQUIRE(least.has_value() == t.hit.has_value());
      sky += !least;
      if (!least) continue;
      CHECK(t.hit->t == *least);
      CHECK_THAT(t.normal.norm(), Catch::Matchers::WithinAbs(1, 1e-12));
      if (t.cosine <= 0) {
        ++away;
        CHECK(t.brightness == 0.2);
        continue;
      }
      bool blocked = false;  // a little off the surface, where the lesson leaves the object out
      const lessons::viewing::Ray3 shadow_ray = {t.point + 1e-9 * t.normal, lamp - t.point, {0, 1}};
      for (const Object& o : world.objects) blocked = blocked || lessons::viewing::first_hit(shadow_ray, o.shape);
      CHECK(blocked == t.blocker.has_value());
      CHECK((t.brightness > 0.2) != blocked);
      (blocked ? shadow : lit) += 1;
    }
  for (const int often : {lit, shadow, away, sky}) CHECK(often > 50);
  CHECK(image.work.eye_rays == columns * rows);
  CHECK(image.work.shadow_rays == lit + shadow);
  CHECK(image.work.tests < 5 * (image.work.eye_rays + image.work.shadow_rays) / 2);
}

TEST_CASE("the ray-tracing presets are what their names say", "[ray-tracing lesson]") {
  const auto last = [](const char* id) {
    const Walk walk = walk_of("ray-tracing", id);
    return walk.steps[outcome(walk)];
  };
  CHECK(last("lit").verdict.kind == Verdict::Kind::yes);
  CHECK(last("lit").line == 0);
  CHECK(value(last("lit"), "objects met") >= 2);
  CHECK_THAT(last("shadow").verdict.text, isect::test::Contains("shadow of"));
  CHECK_THAT(last("turned-away").verdict.text, isect::test::Contains("turned away"));
  CHECK_THAT(last("sky").verdict.text, isect::test::Contains("sky"));
  const auto* raster = std::get_if<Raster>(&last("sky").scene.items.front());
  REQUIRE(raster);
  CHECK(raster->cells.size() == 48 * 36);
}

namespace {

/// The object that the window's own picking finds there; -1: none.
int picked_by_window(const std::vector<Object>& objects, const View::ViewingRay& line) {
  Scene scene;
  for (const Object& o : objects) lessons::viewing::add(o, scene);
  const std::optional<Picked> found = pick(scene, line);
  return found ? static_cast<int>(found->item - scene.items.data()) : -1;
}

}  // namespace

TEST_CASE("the lesson picks what the window would pick, at every pixel", "[picking lesson]") {
  const lessons::viewing::World world(lessons::picking_lesson::objects());
  const lessons::viewing::Eye eye(48, 36);
  std::map<int, int> seen;
  for (int y = 0; y < 36; ++y)
    for (int x = 0; x < 48; ++x) {
      INFO("pixel " << x << ", " << y);
      const Vec2 pixel = {x + 0.5, y + 0.5};
      const auto hit = world.closest(eye.through(eye.on_plane(pixel)));
      const int mine = hit ? hit->primitive : -1;
      CHECK(mine == picked_by_window(world.objects, eye.view.viewing_ray(pixel)));
      ++seen[mine];
    }
  CHECK(seen.size() == 5);
  for (const auto& [object, count] : seen) CHECK(count > 30);
}

TEST_CASE("the picking presets are what their names say", "[picking lesson]") {
  const lessons::viewing::World world(lessons::picking_lesson::objects());
  const lessons::viewing::Eye eye(48, 36);
  const auto step = [](const char* id) {
    const Walk walk = walk_of("picking", id);
    return walk.steps[outcome(walk)];
  };
  const auto ray = [&](const char* id) {
    return eye.through(std::get<Vec3>(preset(lesson("picking"), id).parameters.at("pointer")));
  };
  const auto t = [&](const char* id, int object) {
    return lessons::viewing::first_hit(ray(id), world.object(object).shape);
  };
  const auto in_ball = [&](const char* id, int object) {
    return lessons::viewing::first_hit(ray(id), lessons::picking_lesson::bounding_ball(world.object(object).shape));
  };
  REQUIRE((t("front", 0) && t("front", 1)));
  CHECK(*t("front", 1) < *t("front", 0));
  CHECK_THAT(step("front").verdict.text, isect::test::Contains("gem"));

  CHECK((t("behind", 0) && !t("behind", 1) && in_ball("behind", 1)));  // through the void of the gem's ball
  CHECK_THAT(step("behind").verdict.text, isect::test::Contains("crate"));

  for (int i = 0; i < 4; ++i) CHECK_FALSE(in_ball("miss", i));
  CHECK(step("miss").verdict.kind == Verdict::Kind::no);
  CHECK(value(step("miss"), "tests, balls first") == 4);
  CHECK(value(step("miss"), "tests without") == 8 + 12 + 2);
  CHECK(value(step("miss"), "tests, mean of all pixels") < 11);

  REQUIRE((t("tie", 2) && t("tie", 3)));
  CHECK(*t("tie", 2) == *t("tie", 3));
  CHECK(step("tie").verdict.kind == Verdict::Kind::on);
  CHECK_THAT(step("tie").verdict.text, isect::test::Contains("**b**"));
}

TEST_CASE("a bounding ball holds every vertex of what it bounds", "[picking lesson]") {
  for (const Object& o : lessons::picking_lesson::objects()) {
    const auto* all = std::get_if<lessons::viewing::Triangles>(&o.shape);
    if (!all) continue;
    const Sphere<double, 3> ball = lessons::picking_lesson::bounding_ball(o.shape);
    Vec3 outwards = Vec3::Zero();
    for (const Triangle<double, 3>& triangle : *all) {
      for (const Vec3& v : triangle.vertices) CHECK(locate(v, ball) != Location::out);
      const auto& [a, b, c] = triangle.vertices;
      CHECK((b - a).cross(c - a).dot(a - ball.center) > 0);  // counter-clockwise seen from outside
      outwards += (b - a).cross(c - a);
    }
    CHECK(outwards.norm() < 1e-12);  // closed
  }
}

}  // namespace uses_test
