// A ray that is given by a point and a direction, or by two points, against a wall.

#include <fmt/format.h>

#include <isect/methods/ray_plane.h>
#include "lessons/rays/picture.h"
#include "lessons/shared/line_question.h"
#include "lessons/shared/questions.h"
#include "lessons/shared/script.h"

namespace isect::lessons::rays_lesson {

using namespace viz;
using C = Counted<double>;

namespace {

/// The letter of the direction that the ray ends up with.
const char* letter(const Setup& s) { return s.made == Made::unit ? "u" : "d"; }

std::vector<std::string> pseudocode(const Setup& s) {
  const char* const made = s.made == Made::points ? "o ← p₁; d ← p₂ − p₁"
                           : s.made == Made::unit ? "o, d ← as given; u ← d / |d|"
                                                  : "o, d ← as given";
  const char* const segment = s.made == Made::unit ? "[0, |d|]" : "[0, 1]";
  return {made,                                                                        // 0
          fmt::format("r(t) = o + t {}", letter(s)),                                   // 1
          fmt::format("t_min, t_max ← {} or [0, ∞) or (−∞, ∞)", segment),              // 2
          fmt::format("if n · {} = 0: return n · o + D = 0 ? HIT : MISS", letter(s)),  // 3
          fmt::format("t ← −(n · o + D) / (n · {})", letter(s)),                       // 4
          "if t < t_min or t > t_max: return MISS",                                    // 5
          "return HIT, r(t)"};                                                         // 6
}

/// The unit of t, for readers who don't see the axis.
std::string unit_of_t(const Setup& s) {
  return s.made == Made::unit || s.ray.direction.squaredNorm() == 1 ? " (a length)" : ", in lengths of d";
}

class Teller {
 public:
  explicit Teller(const Setup& setup)
      : s_(setup),
        script_({"Lecture note Intersection Detection, rays, and ray against plane",
                 fmt::format("A {} and a wall at x = {}: {}.", s_.extent, shown(s_.wall),
                             s_.truth.coplanar ? "it lies in the wall"
                             : s_.truth.meets  ? "they meet at t = " + shown(*s_.truth.t) + unit_of_t(s_)
                                               : "they do not meet"),
                 pseudocode(setup),
                 s_.made == Made::points ? "two points"
                 : s_.made == Made::unit ? "unit direction"
                                         : "point and direction"}) {}

  Walk tell() {
    made();
    marks();
    range();
    script_.tell<ray_plane::TextbookEvent<C>>(
        [&](auto& record) { ray_plane::textbook(counted(), cast<C>(s_.plane), record); },
        [&](const auto& event) { say(event); });
    verdict();
    return std::move(script_.walk());
  }

 private:
  /// The same ray with counting scalars.
  Ray<C, 2> counted() const {
    Ray<C, 2> ray = {s_.o.head<2>().cast<C>(), s_.d.head<2>().cast<C>(), cast<C>(s_.ray.range)};
    if (s_.made == Made::points)
      ray.direction = s_.q.head<2>().cast<C>() - ray.origin;
    else if (s_.made == Made::unit && s_.d.head<2>() != Point<double, 2>::Zero())
      ray.direction = ray.direction / sqrt(ray.direction.dot(ray.direction));
    return ray;
  }

  Step& add(const std::string& slug, const std::string& title, int line, const std::string& caption,
            const std::string& formula = {}) {
    Step& step = script_.add(slug, title, line, caption, formula);
    step.scene = picture(s_, known_);
    return step;
  }

