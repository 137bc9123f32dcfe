#pragma once
// Sphere against cone.
//
// In the plane through the axis and the ball's center c, half of the cone is a triangle. Let f lead from the apex to c,
// d from the apex to the center of the base, h = f.d, and w = |f x d|: c lies h / |d| along the axis, and w / |d|
// beside it. The cone's point nearest to c is
//
//   c itself      where 0 <= h <= d.d and w |d| <= r h;
//   in the base   where h >= d.d and w <= r |d|, |h - d.d| / |d| away;
//   the apex      where what c lies along a line of the side, times its length, h + r w / |d|, is at most 0;
//   the rim       where that is at least d.d + r^2: isect/parts/sphere_round.h;
//   on the side   else, (w |d| - r h) / sqrt(d.d (d.d + r^2)) away.
//
// With the side's polynomial g = d.d w^2 - r^2 h^2 and B = s^2 d.d (d.d + r^2) the last less s has the sign of
// w |d| - (r h + sqrt B): that of g - B - 2 r h sqrt B, if r h + sqrt B is not negative. Inside, the ball does not
// reach the side iff r h >= w |d| + sqrt B: iff -g - B >= 2 w |d| sqrt B, for h >= 0. So each sign takes two squares at
// most. The ball lies in the cone iff c does, and the ball reaches neither side nor base beyond touching; the cone in
// the ball iff apex and base do.
//
// Source: Ericson, Real-Time Collision Detection (2005), 5.1.5, for the nearest point of a triangle.

#include <variant>

#include <isect/parts/sphere_round.h>
#include <isect/trace.h>

