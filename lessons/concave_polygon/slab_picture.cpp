#include "lessons/concave_polygon/slab_picture.h"

#include <fmt/format.h>

namespace isect::lessons::concave_polygon_lesson {

using namespace viz;

namespace {

using Index = std::size_t;

class SlabPicture {
 public:
  SlabPicture(const Setup& setup, const SlabMap& map, const DrawnSlabs& drawn) : s_(setup), map_(map), d_(drawn) {}

  Scene all() const {
    Scene scene;
    scene.items.emplace_back(polygon(s_));
    if (real(d_.slab) && !(d_.done && s_.truth == Location::on)) scene.items.emplace_back(possible());
    for (int i = 0; i <= count(); ++i)
      scene.items.emplace_back(Line{{s_.frame.left, slab(i).bottom, 0},
                                    {s_.frame.right, slab(i).bottom, 0},
                                    Role::construction,
                                    Pen::construction});
    for (Index k = 0; k < d_.probed.size(); ++k) {
      if (d_.probed[k] > count()) continue;
      const double y = slab(d_.probed[k]).bottom;
      scene.items.emplace_back(Line{{s_.frame.left, y, 0}, {s_.frame.right, y, 0}, Role::text, Pen::solid});
      scene.items.emplace_back(viz::Heading{
          {s_.frame.left - unit() * (k % 2 == 0 ? 0.12 : 0.3), y, 0}, std::to_string(k + 1), Role::text, 0.2 * unit()});
    }
    if (d_.asked >= 0) {
      const SlabMap::Edge& e = map_.edges[d_.asked];
      scene.items.emplace_back(
          Line{flat(map_.vertices[e.lower]), flat(map_.vertices[e.upper]), Role::highlight, Pen::highlight});
    }
    if (d_.table) table(scene);
    add_point(scene, s_, d_.done && s_.truth == Location::on);
    return scene;
  }

 private:
  double unit() const { return s_.frame.unit; }
  int count() const { return static_cast<int>(map_.slabs.size()) - 2; }
  const SlabMap::Slab& slab(int i) const { return map_.slabs[i]; }
  bool real(int i) const { return i >= 0 && i < count(); }
  Index entries(int i) const { return slab(i + 1).first - slab(i).first; }

  /// An edge's abscissa at a height, for drawing.
  double abscissa(int edge, double y) const {
    const SlabMap::Edge& e = map_.edges[edge];
    const Point<double, 2>&a = map_.vertices[e.lower], &b = map_.vertices[e.upper];
    return a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
  }

  /// The part of the slab that is still possible: between the edges known to lie left and right of p.
  Region possible() const {
    const double y0 = slab(d_.slab).bottom, y1 = slab(d_.slab + 1).bottom;
    const bool none_left = d_.lo == slab(d_.slab).first, none_right = d_.hi == slab(d_.slab + 1).first;
    const auto x = [&](bool left, double y) {
      if (left) return none_left ? s_.frame.left : abscissa(map_.order[d_.lo - 1], y);
      return none_right ? s_.frame.right : abscissa(map_.order[d_.hi], y);
    };
    const Role role = !d_.done || s_.truth == Location::on ? Role::highlight
                      : s_.truth == Location::in           ? Role::hit
                                                           : Role::miss;
    return filled({{x(true, y0), y0, 0}, {x(false, y0), y0, 0}, {x(false, y1), y1, 0}, {x(true, y1), y1, 0}}, role);
  }

  /// Draws what is stored: beside each slab a square for each of its edges.
  void table(Scene& scene) const {
    const double size = 0.15, pitch = 0.22;
    for (int i = 0; i < count(); ++i) {
      const double y = (slab(i).bottom + slab(i + 1).bottom) / 2;
      for (Index k = 0; k < entries(i); ++k) {
        const Index at = slab(i).first + k;
        const bool here = i == d_.slab, asked = here && map_.order[at] == d_.asked;
        const bool gone = here && d_.narrowed && !asked && (at < d_.lo || at >= d_.hi);
        add_cell(scene, s_.frame.table((static_cast<double>(k) + 0.5) * pitch), y, size * unit(),
                 asked  ? Role::highlight
                 : gone ? Role::muted
                 : here ? Role::second
                        : Role::construction,
                 asked);
      }
    }
    scene.items.emplace_back(viz::Heading{{s_.frame.table(1), s_.frame.high, 0},
                                          fmt::format("{} edges stored", map_.order.size()),
                                          Role::text,
                                          2 * unit()});
  }

  const Setup& s_;
  const SlabMap& map_;
  const DrawnSlabs& d_;
};

}  // namespace

Scene picture(const Setup& setup, const SlabMap& map, const DrawnSlabs& drawn) {
  return SlabPicture(setup, map, drawn).all();
}

}  // namespace isect::lessons::concave_polygon_lesson
