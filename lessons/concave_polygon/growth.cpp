// What slabs and a trapezoidal map keep of a polygon with long spikes, counted.

#include <fmt/format.h>

#include <cmath>
#include <map>

#include <isect/many/slab_map.h>
#include <isect/many/trapezoid_map.h>
#include "lessons/concave_polygon/picture.h"
#include "viz/chart/chart.h"

namespace isect::lessons::concave_polygon_lesson {

using namespace viz;

const Kept& kept(int spikes) {
  static std::map<int, Kept> all;  // counting takes a while
  if (const auto it = all.find(spikes); it != all.end()) return it->second;
  const Ring<double, 2> ring = spiky_polygon(spikes);
  return all[spikes] = {static_cast<int>(ring.size()), static_cast<double>(make_slab_map(ring).order.size()),
                        static_cast<double>(make_trapezoid_map(ring).nodes.size())};
}

std::string growth_caption() {
  const Kept &few = kept(fewest_spikes), &many = kept(most_spikes);
  return fmt::format(
      "Counted on polygons with long spikes. From {} to {} vertices, {} times as many, the slabs' edges become {} "
      "times as many: about the square.\nThe nodes of a trapezoidal map, the next method, become {} times as many. In "
      "general slabs take O(*n*^2), a map O(*n*).",
      few.n, many.n, shown(std::round(static_cast<double>(many.n) / few.n)),
      shown(std::round(many.slab_entries / few.slab_entries)), shown(std::round(many.map_nodes / few.map_nodes)));
}

Chart growth() {
  Plot plot;
  plot.series = {{"", Glyph::square, Role::second, 0}, {"", Glyph::disc, Role::first, 1}};
  Curve slabs = {0, {}, "slabs"}, map = {1, {}, "trapezoids"};
  for (int spikes = fewest_spikes; spikes <= most_spikes; spikes *= 2) {
    const Kept k = kept(spikes);
    slabs.points.emplace_back(k.n, k.slab_entries);
    map.points.emplace_back(k.n, k.map_nodes);
  }
  plot.x = {Scale::Kind::log, slabs.points.front().x() / 1.5, slabs.points.back().x() * 1.5, "vertices *n*"};
  plot.y = {Scale::Kind::log, slabs.points.front().y() / 1.6, slabs.points.back().y() * 1.6,
            "edges in slabs; nodes of the map"};
  Panel panel;
  panel.curves = {slabs, map};
  plot.panels = {panel};
  return {plot};
}

}  // namespace isect::lessons::concave_polygon_lesson
