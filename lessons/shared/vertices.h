#pragma once
// Points of a polygon or a cloud that a reader may move: parameters v0, v1, … that are absent until then, so that a
// setting without them is as its choices have it.

#include <fmt/format.h>

#include <string>
#include <vector>

#include <isect/segment_segment.h>
#include "lessons/shared/flat.h"
#include "lessons/shared/parameters.h"

namespace isect::lessons {

/// Of the point number i: `name` in front of its number, `kind` in its help: "corner".
inline viz::Parameter movable(const std::string& name, int i, const std::string& kind) {
  viz::Parameter p =
      vector(fmt::format("{}{}", name, i), fmt::format("**{}**_{{{}}}", name, i),
             fmt::format("The {} number {}, where it was moved; its third coordinate is not used.", kind, i),
             viz::Vec3::Zero());
  p.optional = true;
  return p;
}

/// The points as the setting has them. The first of the ring is the point number `first`.
inline void move_vertices(const viz::Parameters& values, const std::string& name, Ring<double, 2>& ring,
                          std::size_t first = 0) {
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (const auto moved = values.find(name + std::to_string(first + i)); moved != values.end())
      ring[i] = std::get<viz::Vec3>(moved->second).head<2>();
}

/// A handle on each of them. `kind` is what one of them is called: "a corner".
inline void add_handles(viz::Scene& scene, const std::string& name, const Ring<double, 2>& ring, viz::Role role,
                        const std::string& kind, std::size_t first = 0) {
  for (std::size_t i = 0; i < ring.size(); ++i)
    scene.handles.push_back({.parameter = name + std::to_string(first + i),
                             .kind = viz::Handle::Kind::point,
                             .at = flat(ring[i]),
                             .role = role,
                             .one_of = kind});
}

/// Whether edges meet only where one ends and the next begins, and only in that point. Exact; false below 3 points.
inline bool is_simple(const Ring<double, 2>& ring) {
  using segment_segment::Meeting;
  const std::size_t n = ring.size();
  if (n < 3) return false;
  const auto edge = [&](std::size_t i) { return Segment<double, 2>{ring[i], ring[(i + 1) % n]}; };
  for (std::size_t i = 0; i < n; ++i) {
    if (ring[i] == ring[(i + 1) % n]) return false;
    for (std::size_t j = i + 1; j < n; ++j) {
      const bool neighbours = j == i + 1 || (i == 0 && j == n - 1);
      if (intersect(edge(i), edge(j)).relation > (neighbours ? Meeting::touch : Meeting::disjoint)) return false;
    }
  }
  return true;
}

}  // namespace isect::lessons
