// Kirkpatrick's hierarchy: ever coarser triangulations, searched from the coarsest to the finest.

#include <fmt/format.h>

#include <algorithm>

#include "lessons/concave_polygon/level_picture.h"
#include "lessons/shared/script.h"

namespace isect::lessons::concave_polygon_lesson {

using namespace viz;

namespace {

using Index = std::size_t;

class Coarsening {
 public:
  explicit Coarsening(const Setup& setup)
      : s_(setup),
        h_(make_hierarchy(setup.ring, {{frame.left, frame.low}, {frame.right, frame.high}})),
        script_({"Note, N24; Kirkpatrick (1983)",
                 alt_text(setup, "and a box around it, cut into triangles"),
                 {"triangulate the polygon, and the rest of a box around it",  // 0
                  "while more than two triangles are left",                    // 1
                  "    remove vertices of few edges, no two joined",           // 2
                  "    triangulate the holes; link new triangles to old",      // 3
                  "triangle ← the one of the coarsest two that holds p",       // 4
                  "while it has links: triangle ← the linked one with p",      // 5
                  "return the mark of the triangle: IN or OUT"},               // 6
                 "Kirkpatrick's hierarchy"}) {}

  Walk tell() {
    drawn_.path = descend(h_, s_.p);
    build();
    if (drawn_.path.empty()) return outside();
    search();
    return std::move(script_.walk());
  }

 private:
  Step& add(const std::string& slug, const std::string& title, int line, const std::string& caption, Index level) {
    Step& step = script_.add(slug, title, line, caption);
    step.scene = picture(s_, h_, drawn_, level);
    return step;
  }

  void build() {
    script_.value("*n*", s_.size());
    script_.value("triangles", static_cast<double>(h_.levels[0].triangles.size()));
    add("triangles", "Triangles everywhere", 0,
        "Polygon and box are cut into triangles. Each triangle is marked as inside or outside.", 0);
    coarsen(1);
    coarsen(h_.levels.size() - 1);
    drawn_.gone.clear();
  }

  /// The first level that is coarser, or the last one.
  void coarsen(Index level) {
    drawn_.gone = h_.levels[level - 1].removed;
    const auto count = [&] { script_.value("triangles", static_cast<double>(h_.levels[level].triangles.size())); };
    if (level > 1) {
      count();
      script_.value("levels", static_cast<double>(h_.levels.size()));
      add("coarsest", "Two triangles are left", 1,
          "Round by round vertices go, a constant share each time: O(lg *n*) levels, O(*n*) triangles in "
          "all.",
          level);
      return;
    }
    Step& step =
        add("removed", fmt::format("{} vertices to remove", drawn_.gone.size()), 2,
            "Crosses mark vertices that are removed. No two are joined by an edge, so the holes are apart.", level - 1);
    step.question = Question{"May two vertices be removed at once that an edge joins?",
                             {"yes", "no"},
                             1,
                             "Their holes would be one, of unbounded size. So would be the work there."};
    drawn_.gone.clear();
    count();
    add("holes", "Holes triangulated", 3,
        "Each hole is triangulated again. A new triangle is linked to the few old ones with which it shares "
        "area.",
        level);
  }

  Walk outside() {
    script_.settle(Verdict::Kind::no, verdict_text(Location::out));
    script_.leave_early();
    add("verdict", "Outside the box", 4, "Neither of the two triangles holds **p**.", h_.levels.size() - 1);
    return std::move(script_.walk());
  }

  void search() {
    int tested = 0;
    for (Index k = 0; k < drawn_.path.size(); ++k) {
      const Index level = h_.levels.size() - 1 - k;
      const std::vector<int> candidates = k == 0 ? std::vector<int>{0, 1} : found(k - 1).links;
      drawn_.here = drawn_.path[k], drawn_.linked = candidates;
      tested += static_cast<int>(std::ranges::find(candidates, drawn_.here) - candidates.begin()) + 1;
      script_.value("triangles", static_cast<double>(h_.levels[level].triangles.size()));
      script_.value("triangles tested", tested, {}, Role::first);
      if (k > 0 && level != told) continue;  // as there
      Step& step = add(
          fmt::format("search-{}", level), fmt::format("Level {}", level), k == 0 ? 4 : 5,
          k == 0  ? "The search starts with the two coarsest triangles: one holds **p**."
          : k > 1 ? fmt::format("From triangle to linked triangle, level by level. Here {} are linked, shaded.",
                                candidates.size())
          : candidates.size() == 1
              ? "The triangle did not change: its only link is itself."
              : fmt::format("Only {} triangles are linked, shaded here. One of them holds **p**.", candidates.size()),
          level);
      step.decides = true;
    }
    drawn_.done = true;
    script_.settle(verdict_kind(s_.truth), verdict_text(s_.truth));
    Step& step = add("verdict", "The mark of the finest triangle", 6,
                     std::string(s_.truth == Location::on   ? "**p** lies on an edge of the polygon."
                                 : s_.truth == Location::in ? "The triangle is one of the polygon's: inside."
                                                            : "The triangle is one of the rest: outside.") +
                         "\nO(lg *n*) levels with a few tests each, O(*n*) space: optimal, with large constants.",
                     0);
    step.question = where(s_, "The exact test by crossings says the same.");
  }

  static constexpr Index told = 1;  ///< of the search, beside the coarsest and the finest

  const Triangle& found(Index k) const { return h_.levels[h_.levels.size() - 1 - k].triangles[drawn_.path[k]]; }
  const Setup& s_;
  const Hierarchy h_;
  Script script_;
  DrawnLevel drawn_;
};

}  // namespace

Walk hierarchy(const Setup& setup) { return Coarsening(setup).tell(); }

}  // namespace isect::lessons::concave_polygon_lesson
