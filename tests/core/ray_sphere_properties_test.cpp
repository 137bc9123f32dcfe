// What must hold for every ray and every sphere, on the hard families.

#include <cmath>
#include <utility>
#include <vector>

#include "bench/ray_sphere/judge.h"
#include "tests/catch.h"
#include "tests/settings.h"

namespace ray_sphere_properties_test {
using namespace isect;
using namespace isect::bench;

namespace {

constexpr int rays = 400;  // of each family

/// Calls check(case) for rays of every family; what it requires may fail with the case in full.
template <class S, int N, class Check>
void for_all(const Check& check) {
  for (const RaySphereDraw<S, N>& family : ray_sphere_families<S, N>()) {
    Random random(stream(tests::seed(), family.name));
    for (int i = 0; i < rays; ++i) {
      const RaySphereCase<S, N> c = family.draw(random);
      INFO(family.name << ", ISECT_SEED=" << tests::seed() << ": " << text(c));
      check(c, random);
    }
  }
}

/// Whether both can be within the promise of the same true value.
template <class S>
bool near(S x, S y) {
  if (x == y) return true;
  const S ulp = std::max(std::nextafter(std::abs(x), std::numeric_limits<S>::infinity()) - std::abs(x),
                         std::numeric_limits<S>::denorm_min());
  return std::abs(x - y) <= static_cast<S>(2 * promised_ulps + 1) * ulp;
}

template <class S>
bool same_verdicts(const RaySphere<S>& x, const RaySphere<S>& y) {
  return x.line_roots == y.line_roots && x.origin == y.origin && x.surface.has_value() == y.surface.has_value() &&
         x.solid.has_value() == y.solid.has_value();
}

template <class S>
bool same_values(const RaySphere<S>& x, const RaySphere<S>& y) {
  return near(x.roots.lo, y.roots.lo) && near(x.roots.hi, y.roots.hi) && (!x.surface || near(*x.surface, *y.surface)) &&
         (!x.solid || (near(x.solid->lo, y.solid->lo) && near(x.solid->hi, y.solid->hi)));
}

template <class S>
bool identical(const RaySphere<S>& x, const RaySphere<S>& y) {
  return same_verdicts(x, y) && x.roots == y.roots && x.surface == y.surface && x.solid == y.solid;
}

/// Lengths times 2^across, the direction times 2^along, t to suit.
template <class S, int N>
RaySphereCase<S, N> scaled(RaySphereCase<S, N> c, int across, int along) {
  const auto scale = [](S& x, int by) { x = std::ldexp(x, by); };
  for (int i = 0; i < N; ++i)
    scale(c.ray.origin[i], across), scale(c.ray.direction[i], along), scale(c.sphere.center[i], across);
  scale(c.sphere.radius, across);
  scale(c.ray.range.lo, across - along), scale(c.ray.range.hi, across - along);
  return c;
}

/// Whole numbers below 2^10, so that moving by whole numbers is exact.
template <class S, int N>
RaySphereCase<S, N> on_grid(Random& random) {
  const auto vector = [&](int most) {
    Vector<S, N> v;
    for (int i = 0; i < N; ++i) v[i] = static_cast<S>(random.integer(-most, most));
    return v;
  };
  const Point<S, N> origin = vector(30), center = vector(30);
  const Vector<S, N> direction = random.one_in(2) ? Vector<S, N>(center - origin + vector(8)) : vector(5);
  return {{origin, direction}, {center, static_cast<S>(random.integer(0, 20))}};
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("the reversed direction mirrors every t", "[ray_sphere][property]", FLOATS_AND_DIMENSIONS) {
  for_all<S, N>([](const RaySphereCase<S, N>& c, Random&) {
    const Ray<S, N> mirrored = {c.ray.origin, -c.ray.direction, {-c.ray.range.hi, -c.ray.range.lo}};
    const RaySphere<S> one = intersect(c.ray, c.sphere), two = intersect(mirrored, c.sphere);
    REQUIRE(one.line_roots == two.line_roots);
    REQUIRE(one.origin == two.origin);
    REQUIRE(one.surface.has_value() == two.surface.has_value());
    REQUIRE(one.solid.has_value() == two.solid.has_value());
    if (one.line_roots > 0) REQUIRE((near(one.roots.lo, -two.roots.hi) && near(one.roots.hi, -two.roots.lo)));
    if (one.solid) REQUIRE((near(one.solid->lo, -two.solid->hi) && near(one.solid->hi, -two.solid->lo)));
  });
}

TEMPLATE_TEST_CASE_SIG("scaling by powers of two scales every t and changes no verdict", "[ray_sphere][property]",
                       FLOATS_AND_DIMENSIONS) {
  int compared = 0;
  for_all<S, N>([&](const RaySphereCase<S, N>& c, Random& random) {
    constexpr int most = std::numeric_limits<S>::max_exponent / 4;
    const int across = random.integer(-most, most), along = random.integer(-most, most);
    const RaySphereCase<S, N> d = scaled(c, across, along);
    if (text(scaled(d, -across, -along)) != text(c)) return;  // a number was lost to overflow or underflow

    ++compared;
    const RaySphere<S> one = intersect(c.ray, c.sphere), two = intersect(d.ray, d.sphere);
    REQUIRE(same_verdicts(one, two));
    const auto by = [&](S t) { return std::ldexp(t, across - along); };
    const auto matches = [&](S x,
                             S y) {  // where neither lost bits below the normal numbers or above the largest
      return !std::isnormal(x) || !std::isnormal(y) || near(by(x), y);
    };
    if (one.line_roots > 0) REQUIRE((matches(one.roots.lo, two.roots.lo) && matches(one.roots.hi, two.roots.hi)));
  });
  CHECK(compared > 2000);
}

TEMPLATE_TEST_CASE_SIG("moving ray and sphere together changes nothing", "[ray_sphere][property]",
                       FLOATS_AND_DIMENSIONS) {
  Random random(stream(tests::seed(), "translation"));
  for (int i = 0; i < 20 * rays; ++i) {
    const RaySphereCase<S, N> c = on_grid<S, N>(random);
    INFO("ISECT_SEED=" << tests::seed() << ": " << text(c));
    Vector<S, N> by;
    for (int k = 0; k < N; ++k) by[k] = static_cast<S>(random.integer(-1000000, 1000000));
    RaySphereCase<S, N> d = c;
    d.ray.origin += by, d.sphere.center += by;
    const RaySphere<S> one = intersect(c.ray, c.sphere), two = intersect(d.ray, d.sphere);
    REQUIRE(same_verdicts(one, two));
    REQUIRE(same_values(one, two));
  }
}

TEMPLATE_TEST_CASE_SIG("swapping and mirroring axes changes nothing", "[ray_sphere][property]", FLOATS_AND_DIMENSIONS) {
  for_all<S, N>([](const RaySphereCase<S, N>& c, Random& random) {
    const int i = random.below(N), j = (i + 1) % N, flipped = random.below(N);
    RaySphereCase<S, N> d = c;
    for (Vector<S, N>* v : {&d.ray.origin, &d.ray.direction, &d.sphere.center}) {
      std::swap((*v)[i], (*v)[j]);
      (*v)[flipped] = -(*v)[flipped];
    }
    const RaySphere<S> one = intersect(c.ray, c.sphere), two = intersect(d.ray, d.sphere);
    REQUIRE(same_verdicts(one, two));
    REQUIRE(same_values(one, two));
  });
}

TEMPLATE_TEST_CASE_SIG("listening changes no answer", "[ray_sphere][property]", FLOATS_AND_DIMENSIONS) {
  for_all<S, N>([](const RaySphereCase<S, N>& c, Random&) {
    Record<ray_sphere::Event> record;
    REQUIRE(identical(intersect(c.ray, c.sphere, record), intersect(c.ray, c.sphere)));
  });
}

TEMPLATE_TEST_CASE_SIG("every hit lies on the surface", "[ray_sphere][property]", FLOATS_AND_DIMENSIONS) {
  for (const char* name : {"ordinary", "far-small", "planet", "near-tangent", "near-surface", "ranges"}) {
    Random random(stream(tests::seed(), name));
    for (int i = 0; i < 10 * rays; ++i) {
      const RaySphereCase<S, N> c = ray_sphere_family<S, N>(name).draw(random);
      INFO(name << ", ISECT_SEED=" << tests::seed() << ": " << text(c));
      const std::optional<S> t = intersect(c.ray, c.sphere).surface;
      if (!t) continue;
      const Vector<long double, N> from =
          c.ray.at(*t).template cast<long double>() - c.sphere.center.template cast<long double>();
      // Each coordinate of o + t d lies within 4 eps (max |o_i| + |t| max |d_i|).
      const long double coordinate =
          4 * std::numeric_limits<S>::epsilon() *
          (c.ray.origin.cwiseAbs().maxCoeff() + std::abs(*t) * c.ray.direction.cwiseAbs().maxCoeff());
      const long double measuring = 4 * std::numeric_limits<long double>::epsilon() * c.sphere.radius;
      REQUIRE(std::abs(from.norm() - c.sphere.radius) <=
              std::sqrt(static_cast<long double>(N)) * coordinate + measuring);
    }
  }
}

TEMPLATE_TEST_CASE_SIG("a larger ball meets whatever the smaller one meets", "[ray_sphere][property]",
                       FLOATS_AND_DIMENSIONS) {
  for_all<S, N>([](const RaySphereCase<S, N>& c, Random&) {
    Sphere<S, N> larger = c.sphere;
    larger.radius = std::nextafter(larger.radius, std::numeric_limits<S>::infinity());
    const RaySphere<S> one = intersect(c.ray, c.sphere), two = intersect(c.ray, larger);
    REQUIRE(two.line_roots >= one.line_roots);
    if (one) REQUIRE(two);
    if (one.origin == Location::on) REQUIRE(two.origin == Location::in);
  });
}

TEMPLATE_TEST_CASE_SIG("floats meet as the doubles meet that they denote", "[ray_sphere][property]", ((int N), N), 2,
                       3) {
  for_all<float, N>([](const RaySphereCase<float, N>& c, Random&) {
    const Ray<double, N> ray = {c.ray.origin.template cast<double>(),
                                c.ray.direction.template cast<double>(),
                                {c.ray.range.lo, c.ray.range.hi}};
    const Sphere<double, N> sphere = {c.sphere.center.template cast<double>(), c.sphere.radius};
    const RaySphere<float> narrow = intersect(c.ray, c.sphere);
    const RaySphere<double> wide = intersect(ray, sphere);
    REQUIRE(narrow.line_roots == wide.line_roots);
    REQUIRE(narrow.origin == wide.origin);
    REQUIRE(narrow.surface.has_value() == wide.surface.has_value());
    REQUIRE(narrow.solid.has_value() == wide.solid.has_value());
    if (narrow.surface) REQUIRE(near(*narrow.surface, static_cast<float>(*wide.surface)));
  });
}

TEMPLATE_TEST_CASE_SIG("the yes or no and the first hit are those of the full answer, for ranges of every kind",
                       "[ray_sphere][property]", FLOATS_AND_DIMENSIONS) {
  constexpr S infinity = std::numeric_limits<S>::infinity(), nan = std::numeric_limits<S>::quiet_NaN();
  for_all<S, N>([](const RaySphereCase<S, N>& c, Random& random) {
    const RaySphere<S> whole = intersect(c.ray, c.sphere);
    std::vector<S> ends = {-infinity, infinity, 0, -S(0), nan, static_cast<S>(random.uniform(-4, 4))};
    for (const S root : {whole.roots.lo, whole.roots.hi})
      for (const S towards : {-infinity, root, infinity}) ends.push_back(std::nextafter(root, towards));
    for (const S lo : ends)
      for (const S hi : ends) {
        const Ray<S, N> ray = {c.ray.origin, c.ray.direction, {lo, hi}};
        const RaySphere<S> answer = intersect(ray, c.sphere);
        INFO("range " << lo << ", " << hi);
        REQUIRE(intersects(ray, c.sphere) == bool(answer));
        REQUIRE(intersects(ray, c.sphere, [](const auto&) {}) == bool(answer));
        REQUIRE(first_hit(ray, c.sphere) == (answer.solid ? std::optional<S>(answer.solid->lo) : std::nullopt));
      }
  });
}

TEMPLATE_TEST_CASE_SIG("the yes or no is right where squares begin to overflow and to vanish", "[ray_sphere][property]",
                       FLOATS_AND_DIMENSIONS) {
  // A length's square ends at 2^+-half of it, the square of two lengths' product at 2^+-quarter of each; from
  // 2^-quarter down counts what the first pass adds to its bound.
  constexpr int half = std::numeric_limits<S>::max_exponent / 2, quarter = half / 2;
  for (const char* family : {"ordinary", "exact-tangent", "near-tangent", "near-surface", "nudged"}) {
    const RaySphereDraw<S, N>& drawn = ray_sphere_family<S, N>(family);
    Random random(stream(tests::seed(), family));
    for (int i = 0; i < tests::cases(2000, 200000); ++i) {
      RaySphereCase<S, N> c = drawn.draw(random);
      const auto exponent = [&] {
        const int near[] = {0, half, -half, quarter, -quarter, -half - quarter};
        return near[random.below(std::size(near))] + random.integer(-8, 8);
      };
      const int size = exponent(), along = exponent();
      for (int k = 0; k < N; ++k) {
        c.ray.origin[k] = std::ldexp(c.ray.origin[k], size), c.sphere.center[k] = std::ldexp(c.sphere.center[k], size);
        c.ray.direction[k] = std::ldexp(c.ray.direction[k], along);
      }
      c.sphere.radius = std::ldexp(c.sphere.radius, size), c.ray.range = semi_infinite<S>;
      if (!c.ray.origin.allFinite() || !c.ray.direction.allFinite() || !c.sphere.center.allFinite()) continue;
      if (!std::isfinite(c.sphere.radius)) continue;
      INFO(family << " x 2^" << size << ", direction x 2^" << along << ": " << text(c));
      REQUIRE(intersects(c.ray, c.sphere) == oracle::ray_sphere(c.ray, c.sphere).enter.has_value());
    }
  }
}

TEMPLATE_TEST_CASE_SIG("the yes or no is right where the square of B overflows, and A C does not", "[ray_sphere]",
                       FLOATS_AND_DIMENSIONS) {
  constexpr int quarter = std::numeric_limits<S>::max_exponent / 4, digits = std::numeric_limits<S>::digits;
  // The direction's length, as a power of two, and by which power the ray passes nearer than it begins: large all, or
  // only how far away it begins.
  for (const auto& [length, nearer] : {std::pair(quarter, digits), std::pair(quarter / 2 - 1, quarter)}) {
    Random random(tests::seed());
    int found = 0;
    for (int i = 0; i < 100000 && found < 100; ++i) {
      // x y rounds to the least number whose square is too large; |f|^2 |d|^2, of the same factors, rounds to one that
      // is not.
      const S y = std::ldexp(static_cast<S>(random.uniform(1, 2)), length);
      const S x = std::ldexp(S(1), 2 * quarter) / y;
      if (std::isfinite((x * y) * (x * y)) || !std::isfinite((x * x) * (y * y))) continue;
      ++found;
      Ray<S, N> ray = {Point<S, N>::Zero(), Vector<S, N>::Zero()};
      ray.origin[0] = -x, ray.origin[1] = std::ldexp(x, -nearer), ray.direction[0] = y;
      for (const S part : {S(0.5), S(1), S(1.5)}) {  // of the distance at which the ray passes
        const Sphere<S, N> sphere = {Point<S, N>::Zero(), part * ray.origin[1]};
        INFO(text(RaySphereCase<S, N>{ray, sphere}));
        REQUIRE(intersects(ray, sphere) == (part >= 1));
        REQUIRE(oracle::ray_sphere(ray, sphere).enter.has_value() == (part >= 1));
      }
    }
    REQUIRE(found == 100);
  }
}

TEMPLATE_TEST_CASE_SIG("the yes or no holds for no direction, no ball, NaN and infinite coordinates", "[ray_sphere]",
                       FLOATS_AND_DIMENSIONS) {
  const S huge = std::numeric_limits<S>::infinity(), nan = std::numeric_limits<S>::quiet_NaN();
  const Point<S, N> o = Point<S, N>::Zero(), d = Point<S, N>::Unit(0);
  CHECK(intersects(Ray<S, N>{o, o}, Sphere<S, N>{d, 1}));
  CHECK_FALSE(intersects(Ray<S, N>{o, o}, Sphere<S, N>{2 * d, 1}));
  CHECK_FALSE(intersects(Ray<S, N>{o, o, {huge, huge}}, Sphere<S, N>{o, 1}));
  CHECK(intersects(Ray<S, N>{o, d}, Sphere<S, N>{2 * d, 0}));
  CHECK_FALSE(intersects(Ray<S, N>{o, d}, Sphere<S, N>{2 * d, -1}));
  for (const S bad : {huge, -huge, nan}) {
    CHECK_FALSE(intersects(Ray<S, N>{bad * d, d}, Sphere<S, N>{o, 1}));
    CHECK_FALSE(intersects(Ray<S, N>{o, bad * d}, Sphere<S, N>{o, 1}));
    CHECK_FALSE(intersects(Ray<S, N>{o, d}, Sphere<S, N>{bad * d, 1}));
    CHECK_FALSE(intersects(Ray<S, N>{o, d}, Sphere<S, N>{o, bad}));
  }
}

}  // namespace ray_sphere_properties_test
