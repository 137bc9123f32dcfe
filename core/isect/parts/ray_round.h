#pragma once
// Ray, segment or line against a cylinder or a cone (isect/parts/round_solid.h): whether they meet, and which part of
// the one lies in the other.
//
// Let A and B be where the part of the range between the planes of both ends begins and ends: at an end of the range,
// at one of those planes, or nowhere. Between these planes the solid, as it is convex, holds a stretch of the line:
// where the side's polynomial
//
//   g(t) = form(f + t u, f + t u) - c = a t^2 + 2 b t + constant,   f = o - where the axis begins, u: the direction,
//
// is at most 0. It holds A or B if g does not exceed 0 there. If it holds neither, but something between, g falls at A,
// rises at B, and has roots; and if g does all that, its least value, which is at most 0, is taken between them. A root
// at which g falls is where the line enters, one at which it rises where it leaves: (-b -+ sqrt D) / a, whatever the
// sign of a, which of a cone may be negative. With n = u x d, and m = f x u,
//
//   cylinder   D = d.d (r^2 n.n - (f.n)^2),      cone   D = (d.d)^2 (r^2 |d x m|^2 - d.d (m.d)^2).
//
// In the plane of an end with center c and radius R the line passes y / u.d from c, y = (u.d) (o - c) - ((o - c).d) u:
// in the disc iff |y|^2 <= R^2 (u.d)^2; and with the radius growing along the axis from R0 to R1, g falls or rises
// there as (d.d y.u - R (R1 - R0) (u.d)^2) / u.d says.
//
// Source: Cyrus, Beck, Generalized two- and three-dimensional clipping, Computers & Graphics 3 (1978), for the stretch;
// Eberly, Intersection of a Line and a Cone (2000), geometrictools.com, for the forms.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <variant>

#include <isect/numbers/root.h>
#include <isect/parts/ray_range.h>
#include <isect/parts/round_solid.h>
#include <isect/parts/straight.h>
#include <isect/trace.h>

namespace isect::ray_round {

/// What a stretch begins or ends with: nothing, an end of the range, the plane where the axis begins or ends.
enum class Limit { none, range, first, last };
/// Where the part of the range between the planes begins, or ends, and whether the solid holds that point.
struct Stop {
  bool ends;
  Limit at;
  bool inside;
};
/// Where the solid holds neither end: whether the side's polynomial falls at the one, rises at the other and has a
/// root.
struct Side {
  bool falls, rises, root;
};
using Event = std::variant<Stop, Side, Fallback>;

namespace detail {

using round_solid::axis, round_solid::form, round_solid::Disc;

/// u.d
template <PolynomialScalar W, bool ends, class Solid>
W rate(const Straight<3, ends>& line, const Solid& solid) {
  return dot(line.template along<W>(), axis<W>(solid));
}
/// (x - c).d of the line's point x at t.
template <PolynomialScalar W, bool ends, class Solid>
W height(const Straight<3, ends>& line, double t, const Point<double, 3>& c, const Solid& solid) {
  return dot(seen_from<W, 3>(c, line, t), axis<W>(solid));
}
/// y of the text above, for the plane through c.
template <PolynomialScalar W, bool ends, class Solid>
Components<W, 3> in_plane(const Straight<3, ends>& line, const Point<double, 3>& c, const Solid& solid) {
  const Components<W, 3> f = difference<W>(line.origin, c), u = line.template along<W>(), d = axis<W>(solid);
  const W rate = dot(u, d), height = dot(f, d);
  Components<W, 3> y;
  for (std::size_t i = 0; i < 3; ++i) y[i] = rate * f[i] - height * u[i];
  return y;
}

/// The term in brackets in D, for a line through f along u.
template <PolynomialScalar W>
W room(const Cylinder<double>& c, const Components<W, 3>& f, const Components<W, 3>& u) {
  const Components<W, 3> n = cross(u, axis<W>(c));
  const W away = dot(f, n);
  return W(c.radius) * W(c.radius) * dot(n, n) - away * away;
}
template <PolynomialScalar W>
W room(const Cone<double>& c, const Components<W, 3>& f, const Components<W, 3>& u) {
  const Components<W, 3> d = axis<W>(c), m = cross(f, u), across = cross(d, m);
  const W along = dot(m, d);
  return W(c.radius) * W(c.radius) * dot(across, across) - dot(d, d) * (along * along);
}
/// The factor of that term in D.
template <PolynomialScalar W>
W scale_of_room(const Cylinder<double>& c) {
  const Components<W, 3> d = axis<W>(c);
  return dot(d, d);
}
template <PolynomialScalar W>
W scale_of_room(const Cone<double>& c) {
  const Components<W, 3> d = axis<W>(c);
  return dot(d, d) * dot(d, d);
}
/// The polynomial g, with f and u.
template <PolynomialScalar W, bool ends, class Solid>
Quadratic<W> polynomial(const Straight<3, ends>& line, const Solid& solid) {
  const Components<W, 3> f = difference<W>(line.origin, round_solid::start(solid)), u = line.template along<W>();
  return {form<W>(solid, u, u), form<W>(solid, f, u), round_solid::beside<W>(solid, f),
          scale_of_room<W>(solid) * room<W>(solid, f, u)};
}

/// A line, its range, and a solid that exists; all questions about both.
template <bool ends, class Solid, class Trace>
class Passage {
 public:
  Passage(const Straight<3, ends>& line, const Solid& solid, Trace& trace)
      : line_(line), solid_(solid), discs_(round_solid::discs(solid)), trace_(trace) {
    if (line.is_point()) line_.range = {0, 0};
    rate_ = sign_of([&]<class W>() -> W { return rate<W>(line_, solid_); }, trace_);
  }

