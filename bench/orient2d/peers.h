#pragma once
// The orientation of three points by CGAL.

#include "bench/orient2d/families.h"
#include "bench/peer.h"
#ifdef ISECT_HAS_CGAL
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#endif

namespace isect::bench::peers {

#ifdef ISECT_HAS_CGAL
/// Enters the orientation of one of CGAL's kernels.
template <class Kernel, class S>
Entrant<OrientCase<S>>& cgal_orientation(Contest<S, OrientCase<S>>& contest, const char* name) {
  using Corner = typename Kernel::Point_2;
  using Corners = std::array<Corner, 3>;
  const auto converted = [](const OrientCase<S>& t) -> Corners {
    return {Corner(t.a[0], t.a[1]), Corner(t.b[0], t.b[1]), Corner(t.c[0], t.c[1])};
  };
  return enter(contest, "CGAL", name, converted,
               [](const Corners& t) { return static_cast<int>(CGAL::orientation(t[0], t[1], t[2])); });
}
#endif

template <class S>
void orient([[maybe_unused]] Contest<S, OrientCase<S>>& contest) {
#ifdef ISECT_HAS_CGAL
  cgal_orientation<CGAL::Simple_cartesian<double>>(contest, "Simple_cartesian<double>");
  cgal_orientation<CGAL::Exact_predicates_inexact_constructions_kernel>(contest, "EPICK").exact();
#endif
}

}  // namespace isect::bench::peers
