#include "viz/player/pick.h"

#include <isect/ray_polygon.h>
#include <isect/ray_sphere.h>
#include <isect/ray_triangle.h>

namespace isect::viz {
namespace {

using Sight = Ray<double, 3>;

void nearer(std::optional<double>& t, const std::optional<double>& other) {
  if (other && (!t || *other < *t)) t = other;
}

struct FirstHit {
  const Sight& ray;

  std::optional<double> operator()(const Ball& ball) const {
    return intersect(ray, Sphere<double, 3>{ball.center, ball.radius}).surface;
  }
  std::optional<double> operator()(const Solid& solid) const {
    std::optional<double> first;
    for (const std::vector<int>& face : solid.faces)  // convex: a fan
      for (std::size_t i = 2; i < face.size(); ++i)
        nearer(first, triangle(solid.vertices, face[0], face[i - 1], face[i]));
    return first;
  }
  std::optional<double> operator()(const Mesh& mesh) const {
    std::optional<double> first;
    for (const auto& [a, b, c] : mesh.triangles) nearer(first, triangle(mesh.vertices, a, b, c));
    return first;
  }
  std::optional<double> operator()(const Region& region) const {
    Polygon<double, 3> polygon;
    for (const std::vector<Vec3>& ring : region.rings) polygon.rings.push_back({ring.begin(), ring.end()});
    return intersect(ray, polygon).t;
  }
  template <class Other>
  std::optional<double> operator()(const Other&) const {
    return std::nullopt;
  }

 private:
  std::optional<double> triangle(const std::vector<Vec3>& vertices, int a, int b, int c) const {
    const auto at = [&](int i) -> const Vec3& { return vertices[i]; };
    return intersect(ray, Triangle<double, 3>{{at(a), at(b), at(c)}}).t;
  }
};

}  // namespace

std::optional<Picked> pick(const Scene& scene, const View::ViewingRay& sight) {
  const Sight ray{sight.origin, sight.direction};
  const Item* first = nullptr;
  double nearest = 0;
  for (const Item& item : scene.items) {
    const std::optional<double> t = std::visit(FirstHit{ray}, item);
    if (!t || (first && *t > nearest)) continue;
    first = &item, nearest = *t;
  }
  if (!first) return std::nullopt;
  return Picked{first, ray.at(nearest)};
}

}  // namespace isect::viz
