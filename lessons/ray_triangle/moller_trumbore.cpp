// The three unknowns t, u, v by Cramer's rule, one after the other.

#include <cmath>

#include "lessons/ray_triangle/telling.h"
#include "lessons/shared/questions.h"

namespace isect::lessons::ray_triangle_lesson {
namespace {

using namespace viz;
using namespace isect::ray_triangle;

class CramerTeller : Teller {
 public:
  explicit CramerTeller(const Setup& s)
      : Teller(s, "Möller and Trumbore", "Möller and Trumbore, Fast, minimum storage ray/triangle intersection (1997)",
               {
                   "e₁ ← b − a, e₂ ← c − a",             // 0
                   "det ← (d × e₂) · e₁",                // 1
                   "if det = 0",                         // 2
                   "    return MISS",                    // 3
                   "l ← o − a, u ← (d × e₂) · l / det",  // 4
                   "if u < 0 or u > 1",                  // 5
                   "    return MISS",                    // 6
                   "v ← (l × e₁) · d / det",             // 7
                   "if v < 0 or u + v > 1",              // 8
                   "    return MISS",                    // 9
                   "t ← (l × e₁) · e₂ / det",            // 10
                   "if t < 0 or t > t_max",              // 11
                   "    return MISS",                    // 12
                   "return HIT, t, u, v"                 // 13
               }) {}

  Walk tell() {
    known_.edges = true;
    add("edges", "Two steps along the edges", 0,
        "A point of the plane is **a** + *u* **e**_1 + *v* **e**_2: from **a**, two steps along the edges.\n"
        "The edge **e**_1 leads from **a** to **b**, and **e**_2 to **c**.\n"
        "A point of the ray is **o** + *t* **d**. Where they are equal, *t*, *u* and *v* solve three equations.",
        "**e**_1 = **b** − **a**,  **e**_2 = **c** − **a**");
    run<MollerTrumboreEvent<C>>([](const auto& ray, const auto& triangle,
                                   auto& record) { return ray_triangle::moller_trumbore(ray, triangle, record); },
                                [this](const auto& event) { say(event); });
    end(13);
    return std::move(script_.walk());
  }

 private:
  void say(const Determinant<C>& e) {
    const double det = e.value.value;
    script_.value("*det*", det, {}, Role::muted);
    Step& step =
        add("determinant", "The determinant", 1,
            "By Cramer's rule each unknown is a quotient of two determinants. This one, *det*, is below all three.\n"
            "Its size is the volume of the parallelepiped that **d**, **e**_1 and **e**_2 span." +
                facing(det),
            "*det* = (**d** × **e**_2) · **e**_1 = " + shown(det));
    step.question = {"You look along **d**. Which face of the triangle do you see?",
                     {"the front face: **a**, **b**, **c** turn counter-clockwise",
                      "the back face: **a**, **b**, **c** turn clockwise", "neither of them"},
                     s_.heading < 0   ? 0
                     : s_.heading > 0 ? 1
                                      : 2,
                     s_.heading == 0 ? "**d** lies along the plane, or the triangle has none."
                                     : "The order of **a**, **b**, **c** decides; by the usual convention it turns "
                                       "counter-clockwise on the front face."};
    keep_picture(script_.walk());
    known_.edges = false;
    parallel(2, "*det*", det);
  }

  /// What the determinant's sign says of the face, if it is right.
  std::string facing(double det) const {
    if ((det > 0) != (s_.heading < 0) || (det < 0) != (s_.heading > 0))
      return unless(false, s_.heading < 0 ? "it is positive" : s_.heading > 0 ? "it is negative" : "it is 0");
    return det > 0   ? " It is positive where **d** meets the front face, as here."
           : det < 0 ? " It is negative, as **d** meets the back face. Renderers that cull back faces stop here."
                     : " It is 0, as they lie in one plane.";
  }

