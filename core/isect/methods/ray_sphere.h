#pragma once
// Ray against sphere by the note's three methods, each with the line numbers of its pseudocode: what is
// taught, stepped through and compared. They are right for ordinary input; `intersect` in isect/ray_sphere.h
// is right for all.
//
// Each returns the smallest t of the ray's range at which it meets the *sphere* (the surface), in units of
// |direction|. Nothing on a miss, for a zero direction, for NaN. Rounding may decide wrongly near tangency or
// far away, and squares overflow or vanish beyond 1e+-150 in double: none of that is guarded here.

#include <cmath>
#include <optional>
#include <variant>

#include <isect/shapes.h>
#include <isect/trace.h>

namespace isect::ray_sphere {

// Events: the values of one pseudocode line, or the condition of an `if`.
// clang-format off
template <class S, int N> struct FromCenter { Vector<S, N> f; };        ///< f = o - c
template <class S> struct CoefficientA { S a; };
template <class S> struct CoefficientB { S b; };
template <class S> struct CoefficientC { S c; };
template <class S> struct Discriminant { S d; };
template <class S> struct LineMisses { S d; bool holds; };              ///< D < 0
template <class S> struct Root { int index; S t; };                     ///< t1 (index 0) or t2 (index 1)
template <class S> struct RootInRange { int index; S t; bool holds; };  ///< t_min <= t <= t_max
template <class S> struct Hit { S t; };
struct Miss {};
// clang-format on

template <class S, int N>
using QuadraticEvent = std::variant<FromCenter<S, N>, CoefficientA<S>, CoefficientB<S>, CoefficientC<S>,
                                    Discriminant<S>, LineMisses<S>, Root<S>, RootInRange<S>, Hit<S>, Miss>;

namespace detail {

/// Which root of the two the range holds first: the end of both quadratic forms.
template <class S, class Trace>
std::optional<S> first_in_range(const S& t1, const S& t2, const Interval<S>& range, Trace&& trace) {
  const bool first = range.contains(t1);
  trace(RootInRange<S>{0, t1, first});
  if (first) {
    trace(Hit<S>{t1});
    return t1;
  }
  const bool second = range.contains(t2);
  trace(RootInRange<S>{1, t2, second});
  if (second) {
    trace(Hit<S>{t2});
    return t2;
  }
  trace(Miss{});
  return {};
}

}  // namespace detail

/// Substitute the ray into the sphere and solve A t^2 + B t + C = 0.
/// The note prints a stray t in A and B; they are constants. It takes "the smallest positive root", which
/// fails for an origin on the surface (t = 0 counts) and for a segment: the closed range decides instead.
/// Source: the note, N17; Akenine-Moller, Haines, Real-Time Rendering, 2nd ed. (2002), ch. 13.5.1.
template <class S, int N, class Trace = NoTrace>
std::optional<S> quadratic(const Ray<S, N>& ray, const Sphere<S, N>& sphere, Trace&& trace = {}) {
  const Vector<S, N> f = ray.origin - sphere.center;
  trace(FromCenter<S, N>{f});

  const S a = ray.direction.dot(ray.direction);
  trace(CoefficientA<S>{a});

  const S b = S(2) * f.dot(ray.direction);
  trace(CoefficientB<S>{b});

  const S c = f.dot(f) - sphere.radius * sphere.radius;
  trace(CoefficientC<S>{c});

  const S discriminant = b * b - S(4) * a * c;
  trace(Discriminant<S>{discriminant});

  const bool misses = !(discriminant >= S(0));  // NaN misses
  trace(LineMisses<S>{discriminant, misses});
  if (misses) {
    trace(Miss{});
    return {};
  }

  using std::sqrt;
  const S root = sqrt(discriminant), denominator = S(2) * a;
  const S t1 = (-b - root) / denominator;
  trace(Root<S>{0, t1});

  const S t2 = (-b + root) / denominator;
  trace(Root<S>{1, t2});

  return detail::first_in_range(t1, t2, ray.range, trace);
}

/// Whether a ray with t >= 0 meets the ball, without a root: it begins in there, or it heads for the center and the
/// discriminant is not negative. Source: Akenine-Moller, Haines, Real-Time Rendering, 2nd ed. (2002), ch. 13.5.1.
template <class S, int N>
bool by_discriminant(const Ray<S, N>& ray, const Sphere<S, N>& sphere) {
  const Vector<S, N> f = ray.origin - sphere.center;
  const S b = f.dot(ray.direction), c = f.dot(f) - sphere.radius * sphere.radius;
  if (c <= S(0)) return true;
  return b < S(0) && b * b >= ray.direction.dot(ray.direction) * c;
}

/// `quadratic` with half of B, so that the factors 2 and 4 cancel. The note warns that such tweaks gain little
/// and breed bugs: the formula holds for the halved B only. Source: the note, N18.
template <class S, int N, class Trace = NoTrace>
std::optional<S> half_b(const Ray<S, N>& ray, const Sphere<S, N>& sphere, Trace&& trace = {}) {
  const Vector<S, N> f = ray.origin - sphere.center;
  trace(FromCenter<S, N>{f});

  const S a = ray.direction.dot(ray.direction);
  trace(CoefficientA<S>{a});

  const S b = f.dot(ray.direction);
  trace(CoefficientB<S>{b});

  const S c = f.dot(f) - sphere.radius * sphere.radius;
  trace(CoefficientC<S>{c});

  const S discriminant = b * b - a * c;
  trace(Discriminant<S>{discriminant});

  const bool misses = !(discriminant >= S(0));  // NaN misses
  trace(LineMisses<S>{discriminant, misses});
  if (misses) {
    trace(Miss{});
    return {};
  }

  using std::sqrt;
  const S root = sqrt(discriminant);
  const S t1 = (-b - root) / a;
  trace(Root<S>{0, t1});

  const S t2 = (-b + root) / a;
  trace(Root<S>{1, t2});

  return detail::first_in_range(t1, t2, ray.range, trace);
}

// clang-format off
template <class S, int N> struct ToCenter { Vector<S, N> l; };    ///< l = c - o
template <class S> struct AlongRay { S s; };                      ///< s = l.d: where the ray passes the center
template <class S> struct CenterDistance { S l2; };               ///< l^2
template <class S> struct Behind { S s, l2, r2; bool holds; };    ///< s < 0 and l^2 > r^2
template <class S> struct PassingDistance { S m2; };              ///< m^2: how far from the center it passes
template <class S> struct PassesBy { S m2, r2; bool holds; };     ///< m^2 > r^2
template <class S> struct HalfChord { S q; };
template <class S> struct FromOutside { S l2, r2; bool holds; };  ///< t = s - q if it holds, else s + q
template <class S> struct Nearest { S t; };
template <class S> struct TooFar { S t, limit; bool holds; };     ///< t > t_max
struct Reject {};
template <class S, int N> struct Intersect { S t; Point<S, N> p; };
// clang-format on

template <class S, int N>
using HainesEvent =
    std::variant<ToCenter<S, N>, AlongRay<S>, CenterDistance<S>, Behind<S>, PassingDistance<S>, PassesBy<S>,
                 HalfChord<S>, FromOutside<S>, Nearest<S>, TooFar<S>, Reject, Intersect<S, N>>;

/// Haines' geometric method: early rejection, one square root, no division.
/// The direction has unit length *exactly*: the rounded unit vectors of practice cost accuracy far away. The
/// range starts at 0; only its upper end is read. At l^2 = r^2 heading inward the note's form returns the
/// exit; here t = 0. Source: the note, N19; Haines in Glassner (ed.), An Introduction to Ray Tracing (1989),
/// ch. 2.
template <class S, int N, class Trace = NoTrace>
std::optional<S> haines(const Ray<S, N>& ray, const Sphere<S, N>& sphere, Trace&& trace = {}) {
  const Vector<S, N> l = sphere.center - ray.origin;
  trace(ToCenter<S, N>{l});

  const S s = l.dot(ray.direction);
  trace(AlongRay<S>{s});

  const S l2 = l.dot(l), r2 = sphere.radius * sphere.radius;
  trace(CenterDistance<S>{l2});

  const bool behind = s < S(0) && l2 > r2;
  trace(Behind<S>{s, l2, r2, behind});
  if (behind) {
    trace(Reject{});
    return {};
  }

  const S m2 = l2 - s * s;
  trace(PassingDistance<S>{m2});

  const bool passes_by = !(m2 <= r2);  // NaN misses
  trace(PassesBy<S>{m2, r2, passes_by});
  if (passes_by) {
    trace(Reject{});
    return {};
  }

  using std::sqrt;
  const S q = sqrt(r2 - m2);
  trace(HalfChord<S>{q});

  const bool outside = l2 > r2 || (l2 == r2 && s > S(0));
  trace(FromOutside<S>{l2, r2, outside});
  const S t = outside ? s - q : s + q;
  trace(Nearest<S>{t});

  const bool too_far = !(t <= ray.range.hi);
  trace(TooFar<S>{t, ray.range.hi, too_far});
  if (too_far) {
    trace(Reject{});
    return {};
  }
  trace(Intersect<S, N>{t, ray.at(t)});
  return t;
}

}  // namespace isect::ray_sphere
