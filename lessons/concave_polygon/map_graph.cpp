// The questions of a trapezoidal map: all of them as a graph, and those of a search as a path.

#include <algorithm>
#include <map>

#include "lessons/concave_polygon/map_picture.h"

namespace isect::lessons::concave_polygon_lesson {

using namespace viz;
using Node = TrapezoidMap::Node;
using Ask = TrapezoidMap::Ask;

namespace {

using Index = std::size_t;

void add_mark(Scene& scene, const Vec3& at, Ask ask, Role role, double size) {
  if (ask == Ask::vertex) {
    scene.items.emplace_back(Circle{at, size / 2, role, Pen::solid, true});
    if (role == Role::highlight) scene.items.emplace_back(Circle{at, size / 2, Role::text, Pen::solid});
  } else if (ask == Ask::piece) {
    add_cell(scene, at.x(), at.y(), size, role);
  } else {
    scene.items.emplace_back(Dot{at, role == Role::highlight ? Mark::diamond : Mark::disc, role});
  }
}

/// Where the questions stand: leaves side by side in the order of a search, a question midway above its two successors.
class Layout {
 public:
  Layout(const Frame& frame, const TrapezoidMap& map) : frame_(frame), map_(map), depth_(depths(map)) {
    place(0);
    spread();
  }

  Vec3 at(int i) const {
    int deepest = 1;
    for (const auto& [_, d] : depth_) deepest = std::max(deepest, d);
    const double height = std::min(3.2, 0.5 * deepest);
    return {frame_.table(table_width * (x_.at(i) + 0.5) / leaves_),
            frame_.below_top(0.6 + height * depth_.at(i) / deepest), 0};
  }
  const std::map<int, int>& all() const { return depth_; }

 private:
  double place(int i) {
    if (const auto it = x_.find(i); it != x_.end()) return it->second;
    const Node& n = map_.nodes[i];
    const double x = n.ask == Ask::nothing ? leaves_++ : (place(n.first) + place(n.second)) / 2;
    return x_[i] = x;
  }

  /// Keeps a distance between neighbours in a row.
  void spread() {
    std::map<int, std::vector<int>> rows;
    for (const auto& [i, d] : depth_) rows[d].push_back(i);
    for (auto& [_, row] : rows) {
      std::ranges::sort(row, {}, [&](int i) { return x_.at(i); });
      const double apart = 1.0;
      double moved = 0;
      for (Index k = 1; k < row.size(); ++k) {
        const double before = x_[row[k]];
        x_[row[k]] = std::max(before, x_[row[k - 1]] + apart);
        moved = std::max(moved, x_[row[k]] - before);
      }
      for (const int i : row) x_[i] -= moved / 2;
    }
  }

  const Frame& frame_;
  const TrapezoidMap& map_;
  std::map<int, int> depth_;
  std::map<int, double> x_;
  int leaves_ = 0;
};

}  // namespace

void add_graph(Scene& scene, const Frame& frame, const TrapezoidMap& map, bool named) {
  const Layout layout(frame, map);
  for (const auto& [i, _] : layout.all()) {
    const Node& n = map.nodes[i];
    if (n.ask == Ask::nothing) continue;
    for (const int next : {n.first, n.second})
      scene.items.emplace_back(Line{layout.at(i), layout.at(next), Role::construction, Pen::hairline});
  }
  for (const auto& [i, _] : layout.all()) {
    const Node& n = map.nodes[i];
    add_mark(scene, layout.at(i), n.ask, n.ask == Ask::nothing ? Role::second : Role::first,
             frame.unit * (named ? 0.14 : 0.1));
    if (named && n.ask != Ask::nothing) scene.items.emplace_back(Label{layout.at(i), name(n), Role::first});
  }
}

void add_path(Scene& scene, const Frame& frame, const TrapezoidMap& map, const std::vector<Asked>& path) {
  const double unit = frame.unit, x = frame.table(0.3), top = frame.below_top(0.6),
               pitch = std::min(0.36, 3.3 / depth(map)) * unit, stub = 0.22 * unit;  // the longest path fits
  for (Index k = 0; k < path.size(); ++k) {
    const Node& n = map.nodes[path[k].node];
    const double y = top - pitch * static_cast<double>(k);
    const bool last = k + 1 == path.size();
    if (n.ask == Ask::nothing) {
      add_mark(scene, {x, y, 0}, n.ask, Role::highlight, 0.16 * unit);
      scene.items.emplace_back(viz::Heading{{x + 0.3 * unit, y, 0}, "a trapezoid", Role::text, 1.5 * unit, false, 0});
      continue;
    }
    const double side = path[k].side < 0 ? stub : -stub;  // the way not taken
    if (path[k].side != 0) {
      scene.items.emplace_back(Line{{x, y, 0}, {x + side, y - 0.6 * pitch, 0}, Role::construction, Pen::construction});
      scene.items.emplace_back(Line{{x, y, 0}, {x, y - pitch, 0}, Role::text, Pen::solid});
    }
    add_mark(scene, {x, y, 0}, n.ask, last ? Role::highlight : Role::first, 0.17 * unit);
    const char* const word =
        n.ask == Ask::vertex ? (path[k].side < 0 ? "left of " : "right of ") : (path[k].side < 0 ? "below " : "above ");
    scene.items.emplace_back(viz::Heading{{x + 0.3 * unit, y, 0},
                                          (path[k].side == 0 ? "on " : word) + name(n),
                                          last ? Role::text : Role::muted,
                                          1.5 * unit,
                                          false,
                                          0});
  }
}

}  // namespace isect::lessons::concave_polygon_lesson
