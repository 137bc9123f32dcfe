// Rule 8, on points near a line.

#include <fmt/format.h>

#include <cmath>

#include <isect/methods/orient.h>
#include <isect/orient.h>
#include "bench/rows.h"
#include "lessons/rules_of_thumb/experiment.h"
#include "lessons/shared/plural.h"
#include "lessons/speed_against_error/results.h"
#include "viz/lesson.h"

namespace isect::lessons::rules_of_thumb_lesson {

using namespace viz;

namespace {

/// A mark for a point that a test puts left or right of the line, or on it, drawn on that side.
Dot said(const Flat& q, const Vector<double, 2>& left, int side, bool wrong) {
  const Flat at = q + 0.13 * side * left;
  if (wrong) return {flat(at), Mark::cross, Role::miss};
  if (side == 0) return {flat(at), Mark::diamond, Role::highlight};
  return {flat(at), Mark::disc, side > 0 ? Role::first : Role::second};
}

/// A sentence on the measured cost.
std::string price() {
  const auto rows = bench::rows_of(speed_against_error_lesson::results(), "orient2d", "double", "ordinary");
  const bench::Row *naive = bench::standard_of(rows), *exact = bench::exact_of(rows);
  if (naive == nullptr || exact == nullptr) return "";
  return fmt::format("\nMeasured far from a line ({}): {} ns a call instead of {} ns.",
                     speed_against_error_lesson::results().machine.cpu, shown(exact->ns), shown(naive->ns));
}

}  // namespace

Experiment robust(const Flat& p) {
  const Flat a(-3.1, -1.7);
  Experiment e = {
      .title = "8: make it robust",
      .source = "Lecture note, rules of thumb (8); Kettner et al., Classroom examples of robustness problems (2008)",
      .alt = "Points computed on a line, and the side that each test reports for them.",
      .pseudocode = {"for each of many points near the line from a to p",
                     "    without: the sign of a rounded determinant",
                     "    with: a proved bound of its error beside it",
                     "    where that leaves the sign open: compute exactly"},
      .unit = "wrong sides"};
  constexpr int many = 24;
  const Vector<double, 2> along = p - a;
  const double length = along.norm() > 0 ? along.norm() : 1;
  const Vector<double, 2> left(-along.y() / length, along.x() / length);
  for (Part& part : e.parts) part.items.emplace_back(line(a, p, Role::construction, Pen::hairline));
  int open = 0, beside = 0;
  for (int k = 1; k <= many; ++k) {
    const Flat q = a + (k / (many + 1.0)) * along;
    Record<std::variant<Fallback>> record;
    const int truth = orient2d(a, p, q, record);
    const double rounded = orient::pivoted<orient::Corner::c>(a, p, q);
    const int naive = (rounded > 0) - (rounded < 0);
    open += !record.events.empty(), beside += truth != 0;
    e.before += naive != truth;  // with the rule none is wrong: it gives the truth
    e.parts[0].items.emplace_back(Dot{flat(q), Mark::disc, Role::muted});
    e.parts[1].items.emplace_back(said(q, left, naive, naive != truth));
    e.parts[2].items.emplace_back(Dot{flat(q), record.events.empty() ? Mark::disc : Mark::ring, Role::text});
    e.parts[3].items.emplace_back(said(q, left, truth, false));
  }
  for (Part& part : e.parts) {
    part.items.emplace_back(Dot{flat(a), Mark::disc, Role::second});
    part.items.emplace_back(Label{flat(a), "**a**", Role::second});
  }
  e.details = {{"points", many}, {"sign left open", open}};
  e.parts[0].title = "Is it ever wrong?";
  e.parts[0].caption =
      fmt::format("{} points are computed on the line from **a** to **p**. Rounding puts {} beside it.{}", many,
                  beside == many ? fmt::format("all {}", many)
                  : beside == 0  ? std::string("none")
                                 : fmt::format("{}", beside),
                  beside == 0 ? "" : " On which side?");
  e.parts[1].title = "The rounded sign";
  e.parts[1].caption =
      std::string("Points said to lie left are drawn left of the line, seen from **a** to **p**; right ones right.") +
      (e.before > 0 ? " Crosses mark wrong answers.\nEach may break what builds on it: a hull, a map, a mesh." : "");
  e.parts[2].title = "Know when you do not know";
  e.parts[2].caption =
      fmt::format("A bound on the rounding error comes with the value. It leaves {} open{}.", plural(open, "sign"),
                  open > 0 ? " (rings)" : "") +
      "\nShewchuk's bound, but for underflow: the sign of *l* − *r*, both rounded products, is right where "
      "|*l* − *r*| ≥ (3 + 16*u*) *u* (|*l*| + |*r*|), *u* = 2^{−53}.";
  e.parts[3].title = "Exact where needed";
  e.parts[3].caption =
      std::string(open > 0 ? "Open signs are computed again, exactly. So no sign is wrong." : "No sign is wrong.") +
      " The note expects 80 % of all work on a test to go into this." + price();
  e.saving = "The exact test is right on every input: that is its promise.";
  return e;
}

}  // namespace isect::lessons::rules_of_thumb_lesson
