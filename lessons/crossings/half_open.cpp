// The half-open rule: a vertex at the height of the point counts as below it, so each edge crosses or does not.

#include <span>

#include <isect/orient.h>
#include <isect/point_polygon.h>
#include "lessons/crossings/telling.h"
#include "lessons/shared/questions.h"

namespace isect::lessons::crossings_lesson {

using namespace viz;
using C = Counted<double>;

namespace {

class HalfOpen : Teller {
 public:
  explicit HalfOpen(const Setup& setup)
      : Teller(setup, "half-open rule", "Lecture note, point in polygon; Franklin, PNPOLY (1970)",
               {"count ← 0",                                          // 0
                "for each edge a b",                                  // 1
                "    if p = a, or p on a horizontal a b: return ON",  // 2
                "    if a and b both above p: next edge",             // 3
                "    if neither is above p: next edge",               // 4
                "    if p on a b: return ON",                         // 5
                "    if p right of a b, seen upwards: next edge",     // 6
                "    count ← count + 1",                              // 7
                "if count is odd: return IN",                         // 8
                "return OUT"}) {}                                     // 9

  Walk tell() {
    using point_polygon::Edge;
    first_step();
    tell_rule();
    tally() = {};
    const std::vector<Ring<double, 2>>& rings = setup_.polygon.rings;
    for (int r = 0; r < static_cast<int>(rings.size()) && !known_.on; ++r) {
      CountingRecord<point_polygon::Event> record;
      run(rings[r], r, record);
      for (const auto& [event, counts] : record.events) {
        script_.count(counts);
        if (const Edge* edge = std::get_if<Edge>(&event)) say(*edge);
      }
    }
    if (!known_.on) finish();
    return std::move(script_.walk());
  }

 private:
  void tell_rule() {
    known_.raised = true;
    Step& step =
        add("rule", "The half-open rule", 1,
            "An edge from **a** to **b** counts only if just one of its ends is above **p**. A vertex at the height of "
            "**p** counts as below it.\n"
            "It does lie below the same ray raised by a tiny *ε* (dashed). That ray meets no vertex, only interiors of "
            "edges.",
            "counts only if  (*a*_y > *p*_y) ≠ (*b*_y > *p*_y)");
    known_.raised = false;
    if (setup_.truth.even_odd == Location::on) return;
    step.question = how_many("A vertex on the ray counts as below it.", setup_.truth.crossings);
    step.question->over = picture(setup_, known_);  // the raised ray would give the answer away
    give_before(script_.walk(), {"count"});
  }

  /// The core's walk along a ring; its three predicates count their operations, and the orientation's sign is exact.
  void run(const Ring<double, 2>& ring, int number, CountingRecord<point_polygon::Event>& record) const {
    const Point<double, 2>& p = setup_.p;
    const auto sign = [](const C& x, const C& y) { return (x > y) - (x < y); };
    const auto height = [&](const Point<double, 2>& v) { return sign(v.y(), p.y()); };
    const auto across = [&](const Point<double, 2>& v) { return sign(v.x(), p.x()); };
    const auto side = [&](const Point<double, 2>& a, const Point<double, 2>& b) {
      const C area2 = (C(a.x()) - C(p.x())) * (C(b.y()) - C(p.y())) - (C(a.y()) - C(p.y())) * (C(b.x()) - C(p.x()));
      (void)(area2 > C(0)), (void)(area2 < C(0));
      return orient2d(a, b, p);
    };
    point_polygon::wind(std::span<const Point<double, 2>>(ring), height, across, side, number, record);
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
        add(slug(edge), "Along the ray", 4,
            "Neither end lies above **p**: an edge along the line never counts. Its neighbours decide.");
        ask(edge,
            {{3, "Neither end lies above **p**."},
             {6, "Both ends lie on one side, so it is not asked where **p** lies."},
             {7, "Both ends count as below, so the edge does not cross."}},
            "Both ends count as below, so it has no side to cross to.");
        return;
      }
      case Passage::crossed_left:
        add(slug(edge), "Crossed on the left", 6,
            "The edge crosses the line on the left of **p**: the ray starts beyond it.");
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
    add(slug(edge), "An end on the line", 4,
        "One end lies at the height of **p** and counts as below. So this edge does not cross.");
    ask(edge,
        {{3, "Neither end lies above **p**."},
         {6, "Both ends lie on one side, so it is not asked where **p** lies."},
         {7, "The end at the height of **p** counts as below, like the other end."}},
        "A vertex on the line counts as below it: both ends lie on the same side.");
  }

  void right(const EdgeOf& edge, bool vertex) {
    meet(edge, true);
    Step& step = add(slug(edge), vertex ? "A vertex on the ray" : "Crossed on the right", 7,
                     vertex ? "The end on the ray counts as below, the other lies above: the edge crosses, once."
                            : "The edge crosses the line, and **p** lies on its left: it counts.");
    step.decides = true;
    ask(edge,
        {{3, "One end is not above **p**."},
         {4, "One end is above **p**."},
         {6, "**p** lies on the left of the edge, seen upwards."}},
        vertex ? "A vertex on the line counts as below it; the other end lies above."
               : "Its ends lie on opposite sides, and **p** is on its left.");
  }

