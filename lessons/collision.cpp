// Collision (N25): the double loop with its count, then sweep and prune, then a hierarchy; and what discrete times miss.
//
// The boxes and their picture stand in collision/boxes, the moving ones in collision/tunnelling.

#include <fmt/format.h>

#include "core/all_pairs.h"
#include "core/bvh_pairs.h"
#include "lessons/collision/boxes.h"
#include "lessons/collision/tunnelling.h"
#include "lessons/parameters.h"
#include "lessons/script.h"

namespace isect::lessons {
namespace {

using namespace viz;
using namespace collision_lesson;

/// How many pairs each method tests among n boxes.
struct Tests {
  std::int64_t brute, sweep, tree, found;
};
Tests tests(int n) {
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

std::string alt_text(const Boxes& boxes) {
  int found = 0;
  all_pairs::brute_force(boxes, [&](int, int) { ++found; });
  return fmt::format("{} boxes, of which {} pairs overlap.", boxes.size(), found);
}

class Teller {
 public:
  Teller(const Boxes& boxes, const std::string& title, std::vector<std::string> lines)
      : boxes_(boxes), script_({"Note, N25 (corrected)", alt_text(boxes), std::move(lines), title}) {}

 protected:
  Step& add(const std::string& slug, const std::string& title, int line, const std::string& caption,
            const std::string& formula = {}) {
    Step& step = script_.add(slug, title, line, caption, formula);
    step.scene = picture(boxes_, drawn_);
    return step;
  }

  /// A pair was tested.
  Step& tested(int i, int j, bool overlap, int yes, int no) {
    drawn_.i = i, drawn_.j = j, drawn_.overlap = overlap;
    if (overlap) drawn_.found.emplace_back(i, j);
    script_.value("tests", ++tests_);
    script_.value("pairs", static_cast<double>(drawn_.found.size()), {}, Role::hit);
    Step& step =
        add(fmt::format("test-{}-{}", i, j), fmt::format("Boxes {} and {}", i, j), overlap ? yes : no,
            overlap ? "They share points on each axis: a pair." : "Some axis separates them: no pair.");
    step.decides = overlap;
    return step;
  }

  void total(int line, const std::string& caption) {
    drawn_.i = drawn_.j = -1, drawn_.sweeping = false;
    script_.settle(drawn_.found.empty() ? Verdict::Kind::no : Verdict::Kind::yes,
                   fmt::format("{} pairs, {} tests", drawn_.found.size(), tests_));
    add("total", "What it cost", line, caption);
    for (const int n : {10, 100, 1000}) {
      const Tests t = tests(n);
      script_.value(fmt::format("brute force, *n* = {}", n), static_cast<double>(t.brute), "tests");
      script_.value(fmt::format("sweep, *n* = {}", n), static_cast<double>(t.sweep), "tests");
      script_.value(fmt::format("hierarchy, *n* = {}", n), static_cast<double>(t.tree), "tests");
    }
    const Tests t = tests(1000);
    Step& step =
        add("growth", "As *n* grows", line,
            fmt::format(
                "1,000 boxes as dense as these: {} tests by brute force, {} by the sweep, {} node and pair "
                "tests by a hierarchy. All find the same {} pairs.",
                t.brute, t.sweep, t.tree, t.found),
            "*n* (*n* − 1) / 2 = O(*n*^2)");
    step.question = Question{"Which needs fewest tests for 1,000 boxes?",
                             {"brute force", "sweep", "hierarchy"},
                             t.tree < t.sweep ? 2 : 1,
                             "Counted on the boxes themselves."};
  }

  const Boxes& boxes_;
  Script script_;
  Drawn drawn_;
  int tests_ = 0;
};

class DoubleLoop : Teller {
 public:
  explicit DoubleLoop(const Boxes& boxes)
      : Teller(boxes, "brute force",
               {"for i ← 0 to n − 1",                // 0
                "    for j ← i + 1 to n − 1",        // 1
                "        if boxes i and j overlap",  // 2
                "            report i, j"}) {}       // 3

  Walk tell() {
    add("loop", "Every pair once", 1,
        "The note lets *j* run from *i*, which tests each box with itself. It must start at *i* + 1.",
        fmt::format("*n* (*n* − 1) / 2 = {} tests", boxes_.size() * (boxes_.size() - 1) / 2));
    Record<all_pairs::Event<2>> record;
    all_pairs::brute_force(
        boxes_, [](int, int) {}, record);
    for (const auto& event : record.events)
      if (const auto* e = std::get_if<all_pairs::Tested>(&event)) tested(e->i, e->j, e->overlap, 3, 2);
    total(0, "Most tests say no. A cheaper way should not ask them at all.");
    return std::move(script_.walk());
  }
};

class Sweep : Teller {
 public:
  explicit Sweep(const Boxes& boxes)
      : Teller(boxes, "sweep and prune",
               {"sort the boxes by their lower ends",                      // 0
                "for each box b",                                          // 1
                "    remove what ended before b begins",                   // 2
                "    for each active a: if a and b overlap: report a, b",  // 3
                "    add b to the active boxes"}) {}                       // 4

  Walk tell() {
    Record<all_pairs::Event<2>> record;
    all_pairs::sweep_and_prune(
        boxes_, [](int, int) {}, record);
    int box = 0;
    for (const auto& event : record.events) {
      if (const auto* e = std::get_if<all_pairs::Axis>(&event)) axis_ = e->axis, begin();
      if (const auto* e = std::get_if<all_pairs::Leaves>(&event))
        std::erase(drawn_.active, e->box), left_.push_back(e->box);
      if (const auto* e = std::get_if<all_pairs::Tested>(&event)) {
        enter(box);
        tested(e->i, e->j, e->overlap, 3, 3);
      }
      if (const auto* e = std::get_if<all_pairs::Enters>(&event)) {
        enter(box);
        box = e->box, fresh_ = true;
      }
    }
    enter(box);
    total(1, "Only boxes that the plane cuts together are tested.");
    return std::move(script_.walk());
  }

 private:
  void begin() {
    add("sort", "Sort along an axis", 0,
        axis_ == 0 ? "A plane will sweep to the right. Boxes that it never cuts together cannot overlap."
                   : "The boxes spread most along *y*, so the sweep runs along it.");
    drawn_.sweeping = axis_ == 0;
  }

  /// The plane reaches a box; told after what it leaves.
  void enter(int box) {
    if (!fresh_) return;
    fresh_ = false;
    drawn_.i = drawn_.j = -1;
    drawn_.sweep = boxes_[static_cast<std::size_t>(box)].lo[axis_];
    drawn_.active.push_back(box);
    std::string gone;
    for (const int k : left_) gone += fmt::format("{}{}", gone.empty() ? "" : ", ", k);
    left_.clear();
    script_.value("active", static_cast<double>(drawn_.active.size()));
    add(fmt::format("enter-{}", box), fmt::format("Box {} begins", box), gone.empty() ? 4 : 2,
        fmt::format("The plane cuts {} box{} now.{}", drawn_.active.size(),
                    drawn_.active.size() == 1 ? "" : "es", gone.empty() ? "" : " It has left " + gone + "."));
  }

  int axis_ = 0;
  bool fresh_ = false;
  std::vector<int> left_;
};

class Hierarchy : Teller {
 public:
  explicit Hierarchy(const Boxes& boxes)
      : Teller(boxes, "hierarchy",
               {"build a hierarchy of boxes",                   // 0
                "for two nodes a, b",                           // 1
                "    if their boxes are apart: prune",          // 2
                "    if both are leaves: test what they hold",  // 3
                "    else open the larger one"}) {}             // 4

  Walk tell() {
    using namespace bvh_pairs;
    const Bvh<double, 2> bvh = build_bvh(boxes_);
    for (const BvhNode<double, 2>& node : bvh.nodes) drawn_.nodes.push_back(node.box);
    add("build", "Boxes in boxes", 0,
        "Each node's box holds all boxes below it. What misses a node misses them all.");
    drawn_.nodes.clear();
    Record<bvh_pairs::Event> record;
    report_pairs(
        bvh, boxes_, [](int, int) {}, record);
    int number = 0;
    for (const auto& event : record.events) {
      drawn_.i = drawn_.j = -1;
      if (const auto* e = std::get_if<Pruned>(&event)) {
        drawn_.compared = {bvh.nodes[static_cast<std::size_t>(e->a)].box,
                           bvh.nodes[static_cast<std::size_t>(e->b)].box};
        script_.value("tests", ++tests_);
        add(fmt::format("prune-{}", ++number), "Two nodes apart", 2,
            "Their boxes share no point: one test rules out all pairs between them.")
            .decides = true;
      }
      if (const auto* e = std::get_if<Visited>(&event)) {
        drawn_.compared = {bvh.nodes[static_cast<std::size_t>(e->a)].box,
                           bvh.nodes[static_cast<std::size_t>(e->b)].box};
        script_.value("tests", ++tests_);
        const bool leaves = bvh.nodes[static_cast<std::size_t>(e->a)].leaf() &&
                            bvh.nodes[static_cast<std::size_t>(e->b)].leaf();
        add(fmt::format("visit-{}", ++number), "Two nodes overlap", leaves ? 3 : 4,
            leaves ? "Both are leaves: the boxes in them are tested."
                   : "Their boxes overlap, so the larger one is opened.");
      }
      if (const auto* e = std::get_if<Tested>(&event))
        tested(std::min(e->i, e->j), std::max(e->i, e->j), e->meet, 3, 3);
    }
    drawn_.compared.clear();
    total(1, "Six boxes are too few to gain from a hierarchy. A thousand are not.");
    return std::move(script_.walk());
  }
};

Walk walk(const Parameters& values) {
  const std::string& method = std::get<std::string>(values.at("method"));
  const Boxes boxes = few(std::get<Vec3>(values.at("p")));
  if (method == "brute-force") return DoubleLoop(boxes).tell();
  if (method == "sweep") return Sweep(boxes).tell();
  if (method == "hierarchy") return Hierarchy(boxes).tell();
  return tunnelling(std::get<Vec3>(values.at("p")), std::get<double>(values.at("speed")));
}

}  // namespace

const Lesson& collision() {
  static const Lesson lesson = [] {
    std::vector<Preset> presets;
    const auto add = [&](const char* id, const char* title, const char* method, const Vec3& p, double speed) {
      presets.push_back({id, title, method, {{"method", std::string(method)}, {"p", p}, {"speed", speed}}});
    };
    const Vec3 near = {-1.75, -0.5, 0}, far = {-2.5, -1.5, 0};
    for (const char* method : {"brute-force", "sweep", "hierarchy"}) {
      add(method, "boxes meet", method, near, 4);
      add((std::string(method) + "-apart").c_str(), "one box apart", method, far, 4);
    }
    add("tunnelling", "a bullet", "motion", {-2.5, 0, 0}, 5);
    add("slow", "a slow box", "motion", {-2.5, 0, 0}, 2);
    add("passes-by", "passes by", "motion", {-2.5, 2.25, 0}, 5);
    return Lesson{
        .id = "collision",
        .title = "Collision",
        .rows = "N25",
        .summary = "All pairs of boxes that overlap, in three ways, and what discrete times miss.",
        .parameters = {choice("method", "method", "How pairs are found, or one moving box.",
                              {"brute-force", "sweep", "hierarchy", "motion"}),
                       {"p", "**p**",
                        "The centre of box 0 or of the moving box; its third coordinate is not used.", near,
                        -1e6, 1e6, -4, 4},
                       {"speed", "speed", "Of the moving box, in world units a second.", 4.0, 0, 1e6, 0, 8}},
        .group_by = "method",
        .presets = presets,
        .camera = {.azimuth = 0, .elevation = 0},
        .walk = walk,
        .flat = true,
    };
  }();
  return lesson;
}

}  // namespace isect::lessons
