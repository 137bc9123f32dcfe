// Kirkpatrick's hierarchy: ever coarser triangulations, searched from the coarsest to the finest.

#include <fmt/format.h>

#include <algorithm>

#include "lessons/concave_polygon/level_picture.h"
#include "lessons/shared/questions.h"
#include "lessons/shared/script.h"

namespace isect::lessons::concave_polygon_lesson {

using namespace viz;

namespace {

using Index = std::size_t;

class Coarsening {
 public:
  explicit Coarsening(const Setup& setup)
      : s_(setup),
        h_(make_hierarchy(setup.ring, {{setup.frame.left, setup.frame.low}, {setup.frame.right, setup.frame.high}})),
        script_({"Lecture note, concave polygons; Kirkpatrick, SIAM Journal on Computing 12 (1983)",
                 alt_text(setup, "and a box around it, split into triangles"),
                 {"triangulate the polygon, and the rest of a box around it",  // 0
                  "while more than two triangles are left",                    // 1
                  "    remove vertices of few edges, no two joined",           // 2
                  "    triangulate the holes; link new triangles to old",      // 3
                  "triangle ← the one of the coarsest two that holds p",       // 4
                  "while it has links: triangle ← the linked one with p",      // 5
                  "return the mark of the triangle"},                          // 6
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
        "Polygon and box are split into triangles. Each triangle is marked as inside or outside.", 0);
    coarsen(1);
    coarsen(h_.levels.size() - 1);
    drawn_.gone.clear();
  }

  /// Shows the first level that is coarser, or the last one.
  void coarsen(Index level) {
    drawn_.gone = h_.levels[level - 1].removed;
    const auto count = [&] { script_.value("triangles", static_cast<double>(h_.levels[level].triangles.size())); };
    if (level > 1) {
      count();
      script_.value("levels", static_cast<double>(h_.levels.size()));
      add("coarsest", "Two triangles are left", 1,
          "Only the polygon's vertices are removed. At each of them at least 3 edges meet, and fewer than 6 on "
          "average. So at least half have 8 edges or fewer.\n"
          "Each one chosen rules out 8 at most: each round removes a constant fraction. Hence O(lg *n*) levels, O(*n*) "
          "triangles.",
          level);
      return;
    }
    const auto removed = static_cast<double>(drawn_.gone.size());
    Step& step =
        add("removed", fmt::format("{} {} to remove", removed, removed == 1 ? "vertex" : "vertices"), 2,
            "Dashed rings mark vertices of 8 edges or fewer that are removed. No edge joins two of them, so the "
            "holes are apart.",
            level - 1);
    step.question = Question{"Why must no edge join two vertices that are removed at once?",
                             {"Their holes would be one, which may grow without bound",
                              "The triangles left would overlap", "The point **p** could lie on that edge"},
                             0,
                             "A hole of at most 8 sides is filled, and linked, in constant time."};
    drawn_.gone.clear();
    count();
    const auto before = static_cast<double>(h_.levels[level - 1].triangles.size());
    Step& holes = add("holes", "Holes triangulated", 3,
                      "Each hole is triangulated again: *d* triangles around a vertex become *d* − 2. A new triangle "
                      "is linked to the "
                      "old ones that it overlaps.",
                      level);
    holes.question =
        which_count(fmt::format("{} triangles lose {} {}, and the holes are filled. How many triangles are there then?",
                                before, removed, removed == 1 ? "vertex" : "vertices"),
                    static_cast<double>(h_.levels[level].triangles.size()),
                    {{before - removed, "That takes away one triangle for each vertex. It is two."},
                     {before, "That fills each hole with as many triangles as it had."},
                     {before - 3 * removed, "That takes away three triangles for each vertex. It is two."}},
                    "A hole with *d* sides takes *d* − 2 triangles: two less for each vertex.");
    keep_picture(script_.walk());
  }

  Walk outside() {
    script_.settle(Verdict::Kind::no, verdict_text(Location::out));
    script_.leave_early();
    add("verdict", "Outside the box", 4, "Neither of the two triangles contains **p**.", h_.levels.size() - 1);
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
          k == 0  ? "The search starts with the two coarsest triangles: one contains **p**."
          : k > 1 ? fmt::format(
                        "From triangle to linked triangle, level by level; {} not drawn. Here {} {} linked, shaded.",
                        passed(level), candidates.size(), candidates.size() == 1 ? "is" : "are")
          : candidates.size() == 1
              ? "The triangle did not change: its only link is itself."
              : fmt::format("Only {} triangles are linked, shaded here. One of them contains **p**.",
                            candidates.size()),
          level);
      step.decides = true;
    }
    drawn_.done = true;
    script_.settle(verdict_kind(s_.truth), verdict_text(s_.truth));
    add("verdict", "The mark of the finest triangle", 6,
        std::string(s_.truth == Location::on   ? "**p** lies on an edge of the polygon."
                    : s_.truth == Location::in ? "The triangle is one of the polygon's: inside."
                                               : "The triangle is one of the rest: outside.") +
            "\nO(lg *n*) levels with a few tests each, O(*n*) space: optimal, with large constants.",
        0);
  }

  /// The levels between the coarsest and this one.
  std::string passed(Index level) const {
    const Index first = h_.levels.size() - 2, last = level + 1;
    return first == last ? fmt::format("level {} is", first) : fmt::format("levels {} to {} are", first, last);
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
