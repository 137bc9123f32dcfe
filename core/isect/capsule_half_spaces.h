#pragma once
// Capsule against a convex solid given by half-spaces (isect/half_spaces.h): a box, an oriented box, a k-DOP, a
// frustum.
//
// Most capsules lie wholly beyond one face, or their segment passes through the solid. The others need more:
//
// The capsule is the ball that moves from p to q. It meets the solid iff the ball at p meets what the solid sweeps
// moving from q to p, which is convex again: its half-spaces follow from those of the solid by eliminating the time t
// of 0 <= t <= 1 (Fourier, Motzkin). With d = q - p and s_i = a_i.d they are, as seen from p,
//
//   a_i.y + w_i + max(0, s_i) >= 0,   and   s_i (a_j.y + w_j) - s_j (a_i.y + w_i) >= 0   where s_i > 0 > s_j.
//
// Only those of the latter matter whose two faces share a point of the solid: elsewhere both sides are never 0 at once,
// so that nothing that is swept reaches the limit.
//
// So the ball's test decides (isect/sphere_half_spaces.h). Source: Schrijver, Theory of Linear and Integer Programming
// (1986), 12.2.

#include <array>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include <isect/ray_half_spaces.h>
#include <isect/sphere_half_spaces.h>

namespace isect {

namespace capsule_half_spaces {

using Event = std::variant<Fallback>;

namespace detail {

/// How fast face i is approached, on the way from p to q.
template <PolynomialScalar W, class Rows>
W speed(const Rows& rows, int i, const Capsule<double, 3>& capsule) {
  return dot(inequalities::detail::normal(rows.template operator()<W>(i)), difference<W>(capsule.q, capsule.p));
}

/// Whether a point of the solid lies on both faces.
template <class Trace>
bool share_a_point(const HalfSpaces& solid, int i, int j, Trace&& trace) {
  std::vector<half_spaces::Face> faces = solid.faces;
  for (const int k : {i, j}) {
    half_spaces::Face face = solid.faces[static_cast<std::size_t>(k)];
    face.turned = !face.turned;
    faces.push_back(face);
  }
  return half_spaces::detail::have_a_point(faces, trace);
}

/// The sign of the distance of the capsule's segment from the solid, which is not empty, less the radius.
template <class Trace>
int distance(const Capsule<double, 3>& capsule, const HalfSpaces& solid, Trace&& trace) {
  const auto rows = sphere_half_spaces::detail::seen_from(solid.faces, capsule.p);
  std::vector<int> approached, left;
  const int count = half_spaces::detail::count(solid.faces);
  std::vector<char> at_q;
  for (int i = 0; i < count; ++i) {
    const int sign = sign_of<long_text>([&]<class W>() -> W { return speed<W>(rows, i, capsule); }, trace);
    if (sign > 0) approached.push_back(i);
    if (sign < 0) left.push_back(i);
    at_q.push_back(sign > 0);
  }
  std::vector<std::pair<int, int>> between;
  const bool few = approached.size() * left.size() <= 9;  // as for a box: asking would cost more than it saves
  for (const int i : approached)
    for (const int j : left)
      if (few || share_a_point(solid, i, j, trace)) between.emplace_back(i, j);

  const auto swept = [&]<class W>(int k) -> inequalities::Row<W> {
    if (k < count) {
      inequalities::Row<W> row = rows.template operator()<W>(k);
      if (at_q[static_cast<std::size_t>(k)]) row[3] = row[3] + speed<W>(rows, k, capsule);
      return row;
    }
    const auto [i, j] = between[static_cast<std::size_t>(k - count)];
    const inequalities::Row<W> x = rows.template operator()<W>(i), y = rows.template operator()<W>(j);
    const W towards = speed<W>(rows, i, capsule), away = speed<W>(rows, j, capsule);
    inequalities::Row<W> row;
    for (std::size_t m = 0; m < 4; ++m) row[m] = towards * y[m] - away * x[m];
    return row;
  };
  return inequalities::distance(count + static_cast<int>(between.size()), swept, capsule.radius, trace);
}

/// Returns what `distance` does; 1 for a solid without a point.
template <class Trace>
int reach(const Capsule<double, 3>& capsule, const HalfSpaces& solid, Trace&& trace) {
  const auto& [p, q, r] = capsule;
  if (const auto plain = sphere_half_spaces::detail::plain_reach(std::array{p, q}, r, solid, trace)) return *plain;
  if (intersect(Segment<double, 3>{p, q}, solid, trace)) return r > 0 ? -1 : 0;
  return has_a_point(solid, trace) ? distance(capsule, solid, trace) : 1;
}

/// Whether the solid lies in the capsule: each corner within r of the segment.
template <class Trace>
bool holds(const Capsule<double, 3>& capsule, const HalfSpaces& solid, Trace&& trace) {
  const std::vector<half_spaces::Face> faces = sphere_half_spaces::detail::with_corners(solid);
  const auto held = [&](const auto& corner, const auto& scale) {
    // The corner is x / k as seen from p; all is multiplied by k, or by k^2
    const auto along = [&]<class W>(bool left) -> W {
      const Components<W, 3> d = difference<W>(capsule.q, capsule.p), x = corner.template operator()<W>();
      const W k = scale.template operator()<W>(), place = k * dot(x, d);
      return left ? k * k * dot(d, d) - place : place;
    };
    const auto place = [&](bool left) {
      return sign_of<long_text>([&]<class W>() -> W { return along.template operator()<W>(left); }, trace);
    };
    const bool at_p = place(false) <= 0, at_end = at_p || place(true) <= 0;
    return sign_of<long_text>(
               [&]<class W>() -> W {
                 const Components<W, 3> d = difference<W>(capsule.q, capsule.p);
                 Components<W, 3> x = corner.template operator()<W>();
                 const W k = scale.template operator()<W>(), reach2 = W(capsule.radius) * W(capsule.radius) * (k * k);
                 if (!at_end) {
                   const Components<W, 3> n = cross(x, d);
                   return dot(n, n) - reach2 * dot(d, d);
                 }
                 if (!at_p)
                   for (std::size_t i = 0; i < 3; ++i) x[i] = x[i] - k * d[i];
                 return dot(x, x) - reach2;
               },
               trace) <= 0;
  };
  return inequalities::all_corners(half_spaces::detail::count(faces),
                                   sphere_half_spaces::detail::seen_from(faces, capsule.p), held, trace) &&
         sphere_half_spaces::detail::bounded(solid, trace);
}

template <class S, int N>
Capsule<double, 3> in_space(const Capsule<S, N>& capsule) {
  return {half_spaces::detail::in_space<S, N>(capsule.p), half_spaces::detail::in_space<S, N>(capsule.q),
          static_cast<double>(capsule.radius)};
}

}  // namespace detail

}  // namespace capsule_half_spaces

/// Whether they have a common point. Exact. What is empty, NaN or infinite meets nothing.
template <class S, int N, class Trace = NoTrace>
bool intersects(const Capsule<S, N>& capsule, const HalfSpaces& solid, Trace&& trace = {}) {
  if (empty(capsule) || !finite(capsule)) return false;
  return capsule_half_spaces::detail::reach(capsule_half_spaces::detail::in_space<S, N>(capsule), solid, trace) <= 0;
}

/// How the capsule (A) and the solid lie. Exact, for a solid without a volume, too; a capsule of radius 0 is a segment.
/// What is empty, NaN or infinite is disjoint from all.
template <class S, int N, class Trace = NoTrace>
Relation relate(const Capsule<S, N>& capsule, const HalfSpaces& solid, Trace&& trace = {}) {
  if (empty(capsule) || !finite(capsule)) return Relation::disjoint;
  const Capsule<double, 3> wide = capsule_half_spaces::detail::in_space<S, N>(capsule);
  if (wide.radius == 0) return relate(half_spaces::detail::segment(wide.p, wide.q, solid.dimension), solid, trace);
  const int reach = capsule_half_spaces::detail::reach(wide, solid, trace);
  if (reach > 0) return Relation::disjoint;

  const bool a_in_b = sphere_half_spaces::detail::contained(wide.p, wide.radius, solid, trace) &&
                      sphere_half_spaces::detail::contained(wide.q, wide.radius, solid, trace);
  const bool b_in_a = capsule_half_spaces::detail::holds(wide, solid, trace);
  if (a_in_b) return b_in_a ? Relation::equal : Relation::a_inside_b;
  if (b_in_a) return Relation::b_inside_a;
  return reach == 0 ? Relation::touching : Relation::overlapping;
}

}  // namespace isect
