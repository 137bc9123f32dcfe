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

Exact3 normal_of(const Ring<double, 3>& outline) {
  Exact3 n;
  for (std::size_t i = 1; i + 1 < outline.size(); ++i) {
    const Exact3 a = difference(outline[i], outline[0]), b = difference(outline[i + 1], outline[0]);
    for (int k = 0; k < 3; ++k) n[k] = n[k] + a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
  }
  return n;
}

/// A place on the ray, num / den, den > 0.
struct Place {
  Exact num, den;

  Place(Exact n, Exact d) : num(std::move(n)), den(std::move(d)) {
    if (den.sign() < 0) num = -num, den = -den;
  }
  /// The sign of this place less the other.
  int beyond(const Place& other) const { return (num * other.den - other.num * den).sign(); }
  int beyond(double t) const { return std::isinf(t) ? (t < 0 ? 1 : -1) : beyond(Place(Exact(t), Exact(1.0))); }
};

/// Its corners, from the ray's origin.
using Outline = std::vector<Exact2>;

class InPlane {
 public:
  InPlane(const Interval<double>& range, Exact2 direction, std::vector<Outline> outlines)
      : range_(range), direction_(std::move(direction)), outlines_(std::move(outlines)) {}

  std::optional<double> first() {
    if (!(range_.lo <= range_.hi) || range_.lo == HUGE_VAL || range_.hi == -HUGE_VAL) return {};
    for (const Outline& o : outlines_)
      for (std::size_t i = 0; i < o.size(); ++i) edge(o[i], o[(i + 1) % o.size()]);
    if (std::isfinite(range_.lo) && starts_inside()) return range_.lo;
    if (!first_) return {};
    return std::clamp(quotient(first_->num, first_->den), range_.lo, range_.hi);
  }

 private:
  void edge(const Exact2& a, const Exact2& b) {
    const Exact side_a = cross(direction_, a), side_b = cross(direction_, b);
    if (side_a.sign() * side_b.sign() > 0) return;
    if (side_a.sign() == 0 && side_b.sign() == 0) {  // along the ray
      const Exact length = dot(direction_, direction_);
      Place from(dot(a, direction_), length), to(dot(b, direction_), length);
      if (from.beyond(to) > 0) std::swap(from, to);
      if (to.beyond(range_.lo) < 0 || from.beyond(range_.hi) > 0) return;
      take(from.beyond(range_.lo) < 0 ? Place(Exact(range_.lo), Exact(1.0)) : from);
      return;
    }
    const Place at(cross(a, b - a), side_b - side_a);
    if (at.beyond(range_.lo) >= 0 && at.beyond(range_.hi) <= 0) take(at);
  }

  void take(const Place& place) {
    if (!first_ || place.beyond(*first_) < 0) first_ = place;
  }

  /// By the edges right of the range's lower end; on the boundary any answer does, as that is an edge's.
  bool starts_inside() const {
    const Exact2 p = {Exact(range_.lo) * direction_[0], Exact(range_.lo) * direction_[1]};
    bool inside = false;
    for (const Outline& o : outlines_)
      for (std::size_t i = 0; i < o.size(); ++i) {
        const Exact2 a = o[i] - p, b = o[(i + 1) % o.size()] - p;
        const bool rises = a[1].sign() <= 0 && b[1].sign() > 0, falls = a[1].sign() > 0 && b[1].sign() <= 0;
        if ((rises && cross(a, b).sign() > 0) || (falls && cross(a, b).sign() < 0)) inside = !inside;
      }
    return inside;
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

std::optional<double> first_in_plane(const Ray<double, 3>& ray, const Ring<double, 3>& outline) {
  const auto [x, y, clockwise] = projection(outline);
  Outline corners;
  for (const Point<double, 3>& v : outline) {
    const Exact3 from_origin = difference(v, ray.origin);
    corners.push_back({from_origin[x], from_origin[y]});
  }
  return InPlane(ray.range, {Exact(ray.direction[x]), Exact(ray.direction[y])}, {corners}).first();
}

std::optional<double> first_in_plane(const Ray<double, 2>& ray, const std::vector<Ring<double, 2>>& outlines) {
  return InPlane(ray.range, {Exact(ray.direction[0]), Exact(ray.direction[1])}, seen_from(ray.origin, outlines))
      .first();
}

std::optional<double> first_in_plane(const Segment<double, 2>& segment, const std::vector<Ring<double, 2>>& outlines) {
  return InPlane({0, 1}, difference(segment.q, segment.p), seen_from(segment.p, outlines)).first();
}

double off_plane(const Ring<double, 3>& outline) {
  const Exact3 n = normal_of(outline);
  const double length = std::hypot(n[0].rounded(), n[1].rounded(), n[2].rounded());
  double farthest = 0;
  for (const Point<double, 3>& v : outline) {
    const Exact3 d = difference(v, outline[0]);
    const Exact height = n[0] * d[0] + n[1] * d[1] + n[2] * d[2];
    if (height.sign() == 0) continue;
    const double off = std::abs(height.rounded()) / length;
    farthest = std::max({farthest, off, std::numeric_limits<double>::min()});
  }
  return farthest;
}

}  // namespace isect::program::scene
