#pragma once
// Writing an answer: numbers, locations and traces as JSON.

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include <isect/conventions.h>
#include <isect/obb_obb.h>
#include <isect/shapes.h>
#include "app/query/relation_words.h"
#include "app/query/request.h"

namespace isect::query {

using Json = nlohmann::ordered_json;

/// Returns the JSON on one line, in UTF-8 whatever the texts are.
inline std::string written(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

/// Returns the number, "inf" or "-inf"; -0 as it is.
template <class S>
Json number(S x) {
  if (std::isnan(x)) return "nan";
  if (std::isinf(x)) return x > 0 ? "inf" : "-inf";
  return static_cast<double>(x);
}
template <class S>
Json number(const std::optional<S>& x) {
  return x ? number(*x) : Json(nullptr);
}
template <class S, int N>
Json numbers(const Vector<S, N>& v) {
  Json list = Json::array();
  list.get_ref<Json::array_t&>().reserve(N);
  for (int i = 0; i < N; ++i) list.push_back(number(v[i]));
  return list;
}
template <class S, int N>
Json numbers(const Ring<S, N>& points) {
  Json list = Json::array();
  for (const Point<S, N>& p : points) list.push_back(numbers<S, N>(p));
  return list;
}

template <class S, int N>
bool has_no_point(const Aabb<S, N>& box) {
  return empty(box);
}
template <class S, int N>
bool has_no_point(const Obb<S, N>& box) {
  return !has_points(box);
}
template <class S>
bool has_no_point(const Cylinder<S>& cylinder) {
  return empty(cylinder);
}
template <class S>
bool has_no_point(const Cone<S>& cone) {
  return empty(cone);
}
/// Adds which of the shapes has no point, if any: of a box lo is above hi on some axis, a half is negative, or the axes
/// lie in one plane, in the plane on one line, so that there is no such box; of a cylinder or a cone the radius is
/// negative, or there is no axis.
template <class Shape>
Json telling_empty(Json result, const Shape& shape, const char* name) {
  if (has_no_point(shape))
    result["empty"] = result.contains("empty") ? result["empty"].get<std::string>() + " and " + name : name;
  return result;
}

inline Json name(Location l) { return l == Location::in ? "in" : l == Location::on ? "on" : "out"; }

/// A case in progress: the question, and the trace if it was asked for.
struct Job {
  const Field& fields;
  std::string variant;
  bool traced;
  std::string trace;  ///< events as JSON, with commas between

  void tell(const Json& event) { trace += (trace.empty() ? "" : ",") + written(event); }
};

}  // namespace isect::query
