// Points, intervals and planes.

#include <isect/interval_interval.h>
#include <isect/orient.h>
#include <isect/plane_aabb.h>
#include <isect/plane_sphere.h>
#include <isect/point_aabb.h>
#include <isect/point_capsule.h>
#include <isect/point_line.h>
#include <isect/point_obb.h>
#include <isect/point_plane.h>
#include <isect/point_point.h>
#include <isect/point_sphere.h>
#include "app/query/events.h"
#include "app/query/handlers.h"
#include "app/query/results.h"

namespace isect::query {

// clang-format off
template <class S> struct EventNames<interval_interval::Common<S>> : Named<"Common", "common"> {};
template <class S> struct EventNames<interval_interval::Beyond<S>> : Named<"Beyond", "lo hi holds"> {};
template <> struct EventNames<point_obb::Slab> : Named<"Slab", "axis sign"> {};
template <class S> struct EventNames<point_aabb::Axis<S>> : Named<"Axis", "axis x interval location"> {};
template <> struct EventNames<point_sphere::Distance> : Named<"Distance", "sign"> {};
template <class S> struct EventNames<point_point::Coordinate<S>> : Named<"Coordinate", "axis p q equal"> {};
template <> struct EventNames<point_point::Distance> : Named<"Distance", "sign"> {};
template <class S, int N> struct EventNames<plane_aabb::Corners<S, N>> : Named<"Corners", "least greatest at_least at_greatest"> {};
template <> struct EventNames<plane_aabb::Decision> : Named<"Decision", "least greatest"> {};
template <> struct EventNames<point_line::Side> : Named<"Side", "sign"> {};
template <> struct EventNames<point_line::Along> : Named<"Along", "from_lo from_hi"> {};
template <> struct Names<Beside> {
  static constexpr const char* of[] = {"on", "before", "beyond", "left", "right", "aside"};
};
template <> struct EventNames<point_plane::Height> : Named<"Height", "sign"> {};
template <> struct EventNames<point_capsule::Distance> : Named<"Distance", "nearest sign"> {};
template <> struct EventNames<plane_sphere::Decision> : Named<"Decision", "center clear"> {};
// clang-format on

namespace {

template <class S>
Json orient2d(Job& job) {
  const auto point = [&](const char* key) -> Point<double, 2> {
    return vector<S, 2>(job.fields[key]).template cast<double>();
  };
  const Point<double, 2> a = point("a"), b = point("b"), c = point("c");
  return {{"sign", run<std::variant<Fallback>>(job, [&](auto&& trace) { return isect::orient2d(a, b, c, trace); })}};
}

template <class S>
Json interval_interval(Job& job) {
  const Interval<S> a = interval<S>(job.fields["a"]), b = interval<S>(job.fields["b"]);
  using Event = interval_interval::Event<S>;
  if (job.variant == "ends")
    return {{"intersects", run<Event>(job, [&](auto&& trace) { return interval_interval::ends(a, b, trace); })}};

  return related(run<Event>(job, [&](auto&& trace) { return relate(a, b, trace); }));
}

template <class S>
Json point_obb(Job& job) {
  return in_dimension(job.fields["point"], [&]<int N>() -> Json {
    const Point<S, N> point = vector<S, N>(job.fields["point"]);
    const Obb<S, N> b = obb<S, N>(job.fields);
    const Location where = run<point_obb::Event>(job, [&](auto&& trace) { return locate(point, b, trace); });
    return telling_empty(located(where), b, "box");
  });
}

template <class S>
Json point_point(Job& job) {
  return in_dimension(job.fields["a"], [&]<int N>() -> Json {
    const Point<S, N> a = vector<S, N>(job.fields["a"]), b = vector<S, N>(job.fields["b"]);
    const auto given = job.fields.find("tol");
    const S tolerance = given ? given->template number<S>() : S(0);
    const bool same = run<point_point::Event<S>>(
        job, [&](auto&& trace) { return tolerance == 0 ? equal(a, b, trace) : nearly_equal(a, b, tolerance, trace); });
    return {{"equal", same}};
  });
}

template <class S>
Json point_box(Job& job) {
  return in_dimension(job.fields["point"], [&]<int N>() -> Json {
    const Point<S, N> point = vector<S, N>(job.fields["point"]);
    const Aabb<S, N> b = box<S, N>(job.fields);
    return located(run<point_aabb::Event<S>>(job, [&](auto&& trace) { return locate(point, b, trace); }));
  });
}

template <class S>
Json point_sphere(Job& job) {
  return in_dimension(job.fields["point"], [&]<int N>() -> Json {
    const Point<S, N> point = vector<S, N>(job.fields["point"]);
    const Sphere<S, N> ball = sphere<S, N>(job.fields);
    return located(run<point_sphere::Event>(job, [&](auto&& trace) { return locate(point, ball, trace); }));
  });
}

template <class S>
Json point_capsule(Job& job) {
  return in_dimension(job.fields["point"], [&]<int N>() -> Json {
    const Point<S, N> point = vector<S, N>(job.fields["point"]);
    const Capsule<S, N> c = capsule<S, N>(job.fields);
    return located(run<point_capsule::Event>(job, [&](auto&& trace) { return locate(point, c, trace); }));
  });
}

template <class S>
Json point_line(Job& job) {
  return in_dimension(job.fields["point"], [&]<int N>() -> Json {
    const Point<S, N> point = vector<S, N>(job.fields["point"]);
    const Ray<S, N> r = ray<S, N>(job.fields);
    const Beside where = run<point_line::Event>(job, [&](auto&& trace) { return beside(point, r, trace); });
    return {{"where", Names<Beside>::of[static_cast<int>(where)]}};
  });
}

template <class S>
Json point_plane(Job& job) {
  return in_dimension(job.fields["point"], [&]<int N>() -> Json {
    const Point<S, N> point = vector<S, N>(job.fields["point"]);
    const Plane<S, N> p = plane<S, N>(job.fields);
    return {{"side", run<point_plane::Event>(job, [&](auto&& trace) { return side(p, point, trace); })}};
  });
}

template <class S>
Json plane_sphere(Job& job) {
  return in_dimension(job.fields["normal"], [&]<int N>() -> Json {
    const Plane<S, N> p = plane<S, N>(job.fields);
    const Sphere<S, N> ball = sphere<S, N>(job.fields);
    return related(run<plane_sphere::Event>(job, [&](auto&& trace) { return relate(p, ball, trace); }));
  });
}

template <class S>
Json plane_box(Job& job) {
  return in_dimension(job.fields["normal"], [&]<int N>() -> Json {
    const Plane<S, N> p = plane<S, N>(job.fields);
    const Aabb<S, N> b = box<S, N>(job.fields);
    return related(run<plane_aabb::Event<S, N>>(job, [&](auto&& trace) { return relate(p, b, trace); }));
  });
}

}  // namespace

const std::vector<Handler>& point_handlers() {
  static const std::vector<Handler> table = {
      ISECT_HANDLER(orient2d, "a b c", {"exact"}),
      ISECT_HANDLER(interval_interval, "a b", {"exact", "ends"}),
      ISECT_HANDLER(point_obb, "point c u e", {"exact"}),
      ISECT_HANDLER(point_point, "a b [tol]", {"exact"}),
      ISECT_HANDLER(point_box, "point lo hi", {"exact"}),
      ISECT_HANDLER(point_sphere, "point center radius", {"exact"}),
      ISECT_HANDLER(point_capsule, "point p q r", {"exact"}),
      ISECT_HANDLER(point_line, "point origin dir [tmin] [tmax]", {"exact"}),
      ISECT_HANDLER(point_plane, "point normal d", {"exact"}),
      ISECT_HANDLER(plane_sphere, "normal d center radius", {"exact"}),
      ISECT_HANDLER(plane_box, "normal d lo hi", {"exact"}),
  };
  return table;
}

}  // namespace isect::query
