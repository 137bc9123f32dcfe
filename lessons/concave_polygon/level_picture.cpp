#include "lessons/concave_polygon/level_picture.h"

namespace isect::lessons::concave_polygon_lesson {

using namespace viz;

namespace {

using Index = std::size_t;

class LevelPicture {
 public:
  LevelPicture(const Setup& setup, const Hierarchy& hierarchy, const DrawnLevel& drawn)
      : s_(setup), h_(hierarchy), d_(drawn) {}

  Scene all(Index level) const {
    const std::vector<Triangle>& triangles = h_.levels[level].triangles;
    Scene scene;
    scene.items.emplace_back(polygon(s_, level == 0));
    for (const int k : d_.linked) scene.items.emplace_back(filled(outline(triangles[k]), Role::highlight));
    for (const Triangle& t : triangles)
      scene.items.emplace_back(Chain{outline(t), true, Role::construction, level == 0 ? Pen::hairline : Pen::solid});
    if (d_.here >= 0) {
      Region region = filled(outline(triangles[d_.here]), !d_.done                    ? Role::first
                                                          : s_.truth == Location::out ? Role::miss
                                                                                      : Role::hit);
      region.outlined = true, region.pen = Pen::thick;
      scene.items.emplace_back(region);
    }
    for (const int v : d_.gone) scene.items.emplace_back(Dot{flat(h_.vertices[v]), Mark::excluded, Role::text});
    table(scene, level);
    add_point(scene, s_, d_.done && s_.truth == Location::on);
    return scene;
  }

 private:
  std::vector<Vec3> outline(const Triangle& t) const {
    std::vector<Vec3> ring;
    for (const auto& v : h_.triangle(t)) ring.push_back(flat(v));
    return ring;
  }

  /// A bar for each level made so far, the coarsest above, and on it the triangles of the search.
  void table(Scene& scene, Index level) const {
    const bool searching = d_.here >= 0 || d_.done;
    const Index shown = searching ? h_.levels.size() : level + 1;
    const Frame& f = s_.frame;
    const double size = 0.1 * f.unit, pitch = 0.13;
    for (Index l = 0; l < shown; ++l) {
      const std::vector<Triangle>& triangles = h_.levels[l].triangles;
      const double y = f.below_top(3.4 - 0.5 * static_cast<double>(l));
      scene.items.emplace_back(viz::Heading{
          {f.table(-0.18), y, 0}, std::to_string(l), l == level ? Role::text : Role::muted, 0.2 * f.unit, l == level});
      add_bar(scene, f.table(), y, size, f.unit * pitch * static_cast<double>(triangles.size()),
              l == level ? Role::second : Role::construction);
      const auto mark = [&](int k, Role role) { add_cell(scene, f.table((k + 0.5) * pitch), y, size, role); };
      if (l == level)
        for (const int k : d_.linked) mark(k, Role::highlight);
      const Index down = h_.levels.size() - 1 - l;
      if (searching && l >= level && down < d_.path.size()) mark(d_.path[down], Role::first);
    }
    scene.items.emplace_back(table_heading(f, "triangles of each level"));
  }

  /// Adds a bar whose length shows the number of triangles.
  static void add_bar(Scene& scene, double x, double y, double size, double length, Role role) {
    const double h = size / 2;
    Region bar = filled({{x, y - h, 0}, {x + length, y - h, 0}, {x + length, y + h, 0}, {x, y + h, 0}}, role);
    bar.outlined = true, bar.pen = Pen::hairline;
    scene.items.emplace_back(bar);
  }

  const Setup& s_;
  const Hierarchy& h_;
  const DrawnLevel& d_;
};

}  // namespace

Scene picture(const Setup& setup, const Hierarchy& hierarchy, const DrawnLevel& drawn, std::size_t level) {
  return LevelPicture(setup, hierarchy, drawn).all(level);
}

}  // namespace isect::lessons::concave_polygon_lesson
