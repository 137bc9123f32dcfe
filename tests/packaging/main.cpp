// Every installed header, and one question: the exact one.
#include <cstdio>

#include "core/conventions.h"
#include "core/counted.h"
#include "core/double_double.h"
#include "core/exact.h"
#include "core/filter.h"
#include "core/ray_sphere.h"
#include "core/ray_sphere_methods.h"
#include "core/shapes.h"
#include "core/trace.h"

int main() {
  const isect::Ray<double, 3> ray = {{-3, 0, 0}, {2, 0, 0}};
  const isect::Sphere<double, 3> sphere = {{1, 0, 0}, 1};
  const isect::RaySphere<double> found = isect::intersect(ray, sphere);
  if (found) std::printf("hit at %g and %g\n", found.roots.lo, found.roots.hi);
}
