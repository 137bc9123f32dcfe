// The quadratic (N17) and its half-B form (N18), one step for each event. They differ in the factors 2 and 4
// alone.

#include <algorithm>
#include <cmath>

#include <isect/methods/ray_sphere.h>
#include "lessons/ray_sphere/cancellation.h"
#include "lessons/ray_sphere/telling.h"
#include "lessons/shared/questions.h"

namespace isect::lessons::ray_sphere_lesson {
namespace {

using namespace viz;
using namespace isect::ray_sphere;
using C = Counted<double>;

std::vector<std::string> pseudocode(bool half) {
  return {
      "f ← o − c",                                          // 0
      "A ← d · d",                                          // 1
      half ? "B ← f · d" : "B ← 2 f · d",                   // 2
      "C ← f · f − r²",                                     // 3
      half ? "Δ ← B² − A C" : "Δ ← B² − 4 A C",             // 4
      "if Δ < 0",                                           // 5
      "    return MISS",                                    // 6
      half ? "t₁ ← (−B − √Δ) / A" : "t₁ ← (−B − √Δ) / 2A",  // 7
      half ? "t₂ ← (−B + √Δ) / A" : "t₂ ← (−B + √Δ) / 2A",  // 8
      "if t_min ≤ t₁ ≤ t_max",                              // 9
      "    return HIT, t₁",                                 // 10
      "if t_min ≤ t₂ ≤ t_max",                              // 11
      "    return HIT, t₂",                                 // 12
      "return MISS"                                         // 13
  };
}

class QuadraticTeller : Teller {
 public:
  QuadraticTeller(const Setup& setup, bool half)
      : Teller(setup, half ? "half-B" : "quadratic",
               "Lecture note, ray and sphere; Akenine-Möller and Haines, Real-Time Rendering (2002), ch. 13",
               pseudocode(half)),
        half_(half) {}

  Walk tell() {
    return Teller::tell<QuadraticEvent<C, 3>>(
        [this](const auto& ray, const auto& sphere, auto& record) {
          half_ ? ray_sphere::half_b(ray, sphere, record) : ray_sphere::quadratic(ray, sphere, record);
        },
        [this](const auto& event) { say(event); });
  }

 private:
  void say(const FromCenter<C, 3>&) {
    known_.center_line = known_.from_center = true;
    add("from-center", "From the centre to the origin", 0,
        std::string(
            "Substitute **o** + *t* **d** into |**x** − **c**|^2 = *r*^2, with **f** = **o** − **c**. Expand the "
            "square.\n") +
            (half_ ? "The coefficients of *t*^2, *t* and 1 are *A*, 2*B* and *C*: only half of the middle one is kept."
                   : "The coefficients of *t*^2, *t* and 1 are called *A*, *B* and *C*.") +
            "\nHere *t* counts lengths of **d**, which need not be 1.",
        Focus::center_line,
        "|**f** + *t* **d**|^2 − *r*^2 = (**d** · **d**) *t*^2 + 2 (**f** · **d**) *t* + (**f** · **f** − *r*^2)");
  }

  void say(const CoefficientA<C>& e) {
    a_ = e.a.value;
    script_.value("*A*", a_);
    add("coefficient-a", "The coefficient of *t*^2", 1,
        std::string("The squared length of the direction") +
            (a_ == 1 ? ", which is 1 here." : ". For a unit direction it would be 1.") +
            "\nThe note prints a stray *t* here, and one in *B*: both are constants.",
        Focus::direction, "*A* = **d** · **d** = " + shown(e.a.value));
  }

  void say(const CoefficientB<C>& e) {
    known_.foot = true;
    b_ = e.b.value;
    script_.value("*B*", b_);
    const std::string sign = b_ < 0   ? "It is negative: the ray approaches the centre at first."
                             : b_ > 0 ? "It is positive: the ray moves away from the centre."
                                      : "It is zero: no point of the line is nearer to the centre than the origin.";
    add("coefficient-b", half_ ? "Half the coefficient of *t*" : "The coefficient of *t*", 2,
        half_
            ? "Half the linear coefficient is enough if the 2 and the 4 are dropped from the other lines too.\n" + sign
            : "Twice the dot product of **f** and **d**. " + sign,
        Focus::along, (half_ ? "*B* = **f** · **d** = " : "*B* = 2 **f** · **d** = ") + shown(e.b.value));
  }

