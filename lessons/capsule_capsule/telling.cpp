#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <isect/orient.h>
#include "lessons/capsule_capsule/picture.h"
#include "lessons/shared/questions.h"
#include "lessons/shared/relation.h"
#include "lessons/shared/script.h"

namespace isect::lessons::capsule_capsule_lesson {

using namespace viz;
using capsule_capsule::Between;
using capsule_capsule::Nearest;

namespace {

const std::vector<std::string> pseudocode = {
    "R ← r_a + r_b",                                                  // 0
    "if the segments cross: d ← 0",                                   // 1
    "else: for p_a, q_a, until d < R: d ← distance to b, if less",    // 2
    "      for p_b, q_b, until d < R: d ← distance to a, if less",    // 3
    "if d > R: return DISJOINT",                                      // 4
    "if the balls at the ends of one lie in the other: INSIDE",       // 5
    "return OVERLAPPING, or TOUCHING if d = R (segments: at an end)"  // 6
};
const char* const end_names[] = {"**p**_a", "**q**_a", "**p**_b", "**q**_b"};

class Teller {
 public:
  explicit Teller(const Setup& setup)
      : s_(setup),
        script_({"Ericson, Real-Time Collision Detection (2005), sections 4.5 and 5.1.9",
                 "Two capsules in the plane, a and b: " + relation_words(s_.truth, "the capsules") + ".", pseudocode}) {
  }

  Walk tell() {
    reach();
    script_.tell<capsule_capsule::Event>([&](auto& record) { relate(s_.a, s_.b, record); },
                                         [&](const auto& event) { say(event); });
    if (!ends_.empty()) ends();
    relation();
    return std::move(script_.walk());
  }

 private:
  Step& add(const std::string& slug, const std::string& title, int line, const std::string& caption,
            const std::string& formula = {}) {
    Step& step = script_.add(slug, title, line, caption, formula);
    step.scene = picture(s_, shown_);
    return step;
  }

  void reach() {
    script_.value("*R*", sum(), "length", Role::first);
    shown_.radii = true;
    add("reach", "How far do they reach?", 0,
        "A capsule is the Minkowski sum of a segment and a ball: all points within its radius *r* of the segment.\n"
        "So two capsules meet if and only if the distance *d* of their segments is at most *R* = *r*_a + *r*_b.",
        fmt::format("*R* = {} + {} = {}", shown(s_.a.radius), shown(s_.b.radius), shown(sum())));
    shown_.radii = false;
  }

  void say(const Between& e) {
    shown_.crossing = crossed_ = e.holds;
    if (e.holds) least_ = 0, script_.value("*d*", 0, "length", Role::highlight);
    Step& step =
        add("crossing", "Do the segments cross?", 1,
            e.holds ? "They cross between their ends, so their distance *d* is 0."
                    : "No crossing. In the plane, a shortest connection of the segments then starts at an endpoint.\n"
                      "In space it may start between the ends of both, so four ends would not be enough.",
            e.holds ? "*d* = 0" : "");
    const int lines = separating_lines();
    step.question =
        which_count("Of the two segments' lines, how many have the other segment's ends on different sides?", lines,
                    {{0, "At least one of the lines has."},
                     {1, lines == 0 ? "Neither of the lines has." : "Both of the lines have."},
                     {2, "At least one of the lines has not."}},
                    std::string(a_point() ? "A segment that is one point has no line, and separates nothing. " : "") +
                        "Each takes two orientations: the signs of two areas (orient2d). The segments cross if and "
                        "only if both do.");
    if (e.holds)
      step.decides = true;
    else
      script_.refuse(1, {});
  }
  bool a_point() const { return s_.a.p == s_.a.q || s_.b.p == s_.b.q; }
  /// How many of the two segments' lines pass strictly between the ends of the other segment; exact.
  int separating_lines() const {
    const auto between = [](const Capsule2& line, const Capsule2& ends) {
      return orient2d(line.p, line.q, ends.p) * orient2d(line.p, line.q, ends.q) < 0;
    };
    return (between(s_.a, s_.b) ? 1 : 0) + (between(s_.b, s_.a) ? 1 : 0);
  }
  void say(const End& e) {
    if (!ends_.empty() && (ends_.back().end < 2) != (e.end < 2)) ends();
    ends_.push_back(e);
  }
  void say(const capsule_capsule::Contained&) {}  // the step of the relation shows it
  void say(const Fallback&) {}

  /// Adds the step about the tested ends of one segment.
  void ends() {
    const bool of_a = ends_.back().end < 2;
    const double before = least_;
    std::string caption;
    for (const End& e : ends_) {
      const auto [end, nearest] = s_.way(e);
      least_ = std::min(least_, (end - nearest).norm());
      caption += (caption.empty() ? "" : "\n") + said(e);
    }
    const bool settled = ends_.back().sign < 0;
    if (settled) caption += "\nSo the capsules meet, and no other endpoint is tested";
    if (settled) caption += shown_.earlier.size() + ends_.size() < 4 ? ": one may be nearer still." : ".";
    script_.value("least *d* so far", least_, "length", Role::highlight);
    shown_.ways = ends_;
    Step& step = add(of_a ? "ends-a" : "ends-b", of_a ? "The ends of a" : "The ends of b", of_a ? 2 : 3, caption,
                     "least *d* so far = " + shown(least_));
    if (read_well(least_as_read(before), least_)) {
      step.question =
          which_value(fmt::format("{} tested against {}. What is the least *d* so far?", tested(), tested_against()),
                      least_, misconceived(before),
                      std::string("The nearest point of a segment lies between its ends, or is one of them.") +
                          (least_ < before ? "" : " None of these is nearer than what was found before."));
      give_before(script_.walk(), {"least *d* so far"});
    }
    shown_.earlier.insert(shown_.earlier.end(), ends_.begin(), ends_.end());
    shown_.ways.clear(), ends_.clear();
  }

