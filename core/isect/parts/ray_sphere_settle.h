#pragma once
// Ray against sphere, the slow path: signs within their bounds, values that need more digits, sizes out of
// range, the direction 0. The texts of isect/parts/ray_sphere_roots.h run here in finer arithmetic.

#include <isect/numbers/double_double.h>
#include <isect/numbers/exact.h>
#include <isect/numbers/short_exact.h>
#include <isect/parts/ray_sphere_roots.h>
#include <isect/parts/unit_of_length.h>

namespace isect::ray_sphere {

namespace detail {

/// The problem in units in which squares neither overflow nor underflow: t = t' 2^exponent.
template <int N>
struct Scaled {
  Ray<double, N> ray;
  Sphere<double, N> sphere;
  int exponent;
};

/// Scales lengths and direction by powers of two; nothing if that would lose a bit, or if there is no need.
template <int N>
std::optional<Scaled<N>> scaled(const Ray<double, N>& ray, const Sphere<double, N>& sphere) {
  const auto exponent = [](double size) { return size > 0 ? std::ilogb(size) : 0; };
  const int along = exponent(largest_length(ray.direction)),
            across = exponent(std::max(largest_length(ray), largest_length(sphere)));
  if (std::abs(along) < 40 && std::abs(across) < 40) return {};

  UnitOfLength lengths(across), directions(along), parameters(across - along);
  const Scaled<N> s = {
      {lengths(ray.origin), directions(ray.direction), {parameters(ray.range.lo), parameters(ray.range.hi)}},
      lengths(sphere),
      across - along};
  const bool exact = lengths.exact() && directions.exact() && parameters.exact();
  return exact ? std::optional(s) : std::nullopt;
}

/// The roots of a line that has `count` of them, by V; where V is Compensated as ordinary rays have them, in doubles.
template <class V, class S, int N>
std::optional<Interval<double>> roots_by(const Ray<double, N>& ray, const Sphere<double, N>& sphere, int count) {
  if constexpr (std::is_same_v<V, Compensated>) {
    if (count == 1) return roots<DoubleDouble>(ray, sphere, tolerance<S>, count);
    return quick_roots<S>(ray, sphere, Plain<N>(ray, sphere));
  } else {
    return roots<V>(ray, sphere, tolerance<S>, count);
  }
}

/// A verdict, and the roots of a line that has some.
struct Settled {
  Verdict verdict;
  Interval<double> roots;
};

/// Finds the verdict in W, unless it is known, and the values in V; or nothing.
template <Arithmetic W, class V, class S, int N, class Trace>
std::optional<Settled> attempt(const Ray<double, N>& ray, const Sphere<double, N>& sphere, int exponent,
                               const std::optional<Verdict>& known, Trace&& trace) {
  const std::optional<Verdict> verdict = known ? known : decide<W>(ray, sphere, trace);
  if (!verdict) return {};
  if (verdict->line_roots == 0) return Settled{*verdict, {}};
  const std::optional<Interval<double>> t = roots_by<V, S>(ray, sphere, verdict->line_roots);
  if (!t) return {};
  return Settled{*verdict, {std::ldexp(t->lo, exponent), std::ldexp(t->hi, exponent)}};
}

/// Settles a ray of direction 0: it is the point `origin` at every real t of its range.
template <class S, int N>
RaySphere<S> settle_point(const Ray<double, N>& ray, const Sphere<double, N>& sphere, const Interval<S>& range) {
  const Numbers<Exact, N> n = numbers<Exact>(ray, sphere);
  const int c = (n.ff - n.rr).sign();
  RaySphere<S> result;
  result.origin = c < 0 ? Location::in : c > 0 ? Location::out : Location::on;
  const S end = std::numeric_limits<S>::infinity();
  const bool some = range.lo <= range.hi && range.lo != end && range.hi != -end;
  if (some && c == 0) result.surface = range.lo;
  if (some && c <= 0) result.solid = range;
  return result;
}

/// What doubles leave open, by the stages that follow. `known`: the verdict, where only the values are missing.
template <class S, int N, class Trace>
Settled by_stages(const Ray<double, N>& ray, const Sphere<double, N>& sphere, const std::optional<Verdict>& known,
                  Trace&& trace) {
  // What touches on integers or on a grid is settled in 127 bits; its values are then as easy as any others.
  const std::optional<Verdict> verdict = known ? known : decide<ShortExact>(ray, sphere, trace);
  if (verdict && verdict->origin == Location::on) {  // a root at 0, which no rounded number can promise
    if (const auto t = roots_from_surface<DoubleDouble>(ray, sphere, tolerance<S>)) return {*verdict, *t};
    if (const auto found = attempt<MediumExact, MediumExact, S>(ray, sphere, 0, verdict, trace)) return *found;
  }
  const std::optional<Scaled<N>> s = scaled(ray, sphere);
  const Ray<double, N>& own_ray = s ? s->ray : ray;
  const Sphere<double, N>& own_sphere = s ? s->sphere : sphere;
  const int exponent = s ? s->exponent : 0;
  if (s || (!known && verdict))
    if (const auto found = attempt<double, Compensated, S>(own_ray, own_sphere, exponent, verdict, trace))
      return *found;
  if (const auto found = attempt<DoubleDouble, DoubleDouble, S>(own_ray, own_sphere, exponent, verdict, trace))
    return *found;
  if (const auto found = attempt<MediumExact, MediumExact, S>(ray, sphere, 0, verdict, trace)) return *found;
  return *attempt<Exact, Exact, S>(ray, sphere, 0, verdict, trace);
}

/// Settles what doubles leave open. `known`: the verdict, where only the values are missing.
template <class S, int N, class Trace>
[[gnu::noinline, gnu::cold]] RaySphere<S> settle(const Ray<double, N>& ray, const Sphere<double, N>& sphere,
                                                 const Interval<S>& range, const std::optional<Verdict>& known,
                                                 Trace&& trace) {
  if (!finite(ray) || !finite(sphere)) return {};
  if (is_zero(ray.direction)) return settle_point(ray, sphere, range);
  const Settled found = by_stages<S>(ray, sphere, known, trace);
  if (found.verdict.line_roots == 0) return {};
  trace(Values{found.roots});
  return report(range, found.verdict, found.roots);
}

/// The verdict and the values in doubles, each settled where doubles can't tell.
template <class S, int N, class Trace>
RaySphere<S> step_by_step(const Ray<double, N>& ray, const Sphere<double, N>& sphere, const Interval<S>& range,
                          Trace&& trace) {
  const std::optional<Verdict> verdict = decide<double>(ray, sphere, trace);
  if (verdict) {
    if (verdict->line_roots == 0) return {};
    if (const std::optional<Interval<double>> t = quick_roots<S>(ray, sphere, Plain<N>(ray, sphere))) {
      trace(Values{*t});
      return report(range, *verdict, *t);
    }
  }
  trace(Fallback{});
  return settle(ray, sphere, range, verdict, trace);
}
template <class S, int N, class Trace>
[[gnu::noinline]] RaySphere<S> step_by_step_cold(const Ray<double, N>& ray, const Sphere<double, N>& sphere,
                                                 const Interval<S>& range, Trace&& trace) {
  return step_by_step(ray, sphere, range, trace);
}

}  // namespace detail

}  // namespace isect::ray_sphere
