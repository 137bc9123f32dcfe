#pragma once
// Our shapes as those of other libraries.
//
// CGAL answers in three kernels: Simple_cartesian<double> computes as naive code does; EPICK ("exact predicates,
// inexact constructions") is what its manual recommends, exact where no number is made on the way; EPECK is exact
// throughout. Both stop the program at NaN and infinities, EPICK also at a number that overflows on the way (the
// squares of "scale"), and are not asked there.

#include <string>
#include <string_view>
#include <utility>

#include <isect/shapes.h>
#include "bench/peer.h"
#ifdef ISECT_HAS_CGAL
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/intersections.h>
#endif
#ifdef ISECT_HAS_BULLET
#include <LinearMath/btTransform.h>
#endif

namespace isect::bench::peers {

#ifdef ISECT_HAS_CGAL
using Plain = CGAL::Simple_cartesian<double>;
using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;

/// ask(kernel, name of the kernel) for each of them.
template <class Ask>
void each_kernel(std::string_view family, const Ask& ask) {
  ask(Plain(), "Simple_cartesian");
  if (family == "invalid") return;
  if (family != "scale") ask(Epick(), "EPICK");
  ask(Epeck(), "EPECK");
}

template <class K, class S>
typename K::Point_3 cgal(const Point<S, 3>& p) {
  return {double(p[0]), double(p[1]), double(p[2])};
}
template <class K, class S>
typename K::Vector_3 cgal_vector(const Vector<S, 3>& v) {
  return {double(v[0]), double(v[1]), double(v[2])};
}
template <class K, class S>
typename K::Iso_cuboid_3 cgal(const Aabb<S, 3>& box) {
  return {cgal<K>(box.lo), cgal<K>(box.hi)};
}
template <class K, class S>
typename K::Ray_3 cgal(const Ray<S, 3>& ray) {
  return {cgal<K>(ray.origin), cgal_vector<K>(ray.direction)};
}
template <class K, class S>
typename K::Segment_3 cgal(const Segment<S, 3>& s) {
  return {cgal<K>(s.p), cgal<K>(s.q)};
}
template <class K, class S>
typename K::Plane_3 cgal(const Plane<S, 3>& p) {
  return {double(p.normal[0]), double(p.normal[1]), double(p.normal[2]), double(p.d)};
}
template <class K, class S>
typename K::Triangle_3 cgal(const Triangle<S, 3>& t) {
  return {cgal<K>(t.vertices[0]), cgal<K>(t.vertices[1]), cgal<K>(t.vertices[2])};
}
template <class K, class S>
typename K::Point_2 cgal(const Point<S, 2>& p) {
  return {double(p[0]), double(p[1])};
}
template <class K, class S>
typename K::Segment_2 cgal(const Segment<S, 2>& s) {
  return {cgal<K>(s.p), cgal<K>(s.q)};
}
/// CGAL keeps the squared radius: rounded, except in EPECK.
template <class K, class S>
typename K::Sphere_3 cgal(const Sphere<S, 3>& ball) {
  const typename K::FT r = double(ball.radius);
  return {cgal<K>(ball.center), r * r};
}
#endif

#ifdef ISECT_HAS_BULLET
template <class V>
btVector3 bullet(const V& v) {
  return {static_cast<btScalar>(v[0]), static_cast<btScalar>(v[1]), static_cast<btScalar>(v[2])};
}
#endif

/// Asks a question of CGAL's shapes of both, ask(a, b), in each kernel; none without CGAL.
template <class Ask>
struct ByCgal {
  const char* question;
  Ask ask;

  template <class S, class Case>
  void operator()([[maybe_unused]] Contest<S, Case>& contest, [[maybe_unused]] std::string_view family) const {
#ifdef ISECT_HAS_CGAL
    each_kernel(family, [&]<class K>(K, const char* kernel) {
      enter(
          contest, "CGAL", (std::string(question) + ", " + kernel).c_str(),
          [](const Case& c) { return std::pair(cgal<K>(c.a), cgal<K>(c.b)); },
          [ask = ask](const auto& c) { return ask(c.first, c.second); });
    });
#endif
  }
};
template <class Ask>
ByCgal(const char*, Ask) -> ByCgal<Ask>;
/// Whether they have a common point; its sphere is a surface.
inline constexpr ByCgal meet_by_cgal = {"do_intersect", [](const auto& a, const auto& b) {
#ifdef ISECT_HAS_CGAL
                                          return CGAL::do_intersect(a, b);
#else
                                          return &a == &b;  // never asked
#endif
                                        }};

/// Both shapes of a case, as `convert` makes them.
template <class S, class Case, class Convert, class Ask>
void enter_both(Contest<S, Case>& contest, const char* library, const char* method, const Convert& convert,
                const Ask& ask) {
  using Shape = std::decay_t<decltype(convert(contest.cases()[0].a))>;
  struct Two {
    Shape a, b;
  };
  enter(
      contest, library, method,
      [convert](const Case& c) {
        return Two{convert(c.a), convert(c.b)};
      },
      [ask](const Two& c) { return ask(c.a, c.b); });
}

}  // namespace isect::bench::peers
