// The fan from vertex 0, as the core runs it.

#include <fmt/format.h>

#include "lessons/convex_polygon/picture.h"
#include "lessons/shared/script.h"

namespace isect::lessons::convex_polygon_lesson {

using namespace viz;

namespace {

class Fan {
 public:
  explicit Fan(const Setup& setup)
      : s_(setup),
        script_({"Note, N23; Preparata and Shamos (1990), 2.2.1",
                 alt_text(setup),
                 {"lo ← 1, hi ← n − 1",                                     // 0
                  "if p right of v0 v1, or left of v0 v_hi: return OUT",    // 1
                  "while hi − lo > 1 and p not in triangle v0 v_lo v_hi",   // 2
                  "    if p left of v0 v_{(lo+hi)/2}: lo ← (lo + hi) / 2",  // 3
                  "    else: hi ← (lo + hi) / 2",                           // 4
                  "    if p right of the edge after that: return OUT",      // 5
                  "if p right of v_lo v_hi: return OUT",                    // 6
                  "return p on an edge ? ON : IN"},                         // 7
                 "fan from a vertex"}) {
    shown_.apex = setup.vertex(0), shown_.apex_name = "**v**_0";
  }

  Walk tell() {
    using namespace point_convex_polygon;
    script_.value("*n*", s_.size());
    add("fan", "A fan of wedges", 0,
        "Rays from **v**_0 through the other vertices cut the polygon into wedges.\n"
        "The vertices stand in order in an array: no preprocessing but, once, O(*n*) to check convexity.");
    Record<Event> record;
    locate(s_.p, s_.polygon, record);
    for (std::size_t i = 0; i < record.events.size(); ++i) {
      if (const auto* fan = std::get_if<point_convex_polygon::Fan>(&record.events[i])) say(*fan);
      if (const auto* wedge = std::get_if<Wedge>(&record.events[i])) say(*wedge, record.events, i);
      if (const auto* chord = std::get_if<Chord>(&record.events[i])) turns_ += 1, last_ = *chord;
    }
    finish();
    return std::move(script_.walk());
  }

 private:
  Step& add(const std::string& slug, const std::string& title, int line, const std::string& caption) {
    script_.value("orientations", turns_);
    Step& step = script_.add(slug, title, line, caption);
    step.scene = picture(s_, shown_);
    return step;
  }

  void say(const point_convex_polygon::Fan& e) {
    turns_ = 2;
    shown_.lo = 1, shown_.hi = s_.size() - 1;
    left_ = e.first < 0 || e.last > 0;
    Step& step = add("within", "Within the fan?", 1,
                     left_ ? "**p** lies outside one of the two edges at **v**_0, so outside of all."
                           : "**p** lies on the inner side of both edges at **v**_0: some wedge holds it.");
    step.decides = true;
    step.question = Question{
        "Does some wedge hold **p**?", {"yes", "no"}, left_ ? 1 : 0, "The two edges at **v**_0 bound the fan."};
    if (left_) script_.leave_early();
  }

  /// A bisection with the turn of the edge after mid, which is the next event.
  void say(const point_convex_polygon::Wedge& e, const std::vector<point_convex_polygon::Event>& events,
           std::size_t i) {
    shown_.edge = rounds_ == 0;
    if (rounds_ == 0)
      add("wide", "Not in the widest triangle", 2,
          "**p** lies beyond **v**_{lo} **v**_{hi}, so no wide triangle settles it. Halve the fan.");
    shown_.edge = false;
    turns_ += 1;
    ++rounds_;
    const auto* edge = i + 1 < events.size() ? std::get_if<point_convex_polygon::Chord>(&events[i + 1]) : nullptr;
    const bool out = edge != nullptr && edge->turn < 0;
    shown_.mid = e.mid;
    const int line = out ? 5 : e.turn >= 0 ? 3 : 4;
    shown_.lo = e.lo, shown_.hi = e.hi;
    script_.value("*lo*", e.lo);
    script_.value("*hi*", e.hi);
    add(fmt::format("bisect-{}", rounds_), e.turn >= 0 ? "The upper half" : "The lower half", line,
        out           ? "**p** lies beyond the edge after **v**_{mid}. The polygon lies on the inner side of each "
                        "edge: outside."
        : e.turn >= 0 ? "**p** lies left of the ray through **v**_{mid}: the wedges before it are gone."
                      : "**p** lies right of the ray through **v**_{mid}: the wedges after it are gone.");
    shown_.mid = -1;
    left_ = left_ || out;
  }

  void finish() {
    const bool on = s_.truth == Location::on;
    shown_.on = on;
    shown_.edge = !left_;
    script_.settle(s_.truth == Location::in ? Verdict::Kind::yes
                   : on                     ? Verdict::Kind::on
                                            : Verdict::Kind::no,
                   verdict_text(s_.truth));
    const std::string cost = fmt::format("\n{} orientation{} for {} vertices: the cost grows as lg *n*.", turns_,
                                         turns_ == 1 ? "" : "s", s_.size());
    Step& step = add("verdict", "The last edge",
                     s_.truth == Location::out && !left_ ? 6
                     : left_                             ? (rounds_ == 0 ? 1 : 5)
                                                         : 7,
                     (left_ ? "One edge was enough to reject."
                      : s_.truth == Location::in && s_.size() - 2 > shown_.hi - shown_.lo && shown_.hi - shown_.lo > 1
                          ? "**p** lies in the triangle of a wider wedge already, so in the polygon."
                      : on                       ? "The last orientation is exactly zero: **p** lies on the boundary."
                      : s_.truth == Location::in ? "**p** lies on the inner side of the last edge."
                                                 : "**p** lies beyond the last edge.") +
                         cost);
    step.decides = true;
    step.question = Question{"Where does **p** lie?",
                             {"inside", "on the boundary", "outside"},
                             static_cast<int>(s_.truth),
                             "The exact orientations decide."};
  }

  const Setup& s_;
  Script script_;
  Shown shown_;
  point_convex_polygon::Chord last_ = {};
  int turns_ = 0, rounds_ = 0;
  bool left_ = false;  ///< rejected before the last edge
};

}  // namespace

Walk fan(const Setup& setup) { return Fan(setup).tell(); }

}  // namespace isect::lessons::convex_polygon_lesson
