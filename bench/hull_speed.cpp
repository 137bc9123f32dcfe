// Hulls and bounding volumes of many points: the core beside qhull and CGAL where they are installed.

#include <functional>

#include "bench/growth_shapes.h"
#include "bench/measure.h"
#include "core/convex_hull_3d.h"

#ifdef ISECT_PEERS
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include "bench/qhull.h"
#endif

using namespace isect;

namespace {

using Points = std::vector<Point<double, 3>>;

/// The whole set is one case; its time is told for each point.
void row(bench::Table& table, const char* method, std::size_t n, const std::function<std::size_t()>& count) {
  const std::vector<int> once = {0};
  bench::Timing t = bench::timed(once, n > 500000 ? 3 : 5, [&](int) { return count(); });
  t.least /= static_cast<double>(n), t.median /= static_cast<double>(n);
  table.row(method, t);
}

#ifdef ISECT_PEERS
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
#endif

void hulls(int n, bool ball) {
  const Points points = bench::cloud(n, ball);
  bench::Table table("hull 3D, " + std::string(ball ? "ball" : "sphere") + ", n = " + std::to_string(n));
  row(table, "isect exact", points.size(), [&] { return convex_hull(points).vertices.size(); });
#ifdef ISECT_PEERS
  row(table, "qhull", points.size(), [&] { return bench::peers::qhull_vertices(points); });
  std::vector<Kernel::Point_3> same;
  for (const Point<double, 3>& p : points) same.emplace_back(p[0], p[1], p[2]);
  row(table, "CGAL", points.size(), [&] {
    CGAL::Surface_mesh<Kernel::Point_3> mesh;
    CGAL::convex_hull_3(same.begin(), same.end(), mesh);
    return static_cast<std::size_t>(mesh.number_of_vertices());
  });
#endif
}

}  // namespace

int main() {
  bench::Table::head(ISECT_FLAGS, "n distinct points, in random order; ns for each; hits: vertices");
  for (const bool ball : {true, false})
    for (const int n : {1000, 10000, 100000, 1000000}) hulls(n, ball);
}
