#include "lessons/crossings/rules.h"

#include <span>

#include "core/point_polygon_methods.h"
#include "lessons/crossings/picture.h"
#include "lessons/script.h"

namespace isect::lessons::crossings_lesson {

using namespace viz;
using C = Counted<double>;

namespace {

/// What both rules share: the first step, the last one, and the state between them.
class Teller {
 protected:
  Teller(const Setup& setup, const std::string& title, const std::string& source,
         std::vector<std::string> lines)
      : setup_(setup), script_({source, alt_text(setup), std::move(lines), title}) {}

  Step& add(const std::string& slug, const std::string& title, int line, const std::string& caption) {
    Step& step = script_.add(slug, title, line, caption);
    step.scene = picture(setup_, known_);
    return step;
  }

  void first_step(const std::string& rule) {
    script_.value("count", 0, {}, Role::hit);
    add("ray", "A ray to the right", 0,
        std::string(
            "Count the edges that it crosses: an odd number means inside (Jordan's curve theorem).\n") +
            setup_.situation.note);
    add("rule", "The rule", 1, rule);
  }

  /// "edge-3", counted over all rings.
  std::string slug(const EdgeOf& e) const {
    int number = e.index + 1;
    for (int r = 0; r < e.ring; ++r)
      number += static_cast<int>(setup_.situation.polygon.rings[static_cast<std::size_t>(r)].size());
    return "edge-" + std::to_string(number);
  }

  void meet(const EdgeOf& e, bool counts) {
    if (counts) ++count_;
    known_.meetings.push_back({meeting(setup_, e), counts ? count_ : 0});
    if (counts) script_.value("count", count_, {}, Role::hit);
  }

  /// "Does this edge count?", asked the first time that a case needs thought.
  void ask(Step& step, bool counts, const std::string& because) {
    if (asked_) return;
    asked_ = true;
    step.question = Question{"Does the edge **a** **b** count?", {"yes", "no"}, counts ? 0 : 1, because};
  }

  Question where_question() const {
    const int answer = static_cast<int>(setup_.truth.even_odd);
    return {"Where does **p** lie, by the even-odd rule?",
            {"inside", "on the boundary", "outside"},
            answer,
            answer == 1 ? "An edge holds the point." : "The true count of crossings decides."};
  }

  const Setup& setup_;
  Script script_;
  Known known_;
  int count_ = 0;

 private:
  bool asked_ = false;
};

class HalfOpen : Teller {
 public:
  explicit HalfOpen(const Setup& setup)
      : Teller(setup, "half-open rule", "Note, N22; Franklin's PNPOLY (1970)",
               {"count ← 0",                                          // 0
                "for each edge a b",                                  // 1
                "    if p = a, or p on a horizontal a b: return ON",  // 2
                "    if a and b both above p: next edge",             // 3
                "    if neither is above p: next edge",               // 4
                "    if p on a b: return ON",                         // 5
                "    if p right of a b, seen upwards: next edge",     // 6
                "    count ← count + 1",                              // 7
                "return count odd ? IN : OUT"}) {}                    // 8

  Walk tell() {
    using point_polygon::Edge;
    first_step(
        "A vertex at the height of **p** counts as below it.\n"
        "So each vertex is on one side, and each edge crosses or does not.");
    tally() = {};
    const std::vector<Ring<double, 2>>& rings = setup_.situation.polygon.rings;
    for (int r = 0; r < static_cast<int>(rings.size()) && !known_.on; ++r) {
      CountingRecord<point_polygon::Event> record;
      run(rings[static_cast<std::size_t>(r)], r, record);
      for (const auto& [event, counts] : record.events) {
        script_.count(counts);
        if (const Edge* edge = std::get_if<Edge>(&event)) say(*edge);
      }
    }
    if (!known_.on) finish();
    return std::move(script_.walk());
  }

 private:
  /// The core's walk along a ring; its three predicates count their operations, and the orientation's sign is exact.
  void run(const Ring<double, 2>& ring, int number, CountingRecord<point_polygon::Event>& record) const {
    const Point<double, 2>& p = setup_.p;
    const auto sign = [](const C& x, const C& y) { return (x > y) - (x < y); };
    const auto height = [&](const Point<double, 2>& v) { return sign(v.y(), p.y()); };
    const auto abscissa = [&](const Point<double, 2>& v) { return sign(v.x(), p.x()); };
    const auto side = [&](const Point<double, 2>& a, const Point<double, 2>& b) {
      const C area2 =
          (C(a.x()) - C(p.x())) * (C(b.y()) - C(p.y())) - (C(a.y()) - C(p.y())) * (C(b.x()) - C(p.x()));
      (void)(area2 > C(0)), (void)(area2 < C(0));
      return orient2d(a, b, p);
    };
    point_polygon::wind(std::span<const Point<double, 2>>(ring), height, abscissa, side, number, record);
  }

