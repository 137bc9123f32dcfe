// The closed rule: each edge counts with its ends, so a vertex on the ray counts twice.

#include <fmt/format.h>

#include <isect/methods/point_polygon.h>
#include "lessons/crossings/telling.h"
#include "lessons/shared/questions.h"

namespace isect::lessons::crossings_lesson {

using namespace viz;
using C = Counted<double>;

namespace {

class Closed : Teller {
 public:
  explicit Closed(const Setup& setup)
      : Teller(setup, "closed rule (naive)", "Lecture note, point in polygon, read literally",
               {"count ← 0",                                     // 0
                "for each edge a b",                             // 1
                "    if both above or both below p: next edge",  // 2
                "    x ← where a b meets the line of p",         // 3
                "    if not p.x < x: next edge",                 // 4
                "    count ← count + 1",                         // 5
                "if count is odd: return IN",                    // 6
                "return OUT"}) {}                                // 7

  Walk tell() {
    first_step();
    int counted = 0;
    for (const Ring<double, 2>& ring : setup_.polygon.rings) counted += point_polygon::crossings_closed(setup_.p, ring);
    add("rule", "The rule", 1,
        "An edge counts if it has a point on the ray beyond **p**, its ends included.\n"
        "That sounds right, but each vertex belongs to two edges.")
        .question = how_many("Each edge counts with both its ends.", counted);
    give_before(script_.walk(), {"count"});
    tally() = {};
    const std::vector<Ring<double, 2>>& rings = setup_.polygon.rings;
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
    Step& step = add(slug(*known_.edge),
                     along               ? "An edge along the ray"
                     : vertex && e.holds ? "A vertex on the ray"
                     : e.holds           ? "Crossed"
                                         : "Not on the right",
                     along     ? 3
                     : e.holds ? 5
                               : 4,
                     along ? "The formula divides 0 by 0. By IEEE 754 no comparison with the result is true, so the "
                             "edge does not count."
                     : !e.holds ? (e.x.value == setup_.p.x()
                                       ? "The edge meets the line at **p** itself, not right of it: it does not count."
                                       : "The edge meets the line on the left of **p**: it does not count.")
                     : vertex   ? "One end lies on the ray, so the edge counts. " + other_edge(*known_.edge)
                                : "The edge meets the line on the right of **p**: it counts.");
    step.decides = e.holds;
  }

  /// A sentence on what the other edge at the end on the ray does.
  std::string other_edge(const EdgeOf& e) const {
    const int n = static_cast<int>(setup_.polygon.rings[e.ring].size());
    const bool first = ends(setup_, e)[0].y() == setup_.p.y();
    const auto [a, b] = ends(setup_, {e.ring, (e.index + (first ? n - 1 : 1)) % n});
    return a.y() == b.y() ? "The other edge at this end lies along the ray."
                          : "The other edge at this end counts it again.";
  }

  void finish() {
    known_.edge.reset();
    const bool inside = count_ % 2 != 0, boundary = setup_.truth.even_odd == Location::on;
    const bool right = boundary || inside == (setup_.truth.even_odd == Location::in);
    const std::string counted = fmt::format("{} crossing{}: {}, {}", count_, count_ == 1 ? "" : "s",
                                            inside ? "odd" : "even", inside ? "IN" : "OUT");
    script_.settle(boundary          ? Verdict::Kind::on
                   : right && inside ? Verdict::Kind::yes
                                     : Verdict::Kind::no,
                   boundary ? counted + ". In truth ON the boundary"
                   : right  ? counted
                            : counted + ". Wrong: the truth is " + verdict_text(setup_.truth));
    if (!inside) script_.refuse(6, {});
    Step& step = add("verdict", "Odd or even", inside ? 6 : 7, told(boundary, right));
    step.decides = true;
  }

  std::string told(bool boundary, bool right) const {
    const int extra = count_ - setup_.truth.crossings;
    if (boundary) return "The point lies on the boundary. The note's rule, read literally, has no such answer.";
    if (right && extra == 0) return "The answer is right: this count is that of the half-open rule.";
    if (right)
      return fmt::format(
          "The answer is right, but not the count, which should be {}.\n"
          "Its error is even here, so the parity survives.",
          setup_.truth.crossings);
    const std::string why = setup_.vertices_on_ray() > 0 ? "The vertices on the ray make the difference: the half-open "
                                                           "rule gives each of them to one side."
                                                         : "No vertex lies on the ray: rounding makes the difference.";
    return fmt::format("The answer is wrong: there {} {} crossing{}.\n{}", setup_.truth.crossings == 1 ? "is" : "are",
                       setup_.truth.crossings, setup_.truth.crossings == 1 ? "" : "s", why);
  }
};

}  // namespace

Walk closed(const Setup& setup) { return Closed(setup).tell(); }

}  // namespace isect::lessons::crossings_lesson
