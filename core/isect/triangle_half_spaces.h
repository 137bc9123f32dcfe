#pragma once
// Triangle against a convex solid given by half-spaces (isect/half_spaces.h): an oriented box, a k-DOP, a frustum, a
// hull; and against another triangle, which is flat and has half-spaces as well.
//
// The points of the triangle are a + s (b - a) + t (c - a) with s, t >= 0, s + t <= 1. So each half-space says one
// linear inequality in s and t, and whether all have a common solution is decided as in isect/parts/inequalities.h. A
// triangle that is a segment or a point needs no case of its own.

#include <algorithm>
#include <cstddef>
#include <variant>

#include <isect/capsule_capsule.h>
#include <isect/half_spaces.h>

namespace isect {

namespace triangle_half_spaces {

using Event = std::variant<Fallback>;

namespace detail {

/// Returns inequality i: the factors of s, of t and of nothing else, and the constant.
template <PolynomialScalar W>
inequalities::Row<W> row(const std::vector<half_spaces::Face>& faces, const Triangle<double, 3>& x, int i) {
  if (i == 0) return {W(1), W(0), W(0), W(0)};
  if (i == 1) return {W(0), W(1), W(0), W(0)};
  if (i == 2) return {W(-1), W(-1), W(0), W(1)};
  const inequalities::Row<W> face = half_spaces::detail::row<W>(faces[static_cast<std::size_t>(i - 3)]);
  const Components<W, 3> n = inequalities::detail::normal(face);
  const auto& [a, b, c] = x.vertices;
  return {dot(n, difference<W>(b, a)), dot(n, difference<W>(c, a)), W(0), dot(n, exactly<W>(a)) + face[3]};
}

/// Whether some half-space holds no corner, as for most triangles that have no point in all half-spaces.
template <class Trace>
bool beyond_a_face(const Triangle<double, 3>& x, const std::vector<half_spaces::Face>& faces, Trace&& trace) {
  return std::ranges::any_of(faces, [&](const half_spaces::Face& face) {
    return std::ranges::all_of(x.vertices, [&](const Point<double, 3>& v) {
      return sign_of<long_text>(
                 [&]<class W>() -> W {
                   const inequalities::Row<W> row = half_spaces::detail::row<W>(face);
                   return dot(inequalities::detail::normal(row), exactly<W>(v)) + row[3];
                 },
                 trace) < 0;
    });
  });
}

/// 1: some point within the triangle lies in the interior of all half-spaces. 0: a point of it lies in all. -1: none.
template <class Trace>
int common(const Triangle<double, 3>& x, const std::vector<half_spaces::Face>& faces, Trace&& trace) {
  if (beyond_a_face(x, faces, trace)) return -1;
  const auto text = [&]<class W>(int i) -> inequalities::Row<W> { return row<W>(faces, x, i); };
  return inequalities::common(half_spaces::detail::count(faces) + 3, text, trace);
}

/// Whether a point of the triangle lies in all half-spaces.
template <class Trace>
bool meets(const Triangle<double, 3>& x, const std::vector<half_spaces::Face>& faces, Trace&& trace) {
  if (beyond_a_face(x, faces, trace)) return false;
  const auto text = [&]<class W>(int i) -> inequalities::Row<W> { return row<W>(faces, x, i); };
  return !inequalities::contradictory(half_spaces::detail::count(faces) + 3, text, trace);
}

template <class S, int N>
Triangle<double, 3> in_space(const Triangle<S, N>& x) {
  const auto at = [&](std::size_t i) { return half_spaces::detail::in_space<S, N>(x.vertices[i]); };
  return {{at(0), at(1), at(2)}};
}

/// Whether the corners lie on one line.
template <class Trace>
bool degenerate(const Triangle<double, 3>& x, Trace&& trace) {
  const Point<double, 3>&a = x.vertices[0], &b = x.vertices[1], &c = x.vertices[2];
  for (std::size_t i = 0; i < 3; ++i)
    if (sign_of<long_text>([&]<class W>() -> W { return half_spaces::detail::normal<W>(a, b, c)[i]; }, trace) != 0)
      return false;
  return true;
}

/// The segment that a degenerate triangle is: between the two corners that have the third between them.
template <class Trace>
Capsule<double, 3> as_segment(const Triangle<double, 3>& x, Trace&& trace) {
  for (std::size_t i = 0; i < 3; ++i) {
    const Point<double, 3>&p = x.vertices[i], &q = x.vertices[(i + 1) % 3], &r = x.vertices[(i + 2) % 3];
    if (sign_of<long_text>([&]<class W>() -> W { return dot(difference<W>(p, r), difference<W>(q, r)); }, trace) <= 0)
      return {p, q, 0};
  }
  return {x.vertices[0], x.vertices[0], 0};
}

/// Returns any triangle as half-spaces; in the plane the prism over it.
template <class Trace>
HalfSpaces solid_of(const Triangle<double, 3>& x, int dimension, Trace&& trace) {
  if (degenerate(x, trace)) {
    const Capsule<double, 3> segment = as_segment(x, trace);
    return half_spaces::detail::segment(segment.p, segment.q, dimension);
  }
  HalfSpaces result = half_spaces_of(x);
  result.dimension = dimension;
  if (dimension == 2) result.faces.erase(result.faces.begin(), result.faces.begin() + 2);  // its plane
  return result;
}

}  // namespace detail

}  // namespace triangle_half_spaces

/// How triangle (A) and solid lie. Exact, for a solid without a volume, too; degenerate triangles are segments or
/// points. What is empty, NaN or infinite is disjoint from all.
template <class S, int N, class Trace = NoTrace>
Relation relate(const Triangle<S, N>& triangle, const HalfSpaces& solid, Trace&& trace = {}) {
  if (!finite(triangle)) return Relation::disjoint;
  const Triangle<double, 3> x = triangle_half_spaces::detail::in_space<S, N>(triangle);
  const int meet = triangle_half_spaces::detail::common(x, solid.faces, trace);
  if (meet < 0) return Relation::disjoint;
  const bool inside = std::ranges::all_of(
      triangle.vertices, [&](const Point<S, N>& v) { return locate<S, N>(v, solid, trace) != Location::out; });
  if (solid.dimension == 3 &&
      half_spaces::detail::has_interior(solid.faces, trace))  // it has a volume: no triangle holds it
    return inside ? Relation::a_inside_b : meet > 0 ? Relation::overlapping : Relation::touching;
  const HalfSpaces own = triangle_half_spaces::detail::solid_of(x, solid.dimension, trace);
  const bool held = half_spaces::detail::inside(solid, own.faces, trace);
  if (inside) return held ? Relation::equal : Relation::a_inside_b;
  if (held) return Relation::b_inside_a;
  return meet > 0 || half_spaces::detail::interiors_meet(own, solid, trace) ? Relation::overlapping
                                                                            : Relation::touching;
}

/// Whether they have a common point. Exact.
template <class S, int N, class Trace = NoTrace>
bool intersects(const Triangle<S, N>& triangle, const HalfSpaces& solid, Trace&& trace = {}) {
  if (!finite(triangle)) return false;
  const Triangle<double, 3> x = triangle_half_spaces::detail::in_space<S, N>(triangle);
  return triangle_half_spaces::detail::meets(x, solid.faces, trace);
}

/// Whether two triangles in space have a common point. Exact, in one plane, too, and where they are segments or points.
/// NaN or an infinite coordinate: no.
template <class S, class Trace = NoTrace>
bool intersects(const Triangle<S, 3>& a, const Triangle<S, 3>& b, Trace&& trace = {}) {
  if (!finite(a) || !finite(b)) return false;
  using namespace triangle_half_spaces::detail;
  const Triangle<double, 3> x = cast<double>(a), y = cast<double>(b);
  const bool flat_x = degenerate(x, trace), flat_y = degenerate(y, trace);
  if (flat_x && flat_y) return intersects(as_segment(x, trace), as_segment(y, trace), trace);
  const Triangle<double, 3>&outer = flat_y ? x : y, &inner = flat_y ? y : x;
  return triangle_half_spaces::detail::meets(inner, half_spaces_of(outer).faces, trace);
}

}  // namespace isect
