// The filter, line by line: each line's rounding in this run, its error, and the bound that covers every run.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lessons/rounding_bound/picture.h"
#include "lessons/rounding_bound/telling.h"
#include "lessons/shared/digits.h"
#include "lessons/shared/plural.h"
#include "lessons/shared/questions.h"
#include "viz/chart/chart.h"

namespace isect::lessons::rounding_bound_lesson {

using namespace viz;

namespace {

const std::array<std::string, 4> names = {"*a_x* − *c_x*", "*b_y* − *c_y*", "*a_y* − *c_y*", "*b_x* − *c_x*"};

/// "0.25 *u*"
std::string in_u(double x) { return x != 0 && std::abs(x) < 1e-6 * u ? "nearly 0" : shown(x / u) + " *u*"; }
std::string percent(double share) { return percent_text(100 * share) + " %"; }

/// A rounded difference between its bounds, u times its size.
Row rounded(const Operation& o, const std::string& name) {
  return {name, -std::copysign(o.delta / u, o.value * o.delta), "*δ* = " + in_u(o.delta)};
}
/// A number with the error that has added up to here, between its bounds.
Row bounded(const Operation& o, const std::string& name) {
  const bool known = std::isfinite(o.error);
  return {name, std::copysign(o.share, -o.error), known ? "error: " + percent(o.share) + " of its bound" : "overflow"};
}

class Derivation {
 public:
  Derivation(Script& script, const Setup& s, const Run& run) : script_(script), s_(s), run_(run) {}

  void tell() {
    say_question();
    say_model();
    say_differences();
    say_products();
    say_determinant();
    say_bound();
  }

 private:
  void say_question() {
    Step& step = script_.add("question", "On which side of the line?", -1,
                             "The orientation of three points is the sign of a determinant: twice a signed area.\n"
                             "It is positive if **a** lies left of the line from **b** to **c**, and negative right of "
                             "it. On the line it is 0.\n" +
                                 given(),
                             "(*a_x* − *c_x*)(*b_y* − *c_y*) − (*a_y* − *c_y*)(*b_x* − *c_x*)");
    step.scene = points(s_);
  }

  std::string given() const {
    const auto at = [](const Vec3& p) { return coordinates(Vec2(p.head<2>())); };
    const auto [right, up] = s_.selected;
    std::string a = "**a** = " + at(s_.a);
    if (right != 0 || up != 0)
      a = fmt::format("**a** is a neighbour of {}: {} to the {} and {} {}", at(s_.a), plural(std::abs(right), "double"),
                      right < 0 ? "left" : "right", std::abs(up), up < 0 ? "down" : "up");
    const std::string unit =
        s_.unit == 1 ? "" : fmt::format(" All are in units of 2^{{{}}}.", s_.unit > 1 ? "515" : "−530");
    return a + ". The line runs through **b** = " + at(s_.b) + " and **c** = " + at(s_.c) + "." + unit;
  }

  void say_model() {
    const Operation& o = run_.differences[0];
    Step& step = script_.add(
        "model", "One operation rounds once", 0,
        "Each result is rounded to the nearest double: fl(*x* − *y*) = (*x* − *y*)(1 + *δ*). Likewise a sum or a "
        "product.\n"
        "*δ* is its relative error: in size at most *u* = 2^{−53}, about 1.1 · 10^{−16}, if nothing over- or "
        "underflows. A tie goes to the double whose last bit is 0.\n"
        "Compilers may fuse a product and a sum, which then round once. Of two equal products one is rounded then, and "
        "their difference need not be 0. This program forbids it.\n" +
            std::string(o.error == 0 ? "This difference is a double itself, so *δ* is 0."
                                     : "This difference is no double, so it is rounded."),
        names[0] + " = " + shown(o.value) + ", *δ* = " + in_u(o.delta));
    step.scene = bounds({rounded(o, names[0])}, "*u* |*x* − *y*|");
  }

  void say_differences() {
    std::vector<Row> rows;
    for (std::size_t i = 0; i < names.size(); ++i) rows.push_back(rounded(run_.differences[i], names[i]));
    const auto exact = std::ranges::count(run_.differences, 0.0, &Operation::error);
    script_.value("differences without rounding", static_cast<double>(exact));
    Step& step = script_.add(
        "differences", "Four differences", 0,
        std::string(exact == 4   ? "All four differences are doubles themselves: nothing is rounded yet."
                    : exact == 0 ? "All four differences are rounded. Last bits of the coordinates may be lost already."
                                 : "The rounded ones may have lost last bits of the coordinates already.") +
            "\nSterbenz's lemma: two doubles within a factor of two of each other have an exact difference. "
            "Others may have one, too.");
    step.scene = bounds(rows, "*u* |*x* − *y*|");
    step.question = Question{"Of the four differences, how many are exact, without any rounding?",
                             {"0", "1", "2", "3", "4"},
                             static_cast<int>(exact),
                             "Each was compared with the exact difference."};
    ask_for_number(*step.question, static_cast<double>(exact), 0,
                   {{static_cast<double>(4 - exact), "That is how many of them are rounded."},
                    {4, "Not all of them are doubles themselves: at least one is rounded."},
                    {0, "At least one of them is a double itself, and so is not rounded."}});
  }

