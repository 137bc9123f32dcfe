// Rays and segments.

#include <isect/clip_segment.h>
#include <isect/line_triangle.h>
#include <isect/methods/clip_segment.h>
#include <isect/methods/ray_aabb.h>
#include <isect/methods/ray_obb.h>
#include <isect/methods/ray_plane.h>
#include <isect/methods/ray_polygon.h>
#include <isect/methods/segment_segment.h>
#include <isect/ray_aabb.h>
#include <isect/ray_plane.h>
#include <isect/ray_sphere.h>

#include <isect/methods/ray_sphere.h>
#include <isect/ray_capsule.h>
#include <isect/ray_obb.h>
#include <isect/ray_outline.h>
#include <isect/ray_polygon.h>
#include <isect/segment_plane.h>
#include <isect/segment_segment.h>
#include "app/query/events.h"
#include "app/query/handlers.h"
#include "app/query/results.h"

namespace isect::query {

// clang-format off
template <> struct EventNames<ray_sphere::Verdict> : Named<"Verdict", "line_roots origin lo hi"> {};
template <> struct EventNames<ray_sphere::Decision> : Named<"Decision", "a discriminant c verdict"> {};
template <> struct EventNames<ray_sphere::Values> : Named<"Values", "roots"> {};
template <class S, int N> struct EventNames<ray_sphere::FromCenter<S, N>> : Named<"FromCenter", "f"> {};
template <class S> struct EventNames<ray_sphere::CoefficientA<S>> : Named<"CoefficientA", "a"> {};
template <class S> struct EventNames<ray_sphere::CoefficientB<S>> : Named<"CoefficientB", "b"> {};
template <class S> struct EventNames<ray_sphere::CoefficientC<S>> : Named<"CoefficientC", "c"> {};
template <class S> struct EventNames<ray_sphere::Discriminant<S>> : Named<"Discriminant", "d"> {};
template <class S> struct EventNames<ray_sphere::LineMisses<S>> : Named<"LineMisses", "d holds"> {};
template <class S> struct EventNames<ray_sphere::Root<S>> : Named<"Root", "index t"> {};
template <class S> struct EventNames<ray_sphere::RootInRange<S>> : Named<"RootInRange", "index t holds"> {};
template <class S> struct EventNames<ray_sphere::Hit<S>> : Named<"Hit", "t"> {};
template <> struct EventNames<ray_sphere::Miss> : Named<"Miss"> {};
template <class S, int N> struct EventNames<ray_sphere::ToCenter<S, N>> : Named<"ToCenter", "l"> {};
template <class S> struct EventNames<ray_sphere::AlongRay<S>> : Named<"AlongRay", "s"> {};
template <class S> struct EventNames<ray_sphere::CenterDistance<S>> : Named<"CenterDistance", "l2"> {};
template <class S> struct EventNames<ray_sphere::Behind<S>> : Named<"Behind", "s l2 r2 holds"> {};
template <class S> struct EventNames<ray_sphere::PassingDistance<S>> : Named<"PassingDistance", "m2"> {};
template <class S> struct EventNames<ray_sphere::PassesBy<S>> : Named<"PassesBy", "m2 r2 holds"> {};
template <class S> struct EventNames<ray_sphere::HalfChord<S>> : Named<"HalfChord", "q"> {};
template <class S> struct EventNames<ray_sphere::FromOutside<S>> : Named<"FromOutside", "l2 r2 holds"> {};
template <class S> struct EventNames<ray_sphere::Nearest<S>> : Named<"Nearest", "t"> {};
template <class S> struct EventNames<ray_sphere::TooFar<S>> : Named<"TooFar", "t limit holds"> {};
template <> struct EventNames<ray_sphere::Reject> : Named<"Reject"> {};
template <class S, int N> struct EventNames<ray_sphere::Intersect<S, N>> : Named<"Intersect", "t p"> {};
template <> struct EventNames<ray_plane::Decision> : Named<"Decision", "heading side"> {};
template <class S> struct EventNames<ray_plane::Hit<S>> : Named<"Hit", "t in_range"> {};
template <class S> struct EventNames<ray_plane::Numerator<S>> : Named<"Numerator", "value"> {};
template <class S> struct EventNames<ray_plane::Denominator<S>> : Named<"Denominator", "value"> {};
template <class S> struct EventNames<ray_plane::Parallel<S>> : Named<"Parallel", "denominator holds"> {};
template <class S> struct EventNames<ray_plane::Quotient<S>> : Named<"Quotient", "t"> {};
template <class S> struct EventNames<ray_plane::InRange<S>> : Named<"InRange", "t holds"> {};
template <> struct EventNames<slabs::Outside> : Named<"Outside", "slab"> {};
template <> struct EventNames<slabs::Stretch> : Named<"Stretch", "entered left"> {};
template <> struct EventNames<ray_aabb::Estimate> : Named<"Estimate", "in out meets"> {};
template <class S> struct EventNames<ray_aabb::Beside<S>> : Named<"Beside", "axis origin outside"> {};
template <class S> struct EventNames<ray_aabb::Crossing<S>> : Named<"Crossing", "axis entry exit"> {};
template <class S> struct EventNames<ray_aabb::Remains<S>> : Named<"Remains", "in out holds"> {};
template <class S> struct EventNames<ray_obb::Projected<S>> : Named<"Projected", "axis center rate"> {};
template <class S> struct EventNames<ray_obb::Beside<S>> : Named<"Beside", "axis outside"> {};
template <class S> struct EventNames<ray_obb::Crossing<S>> : Named<"Crossing", "axis entry exit"> {};
template <class S> struct EventNames<ray_obb::Remains<S>> : Named<"Remains", "in out holds"> {};
template <> struct EventNames<ray_capsule::Between> : Named<"Between", "holds sign"> {};
template <> struct EventNames<ray_capsule::End> : Named<"End", "end sign"> {};
template <> struct EventNames<ray_capsule::Passage> : Named<"Passage", "leaves through"> {};
template <> struct Names<ray_capsule::Piece> {
  static constexpr const char* of[] = {"p", "q", "side"};
};
template <> struct EventNames<segment_segment::Apart> : Named<"Apart"> {};
template <> struct EventNames<segment_segment::Sides> : Named<"Sides", "r s p q"> {};
template <class S> struct EventNames<segment_segment::Determinant<S>> : Named<"Determinant", "value"> {};
template <class S> struct EventNames<segment_segment::Parameters<S>> : Named<"Parameters", "t u holds"> {};
template <> struct Names<ray_sphere::AmongRoots> {
  static constexpr const char* of[] = {"before", "entry", "between", "exit", "after"};
};
template <> struct EventNames<ray_polygon::Decision> : Named<"Decision", "axis heading side"> {};
template <class S> struct EventNames<ray_polygon::Hit<S>> : Named<"Hit", "t"> {};
template <class S> struct EventNames<ray_polygon::Normal<S>> : Named<"Normal", "n"> {};
template <class S> struct EventNames<ray_polygon::InPlane<S>> : Named<"InPlane", "t point"> {};
template <class S> struct EventNames<ray_polygon::InRange<S>> : Named<"InRange", "t holds"> {};
template <class S> struct EventNames<ray_polygon::Projected<S>> : Named<"Projected", "dropped point"> {};
template <> struct EventNames<clip_segment::Outcodes> : Named<"Outcodes", "p q"> {};
template <class S> struct EventNames<clip_segment::Narrowed<S>> : Named<"Narrowed", "axis upper heading t range holds"> {};
template <> struct EventNames<ray_outline::Start> : Named<"Start", "location"> {};
template <> struct EventNames<ray_outline::Nearer> : Named<"Nearer", "ring index corner"> {};
// clang-format on

namespace {

/// The note's methods find the first t on the surface, nothing else.
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

