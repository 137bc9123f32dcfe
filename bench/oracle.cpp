#include "bench/oracle.h"

#include <algorithm>
#include <array>
#include <boost/multiprecision/gmp.hpp>
#include <boost/multiprecision/mpfr.hpp>
#include <cmath>
#include <limits>

namespace isect::oracle {
namespace {

namespace mp = boost::multiprecision;
using Integer = mp::number<mp::gmp_int, mp::et_off>;
template <unsigned Digits>
using Decimal = mp::number<mp::mpfr_float_backend<Digits>, mp::et_off>;

/// x = mantissa 2^exponent.
struct Parts {
  Integer mantissa;
  int exponent;
};

Parts parts(double x) {
  int exponent = 0;
  const double fraction = std::frexp(x, &exponent);
  return {Integer(static_cast<long long>(std::ldexp(fraction, 53))), exponent - 53};
}

/// x / 2^exponent, which must be an integer.
Integer integer(double x, int exponent) {
  if (x == 0) return 0;
  const Parts p = parts(x);
  const int by = p.exponent - exponent;
  return by >= 0 ? Integer(p.mantissa << by) : Integer(p.mantissa >> -by);
}

/// The largest power of two that divides every number of the list, up to the 53 bits of a mantissa.
template <class... Lists>
int common_exponent(const Lists&... lists) {
  int least = std::numeric_limits<int>::max();
  const auto look = [&least](double x) {
    if (x != 0) least = std::min(least, std::max(std::ilogb(x) - 52, -1074));
  };
  (std::for_each(lists.begin(), lists.end(), look), ...);
  return least == std::numeric_limits<int>::max() ? 0 : least;
}

/// A t^2 + 2 B t + C = 0 over the integers: t counts units of 2^unit.
struct Quadratic {
  Integer a, b, c, discriminant;
  int unit;
};

template <int N>
Quadratic quadratic(const Ray<double, N>& ray, const Sphere<double, N>& sphere) {
  const std::array radius = {sphere.radius};
  const int along = common_exponent(ray.direction);
  const int across = common_exponent(ray.origin, sphere.center, radius);

  const Integer r = integer(sphere.radius, across);
  Quadratic q = {0, 0, -r * r, 0, across - along};
  for (int i = 0; i < N; ++i) {
    const Integer d = integer(ray.direction[i], along);
    const Integer f = integer(ray.origin[i], across) - integer(sphere.center[i], across);
    q.a += d * d;
    q.b += d * f;
    q.c += f * f;
  }
  q.discriminant = q.b * q.b - q.a * q.c;
  return q;
}

/// The sign of root - e, where root = (-B -+ sqrt D) / A and e is an end of the range. With k = A e + B that
/// is the sign of -+sqrt D - k; it follows from the signs of k and of D - k^2.
int compare(const Quadratic& q, bool upper, double e) {
  if (std::isinf(e)) return e > 0 ? -1 : 1;
  const Parts p = parts(e);
  const int by = e == 0 ? 0 : p.exponent - q.unit;
  const Integer ae = q.a * p.mantissa;
  const Integer k = by >= 0 ? Integer((ae << by) + q.b) : Integer(ae + (q.b << -by));
  const Integer d = by >= 0 ? q.discriminant : Integer(q.discriminant << (-2 * by));
  const Integer kk = k * k;
  if (upper) return k.sign() < 0 ? 1 : d.compare(kk);
  return k.sign() > 0 ? -1 : kk.compare(d);
}

/// The root (-B -+ sqrt D) / A in that many digits, unless all but 60 of them cancel.
template <unsigned Digits>
std::optional<Real> value_in(const Quadratic& q, bool upper) {
  using D = Decimal<Digits>;
  const D b(q.b), s = sqrt(D(q.discriminant));
  const D sum = upper ? D(s - b) : D(-s - b);
  if (sum != 0 && ilogb(sum) < ilogb(D(abs(b) + s)) - static_cast<int>(3.3 * (Digits - 60))) return {};
  if (sum == 0 && q.c != 0) return {};

  const D t = ldexp(D(sum / D(q.a)), q.unit);
  const double nearest = static_cast<double>(t);
  return Real{nearest, std::isfinite(nearest) ? static_cast<double>(D(t - nearest)) : 0};
}

/// Four thousand digits hold every quadratic of doubles: its coefficients span some 2,500.
Real value(const Quadratic& q, bool upper) {
  const std::optional<Real> t = value_in<400>(q, upper);
  return t ? *t : *value_in<4000>(q, upper);
}

/// A ray without direction: a point.
RaySphere point(const Quadratic& q, const Interval<double>& range) {
  const int c = q.c.sign();
  RaySphere truth;
  truth.origin = c < 0 ? Location::in : c > 0 ? Location::out : Location::on;
  const bool some = range.lo <= range.hi && std::isless(range.lo, INFINITY) && std::isgreater(range.hi, -INFINITY);
  if (!some || c > 0) return truth;
  if (c == 0) truth.surface = Real{range.lo};
  truth.enter = Real{range.lo};
  truth.leave = Real{range.hi};
  return truth;
}

}  // namespace

template <int N>
RaySphere ray_sphere(const Ray<double, N>& ray, const Sphere<double, N>& sphere) {
  const bool finite = ray.origin.allFinite() && ray.direction.allFinite() && sphere.center.allFinite() &&
                      std::isfinite(sphere.radius) && !std::isnan(ray.range.lo) && !std::isnan(ray.range.hi);
  if (!finite || sphere.radius < 0) return {};

  const Quadratic q = quadratic(ray, sphere);
  if (q.a == 0) return point(q, ray.range);
  if (q.discriminant < 0) return {};

  RaySphere truth;
  truth.line_roots = q.discriminant == 0 ? 1 : 2;
  truth.t0 = value(q, false);
  truth.t1 = truth.line_roots == 1 ? truth.t0 : value(q, true);
  truth.origin = q.c < 0 ? Location::in : q.c > 0 ? Location::out : Location::on;

  const auto [lo, hi] = ray.range;
  if (!(lo <= hi)) return truth;
  const int entry_lo = compare(q, false, lo), entry_hi = compare(q, false, hi);
  const int exit_lo = compare(q, true, lo), exit_hi = compare(q, true, hi);
  if (entry_lo >= 0 && entry_hi <= 0)
    truth.surface = truth.t0;
  else if (exit_lo >= 0 && exit_hi <= 0)
    truth.surface = truth.t1;
  if (entry_hi <= 0 && exit_lo >= 0) {
    truth.enter = entry_lo >= 0 ? truth.t0 : Real{lo};
    truth.leave = exit_hi <= 0 ? truth.t1 : Real{hi};
  }
  return truth;
}

template RaySphere ray_sphere<2>(const Ray<double, 2>&, const Sphere<double, 2>&);
template RaySphere ray_sphere<3>(const Ray<double, 3>&, const Sphere<double, 3>&);

template <class S>
double ulps(S x, const Real& truth) {
  if (std::isnan(x)) return INFINITY;
  const S nearest = static_cast<S>(truth.nearest);
  if (std::isinf(nearest) || std::isinf(x)) return x == nearest ? 0 : INFINITY;
  constexpr int lowest = std::numeric_limits<S>::min_exponent - 1, bits = std::numeric_limits<S>::digits - 1;
  const int exponent = truth.nearest == 0 ? lowest : std::max(lowest, std::ilogb(truth.nearest));
  return std::ldexp(std::abs((static_cast<double>(x) - truth.nearest) - truth.rest), bits - exponent);
}

template double ulps(float, const Real&);
template double ulps(double, const Real&);

}  // namespace isect::oracle
