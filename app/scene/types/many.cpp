// Meshes and clouds of points.

#include <utility>

#include "app/scene/types/rows.h"

namespace isect::program::scene {

std::vector<TypeSpec> many_types() {
  TypeSpec mesh = {Type::mesh, "mesh"};
  mesh.in_plane = "";
  mesh.made_of = "file (or points triangles) [at]";
  mesh.draw = [](Drawing& d) {
    std::vector<viz::Vec3> points = d.s.points(d.o);
    d.name(top_of(points));
    d.items.push_back(viz::Mesh{std::move(points), d.o.fixed.triangles, d.role});
  };
  mesh.with_at = true;

  TypeSpec cloud = {Type::cloud, "cloud", "point cloud"};
  cloud.made_of = "points (or file) [at]";
  cloud.with_at = true;
  cloud.draw = [](Drawing& d) {
    const std::vector<viz::Vec3> points = d.s.points(d.o);
    d.dots(points);
    d.name(top_of(points));
  };
  return {mesh, cloud};
}

}  // namespace isect::program::scene
