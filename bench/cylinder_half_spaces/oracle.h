#pragma once
// How a cylinder or a cone K and a bounded convex solid P lie, in rationals and without shadows, by what may meet
// first: the axis of K and P, an edge of P and K, a disc of K and P.
//
// If they meet, one of those does: let no edge of P meet K. If a face of P does, its plane's section of K lies within
// that face; and every plane that meets K meets its axis or one of its discs, at whose nearest point to the center the
// section may be asked. If no face does, all of K lies within P.
//
// Likewise, some point is interior to K and in P iff it lies on the axis, between its ends, or on an edge of P; or that
// nearest point on a disc lies within the rim and in P, and P's points near it, in the plane of that face and towards
// the other disc, do as well.

#include <algorithm>
#include <optional>
#include <type_traits>
#include <variant>

#include <isect/half_spaces.h>
#include "bench/half_spaces/oracle.h"
#include "bench/round_oracle.h"

namespace isect::oracle {

inline Side side_of_face(const half_spaces::Face& face) {
  const auto through = [](const Place& x, const Place& n) { return Side{n, -dot(n, x)}; };
  Side side = std::visit(
      [&]<class Form>(const Form& form) -> Side {
        if constexpr (std::is_same_v<Form, half_spaces::Level>) {
          return {rational(form.normal), Rational(form.d)};
        } else if constexpr (std::is_same_v<Form, half_spaces::BoxFace>) {
          return sides(form.box)[static_cast<std::size_t>(2 * form.i + (form.side > 0))];
        } else if constexpr (std::is_same_v<Form, half_spaces::Along>) {
          Place unit = {0, 0, 0};
          unit[static_cast<std::size_t>(form.i)] = 1;
          return through(rational(form.a), cross(rational(form.b) - rational(form.a), unit));
        } else if constexpr (std::is_same_v<Form, half_spaces::Beyond>) {
          return through(rational(form.a), rational(form.b) - rational(form.a));
        } else {
          const Place a = rational(form.a), b = rational(form.b), c = rational(form.c), n = cross(b - a, c - a);
          if constexpr (std::is_same_v<Form, half_spaces::Behind>)
            return through(a, Rational(-1) * n);
          else
            return through(a, cross(n, b - a));
        }
      },
      face.form);
  if (face.turned) side = {Rational(-1) * side.normal, -side.d};
  return side;
}
inline Sides sides(const HalfSpaces& solid) {
  Sides all;
  for (const half_spaces::Face& face : solid.faces) all.push_back(side_of_face(face));
  return all;
}

class RoundAndSides {
 public:
  /// K exists, with a radius above 0.
  RoundAndSides(const RoundSolid& k, const Sides& p) : k_(k), p_(p), corners_(corners(p)) {
    if (!corners_.empty()) ask_axis(), ask_edges(), ask_discs();
  }

  Relation relation() const {
    if (!meet_) return Relation::disjoint;
    if (std::ranges::all_of(p_, [&](const Side& side) { return holds_disc(side, 0) && holds_disc(side, 1); }))
      return Relation::a_inside_b;
    if (std::ranges::all_of(corners_, [&](const Place& c) { return k_.locate(c) != Location::out; }))
      return Relation::b_inside_a;
    return within_ ? Relation::overlapping : Relation::touching;
  }

 private:
  Place center(int end) const { return k_.start + Rational(end) * k_.d; }
  Rational radius(int end) const { return end == 0 ? k_.at_start : k_.at_end; }

  void ask_axis() {
    const auto shared = part(k_.start, k_.start + k_.d, p_);
    if (!shared) return;
    meet_ = true;
    within_ |= shared->first < 1 && shared->second > 0;
  }