  void say(const CoefficientC<C>& e) {
    const double c = c_ = e.c.value;
    script_.value("*C*", c);
    const Location told = c > 0 ? Location::out : c < 0 ? Location::in : Location::on, truth = setup_.truth.origin;
    const std::string place = truth == Location::out  ? "outside."
                              : truth == Location::in ? "inside."
                                                      : "exactly on the surface.";
    add("coefficient-c", "Where the origin lies", 3,
        "The sign of the constant term shows on which side of the surface the origin lies." +
            lost_in(constant(setup_, c)) + "\n" +
            (told == truth ? (c > 0   ? "It is positive: "
                              : c < 0 ? "It is negative: "
                                      : "It is zero: ") +
                                 place
                           : "Rounding has changed the sign here: exactly, the origin lies " + place),
        Focus::center_line, "*C* = **f** · **f** − *r*^2 = " + shown(c));
  }

  void say(const ray_sphere::Discriminant<C>& e) {
    known_.passing = true;
    script_.value("*Δ*", e.d.value);
    const double square = b_ * b_, product = a_ * c_;
    add("discriminant", "The discriminant", 4,
        half_ ? "*Δ* equals *A* (*r*^2 − *m*^2): the line passes the centre at a distance *m*, with *m*^2 = **f** · "
                "**f** − (**f** · **d**)^2 / *A*.\n"
                "Half of *B* saves three products. That paid when floating point was slow; with the full *B* this line "
                "is wrong."
              : "*Δ* equals 4 *A* (*r*^2 − *m*^2): the line passes the centre at a distance *m*, with *m*^2 = **f** · "
                "**f** − (**f** · **d**)^2 / *A*.\n"
                "So its sign gives the number of real roots.",
        Focus::passing, (half_ ? "*Δ* = *B*^2 − *A* *C* = " : "*Δ* = *B*^2 − 4 *A* *C* = ") + shown(e.d.value))
        .question = which_value(
        "What is the discriminant *Δ*?", e.d.value,
        {{square - (half_ ? 4 : 1) * product, half_ ? "The factor 4 belongs to the full *B*."
                                                    : "That leaves out the factor 4. Only half of *B* cancels it."},
         {square + (half_ ? 1 : 4) * product, "That adds the product of *A* and *C*. It is subtracted."},
         {std::sqrt(std::abs(e.d.value)), "That is a root: *Δ* is what stands under it."}},
        half_ ? "With half of *B*, the factor 4 cancels." : "The full *B* takes the factor 4.");
  }

  void say(const LineMisses<C>& e) {
    const int roots = setup_.truth.line_roots;
    const bool as_true = roots == (e.d.value < 0 ? 0 : e.d.value > 0 ? 2 : 1);
    root_ = std::sqrt(std::max(e.d.value, 0.0));
    Step& step =
        add("real-roots", "Are there real roots?", 5,
            !as_true     ? astray_line()
            : roots == 0 ? "*Δ* is negative, so there is no real root: the line misses the sphere."
            : roots == 1 && setup_.is_a_point()
                ? "*Δ* is exactly zero: both roots coincide. The sphere is a point of the line."
            : roots == 1 ? "*Δ* is exactly zero: both roots coincide, and the line touches the sphere."
                         : "*Δ* is positive: the line meets the sphere twice. Whether the *ray* does is still open.",
            Focus::passing);
    decide(step, {"*Δ* < 0", e.d.value, 0, e.holds,
                  !as_true     ? "by rounding"
                  : roots == 0 ? "no real root"
                  : roots == 1 ? "a double root"
                               : "two real roots"});
    step.question = roots_question(setup_, as_true);
    if (!e.holds) script_.refuse(5, {6});
  }

