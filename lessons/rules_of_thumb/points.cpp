// Rules 6 and 8, on points.

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "bench/random.h"
#include "bench/rows.h"
#include "core/orient.h"
#include "core/orient_methods.h"
#include "core/point_polygon.h"
#include "core/slab_map.h"
#include "lessons/rules_of_thumb/experiment.h"
#include "lessons/speed_against_error/results.h"
#include "viz/lesson.h"

namespace isect::lessons::rules_lesson {

using namespace viz;

namespace {

Ring<double, 2> jagged() {
  bench::Random random(5);
  Ring<double, 2> ring;
  for (int i = 0; i < 48; ++i) {
    const double angle = 2 * std::numbers::pi * i / 48, r = random.uniform(0.55, 1);
    ring.push_back({-1.05 + 2.1 * r * std::cos(angle), 1.9 * r * std::sin(angle)});
  }
  return ring;
}

/// How many heights and edges a query compares.
int asked(const Flat& p, const SlabMap& map) {
  Record<slab_map::Event> record;
  locate(p, map, FillRule::even_odd, record);
  int n = 0;
  for (const auto& event : record.events) {
    if (const auto* e = std::get_if<slab_map::SlabFound>(&event)) n += e->steps;
    if (const auto* e = std::get_if<slab_map::OnLine>(&event)) n += e->steps;
    n += std::holds_alternative<slab_map::Compared>(event);
  }
  return n;
}

}  // namespace

Experiment precalculate(const Flat& p) {
  const Ring<double, 2> ring = jagged();
  const SlabMap map = make_slab_map(ring);
  bench::Random random(11);
  std::vector<Flat> points = {p};
  while (points.size() < 60) {
    const double x = random.uniform(-3.2, 1.1);
    points.emplace_back(x, random.uniform(-1.95, 1.95));
  }
  const int n = static_cast<int>(ring.size()), many = static_cast<int>(points.size());
  Experiment e = {
      .title = "6: many against one, precalculate",
      .source = "Note, N10 (6), N24",
      .alt = fmt::format("A jagged polygon of {} vertices and {} points.", n, many),
      .pseudocode = {"for each of many points, and one polygon", "    without: look at every edge",
                     "    with: once, store the edges of each slab in order",
                     "    then bisect heights and edges for each point"},
      .unit = "steps"};
  const auto stored = static_cast<double>(map.order.size());
  e.after = stored;
  for (const Flat& q : points) {
    Record<point_polygon::NaiveEvent<double>> record;
    point_polygon::crossings_naive(q, ring, record);
    for (const auto& event : record.events)
      e.before += std::holds_alternative<point_polygon::Straddles>(event);
    e.after += asked(q, map);
    const Location truth = locate(q, map);
    for (std::size_t k = 0; k < 4; ++k)
      if (k != 2 && (&q != &points[0]))
        e.parts[k].items.emplace_back(Dot{flat(q),
                                          k > 0 && truth == Location::out ? Mark::uncounted : Mark::disc,
                                          k == 0                   ? Role::muted
                                          : truth == Location::out ? Role::muted
                                                                   : Role::hit});
  }
  for (Part& part : e.parts) part.items.insert(part.items.begin(), region(ring, Role::second));
  for (const SlabMap::Slab& s : map.slabs)
    if (std::isfinite(s.bottom))
      e.parts[2].items.emplace_back(
          line({-3.3, s.bottom}, {1.2, s.bottom}, Role::construction, Pen::hairline));
  const double a_point = (e.after - stored) / many;
  e.details = {{"stored once", stored},
               {"steps a point", a_point},
               {"pays from so many points", std::ceil(stored / (n - a_point))}};
  e.parts[0].title = "Many points, one polygon";
  e.parts[0].caption =
      fmt::format("{} points are to be told inside or outside of one polygon with {} edges.", many, n);
  e.parts[1].title = "Every edge for every point";
  e.parts[1].caption =
      "Crossings look at all edges for each point: *n* steps a point, and nothing is remembered.";
  e.parts[2].title = "Prepare once";
  e.parts[2].caption =
      fmt::format("Slabs keep the edges in order: {} entries, stored once. Each counts as a step, too.",
                  static_cast<int>(stored));
  e.parts[3].title = "Then ask quickly";
  e.parts[3].caption = fmt::format(
      "A point now takes {} steps on average instead of {}. With the preparation, it pays from {} "
      "points on.",
      shown(std::round(10 * a_point) / 10), n, shown(std::ceil(stored / (n - a_point))));
  e.saving = "The preparation is paid once, the saving comes with every point.";
  return e;
}

namespace {

/// A point said to lie left or right of the line, or on it: drawn on that side.
Dot said(const Flat& q, const Vector<double, 2>& left, int side, bool wrong) {
  const Flat at = q + 0.13 * side * left;
  if (wrong) return {flat(at), Mark::cross, Role::miss};
  if (side == 0) return {flat(at), Mark::diamond, Role::highlight};
  return {flat(at), Mark::disc, side > 0 ? Role::first : Role::second};
}

/// What the measurements say of the price.
std::string price() {
  const auto rows = bench::rows_of(speed_lesson::results(), "orient2d", "double", "ordinary");
  const bench::Row *naive = bench::standard_of(rows), *exact = bench::exact_of(rows);
  if (naive == nullptr || exact == nullptr) return "";
  return fmt::format("\nMeasured far from a line ({}): {} ns a call instead of {} ns.",
                     speed_lesson::results().machine.cpu, shown(exact->ns), shown(naive->ns));
}

}  // namespace

Experiment robust(const Flat& p) {
  const Flat a(-3.1, -1.7);
  Experiment e = {.title = "8: make it robust",
                  .source = "Note, N10 (8); Kettner et al. (2008)",
                  .alt = "Points computed on a line, and on which side of it they are said to lie.",
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
  int open = 0;
  for (int k = 1; k <= many; ++k) {
    const Flat q = a + (k / (many + 1.0)) * along;
    Record<std::variant<Fallback>> record;
    const int truth = orient2d(a, p, q, record);
    const double rounded = orient::pivoted<orient::Corner::c>(a, p, q);
    const int naive = (rounded > 0) - (rounded < 0);
    open += !record.events.empty();
    e.before += naive != truth;  // with the rule none: the truth is its own
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
  e.parts[0].caption = fmt::format(
      "{} points are computed on the line from **a** to **p**. Rounding puts most beside it. On "
      "which side?",
      many);
  e.parts[1].title = "The rounded sign";
  e.parts[1].caption =
      "Points said to lie left are drawn above the line, right below. Crosses mark wrong answers.\n"
      "Each may break what builds on it: a hull, a map, a mesh.";
  e.parts[2].title = "Know when you do not know";
  e.parts[2].caption = fmt::format(
      "A bound of the rounding error stands beside the value. Rings: {} signs that it leaves open.", open);
  e.parts[3].title = "Exact where needed";
  e.parts[3].caption =
      "Open signs are computed again, exactly: none is wrong. The note expects 80 % of the work here." +
      price();
  e.saving = "The exact test is right on every input: that is its promise.";
  return e;
}

}  // namespace isect::lessons::rules_lesson
