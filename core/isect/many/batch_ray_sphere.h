#pragma once
// One ray against many spheres: which are hit, and the first hit of all. See isect/many/batch.h, and isect/ray_sphere.h
// for the exact test of one sphere, whose answers these are.
//
// With the unit vector e along the direction, f = p - c from the sphere's center to a point p of the line, b = f.e
// and c = f.f - r^2, the line meets the sphere twice where D = b^2 - c > 0. The point p lies before both where c > 0
// and b < 0, between them where c < 0, behind both where c > 0 and b > 0.
//
// Bounds, u that of S. e is off by at most 7 u in each component, relatively, so b by less than 12 u |f|; then D by
// less than 24 u |f|^2 + 8 u (f.f + r^2), c by less. A p = o + t d, t not 0, is itself off by u w, where w is the sum
// of |o_i| + 2 |t d_i|: that moves D and c by less than 5 u |f| w + 3 u w^2 <= 6 u (f.f + w^2). So all signs are
// certain beyond m = 64 u (f.f + r^2) + 64 u w^2 + tiny; `tiny`, the least normal number, covers what underflows.
// Where c > m and D > m also the sign of b is certain, as b^2 = D + c. Twice f.f + r^2 is formed first: where it is
// finite, so is b^2. Where a set fuses products with sums there are fewer roundings; the bounds serve both.

#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>

#include <isect/many/batch.h>
#include <isect/ray_sphere.h>

namespace isect {

namespace batch {

namespace detail {

/// The direction's unit vector and length; the length is 0 where the filters can't serve.
template <class S, int N>
struct Heading {
  Vector<S, N> unit;
  S length;

  explicit Heading(const Vector<S, N>& d) {
    const S largest = d.cwiseAbs().maxCoeff();
    const Vector<S, N> scaled = d / largest;
    const S norm = std::sqrt(scaled.squaredNorm());
    unit = scaled / norm, length = largest * norm;
    if (!finite(unit) || !std::isfinite(length) || !(length >= std::numeric_limits<S>::min())) length = 0;
  }
};

/// The point at t of a ray, and what rounding it adds to the bound m; infinite where the filter can't serve.
template <class S, int N>
struct Station {
  Point<S, N> at;
  S off;    ///< how far the point may be off
  S slack;  ///< 64 u w^2 + tiny

  Station(const Ray<S, N>& ray, const S& t, bool usable) : at(ray.origin) {
    S reach = 0;
    if (t != 0) {
      const Vector<S, N> step = t * ray.direction;
      at += step, reach = ray.origin.cwiseAbs().sum() + 2 * step.cwiseAbs().sum();
    }
    constexpr S epsilon = std::numeric_limits<S>::epsilon();
    off = epsilon * reach, slack = 32 * epsilon * reach * reach + std::numeric_limits<S>::min();
    if (!usable) slack = std::numeric_limits<S>::infinity();
  }
};

/// b, c, D and m, for several spheres at once.
template <class V>
struct Signs {
  V b, c, discriminant, m;
};
template <class S, int N, class V>
[[gnu::always_inline]] inline void signs(const Station<S, N>& station, const Vector<S, N>& unit,
                                         const std::array<V, N + 1>& sphere, Signs<V>& s) {
  using simd::add_product;
  const V zero = {};
  V f = station.at[0] - sphere[0], b = f * unit[0], ff = f * f;
  for (int k = 1; k < N; ++k) {
    f = station.at[k] - sphere[k];
    add_product(b, f, zero + unit[k]), add_product(ff, f, f);
  }
  const V rr = sphere[N] * sphere[N], twice = S(2) * (ff + rr);
  s.b = b, s.c = ff - rr, s.discriminant = -s.c, s.m = zero + station.slack;
  add_product(s.discriminant, b, b);
  add_product(s.m, twice, zero + S(16) * std::numeric_limits<S>::epsilon());
}

/// Whether the ray's range holds a root: `ends` of its ends are finite; if only one is, it is lo.
template <class S, int N, int ends>
struct HitsSphere {
  Station<S, N> lo, hi;
  Vector<S, N> unit;

  template <class V>
  [[gnu::always_inline]] void operator()(const std::array<V, N + 1>& sphere, FilterSigns<V>& f) const {
    using simd::lower, simd::raise;
    Signs<V> s;
    signs<S, N>(lo, unit, sphere, s);
    f.no = -s.discriminant;
    V size = s.discriminant;
    raise(size, f.no);
    if constexpr (ends > 0) {
      V behind = s.c, c_size = -s.c;
      lower(behind, s.b), raise(f.no, behind);
      raise(c_size, s.c), lower(size, c_size);
    }
    f.sure = size - s.m;
    if constexpr (ends > 1) {
      Signs<V> h;
      signs<S, N>(hi, unit, sphere, h);
      V before = h.c, within = -h.c, least = -h.discriminant, c_size = -h.c;
      lower(before, -h.b), raise(f.no, before);
      lower(within, -s.c), raise(f.no, within);
      raise(least, h.discriminant), raise(c_size, h.c), lower(least, c_size);
      lower(f.sure, least - h.m);
      f.sure -= h.m - h.m;  // NaN where m is infinite
    }
    lower(f.sure, sphere[N]);
  }
};

/// Whether the first hit may be nearer than `limit`, measured from the station; only a no is sure.
///
/// The line enters a sphere no earlier than -b - r. Where it doesn't miss for certain, |f|^2 <= b^2 + r^2 + 2 m, so b
/// is off by less than 14 u (|b| + r) + 64 u sqrt(slack), plus the station's own error. The spheres with c > 2 m and b
/// > 0 lie behind the station: where D >= -m, b^2 > m, so the sign of b is certain.
template <class S, int N>
struct MayBeNearer {
  Station<S, N> from;
  Vector<S, N> unit;
  const S& limit;
  bool starts;  ///< the range starts at the station

