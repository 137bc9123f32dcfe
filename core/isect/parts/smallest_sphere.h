#pragma once
// The smallest ball around points, exactly: which of them it rests on, and where its center is.
//
// It is the ball through some points p0, ..., pm, m <= N, that holds all the others and has its center in their
// simplex. That center is p0 + v with 2 v.u_i = |u_i|^2 for u_i = p_i - p0, and v in the span of the u_i. Cramer's rule
// solves this without a division, v = num / den, so signs of polynomials tell what lies outside:
//
//   |f|^2 > 2 f.v,  f = p - p0,   which is   (|f|^2 den - 2 f.num) / den > 0,
//
// and whether the center is in the simplex. A guess in doubles, isect/parts/fit_tight_guess.h, is checked, and nearly
// always right. Where a point lies outside after all, it joins the others; their own smallest ball is larger, so that
// this ends. Source: Welzl, Smallest enclosing disks (balls and ellipsoids), 1991; Gaertner, Fast and robust smallest
// enclosing balls, ESA 1999.

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <isect/numbers/predicate.h>
#include <isect/numbers/quotient.h>
#include <isect/parts/fit_tight_guess.h>
#include <isect/parts/memo.h>

namespace isect::fit_tight::detail {

/// The points in doubles: themselves, not a copy, if they are in doubles already.
template <class S, int N>
decltype(auto) in_doubles(const std::vector<Point<S, N>>& points) {
  if constexpr (std::is_same_v<S, double>) {
    return (points);
  } else {
    std::vector<Point<double, N>> wide;
    wide.reserve(points.size());
    for (const Point<S, N>& p : points) wide.push_back(p.template cast<double>());
    return wide;
  }
}

/// The way from p0 to the center: num / den; den = 0 where the points are dependent.
template <class W, int N>
struct Way {
  Components<W, N> num;
  W den;
};

/// The ball through N + 1 points or fewer.
template <int N>
class Through {
 public:
  explicit Through(const std::vector<Point<double, N>>& points) : p_(points) {}

  const Point<double, N>& first() const { return p_[0]; }

  /// The way from the first point to the center. Found once in each arithmetic, as many points are compared with it.
  template <PolynomialScalar W>
  kept_t<W, Way<W, N>> way() const {
    return way_.template in<W>([&] { return found<W>(); });
  }

  /// Whether p lies outside. The points must be independent. Asked where doubles leave it in doubt.
  bool outside(const Point<double, N>& p) const {
    if (std::find(p_.begin(), p_.end(), p) != p_.end()) return false;
    const auto beyond = [&]<class W>() -> W {
      const Way<W, N>& v = way<W>();
      const Components<W, N> f = difference<W, N>(p, first());
      return dot(f, f) * v.den - W(2.0) * dot(f, v.num);
    };
    const std::optional<int> quick = beyond.template operator()<Bounded<DoubleDouble>>().sign();
    return (quick ? *quick : beyond.template operator()<Exact>().sign()) * sign_of_den() > 0;
  }

  /// Whether this is the smallest ball that holds its points: they are independent, and no weight of the center among
  /// them is negative.
  bool least() const {
    if (sign_of_den() == 0) return false;
    for (int i = 0; i < weights(); ++i)
      if (sign_of<long_text>([&]<class W>() -> W { return weight<W>(i); }) < 0) return false;
    return true;
  }

 private:
  int size() const { return static_cast<int>(p_.size()); }
  template <PolynomialScalar W>
  Components<W, N> edge(int i) const {
    return difference<W, N>(p_[i], p_[0]);
  }
  int sign_of_den() const {
    if (!den_) den_ = sign_of<long_text>([&]<class W>() -> W { return way<W>().den; });
    return *den_;
  }

