#pragma once
// Whether a ray meets a ball, yes or no: by signs alone, at first in the scalar's own arithmetic.

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <type_traits>

#include <isect/parts/ray_sphere_settle.h>
#include <isect/shapes.h>
#include <isect/trace.h>

namespace isect::ray_sphere::detail {

/// Whether they meet: the signs alone, in one arithmetic after the other.
template <class S, int N, class Trace>
[[gnu::noinline]] bool settled_meeting(const Ray<S, N>& given, const Sphere<S, N>& ball, Trace&& trace) {
  if (!(ball.radius >= 0) || !(given.range.lo <= given.range.hi)) return false;  // empty, or NaN
  const Ray<double, N>& ray = in_doubles(given);
  const Sphere<double, N>& sphere = in_doubles(ball);
  const auto certain = [&](const std::optional<Verdict>& verdict) { return meets(ray.range, *verdict); };
  if (const auto verdict = decide<double>(ray, sphere, trace)) return certain(verdict);
  trace(Fallback{});
  if (!bounded(ray, sphere, ray.range)) return false;
  if ((ray.direction.array() == 0).all()) return settle_point(ray, sphere, ray.range).solid.has_value();
  if (const auto verdict = decide<ShortExact>(ray, sphere, trace)) return certain(verdict);
  if (const std::optional<Scaled<N>> s = scaled(ray, sphere)) {
    if (const auto verdict = decide<double>(s->ray, s->sphere, trace)) return certain(verdict);
    if (const auto verdict = decide<DoubleDouble>(s->ray, s->sphere, trace)) return certain(verdict);
  } else if (const auto verdict = decide<DoubleDouble>(ray, sphere, trace)) {
    return certain(verdict);
  }
  if (const auto verdict = decide<MediumExact>(ray, sphere, trace)) return certain(verdict);
  return certain(decide<Exact>(ray, sphere, trace));
}

/// Whether a range is [0, inf), bit for bit: as numbers they take longer to compare. [-0, inf) is asked the longer way.
template <class S>
ISECT_INLINE bool from_zero_on(const Interval<S>& range) {
  using Bits = std::conditional_t<std::is_same_v<S, float>, std::uint32_t, std::uint64_t>;
  constexpr Bits infinity = std::bit_cast<Bits>(std::numeric_limits<S>::infinity());
  return (std::bit_cast<Bits>(range.lo) | (std::bit_cast<Bits>(range.hi) ^ infinity)) == 0;
}

/// Whether a ray with t >= 0 meets a ball, without a root: by S alone, or settled where rounding may decide. A radius
/// below 0 makes r^2 negative, and with it D: nothing is met.
///
/// Bounds, with H = A (f.f + r^2): A C errs by at most 10 u H, D = B^2 - A C by at most 32 u H, B by 5.1 u |f| |d|.
/// What underflows adds less than u `least` (A + f.f + r^2 + `least`) to each, and where H is above a quarter of what S
/// holds, the bound is infinite. So where |D| is above the bound, D has its true sign. D < 0: the line misses. D > 0
/// and B < 0: the ray heads for the ball; or B is within its error of 0, so that -A C > 0 and the ray begins in the
/// ball: it meets it either way. D > 0 and B >= 0: it meets what it begins in, if C is certain; where C > 0,
/// B^2 > A C > 24 u H, so that B has its true sign, too.
template <class S, int N>
ISECT_INLINE bool quick_meeting(const Ray<S, N>& ray, const Sphere<S, N>& sphere) {
  constexpr S least = std::is_same_v<S, float> ? S(0x1p-62) : S(0x1p-500), u = std::numeric_limits<S>::epsilon() / 2;
  const Vector<S, N> f = ray.origin - sphere.center;
  const S ff = f.dot(f), rr = sphere.radius * std::abs(sphere.radius), reach = ff + rr, c = ff - rr;
  const S b = f.dot(ray.direction), a = ray.direction.dot(ray.direction), ac = a * c, discriminant = b * b - ac;
  const S bound = (34 * u / 4) * ((4 * a + least) * (reach + least));
  if (std::abs(discriminant) > bound) [[likely]] {
    if (b < 0) [[likely]]
      return discriminant > 0;
    if (discriminant < 0) return false;
    if (std::abs(ac) > bound) return ac < 0;
  }
  return settled_meeting(ray, sphere, NoTrace{});
}

}  // namespace isect::ray_sphere::detail
