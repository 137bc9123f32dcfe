// Two triangles by the parts of the line of both planes that lie in them: Möller's test, in doubles.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lessons/shared/axis_names.h"
#include "lessons/shared/common_length.h"
#include "lessons/shared/digits.h"
#include "lessons/shared/questions.h"
#include "lessons/triangle_triangle/telling.h"

namespace isect::lessons::triangle_triangle_lesson {

using namespace viz;
using triangle_triangle::Cut;
using triangle_triangle::Heights;
using triangle_triangle::InPlane;
using triangle_triangle::LineOfPlanes;
using triangle_triangle::Signs;
using C = Counted<double>;

namespace {

Triangle<C, 3> counted_triangle(const Three& x) {
  Triangle<C, 3> all;
  for (std::size_t i = 0; i < 3; ++i) all.vertices[i] = x.vertices[i].cast<C>();
  return all;
}

std::string without_sign_of_zero(double x) { return shown(x == 0 ? 0 : x); }

class IntervalsTeller : Teller {
 public:
  explicit IntervalsTeller(const Setup& s)
      : Teller(s, "intervals",
               "Möller, A fast triangle-triangle intersection test (1997); Ericson, Real-Time "
               "Collision Detection (2005), 5.2.10",
               {"n_b ← (b₁ − b₀) × (b₂ − b₀); heights of a: n_b · (a_i − b₀)",   // 0
                "if all heights of a are positive, or all negative",             // 1
                "    return DISJOINT",                                           // 2
                "n_a ← (a₁ − a₀) × (a₂ − a₀); heights of b: n_a · (b_i − a₀)",   // 3
                "if all heights of b are positive, or all negative",             // 4
                "    return DISJOINT",                                           // 5
                "if all heights of a are 0, or all of b",                        // 6
                "    return whether no side of a or b parts them in the plane",  // 7
                "d ← n_a × n_b; project on the axis of the largest |d_i|",       // 8
                "a's interval ← where its edges meet the plane of b",            // 9
                "b's interval ← where its edges meet the plane of a",            // 10
                "if the larger lower end > the smaller upper end",               // 11
                "    return DISJOINT",                                           // 12
                "return INTERSECT"}) {}                                          // 13

  Walk tell() {
    two_triangles(0);
    script_.tell<triangle_triangle::IntervalsEvent<C>>(
        [&](auto& record) {
          found_ = triangle_triangle::by_intervals(counted_triangle(s_.a()), counted_triangle(s_.b()), record);
        },
        [&](const auto& event) { say(event); });
    return end();
  }

 private:
  void say(const Heights<C>& e) {
    const int which = e.of;
    const std::string own = triangle_name(which), other = triangle_name(1 - which);
    auto& heights = heights_[static_cast<std::size_t>(which)];
    for (std::size_t i = 0; i < 3; ++i) {
      heights[i] = e.heights[i].value;
      script_.value("height of " + corner_name(which, static_cast<int>(i)), heights[i]);
    }
    known_.plane = 1 - which, known_.heights = true;
    const std::string all = fmt::format("{}, {} and {}", without_sign_of_zero(heights[0]),
                                        without_sign_of_zero(heights[1]), without_sign_of_zero(heights[2]));
    add("heights-" + own, "Heights above the plane of " + other, which == 0 ? 0 : 3, heights_caption(which),
        "heights of " + own + ": " + all);
    const Signs found = triangle_triangle::detail::signs(heights);
    Step& step = add("sides-" + own, "On which side is " + own + "?", which == 0 ? 1 : 4, sides_caption(which, found));
    step.decides = true;
    if (which == 0 && s_.area[1] && found == s_.of[0]) {
      step.question = sides_question(
          found, "The corners of a have the heights " + all + " above the plane of b, times the length of **n**_b.");
      keep_picture(script_.walk());
    }
    if (e.beside)
      line_ = which == 0 ? 2 : 5;
    else
      script_.refuse(which == 0 ? 1 : 4, {which == 0 ? 2 : 5});
  }