  void say(const WeightU<C>& e) {
    const double u = e.value.value;
    known_.u = u;
    script_.value("*u*", u);
    add("weight-u", "The weight of **b**", 4,
        std::string("*u* is the weight of **b**: 0 on the edge ca, and 1 at **b**.") +
            (std::abs(u) < largest_weight ? " The line drawn has points of this weight." : "") +
            "\nThe vector **l** leads from **a** to the origin **o**.",
        "*u* = (**d** × **e**_2) · **l** / *det* = " + shown(u));
    const bool exactly = e.holds ? s_.weight(1) >= 0 : u < 0 ? s_.weight(1) < 0 : s_.weight(0) < 0 || s_.weight(2) < 0;
    Step& step = add("range-u", "Does *u* rule it out?", 5,
                     (e.holds ? "It lies between 0 and 1, which leaves both answers open."
                      : u < 0 ? "A negative weight: the point lies beyond the edge ca."
                              : "A weight above 1: the other two sum to less than 0, so one of them is negative.") +
                         unless(exactly, verdict_text(s_)));
    const Comparison below = {"*u* < 0", u, 0, u < 0, ""}, above = {"*u* > 1", u, 1, u > 1, ""};
    Script::decide(step, {.text = below.text + " or " + above.text,
                          .holds = !e.holds,
                          .meaning = e.holds ? "nothing is ruled out yet" : "outside of the triangle",
                          .parts = {below, above}});
    if (e.holds) script_.refuse(5, {6});
  }

  void say(const WeightV<C>& e) {
    const double u = known_.u.value_or(0), v = e.value.value;
    known_.v = v;
    script_.value("*v*", v);
    add("weight-v", "The weight of **c**", 7,
        std::string("*v* is the weight of **c**: 0 on the edge ab, and 1 at **c**.") +
            (std::abs(v) < largest_weight ? " The two lines cross in the point in question." : "") +
            "\nWhat is left of 1, 1 − *u* − *v*, is the weight of **a**. It is 0 on the edge bc.",
        "*v* = (**l** × **e**_1) · **d** / *det* = " + shown(v));
    const bool exactly = e.holds ? s_.truth.location != Location::out : v < 0 ? s_.weight(2) < 0 : s_.weight(0) < 0;
    Step& step = add("range-v", "Inside the triangle?", 8,
                     (e.holds ? "No weight is negative: the point lies in the triangle."
                      : v < 0 ? "The weight of **c** is negative: the point lies beyond the edge ab."
                              : "The weight of **a** is negative: the point lies beyond the edge bc.") +
                         unless(exactly, verdict_text(s_)));
    const Comparison below = {"*v* < 0", v, 0, v < 0, ""}, above = {"*u* + *v* > 1", u + v, 1, u + v > 1, ""};
    Script::decide(step, {.text = below.text + " or " + above.text,
                          .holds = !e.holds,
                          .meaning = e.holds ? "the line meets the triangle" : "outside of the triangle",
                          .parts = {below, above}});
    step.question = third_weight_question(u, v, e.holds);
    if (e.holds) script_.refuse(8, {9});
  }

  /// Asks for the weight that is left. None where the numbers as shown do not give it, or not the sign of v.
  std::optional<Question> third_weight_question(double u, double v, bool holds) const {
    const double w = 1 - u - v;
    const auto tiny = [](double x) { return x != 0 && std::abs(x) < 1e-3; };
    if (tiny(v) || tiny(w) || !read_well(1 - as_read(u) - as_read(v), w)) return {};
    return which_value(
        fmt::format("*u* is {} and *v* is {}. What is the weight of **a**?", shown(u), shown(v)), w,
        {{u, "That is the weight of **b**."},
         {v, "That is the weight of **c**."},
         {u + v, "That is the sum of the other two. What is left of 1 is asked for."},
         {1 - u, "That leaves out *v*."},
         {1 - u + v, "That adds *v*. It is subtracted, as *u* is."}},
        std::string("All three weights sum to 1. ") +
            (holds   ? "None of them is negative: the point lies in the triangle."
             : v < 0 ? "Here *v* is negative: it is the weight of **c**, which is opposite ab."
                     : "This one is negative: **a** is opposite bc, so the point lies beyond that edge."));
  }

  void say(const InRange<C>& e) {
    const double t = e.t.value;
    script_.value("*t*", t, {}, e.holds ? Role::hit : Role::muted);
    known_.crossing = true;
    add("parameter", "Where on the ray", 10,
        "The third unknown needs no new cross product: **l** × **e**_1 is known from *v*.",
        "*t* = (**l** × **e**_1) · **e**_2 / *det* = " + shown(t));
    range(11, t, e.holds);
  }
};

}  // namespace

Walk moller_trumbore(const Setup& s) { return CramerTeller(s).tell(); }

}  // namespace isect::lessons::ray_triangle_lesson
