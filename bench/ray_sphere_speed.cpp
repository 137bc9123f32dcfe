// What an exact answer costs: the default ray-sphere call and the note's methods against the naive quadratic.
//
// 65,536 distinct rays a family, in random order, so that branch prediction learns nothing; every method
// makes the same passes over them, and reading them costs each the same ("read").

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <vector>

#include "bench/measure.h"
#include "bench/ray_sphere_families.h"
#include "core/ray_sphere.h"
#include "core/ray_sphere_methods.h"

using namespace isect;
using namespace isect::bench;

namespace {

constexpr int rays = 1 << 16;
constexpr std::uint64_t seed = 1;

template <class S>
using Cases = std::vector<RaySphereCase<S, 3>>;

/// The quadratic as found in textbooks and tutorials.
template <class S>
std::optional<S> naive(const Ray<S, 3>& ray, const Sphere<S, 3>& sphere) {
  const Vector<S, 3> f = ray.origin - sphere.center;
  const S a = ray.direction.dot(ray.direction);
  const S b = 2 * f.dot(ray.direction);
  const S c = f.dot(f) - sphere.radius * sphere.radius;
  const S discriminant = b * b - 4 * a * c;
  if (discriminant < 0) return {};
  const S root = std::sqrt(discriminant);
  const S t0 = (-b - root) / (2 * a), t1 = (-b + root) / (2 * a);
  if (ray.range.contains(t0)) return t0;
  if (ray.range.contains(t1)) return t1;
  return {};
}

template <class S>
double fallback_share(const Cases<S>& cases) {
  int fell = 0;
  for (const RaySphereCase<S, 3>& c : cases) {
    bool once = false;
    intersect(c.ray, c.sphere, [&once](const auto& event) {
      once = once || std::is_same_v<std::decay_t<decltype(event)>, Fallback>;
    });
    fell += once;
  }
  return fell / static_cast<double>(cases.size());
}

template <class S>
void report(const RaySphereFamily<S, 3>& family, int passes) {
  Random random(stream(seed, family.name));
  Cases<S> cases;
  for (int i = 0; i < rays; ++i) cases.push_back(family.draw(random));

  double sum = 0;  // of all t, so that none is dropped
  const auto time = [&](const auto& solve) {
    return timed(cases, passes, [&](const RaySphereCase<S, 3>& c) {
      const std::optional<S> t = solve(c);
      if (t) sum += static_cast<double>(*t);
      return t.has_value();
    });
  };
  using Case = RaySphereCase<S, 3>;
  const Timing read = time([](const Case& c) -> std::optional<S> {
    return c.ray.origin[0] + c.sphere.radius < c.ray.range.hi ? std::optional(c.ray.direction[0])
                                                              : std::nullopt;
  });
  const Timing quick = time([](const Case& c) { return naive(c.ray, c.sphere); });
  const Timing exact = time([](const Case& c) { return intersect(c.ray, c.sphere).surface; });
  const double fell = fallback_share(cases);

  const auto row = [&](const char* method, const Timing& t) {
    std::printf("%-17s %-6s %-10s %8.2f %8.2f %7.2f %7ld", family.name, sizeof(S) == 4 ? "float" : "double",
                method, t.least, t.median, t.least / quick.least, t.hits);
  };
  const auto line = [&](const char* method, const Timing& t) { row(method, t), std::printf("\n"); };
  line("read", read);
  line("naive", quick);
  line("quadratic", time([](const Case& c) { return ray_sphere::quadratic(c.ray, c.sphere); }));
  line("half_b", time([](const Case& c) { return ray_sphere::half_b(c.ray, c.sphere); }));
  line("haines", time([](const Case& c) { return ray_sphere::haines(c.ray, c.sphere); }));
  row("intersect", exact);
  std::printf("  %6.2f %%\n", 100 * fell);
  asm volatile("" : : "g"(sum));
}

}  // namespace

/// ray_sphere_speed [passes], 21 by default.
int main(int argc, char** argv) {
  const int passes = argc > 1 ? std::atoi(argv[1]) : 21;
  if (argc > 2 || passes < 1) {
    std::fprintf(stderr, "usage: %s [passes]\n", argv[0]);
    return 2;
  }
  std::printf("compiler %s\nflags    %s\ncpu      %s\nrays     %d a family, %d passes, seed %d, 3D\n\n",
              __VERSION__, ISECT_FLAGS, cpu().c_str(), rays, passes, static_cast<int>(seed));
  std::printf("%-17s %-6s %-10s %8s %8s %7s %7s %10s\n", "family", "scalar", "method", "ns least", "median",
              "/naive", "hits", "fallback");
  for (const char* family : {"ordinary", "far-small", "near-tangent", "planet", "direction-length"}) {
    report(ray_sphere_family<double, 3>(family), passes);
    report(ray_sphere_family<float, 3>(family), passes);
  }
}
