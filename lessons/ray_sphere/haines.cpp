// Haines' geometric method (N19), one step for each event.

#include <cmath>

#include <isect/methods/ray_sphere.h>
#include "lessons/ray_sphere/telling.h"
#include "lessons/shared/order_question.h"
#include "lessons/shared/questions.h"

namespace isect::lessons::ray_sphere_lesson {
namespace {

using namespace viz;
using namespace isect::ray_sphere;
using C = Counted<double>;

class HainesTeller : Teller {
 public:
  explicit HainesTeller(const Setup& setup)
      : Teller(setup, "Haines",
               "Lecture note, ray and sphere; Haines in Glassner (ed.), An Introduction to Ray Tracing (1989), ch. 2",
               {
                   "l ← c − o",                          // 0
                   "s ← l · d",                          // 1
                   "l² ← l · l",                         // 2
                   "if s < 0 and l² > r²",               // 3
                   "    return REJECT",                  // 4
                   "m² ← l² − s²",                       // 5
                   "if m² > r²",                         // 6
                   "    return REJECT",                  // 7
                   "q ← √(r² − m²)",                     // 8
                   "if l² > r² or (l² = r² and s > 0)",  // 9
                   "    t ← s − q",                      // 10
                   "else",                               // 11
                   "    t ← s + q",                      // 12
                   "if t > t_max",                       // 13
                   "    return REJECT",                  // 14
                   "return INTERSECT, t, o + t d"        // 15
               }) {}

  Walk tell() {
    return Teller::tell<HainesEvent<C, 3>>(
        [](const auto& ray, const auto& sphere, auto& record) { ray_sphere::haines(ray, sphere, record); },
        [this](const auto& event) { say(event); });
  }

 private:
  void say(const ToCenter<C, 3>&) {
    known_.center_line = true;
    add("to-center", "From the origin to the centre", 0,
        "Let **l** be the vector from the ray's origin **o** to the centre **c** of the ball.\n"
        "The method needs a direction of length 1, so **d** has been normalised. Now *t* is a length" +
            std::string(setup_.segment() ? ", and so is *t*_{max}." : "."),
        Focus::center_line, "**l** = **c** − **o**");
  }

  void say(const AlongRay<C>& e) {
    known_.foot = true;
    s_ = e.s.value;
    script_.value("*s*", e.s.value, "length");
    add("along-the-ray", "How far along the ray", 1,
        std::string("The projection of **l** onto **d** shows where the line is nearest to the centre. ") +
            (e.s.value < 0 ? "Here that is behind the origin.\n" : "\n") +
            "The note calls this number *d* too, like the direction. We call it *s*.",
        Focus::along, "*s* = **l** · **d** = " + shown(e.s.value));
  }

  void say(const CenterDistance<C>& e) {
    l2_ = e.l2.value;
    script_.value("*l*^2", e.l2.value, "area");
    const double r = setup_.sphere.radius;
    script_.value("*r*^2", r * r, "area", Role::second);
    add("distance", "Inside or outside?", 2,
        "The square of *l*, the distance to the centre, is compared with *r*^2. That shows on which side of the "
        "surface the origin lies.",
        Focus::center_line, "*l*^2 = **l** · **l** = " + shown(e.l2.value));
  }

  void say(const Behind<C>& e) {
    Step& step =
        add("early-reject", "A cheap rejection", 3,
            e.holds         ? "The centre lies behind, and the origin outside: along the ray the distance only grows.\n"
                              "That took no square root."
            : e.s.value < 0 ? "The centre lies behind, but the origin is not outside, so it is itself a point of "
                              "the ball."
                            : "The centre does not lie behind the origin, so the ball may lie ahead.",
            Focus::none);
    decide(step, {.text = "*s* < 0 and *l*^2 > *r*^2",
                  .holds = e.holds,
                  .meaning = e.holds         ? "behind, seen from outside"
                             : e.s.value < 0 ? "the origin is not outside"
                             : e.s.value > 0 ? "the centre lies ahead"
                                             : "the centre lies level",
                  .parts = {{"*s* < 0", e.s.value, 0, e.s.value < 0, ""},
                            {"*l*^2 > *r*^2", e.l2.value, e.r2.value, e.l2.value > e.r2.value, ""}}});
    const bool from_within = setup_.truth.origin != Location::out && !setup_.segment();
    // 0: a centre behind is taken for enough; 2: what is not rejected is taken for a hit
    step.question =
        Question{"Next the signs of *s* and *l*^2 − *r*^2 are asked. What do they tell?",
                 {"the ray misses", "nothing yet: *m*^2 is needed", "the ray hits"},
                 e.holds       ? 0
                 : from_within ? 2
                               : 1,
                 e.holds       ? "The centre lies behind an origin that is outside."
                 : from_within ? "The origin is not outside, and a ray without end leaves the ball. Where it does "
                                 "takes *m*^2."
                               : "Rejection requires a centre behind the origin and an origin outside."};
    if (!e.holds) script_.refuse(3, {4});
  }

