// What holds of every lesson, present and future: nothing here knows one by name.

#include <array>
#include <bit>
#include <map>
#include <set>
#include <sstream>

#include "tests/catch.h"
#include "tests/lessons/asked_for.h"
#include "viz/chart/case_map.h"
#include "viz/chart/chart.h"
#include "viz/compose/compose.h"
#include "viz/player/player.h"
#include "viz/text/rich_text.h"

namespace every_lesson_test {
using namespace isect;
using namespace isect::viz;

namespace {

/// Whether a line is just an `else`, which does nothing and so has no step.
bool is_else(const std::string& line) {
  const std::size_t first = line.find_first_not_of(' ');
  return first != std::string::npos && line.substr(first) == "else";
}

struct Page {
  ThemeName theme;
  int width, height;
};
/// Dark and grey have the same sizes as screen and print, so they are tried at one page size each.
constexpr Page pages[] = {{ThemeName::screen, 480, 360}, {ThemeName::screen, 960, 600}, {ThemeName::screen, 1920, 1080},
                          {ThemeName::print, 480, 360},  {ThemeName::print, 960, 600},  {ThemeName::print, 1920, 1080},
                          {ThemeName::dark, 960, 600},   {ThemeName::grey, 480, 360}};

}  // namespace

TEST_CASE("labels neither meet nor leave the picture, in any preset, step, theme and size", "[every lesson]") {
  for (const Lesson* lesson : those_asked_for()) {
    std::vector<Walk> walks;
    for (const Preset& p : lesson->presets) walks.push_back(walk_with_map(*lesson, p.parameters));
    for (const auto& [name, w, h] : pages) {
      for (std::size_t i = 0; i < walks.size(); ++i) {
        const double aspect = picture_aspect(walks[i], name, w, h);
        const Camera camera = frame_alike(lesson->camera, walks[i], walks, aspect);
        for (const Step& s : walks[i].steps) {
          for (const std::string& fault : label_faults(figure(s, closer(camera, s.scene, aspect), name, w, h)))
            FAIL_CHECK(lesson->id << " " << lesson->presets[i].id << ", " << s.slug << ", " << name_of(name) << " " << w
                                  << "x" << h << ": " << fault);
        }
      }
    }
  }
}

TEST_CASE("a player shows all of what it draws, also while it asks", "[every lesson]") {
  for (const Lesson* lesson : those_asked_for()) {
    Player player({lesson}, ReaderState{}, true);
    for (const Preset& preset : lesson->presets)
      for (const double aspect : {1.2, 2.0}) {
        player.load(preset);
        player.set_aspect(aspect);
        for (bool more = true; more;) {
          const Camera camera = player.camera().goal();
          const View view(camera, 1, 1);
          const Scene& scene = player.scene();
          if (!scene.chart && !scene.items.empty() && !camera.perspective) {
            const Box2 box = extent(scene.items, camera);
            const Vec2 middle(camera.target.dot(view.right()), camera.target.dot(view.up()));
            const Vec2 half = camera.half_height * (1 + 1e-9) * Vec2(aspect, 1);
            INFO(lesson->id << " " << preset.id << ", " << player.step().slug
                            << (player.quiz().asked() ? ", asking" : ""));
            CHECK(((box.lo - middle + half).minCoeff() >= 0 && (middle + half - box.hi).minCoeff() >= 0));
          }
          more = !player.at_end();
          player.next();
        }
      }
  }
}

TEST_CASE("dark has the lengths of screen, and grey of print", "[every lesson]") {
  using Lengths = std::array<double, sizeof(Sizes) / sizeof(double)>;
  const auto lengths = [](ThemeName name, const Page& page) {
    return std::bit_cast<Lengths>(theme(name, page.width, page.height).sizes);
  };
  for (const Page& page : pages) {
    CHECK(lengths(ThemeName::dark, page) == lengths(ThemeName::screen, page));
    CHECK(lengths(ThemeName::grey, page) == lengths(ThemeName::print, page));
  }
}

TEST_CASE("a cross means wrong, never no", "[every lesson]") {
  const std::set<std::string> where_methods_err = {"points", "robustness", "rules-of-thumb"};
  for (const Lesson* lesson : those_asked_for())
    for (const Preset& p : lesson->presets)
      for (const Step& s : lesson->walk(p.parameters).steps)
        for (const Item& item : s.scene.items) {
          const Dot* dot = std::get_if<Dot>(&item);
          INFO(lesson->id << " " << p.id << ", " << s.slug);
          CHECK_FALSE((dot && dot->mark == Mark::cross && !where_methods_err.contains(lesson->id)));
        }
}

TEST_CASE("every line of the pseudocode is reached by a preset", "[every lesson]") {
  for (const Lesson* lesson : those_asked_for()) {
    std::map<std::vector<std::string>, std::set<int>> reached;
    for (const Preset& p : lesson->presets) {
      const Walk walk = lesson->walk(p.parameters);
      for (const Step& s : walk.steps) {
        reached[walk.pseudocode].insert(s.line);
        for (const int line : s.untaken) CHECK(line != s.line);
      }
    }
    for (const auto& [pseudocode, lines] : reached)
      for (int line = 0; line < static_cast<int>(pseudocode.size()); ++line) {
        INFO(lesson->id << ", line " << line << ": " << pseudocode[line]);
        CHECK((lines.count(line) == 1 || is_else(pseudocode[line])));
      }
  }
}

TEST_CASE("sentences are short, steps have names of their own and a source", "[every lesson]") {
  for (const Lesson* lesson : those_asked_for()) {
    CHECK_FALSE(lesson->rows.empty());
    CHECK_FALSE(lesson->summary.empty());
    for (const Preset& p : lesson->presets) {
      CHECK_NOTHROW(validate(*lesson, p.parameters));
      std::set<std::string> slugs;
      const Walk walk = lesson->walk(p.parameters);
      CHECK_FALSE(walk.alt.empty());
      for (const Step& s : walk.steps) {
        INFO(lesson->id << " " << p.id << ", " << s.slug << ": " << s.caption);
        CHECK(slugs.insert(s.slug).second);
        CHECK_FALSE(s.source.empty());
        CHECK_FALSE(s.caption.empty());
        int words = 0;
        std::istringstream lines(plain(s.caption));
        for (std::string line; std::getline(lines, line);) {
          if (line.starts_with("Read: ")) continue;  // a work cited is not a sentence
          std::istringstream text(line);
          for (std::string word; text >> word;) {
            if (word.find_first_not_of("−=<>≤≥+,.") != std::string::npos) ++words;
            CHECK(words <= 20);
            if (word.find_last_of(".:?!") == word.size() - 1) words = 0;
          }
        }
      }
    }
  }
}

TEST_CASE("each walk ends with a verdict, and steps before it leave it open or keep to it", "[every lesson]") {
  for (const Lesson* lesson : those_asked_for()) {
    int questions = 0;
    for (const Preset& p : lesson->presets) {
      INFO(lesson->id << " " << p.id);
      const Walk walk = lesson->walk(p.parameters);
      REQUIRE_FALSE(walk.steps.empty());
      CHECK(walk.steps.back().verdict.kind != Verdict::Kind::open);
      CHECK_FALSE(walk.steps.back().verdict.text.empty());
      int before = 0;
      for (const Step& s : walk.steps) {
        const Counters& c = s.counters;
        CHECK(c.mul + c.add + c.div + c.sqrt + c.compare >= before);
        before = c.mul + c.add + c.div + c.sqrt + c.compare;
        if (!s.question) continue;
        ++questions;
        CHECK((s.question->answer >= 0 && s.question->answer < static_cast<int>(s.question->choices.size())));
        CHECK_FALSE(s.question->because.empty());
      }
    }
    CHECK(questions > 0);
  }
}

TEST_CASE("a flat lesson lies in one plane and is seen straight on", "[every lesson]") {
  for (const Lesson* lesson : those_asked_for()) {
    if (!lesson->flat) continue;
    CHECK((opening(*lesson).azimuth == 0 && opening(*lesson).elevation == 0));
    CHECK_FALSE(opening(*lesson).perspective);
    for (const Preset& p : lesson->presets)
      for (const Step& s : lesson->walk(p.parameters).steps)
        for (const Handle& handle : s.scene.handles) CHECK(handle.at.z() == 0);
  }
}

TEST_CASE("a handle that is dragged stays under the pointer, and one that is not moved stays", "[every lesson]") {
  for (const Lesson* lesson : those_asked_for()) {
    for (const Preset& p : lesson->presets) {
      const Walk walk = lesson->walk(p.parameters);
      const std::vector<Handle>& handles = walk.steps.front().scene.handles;
      const bool measured = bool(walk.steps.front().scene.chart);  // what was measured is not dragged
      CHECK(handles.empty() == measured);
      for (std::size_t i = 0; i < handles.size(); ++i) {
        INFO(lesson->id << " " << p.id << ", " << handles[i].parameter);
        Parameters parameters = p.parameters;
        drag(*lesson, parameters, handles[i], handles[i].at);
        const Walk again = lesson->walk(parameters);
        REQUIRE(again.steps.front().scene.handles.size() == handles.size());
        const Vec3& now = again.steps.front().scene.handles[i].at;
        CHECK((now - handles[i].at).norm() <= 1e-9 * (1 + handles[i].at.norm()));
      }
    }
  }
}

TEST_CASE("presets visit every branch of a map of cases, and a setting brought to a place lies there",
          "[every lesson]") {
  for (const Lesson* lesson : those_asked_for()) {
    if (!lesson->map) continue;
    const CaseMap& map = *lesson->map;
    std::set<int> visited;
    for (const Preset& p : lesson->presets) {
      INFO(lesson->id << " " << p.id);
      visited.insert(map.branch(p.parameters));
      const Vec2 at = map.place(p.parameters);
      const bool on_map = (at.array() >= map.lo.array()).all() && (at.array() <= map.hi.array()).all();
      const Walk walk = lesson->walk(p.parameters);
      const auto shown = std::ranges::find(walk.steps, std::string(case_map_slug), &Step::slug);
      CHECK((shown != walk.steps.end()) == on_map);
      if (!on_map) continue;
      CHECK(std::get<Cases>(shown->scene.chart->kind).here->branch == map.branch(p.parameters));
      for (const Vec2& share : {Vec2(0.21, 0.37), Vec2(0.83, 0.62)}) {
        const Vec2 to = map.lo + share.cwiseProduct(map.hi - map.lo);
        CHECK((map.place(map.moved(p.parameters, to)) - to).norm() <= 1e-9 * (map.hi - map.lo).norm());
      }
    }
    for (int i = 0; i < static_cast<int>(map.branches.size()); ++i) {
      INFO(lesson->id << ": " << map.branches[i]);
      CHECK(visited.contains(i));
    }
  }
}

}  // namespace every_lesson_test