  /// The least *d* that a reader finds from the numbers as they are shown.
  double least_as_read(double before) const {
    const auto read = [](const Vec2& p) { return Vec2(as_read(p.x()), as_read(p.y())); };
    Setup setup = s_;
    for (Capsule2* c : {&setup.a, &setup.b}) c->p = read(c->p), c->q = read(c->q);
    double least = std::isinf(before) ? before : as_read(before);
    for (const End& e : ends_) {
      const auto [end, nearest] = setup.way(e);
      least = std::min(least, (end - nearest).norm());
    }
    return least;
  }

  /// "**p**_a = (1, 2) is": the ends of this step; a search that ends early leaves some out.
  std::string tested() const {
    const std::string first = placed(ends_.front().end);
    return ends_.size() == 1 ? first + " is" : fmt::format("{} and {} are", first, placed(ends_.back().end));
  }
  /// The segment that these ends are compared with.
  std::string tested_against() const {
    const int other = ends_.front().end < 2 ? 2 : 0;
    return fmt::format("the segment from {} to {}", placed(other), placed(other + 1));
  }
  std::string placed(int end) const {
    const Capsule2& c = end < 2 ? s_.a : s_.b;
    const Vec2 at = end % 2 == 0 ? c.p : c.q;
    return fmt::format("{} = ({}, {})", end_names[end], shown(at.x()), shown(at.y()));
  }

  /// Wrong values: the least distance to the ends alone, and to the line (each with what was found `before`); `before`
  /// alone; and the distance from the other capsule's surface.
  std::vector<WrongNumber> misconceived(double before) const {
    double to_ends = before, to_line = before;
    for (const End& e : ends_) {
      const Vec2 end = s_.way(e).first;
      const Capsule2& other = e.end < 2 ? s_.b : s_.a;
      const Vec2 d = other.q - other.p, w = end - other.p;
      to_ends = std::min({to_ends, w.norm(), (end - other.q).norm()});
      if (d.norm() > 0) to_line = std::min(to_line, std::abs(d.x() * w.y() - d.y() * w.x()) / d.norm());
    }
    const double to_surface = least_ - (ends_.front().end < 2 ? s_.b.radius : s_.a.radius);
    std::vector<WrongNumber> all = {{to_ends, "That measures to the ends of the other segment alone."},
                                    {to_line, "That measures to the whole line, beyond the segment's ends."},
                                    {before, "That was found before. Something is nearer now."},
                                    {to_surface, "That takes off a radius, but *d* is the distance of the segments."}};
    std::erase_if(all, [](const WrongNumber& w) { return std::isinf(w.value) || w.value < 0; });
    return all;
  }

  static std::string said(const End& e) {
    const char* const other = e.end < 2 ? "b" : "a";
    const char* const far = e.sign > 0 ? "farther off than *R*" : e.sign < 0 ? "nearer than *R*" : "exactly *R* away";
    if (e.nearest == Nearest::between)
      return fmt::format("{}: the nearest point lies between the ends of {}, {}.", end_names[e.end], other, far);
    const int nearest = (e.end < 2 ? 2 : 0) + (e.nearest == Nearest::q ? 1 : 0);
    return fmt::format("{}: the nearest point is the end {}, {}.", end_names[e.end], end_names[nearest], far);
  }

  void relation() {
    script_.settle(verdict_kind(s_.truth), relation_words(s_.truth, "the capsules"));
    const bool meet = s_.truth != Relation::disjoint;
    const bool inside = meet && s_.truth != Relation::touching && s_.truth != Relation::overlapping;
    if (meet) script_.refuse(4, {});
    if (meet && !inside) script_.refuse(5, {});
    shown_.settled = true;
    Step& step = add("relation", "How they relate",
                     !meet    ? 4
                     : inside ? 5
                              : 6,
                     end_caption(s_), fmt::format("*d* {} {} = *R*", meet ? compared() : ">", shown(sum())));
    if (inside)
      step.decides = true;               // the balls at the ends decide
    else if ((least_ <= sum()) == meet)  // else rounding hides the difference
      Script::decide(step, {"*d* > *R*", least_, sum(), !meet,
                            !meet                       ? "a gap between them"
                            : is_least() || least_ == 0 ? "they share a point"
                                                        : "they share a point, and the distance may be less still"});
    step.question = relation_question(s_.truth, "the two capsules", because(s_));
    if (std::isfinite(least_)) step.question->given = {{"least *d* so far", least_, "length", Role::highlight}};
  }

  /// The sign between d, which is at most R, and R.
  const char* compared() const {
    const bool all_as_far = is_least() && !crossed_ && !nearer();
    if (sum() == 0 || all_as_far || s_.truth == Relation::touching) return "=";
    return crossed_ || nearer() || s_.truth == Relation::overlapping ? "<" : "≤";
  }

  /// Whether d is the segments' distance: no endpoint was left out.
  bool is_least() const { return crossed_ || shown_.earlier.size() == 4; }

  /// Whether an end comes nearer than R.
  bool nearer() const {
    return std::ranges::any_of(shown_.earlier, [](const End& e) { return e.sign < 0; });
  }

  double sum() const { return s_.a.radius + s_.b.radius; }

  const Setup s_;
  Script script_;
  Shown shown_;
  std::vector<End> ends_;  ///< not shown in a step yet
  bool crossed_ = false;
  double least_ = std::numeric_limits<double>::infinity();
};

}  // namespace

Walk tell(const Setup& setup) { return Teller(setup).tell(); }

}  // namespace isect::lessons::capsule_capsule_lesson