  template <class V>
  [[gnu::always_inline]] void operator()(const std::array<V, N + 1>& sphere, FilterSigns<V>& f) const {
    using simd::lower, simd::raise;
    constexpr S margin = 32 * std::numeric_limits<S>::epsilon();
    Signs<V> s;
    signs<S, N>(from, unit, sphere, s);
    f.no = -s.discriminant - s.m;
    V far = -s.b * (1 - margin) - sphere[N] * (1 + margin) - limit;
    lower(far, std::numeric_limits<S>::max() - s.m), raise(f.no, far);
    if (starts) {
      V behind = s.c - 2 * s.m;
      lower(behind, s.b), raise(f.no, behind);
    }
    f.sure = f.no;
  }
};

}  // namespace detail

}  // namespace batch

/// Bit i: whether intersect(ray, spheres[i]).surface has a value. Exact. `set` is one that the machine has.
template <class S, int N>
Mask hits(const Ray<S, N>& ray, const SphereBatch<S, N>& spheres, InstructionSet set = widest()) {
  Ray<S, N> forward = ray;  // the same points, from a finite end if there is one
  if (!std::isfinite(ray.range.lo) && std::isfinite(ray.range.hi))
    forward = {ray.origin, -ray.direction, {-ray.range.hi, -ray.range.lo}};
  const auto [lo, hi] = forward.range;
  const batch::detail::Heading<S, N> heading(forward.direction);
  const bool usable = heading.length > 0 && lo <= hi && lo != infinite<S>.hi && hi != infinite<S>.lo;
  const int ends = std::isfinite(lo) + std::isfinite(hi);
  const batch::detail::Station<S, N> first(forward, ends > 0 ? lo : 0, usable),
      last(forward, ends > 1 ? hi : 0, usable);

  const auto ask = [&]<int count>(std::integral_constant<int, count>) {
    return batch::detail::answers<S>(batch::detail::columns(spheres), spheres.size(), set,
                                     batch::detail::HitsSphere<S, N, count>{first, last, heading.unit},
                                     [&](std::size_t i) { return intersect(ray, spheres[i]).surface.has_value(); });
  };
  if (ends == 0) return ask(std::integral_constant<int, 0>{});
  if (ends == 1) return ask(std::integral_constant<int, 1>{});
  return ask(std::integral_constant<int, 2>{});
}

/// A sphere that is hit first, and where: t in units of |direction|.
template <class S>
struct FirstHit {
  S t;
  std::size_t index;

  friend bool operator==(const FirstHit&, const FirstHit&) = default;
};

/// The least intersect(ray, spheres[i]).surface of all, and the least such i; nothing if none is hit. Only spheres that
/// may be nearer than the nearest so far are tested. `set` is one that the machine has.
template <class S, int N>
std::optional<FirstHit<S>> first_hit(const Ray<S, N>& ray, const SphereBatch<S, N>& spheres,
                                     InstructionSet set = widest()) {
  const auto [lo, hi] = ray.range;
  if (!(lo <= hi)) return {};
  const bool starts = std::isfinite(lo);
  const S start = starts ? lo : S(0);
  const batch::detail::Heading<S, N> heading(ray.direction);
  const batch::detail::Station<S, N> from(ray, start, heading.length > 0);

  // the length from the station to t, rounded up, with room for the errors of t, of the station and of b
  constexpr S epsilon = std::numeric_limits<S>::epsilon();
  const S room = 16 * from.off + 64 * epsilon * std::sqrt(from.slack);
  const auto length = [&](const S& t) {
    const S ulps = 16 * epsilon * (std::abs(t) + std::abs(start)) + std::numeric_limits<S>::min();
    return ((t - start) + ulps) * heading.length + room;
  };
  S limit = length(hi);
  std::optional<FirstHit<S>> best;
  batch::detail::each_block<S>(batch::detail::columns(spheres), spheres.size(), set,
                               batch::detail::MayBeNearer<S, N>{from, heading.unit, limit, starts},
                               [&](std::size_t first, const batch::detail::Bits& bits) {
                                 for (std::uint64_t open = ~bits.sure; open != 0; open &= open - 1) {
                                   const std::size_t i = first + static_cast<std::size_t>(std::countr_zero(open));
                                   const std::optional<S> t = intersect(ray, spheres[i]).surface;
                                   if (!t || (best && !(*t < best->t))) continue;
                                   best = {*t, i}, limit = length(*t);
                                 }
                               });
  return best;
}

}  // namespace isect