  void say(const point_polygon::Edge& e) {
    using point_polygon::Passage;
    const EdgeOf edge = {e.ring, e.index};
    known_.edge = edge;
    const auto [a, b] = ends(setup_, edge);
    const double y = setup_.p.y();
    switch (e.passage) {
      case Passage::above:
        add(slug(edge), "Both ends above", 3, "Both ends lie above **p**: the ray cannot cross this edge.");
        return;
      case Passage::below:
        return below(edge, a.y() == y || b.y() == y);
      case Passage::horizontal: {
        known_.along.push_back(edge);
        Step& step =
            add(slug(edge), "An edge along the ray", 4,
                "Neither end lies above **p**: an edge along the line never counts. Its neighbours decide.");
        ask(step, false, "Both ends count as below, so it has no side to cross to.");
        return;
      }
      case Passage::crossed_left:
        add(slug(edge), "Crossed on the left", 6,
            "The edge crosses the line, but **p** lies on its right: the ray starts beyond it.");
        return;
      case Passage::crossed_right:
        return right(edge, a.y() == y || b.y() == y);
      case Passage::on:
        return on(edge, e.turn == 0 && (a == setup_.p || (a.y() == y && b.y() == y)) ? 2 : 5);
    }
  }

  void below(const EdgeOf& edge, bool touches) {
    if (!touches) {
      add(slug(edge), "Both ends below", 4, "Neither end lies above **p**: the ray cannot cross this edge.");
      return;
    }
    if (meeting(setup_, edge).x() > setup_.p.x()) meet(edge, false);
    Step& step = add(slug(edge), "An end on the line", 4,
                     "One end lies at the height of **p** and counts as below. So this edge does not cross.");
    ask(step, false, "A vertex on the line counts as below it: both ends lie on the same side.");
  }

  void right(const EdgeOf& edge, bool vertex) {
    meet(edge, true);
    Step& step =
        add(slug(edge), vertex ? "A vertex on the ray" : "Crossed on the right", 7,
            vertex ? "The end on the ray counts as below, the other lies above: the edge crosses, once."
                   : "The edge crosses the line, and **p** lies on its left: it counts.");
    step.decides = true;
    ask(step, true,
        vertex ? "A vertex on the line counts as below it; the other end lies above."
               : "Its ends lie on both sides, and **p** on its left.");
  }

  void on(const EdgeOf&, int line) {
    known_.on = true;
    script_.settle(Verdict::Kind::on, verdict_text(setup_.truth));
    script_.leave_early();
    Step& step =
        add("on", "On the boundary", line,
            line == 2 ? "**p** is an end of this edge, or lies between them at the same height.\n"
                        "Neither inside nor outside: counting would give either, by chance."
                      : "The orientation of **a**, **b**, **p** is exactly zero: the edge holds the point.\n"
                        "Neither inside nor outside: counting would give either, by chance.");
    step.decides = true;
    step.question = where_question();
  }

  void finish() {
    known_.edge.reset();
    const Winding& truth = setup_.truth;
    const bool differs = truth.nonzero != truth.even_odd;
    script_.settle(truth.even_odd == Location::in ? Verdict::Kind::yes : Verdict::Kind::no,
                   verdict_text(truth));
    script_.value("winding", truth.winding);
    Step& step = add("verdict", "Odd or even", 8,
                     std::string(count_ % 2 != 0 ? "The count is odd: **p** lies inside."
                                                 : "The count is even: **p** lies outside.") +
                         (differs ? "\nThe other rule asks how often the boundary goes around. Here that is "
                                    "not 0, so **p** is inside."
                                  : "\nEach edge was looked at once: the cost grows as n."));
    step.decides = true;
    step.question = where_question();
  }
};

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
      for (const Point<double, 2>& v : rings[static_cast<std::size_t>(r)]) ring.push_back(v.cast<C>());
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
    Step& step = add(
        slug(*known_.edge),
        along    ? "An edge along the ray"
        : vertex ? "A vertex on the ray"
                 : "Crossed",
        along     ? 3
        : e.holds ? 5
                  : 4,
        along      ? "The formula divides 0 by 0. NaN compares as false, so nothing is counted, by luck."
        : !e.holds ? "The edge meets the line on the left of **p**: it does not count."
        : vertex ? "Its end lies on the ray, so it counts. The next edge has the same end, and counts again."
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

Walk half_open(const Setup& setup) { return HalfOpen(setup).tell(); }
Walk closed(const Setup& setup) { return Closed(setup).tell(); }

}  // namespace isect::lessons::crossings_lesson
