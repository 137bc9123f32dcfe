#pragma once
// The signs and the roots of a ray and a sphere, in whatever arithmetic: the texts behind isect/ray_sphere.h, which
// derives their polynomials. Each says nothing where rounding might decide.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <variant>

#include <isect/parts/ray_sphere_arithmetic.h>
#include <isect/shapes.h>
#include <isect/trace.h>

namespace isect {

template <class S>
struct RaySphere;  // the answer: isect/ray_sphere.h

}  // namespace isect

namespace isect::ray_sphere {

/// Where a value of t lies among the roots of a line that meets the sphere. A double root counts as entry.
enum class AmongRoots { before, entry, between, exit, after };

struct Verdict {
  int line_roots;
  Location origin;
  AmongRoots lo, hi;  ///< of the range's ends; meaningless without roots
};

/// What `intersect` reports: the signs it settled, and the numbers they were read from.
struct Decision {
  double a, discriminant, c;
  Verdict verdict;
};
struct Values {
  Interval<double> roots;
};
using Event = std::variant<Decision, Values, Fallback>;

namespace detail {

/// How far, relatively, sums and products may be from their true values before the last rounding: at most an
/// ulp of S.
template <class S>
inline constexpr double tolerance = std::numeric_limits<S>::epsilon() / 2;

template <Arithmetic W, int N>
using Offset = std::array<W, N>;

template <Arithmetic W, int N>
ISECT_INLINE Offset<W, N> from_center(const Ray<double, N>& ray, const Sphere<double, N>& sphere) {
  return [&]<int... i>(std::integer_sequence<int, i...>) {  // no loop, which GCC would vectorise by way of memory
    return Offset<W, N>{difference<W>(ray.origin[i], sphere.center[i])...};
  }
  (std::make_integer_sequence<int, N>());
}

/// x.y
template <Arithmetic W, int N, class X, class Y>
ISECT_INLINE W dot(const X& x, const Y& y) {
  if constexpr (std::same_as<W, DoubleDouble>) return compensated_dot<N>(x, y);
  W sum = product<W>(x[0], y[0]);
  for (int i = 1; i < N; ++i) sum = sum + product<W>(x[i], y[i]);
  return sum;
}

/// |f x d|^2
template <Arithmetic W, int N>
ISECT_INLINE W cross_squared(const Offset<W, N>& f, const Vector<double, N>& d) {
  const auto component = [&](int i, int j) __attribute__((always_inline))->W {
    return product<W>(f[i], d[j]) - product<W>(f[j], d[i]);
  };
  const auto squared = [](const W& k) __attribute__((always_inline))->W { return k * k; };
  W sum = squared(component(0, 1));
  for (int j = 2; j < N; ++j)
    for (int i = 0; i < j; ++i) sum = sum + squared(component(i, j));
  return sum;
}

/// f, A, B, f.f and r^2.
template <Arithmetic W, int N>
struct Numbers {
  Offset<W, N> f;
  W a, b, ff, rr;

