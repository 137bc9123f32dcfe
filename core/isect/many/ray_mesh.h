#pragma once
// A triangle mesh prepared for many rays: the hierarchy of isect/many/bvh.h four children wide, its boxes in float, and
// the triangles in the order of its leaves.
//
// A ray waits for memory more than for arithmetic. So a node with its four boxes fills two cache lines, what is to be
// visited later is fetched at once, and leaves hold their triangles themselves. Boxes are rounded outwards and asked
// four at a time; a box that the ray meets is never missed. Triangles are screened two at a time, in double, and the
// rest take the exact test. So the answers are those of isect/triangle_mesh.h. See
// isect/parts/ray_mesh_parts.h for the bounds.
//
// Source: Wald, Benthin, Boulos, Getting rid of packets: efficient SIMD single-ray traversal using multi-branching
// BVHs, IEEE Symposium on Interactive Ray Tracing (2008); Ize, Robust BVH ray traversal, J. Computer Graphics
// Techniques 2 (2013), for rounding outwards.

#include <array>
#include <bit>
#include <optional>
#include <vector>

#include <isect/many/bvh_ray.h>
#include <isect/parts/ray_mesh_parts.h>
#include <isect/triangle_mesh.h>

namespace isect {

/// Memory: 72 bytes a triangle in double, 36 in float, and 4 for its index; about 30 for the nodes.
template <class S>
struct RayMesh {
  std::vector<ray_mesh::detail::Node> nodes;  ///< node 0 is the root, if there are nodes
  std::vector<Triangle<S, 3>> triangles;
  std::vector<int> indices;  ///< of the triangles in the mesh
  double reach = 0;          ///< the largest absolute value of a coordinate
};

namespace ray_mesh {

namespace detail {

/// A few triangles are screened while a node is fetched; by measurement.
inline constexpr BvhOptions options = {.largest_leaf = 8, .visit = 3};

/// Some nodes of the binary hierarchy.
struct Family {
  std::array<int, width> nodes;
  int count;
};

/// The children of one wide node. It starts with the node itself; then the largest inner one is replaced by its two
/// children until there are enough.
template <class S>
Family widened(const Bvh<S, 3>& bvh, int index) {
  const S unit = bvh::detail::scale(bvh.nodes[0].box);
  Family family = {{index}, 1};
  while (family.count < width) {
    int largest = -1;
    S area = -1;
    for (int k = 0; k < family.count; ++k) {
      const BvhNode<S, 3>& node = bvh.nodes[family.nodes[k]];
      if (const S own = bvh::detail::area(node.box, unit); !node.leaf() && own > area) largest = k, area = own;
    }
    if (largest < 0) break;
    const int first = bvh.nodes[family.nodes[largest]].first;
    family.nodes[largest] = first, family.nodes[family.count++] = first + 1;
  }
  return family;
}

}  // namespace detail

}  // namespace ray_mesh

/// Prepares the mesh. O(n lg n), nearly all of it in build_bvh. A triangle with a NaN or infinite coordinate is left
/// out.
template <class S>
RayMesh<S> make_ray_mesh(const TriangleMesh<S>& mesh) {
  std::vector<Aabb<S, 3>> around = boxes(mesh);
  for (std::size_t i = 0; i < around.size(); ++i)
    if (!finite(triangle(mesh, static_cast<int>(i)))) around[i] = bvh::detail::nothing<S, 3>();
  const Bvh<S, 3> bvh = build_bvh(around, ray_mesh::detail::options);

  RayMesh<S> result;
  result.indices = bvh.primitives;
  result.triangles.reserve(bvh.primitives.size());
  for (const int index : bvh.primitives) result.triangles.push_back(triangle(mesh, index));
  if (bvh.nodes.empty()) return result;
  const Aabb<S, 3>& all = bvh.nodes[0].box;
  result.reach = all.lo.cwiseAbs().cwiseMax(all.hi.cwiseAbs()).maxCoeff();

  struct Task {
    int from, to;
  };
  std::vector<Task> tasks = {{0, 0}};
  result.nodes.resize(1);
  while (!tasks.empty()) {
    const Task task = tasks.back();
    tasks.pop_back();
    const ray_mesh::detail::Family family = ray_mesh::detail::widened(bvh, task.from);
    result.nodes[task.to].children = static_cast<std::uint8_t>(family.count);
    for (int k = 0; k < family.count; ++k) {
      const BvhNode<S, 3>& child = bvh.nodes[family.nodes[k]];
      const int first = child.leaf() ? child.first : static_cast<int>(result.nodes.size());
      if (!child.leaf()) result.nodes.emplace_back(), tasks.push_back({family.nodes[k], first});
      ray_mesh::detail::Node& node = result.nodes[task.to];
      ray_mesh::detail::put(node, k, child.box);
      node.first[k] = first, node.count[k] = static_cast<std::uint8_t>(child.count);
    }
  }
  return result;
}

namespace ray_mesh {

namespace detail {

/// Brings a node or the triangles of a leaf nearer to the processor, without waiting for them.
template <class S>
void fetch(const RayMesh<S>& mesh, int first, int count) {
  const char* const from = count > 0 ? reinterpret_cast<const char*>(&mesh.triangles[first])
                                     : reinterpret_cast<const char*>(&mesh.nodes[first]);
  for (int line = 0; line < 2 + (count > 0); ++line) __builtin_prefetch(from + 64 * line);
}

/// Calls visit(triangle, sign) for the triangles that the ray's line may meet, in leaves whose boxes the ray meets up
/// to `end`, the nearest first, until it returns true. visit may lower `end`; `sign` is that of the volumes, or 0 where
/// those are not sure.
template <class S, class Visit>
void each_near(const RayMesh<S>& mesh, const Ray<S, 3>& ray, const float& end, const Visit& visit) {
  struct Waiting {
    float entry;
    int first, count;
  };
  std::array<Waiting, (width - 1) * bvh::detail::deepest + width> stack;
  int waiting = 0;
  const Line line(ray);
  const Screen screen(cast<double>(ray), mesh.reach);
  stack[waiting++] = {line.start, 0, 0};
  while (waiting > 0) {
    const Waiting next = stack[--waiting];
    if (next.entry > end) continue;
    for (int i = next.first, last = i + next.count - 1; i <= last; i += 2) {
      const int j = std::min(i + 1, last);
      const auto [one, other] = screen(mesh.triangles[i], mesh.triangles[j]);
      if (!one.missed && visit(i, one.sign)) return;
      if (i < j && !other.missed && visit(j, other.sign)) return;
    }
    if (next.count > 0) continue;

    const Node& node = mesh.nodes[next.first];
    Four in;
    const int bottom = waiting;
    for (std::uint64_t rest = met(node, line, end, in); rest != 0; rest &= rest - 1) {
      const int k = std::countr_zero(rest);
      const Waiting child = {in[k], node.first[k], node.count[k]};
      fetch(mesh, child.first, child.count);
      int place = waiting++;
      for (; place > bottom && stack[place - 1].entry < child.entry; --place) stack[place] = stack[place - 1];
      stack[place] = child;
    }
  }
}

/// An end beyond which no node is entered that holds a triangle with a reported t <= `t`.
template <class S>
float end(const S& t) {
  float result = up(bvh_ray::detail::beyond(t));
  delay(result);
  return result;
}

template <class S>
bool askable(const RayMesh<S>& mesh, const Ray<S, 3>& ray) {
  return !mesh.nodes.empty() && finite(ray) && ray.range.lo <= ray.range.hi;
}

}  // namespace detail

}  // namespace ray_mesh

/// The closest hit of the ray: what closest_hit(bvh, mesh, ray) returns.
template <class S>
std::optional<BvhHit<S>> closest_hit(const RayMesh<S>& mesh, const Ray<S, 3>& ray) {
  if (!ray_mesh::detail::askable(mesh, ray)) return {};
  std::optional<BvhHit<S>> closest;
  float end = ray_mesh::detail::end(ray.range.hi);
  ray_mesh::detail::each_near(mesh, ray, end, [&](int i, int sign) {
    const std::optional<S> t = triangle_mesh::detail::first_t(ray, mesh.triangles[i], sign);
    const int index = mesh.indices[i];
    if (!t || (closest && !(*t < closest->t || (*t == closest->t && index < closest->primitive)))) return false;
    closest = BvhHit<S>{*t, index};
    end = ray_mesh::detail::end(*t);
    return false;
  });
  return closest;
}

/// Whether the ray meets any triangle.
template <class S>
bool any_hit(const RayMesh<S>& mesh, const Ray<S, 3>& ray) {
  if (!ray_mesh::detail::askable(mesh, ray)) return false;
  bool hit = false;
  const float end = ray_mesh::detail::end(ray.range.hi);
  ray_mesh::detail::each_near(mesh, ray, end, [&](int i, int sign) {
    return hit = triangle_mesh::detail::first_t(ray, mesh.triangles[i], sign).has_value();
  });
  return hit;
}

}  // namespace isect
