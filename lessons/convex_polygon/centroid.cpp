// The note's wedges around the centroid of three vertices.

#include <fmt/format.h>

#include <isect/methods/point_convex_polygon.h>

#include "lessons/convex_polygon/picture.h"
#include "lessons/shared/plural.h"
#include "lessons/shared/questions.h"
#include "lessons/shared/script.h"

namespace isect::lessons::convex_polygon_lesson {

using namespace viz;
using C = Counted<double>;

namespace {

class Around {
 public:
  explicit Around(const Setup& setup)
      : s_(setup),
        script_({"Lecture note, convex polygons; Preparata and Shamos, Computational Geometry (1985), 2.2.1",
                 alt_text(setup),
                 {"q ← centroid of v0, v_{n/3}, v_{2n/3}; lo ← 0, hi ← n",    // 0
                  "while hi − lo > 1: if p beyond q v_{(lo+hi)/2}: lo ← it",  // 1
                  "    else: hi ← it",                                        // 2
                  "if p not right of v_lo v_hi: return IN",                   // 3
                  "return OUT"},                                              // 4
                 "wedges around a centroid (naive)"}) {}

  Walk tell() {
    ConvexPolygon<C> polygon;
    for (const Point<double, 2>& v : s_.polygon.vertices) polygon.vertices.push_back(v.cast<C>());
    CountingRecord<point_convex_polygon::NaiveEvent<C>> record;
    tally() = {};
    inside_ = point_convex_polygon::wedge_naive<C>(s_.p.cast<C>(), polygon, record);
    for (const auto& [event, _] : record.events)
      bisections_ += std::holds_alternative<point_convex_polygon::WedgeAround<C>>(event);
    for (const auto& [event, counts] : record.events) {
      script_.count(counts);
      std::visit([&](const auto& e) { say(e); }, event);
    }
    return std::move(script_.walk());
  }

 private:
  Step& add(const std::string& slug, const std::string& title, int line, const std::string& caption,
            const std::string& formula = {}) {
    Step& step = script_.add(slug, title, line, caption, formula);
    step.scene = picture(s_, shown_);
    return step;
  }

  void say(const point_convex_polygon::Centroid<C>& e) {
    shown_.apex = {e.q[0].value, e.q[1].value}, shown_.apex_name = "**q**";
    script_.value("*n*", s_.size());
    add("centroid", "A point inside", 0,
        "The centroid of three vertices not on one line lies inside: all the preprocessing, O(1). A **p** there is "
        "inside, at once. In a very thin polygon the rounded centroid may fall outside.\n"
        "Angles around **q**, polar coordinates, would order **p** and the vertices **v**. Cross products do so "
        "without an arctangent.\n"
        "One sign orders directions within half a turn alone. So first find on which side of the line from **q** "
        "through **v**_0 both lie: the left side comes first.",
        "on one side of a line through **q**, **v** comes before **p**  if  (**v** − **q**) × (**p** − **q**) > 0");
  }

  void say(const point_convex_polygon::WedgeAround<C>& e) {
    shown_.lo = e.lo, shown_.hi = e.hi, shown_.mid = e.mid;
    script_.value("*lo*", e.lo);
    script_.value("*hi*", e.hi);
    const bool passed = e.lo == e.mid;
    const std::string mid = fmt::format("**v**_{{{}}}", e.mid);
    Step& step =
        add(fmt::format("bisect-{}", ++rounds_), (passed ? "Not before " : "Before ") + mid, passed ? 1 : 2,
            passed ? "Counter-clockwise from **v**_0, **p** comes at " + mid + " or later: drop the wedges before it."
                   : "Counter-clockwise from **v**_0, **p** comes before " + mid + ": drop the wedges after it.");
    if (rounds_ == 1) {
      step.question = which_count(
          "How many bisections single out one wedge?", bisections_,
          {{1.0 * s_.size(), "That looks at every wedge, one by one."},
           {s_.size() > 5 ? s_.size() / 2.0 : 1.0, s_.size() > 5 ? "That looks at half of the wedges, one by one."
                                                                 : "One bisection leaves more than one wedge."}},
          "Each halves the number of wedges: lg *n*, up to rounding.");
      keep_picture(script_.walk());
    }
    shown_.mid = -1;
  }

  void say(const point_convex_polygon::EdgeSide<C>& e) {
    shown_.lo = e.from, shown_.hi = e.to == 0 ? s_.size() : e.to, shown_.edge = true;
    const bool on = s_.truth == Location::on, right = on || inside_ == (s_.truth == Location::in);
    script_.value("cross product", e.cross.value);
    script_.settle(on        ? Verdict::Kind::on
                   : inside_ ? Verdict::Kind::yes
                             : Verdict::Kind::no,
                   std::string(inside_ ? "IN" : "OUT") + (on      ? ", in truth " + verdict_text(s_.truth)
                                                          : right ? ""
                                                                  : " (wrong: " + verdict_text(s_.truth) + ")"));
    if (!inside_) script_.refuse(3, {});
    const char* const side = e.cross.value > 0   ? "on its inner side"
                             : e.cross.value < 0 ? "on its outer side"
                                                 : "on its line";
    Step& step = add("verdict", "One edge decides", inside_ ? 3 : 4,
                     fmt::format("{} bisections for {} vertices, then one edge: the cross product puts **p** {}.",
                                 rounds_, counted(static_cast<long long>(s_.size())), side) +
                         (on ? "\nThe note's method has no answer for the boundary: rounding decides there." : ""));
    step.decides = true;
  }

  const Setup& s_;
  Script script_;
  Shown shown_;
  int rounds_ = 0, bisections_ = 0;
  bool inside_ = false;
};

}  // namespace

Walk centroid(const Setup& setup) { return Around(setup).tell(); }

}  // namespace isect::lessons::convex_polygon_lesson
