// Cylinders and cones.

#include <isect/cone_half_spaces.h>
#include <isect/cylinder_half_spaces.h>
#include <isect/plane_cone.h>
#include <isect/plane_cone_methods.h>
#include <isect/plane_cylinder.h>
#include <isect/plane_cylinder_methods.h>
#include <isect/point_cone.h>
#include <isect/point_cone_methods.h>
#include <isect/point_cylinder.h>
#include <isect/point_cylinder_methods.h>
#include <isect/ray_cone.h>
#include <isect/ray_cone_methods.h>
#include <isect/ray_cylinder.h>
#include <isect/ray_cylinder_methods.h>
#include <isect/sphere_cone.h>
#include <isect/sphere_cone_methods.h>
#include <isect/sphere_cylinder.h>
#include <isect/sphere_cylinder_methods.h>
#include "app/query/events.h"
#include "app/query/handlers.h"
#include "app/query/results.h"

namespace isect::query {

// clang-format off
template <> struct EventNames<round_solid::Signs> : Named<"Signs", "first last side"> {};
template <class S> struct EventNames<point_cylinder::Projected<S>> : Named<"Projected", "t distance2"> {};
template <class S> struct EventNames<point_cone::Height<S>> : Named<"Height", "t distance"> {};
template <> struct Names<ray_round::Limit> {
  static constexpr const char* of[] = {"none", "range", "first", "last"};
};
template <> struct EventNames<ray_round::Stop> : Named<"Stop", "ends at inside"> {};
template <> struct EventNames<ray_round::Side> : Named<"Side", "falls rises root"> {};
template <class S> struct EventNames<ray_cylinder::Coefficients<S>> : Named<"Coefficients", "a b c"> {};
template <class S> struct EventNames<ray_cylinder::Left<S>> : Named<"Left", "lo hi"> {};
template <class S> struct EventNames<ray_cone::Coefficients<S>> : Named<"Coefficients", "a b c"> {};
template <class S> struct EventNames<ray_cone::Candidate<S>> : Named<"Candidate", "t holds"> {};
template <> struct EventNames<plane_round::Decision> : Named<"Decision", "lowest highest"> {};
template <class S> struct EventNames<plane_cylinder::Heights<S>> : Named<"Heights", "start end reach"> {};
template <class S> struct EventNames<plane_cone::Heights<S>> : Named<"Heights", "start end reach"> {};
template <> struct Names<sphere_cylinder::Nearest> {
  static constexpr const char* of[] = {"center", "side", "end_p", "end_q", "rim_p", "rim_q"};
};
template <> struct EventNames<sphere_cylinder::Reach> : Named<"Reach", "nearest sign"> {};
template <> struct EventNames<sphere_cylinder::Contained> : Named<"Contained", "ball cylinder"> {};
template <class S> struct EventNames<sphere_cylinder::Gaps<S>> : Named<"Gaps", "beyond beside"> {};
template <> struct Names<sphere_cone::Nearest> {
  static constexpr const char* of[] = {"center", "side", "base", "rim", "apex"};
};
template <> struct EventNames<sphere_cone::Reach> : Named<"Reach", "nearest sign"> {};
template <> struct EventNames<sphere_cone::Contained> : Named<"Contained", "ball cone"> {};
template <class S> struct EventNames<sphere_cone::InProfile<S>> : Named<"InProfile", "along beside distance"> {};
template <> struct EventNames<round_half_spaces::Shadow> : Named<"Shadow", "reach"> {};
template <> struct EventNames<round_half_spaces::Contained> : Named<"Contained", "round other"> {};
// clang-format on

namespace {

template <class S>
Json point_cylinder(Job& job) {
  const Point<S, 3> point = vector<S, 3>(job.fields["point"]);
  const Cylinder<S> c = cylinder<S>(job.fields);
  if (job.variant == "projected") {
    using Event = point_cylinder::ProjectedEvent<S>;
    return {{"inside", run<Event>(job, [&](auto&& trace) { return point_cylinder::projected(point, c, trace); })}};
  }
  const Location where = run<point_cylinder::Event>(job, [&](auto&& trace) { return locate(point, c, trace); });
  return telling_empty({{"location", name(where)}}, c, "cylinder");
}

template <class S>
Json point_cone(Job& job) {
  const Point<S, 3> point = vector<S, 3>(job.fields["point"]);
  const Cone<S> c = cone<S>(job.fields);
  if (job.variant == "by_height") {
    using Event = point_cone::HeightEvent<S>;
    return {{"inside", run<Event>(job, [&](auto&& trace) { return point_cone::by_height(point, c, trace); })}};
  }
  const Location where = run<point_cone::Event>(job, [&](auto&& trace) { return locate(point, c, trace); });
  return telling_empty({{"location", name(where)}}, c, "cone");
}

/// The part of the range inside; of a method the first t of it alone.
template <class S>
Json stretch_in(const std::optional<Interval<S>>& part) {
  return {{"hit", part.has_value()},
          {"t_in", part ? number(part->lo) : Json(nullptr)},
          {"t_out", part ? number(part->hi) : Json(nullptr)}};
}
template <class S>
Json first_in(const std::optional<S>& t) {
  return {{"hit", t.has_value()}, {"t_in", number(t)}};
}

template <class S>
Json ray_cylinder(Job& job) {
  const Ray<S, 3> r = ray<S, 3>(job.fields);
  const Cylinder<S> c = cylinder<S>(job.fields);
  if (job.variant == "quadratic") {
    using Event = ray_cylinder::QuadraticEvent<S>;
    return first_in(run<Event>(job, [&](auto&& trace) { return ray_cylinder::quadratic(r, c, trace); }));
  }
  const auto part = run<ray_cylinder::Event>(job, [&](auto&& trace) { return intersect(r, c, trace); });
  return telling_empty(stretch_in(part), c, "cylinder");
}

template <class S>
Json ray_cone(Job& job) {
  const Ray<S, 3> r = ray<S, 3>(job.fields);
  const Cone<S> c = cone<S>(job.fields);
  if (job.variant == "quadratic") {
    using Event = ray_cone::QuadraticEvent<S>;
    return first_in(run<Event>(job, [&](auto&& trace) { return ray_cone::quadratic(r, c, trace); }));
  }
  const auto part = run<ray_cone::Event>(job, [&](auto&& trace) { return intersect(r, c, trace); });
  return telling_empty(stretch_in(part), c, "cone");
}

template <class Event, class S, class Solid>
Json segment_and(Job& job, const Solid& c, const char* solid) {
  const Segment<S, 3> s = segment<S, 3>(job.fields["segment"]);
  return telling_empty(stretch_in(run<Event>(job, [&](auto&& trace) { return intersect(s, c, trace); })), c, solid);
}
template <class S>
Json segment_cylinder(Job& job) {
  return segment_and<ray_cylinder::Event, S>(job, cylinder<S>(job.fields), "cylinder");
}
template <class S>
Json segment_cone(Job& job) {
  return segment_and<ray_cone::Event, S>(job, cone<S>(job.fields), "cone");
}

template <class S>
Json plane_cylinder(Job& job) {
  const Plane<S, 3> p = plane<S, 3>(job.fields);
  const Cylinder<S> c = cylinder<S>(job.fields);
  if (job.variant == "by_heights") {
    using Event = plane_cylinder::HeightsEvent<S>;
    return {{"intersects", run<Event>(job, [&](auto&& trace) { return plane_cylinder::by_heights(p, c, trace); })}};
  }
  const Relation r = run<plane_cylinder::Event>(job, [&](auto&& trace) { return relate(p, c, trace); });
  return telling_empty({{"intersects", r != Relation::disjoint}, {"relation", name(r)}}, c, "cylinder");
}

template <class S>
Json plane_cone(Job& job) {
  const Plane<S, 3> p = plane<S, 3>(job.fields);
  const Cone<S> c = cone<S>(job.fields);
  if (job.variant == "by_heights") {
    using Event = plane_cone::HeightsEvent<S>;
    return {{"intersects", run<Event>(job, [&](auto&& trace) { return plane_cone::by_heights(p, c, trace); })}};
  }
  const Relation r = run<plane_cone::Event>(job, [&](auto&& trace) { return relate(p, c, trace); });
  return telling_empty({{"intersects", r != Relation::disjoint}, {"relation", name(r)}}, c, "cone");
}

template <class S>
Json sphere_cylinder(Job& job) {
  const Sphere<S, 3> ball = sphere<S, 3>(job.fields);
  const Cylinder<S> c = cylinder<S>(job.fields);
  if (job.variant == "clamped") {
    using Event = sphere_cylinder::GapsEvent<S>;
    return {{"intersects", run<Event>(job, [&](auto&& trace) { return sphere_cylinder::clamped(ball, c, trace); })}};
  }
  const Relation r = run<sphere_cylinder::Event>(job, [&](auto&& trace) { return relate(ball, c, trace); });
  return telling_empty({{"intersects", r != Relation::disjoint},
                        {"relation", r == Relation::a_inside_b   ? "cylinder_contains_sphere"
                                     : r == Relation::b_inside_a ? "sphere_contains_cylinder"
                                                                 : name(r)}},
                       c, "cylinder");
}

template <class S>
Json sphere_cone(Job& job) {
  const Sphere<S, 3> ball = sphere<S, 3>(job.fields);
  const Cone<S> c = cone<S>(job.fields);
  if (job.variant == "by_profile") {
    using Event = sphere_cone::ProfileEvent<S>;
    return {{"intersects", run<Event>(job, [&](auto&& trace) { return sphere_cone::by_profile(ball, c, trace); })}};
  }
  const Relation r = run<sphere_cone::Event>(job, [&](auto&& trace) { return relate(ball, c, trace); });
  return telling_empty({{"intersects", r != Relation::disjoint},
                        {"relation", r == Relation::a_inside_b   ? "cone_contains_sphere"
                                     : r == Relation::b_inside_a ? "sphere_contains_cone"
                                                                 : name(r)}},
                       c, "cone");
}

/// The other solid is a k-DOP, with normals of any directions.
template <class Event, class S, class Solid>
Json and_solid(Job& job, const Solid& c, const char* solid) {
  const HalfSpaces other = half_spaces_of(kdop<S, 3>(job.fields["normals"], job.fields["slabs"]));
  const Relation r = run<Event>(job, [&](auto&& trace) { return relate(c, other, trace); });
  return telling_empty(related(r, solid, "solid"), c, solid);
}
template <class S>
Json cylinder_solid(Job& job) {
  return and_solid<cylinder_half_spaces::Event, S>(job, cylinder<S>(job.fields), "cylinder");
}
template <class S>
Json cone_solid(Job& job) {
  return and_solid<cone_half_spaces::Event, S>(job, cone<S>(job.fields), "cone");
}

}  // namespace

const std::vector<Handler>& round_handlers() {
  static const std::vector<Handler> table = {
      ISECT_HANDLER(point_cylinder, "point p q r", {"exact", "projected"}),
      ISECT_HANDLER(point_cone, "point apex base r", {"exact", "by_height"}),
      ISECT_HANDLER(plane_cylinder, "normal d p q r", {"exact", "by_heights"}),
      ISECT_HANDLER(plane_cone, "normal d apex base r", {"exact", "by_heights"}),
      ISECT_HANDLER(sphere_cylinder, "center radius p q r", {"exact", "clamped"}),
      ISECT_HANDLER(sphere_cone, "center radius apex base r", {"exact", "by_profile"}),
      ISECT_HANDLER(ray_cylinder, "origin dir p q r [tmin] [tmax]", {"exact", "quadratic"}),
      ISECT_HANDLER(ray_cone, "origin dir apex base r [tmin] [tmax]", {"exact", "quadratic"}),
      ISECT_HANDLER(segment_cylinder, "segment p q r", {"exact"}),
      ISECT_HANDLER(segment_cone, "segment apex base r", {"exact"}),
      ISECT_HANDLER(cylinder_solid, "p q r normals slabs", {"exact"}),
      ISECT_HANDLER(cone_solid, "apex base r normals slabs", {"exact"}),
  };
  return table;
}

}  // namespace isect::query
