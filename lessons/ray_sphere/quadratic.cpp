// The quadratic (N17) and its half-B form (N18), one step for each event. They differ in the factors 2 and 4
// alone.

#include <isect/ray_sphere_methods.h>
#include "lessons/ray_sphere/telling.h"

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
      half ? "D ← B² − A C" : "D ← B² − 4 A C",             // 4
      "if D < 0",                                           // 5
      "    return MISS",                                    // 6
      half ? "t₁ ← (−B − √D) / A" : "t₁ ← (−B − √D) / 2A",  // 7
      half ? "t₂ ← (−B + √D) / A" : "t₂ ← (−B + √D) / 2A",  // 8
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
      : Teller(setup, half ? "half-B" : "quadratic", half ? "Note, N18" : "Note, N17; Möller and Haines (2002), ch. 13",
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
        "Put **o** + *t* **d** into |**x** − **c**|^2 = *r*^2. Only the vector **f** from centre to origin "
        "remains.",
        Focus::center_line, "|**f** + *t* **d**|^2 = *r*^2");
  }

  void say(const CoefficientA<C>& e) {
    script_.value("*A*", e.a.value);
    add("coefficient-a", "The factor of *t*^2", 1,
        "The squared length of the direction. For a unit direction it would be 1.\n"
        "The note prints a stray *t* here: *A* is a constant.",
        Focus::direction, "*A* = **d** · **d** = " + shown(e.a.value));
  }

  void say(const CoefficientB<C>& e) {
    known_.foot = true;
    script_.value("*B*", e.b.value);
    const std::string sign = e.b.value < 0 ? "It is negative: the ray heads towards the centre."
                                           : "It is not negative: the ray heads away from the centre.";
    add("coefficient-b", "The factor of *t*", 2,
        half_ ? "Half of the linear factor is enough, if the 2 and the 4 leave the other lines too.\n" + sign
              : "Twice the projection of **f** onto **d**. " + sign,
        Focus::along, (half_ ? "*B* = **f** · **d** = " : "*B* = 2 **f** · **d** = ") + shown(e.b.value));
  }

  void say(const CoefficientC<C>& e) {
    script_.value("*C*", e.c.value);
    const double c = e.c.value;
    add("coefficient-c", "Where the origin lies", 3,
        std::string("The constant tells on which side of the surface the origin lies. Here it is ") +
            (c > 0   ? "positive: outside."
             : c < 0 ? "negative: inside."
                     : "zero: exactly on the surface."),
        Focus::center_line, "*C* = **f** · **f** − *r*^2 = " + shown(c));
  }

  void say(const ray_sphere::Discriminant<C>& e) {
    known_.passing = true;
    script_.value("*D*", e.d.value);
    add("discriminant", "The discriminant", 4,
        half_ ? "Its sign tells how many roots there are.\n"
                "With the full *B* this line would be wrong: the tweak gains little and breeds bugs."
              : "Its sign tells how many roots there are: it compares *r* with the distance *m* of the line.",
        Focus::passing, (half_ ? "*D* = *B*^2 − *A* *C* = " : "*D* = *B*^2 − 4 *A* *C* = ") + shown(e.d.value));
  }

  void say(const LineMisses<C>& e) {
    const int roots = setup_.truth.line_roots;
    Step& step =
        add("real-roots", "Are there real roots?", 5,
            roots == 0   ? "A negative discriminant has no real root: the line misses the sphere."
            : roots == 1 ? "It is exactly zero: both roots coincide, the line touches the sphere."
                         : "It is positive: the line meets the sphere twice. Whether the *ray* does is still open.",
            Focus::passing);
    decide(step, {"*D* ≥ 0", e.d.value, 0, !e.holds,
                  roots == 0   ? "no real root"
                  : roots == 1 ? "a double root"
                               : "two real roots"});
    step.question = roots_question(setup_);
    if (!e.holds) script_.refuse(5, {6});
  }

  void say(const Root<C>& e) {
    const bool first = e.index == 0;
    known_.roots = e.index + 1;
    known_.half_chord = true;
    script_.value(first ? "*t*_1" : "*t*_2", e.t.value, {}, Role::hit);
    const std::string formula =
        std::string(first ? "*t*_1 = (−*B* − √*D*) / " : "*t*_2 = (−*B* + √*D*) / ") + (half_ ? "*A* = " : "2*A* = ");
    add(first ? "first-root" : "second-root", first ? "The smaller root" : "The larger root", first ? 7 : 8,
        first ? "The smaller root: where the line enters.\n"
                "For a ball ahead, −*B* and √*D* nearly cancel here. That costs digits far away."
              : "The larger root: where the line leaves. Here the two terms have the same sign for a ball "
                "ahead.",
        first ? Focus::first_root : Focus::half_chord, formula + shown(e.t.value));
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
      step.question = first_hit_question(setup_, {"*t*_1", "*t*_2"});
    }
    if (!e.holds) script_.refuse(first ? 9 : 11, {first ? 10 : 12});
    last_ = first ? 10 : 12;
  }

  void say(const Hit<C>& e) {
    settle(setup_.truth.origin == Location::on ? viz::Verdict::Kind::on : viz::Verdict::Kind::yes);
    add("hit", "The first hit", last_,
        "\"The smallest positive root\", as the note has it, fails on the surface and for segments. The "
        "range decides.\n" +
            solid_caption(setup_),
        Focus::none, "*t* = " + shown(e.t.value));
  }

  void say(const Miss&) {
    const bool no_roots = known_.roots == 0;
    if (no_roots) script_.leave_early();
    settle(viz::Verdict::Kind::no);
    add("miss", "No intersection", no_roots ? 6 : 13, miss_caption(setup_), Focus::none);
  }

  const bool half_;
  int last_ = 10;
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
