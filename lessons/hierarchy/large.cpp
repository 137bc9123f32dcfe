#include "lessons/hierarchy/large.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lessons/hierarchy/splits.h"

namespace isect::lessons::hierarchy_lesson {

using namespace viz;

namespace {

std::string in_percent(double share) { return shown(std::round(100 * share)) + " %"; }

std::string two_digits(double cost) { return shown(std::round(100 * cost) / 100); }

}  // namespace

std::optional<LargeBox> large_box(const Tree& tree) {
  if (tree.boxes.size() < 2) return {};
  const auto largest = std::ranges::max_element(tree.boxes, {}, half_perimeter);
  const double whole = half_perimeter(tree.node(0).box);
  LargeBox large = {static_cast<int>(largest - tree.boxes.begin()), half_perimeter(*largest) / whole, 0, 0, 0, 0};
  if (!(large.share >= 0.5)) return {};

  for (int i = 0; i < tree.size(); ++i) {
    if (std::ranges::count(tree.below(i), large.box) == 0) continue;
    ++large.nodes;
    if (tree.node(i).leaf()) large.mates = tree.node(i).count - 1;
  }
  Boxes others = tree.boxes;
  others.erase(others.begin() + large.box);
  const Bvh<double, 2> rest = build_bvh(others, options);
  large.cost = statistics(tree.bvh).cost;
  large.apart = 1 + half_perimeter(rest.nodes.front().box) / whole * statistics(rest).cost;
  return large;
}

std::string told_of(const LargeBox& large) {
  const std::string mates = large.mates == 0 ? ""
                            : large.mates == 1
                                ? " One other box shares its leaf, and is tested as often."
                                : fmt::format(" {} other boxes share its leaf, and are tested as often.", large.mates);
  return fmt::format(
             "Box {} has {} of the root's perimeter. Each of the {} nodes that hold it has at least as much. So a line "
             "that meets the root meets each of them with that chance at least.{}\n",
             large.box, in_percent(large.share), large.nodes, mates) +
         fmt::format(
             "Expected of a line that meets the root: {} nodes opened and boxes tested. With box {} tested by itself "
             "and a tree of the others: {}.{}",
             two_digits(large.cost), large.box, two_digits(large.apart),
             large.apart < large.cost ? " So builders take such a box out, or cut it in two: a spatial split."
                                      : " So here it does no harm in the tree.");
}

Question asked_of(const LargeBox& large) {
  return {fmt::format(
              "Box {} is tested by itself, and the others get a tree of their own. What becomes of the expected cost?",
              large.box),
          {"it falls", "it stays the same", "it rises"},
          large.apart < large.cost    ? 0
          : large.apart == large.cost ? 1
                                      : 2,
          fmt::format("Now {} nodes hold it, each met with a chance of {} or more. Then one test does.", large.nodes,
                      in_percent(large.share))};
}

}  // namespace isect::lessons::hierarchy_lesson
