#include "lessons/collision/picture.h"

#include <algorithm>
#include <cmath>

#include "bench/random.h"

namespace isect::lessons::collision_lesson {

using namespace viz;

Boxes few(const Vec3& p) {
  return {{{p.x() - 0.75, p.y() - 0.5}, {p.x() + 0.75, p.y() + 0.5}},
          {{-1.75, -0.25}, {-0.5, 1.25}},
          {{-0.25, -1.75}, {1.25, -0.5}},
          {{0.5, 0.25}, {1.75, 1.5}},
          {{1.5, -0.75}, {3, 0.5}},
          {{2.25, -2}, {3.25, -1.25}}};
}

Boxes many(int n) {
  bench::Random random(static_cast<std::uint64_t>(n));
  const double extent = std::sqrt(n);  // the density stays
  Boxes boxes;
  for (int i = 0; i < n; ++i) {
    const double x = random.uniform(0, extent), y = random.uniform(0, extent);
    boxes.push_back({{x, y}, {x + random.uniform(0.2, 0.6), y + random.uniform(0.2, 0.6)}});
  }
  return boxes;
}

Scene picture(const Boxes& boxes, const Drawn& d) {
  Scene scene;
  for (const Aabb<double, 2>& node : d.nodes)
    scene.items.emplace_back(Chain{corners(node), true, Role::construction, Pen::construction});
  const auto among = [](const std::vector<int>& list, int k) { return std::ranges::find(list, k) != list.end(); };
  for (int k = 0; k < static_cast<int>(boxes.size()); ++k) {
    const bool first = k == d.i || (d.i < 0 && d.sweeping && among(d.active, k));
    Region box;
    box.rings = {corners(boxes[k])};
    box.role = first ? Role::first : Role::second;
    scene.items.emplace_back(box);
  }
  for (const Aabb<double, 2>& node : d.compared)
    scene.items.emplace_back(Chain{corners(node), true, Role::highlight, Pen::highlight});
  for (const auto& [i, j] : d.found) {
    const Aabb<double, 2>&a = boxes[i], &b = boxes[j];
    Region shared;
    shared.rings = {corners({a.lo.cwiseMax(b.lo), a.hi.cwiseMin(b.hi)})};
    shared.role = Role::hit;
    scene.items.emplace_back(shared);
  }
  if (d.j >= 0 && d.j != d.i) {
    const Vec3 a = middle(boxes[d.i]), b = middle(boxes[d.j]);
    scene.items.emplace_back(
        Line{a, b, d.overlap ? Role::hit : Role::miss, d.overlap ? Pen::thick : Pen::construction});
  }
  if (d.sweeping) scene.items.emplace_back(Line{{d.sweep, -2.5, 0}, {d.sweep, 2, 0}, Role::highlight, Pen::highlight});
  for (int k = 0; k < static_cast<int>(boxes.size()); ++k) {
    const Aabb<double, 2>& b = boxes[k];
    scene.items.emplace_back(Label{{b.lo.x(), b.lo.y(), 0}, std::to_string(k), k == d.i ? Role::first : Role::second});
  }
  scene.handles.push_back({"p", Handle::Kind::point, middle(boxes[0]), Vec3::Zero(), Role::second});
  return scene;
}

}  // namespace isect::lessons::collision_lesson