    return line_and_ball(run<ray_sphere::Event>(job, [&](auto&& trace) { return intersect(r, ball, trace); }));
  });
}

template <class S>
Json ray_plane(Job& job) {
  return in_dimension(job.fields["origin"], [&]<int N>() -> Json {
    const Ray<S, N> r = ray<S, N>(job.fields);
    const Plane<S, N> p = plane<S, N>(job.fields);
    if (job.variant == "textbook") {
      const auto t =
          run<ray_plane::TextbookEvent<S>>(job, [&](auto&& trace) { return ray_plane::textbook(r, p, trace); });
      return {{"ray_hit", t.has_value()}, {"t", number(t)}};
    }
    return ray_and_plane(run<ray_plane::Event<S>>(job, [&](auto&& trace) { return intersect(r, p, trace); }), r, p);
  });
}

template <class S>
Json ray_box(Job& job) {
  return in_dimension(job.fields["origin"], [&]<int N>() -> Json {
    const Ray<S, N> r = ray<S, N>(job.fields);
    const Aabb<S, N> b = box<S, N>(job.fields);
    if (job.variant == "conservative") return {{"hit", may_intersect(r, b)}};
    if (job.variant == "slabs")
      return stretch(
          run<ray_aabb::SlabsEvent<S>>(job, [&](auto&& trace) { return ray_aabb::slabs_naive(r, b, trace); }));
    return stretch(run<ray_aabb::Event>(job, [&](auto&& trace) { return intersect(r, b, trace); }));
  });
}

template <class S>
Json ray_obb(Job& job) {
  return in_dimension(job.fields["origin"], [&]<int N>() -> Json {
    const Ray<S, N> r = ray<S, N>(job.fields);
    const Obb<S, N> b = obb<S, N>(job.fields);
    const auto told = [&](const auto& part) { return telling_empty(stretch(part), b, "box"); };
    if (job.variant == "projections")
      return told(
          run<ray_obb::ProjectionsEvent<S>>(job, [&](auto&& trace) { return ray_obb::projections(r, b, trace); }));
    return told(run<ray_obb::Event>(job, [&](auto&& trace) { return intersect(r, b, trace); }));
  });
}