  /// Whether the solid holds a point of the range. What it finds serves the questions below.
  bool meets() {
    Trace& trace = trace_;
    if (!between_planes()) return false;
    first_ = stop(false), last_ = stop(true);
    trace(first_);
    trace(last_);
    if (first_.inside || last_.inside) return true;
    const Side side = {falls(first_), rises(last_), has_root()};
    trace(side);
    return side.falls && side.rises && side.root;
  }

  /// The first or the last t in the solid, which the range meets, for a range that is in S.
  template <class S>
  S end_in(const Interval<S>& range, bool last) const {
    const Stop& stop = last ? last_ : first_;
    if (stop.inside && stop.at == Limit::range) return last ? range.hi : range.lo;
    const S t = stop.inside ? value_of<S>([&]<class W>() -> Ratio<W> { return crossing<W>(disc(stop)); }, trace_)
                            : root_of<S>([&]<class W>() -> Quadratic<W> { return polynomial<W>(line_, solid_); },
                                         last ? 1 : -1, trace_);
    return ray_range::clamped(t, range);
  }

 private:
  const Disc& disc(const Stop& stop) const { return discs_[stop.at == Limit::last]; }
  /// The plane through which the line enters the space between both, or leaves it; it is not parallel to them.
  Limit plane(bool out) const { return (rate_ > 0) == out ? Limit::last : Limit::first; }

  /// Where the line crosses the plane of a disc.
  template <PolynomialScalar W>
  Ratio<W> crossing(const Disc& disc) const {
    return {-height<W>(line_, 0, disc.center, solid_), rate<W>(line_, solid_)};
  }
  /// The sign of how far the line's point at t lies beyond the plane, as the axis runs.
  int above(double t, Limit plane) const {
    const Point<double, 3>& c = discs_[plane == Limit::last].center;
    return sign_of([&]<class W>() -> W { return height<W>(line_, t, c, solid_); }, trace_);
  }
  /// The sign of how far that point lies beyond the plane, as the line runs.
  int past(double t, Limit plane) const { return rate_ * above(t, plane); }

