#pragma once
// Bounding volumes that `isect query` fitted, in rational arithmetic: they hold every point, and no smaller size would.

#include <algorithm>
#include <limits>

#include "tests/app/query_questions.h"

namespace isect::tests {

using Coordinates = std::vector<Rational>;

inline Coordinates point(const Json& json, bool f32 = false) {
  Coordinates x;
  for (const Json& entry : json) x.push_back(peer_number(entry, f32));
  return x;
}
inline Coordinates minus(Coordinates x, const Coordinates& y) {
  for (std::size_t i = 0; i < x.size(); ++i) x[i] -= y[i];
  return x;
}
inline Rational product(const Coordinates& x, const Coordinates& y) {
  Rational sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += x[i] * y[i];
  return sum;
}

/// The largest number below `size`, in the scalar that was requested.
inline Rational before(const Json& size, bool f32) {
  const double x = peer_number(size), inf = std::numeric_limits<double>::infinity();
  return f32 ? std::nextafter(static_cast<float>(x), static_cast<float>(-inf)) : std::nextafter(x, -inf);
}

/// A size in an answer, and what the farthest point requires of it: that it, or its square, is at least `most`.
struct Need {
  Json size;
  Rational most;  ///< a length, or its square
  bool squared = false;
};

/// A normal of each pair of a box's faces.
inline std::vector<Coordinates> across(const std::vector<Coordinates>& u) {
  if (u.size() == 2) return {{-u[1][1], u[1][0]}, {-u[0][1], u[0][0]}};
  const auto cross = [&](std::size_t i, std::size_t j) {
    const auto &a = u[i], &b = u[j];
    return Coordinates{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  };
  return {cross(1, 2), cross(2, 0), cross(0, 1)};
}

/// The sizes that the points require of a ball, a k-DOP or an oriented box.
inline std::vector<Need> needs(const Question& q, const Json& r) {
  const bool f32 = asks_for_floats(q.request);
  const std::string volume = q.request["volume"];
  std::vector<Coordinates> points;
  for (const Json& p : q.request["points"]) points.push_back(point(p, f32));
  const auto most = [&](const auto& size_of) {
    Rational result = size_of(points[0]);
    for (const Coordinates& p : points) result = std::max(result, Rational(size_of(p)));
    return result;
  };
  std::vector<Need> all;
  if (volume == "sphere") {
    const Coordinates center = point(r["center"]);
    all.push_back({r["radius"], most([&](const Coordinates& p) {
                     const Coordinates f = minus(p, center);
                     return product(f, f);
                   }),
                   true});
  }
  if (volume == "kdop")
    for (std::size_t i = 0; i < r["normals"].size(); ++i) {
      const Coordinates n = point(r["normals"][i]);
      all.push_back({r["hi"][i], most([&](const Coordinates& p) { return product(n, p); })});
      all.push_back({-peer_number(r["lo"][i]), most([&](const Coordinates& p) -> Rational { return -product(n, p); })});
    }
  if (volume == "obb") {
    std::vector<Coordinates> axes;
    for (const Json& u : r["u"]) axes.push_back(point(u));
    const std::vector<Coordinates> normals = across(axes);
    for (std::size_t i = 0; i < axes.size(); ++i)
      all.push_back({r["e"][i], most([&](const Coordinates& p) -> Rational {
                       return abs(product(normals[i], minus(p, point(r["c"])))) / abs(product(normals[i], axes[i]));
                     })});
  }
  return all;
}

/// Whether the volume of the answer holds every point, in rational arithmetic, and no smaller number would; and whether
/// it is not too large.
inline std::string contradiction_of_fit(const Question& q, const Json& r) {
  const bool f32 = asks_for_floats(q.request);
  const std::string volume = q.request["volume"];
  if (volume == "aabb") {
    if (q.of->own) return contradiction(q, r);
    for (const Json& p : q.request["points"])
      for (std::size_t i = 0; i < p.size(); ++i)
        if (!(r["lo"][i] <= p[i] && p[i] <= r["hi"][i])) return "a point lies outside";
  }
  for (const Need& need : needs(q, r)) {
    const double size = peer_number(need.size);
    if (std::isinf(size)) continue;  // beyond the largest number
    const Rational less = before(need.size, f32);
    const auto holds = [&](const Rational& x) { return need.squared ? x >= 0 && x * x >= need.most : x >= need.most; };
    if (!holds(size)) return "a point lies outside";
    if (holds(less)) return "a smaller size would do";
  }
  if (volume == "obb" && q.expected.contains("volume_upper_bound")) {
    double size = 1;
    for (const Json& e : r["e"]) size *= 2 * e.get<double>();
    if (!(size <= 2.0 * q.expected["volume_upper_bound"].get<double>()))
      WARN(q.of->name << ": the box of the principal axes has " << size << ", the best known "
                      << q.expected["volume_upper_bound"]);
  }
  if (volume == "sphere" && q.expected.contains("three_sphere_radius") &&
      !(r["radius"].get<double>() <= q.expected["three_sphere_radius"].get<double>()))
    return "the sphere is larger than three.js's";
  return "";
}

}  // namespace isect::tests