  void say(const PassingDistance<C>& e) {
    known_.passing = true;
    m2_ = e.m2.value;
    script_.value("*m*^2", e.m2.value, "area");
    add("passing-distance", "How near the line passes", 5,
        std::string("By Pythagoras, *l*^2 and *s*^2 give *m*, the distance of the line from the centre.") +
            (e.m2.value < 0 ? " Rounding has made the square negative." : ""),
        Focus::passing, "*m*^2 = *l*^2 − *s*^2 = " + shown(e.m2.value))
        .question =
        which_value("What is *m*^2?", e.m2.value,
                    {{l2_ - s_, "That subtracts *s*, and not *s*^2."},
                     {l2_ - setup_.sphere.radius * setup_.sphere.radius, "That subtracts *r*^2, and not *s*^2."},
                     {l2_ + s_ * s_, "That adds *s*^2. The hypotenuse is *l*, so it is subtracted."}},
                    "*m* and *s* are the legs of a right triangle, and *l* is its hypotenuse.");
  }

  void say(const PassesBy<C>& e) {
    r2_ = e.r2.value;
    const bool tangent = line_roots() == 1;
    Step& step = add("passes-by", "Does the line meet the ball?", 6,
                     e.holds != (line_roots() == 0)   ? astray_line()
                     : e.holds                        ? "The line stays farther than *r* from the centre: it misses."
                     : tangent && setup_.is_a_point() ? "The line passes through the centre, and *r* is 0: the ball is "
                                                        "that one point. It counts."
                     : tangent ? "The line passes at exactly *r*: it touches the ball in one point. Touching counts."
                               : "The line passes nearer than *r*: it meets the ball.",
                     Focus::passing);
    decide(step, {"*m*^2 > *r*^2", e.m2.value, e.r2.value, e.holds,
                  e.holds != (line_roots() == 0) ? "by rounding"
                  : e.holds                      ? "the line misses the ball"
                                                 : "the line meets the ball"});
    const int as_shown = e.holds ? 0 : e.m2.value == r2_ ? 1 : 2;
    step.question =
        roots_question(setup_, as_shown == line_roots() && (as_shown == 1 || shown(e.m2.value) != shown(r2_)));
    if (!e.holds) script_.refuse(6, {7});
  }

  void say(const HalfChord<C>& e) {
    known_.half_chord = true;
    q_ = e.q.value;
    script_.value("*q*", e.q.value, "length");
    Step& step =
        add("half-chord", "Half the chord", 8,
            e.q.value > 0
                ? "Inside the ball the line runs equally far before and after the foot of the perpendicular.\n"
                  "That distance, half the chord, is *q*. Its square root is the only one once **d** has length 1."
                : "The foot of the perpendicular is the only common point, so *q*, half the chord, is 0.",
            Focus::half_chord, "*q* = √(*r*^2 − *m*^2) = " + shown(e.q.value));
    step.question = order_of_t(e.q.value);
  }

  /// Asks in which order the origin, the foot and both roots come along the line.
  std::optional<Question> order_of_t(double q) const {
    const std::vector<double> t = {0, s_, s_ - q, s_ + q};
    std::vector<double> backwards;
    for (const double x : t) backwards.push_back(-x);
    std::optional<Question> question =
        which_order("Half the chord is *q* = √(*r*^2 − *m*^2). In which order do these *t* come along **d**?",
                    {{"0", t[0]}, {"*s*", t[1]}, {"*s* − *q*", t[2]}, {"*s* + *q*", t[3]}},
                    {{{0, 2, 1, 3}, "That holds where a ball lies ahead of an origin outside."},
                     {{1, 2, 0, 3}, "That holds where the origin lies inside, and the centre ahead."},
                     {backwards, "That goes against **d**."}},
                    "The foot lies half way between the roots, and *t* = 0 is the origin.");
    if (question) question->given = {{"*s*", s_, "length"}, {"*m*^2", m2_, "area"}, {"*r*^2", r2_, "area"}};
    return question;
  }

