#pragma once
// Sphere against a convex solid given by half-spaces (isect/half_spaces.h): an oriented box, a k-DOP, a frustum, a
// hull.
//
// Most balls lie wholly beyond one face, or have their center in the solid. For the others, the distance of the center
// from the solid is compared with the radius by duality: isect/parts/inequality_distance.h. The ball lies in the solid
// iff its center is at least r inside each face, and the solid in the ball iff its corners do and it is bounded. All is
// compared squared and multiplied out.

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <variant>

#include <isect/half_spaces.h>
#include <isect/parts/inequality_distance.h>

namespace isect {

namespace sphere_half_spaces {

using Event = std::variant<Fallback>;

namespace detail {

/// The faces as seen from that point.
inline auto seen_from(const std::vector<half_spaces::Face>& faces, const Point<double, 3>& from) {
  return [&faces, from]<class W>(int i) -> inequalities::Row<W> {
    inequalities::Row<W> row = half_spaces::detail::row<W>(faces[static_cast<std::size_t>(i)]);
    row[3] = row[3] + dot(inequalities::detail::normal(row), exactly<W>(from));
    return row;
  };
}

/// The sign of the distance of a convex set from the solid less the radius, where that is plain: 1 if all that is
/// within the radius of the corners, which span the set, lies beyond one face; 0 or -1 if a corner lies in the solid.
template <std::size_t corners, class Trace>
std::optional<int> plain_reach(const std::array<Point<double, 3>, corners>& set, double r, const HalfSpaces& solid,
                               Trace&& trace) {
  std::array<bool, corners> in;
  in.fill(true);
  for (int i = 0; i < half_spaces::detail::count(solid.faces); ++i) {
    bool beyond = true;
    for (std::size_t k = 0; k < corners; ++k) {
      const auto row = [&]<class W>() -> inequalities::Row<W> {
        return seen_from(solid.faces, set[k]).template operator()<W>(i);
      };
      const auto height = [&]<class W>() -> W { return row.template operator()<W>()[3]; };
      const auto excess = [&]<class W>() -> W {
        const inequalities::Row<W> x = row.template operator()<W>();
        const Components<W, 3> n = inequalities::detail::normal(x);
        return x[3] * x[3] - W(r) * W(r) * dot(n, n);
      };
      const bool outside = sign_of<long_text>(height, trace) < 0;
      in[k] = in[k] && !outside;
      beyond = beyond && outside && (r == 0 || sign_of<long_text>(excess, trace) > 0);
    }
    if (beyond) return 1;
  }
  if (std::ranges::none_of(in, [](bool x) { return x; })) return {};
  return r > 0 ? -1 : 0;
}

/// Whether the ball lies in the solid.
template <class Trace>
bool contained(const Point<double, 3>& center, double r, const HalfSpaces& solid, Trace&& trace) {
  const auto rows = seen_from(solid.faces, center);
  for (int i = 0; i < half_spaces::detail::count(solid.faces); ++i) {
    if (sign_of<long_text>([&]<class W>() -> W { return rows.template operator()<W>(i)[3]; }, trace) < 0) return false;
    const auto room = [&]<class W>() -> W {
      const inequalities::Row<W> row = rows.template operator()<W>(i);
      const Components<W, 3> n = inequalities::detail::normal(row);
      return row[3] * row[3] - W(r) * W(r) * dot(n, n);
    };
    if (sign_of<long_text>(room, trace) < 0) return false;
  }
  return true;
}

/// Returns the faces, and for a solid in the plane the plane itself as well, so that there are corners.
inline std::vector<half_spaces::Face> with_corners(const HalfSpaces& solid) {
  std::vector<half_spaces::Face> faces = solid.faces;
  if (solid.dimension == 2) faces.push_back({half_spaces::Level{Vector<double, 3>::UnitZ(), 0}});
  return faces;
}

template <class Trace>
bool bounded(const HalfSpaces& solid, Trace&& trace) {
  return inequalities::bounded(half_spaces::detail::count(solid.faces), solid.dimension,
                               half_spaces::detail::text_of(solid.faces), trace);
}

/// The sign of the center's distance from the solid less the radius; 1 for a solid without a point.
template <class Trace>
int reach(const Point<double, 3>& center, double r, const HalfSpaces& solid, Trace&& trace) {
  if (const std::optional<int> plain = plain_reach(std::array{center}, r, solid, trace)) return *plain;
  if (!has_a_point(solid, trace)) return 1;
  return inequalities::distance(half_spaces::detail::count(solid.faces), seen_from(solid.faces, center), r, trace);
}

}  // namespace detail

}  // namespace sphere_half_spaces

/// How the ball (A) and the solid lie. Exact, for a solid without a volume, too; a ball of radius 0 is a point. What is
/// empty, NaN or infinite is disjoint from all.
template <class S, int N, class Trace = NoTrace>
Relation relate(const Sphere<S, N>& sphere, const HalfSpaces& solid, Trace&& trace = {}) {
  if (empty(sphere) || !finite(sphere)) return Relation::disjoint;
  const Point<double, 3> center = half_spaces::detail::in_space<S, N>(sphere.center);
  const double r = sphere.radius;
  const int reach = sphere_half_spaces::detail::reach(center, r, solid, trace);
  if (reach > 0) return Relation::disjoint;

  const bool a_in_b = sphere_half_spaces::detail::contained(center, r, solid, trace);
  const std::vector<half_spaces::Face> faces = sphere_half_spaces::detail::with_corners(solid);
  const auto held = [&](const auto& corner, const auto& scale) {
    return sign_of<long_text>(
               [&]<class W>() -> W {
                 const Components<W, 3> x = corner.template operator()<W>();
                 const W d = scale.template operator()<W>();
                 return dot(x, x) - W(r) * W(r) * (d * d);
               },
               trace) <= 0;
  };
  const bool b_in_a = inequalities::all_corners(half_spaces::detail::count(faces),
                                                sphere_half_spaces::detail::seen_from(faces, center), held, trace) &&
                      sphere_half_spaces::detail::bounded(solid, trace);
  if (a_in_b) return b_in_a ? Relation::equal : Relation::a_inside_b;
  if (b_in_a) return Relation::b_inside_a;
  return reach == 0 ? Relation::touching : Relation::overlapping;
}

/// Whether they have a common point. Exact.
template <class S, int N, class Trace = NoTrace>
bool intersects(const Sphere<S, N>& sphere, const HalfSpaces& solid, Trace&& trace = {}) {
  if (empty(sphere) || !finite(sphere)) return false;
  const Point<double, 3> center = half_spaces::detail::in_space<S, N>(sphere.center);
  return sphere_half_spaces::detail::reach(center, static_cast<double>(sphere.radius), solid, trace) <= 0;
}

}  // namespace isect
