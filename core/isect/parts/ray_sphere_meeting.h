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
  if (!finite(ray) || !finite(sphere)) return false;
  if (is_zero(ray.direction)) return settle_point(ray, sphere, ray.range).solid.has_value();
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

/// The bits of a number: of numbers of one sign the larger in magnitude has the larger bits, and those compare faster.
template <class S>
constexpr auto bits(S x) {
  return std::bit_cast<std::conditional_t<std::is_same_v<S, float>, std::uint32_t, std::uint64_t>>(x);
}
/// The first 32 of those bits.
template <class S>
constexpr std::uint32_t head(S x) {
  return static_cast<std::uint32_t>(bits(x) >> (8 * sizeof(S) - 32));
}

/// Returns a number below 2^29 if x is ordinary: from 2^-256 on and below 2^256, in float from 2^-32 on and below 2^32.
template <class S>
ISECT_INLINE std::uint32_t beyond_ordinary(S x) {
  return head(x) - head(std::is_same_v<S, float> ? S(0x1p-32) : S(0x1p-256));
}

/// Whether a range is [0, inf), bit for bit. [-0, inf) takes the longer way.
template <class S>
ISECT_INLINE bool from_zero_on(const Interval<S>& range) {
  return (bits(range.lo) | (bits(range.hi) ^ bits(std::numeric_limits<S>::infinity()))) == 0;
}

/// Whether a ray with t >= 0 meets a ball, without a root: by S alone, or settled where rounding may decide.
///
/// Bounds, with R = f.f + r^2 and H = A R: C errs by at most 7 u R, A C by 10 u H, B by 4.1 u |f| |d|, D = B^2 - A C by
/// 32 u H. They hold because r and A are checked to be ordinary, at least m: so R is at least m^2, H m^3, and all that
/// underflows adds less than 2^-20 u of them. r^2, A and, where B < 0, B^2 do not overflow; if f.f does, R is infinite,
/// and so is every bound. B may be NaN, which is in no range; then no other number is asked, and otherwise none is NaN.
///
/// |D| beyond its bound and B < 0: D < 0, and the line misses; or D > 0, and the ray heads for the ball, or B is within
/// its error of 0, so that -A C > 0 and the ray begins in the ball: it meets it either way. B >= 0: the ray meets what
/// it begins in, if C is certain; for if C > 0, then A C > 8 u H, and B^2 is below that if B is within its error of 0.
template <class S, int N>
ISECT_INLINE bool quick_meeting(const Ray<S, N>& ray, const Sphere<S, N>& sphere) {
  constexpr S most = std::is_same_v<S, float> ? S(-0x1p32) : S(-0x1p256), u = std::numeric_limits<S>::epsilon() / 2;
  const Vector<S, N> f = ray.origin - sphere.center;
  const S ff = f.dot(f), rr = sphere.radius * sphere.radius, reach = ff + rr, c = ff - rr;
  const S b = f.dot(ray.direction), a = ray.direction.dot(ray.direction);
  if ((beyond_ordinary(sphere.radius) | beyond_ordinary(a)) < 1u << 29) [[likely]] {
    if (head(b) - head(S(-0.0)) < head(most) - head(S(-0.0))) [[likely]] {
      const S discriminant = b * b - a * c, bound = (34 * u) * (a * reach);
      if (2 * bits(discriminant) > 2 * bits(bound)) [[likely]]  // twice, which leaves the sign out
        return !std::signbit(discriminant);
    } else if (b >= 0 && std::abs(c) > (16 * u) * reach) {
      return c < 0;
    }
  }
  NoTrace nobody;
  return settled_meeting(ray, sphere, nobody);
}

}  // namespace isect::ray_sphere::detail
