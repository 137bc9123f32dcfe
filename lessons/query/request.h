#pragma once
// Reading a case: every complaint names the field as its path, what is allowed and what was found.

#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/shapes.h"

namespace isect::query {

using Json = nlohmann::ordered_json;

/// A case that can't be answered; the message names the field.
struct BadCase : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A value inside a case, and how to call it: "a.u[1]".
class Field {
 public:
  Field(const Json& value, std::string path) : value_(value), path_(std::move(path)) {}

  /// The member `key` of an object. Throws BadCase when there is none.
  Field operator[](const std::string& key) const;
  std::optional<Field> find(const std::string& key) const;

  /// The entries of a list.
  std::vector<Field> list() const;
  /// A list of exactly `count`.
  std::vector<Field> list(std::size_t count) const;
  std::string text() const;
  bool boolean() const;

  /// A finite number, rounded to S, in whose range it must be.
  template <class S>
  S number() const;
  /// The same, or "inf" or "-inf".
  template <class S>
  S end() const;

  [[noreturn]] void complain(const std::string& what) const;

 private:
  const Json& value_;
  std::string path_;
};

/// 2 or 3: how many numbers the list has.
int dimension(const Field&);

template <class S, int N>
Vector<S, N> vector(const Field& field) {
  const std::vector<Field> entries = field.list(N);
  Vector<S, N> v;
  for (int i = 0; i < N; ++i) v[i] = entries[i].number<S>();
  return v;
}
template <class S, int N>
Vector<S, N> vector_of_ends(const Field& field) {
  const std::vector<Field> entries = field.list(N);
  Vector<S, N> v;
  for (int i = 0; i < N; ++i) v[i] = entries[i].end<S>();
  return v;
}
template <class S>
Interval<S> interval(const Field& field) {
  const std::vector<Field> ends = field.list(2);
  return {ends[0].end<S>(), ends[1].end<S>()};
}
template <class S, int N>
Ring<S, N> ring(const Field& field) {
  Ring<S, N> points;
  for (const Field& entry : field.list()) points.push_back(vector<S, N>(entry));
  return points;
}

/// origin, dir, tmin = 0, tmax = inf
template <class S, int N>
Ray<S, N> ray(const Field& request) {
  const auto lo = request.find("tmin"), hi = request.find("tmax");
  return {vector<S, N>(request["origin"]),
          vector<S, N>(request["dir"]),
          {lo ? lo->end<S>() : semi_infinite<S>.lo, hi ? hi->end<S>() : semi_infinite<S>.hi}};
}
template <class S, int N>
Sphere<S, N> sphere(const Field& request, const char* center = "center", const char* radius = "radius") {
  return {vector<S, N>(request[center]), request[radius].number<S>()};
}
template <class S, int N>
Aabb<S, N> box(const Field& request, const char* lo = "lo", const char* hi = "hi") {
  const Aabb<S, N> b = {vector_of_ends<S, N>(request[lo]), vector_of_ends<S, N>(request[hi])};
  if (!finite(b) && !empty(b)) request[lo].complain("finite ends are expected of a box that is not inverted");
  return b;
}
/// c, u: N rows, e
template <class S, int N>
Obb<S, N> obb(const Field& request) {
  Obb<S, N> b;
  b.center = vector<S, N>(request["c"]);
  const std::vector<Field> rows = request["u"].list(N);
  for (int i = 0; i < N; ++i) b.axes.col(i) = vector<S, N>(rows[i]);
  b.half = vector<S, N>(request["e"]);
  return b;
}
/// normal, d
template <class S, int N>
Plane<S, N> plane(const Field& request) {
  return {vector<S, N>(request["normal"]), request["d"].number<S>()};
}
/// normals, and {lo, hi} lists of as many ends
template <class S, int N>
Kdop<S, N> kdop(const Field& normals, const Field& slabs) {
  Kdop<S, N> k = {ring<S, N>(normals), {}};
  const std::vector<Field> lo = slabs["lo"].list(k.normals.size()), hi = slabs["hi"].list(k.normals.size());
  for (std::size_t i = 0; i < lo.size(); ++i) k.slabs.push_back({lo[i].number<S>(), hi[i].number<S>()});
  return k;
}

/// Calls what.operator()<N>() with the dimension that the list shows.
template <class What>
auto in_dimension(const Field& list, const What& what) {
  return dimension(list) == 2 ? what.template operator()<2>() : what.template operator()<3>();
}

}  // namespace isect::query
