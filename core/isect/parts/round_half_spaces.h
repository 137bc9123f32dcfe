#pragma once
// A cylinder or a cone (isect/parts/round_solid.h) against a convex solid P given by half-spaces (isect/half_spaces.h).
//
// Look along the axis d: at a cone from its apex, at a cylinder from infinitely far away. Among all points between the
// planes of both ends those in the round solid are just those that hide a point of the disc at its far end, or lie in
// it. So it meets P iff that disc meets the shadow that is cast on its plane by the part of P between the planes. (What
// lies in the plane of a cone's apex casts none; whether P holds the apex is tested apart.)
//
// The shadow. Let P's faces, and both planes, be a_i.x + w_i >= 0, let b_i be the value there of the disc's center, and
// let y lead from the center to a point of the disc's plane. On the way from that point to the eye a_i.x + w_i changes
// like a_i.y + b_i + t g_i, with
//
//   cylinder   g_i = -a_i.d,      cone   g_i = b_i - a_i.d,   where all is divided by 1 + t.
//
// So the point lies in the shadow iff some t satisfies all, that is, iff (Fourier, Motzkin)
//
//   a_i.y + b_i >= 0 where g_i = 0,   and   g_i (a_j.y + b_j) - g_j (a_i.y + b_i) >= 0 where g_i > 0 > g_j.
//
// Only those of the latter matter whose two faces share a point of P between the planes: elsewhere both are never 0 at
// once, so that no point of the shadow reaches the limit. As y is perpendicular to d, only the part of a normal a that
// is so counts; turned by a right angle, that is a x d / |d|. So with the normals a x d, in the plane,
// isect/parts/inequality_distance.h finds how far the shadow is from the center, over |d|; squared, that is compared
// with r^2 / d.d.
//
// Interiors. What hides a point within the disc's rim, and lies strictly between the planes, is the interior of the
// round solid. It has a point of P iff the shadow has one within the rim, and the part of P between the planes is not
// all in one of them: if a point of P hides one within the rim, but lies in such a plane, those near it on the way to a
// point of P that does not are interior.
//
// The round solid lies in P iff both its discs do, by their lowest points over each face (isect/parts/plane_round.h),
// and P in the round solid iff its corners do and it is bounded. Of radius 0 it is a segment.
//
// Source: Schrijver, Theory of Linear and Integer Programming (1986), 12.2, for the elimination of t.

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <isect/capsule_half_spaces.h>
#include <isect/parts/round_solid.h>

