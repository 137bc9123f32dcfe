#include "lessons/collision/telling.h"

#include <fmt/format.h>

#include <isect/many/all_pairs.h>
#include <isect/many/bvh_pairs.h>
#include "viz/chart/chart.h"

namespace isect::lessons::collision_lesson {

using namespace viz;

namespace {

/// How many pairs each method tests among n boxes.
struct Tests {
  std::int64_t brute, sweep, tree, found;
};
Tests counted(int n) {
  const Boxes boxes = many(n);
  std::int64_t found = 0;
  const auto count = [&](int, int) { ++found; };
  const std::int64_t brute = all_pairs::brute_force(boxes, count);
  const std::int64_t sweep = all_pairs::sweep_and_prune(boxes, [](int, int) {});
  bvh_pairs::Counts counts;
  report_pairs(
      build_bvh(boxes), boxes, [](int, int) {}, counts);
  return {brute, sweep, counts.visited + counts.pruned + counts.tested, found};
}

constexpr int sizes[] = {10, 30, 100, 300, 1000};

/// Counted once, as they are the same for every setting.
const std::vector<Tests>& tests() {
  static const std::vector<Tests> all = [] {
    std::vector<Tests> result;
    for (const int n : sizes) result.push_back(counted(n));
    return result;
  }();
  return all;
}

std::shared_ptr<const Chart> chart() {
  Plot plot = {
      {Scale::Kind::log, 0.8 * sizes[0], sizes[4], "number of boxes *n*"},
      {Scale::Kind::log, 1, 1e6, "tests for all pairs"},
      {{"", Glyph::square, Role::second, 0}, {"", Glyph::disc, Role::first, 1}, {"", Glyph::diamond, Role::hit, 2}},
      {}};
  Panel panel = {.title = {}, .curves = {{0, {}, "brute force"}, {1, {}, "sweep"}, {2, {}, "hierarchy"}}};
  for (std::size_t i = 0; i < std::size(sizes); ++i) {
    const Tests& t = tests()[i];
    const std::int64_t counts[] = {t.brute, t.sweep, t.tree};
    for (std::size_t k = 0; k < 3; ++k) panel.curves[k].points.emplace_back(sizes[i], counts[k]);
  }
  plot.panels = {panel};
  return std::make_shared<const Chart>(Chart{plot});
}

std::string alt_text(const Boxes& boxes) {
  int found = 0;
  all_pairs::brute_force(boxes, [&](int, int) { ++found; });
  return fmt::format("{} boxes, with {} that overlap{}.", boxes.size(), plural(found, "pair"), found == 1 ? "s" : "");
}

}  // namespace

Teller::Teller(const Boxes& boxes, const Frame& frame, const std::string& title, std::vector<std::string> lines)
    : boxes_(boxes),
      frame_(frame),
      script_({"Lecture note, collision detection (corrected); Ericson, Real-Time Collision Detection (2005), ch. 7",
               alt_text(boxes), std::move(lines), title}) {}

Step& Teller::add(const std::string& slug, const std::string& title, int line, const std::string& caption,
                  const std::string& formula) {
  Step& step = script_.add(slug, title, line, caption, formula);
  step.scene = picture(boxes_, drawn_, frame_);
  return step;
}

Step& Teller::tested(int i, int j, bool overlap, int yes, int no) {
  drawn_.i = i, drawn_.j = j, drawn_.overlap = overlap;
  if (overlap) drawn_.found.emplace_back(i, j);
  script_.value("tests", ++tests_);
  script_.value("pairs", static_cast<double>(drawn_.found.size()), {}, Role::hit);
  Step& step = add(fmt::format("test-{}-{}", i, j), fmt::format("Boxes {} and {}", i, j), overlap ? yes : no,
                   overlap ? "They share points on each axis: a pair." : "Some axis separates them: no pair.");
  step.decides = overlap;
  return step;
}

Step& Teller::apart(int i, const std::vector<int>& others, int no) {
  std::string names;
  for (const int j : others) names += (names.empty() ? "" : j == others.back() ? " and " : ", ") + std::to_string(j);
  drawn_.i = i, drawn_.j = others.back(), drawn_.overlap = false;
  drawn_.also.assign(others.begin(), others.end() - 1);
  tests_ += static_cast<int>(others.size());
  script_.value("tests", tests_);
  script_.value("pairs", static_cast<double>(drawn_.found.size()), {}, Role::hit);
  Step& step = add(fmt::format("apart-{}-{}", i, others.front()), fmt::format("Box {} with {}", i, names), no,
                   fmt::format("Each of these is separated from box {} on some axis: {}, no pair.", i,
                               plural(static_cast<long long>(others.size()), "test")));
  drawn_.also.clear();
  return step;
}

void Teller::total(int line, const std::string& caption) {
  drawn_.i = drawn_.j = -1, drawn_.sweeping = false;
  script_.settle(drawn_.found.empty() ? Verdict::Kind::no : Verdict::Kind::yes,
                 plural(static_cast<long long>(drawn_.found.size()), "pair") + ", " + plural(tests_, "test"));
  add("total", "What it cost", line, caption);
  for (const std::size_t i : {0, 2, 4}) {
    const Tests& t = tests()[i];
    script_.value(fmt::format("brute force, {} boxes", sizes[i]), static_cast<double>(t.brute), "tests");
    script_.value(fmt::format("sweep, {} boxes", sizes[i]), static_cast<double>(t.sweep), "tests");
    script_.value(fmt::format("hierarchy, {} boxes", sizes[i]), static_cast<double>(t.tree), "tests");
  }
  const Tests& t = tests().back();
  Step& step =
      add("growth", "As *n* grows", line,
          fmt::format("1000 random boxes: {} tests by brute force, {} by the sweep, {} of nodes and boxes by a "
                      "hierarchy.\nAll find the same {} pairs. Boxes at rest need not be tested against each other.",
                      shown(static_cast<double>(t.brute)), shown(static_cast<double>(t.sweep)),
                      shown(static_cast<double>(t.tree)), t.found),
          "*n* (*n* − 1) / 2 = O(*n*^2)");
  step.scene = {};
  step.scene.chart = chart();
  step.question = Question{"Which needs fewest tests for 1000 boxes?",
                           {"brute force: all pairs", "a sweep: pairs that overlap on *x*",
                            "a hierarchy: pairs in groups whose boxes overlap"},
                           t.tree < t.sweep ? 2 : 1,
                           "All three were counted on the same boxes."};
}

}  // namespace isect::lessons::collision_lesson
