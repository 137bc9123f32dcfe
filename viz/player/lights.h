#pragma once
// One name, one light, in the picture: the names at a place of it, and what lights up for a name.

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "viz/camera.h"
#include "viz/compose/compose.h"
#include "viz/lesson.h"

namespace isect::viz {

/// Return the keys of the names in a label, and of a handle's parameter.
std::vector<std::string> keys_of(const PlacedLabel&, const std::set<std::string>& known);
std::vector<std::string> keys_of(const Handle&, const Lesson&);
/// Calls `each` for every item that has its own names, with their keys. Charts and very large scenes have none.
void each_named(const Scene&, const std::set<std::string>& known,
                const std::function<void(const Item&, const std::vector<std::string>&)>& each);
/// Returns the names of the point or line nearest to a place of the picture, within reach of it.
std::vector<std::string> names_near(const Scene&, const View&, const Vec2& at, const std::set<std::string>& known);

/// A broad, clear stroke over an item that is lit: a line, or a ring about `a`.
struct LitStroke {
  Vec2 a = Vec2::Zero(), b = Vec2::Zero();
  double radius = 0, width = 0;  ///< radius 0: a line from a to b
};
std::optional<LitStroke> lit_stroke(const Item&, const View&);

}  // namespace isect::viz
