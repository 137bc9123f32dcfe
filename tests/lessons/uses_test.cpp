// The lessons on what intersection detection is used for: their last word is that of the core's exact tests.

#include "core/clip_polygon.h"
#include "core/clip_segment.h"
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
