// Two segments: the nearest points of their lines, clamped, and clamped again; then what is exactly so.

#include <fmt/format.h>

#include <cmath>

#include "lessons/distance/telling.h"
#include "lessons/shared/digits.h"
#include "lessons/shared/questions.h"

namespace isect::lessons::distance_lesson {

using namespace viz;
using nearest_features::Find;
using C = Counted<double>;

namespace {

Vec3 as_doubles(const Vector<C, 3>& p) { return {p[0].value, p[1].value, p[2].value}; }
Vec3 at_place(const Segment3& x, double t) { return x.p + t * (x.q - x.p); }

class SegmentsTeller : Teller {
 public:
  explicit SegmentsTeller(const Setup& s)
      : Teller(
            s, "two segments",
            "Ericson, Real-Time Collision Detection (2005), 5.1.9; Lumelsky, Information Processing Letters 21 (1985)",
            {"d_a ← q_a − p_a; d_b ← q_b − p_b; l ← p_b − p_a",            // 0
             "det ← (d_a · d_a) (d_b · d_b) − (d_a · d_b)²",               // 1
             "if det ≤ 0: t_a ← 0",                                        // 2
             "else t_a ← the place nearest to the line of b, clamped",     // 3
             "t_b ← the place on the line of b nearest to p_a + t_a d_a",  // 4
             "if t_b ≤ 0 or t_b ≥ 1",                                      // 5
             "    clamp t_b; t_a ← the place nearest to it, clamped",      // 6
             "return |p_a + t_a d_a − (p_b + t_b d_b)|²"}) {}              // 7

  Walk tell() {
    add("segments", "Two places", 0,
        "The point of a at the place *t*_a is **p**_a + *t*_a **d**_a, with *t*_a from 0 to 1. That of b is at *t*_b.\n"
        "The squared distance of both points is a quadratic function of *t*_a and *t*_b. The allowed places fill a "
        "square of side 1.\n"
        "The lines through its sides part the plane of both places into nine regions, with the square in the middle.");
    script_.tell<nearest_features::SegmentEvent<C, 3>>(
        [&](auto& record) { nearest_features::distance2<C, 3>(cast<C>(s_.a), cast<C>(s_.b), record); },
        [&](const auto& event) { say(event); });
    exactly();
    clamped_once();
    tilted();
    return std::move(script_.walk());
  }

 private:
  bool a_point() const { return s_.a.p == s_.a.q || s_.b.p == s_.b.q; }

  void say(const nearest_features::Lines<C>& e) {
    determinant_ = e.determinant.value, parallel_ = e.parallel;
    script_.value("det", determinant_);
    known_.lines = true;
    add("lines", "Are they parallel?", 1,
        a_point() ? "One segment is a point here. So det, the square of the area that **d**_a and **d**_b span, is 0."
                  : "det belongs to two equations: the gap must be perpendicular to both lines (dashed).\n"
                    "It is the square of the area that **d**_a and **d**_b span. It is 0 for parallel segments.",
        "det = " + shown(determinant_));
    if (!parallel_) return script_.refuse(2, {});
    Step& step =
        add("parallel", "No single place", 2,
            a_point() ? "One segment is a point here, and has no direction. So *t*_a = 0 will do at first."
            : s_.parallel()
                ? "Parallel lines are equally far apart everywhere. So *t*_a = 0 will do at first."
                : "Rounding has made det 0, or less. So the method takes *t*_a = 0 at first, as for parallel lines.");
    Script::decide(step, {"det ≤ 0", determinant_, 0, true, "they count as parallel"});
    s_place_ = 0;
  }

  void say(const nearest_features::Found<C>& e) {
    const double numerator = e.numerator.value, denominator = e.denominator.value;
    const double place = denominator == 0 ? 0 : numerator / denominator;
    if (e.what == Find::on_a) return on_a(place, e.clamped.value);
    if (e.what == Find::on_b) return on_b(numerator, denominator, place, e.clamped.value);
    again(e.clamped.value);
  }

