#include "app/scene/shapes.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <isect/convex_hull.h>
#include <isect/kdop_polytope.h>
#include <isect/point_mesh.h>

#include "app/scene/pairs.h"

namespace isect::program::scene {

namespace {

using viz::Vec3;

[[noreturn]] void has_none(const Object& o, const std::string& what) {
  throw viz::BadInput(fmt::format("{}: {}", o.name, what));
}

HalfSpaces hull_faces(const NamedValues& s, const Object& o) {
  if (!s.flat) {
    static_cast<void>(solid_of(s, o));  // this refuses one without a volume
    return half_spaces_of(hull_of(s, o));
  }
  HalfSpaces result = {{}, 2};
  const std::vector<Vec3> ring = outline_of(s, o);
  if (ring.size() < 3) has_none(o, "its points lie on one line, so their hull has no area");
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec3 &a = ring[i], &b = ring[(i + 1) % ring.size()];
    result.faces.push_back({half_spaces::Behind{a, b, a + Vec3::UnitZ()}});
  }
  return result;
}

template <int N>
HalfSpaces faces(const NamedValues& s, const Object& o) {
  if (o.type == Type::box) return half_spaces_of(made<Aabb<double, N>>(s, o));
  if (o.type == Type::obb) return half_spaces_of(made<Obb<double, N>>(s, o));
  if (o.type == Type::kdop) return half_spaces_of(kdop_of<N>(s, o));
  if (o.type == Type::frustum) return half_spaces_of(frustum_of(s, o));
  return hull_faces(s, o);
}

}  // namespace

std::vector<Vec3> in_space(const std::vector<Point<double, 2>>& points) {
  std::vector<Vec3> all;
  for (const Point<double, 2>& p : points) all.emplace_back(p.x(), p.y(), 0);
  return all;
}

Frustum<double> frustum_of(const NamedValues& s, const Object& o) {
  const Vec3 eye = s.point(o, "eye"), f = s.point(o, "forward").stableNormalized();
  const Vec3 right = f.cross(s.point(o, "up")).stableNormalized(), up = right.cross(f);
  if (!(right.squaredNorm() > 0.5)) has_none(o, "forward and up are along one line");
  const double half = s.number(o, "angle") * std::numbers::pi / 360, tall = std::tan(half);
  const double wide = tall * (s.has(o, "aspect") ? s.number(o, "aspect") : 1);
  const double near = s.number(o, "near"), far = s.number(o, "far");
  if (!(near < far)) has_none(o, "near is to be less than far");
  const auto through_eye = [&](const Vec3& normal) { return Plane<double, 3>{normal, -normal.dot(eye)}; };
  return {{through_eye(wide * f + right), through_eye(wide * f - right), through_eye(tall * f + up),
           through_eye(tall * f - up), Plane<double, 3>{f, -f.dot(eye) - near},
           Plane<double, 3>{-f, f.dot(eye) + far}}};
}

Hull3<double> hull_of(const NamedValues& s, const Object& o) { return convex_hull(s.points(o)); }

TriangleMesh<double> mesh_of(const NamedValues& s, const Object& o) { return {s.points(o), o.fixed.triangles}; }

Triangle<double, 3> triangle_of(const NamedValues& s, const Object& o) {
  const std::vector<Vec3> p = s.rings(o).front();
  return {{p[0], p[1], p[2]}};
}

Capsule<double, 3> capsule_in_space(const NamedValues& s, const Object& o) {
  if (o.type == Type::sphere) return {s.point(o, "center"), s.point(o, "center"), s.number(o, "radius")};
  return made<Capsule<double, 3>>(s, o);
}

HalfSpaces faces_of(const NamedValues& s, const Object& o) { return s.flat ? faces<2>(s, o) : faces<3>(s, o); }

viz::Solid solid_of(const NamedValues& s, const Object& o) {
  if (o.type == Type::hull) {
    const Hull3<double> hull = hull_of(s, o);
    if (hull.dimension < 3) has_none(o, "its points lie in one plane, so their hull has no volume");
    return viz::solid(hull, viz::Role::second);
  }
  try {
    const viz::Solid solid = viz::solid(kdop_of<3>(s, o), viz::Role::second);
    if (solid.vertices.empty()) has_none(o, "it is empty: its slabs have no common point");
    return solid;
  } catch (const std::invalid_argument&) {
    has_none(o, "its normals do not span space, so it has no end");
  }
}

std::vector<Vec3> outline_of(const NamedValues& s, const Object& o) {
  if (o.type == Type::hull) return in_space(convex_hull(points_of<2>(s.points(o))));
  try {
    const std::vector<Vec3> corners = in_space(polytope(kdop_of<2>(s, o)).vertices);
    if (corners.empty()) has_none(o, "it is empty: its slabs have no common point");
    return corners;
  } catch (const std::invalid_argument&) {
    has_none(o, "its normals do not span the plane, so it has no end");
  }
}

std::optional<Ray<double, 3>> ray_in_space(const NamedValues& s, const Object& o) {
  if (o.type == Type::segment) {
    const Vec3 from = s.point(o, "from"), to = s.point(o, "to"), dir = to - from;
    for (int i = 0; i < 3; ++i) {
      const double back = dir[i] + from[i], error = (to[i] - back) + ((back - dir[i]) - from[i]);
      if (back != to[i] || error != 0) return {};
    }
    return Ray<double, 3>{from, dir, {0, 1}};
  }
  Ray<double, 3> ray = made<Ray<double, 3>>(s, o);
  if (o.type == Type::line) ray.range = infinite<double>;
  return ray;
}

