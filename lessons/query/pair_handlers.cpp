// Boxes, spheres, k-DOPs and triangles in pairs.

#include "core/sphere_sphere.h"
#include "lessons/query/events.h"
#include "lessons/query/handlers.h"

namespace isect::query {

// clang-format off
template <> struct Told<sphere_sphere::Decision> : Says<"Decision", "outer inner"> {};
template <class S> struct Told<sphere_sphere::Compared<S>> : Says<"Compared", "distance2 sum2"> {};
// clang-format on

namespace {}  // namespace

const std::vector<Handler>& pair_handlers() {
  static const std::vector<Handler> table = {};
  return table;
}

}  // namespace isect::query