  ISECT_INLINE Numbers(const Ray<double, N>& ray, const Sphere<double, N>& sphere)
      : f(from_center<W>(ray, sphere)),
        a(dot<W, N>(ray.direction, ray.direction)),
        b(dot<W, N>(f, ray.direction)),
        ff(dot<W, N>(f, f)),
        rr(product<W>(sphere.radius, sphere.radius)) {}
};
/// Returns these numbers by a call. The texts that run once doubles have failed share its code.
template <Arithmetic W, int N>
[[gnu::noinline]] Numbers<W, N> numbers(const Ray<double, N>& ray, const Sphere<double, N>& sphere) {
  return {ray, sphere};
}

/// Where t = e lies among the roots, for a line that has some; nothing where W can't tell.
///
/// Bounds. Let G_i = |f_i| + |e d_i|. Then g = f + e d has an error of at most g(2) G_i, and with squares,
/// sums and the subtraction C(e) one of at most 8.1 u (sum G_i^2) + 3 u r^2 < 16 u (G^2 + r^2); B(e) one of
/// at most 5.1 u sum G_i |d_i| < 8 u |G| |d| (Cauchy).
template <Arithmetic W, int N>
std::optional<AmongRoots> among_roots(double e, Offset<W, N> f, const Vector<double, N>& d, const W& dd, const W& rr) {
  if (std::isinf(e)) return e > 0 ? AmongRoots::after : AmongRoots::before;

  double reach = 0;  // G^2
  for (int i = 0; i < N; ++i) {
    const double size = std::abs(leading(f[i])) + std::abs(e * d[i]);
    reach += size * size;
    if (e != 0) f[i] = f[i] + product<W>(e, d[i]);
  }
  if (!in_range<W>(reach + leading(rr))) return {};

  const double c_bound = 16 * unit<W> * (reach + leading(rr)), b_bound = 8 * unit<W>;
  const std::optional<int> c = certain_sign<W>(dot<W, N>(f, f) - rr, c_bound * c_bound);
  if (!c) return {};
  if (*c < 0) return AmongRoots::between;

  const std::optional<int> b = certain_sign<W>(dot<W, N>(f, d), b_bound * b_bound * reach * leading(dd));
  if (!b) return {};
  if (*c == 0) return *b > 0 ? AmongRoots::exit : AmongRoots::entry;
  return *b > 0 ? AmongRoots::after : AmongRoots::before;
}

inline Location location(AmongRoots origin) {
  if (origin == AmongRoots::between) return Location::in;
  return origin == AmongRoots::entry || origin == AmongRoots::exit ? Location::on : Location::out;
}

/// Finds every verdict, or nothing where W can't tell. The direction is not zero.
///
/// Bound of D. A component k of f x d has an error of at most g(3) m, m = |f_i d_j| + |f_j d_i|, and |m|^2 <=
/// 2 |f|^2 A. So K = |f x d|^2 errs by at most g(4) K + 2 g(3) sqrt(2) sqrt(K) |f| |d| + 18 u^2 |f|^2 A, and
/// A r^2 by g(6) A r^2. Let T = A r^2 + K and H = A (f.f + r^2), so that T <= H: all in all |error of D|
/// < 14.6 u sqrt(T H) + 18.1 u^2 H. For T >= (26 u)^2 H that is < 15.3 u sqrt(T H), and the computed T is at
/// least 0.64 T, so 32 u sqrt(computed T H) is a bound with room for its own rounding. For a smaller T, |D|
/// <= computed T < 1000 u^2 H never exceeds that bound.
template <Arithmetic W, int N, class Trace>
std::optional<Verdict> decide(const Ray<double, N>& ray, const Sphere<double, N>& sphere, Trace&& trace) {
  const Numbers<W, N> n = numbers<W>(ray, sphere);
  const double reach = leading(n.ff) + leading(n.rr);
  if (!in_range<W>(leading(n.a)) || !in_range<W>(reach)) return {};

  const W arr = n.a * n.rr, cross = cross_squared<W, N>(n.f, ray.direction);
  const W discriminant = arr - cross;
  const double bound2 = 1024 * unit<W> * unit<W> * (leading(arr) + leading(cross)) * (leading(n.a) * reach);
  const std::optional<int> roots = certain_sign<W>(discriminant, bound2);
  if (!roots) return {};

  Verdict verdict = {*roots + 1, Location::out, AmongRoots::before, AmongRoots::before};
  if (verdict.line_roots > 0) {
    const auto of = [&](double e) { return among_roots<W, N>(e, n.f, ray.direction, n.a, n.rr); };
    const std::optional<AmongRoots> origin = of(0);
    const std::optional<AmongRoots> lo = ray.range.lo == 0 ? origin : of(ray.range.lo);
    const std::optional<AmongRoots> hi = of(ray.range.hi);
    if (!origin || !lo || !hi) return {};
    verdict = {verdict.line_roots, location(*origin), *lo, *hi};
  }
  if constexpr (heard<Trace>) trace(Decision{rounded(n.a), rounded(discriminant), rounded(n.ff - n.rr), verdict});
  return verdict;
}

/// t0 <= t1 of a line with roots, each within a relative `tolerance` before its last rounding; nothing where
/// W can't promise that. The root whose square root opposes -B cancels, so it is taken from the other one: t0
/// t1 = C / A.
///
/// Bounds, with H as above. D = B^2 - A C errs by at most 32 u H =: E. Let s = sqrt D, q = |B| + s. For D >=
/// 64 E, s errs by at most 0.51 E / s, which is below a relative tolerance / 2 of q where s q tolerance >= 33
/// u H; B's error is smaller still. C errs by at most 8 u (f.f + r^2).
template <Arithmetic W, int N>
std::optional<Interval<double>> roots(const Ray<double, N>& ray, const Sphere<double, N>& sphere, double tolerance) {
  const Numbers<W, N> n = numbers<W>(ray, sphere);
  const W c = n.ff - n.rr;
  const W discriminant = n.b * n.b - n.a * c;

  const double reach = leading(n.ff) + leading(n.rr), size = leading(n.a) * reach;
  if (!in_range<W>(leading(n.a)) || !in_range<W>(reach)) return {};
  if (!(leading(discriminant) >= 2048 * unit<W> * size)) return {};

  using std::sqrt;
  const bool ahead = certain_sign(n.b, 0) == -1;
  const W s = sqrt(discriminant);
  const W q = ahead ? s - n.b : s + n.b;
  if (!(leading(s) * leading(q) * tolerance >= 33 * unit<W> * size)) return {};
  if (!(std::abs(leading(c)) * tolerance >= 8 * unit<W> * reach)) return {};

  const double far = quotient(q, n.a), near = quotient(c, q);
  if (Unrounded<W> && (std::isnan(far) || std::isnan(near))) return {};  // more digits than W has
  return ahead ? Interval<double>{near, far} : Interval<double>{-far, -near};
}

/// What doubles find of a ray and a sphere, and by Lagrange's identity D.
template <int N>
struct Plain : Numbers<double, N> {
  double reach, arr, cross;  ///< reach: f.f + r^2; D is arr - cross

