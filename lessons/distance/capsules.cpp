// Two capsules: how near they come, compared with a bound, without a root.

#include <fmt/format.h>

#include <cmath>

#include "lessons/distance/telling.h"
#include "lessons/shared/digits.h"
#include "lessons/shared/questions.h"

namespace isect::lessons::distance_lesson {

using namespace viz;
using C = Counted<double>;

namespace {

class CapsulesTeller : Teller {
 public:
  explicit CapsulesTeller(const Setup& s)
      : Teller(s, "two capsules and a bound", "Ericson, Real-Time Collision Detection (2005), 4.5.1 and 5.1.9",
               {"bound ← r_a + r_b + clearance",              // 0
                "if bound < 0",                               // 1
                "    return FAR",                             // 2
                "d² ← the squared distance of the segments",  // 3
                "if d² > bound²",                             // 4
                "    return FAR",                             // 5
                "return NEAR"}) {}                            // 6

  Walk tell() {
    known_.radii = true;
    add("clearance", "How near is too near?", 0,
        "A capsule is a segment with a radius. If they are disjoint, their surfaces are *d* − *R* apart.\n"
        "*d* is the distance of the segments, and *R* = *r*_a + *r*_b. The clearance is how far apart the surfaces "
        "have to be.\n"
        "Below 0 it asks whether they reach into each other as far as that.");
    script_.tell<nearest_features::CapsuleEvent<C, 3>>(
        [&](auto& record) {
          nearest_features::within<C, 3>(cast<C>(s_.capsule(0)), cast<C>(s_.capsule(1)), C(s_.clearance), record);
        },
        [&](const auto& event) { say(event); });
    if (bound_ < 0) squares_alone();
    root();
    return std::move(script_.walk());
  }

 private:
  double sum() const { return s_.r_a + s_.r_b; }

  void say(const nearest_features::Bound<C>& e) {
    bound_ = e.bound.value;
    script_.value("clearance", s_.clearance, "length");
    script_.value("bound", bound_, "length", Role::first);
    Step& step = add("bound", "A bound for the segments", 0,
                     "Both sides of *d* − *R* ≤ clearance are raised by *R*. Then one bound stands against *d*.",
                     fmt::format("bound = {}", shown(bound_)));
    if (bound_ >= 0)
      step.question =
          which_value(fmt::format("The clearance is {}, *r*_a is {} and *r*_b is {}. "
                                  "How far apart may the segments be, to count as near?",
                                  shown(s_.clearance), shown(s_.r_a), shown(s_.r_b)),
                      bound_,
                      {{s_.clearance, "That is for the surfaces. The segments lie inside."},
                       {sum(), "Then the capsules touch. The clearance is left out."},
                       {std::abs(s_.clearance - sum()), "The radii are added to the clearance, not taken off."}},
                      "The surfaces are nearer than the segments by both radii.");
    known_.radii = false;

    const bool never = bound_ < 0;
    if (never) settle();
    Step& sign =
        add("sign", "Is the bound below 0?", never ? 2 : 1,
            never ? "No distance is below 0. So the answer is no, before anything else is computed." + misled(false)
                  : std::string("It is not, so both sides may be squared: that keeps their order."),
            fmt::format("bound = {}", shown(bound_)));
    Script::decide(sign, {"bound < 0", bound_, 0, never, never ? "no distance is so small" : "squares keep the order"});
    if (never)
      sign.question = Question{fmt::format("The bound is {}. What follows?", shown(bound_)),
                               {"no segments are so near, so the answer is no",
                                fmt::format("*d*^2 is compared with {}", shown(bound_ * bound_)),
                                fmt::format("*d* is compared with {}", shown(-bound_))},
                               0,
                               "A square loses the sign. So the sign is asked before."};
    else
      script_.refuse(1, {2});
  }

  void say(const nearest_features::Lines<C>&) {}  // the walk of two segments tells how d is found
  void say(const nearest_features::Found<C>&) {}
  void say(const nearest_features::Closest<C, 3>& e) {
    const double squared = e.distance2.value;
    known_.ways = {{Vec3(e.on_a[0].value, e.on_a[1].value, e.on_a[2].value),
                    Vec3(e.on_b[0].value, e.on_b[1].value, e.on_b[2].value)}};
    script_.value("*d*^2", squared, "area", Role::highlight);
    add("squared", "The segments' distance, squared", 3,
        "The walk of two segments tells how this is found. The radii play no part in it.", "*d*^2 = " + shown(squared));
  }

