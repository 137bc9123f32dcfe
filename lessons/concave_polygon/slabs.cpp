// Slabs: a line through every vertex, and in each slab its edges from left to right.

#include <isect/many/slab_map.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lessons/concave_polygon/slab_picture.h"
#include "lessons/shared/plural.h"
#include "lessons/shared/questions.h"
#include "lessons/shared/script.h"
#include "viz/chart/chart.h"

namespace isect::lessons::concave_polygon_lesson {

using namespace viz;

namespace {

using Index = std::size_t;

class Slabs {
 public:
  explicit Slabs(const Setup& setup)
      : s_(setup),
        map_(make_slab_map(setup.ring)),
        script_({"Lecture note, concave polygons; Preparata and Shamos, Computational Geometry (1985), 2.2.2",
                 alt_text(setup, "split into slabs at the heights of its vertices"),
                 {"split the plane at the height of every vertex: slabs",      // 0
                  "in each slab store its edges from left to right",           // 1
                  "bisect the heights: in which slab is p?",                   // 2
                  "if p is on its lower line: on a vertex or edge there? ON",  // 3
                  "bisect the slab's edges: is p left or right of the edge",   // 4
                  "    exactly on it: return ON",                              // 5
                  "return the mark stored left of the next edge"},             // 6
                 "slabs"}) {}

  Walk tell() {
    script_.value("*n*", s_.size());
    script_.value("slabs", static_cast<double>(count()));
    add("slabs", "Split into slabs", 0,
        "A horizontal line through every vertex. Between two lines no edge begins, ends or crosses another.\n"
        "Two vertices at one height would part a slab of width 0: it is left out, and they share a line.\n"
        "The unbounded strips below and above hold no edge, and are not counted.");
    drawn_.table = true;
    script_.value("edges in slabs", static_cast<double>(map_.order.size()), {}, Role::second);
    const int n = s_.size(), stored = static_cast<int>(map_.order.size());
    add("store", "Edges from left to right", 1,
        "So in each slab the edges are ordered from left to right. Each square is a stored edge.\n"
        "Between the *k*-th height and the next run at most 2 min(*k*, *n* − *k*) edges, as each vertex has two. "
        "Summed over all slabs, that is at most *n*^2/2.",
        fmt::format("{} ≤ *n*^2/2 = {}", stored, shown(n * n / 2.0)))
        .question =
        which_count("How many edges must be stored, if each counts once for every slab that it crosses?", stored,
                    {{1.0 * n, "That counts each edge once, whatever slabs it crosses."},
                     {1.0 * n * (n - 1), "That lets each edge cross every slab."},
                     {std::floor(n * n / 2.0), "That is the bound, which is not reached here."}},
                    "Count, for every edge, the slabs that it runs through.");
    keep_picture(script_.walk());
    compare();
    Record<slab_map::Event> record;
    winding(s_.p, map_, record);
    for (const auto& event : record.events) std::visit([&](const auto& e) { say(e); }, event);
    finish();
    return std::move(script_.walk());
  }

 private:
  int count() const { return static_cast<int>(map_.slabs.size()) - 2; }
  const SlabMap::Slab& slab(int i) const { return map_.slabs[i]; }
  bool real(int i) const { return i >= 0 && i < count(); }

  Step& add(const std::string& slug, const std::string& title, int line, const std::string& caption,
            const std::string& formula = {}) {
    Step& step = script_.add(slug, title, line, caption, formula);
    step.scene = picture(s_, map_, drawn_);
    return step;
  }

  void say(const slab_map::SlabFound& e) {
    drawn_.slab = e.slab;
    if (real(drawn_.slab)) drawn_.lo = slab(drawn_.slab).first, drawn_.hi = slab(drawn_.slab + 1).first;
    int steps = 0;
    slab_map::bisect(0, static_cast<int>(map_.slabs.size()), steps, [&](int i) {
      drawn_.probed.push_back(i);
      return slab(i).bottom > s_.p.y();
    });
    heights_ = e.steps;
    script_.value("heights compared", e.steps);
    Step& step =
        add("slab", "Bisect the heights", 2,
            real(drawn_.slab)  ? "The numbers show the order in which lines are compared. That finds "
                                 "the slab of **p** in O(lg *n*)."
            : level_with_top() ? "**p** is level with the highest vertex, where no slab begins. Is it that vertex?"
                               : "**p** lies below or above all vertices, so outside.");
    step.decides = true;
    drawn_.probed.clear();
  }

