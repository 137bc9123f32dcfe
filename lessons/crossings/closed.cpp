// The closed rule: each edge counts with its ends, so a vertex on the ray counts twice.

#include <fmt/format.h>

#include <isect/point_polygon_methods.h>
#include "lessons/crossings/telling.h"

namespace isect::lessons::crossings_lesson {

using namespace viz;
using C = Counted<double>;

namespace {

class Closed : Teller {
 public:
  explicit Closed(const Setup& setup)
      : Teller(setup, "closed rule (naive)", "Note, N22, read plainly",
               {"count ← 0",                                     // 0
                "for each edge a b",                             // 1
                "    if both above or both below p: next edge",  // 2
                "    x ← where a b meets the line of p",         // 3
                "    if not p.x < x: next edge",                 // 4
                "    count ← count + 1",                         // 5
                "return count odd ? IN : OUT"}) {}               // 6

  Walk tell() {
    first_step(
        "An edge counts if it has a point on the ray, its ends included.\n"
        "That sounds right, but each vertex belongs to two edges.");
    tally() = {};
    const std::vector<Ring<double, 2>>& rings = setup_.situation.polygon.rings;
    for (int r = 0; r < static_cast<int>(rings.size()); ++r) {
      Ring<C, 2> ring;
      for (const Point<double, 2>& v : rings[r]) ring.push_back(v.cast<C>());
      CountingRecord<point_polygon::ClosedEvent<C>> record;
      point_polygon::crossings_closed<C>(setup_.p.cast<C>(), ring, record);
      for (const auto& [event, counts] : record.events) {
        script_.count(counts);
        std::visit([&](const auto& e) { say(r, e); }, event);
      }
    }
    finish();
    return std::move(script_.walk());
  }

 private:
  void say(int ring, const point_polygon::Reaches& e) {
    if (e.holds) return;
    known_.edge = EdgeOf{ring, e.index};
    add(slug(*known_.edge), "Another height", 2, "The edge has no point at the height of **p**.");
  }

  void say(int ring, const point_polygon::CrossesAt<C>& e) {
    known_.edge = EdgeOf{ring, e.index};
    const auto [a, b] = ends(setup_, *known_.edge);
    const bool along = a.y() == b.y(), vertex = a.y() == setup_.p.y() || b.y() == setup_.p.y();
    if (e.holds) meet(*known_.edge, true);
    Step& step =
        add(slug(*known_.edge),
            along    ? "An edge along the ray"
            : vertex ? "A vertex on the ray"
                     : "Crossed",
            along     ? 3
            : e.holds ? 5
                      : 4,
            along      ? "The formula divides 0 by 0. NaN compares as false, so nothing is counted, by luck."
            : !e.holds ? "The edge meets the line on the left of **p**: it does not count."
            : vertex   ? "Its end lies on the ray, so it counts. The next edge has the same end, and counts again."
                       : "The edge meets the line on the right of **p**: it counts.");
    step.decides = e.holds;
  }

  void finish() {
    known_.edge.reset();
    const bool inside = count_ % 2 != 0, boundary = setup_.truth.even_odd == Location::on;
    const bool right = !boundary && inside == (setup_.truth.even_odd == Location::in);
    const std::string counted = fmt::format("{} crossing{}: {}, {}", count_, count_ == 1 ? "" : "s",
                                            inside ? "odd" : "even", inside ? "IN" : "OUT");
    const Verdict::Kind kind = !right ? Verdict::Kind::no : inside ? Verdict::Kind::yes : Verdict::Kind::no;
    script_.settle(kind, right ? counted : counted + ". Wrong: " + verdict_text(setup_.truth));
    Step& step = add("verdict", "Odd or even", 6,
                     boundary ? "The point lies on the boundary, and this rule cannot say so."
                     : right  ? "The answer is right this time: no vertex was counted once too often."
                              : "The answer is wrong: a vertex on the ray was counted once too often.\n"
                                "The half-open rule gives each vertex to one side.");
    step.decides = true;
    step.question = Question{"Is the closed rule right here?",
                             {"yes", "no"},
                             right ? 0 : 1,
                             "The exact test says: " + verdict_text(setup_.truth) + "."};
  }
};

}  // namespace

Walk closed(const Setup& setup) { return Closed(setup).tell(); }

}  // namespace isect::lessons::crossings_lesson
