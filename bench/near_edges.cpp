#include "bench/near_edges.h"

#include <cmath>

#include <isect/methods/point_polygon.h>
#include <isect/numbers/exact.h>
#include <isect/point_polygon.h>
#include "bench/random_shapes.h"

namespace isect::bench::near_edges {
namespace {

using Point2 = Point<double, 2>;

/// A star around the origin. Each vertex has |x| + |y| between 0.3 and 1, and multiples of 2^-23 as coordinates: so an
/// edge holds doubles.
Ring<double, 2> star(Random& random, int n) {
  Ring<double, 2> ring;
  for (int i = 0; i < n; ++i) {
    const double turn = 4 * (i + random.unit()) / n, radius = random.uniform(0.3, 1);
    const int quarter = static_cast<int>(turn);
    const double t = turn - quarter;
    const Point2 first = {1 - t, t}, turned[] = {first, {-t, 1 - t}, {t - 1, -t}, {t, t - 1}};
    Point2 v = radius * turned[quarter];
    for (int k = 0; k < 2; ++k) v[k] = std::floor(v[k] * 0x1p23) * 0x1p-23;
    ring.push_back(v);
  }
  return ring;
}

/// Positive where p lies left of the point that the edge has at p's height.
int left_of(const Point2& p, const Point2& a, const Point2& b) {
  const Exact ax = a[0], ay = a[1];
  const int side = ((Exact(b[0]) - ax) * (Exact(p[1]) - ay) - (Exact(b[1]) - ay) * (Exact(p[0]) - ax)).sign();
  return b[1] > a[1] ? side : -side;
}

/// The double nearest to the abscissa at which the edge has this height.
double abscissa_at(double y, const Point2& a, const Point2& b) {
  const Exact rise = Exact(b[1]) - Exact(a[1]);
  return quotient(Exact(a[0]) * rise + (Exact(y) - Exact(a[1])) * (Exact(b[0]) - Exact(a[0])), rise);
}

/// The points of all rows beside an edge from a to b, at the height of e.
void beside(const Point2& e, const Point2& a, const Point2& b, const Ring<double, 2>& ring,
            const std::function<void(const Query&)>& visit) {
  const bool inside_is_right = b[1] < a[1];  // the ring runs counter-clockwise
  const Point2 nearest = {abscissa_at(e[1], a, b), e[1]};
  for (const int side : {-1, 1}) {
    Point2 p = nearest;
    int step = -side * left_of(p, a, b) > 0 ? 1 : 0;
    for (std::size_t row = 1; row < steps.size(); ++row) {
      p[0] = moved(p[0], side * (steps[row] - step));
      step = steps[row];
      visit({static_cast<int>(row), ring, p, inside_is_right == (side > 0)});
    }
  }
}

}  // namespace

void each_query(const std::function<void(const Query&)>& visit) {
  Random random(stream(1, "near edges"));
  constexpr int rings = 256, edges = 128, corners = 8;
  for (int i = 0; i < rings; ++i) {
    const Ring<double, 2> ring = star(random, corners);
    for (int k = 0; k < edges; ++k) {
      const int from = random.below(corners);
      const Point2 &a = ring[from], &b = ring[(from + 1) % corners];
      const double t = random.uniform(0.125, 0.875);  // far from the vertices, where another edge begins
      if (a[1] == b[1]) continue;
      const double few_bits = std::floor(t * 0x1p22) * 0x1p-22;
      visit({0, ring, a + few_bits * (b - a), b[1] < a[1]});  // without rounding
      beside(a + t * (b - a), a, b, ring, visit);
    }
  }
}

const std::vector<Method>& methods() {
  using namespace point_polygon;
  static const std::vector<Method> all = [] {
    std::vector<Method> found = {
        {"division", {}}, {"multiplication", {}}, {"translated", {}}, {"winding", {}}, {"exact", {}}};
    each_query([&](const Query& q) {
      const Location truth = q.row == 0 ? Location::on : q.inside ? Location::in : Location::out;
      const bool says[] = {crossings_naive(q.point, q.ring), crossings_multiplied(q.point, q.ring),
                           crossings_translated(q.point, q.ring), winding_naive(q.point, q.ring) != 0,
                           (locate(q.point, q.ring) == truth) == q.inside};
      for (std::size_t i = 0; i < found.size(); ++i) {
        Row& row = found[i].rows[static_cast<std::size_t>(q.row)];
        Count& side = q.inside ? row.inside : row.outside;
        ++side.points, side.wrong += says[i] != q.inside;
      }
    });
    return found;
  }();
  return all;
}

}  // namespace isect::bench::near_edges
