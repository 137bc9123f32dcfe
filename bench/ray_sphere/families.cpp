#include "bench/ray_sphere/families.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string_view>

#include "bench/ray_sphere/generators.h"

namespace isect::bench {
namespace {

using namespace generators;

template <int N>
Wide<N> unit_scale(Random& random) {
  return aimed<N>(random, {random.uniform(0.5, 2), random.uniform(0, 8), random.uniform(0, 2)});
}

template <class S, int N>
Case<S, N> ordinary(Random& random) {
  return narrowed<S, N>(unit_scale<N>(random));
}

template <class S, int N>
Case<S, N> exact_tangent(Random& random) {
  const Tangent<N> t = tangent<S, N>(random);
  const Whole<N> origin = t.point - random.integer(-20, 60) * t.along;
  const Case<S, N> c = exactly<S, N>(origin, t.along, t.center, t.radius);
  return scaled(random, c, 30);
}

template <class S, int N>
Case<S, N> near_tangent(Random& random) {
  if (random.one_in(2)) return nudged(random, exact_tangent<S, N>(random));
  const double ulp = std::numeric_limits<S>::epsilon();
  return narrowed<S, N>(aimed<N>(random, {std::pow(10, random.uniform(-1, 1)), std::pow(10, random.uniform(0, 4)),
                                          1 + random.integer(-8, 8) * ulp}));
}

/// A tangent case with its origin on the surface, heading anywhere, and sometimes along the tangent.
template <class S, int N>
Case<S, N> on_surface(Random& random) {
  const Tangent<N> t = tangent<S, N>(random);
  const Whole<N> direction = random.one_in(3) ? t.along : small<N>(random, 1000);
  return scaled(random, exactly<S, N>(t.point, direction, t.center, t.radius), 30);
}

template <class S, int N>
Case<S, N> near_surface(Random& random) {
  if (random.one_in(2)) return nudged(random, on_surface<S, N>(random), 3);
  Wide<N> c = unit_scale<N>(random);
  c.ray.origin = c.sphere.center + c.sphere.radius * random.heading<N>();
  return nudged(random, narrowed<S, N>(c), 3);
}

/// Segments, rays and points whose ends lie exactly on the surface: r(1) = p for a surface point p.
template <class S, int N>
Case<S, N> range_ends(Random& random) {
  const Tangent<N> t = tangent<S, N>(random);
  const Whole<N> origin = random.one_in(3) ? Whole<N>(t.point - random.integer(1, 20) * t.along)
                                           : Whole<N>(t.point + small<N>(random, 1 << 20));
  Case<S, N> c = exactly<S, N>(origin, t.point - origin, t.center, t.radius);
  const S one = random.one_in(2) ? S(1) : nudged(random, S(1), 2);
  const S other = static_cast<S>(random.uniform(-3, 5));
  const std::array<Interval<S>, 6> ranges = {
      Interval<S>{S(0), one}, {one, std::numeric_limits<S>::infinity()}, {one, one}, {other, one},
      {one, other},           {-std::numeric_limits<S>::infinity(), one}};
  c.ray.range = ranges[random.below(6)];
  return scaled(random, c, 20);
}

/// A range with ends within a few ulp of the roots that the textbook finds.
template <class S, int N>
Case<S, N> range_near_roots(Random& random) {
  const Aim aim = {random.uniform(0.5, 2), random.uniform(0, 20), random.uniform(0, 1.1)};
  Case<S, N> c = narrowed<S, N>(aimed<N>(random, aim));
  const Vector<double, N> d = c.ray.direction.template cast<double>();
  const Vector<double, N> f = c.ray.origin.template cast<double>() - c.sphere.center.template cast<double>();
  const double a = d.squaredNorm(), b = f.dot(d), r = c.sphere.radius;
  const double s = std::sqrt(std::max(0.0, b * b - a * (f.squaredNorm() - r * r)));
  const auto end = [&](double t) { return nudged(random, static_cast<S>(t), 4); };
  const S entry = end((-b - s) / a), exit = end((-b + s) / a), zero = 0;
  constexpr S inf = std::numeric_limits<S>::infinity();
  const std::array<Interval<S>, 6> ranges = {
      Interval<S>{zero, entry}, {entry, exit}, {exit, inf}, {-inf, entry}, {exit, exit}, {entry, inf}};
  c.ray.range = ranges[random.below(6)];
  return c;
}

/// Lines, segments, single points of the line, and empty ranges.
template <class S, int N>
Case<S, N> ranges(Random& random) {
  Case<S, N> c = ordinary<S, N>(random);
  const auto end = [&] { return static_cast<S>(random.one_in(4) ? 0.0 : random.uniform(-4, 12)); };
  const S lo = end(), hi = end();
  switch (random.below(5)) {
    case 0:
      c.ray.range = infinite<S>;
      break;
    case 1:
      c.ray.range = {lo, lo};
      break;
    case 2:
      c.ray.range = {-std::numeric_limits<S>::infinity(), hi};
      break;
    case 3:
      c.ray.range = {std::max(lo, hi), std::min(lo, hi)};
      break;
    default:
      c.ray.range = {std::min(lo, hi), std::max(lo, hi)};
  }
  return c;
}

template <class S, int N>
Case<S, N> far_small(Random& random) {
  const double least = wide<S> ? 3 : 1, most = wide<S> ? 12 : 6;
  return narrowed<S, N>(
      aimed<N>(random, {random.uniform(0.5, 2), std::pow(10, random.uniform(least, most)), random.uniform(0, 2)}));
}

template <class S, int N>
Case<S, N> planet(Random& random) {
  const double radius = 6.371e6, height = random.uniform(2, 1000);
  const Vector<double, N> up = random.heading<N>();
  Vector<double, N> direction = random.heading<N>();
  if (random.one_in(2)) direction = (direction - direction.dot(up) * up) - random.uniform(0, 0.03) * up;
  const Point<double, N> origin = random.in_box<N>(3000), center = origin - (radius + height) * up;
  return narrowed<S, N>({{origin, direction}, {center, radius}});
}

template <class S, int N>
Case<S, N> direction_length(Random& random) {
  Wide<N> c = unit_scale<N>(random);
  c.ray.direction *= std::abs(random.magnitude(-reach<S>, reach<S>));
  return narrowed<S, N>(c);
}

template <class S, int N>
Case<S, N> scale(Random& random) {
  Wide<N> c = random.one_in(4) ? aimed<N>(random, {1, 1e4, random.uniform(0, 2)}) : unit_scale<N>(random);
  const double across = std::abs(random.magnitude(-reach<S>, reach<S>));
  c.ray.origin *= across, c.sphere.center *= across, c.sphere.radius *= across;
  c.ray.direction *= random.one_in(2) ? across : std::abs(random.magnitude(-reach<S>, reach<S>));
  return narrowed<S, N>(c);
}

/// Each number with a size of its own; half of the rays aim at the center, so that some hit.
template <class S, int N>
Case<S, N> mixed_scales(Random& random) {
  const double most = reach<S> * (random.one_in(2) ? 1 : random.unit());
  const auto any = [&] { return random.one_in(8) ? 0.0 : random.magnitude(-most, most); };
  Wide<N> c;
  for (int i = 0; i < N; ++i) c.ray.origin[i] = any(), c.ray.direction[i] = any(), c.sphere.center[i] = any();
  c.sphere.radius = std::abs(any());
  if (random.one_in(2)) c.ray.direction = (c.sphere.center - c.ray.origin) * std::abs(random.magnitude(-6, 6));
  if (random.one_in(2)) c.ray.range = {any(), any()};
  return narrowed<S, N>(c);
}

/// Tangent along an axis, at some scale, with a number of another scale where there was a zero: it alone
/// decides.
template <class S, int N>
Case<S, N> tiny_offset(Random& random) {
  const auto whole = [&](int most) { return static_cast<S>(random.integer(-most, most)); };
  const int i = random.below(N), j = (i + 1) % N;
  Case<S, N> c = {{Point<S, N>::Zero(), Vector<S, N>::Zero()}, {Point<S, N>::Zero(), S(random.integer(0, 5))}};
  c.ray.origin[i] = whole(9);
  c.ray.origin[j] = c.sphere.radius;
  c.ray.direction[i] = static_cast<S>(random.sign());
  if (random.one_in(2)) c.ray.range = {whole(9), whole(9)};
  if (random.one_in(4)) c.ray.origin[j] = whole(5);
  constexpr int most = std::numeric_limits<S>::max_exponent - 8;
  const int across = random.integer(-most / 2, most);
  c = scaled(c, across, random.integer(-20, 20));

  const S side = static_cast<S>(random.sign()), tiny = std::ldexp(side, -random.integer(0, most));
  Vector<S, N>& changed = random.one_in(3) ? c.ray.origin : random.one_in(2) ? c.ray.direction : c.sphere.center;
  S& number = changed[random.below(N)];
  if (number == 0) number = tiny;
  return c;
}

/// Everything among the smallest numbers there are.
template <class S, int N>
Case<S, N> denormal(Random& random) {
  const auto tiny = [&] { return static_cast<S>(random.integer(-64, 64)) * std::numeric_limits<S>::denorm_min(); };
  Case<S, N> c;
  for (int i = 0; i < N; ++i) c.ray.origin[i] = tiny(), c.ray.direction[i] = tiny(), c.sphere.center[i] = tiny();
  c.sphere.radius = std::abs(tiny());
  if (random.one_in(2)) c.ray.direction = random.heading<N>().template cast<S>();
  if (random.one_in(3)) c.ray.range = {tiny(), tiny()};
  return c;
}

/// A sphere of radius 0 on the ray, or next to it.
template <class S, int N>
Case<S, N> zero_radius(Random& random) {
  const Whole<N> origin = small<N>(random, 1 << 12), direction = small<N>(random, 1 << 8);
  const Whole<N> center = origin + random.integer(-3, 12) * direction;
  Case<S, N> c = scaled(random, exactly<S, N>(origin, direction, center, 0), 30);
  if (random.one_in(2)) c.ray.range = {S(0), S(random.integer(0, 4))};
  if (random.one_in(4)) c = nudged(random, c, 1);
  return c;
}

template <class S, int N>
Case<S, N> zero_direction(Random& random) {
  Case<S, N> c = random.one_in(2) ? on_surface<S, N>(random) : ordinary<S, N>(random);
  if (random.one_in(3)) c = nudged(random, c, 2);
  for (int i = 0; i < N; ++i) c.ray.direction[i] = random.one_in(2) ? S(-0.0) : S(0);
  if (random.one_in(2)) c.ray.range = {S(random.integer(-2, 2)), S(random.integer(-2, 2))};
  return c;
}

/// Axis-parallel rays of small integers with zeros of either sign everywhere.
template <class S, int N>
Case<S, N> signed_zeros(Random& random) {
  const auto number = [&](int most) {
    const int n = random.integer(-most, most);
    return n == 0 && random.one_in(2) ? S(-0.0) : S(n);
  };
  Case<S, N> c;
  for (int i = 0; i < N; ++i)
    c.ray.origin[i] = number(2), c.ray.direction[i] = number(1), c.sphere.center[i] = number(2);
  c.sphere.radius = random.one_in(4) ? S(-0.0) : S(random.integer(0, 2));
  if (random.one_in(2)) c.ray.range = {number(2), number(2)};
  return c;
}

template <class S, int N>
constexpr std::array<RaySphereDraw<S, N>, 19> families = {{
    {"ordinary", ordinary<S, N>},
    {"far-small", far_small<S, N>, "a small ball far away, where the squares of the distance swallow its radius."},
    {"planet", planet<S, N>,
     "an eye a little above a ball as large as a planet: the nearer root is a difference of large numbers."},
    {"near-tangent", near_tangent<S, N>, "rays that pass the surface within a few ulp, on either side."},
    {"exact-tangent", exact_tangent<S, N>, "rays that touch the ball in exactly one point."},
    {"on-surface", on_surface<S, N>, "rays that start on the surface, so that t = 0 is a hit."},
    {"near-surface", near_surface<S, N>, "the origin within a few ulp of the sphere."},
    {"range-ends", range_ends<S, N>, "a range that ends exactly on the sphere, or an ulp away."},
    {"range-near-roots", range_near_roots<S, N>, "a range that ends within a few ulp of a root."},
    {"ranges", ranges<S, N>, "lines, segments, points and empty ranges."},
    {"direction-length", direction_length<S, N>,
     "directions from 1e-300 to 1e300 long: their squares overflow or vanish."},
    {"scale", scale<S, N>, "lengths of any size."},
    {"mixed-scales", mixed_scales<S, N>, "each coordinate of its own size."},
    {"tiny-offset", tiny_offset<S, N>, "a number too small for the others to see decides."},
    {"denormal", denormal<S, N>, "the smallest numbers."},
    {"zero-radius", zero_radius<S, N>, "balls that are points."},
    {"zero-direction", zero_direction<S, N>, "a point for a ray."},
    {"signed-zeros", signed_zeros<S, N>, "small integers and zeros of either sign."},
    {"nudged", [](Random& random) { return nudged(random, ordinary<S, N>(random), 1); },
     "an ordinary ray, one number moved by an ulp."},
}};

}  // namespace

template <class S, int N>
std::span<const RaySphereDraw<S, N>> ray_sphere_families() {
  return families<S, N>;
}

template <class S, int N>
const RaySphereDraw<S, N>& ray_sphere_family(const char* name) {
  for (const RaySphereDraw<S, N>& family : families<S, N>)
    if (std::string_view(family.name) == name) return family;
  throw std::invalid_argument(name);
}

template std::span<const RaySphereDraw<float, 2>> ray_sphere_families();
template std::span<const RaySphereDraw<float, 3>> ray_sphere_families();
template std::span<const RaySphereDraw<double, 2>> ray_sphere_families();
template std::span<const RaySphereDraw<double, 3>> ray_sphere_families();
template const RaySphereDraw<float, 2>& ray_sphere_family(const char*);
template const RaySphereDraw<float, 3>& ray_sphere_family(const char*);
template const RaySphereDraw<double, 2>& ray_sphere_family(const char*);
template const RaySphereDraw<double, 3>& ray_sphere_family(const char*);

}  // namespace isect::bench