namespace isect::round_half_spaces {

/// The sign of the distance of the disc's center from the shadow less the radius.
struct Shadow {
  int reach;
};
/// relate: whether the round solid lies in the other, the other in it.
struct Contained {
  bool round, other;
};
using Event = std::variant<Shadow, Contained, Fallback>;

namespace detail {

using half_spaces::Face;
using round_solid::axis, round_solid::Disc;

template <class Solid>
inline constexpr bool has_apex = std::is_same_v<Solid, Cone<double>>;

/// The half-space that begins at that end of the axis and holds the other.
template <class Solid>
Face beyond(const Solid& solid, std::size_t end) {
  const std::array<Disc, 2> discs = round_solid::discs(solid);
  return {half_spaces::Beyond{discs[end].center, discs[1 - end].center}};
}

/// g of a row that is seen from the center of the disc.
template <PolynomialScalar W, class Solid>
W at_eye(const inequalities::Row<W>& row, const Solid& solid) {
  const W fall = dot(inequalities::detail::normal(row), axis<W>(solid));
  if constexpr (has_apex<Solid>)
    return row[3] - fall;
  else
    return -fall;
}

/// The sign of the distance of the center from the shadow less the radius, which is above 0. `between` lies between the
/// planes and casts a shadow.
template <class Solid, class Trace>
int reach(const Solid& solid, const HalfSpaces& between, Trace&& trace) {
  const Disc disc = round_solid::discs(solid)[1];
  const auto rows = sphere_half_spaces::detail::seen_from(between.faces, disc.center);
  std::vector<int> grow, fall;
  std::vector<std::pair<int, int>> edges;
  for (int i = 0; i < half_spaces::detail::count(between.faces); ++i) {
    const int sign =
        sign_of<long_text>([&]<class W>() -> W { return at_eye<W>(rows.template operator()<W>(i), solid); }, trace);
    if (sign == 0) edges.emplace_back(i, i);
    if (sign > 0) grow.push_back(i);
    if (sign < 0) fall.push_back(i);
  }
  const bool few = grow.size() * fall.size() <= 16;  // as for a box: asking would cost more than it saves
  for (const int i : grow)
    for (const int j : fall)
      if (few || capsule_half_spaces::detail::share_a_point(between, i, j, trace)) edges.emplace_back(i, j);

  const auto shadow = [&]<class W>(int k) -> inequalities::Row<W> {
    const auto [i, j] = edges[static_cast<std::size_t>(k)];
    inequalities::Row<W> row = rows.template operator()<W>(i);
    if (i != j) {
      const inequalities::Row<W> other = rows.template operator()<W>(j);
      const W g = at_eye<W>(row, solid), h = at_eye<W>(other, solid);
      for (std::size_t m = 0; m < 4; ++m) row[m] = g * other[m] - h * row[m];
    }
    const Components<W, 3> turned = cross(inequalities::detail::normal(row), axis<W>(solid));
    return {turned[0], turned[1], turned[2], row[3]};
  };
  const auto excess = [&]<class W>(const W& square, const W& scale) -> W {
    const Components<W, 3> d = axis<W>(solid);
    return square * dot(d, d) - W(disc.radius) * W(disc.radius) * scale;
  };
  return inequalities::distance(static_cast<int>(edges.size()), 2, shadow, true, excess, trace);
}

/// The sign of a_i.x + w_i at the disc's point over face i where it is highest, 1, or lowest, -1.
template <class Solid, class Trace>
int extreme(const Solid& solid, const Disc& disc, const HalfSpaces& other, std::size_t i, int way, Trace&& trace) {
  const auto row = [&]<class W>() -> inequalities::Row<W> {
    return sphere_half_spaces::detail::seen_from(other.faces, disc.center).template operator()<W>(static_cast<int>(i));
  };
  const int center = sign_of<long_text>([&]<class W>() -> W { return row.template operator()<W>()[3]; }, trace);
  if (center == way || disc.radius == 0) return center;
  return way * sign_of<long_text>(
                   [&]<class W>() -> W {
                     const inequalities::Row<W> seen = row.template operator()<W>();
                     const Components<W, 3> d = axis<W>(solid), across = cross(inequalities::detail::normal(seen), d);
                     return W(disc.radius) * W(disc.radius) * dot(across, across) - seen[3] * seen[3] * dot(d, d);
                   },
                   trace);
}
/// Whether all of the round solid is outside face i.
template <class Solid, class Trace>
bool beyond_face(const Solid& solid, const HalfSpaces& other, std::size_t i, Trace&& trace) {
  return std::ranges::all_of(round_solid::discs(solid),
                             [&](const Disc& disc) { return extreme(solid, disc, other, i, 1, trace) < 0; });
}
/// Whether the round solid lies in the other.
template <class Solid, class Trace>
bool contained(const Solid& solid, const HalfSpaces& other, Trace&& trace) {
  for (const Disc& disc : round_solid::discs(solid))
    for (std::size_t i = 0; i < other.faces.size(); ++i)
      if (extreme(solid, disc, other, i, -1, trace) < 0) return false;
  return true;
}

/// 1: they have no common point. 0: one, but none interior to the round solid. -1: one that is. The radius is above 0.
template <class Solid, class Trace>
int meeting(const Solid& solid, const HalfSpaces& other, Trace&& trace) {
  for (std::size_t i = 0; i < other.faces.size(); ++i)  // most are beyond one
    if (beyond_face(solid, other, i, trace)) return 1;
  HalfSpaces between = other;
  for (const std::size_t end : {0, 1}) between.faces.push_back(beyond(solid, end));
  if (!has_a_point(between, trace)) return 1;
  const auto all_in_plane = [&](std::size_t end) {
    Face outside = beyond(solid, end);
    outside.turned = true;
    return half_spaces::detail::inside(between, {outside}, trace);
  };
  const bool at_start = all_in_plane(0);
  const int least = has_apex<Solid> && locate(round_solid::start(solid), other, trace) != Location::out ? 0 : 1;
  if (has_apex<Solid> && at_start) return least;
  const int reached = reach(solid, between, trace);
  trace(Shadow{reached});
  if (reached >= 0) return std::min(least, reached);
  return at_start || all_in_plane(1) ? 0 : -1;
}

/// Whether the other lies in the round solid.
template <class Solid, class Trace>
bool holds(const Solid& solid, const HalfSpaces& other, Trace&& trace) {
  const std::vector<Face> faces = sphere_half_spaces::detail::with_corners(other);
  const auto held = [&](const auto& corner, const auto& scale) {  // the corner is x / k as seen from the start
    const auto along = [&]<class W>(bool left) -> W {
      const Components<W, 3> d = axis<W>(solid);
      const W k = scale.template operator()<W>(), place = k * dot(corner.template operator()<W>(), d);
      return left ? k * k * dot(d, d) - place : place;
    };
    for (const bool left : {false, true})
      if (sign_of<long_text>([&]<class W>() -> W { return along.template operator()<W>(left); }, trace) < 0)
        return false;
    return sign_of<long_text>(
               [&]<class W>() -> W {
                 return round_solid::beside<W>(solid, corner.template operator()<W>(), scale.template operator()<W>());
               },
               trace) <= 0;
  };
  return inequalities::all_corners(half_spaces::detail::count(faces),
                                   sphere_half_spaces::detail::seen_from(faces, round_solid::start(solid)), held,
                                   trace) &&
         sphere_half_spaces::detail::bounded(other, trace);
}

/// Returns the axis, a segment, as half-spaces.
template <class Solid>
HalfSpaces segment(const Solid& solid, int dimension) {
  const std::array<Disc, 2> discs = round_solid::discs(solid);
  return half_spaces::detail::segment(discs[0].center, discs[1].center, dimension);
}

template <class Solid, class Trace>
bool meet(const Solid& solid, const HalfSpaces& other, Trace&& trace) {
  if (!round_solid::exists(solid)) return false;
  if (solid.radius == 0) return intersects(segment(solid, other.dimension), other, trace);
  return meeting(solid, other, trace) <= 0;
}

template <class Solid, class Trace>
Relation relation(const Solid& solid, const HalfSpaces& other, Trace&& trace) {
  if (!round_solid::exists(solid)) return Relation::disjoint;
  if (solid.radius == 0) return relate(segment(solid, other.dimension), other, trace);
  const int met = meeting(solid, other, trace);
  if (met > 0) return Relation::disjoint;
  const Contained inside = {contained(solid, other, trace), holds(solid, other, trace)};
  trace(inside);
  if (inside.round) return Relation::a_inside_b;
  if (inside.other) return Relation::b_inside_a;
  return met == 0 ? Relation::touching : Relation::overlapping;
}

}  // namespace detail

}  // namespace isect::round_half_spaces