  template <PolynomialScalar W>
  Way<W, N> found() const {
    Way<W, N> way;
    if (size() == 1) {
      way.num.fill(W(0.0)), way.den = W(1.0);
    } else if (size() == 2) {
      way = {edge<W>(1), W(2.0)};
    } else if constexpr (N == 2) {
      const Components<W, 2> u = edge<W>(1), v = edge<W>(2);
      const W a = dot(u, u), b = dot(v, v);
      way = {{a * v[1] - b * u[1], b * u[0] - a * v[0]}, W(2.0) * (u[0] * v[1] - u[1] * v[0])};
    } else {  // of a triangle, the third equation keeps v in its plane
      const Components<W, 3> u = edge<W>(1), v = edge<W>(2), n = cross(u, v), w = size() == 4 ? edge<W>(3) : n;
      const Components<W, 3> vw = cross(v, w), wu = cross(w, u);
      const W a = dot(u, u), b = dot(v, v);
      for (int k = 0; k < 3; ++k) way.num[k] = a * vw[k] + b * wu[k];
      if (size() == 4)
        for (int k = 0; k < 3; ++k) way.num[k] = way.num[k] + dot(w, w) * n[k];
      way.den = W(2.0) * dot(w, n);
    }
    return way;
  }

  /// How many weights may be negative: none for a point or the ends of a diameter.
  int weights() const { return size() < 3 ? 0 : size(); }
  /// The weight of p_i in the center, times something positive.
  template <PolynomialScalar W>
  W weight(int i) const {
    const Components<W, N> u = edge<W>(1), v = edge<W>(2);
    if (size() == 3) {  // positive where the angle at p_i is less than a right one
      const W d = dot(u, v);
      return i == 0 ? d : i == 1 ? dot(u, u) - d : dot(v, v) - d;
    }
    if constexpr (N == 3) {
      const Way<W, 3>& way = this->way<W>();
      const Components<W, 3> w = edge<W>(3);
      const W x = dot(way.num, cross(v, w)), y = dot(way.num, cross(w, u)), z = dot(way.num, cross(u, v));
      return i == 0 ? way.den * way.den - W(2.0) * (x + y + z) : i == 1 ? x : i == 2 ? y : z;
    } else {
      return W(0.0);
    }
  }

  template <class W>
  using WayIn = Way<W, N>;

