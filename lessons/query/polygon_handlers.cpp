// Polygons, hulls and fits.

#include "lessons/query/events.h"
#include "lessons/query/handlers.h"

namespace isect::query {

namespace {}  // namespace

const std::vector<Handler>& polygon_handlers() {
  static const std::vector<Handler> table = {};
  return table;
}

}  // namespace isect::query
