// What questions cost as the number of boxes grows: counted, never timed.

#include <fmt/format.h>

#include <cmath>

#include <isect/many/bvh_pairs.h>
#include <isect/many/bvh_ray.h>
#include "bench/random.h"
#include "lessons/collision/picture.h"
#include "lessons/hierarchy/tree.h"
#include "lessons/shared/script.h"
#include "viz/chart/chart.h"

namespace isect::lessons::hierarchy_lesson {

using namespace viz;

namespace {

/// The mean number of node and box tests of a ray from anywhere among the boxes.
double ray_tests(const Bvh<double, 2>& bvh, const Boxes& boxes) {
  constexpr int rays = 64;
  bench::Random random(boxes.size());
  bvh_ray::Counts counts;
  const double extent = std::sqrt(boxes.size());
  for (int i = 0; i < rays; ++i) {
    const double y = random.uniform(0, extent), x = random.uniform(0, extent);  // arguments have no order
    const Point<double, 2> o(x, y);
    const Ray<double, 2> ray = {o, random.heading<2>()};
    closest_hit(
        bvh, ray,
        [&](int k) -> std::optional<double> {
          const std::optional<Interval<double>> part = intersect(ray, boxes[k]);
          if (!part) return {};
          return part->lo;
        },
        counts);
  }
  return static_cast<double>(counts.visited + counts.missed + counts.farther + counts.tested) / rays;
}

Cost cost(int n) {
  const Boxes boxes = collision_lesson::many(n);
  const Bvh<double, 2> bvh = build_bvh(boxes);
  bvh_pairs::Counts counts;
  report_pairs(
      bvh, boxes, [](int, int) {}, counts);
  return {n, ray_tests(bvh, boxes), static_cast<double>(counts.visited + counts.pruned + counts.tested),
          statistics(bvh).depth};
}

/// The chart of the cost over n, without a hierarchy and, if `with` is not null, with one.
std::shared_ptr<const Chart> chart(const std::string& title, const std::string& name, double (*plain)(double),
                                   double Cost::*with) {
  const double n = costs().back().n;
  Plot plot = {{Scale::Kind::log, 0.7 * costs().front().n, n, "number of boxes *n*"},
               {Scale::Kind::log, 1, plain(n), title},
               {{"", Glyph::square, Role::second, 0}, {"", Glyph::disc, Role::hit, 1}},
               {}};
  Curve each = {0, {}, name}, tree = {1, {}, "hierarchy"};
  for (const Cost& c : costs()) {
    each.points.emplace_back(c.n, plain(c.n));
    if (with) tree.points.emplace_back(c.n, c.*with);
  }
  plot.panels = {{.title = {}, .curves = {each}}};
  if (with) plot.panels.front().curves.push_back(tree);
  return std::make_shared<const Chart>(Chart{plot});
}

}  // namespace

const std::vector<Cost>& costs() {
  static const std::vector<Cost> all = [] {
    std::vector<Cost> result;
    for (const int n : {10, 30, 100, 300, 1000, 3000, 10000, 30000, 100000}) result.push_back(cost(n));
    return result;
  }();
  return all;
}

Walk growth() {
  const Cost &some = costs()[4], &most = costs().back();
  Script script({"Lecture note, bounding volume hierarchies",
                 "Two curves: the tests that a ray and that all pairs need as boxes are added.",
                 {"for a ray: ask the nodes that it meets",            // 0
                  "for all pairs: ask the pairs of nodes that meet"},  // 1
                 "growth"});
  script.value("a ray, 1000 boxes", some.ray, "tests");
  script.value("a ray, 100 000 boxes", most.ray, "tests");
  Step& rays = script.add("rays", "A ray among *n* boxes", 0,
                          fmt::format("A hundred times as many boxes, but only {:.1f} times as many tests.\n"
                                      "The depth grew from {} to {}. Without a hierarchy a ray tests all *n* boxes.\n"
                                      "Both children of each opened node are tested. So one path down a balanced tree "
                                      "takes about 1 + 2 lg *n* node tests.",
                                      most.ray / some.ray, some.depth, most.depth));
  rays.scene.chart = chart(
      "tests for a ray", "every box", [](double n) { return n; }, &Cost::ray);
  // of growth as n, as the root of n and as lg n, the nearest to what was counted
  const double factor = std::log(most.ray / some.ray), n_factor = std::log(most.n / some.n);
  const double lg_factor = std::log(std::log(most.n) / std::log(some.n));
  const bool as_lg = factor < (lg_factor + n_factor / 2) / 2, as_root = factor < 0.75 * n_factor;
  rays.question = Question{"How does the number of tests per ray grow with *n*?",
                           {"as *n*", "as √*n*", "as lg *n*"},
                           as_lg     ? 2
                           : as_root ? 1
                                     : 0,
                           "Counted over 64 rays among boxes of one density."};
  Scene without;
  without.chart = chart(
      "tests for a ray", "every box", [](double n) { return n; }, nullptr);
  rays.question->over = without;
  script.value("all pairs, 100 000 boxes", most.pairs, "tests");
  script.value("every pair, 100 000 boxes", 0.5 * most.n * (most.n - 1.0), "tests");
  script.settle(Verdict::Kind::yes, fmt::format("depth {} for 100 000 boxes", most.depth));
  Step& pairs =
      script.add("pairs", "All pairs among *n* boxes", 1,
                 fmt::format("Testing every pair takes *n* (*n* − 1) / 2 tests. The hierarchy takes {:.1f} per box at "
                             "*n* = 1000, and {:.1f} at 100 000.\n"
                             "Where few pairs meet, O(*n*^2) becomes O(*n* lg *n*) or even O(*n*). Where all meet, it "
                             "does not help.",
                             some.pairs / some.n, most.pairs / most.n));
  pairs.scene.chart = chart(
      "tests for all pairs", "every pair", [](double n) { return n * (n - 1) / 2; }, &Cost::pairs);
  return std::move(script.walk());
}

}  // namespace isect::lessons::hierarchy_lesson
