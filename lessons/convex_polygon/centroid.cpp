// The note's wedges around the centroid of three vertices.

#include <fmt/format.h>

#include "lessons/convex_polygon/picture.h"
#include "lessons/shared/script.h"

namespace isect::lessons::convex_polygon_lesson {

using namespace viz;
using C = Counted<double>;

namespace {

class Around {
 public:
  explicit Around(const Setup& setup)
      : s_(setup),
        script_({"Note, N23; Preparata and Shamos (1990), 2.2.1",
                 alt_text(setup),
                 {"q ← centroid of v0, v_{n/3}, v_{2n/3}; lo ← 0, hi ← n",    // 0
                  "while hi − lo > 1: if p beyond q v_{(lo+hi)/2}: lo ← it",  // 1
                  "    else: hi ← it",                                        // 2
                  "return p left of v_lo v_hi ? IN : OUT"},                   // 3
                 "wedges around a centroid (naive)"}) {}

  Walk tell() {
    ConvexPolygon<C> polygon;
    for (const Point<double, 2>& v : s_.polygon.vertices) polygon.vertices.push_back(v.cast<C>());
    CountingRecord<point_convex_polygon::NaiveEvent<C>> record;
    tally() = {};
    inside_ = point_convex_polygon::wedge_naive<C>(s_.p.cast<C>(), polygon, record);
    for (const auto& [event, counts] : record.events) {
      script_.count(counts);
      std::visit([&](const auto& e) { say(e); }, event);
    }
    return std::move(script_.walk());
  }

 private:
  Step& add(const std::string& slug, const std::string& title, int line, const std::string& caption) {
    Step& step = script_.add(slug, title, line, caption);
    step.scene = picture(s_, shown_);
    return step;
  }

  void say(const point_convex_polygon::Centroid<C>& e) {
    shown_.apex = {e.q[0].value, e.q[1].value}, shown_.apex_name = "**q**";
    script_.value("*n*", s_.size());
    add("centroid", "A point inside", 0,
        "The centroid of any three vertices lies inside: that is all the preprocessing, O(1).\n"
        "In a sliver it may not: rounded, it leaves a thin polygon.");
  }

  void say(const point_convex_polygon::WedgeAround<C>& e) {
    shown_.lo = e.lo, shown_.hi = e.hi, shown_.mid = e.mid;
    script_.value("*lo*", e.lo);
    script_.value("*hi*", e.hi);
    const bool passed = e.lo == e.mid;
    add(fmt::format("bisect-{}", ++rounds_), passed ? "The later half" : "The earlier half", passed ? 1 : 2,
        passed ? "Seen from **q**, **p** lies beyond **v**_{mid}: the wedges before it are gone."
               : "Seen from **q**, **p** lies before **v**_{mid}: the wedges after it are gone.");
    shown_.mid = -1;
  }

  void say(const point_convex_polygon::EdgeSide<C>& e) {
    shown_.lo = e.from, shown_.hi = e.to == 0 ? s_.size() : e.to, shown_.edge = true;
    const bool right = inside_ == (s_.truth != Location::out);
    script_.value("cross", e.cross.value);
    script_.settle(inside_ ? Verdict::Kind::yes : Verdict::Kind::no,
                   std::string(inside_ ? "IN" : "OUT") + (right ? "" : " (wrong: " + verdict_text(s_.truth) + ")"));
    Step& step = add(
        "verdict", "One edge decides", 3,
        fmt::format("{} bisections for {} vertices, then one edge.", rounds_, s_.size()) +
            (s_.truth == Location::on ? "\nA point on the boundary counts as inside here, if rounding allows." : ""));
    step.decides = true;
    step.question = Question{"Which side of the wedge's edge is **p** on?",
                             {"the inner side", "the outer side"},
                             inside_ ? 0 : 1,
                             "The sign of the last cross product decides."};
  }

  const Setup& s_;
  Script script_;
  Shown shown_;
  int rounds_ = 0;
  bool inside_ = false;
};

}  // namespace

Walk centroid(const Setup& setup) { return Around(setup).tell(); }

}  // namespace isect::lessons::convex_polygon_lesson
