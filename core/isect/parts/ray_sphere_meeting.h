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

/// The bits of a number: of numbers of one sign the larger in magnitude has the larger bits, and those compare faster.
template <class S>
constexpr auto bits(S x) {
  return std::bit_cast<std::conditional_t<std::is_same_v<S, float>, std::uint32_t, std::uint64_t>>(x);
}

/// Whether |x| is from |least| on and below |most|, and x has their sign, which is one. NaN is not.
template <class S>
ISECT_INLINE bool between(S x, S least, S most) {
  return bits(x) - bits(least) < bits(most) - bits(least);
}

/// Whether a range is [0, inf), bit for bit. [-0, inf) is asked the longer way.
template <class S>
ISECT_INLINE bool from_zero_on(const Interval<S>& range) {
  return bits(range.lo) == 0 && bits(range.hi) == bits(std::numeric_limits<S>::infinity());
}

/// Whether a ray with t >= 0 meets a ball, without a root: by S alone, or settled where rounding may decide.
///
/// Bounds, with R = f.f + r^2 and H = A R: C errs by at most 7 u R, A C by 10 u H, B by 4.1 u |f| |d|, D = B^2 - A C by
/// 32 u H. They hold because r and A are asked to be in a range. So R is at least m^2 and H m^4, and all that
/// underflows adds less than 2^-20 u of them. r^2, A and, where B < 0, B^2 do not overflow; if f.f does, R is infinite,
/// and so is every bound. B may be NaN, which is in no range; then no other number is asked, and otherwise none is NaN.
///
/// |D| beyond its bound and B < 0: D < 0, and the line misses; or D > 0, and the ray heads for the ball, or B is within
/// its error of 0, so that -A C > 0 and the ray begins in the ball: it meets it either way. B >= 0: the ray meets what
/// it begins in, if C is certain; for if C > 0, then A C > 8 u H, and B^2 is below that if B is within its error of 0.
template <class S, int N>
ISECT_INLINE bool quick_meeting(const Ray<S, N>& ray, const Sphere<S, N>& sphere) {
  constexpr bool single = std::is_same_v<S, float>;
  constexpr S m = single ? S(0x1p-25) : S(0x1p-250), most = single ? S(0x1p63) : S(0x1p511);
  constexpr S u = std::numeric_limits<S>::epsilon() / 2;
  const Vector<S, N> f = ray.origin - sphere.center;
  const S ff = f.dot(f), rr = sphere.radius * sphere.radius, reach = ff + rr, c = ff - rr;
  const S b = f.dot(ray.direction), a = ray.direction.dot(ray.direction);
  if (between(sphere.radius, m, most) & between(a, m * m, most)) [[likely]] {  // one branch: && takes longer
    if (between(b, S(-0.0), -most)) [[likely]] {
      const S discriminant = b * b - a * c, bound = (34 * u) * (a * reach);
      if (2 * bits(discriminant) > 2 * bits(bound)) [[likely]]  // twice, which leaves the sign out
        return !std::signbit(discriminant);
    } else if (b >= 0 && std::abs(c) > (16 * u) * reach) {
      return c < 0;
    }
  }
  return settled_meeting(ray, sphere, NoTrace{});
}

}  // namespace isect::ray_sphere::detail
