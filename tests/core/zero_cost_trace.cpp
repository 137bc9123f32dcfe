// Compiled by zero_cost_trace.cmake, with and without the core's trace lines: the calls of one header, named
// by INTERSECT or METHODS. LISTEN adds a listener.

#ifdef INTERSECT
#include "core/ray_sphere.h"
#else
#include "core/ray_sphere_methods.h"
#endif

using namespace isect;

#ifdef LISTEN
template <class Event>
struct Listener {
  static inline Record<Event> record;
};
#define HEAR(...) , Listener<__VA_ARGS__>::record
#else
#define HEAR(...)
#endif

#ifdef INTERSECT
#define CALLS(S, N)                                                               \
  RaySphere<S> call_intersect(const Ray<S, N>& ray, const Sphere<S, N>& sphere) { \
    return intersect(ray, sphere HEAR(ray_sphere::Event));                        \
  }
#else
#define CALLS(S, N)                                                                   \
  std::optional<S> call_quadratic(const Ray<S, N>& ray, const Sphere<S, N>& sphere) { \
    return ray_sphere::quadratic(ray, sphere HEAR(ray_sphere::QuadraticEvent<S, N>)); \
  }                                                                                   \
  std::optional<S> call_half_b(const Ray<S, N>& ray, const Sphere<S, N>& sphere) {    \
    return ray_sphere::half_b(ray, sphere HEAR(ray_sphere::QuadraticEvent<S, N>));    \
  }                                                                                   \
  std::optional<S> call_haines(const Ray<S, N>& ray, const Sphere<S, N>& sphere) {    \
    return ray_sphere::haines(ray, sphere HEAR(ray_sphere::HainesEvent<S, N>));       \
  }
#endif

CALLS(float, 2)
CALLS(double, 3)