  void made() {
    if (s_.made == Made::points) {
      add("two-points", "Two points", 0,
          "Two points give a ray, too: from **p**_1, in the direction **p**_2 − **p**_1.\n"
          "The difference is rounded. A test that must see both end points exactly takes the points themselves.",
          "**d** = **p**_2 − **p**_1");
    } else if (s_.made == Made::unit) {
      const Vector<double, 2>& u = s_.ray.direction;
      script_.value("|**d**|", std::sqrt(s_.d.head<2>().dot(s_.d.head<2>())), "length");
      script_.value("|**u**|^2 − 1", u.dot(u) - 1);
      add("normalise", "A unit direction", 0,
          "Divided by its length, **d** becomes the unit vector **u**. It costs a square root, divisions, and "
          "rounding.\n"
          "In return **v** · **u** is the signed length of a projection onto the ray. With **d** it takes "
          "**v** · **d** / |**d**|.",
          "**u** = **d** / |**d**|");
    } else {
      add("direction", "A point and a direction", 0,
          "A ray has an origin **o** and a direction **d**. The direction may have any length but 0.");
    }
  }

  void marks() {
    known_.marks = true;
    const bool of_length_one = s_.d.head<2>().squaredNorm() == 1;
    const std::string unit =
        s_.made == Made::unit     ? "As |**u**| = 1, *t* is the signed distance from **o**."
        : s_.made == Made::points ? "*t* = 0 is **p**_1, *t* = 1 is **p**_2: *t* counts lengths of **d**."
        : of_length_one           ? "As |**d**| = 1, *t* is the signed distance from **o**."
                                  : "*t* counts lengths of **d**, so the distance from **o** is |*t*| |**d**|.";
    add("parameter", "One number for each point", 1,
        "Each *t* has its point on the line: *x*(*t*) = *o*_x + *t* *d*_x, and likewise for *y*.\n" + unit,
        fmt::format("**r**(*t*) = **o** + *t* **{}**", letter(s_)));
  }

  void range() {
    known_.range = true;
    const bool segment = s_.extent == "segment", line = s_.extent == "line";
    const std::string end = s_.made == Made::unit ? "|**d**|" : "1";
    const std::string t = segment ? "0 ≤ *t* ≤ " + end : line ? "−∞ < *t* < ∞" : "0 ≤ *t* < ∞";
    Step& step = add("range",
                     segment ? "Finite: a segment"
                     : line  ? "Infinite: a line"
                             : "Semi-infinite: a ray",
                     2,
                     segment ? "A segment has two ends. Both belong to it, as the range is closed."
                     : line  ? "A line has no end. What lies behind **o**, at *t* < 0, belongs to it, too."
                             : "A ray has one end, and **o** belongs to it. What lies at *t* < 0 does not.",
                     t);
    step.question = {"Which *t* belong to a " + s_.extent + "?",
                     {"0 ≤ *t* ≤ " + end, "*t* ≥ 0", "every *t*"},
                     segment ? 0
                     : line  ? 2
                             : 1,
                     "The three kinds differ only in the range of *t*."};
    keep_picture(script_.walk());
  }

