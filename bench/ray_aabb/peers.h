#pragma once
// Whether a ray meets a box, by CGAL, which finds no t. Except in EPECK its ray goes through origin + direction,
// rounded, and so differs from ours.

#include "bench/ordinary_shapes.h"
#include "bench/peer_shapes.h"

namespace isect::bench::peers {

template <class S, class Case>
void ray_aabb([[maybe_unused]] Contest<S, Case>& contest, [[maybe_unused]] std::string_view family) {
#ifdef ISECT_HAS_CGAL
  each_kernel(family, [&]<class K>(K, const char* kernel) {
    struct Shapes {
      typename K::Ray_3 ray;
      typename K::Iso_cuboid_3 box;
    };
    enter(
        contest, "CGAL", (std::string("do_intersect, ") + kernel).c_str(),
        [](const Case& c) {
          return Shapes{cgal<K>(c.a), cgal<K>(c.b)};
        },
        [](const Shapes& c) { return CGAL::do_intersect(c.ray, c.box); });
  });
#endif
}

}  // namespace isect::bench::peers
