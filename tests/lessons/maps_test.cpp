// The maps of cases of all lessons: names lie in what they name, lengths are drawn at one scale, and making one takes
// little work.

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <utility>

#include "tests/catch.h"
#include "tests/lessons/asked_for.h"
#include "tests/viz/drawn.h"
#include "tests/viz/scarce_memory.h"
#include "viz/chart/case_map.h"
#include "viz/chart/chart.h"
#include "viz/compose/labels.h"
#include "viz/compose/marks.h"
#include "viz/text/rich_text.h"

namespace maps_test {
using namespace isect;
using namespace isect::viz;

namespace {

struct Page {
  ThemeName theme;
  double width, height;
};
constexpr Page pages[] = {{ThemeName::screen, 960, 600},
                          {ThemeName::grey, 960, 600},
                          {ThemeName::grey, 640, 360},
                          {ThemeName::screen, 640, 600}};

/// The map as another machine may compute it: each number is off by up to `rounding`.
Chart rounded(Chart chart, double rounding) {
  std::minstd_rand random(7);
  std::uniform_real_distribution<double> off(-rounding, rounding);
  const auto shift = [&](Vec2& p) { p += Vec2(off(random), off(random)); };
  Cases& cases = std::get<Cases>(chart.kind);
  for (Cases::Patch& patch : cases.patches) std::ranges::for_each(patch.corners, shift);
  for (std::vector<Vec2>& border : cases.borders) std::ranges::for_each(border, shift);
  for (Cases::Spot& spot : cases.presets) shift(spot.at);
  if (cases.here) shift(cases.here->at);
  return chart;
}

/// A composed map in its own units.
class Drawn {
 public:
  Drawn(const Lesson& lesson, const Parameters& setting, const Page& page, double rounding = 0)
      : map_(*lesson.map),
        setting_(setting),
        chart_(rounded(case_map(lesson, setting), rounding)),
        cases_(std::get<Cases>(chart_.kind)),
        theme_(theme(page.theme, page.width, page.height)),
        height_(height_of(lesson.walk(setting), page)),
        plane_(plane_of(cases_, {0, 0}, page.width, height_, theme_)),
        composed_(compose(chart_, {0, 0}, page.width, height_, theme_)) {}

  const std::vector<PlacedLabel>& labels() const { return composed_.labels; }
  Vec2 unit() const { return (plane_.hi - plane_.lo).cwiseQuotient(map_.hi - map_.lo); }
  int branch(const Vec2& p) const {
    const Vec2 share = (p - plane_.lo).cwiseQuotient(plane_.hi - plane_.lo);
    const Vec2 at(map_.lo.x() + share.x() * (map_.hi.x() - map_.lo.x()),
                  map_.hi.y() - share.y() * (map_.hi.y() - map_.lo.y()));
    return map_.branch(map_.moved(setting_, at));
  }

  /// The branches that have an area.
  std::set<int> regions() const {
    std::set<int> found;
    for (const Cases::Patch& patch : cases_.patches) found.insert(patch.branch);
    return found;
  }
  std::vector<PlacedLabel> names_of(int branch) const {
    std::vector<PlacedLabel> found;
    for (const PlacedLabel& label : composed_.labels)
      if (label.text == plain(map_.branches[branch])) found.push_back(label);
    return found;
  }

