#include <isect/compiled.h>

#include <cstddef>
#include <stdexcept>
#include <utility>

#include <isect/ask_any.h>
#include <isect/convex_hull_3d.h>

namespace isect::compiled {

template <int N>
struct Shape<N>::Held {
  AnyShape<double, N> shape;
};

namespace detail {

template <std::size_t N>
isect::Point<double, N> vector(const std::array<double, N>& p) {
  return isect::Point<double, N>(p.data());
}

template <std::size_t N>
std::vector<isect::Point<double, N>> vectors(const std::vector<std::array<double, N>>& points) {
  std::vector<isect::Point<double, N>> all;
  all.reserve(points.size());
  for (const std::array<double, N>& p : points) all.push_back(vector(p));
  return all;
}

}  // namespace detail

using detail::vector, detail::vectors;

template <int N>
Shape<N>::Shape(Held&& held) : held_(new Held(std::move(held))) {}
template <int N>
Shape<N>::Shape(const Shape& other) : held_(new Held(*other.held_)) {}
template <int N>
Shape<N>::~Shape() {
  delete held_;
}

template <int N>
Shape<N> Shape<N>::point(const Point& p) {
  return Shape(Held{vector(p)});
}
template <int N>
Shape<N> Shape<N>::segment(const Point& p, const Point& q) {
  return Shape(Held{Segment<double, N>{vector(p), vector(q)}});
}
template <int N>
Shape<N> Shape<N>::ray(const Point& origin, const Point& direction, Interval<double> range) {
  return Shape(Held{Ray<double, N>{vector(origin), vector(direction), range}});
}
template <int N>
Shape<N> Shape<N>::plane(const Point& normal, double d) {
  return Shape(Held{isect::Plane<double, N>{vector(normal), d}});
}
template <int N>
Shape<N> Shape<N>::sphere(const Point& center, double radius) {
  return Shape(Held{Sphere<double, N>{vector(center), radius}});
}
template <int N>
Shape<N> Shape<N>::capsule(const Point& p, const Point& q, double radius) {
  return Shape(Held{Capsule<double, N>{vector(p), vector(q), radius}});
}
template <int N>
Shape<N> Shape<N>::aabb(const Point& lo, const Point& hi) {
  return Shape(Held{Aabb<double, N>{vector(lo), vector(hi)}});
}
template <int N>
Shape<N> Shape<N>::obb(const Point& center, const std::array<Point, N>& axes, const Point& half) {
  Obb<double, N> box = {vector(center), {}, vector(half)};
  for (int i = 0; i < N; ++i) box.axes.col(i) = vector(axes[static_cast<std::size_t>(i)]);
  return Shape(Held{std::move(box)});
}
template <int N>
Shape<N> Shape<N>::kdop(const std::vector<Slab>& slabs) {
  Kdop<double, N> kdop;
  for (const Slab& slab : slabs) kdop.normals.push_back(vector(slab.normal)), kdop.slabs.push_back(slab.range);
  return Shape(Held{std::move(kdop)});
}
template <int N>
Shape<N> Shape<N>::triangle(const Point& a, const Point& b, const Point& c) {
  return Shape(Held{Triangle<double, N>{{vector(a), vector(b), vector(c)}}});
}

template <int N>
Shape<N> Shape<N>::polygon(const std::vector<Ring>& rings) requires(N == 2) {
  Polygon<double, 2> polygon;
  for (const Ring& ring : rings) polygon.rings.push_back(vectors(ring));
  return Shape(Held{std::move(polygon)});
}

template <int N>
Shape<N> Shape<N>::polygon(const Ring& outline) requires(N == 3) {
  return Shape(Held{triangulated(vectors(outline))});
}
template <int N>
Shape<N> Shape<N>::frustum(const std::array<Plane, 6>& planes) requires(N == 3) {
  Frustum<double> frustum;
  for (std::size_t i = 0; i < planes.size(); ++i) frustum.planes[i] = {vector(planes[i].normal), planes[i].d};
  return Shape(Held{std::move(frustum)});
}
template <int N>
Shape<N> Shape<N>::hull(const std::vector<Point>& points) requires(N == 3) {
  Hull3<double> hull = convex_hull(vectors(points));
  if (hull.dimension != 3)
    throw std::invalid_argument("isect: the points of a hull lie in a plane, and have no volume");
  return Shape(Held{std::move(hull)});
}
template <int N>
Shape<N> Shape<N>::mesh(const std::vector<Point>& vertices,
                        const std::vector<std::array<int, 3>>& triangles) requires(N == 3) {
  TriangleMesh<double> mesh = {vectors(vertices), triangles};
  if (!valid(mesh)) throw std::invalid_argument("isect: a triangle of the mesh has an index of no vertex");
  return Shape(Held{std::move(mesh)});
}
template <int N>
Shape<N> Shape<N>::cylinder(const Point& p, const Point& q, double radius) requires(N == 3) {
  return Shape(Held{Cylinder<double>{vector(p), vector(q), radius}});
}
template <int N>
Shape<N> Shape<N>::cone(const Point& apex, const Point& base, double radius) requires(N == 3) {
  return Shape(Held{Cone<double>{vector(apex), vector(base), radius}});
}

template class Shape<2>;
template class Shape<3>;

Answer ask(const Shape2& a, const Shape2& b) { return ask_any(a.held().shape, b.held().shape); }
std::optional<Answer> ask(const Shape3& a, const Shape3& b) { return ask_any(a.held().shape, b.held().shape); }

}  // namespace isect::compiled