  bool level_with_top() const { return s_.p.y() == slab(count()).bottom; }

  void say(const slab_map::OnLine& e) {
    on_line_ = e.holds;
    Step& step = add("line", "Level with a vertex", 3,
                     e.holds ? std::string("**p** lies on the slab's lower line, exactly, and ") +
                                   (std::ranges::count(s_.ring, s_.p) > 0 ? "is a vertex." : "on a level edge.")
                     : real(drawn_.slab) ? "**p** lies on the slab's lower line, exactly, but on no vertex of it.\n"
                                           "A slab includes its lower line, so the search continues in it."
                                         : "**p** is level with the highest vertex, but not that vertex: outside.");
    step.decides = true;
  }

  void say(const slab_map::Compared& e) {
    drawn_.asked = e.edge;
    const Scene asking = picture(s_, map_, drawn_);
    const Index mid = drawn_.lo + (drawn_.hi - drawn_.lo) / 2;
    on_edge_ = e.turn == 0;
    script_.value("orientations", ++turns_);
    const SlabMap::Edge& middle = map_.edges[e.edge];
    const auto pair = [&](int v) {
      return fmt::format("({}, {})", shown(map_.vertices[v].x()), shown(map_.vertices[v].y()));
    };
    const std::string ends = pair(middle.lower) + " to " + pair(middle.upper);
    drawn_.narrowed = true;
    if (e.turn > 0) drawn_.hi = mid;
    if (e.turn < 0) drawn_.lo = mid + 1;
    Step& step =
        add(fmt::format("edge-{}", turns_),
            fmt::format("Comparison {}: {} the edge", turns_,
                        e.turn > 0   ? "left of"
                        : e.turn < 0 ? "right of"
                                     : "on"),
            e.turn == 0 ? 5 : 4,
            e.turn == 0  ? "The orientation is exactly zero: **p** lies on the edge."
            : e.turn > 0 ? "Compare **p** with the middle remaining edge. **p** is to its left: discard that edge "
                           "and everything right of it."
                         : "Compare **p** with the middle remaining edge. **p** is to its right: discard that "
                           "edge and everything left of it.");
    step.decides = true;
    if (turns_ == 1)
      step.question = Question{fmt::format("The middle edge of the slab runs from {}. Where is **p** = ({}, {})?", ends,
                                           shown(s_.p.x()), shown(s_.p.y())),
                               {"left of it", "right of it", "on it"},
                               e.turn > 0   ? 0
                               : e.turn < 0 ? 1
                                            : 2,
                               "The sign of the orientation decides, exactly.",
                               asking};
    if (e.turn != 0) drawn_.asked = -1;
  }
  void say(const Fallback&) {}

  void finish() {
    drawn_.done = true;
    script_.settle(verdict_kind(s_.truth), verdict_text(s_.truth));
    const std::string cost = fmt::format(
        "\n{} and {} were compared, of {} vertices. Each comparison halves what is left, so there "
        "are O(lg *n*).",
        plural(heights_, "height"), plural(turns_, "edge"), s_.size());
    if (on_line_ || on_edge_ || !real(drawn_.slab)) script_.leave_early();
    add("verdict", s_.truth == Location::on ? "On the boundary" : "The answer is stored",
        on_line_             ? 3
        : on_edge_           ? 5
        : !real(drawn_.slab) ? 2
                             : 6,
        (s_.truth == Location::on ? "The boundary is a case of its own."
         : !real(drawn_.slab)     ? "Below and above all vertices there is no edge."
         : s_.truth == Location::in
             ? "The part of the slab between the two neighbouring edges is inside: the mark was precomputed."
             : "The part of the slab between the two neighbouring edges is outside: the mark was precomputed.") +
            cost);
  }

  void compare() {
    Step& step = script_.add("growth", "Memory as *n* grows", 1, growth_caption());
    step.scene.chart = std::make_shared<const Chart>(growth());
  }

  const Setup& s_;
  const SlabMap map_;
  Script script_;
  DrawnSlabs drawn_;
  int turns_ = 0, heights_ = 0;
  bool on_line_ = false, on_edge_ = false;
};

}  // namespace

Walk slabs(const Setup& setup) { return Slabs(setup).tell(); }

}  // namespace isect::lessons::concave_polygon_lesson