  std::string heights_caption(int which) const {
    const std::string other = triangle_name(1 - which), n = "**n**_" + other;
    if (which == 1)
      return "The same with a and b exchanged: the heights of b above the plane of a, times the length of " + n + "." +
             (s_.area[0] ? "" : "\nHere a has no area: " + n + " is 0, and so are all heights.");
    return fmt::format(
               "The cross product of two sides of {} is a normal {} of its plane.\n"
               "For a corner **a**_i, {} · (**a**_i − **b**_0) is its height above that plane, times the length of {}. "
               "Only signs count.",
               other, n, n, n) +
           (s_.area[1] ? "" : "\nHere b has no area: " + n + " is 0, and so are all heights.");
  }

  std::string sides_caption(int which, const Signs& found) const {
    const Signs& exact = s_.of[static_cast<std::size_t>(which)];
    if (found == exact) return told_sides(which, found);
    int i = 0;
    while (found[static_cast<std::size_t>(i)] == exact[static_cast<std::size_t>(i)]) ++i;
    const int sign = exact[static_cast<std::size_t>(i)];
    return fmt::format("Rounding has changed a sign: exactly, {} lies {} the plane of {}.\n", corner_name(which, i),
                       sign > 0   ? "above"
                       : sign < 0 ? "below"
                                  : "in",
                       triangle_name(1 - which)) +
           "The method cannot know that, and goes on with the rounded signs.";
  }

  void say(const InPlane& e) {
    if (!last_side_) {
      known_.plane = -1, known_.heights = false;
      script_.forget(height_names());
      add("one-plane", "One plane?", 6, plane_caption()).decides = true;
    }
    last_side_ = e;
    line_ = 7;
  }
  std::string plane_caption() const {
    if (s_.one_plane())
      return "All heights of one are 0: one plane holds both triangles, and there is no line where two planes meet.\n"
             "What is left is a test in two dimensions.";
    if (!s_.both_have_area())
      return "All heights of one are 0. The method concludes that one plane holds both.\n"
             "That does not follow: without area a triangle has no plane, and its **n** is 0 wherever the other lies.";
    return "Rounding makes all heights of one 0. The method concludes that one plane holds both, and tests there.";
  }

  void say(const LineOfPlanes<C>& e) {
    const Vec3 d(e.direction[0].value, e.direction[1].value, e.direction[2].value);
    axis_ = e.axis;
    script_.refuse(6, {7});
    script_.forget(height_names());
    known_.plane = -1, known_.heights = false, known_.line = true;
    const bool both_reach = s_.part(0) && s_.part(1);  // exactly; else rounding alone has led here
    add("line", "The line of both planes", 8,
        std::string(both_reach
                        ? "The two planes meet in a line (dashed), with the direction **d** = **n**_a × **n**_b.\n"
                          "Common points of a and b lie on it. Each triangle has an interval of this line.\n"
                        : "By the rounded signs, both triangles reach the line of both planes. Exactly, there is no "
                          "such line, or one of them does not reach it.\n"
                          "Its direction is taken as **d** = **n**_a × **n**_b.\n") +
            "Its projection on an axis keeps the order of points. Here we take that along which **d** is longest: " +
            axis_names[axis_] + ".",
        "**d** = " + coordinates(d));
  }

  void say(const Cut<C>& e) {
    const auto own = static_cast<std::size_t>(e.of);
    const std::string name = triangle_name(e.of), axis = axis_names[axis_];
    const Interval<double> found = {e.interval.lo.value, e.interval.hi.value};
    interval_[own] = found;
    known_.part[own] = true;
    const int j = (e.alone + 1) % 3, k = (e.alone + 2) % 3;
    known_.lit = {{e.of, e.alone, j}, {e.of, e.alone, k}};
    script_.value(name + " from", found.lo);
    script_.value(name + " to", found.hi);
    Step& step = add(
        "interval-" + name, "The interval of " + name, e.of == 0 ? 9 : 10, cut_caption(e.of, e.alone),
        fmt::format("{} on {}: {} to {}", name, axis, without_sign_of_zero(found.lo), without_sign_of_zero(found.hi)));
    known_.lit.clear();
    ask_share(step, e.of, e.alone, j, e.shares[0].value);
  }

