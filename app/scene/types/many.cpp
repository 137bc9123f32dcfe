// Meshes and clouds of points.

#include "app/scene/types/rows.h"

namespace isect::program::scene {

std::vector<TypeSpec> many_types() {
  TypeSpec mesh = {Type::mesh, "mesh"};
  mesh.in_plane = "";
  mesh.made_of = "file (or points triangles)";
  mesh.draw = [](Drawing& d) {
    d.items.push_back(viz::Mesh{d.o.fixed.points, d.o.fixed.triangles, d.role});
    d.name(top_of(d.o.fixed.points));
  };

  TypeSpec cloud = {Type::cloud, "cloud", "point cloud"};
  cloud.made_of = "points (or file)";
  cloud.draw = [](Drawing& d) {
    const std::vector<viz::Vec3> points = d.s.points(d.o);
    d.dots(points);
    d.name(top_of(points));
  };
  return {mesh, cloud};
}

}  // namespace isect::program::scene
