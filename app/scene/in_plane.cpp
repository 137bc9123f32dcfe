#include "app/scene/in_plane.h"

#include <algorithm>
#include <limits>
#include <vector>

#include <isect/segment_polygon.h>

namespace isect::program::scene {

namespace {

using Exact2 = Components<Exact, 2>;

Exact cross(const Exact2& a, const Exact2& b) { return a[0] * b[1] - a[1] * b[0]; }
Exact2 operator-(const Exact2& a, const Exact2& b) { return {a[0] - b[0], a[1] - b[1]}; }

/// Its corners.
using Outline = std::vector<Exact2>;

/// Where the origin lies, by the edges right of it.
Location location_of_origin(const std::vector<Outline>& outlines) {
  bool inside = false;
  for (const Outline& o : outlines)
    for (std::size_t i = 0; i < o.size(); ++i) {
      const Exact2 &a = o[i], &b = o[(i + 1) % o.size()];
      const int turn = cross(a, b).sign();
      if (turn == 0 && dot(a, b).sign() <= 0) return Location::on;
      const bool rises = a[1].sign() <= 0 && b[1].sign() > 0, falls = a[1].sign() > 0 && b[1].sign() <= 0;
      if ((rises && turn > 0) || (falls && turn < 0)) inside = !inside;
    }
  return inside ? Location::in : Location::out;
}

}  // namespace

Projection projection(const Ring<double, 3>& outline) {
  const int axis = segment_polygon::detail::steepest(outline);
  const auto along = [&]<class W>() -> W {
    return segment_polygon::detail::normal<W>(outline)[static_cast<std::size_t>(axis)];
  };
  return {(axis + 1) % 3, (axis + 2) % 3, sign_of(along) < 0};
}

Location locate_corner(const Kdop<double, 2>& kdop, const std::vector<Ring<double, 2>>& outlines) {
  const auto normal = [&](std::size_t i) -> Exact2 { return {Exact(kdop.normals[i][0]), Exact(kdop.normals[i][1])}; };
  for (std::size_t i = 0; i < kdop.slabs.size(); ++i)
    for (std::size_t j = i + 1; j < kdop.slabs.size(); ++j) {
      const Exact2 m = normal(i), n = normal(j);
      const Exact w = cross(m, n);
      if (w.sign() == 0) continue;
      for (const double c : {kdop.slabs[i].lo, kdop.slabs[i].hi})
        for (const double d : {kdop.slabs[j].lo, kdop.slabs[j].hi}) {
          const Exact2 x = {Exact(c) * n[1] - m[1] * Exact(d), m[0] * Exact(d) - Exact(c) * n[0]};  // times w
          const auto holds = [&](std::size_t k) {
            const Exact at = dot(normal(k), x);
            return (at - Exact(kdop.slabs[k].lo) * w).sign() * w.sign() >= 0 &&
                   (at - Exact(kdop.slabs[k].hi) * w).sign() * w.sign() <= 0;
          };
          bool corner = true;
          for (std::size_t k = 0; k < kdop.slabs.size() && corner; ++k) corner = k == i || k == j || holds(k);
          if (!corner) continue;
          std::vector<Outline> from_there;
          for (const Ring<double, 2>& ring : outlines) {
            from_there.emplace_back();
            for (const Point<double, 2>& v : ring)
              from_there.back().push_back(Exact2{Exact(v[0]) * w, Exact(v[1]) * w} - x);
          }
          return location_of_origin(from_there);
        }
    }
  return Location::out;
}

double off_plane(const Ring<double, 3>& outline) {
  const Components<Exact, 3> n = segment_polygon::detail::normal<Exact>(outline);
  const Exact length = sqrt(dot(n, n));
  double farthest = 0;
  for (const Point<double, 3>& v : outline) {
    const Exact height = dot(n, difference<Exact>(v, outline[0]));
    if (height.sign() == 0) continue;
    farthest = std::max({farthest, near_quotient(abs(height), length), std::numeric_limits<double>::denorm_min()});
  }
  return farthest;
}

}  // namespace isect::program::scene