  void say(const ray_plane::Numerator<C>& e) { script_.value("**n** · **o** + *D*", e.value.value, "length"); }
  void say(const ray_plane::Denominator<C>& e) {
    script_.value(fmt::format("**n** · **{}**", letter(s_)), e.value.value, "length");
  }
  void say(const ray_plane::Parallel<C>& e) {
    if (!e.holds) return script_.refuse(3, {});
    known_.wall = true;
    add("parallel", "Parallel", 3,
        fmt::format(
            "**n** · **{}** = 0: the line is parallel to the wall. The quotient would divide by zero.\n"
            "If **n** · **o** + *D* = 0, the line lies in the wall. Then every *t* of the range counts, so HIT comes "
            "without one.\n"
            "Tests of polygons and triangles answer otherwise for a ray in their plane: MISS, or a case of its own.",
            letter(s_)),
        fmt::format("**n** · **{}** = 0", letter(s_)));
  }
  void say(const ray_plane::InRange<C>&) {}  // part of the verdict
  void say(const ray_plane::Quotient<C>& e) {
    const double t = e.t.value;
    known_.wall = known_.hit = true;
    script_.value("*t*", t);
    const double length = s_.made == Made::unit ? s_.d.head<2>().norm() : s_.ray.direction.norm();
    std::vector<WrongNumber> wrong = {
        {t * length, s_.made == Made::unit ? "The direction is a unit vector: no length comes in."
                                           : "That is a distance. *t* counts in lengths of the direction."},
        {s_.plane.normal.dot(s_.ray.origin) + s_.plane.d, "That is **n** · **o** + *D*, neither negated nor divided."}};
    if (t != 0) wrong.push_back({-t, "The minus sign before **n** · **o** + *D* is lost."});
    Step& step = add("wall", "Where the line meets the wall", 4,
                     fmt::format("The wall is the plane **n** · **x** + *D* = 0 with **n** = (1, 0) and *D* = {}. The "
                                 "line meets it at one *t*{}. The range decides whether it counts.",
                                 shown(-s_.wall), s_.made == Made::unit ? ", the signed distance from **o**" : ""),
                     fmt::format("*t* = −(**n** · **o** + *D*) / (**n** · **{}**) = {}", letter(s_), shown(t)));
    const double read = (as_read(s_.wall) - as_read(s_.ray.origin.x())) / as_read(s_.ray.direction.x());
    if (!read_well(read, t)) return;  // the numbers as they are shown do not give it
    step.question = which_value(
        fmt::format("**o** = ({}, {}) and **{}** = ({}, {}). At which *t* does the line meet the wall *x* = {}?",
                    shown(s_.ray.origin.x()), shown(s_.ray.origin.y()), letter(s_), shown(s_.ray.direction.x()),
                    shown(s_.ray.direction.y()), shown(s_.wall)),
        t, wrong,
        fmt::format("**n** = (1, 0) and *D* = {}: substitute **r**(*t*) into **n** · **x** + *D* = 0 and "
                    "solve for *t*.",
                    shown(-s_.wall)));
    Shown asked = known_;  // without the numbers along the line
    asked.marks = asked.hit = false;
    step.question->over = picture(s_, asked);
  }

  void verdict() {
    known_.settled = true;
    const bool meets = s_.truth.meets;
    script_.settle(meets ? Verdict::Kind::yes : Verdict::Kind::no,
                   !meets              ? "the " + s_.extent + " misses the wall"
                   : s_.truth.coplanar ? "the " + s_.extent + " lies in the wall"
                                       : "the " + s_.extent + " meets the wall at *t* = " + shown(*s_.truth.t));
    const bool divided = s_.truth.line.has_value();
    const int line = !divided ? 3 : meets ? 6 : 5;
    if (divided && meets) script_.refuse(5, {});
    if (divided && meets) script_.value("*t*", *s_.truth.line, {}, Role::hit);
    Step& step = add("verdict", "Does it count?", line, verdict_caption(s_));
    if (!divided) return;
    const double t = *s_.truth.line;
    const bool below = t < s_.ray.range.lo || !std::isfinite(s_.ray.range.hi);
    const double end = below ? s_.ray.range.lo : s_.ray.range.hi;
    const bool holds = below ? end <= t : t <= end;
    if (std::isfinite(end) && holds == meets)  // else rounding hides the difference
      Script::decide(step, {below ? "*t* < *t*_{min}" : "*t* > *t*_{max}", t, end, !meets,
                            meets ? "in the range" : "outside the range"});
    ask_for_line(script_.walk(), "Which line returns the answer?",
                 {{3, "The line is not parallel to the wall."},
                  {4, "That line computes *t*, and returns nothing."},
                  {5, "Its *t* does not lie outside the range."},
                  {6, "Its *t* lies outside the range."}},
                 meets ? "Its *t* lies in the range." : "Its *t* lies outside the range.");
  }

  const Setup& s_;
  Script script_;
  Shown known_;
};

}  // namespace

Walk tell(const Setup& setup) { return Teller(setup).tell(); }

}  // namespace isect::lessons::rays_lesson
