// A segment against a box by slabs with reciprocals, as ray tracers write it, and what min and max make of 0 · ∞.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include <isect/clip_segment.h>
#include <isect/methods/ray_aabb.h>
#include "lessons/clipping/picture.h"
#include "lessons/shared/axis_names.h"
#include "lessons/shared/questions.h"
#include "lessons/shared/script.h"

namespace isect::lessons::clipping_lesson {

using namespace viz;

namespace {

using Part = std::optional<Interval<double>>;

/// The number as it is shown; what is not a number has a word of its own.
std::string told(double x) { return std::isnan(x) ? "no number" : shown(x); }

bool no_number(const Interval<double>& i) { return std::isnan(i.lo) || std::isnan(i.hi); }

class Reciprocals {
 public:
  Reciprocals(const Segment<double, 2>& segment, const Box& box, bool range_first)
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

  Walk tell() {
    begin();
    const Ray<double, 2> ray = isect::segment(known_.segment.p, known_.segment.q);
    Record<ray_aabb::MethodEvent<double>> record;
    found_ = range_first_ ? ray_aabb::by_min_max(ray, box_, record) : ray_aabb::by_min_max_exchanged(ray, box_, record);
    exchanged_ = range_first_ ? ray_aabb::by_min_max_exchanged(ray, box_) : ray_aabb::by_min_max(ray, box_);
    for (const auto& event : record.events) std::visit([&](const auto& e) { say(e); }, event);
    end();
    return std::move(script_.walk());
  }

 private:
  Step& add(const std::string& slug, const std::string& title, int line, const std::string& caption,
            const std::string& formula) {
    Step& step = script_.add(slug, title, line, caption, formula);
    step.scene = picture(known_);
    return step;
  }