  ISECT_INLINE Plain(const Ray<double, N>& ray, const Sphere<double, N>& sphere)
      : Numbers<double, N>(ray, sphere),
        reach(this->ff + this->rr),
        arr(this->a * this->rr),
        cross(cross_squared<double, N>(this->f, ray.direction)) {}

  /// Whether the line misses the sphere, -1, or meets it twice, 1; or 0 where rounding may decide: see decide.
  int meets() const {
    const double d = arr - cross, bound2 = 1024 * unit<double> * unit<double> * (arr + cross) * (this->a * reach);
    const bool certain = in_range<double>(this->a) & in_range<double>(reach) & (d * d > bound2);
    return certain ? d > 0 ? 1 : -1 : 0;
  }
};

/// The roots of a line that meets the sphere twice, side by side, each within a relative 2^-55 before its last
/// rounding; nothing where that is too much to promise. W is Compensated or Fused.
///
/// Newton. For any t, with p = f + t d, a root t + h obeys A h^2 + 2 M h + C(t) = 0, M = A t + B, C(t) = p.p - r^2.
/// Near by, h = -C / 2 M - (A / 2 M) (C / 2 M)^2 up to a relative 2 (A h / M)^2, and the sign of M tells which root it
/// is. So C(t) alone is needed to more digits than doubles have.
///
/// Bound. p, in two parts, misses 2^-102 (|f| + |t d|), and the sum of its squares less r^2, with all that rounding
/// takes from it, is rounded to some 100 bits. As |t d| <= |f| + r, and |p| is r nearly, C errs by less than 2^-90 R, R
/// = f.f + r^2. That is 2^-61 |t| in h where |M t| >= 2^-30 R. There M errs by 16 u sqrt(A R) at most, which changes h
/// by 2^-57 |t| at most where 2^8 |h| sqrt(A R) <= |M t|; and 2 (A h / M)^2 <= 2^-35 where |A h| <= 2^-18 |M|, of an h
/// below 2^-22 |t|.
template <class W, int N>
ISECT_INLINE std::optional<Interval<double>> ordinary_roots(const Ray<double, N>& ray, const Sphere<double, N>& sphere,
                                                            const Plain<N>& plain) {
  using isect::detail::Two, isect::detail::both;
  constexpr bool fused = std::is_same_v<W, Fused>;
  const double a = plain.a, b = plain.b, s = std::sqrt(plain.arr - plain.cross), inverse = 1 / a;
  const Two t = Two{-b - s, s - b} * inverse;

  const DoubleDouble square = two_product<fused>(sphere.radius, sphere.radius);
  Two sum = both(-square.hi), rest = both(-square.lo);
  for (int i = 0; i < N; ++i) {
    const double f_rest = two_sum(ray.origin[i], -sphere.center[i]).lo;
    const SumOf<Two> along = isect::detail::two_product_of<fused>(t, both(ray.direction[i])),
                     p = two_sum_of(both(plain.f[i]), along.hi);
    const SumOf<Two> p2 = isect::detail::two_product_of<fused>(p.hi, p.hi), c = two_sum_of(sum, p2.hi);
    sum = c.hi, rest += (c.lo + p2.lo) + 2 * p.hi * ((p.lo + along.lo) + f_rest);
  }
  const Two m = a * t + b, half = 0.5 / m, step = (sum + rest) * half, h = step + a * half * (step * step);

  const double breadth = 0x1p8 * std::sqrt(a * plain.reach);
  bool safe = in_range<double>(a) & in_range<double>(plain.reach);
  for (int k = 0; k < 2; ++k) {
    const double size = std::abs(t[k]), slope = std::abs(m[k]), off = std::abs(h[k]);
    safe &= (off <= 0x1p-22 * size) & (a * off <= 0x1p-18 * slope) & (slope * size >= 0x1p-30 * plain.reach) &
            (off * breadth <= slope * size);
  }
  return safe ? std::optional(Interval<double>{t[0] - h[0], t[1] - h[1]}) : std::nullopt;
}
template <int N>
ISECT_INLINE std::optional<Interval<double>> ordinary_roots(const Ray<double, N>& ray, const Sphere<double, N>& sphere,
                                                            const Plain<N>& plain) {
  return compensated([&]<class W>() { return ordinary_roots<W>(ray, sphere, plain); });
}

/// t of a tangent line's double root, -B / A, within a relative `tolerance` before its last rounding; nothing where W
/// can't promise that.
///
/// Bound. B errs by at most 5.1 u |f| |d|, which is below a relative tolerance / 2 of |B| where |B| tolerance >= 11 u
/// |f| |d|; A's error is far smaller.
template <Arithmetic W, int N>
std::optional<double> double_root(const Ray<double, N>& ray, const Sphere<double, N>& sphere, double tolerance) {
  const Numbers<W, N> n = numbers<W>(ray, sphere);
  if (!in_range<W>(leading(n.a)) || !in_range<W>(leading(n.ff))) return {};
  if (!(std::abs(leading(n.b)) * tolerance >= 11 * unit<W> * std::sqrt(leading(n.ff) * leading(n.a)))) {
    const bool at_origin = numbers<ShortExact>(ray, sphere).b.sign() == 0;
    return at_origin ? std::optional(0.0) : std::nullopt;
  }
  const double t = -quotient(n.b, n.a);
  return std::isnan(t) ? std::nullopt : std::optional(t);
}

/// The roots of a line that starts on the sphere, as C = 0 there: 0 and -2 B / A, with double_root's bound.
template <Arithmetic W, int N>
std::optional<Interval<double>> roots_from_surface(const Ray<double, N>& ray, const Sphere<double, N>& sphere,
                                                   double tolerance) {
  const std::optional<double> middle = double_root<W>(ray, sphere, tolerance);
  if (!middle) return {};
  return Interval<double>{std::min(0.0, 2 * *middle), std::max(0.0, 2 * *middle)};
}

/// The roots of a line that has `count` of them, as `roots` and `double_root` give them.
template <Arithmetic W, int N>
std::optional<Interval<double>> roots(const Ray<double, N>& ray, const Sphere<double, N>& sphere, double tolerance,
                                      int count) {
  if (count == 2) return roots<W>(ray, sphere, tolerance);
  const std::optional<double> t = double_root<W>(ray, sphere, tolerance);
  return t ? std::optional(Interval<double>{*t, *t}) : std::nullopt;
}

/// Finds the roots from what doubles have found already: exact enough for floats. D is off by 32 u H at most here, too.
template <int N>
ISECT_INLINE std::optional<Interval<double>> plain_roots(const Plain<N>& plain, double tolerance) {
  constexpr double u = unit<double>;
  const double c = plain.ff - plain.rr, discriminant = plain.arr - plain.cross, size = plain.a * plain.reach;
  const double s = std::sqrt(discriminant), q = std::abs(plain.b) + s, far = q / plain.a, near = c / q;
  const bool safe = in_range<double>(plain.a) & in_range<double>(plain.reach) & (discriminant >= 2048 * u * size) &
                    (s * q * tolerance >= 33 * u * size) & (std::abs(c) * tolerance >= 8 * u * plain.reach);
  if (!safe) return {};
  return plain.b < 0 ? Interval<double>{near, far} : Interval<double>{-far, -near};
}

/// The roots of a line that has two, for ordinary rays, by what doubles have made of it.
template <class S, int N>
ISECT_INLINE std::optional<Interval<double>> quick_roots(const Ray<double, N>& ray, const Sphere<double, N>& sphere,
                                                         const Plain<N>& plain) {
  if constexpr (std::is_same_v<S, float>)
    return plain_roots(plain, tolerance<S>);
  else
    return ordinary_roots(ray, sphere, plain);
}

/// Whether the range holds a point between the roots.
inline bool meets(const Interval<double>& range, const Verdict& verdict) {
  return verdict.line_roots > 0 && range.lo <= range.hi && verdict.lo <= AmongRoots::exit &&
         verdict.hi >= AmongRoots::entry;
}

/// The answer for the part of the line that the range holds.
template <class S>
void report(const Interval<S>& range, const Verdict& verdict, const Interval<double>& t, RaySphere<S>& result) {
  result.line_roots = verdict.line_roots;
  result.roots = {static_cast<S>(t.lo), static_cast<S>(t.hi)};
  result.origin = verdict.origin;
  if (!(range.lo <= range.hi)) return;

  const AmongRoots lo = verdict.lo, hi = verdict.hi;
  // min and max are one instruction each, std::clamp branches
  const auto clamped = [&](S x) { return std::min(std::max(x, range.lo), range.hi); };
  const S entry = lo == AmongRoots::entry ? range.lo : clamped(result.roots.lo);
  const S exit = hi == AmongRoots::exit ? range.hi : clamped(result.roots.hi);
  if (lo <= AmongRoots::entry && hi >= AmongRoots::entry)
    result.surface = entry;
  else if (lo <= AmongRoots::exit && hi >= AmongRoots::exit)
    result.surface = exit;
  if (lo <= AmongRoots::exit && hi >= AmongRoots::entry)
    result.solid = {lo >= AmongRoots::entry ? range.lo : entry, hi <= AmongRoots::exit ? range.hi : exit};
}
template <class S>
RaySphere<S> report(const Interval<S>& range, const Verdict& verdict, const Interval<double>& t) {
  RaySphere<S> result;
  report(range, verdict, t, result);
  return result;
}

/// The whole answer for an ordinary ray, by the sign of D and by the roots: they are so near to the true ones that an
/// end of the range, or 0, lies among these as it does among those, unless it is nearly one of them. False where that
/// is not certain. `answer` is newly made.
template <class S, int N>
ISECT_INLINE bool quick_answer(const Ray<double, N>& ray, const Sphere<double, N>& sphere, const Interval<S>& range,
                               RaySphere<S>& answer) {
  const Plain<N> plain(ray, sphere);
  const int meets = plain.meets();
  if (meets <= 0) return meets < 0;
  const std::optional<Interval<double>> t = quick_roots<S>(ray, sphere, plain);
  if (!t) return false;

  bool certain = true;
  constexpr double near = std::is_same_v<S, float> ? 2 * tolerance<S> : 0x1p-50;
  const double near_lo = near * std::abs(t->lo), near_hi = near * std::abs(t->hi);
  const auto among = [&](double e) -> AmongRoots {
    certain &= (std::abs(e - t->lo) > near_lo) & (std::abs(e - t->hi) > near_hi);
    return static_cast<AmongRoots>(2 * ((e > t->lo) + (e > t->hi)));
  };
  const AmongRoots origin = among(0), lo = among(range.lo), hi = among(range.hi);
  if (certain) report(range, {2, location(origin), lo, hi}, *t, answer);
  return certain;
}

}  // namespace detail

}  // namespace isect::ray_sphere