  void say_products() {
    script_.value("*left*", run_.left.value);
    script_.value("*right*", run_.right.value);
    const char* const text =
        run_.overflows() ? "A number here is beyond the largest double: it overflows, and counts as infinite.\n"
                           "The model covers no such result."
        : run_.underflows()
            ? "Digits below 2^{−1074} are lost here: *δ* of a product is larger than *u*. The model fails.\n"
              "An absolute term mends it: for the bound, each product counts as 2^{−960} at least."
        : run_.vanish() ? "A factor of each product is exactly 0, and so are both products."
        : run_.tiny()
            ? "Products as small as these may lose digits below 2^{−1074}, though here none is lost.\n"
              "So for the bound each product counts as 2^{−960} at least."
            : "Each product has three factors 1 + *δ*: those of its differences, and its own.\n"
              "A chain of *n* roundings errs by *n* *u* / (1 − *n* *u*) at most, relative to the product. So here "
              "that is about 3 *u*.\n"
              "The picture takes 4 *u*: the fourth covers the terms in *u*^2.";
    Step& step = script_.add("products", "A product has three roundings", 1, text);
    step.scene = bounds({bounded(run_.left, "*left*"), bounded(run_.right, "*right*")}, "*bound*");
  }

  void say_determinant() {
    const bool has_sign = !std::isnan(run_.det.value);
    if (has_sign) script_.value("*det*", run_.det.value);
    script_.value("*size*", run_.size());
    Step& step = script_.add("determinant", "What the last difference leaves", 2,
                             determinant_caption() +
                                 "\nBounds add up where values cancel. So the bound goes by "
                                 "*size* = |*left*| + |*right*|, not by |*det*|." +
                                 (run_.tiny() ? "\nHere *size* counts each product as 2^{−960} at least." : ""),
                             has_sign ? "*det* = " + shown(run_.det.value) : "");
    step.scene = bounds({bounded(run_.det, "*det*")}, "*bound*");
    step.question = which_count("How many roundings touch each of the two products, once *det* is found?", 4,
                                {{3, "That leaves out the last difference."},
                                 {7, "That counts all 7 operations. Three of them touch the other product alone."}},
                                "Two differences, the product itself, the last difference: 4 of the 7 operations.");
  }

  std::string determinant_caption() const {
    const double det = run_.det.value;
    if (std::isnan(det)) return "Infinity minus infinity is not a number: it has no sign.";
    if (std::isinf(det)) return "One product is infinite, so *det* is infinite, too.";
    if (run_.overflows()) return "The sum of the sizes is infinite: nothing is known of *det*.";
    if (det == 0) return "Both products came out equal, so *det* is 0. That tells nothing of the truth yet.";
    const double left = std::abs(det) / run_.size();
    return "|*det*| is " + shown(left) + " · *size*" + (left < 0x1p-20 ? ": nearly all cancels." : ".");
  }

  void say_bound() {
    const double bound = run_.bound();
    script_.value("*bound*", bound);
    const bool too_small = run_.det.error == 0 && run_.det.share > 0;  // for a double
    if (!run_.overflows() && !too_small) script_.value("error", run_.det.error);
    const bool any = std::ranges::any_of(run_.differences, [](const Operation& o) { return o.error != 0; }) ||
                     run_.left.error != 0 || run_.right.error != 0;
    const std::string error = run_.det.share > 0
                                  ? "In this run the error is " + percent(run_.det.share) + " of the bound."
                              : any ? "In this run the errors cancel."
                                    : "In this run nothing is rounded before the last difference.";
    const std::string derived =
        std::string(
            "The error is at most *bound*: four roundings touch each product. One *u* more covers the terms in "
            "*u*^2.\n") +
        "The constant has slack: where anything is rounded, the error is less than *bound*. So |*det*| ≥ *bound* is "
        "enough.\n" +
        (run_.underflows() ? "The 2^{−960} in *size* pays for digits that underflow took.\n" : "") +
        "Shewchuk needs only (3 + 16 *u*) *u* for the sign: the last rounding cannot turn it.\n" + error;
    Step& step = script_.add("bound", "The bound is 5 *u* times the size", 3,
                             run_.overflows() ? "The bound, *bound*, is infinite here: nothing is certain." : derived,
                             "*bound* = 5 *u* · *size* = " + shown(bound));
    step.scene = bounds({bounded(run_.det, "*det*")}, "*bound*");
  }

  Script& script_;
  const Setup& s_;
  const Run& run_;
};

}  // namespace

void tell_derivation(Script& script, const Setup& s, const Run& run) { Derivation(script, s, run).tell(); }

}  // namespace isect::lessons::rounding_bound_lesson
