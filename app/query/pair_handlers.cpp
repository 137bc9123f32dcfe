// Boxes, spheres, capsules, k-DOPs and triangles in pairs.

#include <isect/aabb_aabb.h>
#include <isect/capsule_capsule.h>
#include <isect/kdop_kdop.h>
#include <isect/methods/aabb_aabb.h>
#include <isect/methods/capsule_capsule.h>
#include <isect/methods/obb_obb.h>
#include <isect/methods/sphere_aabb.h>
#include <isect/methods/sphere_capsule.h>
#include <isect/methods/sphere_sphere.h>
#include <isect/obb_obb.h>
#include <isect/sphere_aabb.h>
#include <isect/sphere_capsule.h>
#include <isect/sphere_sphere.h>
#include <isect/triangle_aabb.h>
#include "app/query/events.h"
#include "app/query/handlers.h"
#include "app/query/results.h"

namespace isect::query {

// clang-format off
template <class S> struct EventNames<aabb_aabb::Axis<S>> : Named<"Axis", "axis a b disjoint"> {};
template <class S, int N> struct EventNames<aabb_aabb::Common<S, N>> : Named<"Common", "common"> {};
template <> struct EventNames<sphere_sphere::Decision> : Named<"Decision", "outer inner"> {};
template <class S> struct EventNames<sphere_sphere::Compared<S>> : Named<"Compared", "distance2 sum2"> {};
template <class S> struct EventNames<sphere_aabb::Axis<S>> : Named<"Axis", "axis center interval gap distance2"> {};
template <class S> struct EventNames<sphere_aabb::Compared<S>> : Named<"Compared", "distance2 radius2"> {};
template <> struct EventNames<sphere_aabb::Decision> : Named<"Decision", "nearest farthest ball_inside"> {};
template <> struct EventNames<sphere_capsule::Reach> : Named<"Reach", "nearest sign"> {};
template <> struct EventNames<sphere_capsule::Contained> : Named<"Contained", "ball capsule"> {};
template <class S, int N> struct EventNames<sphere_capsule::Foot<S, N>> : Named<"Foot", "t at"> {};
template <class S> struct EventNames<sphere_capsule::Compared<S>> : Named<"Compared", "distance2 reach2"> {};
template <> struct EventNames<capsule_capsule::Between> : Named<"Between", "holds sign"> {};
template <> struct EventNames<capsule_capsule::End> : Named<"End", "end nearest sign"> {};
template <> struct EventNames<capsule_capsule::Contained> : Named<"Contained", "a b"> {};
template <class S> struct EventNames<capsule_capsule::Lines<S>> : Named<"Lines", "determinant parallel"> {};
template <class S, int N> struct EventNames<capsule_capsule::Closest<S, N>> : Named<"Closest", "s t on_a on_b"> {};
template <class S> struct EventNames<capsule_capsule::Compared<S>> : Named<"Compared", "distance2 reach2"> {};
template <class S> struct EventNames<kdop_kdop::Slab<S>> : Named<"Slab", "slab a b disjoint"> {};
template <int N> struct EventNames<obb_obb::Tested<N>> : Named<"Tested", "axis l distance radius_a radius_b sign"> {};
template <int N> struct EventNames<obb_obb::Witness<N>> : Named<"Witness", "p"> {};
template <int N> struct EventNames<triangle_aabb::Tested<N>> : Named<"Tested", "axis l triangle box sign"> {};
template <> struct Names<obb_obb::Kind> {
  static constexpr const char* of[] = {"face_of_a", "face_of_b", "edges"};
};
template <> struct Names<triangle_aabb::Kind> {
  static constexpr const char* of[] = {"box_normal", "triangle_normal", "edge"};
};
template <> struct EventNames<obb_obb::Axis> : Named<"Axis", "kind i j"> {};
template <> struct EventNames<triangle_aabb::Axis> : Named<"Axis", "kind i j"> {};
// clang-format on

namespace {

template <class S>
Json box_box(Job& job) {
  return in_dimension(job.fields["alo"], [&]<int N>() -> Json {
    const Aabb<S, N> a = box<S, N>(job.fields, "alo", "ahi"), b = box<S, N>(job.fields, "blo", "bhi");
    using Event = aabb_aabb::Event<S, N>;
    if (job.variant == "by_axis")
      return {{"intersects", run<Event>(job, [&](auto&& trace) { return aabb_aabb::by_axis(a, b, trace); })}};

    return two_boxes(run<Event>(job, [&](auto&& trace) { return relate(a, b, trace); }), a, b);
  });
}

/// Whether one contains the other and touches its surface.
template <class S, int N>
bool touch_within(Relation r, const Sphere<S, N>& a, const Sphere<S, N>& b) {
  if (r != Relation::a_inside_b && r != Relation::b_inside_a) return false;
  sphere_sphere::Decision signs = {};
  relate(a, b, [&](const auto& event) {
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(event)>, sphere_sphere::Decision>) signs = event;
  });
  return signs.inner == 0;
}

template <class S>
Json sphere_sphere(Job& job) {
  return in_dimension(job.fields["c1"], [&]<int N>() -> Json {
    const Sphere<S, N> a = sphere<S, N>(job.fields, "c1", "r1"), b = sphere<S, N>(job.fields, "c2", "r2");
    if (job.variant == "squared_distance") {
      using Event = std::variant<sphere_sphere::Compared<S>>;
      return {{"intersects",
               run<Event>(job, [&](auto&& trace) { return sphere_sphere::squared_distance_naive(a, b, trace); })}};
    }
    const Relation r = run<sphere_sphere::Event>(job, [&](auto&& trace) { return relate(a, b, trace); });
    return two_balls(r, touch_within(r, a, b), a, b);
  });
}

template <class S>
Json sphere_box(Job& job) {
  return in_dimension(job.fields["center"], [&]<int N>() -> Json {
    const Sphere<S, N> ball = sphere<S, N>(job.fields);
    const Aabb<S, N> b = box<S, N>(job.fields);
    using Event = sphere_aabb::Event<S>;
    if (job.variant == "accumulate")
      return {
          {"intersects", run<Event>(job, [&](auto&& trace) { return sphere_aabb::accumulate_naive(ball, b, trace); })}};

    return related(run<Event>(job, [&](auto&& trace) { return relate(ball, b, trace); }), "sphere", "box", b);
  });
}

template <class S>
Json sphere_capsule(Job& job) {
  return in_dimension(job.fields["center"], [&]<int N>() -> Json {
    const Sphere<S, N> ball = sphere<S, N>(job.fields);
    const Capsule<S, N> c = capsule<S, N>(job.fields);
    using Event = sphere_capsule::MethodEvent<S, N>;
    if (job.variant == "clamped")
      return {{"intersects", run<Event>(job, [&](auto&& trace) { return sphere_capsule::clamped(ball, c, trace); })}};
    if (job.variant == "by_pythagoras")
      return {
          {"intersects", run<Event>(job, [&](auto&& trace) { return sphere_capsule::by_pythagoras(ball, c, trace); })}};

    return related(run<sphere_capsule::Event>(job, [&](auto&& trace) { return relate(ball, c, trace); }), "sphere",
                   "capsule");
  });
}

template <class S>
Json capsule_capsule(Job& job) {
  for (const char* one : {"a", "b"}) job.fields[one].only(capsule_fields);
  return in_dimension(job.fields["a"]["p"], [&]<int N>() -> Json {
    const Capsule<S, N> a = capsule<S, N>(job.fields["a"]), b = capsule<S, N>(job.fields["b"]);
    if (job.variant == "clamped") {
      using Event = capsule_capsule::MethodEvent<S, N>;
      return {{"intersects", run<Event>(job, [&](auto&& trace) { return capsule_capsule::clamped(a, b, trace); })}};
    }
    return related(run<capsule_capsule::Event>(job, [&](auto&& trace) { return relate(a, b, trace); }));
  });
}

template <class S>
Json obb_obb(Job& job) {
  for (const char* box : {"a", "b"}) job.fields[box].only(obb_fields);
  return in_dimension(job.fields["a"]["c"], [&]<int N>() -> Json {
    const Obb<S, N> a = obb<S, N>(job.fields["a"]), b = obb<S, N>(job.fields["b"]);
    return two_obbs(run<obb_obb::Event<N>>(job, [&](auto&& trace) { return relate(a, b, trace); }), a, b);
  });
}

template <class S>
Json kdop_kdop(Job& job) {
  const Field::Entries normals = job.fields["normals"].list();
  if (normals.empty()) job.fields["normals"].complain("at least one normal is expected");
  return in_dimension(normals.front(), [&]<int N>() -> Json {
    const Kdop<S, N> a = kdop<S, N>(job.fields["normals"], job.fields["a"]);
    const Kdop<S, N> b = kdop<S, N>(job.fields["normals"], job.fields["b"]);
    const bool may = run<kdop_kdop::Event<S>>(job, [&](auto&& trace) { return may_intersect(a, b, trace); });
    return {{"slabs", may ? "overlap" : "disjoint"}};
  });
}

template <class S>
Json triangle_box(Job& job) {
  const std::array<Field, 3> corners = job.fields["tri"].list_of<3>();
  return in_dimension(corners[0], [&]<int N>() -> Json {
    const Triangle<S, N> t = {{vector<S, N>(corners[0]), vector<S, N>(corners[1]), vector<S, N>(corners[2])}};
    const Aabb<S, N> b = box<S, N>(job.fields);
    return related(run<triangle_aabb::Event<N>>(job, [&](auto&& trace) { return relate(t, b, trace); }), "a", "b", b);
  });
}

}  // namespace

const std::vector<Handler>& pair_handlers() {
  static const std::vector<Handler> table = {
      ISECT_HANDLER(box_box, "alo ahi blo bhi", {"exact", "by_axis"}),
      ISECT_HANDLER(sphere_sphere, "c1 r1 c2 r2", {"exact", "squared_distance"}),
      ISECT_HANDLER(sphere_box, "center radius lo hi", {"exact", "accumulate"}),
      ISECT_HANDLER(sphere_capsule, "center radius p q r", {"exact", "clamped", "by_pythagoras"}),
      ISECT_HANDLER(capsule_capsule, "a b", {"exact", "clamped"}),
      ISECT_HANDLER(obb_obb, "a b", {"exact"}),
      ISECT_HANDLER(kdop_kdop, "normals a b", {"exact"}),
      ISECT_HANDLER(triangle_box, "tri lo hi", {"exact"}),
  };
  return table;
}

}  // namespace isect::query
