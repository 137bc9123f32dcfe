#include "lessons/collision/telling.h"

#include <fmt/format.h>

#include <isect/all_pairs.h>
#include <isect/bvh_pairs.h>

namespace isect::lessons::collision_lesson {

using namespace viz;

namespace {

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

}  // namespace

Teller::Teller(const Boxes& boxes, const std::string& title, std::vector<std::string> lines)
    : boxes_(boxes), script_({"Note, N25 (corrected)", alt_text(boxes), std::move(lines), title}) {}

Step& Teller::add(const std::string& slug, const std::string& title, int line, const std::string& caption,
                  const std::string& formula) {
  Step& step = script_.add(slug, title, line, caption, formula);
  step.scene = picture(boxes_, drawn_);
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

void Teller::total(int line, const std::string& caption) {
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
          fmt::format("1,000 boxes as dense as these: {} tests by brute force, {} by the sweep, {} node and pair "
                      "tests by a hierarchy. All find the same {} pairs.",
                      t.brute, t.sweep, t.tree, t.found),
          "*n* (*n* − 1) / 2 = O(*n*^2)");
  step.question = Question{"Which needs fewest tests for 1,000 boxes?",
                           {"brute force", "sweep", "hierarchy"},
                           t.tree < t.sweep ? 2 : 1,
                           "Counted on the boxes themselves."};
}

}  // namespace isect::lessons::collision_lesson
