// Slabs: a line through every vertex, and in each slab its edges from left to right.

#include "core/slab_map.h"

#include <fmt/format.h>

#include "lessons/concave_polygon/setup.h"
#include "lessons/script.h"
#include "viz/chart.h"

namespace isect::lessons::concave_polygon_lesson {

using namespace viz;

namespace {

using Index = std::size_t;

class Slabs {
 public:
  explicit Slabs(const Setup& setup)
      : s_(setup),
        map_(make_slab_map(setup.ring)),
        script_({"Note, N24; Preparata and Shamos (1990), 2.2.2",
                 alt_text(setup, "cut into slabs at the heights of its vertices"),
                 {"cut the plane at the height of every vertex: slabs",       // 0
                  "in each slab store its edges from left to right",          // 1
                  "bisect the heights: in which slab is p?",                  // 2
                  "if p is on its lower line: look up vertices there",        // 3
                  "bisect the slab's edges: is p left or right of the edge",  // 4
                  "    exactly on it: return ON",                             // 5
                  "return the mark left of the next edge: IN or OUT"},        // 6
                 "slabs"}) {}

  Walk tell() {
    script_.value("*n*", s_.size());
    script_.value("slabs", static_cast<double>(count()));
    add("slabs", "Cut into slabs", 0,
        "A horizontal line through every vertex. Between two lines no edge begins, ends or crosses another.");
    table_ = true;
    script_.value("edges in slabs", static_cast<double>(map_.order.size()), {}, Role::second);
    add("store", "Edges from left to right", 1,
        "So in each slab the edges have one order from left to right. Each square is an edge stored.\n"
        "A long edge is stored in many slabs: up to *n*^2/4 in all, O(*n*^2) space.");
    compare();
    Record<slab_map::Event> record;
    winding(s_.p, map_, record);
    for (const auto& event : record.events) std::visit([&](const auto& e) { say(e); }, event);
    finish();
    return std::move(script_.walk());
  }

 private:
  int count() const { return static_cast<int>(map_.slabs.size()) - 2; }
  const SlabMap::Slab& slab(int i) const { return map_.slabs[static_cast<Index>(i)]; }
  bool real(int i) const { return i >= 0 && i < count(); }
  Index entries(int i) const { return slab(i + 1).first - slab(i).first; }

  Step& add(const std::string& slug, const std::string& title, int line, const std::string& caption,
            const std::string& formula = {}) {
    Step& step = script_.add(slug, title, line, caption, formula);
    step.scene = picture();
    return step;
  }

  void say(const slab_map::SlabFound& e) {
    slab_ = e.slab;
    if (real(slab_)) lo_ = slab(slab_).first, hi_ = slab(slab_ + 1).first;
    int steps = 0;
    slab_map::bisect(0, static_cast<int>(map_.slabs.size()), steps, [&](int i) {
      probed_.push_back(i);
      return slab(i).bottom > s_.p.y();
    });
    heights_ = e.steps;
    script_.value("heights compared", e.steps);
    Step& step = add("slab", "Bisect the heights", 2,
                     real(slab_) ? "The numbers show which lines are asked, in turn. Comparing heights finds "
                                   "the slab of **p** in O(lg *n*)."
                                 : "**p** lies below or above all vertices, so outside.");
    step.decides = true;
    probed_.clear();
  }

  void say(const slab_map::OnLine& e) {
    on_line_ = e.holds;
    Step& step = add("line", "Level with a vertex", 3,
                     e.holds ? "**p** lies exactly on the slab's lower line, on a vertex or a flat edge."
                             : "**p** lies exactly on the slab's lower line, but on no vertex of it.\n"
                               "A slab holds its lower line, so the search goes on in it.");
    step.decides = true;
  }

  void say(const slab_map::Compared& e) {
    asked_ = e.edge;
    const Index mid = lo_ + (hi_ - lo_) / 2;
    on_edge_ = e.turn == 0;
    script_.value("orientations", ++turns_);
    if (e.turn > 0) hi_ = mid;
    if (e.turn < 0) lo_ = mid + 1;
    Step& step = add(
        fmt::format("edge-{}", turns_),
        e.turn > 0   ? "Left of the edge"
        : e.turn < 0 ? "Right of the edge"
                     : "On the edge",
        e.turn == 0 ? 5 : 4,
        e.turn == 0  ? "The orientation is exactly zero: **p** lies on the edge."
        : e.turn > 0 ? "The middle one of the edges left is asked: **p** lies left of it. What lies right "
                       "is gone."
                     : "The middle one of the edges left is asked: **p** lies right of it. What lies left "
                       "is gone.");
    step.decides = true;
    if (turns_ == 1)
      step.question = Question{"On which side of the slab's middle edge is **p**?",
                               {"left", "right", "on it"},
                               e.turn > 0   ? 0
                               : e.turn < 0 ? 1
                                            : 2,
                               "The sign of an orientation tells, exactly."};
    if (e.turn != 0) asked_ = -1;
  }
  void say(const Fallback&) {}

