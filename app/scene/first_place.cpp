#include "app/scene/first_place.h"

#include <isect/first_place.h>

namespace isect::program::scene {

namespace {

Ray<double, 2> in_the_plane(const Ray<double, 3>& x) {
  return {point_of<2>(x.origin), point_of<2>(x.direction), x.range};
}
Segment<double, 2> in_the_plane(const Segment<double, 3>& x) { return {point_of<2>(x.p), point_of<2>(x.q)}; }

/// Returns the first place at which the line meets any of these shapes.
template <class Line, class Shapes>
std::optional<Place> first_of_all(const Line& line, const Shapes& shapes) {
  std::optional<Place> first;
  for (const auto& shape : shapes)
    if (std::optional<Place> found = isect::first_place(line, shape); found && (!first || compare(*found, *first) < 0))
      first = std::move(found);
  return first;
}

/// The first place on a mesh's triangles, or on a polygon's.
template <class Line, class Surface>
std::optional<Place> first_on_surface(const Line& line, const Surface& surface) {
  std::vector<Triangle<double, 3>> triangles;
  for (int i = 0; i < static_cast<int>(surface.triangles.size()); ++i) triangles.push_back(triangle(surface, i));
  return first_of_all(line, triangles);
}

template <class Line>
std::optional<Place> place_of(const Line& line, const Shaped& o) {
  const auto first = [&](const auto& shape) { return isect::first_place(line, shape); };
  switch (o.type()) {
    case Type::plane:
      return first(o.as<Plane, 3>());
    case Type::sphere:
      return first(o.as<Sphere, 3>());
    case Type::capsule:
      return first(o.as<Capsule, 3>());
    case Type::cylinder:
      return first(std::get<Cylinder<double>>(o.shape<3>()));
    case Type::cone:
      return first(std::get<Cone<double>>(o.shape<3>()));
    case Type::point:
      return first(o.numbers.point(o.object, "at"));
    case Type::cloud:
      return first_of_all(line, o.points());
    case Type::ray:
    case Type::line:
      return first(o.as<Ray, 3>());
    case Type::segment:
      return first(o.as<Segment, 3>());
    case Type::box:
    case Type::obb:
    case Type::kdop:
    case Type::frustum:
    case Type::hull:
      return first(o.faces());
    case Type::mesh:
      return first_on_surface(line, o.mesh().mesh);
    case Type::triangle:
    case Type::polygon:
      if (o.flat()) return isect::first_place(in_the_plane(line), o.outline());
      if (o.type() == Type::triangle) return first(o.as<Triangle, 3>());
      if (o.off_plane() > 0) return first_on_surface(line, o.polygon());
      return first(Polygon<double, 3>{{o.ring()}});
  }
  return {};
}

}  // namespace

std::optional<Place> first_place(const Shaped& along, const Shaped& o) {
  return along.type() == Type::segment ? place_of(along.as<Segment, 3>(), o) : place_of(along.as<Ray, 3>(), o);
}

}  // namespace isect::program::scene