  std::vector<Point<double, N>> p_;
  Memo<WayIn> way_;
  mutable std::optional<int> den_;
};

template <int N>
Through<N> through(const std::vector<Point<double, N>>& points, const std::vector<int>& these) {
  std::vector<Point<double, N>> chosen;
  for (const int i : these) chosen.push_back(points[i]);
  return Through<N>(chosen);
}

/// The points on which the smallest ball of a few points and of `fresh`, which lies outside theirs, rests.
template <int N>
std::vector<int> joined(const std::vector<Point<double, N>>& points, const std::vector<int>& few, int fresh) {
  for (unsigned subset = 1; subset < 1u << few.size(); ++subset) {
    std::vector<int> these = {fresh};
    for (std::size_t k = 0; k < few.size(); ++k)
      if (subset >> k & 1) these.push_back(few[k]);
    if (these.size() > N + 1) continue;
    const Through<N> ball = through(points, these);
    if (!ball.least()) continue;
    if (std::none_of(few.begin(), few.end(), [&](int i) { return ball.outside(points[i]); })) return these;
  }
  return {fresh};  // never: one of the balls is the smallest
}

/// A point outside the ball, or -1. `q` are the points at a scale near 1, rounded; they decide which points are tested.
///
/// Bound. |q - p 2^-exponent - const| <= u, |q| <= 1, so that f errs by 4 u, v by u and `error`, their difference,
/// below 4, by 2 u more. A squared distance of at most 4 then errs by less than 100 u + 16 error, which is below
/// `slack`.
template <int N>
int someone_outside(const Through<N>& ball, const std::vector<Point<double, N>>& points, int first,
                    const std::vector<Point<double, N>>& q, int exponent) {
  const Way<Bounded<DoubleDouble>, N>& way = ball.template way<Bounded<DoubleDouble>>();
  const double den = way.den.value().hi, den_error = way.den.error();
  Vector<double, N> v;
  double error = 0;
  for (int k = 0; k < N; ++k) {
    v[k] = way.num[k].value().hi / den;
    error += 2 * (way.num[k].error() + std::abs(v[k]) * den_error) / std::abs(den);
    v[k] = std::ldexp(v[k], -exponent);
  }
  const bool known = 2 * den_error < std::abs(den) && std::isfinite(error);
  const double slack = 0x1p-44 + 16 * std::ldexp(error, -exponent), near2 = v.squaredNorm() - slack;

  std::vector<int> doubtful;
  int farthest = 0;
  double most2 = -1;
  for (int i = 0; i < static_cast<int>(points.size()); ++i) {
    const double distance2 = (q[i] - q[first] - v).squaredNorm();
    if (known && distance2 < near2) continue;
    doubtful.push_back(i);
    if (distance2 > most2) most2 = distance2, farthest = i;
  }
  if (ball.outside(points[farthest])) return farthest;
  const auto found =
      std::find_if(doubtful.begin(), doubtful.end(), [&](int i) { return i != farthest && ball.outside(points[i]); });
  return found == doubtful.end() ? -1 : *found;
}

/// The points times 2^-exponent, so that no product of theirs overflows; none where some number would vanish.
template <int N>
std::vector<Point<double, N>> moved_near_1(std::vector<Point<double, N>> points, int exponent) {
  for (Point<double, N>& p : points)
    for (double& x : p) {
      const double near = std::ldexp(x, -exponent);
      if (std::ldexp(near, exponent) != x) return {};
      x = near;
    }
  return points;
}

/// The points, by their indices, that the smallest ball rests on: N + 1 at most, and one at least. Exact. The points
/// are finite; `scaled` are the same.
template <int N>
std::vector<int> support(const std::vector<Point<double, N>>& points, const fit::detail::Scaled<N>& scaled) {
  std::vector<Point<double, N>> near;
  if (std::abs(scaled.exponent) > 64) near = moved_near_1(points, scaled.exponent);
  const std::vector<Point<double, N>>& p = near.empty() ? points : near;
  const int exponent = near.empty() ? scaled.exponent : 0;

  std::vector<int> now = fit::detail::smallest_ball<N>(scaled.q).points;
  if (!through(p, now).least()) now = {now[0]};
  for (;;) {
    const int fresh = someone_outside(through(p, now), p, now[0], scaled.q, exponent);
    if (fresh < 0) return now;
    now = joined(p, now, fresh);
  }
}

/// The quotient in DoubleDouble, if it is finite there and num and den are within a relative `tolerance`.
template <class Text>
[[gnu::noinline]] std::optional<double> fine_quotient(const Text& text, double tolerance) {
  const Ratio<Bounded<DoubleDouble>> r = text.template operator()<Bounded<DoubleDouble>>();
  if (!r.num.within(tolerance) || !r.den.within(tolerance)) return {};
  const double q = quotient(r.num.value(), r.den.value());
  return std::isfinite(q) ? std::optional(q) : std::nullopt;  // beyond 2^996 DoubleDouble's steps overflow
}

/// The center of the smallest ball through these points, which are independent. Each coordinate is the nearest number
/// of S, up to 0.001 ulp: the quotient is, to a relative 2^-69, rounded once, and for float once more, by a 2^-29th of
/// that.
template <class S, int N>
Point<S, N> center(const Through<N>& ball) {
  Point<S, N> c;
  for (int k = 0; k < N; ++k) {
    const auto coordinate = [&]<class W>() -> Ratio<W> {
      const Way<W, N>& v = ball.template way<W>();
      return {W(ball.first()[k]) * v.den + v.num[k], v.den};
    };
    const std::optional<double> quick = fine_quotient(coordinate, 0x1p-70);
    if (quick && std::abs(*quick) > 0x1p-900) {
      c[k] = static_cast<S>(*quick);
    } else {
      const Ratio<Exact> r = coordinate.template operator()<Exact>();
      c[k] = static_cast<S>(quotient(r.num, r.den));
    }
  }
  return c;
}

}  // namespace isect::fit_tight::detail
