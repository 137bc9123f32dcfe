// Polygons, hulls and fits.

#include "core/point_polygon.h"
#include "lessons/query/events.h"
#include "lessons/query/handlers.h"

namespace isect::query {

// clang-format off
template <> struct Told<point_polygon::Edge> : Says<"Edge", "ring index passage turn"> {};
template <> struct Told<point_polygon::Straddles> : Says<"Straddles", "index holds"> {};
template <class S> struct Told<point_polygon::CrossesAt<S>> : Says<"CrossesAt", "index x holds"> {};
template <class S> struct Told<point_polygon::LeftBy<S>> : Says<"LeftBy", "index area2"> {};
// clang-format on

namespace {

template <class S>
Polygon<S, 2> polygon(const Field& rings) {
  Polygon<S, 2> p;
  for (const Field& entry : rings.list()) p.rings.push_back(ring<S, 2>(entry));
  return p;
}

/// The naive methods know neither boundary nor other rings: each ring by itself, summed.
template <class S, class Method>
int summed(Job& job, const Polygon<S, 2>& p, const Method& method) {
  int sum = 0;
  for (const Ring<S, 2>& r : p.rings)
    sum += run<point_polygon::NaiveEvent<S>>(
        job, [&](auto&& trace) { return static_cast<int>(method(r, trace)); });
  return sum;
}

Json in_or_out(bool in) { return in ? "in" : "out"; }

template <class S>
Json pip(Job& job) {
  const Polygon<S, 2> p = polygon<S>(job.fields["rings"]);
  const Point<S, 2> point = vector<S, 2>(job.fields["point"]);
  if (job.variant == "crossings_naive") {
    const auto method = [&](const auto& r, auto&& trace) {
      return point_polygon::crossings_naive(point, r, trace);
    };
    return {{"evenodd", in_or_out(summed(job, p, method) % 2 != 0)}};
  }
  if (job.variant == "winding_naive") {
    const auto method = [&](const auto& r, auto&& trace) {
      return point_polygon::winding_naive(point, r, trace);
    };
    const int winding = summed(job, p, method);
    return {{"nonzero", in_or_out(winding != 0)}, {"winding", winding}};
  }

  const Winding w = run<point_polygon::Event>(job, [&](auto&& trace) { return winding(point, p, trace); });
  const Json times = w.nonzero == Location::on ? Json(nullptr) : Json(w.winding);
  if (job.variant == "crossings") return {{"evenodd", name(w.even_odd)}};
  if (job.variant == "winding") return {{"nonzero", name(w.nonzero)}, {"winding", times}};
  return {{"evenodd", name(w.even_odd)}, {"nonzero", name(w.nonzero)}, {"winding", times}};
}

}  // namespace

const std::vector<Handler>& polygon_handlers() {
  static const std::vector<Handler> table = {
      ISECT_HANDLER(pip, {"exact", "crossings", "winding", "crossings_naive", "winding_naive"}),
  };
  return table;
}

}  // namespace isect::query
