#include "lessons/culling/culled.h"

#include <cmath>

#include "bench/random.h"

namespace isect::lessons::culling_lesson {

using namespace viz;

std::vector<Box> few() {
  const Vec3 half = Vec3::Constant(0.3125);
  std::vector<Box> boxes;
  for (const Vec3& cluster : {Vec3(1.25, 0, -0.5), Vec3(-2, 0, -2.5), Vec3(-1, 0, 3), Vec3(3.25, 0.25, 2)})
    for (const Vec3& at :
         {Vec3(-0.625, -0.25, 0.5), Vec3(0.5, -0.25, -0.5), Vec3(-0.5, 0.25, -0.5), Vec3(0.5, 0.25, 0.5)})
      boxes.push_back({cluster + at - half, cluster + at + half});
  return boxes;
}

std::vector<Box> many(int n, const Vec3& eye) {
  bench::Random random(static_cast<std::uint64_t>(n));
  std::vector<Box> boxes;
  for (int i = 0; i < n; ++i) {
    const double z = random.uniform(-8, 8), y = random.uniform(-2, 2), x = random.uniform(-8, 8);
    const Vec3 at = eye + Vec3(x, y, z);  // drawn before: arguments have no order
    const Vec3 half = Vec3::Constant(2 / std::cbrt(n));
    boxes.push_back({at - half, at + half});
  }
  return boxes;
}

namespace {

void draw_all_below(const Bvh<double, 3>& bvh, int node, Culled& result) {
  const BvhNode<double, 3>& n = bvh.nodes[node];
  for (int k = 0; k < n.count; ++k) result.drawn.push_back(bvh.primitives[n.first + k]);
  if (n.leaf()) return;
  draw_all_below(bvh, n.first, result);
  draw_all_below(bvh, n.first + 1, result);
}

void visit(const Bvh<double, 3>& bvh, const std::vector<Box>& boxes, const Frustum<double>& view, int node,
           Culled& result) {
  const BvhNode<double, 3>& n = bvh.nodes[node];
  Visit visited = {node, ask(n.box, view), {}};
  ++result.tests;
  if (visited.answer.culling == Culling::inside) draw_all_below(bvh, node, result);
  if (visited.answer.culling == Culling::crossing)
    for (int k = 0; k < n.count; ++k) {
      const int box = bvh.primitives[n.first + k];
      visited.tested.emplace_back(box, ask(boxes[box], view));
      ++result.tests;
      if (visited.tested.back().second.culling != Culling::outside) result.drawn.push_back(box);
    }
  result.visits.push_back(visited);
  if (visited.answer.culling != Culling::crossing || n.leaf()) return;
  visit(bvh, boxes, view, n.first, result);
  visit(bvh, boxes, view, n.first + 1, result);
}

}  // namespace

Culled culled(const Bvh<double, 3>& bvh, const std::vector<Box>& boxes, const Frustum<double>& view) {
  Culled result;
  visit(bvh, boxes, view, 0, result);
  return result;
}

}  // namespace isect::lessons::culling_lesson
