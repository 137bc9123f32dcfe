#pragma once
// An eye, its picture plane and what it sees, for the lessons that send viewing rays through pixels.

#include <optional>
#include <span>

#include <isect/many/bvh_ray.h>
#include "viz/lesson.h"

namespace isect::lessons::viewing {

using Ray3 = Ray<double, 3>;
/// The surface of a convex body.
using Triangles = std::vector<Triangle<double, 3>>;
/// A ball, a box, a plane polygon, or triangles.
using Shape = std::variant<Sphere<double, 3>, Aabb<double, 3>, Ring<double, 3>, Triangles>;

struct Object {
  const char* name;  ///< markup, "ball **a**"
  Shape shape;
  viz::Role role;
};

/// The least t of the ray's range at which it meets the shape: the core's own ray tests.
std::optional<double> first_hit(const Ray3&, const Shape&);
/// The unit normal, outwards; a polygon's points upwards.
viz::Vec3 normal_at(const Shape&, const viz::Vec3& p);
Aabb<double, 3> bounds(const Shape&);
viz::Vec3 middle(const Shape&);

/// Objects under a hierarchy with a leaf each.
struct World {
  explicit World(std::vector<Object>);

  std::vector<Object> objects;
  Bvh<double, 3> bvh;

  /// The closest hit of a ray.
  template <class Trace = NoTrace>
  std::optional<BvhHit<double>> closest(const Ray3& ray, Trace&& trace = {}) const {
    return closest_hit(
        bvh, ray, [&](int i) { return first_hit(ray, objects[i].shape); }, trace);
  }
  const Object& object(int i) const { return objects[i]; }
};

/// The eye looks along +x through a picture of columns x rows pixels.
struct Eye {
  Eye(int columns, int rows);

  int columns, rows;
  viz::View view;  ///< in pixels

  /// Where the viewing ray through a point of the picture, in pixels, meets the picture plane.
  viz::Vec3 on_plane(const viz::Vec2& pixel) const;
  /// The inverse of on_plane; the point's x is not used.
  viz::Vec2 pixel(const viz::Vec3& on_plane) const;
  /// The viewing ray from the eye, with t = 1 on the picture plane.
  Ray3 through(const viz::Vec3& on_plane) const { return {eye_point(), on_plane - eye_point()}; }
  static viz::Vec3 eye_point() { return {-4.5, 0.25, 0}; }  ///< exact; the eye point of `view` is rounded
};
inline constexpr double plane_x = -1.5;
viz::Camera eye_camera();

void add(const Object&, viz::Scene&, bool lit = true);  ///< not lit: muted, without a colour of its own
void add_name(const Object&, viz::Scene&);
std::string short_name(const Object&);  ///< without "ball"
/// Adds the eye and the frame of its picture plane, with the lines from one to the other.
void add(const Eye&, viz::Scene&);
/// The eye's picture, a cell a pixel, facing the viewer outside; and where a point of it, in pixels, lies.
viz::Raster picture(const Eye&, std::vector<viz::Cell>, const viz::Vec3& center, double height);
viz::Vec3 on_picture(const viz::Raster&, const Eye&, const viz::Vec2& pixel);
/// A camera outside: the eye on the left, the objects on the right.
viz::Camera from_outside();

}  // namespace isect::lessons::viewing
