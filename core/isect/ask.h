#pragma once
// `ask` tells how any two shapes lie, in either order:
//
//   const Answer answer = ask(ball, box);
//   for (const AnyShape<double, 3>& shape : shapes) if (ask(ray, shape).meet) ...
//
// The table of pairs is the core's own set of overloads: a pair that `relate`, `locate`, `intersect`, `first_hit` or
// `beside` takes, in this order or the other, goes to it. A convex solid without a test of its own with B counts as the
// common part of its half-spaces, a triangle in the plane as a polygon of one ring. The other pairs are in
// isect/parts/ask_pairs.h, isect/parts/ask_meshes.h and below.
//
// Some pairs have no test yet, such as a cylinder and a capsule. For such a pair of known types `ask` does not compile;
// for types known only at run time it returns a std::optional<Answer>, empty for such a pair: not decided.
//
// This header includes every test of two shapes, and compiles most of them where it asks an AnyShape: a minute. Include
// the pair's own header where the types are known, and this one in a single source file where they are not.

#include <array>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <isect/aabb_aabb.h>
#include <isect/answer.h>
#include <isect/any_shape.h>
#include <isect/capsule_capsule.h>
#include <isect/capsule_half_spaces.h>
#include <isect/cone_half_spaces.h>
#include <isect/cylinder_half_spaces.h>
#include <isect/half_spaces.h>
#include <isect/interval_interval.h>
#include <isect/line_line.h>
#include <isect/line_triangle.h>
#include <isect/many/bvh_pairs.h>
#include <isect/mesh_convex.h>
#include <isect/mesh_mesh.h>
#include <isect/obb_obb.h>
#include <isect/parts/ask_meshes.h>
#include <isect/parts/ask_pairs.h>
#include <isect/plane_aabb.h>
#include <isect/plane_cone.h>
#include <isect/plane_cylinder.h>
#include <isect/plane_sphere.h>
#include <isect/point_aabb.h>
#include <isect/point_capsule.h>
#include <isect/point_cone.h>
#include <isect/point_cylinder.h>
#include <isect/point_kdop.h>
#include <isect/point_line.h>
#include <isect/point_mesh.h>
#include <isect/point_obb.h>
#include <isect/point_plane.h>
#include <isect/point_point.h>
#include <isect/point_polygon.h>
#include <isect/point_sphere.h>
#include <isect/polygon_convex.h>
#include <isect/polygon_in_space.h>
#include <isect/polygon_polygon.h>
#include <isect/ray_aabb.h>
#include <isect/ray_capsule.h>
#include <isect/ray_cone.h>
#include <isect/ray_cylinder.h>
#include <isect/ray_half_spaces.h>
#include <isect/ray_obb.h>
#include <isect/ray_outline.h>
#include <isect/ray_plane.h>
#include <isect/ray_sphere.h>
#include <isect/segment_plane.h>
#include <isect/segment_segment.h>
#include <isect/segment_sphere.h>
#include <isect/sphere_aabb.h>
#include <isect/sphere_capsule.h>
#include <isect/sphere_cone.h>
#include <isect/sphere_cylinder.h>
#include <isect/sphere_half_spaces.h>
#include <isect/sphere_sphere.h>
#include <isect/sphere_triangle.h>
#include <isect/triangle_aabb.h>
#include <isect/triangle_half_spaces.h>
#include <isect/triangle_mesh.h>

