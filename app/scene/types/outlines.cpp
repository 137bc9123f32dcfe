// Triangles and polygons.

#include "app/scene/types/rows.h"

namespace isect::program::scene {

std::vector<TypeSpec> outline_types() {
  const auto draw = [](Drawing& d) { d.outline(d.s.rings(d.o)); };
  TypeSpec triangle = {Type::triangle, "triangle"};
  triangle.made_of = "points";
  triangle.draw = draw;

  TypeSpec polygon = {Type::polygon, "polygon"};
  polygon.made_of = "points (or rings, for holes; or file) [at]";
  polygon.with_at = true;
  polygon.draw = draw;
  return {triangle, polygon};
}

}  // namespace isect::program::scene
