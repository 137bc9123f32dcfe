// Points, intervals and planes.

#include "core/orient.h"
#include "lessons/query/events.h"
#include "lessons/query/handlers.h"

namespace isect::query {

namespace {

template <class S>
Json orient2d(Job& job) {
  const auto point = [&](const char* key) -> Point<double, 2> {
    return vector<S, 2>(job.fields[key]).template cast<double>();
  };
  const Point<double, 2> a = point("a"), b = point("b"), c = point("c");
  return {{"sign",
           run<std::variant<Fallback>>(job, [&](auto&& trace) { return isect::orient2d(a, b, c, trace); })}};
}

}  // namespace

const std::vector<Handler>& point_handlers() {
  static const std::vector<Handler> table = {
      ISECT_HANDLER(orient2d, {"exact"}),
  };
  return table;
}

}  // namespace isect::query