namespace isect {

// Converts what each test returns into an Answer.

template <class S>
Answer answer(const RaySphere<S>& shared) {
  Answer out = answer(shared.solid);
  out.tangent = shared.line_roots == 1;
  return out;
}
template <class S>
Answer answer(const RayPlane<S>& shared) {
  return {.meet = shared.meets, .t = shared.t, .parallel = shared.parallel, .coplanar = shared.coplanar};
}
inline Answer answer(const line_line::Result& r) {
  using line_line::Meeting;
  return {.meet = r.meets(),
          .t = r.t,
          .one_point = r.meeting == Meeting::point,
          .parallel = r.meeting == Meeting::parallel,
          .coplanar = r.meeting != Meeting::skew};
}
/// Answers for a point and a line: the point is left or right of it, in line with it, or on it.
inline Answer answer(Beside where) {
  return {.meet = where == Beside::on, .side = where == Beside::left ? 1 : where == Beside::right ? -1 : 0};
}
/// Answers for a plane and corners.
inline Answer answer(const Sides& count) {
  const bool cut = count.behind > 0 && count.before > 0, apart = count.on == 0 && !cut;
  Answer out = answer(cut ? Relation::overlapping : apart ? Relation::disjoint : Relation::touching);
  out.side = cut ? 0 : (count.before > 0) - (count.behind > 0);
  out.coplanar = count.on > 0 && count.behind + count.before == 0;
  return out;
}
/// Answers for a line and what it meets first at t.
template <class S>
Answer answer(const std::optional<S>& t) {
  return {.meet = t.has_value(), .t = t};
}

namespace ask_pairs {

namespace detail {

template <class X>
inline constexpr bool is_plane_triangle = false;
template <class S>
inline constexpr bool is_plane_triangle<Triangle<S, 2>> = true;

template <class X>
inline constexpr bool is_solid = false;
template <class S, int N>
inline constexpr bool is_solid<Aabb<S, N>> = true;
template <class S, int N>
inline constexpr bool is_solid<Obb<S, N>> = true;
template <class S, int N>
inline constexpr bool is_solid<Kdop<S, N>> = true;
template <class S>
inline constexpr bool is_solid<Frustum<S>> = true;
template <class S>
inline constexpr bool is_solid<Hull3<S>> = true;

template <class S, int N>
Ray<double, 3> in_space(const Ray<S, N>& x) {
  return {half_spaces::detail::in_space<S, N>(x.origin), half_spaces::detail::in_space<S, N>(x.direction),
          cast<double>(x.range)};
}
template <class S, int N>
Segment<double, 3> in_space(const Segment<S, N>& x) {
  return {half_spaces::detail::in_space<S, N>(x.p), half_spaces::detail::in_space<S, N>(x.q)};
}

template <class S>
Polygon<S, 2> polygon(const Triangle<S, 2>& x) {
  return {{{x.vertices[0], x.vertices[1], x.vertices[2]}}};
}
template <class S>
Polygon<S, 2> polygon(const Aabb<S, 2>& x) {
  if (empty(x)) return {};
  return {{{x.lo, {x.hi[0], x.lo[1]}, x.hi, {x.lo[0], x.hi[1]}}}};
}

}  // namespace detail

/// The pair has no test, or none in this order.
struct Untested {};

// Tests that say more than their overload, or have none. The last `in_order` finds the others.

template <class S, int N>
Answer in_order(const Point<S, N>& a, const Point<S, N>& b) {
  return answer(equal(a, b) ? Location::on : Location::out);
}
template <class S, int N>
Answer in_order(const Point<S, N>& a, const Plane<S, N>& b) {
  if (!finite(a) || !exists(b)) return {};
  const int where = side(b, a);
  return {.meet = where == 0, .side = where, .coplanar = where == 0};
}
template <class S>
Answer in_order(const Point<S, 3>& a, const Triangle<S, 3>& b) {
  return answer(intersects(Sphere<S, 3>{a, S(0)}, b) ? Location::on : Location::out);
}
template <class S>
Answer in_order(const Point<S, 3>& a, const TriangleMesh<S>& b) {
  if (point_mesh::closed(b)) return answer(locate(a, b));
  for (int i = 0; i < static_cast<int>(b.triangles.size()); ++i)
    if (intersects(Sphere<S, 3>{a, S(0)}, triangle(b, i))) return answer(Location::on);
  return {};  // nothing is inside
}
template <class S>
Answer in_order(const Segment<S, 2>& a, const Segment<S, 2>& b) {
  const SegmentSegment<S> shared = intersect(a, b);
  if (!shared) return {};
  return {.meet = true, .t = first_hit(a, Polygon<S, 2>{{{b.p, b.q}}}), .one_point = shared.point.has_value()};
}
template <class S, int N>
Answer in_order(const Plane<S, N>& a, const Plane<S, N>& b) {
  Answer out = answer(planes(a, b));
  out.parallel = exists(a) && exists(b) && out.relation != Relation::overlapping,
  out.coplanar = out.meet && out.parallel;
  return out;
}
template <class S, int N>
Answer in_order(const Plane<S, N>& a, const Capsule<S, N>& b) {
  return answer(plane_and_capsule(a, b));
}
template <class S, int N>
Answer in_order(const Plane<S, N>& a, const Triangle<S, N>& b) {
  return answer(corners<S, N>(a, b.vertices));
}
template <class S>
Answer in_order(const Plane<S, 2>& a, const Polygon<S, 2>& b) {
  Ring<S, 2> all;
  for (const Ring<S, 2>& ring : b.rings) all.insert(all.end(), ring.begin(), ring.end());
  return answer(corners<S, 2>(a, all));
}
template <class S>
Answer in_order(const Plane<S, 3>& a, const TriangulatedPolygon<S>& b) {
  return empty(b) ? Answer() : answer(corners<S, 3>(a, b.outline));
}
template <class S>
Answer in_order(const Plane<S, 3>& a, const TriangleMesh<S>& b) {
  std::vector<Point<S, 3>> all;
  for (const std::array<int, 3>& triangle : b.triangles)
    for (const int i : triangle) all.push_back(b.vertices[static_cast<std::size_t>(i)]);
  return answer(corners<S, 3>(a, all));
}
/// Reports both tangencies, from outside and from inside.
template <class S, int N>
Answer in_order(const Sphere<S, N>& a, const Sphere<S, N>& b) {
  Answer out = answer(relate(a, b));
  out.tangent = out.relation == Relation::touching;
  if (out.relation == Relation::a_inside_b || out.relation == Relation::b_inside_a)
    relate(a, b, [&](const auto& event) {
      if constexpr (std::is_same_v<std::remove_cvref_t<decltype(event)>, sphere_sphere::Decision>)
        out.tangent = event.inner == 0;
    });
  return out;
}
template <class S>
Answer in_order(const Triangle<S, 3>& a, const Triangle<S, 3>& b) {
  return answer(relate(solid_of(a), solid_of(b)));
}
template <class S, class B>
requires detail::is_round<B> Answer in_order(const Triangle<S, 3>& a, const B& b) {
  return answer(reversed(relate(b, solid_of(a))));
}
template <class S>
Answer in_order(const Polygon<S, 2>& a, const Sphere<S, 2>& b) {
  return answer(outline_and(a, Capsule<S, 2>{b.center, b.center, b.radius}));
}
template <class S>
Answer in_order(const Polygon<S, 2>& a, const Capsule<S, 2>& b) {
  return answer(outline_and(a, b));
}
template <class S>
Answer in_order(const Polygon<S, 2>& a, const HalfSpaces& b) {
  const std::optional<Relation> r = outline_and(a, b);
  return r ? answer(*r) : Answer{.meet = intersects(a, b)};
}
template <class S>
Answer in_order(const Triangle<S, 2>& a, const Triangle<S, 2>& b) {
  return answer(outlines(detail::polygon(a), detail::polygon(b)));
}
template <class S>
Answer in_order(const Polygon<S, 2>& a, const Triangle<S, 2>& b) {
  return answer(outlines(a, detail::polygon(b)));
}
template <class S>
Answer in_order(const Polygon<S, 2>& a, const Aabb<S, 2>& b) {
  return answer(outlines(a, detail::polygon(b)));
}

/// Calls the core's test of A and B in this order, if there is one.
template <class A, class B>
auto in_order(const A& a, const B& b) {
  if constexpr (detail::is_line<A> && detail::is_line<B>) {
    return answer(intersect(line_line::Straight(detail::in_space(a)), line_line::Straight(detail::in_space(b))));
  } else if constexpr (requires { relate(a, b); }) {
    Answer out = answer(relate(a, b));
    if constexpr (requires { first_hit(a, b); })
      if (out.meet) out.t = first_hit(a, b);
    return out;
  } else if constexpr (requires { answer(locate(a, b)); }) {
    return answer(locate(a, b));
  } else if constexpr (requires { answer(intersect(a, b)); }) {
    return answer(intersect(a, b));
  } else if constexpr (requires { answer(first_hit(a, b)); }) {
    return answer(first_hit(a, b));
  } else if constexpr (requires { answer(beside(a, b)); }) {
    return answer(beside(a, b));
  } else {
    return Untested();
  }
}

template <class A, class B>
inline constexpr bool has_test = !std::is_same_v<decltype(in_order(std::declval<A>(), std::declval<B>())), Untested>;

/// Calls the core's test of A and B in either order, or of what they count as, if there is one.
template <class A, class B>
auto in_any_order(const A& a, const B& b) {
  if constexpr (has_test<A, B>)
    return in_order(a, b);
  else if constexpr (has_test<B, A>)
    return reversed(in_order(b, a));
  else if constexpr (detail::is_solid<A>)
    return in_any_order(half_spaces_of(a), b);
  else if constexpr (detail::is_solid<B>)
    return in_any_order(a, half_spaces_of(b));
  else if constexpr (detail::is_plane_triangle<A>)
    return in_any_order(detail::polygon(a), b);
  else if constexpr (detail::is_plane_triangle<B>)
    return in_any_order(a, detail::polygon(b));
  else
    return Untested();
}

}  // namespace ask_pairs

/// Whether a test decides how an A and a B lie.
template <class A, class B>
inline constexpr bool is_decided =
    !std::is_same_v<decltype(ask_pairs::in_any_order(std::declval<A>(), std::declval<B>())), ask_pairs::Untested>;
template <class A, class... B>
inline constexpr bool is_decided<A, std::variant<B...>> = (is_decided<A, B> && ...);
template <class... A, class B>
inline constexpr bool is_decided<std::variant<A...>, B> = (is_decided<A, B> && ...);
template <class... A, class... B>
inline constexpr bool is_decided<std::variant<A...>, std::variant<B...>> = (is_decided<A, std::variant<B...>> && ...);

/// Returns the answer about A and B, in either order, by the core's own test of them, or of what they count as. Every
/// verdict is exact; empty shapes, NaN and infinite coordinates meet nothing. Does not compile for a pair that has no
/// test.
template <class A, class B>
requires is_decided<A, B> Answer ask(const A& a, const B& b) { return ask_pairs::in_any_order(a, b); }

/// What `ask` returns where one type, or both, are known only when the program runs: an Answer, or, where some pair of
/// their types has no test, a std::optional<Answer>, which is empty for such a pair.
template <class A, class B>
using AnswerOf = std::conditional_t<is_decided<A, B>, Answer, std::optional<Answer>>;

namespace ask_pairs {
template <class Result, class A, class B>
Result if_decided(const A& a, const B& b) {
  if constexpr (is_decided<A, B>)
    return ask(a, b);
  else
    return std::nullopt;
}
}  // namespace ask_pairs

template <class... A, class... B>
auto ask(const std::variant<A...>& a, const std::variant<B...>& b) {
  using Result = AnswerOf<std::variant<A...>, std::variant<B...>>;
  return std::visit([](const auto& x, const auto& y) { return ask_pairs::if_decided<Result>(x, y); }, a, b);
}
template <class A, class... B>
auto ask(const A& a, const std::variant<B...>& b) {
  using Result = AnswerOf<A, std::variant<B...>>;
  return std::visit([&](const auto& y) { return ask_pairs::if_decided<Result>(a, y); }, b);
}
template <class... A, class B>
auto ask(const std::variant<A...>& a, const B& b) {
  using Result = AnswerOf<std::variant<A...>, B>;
  return std::visit([&](const auto& x) { return ask_pairs::if_decided<Result>(x, b); }, a);
}

}  // namespace isect
