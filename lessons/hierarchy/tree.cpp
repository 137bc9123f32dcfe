#include "lessons/hierarchy/tree.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "lessons/shared/moved_boxes.h"

namespace isect::lessons::hierarchy_lesson {

using namespace viz;
using Items = std::vector<Item>;

namespace {

Aabb<double, 2> around(double x, double y, double half_x, double half_y) {
  return {{x - half_x, y - half_y}, {x + half_x, y + half_y}};
}

std::string held(const Tree& tree, int leaf, const std::string& prefix) {
  std::string text;
  for (const int i : tree.below(leaf)) text += fmt::format("{}{}{}", text.empty() ? "" : ", ", prefix, i);
  return text;
}

}  // namespace

Boxes scattered(const Vec3& p, double size) {
  return {around(p.x(), p.y(), 0.3 * size, 0.25 * size),
          around(-2.75, 1.5, 0.25, 0.25),
          around(-3.25, 0.5, 0.375, 0.2),
          around(-1.75, 1.25, 0.2, 0.375),
          around(-1, 1.625, 0.3, 0.2),
          around(-1.125, 0.625, 0.25, 0.25),
          around(-3.5, -0.75, 0.25, 0.3),
          around(-2.75, -1.5, 0.375, 0.2),
          around(-1.875, -0.875, 0.25, 0.3),
          around(-0.875, -0.625, 0.3, 0.2),
          around(-0.25, -1.5, 0.25, 0.3),
          around(0.125, 0.5, 0.2, 0.375)};
}

Boxes cluster(const Vec3& middle) {
  Boxes boxes;
  for (const Vec2& at : {Vec2(-0.75, 0.4375), Vec2(-0.5, -0.4375), Vec2(0.125, 0.125), Vec2(0.75, 0.625),
                         Vec2(0.625, -0.5), Vec2(1.25, 0)})
    boxes.push_back(around(middle.x() + at.x(), middle.y() + at.y(), 0.25, 0.1875));
  return boxes;
}

Boxes boxes_of(const Parameters& values) {
  const std::string& walk = std::get<std::string>(values.at("walk"));
  const bool sized = walk == "build" || walk == "ray";
  Boxes boxes = scattered(std::get<Vec3>(values.at("p")), sized ? std::get<double>(values.at("size")) : 1);
  move_boxes(values, boxes);
  return boxes;
}

void add_handles_of_others(const Boxes& boxes, Scene& scene) {
  for (std::size_t k = 1; k < boxes.size(); ++k)
    scene.handles.push_back({.parameter = fmt::format("p{}", k),
                             .kind = Handle::Kind::shift,
                             .at = flat(boxes[k].lo),
                             .anchor = flat(boxes[k].lo) - middle(boxes[k]),
                             .role = Role::second,
                             .one_of = "another box"});
}

TreePlace place_beside(const Boxes& boxes) {
  Vec2 lo = boxes.front().lo, hi = boxes.front().hi;
  for (const Aabb<double, 2>& box : boxes) lo = lo.cwiseMin(box.lo), hi = hi.cwiseMax(box.hi);
  const double unit = std::max((hi.x() - lo.x()) / 4.2, (hi.y() - lo.y()) / 3.55);  // spans of the lesson's boxes
  const Vec2 corner = {hi.x() + 0.9 * unit, (lo.y() + hi.y()) / 2 - 1.5 * unit};
  return {corner, corner + Vec2(3.75, 3.125) * unit, unit};
}

Tree::Tree(Boxes the_boxes, const TreePlace& the_place)
    : boxes(std::move(the_boxes)), place(the_place), bvh(build_bvh(boxes, options)) {}

std::vector<int> Tree::below(int i) const {
  const BvhNode<double, 2>& n = node(i);
  if (n.leaf()) return {bvh.primitives.begin() + n.first, bvh.primitives.begin() + n.first + n.count};
  std::vector<int> all = below(n.first);
  for (const int primitive : below(n.first + 1)) all.push_back(primitive);
  std::ranges::sort(all);
  return all;
}

int Tree::height(int i) const {
  const BvhNode<double, 2>& n = node(i);
  return n.leaf() ? 0 : 1 + std::max(height(n.first), height(n.first + 1));
}

Items nested(const Tree& tree, const Drawn& drawn) {
  Items items;
  for (int i = 0; i < static_cast<int>(tree.boxes.size()); ++i) {
    const bool hit = std::ranges::find(drawn.hits, i) != drawn.hits.end();
    items.push_back(Region{.rings = {corners(tree.box(i))}, .role = hit ? Role::hit : drawn.role});
    const Vec2 middle = (tree.box(i).lo + tree.box(i).hi) / 2;
    items.push_back(viz::Heading{flat(middle), fmt::format("{}{}", drawn.prefix, i), hit ? Role::hit : drawn.role,
                                 0.36 * tree.place.unit, false});
  }
  for (int i = 0; i < tree.size(); ++i) {
    const State state = drawn.states[i];
    const Aabb<double, 2>& box = tree.node(i).box;
    if (state == State::seen || state == State::waiting)
      items.push_back(Chain{corners(box), true, Role::construction, Pen::construction});
    if (state == State::current) items.push_back(Chain{corners(box), true, Role::highlight, Pen::highlight});
    if (state != State::pruned) continue;
    const std::vector<Vec3> c = corners(box);
    items.push_back(Chain{c, true, Role::miss, Pen::construction});
    items.push_back(Dot{c[2], Mark::no, Role::miss});
  }
  return items;
}

Items branches(const Tree& tree, const Drawn& drawn, const Vec2& lo, const Vec2& hi) {
  std::vector<Vec3> at(drawn.states.size());
  std::vector<double> widths(drawn.states.size());  // of leaves, as their texts need
  double all = 0;
  for (int i = 0; i < tree.size(); ++i)
    if (tree.node(i).leaf()) all += widths[i] = 3 + static_cast<double>(held(tree, i, drawn.prefix).size());
  for (double& width : widths) width *= (hi.x() - lo.x()) / all;
  const double row = (hi.y() - lo.y()) / std::max(1, tree.height(0));
  double next = lo.x();
  const std::function<void(int, int)> place = [&](int i, int depth) {
    const BvhNode<double, 2>& n = tree.node(i);
    const double width = widths[i];
    double x = next + width / 2;
    if (n.leaf()) {
      next += width;
    } else {
      place(n.first, depth + 1), place(n.first + 1, depth + 1);
      x = (at[n.first].x() + at[n.first + 1].x()) / 2;
    }
    at[i] = {x, hi.y() - depth * row, 0};
  };
  place(0, 0);

  Items items;
  const auto state = [&](int i) { return drawn.states[i]; };
  for (int i = 0; i < tree.size(); ++i) {
    const BvhNode<double, 2>& n = tree.node(i);
    if (n.leaf() || state(n.first) == State::hidden) continue;
    for (const int child : {n.first, n.first + 1}) {
      const bool unseen = state(child) == State::unseen, pruned = state(child) == State::pruned;
      items.push_back(
          Line{at[i], at[child], pruned ? Role::miss : Role::muted, unseen || pruned ? Pen::construction : Pen::solid});
    }
  }
  for (int i = 0; i < tree.size(); ++i) {
    const Vec3& p = at[i];
    if (state(i) == State::hidden) continue;
    items.push_back(state(i) == State::current  ? Dot{p, Mark::diamond, Role::highlight}
                    : state(i) == State::pruned ? Dot{p, Mark::no, Role::miss}
                    : state(i) == State::seen   ? Dot{p, Mark::disc, drawn.role}
                                                : Dot{p, Mark::ring, drawn.role});
    if (tree.node(i).leaf())
      items.push_back(viz::Heading{p - Vec3(0, 0.28 * tree.place.unit, 0), held(tree, i, drawn.prefix), drawn.role,
                                   0.8 * widths[i], false});
  }
  return items;
}

}  // namespace isect::lessons::hierarchy_lesson