  void begin() {
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

  std::string letter() const { return std::string(1, "xy"[axis_]); }

  void say(const ray_aabb::Reciprocal<double>& e) { axis_ = e.axis, inverse_ = e.value; }

  void say(const ray_aabb::Planes<double>& e) {
    slab_ = {e.lo, e.hi};
    const std::string axis = axis_names[axis_];
    Step& step = add("planes-" + letter(), "The slab on " + axis, 1, planes_caption(),
                     fmt::format("*t*_1 = {}, *t*_2 = {}", told(e.lo), told(e.hi)));
    const Scene over = step.scene;
    add_slab(step.scene);
    if (asked_t_ || std::isinf(inverse_)) return;
    asked_t_ = true;
    const double p = known_.segment.p[axis_], d = known_.segment.q[axis_] - p, at = box_.lo[axis_];
    // not divided by d; the wrong way round; from q
    step.question = which_value(
        fmt::format("From {} = {}, **d** advances by {}. At which *t* is {} = {}?", axis, shown(p), shown(d), axis,
                    shown(at)),
        e.lo, {at - p, (p - at) / d, 1 - e.lo},
        fmt::format("*t*_1 = ({} − {}) / {}.", shown(at), p < 0 ? "(" + shown(p) + ")" : shown(p), shown(d)));
    step.question->over = over;
    give_before(script_.walk(), {"*t*_{in}", "*t*_{out}"});
  }

  std::string planes_caption() const {
    const double d = known_.segment.q[axis_] - known_.segment.p[axis_];
    const std::string start = fmt::format("On {} the component of **d** is {}, and its reciprocal is {}.\n",
                                          axis_names[axis_], shown(d), shown(inverse_));
    if (!std::isinf(inverse_)) return start + "The line crosses the lines of two sides at *t*_1 and *t*_2.";
    if (no_number(slab_))
      return start + fmt::format("**p** lies level with {}: there 0 · ∞ is not a number.",
                                 name_of(Side{axis_, std::isnan(slab_.hi)}));
    return start + (slab_.lo < slab_.hi ? "The line is parallel to two sides and lies between them. So the crossings "
                                          "are infinitely far, one before and one after."
                                        : "The line is parallel to two sides and lies beyond one of them. So both "
                                          "crossings are infinitely far, on one side.");
  }

  void say(const ray_aabb::Crossing<double>& e) {
    crossing_ = {e.entry, e.exit};
    std::string caption = "The smaller is the entry into the slab, the larger the exit from it.";
    if (no_number(slab_)) {
      no_number_seen_ = true;
      hidden_ = !no_number(crossing_);
      caption = std::string(
                    "No comparison with what is not a number holds. So both min and max return their first argument, "
                    "*t*_1.\n") +
                (hidden_ ? "It is −∞, for entry and exit. That *t*_2 is not a number is hidden now."
                         : "So neither entry nor exit is a number.");
    }
    Step& step = add("sorted-" + letter(), "Entry and exit on " + std::string(axis_names[axis_]), 2, caption,
                     fmt::format("entry = {}, exit = {}", told(e.entry), told(e.exit)));
    add_slab(step.scene);
  }

  void say(const ray_aabb::Remains<double>& e) {
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
    step.question = {
        fmt::format("*t*_{{in}} is {}, and the entry is not a number. What does max({}, {}) of C++ return?",
                    shown(before.lo), first, second),
        {"*t*_{in}", "the entry, no number", "nothing: it is an error"},
        std::isnan(e.in) ? 1 : 0,
        "The first argument *a* is returned, unless *a* < *b*. No such comparison holds."};
    keep_picture(script_.walk());
    give_before(script_.walk(), {"*t*_{in}", "*t*_{out}"});
  }

  std::string remains_caption(const Interval<double>& before) const {
    if (no_number(crossing_) && !no_number(range_))
      return "The range comes first, so max and min return it: this slab is passed over, as if it were not there.";
    if (no_number(before) && no_number(range_))
      return "The range is not a number, and the first argument is returned: still no number.";
    if (no_number(range_))
      return "Entry and exit come first, so max and min return them: the range is no longer a number.";
    if (no_number(before))
      return "Entry and exit come first and replace what is not a number. What was found before is forgotten, and with "
             "it 0 ≤ *t* ≤ 1.";
    if (hidden_ && known_.left) return "The exit −∞ ends the range before it begins. Nothing tells why.";
    if (known_.left) return "The range ends before it begins: nothing of it is left.";
    return before == range_ ? "The range lies in this slab already, and stays as it is."
                            : "The last entry and the first exit count: the range shrinks.";
  }

  /// Adds the two sides of the axis, and where the line crosses theirs.
  void add_slab(Scene& scene) const {
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

  bool is_a_point() const { return known_.segment.p == known_.segment.q; }
  /// Whether the part that the method keeps goes beyond the segment.
  bool beyond() const { return found_ && (found_->lo < 0 || found_->hi > 1); }

  void end() {
    known_.settled = true, known_.left = !truth_;
    known_.range = truth_.value_or(Interval<double>{0, 0});
    const bool one = truth_ && (truth_->lo == truth_->hi || is_a_point());
    const auto [lo, hi] = shown_apart(known_.range.lo, known_.range.hi);
    const std::string kept = is_a_point() ? "the point is kept"
                             : one        ? "one point is kept: *t* = " + lo
                                          : fmt::format("kept: *t* from {} to {}", lo, hi);
    script_.settle(!truth_                                                             ? Verdict::Kind::no
                   : runs_along_a_side(known_.segment, box_) || (one && !is_a_point()) ? Verdict::Kind::on
                                                                                       : Verdict::Kind::yes,
                   !truth_    ? std::string("nothing is kept") + (found_ ? "; this method keeps a part" : "")
                   : !found_  ? kept + "; this method loses it"
                   : beyond() ? kept + "; this method keeps more"
                              : kept);
    if (!found_) script_.refuse(4, {});
    const std::string exchanged =
        fmt::format("\nWith the arguments exchanged it would keep {}.", exchanged_ ? "a part" : "none");
    add("kept", "What the method keeps", found_ ? 4 : 5, end_caption() + (no_number_seen_ ? exchanged : ""), "");
  }

  std::string end_caption() const {
    if (!no_number_seen_) {
      if (found_.has_value() != truth_.has_value())
        return "Rounding makes this method wrong here: at a corner the last entry is the first exit, and rounding "
               "moved them.";
      return found_ ? "No product was 0 · ∞, so min and max compared numbers only. The exact test keeps a part, too."
                    : "No product was 0 · ∞, so min and max compared numbers only. The exact test keeps nothing, too.";
    }
    if (beyond()) return "The part kept goes beyond the segment, whose range was forgotten: this answer is wrong.";
    if (found_ && truth_)
      return range_first_ ? "This answer is right: the range came first, so what is not a number was passed over."
                          : "This answer is right: the next axis replaced what is not a number. The range that it "
                            "forgot was not needed.";
    if (found_) return "The exact test keeps nothing: this answer is wrong.";
    if (!truth_) return "The exact test keeps nothing, too.";
    return hidden_ ? "The segment lies in a side, and the exact test keeps it. This method loses it: −∞ has hidden "
                     "that a product was not a number."
                   : "The segment lies in a side, and the exact test keeps it. This method loses it: the range is not "
                     "a number, and no comparison with it holds.";
  }

  const Box box_;
  const bool range_first_;
  const Part truth_;
  Script script_;
  Narrowing known_;
  Part found_, exchanged_;  ///< what the method keeps; what it would keep with the arguments exchanged
  int axis_ = 0;
  double inverse_ = 0;
  Interval<double> slab_ = {0, 0}, crossing_ = {0, 0}, range_ = {0, 1};
  bool asked_t_ = false, no_number_seen_ = false, hidden_ = false;
};

}  // namespace

Walk clip_by_reciprocals(const Segment<double, 2>& segment, const Box& box, bool range_first) {
  return Reciprocals(segment, box, range_first).tell();
}

}  // namespace isect::lessons::clipping_lesson
