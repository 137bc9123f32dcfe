#pragma once
// Whether a ray meets a triangle, by CGAL: it finds no t. Except in EPECK its ray goes through origin + direction,
// rounded, and so another way than ours. Embree meets triangles of a scene that is built before: one each would
// measure the scene.

#include "bench/ordinary_shapes.h"
#include "bench/peer_shapes.h"

namespace isect::bench::peers {

template <class S, class Case>
void ray_triangle([[maybe_unused]] Contest<S, Case>& contest, [[maybe_unused]] std::string_view family) {
#ifdef ISECT_HAS_CGAL
  each_kernel(family, [&]<class K>(K, const char* kernel) {
    struct Shapes {
      typename K::Ray_3 ray;
      typename K::Triangle_3 triangle;
    };
    enter(
        contest, "CGAL", (std::string("do_intersect, ") + kernel).c_str(),
        [](const Case& c) {
          const auto& [p, q, r] = c.b.vertices;
          return Shapes{cgal<K>(c.a), typename K::Triangle_3(cgal<K>(p), cgal<K>(q), cgal<K>(r))};
        },
        [](const Shapes& c) { return CGAL::do_intersect(c.ray, c.triangle); });
  });
#endif
}

}  // namespace isect::bench::peers
