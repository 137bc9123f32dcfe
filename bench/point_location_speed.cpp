// What preparing a polygon costs and saves: time, memory and time a query for n = 100 to 1e6, and how they grow.

#include <malloc.h>

#include <cstdlib>
#include <map>

#include "bench/growth_shapes.h"
#include "bench/measure.h"
#include "bench/random.h"
#include "core/point_convex_polygon.h"
#include "core/polygon_grid.h"
#include "core/slab_map.h"
#include "core/trapezoid_map.h"
#ifdef ISECT_PEERS
#include "bench/point_location_peers.h"
#endif

using namespace isect;
using namespace isect::bench;

namespace {

constexpr std::size_t most_slab_bytes = std::size_t{1} << 30;

constexpr const char* names[] = {"convex", "smooth", "spiky"};

/// Anywhere in the square around, or within 1e-4 of the boundary.
Ring<double, 2> query_points(const Ring<double, 2>& ring, int count, bool near) {
  Random random(stream(1, near ? "near" : "anywhere"));
  Ring<double, 2> points;
  for (int i = 0; i < count; ++i) {
    Point<double, 2> p = random.in_box<2>(1);
    if (near) {
      const std::size_t k = static_cast<std::size_t>(random.below(static_cast<int>(ring.size())));
      p = ring[k] + random.unit() * (ring[(k + 1) % ring.size()] - ring[k]) + 1e-4 * p;
    }
    points.push_back(p);
  }
  return points;
}

double bytes_in_use() {
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks) + static_cast<double>(info.hblkhd);
}

/// The least-squares slope of log y over log x.
double exponent(const std::vector<std::pair<double, double>>& points) {
  double x = 0, y = 0, xx = 0, xy = 0, n = static_cast<double>(points.size());
  for (const auto& [a, b] : points) {
    const double u = std::log(a), v = std::log(b);
    x += u, y += v, xx += u * u, xy += u * v;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

struct Growth {
  std::vector<std::pair<double, double>> build, bytes, query;
};
std::map<std::string, Growth> growth;

/// One row: prepare(ring) makes what ask(prepared, point) is asked of.
template <class Prepare, class Ask>
void row(Outline kind, const char* method, const Ring<double, 2>& ring, int queries, const Prepare& prepare,
         const Ask& ask) {
  const double before = bytes_in_use();
  const auto start = std::chrono::steady_clock::now();
  const auto prepared = prepare(ring);
  const std::chrono::duration<double, std::milli> passed = std::chrono::steady_clock::now() - start;
  ask(prepared, ring[0]);  // some peers prepare themselves at the first query
  const std::chrono::duration<double, std::milli> build =
      passed.count() < 0.001 ? passed : std::chrono::steady_clock::now() - start;
  const double n = static_cast<double>(ring.size()), bytes = std::max(0., bytes_in_use() - before);
  const auto count = [&](const auto& p) { return ask(prepared, p); };
  const Timing any = timed(query_points(ring, queries, false), queries > 1000 ? 5 : 2, count),
               near = timed(query_points(ring, queries, true), queries > 1000 ? 5 : 2, count);
  std::printf("%-8s %8.0f %-22s %11.2f %10.1f %12.1f %12.1f %9.4f %9.4f\n", names[static_cast<int>(kind)], n,
              method, build.count(), bytes / n, any.least, near.least,
              static_cast<double>(any.hits) / queries, static_cast<double>(near.hits) / queries);
  std::fflush(stdout);
  Growth& g = growth[std::string(names[static_cast<int>(kind)]) + " " + method];
  if (build.count() > 0.001) g.build.emplace_back(n, build.count());
  if (bytes > 0) g.bytes.emplace_back(n, bytes);
  g.query.emplace_back(n, any.least);
}

void rows(Outline kind, int n) {
  const Ring<double, 2> ring = outline_of(kind, n);
  const auto in = [](const auto& map, const Point<double, 2>& p) { return locate(p, map) != Location::out; };
  row(
      kind, "crossings", ring, std::clamp(100'000'000 / n, 64, 65536), [](const auto& r) { return &r; },
      [](const auto* r, const Point<double, 2>& p) { return locate(p, *r) != Location::out; });
  if (kind == Outline::convex)
    row(
        kind, "wedges", ring, 65536, [](const auto& r) { return make_convex(r).value(); }, in);
  try {
    row(
        kind, "slabs", ring, 65536, [](const auto& r) { return make_slab_map(r, most_slab_bytes); }, in);
  } catch (const std::length_error& e) {
    std::printf("%-8s %8d %-22s %s\n", names[static_cast<int>(kind)], n, "slabs", e.what());
  }
  row(
      kind, "trapezoids", ring, 65536, [](const auto& r) { return make_trapezoid_map(r); }, in);
  row(
      kind, "grid", ring, kind == Outline::spiky && n > 100'000 ? 8192 : 65536,
      [](const auto& r) { return make_polygon_grid(r); }, in);
#ifdef ISECT_PEERS
  const int few = kind == Outline::spiky ? std::clamp(300'000'000 / n, 256, 65536) : 65536;
  row(
      kind, "GEOS indexed", ring, few, [](const auto& r) { return peers::make_geos(r); }, peers::geos_covers);
  row(
      kind, "CGAL CDT hierarchy", ring, kind == Outline::spiky && n > 10'000 ? 4096 : 65536,
      [](const auto& r) { return peers::make_cgal(r); }, peers::cgal_covers);
#endif
}

}  // namespace

/// point_location_speed [n [outline]]: the largest n, 1000000 by default, and one of the outlines only.
int main(int argc, char** argv) {
  const int most = argc > 1 ? std::atoi(argv[1]) : 1'000'000;
  if (argc > 3 || most < 100) {
    std::fprintf(stderr, "usage: %s [largest n, at least 100 [convex | smooth | spiky]]\n", argv[0]);
    return 2;
  }
  std::printf("compiler %s\nflags    %s\ncpu      %s\n", __VERSION__, ISECT_FLAGS, cpu().c_str());
  std::printf(
      "near     within 1e-4 of the boundary; any: in the square around; hits: the share in or on\n\n");
  std::printf("%-8s %8s %-22s %11s %10s %12s %12s %9s %9s\n", "outline", "n", "method", "build ms",
              "bytes/edge", "any ns", "near ns", "any hits", "near hits");
  for (const Outline kind : {Outline::convex, Outline::smooth, Outline::spiky})
    for (int n = 100; n <= most; n *= 10)
      if (argc < 3 || std::string(argv[2]) == names[static_cast<int>(kind)]) rows(kind, n);

  std::printf("\n%-32s %10s %10s %10s\n", "exponent of n", "build", "bytes", "any");
  for (const auto& [name, g] : growth) {
    const auto shown = [](const auto& points) { return points.size() > 1 ? exponent(points) : 0; };
    std::printf("%-32s %10.2f %10.2f %10.2f\n", name.c_str(), shown(g.build), shown(g.bytes), shown(g.query));
  }
}
