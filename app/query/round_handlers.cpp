// Cylinders and cones.

#include <isect/cone_half_spaces.h>
#include <isect/cylinder_half_spaces.h>
#include <isect/methods/plane_cone.h>
#include <isect/methods/plane_cylinder.h>
#include <isect/methods/point_cone.h>
#include <isect/methods/point_cylinder.h>
#include <isect/methods/ray_cone.h>
#include <isect/methods/ray_cylinder.h>
#include <isect/methods/sphere_cone.h>
#include <isect/methods/sphere_cylinder.h>
#include <isect/plane_cone.h>
#include <isect/plane_cylinder.h>
#include <isect/point_cone.h>
#include <isect/point_cylinder.h>
#include <isect/ray_cone.h>
#include <isect/ray_cylinder.h>
#include <isect/sphere_cone.h>
#include <isect/sphere_cylinder.h>
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

// Each pair once, for any round solid: its name and fields are those of isect/described.h.

template <class Solid>
Json of_solid(const Json& result, const Solid& solid) {
  return telling_empty(result, solid, Described<Solid>::name);
}
template <class Solid>
Json relation_of(Relation r, const Solid& solid) {
  return of_solid({{"intersects", r != Relation::disjoint}, {"relation", name(r)}}, solid);
}
/// Returns a method's yes or no, as `field`.
template <class Event>
Json yes_or_no(Job& job, const char* field, const auto& method) {
  return {{field, run<Event>(job, method)}};
}

template <class Solid, class Event, class MethodsEvent, class S>
Json point_and(Job& job, const auto& method) {
  const Point<S, 3> point = vector<S, 3>(job.fields["point"]);
  const Solid c = shape<Solid>(job.fields);
  if (job.variant != "exact")
    return yes_or_no<MethodsEvent>(job, "inside", [&](auto&& trace) { return method(point, c, trace); });
  return of_solid({{"location", name(run<Event>(job, [&](auto&& trace) { return locate(point, c, trace); }))}}, c);
}

/// Returns the first t, the only result of a method.
template <class Solid, class Event, class MethodsEvent, class S>
Json ray_and(Job& job, const auto& method) {
  const Ray<S, 3> r = ray<S, 3>(job.fields);
  const Solid c = shape<Solid>(job.fields);
  if (job.variant != "exact") {
    const std::optional<S> t = run<MethodsEvent>(job, [&](auto&& trace) { return method(r, c, trace); });
    return {{"hit", t.has_value()}, {"t_in", number(t)}};
  }
  return of_solid(stretch(run<Event>(job, [&](auto&& trace) { return intersect(r, c, trace); })), c);
}

template <class Solid, class Event, class S>
Json segment_and(Job& job) {
  const Segment<S, 3> s = segment<S, 3>(job.fields["segment"]);
  const Solid c = shape<Solid>(job.fields);
  return of_solid(stretch(run<Event>(job, [&](auto&& trace) { return intersect(s, c, trace); })), c);
}

template <class Solid, class Event, class MethodsEvent, class S>
Json plane_and(Job& job, const auto& method) {
  const Plane<S, 3> p = plane<S, 3>(job.fields);
  const Solid c = shape<Solid>(job.fields);
  if (job.variant != "exact")
    return yes_or_no<MethodsEvent>(job, "intersects", [&](auto&& trace) { return method(p, c, trace); });
  return relation_of(run<Event>(job, [&](auto&& trace) { return relate(p, c, trace); }), c);
}

template <class Solid, class Event, class MethodsEvent, class S>
Json sphere_and(Job& job, const auto& method) {
  const Sphere<S, 3> ball = sphere<S, 3>(job.fields);
  const Solid c = shape<Solid>(job.fields);
  if (job.variant != "exact")
    return yes_or_no<MethodsEvent>(job, "intersects", [&](auto&& trace) { return method(ball, c, trace); });
  const Relation r = run<Event>(job, [&](auto&& trace) { return relate(ball, c, trace); });
  return of_solid(related(r, "sphere", Described<Solid>::name), c);
}

/// The other solid is a k-DOP, with normals of any directions.
template <class Solid, class Event, class S>
Json and_solid(Job& job) {
  const Solid c = shape<Solid>(job.fields);
  const HalfSpaces other = half_spaces_of(kdop<S, 3>(job.fields["normals"], job.fields["slabs"]));
  const Relation r = run<Event>(job, [&](auto&& trace) { return relate(c, other, trace); });
  return of_solid(related(r, Described<Solid>::name, "solid"), c);
}

template <class S>
Json point_cylinder(Job& job) {
  using namespace isect::point_cylinder;
  return point_and<Cylinder<S>, Event, ProjectedEvent<S>, S>(
      job, [](const auto& p, const auto& c, auto&& trace) { return projected(p, c, trace); });
}
template <class S>
Json point_cone(Job& job) {
  using namespace isect::point_cone;
  return point_and<Cone<S>, Event, HeightEvent<S>, S>(
      job, [](const auto& p, const auto& c, auto&& trace) { return by_height(p, c, trace); });
}
template <class S>
Json ray_cylinder(Job& job) {
  using namespace isect::ray_cylinder;
  return ray_and<Cylinder<S>, Event, QuadraticEvent<S>, S>(
      job, [](const auto& r, const auto& c, auto&& trace) { return quadratic(r, c, trace); });
}
template <class S>
Json ray_cone(Job& job) {
  using namespace isect::ray_cone;
  return ray_and<Cone<S>, Event, QuadraticEvent<S>, S>(
      job, [](const auto& r, const auto& c, auto&& trace) { return quadratic(r, c, trace); });
}
template <class S>
Json segment_cylinder(Job& job) {
  return segment_and<Cylinder<S>, isect::ray_cylinder::Event, S>(job);
}
template <class S>
Json segment_cone(Job& job) {
  return segment_and<Cone<S>, isect::ray_cone::Event, S>(job);
}
template <class S>
Json plane_cylinder(Job& job) {
  using namespace isect::plane_cylinder;
  return plane_and<Cylinder<S>, Event, HeightsEvent<S>, S>(
      job, [](const auto& p, const auto& c, auto&& trace) { return by_heights(p, c, trace); });
}
template <class S>
Json plane_cone(Job& job) {
  using namespace isect::plane_cone;
  return plane_and<Cone<S>, Event, HeightsEvent<S>, S>(
      job, [](const auto& p, const auto& c, auto&& trace) { return by_heights(p, c, trace); });
}
template <class S>
Json sphere_cylinder(Job& job) {
  using namespace isect::sphere_cylinder;
  return sphere_and<Cylinder<S>, Event, GapsEvent<S>, S>(
      job, [](const auto& b, const auto& c, auto&& trace) { return clamped(b, c, trace); });
}
template <class S>
Json sphere_cone(Job& job) {
  using namespace isect::sphere_cone;
  return sphere_and<Cone<S>, Event, ProfileEvent<S>, S>(
      job, [](const auto& b, const auto& c, auto&& trace) { return by_profile(b, c, trace); });
}
template <class S>
Json cylinder_solid(Job& job) {
  return and_solid<Cylinder<S>, cylinder_half_spaces::Event, S>(job);
}
template <class S>
Json cone_solid(Job& job) {
  return and_solid<Cone<S>, cone_half_spaces::Event, S>(job);
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
