#include <algorithm>
#include <map>
#include <set>
#include <sstream>

#include "core/ray_sphere.h"
#include "core/ray_sphere_methods.h"
#include "lessons/lessons.h"
#include "tests/catch.h"
#include "viz/compose.h"
#include "viz/rich_text.h"

using namespace isect;
using namespace isect::viz;

namespace {

const Lesson& lesson() {
  for (const Lesson* l : lessons::all_lessons())
    if (l->id == "ray-sphere") return *l;
  throw std::runtime_error("no lesson ray-sphere");
}

Ray<double, 3> ray_of(const Parameters& p) {
  Ray<double, 3> ray = {std::get<Vec3>(p.at("origin")), std::get<Vec3>(p.at("direction"))};
  if (std::get<std::string>(p.at("extent")) == "segment") ray.range.hi = std::get<double>(p.at("t_max"));
  return ray;
}
Sphere<double, 3> ball_of(const Parameters& p) {
  return {std::get<Vec3>(p.at("center")), std::get<double>(p.at("radius"))};
}

bool meet(const TextBox& a, const TextBox& b) {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

}  // namespace

TEST_CASE("nine situations stand ready for each of the three methods", "[ray-sphere lesson]") {
  std::map<std::string, int> by_method;
  for (const Preset& p : lesson().presets) ++by_method[p.group];
  CHECK(by_method == std::map<std::string, int>{{"haines", 9}, {"quadratic", 9}, {"half-b", 9}});
  for (const Preset& p : lesson().presets) CHECK_NOTHROW(validate(lesson(), p.parameters));
}

TEST_CASE("the presets are what their names say, exactly", "[ray-sphere lesson]") {
  const auto truth = [](const char* id) {
    const Parameters& p = preset(lesson(), id).parameters;
    return intersect(ray_of(p), ball_of(p));
  };
  CHECK(truth("two-roots").line_roots == 2);
  CHECK(truth("tangent").line_roots == 1);
  CHECK(truth("miss").line_roots == 0);
  CHECK(truth("inside").origin == Location::in);
  CHECK(truth("behind").roots.hi < 0);
  CHECK_FALSE(truth("segment-before"));
  CHECK(truth("segment-before").line_roots == 2);
  CHECK(truth("segment-inside").solid->hi == 2);
  CHECK(truth("surface-in").origin == Location::on);
  CHECK(truth("surface-in").roots.lo == 0);
  CHECK(truth("surface-out").origin == Location::on);
  CHECK(truth("surface-out").roots.hi == 0);
}

TEST_CASE("every line of the pseudocode is reached by a preset", "[ray-sphere lesson]") {
  std::map<std::string, std::set<int>> reached;
  std::map<std::string, std::size_t> lines;
  for (const Preset& p : lesson().presets) {
    const Walk walk = lesson().walk(p.parameters);
    lines[p.group] = walk.pseudocode.size();
    for (const Step& s : walk.steps) {
      reached[p.group].insert(s.line);
      for (const int line : s.untaken) CHECK(line != s.line);
    }
  }
  for (const auto& [method, count] : lines) {
    for (int line = 0; line < static_cast<int>(count); ++line) {
      INFO(method << ", line " << line);
      const bool is_else = method == "haines" && line == 11;  // `else` alone does nothing to step on
      CHECK((reached[method].count(line) == 1 || is_else));
    }
  }
}

TEST_CASE("the method's answer in the last step is the exact one", "[ray-sphere lesson]") {
  for (const Preset& p : lesson().presets) {
    INFO(p.id);
    const Walk walk = lesson().walk(p.parameters);
    const RaySphere<double> truth = intersect(ray_of(p.parameters), ball_of(p.parameters));
    const Verdict::Kind expected = !truth.surface                 ? Verdict::Kind::no
                                   : truth.origin == Location::on ? Verdict::Kind::on
                                                                  : Verdict::Kind::yes;
    CHECK(walk.steps.back().verdict.kind == expected);
    for (const Step& s : walk.steps)
      if (&s != &walk.steps.back()) CHECK(s.verdict.kind == Verdict::Kind::open);
  }
}

TEST_CASE("the counters are those of the run: no root before it is needed", "[ray-sphere lesson]") {
  const auto last = [](const char* id) {
    return lesson().walk(preset(lesson(), id).parameters).steps.back().counters;
  };
  CHECK(last("behind").sqrt == 0);
  CHECK(last("behind").early_out);
  CHECK(last("two-roots").sqrt == 1);
  CHECK(last("two-roots").div == 0);
  CHECK(last("two-roots-quadratic").div == 2);
  CHECK(last("miss-half-b").sqrt == 0);
  CHECK(last("two-roots-half-b").mul < last("two-roots-quadratic").mul);
  for (const Preset& p : lesson().presets) {
    int before = 0;
    for (const Step& s : lesson().walk(p.parameters).steps) {
      const int now = s.counters.mul + s.counters.add + s.counters.div + s.counters.sqrt + s.counters.compare;
      CHECK(now >= before);
      before = now;
    }
  }
}

TEST_CASE("the values shown are those of the untraced call", "[ray-sphere lesson]") {
  const Parameters& p = preset(lesson(), "two-roots-quadratic").parameters;
  const auto t = ray_sphere::quadratic(ray_of(p), ball_of(p));
  REQUIRE(t);
  const Walk walk = lesson().walk(p);
  const std::vector<Value>& values = walk.steps.back().values;
  const auto t1 =
      std::find_if(values.begin(), values.end(), [](const Value& v) { return v.name == "*t*_1"; });
  REQUIRE(t1 != values.end());
  CHECK(t1->value == *t);
}

TEST_CASE("sentences are short, steps have names of their own and a source", "[ray-sphere lesson]") {
  for (const Preset& p : lesson().presets) {
    std::set<std::string> slugs;
    for (const Step& s : lesson().walk(p.parameters).steps) {
      INFO(p.id << ", " << s.slug << ": " << s.caption);
      CHECK(slugs.insert(s.slug).second);
      CHECK_FALSE(s.source.empty());
      int words = 0;
      std::istringstream text(plain(s.caption));
      for (std::string word; text >> word;) {
        if (word.find_first_not_of("−=<>≤≥+,.") != std::string::npos) ++words;
        CHECK(words <= 20);
        if (word.find_last_of(".:?!") == word.size() - 1) words = 0;
      }
    }
  }
}

TEST_CASE("questions offer their answer, and the answer is the exact one", "[ray-sphere lesson]") {
  int asked = 0;
  for (const Preset& p : lesson().presets) {
    const RaySphere<double> truth = intersect(ray_of(p.parameters), ball_of(p.parameters));
    for (const Step& s : lesson().walk(p.parameters).steps) {
      if (!s.question) continue;
      ++asked;
      REQUIRE(s.question->answer >= 0);
      REQUIRE(s.question->answer < static_cast<int>(s.question->choices.size()));
      if (s.question->choices[0] == "none") CHECK(s.question->answer == truth.line_roots);
      if (s.question->choices.back() == "none") CHECK((s.question->answer == 2) == !truth.surface);
    }
  }
  CHECK(asked > 27);
}

TEST_CASE("no label meets another or leaves the picture, in any theme and size", "[ray-sphere lesson]") {
  for (const Preset& p : lesson().presets) {
    const Walk walk = lesson().walk(p.parameters);
    std::vector<const Scene*> scenes;
    for (const Step& s : walk.steps) scenes.push_back(&s.scene);
    for (const ThemeName name : {ThemeName::screen, ThemeName::print, ThemeName::grey}) {
      for (const auto& [w, h] : {std::pair{480, 360}, {960, 600}, {1920, 1080}}) {
        const Camera camera = frame(lesson().camera, scenes, 1.0 * w / h);
        for (const Step& s : walk.steps) {
          const Figure f = figure(s, camera, name, w, h);
          for (std::size_t i = 0; i < f.labels.size(); ++i) {
            const TextBox& b = f.labels[i].box;
            INFO(p.id << ", " << s.slug << ", " << name_of(name) << " " << w << "x" << h << ": "
                      << f.labels[i].text);
            CHECK((b.left >= 0 && b.top >= 0 && b.right <= w && b.bottom <= h));
            for (std::size_t j = 0; j < i; ++j) {
              INFO("and " << f.labels[j].text);
              CHECK_FALSE(meet(b, f.labels[j].box));
            }
          }
        }
      }
    }
  }
}

TEST_CASE("a lesson bears any numbers a reader may drag or type", "[ray-sphere lesson]") {
  for (const char* method : {"haines", "quadratic", "half-b"}) {
    Parameters p = preset(lesson(), "two-roots").parameters;
    p["method"] = std::string(method);
    for (const Vec3& direction : {Vec3(0, 0, 0), Vec3(1e-6, 0, 0), Vec3(1e6, -1e6, 3), Vec3(0, 0, -1)}) {
      for (const double radius : {0.0, 1e-6, 1e6}) {
        p["direction"] = direction;
        p["radius"] = radius;
        const Walk walk = lesson().walk(p);
        REQUIRE_FALSE(walk.steps.empty());
        std::vector<const Scene*> scenes;
        for (const Step& s : walk.steps) scenes.push_back(&s.scene);
        const Figure f =
            figure(walk.steps.back(), frame(lesson().camera, scenes, 1.6), ThemeName::print, 960, 600);
        CHECK_FALSE(f.drawing.shapes.empty());
      }
    }
  }
}
