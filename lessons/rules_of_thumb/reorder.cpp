// Rule 3, on boxes that spread along one axis.

#include <fmt/format.h>

#include <isect/aabb_aabb.h>
#include <isect/methods/aabb_aabb.h>
#include "bench/random.h"
#include "lessons/rules_of_thumb/experiment.h"

namespace isect::lessons::rules_of_thumb_lesson {

using namespace viz;

namespace {
using C = Counted<double>;
}  // namespace

Experiment reorder(const Flat& p) {
  bench::Random random(3);
  const auto box = [](const Flat& lo, const Flat& hi, bool y_first) -> Aabb<C, 3> {
    const Point<double, 3> l = y_first ? Point<double, 3>(lo.y(), lo.x(), 0) : Point<double, 3>(lo.x(), lo.y(), 0),
                           h = y_first ? Point<double, 3>(hi.y(), hi.x(), 1) : Point<double, 3>(hi.x(), hi.y(), 1);
    return {l.cast<C>(), h.cast<C>()};
  };
  const Flat half(0.35, 0.12), lo = p - half, hi = p + half;
  Experiment e = {.title = "3: reorder the tests",
                  .source = "Lecture note, rules of thumb (3) and boxes",
                  .alt = "A small box among seven long flat ones, one above the other.",
                  .pseudocode = {"for each other box b", "    without: compare on x, then y, then z",
                                 "    with: first the axis along which the boxes spread", "    then the others"},
                  .unit = "comparisons"};
  for (Part& part : e.parts) part.items.emplace_back(region({lo, {hi.x(), lo.y()}, hi, {lo.x(), hi.y()}}, Role::first));
  e.parts[2].items.emplace_back(Arrow{{-3.2, -1.95, 0}, {-3.2, 1.95, 0}, Role::highlight, Pen::highlight});
  int overlap_on_x = 0, overlap_on_y = 0;
  for (int i = 0; i < 7; ++i) {
    const double y = -1.8 + 0.55 * i;
    const Flat l(-2.95 + random.uniform(0, 0.4), y), h(0.7 - random.uniform(0, 0.4), y + 0.14);
    overlap_on_x += lo.x() <= h.x() && l.x() <= hi.x(), overlap_on_y += lo.y() <= h.y() && l.y() <= hi.y();
    bool meet = false;
    const int without = total(counted([&] { meet = aabb_aabb::by_axis(box(lo, hi, false), box(l, h, false)); }));
    const int with = total(counted([&] { aabb_aabb::by_axis(box(lo, hi, true), box(l, h, true)); }));
    e.before += without, e.after += with;
    for (std::size_t k = 0; k < 4; ++k)
      e.parts[k].items.emplace_back(
          region({l, {h.x(), l.y()}, h, {l.x(), h.y()}}, k % 2 == 1 && meet ? Role::hit : Role::second));
    e.parts[1].items.emplace_back(text({1.0, y + 0.07}, std::to_string(without), Role::muted));
    e.parts[3].items.emplace_back(text({1.0, y + 0.07}, std::to_string(with), Role::muted));
  }
  e.parts[0].title = "The likeliest gap first";
  e.parts[0].caption = "Which of the long boxes meets the small one, around **p**? They lie one above the other.";
  e.parts[1].title = "*x* before *y*";
  e.parts[1].caption = fmt::format(
      "On *x*, {} of 7 boxes {} the small one{}.\n"
      "Beside each box: how many comparisons its test needs.",
      overlap_on_x, overlap_on_x == 1 ? "overlaps" : "overlap",
      overlap_on_x > 0 ? ": comparisons that decide nothing" : ", so that *x* alone decides");
  e.parts[2].title = "The boxes spread along *y*";
  e.parts[2].caption = "A gap is likeliest on the axis along which the boxes lie farthest apart. Test it first.";
  e.parts[3].title = "*y* before *x*";
  e.parts[3].caption =
      fmt::format("On *y*, {} of 7 {}. It is the same test with its axes in another order, and gives the same answers.",
                  overlap_on_y, overlap_on_y == 1 ? "overlaps" : "overlap");
  e.saving = overlap_on_y < overlap_on_x ? "One gap ends a test, and more boxes have it on *y* than on *x*."
                                         : "One gap ends a test, whichever axis has it.";
  return e;
}

}  // namespace isect::lessons::rules_of_thumb_lesson
