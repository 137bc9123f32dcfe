#pragma once
// A convex solid as the common part of half-spaces: one form for boxes, oriented boxes, k-DOPs, frusta and hulls of
// points, so that how any two of them lie is decided exactly.
//
// The half-spaces follow from the shape's own numbers, not rounded: the face of an oriented box has a product of two
// axes as its normal, a hull's facet one of two differences of corners. Every verdict is the sign of a determinant of
// them, see isect/parts/inequalities.h. A lies in B iff for no face of B there is a point of A beyond it.
//
// The price: about n signs for each corner on the way to the answer, for n half-spaces in all; whether m faces hold a
// solid of n is decided face by face. Boxes and oriented boxes among themselves have faster tests, isect/aabb_aabb.h
// and isect/obb_obb.h.
//
// A shape of the plane counts as the prism over it, which has no end in z.

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <variant>
#include <vector>

#include <isect/convex_hull_3d.h>
#include <isect/parts/inequalities.h>
#include <isect/point_obb.h>
#include <isect/shapes.h>
#include <isect/trace.h>

namespace isect {

namespace half_spaces {

/// normal.x + d >= 0, as given.
using Level = Plane<double, 3>;
/// The inner side of one face, of pair `i`, of an oriented box.
struct BoxFace {
  Obb<double, 3> box;
  int i, side;
};
/// The side of the plane of a, b, c from which they turn clockwise.
struct Behind {
  Point<double, 3> a, b, c;
};
/// The side of a triangle's edge a b on which its corner c is.
struct Beside {
  Point<double, 3> a, b, c;
};
/// The points from a on in the direction of b.
struct Beyond {
  Point<double, 3> a, b;
};
/// One side of the plane through a and b along coordinate axis `i`.
struct Along {
  Point<double, 3> a, b;
  int i;
};

/// One half-space; turned it is the other side of the same plane.
struct Face {
  std::variant<Level, BoxFace, Behind, Beside, Beyond, Along> form;
  bool turned = false;
};

using Event = std::variant<Fallback>;

}  // namespace half_spaces

/// The points that lie in all faces. In the plane `dimension` is 2.
struct HalfSpaces {
  std::vector<half_spaces::Face> faces;
  int dimension = 3;
};

namespace half_spaces {

namespace detail {

template <PolynomialScalar W>
inequalities::Row<W> row(const Level& plane) {
  return {W(plane.normal[0]), W(plane.normal[1]), W(plane.normal[2]), W(plane.d)};
}
/// h |D| - s n.(x - c) >= 0, with the normals and the volume of isect/point_obb.h
template <PolynomialScalar W>
inequalities::Row<W> row(const BoxFace& face) {
  const Components<W, 3> n = point_obb::detail::normal<W>(face.box.axes, face.i);
  const W side(face.side), reach = W(face.box.half[face.i]) * abs(point_obb::detail::volume<W>(face.box.axes, face.i));
  return {-(side * n[0]), -(side * n[1]), -(side * n[2]), side * dot(n, exactly<W>(face.box.center)) + reach};
}
/// The plane through p with this normal.
template <PolynomialScalar W>
inequalities::Row<W> through(const Point<double, 3>& p, const Components<W, 3>& n) {
  return {n[0], n[1], n[2], -dot(n, exactly<W>(p))};
}
template <PolynomialScalar W>
Components<W, 3> normal(const Point<double, 3>& a, const Point<double, 3>& b, const Point<double, 3>& c) {
  return cross(difference<W>(b, a), difference<W>(c, a));
}
template <PolynomialScalar W>
inequalities::Row<W> row(const Behind& face) {
  return through<W>(face.a, normal<W>(face.a, face.c, face.b));
}
template <PolynomialScalar W>
inequalities::Row<W> row(const Beside& face) {
  return through<W>(face.a, cross(normal<W>(face.a, face.b, face.c), difference<W>(face.b, face.a)));
}

template <PolynomialScalar W>
inequalities::Row<W> row(const Beyond& face) {
  return through<W>(face.a, difference<W>(face.b, face.a));
}
template <PolynomialScalar W>
inequalities::Row<W> row(const Along& face) {
  const Vector<double, 3> axis = Vector<double, 3>::Unit(face.i);
  return through<W>(face.a, cross(difference<W>(face.b, face.a), exactly<W>(axis)));
}

template <PolynomialScalar W>
inequalities::Row<W> row(const Face& face) {
  inequalities::Row<W> r = std::visit([](const auto& form) { return row<W>(form); }, face.form);
  if (face.turned)
    for (W& x : r) x = -x;
  return r;
}

/// Returns a half-space without a point.
inline Face nothing() { return {Level{Vector<double, 3>::Zero(), -1}}; }

/// Returns x, with 0 for the coordinate that the plane lacks.
template <class S, int N>
Vector<double, 3> in_space(const Vector<S, N>& x) {
  Vector<double, 3> v = Vector<double, 3>::Zero();
  v.template head<N>() = x.template cast<double>();
  return v;
}

/// The text of the faces, one after the other.
inline auto text_of(const std::vector<Face>& faces) {
  return [&faces]<class W>(int i) -> inequalities::Row<W> { return row<W>(faces[static_cast<std::size_t>(i)]); };
}

inline int count(const std::vector<Face>& faces) { return static_cast<int>(faces.size()); }

/// Whether they have a common point.
template <class Trace>
bool have_a_point(const std::vector<Face>& faces, Trace&& trace) {
  return !inequalities::contradictory(count(faces), text_of(faces), trace);
}
/// Whether they have a common interior point.
template <class Trace>
bool has_interior(const std::vector<Face>& faces, Trace&& trace) {
  return inequalities::common(count(faces), text_of(faces), trace) > 0;
}

inline HalfSpaces both(const HalfSpaces& a, const HalfSpaces& b) {
  HalfSpaces all = a;
  all.faces.insert(all.faces.end(), b.faces.begin(), b.faces.end());
  return all;
}

/// Whether A, which is not empty, lies in B, of which these are the faces.
template <class Trace>
bool inside(const HalfSpaces& a, const std::vector<Face>& b, Trace&& trace) {
  const auto text = text_of(a.faces);
  inequalities::System system(count(a.faces), text, trace);
  return std::ranges::all_of(b, [&](const Face& face) {
    return system.implies([&]<class W>() -> inequalities::Row<W> { return row<W>(face); });
  });
}

/// Whether some point is interior to both solids, which have a common point. A thin one has its interior within the
/// plane or line that it spans, so that the faces that it lies on as a whole do not count.
template <class Trace>
bool interiors_meet(const HalfSpaces& a, const HalfSpaces& b, Trace&& trace) {
  const std::vector<Face> faces = both(a, b).faces;
  if (has_interior(faces, trace)) return true;
  std::vector<char> strict;
  for (const HalfSpaces* const solid : {&a, &b}) {
    const auto text = text_of(solid->faces);
    inequalities::System system(count(solid->faces), text, trace);
    for (int i = 0; i < count(solid->faces); ++i) strict.push_back(!system.is_equation(i));
  }
  const auto is_strict = [&](int i) { return strict[static_cast<std::size_t>(i)] != 0; };
  return inequalities::common(count(faces), text_of(faces), is_strict, trace) > 0;
}

}  // namespace detail

}  // namespace half_spaces

// What is empty, NaN or infinite has no point in this form, either.

template <class S, int N>
HalfSpaces half_spaces_of(const Aabb<S, N>& box) {
  if (empty(box) || !finite(box)) return {{half_spaces::detail::nothing()}, N};
  HalfSpaces result = {{}, N};
  for (int i = 0; i < N; ++i) {
    const Vector<double, 3> unit = Vector<double, 3>::Unit(i);
    result.faces.push_back({half_spaces::Level{unit, -static_cast<double>(box.lo[i])}});
    result.faces.push_back({half_spaces::Level{-unit, static_cast<double>(box.hi[i])}});
  }
  return result;
}

/// A box with dependent axes has no point.
template <class S, int N>
HalfSpaces half_spaces_of(const Obb<S, N>& box) {
  Obb<double, 3> wide = {half_spaces::detail::in_space<S, N>(box.center), Eigen::Matrix3d::Identity(),
                         half_spaces::detail::in_space<S, N>(box.half)};
  wide.axes.template topLeftCorner<N, N>() = box.axes.template cast<double>();
  if (empty(box) || !finite(box) || !point_obb::detail::independent(wide.axes))
    return {{half_spaces::detail::nothing()}, N};
  HalfSpaces result = {{}, N};
  for (int i = 0; i < N; ++i)
    for (const int side : {-1, 1}) result.faces.push_back({half_spaces::BoxFace{wide, i, side}});
  return result;
}

/// There must be as many slabs as normals.
template <class S, int N>
HalfSpaces half_spaces_of(const Kdop<S, N>& kdop) {
  assert(kdop.normals.size() == kdop.slabs.size());
  if (empty(kdop) || !finite(kdop)) return {{half_spaces::detail::nothing()}, N};
  HalfSpaces result = {{}, N};
  for (std::size_t i = 0; i < kdop.slabs.size(); ++i) {
    const Vector<double, 3> n = half_spaces::detail::in_space<S, N>(kdop.normals[i]);
    result.faces.push_back({half_spaces::Level{n, -static_cast<double>(kdop.slabs[i].lo)}});
    result.faces.push_back({half_spaces::Level{-n, static_cast<double>(kdop.slabs[i].hi)}});
  }
  return result;
}

template <class S>
HalfSpaces half_spaces_of(const Frustum<S>& frustum) {
  if (!finite(frustum)) return {{half_spaces::detail::nothing()}};
  HalfSpaces result;
  for (const Plane<S, 3>& plane : frustum.planes) result.faces.push_back({cast<double>(plane)});
  return result;
}

namespace half_spaces::detail {

/// Returns the half-spaces of a segment, which is finite.
inline HalfSpaces segment(const Point<double, 3>& p, const Point<double, 3>& q, int dimension) {
  if (p == q)
    return dimension == 2 ? half_spaces_of(Aabb<double, 2>{p.head<2>(), p.head<2>()})
                          : half_spaces_of(Aabb<double, 3>{p, p});
  HalfSpaces result = {{{Beyond{p, q}}, {Beyond{q, p}}}, dimension};
  for (int i = dimension == 2 ? 2 : 0; i < 3; ++i)
    for (const bool turned : {false, true}) result.faces.push_back({Along{p, q, i}, turned});
  return result;
}

}  // namespace half_spaces::detail

/// The segment's ends may be the same.
template <class S, int N>
HalfSpaces half_spaces_of(const Segment<S, N>& segment) {
  using namespace half_spaces::detail;
  if (!finite(segment)) return {{nothing()}, N};
  return half_spaces::detail::segment(in_space<S, N>(segment.p), in_space<S, N>(segment.q), N);
}

/// Returns the half-spaces of a triangle with an area: its plane from both sides, and a side for each edge.
template <class S>
HalfSpaces half_spaces_of(const Triangle<S, 3>& triangle) {
  if (!finite(triangle)) return {{half_spaces::detail::nothing()}};
  const auto at = [&](std::size_t i) { return half_spaces::detail::in_space<S, 3>(triangle.vertices[i]); };
  const Point<double, 3> a = at(0), b = at(1), c = at(2);
  using half_spaces::Behind, half_spaces::Beside;
  return {{{Behind{a, b, c}}, {Behind{a, b, c}, true}, {Beside{a, b, c}}, {Beside{b, c, a}}, {Beside{c, a, b}}}};
}

/// Returns the half-spaces of a hull that has a volume.
template <class S>
HalfSpaces half_spaces_of(const Hull3<S>& hull) {
  assert(hull.dimension == 3);
  HalfSpaces result;
  const auto at = [&](int i) {
    return half_spaces::detail::in_space<S, 3>(hull.vertices[static_cast<std::size_t>(i)]);
  };
  for (const auto& [a, b, c] : hull.triangles) result.faces.push_back({half_spaces::Behind{at(a), at(b), at(c)}});
  return result;
}

/// Whether they have a common point. Exact.
template <class Trace = NoTrace>
bool intersects(const HalfSpaces& a, const HalfSpaces& b, Trace&& trace = {}) {
  return half_spaces::detail::have_a_point(half_spaces::detail::both(a, b).faces, trace);
}

/// Whether it has a point. Exact.
template <class Trace = NoTrace>
bool has_a_point(const HalfSpaces& a, Trace&& trace = {}) {
  return half_spaces::detail::have_a_point(a.faces, trace);
}

/// How two solids lie. Exact, for those without a volume, too. One without a point is disjoint from all.
template <class Trace = NoTrace>
Relation relate(const HalfSpaces& a, const HalfSpaces& b, Trace&& trace = {}) {
  if (!intersects(a, b, trace)) return Relation::disjoint;
  const bool a_in_b = half_spaces::detail::inside(a, b.faces, trace),
             b_in_a = half_spaces::detail::inside(b, a.faces, trace);
  if (a_in_b) return b_in_a ? Relation::equal : Relation::a_inside_b;
  if (b_in_a) return Relation::b_inside_a;
  return half_spaces::detail::interiors_meet(a, b, trace) ? Relation::overlapping : Relation::touching;
}

/// How the plane (A) and the solid lie: disjoint, touching, or overlapping, when the solid has points on both sides.
/// Exact. A plane with a zero normal or a number that is not finite is disjoint from all.
template <class S, int N, class Trace = NoTrace>
Relation relate(const Plane<S, N>& plane, const HalfSpaces& solid, Trace&& trace = {}) {
  if (!finite(plane) || plane.normal.isZero(0) || !has_a_point(solid, trace)) return Relation::disjoint;
  half_spaces::Face before = {half_spaces::Level{half_spaces::detail::in_space<S, N>(plane.normal), plane.d}};
  half_spaces::Face behind = before;
  behind.turned = true;
  const bool all_before = half_spaces::detail::inside(solid, {before}, trace),
             all_behind = half_spaces::detail::inside(solid, {behind}, trace);
  if (!all_before && !all_behind) return Relation::overlapping;
  std::vector<half_spaces::Face> on = solid.faces;
  on.push_back(before), on.push_back(behind);
  return half_spaces::detail::have_a_point(on, trace) ? Relation::touching : Relation::disjoint;
}

/// Where the point lies: on the boundary, too, where the solid has no volume. Exact.
template <class S, int N, class Trace = NoTrace>
Location locate(const Point<S, N>& p, const HalfSpaces& solid, Trace&& trace = {}) {
  if (!finite(p)) return Location::out;
  const Point<double, 3> at = half_spaces::detail::in_space<S, N>(p);
  Location where = Location::in;
  for (const half_spaces::Face& face : solid.faces) {
    const int side = sign_of<long_text>(
        [&]<class W>() -> W {
          const inequalities::Row<W> row = half_spaces::detail::row<W>(face);
          return dot(inequalities::detail::normal(row), exactly<W>(at)) + row[3];
        },
        trace);
    if (side < 0) return Location::out;
    const auto* level = std::get_if<half_spaces::Level>(&face.form);
    if (side == 0 && !(level && level->normal.isZero(0))) where = Location::on;
  }
  return where;
}

}  // namespace isect
