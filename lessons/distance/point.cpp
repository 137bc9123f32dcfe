// A point and a segment: two dot products tell which of three regions holds the point.

#include <fmt/format.h>

#include "lessons/distance/telling.h"
#include "lessons/shared/digits.h"
#include "lessons/shared/questions.h"

namespace isect::lessons::distance_lesson {

using namespace viz;
using C = Counted<double>;

namespace {

const char* const along_name = "(**c** − **p**_a) · **d**";
const char* const length_name = "**d** · **d**";

class PointTeller : Teller {
 public:
  explicit PointTeller(const Setup& s)
      : Teller(s, "a point and a segment", "Ericson, Real-Time Collision Detection (2005), 5.1.2",
               {"d ← q_a − p_a",                         // 0
                "if (c − p_a) · d ≤ 0: t ← 0",           // 1
                "else if (c − p_a) · d ≥ d · d: t ← 1",  // 2
                "else t ← (c − p_a) · d / (d · d)",      // 3
                "return |c − (p_a + t d)|²"}) {}         // 4

  Walk tell() {
    known_.regions = true;
    add("regions", "Three regions", 0,
        s_.a.p == s_.a.q
            ? "Here **p**_a and **q**_a are equal, so the segment is a point, and **d** = **q**_a − **p**_a is 0."
            : "**d** = **q**_a − **p**_a is the direction of the segment.\n"
              "Two planes perpendicular to **d**, one through each end (dashed), part space into three regions.\n"
              "In the outer ones an end is nearest to **c**. Between the planes it is a point of the interior.");
    script_.tell<nearest_features::PointEvent<C, 3>>(
        [&](auto& record) {
          const Vector<C, 3> c = s_.c().cast<C>();
          nearest_features::distance2<C, 3>(c, cast<C>(s_.a), record);
        },
        [&](const auto& event) { say(event); });
    return std::move(script_.walk());
  }

 private:
  void say(const nearest_features::Along<C>& e) {
    along_ = e.along.value, length2_ = e.length2.value;
    script_.value(along_name, along_);
    script_.value(length_name, length2_);
    const bool a_point = s_.a.p == s_.a.q;  // has one place, and nothing to ask
    Step& dot =
        add("dot", "Two dot products", 0,
            a_point ? "**d** is 0, so both dot products are 0. Line 2 then takes *t* = 0, and nothing is divided."
                    : "(**c** − **p**_a) · **d** tells how far **c** lies along **d**, seen from **p**_a.\n"
                      "Divided by **d** · **d** it is the *t* of the nearest point of the line. That division "
                      "can wait.",
            fmt::format("{} = {}", along_name, shown(along_)));
    if (!a_point) ask_for_dot(dot);

    const bool first = along_ <= 0, second = !first && along_ >= length2_;
    const Nearest exact = s_.pairs.front().on_a;
    const char* const rounded = "Rounding has changed what this comparison says. The method cannot know that.";
    Step& start = add("first-end", "Before the first end?", 1,
                      first != (exact == Nearest::p) ? rounded
                      : first ? "It is not above 0. So no point of the segment is nearer than **p**_a: *t* is 0."
                              : "It is above 0: on the way from **p**_a along **d** the distance falls at first.",
                      fmt::format("{} = {}{}", along_name, shown(along_),
                                  along_ < 0   ? " < 0"
                                  : along_ > 0 ? " > 0"
                                               : ""));
    Script::decide(start, {std::string(along_name) + " ≤ 0", along_, 0, first, first ? "*t* is 0" : "*t* is above 0"});
    if (!a_point)
      start.question =
          Question{fmt::format("{} = {} and {} = {}. Which point of the segment is nearest to **c**?", along_name,
                               apart(along_, length2_), length_name, apart(length2_, along_)),
                   {"the first end, **p**_a", "the second end, **q**_a", "a point between both ends"},
                   first    ? 0
                   : second ? 1
                            : 2,
                   "*t* is the quotient of both, clamped to the range from 0 to 1. To clamp, comparisons are enough."};
    if (first) return;
    script_.refuse(1, {});

    Step& end =
        add("second-end", "Beyond the second end?", 2,
            second != (exact == Nearest::q) ? rounded
            : second ? "It is at least **d** · **d**. So no point of the segment is nearer than **q**_a: *t* is 1."
                     : "It is less than **d** · **d**: the nearest point lies before **q**_a.",
            fmt::format("{} {} {}", apart(along_, length2_),
                        !second              ? "<"
                        : along_ == length2_ ? "="
                                             : ">",
                        apart(length2_, along_)));
    Script::decide(end, {fmt::format("{} ≥ {}", along_name, length_name), along_, length2_, second,
                         second ? "*t* is 1" : "*t* is below 1"});
    if (!second) script_.refuse(2, {});
  }

  static std::string apart(double x, double other) { return digits(x == 0 ? 0 : x, other == 0 ? 0 : other); }

  void ask_for_dot(Step& step) const {
    const Vec3 w = s_.c() - s_.a.p, d = s_.a.q - s_.a.p;
    step.question = which_value(
        fmt::format("**c** − **p**_a = {} and **d** = {}. What is their dot product?", coordinates(w), coordinates(d)),
        along_,
        {{w.dot(w), "That is the square of the length of **c** − **p**_a."},
         {d.dot(d), "That is **d** · **d**."},
         {w.norm() * d.norm(), "That is the product of both lengths, without the cosine of the angle."},
         {(s_.c() - s_.a.q).dot(d), "That is seen from **q**_a."}},
        "Multiply coordinate by coordinate, and add.");
  }

  void say(const nearest_features::Foot<C, 3>& e) {
    const double t = e.t.value, squared = e.distance2.value;
    const Vec3 at(e.at[0].value, e.at[1].value, e.at[2].value);
    script_.value("*t*", t);
    known_.ways = {{s_.c(), at}};
    if (along_ > 0 && along_ < length2_) {
      add("foot", "Between the ends", 3,
          "Only here a quotient is needed. The point at *t* is the foot of the perpendicular from **c**.",
          fmt::format("*t* = {}", shown(t)));
      known_.regions = false;
    }
    script_.value("*d*^2", squared, "area", Role::highlight);
    known_.settled = true;
    settle();
    add("distance", "The squared distance", 4, told(t), fmt::format("*d*^2 = {}", shown(squared)));
  }

  /// What is exactly so, and whether the method has found it.
  std::string told(double t) const {
    const Nearest exact = s_.pairs.front().on_a, found = t == 0 ? Nearest::p : t == 1 ? Nearest::q : Nearest::between;
    const std::string least =
        "*d*^2 is the squared distance. To compare it with a bound, square the bound: no root is needed.\n";
    if (found != exact && s_.a.p != s_.a.q)
      return least + fmt::format(
                         "Rounding has moved **c** across the border of a region: exactly, {} is nearest.\n"
                         "The points are near each other there, so the distance is hardly changed.",
                         exact == Nearest::between ? std::string("a point of the interior") : feature_name(0, exact));
    if (s_.meet) return least + "**c** lies on the segment, and is its own nearest point.";
    if (exact != Nearest::between)
      return least + fmt::format("{} is nearest. No other point is as near.", capital(exact));
    return least + "The interior contains the nearest point. No other point is as near.";
  }
  static std::string capital(Nearest end) { return end == Nearest::p ? "The end **p**_a" : "The end **q**_a"; }

  double along_ = 0, length2_ = 0;
};

}  // namespace

Walk point(const Setup& s) { return PointTeller(s).tell(); }

}  // namespace isect::lessons::distance_lesson