  void on_a(double place, double clamped) {
    script_.value("place on the line of a", place);
    script_.value("*t*_a", clamped);
    line_a_ = place, s_place_ = clamped;
    add("on-a", "Nearest to the other line", 3,
        std::string(s_.parallel()
                        ? "The segments are parallel, but rounding has left det above 0. So rounding errors alone make "
                          "this place.\n"
                        : "Both equations give the place on the line of a that is nearest to the line of b.\n") +
            (place == clamped ? "It lies between 0 and 1, so *t*_a keeps it."
                              : "It lies outside the range from 0 to 1, so *t*_a is clamped."),
        "*t*_a = " + shown(clamped));
  }

  void on_b(double numerator, double denominator, double place, double clamped) {
    const bool point = denominator == 0, beyond = numerator <= 0 || numerator >= denominator;
    const Vec3 at = at_place(s_.a, s_place_);
    script_.value("*t*_a", s_place_);
    script_.value("*t*_b", point ? 0 : place);
    known_.lines = !point;
    known_.ways = {{at, point ? s_.b.p : at_place(s_.b, place)}};
    Step& step =
        add("on-b", "Nearest to that point", 4,
            point ? "b is a point: its only place is *t*_b = 0. The numerator is 0, too: then the code takes 0, and "
                    "does not divide."
                  : "Now the point of a is fixed. The line of b is nearest to it at *t*_b, which is not clamped yet.\n"
                    "*t*_b is a quotient. If **d**_b were 0, the code would take *t*_b = 0, and not divide by 0.",
            "*t*_b = " + shown(point ? 0 : place));
    if (!point) ask_for_place(step, at, numerator, place, clamped);
    known_.ways.clear();

    const bool consistent = (place <= 0) == (numerator <= 0) && (place >= 1) == (numerator >= denominator);
    Step& ends = add("ends", "Beyond an end of b?", 5,
                     beyond ? "*t*_b is no interior place: an end of b is nearest to that point of a."
                            : "*t*_b lies between 0 and 1. So both places are allowed, and nothing moves any more.");
    if (point || !consistent)
      ends.decides = true;
    else
      Script::decide(ends, {"*t*_b ≤ 0 or *t*_b ≥ 1",
                            place,
                            0,
                            beyond,
                            beyond ? "an end of b is nearest" : "no end of b is nearest",
                            {{"*t*_b ≤ 0", place, 0, place <= 0, ""}, {"*t*_b ≥ 1", place, 1, place >= 1, ""}}});
    if (!beyond) script_.refuse(5, {6});
    t_place_ = clamped;
  }

  void ask_for_place(Step& step, const Vec3& at, double numerator, double place, double clamped) {
    const auto read = [](const Vec3& p) { return Vec3(p.unaryExpr([](double x) { return as_read(x); })); };
    const Vec3 d = s_.b.q - s_.b.p, d_read = read(d);
    if (!read_well((read(at) - read(s_.b.p)).dot(d_read) / d_read.squaredNorm(), place)) return;
    const double lines = at_lines();
    step.question = which_value(
        fmt::format(
            "The point of a is {}, **p**_b = {} and **d**_b = {}. At which *t*_b is the line of b nearest to it?",
            coordinates(at), coordinates(s_.b.p), coordinates(d)),
        place,
        {{numerator, "Divide that by **d**_b · **d**_b."},
         {lines, "There both lines are nearest. But the point of a is another one by now."},
         {clamped, "That is clamped already. The line of b has no ends."}},
        "The vector from **p**_b to that point, times **d**_b, divided by **d**_b · **d**_b.");
    keep_picture(script_.walk());
  }
  /// Where the line of b is nearest to that of a; NaN for parallel lines.
  double at_lines() const {
    if (parallel_) return std::nan("");
    const Vec3 d = s_.b.q - s_.b.p;
    return (at_place(s_.a, line_a_) - s_.b.p).dot(d) / d.squaredNorm();
  }

  void again(double clamped) {
    const double before = s_place_;
    script_.value("*t*_b", t_place_);
    script_.value("*t*_a", clamped);
    s_place_ = clamped;
    add("again", "Back to a", 6,
        fmt::format("The end of b at *t*_b = {} is fixed now, so *t*_a is found anew.\n", shown(t_place_)) +
            (before == clamped
                 ? "It stays as it was."
                 : fmt::format("It moves from {} to {}{}.", digits(before, clamped), digits(clamped, before),
                               parallel_ || s_.parallel() ? "" : ": clamping each place once is not enough")),
        "*t*_a = " + shown(clamped));
  }