namespace {

template <int N>
AnyShape<double, N> shape_of(const Shaped& x) {
  const NamedValues& s = x.numbers;
  const Object& o = x.object;
  switch (o.type) {
    case Type::point:
      return point_of<N>(s.point(o, "at"));
    case Type::segment:
      return made<Segment<double, N>>(s, o);
    case Type::ray:
      return made<Ray<double, N>>(s, o);
    case Type::line: {
      Ray<double, N> line = made<Ray<double, N>>(s, o);
      line.range = infinite<double>;
      return line;
    }
    case Type::plane:
      return made<Plane<double, N>>(s, o);
    case Type::sphere:
      return made<Sphere<double, N>>(s, o);
    case Type::capsule:
      return made<Capsule<double, N>>(s, o);
    case Type::cylinder:
      if constexpr (N == 3) return made<Cylinder<double>>(s, o);
      break;
    case Type::cone:
      if constexpr (N == 3) return made<Cone<double>>(s, o);
      break;
    case Type::box:
      return made<Aabb<double, N>>(s, o);
    case Type::obb:
      return made<Obb<double, N>>(s, o);
    case Type::triangle: {
      const std::vector<Point<double, N>> p = points_of<N>(s.rings(o).front());
      return Triangle<double, N>{{p[0], p[1], p[2]}};
    }
    case Type::kdop:
    case Type::frustum:
    case Type::hull:
      return x.faces();
    case Type::mesh:
      if constexpr (N == 3) return x.mesh().mesh;
      break;
    case Type::polygon:
      if constexpr (N == 2)
        return x.outline();
      else
        return triangulated(x.ring());
    case Type::cloud:
      break;
  }
  throw std::logic_error("the core has no such shape");
}

Polygon<double, 2> outline_in_plane(const NamedValues& s, const Object& o) {
  if (o.type == Type::segment) return {{{point_of<2>(s.point(o, "from")), point_of<2>(s.point(o, "to"))}}};
  if (o.type == Type::hull) return {{convex_hull(points_of<2>(s.points(o)))}};
  if (o.type == Type::box) {
    const Vec3 lo = s.point(o, "lo"), hi = s.point(o, "hi");
    return {{{{lo.x(), lo.y()}, {hi.x(), lo.y()}, {hi.x(), hi.y()}, {lo.x(), hi.y()}}}};
  }
  Polygon<double, 2> polygon;
  for (const std::vector<Vec3>& ring : s.rings(o)) polygon.rings.push_back(points_of<2>(ring));
  return polygon;
}

}  // namespace

struct Shaped::Made {
  std::optional<AnyShape<double, 2>> in_plane = {};
  std::optional<AnyShape<double, 3>> in_space = {};
  std::optional<HalfSpaces> faces = {};
  std::optional<Hull3<double>> hull = {};
  std::optional<Polygon<double, 2>> outline = {};
  std::optional<Ring<double, 3>> ring = {};
  std::optional<double> off_plane = {};
  std::optional<std::optional<Ray<double, 3>>> ray = {};
  std::optional<std::vector<Vec3>> points = {};
  std::optional<Mesh> mesh = {};
};

template <class X, class Make>
const X& Shaped::kept(std::optional<X> Made::*one, const Make& make) const {
  if (!made_) made_ = std::make_shared<Made>();
  std::optional<X>& x = (*made_).*one;
  if (!x) x = make();
  return *x;
}

template <>
const AnyShape<double, 2>& Shaped::shape<2>() const {
  return kept(&Made::in_plane, [&] { return shape_of<2>(*this); });
}
template <>
const AnyShape<double, 3>& Shaped::shape<3>() const {
  return kept(&Made::in_space, [&] { return shape_of<3>(*this); });
}
const HalfSpaces& Shaped::faces() const {
  return kept(&Made::faces, [&] { return faces_of(numbers, object); });
}
const Hull3<double>& Shaped::hull() const {
  return kept(&Made::hull, [&] { return hull_of(numbers, object); });
}
const Polygon<double, 2>& Shaped::outline() const {
  return kept(&Made::outline, [&] { return outline_in_plane(numbers, object); });
}
const Ring<double, 3>& Shaped::ring() const {
  return kept(&Made::ring, [&] { return points_of<3>(numbers.rings(object).front()); });
}
const TriangulatedPolygon<double>& Shaped::polygon() const {
  if (ring().size() > most_corners)
    throw NotDecided(fmt::format("{} has more than {} corners", object.name, most_corners));
  const auto& made = std::get<TriangulatedPolygon<double>>(shape<3>());
  if (empty(made)) refuse_outline(object);
  return made;
}
double Shaped::off_plane() const {
  return kept(&Made::off_plane, [&] { return type() == Type::polygon ? isect::off_plane(ring()) : 0.0; });
}
const std::optional<Ray<double, 3>>& Shaped::ray() const {
  return kept(&Made::ray, [&] { return ray_in_space(numbers, object); });
}
const std::vector<Vec3>& Shaped::points() const {
  return kept(&Made::points, [&] { return numbers.points(object); });
}
const Shaped::Mesh& Shaped::mesh() const {
  return kept(&Made::mesh, [&] {
    const TriangleMesh<double> mesh = mesh_of(numbers, object);
    const std::vector<Aabb<double, 3>> around = isect::boxes(mesh);
    return Mesh{mesh, around, build_bvh(around), point_mesh::closed(mesh)};
  });
}

}  // namespace isect::program::scene
