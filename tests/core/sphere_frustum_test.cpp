#include <isect/sphere_frustum.h>

#include "bench/rational.h"
#include "tests/catch.h"
#include "tests/core/common.h"
#include "tests/core/frustums.h"
#include "tests/settings.h"

namespace sphere_frustum_test {
using namespace isect;
using namespace isect::oracle;
using tests::inf, tests::not_a_number;

namespace {

template <class S>
Sphere<S, 3> ball(double x, double y, double z, double radius) {
  return {Vector<double, 3>(x, y, z).cast<S>(), S(radius)};
}

template <class S>
Culling culled(const Sphere<S, 3>& sphere) {
  return cull(sphere, tests::pyramid<S>());
}

}  // namespace

TEMPLATE_TEST_CASE("a ball is outside, inside or crossing", "[sphere_frustum]", float, double) {
  using S = TestType;
  CHECK(culled(ball<S>(0, 0, 5, 2)) == Culling::inside);
  CHECK(culled(ball<S>(0, 0, -5, 2)) == Culling::outside);
  CHECK(culled(ball<S>(9, 0, 3, 2)) == Culling::outside);
  CHECK(culled(ball<S>(5, 0, 5, 2)) == Culling::crossing);
  CHECK(culled(ball<S>(0, 0, 5, 90)) == Culling::crossing);
  CHECK(culled(ball<S>(0, 0, 5, 0)) == Culling::inside);
  CHECK(culled(ball<S>(5, 0, 5, 0)) == Culling::inside);  // in the surface
}

TEMPLATE_TEST_CASE("an ulp decides at the near and the far plane", "[sphere_frustum]", float, double) {
  using S = TestType;
  CHECK(culled(ball<S>(0, 0, 7, 1)) == Culling::inside);  // touches from within
  CHECK(culled(ball<S>(0, 0, std::nextafter(S(7), S(9)), 1)) == Culling::crossing);
  CHECK(culled(ball<S>(0, 0, 9, 1)) == Culling::crossing);  // touches from beyond: a common point
  CHECK(culled(ball<S>(0, 0, std::nextafter(S(9), S(10)), 1)) == Culling::outside);
}

TEST_CASE("near an edge a ball may be outside and called crossing", "[sphere_frustum]") {
  // two planes that meet at 11 degrees, in the line x = y = 0
  Frustum<double> sharp;
  sharp.planes = {
      {{{0.1, 1, 0}, 0}, {{0.1, -1, 0}, 0}, {{1, 0, 0}, 9}, {{-1, 0, 0}, 9}, {{0, 0, 1}, 9}, {{0, 0, -1}, 9}}};
  CHECK(cull(ball<double>(-2, 0, 0, 1), sharp) == Culling::crossing);  // all of the frustum has x >= 0
}

TEMPLATE_TEST_CASE("sphere and frustum: what is empty, NaN or infinite is outside", "[sphere_frustum]", float, double) {
  using S = TestType;
  CHECK(culled(ball<S>(0, 0, 5, -1)) == Culling::outside);
  for (const double bad : {not_a_number, inf, -inf}) {
    CHECK(culled(ball<S>(0, 0, 5, bad)) == Culling::outside);
    CHECK(culled(ball<S>(0, bad, 5, 1)) == Culling::outside);
    Frustum<S> f = tests::pyramid<S>();
    f.planes[5].d = S(bad);
    CHECK(cull(ball<S>(0, 0, 5, 1), f) == Culling::outside);
    f = tests::pyramid<S>();
    f.planes[5].normal[0] = S(bad);
    CHECK(cull(ball<S>(0, 0, 5, 1), f) == Culling::outside);
  }
}

TEMPLATE_TEST_CASE("sphere and frustum: a zero normal bounds nothing, or everything", "[sphere_frustum]", float,
                   double) {
  using S = TestType;
  Frustum<S> f = tests::pyramid<S>();
  f.planes[5] = {Vector<S, 3>::Zero(), S(1)};
  CHECK(cull(ball<S>(0, 0, 50, 1), f) == Culling::inside);
  f.planes[5].d = S(-0.0);
  CHECK(cull(ball<S>(0, 0, 50, 1), f) == Culling::inside);
  f.planes[5].d = S(-1);
  CHECK(cull(ball<S>(0, 0, 5, 1), f) == Culling::outside);
}

TEMPLATE_TEST_CASE("sphere and frustum: lengths of any size give the same verdict", "[sphere_frustum]", float, double) {
  using S = TestType;
  constexpr int most = std::numeric_limits<S>::max_exponent - 5;
  for (const int e : {-most, -most / 2, most / 2, most}) {
    const double k = std::ldexp(1.0, e);
    Frustum<S> f = tests::pyramid<S>();
    for (Plane<S, 3>& plane : f.planes) plane.d = std::ldexp(plane.d, e);
    CHECK(cull(ball<S>(0, 0, 7 * k, k), f) == Culling::inside);
    CHECK(cull(ball<S>(0, 0, 8 * k, k), f) == Culling::crossing);
    CHECK(cull(ball<S>(0, 0, 10 * k, k), f) == Culling::outside);
  }
}

TEST_CASE("the events tell each plane up to the first that shuts the ball out", "[sphere_frustum]") {
  Record<sphere_frustum::Event> record;
  CHECK(cull(ball<double>(0, 0, 9.5, 1), tests::pyramid<double>(), record) == Culling::outside);
  const auto& last = std::get<sphere_frustum::Tested>(record.events.back());
  CHECK((last.plane == 5 && last.side == Culling::outside));
}

TEMPLATE_TEST_CASE("sphere and frustum: culling is that of rational arithmetic", "[sphere_frustum]", float, double) {
  using S = TestType;
  bench::Random random(tests::seed());
  int seen[3] = {};
  for (const bench::Numbers numbers : bench::all_numbers)
    for (int i = 0; i < tests::cases(800, 125000); ++i) {
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      const Frustum<S> f = tests::frustum<S>(random, numbers);
      Sphere<S, 3> sphere = bench::ball<S, 3>(random, random.one_in(2) ? bench::Numbers::nudged : numbers);
      if (random.one_in(2)) sphere.center[2] += S(5), sphere.radius /= S(random.integer(1, 4));
      const Plane<S, 3>& plane = f.planes[random.below(6)];
      if (random.one_in(3)) {
        const Vector<double, 3> n = plane.normal.template cast<double>();
        const double height = std::abs(n.dot(sphere.center.template cast<double>()) + double(plane.d)) / n.stableNorm();
        sphere.radius = bench::moved(static_cast<S>(height), random.integer(-1, 1));
      }
      if (!finite(sphere) || !finite(f) || sphere.radius < 0) continue;

      // by the point of each plane nearest to the center
      Culling truth = Culling::inside;
      const Rational radius = sphere.radius;
      for (const Plane<S, 3>& p : f.planes) {
        const Coordinates<3> n = rational(p.normal);
        const Rational h = dot(n, rational(sphere.center)) + Rational(p.d), n2 = dot(n, n);
        const Coordinates<3> foot = n2 == 0 ? n : Rational(h / n2) * n;
        const int clear = n2 == 0 ? 1 : sign(dot(foot, foot) - radius * radius);
        if (h < 0 && clear > 0) truth = Culling::outside;
        if (truth == Culling::inside && (h < 0 || clear < 0)) truth = Culling::crossing;
      }
      const Culling c = cull(sphere, f);
      if (c != truth) FAIL("wrong");

      // a point of the ball in all half-spaces refutes outside, one beyond a plane refutes inside: the definition
      bool center_in = true;
      for (const Plane<S, 3>& p : f.planes)
        center_in &= dot(rational(p.normal), rational(sphere.center)) + Rational(p.d) >= 0;
      if (center_in ? c == Culling::outside : c == Culling::inside) FAIL("the center says otherwise");
      Record<sphere_frustum::Event> record;
      if (cull(sphere, f, record) != c) FAIL("not the same when traced");
      ++seen[static_cast<int>(c)];
    }
  for (const int count : seen) CHECK(count > 500);
}

}  // namespace sphere_frustum_test
