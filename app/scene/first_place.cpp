#include "app/scene/first_place.h"

#include <isect/first_place.h>

#include "app/scene/pairs.h"
#include "app/scene/shapes.h"

namespace isect::program::scene {

namespace {

Ray<double, 2> in_the_plane(const Ray<double, 3>& x) {
  return {point_of<2>(x.origin), point_of<2>(x.direction), x.range};
}
Segment<double, 2> in_the_plane(const Segment<double, 3>& x) { return {point_of<2>(x.p), point_of<2>(x.q)}; }

/// Of all of these.
template <class Line, class Shapes>
std::optional<Place> first_of_all(const Line& line, const Shapes& shapes) {
  std::optional<Place> first;
  for (const auto& shape : shapes)
    if (std::optional<Place> found = isect::first_place(line, shape); found && (!first || compare(*found, *first) < 0))
      first = std::move(found);
  return first;
}

template <class Line>
std::optional<Place> place_of(const Setting& s, const Line& line, const Object& o) {
  const auto first = [&](const auto& shape) { return isect::first_place(line, shape); };
  switch (o.type) {
    case Type::plane:
      return first(Plane<double, 3>{s.point(o, "normal"), s.number(o, "d")});
    case Type::sphere:
      return first(sphere_of<3>(s, o));
    case Type::capsule:
      return first(capsule_in_space(s, o));
    case Type::point:
      return first(s.point(o, "at"));
    case Type::cloud:
      return first_of_all(line, s.points(o));
    case Type::ray:
    case Type::line:
      return first(ray_in_space(s, o));
    case Type::segment:
      return first(segment_of(s, o));
    case Type::box:
    case Type::obb:
    case Type::kdop:
    case Type::frustum:
    case Type::hull:
      return first(faces_of(s, o));
    case Type::mesh: {
      const TriangleMesh<double> mesh = mesh_of(o);
      std::vector<Triangle<double, 3>> triangles;
      for (int i = 0; i < static_cast<int>(mesh.triangles.size()); ++i) triangles.push_back(triangle(mesh, i));
      return first_of_all(line, triangles);
    }
    case Type::triangle:
    case Type::polygon: {
      if (s.flat) {
        Polygon<double, 2> polygon;
        for (const std::vector<viz::Vec3>& ring : s.rings(o)) polygon.rings.push_back(points_of<2>(ring));
        return isect::first_place(in_the_plane(line), polygon);
      }
      if (o.type == Type::triangle) return first(triangle_of(s, o));
      if (is_bent(s, o)) return first_of_all(line, surface_of(s, o));
      return first(Polygon<double, 3>{{points_of<3>(s.rings(o).front())}});
    }
  }
  return {};
}

}  // namespace

std::optional<Place> first_place(const Setting& s, const Object& along, const Object& o) {
  return along.type == Type::segment ? place_of(s, segment_of(s, along), o) : place_of(s, ray_in_space(s, along), o);
}

}  // namespace isect::program::scene