  void ask_edges() {
    for (std::size_t i = 0; i < p_.size(); ++i)
      for (std::size_t j = i + 1; j < p_.size(); ++j) {
        const Place u = cross(p_[i].normal, p_[j].normal);
        if (dot(u, u) == 0) continue;
        const Place o = *meeting(p_[i], p_[j], Side{u, 0});
        std::optional<Rational> lo, hi;  // the part in P, which its corners bound
        for (const Place& c : corners_) {
          if (p_[i].at(c) != 0 || p_[j].at(c) != 0) continue;
          const Rational t = dot(c - o, u) / dot(u, u);
          if (!lo || t < *lo) lo = t;
          if (!hi || t > *hi) hi = t;
        }
        if (lo) ask_edge(o, u, *lo, *hi);
      }
  }
  /// The part of o + t u, lo <= t <= hi, between the planes of both ends: the excess of its distance from the axis is
  /// least at an end, or at the minimum of the parabola.
  void ask_edge(const Place& o, const Place& u, Rational lo, Rational hi) {
    const Rational from = k_.height(o), climb = k_.height(o + u) - from;
    if (climb == 0 && (from < 0 || from > 1)) return;
    if (climb != 0) {
      const Rational a = -from / climb, b = (1 - from) / climb;
      lo = std::max(lo, std::min(a, b)), hi = std::min(hi, std::max(a, b));
    }
    if (lo > hi) return;
    const auto excess = [&](const Rational& t) -> Rational {
      const Place x = o + t * u;
      const Rational r = k_.radius(k_.height(x));
      return k_.from_axis2(x) - r * r;
    };
    Rational least = std::min<Rational>(excess(lo), excess(hi));
    const Rational curvature = excess(1) + excess(-1) - 2 * excess(0), slope = (excess(1) - excess(-1)) / 2;
    if (curvature > 0)
      if (const Rational t = -slope / curvature; lo < t && t < hi) least = std::min<Rational>(least, excess(t));
    meet_ |= least <= 0;
    const Rational middle = from + (lo + hi) / 2 * climb;
    within_ |= least < 0 && middle > 0 && middle < 1;
  }

  void ask_discs() {
    for (const int end : {0, 1}) {
      if (holds(p_, center(end))) meet_ = true;
      for (const Side& face : p_) {
        const Place tilted = face.normal - (dot(face.normal, k_.d) / dot(k_.d, k_.d)) * k_.d;
        const Rational tilt = dot(tilted, tilted);
        if (tilt == 0) continue;
        const Place to_plane = (-face.at(center(end)) / tilt) * tilted, x = center(end) + to_plane;
        const Rational away = dot(to_plane, to_plane), reach = radius(end) * radius(end);
        if (away > reach || !holds(p_, x)) continue;
        meet_ = true;
        const Place n = face.normal, inwards = Rational(end == 0 ? 1 : -1) * k_.d;
        const Place on = inwards - (dot(n, inwards) / dot(n, n)) * n;
        const bool leads_on = dot(on, inwards) > 0 && std::ranges::all_of(p_, [&](const Side& s) {
                                return s.at(x) > 0 || dot(s.normal, on) >= 0;
                              });
        within_ |= away < reach && leads_on;
      }
      // The polygon that P has in the disc's plane may lie within the disc
      const Side plane = {k_.d, -dot(k_.d, center(end))};
      for (std::size_t i = 0; i < p_.size(); ++i)
        for (std::size_t j = i + 1; j < p_.size(); ++j)
          if (const auto x = meeting(p_[i], p_[j], plane); x && holds(p_, *x))
            meet_ |= distance2<3>(*x, center(end)) <= radius(end) * radius(end);
    }
  }

  /// Whether the disc lies on the inner side: its point that is farthest out.
  bool holds_disc(const Side& side, int end) const {
    const Place tilted = side.normal - (dot(side.normal, k_.d) / dot(k_.d, k_.d)) * k_.d;
    const Rational height = side.at(center(end));
    return height >= 0 && height * height >= radius(end) * radius(end) * dot(tilted, tilted);
  }

  const RoundSolid& k_;
  const Sides& p_;
  std::vector<Place> corners_;
  bool meet_ = false, within_ = false;
};

/// The sides of a segment: its ends, and two planes through it.
inline Sides sides_of_segment(const Place& p, const Place& d) {
  Place across = {0, 0, 0};
  for (std::size_t i = 0; i < 3 && dot(across, across) == 0; ++i) {
    Place unit = {0, 0, 0};
    unit[i] = 1;
    across = cross(d, unit);
  }
  const Side start = {d, -dot(d, p)}, end = {Rational(-1) * d, dot(d, p + d)};
  Sides all = {start, end};
  for (const Place& n : {across, cross(d, across)}) {
    all.push_back({n, -dot(n, p)});
    all.push_back({Rational(-1) * n, dot(n, p)});
  }
  return all;
}

/// A shape that is empty, NaN or infinite is disjoint from all.
template <Round Solid>
Relation relation(const Solid& shape, const Sides& solid) {
  const RoundSolid k = round_solid(shape);
  if (!k.exists) return Relation::disjoint;
  if (shape.radius == 0) return relation(sides_of_segment(k.start, k.d), solid);
  return RoundAndSides(k, solid).relation();
}
template <class S, Round Solid>
Relation relation(const Solid& shape, const Kdop<S, 3>& kdop) {
  if (!finite(kdop) || empty(kdop)) return Relation::disjoint;
  return relation(shape, sides(half_spaces_of(kdop)));
}

}  // namespace isect::oracle
