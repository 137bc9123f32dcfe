#include "lessons/collision/picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/random.h"
#include "lessons/shared/moved_boxes.h"

namespace isect::lessons::collision_lesson {

using namespace viz;

Boxes few(const Parameters& values) {
  const Vec3& p = std::get<Vec3>(values.at("p"));
  Boxes boxes = {{{p.x() - 0.75, p.y() - 0.5}, {p.x() + 0.75, p.y() + 0.5}},
                 {{-1.75, -0.25}, {-0.5, 1.25}},
                 {{-0.25, -1.75}, {1.25, -0.5}},
                 {{0.5, 0.25}, {1.75, 1.5}},
                 {{1.5, -0.75}, {3, 0.5}},
                 {{2.25, -2}, {3.25, -1.25}}};
  move_boxes(values, boxes);
  return boxes;
}

Boxes many(int n) {
  bench::Random random(static_cast<std::uint64_t>(n));
  const double extent = std::sqrt(n);  // the density does not depend on n
  Boxes boxes;
  for (int i = 0; i < n; ++i) {
    const double x = random.uniform(0, extent), y = random.uniform(0, extent);
    boxes.push_back({{x, y}, {x + random.uniform(0.2, 0.6), y + random.uniform(0.2, 0.6)}});
  }
  return boxes;
}

Frame frame_of(const Boxes& boxes) {
  Aabb<double, 2> all = boxes.front();
  for (const Aabb<double, 2>& b : boxes) all = {all.lo.cwiseMin(b.lo), all.hi.cwiseMax(b.hi)};
  const Vec2 size = all.hi - all.lo;
  Frame frame;
  if (const double unit = std::max(size.x() / 5.75, size.y() / 3.5); unit > 0) frame.unit = unit;  // 1 for the few
  frame.below = all.lo.y() - 0.45 * frame.unit;
  frame.bottom = frame.below - frame.unit * (0.11 * static_cast<double>(boxes.size() - 1) + 0.1);
  frame.top = all.hi.y() + 0.5 * frame.unit;
  return frame;
}

namespace {

/// A place in a corner of box k that no other box covers, else in the lower left one.
Vec3 place_of_number(const Boxes& boxes, int k, double unit) {
  const Vec2 in = unit * Vec2(0.16, 0.18);
  const Aabb<double, 2> places = {boxes[k].lo + in, boxes[k].hi - in};
  for (const Vec3& p : corners(places)) {
    bool covered = false;
    for (int i = 0; i < static_cast<int>(boxes.size()); ++i)
      covered = covered || (i != k && ((p.head<2>() - middle(boxes[i]).head<2>()).cwiseAbs().array() <=
                                       ((boxes[i].hi - boxes[i].lo) / 2 + in).array())
                                          .all());
    if (!covered) return p;
  }
  return flat(places.lo);
}

}  // namespace

Scene picture(const Boxes& boxes, const Drawn& d, const Frame& frame) {
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
  std::vector<int> partners = d.also;
  if (d.j >= 0 && d.j != d.i) partners.push_back(d.j);
  for (const int j : partners)
    scene.items.emplace_back(Line{middle(boxes[d.i]), middle(boxes[j]), d.overlap ? Role::hit : Role::miss,
                                  d.overlap ? Pen::thick : Pen::construction});
  if (d.sweeping) {
    for (int k = 0; k < static_cast<int>(boxes.size()); ++k) {  // their intervals on the axis
      const double y = frame.below - 0.11 * frame.unit * k;
      const Role role = among(d.active, k) ? Role::first : Role::muted;
      scene.items.emplace_back(Line{{boxes[k].lo.x(), y, 0}, {boxes[k].hi.x(), y, 0}, role, Pen::thick});
    }
    scene.items.emplace_back(
        Line{{d.sweep, frame.bottom, 0}, {d.sweep, frame.top, 0}, Role::highlight, Pen::highlight});
  }
  for (int k = 0; k < static_cast<int>(boxes.size()); ++k)
    scene.items.emplace_back(Heading{place_of_number(boxes, k, frame.unit), std::to_string(k),
                                     k == d.i ? Role::first : Role::second, 0.3 * frame.unit, false});
  scene.handles.push_back({"p", Handle::Kind::point, middle(boxes[0]), Vec3::Zero(), Role::second});
  for (std::size_t k = 1; k < boxes.size(); ++k)
    scene.handles.push_back({.parameter = fmt::format("p{}", k),
                             .kind = Handle::Kind::point,
                             .at = middle(boxes[k]),
                             .role = Role::second,
                             .one_of = "another box"});
  return scene;
}

}  // namespace isect::lessons::collision_lesson
