#pragma once
// Points of a polygon or a cloud that a reader may move: parameters v0, v1, … that are absent until then, so that a
// setting without them has the points of its choices.

#include <fmt/format.h>

#include <string>
#include <vector>

#include <isect/shapes.h>
#include "lessons/shared/flat.h"
#include "lessons/shared/parameters.h"

namespace isect::lessons {

/// The parameter of point number i: its name is `name` and the number; `kind` is the noun in its help: "corner".
inline viz::Parameter movable(const std::string& name, int i, const std::string& kind) {
  viz::Parameter p =
      vector(fmt::format("{}{}", name, i), fmt::format("**{}**_{{{}}}", name, i),
             fmt::format("The {} number {}, where it was moved; its third coordinate is not used.", kind, i),
             viz::Vec3::Zero());
  p.optional = true;
  return p;
}

/// Moves the points to where the setting has them. The ring's first point is number `first`.
inline void move_vertices(const viz::Parameters& values, const std::string& name, Ring<double, 2>& ring,
                          std::size_t first = 0) {
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (const auto moved = values.find(name + std::to_string(first + i)); moved != values.end())
      ring[i] = std::get<viz::Vec3>(moved->second).head<2>();
}

/// Adds a handle for each point. `kind` is what one of them is called: "a corner".
inline void add_handles(viz::Scene& scene, const std::string& name, const Ring<double, 2>& ring, viz::Role role,
                        const std::string& kind, std::size_t first = 0) {
  for (std::size_t i = 0; i < ring.size(); ++i)
    scene.handles.push_back({.parameter = name + std::to_string(first + i),
                             .kind = viz::Handle::Kind::point,
                             .at = flat(ring[i]),
                             .role = role,
                             .one_of = kind});
}

}  // namespace isect::lessons
