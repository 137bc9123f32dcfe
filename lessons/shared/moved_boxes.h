#pragma once
// Boxes of the plane that a reader may move: their centres are parameters p1, p2, … that are absent until then. Box 0
// is not among them.

#include <fmt/format.h>

#include <string>
#include <vector>

#include "lessons/shared/vertices.h"

namespace isect::lessons {

/// Adds a parameter for each of `count` boxes but box 0, in settings in which `choice` has one of these values.
inline void add_movable_boxes(std::vector<viz::Parameter>& all, int count, const std::string& choice,
                              const std::vector<std::string>& values) {
  for (int k = 1; k < count; ++k) {
    all.push_back(where(choice, values, movable("p", k, "box")));
    all.back().help = fmt::format("The centre of box {}, where it was moved.", k);
  }
}

/// Moves the boxes to where the setting has them.
inline void move_boxes(const viz::Parameters& values, std::vector<Aabb<double, 2>>& boxes) {
  for (std::size_t k = 1; k < boxes.size(); ++k)
    if (const auto moved = values.find(fmt::format("p{}", k)); moved != values.end()) {
      const viz::Vec2 half = (boxes[k].hi - boxes[k].lo) / 2, at = std::get<viz::Vec3>(moved->second).head<2>();
      boxes[k] = {at - half, at + half};
    }
}

/// Whether the setting has moved one of them.
inline bool has_moved(const viz::Parameters& values, const std::vector<Aabb<double, 2>>& boxes) {
  for (std::size_t k = 1; k < boxes.size(); ++k)
    if (values.contains(fmt::format("p{}", k))) return true;
  return false;
}

}  // namespace isect::lessons
