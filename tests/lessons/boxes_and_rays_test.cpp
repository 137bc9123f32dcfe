// The lessons of boxes and of rays: what their presets show, against numbers worked out by hand.

#include <map>

#include "core/sphere_aabb.h"
#include "lessons/lessons.h"
#include "lessons/relation.h"
#include "tests/catch.h"
#include "viz/place.h"

using namespace isect;
using namespace isect::viz;

namespace {

const Lesson& lesson(const std::string& id) { return lesson_named(lessons::all_lessons(), id); }

Walk walk_of(const std::string& id, const std::string& preset_id) {
  return lesson(id).walk(preset(lesson(id), preset_id).parameters);
}

const Step& step_of(const Walk& walk, const std::string& slug) {
  for (const Step& s : walk.steps)
    if (s.slug == slug) return s;
  FAIL("no step " << slug);
  return walk.steps.front();
}

bool has_step(const Walk& walk, const std::string& slug) {
  for (const Step& s : walk.steps)
    if (s.slug == slug) return true;
  return false;
}

double value_of(const Step& step, const std::string& name) {
  for (const Value& v : step.values)
    if (v.name == name) return v.value;
  FAIL("no value " << name);
  return 0;
}

/// The methods that do not agree with the exact one.
std::vector<std::string> dissenters(const std::string& id, const std::string& preset_id) {
  std::vector<std::string> found;
  for (const Opinion& o : lesson(id).opinions(preset(lesson(id), preset_id).parameters))
    if (!o.agrees) found.push_back(o.method);
  return found;
}

}  // namespace

TEST_CASE("the ball-and-box lesson gathers the squared distance axis by axis", "[sphere-aabb]") {
  const Walk walk = walk_of("sphere-aabb", "corner");  // gaps 3/4, 5/8, -5/8
  CHECK(value_of(step_of(walk, "axis-x"), "*d*^2") == 0.5625);
  CHECK(value_of(step_of(walk, "axis-y"), "*d*^2") == 0.953125);
  CHECK(value_of(step_of(walk, "axis-z"), "*d*^2") == 1.34375);
  CHECK(step_of(walk, "axis-y").line == 2);
  CHECK(step_of(walk, "axis-z").line == 1);
  CHECK(step_of(walk, "relation").comparison->right == 2.25);
  CHECK(walk.steps.back().counters.mul == 4);
  CHECK(walk.steps.back().counters.sqrt == 0);
}

TEST_CASE("the ball-and-box lesson shows every region and every relation", "[sphere-aabb]") {
  const std::map<std::string, std::pair<int, Verdict::Kind>> expected = {
      {"corner", {3, Verdict::Kind::yes}},         {"corner-miss", {3, Verdict::Kind::no}},
      {"touching-face", {1, Verdict::Kind::on}},   {"touching-edge", {2, Verdict::Kind::on}},
      {"touching-corner", {3, Verdict::Kind::on}}, {"ball-inside", {0, Verdict::Kind::yes}},
      {"box-inside", {0, Verdict::Kind::yes}}};
  CHECK(expected.size() == lesson("sphere-aabb").presets.size());
  for (const auto& [id, what] : expected) {
    INFO(id);
    const Walk walk = walk_of("sphere-aabb", id);
    int gaps = 0;
    for (const char* axis : {"axis-x", "axis-y", "axis-z"}) gaps += step_of(walk, axis).line > 0 ? 1 : 0;
    CHECK(gaps == what.first);
    CHECK(walk.steps.back().verdict.kind == what.second);
    const bool note_says_overlap = step_of(walk, "relation").line == 3;
    CHECK(note_says_overlap ==
          (what.second == Verdict::Kind::yes));  // touching: the strict comparison refuses
  }
  CHECK(walk_of("sphere-aabb", "ball-inside").steps.back().verdict.text == "the ball lies inside the box");
  CHECK(walk_of("sphere-aabb", "box-inside").steps.back().verdict.text == "the box lies inside the ball");
}

TEST_CASE("the box grown by the radius errs at a corner, and the note's comparison at touching",
          "[sphere-aabb]") {
  CHECK(has_step(walk_of("sphere-aabb", "corner-miss"), "grown"));
  CHECK_FALSE(has_step(walk_of("sphere-aabb", "touching-face"), "grown"));
  CHECK(dissenters("sphere-aabb", "corner-miss") ==
        std::vector<std::string>{"centre in the box grown by *r*"});
  CHECK(dissenters("sphere-aabb", "touching-corner") ==
        std::vector<std::string>{"accumulated, strict (the note)"});
  CHECK(dissenters("sphere-aabb", "corner").empty());
}

TEST_CASE("a box with exchanged corners meets no ball", "[sphere-aabb]") {
  Parameters p = lesson("sphere-aabb").presets.front().parameters;
  p["b_max"] = Vec3(-3, 1, 1);
  CHECK(lesson("sphere-aabb").walk(p).steps.back().verdict.kind == Verdict::Kind::no);
}
