// One question to the installed core: the exact one, and one to a method, by the name that its header had before it
// moved. Every installed header is compiled alone beside this.
#include <cstdio>

#include <isect/ray_sphere.h>
#include <isect/ray_sphere_methods.h>

int main() {
  const isect::Ray<double, 3> ray = {{-3, 0, 0}, {2, 0, 0}};
  const isect::Sphere<double, 3> sphere = {{1, 0, 0}, 1};
  const isect::RaySphere<double> found = isect::intersect(ray, sphere);
  if (!found) return 1;
  std::printf("hit at %g and %g, and by quadratic at %g\n", found.roots.lo, found.roots.hi,
              isect::ray_sphere::quadratic(ray, sphere).value());
}
