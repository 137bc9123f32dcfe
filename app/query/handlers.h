#pragma once
// The tables of the handler files: a kind's name, its inputs, its variants, and what answers it in either scalar.

#include <string>
#include <vector>

#include "app/query/reply.h"

namespace isect::query {

struct Handler {
  const char* kind;
  const char* inputs;                 ///< the names of its fields, [optional] ones in brackets
  std::vector<std::string> variants;  ///< the exact default is called "exact"
  Json (*f32)(Job&);
  Json (*f64)(Job&);
};

/// Handler{"kind", "inputs", {variants}, function<float>, function<double>}
#define ISECT_HANDLER(kind, ...) \
  Handler { #kind, __VA_ARGS__, kind < float>, kind < double> }

const std::vector<Handler>& point_handlers();    ///< points, intervals, planes against things
const std::vector<Handler>& pair_handlers();     ///< boxes, spheres, capsules, k-DOPs, triangles
const std::vector<Handler>& ray_handlers();      ///< rays and segments
const std::vector<Handler>& round_handlers();    ///< cylinders and cones
const std::vector<Handler>& polygon_handlers();  ///< polygons, hulls, fits

}  // namespace isect::query
