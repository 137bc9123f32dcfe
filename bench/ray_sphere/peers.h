#pragma once
// Whether a ray meets a sphere, by CGAL: it finds no t. Its rays have no ends, so it is asked only where ours have
// none. Embree intersects spheres of a scene that is built before: one sphere each would measure the scene.

#include <algorithm>

#include "bench/peer.h"
#include "bench/ray_sphere/families.h"
#ifdef ISECT_HAS_CGAL
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/intersections.h>
#endif

namespace isect::bench::peers {

#ifdef ISECT_HAS_CGAL
/// CGAL keeps the squared radius, rounded: where that is not exact, even its exact kernel answers for another sphere.
template <class Kernel, class S>
Entrant<RaySphereCase<S, 3>>& cgal_ray_sphere(Contest<S, RaySphereCase<S, 3>>& contest, const char* name) {
  struct Shapes {
    typename Kernel::Ray_3 ray;
    typename Kernel::Sphere_3 sphere;
  };
  const auto converted = [](const RaySphereCase<S, 3>& c) -> Shapes {
    const auto& [o, d] = std::pair(c.ray.origin, c.ray.direction);
    const auto& m = c.sphere.center;
    const double r = c.sphere.radius;
    return {{typename Kernel::Point_3(o[0], o[1], o[2]), typename Kernel::Vector_3(d[0], d[1], d[2])},
            {typename Kernel::Point_3(m[0], m[1], m[2]), r * r}};
  };
  return enter(contest, "CGAL", name, converted, [](const Shapes& c) { return CGAL::do_intersect(c.ray, c.sphere); });
}
#endif

template <class S>
void ray_sphere([[maybe_unused]] Contest<S, RaySphereCase<S, 3>>& contest) {
#ifdef ISECT_HAS_CGAL
  const bool without_ends = std::ranges::all_of(contest.cases(), [](const RaySphereCase<S, 3>& c) {
    return c.ray.range.lo == 0 && std::isinf(c.ray.range.hi) && !c.ray.direction.isZero(0);
  });
  if (!without_ends) return;
  cgal_ray_sphere<CGAL::Simple_cartesian<double>>(contest, "do_intersect, inexact");
  cgal_ray_sphere<CGAL::Exact_predicates_inexact_constructions_kernel>(contest, "do_intersect, EPICK");
#endif
}

}  // namespace isect::bench::peers