  void say(const Root<C>& e) {
    const bool first = e.index == 0;
    (first ? roots_.lo : roots_.hi) = e.t.value;
    known_.roots = e.index + 1;
    known_.half_chord = true;
    script_.value(first ? "*t*_1" : "*t*_2", e.t.value, "lengths of **d**", Role::hit);
    const std::string formula =
        std::string(first ? "*t*_1 = (−*B* − √*Δ*) / " : "*t*_2 = (−*B* + √*Δ*) / ") + (half_ ? "*A* = " : "2*A* = ");
    add(first ? "first-root" : "second-root", first ? "The smaller root" : "The larger root", first ? 7 : 8,
        root_ == 0 ? std::string("Both roots are −*B* / ") + (half_ ? "*A*." : "2*A*.")
                   : std::string(first ? "The smaller root: where the line enters.\n"
                                       : "The larger root: where the line leaves.\n") +
                         cancellation(first, e.t.value),
        first ? Focus::first_root : Focus::half_chord, formula + shown(e.t.value));
    if (cancels(first)) what_stable_roots_lack(first);
  }

  void say(const RootInRange<C>& e) {
    const bool first = e.index == 0;
    const std::string name = first ? "*t*_1" : "*t*_2";
    const double t = e.t.value, limit = setup_.ray.range.hi;
    Step& step = add(first ? "first-in-range" : "second-in-range", "Is " + name + " in the range?", first ? 9 : 11,
                     e.holds ? name + " lies in the ray's closed range: it is the first hit."
                     : t < 0 ? name + " is negative: that point lies behind the origin."
                             : name + " lies beyond the segment's end.",
                     Focus::none);
    const bool beyond = t > limit;
    decide(step, beyond ? Comparison{name + " ≤ *t*_{max}", t, limit, false, "beyond the segment's end"}
                        : Comparison{name + " ≥ 0", t, 0, t >= 0, t >= 0 ? "on the ray" : "behind the origin"});
    if (first) {
      const Interval<double>& exact = setup_.truth.roots;
      const bool kept = digits_right(roots_.lo, exact.lo) >= 5 && digits_right(roots_.hi, exact.hi) >= 5;
      step.question = first_hit_question(setup_, {"the smaller one, *t*_1", "the larger one, *t*_2"},
                                         kept ? std::optional(roots_) : std::nullopt);
      if (step.question && setup_.segment())
        step.question->given = {{"*t*_{max}", limit, "lengths of **d**", Role::first}};
    }
    if (!e.holds) script_.refuse(first ? 9 : 11, {first ? 10 : 12});
    last_ = first ? 10 : 12;
  }

  void say(const Hit<C>& e) {
    settle(!setup_.truth.surface                 ? viz::Verdict::Kind::no
           : setup_.truth.origin == Location::on ? viz::Verdict::Kind::on
                                                 : viz::Verdict::Kind::yes);
    add("hit", "The first hit", last_,
        (setup_.truth.surface == 0.0 ? "The smallest *positive* root, as in the note, would miss it. "
         : setup_.segment()          ? "The note checks only for a positive root. A segment's end counts too.\n"
                                     : std::string("It is the smallest root in the range. ")) +
            (right(e.t.value) ? solid_caption(setup_) : astray()),
        Focus::none, "*t* = " + shown(e.t.value));
  }

  void say(const Miss&) {
    const bool no_roots = known_.roots == 0;
    if (no_roots) script_.leave_early();
    settle(right({})                             ? viz::Verdict::Kind::no
           : setup_.truth.origin == Location::on ? viz::Verdict::Kind::on
                                                 : viz::Verdict::Kind::yes);
    add("miss", "No intersection", no_roots ? 6 : 13, right({}) ? miss_caption(setup_) : astray(), Focus::none);
  }

  /// Whether the two terms of a root have opposite signs.
  bool cancels(bool first) const { return b_ != 0 && first == (b_ < 0) && c_ != 0; }

