// Kirkpatrick's hierarchy: ever coarser triangulations, searched from the coarsest to the finest.

#include <fmt/format.h>

#include <algorithm>

#include "lessons/concave_polygon/setup.h"
#include "lessons/concave_polygon/triangles.h"
#include "lessons/script.h"

namespace isect::lessons::concave_polygon_lesson {

using namespace viz;

namespace {

using Index = std::size_t;

class Coarsening {
 public:
  explicit Coarsening(const Setup& setup)
      : s_(setup),
        h_(make_hierarchy(setup.ring, {{frame.left, frame.low}, {frame.right, frame.high}})),
        path_(descend(h_, setup.p)),
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
    build();
    if (path_.empty()) return outside();
    search();
    return std::move(script_.walk());
  }

 private:
  Step& add(const std::string& slug, const std::string& title, int line, const std::string& caption,
            Index level) {
    Step& step = script_.add(slug, title, line, caption);
    step.scene = picture(level);
    return step;
  }

  void build() {
    script_.value("*n*", s_.size());
    script_.value("triangles", static_cast<double>(h_.levels[0].triangles.size()));
    add("triangles", "Triangles everywhere", 0,
        "Polygon and box are cut into triangles. Each triangle is marked as inside or outside.", 0);
    coarsen(1);
    coarsen(h_.levels.size() - 1);
    gone_.clear();
  }

  /// The first level that is coarser, or the last one.
  void coarsen(Index level) {
    gone_ = h_.levels[level - 1].removed;
    const auto count = [&] {
      script_.value("triangles", static_cast<double>(h_.levels[level].triangles.size()));
    };
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
        add("removed", fmt::format("{} vertices to remove", gone_.size()), 2,
            "Crosses mark vertices that are removed. No two are joined by an edge, so the holes are apart.",
            level - 1);
    step.question = Question{"May two vertices be removed at once that an edge joins?",
                             {"yes", "no"},
                             1,
                             "Their holes would be one, of unbounded size. So would be the work there."};
    gone_.clear();
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
    for (Index k = 0; k < path_.size(); ++k) {
      const Index level = h_.levels.size() - 1 - k;
      const std::vector<int> candidates = k == 0 ? std::vector<int>{0, 1} : found(k - 1).links;
      here_ = path_[k], linked_ = candidates;
      tested += static_cast<int>(std::ranges::find(candidates, here_) - candidates.begin()) + 1;
      script_.value("triangles", static_cast<double>(h_.levels[level].triangles.size()));
      script_.value("triangles tested", tested, {}, Role::first);
      if (k > 0 && level != told) continue;  // as there
      Step& step = add(
          fmt::format("search-{}", level), fmt::format("Level {}", level), k == 0 ? 4 : 5,
          k == 0 ? "The search starts with the two coarsest triangles: one holds **p**."
          : k > 1
              ? fmt::format("From triangle to linked triangle, level by level. Here {} are linked, shaded.",
                            candidates.size())
          : candidates.size() == 1
              ? "The triangle did not change: its only link is itself."
              : fmt::format("Only {} triangles are linked, shaded here. One of them holds **p**.",
                            candidates.size()),
          level);
      step.decides = true;
    }
    done_ = true;
    script_.settle(verdict_kind(s_.truth), verdict_text(s_.truth));
    Step& step =
        add("verdict", "The mark of the finest triangle", 6,
            std::string(s_.truth == Location::on   ? "**p** lies on an edge of the polygon."
                        : s_.truth == Location::in ? "The triangle is one of the polygon's: inside."
                                                   : "The triangle is one of the rest: outside.") +
                "\nO(lg *n*) levels with a few tests each, O(*n*) space: optimal, with large constants.",
            0);
    step.question = where(s_, "The exact test by crossings says the same.");
  }

  static constexpr Index told = 1;  ///< of the search, beside the coarsest and the finest

  const Triangle& found(Index k) const {
    return h_.levels[h_.levels.size() - 1 - k].triangles[static_cast<Index>(path_[k])];
  }
  std::vector<Vec3> outline(const Triangle& t) const {
    std::vector<Vec3> ring;
    for (const auto& v : h_.triangle(t)) ring.push_back(flat(v));
    return ring;
  }

  Scene picture(Index level) const {
    const std::vector<Triangle>& triangles = h_.levels[level].triangles;
    Scene scene;
    scene.items.emplace_back(polygon(s_, level == 0));
    for (const int k : linked_)
      scene.items.emplace_back(filled(outline(triangles[static_cast<Index>(k)]), Role::highlight));
    for (const Triangle& t : triangles)
      scene.items.emplace_back(
          Chain{outline(t), true, Role::construction, level == 0 ? Pen::hairline : Pen::solid});
    if (here_ >= 0) {
      Region region =
          filled(outline(triangles[static_cast<Index>(here_)]), !done_                      ? Role::first
                                                                : s_.truth == Location::out ? Role::miss
                                                                                            : Role::hit);
      region.outlined = true, region.pen = Pen::thick;
      scene.items.emplace_back(region);
    }
    for (const int v : gone_)
      scene.items.emplace_back(Dot{flat(h_.vertices[static_cast<Index>(v)]), Mark::cross, Role::miss});
    table(scene, level);
    add_point(scene, s_, done_ && s_.truth == Location::on);
    return scene;
  }

  /// A bar for each level made so far, the coarsest above, and on it the triangles of the search.
  void table(Scene& scene, Index level) const {
    const bool searching = here_ >= 0 || done_;
    const Index shown = searching ? h_.levels.size() : level + 1;
    const double size = 0.1, pitch = 0.13;
    for (Index l = 0; l < shown; ++l) {
      const std::vector<Triangle>& triangles = h_.levels[l].triangles;
      const double y = -1.4 + 0.5 * static_cast<double>(l);
      scene.items.emplace_back(viz::Heading{{frame.table - 0.18, y, 0},
                                            std::to_string(l),
                                            l == level ? Role::text : Role::muted,
                                            0.2,
                                            l == level});
      add_bar(scene, y, size, pitch * static_cast<double>(triangles.size()),
              l == level ? Role::second : Role::construction);
      const auto mark = [&](int k, Role role) {
        add_cell(scene, frame.table + (k + 0.5) * pitch, y, size, role);
      };
      if (l == level)
        for (const int k : linked_) mark(k, Role::highlight);
      const Index down = h_.levels.size() - 1 - l;
      if (searching && l >= level && down < path_.size()) mark(path_[down], Role::first);
    }
    scene.items.emplace_back(table_heading("triangles of each level"));
  }

  /// As long as there are triangles.
  static void add_bar(Scene& scene, double y, double size, double length, Role role) {
    const double x = frame.table, h = size / 2;
    Region bar = filled({{x, y - h, 0}, {x + length, y - h, 0}, {x + length, y + h, 0}, {x, y + h, 0}}, role);
    bar.outlined = true;
    scene.items.emplace_back(bar);
  }

  const Setup& s_;
  const Hierarchy h_;
  const std::vector<int> path_;  ///< the triangle with p on each level, the coarsest first
  Script script_;
  std::vector<int> gone_, linked_;
  int here_ = -1;
  bool done_ = false;
};

}  // namespace

Walk hierarchy(const Setup& setup) { return Coarsening(setup).tell(); }

}  // namespace isect::lessons::concave_polygon_lesson