  std::string cut_caption(int which, int alone) const {
    const std::string other = triangle_name(1 - which), at = corner_name(which, alone);
    const auto& heights = heights_[static_cast<std::size_t>(which)];
    if (heights[static_cast<std::size_t>(alone)] == 0)
      return fmt::format("By its height, only {} lies in the plane of {}: the interval is this one point.", at, other);
    return fmt::format(
               "By the heights, {} lies by itself on its side of the plane of {}. The two edges there (lit) "
               "meet that plane.\n",
               at, other) +
           (which == 0 ? "Along an edge the height changes evenly. So the edge meets the plane at the share height / "
                         "(height − other height) of its length.\nIt counts from that corner."
                       : "The heights tell where, as before: two divisions for each triangle.");
  }

  /// Asks where an edge meets the plane, where the numbers are such that one can compute it.
  void ask_share(Step& step, int which, int i, int j, double share) {
    const auto& heights = heights_[static_cast<std::size_t>(which)];
    const double h = heights[static_cast<std::size_t>(i)], other = heights[static_cast<std::size_t>(j)];
    const auto handy = [](double x) { return std::abs(x) >= 0.01 && std::abs(x) < 1000; };
    if (which != 0 || !handy(h) || !handy(other) || std::abs(2 * share - 1) < 0.02) return;
    step.question = which_value(
        fmt::format("At {} the height is {}, at {} it is {}. At which share of the edge from the first corner does it "
                    "meet the plane?",
                    corner_name(which, i), shown(h), corner_name(which, j), shown(other)),
        share,
        {{1 - share, "That share counts from the other corner."}, {0.5, "That is half way: the heights differ."}},
        "The height falls to 0 after height / (height − other height) of the way.");
    keep_picture(script_.walk());
  }

  void say(const triangle_triangle::Shared<C>& e) {
    const double lo = e.lo.value, hi = e.hi.value;
    script_.value("larger lower end", lo);
    script_.value("smaller upper end", hi);
    const std::string sign = lo > hi ? ">" : lo < hi ? "<" : "=";
    Step& step = add("compare", "What the intervals share", 11,
                     std::string(lo > hi ? "The larger lower end is beyond the smaller upper end: no number is in both."
                                 : lo < hi ? "The intervals share all numbers from the larger lower end to the smaller "
                                             "upper end."
                                           : "The intervals share one number.") +
                         (e.holds == s_.meet() ? "" : "\nSuch is the order after rounding. The exact one is another."),
                     fmt::format("larger lower end {} {} smaller upper end {}", digits(lo, hi), sign, digits(hi, lo)));
    Script::decide(step, {"lower end > upper end", lo, hi, !e.holds,
                          e.holds ? "the intervals share a number" : "the intervals share no number"});
    if (e.holds == s_.meet()) ask_common(step);
    if (e.holds)
      script_.refuse(11, {12}), line_ = 13;
    else
      line_ = 12;
  }

  /// Asks how long is what the intervals share, where the numbers on show tell.
  void ask_common(Step& step) const {
    const auto& [a, b] = interval_;
    step.question = common_length_question(
        fmt::format("a covers {} to {} on the axis, b covers {} to {}.", without_sign_of_zero(a.lo),
                    without_sign_of_zero(a.hi), without_sign_of_zero(b.lo), without_sign_of_zero(b.hi)),
        a, b);
  }

  static std::vector<std::string> height_names() {
    std::vector<std::string> all;
    for (const int which : {0, 1})
      for (int i = 0; i < 3; ++i) all.push_back("height of " + corner_name(which, i));
    return all;
  }

  std::array<std::array<double, 3>, 2> heights_ = {};
  std::array<Interval<double>, 2> interval_ = {};
  int axis_ = 0;
};

}  // namespace

Walk intervals(const Setup& s) { return IntervalsTeller(s).tell(); }

}  // namespace isect::lessons::triangle_triangle_lesson
