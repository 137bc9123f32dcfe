#include <isect/aabb_frustum.h>

#include "bench/rational.h"
#include "tests/catch.h"
#include "tests/core/common.h"
#include "tests/core/frustums.h"
#include "tests/settings.h"

namespace aabb_frustum_test {
using namespace isect;
using namespace isect::oracle;
using tests::inf, tests::not_a_number;

namespace {

/// A cube with that half-width.
template <class S>
Aabb<S, 3> cube(double x, double y, double z, double half) {
  const Vector<double, 3> c(x, y, z), h = Vector<double, 3>::Constant(half);
  return {Vector<double, 3>(c - h).cast<S>(), Vector<double, 3>(c + h).cast<S>()};
}

template <class S>
Culling culled(const Aabb<S, 3>& box) {
  return cull(box, tests::pyramid<S>());
}

}  // namespace

TEMPLATE_TEST_CASE("a box is outside, inside or crossing", "[aabb_frustum]", float, double) {
  using S = TestType;
  CHECK(culled(cube<S>(0, 0, 5, 1)) == Culling::inside);
  CHECK(culled(cube<S>(0, 0, -5, 1)) == Culling::outside);
  CHECK(culled(cube<S>(9, 0, 3, 1)) == Culling::outside);
  CHECK(culled(cube<S>(5, 0, 5, 1)) == Culling::crossing);
  CHECK(culled(cube<S>(0, 0, 5, 90)) == Culling::crossing);
  CHECK(culled(cube<S>(5, 5, 5, 0)) == Culling::inside);  // a point of an edge
}

TEMPLATE_TEST_CASE("an ulp decides at the side planes and the far plane", "[aabb_frustum]", float, double) {
  using S = TestType;
  const auto above = [](double z) { return std::nextafter(S(z), S(99)); };
  Aabb<S, 3> box = cube<S>(0, 0, 7, 1);
  CHECK(culled(box) == Culling::inside);
  box.hi[2] = above(8);
  CHECK(culled(box) == Culling::crossing);
  box = cube<S>(0, 0, 9, 1);
  CHECK(culled(box) == Culling::crossing);  // touches: common points
  box.lo[2] = above(8);
  CHECK(culled(box) == Culling::outside);
  box = cube<S>(3, 0, 5, 1);
  CHECK(culled(box) == Culling::inside);  // its edge lies in x = z
  box.hi[0] = above(4);
  CHECK(culled(box) == Culling::crossing);
}

TEST_CASE("near an edge a box may be outside and called crossing", "[aabb_frustum]") {
  // two planes that meet at 11 degrees, in the line x = y = 0
  Frustum<double> sharp;
  sharp.planes = {
      {{{0.1, 1, 0}, 0}, {{0.1, -1, 0}, 0}, {{1, 0, 0}, 9}, {{-1, 0, 0}, 9}, {{0, 0, 1}, 9}, {{0, 0, -1}, 9}}};
  CHECK(cull(cube<double>(-2, 0, 0, 1), sharp) == Culling::crossing);  // all of the frustum has x >= 0
}

TEMPLATE_TEST_CASE("box and frustum: what is empty, NaN or infinite is outside", "[aabb_frustum]", float, double) {
  using S = TestType;
  CHECK(culled(cube<S>(0, 0, 5, -1)) == Culling::outside);
  for (const double bad : {not_a_number, inf, -inf}) {
    CHECK(culled(cube<S>(0, bad, 5, 1)) == Culling::outside);
    CHECK(culled(cube<S>(0, 0, 5, bad)) == Culling::outside);
    Frustum<S> f = tests::pyramid<S>();
    f.planes[5].d = S(bad);
    CHECK(cull(cube<S>(0, 0, 5, 1), f) == Culling::outside);
    f = tests::pyramid<S>();
    f.planes[5].normal[0] = S(bad);
    CHECK(cull(cube<S>(0, 0, 5, 1), f) == Culling::outside);
  }
}

TEMPLATE_TEST_CASE("box and frustum: a zero normal bounds nothing, or everything", "[aabb_frustum]", float, double) {
  using S = TestType;
  Frustum<S> f = tests::pyramid<S>();
  f.planes[5] = {Vector<S, 3>::Zero(), S(1)};
  CHECK(cull(cube<S>(0, 0, 50, 1), f) == Culling::inside);
  f.planes[5].d = S(-0.0);
  CHECK(cull(cube<S>(0, 0, 50, 1), f) == Culling::inside);
  f.planes[5].d = S(-1);
  CHECK(cull(cube<S>(0, 0, 5, 1), f) == Culling::outside);
}

TEMPLATE_TEST_CASE("box and frustum: lengths of any size give the same verdict", "[aabb_frustum]", float, double) {
  using S = TestType;
  constexpr int most = std::numeric_limits<S>::max_exponent - 5;
  for (const int e : {-most, -most / 2, most / 2, most}) {
    const double k = std::ldexp(1.0, e);
    Frustum<S> f = tests::pyramid<S>();
    for (Plane<S, 3>& plane : f.planes) plane.d = std::ldexp(plane.d, e);
    CHECK(cull(cube<S>(0, 0, 7 * k, k), f) == Culling::inside);
    CHECK(cull(cube<S>(0, 0, 8 * k, k), f) == Culling::crossing);
    CHECK(cull(cube<S>(0, 0, 10 * k, k), f) == Culling::outside);
  }
}

TEST_CASE("the events tell each plane up to the first that shuts the box out", "[aabb_frustum]") {
  Record<aabb_frustum::Event> record;
  CHECK(cull(cube<double>(0, 0, 9.5, 1), tests::pyramid<double>(), record) == Culling::outside);
  const auto& last = std::get<aabb_frustum::Tested>(record.events.back());
  CHECK((last.plane == 5 && last.side == Culling::outside));
}

TEMPLATE_TEST_CASE("box and frustum: culling is that of rational arithmetic", "[aabb_frustum]", float, double) {
  using S = TestType;
  bench::Random random(tests::seed());
  int seen[3] = {};
  for (const bench::Numbers numbers : bench::all_numbers)
    for (int i = 0; i < tests::cases(800, 125000); ++i) {
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      Frustum<S> f = tests::frustum<S>(random, numbers);
      Aabb<S, 3> box = bench::box<S, 3>(random, random.one_in(2) ? bench::Numbers::nudged : numbers);
      if (random.one_in(2)) {
        const Point<S, 3> middle = (box.lo / 2 + box.hi / 2) / 2;
        box = {middle + (box.lo - middle) / 8, middle + (box.hi - middle) / 8};
        box.lo[2] += S(5), box.hi[2] += S(5);
      }
      if (random.one_in(3)) {
        Plane<S, 3>& plane = f.planes[random.below(6)];  // moved so that it touches a corner, up to rounding
        const Point<S, 3>& corner = random.one_in(2) ? box.lo : box.hi;
        const double d = -plane.normal.template cast<double>().dot(corner.template cast<double>());
        plane.d = bench::moved(static_cast<S>(d), random.integer(-1, 1));
      }
      if (!finite(box) || !finite(f) || empty(box)) continue;

      // by all eight corners
      Culling truth = Culling::inside;
      for (const Plane<S, 3>& p : f.planes) {
        int beyond = 0;
        for (int k = 0; k < 8; ++k) {
          Rational h = p.d;
          for (int axis = 0; axis < 3; ++axis)
            h += Rational(p.normal[axis]) * Rational((k >> axis & 1 ? box.hi : box.lo)[axis]);
          beyond += h < 0;
        }
        if (beyond == 8) truth = Culling::outside;
        if (truth == Culling::inside && beyond > 0) truth = Culling::crossing;
      }
      const Culling c = cull(box, f);
      if (c != truth) FAIL("wrong");
      Record<aabb_frustum::Event> record;
      if (cull(box, f, record) != c) FAIL("not the same when traced");
      ++seen[static_cast<int>(c)];
    }
  for (const int count : seen) CHECK(count > 500);
}

}  // namespace aabb_frustum_test
