#pragma once
// Small drawings side by side, at one scale and seen from one direction.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "viz/camera.h"
#include "viz/scene.h"

namespace isect::viz {

/// Returns the items moved by `by`.
std::vector<Item> moved(std::vector<Item>, const Vec3& by);

/// One small drawing with a bold heading above and a line of text below; either may be empty.
struct Inset {
  std::vector<Item> items;
  std::string heading, note;
  Role role = Role::text;  ///< of the note
};

/// Returns the insets row by row, on the plane that faces the camera, each in the middle of a cell as large as the
/// largest of them needs. Headings and notes stand on common lines.
std::vector<Item> small_multiples(const std::vector<Inset>&, int columns, const Camera&);
/// Returns a scene of them that can stand in other numbers of columns, too. `placed`: moves each arrangement to where
/// the lesson has it; null: nowhere else.
Scene arrangeable(const std::vector<Inset>&, int columns, const Camera&,
                  const std::function<std::vector<Item>(std::vector<Item>)>& placed = nullptr);
/// Returns the scene in the number of columns in which its small multiples are largest in a picture of this `aspect`,
/// width / height, seen in the camera's direction; nothing if they are not a twentieth larger than in the lesson's own.
std::optional<Scene> arranged(const Scene&, const Camera&, double aspect);

}  // namespace isect::viz
