#include "lessons/clipping/reciprocals.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include <isect/clip_segment.h>
#include "lessons/shared/axis_names.h"
#include "lessons/shared/questions.h"

namespace isect::lessons::clipping_lesson {

using namespace viz;

namespace {

/// The number as it is shown; what is not a number has a word of its own.
std::string told(double x) { return std::isnan(x) ? "no number" : shown(x); }

}  // namespace

SlabTeller::SlabTeller(const Segment<double, 2>& segment, const Box& box, bool range_first)
    : box_(box),
      range_first_(range_first),
      truth_(isect::clip(segment, box)),
      script_({"Lecture note, uses of intersection detection; Kay and Kajiya, Ray Tracing Complex Scenes, SIGGRAPH "
               "(1986)",
               std::string("A segment from p to q and a box, clipped by slabs. ") +
                   (truth_ ? "The part in the box is drawn thick." : "No part of the segment lies in the box."),
               {"[t_in, t_out] ← [0, 1]; for each axis",                  // 0
                "    t₁ ← (lo − p) · (1/d), t₂ ← (hi − p) · (1/d)",       // 1
                "    entry ← min(t₁, t₂), exit ← max(t₁, t₂)",            // 2
                "    t_in ← max(t_in, entry), t_out ← min(t_out, exit)",  // 3
                "if t_in ≤ t_out: return [t_in, t_out]",                  // 4
                "return NONE"},                                           // 5
               "slabs by reciprocals"}),
      known_{segment, box} {
  known_.started = true;
}

Walk SlabTeller::tell() {
  begin();
  const Ray<double, 2> ray = isect::segment(known_.segment.p, known_.segment.q);
  Record<ray_aabb::MethodEvent<double>> record;
  found_ = range_first_ ? ray_aabb::by_min_max(ray, box_, record) : ray_aabb::by_min_max_exchanged(ray, box_, record);
  exchanged_ = range_first_ ? ray_aabb::by_min_max_exchanged(ray, box_) : ray_aabb::by_min_max(ray, box_);
  for (const auto& event : record.events) std::visit([&](const auto& e) { say(e); }, event);
  end();
  return std::move(script_.walk());
}

Step& SlabTeller::add(const std::string& slug, const std::string& title, int line, const std::string& caption,
                      const std::string& formula) {
  Step& step = script_.add(slug, title, line, caption, formula);
  step.scene = picture(known_);
  return step;
}

void SlabTeller::begin() {
  script_.value("*t*_{in}", 0);
  script_.value("*t*_{out}", 1);
  add("range", "A slab for each axis", 0,
      "Ray tracers clip the segment **p** + *t* **d** at a box by slabs, with **d** = **q** − **p**. One reciprocal "
      "an axis and no branch is fast.\n"
      "In C++ max(*a*, *b*) is *b* if *a* < *b*, else *a*. And min(*a*, *b*) is *b* if *b* < *a*, else *a*.\n" +
          std::string(range_first_ ? "Here *t*_{in} and *t*_{out} are the first arguments, as in the algorithm."
                                   : "Here entry and exit are the first arguments, against the algorithm."),
      "[*t*_{in}, *t*_{out}] = [0, 1]");
}

void SlabTeller::say(const ray_aabb::Planes<double>& e) {
  slab_ = {e.lo, e.hi};
  const std::string axis = axis_names[axis_];
  Step& step = add("planes-" + letter(), "The slab on " + axis, 1, planes_caption(),
                   fmt::format("*t*_1 = {}, *t*_2 = {}", told(e.lo), told(e.hi)));
  const Scene over = step.scene;
  add_slab(step.scene);
  if (asked_t_ || std::isinf(inverse_)) return;
  asked_t_ = true;
  const double p = known_.segment.p[axis_], d = known_.segment.q[axis_] - p, at = box_.lo[axis_];
  step.question =
      which_value(fmt::format("From {} = {}, **d** advances by {}. At which *t* is {} = {}?", axis, shown(p), shown(d),
                              axis, shown(at)),
                  e.lo,
                  {{at - p, "That is the way to go, not divided by what **d** advances."},
                   {(p - at) / d, "That goes the wrong way round: the sign is the opposite."},
                   {1 - e.lo, "That counts from the other end."}},
                  fmt::format("*t*_1 = ({} − {}) / {}.", shown(at), p < 0 ? "(" + shown(p) + ")" : shown(p), shown(d)));
  step.question->over = over;
  give_before(script_.walk(), {"*t*_{in}", "*t*_{out}"});
}

void SlabTeller::say(const ray_aabb::Crossing<double>& e) {
  crossing_ = {e.entry, e.exit};
  no_number_seen_ = no_number_seen_ || no_number(slab_);
  hidden_ = hidden_ || (no_number(slab_) && !no_number(crossing_));
  Step& step = add("sorted-" + letter(), "Entry and exit on " + std::string(axis_names[axis_]), 2, crossing_caption(),
                   fmt::format("entry = {}, exit = {}", told(e.entry), told(e.exit)));
  add_slab(step.scene);
}

void SlabTeller::say(const ray_aabb::Remains<double>& e) {
  const Interval<double> before = range_;
  range_ = {e.in, e.out};
  known_.left = !e.holds;
  if (e.holds) known_.range = {std::max(range_.lo, -0.25), std::min(range_.hi, 1.25)};  // as far as it is drawn
  script_.value("*t*_{in}", e.in, {}, Role::hit);
  script_.value("*t*_{out}", e.out, {}, Role::hit);
  Step& step = add("range-" + letter(), "What is left after " + std::string(axis_names[axis_]), 3,
                   remains_caption(before), fmt::format("range [{}, {}]", told(e.in), told(e.out)));
  step.decides = true;
  if (!no_number(crossing_) || no_number(before)) return;
  const std::string first = range_first_ ? "*t*_{in}" : "the entry", second = range_first_ ? "the entry" : "*t*_{in}";
  step.question = {fmt::format("*t*_{{in}} is {}, and the entry is not a number. What does max({}, {}) of C++ return?",
                               shown(before.lo), first, second),
                   {"*t*_{in}", "the entry, no number", "nothing: it is an error"},
                   std::isnan(e.in) ? 1 : 0,
                   "The first argument *a* is returned, unless *a* < *b*. No such comparison holds."};
  keep_picture(script_.walk());
  give_before(script_.walk(), {"*t*_{in}", "*t*_{out}"});
}

void SlabTeller::add_slab(Scene& scene) const {
  constexpr double overhang = 0.625;
  std::vector<Item> sides;
  for (const bool upper : {false, true}) {
    Point<double, 2> from = box_.lo, to = box_.hi;
    from[axis_] = to[axis_] = upper ? box_.hi[axis_] : box_.lo[axis_];
    from[1 - axis_] -= overhang, to[1 - axis_] += overhang;
    sides.emplace_back(Line{flat(from), flat(to), Role::highlight, Pen::highlight});
  }
  scene.items.insert(scene.items.begin() + 1, sides.begin(), sides.end());
  for (const auto& [t, name] : {std::pair{slab_.lo, "*t*_1"}, {slab_.hi, "*t*_2"}}) {
    if (!(-0.25 <= t && t <= 1.25)) continue;
    scene.items.emplace_back(Dot{flat(known_.at(t)), Mark::uncounted, Role::construction});
    scene.items.emplace_back(Label{flat(known_.at(t)), name, Role::text});
  }
}

void SlabTeller::end() {
  known_.settled = true, known_.left = !truth_;
  known_.range = truth_.value_or(Interval<double>{0, 0});
  const bool in_a_side = runs_along_a_side(known_.segment, box_);
  const bool a_corner = truth_ && truth_->lo == truth_->hi && !is_a_point();
  script_.settle(!truth_                 ? Verdict::Kind::no
                 : in_a_side || a_corner ? Verdict::Kind::on
                                         : Verdict::Kind::yes,
                 verdict_text());
  if (!found_) script_.refuse(4, {});
  add("kept", "What the method keeps", found_ ? 4 : 5, end_caption(), "");
}

Walk clip_by_reciprocals(const Segment<double, 2>& segment, const Box& box, bool range_first) {
  return SlabTeller(segment, box, range_first).tell();
}

}  // namespace isect::lessons::clipping_lesson