  void finish() {
    done_ = true;
    script_.settle(verdict_kind(s_.truth), verdict_text(s_.truth));
    const std::string cost = fmt::format("\n{} heights and {} edge{} for {} vertices: O(lg *n*).", heights_,
                                         turns_, turns_ == 1 ? "" : "s", s_.size());
    if (on_line_ || on_edge_ || !real(slab_)) script_.leave_early();
    Step& step = add("verdict", s_.truth == Location::on ? "On the boundary" : "The answer is stored",
                     on_line_       ? 3
                     : on_edge_     ? 5
                     : !real(slab_) ? 2
                                    : 6,
                     (s_.truth == Location::on ? "The boundary is a case of its own."
                      : !real(slab_)           ? "No slab there has an edge."
                      : s_.truth == Location::in
                          ? "Between these two edges all is inside: the mark was computed beforehand."
                          : "Between these two edges all is outside: the mark was computed beforehand.") +
                         cost);
    step.question = where(s_, "The exact test by crossings says the same.");
  }

  void compare() {
    Step& step = script_.add("growth", "Memory as *n* grows", 1, growth_caption());
    step.scene.chart = std::make_shared<const Chart>(growth());
  }

  /// An edge's abscissa at a height, for drawing.
  double abscissa(int edge, double y) const {
    const SlabMap::Edge& e = map_.edges[static_cast<Index>(edge)];
    const Point<double, 2>&a = map_.vertices[static_cast<Index>(e.lower)],
                        &b = map_.vertices[static_cast<Index>(e.upper)];
    return a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
  }

  /// What of the slab is still possible: between the edges known to lie left and right of p.
  Region possible() const {
    const double y0 = slab(slab_).bottom, y1 = slab(slab_ + 1).bottom;
    const bool none_left = lo_ == slab(slab_).first, none_right = hi_ == slab(slab_ + 1).first;
    const auto x = [&](bool left, double y) {
      if (left) return none_left ? frame.left : abscissa(map_.order[lo_ - 1], y);
      return none_right ? frame.right : abscissa(map_.order[hi_], y);
    };
    const Role role = !done_ || s_.truth == Location::on ? Role::highlight
                      : s_.truth == Location::in         ? Role::hit
                                                         : Role::miss;
    return filled({{x(true, y0), y0, 0}, {x(false, y0), y0, 0}, {x(false, y1), y1, 0}, {x(true, y1), y1, 0}},
                  role);
  }

  Scene picture() const {
    Scene scene;
    scene.items.emplace_back(polygon(s_));
    if (real(slab_) && !(done_ && s_.truth == Location::on)) scene.items.emplace_back(possible());
    for (int i = 0; i <= count(); ++i)
      scene.items.emplace_back(Line{{frame.left, slab(i).bottom, 0},
                                    {frame.right, slab(i).bottom, 0},
                                    Role::construction,
                                    Pen::construction});
    for (Index k = 0; k < probed_.size(); ++k) {
      if (probed_[k] > count()) continue;
      const double y = slab(probed_[k]).bottom;
      scene.items.emplace_back(Line{{frame.left, y, 0}, {frame.right, y, 0}, Role::text, Pen::solid});
      scene.items.emplace_back(viz::Heading{
          {frame.left - (k % 2 == 0 ? 0.12 : 0.3), y, 0}, std::to_string(k + 1), Role::text, 0.2});
    }
    if (asked_ >= 0) {
      const SlabMap::Edge& e = map_.edges[static_cast<Index>(asked_)];
      scene.items.emplace_back(Line{flat(map_.vertices[static_cast<Index>(e.lower)]),
                                    flat(map_.vertices[static_cast<Index>(e.upper)]), Role::highlight,
                                    Pen::highlight});
    }
    if (table_) table(scene);
    add_point(scene, s_, done_ && s_.truth == Location::on);
    return scene;
  }

  /// What is stored: beside each slab a square for each of its edges.
  void table(Scene& scene) const {
    const double size = 0.15, pitch = 0.22;
    for (int i = 0; i < count(); ++i) {
      const double y = (slab(i).bottom + slab(i + 1).bottom) / 2;
      for (Index k = 0; k < entries(i); ++k) {
        const Index at = slab(i).first + k;
        const bool here = i == slab_, asked = here && map_.order[at] == asked_;
        const bool gone = here && turns_ > 0 && !asked && (at < lo_ || at >= hi_);
        add_cell(scene, frame.table + (static_cast<double>(k) + 0.5) * pitch, y, size,
                 asked  ? Role::highlight
                 : gone ? Role::muted
                 : here ? Role::second
                        : Role::construction,
                 asked);
      }
    }
    scene.items.emplace_back(viz::Heading{
        {frame.table + 1, frame.high, 0}, fmt::format("{} edges stored", map_.order.size()), Role::text, 2});
  }

  const Setup& s_;
  const SlabMap map_;
  Script script_;
  std::vector<int> probed_;  ///< lines, in the order asked
  int slab_ = -1, asked_ = -1, turns_ = 0, heights_ = 0;
  Index lo_ = 0, hi_ = 0;  ///< the edges of the slab still possible
  bool table_ = false, on_line_ = false, on_edge_ = false, done_ = false;
};

}  // namespace

Walk slabs(const Setup& setup) { return Slabs(setup).tell(); }

}  // namespace isect::lessons::concave_polygon_lesson
