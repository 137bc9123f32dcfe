// The lessons on what intersection detection is used for: their last word is that of the core's exact tests.

#include <algorithm>
#include <map>

#include "core/clip_polygon.h"
#include "core/clip_segment.h"
#include "lessons/culling/view.h"
#include "lessons/lessons.h"
#include "tests/catch.h"
#include "viz/place.h"

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
    const Step& last = walk.steps.back();
    CHECK((last.verdict.kind != Verdict::Kind::no) == truth.has_value());
    none += !truth;
    double lo = 0, hi = 1;
    for (const Step& s : walk.steps) {
      if (!s.comparison) continue;
      CHECK((lo <= s.comparison->left && s.comparison->right <= hi));
      lo = s.comparison->left, hi = s.comparison->right;
    }
    if (!truth || walk.steps.size() < 4) continue;
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

TEST_CASE("a polygon's lesson ends with the exact test's ring", "[clipping lesson]") {
  for (const Preset& p : lesson("clipping").presets) {
    if (p.group != "polygon") continue;
    INFO(p.id);
    Ring<double, 2> ring;
    for (const char* name : {"p", "q", "r", "s"}) ring.push_back(at(p.parameters, name));
    const Ring<double, 2> truth = clip(ring, clipping_box);
    const Walk walk = lesson("clipping").walk(p.parameters);
    const Step& last = walk.steps.back();
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

/// What a picture shows of each volume but the frustum itself: the volume, and its role.
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
    const auto all = volumes(walk.steps[walk.steps.size() - (p.id == "hierarchy" ? 2 : 1)].scene);
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
      CHECK(value(last, "hierarchy, *n* = 4096") < 4096 / 2);
      continue;
    }
    if (p.id == "scene") {
      CHECK(value(last, "outside") == 10 - drawn);
      CHECK_THAT(last.verdict.text, Catch::Matchers::Contains(std::to_string(drawn) + " of 10"));
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
  CHECK_THAT(walk_of("culling", "beyond-an-edge").steps.back().verdict.text,
             Catch::Matchers::Contains("not visible"));
  CHECK(lessons::culling_lesson::meet({{0, 0, 0}, {1, 1, 1}}, view));
  CHECK(lessons::culling_lesson::meet({{-9, -9, -9}, {9, 9, 9}}, view));
}

TEST_CASE("the first plane that rejects a volume ends its test", "[culling lesson]") {
  const auto planes = [](const char* id) {
    const Walk walk = walk_of("culling", id);
    return std::ranges::count_if(walk.steps, [](const Step& s) { return s.slug.starts_with("plane-"); });
  };
  CHECK(planes("inside") == 6);
  CHECK(planes("outside") == 1);
  Parameters behind = preset(lesson("culling"), "outside").parameters;
  behind["p"] = Vec3(-4.5, 0, 0), behind["size"] = 0.25;
  const std::vector<Step> steps = lesson("culling").walk(behind).steps;
  CHECK(steps.size() < 8);
  CHECK(steps.back().verdict.kind == Verdict::Kind::no);
  const Step last = walk_of("culling", "outside").steps.back();
  CHECK(last.counters.early_out);
  CHECK(
      (last.counters.mul > 0 && last.counters.mul < walk_of("culling", "inside").steps.back().counters.mul));
}