  void on(const EdgeOf& edge, int line) {
    const Point<double, 2> a = ends(setup_, edge)[0];
    known_.on = true;
    script_.settle(Verdict::Kind::on, verdict_text(setup_.truth));
    script_.leave_early();
    Step& step =
        add("on", "On the boundary", line,
            std::string(line == 5       ? "The orientation of **a**, **b**, **p** is exactly zero: the edge "
                                          "contains the point.\n"
                        : a == setup_.p ? "**p** is the end **a** of this edge.\n"
                                        : "**p** lies between the ends of this edge, at their height.\n") +
                "Neither inside nor outside. Counting alone would say " + (counts_as_inside() ? "IN" : "OUT") +
                ", as for the next place on the ray raised by *ε*.\n" +
                (counts_as_inside() ? "Of the highest vertex it would say OUT: boundary points come out either way.\n"
                                    : "") +
                "Where polygons side by side leave no gap around **p**, counting by exact signs gives it to just one. "
                "Filling of pixels requires that. Closed ones would fill such a pixel more than once, open ones "
                "not at all.");
    step.decides = true;
  }

  /// Whether the edges right of the point, itself not included, are odd in number: what counting says of a point on
  /// the boundary.
  bool counts_as_inside() const {
    const Point<double, 2>& p = setup_.p;
    bool odd = false;
    for (int r = 0; r < static_cast<int>(setup_.polygon.rings.size()); ++r)
      for (int i = 0; i < static_cast<int>(setup_.polygon.rings[r].size()); ++i) {
        const auto [a, b] = ends(setup_, {r, i});
        if ((a.y() > p.y()) == (b.y() > p.y())) continue;
        const int turn = orient2d(a, b, p);
        odd = odd != (a.y() < b.y() ? turn > 0 : turn < 0);
      }
    return odd;
  }

  void finish() {
    known_.edge.reset();
    const Winding& truth = setup_.truth;
    script_.settle(truth.even_odd == Location::in ? Verdict::Kind::yes : Verdict::Kind::no, verdict_text(truth));
    script_.value("winding number", truth.winding);
    const bool odd = count_ % 2 != 0;
    if (!odd) script_.refuse(8, {});
    Step& step =
        add("verdict", "Odd or even", odd ? 8 : 9,
            std::string(odd ? "The count is odd: **p** lies inside." : "The count is even: **p** lies outside.") +
                "\nThe winding number adds 1 for an edge upwards and −1 for one downwards." + rules());
    step.decides = true;
    step.question = which_count("How many times does the boundary wind around **p**, counter-clockwise?", truth.winding,
                                {{1.0 * count_, "That counts each crossing as 1, upwards or downwards."},
                                 {-1.0 * truth.winding, "That counts the turns clockwise."},
                                 {odd ? 1.0 : 0.0, "That tells only whether the count is odd."},
                                 {2, "The crossings upwards and downwards do not differ by 2."}},
                                "Edges that cross upwards count 1, those downwards −1.");
    step.question->over = with_directions();
  }

  /// What the winding number says of the two rules, and who fills by which.
  std::string rules() const {
    const Winding& truth = setup_.truth;
    if (setup_.simple) return " In a simple polygon it is 0, 1 or −1, so the even-odd and the non-zero rule agree.";
    const std::string told = truth.nonzero != truth.even_odd ? " It is not 0: by the non-zero rule **p** lies inside."
                             : truth.winding == 0 ? " It is 0: by the non-zero rule, too, **p** lies outside."
                                                  : " An odd count makes it odd, and so not 0: both rules say inside.";
    return told +
           (truth.winding < 0 ? " It is negative, as the boundary winds clockwise around **p**. A rule that asks for "
                                "more than 0 would leave this part out."
                              : "") +
           "\nFonts are filled by the non-zero rule, so that strokes of a letter may overlap. SVG and PDF offer both.";
  }

  /// Each edge an arrow, as the boundary runs: which way it winds is seen by that.
  Scene with_directions() const {
    Scene scene = picture(setup_, known_);
    std::vector<Item> arrows;
    for (int r = 0; r < static_cast<int>(setup_.polygon.rings.size()); ++r)
      for (int i = 0; i < static_cast<int>(setup_.polygon.rings[r].size()); ++i) {
        const auto [a, b] = ends(setup_, {r, i});
        if (a != b) arrows.emplace_back(Arrow{{a.x(), a.y(), 0}, {b.x(), b.y(), 0}, Role::second, Pen::solid});
      }
    scene.items.insert(scene.items.begin() + 1, arrows.begin(), arrows.end());
    return scene;
  }
};

}  // namespace

Walk half_open(const Setup& setup) { return HalfOpen(setup).tell(); }

}  // namespace isect::lessons::crossings_lesson