  /// Whether some of the range lies between the planes.
  bool between_planes() const {
    if (rate_ == 0) return above(0, Limit::first) >= 0 && above(0, Limit::last) <= 0;
    const Interval<double>& range = line_.range;
    return !(std::isfinite(range.lo) && past(range.lo, plane(true)) > 0) &&
           !(std::isfinite(range.hi) && past(range.hi, plane(false)) < 0);
  }
  Stop stop(bool last) const {
    const double t = last ? line_.range.hi : line_.range.lo;
    if (std::isfinite(t) && (rate_ == 0 || (last ? -1 : 1) * past(t, plane(last)) >= 0))
      return {last, Limit::range, beside(t) <= 0};
    if (rate_ == 0) return {last, Limit::none, false};
    return {last, plane(last), beside(discs_[plane(last) == Limit::last]) <= 0};
  }
  int beside(double t) const {
    return sign_of(
        [&]<class W>() -> W {
          return round_solid::beside<W>(solid_, seen_from<W, 3>(round_solid::start(solid_), line_, t));
        },
        trace_);
  }
  int beside(const Disc& disc) const {
    return sign_of(
        [&]<class W>() -> W {
          const Components<W, 3> y = in_plane<W>(line_, disc.center, solid_);
          const W reach = W(disc.radius) * rate<W>(line_, solid_);
          return dot(y, y) - reach * reach;
        },
        trace_);
  }

  /// The sign of g's derivative.
  int slope(const Stop& stop) const {
    if (stop.at == Limit::range) {
      const double t = stop.ends ? line_.range.hi : line_.range.lo;
      return sign_of(
          [&]<class W>() -> W {
            return form<W>(solid_, seen_from<W, 3>(round_solid::start(solid_), line_, t), line_.template along<W>());
          },
          trace_);
    }
    const Disc& at = disc(stop);
    return rate_ * sign_of(
                       [&]<class W>() -> W {
                         const Components<W, 3> y = in_plane<W>(line_, at.center, solid_), d = axis<W>(solid_);
                         const W growth = difference<W>(discs_[1].radius, discs_[0].radius), u = rate<W>(line_, solid_);
                         return dot(d, d) * dot(y, line_.template along<W>()) - W(at.radius) * growth * (u * u);
                       },
                       trace_);
  }
  /// Whether g falls there. Without a limit the line runs across the axis, and g falls and rises for ever.
  bool falls(const Stop& stop) const { return stop.at == Limit::none || slope(stop) < 0; }
  bool rises(const Stop& stop) const { return stop.at == Limit::none || slope(stop) > 0; }
  bool has_root() const {
    return sign_of(
               [&]<class W>() -> W {
                 return room<W>(solid_, difference<W>(line_.origin, round_solid::start(solid_)),
                                line_.template along<W>());
               },
               trace_) >= 0;
  }

  Straight<3, ends> line_;
  const Solid& solid_;
  std::array<Disc, 2> discs_;
  Trace& trace_;
  int rate_ = 0;
  Stop first_ = {}, last_ = {};
};

template <class Line, class Solid>
bool may_meet(const Line& line, const Solid& solid) {
  return round_solid::exists(solid) && finite(line);
}

template <bool ends, class Solid, class Trace>
bool meets(const Straight<3, ends>& line, const Solid& solid, Trace&& trace) {
  return in_doubles_first([&](auto& listener) { return Passage(line, solid, listener).meets(); }, trace);
}

template <class S, bool ends, class Solid, class Trace>
std::optional<Interval<S>> part_in(const Straight<3, ends>& line, const Solid& solid, const Interval<S>& range,
                                   Trace&& trace) {
  return in_doubles_first(
      [&](auto& listener) -> std::optional<Interval<S>> {
        Passage passage(line, solid, listener);
        if (!passage.meets()) return {};
        if (line.is_point()) return range;
        const S first = passage.template end_in<S>(range, false);
        return Interval<S>{first, std::max(first, passage.template end_in<S>(range, true))};
      },
      trace);
}

template <class S, bool ends, class Solid, class Trace>
std::optional<S> first_in(const Straight<3, ends>& line, const Solid& solid, const Interval<S>& range, Trace&& trace) {
  return in_doubles_first(
      [&](auto& listener) -> std::optional<S> {
        Passage passage(line, solid, listener);
        if (!passage.meets()) return {};
        return line.is_point() ? range.lo : passage.template end_in<S>(range, false);
      },
      trace);
}

}  // namespace detail

}  // namespace isect::ray_round
