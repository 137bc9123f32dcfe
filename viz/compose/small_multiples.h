#pragma once
// Small drawings side by side, at one scale and seen from one direction.

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

}  // namespace isect::viz