namespace isect {

namespace sphere_cone {

/// Where the cone's point nearest to the center lies: at the center itself, or on which part.
enum class Nearest { center, side, base, rim, apex };
/// That place, and the sign of its distance less the ball's radius.
struct Reach {
  Nearest nearest;
  int sign;
};
/// relate: whether the ball lies in the cone, the cone in the ball.
struct Contained {
  bool ball, cone;
};
using Event = std::variant<Reach, Contained, Fallback>;

namespace detail {

/// What the text above calls h, w^2, d.d and r.
template <PolynomialScalar W>
struct Profile {
  W h, w2, dd, r;
};
template <PolynomialScalar W>
Profile<W> profile(const Point<double, 3>& c, const Cone<double>& cone) {
  const Components<W, 3> f = difference<W>(c, cone.apex), d = round_solid::axis<W>(cone);
  return {dot(f, d), point_segment::detail::cross_squared(f, d), dot(d, d), W(cone.radius)};
}

/// B
template <PolynomialScalar W>
W margin2(const Profile<W>& at, double s) {
  return W(s) * W(s) * at.dd * (at.dd + at.r * at.r);
}
/// g
template <PolynomialScalar W>
W beside(const Profile<W>& at) {
  return at.dd * at.w2 - at.r * at.r * at.h * at.h;
}

/// The sign of a polynomial in the profile: text(profile).
template <class Text, class Trace>
int sign_at(const Point<double, 3>& c, const Cone<double>& cone, const Text& text, Trace&& trace) {
  return sign_of([&]<class W>() -> W { return text(profile<W>(c, cone)); }, trace);
}

/// Finds that place; `at` are the signs of h, of h - d.d, and of g.
template <class Trace>
Nearest nearest(const Point<double, 3>& c, const Cone<double>& cone, const round_solid::Signs& at, Trace&& trace) {
  if (at.first >= 0 && at.last <= 0 && at.side <= 0) return Nearest::center;
  const auto sign = [&](const auto& text) { return sign_at(c, cone, text, trace); };
  if (at.last >= 0 && sign([]<class W>(const Profile<W>& x) -> W { return x.w2 - x.r * x.r * x.dd; }) <= 0)
    return Nearest::base;
  if (at.first <= 0 && sign([]<class W>(const Profile<W>& x) -> W { return x.r * x.r * x.w2 - x.h * x.h * x.dd; }) <= 0)
    return Nearest::apex;
  const auto left = []<class W>(const Profile<W>& x) -> W { return x.dd + x.r * x.r - x.h; };
  const bool beyond_rim = sign(left) <= 0 || sign([&]<class W>(const Profile<W>& x) -> W {
                                               const W rest = left(x);
                                               return rest * rest * x.dd - x.r * x.r * x.w2;
                                             }) <= 0;
  return beyond_rim ? Nearest::rim : Nearest::side;
}

/// The sign of w |d| - r h - sqrt B, `along` being that of h.
template <class Trace>
int from_side(const Sphere<double, 3>& ball, const Cone<double>& cone, int along, Trace&& trace) {
  const double s = ball.radius;
  const auto sign = [&](const auto& text) { return sign_at(ball.center, cone, text, trace); };
  if (along < 0 && sign([s]<class W>(const Profile<W>& x) -> W { return margin2(x, s) - x.r * x.r * x.h * x.h; }) < 0)
    return 1;
  const auto rest = [s]<class W>(const Profile<W>& x) -> W { return beside(x) - margin2(x, s); };
  const int way = along < 0 ? 1 : -1;  // the sign of the term -2 r h sqrt B
  const int first = sign(rest);
  if (first == way) return way;
  return -way * sign([&]<class W>(const Profile<W>& x) -> W {
    const W e = rest(x), twice = W(2) * x.r * x.h;
    return e * e - twice * twice * margin2(x, s);
  });
}

template <class Trace>
Reach reach(const Sphere<double, 3>& ball, const Cone<double>& cone, Trace&& trace) {
  const auto discs = round_solid::discs(cone);
  const round_solid::Signs at = round_solid::signs(ball.center, cone, trace);
  const Nearest place = nearest(ball.center, cone, at, trace);
  switch (place) {
    case Nearest::center:
      return {place, ball.radius > 0 ? -1 : 0};
    case Nearest::base:
      return {place, sphere_round::plane(ball, discs[1], cone, trace)};
    case Nearest::apex:
    case Nearest::rim:
      return {place, sphere_round::rim(ball, discs[place == Nearest::rim], cone, -1, trace)};
    default:
      return {place, from_side(ball, cone, at.first, trace)};
  }
}

/// Whether a ball that meets the cone lies in it, and the cone in the ball.
template <class Trace>
Contained contained(const Sphere<double, 3>& ball, const Cone<double>& cone, Nearest nearest, Trace&& trace) {
  const double s = ball.radius;
  const auto sign = [&](const auto& text) { return sign_at(ball.center, cone, text, trace); };
  const auto rest = [s]<class W>(const Profile<W>& x) -> W { return -(beside(x) + margin2(x, s)); };
  const bool inside = nearest == Nearest::center &&
                      sphere_round::plane(ball, round_solid::discs(cone)[1], cone, trace) >= 0 && sign(rest) >= 0 &&
                      sign([&]<class W>(const Profile<W>& x) -> W {
                        const W e = rest(x);
                        return e * e - W(4) * x.dd * x.w2 * margin2(x, s);
                      }) >= 0;
  return {inside, sphere_round::holds(ball, cone, trace)};
}

}  // namespace detail

}  // namespace sphere_cone

/// Whether the ball and the cone have a common point. Exact; an empty one, NaN or an infinite coordinate: no.
template <class S, class Trace = NoTrace>
bool intersects(const Sphere<S, 3>& sphere, const Cone<S>& cone, Trace&& trace = {}) {
  if (!sphere_round::exist(sphere, cone)) return false;
  const sphere_cone::Reach reach = in_doubles_first(
      [&](auto& listener) { return sphere_cone::detail::reach(in_doubles(sphere), in_doubles(cone), listener); },
      trace);
  trace(reach);
  return reach.sign <= 0;
}

/// How the ball and the cone lie, the ball being a. Exact. A ball of radius 0 is a point, and a cone of radius 0 a
/// segment. An empty one, NaN or an infinite coordinate: disjoint.
template <class S, class Trace = NoTrace>
Relation relate(const Sphere<S, 3>& sphere, const Cone<S>& cone, Trace&& trace = {}) {
  if (!sphere_round::exist(sphere, cone)) return Relation::disjoint;
  return in_doubles_first(
      [&](auto& listener) {
        const Sphere<double, 3>& ball = in_doubles(sphere);
        const Cone<double>& wide = in_doubles(cone);
        const sphere_cone::Reach reach = sphere_cone::detail::reach(ball, wide, listener);
        listener(reach);
        if (reach.sign > 0) return Relation::disjoint;

        const sphere_cone::Contained inside = sphere_cone::detail::contained(ball, wide, reach.nearest, listener);
        listener(inside);
        if (inside.ball) return Relation::a_inside_b;
        if (inside.cone) return Relation::b_inside_a;
        return reach.sign == 0 ? Relation::touching : Relation::overlapping;
      },
      trace);
}

}  // namespace isect
