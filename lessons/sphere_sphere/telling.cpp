#include <cmath>
#include <limits>

#include <isect/methods/sphere_sphere.h>

#include "lessons/shared/digits.h"
#include "lessons/shared/relation.h"
#include "lessons/shared/script.h"
#include "lessons/sphere_sphere/picture.h"

namespace isect::lessons::sphere_sphere_lesson {

using namespace viz;
using C = Counted<double>;

namespace {

const std::vector<std::string> pseudocode = {
    "l ← b − a",           // 0
    "d² ← l · l",          // 1
    "R ← r_a + r_b",       // 2
    "if d² < R²",          // 3
    "    return OVERLAP",  // 4
    "return DISJOINT"      // 5
};

std::string alt(const Setup& s) {
  return fmt::format("Two balls, a of radius {} and b of radius {}, their centres {} apart: {}.", shown(s.a.radius),
                     shown(s.b.radius), shown((s.b.center - s.a.center).norm()), relation_words(s.truth, "the balls"));
}

class Teller {
 public:
  explicit Teller(const Setup& setup)
      : s_(setup),
        script_({"Lecture note, sphere and sphere; Ericson, Real-Time Collision Detection (2005), 4.3.1", alt(setup),
                 pseudocode}) {}

  Walk tell() {
    const Ball3 a = s_.tested(s_.a), b = s_.tested(s_.b);
    script_.tell<std::variant<sphere_sphere::Compared<C>>>(
        [&](auto& record) { sphere_sphere::squared_distance_naive(cast<C>(a), cast<C>(b), record); },
        [&](const sphere_sphere::Compared<C>& e) { measured(e.distance2.value, e.sum2.value); });
    compared();
    return std::move(script_.walk());
  }

 private:
  Step& add(const std::string& slug, const std::string& title, int line, const std::string& caption, Focus focus,
            const std::string& formula = {}) {
    Step& step = script_.add(slug, title, line, caption, formula);
    step.scene = picture(s_, focus);
    return step;
  }

  /// One event has both squares; the operations of each step of the pseudocode are counted separately.
  void measured(double d2, double s2) {
    d2_ = d2, s2_ = s2;
    tally() = {};
    const Vector<C, 3> l = s_.tested(s_.b).center.cast<C>() - s_.tested(s_.a).center.cast<C>();
    script_.count(tally());
    add("difference", "From centre to centre", 0,
        "Only the line between the centres **a** and **b** matters; **l** is the vector along it. Two balls are "
        "nearest to each other along it.",
        Focus::line, "**l** = **b** − **a**");
    l.dot(l);
    script_.count(tally());
    script_.value("*d*^2", d2, "area");
    add("distance", "The squared distance", 1, distance_caption(d2), Focus::distance,
        "*d*^2 = **l** · **l** = " + shown(d2));
    const C sum = C(s_.a.radius) + C(s_.b.radius);
    static_cast<void>(sum * sum);
    script_.count(tally());
    script_.value("*R*^2", s2, "area", Role::second);
    add("reach", "How far the balls reach", 2,
        "Together the balls reach as far as *R*, the sum of their radii *r*_a and *r*_b.\n"
        "Neither is negative, so squaring keeps their order while the squares stay in range. No root is needed.",
        Focus::radii, "*R*^2 = (*r*_a + *r*_b)^2 = " + shown(s2));
  }

  void compared() {
    const double d2 = d2_, s2 = s2_;
    const bool near = d2 < s2;
    Step& step = add("compare", "Nearer than they reach?", 3, compare_caption(d2, s2), Focus::none,
                     "*d*^2 = " + digits(d2, s2) +
                         (near       ? " < "
                          : d2 == s2 ? " = "
                                     : " > ") +
                         digits(s2, d2) + " = *R*^2");
    Script::decide(step,
                   {"*d*^2 < *R*^2", d2, s2, near, near ? "the note returns OVERLAP" : "the note returns DISJOINT"});
    step.question = relation_question(s_.truth, "the two balls", because());
    const Ball3 a = s_.tested(s_.a), b = s_.tested(s_.b);  // these stay in range where their squares do not
    step.question->given = {{"*d*", (b.center - a.center).stableNorm(), "length", Role::highlight},
                            {"*r*_a", a.radius, "length", Role::first},
                            {"*r*_b", b.radius, "length", Role::second}};
    if (!near) script_.refuse(3, {4});

    script_.settle(verdict_kind(s_.truth), relation_words(s_.truth, "the balls"));
    add("relation", "How they relate", near ? 4 : 5, end_caption(near), Focus::settled, end_formula());
  }

  bool same_centre() const { return s_.tested(s_.a).center == s_.tested(s_.b).center; }
  bool one_point() const { return same_centre() && s_.a.radius == 0 && s_.b.radius == 0; }
  /// A ball of radius 0 on the other's surface: the distance is the reach.
  bool point_on_surface() const { return s_.inner_touch && (s_.a.radius == 0 || s_.b.radius == 0); }
  /// Whether a square is too large for a double, or too small for all its digits.
  bool left_range() const {
    const auto small = [](double square) { return square < std::numeric_limits<double>::min(); };
    return std::isinf(d2_) || std::isinf(s2_) || (small(d2_) && !same_centre()) ||
           (small(s2_) && s_.a.radius + s_.b.radius > 0);
  }

