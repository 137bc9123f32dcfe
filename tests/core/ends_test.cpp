// The ends of the range, repeats and zeros together: the least and the largest numbers, whose sums and differences may
// be no number, against rationals.

#include <isect/capsule_capsule.h>
#include <isect/ray_aabb.h>
#include <isect/ray_obb.h>
#include <isect/ray_plane.h>
#include <isect/ray_polygon.h>
#include <isect/ray_triangle.h>
#include <isect/sphere_aabb.h>
#include <isect/sphere_capsule.h>
#include <isect/sphere_sphere.h>
#include <isect/triangle_aabb.h>

#include "bench/capsule_capsule/oracle.h"
#include "bench/ray_aabb/oracle.h"
#include "bench/ray_obb/oracle.h"
#include "bench/ray_plane/oracle.h"
#include "bench/ray_polygon/oracle.h"
#include "bench/ray_triangle/oracle.h"
#include "bench/simple_shapes.h"
#include "bench/sphere_aabb/oracle.h"
#include "bench/sphere_capsule/oracle.h"
#include "bench/sphere_sphere/oracle.h"
#include "bench/triangle_aabb/oracle.h"
#include "tests/catch.h"
#include "tests/settings.h"

namespace ends_test {
using namespace isect;
using bench::Numbers;

namespace {

template <class S, int N>
struct Draw {
  bench::Random random{tests::seed()};

  Vector<S, N> vector() { return bench::vector<S, N>(random, Numbers::ends); }
  /// A ray that sometimes begins at `corner`, with any range.
  Ray<S, N> ray(const Point<S, N>& corner) {
    Ray<S, N> ray = {random.one_in(3) ? corner : vector(), vector()};
    if (random.one_in(3)) ray.range = {S(-1), S(1)};
    if (random.one_in(4)) ray.range = infinite<S>;
    return ray;
  }
  /// A ring that is sometimes closed, or has a repeated corner.
  Ring<S, N> ring() {
    Ring<S, N> ring;
    for (int k = 3 + random.below(4); k > 0; --k)
      ring.push_back(ring.empty() || !random.one_in(3) ? vector() : random.one_in(2) ? ring.front() : ring.back());
    return ring;
  }
};

/// Whether the stretch is right to 2 ulp; for a ray that is a point, whether it is rightly found.
template <class S, int N>
bool right(const Ray<S, N>& ray, const std::optional<Interval<S>>& found,
           const std::optional<std::pair<oracle::Rational, oracle::Rational>>& truth) {
  if (found.has_value() != truth.has_value()) return false;
  return !found || ray.direction.isZero(0) ||
         (oracle::ulps(found->lo, truth->first) <= 2 && oracle::ulps(found->hi, truth->second) <= 2);
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("at the ends of the range boxes, balls, capsules and planes meet what they meet", "[ends]",
                       FLOATS_AND_DIMENSIONS) {
  Draw<S, N> draw;
  bench::Random& random = draw.random;
  int hits = 0;
  for (int i = 0; i < tests::cases(2000, 200000); ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    const Sphere<S, N> a = bench::ball<S, N>(random, Numbers::ends);
    Sphere<S, N> b = bench::ball<S, N>(random, Numbers::ends);
    if (random.one_in(3)) b.center = a.center;
    const Aabb<S, N> box = bench::box<S, N>(random, Numbers::ends);
    const Capsule<S, N> c = bench::capsule<S, N>(random, Numbers::ends),
                        d = bench::capsule<S, N>(random, Numbers::ends);
    CHECK(intersects(a, b) == (oracle::relation(a, b) != Relation::disjoint));
    CHECK(intersects(a, box) == (oracle::relation(a, box) != Relation::disjoint));
    CHECK(intersects(a, c) == (oracle::relation(a, c) != Relation::disjoint));
    CHECK(intersects(c, d) == (oracle::relation(c, d) != Relation::disjoint));
    Triangle<S, N> x = {{draw.vector(), draw.vector(), draw.vector()}};
    if (random.one_in(4)) x.vertices[2] = x.vertices[0];
    if (!empty(box)) CHECK(intersects(x, box) == (oracle::triangle_aabb::relation(x, box) != Relation::disjoint));

    const Ray<S, N> ray = draw.ray(box.lo);
    CHECK(right(ray, intersect(ray, box), oracle::ray_aabb(ray, box)));
    hits += intersect(ray, box).has_value();
    const Plane<S, N> plane = {draw.vector(), bench::number<S>(random, Numbers::ends)};
    if (plane.normal.isZero(0)) continue;
    const auto found = intersect(ray, plane);
    const auto truth = oracle::ray_plane(ray, plane);
    CHECK((found.parallel == truth.parallel && found.coplanar == truth.coplanar && found.meets == truth.meets));
    CHECK(found.line.has_value() == truth.line.has_value());
    if (found.line && truth.line) CHECK(oracle::ulps(*found.line, *truth.line) <= 2);
  }
  CHECK(hits > 200);
}

TEMPLATE_TEST_CASE("at the ends of the range rays meet polygons, triangles and tilted boxes as they do", "[ends]",
                   float, double) {
  using S = TestType;
  Draw<S, 3> draw;
  int hits = 0, flat = 0;
  for (int i = 0; i < tests::cases(3000, 300000); ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    const Ring<S, 3> ring = draw.ring();
    const Ray<S, 3> ray = draw.ray(ring[1]);
    const RayPolygon<S> found = intersect(ray, ring);
    const auto truth = oracle::ray_polygon(ray, ring);
    CHECK((found.flat == truth.flat && found.coplanar == truth.coplanar && found.t.has_value() == truth.hit));
    CHECK((found.flat || found.line.has_value() != truth.parallel));
    if (found.line && !truth.parallel) {
      CHECK(found.location == truth.location);
      CHECK(oracle::ulps(*found.line, truth.t) <= 2);
    }
    hits += truth.hit, flat += truth.flat;

    const Triangle<S, 3> x = {{ring[0], ring[1], ring[2]}};
    const auto met = intersect(ray, x);
    const auto met_truly = oracle::ray_triangle(ray, x);
    CHECK((met.coplanar == met_truly.coplanar && met.t.has_value() == met_truly.hit));
    if (met.t && met_truly.hit) CHECK(oracle::ulps(*met.t, met_truly.t) <= 2);

    Obb<S, 3> box = {draw.vector(), {}, draw.vector().cwiseAbs()};
    for (int k = 0; k < 3; ++k) box.axes.col(k) = draw.vector();
    CHECK(right(ray, intersect(ray, box), oracle::ray_obb(ray, box)));
  }
  CHECK((hits > 50 && flat > 200));
}

}  // namespace ends_test
