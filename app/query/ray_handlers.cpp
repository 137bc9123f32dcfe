// Rays and segments.

#include <isect/ray_aabb.h>
#include <isect/ray_plane.h>
#include <isect/ray_sphere.h>

#include <isect/ray_obb.h>
#include <isect/ray_polygon.h>
#include <isect/ray_sphere_methods.h>
#include <isect/segment_segment.h>
#include "app/query/events.h"
#include "app/query/handlers.h"

namespace isect::query {

// clang-format off
template <> struct Told<ray_sphere::Verdict> : Says<"Verdict", "line_roots origin lo hi"> {};
template <> struct Told<ray_sphere::Decision> : Says<"Decision", "a discriminant c verdict"> {};
template <> struct Told<ray_sphere::Values> : Says<"Values", "roots"> {};
template <class S, int N> struct Told<ray_sphere::FromCenter<S, N>> : Says<"FromCenter", "f"> {};
template <class S> struct Told<ray_sphere::CoefficientA<S>> : Says<"CoefficientA", "a"> {};
template <class S> struct Told<ray_sphere::CoefficientB<S>> : Says<"CoefficientB", "b"> {};
template <class S> struct Told<ray_sphere::CoefficientC<S>> : Says<"CoefficientC", "c"> {};
template <class S> struct Told<ray_sphere::Discriminant<S>> : Says<"Discriminant", "d"> {};
template <class S> struct Told<ray_sphere::LineMisses<S>> : Says<"LineMisses", "d holds"> {};
template <class S> struct Told<ray_sphere::Root<S>> : Says<"Root", "index t"> {};
template <class S> struct Told<ray_sphere::RootInRange<S>> : Says<"RootInRange", "index t holds"> {};
template <class S> struct Told<ray_sphere::Hit<S>> : Says<"Hit", "t"> {};
template <> struct Told<ray_sphere::Miss> : Says<"Miss"> {};
template <class S, int N> struct Told<ray_sphere::ToCenter<S, N>> : Says<"ToCenter", "l"> {};
template <class S> struct Told<ray_sphere::AlongRay<S>> : Says<"AlongRay", "s"> {};
template <class S> struct Told<ray_sphere::CenterDistance<S>> : Says<"CenterDistance", "l2"> {};
template <class S> struct Told<ray_sphere::Behind<S>> : Says<"Behind", "s l2 r2 holds"> {};
template <class S> struct Told<ray_sphere::PassingDistance<S>> : Says<"PassingDistance", "m2"> {};
template <class S> struct Told<ray_sphere::PassesBy<S>> : Says<"PassesBy", "m2 r2 holds"> {};
template <class S> struct Told<ray_sphere::HalfChord<S>> : Says<"HalfChord", "q"> {};
template <class S> struct Told<ray_sphere::FromOutside<S>> : Says<"FromOutside", "l2 r2 holds"> {};
template <class S> struct Told<ray_sphere::Nearest<S>> : Says<"Nearest", "t"> {};
template <class S> struct Told<ray_sphere::TooFar<S>> : Says<"TooFar", "t limit holds"> {};
template <> struct Told<ray_sphere::Reject> : Says<"Reject"> {};
template <class S, int N> struct Told<ray_sphere::Intersect<S, N>> : Says<"Intersect", "t p"> {};
template <> struct Told<ray_plane::Decision> : Says<"Decision", "heading side"> {};
template <class S> struct Told<ray_plane::Hit<S>> : Says<"Hit", "t in_range"> {};
template <class S> struct Told<ray_plane::Numerator<S>> : Says<"Numerator", "value"> {};
template <class S> struct Told<ray_plane::Denominator<S>> : Says<"Denominator", "value"> {};
template <class S> struct Told<ray_plane::Parallel<S>> : Says<"Parallel", "denominator holds"> {};
template <class S> struct Told<ray_plane::InRange<S>> : Says<"InRange", "t holds"> {};
template <> struct Told<slabs::Outside> : Says<"Outside", "slab"> {};
template <> struct Told<slabs::Stretch> : Says<"Stretch", "entered left"> {};
template <> struct Told<ray_aabb::Estimate> : Says<"Estimate", "in out meets"> {};
template <class S> struct Told<ray_aabb::Beside<S>> : Says<"Beside", "axis origin outside"> {};
template <class S> struct Told<ray_aabb::Crossing<S>> : Says<"Crossing", "axis entry exit"> {};
template <class S> struct Told<ray_aabb::Remains<S>> : Says<"Remains", "in out holds"> {};
template <class S> struct Told<ray_obb::Projected<S>> : Says<"Projected", "axis center rate"> {};
template <class S> struct Told<ray_obb::Beside<S>> : Says<"Beside", "axis outside"> {};
template <class S> struct Told<ray_obb::Crossing<S>> : Says<"Crossing", "axis entry exit"> {};
template <class S> struct Told<ray_obb::Remains<S>> : Says<"Remains", "in out holds"> {};
template <> struct Told<segment_segment::Apart> : Says<"Apart"> {};
template <> struct Told<segment_segment::Sides> : Says<"Sides", "r s p q"> {};
template <class S> struct Told<segment_segment::Determinant<S>> : Says<"Determinant", "value"> {};
template <class S> struct Told<segment_segment::Parameters<S>> : Says<"Parameters", "t u holds"> {};
template <> struct Names<ray_sphere::Place> {
  static constexpr const char* of[] = {"before", "entry", "between", "exit", "after"};
};
template <> struct Names<segment_segment::Meeting> {
  static constexpr const char* of[] = {"disjoint", "touch", "cross", "overlap"};
};
template <> struct Told<ray_polygon::Decision> : Says<"Decision", "axis heading side"> {};
template <class S> struct Told<ray_polygon::Hit<S>> : Says<"Hit", "t"> {};
template <class S> struct Told<ray_polygon::Normal<S>> : Says<"Normal", "n"> {};
template <class S> struct Told<ray_polygon::InPlane<S>> : Says<"InPlane", "t point"> {};
template <class S> struct Told<ray_polygon::InRange<S>> : Says<"InRange", "t holds"> {};
template <class S> struct Told<ray_polygon::Projected<S>> : Says<"Projected", "dropped point"> {};
// clang-format on

namespace {

/// The note's methods know the first t on the surface, nothing else.
template <class S, int N>
Json ray_sphere_by(Job& job, const Ray<S, N>& r, const Sphere<S, N>& ball) {
  using Quadratic = ray_sphere::QuadraticEvent<S, N>;
  std::optional<S> t;
  if (job.variant == "quadratic")
    t = run<Quadratic>(job, [&](auto&& trace) { return ray_sphere::quadratic(r, ball, trace); });
  else if (job.variant == "half_b")
    t = run<Quadratic>(job, [&](auto&& trace) { return ray_sphere::half_b(r, ball, trace); });
  else
    t = run<ray_sphere::HainesEvent<S, N>>(job, [&](auto&& trace) { return ray_sphere::haines(r, ball, trace); });
  return {{"ray_hit", t.has_value()}, {"t_first_surface", number(t)}};
}

template <class S>
Json ray_sphere(Job& job) {
  return in_dimension(job.fields["origin"], [&]<int N>() -> Json {
    const Ray<S, N> r = ray<S, N>(job.fields);
    const Sphere<S, N> ball = sphere<S, N>(job.fields);
    if (job.variant != "exact" && job.variant != "robust") return ray_sphere_by(job, r, ball);

    const RaySphere<S> shared = run<ray_sphere::Event>(job, [&](auto&& trace) { return intersect(r, ball, trace); });
    const bool meets = shared.line_roots > 0;
    return {{"line_roots", shared.line_roots},
            {"t0", meets ? number(shared.roots.lo) : nullptr},
            {"t1", meets ? number(shared.roots.hi) : nullptr},
            {"ray_hit", shared.solid.has_value()},
            {"origin", name(shared.origin)},
            {"t_first_surface", number(shared.surface)},
            {"t_enter_solid", shared.solid ? number(shared.solid->lo) : nullptr}};
  });
}

template <class S>
Json ray_plane(Job& job) {
  return in_dimension(job.fields["origin"], [&]<int N>() -> Json {
    Ray<S, N> r = ray<S, N>(job.fields);
    const Plane<S, N> p = plane<S, N>(job.fields);
    if (job.variant == "textbook") {
      const auto t =
          run<ray_plane::TextbookEvent<S>>(job, [&](auto&& trace) { return ray_plane::textbook(r, p, trace); });
      return {{"ray_hit", t.has_value()}, {"t", number(t)}};
    }
    const RayPlane<S> shared = run<ray_plane::Event<S>>(job, [&](auto&& trace) { return intersect(r, p, trace); });
    r.range = {S(0), S(1)};
    return {{"parallel", shared.parallel},
            {"coplanar", shared.coplanar},
            {"line_hit", shared.line.has_value() || shared.coplanar},
            {"t", number(shared.line)},
            {"ray_hit", shared.meets},
            {"segment_hit_0_1", intersect(r, p).meets}};
  });
}

/// The stretch of a ray inside a solid.
template <class S>
Json stretch(const std::optional<Interval<S>>& inside) {
  return {{"hit", inside.has_value()},
          {"t_in", inside ? number(inside->lo) : nullptr},
          {"t_out", inside ? number(inside->hi) : nullptr}};
}

template <class S>
Json ray_box(Job& job) {
  return in_dimension(job.fields["origin"], [&]<int N>() -> Json {
    const Ray<S, N> r = ray<S, N>(job.fields);
    const Aabb<S, N> b = box<S, N>(job.fields);
    if (job.variant == "conservative") return {{"hit", may_intersect(r, b)}};
    if (job.variant == "slabs")
      return stretch(run<ray_aabb::SlabsEvent<S>>(job, [&](auto&& trace) { return ray_aabb::slabs(r, b, trace); }));
    return stretch(run<ray_aabb::Event>(job, [&](auto&& trace) { return intersect(r, b, trace); }));
  });
}

template <class S>
Json ray_obb(Job& job) {
  return in_dimension(job.fields["origin"], [&]<int N>() -> Json {
    const Ray<S, N> r = ray<S, N>(job.fields);
    const Obb<S, N> b = obb<S, N>(job.fields);
    if (job.variant == "projections")
      return stretch(
          run<ray_obb::ProjectionsEvent<S>>(job, [&](auto&& trace) { return ray_obb::projections(r, b, trace); }));
    return stretch(run<ray_obb::Event>(job, [&](auto&& trace) { return intersect(r, b, trace); }));
  });
}

template <class S>
Segment<S, 2> segment(const Field& field) {
  const auto [p, q] = field.list_of<2>();
  return {vector<S, 2>(p), vector<S, 2>(q)};
}

template <class S>
Json segment_segment(Job& job) {
  const Segment<S, 2> a = segment<S>(job.fields["a"]), b = segment<S>(job.fields["b"]);
  if (job.variant == "parametric") {
    const auto point = run<segment_segment::ParametricEvent<S>>(
        job, [&](auto&& trace) { return segment_segment::parametric(a, b, trace); });
    return {{"point", point ? numbers<S, 2>(*point) : nullptr}};
  }
  const SegmentSegment<S> shared =
      run<segment_segment::Event>(job, [&](auto&& trace) { return intersect(a, b, trace); });
  Json result = {{"relation", Names<segment_segment::Meeting>::of[static_cast<int>(shared.relation)]}};
  result["point"] = shared.point ? numbers<S, 2>(*shared.point) : nullptr;
  if (shared.shared) result["shared"] = {numbers<S, 2>(shared.shared->p), numbers<S, 2>(shared.shared->q)};
  return result;
}

template <class S>
Json ray_polygon(Job& job) {
  const Ray<S, 3> r = ray<S, 3>(job.fields);
  const Ring<S, 3> outline = ring<S, 3>(job.fields["polygon"]);
  if (job.variant == "projected") {
    const auto t = run<ray_polygon::ProjectedEvent<S>>(
        job, [&](auto&& trace) { return ray_polygon::projected(r, outline, trace); });
    return {{"hit", t.has_value()}, {"t", number(t)}};
  }
  const RayPolygon<S> shared =
      run<ray_polygon::Event<S>>(job, [&](auto&& trace) { return intersect(r, outline, FillRule::even_odd, trace); });
  return {{"parallel", !shared.line},
          {"coplanar", shared.coplanar},
          {"hit", shared.flat || shared.coplanar ? Json(nullptr) : Json(shared.t.has_value())},
          {"t", number(shared.line)},
          {"plane_point_location", shared.line ? name(shared.location) : nullptr}};
}

}  // namespace

const std::vector<Handler>& ray_handlers() {
  static const std::vector<Handler> table = {
      ISECT_HANDLER(ray_sphere, "origin dir center radius [tmin] [tmax]",
                    {"exact", "robust", "quadratic", "half_b", "haines"}),
      ISECT_HANDLER(ray_box, "origin dir lo hi [tmin] [tmax]", {"exact", "conservative", "slabs"}),
      ISECT_HANDLER(ray_plane, "origin dir normal d [tmin] [tmax]", {"exact", "textbook"}),
      ISECT_HANDLER(ray_obb, "origin dir c u e [tmin] [tmax]", {"exact", "projections"}),
      ISECT_HANDLER(segment_segment, "a b", {"exact", "parametric"}),
      ISECT_HANDLER(ray_polygon, "origin dir polygon [tmin] [tmax]", {"exact", "projected"}),
  };
  return table;
}

}  // namespace isect::query
