// Two balls that move: a expanded by the radius of b is a ball, and b a point on a ray. So first contact is a root of a
// quadratic.

#include "lessons/moving_bodies/telling.h"
#include "lessons/shared/questions.h"

namespace isect::lessons::moving_bodies_lesson {

using namespace viz;
using C = Counted<double>;

namespace {

int sign(double x) { return (x > 0) - (x < 0); }

class BallsTeller : Teller {
 public:
  explicit BallsTeller(const Setup& s)
      : Teller(s, "two balls",
               "Lecture note, rays, and ray and sphere; Ericson, Real-Time Collision Detection (2005), 5.5.5",
               {"o ← b; d ← v_b − v_a",       // 0
                "c ← a; R ← r_a + r_b",       // 1
                "f ← o − c; C ← f · f − R²",  // 2
                "if C ≤ 0",                   // 3
                "    return HIT, 0",          // 4
                "B ← f · d",                  // 5
                "if B ≥ 0",                   // 6
                "    return MISS",            // 7
                "A ← d · d; Δ ← B² − A C",    // 8
                "if Δ < 0",                   // 9
                "    return MISS",            // 10
                "t ← (−B − √Δ) / A",          // 11
                "if t > duration",            // 12
                "    return MISS",            // 13
                "return HIT, t"}) {}          // 14

  Walk tell() {
    two_bodies(0);
    seen_from_a(0);
    script_.tell<motion::QuadraticEvent<C, 2>>(
        [&](auto& record) {
          const Moving<Sphere, double, 2> a = s_.ball_a(), b = s_.ball_b();
          const auto t = contact_by_quadratic(Moving<Sphere, C, 2>{cast<C>(a.shape), a.velocity.cast<C>()},
                                              Moving<Sphere, C, 2>{cast<C>(b.shape), b.velocity.cast<C>()},
                                              C(s_.duration), record);
          found_ = t.has_value();
        },
        [&](const auto& event) { say(event); });
    if (line_ < 11) script_.leave_early();
    end("contact", found_ ? "First contact" : "No contact", line_, found_, told());
    return std::move(script_.walk());
  }

 private:
  void say(const motion::Relative<C, 2>&) {}  // told before

  void say(const motion::Offset<C, 2>& e) {
    c_ = e.c.value;
    known_.expanded = true;
    script_.value("*R*", e.reach.value, "length");
    add("expanded", "A ray and a ball", 1,
        "The balls, of radii *r*_a and *r*_b, share a point when their centres are at most *R* apart.\n"
        "So expand a to radius *R*: their Minkowski sum. Then b shrinks to its centre, which moves along "
        "**d**. When does it enter the ball?",
        "*R* = *r*_a + *r*_b = " + shown(e.reach.value));
    script_.value("*C*", c_);
    add("coefficient-c", "Are they apart at first?", 2,
        "Let **f** lead from **a** to **b**. Substitute the ray into the equation of the expanded ball: the constant "
        "is *C*.\n" +
            (sign(c_) != s_.signs.apart ? at_fault(s_.signs.apart > 0    ? "they are apart at first"
                                                   : s_.signs.apart == 0 ? "they touch at first"
                                                                         : "they overlap at first")
             : c_ > 0                   ? std::string("It is positive: they are apart at first.")
             : c_ < 0                   ? std::string("It is negative: they overlap at first.")
                                        : std::string("It is zero: they touch at first.")),
        "*C* = **f** · **f** − *R*^2 = " + shown(c_));
    if (c_ > 0) return script_.refuse(3, {4});
    decide("together", "Contact at once", 3, "Already at *t* = 0 the centres are at most *R* apart.",
           s_.signs.apart <= 0, {"*C* ≤ 0", c_, 0, true, "they share a point at *t* = 0"});
    line_ = 4;
  }

  void say(const motion::Receding<C>& e) {
    b_ = e.b.value;
    script_.value("*B*", b_);
    add("coefficient-b", "Does the distance fall?", 5,
        "*B* is half the coefficient of *t*: its sign is that of the change of the distance at *t* = 0.\n" +
            (apart() && sign(b_) != s_.signs.receding ? at_fault(s_.signs.receding < 0    ? "the distance falls"
                                                                 : s_.signs.receding == 0 ? "the distance stays"
                                                                                          : "the distance grows")
             : b_ < 0                                 ? std::string("It is negative: the distance falls at first.")
             : b_ > 0                                 ? std::string("It is positive: the distance grows.")
                                                      : std::string("It is zero: the distance does not fall.")),
        "*B* = **f** · **d** = " + shown(b_));
    if (b_ < 0) return script_.refuse(6, {7});
    Step& step = decide("receding", "Apart, and not approaching", 6,
                        "They are apart, and the distance does not fall. On a straight course it cannot fall later.",
                        apart() && s_.signs.receding >= 0, {"*B* ≥ 0", b_, 0, true, "they do not approach"});
    // a distance that grows is taken to say nothing yet; a line is taken for a ray
    if (!s_.first)
      step.question = Question{"*C* is positive, and *B* is not negative. What follows for the balls?",
                               {"they meet, if *Δ* ≥ 0", "nothing yet", "no contact"},
                               2,
                               "The squared distance is a parabola in *t*. Where it does not fall, it has passed its "
                               "lowest point."};
    line_ = 7;
  }