  bool lies_in(const TextBox& box, int wanted) const {
    for (int i = 0; i <= 24; ++i)
      for (int j = 0; j <= 6; ++j)
        if (branch({box.left + i / 24.0 * (box.right - box.left), box.top + j / 6.0 * (box.bottom - box.top)}) !=
            wanted)
          return false;
    return true;
  }
  /// Whether the leader is drawn from beside the text to a point of the region.
  bool leads(const PlacedLabel& label, int wanted) const {
    if (!label.leads_to || branch(*label.leads_to) != wanted) return false;
    return std::ranges::any_of(all<Stroke>(composed_.shapes), [&](const Stroke& stroke) {
      const std::vector<Vec2> line = flatten(stroke.path);
      const auto off = [&](const Vec2& p) {
        return std::hypot(std::max({label.box.left - p.x(), p.x() - label.box.right, 0.0}),
                          std::max({label.box.top - p.y(), p.y() - label.box.bottom, 0.0}));
      };
      return line.size() == 2 && ((line[0] == *label.leads_to && off(line[1]) < theme_.sizes.label) ||
                                  (line[1] == *label.leads_to && off(line[0]) < theme_.sizes.label));
    });
  }
  /// Whether the name of a line or a point stands beside a marked setting on it.
  bool stands_beside(const PlacedLabel& label, int wanted) const {
    std::vector<Cases::Spot> spots = cases_.presets;
    if (cases_.here) spots.push_back(*cases_.here);
    return std::ranges::any_of(spots, [&](const Cases::Spot& spot) {
      const Vec2 p = drawn(spot.at);
      if (label.leads_to) return spot.branch == wanted && (*label.leads_to - p).norm() < 1e-6;
      const auto nearer = [&](const Cases::Spot& other) {
        const bool apart =
            (drawn(other.at) - p).norm() > mark_radius(Mark::uncounted, theme_.sizes);  // else one marker
        return apart && off(drawn(other.at), label) < off(p, label);
      };
      return spot.branch == wanted && off(p, label) < 1.5 * theme_.sizes.label && std::ranges::none_of(spots, nearer);
    });
  }
  /// The distance of a drawn point from a text.
  static double off(const Vec2& p, const PlacedLabel& label) {
    return std::hypot(std::max({label.box.left - p.x(), p.x() - label.box.right, 0.0}),
                      std::max({label.box.top - p.y(), p.y() - label.box.bottom, 0.0}));
  }
  Vec2 drawn(const Vec2& at) const {
    const Vec2 share = (at - map_.lo).cwiseQuotient(map_.hi - map_.lo);
    return plane_.lo + Vec2(share.x(), 1 - share.y()).cwiseProduct(plane_.hi - plane_.lo);
  }
  /// The texts that a marker covers.
  std::vector<std::string> covered() const {
    std::vector<std::string> all;
    const auto look = [&](const Cases::Spot& spot, Mark mark) {
      for (const PlacedLabel& label : composed_.labels)
        if (off(drawn(spot.at), label) < mark_radius(mark, theme_.sizes)) all.push_back(label.text);
    };
    for (const Cases::Spot& preset : cases_.presets)
      look(preset, regions().contains(preset.branch) ? Mark::uncounted : Mark::diamond);
    if (cases_.here) look(*cases_.here, Mark::double_disc);
    return all;
  }
  bool is_marked(int branch) const {
    const auto on = [&](const Cases::Spot& spot) { return spot.branch == branch; };
    return std::ranges::any_of(cases_.presets, on) || (cases_.here && on(*cases_.here));
  }

 private:
  /// The height of the page that title, formula and verdict leave for the picture.
  static double height_of(const Walk& walk, const Page& page) {
    return page_layout(walk, page.theme, page.width, page.height).picture_height();
  }