  std::string distance_caption(double d2) const {
    if (std::isinf(d2))
      return "The centres lie so far apart that the square of their distance *d* overflows: it is infinite.";
    if (d2 == 0 && same_centre()) return "The square of the distance *d* is zero: the centres coincide.";
    if (d2 == 0) return "The square of the distance *d* is too small for a double: it underflows to zero.";
    return "The dot product of **l** with itself is the square of the distance *d*.";
  }

  std::string compare_caption(double d2, double s2) const {
    if (std::isinf(d2) && std::isinf(s2))
      return "Both squares have overflowed. Infinity is not less than infinity; with ≤ any two balls would seem to "
             "meet.";
    if (d2 == 0 && s2 == 0 && one_point())
      return "Both balls are the same point. Zero is not less than zero: the strict comparison refuses it.";
    if (d2 == 0 && s2 == 0)
      return "Both squares are stored as zero. Zero is not less than zero; with ≤ all balls so small and close would "
             "seem to meet.";
    const bool touch = s_.truth == Relation::touching, apart = s_.truth == Relation::disjoint;
    if (d2 == s2 && touch) return "The distance equals the reach: the balls touch. The strict comparison refuses it.";
    if (d2 == s2 && point_on_surface())
      return "The distance equals the reach: one ball is a point on the other's surface. The strict comparison refuses "
             "it.";
    if (d2 < s2 && !touch && !apart) return "The centres lie nearer than the balls reach: they overlap.";
    if (d2 > s2 && apart) return "The centres lie farther apart than the balls reach: no common point.";
    return "The two squares are so close that rounding has changed which of them is larger, or made them equal.";
  }

  std::string because() const {
    switch (s_.truth) {
      case Relation::disjoint:
        return "*d* > *r*_a + *r*_b.";
      case Relation::touching:
        return "*d* = *r*_a + *r*_b: one common point.";
      case Relation::overlapping:
        return "*d* < *r*_a + *r*_b, and *d* > |*r*_a − *r*_b|.";
      case Relation::equal:
        return "Centres and radii are the same.";
      default:
        return "*d* ≤ |*r*_a − *r*_b|: the larger ball contains the smaller one.";
    }
  }

  std::string end_caption(bool near) const {
    const bool meets = s_.truth != Relation::disjoint;
    if (s_.truth == Relation::touching)
      return "The lecture note calls touching DISJOINT here, but OVERLAP for boxes.\n"
             "With ≤, one rule serves all shapes: sets are closed, so one common point is an intersection.";
    if (near != meets && d2_ == s2_ && point_on_surface())
      return "The lecture note's answer is wrong here: the point lies in the other ball, and its strict < refuses it.";
    if (near != meets && one_point())
      return "The lecture note's answer is wrong here: the balls share a point, and its strict < refuses it.";
    if (near != meets)
      return std::string("The lecture note's answer is wrong here: ") +
             (left_range() ? "its squares left the range of the numbers." : "rounding has changed its squares.") +
             "\nThe exact test computes again in wider numbers, and its answer holds at any scale.";
    switch (s_.truth) {
      case Relation::overlapping:
        return "Their surfaces share a circle. Neither ball contains the other, as *d* > |*r*_a − *r*_b|.";
      case Relation::disjoint:
        return d2_ > s2_ ? "A gap is left between them. Four products and no square root show it."
                         : "A gap is left between them. The squares do not show it; the exact test computes again in "
                           "wider numbers.";
      case Relation::equal:
        return "The two balls are the same set.";
      default:
        if (s_.inner_touch)
          return "One ball lies inside the other and touches it from within: *d* = |*r*_a − *r*_b|.\n"
                 "This is called internal tangency.";
        return "OVERLAP does not say that one ball lies inside the other.\n"
               "That takes a second comparison, with the difference of the radii.";
    }
  }

  std::string end_formula() const {
    // both sides of the formula are in the unit of the setting
    const std::string unit = s_.unit > 1 ? " · 2^{600}" : s_.unit < 1 ? " · 2^{−600}" : "";
    const double d = (s_.a.center - s_.b.center).norm(), r1 = s_.a.radius, r2 = s_.b.radius;
    const bool inside = s_.truth == Relation::a_inside_b || s_.truth == Relation::b_inside_a;
    if (inside) return ordered("*d*", d, s_.inner_touch ? "=" : "<", std::abs(r1 - r2), "|*r*_a − *r*_b|", unit);
    const bool even = s_.truth == Relation::touching || one_point();
    const char* sign = s_.truth == Relation::disjoint ? ">" : even ? "=" : "<";
    return ordered("*d*", d, sign, r1 + r2, "*r*_a + *r*_b", unit);
  }

  const Setup s_;
  Script script_;
  double d2_ = 0, s2_ = 0;
};

}  // namespace

Walk tell(const Setup& setup) { return Teller(setup).tell(); }

}  // namespace isect::lessons::sphere_sphere_lesson