  void say(const nearest_features::Compared<C>& e) {
    const double squared = e.distance2.value, bound2 = e.bound2.value;
    const bool far = !(squared <= bound2);
    script_.value("bound^2", bound2, "area", Role::first);
    settle();
    last_ = far ? 5 : 6, near_ = !far;
    const std::string sign = far ? " > " : squared < bound2 ? " < " : " = ";
    Step& step = add("compare", "Two squares", 4, compared(),
                     "*d*^2 = " + digits(squared, bound2) + sign + digits(bound2, squared) + " = bound^2");
    Script::decide(step,
                   {"*d*^2 > bound^2", squared, bound2, far, far ? "farther than the bound" : "within the bound"});
    step.question =
        Question{fmt::format("*d*^2 = {} and bound = {}. What follows?", digits(squared, bound2),
                             digits(bound_, std::sqrt(squared))),
                 {"they come within the clearance", "they are farther apart than the clearance",
                  "nothing, before the root of *d*^2 is taken"},
                 far ? 1 : 0,
                 "For numbers of at least 0, squares have the order of the numbers. So the bound is squared."};
    if (!far) script_.refuse(4, {5});
  }

  /// What follows from the squares, as the core decides.
  std::string compared() const {
    if (near_ != (s_.beyond <= 0))
      return std::string("By these squares the surfaces ") + (near_ ? "come within" : "are farther apart than") +
             " the clearance." + misled(near_);
    if (s_.beyond > 0)
      return "The square of the distance is larger. So the surfaces are farther apart than the clearance.";
    return s_.beyond < 0 ? "The square of the bound is not exceeded. So the surfaces are nearer than the clearance."
                         : "The distance is exactly the bound. Equal counts as near.";
  }

  /// Whether rounding has misled the method, in words.
  std::string misled(bool near) const {
    return near == (s_.beyond <= 0) ? "" : "\nRounding has misled the method: exactly, it is the other way round.";
  }

  void squares_alone() {
    Record<nearest_features::CapsuleEvent<double, 3>> record;
    const bool near = nearest_features::within_by_squares(s_.capsule(0), s_.capsule(1), s_.clearance, record);
    const auto& squares = std::get<nearest_features::Compared<double>>(record.events.back());
    script_.value("*d*^2", squares.distance2, "area", Role::highlight);
    script_.value("bound^2", squares.bound2, "area", Role::first);
    add("squares", "Squares alone", 2,
        near ? "A test of squares alone would say yes here: the square of the bound has lost its sign."
             : "Here a test of squares alone would say no, too. For segments that are near enough it would say yes.",
        "*d*^2 = " + digits(squares.distance2, squares.bound2) + (near ? " ≤ " : " > ") +
            digits(squares.bound2, squares.distance2) + " = bound^2");
  }

  /// The number that a user may want: here alone a root is taken.
  void root() {
    const double d = s_.distance(), apart = d - sum();
    script_.value("*d*", d, "length", Role::highlight);
    script_.value("*d* − *R*", apart, "length");
    known_.ways.clear(), known_.settled = true;
    add("root", "The number itself", last_,
        "How far apart are the surfaces? That takes the root of *d*^2, and *R* is taken off.\n" + surfaces(apart) +
            misled(near_),
        fmt::format("*d* − *R* = {}", shown(apart)));
  }

  /// What the exact sign of *d* − *R* says; `apart` is rounded.
  std::string surfaces(double apart) const {
    const int sign = nearest_features::order(s_.capsule(0), s_.capsule(1), 0);
    if (sign > 0)
      return "Conservative advancement divides this number by a bound on how fast it falls.\n"
             "That gives a safe time step, as for moving bodies.";
    if (sign == 0)
      return sum() > 0 ? "The capsules touch." : "With radii of 0 the capsules are their segments, and these meet.";
    return apart < 0 ? "The capsules share points. The number is below 0: so deep they reach into each other."
                     : "The capsules share points.";
  }

  double bound_ = 0;
  int last_ = 2;
  bool near_ = false;
};

}  // namespace

Walk capsules(const Setup& s) { return CapsulesTeller(s).tell(); }

}  // namespace isect::lessons::distance_lesson
