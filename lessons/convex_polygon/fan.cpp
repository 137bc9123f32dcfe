// The fan from vertex 0, as the core runs it.

#include <fmt/format.h>

#include <bit>
#include <cmath>

#include "lessons/convex_polygon/picture.h"
#include "lessons/shared/digits.h"
#include "lessons/shared/line_question.h"
#include "lessons/shared/questions.h"
#include "lessons/shared/script.h"

namespace isect::lessons::convex_polygon_lesson {

using namespace viz;

namespace {

class Fan {
 public:
  explicit Fan(const Setup& setup)
      : s_(setup),
        script_({"Lecture note, convex polygons; Preparata and Shamos, Computational Geometry (1985), 2.2.1",
                 alt_text(setup),
                 {"lo ← 1, hi ← n − 1",                                                  // 0
                  "if p right of v0 v1, or left of v0 v_hi",                             // 1
                  "    return OUT",                                                      // 2
                  "while hi − lo > 1 and p not in triangle v0 v_lo v_hi",                // 3
                  "    mid ← (lo + hi) / 2; p right of v0 v_mid ? hi ← mid : lo ← mid",  // 4
                  "    if p right of v_mid v_{mid+1}: return OUT",                       // 5
                  "if p right of v_lo v_hi: return OUT",                                 // 6
                  "return p on an edge ? ON : IN"},                                      // 7
                 "fan from a vertex"}) {
    shown_.apex = setup.vertex(0), shown_.apex_name = "**v**_0";
  }

  Walk tell() {
    using namespace point_convex_polygon;
    script_.value("*n*", s_.size());
    add("fan", "A fan of wedges", 0,
        "Rays from **v**_0 through the other vertices split the polygon into wedges." +
            std::string(s_.size() > most_rays ? " Some of them are drawn." : "") +
            "\nCounter-clockwise, **p** lies first to the left, then to the right of these rays: bisection finds "
            "where.",
        "left of **v**_0 **v**_{*i*}  if  (**v**_{*i*} − **v**_0) × (**p** − **v**_0) > 0");
    Record<Event> record;
    locate(s_.p, s_.polygon, record);
    std::erase_if(record.events, [](const Event& e) { return std::holds_alternative<Fallback>(e); });
    for (std::size_t i = 0; i < record.events.size(); ++i) {
      if (const auto* fan = std::get_if<point_convex_polygon::Fan>(&record.events[i])) say(*fan);
      if (const auto* wedge = std::get_if<Wedge>(&record.events[i])) say(*wedge, record.events, i);
      if (const auto* chord = std::get_if<Chord>(&record.events[i])) turns_ += 1, last_ = *chord;
    }
    finish();
    return std::move(script_.walk());
  }

 private:
  Step& add(const std::string& slug, const std::string& title, int line, const std::string& caption,
            const std::string& formula = {}) {
    script_.value("orientations", turns_);
    Step& step = script_.add(slug, title, line, caption, formula);
    step.scene = picture(s_, shown_);
    return step;
  }

  void say(const point_convex_polygon::Fan& e) {
    turns_ = 2;
    shown_.lo = 1, shown_.hi = s_.size() - 1;
    left_ = e.first < 0 || e.last > 0;
    Step& step = add("within", "Within the fan?", 1,
                     left_ ? "**p** lies outside one of the two edges at **v**_0, so outside the polygon."
                           : "**p** lies beyond neither edge at **v**_0: if the polygon contains it, some wedge does.");
    step.decides = true;
    step.question = which_count("How many bisections can it take at most to find the wedge?", bisections(s_.size()),
                                {{s_.size() - 2.0, "That looks at every wedge, one by one."},
                                 {std::floor(s_.size() / 2.0), "That looks at half of the wedges, one by one."}},
                                "Each halves the wedges, *n* − 2 at first: lg (*n* − 2), rounded up.");
    if (left_) script_.leave_early();
    if (!left_) script_.refuse(1, {2});
  }