template <class S>
Json ray_capsule(Job& job) {
  return in_dimension(job.fields["origin"], [&]<int N>() -> Json {
    const Ray<S, N> r = ray<S, N>(job.fields);
    const Capsule<S, N> c = capsule<S, N>(job.fields);
    return stretch(run<ray_capsule::Event>(job, [&](auto&& trace) { return intersect(r, c, trace); }));
  });
}

template <class S>
Json segment_plane(Job& job) {
  return in_dimension(job.fields["segment"].list_of<2>()[0], [&]<int N>() -> Json {
    const Segment<S, N> s = segment<S, N>(job.fields["segment"]);
    const Plane<S, N> p = plane<S, N>(job.fields);
    return segment_and_plane(intersect(s, p),
                             run<clip_segment::Event>(job, [&](auto&& trace) { return clip(s, p, trace); }));
  });
}

template <class S>
Json segment_box(Job& job) {
  return in_dimension(job.fields["segment"].list_of<2>()[0], [&]<int N>() -> Json {
    const Segment<S, N> s = segment<S, N>(job.fields["segment"]);
    const Aabb<S, N> b = box<S, N>(job.fields);
    if (job.variant == "liang_barsky")
      return stretch(run<clip_segment::LiangBarskyEvent<S>>(
          job, [&](auto&& trace) { return clip_segment::liang_barsky(s, b, trace); }));
    return stretch(run<ray_aabb::Event>(job, [&](auto&& trace) { return clip(s, b, trace); }));
  });
}

template <class S>
Json segment_segment(Job& job) {
  const Segment<S, 2> a = segment<S, 2>(job.fields["a"]), b = segment<S, 2>(job.fields["b"]);
  if (job.variant == "parametric") {
    const auto point = run<segment_segment::ParametricEvent<S>>(
        job, [&](auto&& trace) { return segment_segment::parametric_naive(a, b, trace); });
    return {{"point", point ? numbers<S, 2>(*point) : nullptr}};
  }
  return two_segments(run<segment_segment::Event>(job, [&](auto&& trace) { return intersect(a, b, trace); }));
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
  return line_and_polygon(
      run<ray_polygon::Event<S>>(job, [&](auto&& trace) { return intersect(r, outline, FillRule::even_odd, trace); }));
}

template <class S>
Json ray_outline(Job& job) {
  const Ray<S, 2> r = ray<S, 2>(job.fields);
  Polygon<S, 2> polygon;
  for (const Field entry : job.fields["rings"].list()) polygon.rings.push_back(ring<S, 2>(entry));
  return first_t(
      run<ray_outline::Event>(job, [&](auto&& trace) { return first_hit(r, polygon, FillRule::even_odd, trace); }));
}

template <class S>
Json line_triangle(Job& job) {
  const Ray<S, 3> r = ray<S, 3>(job.fields);
  const auto [a, b, c] = job.fields["tri"].list_of<3>();
  return first_t(first_hit(r, Triangle<S, 3>{{vector<S, 3>(a), vector<S, 3>(b), vector<S, 3>(c)}}));
}

}  // namespace

const std::vector<Handler>& ray_handlers() {
  static const std::vector<Handler> table = {
      ISECT_HANDLER(ray_sphere, "origin dir center radius [tmin] [tmax]",
                    {"exact", "robust", "quadratic", "half_b", "haines"}),
      ISECT_HANDLER(ray_box, "origin dir lo hi [tmin] [tmax]", {"exact", "conservative", "slabs"}),
      ISECT_HANDLER(ray_plane, "origin dir normal d [tmin] [tmax]", {"exact", "textbook"}),
      ISECT_HANDLER(ray_obb, "origin dir c u e [tmin] [tmax]", {"exact", "projections"}),
      ISECT_HANDLER(ray_capsule, "origin dir p q r [tmin] [tmax]", {"exact"}),
      ISECT_HANDLER(segment_plane, "segment normal d", {"exact"}),
      ISECT_HANDLER(segment_box, "segment lo hi", {"exact", "liang_barsky"}),
      ISECT_HANDLER(segment_segment, "a b", {"exact", "parametric"}),
      ISECT_HANDLER(ray_outline, "origin dir rings [tmin] [tmax]", {"exact"}),
      ISECT_HANDLER(line_triangle, "origin dir tri [tmin] [tmax]", {"exact"}),
      ISECT_HANDLER(ray_polygon, "origin dir polygon [tmin] [tmax]", {"exact", "projected"}),
  };
  return table;
}

}  // namespace isect::query