  void say(const nearest_features::Closest<C, 3>& e) {
    known_.lines = false;
    squared_ = e.distance2.value;
    found_ = {feature(s_.a, e.s.value), feature(s_.b, e.t.value)};
    known_.ways = {{as_doubles(e.on_a), as_doubles(e.on_b)}};
    script_.value("*d*^2", squared_, "area", Role::highlight);
    add("closest", "The nearest points", 7, "Both places give a point (rings). *d*^2 is the square of their distance.",
        "*d*^2 = " + shown(squared_));
  }
  static Nearest feature(const Segment3& x, double t) {
    return t == 0 || x.p == x.q ? Nearest::p : t == 1 ? Nearest::q : Nearest::between;
  }

  void exactly() {
    known_.ways.clear(), known_.settled = true;
    settle();
    const bool other = s_.pairs.size() == 1 && !(found_ == s_.pairs.front());
    Step& step = add(
        "features", "Which features are nearest?", 7,
        told_features(s_) +
            (other ? "\nRounding has led the method to other features, at nearly the same distance." : "") +
            (s_.meet && squared_ > 0 ? "\nThe segments meet: exactly, *d*^2 is 0. Rounding has left it above." : ""));
    if (!s_.meet) step.question = pairs_question(), keep_picture(script_.walk());
    known_.settled = false;
  }

  /// What the usual bug returns, where that differs.
  void clamped_once() {
    Record<nearest_features::SegmentEvent<double, 3>> record;
    const double once = nearest_features::distance2_clamped_once<double, 3>(s_.a, s_.b, record);
    if (parallel_ || s_.parallel() || !(once > squared_ * (1 + 1e-6) + 1e-12)) return;
    const auto& closest = std::get<nearest_features::Closest<double, 3>>(record.events.back());
    const auto place = [&](std::size_t event) {
      const auto& found = std::get<nearest_features::Found<double>>(record.events.at(event));
      return found.numerator / found.denominator;
    };
    const double on_a = place(1), on_b = place(2);
    const auto outside = [](double x) { return x < 0 || x > 1; };
    const std::string where =
        outside(on_a) || outside(on_b)
            ? fmt::format("The lines are nearest at the places {} and {}, in {} region of the nine.\n", shown(on_a),
                          shown(on_b), outside(on_a) && outside(on_b) ? "a corner" : "a side")
            : "";
    known_.ways = {{closest.on_a, closest.on_b}};
    for (const Pair& pair : s_.pairs) known_.earlier.push_back(s_.points(pair));
    script_.value("*d*^2, clamped once", once, "area");
    add("once", "A usual bug", 7,
        where +
            "The bug clamps both places, each by itself. The result is too large.\n"
            "Level curves of *d*^2 are ellipses in the plane of both places. "
            "The point of the square with the least *d*^2 need not be the nearest one in that plane.",
        fmt::format("*d*^2, clamped once = {}", shown(once)));
    known_.ways.clear(), known_.earlier.clear();
  }

  /// For nearly parallel segments: b tilted as little the other way.
  void tilted() {
    if (s_.parallel()) return;
    const std::optional<Tilt> tilt = tilted_back(s_.a, s_.b);
    if (!tilt) return;
    known_.earlier = {tilt->before}, known_.ways = {tilt->after};
    script_.value("the end moves by", tilt->moved, "length");
    script_.value("the nearest point moves by", tilt->jump, "length");
    script_.value("*d* changes by", tilt->change, "length");
    add("tilted", "Nearly parallel", 7,
        "Here b is turned to the other side of a parallel segment: **q**_b moves by little.\n"
        "The nearest point of a jumps. The distance changes no more than **q**_b has moved.\n"
        "So of nearly parallel segments the distance is well-conditioned, and the nearest points are not.");
    known_.earlier.clear(), known_.ways.clear();
  }

  double determinant_ = 0, line_a_ = 0, s_place_ = 0, t_place_ = 0, squared_ = 0;
  bool parallel_ = false;
  Pair found_ = {};
};

}  // namespace

Walk segments(const Setup& s) { return SegmentsTeller(s).tell(); }

}  // namespace isect::lessons::distance_lesson
