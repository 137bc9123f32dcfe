#pragma once
// Triangles and boxes by CGAL.

#include "bench/ordinary_shapes.h"
#include "bench/peer_shapes.h"

namespace isect::bench::peers {

template <class S, class Case>
void triangle_aabb([[maybe_unused]] Contest<S, Case>& contest, [[maybe_unused]] std::string_view family) {
#ifdef ISECT_HAS_CGAL
  each_kernel(family, [&]<class K>(K, const char* kernel) {
    struct Shapes {
      typename K::Triangle_3 triangle;
      typename K::Iso_cuboid_3 box;
    };
    enter(
        contest, "CGAL", (std::string("do_intersect, ") + kernel).c_str(),
        [](const Case& c) {
          const auto& [p, q, r] = c.a.vertices;
          return Shapes{{cgal<K>(p), cgal<K>(q), cgal<K>(r)}, cgal<K>(c.b)};
        },
        [](const Shapes& c) { return CGAL::do_intersect(c.triangle, c.box); });
  });
#endif
}

}  // namespace isect::bench::peers