  /// Adds a step where stable roots lose what C has lost before.
  void what_stable_roots_lack(bool first) {
    const Constant c = constant(setup_, c_);
    const std::optional<Cure> cured = cure(setup_, first, c);
    if (!c.cancelled() || !cured || !cured->takes_exact_c()) return;
    const std::string name = first ? "*t*_1" : "*t*_2", quotient = first ? "*C* / (*A* *t*_2)" : "*C* / (*A* *t*_1)";
    script_.value("*C*, exact", c.exact);
    script_.value("stable " + name, cured->root, "lengths of **d**");
    script_.value(name + ", exact *C*", cured->with_exact, "lengths of **d**", Role::hit);
    const int kept = digits_right(cured->root, cured->truth), mended = digits_right(cured->with_exact, cured->truth);
    add("stable-root", "What stable roots do not cure", first ? 7 : 8,
        "By stable roots " + name + " = " + quotient +
            ": there −*B* and √*Δ* do not cancel.\nBut *C* has lost digits " +
            fmt::format("before, so {} {} right. With the exact *C* the same quotient has {} right.",
                        digits_in_words(kept), kept < 2 ? "is" : "are", mended),
        first ? Focus::first_root : Focus::half_chord);
    script_.forget({"*C*, exact", "stable " + name, name + ", exact *C*"});
  }

  /// Whether the two terms of a root cancel, in how many digits, and the form in which they do not.
  std::string cancellation(bool first, double t) const {
    if (b_ == 0) return "*B* is 0, so there is nothing to cancel. Stable roots may begin with either one.";
    if (first != (b_ < 0)) return "−*B* and the square-root term have the same sign, so they do not cancel.";
    if (c_ == 0) return "As *C* = 0, the two terms are equal and cancel exactly: this root is 0.";
    const double rest = std::abs(std::abs(b_) - root_), truth = first ? setup_.truth.roots.lo : setup_.truth.roots.hi;
    const int cancelled = rest > 0 ? static_cast<int>(std::floor(std::log10(std::abs(b_) / rest))) : 16;
    // what the table beside it calls right is not lost
    const int digits =
        cancelled < 1 || setup_.truth.line_roots != 2 ? cancelled : std::max(cancelled, 16 - digits_right(t, truth));
    const std::string over = half_ ? " / *A*" : " / 2*A*";
    const std::string stable =
        "Stable roots take " + (first ? "*t*_2 = (−*B* + √*Δ*)" + over + " first, then *t*_1 = *C* / (*A* *t*_2)."
                                      : "*t*_1 = (−*B* − √*Δ*)" + over + " first, then *t*_2 = *C* / (*A* *t*_1).");
    if (digits < 1) return "Near the surface −*B* and √*Δ* would nearly cancel.\n" + stable;
    return "−*B* and √*Δ* nearly cancel: the origin is near the surface. " +
           fmt::format("About {} of 16 digits are lost.", std::min(digits, 16)) +
           (setup_.truth.line_roots == 2 ? lost_digits(t, truth) : "") + "\n" + stable + cured_here(first);
  }

  /// A sentence on what stable roots reach in this case, unless a step of its own tells it.
  std::string cured_here(bool first) const {
    const Constant c = constant(setup_, c_);
    const std::optional<Cure> cured = cure(setup_, first, c);
    if (!cured || cured->takes_exact_c()) return {};
    if (!cured->works())
      return std::string(" They do not bring back what *B*") + (c.cancelled() ? ", *C*" : "") +
             " or *Δ* has lost before.";
    return c.cancelled() ? "" : " *C* has kept its digits here, so that root keeps them, too.";
  }

  const bool half_;
  int last_ = 10;
  double a_ = 0, b_ = 0, c_ = 0, root_ = 0;
  Interval<double> roots_ = {0, 0};
};

}  // namespace

Walk quadratic(const Parameters& parameters) {
  const Setup s = setup(parameters, false);
  return QuadraticTeller(s, false).tell();
}

Walk half_b(const Parameters& parameters) {
  const Setup s = setup(parameters, false);
  return QuadraticTeller(s, true).tell();
}

}  // namespace isect::lessons::ray_sphere_lesson
