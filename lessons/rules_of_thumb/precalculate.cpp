// Rule 6, on many points and one polygon.

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include <isect/many/slab_map.h>
#include <isect/methods/point_polygon.h>
#include <isect/point_polygon.h>
#include "bench/random.h"
#include "lessons/rules_of_thumb/experiment.h"
#include "viz/lesson.h"

namespace isect::lessons::rules_of_thumb_lesson {

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
  Experiment e = {.title = "6: many against one, precalculate",
                  .source = "Lecture note, rules of thumb (6), concave polygons",
                  .alt = fmt::format("A jagged polygon with {} vertices, and {} points.", n, many),
                  .pseudocode = {"for each of many points, and one polygon", "    without: look at every edge",
                                 "    with: once, store the edges of each slab in order",
                                 "    then bisect heights and edges for each point"},
                  .unit = "steps"};
  const auto stored = static_cast<double>(map.order.size());
  e.after = stored;
  for (const Flat& q : points) {
    Record<point_polygon::NaiveEvent<double>> record;
    point_polygon::crossings_naive(q, ring, record);
    for (const auto& event : record.events) e.before += std::holds_alternative<point_polygon::Straddles>(event);
    e.after += asked(q, map);
    const Location truth = locate(q, map);
    for (std::size_t k = 0; k < 4; ++k)
      if (k != 2 && (&q != &points[0]))
        e.parts[k].items.emplace_back(Dot{flat(q), k > 0 && truth == Location::out ? Mark::uncounted : Mark::disc,
                                          k == 0                   ? Role::muted
                                          : truth == Location::out ? Role::muted
                                                                   : Role::hit});
  }
  for (Part& part : e.parts) part.items.insert(part.items.begin(), region(ring, Role::second));
  for (const SlabMap::Slab& s : map.slabs)
    if (std::isfinite(s.bottom))
      e.parts[2].items.emplace_back(line({-3.3, s.bottom}, {1.2, s.bottom}, Role::construction, Pen::hairline));
  const double a_point = (e.after - stored) / many;
  e.details = {{"stored once", stored},
               {"steps per point", a_point},
               {"pays off from this many points", std::ceil(stored / (n - a_point))}};
  e.parts[0].title = "Many points, one polygon";
  e.parts[0].caption = fmt::format("Which of {} points lie in one polygon of {} edges?", many, n);
  e.parts[1].title = "Every edge for every point";
  e.parts[1].caption = "Crossings look at all edges for each point: *n* steps a point, and nothing is remembered.";
  e.parts[2].title = "Prepare once";
  e.parts[2].caption = fmt::format(
      "Slabs keep the edges in order: {} entries, stored once. Each counts as a step, too.", static_cast<int>(stored));
  e.parts[3].title = "Then query quickly";
  e.parts[3].caption = fmt::format(
      "A point now takes {} steps on average instead of {}. With the preprocessing included, that pays off from point "
      "{}.",
      shown(std::round(10 * a_point) / 10), n, shown(std::ceil(stored / (n - a_point))));
  e.saving = "The preparation is paid once, the saving comes with every point.";
  return e;
}

}  // namespace isect::lessons::rules_of_thumb_lesson
