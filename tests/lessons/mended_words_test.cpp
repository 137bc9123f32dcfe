// What some lessons once said wrongly: numbers, terms and answers, each against what the picture or the core has.

#include <cmath>
#include <regex>
#include <set>

#include "lessons/sphere_sphere/picture.h"
#include "tests/lessons/texts.h"
#include "tests/lessons/words.h"
#include "viz/text/rich_text.h"
#include "viz/walk/alt_text.h"
#include "viz/walk/scene_in_words.h"

namespace mended_words_test {
using namespace isect;
using namespace isect::viz;
using namespace isect::tests;
using isect::test::Contains;

namespace {

/// The walk with these settings in place of the preset's own.
Walk with(const std::string& id, const Exercise& e) {
  Parameters setting = preset(lesson(id), e.preset).parameters;
  for (const auto& [name, value] : e.by) set(lesson(id), setting, name, value);
  return lesson(id).walk(setting);
}

}  // namespace

TEST_CASE("the solution that shows a shadow names the object that lies in it", "[words]") {
  const Exercise& e = lesson("ray-tracing").closing->exercises.front();
  const std::string verdict = plain(ending(with("ray-tracing", e)).verdict.text);
  const std::string lit = verdict.substr(0, verdict.find(','));
  CHECK_THAT(verdict, Contains("in the shadow of ball a"));
  std::string solution = plain(e.solution);
  std::ranges::transform(solution, solution.begin(), [](unsigned char c) { return std::tolower(c); });
  CHECK_THAT(solution, Contains(lit + " lies in the shadow of ball a"));
}

TEST_CASE("a box that is to touch is moved there in its own size", "[words]") {
  const Exercise& e = lesson("aabb-aabb").closing->exercises.front();
  const auto size = [](const Parameters& p) {
    return Vec3(std::get<Vec3>(p.at("b_max")) - std::get<Vec3>(p.at("b_min")));
  };
  Parameters setting = preset(lesson("aabb-aabb"), e.preset).parameters;
  const Vec3 before = size(setting);
  for (const auto& [name, value] : e.by) set(lesson("aabb-aabb"), setting, name, value);
  CHECK(size(setting) == before);
}

TEST_CASE("a side after the other is asked about where the answer is a new one, and only there", "[words]") {
  for (const char* id : {"culling", "clipping", "convex-hull", "points", "aabb-aabb"})
    for (const Preset& p : lesson(id).presets) {
      INFO(id << " " << p.id);
      std::set<std::string> asked;
      for (const Step& s : lesson(id).walk(p.parameters).steps) {
        if (!s.question) continue;
        static const std::regex name("left|right|bottom|top|near|far|AABB|smallest (OBB|circle)|\\*[xyz]\\*");
        CHECK(asked.insert(std::regex_replace(s.question->prompt, name, "…") + " " + answer(s)).second);
      }
    }
}

TEST_CASE("where a scene of other boxes is counted, the words say so", "[words]") {
  for (const Preset& p : lesson("culling").presets) {
    INFO(p.id);
    const Walk walk = lesson("culling").walk(p.parameters);
    const Step* const growth = find(walk, "growth");
    if (!growth) continue;
    CHECK_THAT(growth->caption, Contains("Another scene"));
    const double sixteen = value(*growth, "hierarchy, 16 boxes");
    CHECK(says(growth->caption, "Of 16 it takes " + shown(sixteen)));
    CHECK(says(growth->caption, "more than one by one") == (sixteen > 16));
  }
}

TEST_CASE("what of a box lies in a plane that it touches has as many corners as the words say", "[words]") {
  const Walk walk = walk_of("culling", "touching");
  int touched = 0;
  for (const Step& step : walk.steps)
    if (says(step.caption, "the box touches the plane")) {
      ++touched;
      CHECK_THAT(step.caption, Contains("A face with the p-vertex lies in the plane"));
      if (step.question) CHECK(answer(step) == "neither");
    }
  CHECK(touched == 1);
}

TEST_CASE("the volumes' test takes twelve comparisons at most, as its two lines do", "[words]") {
  int most = 0;
  for (const Preset& p : lesson("bounding-volumes").presets) {
    const Walk walk = lesson("bounding-volumes").walk(p.parameters);
    const Step* const step = find(walk, "volume-first");
    if (!step) continue;
    const int taken = static_cast<int>(value(*step, "volumes"));
    CHECK(taken <= 12);
    CHECK_THAT(step->question->because, Contains("here " + std::to_string(taken)));
    most = std::max(most, taken);
  }
  CHECK(most == 12);
}

TEST_CASE("numbers that read alike and are not equal are told in full", "[words]") {
  const Walk ten = walk_of("points", "ten-steps");
  const Step& x = *find(ten, "axis-x");
  CHECK(shown(x.values) == std::vector<std::string>{"1", "0.9999999999999999"});
  CHECK_THAT(walk_of("intervals", "near-points").alt, Contains("0.30000000000000004") && Contains("0.3:"));
}

TEST_CASE("what is no number is told as NaN", "[words]") {
  const Walk walk = walk_of("points", "nan");
  const Step& z = *find(walk, "axis-z");
  REQUIRE(std::isnan(z.values.back().value));
  CHECK(shown(z.values).back() == "NaN");
}

TEST_CASE("a question of three tests says why they part in this very case", "[words]") {
  const auto why = [](const char* preset) {
    const Walk walk = walk_of("points", preset);
    return find(walk, "squares")->question->because;
  };
  CHECK_THAT(why("cube"), Contains("in the cube, but not in the ball") && !Contains("range") && !Contains("rounding"));
  CHECK_THAT(why("rounding"), Contains("rounding loses") && !Contains("range"));
  CHECK_THAT(why("overflow"), Contains("leaves the range") && !Contains("rounding"));
}

TEST_CASE("a line is not called after a point that lies half-way on it", "[words]") {
  const Preset& p = preset(lesson("robustness"), "orientation");
  const Walk walk = lesson("robustness").walk(p.parameters);
  const std::vector<std::string> told = scene_in_words(walk.steps.front().scene, p.parameters, true);
  CHECK(told == std::vector<std::string>{"segment: (-0.25, -0.25) to (3.25, 3.25)"});
}

TEST_CASE("alt text tells where what no parameter moves lies", "[words]") {
  const auto alt = [](const char* id, const char* preset_id) {
    const Parameters& p = preset(lesson(id), preset_id).parameters;
    return alt_text(lesson(id), p, lesson(id).walk(p), 0);
  };
  CHECK_THAT(alt("crossings", "vertex-passed"), Contains("Fixed: polygon: (−2, −1.5), (0.75, −1.75), (2.25, 0)"));
  CHECK_THAT(alt("ray-tracing", "lit"), Contains("rectangle floor: (0.25, −1, −2.5) to (4.5, −1, 2.5)"));
  CHECK_THAT(alt("clipping", "cut"), Contains("Fixed: box: (−2, −1.25) to (2, 1.25)."));
}

TEST_CASE("a distance in a huge unit is told with its unit", "[words]") {
  for (const Preset& p : lesson("sphere-sphere").presets) {
    INFO(p.id);
    const auto setup = lessons::sphere_sphere_lesson::setup(p.parameters);
    const Walk walk = lesson("sphere-sphere").walk(p.parameters);
    const Step& last = ending(walk);
    CHECK(says(last.formula, "2^{600}") == (setup.unit > 1));
    CHECK(says(last.formula, "2^{−600}") == (setup.unit < 1));
    const std::string& told = find(walk, "distance")->caption;
    CHECK_FALSE(says(told, " or "));
    if (says(told, "coincide")) CHECK(setup.a.center == setup.b.center);
    if (says(told, "underflow")) CHECK(setup.a.center != setup.b.center);
  }
}

TEST_CASE("the points that a hull is built of are those that differ", "[words]") {
  const Walk walk = walk_of("convex-hull", "twice");
  const Step& first = walk.steps.front();
  CHECK(value(first, "different points") == 4);
  CHECK_THAT(first.caption, Contains("Equal points are kept once: 4 are left."));
}

TEST_CASE("digits that are lost and digits that are right are sixteen at least", "[words]") {
  const std::regex count("About ([0-9]+) of 16 digits are lost");
  int told = 0;
  for (const Preset& p : lesson("ray-sphere").presets) {
    const Walk walk = lesson("ray-sphere").walk(p.parameters);
    for (const Step& step : walk.steps) {
      std::smatch lost;
      if (!std::regex_search(step.caption, lost, count)) continue;
      for (const Opinion& o : lesson("ray-sphere").opinions(p.parameters)) {
        std::smatch right;
        static const std::regex digits("([0-9]+) digits? (is|are) right");
        if (o.method != (walk.method == "half-B" ? "half-B" : "quadratic formula") ||
            !std::regex_search(o.says, right, digits))
          continue;
        ++told;
        CHECK(std::stoi(lost[1]) + std::stoi(right[1]) >= 16);
      }
    }
  }
  CHECK(told > 0);
}

TEST_CASE("a ray that is rejected before its line is asked about is not said to have roots", "[words]") {
  int early = 0;
  on_random_settings("ray-sphere", 300, [&](const Parameters&, const Walk& walk) {
    const Step* const step = find(walk, "reject");
    if (!step || find(walk, "passing-distance")) return;
    ++early;
    CHECK_FALSE(says(step->caption, "root"));
    CHECK_FALSE(says(step->caption, "The line meets"));
  });
  CHECK(early > 0);
}

TEST_CASE("the trapezoid map counts the edges that are added without a step", "[words]") {
  for (const Preset& p : lesson("concave-polygon").presets) {
    INFO(p.id);
    const Walk walk = lesson("concave-polygon").walk(p.parameters);
    int steps = 0;
    for (const Step& s : walk.steps) {
      if (!s.slug.starts_with("insert-")) continue;
      const int number = std::stoi(s.slug.substr(7));
      CHECK(s.title.ends_with("number " + std::to_string(number)));
      CHECK(says(s.caption, "been added in between") == (number > ++steps));
    }
  }
}

TEST_CASE("no text names a colour, which another theme does not have", "[words]") {
  static const std::regex colour(
      "\\b(green|blue|orange|yellow|red|violet|purple|pink|brown|gr[ea]y|black|white)\\b|"
      "\\bcolou?red\\b|highlighted\\)",
      std::regex::icase);
  for (const Lesson* l : lessons::all_lessons())
    for (const std::string& text : texts(*l)) {
      INFO(l->id << ": " << text);
      CHECK_FALSE(std::regex_search(text, colour));
    }
}

TEST_CASE("what lies behind the object picked is told only where the ray meets something there", "[words]") {
  std::set<std::size_t> met;
  on_random_settings("picking", 60, [&](const Parameters&, const Walk& walk) {
    const Step& last = ending(walk);
    if (last.verdict.kind != Verdict::Kind::yes) return;
    const auto hits = static_cast<std::size_t>(
        std::ranges::count_if(last.values, [](const Value& v) { return v.name.starts_with("*t* of "); }));
    INFO(last.caption);
    met.insert(hits);
    CHECK(says(last.caption, "meets no other") == (hits == 1));
    CHECK(says(last.caption, "cannot be picked here") == (hits > 1));
  });
  CHECK(met.size() >= 2);
}

TEST_CASE("the words for an image of pixels speak of no scene around it", "[words]") {
  for (const char* id : {"picking", "ray-tracing"})
    for (const Preset& p : lesson(id).presets) {
      const Walk walk = lesson(id).walk(p.parameters);
      const std::vector<Item>& drawn = ending(walk).scene.items;
      INFO(id << " " << p.id << ": " << walk.alt);
      REQUIRE(std::ranges::any_of(drawn, [](const Item& i) { return std::holds_alternative<Raster>(i); }));
      CHECK_FALSE(says(walk.alt, "image plane"));
      CHECK(says(walk.alt, "in pixels"));
    }
}

TEST_CASE("what a method loses is not said to be crossed out, where no cross is drawn", "[words]") {
  const Step& last = ending(walk_of("clipping", "along-a-side"));
  CHECK_THAT(last.caption, Contains("Slabs by reciprocals lose it: ") && !Contains("crossed out"));
}

TEST_CASE("sets that touch from inside have no choice that calls them touching alone", "[words]") {
  int asked = 0;
  for (const Lesson* l : lessons::all_lessons())
    for (const Preset& p : l->presets)
      for (const Step& s : l->walk(p.parameters).steps) {
        if (!s.question || !s.question->prompt.ends_with("related?")) continue;
        ++asked;
        INFO(l->id << " " << p.id);
        CHECK(std::ranges::count(s.question->choices, "touching from outside") == 1);
        CHECK(std::ranges::count(s.question->choices, "touching") == 0);
      }
  CHECK(asked >= 20);
  const Walk inner = walk_of("sphere-sphere", "inner-touch");
  CHECK(answer(*find(inner, "compare")) == "one inside the other");
  CHECK_THAT(ending(inner).caption, Contains("touches it from within"));
}

TEST_CASE("a question of a node names it", "[words]") {
  int asked = 0;
  for (const Step& s : walk_of("culling", "hierarchy").steps)
    if (s.question && s.slug.starts_with("node-")) {
      const std::string node = s.slug == "node-0" ? "the root" : "node " + s.slug.substr(5);
      CHECK(says(s.question->prompt, "The box of " + node + " reaches from "));
      ++asked;
    }
  CHECK(asked >= 2);
}

}  // namespace mended_words_test
