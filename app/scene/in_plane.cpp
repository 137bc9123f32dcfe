#include "app/scene/in_plane.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <isect/numbers/exact.h>

namespace isect::program::scene {

namespace {

using Exact3 = std::array<Exact, 3>;
using Exact2 = std::array<Exact, 2>;

Exact3 difference(const Point<double, 3>& a, const Point<double, 3>& b) {
  return {Exact(a[0]) - Exact(b[0]), Exact(a[1]) - Exact(b[1]), Exact(a[2]) - Exact(b[2])};
}
Exact cross(const Exact2& a, const Exact2& b) { return a[0] * b[1] - a[1] * b[0]; }
Exact dot(const Exact2& a, const Exact2& b) { return a[0] * b[0] + a[1] * b[1]; }
Exact2 operator-(const Exact2& a, const Exact2& b) { return {a[0] - b[0], a[1] - b[1]}; }
Exact dot(const Exact3& a, const Exact3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Exact3 normal_of(const Ring<double, 3>& outline) {
  Exact3 n;
  for (std::size_t i = 1; i + 1 < outline.size(); ++i) {
    const Exact3 a = difference(outline[i], outline[0]), b = difference(outline[i + 1], outline[0]);
    for (int k = 0; k < 3; ++k) n[k] = n[k] + a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
  }
  return n;
}

/// The sign of the place less t.
int beyond(const Place& place, double t) { return std::isinf(t) ? (t < 0 ? 1 : -1) : compare(place, place_at(t)); }

/// Its corners, from the ray's origin.
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

class InPlane {
 public:
  InPlane(const Interval<double>& range, Exact2 direction, std::vector<Outline> outlines)
      : range_(range), direction_(std::move(direction)), outlines_(std::move(outlines)) {}

  std::optional<Place> first() {
    if (!(range_.lo <= range_.hi) || range_.lo == HUGE_VAL || range_.hi == -HUGE_VAL) return {};
    if (direction_[0].sign() != 0 || direction_[1].sign() != 0)
      for (const Outline& o : outlines_)
        for (std::size_t i = 0; i < o.size(); ++i) edge(o[i], o[(i + 1) % o.size()]);
    if (std::isfinite(range_.lo) && starts_inside()) return place_at(range_.lo);
    return first_;
  }

 private:
  void edge(const Exact2& a, const Exact2& b) {
    const Exact side_a = cross(direction_, a), side_b = cross(direction_, b);
    if (side_a.sign() * side_b.sign() > 0) return;
    if (side_a.sign() == 0 && side_b.sign() == 0) {  // along the ray
      const Exact length = dot(direction_, direction_);
      Place from = quotient_at(dot(a, direction_), length), to = quotient_at(dot(b, direction_), length);
      if (compare(from, to) > 0) std::swap(from, to);
      if (beyond(to, range_.lo) < 0 || beyond(from, range_.hi) > 0) return;
      take(beyond(from, range_.lo) < 0 ? place_at(range_.lo) : from);
      return;
    }
    const Place at = quotient_at(cross(a, b - a), side_b - side_a);
    if (beyond(at, range_.lo) >= 0 && beyond(at, range_.hi) <= 0) take(at);
  }

  void take(const Place& place) {
    if (!first_ || compare(place, *first_) < 0) first_ = place;
  }

  /// At the range's lower end.
  bool starts_inside() const {
    const Exact2 p = {Exact(range_.lo) * direction_[0], Exact(range_.lo) * direction_[1]};
    std::vector<Outline> from_there = outlines_;
    for (Outline& o : from_there)
      for (Exact2& corner : o) corner = corner - p;
    return location_of_origin(from_there) != Location::out;
  }

  Interval<double> range_;
  Exact2 direction_;
  std::vector<Outline> outlines_;
  std::optional<Place> first_;
};

Exact2 difference(const Point<double, 2>& a, const Point<double, 2>& b) {
  return {Exact(a[0]) - Exact(b[0]), Exact(a[1]) - Exact(b[1])};
}

std::vector<Outline> seen_from(const Point<double, 2>& origin, const std::vector<Ring<double, 2>>& rings) {
  std::vector<Outline> all;
  for (const Ring<double, 2>& ring : rings) {
    all.emplace_back();
    for (const Point<double, 2>& v : ring) all.back().push_back(difference(v, origin));
  }
  return all;
}

}  // namespace

Projection projection(const Ring<double, 3>& outline) {
  const Exact3 n = normal_of(outline);
  int axis = 0;
  for (int i = 1; i < 3; ++i)
    if ((abs(n[i]) - abs(n[axis])).sign() > 0) axis = i;
  return {(axis + 1) % 3, (axis + 2) % 3, n[axis].sign() < 0};
}

std::optional<Place> place_in_plane(const Point<double, 3>& origin, const Exact3& direction,
                                    const Interval<double>& range, const Ring<double, 3>& outline) {
  const auto [x, y, clockwise] = projection(outline);
  Outline corners;
  for (const Point<double, 3>& v : outline) {
    const Exact3 from_origin = difference(v, origin);
    corners.push_back({from_origin[x], from_origin[y]});
  }
  return InPlane(range, {direction[x], direction[y]}, {corners}).first();
}

std::optional<Place> place_in_plane(const Point<double, 2>& origin, const Exact2& direction,
                                    const Interval<double>& range, const std::vector<Ring<double, 2>>& outlines) {
  return InPlane(range, direction, seen_from(origin, outlines)).first();
}

Crossing crossing_of_plane(const Point<double, 3>& origin, const Exact3& direction, const Ring<double, 3>& outline) {
  const Exact3 n = normal_of(outline);
  return {dot(n, difference(outline[0], origin)), dot(n, direction)};
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
  const Exact3 n = normal_of(outline);
  const Exact length = sqrt(dot(n, n));
  double farthest = 0;
  for (const Point<double, 3>& v : outline) {
    const Exact height = dot(n, difference(v, outline[0]));
    if (height.sign() == 0) continue;
    farthest = std::max({farthest, near_quotient(abs(height), length), std::numeric_limits<double>::denorm_min()});
  }
  return farthest;
}

}  // namespace isect::program::scene