  void say(const FromOutside<C>& e) {
    known_.roots = 2;
    const bool on = e.l2.value == e.r2.value;
    Step& step =
        add("which-root", "Which root comes first?", 9,
            on && setup_.truth.origin != Location::on ? "Rounded, the origin lies on the surface; exactly, it does not."
            : on                ? "The origin lies exactly on the surface. Heading inwards the first hit is *s* − "
                                  "*q*, else *s* + *q*: "
                                  "both give 0.\nThe note only checks *l*^2 > *r*^2, and so returns the exit "
                                  "for a ray that heads inwards."
            : line_roots() == 1 ? (setup_.is_a_point() ? "Both roots are the same: the ball is a point of the line."
                                                       : "Both roots are the same: the line touches the ball.")
            : e.holds           ? "From outside the ray enters first, at *s* − *q*."
                                : "From inside the entry lies behind: the ray leaves at *s* + *q*.",
            Focus::none, "*t*_1 = *s* − *q*,  *t*_2 = *s* + *q*");
    decide(step, {.text = "*l*^2 > *r*^2 or (*l*^2 = *r*^2 and *s* > 0)",
                  .holds = e.holds,
                  .meaning = on        ? "the origin is on the surface"
                             : e.holds ? "the origin is outside"
                                       : "the origin is inside",
                  .parts = {{"*l*^2 > *r*^2", e.l2.value, e.r2.value, e.l2.value > e.r2.value, ""},
                            {"*l*^2 = *r*^2", e.l2.value, e.r2.value, on, ""},
                            {"*s* > 0", s_, 0, s_ > 0, ""}}});
    step.question = first_hit_question(setup_, {"*s* − *q*", "*s* + *q*"},
                                       Interval<double>{as_read(s_) - as_read(q_), as_read(s_) + as_read(q_)});
    if (step.question && setup_.segment())
      step.question->given = {{"*t*_{max} |**d**|", setup_.ray.range.hi, "length", Role::first}};
    if (e.holds) {
      script_.refuse(11, {12});
    } else {
      script_.refuse(9, {10});
    }
    from_outside_ = e.holds;
  }

  void say(const Nearest<C>& e) {
    script_.value("*t*", e.t.value, "length", Role::hit);
    add("nearest-root", "The nearest root", from_outside_ ? 10 : 12,
        line_roots() == 1 ? (setup_.is_a_point() ? "The foot is the ball, which is a point."
                                                 : "The line touches the ball at the foot.")
        : from_outside_   ? "The line enters the ball half a chord before the foot." + cancellation(e.t.value)
                          : "The line leaves the ball half a chord after the foot.",
        from_outside_ ? Focus::first_root : Focus::second_root,
        (from_outside_ ? "*t* = *s* − *q* = " : "*t* = *s* + *q* = ") + shown(e.t.value));
  }

  void say(const TooFar<C>& e) {
    const bool segment = setup_.segment();
    if (segment) script_.value("*t*_{max} |**d**|", e.limit.value, "length", Role::first);
    Step& step =
        add("in-range", "Within the ray's range?", 13,
            !segment        ? "A ray has no end, so every *t* ≥ 0 is on it."
            : !e.holds      ? "The root does not lie beyond the segment's end, so it is a hit."
            : from_outside_ ? "The segment ends before it reaches the ball, though its line goes on to meet it."
                            : "The segment ends inside the ball, before the line leaves it.",
            Focus::none);
    if (segment) {
      decide(step, {"*t* > *t*_{max}", e.t.value, e.limit.value, e.holds,
                    e.holds ? "beyond the segment's end" : "on the segment"});
    }
    if (!e.holds) script_.refuse(13, {14});
  }

  void say(const Reject&) {
    script_.leave_early();
    settle(viz::Verdict::Kind::no);
    const int line = script_.walk().steps.back().line + 1;  // stands below the condition that led to it
    if (!right({})) settle(setup_.truth.origin == Location::on ? viz::Verdict::Kind::on : viz::Verdict::Kind::yes);
    const bool early = !known_.passing;  // whether the line meets the ball has not been asked
    add("reject", "No intersection", line,
        !right({}) ? astray()
        : early    ? "The ray leads away from the ball, whether or not its line meets it."
                   : miss_caption(setup_),
        Focus::none);
  }

  void say(const Intersect<C, 3>& e) {
    settle(!setup_.truth.surface                 ? viz::Verdict::Kind::no
           : setup_.truth.origin == Location::on ? viz::Verdict::Kind::on
                                                 : viz::Verdict::Kind::yes);
    add("intersect", "The first hit", 15,
        "The point follows from *t*: **p** = **o** + *t* **d**.\n" +
            (right(e.t.value) ? solid_caption(setup_) : astray()),
        Focus::none,
        fmt::format("**p** = ({}, {}, {})", shown(e.p.x().value), shown(e.p.y().value), shown(e.p.z().value)));
  }

  /// A sentence on the digits lost where the difference of *s* and *q* is small against them.
  std::string cancellation(double t) const {
    const std::string exactly = line_roots() == 2 ? lost_digits(t, setup_.truth.roots.lo) : "";
    if (exactly.empty() || !(std::abs(t) < 1e-3 * s_)) return {};
    return "\nThe origin is near the surface, so *s* and *q* nearly cancel and digits are lost." + exactly;
  }

  int line_roots() const { return setup_.truth.line_roots; }

  bool from_outside_ = false;
  double s_ = 0, l2_ = 0, m2_ = 0, r2_ = 0, q_ = 0;
};

}  // namespace

Walk haines(const Parameters& parameters) {
  const Setup s = setup(parameters, true);
  return HainesTeller(s).tell();
}

}  // namespace isect::lessons::ray_sphere_lesson