  const CaseMap& map_;
  const Parameters& setting_;
  Chart chart_;
  const Cases& cases_;
  Theme theme_;
  double height_;
  Box2 plane_;
  Composed composed_;
};

struct Leader {
  std::string name;
  Vec2 from, to;
};

std::vector<Leader> leaders(const std::vector<PlacedLabel>& labels) {
  std::vector<Leader> all;
  for (const PlacedLabel& label : labels)
    if (label.leads_to) all.push_back({label.text, nearest_in(label.box, *label.leads_to), *label.leads_to});
  return all;
}

/// The names that another name's leader runs through or grazes, and leaders that cross.
std::vector<std::string> crossed(const std::vector<PlacedLabel>& labels, double clear) {
  std::vector<std::string> all;
  const std::vector<Leader> lines = leaders(labels);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto& [name, from, to] = lines[i];
    for (const PlacedLabel& label : labels)
      if (label.text != name && length_inside(from, to, grown(label.box, clear)) > 0)
        all.push_back(name + " through " + label.text);
    for (std::size_t j = 0; j < i; ++j)
      if (cross(from, to, lines[j].from, lines[j].to)) all.push_back(name + " across that of " + lines[j].name);
  }
  return all;
}

/// The name of a region lies in it or has a leader that ends in it, that of a line stands beside a point of it.
void names_stand_at_what_they_name(const Lesson& lesson, const Drawn& map) {
  const std::set<int> regions = map.regions();
  for (int i = 0; i < static_cast<int>(lesson.map->branches.size()); ++i) {
    INFO(lesson.map->branches[i]);
    const std::vector<PlacedLabel> names = map.names_of(i);
    if (regions.contains(i)) {
      REQUIRE(names.size() == 1);
      CHECK((map.lies_in(names[0].box, i) || map.leads(names[0], i)));
    } else {
      CHECK(names.size() == (map.is_marked(i) ? 1 : 0));
      for (const PlacedLabel& name : names) CHECK(map.stands_beside(name, i));
    }
  }
}

void no_marker_covers_a_name_or_a_number(const Drawn& map) {
  CAPTURE(map.covered());
  CHECK(map.covered().empty());
}

void a_circle_of_lengths_is_a_circle(const Lesson& lesson, const Drawn& map) {
  static const std::set<std::string> not_lengths = {"obb-obb", "relations"};  // degrees, and a ratio of sizes
  if (!not_lengths.contains(lesson.id)) CHECK(std::abs(map.unit().x() / map.unit().y() - 1) < 1e-9);
}

/// What making a map takes, on any machine: how often the lesson is asked for a branch, and how often memory is asked
/// for. A lesson that sets up or computes too much for its answer shows there: exact arithmetic and lists are on the
/// heap.
struct Work {
  int questions;
  long allocations;
};

const CaseMap* asked = nullptr;  // by way of the map that counts
int questions = 0;

Work work_of(const Lesson& lesson, const Parameters& setting) {
  asked = lesson.map, questions = 0;
  CaseMap counted = *lesson.map;
  counted.branch = [](const Parameters& p) {
    ++questions;
    return asked->branch(p);
  };
  Lesson counting = lesson;
  counting.map = &counted;
  constexpr long plenty = 1'000'000'000;
  tests::allocations_left = plenty;
  const Chart map = case_map(counting, setting);
  return {questions, plenty - std::exchange(tests::allocations_left, -1)};
}

/// Between equally good places of names order decides, not rounding.
void places_stay(const Drawn& map, const Drawn& moved_a_little) {
  REQUIRE(map.labels().size() == moved_a_little.labels().size());
  for (std::size_t i = 0; i < map.labels().size(); ++i) {
    INFO(map.labels()[i].text);
    CHECK(std::abs(map.labels()[i].box.left - moved_a_little.labels()[i].box.left) < 0.01);
    CHECK(std::abs(map.labels()[i].box.top - moved_a_little.labels()[i].box.top) < 0.01);
  }
}

}  // namespace

TEST_CASE("on every map names stand at what they name, markers cover nothing, and rounding places no name",
          "[every lesson]") {
  for (const Lesson* lesson : those_asked_for()) {
    if (!lesson->map) continue;
    for (const Preset& preset : lesson->presets) {
      if (!spot_on(*lesson->map, preset.parameters)) continue;
      for (const Page& page : pages) {
        INFO(lesson->id << ' ' << preset.id << ", " << name_of(page.theme) << ' ' << page.width << 'x' << page.height);
        const Drawn map(*lesson, preset.parameters, page);
        names_stand_at_what_they_name(*lesson, map);
        no_marker_covers_a_name_or_a_number(map);
        a_circle_of_lengths_is_a_circle(*lesson, map);
        places_stay(map, Drawn(*lesson, preset.parameters, page, 1e-13));
      }
    }
  }
}

TEST_CASE("no leader of a map grazes another name or crosses another leader", "[every lesson]") {
  struct Size {
    double width, height;
  };
  for (const Lesson* lesson : those_asked_for())
    for (const Preset& preset : lesson->presets) {
      if (!lesson->map || !spot_on(*lesson->map, preset.parameters)) continue;
      Step step;
      step.formula = step.verdict.text = "as in a walk";
      step.scene.chart = std::make_shared<const Chart>(case_map(*lesson, preset.parameters));
      for (const ThemeName name : {ThemeName::screen, ThemeName::grey})
        for (const auto& [width, height] : {Size{960, 600}, {640, 400}, {1280, 800}}) {
          const Figure drawn = figure(step, opening(*lesson), name, width, height);
          const auto faults = crossed(drawn.labels, 0.3 * theme(name, width, height).sizes.label_clear);
          INFO(lesson->id << ' ' << preset.id << ", " << name_of(name) << ' ' << width << 'x' << height);
          CAPTURE(faults);
          CHECK(faults.empty());
        }
    }
}

TEST_CASE("making a map asks the lesson at most 20,000 times, and for memory at most 4,000,000 times",
          "[every lesson]") {
  for (const Lesson* lesson : those_asked_for())
    for (const Preset& preset : lesson->presets) {
      if (!lesson->map || !spot_on(*lesson->map, preset.parameters)) continue;
      INFO(lesson->id << ' ' << preset.id);
      const Work work = work_of(*lesson, preset.parameters);
      CHECK(work.questions > 1000);
      CHECK(work.questions <= 20'000);
      CHECK(work.allocations <= 4'000'000);
    }
}

}  // namespace maps_test
