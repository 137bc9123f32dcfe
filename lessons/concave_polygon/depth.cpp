// A bad order of insertion, and what it costs: the longest path of a search, counted as polygons grow.

#include "lessons/concave_polygon/depth.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <memory>
#include <numeric>
#include <span>
#include <utility>

#include "lessons/shared/questions.h"
#include "viz/chart/chart.h"

namespace isect::lessons::concave_polygon_lesson {

using namespace viz;

TrapezoidMap sorted_map(const Ring<double, 2>& ring, Record<trapezoid_map::BuildEvent>& record) {
  PolygonPieces pieces = make_polygon_pieces(std::span<const Ring<double, 2>>(&ring, 1));
  std::vector<int> order(pieces.pieces.size());  // they are numbered from left to right
  std::iota(order.begin(), order.end(), 0);
  return make_trapezoid_map_in_order(std::move(pieces), order, record);
}

const Depths& depths_of(int spikes) {
  static std::map<int, Depths> all;
  if (const auto it = all.find(spikes); it != all.end()) return it->second;
  const Ring<double, 2> ring = spiky_polygon(spikes);
  Record<trapezoid_map::BuildEvent> unread;
  Depths found = {static_cast<int>(ring.size()), depth(sorted_map(ring, unread)), 0};
  for (int seed = 1; seed <= random_orders; ++seed)
    found.random +=
        static_cast<double>(depth(make_trapezoid_map(ring, static_cast<std::uint64_t>(seed)))) / random_orders;
  return all[spikes] = found;
}

namespace {

std::string depth_caption() {
  const Depths &few = depths_of(fewest_spikes), &many = depths_of(most_spikes);
  return fmt::format(
      "Counted on polygons with long spikes, of {} to {} vertices: {} times as many. From left to right the longest "
      "path becomes {} times as long, from {} to {} questions. The mean of {} random orders becomes {} times as long.",
      few.n, many.n, shown(std::round(static_cast<double>(many.n) / few.n)),
      shown(std::round(static_cast<double>(many.sorted) / few.sorted)), few.sorted, many.sorted, random_orders,
      shown(std::round(10 * many.random / few.random) / 10));
}

Chart depth_growth() {
  Plot plot;
  plot.series = {{"", Glyph::square, Role::second, 0}, {"", Glyph::disc, Role::first, 1}};
  Curve sorted = {0, {}, "left to right"}, random = {1, {}, "random"};
  for (int spikes = fewest_spikes; spikes <= most_spikes; spikes *= 2) {
    const Depths& d = depths_of(spikes);
    sorted.points.emplace_back(d.n, d.sorted);
    random.points.emplace_back(d.n, d.random);
  }
  plot.x = {Scale::Kind::log, sorted.points.front().x() / 1.5, sorted.points.back().x() * 1.5, "vertices *n*"};
  plot.y = {Scale::Kind::log, random.points.front().y() / 1.6, sorted.points.back().y() * 1.6,
            "questions of the longest path"};
  Panel panel;
  panel.curves = {sorted, random};
  plot.panels = {panel};
  return {plot};
}

Question depth_question() {
  const Depths &few = depths_of(fewest_spikes), &many = depths_of(most_spikes);
  const double n = std::log(static_cast<double>(many.n) / few.n);
  const double longest = std::log(static_cast<double>(many.sorted) / few.sorted);
  const double lg = std::log(std::log(many.n) / std::log(few.n));
  // of growth as n, as the root of n and as lg n, the nearest to what was counted
  return {"Edges are added from left to right. How does the longest path grow with *n*?",
          {"as lg *n*", "as √*n*", "as *n*"},
          longest < (lg + n / 2) / 2 ? 0
          : longest < 0.75 * n       ? 1
                                     : 2,
          fmt::format("Counted: {} questions at {} vertices, {} at {}.", few.sorted, few.n, many.sorted, many.n)};
}

}  // namespace

void tell_depth(Script& script, const Ring<double, 2>& ring, const TrapezoidMap& map) {
  constexpr int orders = 32;
  int least = depth(map), greatest = 0, sum = 0;
  for (int seed = 1; seed <= orders; ++seed) {
    const int random = depth(make_trapezoid_map(ring, static_cast<std::uint64_t>(seed)));
    least = seed == 1 ? random : std::min(least, random);
    greatest = std::max(greatest, random), sum += random;
  }
  script.value("longest path", depth(map), "questions", Role::first);
  script.value("longest path, random orders", static_cast<double>(sum) / orders, "questions", Role::second);
  Step& step = script.add(
      "depth", "How deep the questions go", 2,
      fmt::format("The longest path here asks {} questions. In {} random orders of these edges it asks {} to {}, in "
                  "the mean {}.\n{}",
                  depth(map), orders, least, greatest, shown(std::round(10.0 * sum / orders) / 10), depth_caption()));
  step.scene.chart = std::make_shared<const Chart>(depth_growth());
  step.question = depth_question();
  keep_picture(script.walk());
}

}  // namespace isect::lessons::concave_polygon_lesson