  void say(const motion::Passing<C>& e) {
    const double a = e.a.value, delta = e.discriminant.value;
    script_.value("*A*", a);
    script_.value("*Δ*", delta);
    Step& step =
        add("discriminant", "Does the course meet the ball?", 8,
            "*A* is the coefficient of *t*^2. The sign of *Δ* shows whether the line meets the expanded ball.\n" +
                (apart() && sign(delta) != s_.signs.discriminant
                     ? at_fault(s_.signs.discriminant > 0    ? "it meets the ball"
                                : s_.signs.discriminant == 0 ? "it touches the ball"
                                                             : "it passes by")
                 : delta > 0 ? std::string("It is positive: the line passes through.")
                 : delta < 0 ? std::string("It is negative: the line passes by.")
                             : std::string("It is zero: the line touches the expanded ball.")),
            "*Δ* = *B*^2 − *A* *C* = " + shown(delta));
    // Where rounding turns its sign the numbers shown do not give it.
    if (sign(delta) == s_.signs.discriminant) {
      step.question =
          which_value("What is the discriminant *Δ*?", delta,
                      {{b_ * b_ - 4 * a * c_, "The factor 4 belongs to the full coefficient, and *B* is half of it."},
                       {b_ * b_ + a * c_, "That adds *A* *C*. It is subtracted."},
                       {b_ * b_ - c_, "That leaves out *A*."}},
                      "*B* is half the coefficient of *t*, so there is no factor 4.");
      step.question->given = {{"*A*", a}, {"*B*", b_}, {"*C*", c_}};
    }
    if (delta >= 0) return script_.refuse(9, {10});
    decide("passes", "They pass each other", 9,
           "Even where the distance is least, the centres are more than *R* apart.",
           apart() && s_.signs.discriminant < 0, {"*Δ* < 0", delta, 0, true, "the line passes by"});
    line_ = 10;
  }

  void say(const motion::Entry<C>& e) {
    const double t = e.t.value;
    script_.value("*t*", t, {}, e.late ? Role::muted : Role::hit);
    if (t <= 1.1 * s_.duration)  // else it lies beyond the axis
      known_.ticks.push_back({t, e.late ? Mark::excluded : Mark::disc, e.late ? Role::construction : Role::hit, "*t*"});
    known_.found = !e.late;
    const bool digits = s_.first && shown(t) != shown(*s_.first);
    add("root", "The smaller root", 11,
        (apart() && s_.signs.discriminant >= 0
             ? std::string("The ray enters the expanded ball at the smaller root: then the distance of the centres "
                           "first falls to *R*.") +
                   (s_.signs.discriminant > 0 ? " At the larger root it leaves, and the balls part." : "")
             : std::string("Rounded, there is a root, so the method goes on.")) +
            std::string("\nWhere the balls almost touch at first, −*B* and √*Δ* nearly cancel. Stable roots, as for a "
                        "ray and a sphere, do not subtract: *t* = *C* / (−*B* + √*Δ*).") +
            (digits ? fmt::format("\nRounding has cost digits here: exactly, *t* is {}.", shown(*s_.first))
                    : std::string()),
        "*t* = (−*B* − √*Δ*) / *A* = " + shown(t));
    if (!e.late) return script_.refuse(12, {13});
    decide("late", "Within the motion?", 12, "The root lies after the end of the motion.", !s_.first,
           {"*t* > duration", t, s_.duration, true, "after the motion"});
    line_ = 13;
  }

  /// Adds a step whose condition holds; `right`: exactly, too.
  Step& decide(const std::string& slug, const std::string& title, int line, const std::string& caption, bool right,
               Comparison comparison) {
    if (!right) comparison.meaning = "by rounding";
    Step& step = add(slug, title, line, right ? caption : "Rounding alone makes this condition hold.");
    Script::decide(step, comparison);
    return step;
  }

  /// Whether the exact signs of B and of the discriminant are known: they are asked of balls that are apart.
  bool apart() const { return s_.signs.apart > 0; }
  static std::string at_fault(const std::string& truth) {
    return "Rounding has changed the sign here: exactly, " + truth + ".";
  }

  std::string told() const {
    if (s_.truth == Meeting::past && s_.signs.receding < 0)
      return "They pass each other: at no time are the centres within *R*. " + reason();
    return reason();
  }

  double c_ = 0, b_ = 0;
  bool found_ = false;
  int line_ = 14;  ///< that returns
};

}  // namespace

Walk balls(const Setup& s) { return BallsTeller(s).tell(); }

}  // namespace isect::lessons::moving_bodies_lesson