  /// A bisection with the turn of the edge after mid, which is the next event.
  void say(const point_convex_polygon::Wedge& e, const std::vector<point_convex_polygon::Event>& events,
           std::size_t i) {
    shown_.edge = rounds_ == 0;
    if (rounds_ == 0)
      add("wide", "Not in the widest triangle", 3,
          last_.turn == 0
              ? "**p** lies on the line of the highlighted edge, not on its inner side. Halve the fan."
              : "**p** lies beyond the highlighted edge, so the widest triangle does not contain it. Halve the "
                "fan.");
    shown_.edge = false;
    turns_ += 1;
    ++rounds_;
    const auto* edge = i + 1 < events.size() ? std::get_if<point_convex_polygon::Chord>(&events[i + 1]) : nullptr;
    const bool out = edge != nullptr && edge->turn < 0;
    shown_.mid = e.mid;
    const Scene over = picture(s_, shown_);
    shown_.lo = e.lo, shown_.hi = e.hi;
    script_.value("*lo*", e.lo);
    script_.value("*hi*", e.hi);
    const std::string mid = fmt::format("**v**_{{{}}}", e.mid);
    Step& step = add(fmt::format("bisect-{}", rounds_),
                     e.turn >= 0 ? "The wedges after " + mid : "The wedges before " + mid, out ? 5 : 4,
                     out ? "**p** lies beyond the edge after " + mid +
                               ". The whole polygon lies on its inner side, so **p** is outside."
                     : e.turn > 0  ? "**p** lies left of the ray through " + mid + ": drop the wedges before it."
                     : e.turn == 0 ? "**p** lies on the ray through " + mid +
                                         ". The wedges on both sides give the same verdict: drop those before it."
                                   : "**p** lies right of the ray through " + mid + ": drop the wedges after it.");
    if (rounds_ == 1) {
      step.question = {fmt::format("**p** = {} and **v**_0 = {}. The fan is halved at {} = {}, and the edge there ends "
                                   "at {}. What follows?",
                                   coordinates(s_.p), coordinates(s_.vertex(0)), mid, corner(e.mid), corner(e.mid + 1)),
                       {"go on with the wedges before it", "go on with the wedges after it",
                        "return OUT: **p** is beyond the edge that follows it"},
                       out           ? 2
                       : e.turn >= 0 ? 1
                                     : 0,
                       "The orientation of **v**_0, " + mid + ", **p** decides the side; that of the edge rejects."};
      step.question->over = over;
    }
    shown_.mid = -1;
    left_ = left_ || out;
  }

  /// A vertex; neighbours among many differ in their last digits.
  std::string corner(int k) const {
    const Point<double, 2>& v = s_.vertex(k);
    return s_.size() > most_rays ? with_minus_signs(fmt::format("({}, {})", to_text(v.x()), to_text(v.y())))
                                 : coordinates(v);
  }

  void finish() {
    const bool on = s_.truth == Location::on, in = s_.truth == Location::in;
    const bool wide = in && shown_.hi - shown_.lo > 1;  // the triangle of several wedges was enough
    shown_.on = on;
    shown_.edge = !left_;
    script_.settle(verdict_kind(s_.truth), verdict_text(s_.truth));
    if (wide) script_.leave_early();
    Step& step =
        add("verdict",
            left_  ? "Rejected early"
            : wide ? "Inside, early"
                   : "The last edge",
            left_      ? (rounds_ == 0 ? 2 : 5)
            : in || on ? 7
                       : 6,
            (left_  ? (rounds_ == 0 ? "Two orientations reject **p**." : "One edge was enough to reject **p**.")
             : wide ? "A triangle across several wedges contains **p** and lies in the polygon: the search can stop."
             : on   ? "One of these orientations is exactly zero: **p** lies on the boundary."
             : in   ? "**p** lies on the inner side of the last edge."
                    : "**p** lies beyond the last edge.") +
                fmt::format("\nThat took {} orientations. It never takes more than {}.", turns_,
                            3 + 3 * bisections(s_.size())),
            "3 + 3 ⌈lg (*n* − 2)⌉ = " + shown(3 + 3 * bisections(s_.size())));
    step.decides = true;
    if (left_) return;  // then the answer is known
    ask_for_line(script_.walk(),
                 fmt::format("**p** = {}. The wedges that are left reach from {} to {}. Which line returns the answer?",
                             coordinates(s_.p), corner(shown_.lo), corner(shown_.hi)),
                 {{2, "**p** lies within the fan."},
                  {5, "That line tests an edge while the fan is halved."},
                  {6, "From the first to the second, **p** does not lie on the right."},
                  {7, "From the first to the second, **p** lies on the right: outside."}},
                 in || on ? "From the first to the second, **p** does not lie on the right."
                          : "From the first to the second, **p** lies on the right.");
    keep_picture(script_.walk());
  }

  /// lg (n - 2), rounded up.
  static int bisections(int n) { return std::bit_width(static_cast<unsigned>(n) - 3); }

  const Setup& s_;
  Script script_;
  Shown shown_;
  point_convex_polygon::Chord last_ = {};
  int turns_ = 0, rounds_ = 0;
  bool left_ = false;  ///< rejected early
};

}  // namespace

Walk fan(const Setup& setup) { return Fan(setup).tell(); }

}  // namespace isect::lessons::convex_polygon_lesson
