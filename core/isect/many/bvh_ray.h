#pragma once
// A ray through a hierarchy of boxes: the closest hit, any, or all.
//
// The nearer of two children is visited first. Once a hit at t is known, nodes that the ray enters beyond t are pruned
// unseen. A box test that rounds the wrong way would lose hits, so this one never says no to a box that the ray meets;
// a false positive only costs a visit. Source: Kay, Kajiya, Ray tracing complex scenes, SIGGRAPH (1986).

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <variant>
#include <vector>

#include <isect/many/bvh.h>
#include <isect/ray_aabb.h>

namespace isect {

/// The ray's parameter at the hit, and the index of the primitive.
template <class S>
struct BvhHit {
  S t;
  int primitive;
  friend bool operator==(const BvhHit&, const BvhHit&) = default;
};

namespace bvh_ray {

enum class Why {
  missed,  ///< the ray passes the box by
  farther  ///< it enters the box beyond the closest hit
};
/// A node whose children or primitives are looked at next; the ray enters it at t = entry, nearly.
template <class S>
struct Visited {
  int node;
  S entry;
};
struct Pruned {
  int node;
  Why why;
};
/// A primitive that was tested, and the result.
template <class S>
struct Tested {
  int primitive;
  std::optional<S> t;
};
/// The new closest hit.
template <class S>
struct Closer {
  int primitive;
  S t;
};
template <class S>
using Event = std::variant<Visited<S>, Pruned, Tested<S>, Closer<S>>;

/// A listener that counts: `Counts counts; closest_hit(bvh, ray, hit, counts);`
struct Counts {
  long visited = 0, missed = 0, farther = 0, tested = 0;

  // clang-format off
  template <class S> void operator()(const Visited<S>&) { ++visited; }
  void operator()(const Pruned& event) { ++(event.why == Why::missed ? missed : farther); }
  template <class S> void operator()(const Tested<S>&) { ++tested; }
  template <class S> void operator()(const Closer<S>&) {}
  // clang-format on
};

namespace detail {

/// Where the ray, up to t = `end`, may enter a box, rounded; nothing if it certainly does not meet it. The
/// comparisons and their bound are may_intersect's; the box must be finite and not empty, as those of a hierarchy
/// are.
///
/// The result is never beyond `end`, and beyond the true entry T by at most 2 eps |T| and a subnormal.
template <class S, int N>
ISECT_INLINE std::optional<S> entry(const ray_aabb::Prepared<S, N>& ray, S end, const Aabb<S, N>& box) {
  const Point<S, N>* const ends[2] = {&box.lo, &box.hi};  // an index, as a condition would be a branch
  S in = ray.range.lo, out = end;
  for (int i = 0; i < N; ++i) {
    const S enter = ((*ends[ray.backwards[i]])[i] - ray.origin[i]) * ray.inverse[i];
    const S leave = ((*ends[!ray.backwards[i]])[i] - ray.origin[i]) * ray.inverse[i];
    in = enter > in ? enter : in;
    out = leave < out ? leave : out;
  }
  using Limits = std::numeric_limits<S>;
  if (in <= out + (4 * Limits::epsilon() * std::abs(out) + 4 * Limits::denorm_min())) return std::min(in, end);
  if (std::isfinite(in) && std::isfinite(out)) return {};
  if (!ray_aabb::detail::may_at_infinity(ray, box)) return {};
  return std::min(ray.range.lo, end);
}

/// An end of the range that cuts off nothing with a reported t <= `t`. That t may lie 4 ulp, at most 4 eps |t|, below
/// the true one, which an entry may exceed by 2 eps |t| more.
template <class S>
S beyond(S t) {
  using Limits = std::numeric_limits<S>;
  return t + (8 * Limits::epsilon() * std::abs(t) + 8 * Limits::denorm_min());
}

}  // namespace detail

}  // namespace bvh_ray

/// Returns the closest hit of the ray among the primitives: that of least t, and of least index among those with that
/// t; nothing when the ray meets none. Asking every primitive over the whole range gives the same.
///
/// hit(primitive) returns a std::optional<S>: the t of the ray's range at which it meets the primitive first. It must
/// lie within 4 ulp of the true one, at which the ray is in the primitive's box, and not be NaN. It is always asked
/// over the whole range: a rounded t may depend on the range, and then on the order of visits. A ray with NaN or an
/// infinite coordinate, or an empty range: nothing.
template <class S, int N, class Hit, class Trace = NoTrace>
std::optional<BvhHit<S>> closest_hit(const Bvh<S, N>& bvh, const Ray<S, N>& ray, const Hit& hit, Trace&& trace = {}) {
  using namespace bvh_ray;
  using namespace bvh_ray::detail;
  const ray_aabb::Prepared<S, N> line = ray_aabb::prepare(ray);
  if (bvh.nodes.empty() || !(line.range.lo <= line.range.hi)) return {};

  struct Waiting {
    int node;
    S entry;
  };
  std::array<Waiting, bvh::detail::deepest + 1> stack;
  int waiting = 0;
  std::optional<BvhHit<S>> closest;
  S end = ray.range.hi;  // later the closest hit, and a little more

  const std::optional<S> root = entry(line, end, bvh.nodes[0].box);
  if (!root) {
    trace(Pruned{0, Why::missed});
  }
  if (root) stack[waiting++] = {0, *root};
  while (waiting > 0) {
    const Waiting next = stack[--waiting];
    if (next.entry > end) {
      trace(Pruned{next.node, Why::farther});
      continue;
    }
    const BvhNode<S, N>& node = bvh.nodes[next.node];
    trace(Visited<S>{next.node, next.entry});

    for (int i = node.first; i < node.first + node.count; ++i) {  // of a leaf
      const int primitive = bvh.primitives[i];
      const std::optional<S> t = hit(primitive);
      trace(Tested<S>{primitive, t});
      if (!t || (closest && !(*t < closest->t || (*t == closest->t && primitive < closest->primitive)))) continue;
      closest = BvhHit<S>{*t, primitive};
      end = std::min(ray.range.hi, beyond(*t));
      trace(Closer<S>{primitive, *t});
    }
    if (node.leaf()) continue;

    int near = node.first, far = node.first + 1;
    std::optional<S> near_entry = entry(line, end, bvh.nodes[near].box);
    std::optional<S> far_entry = entry(line, end, bvh.nodes[far].box);
    if (near_entry && far_entry && *far_entry < *near_entry) std::swap(near, far), std::swap(near_entry, far_entry);
    if (!near_entry) {
      trace(Pruned{near, Why::missed});
    }
    if (!far_entry) {
      trace(Pruned{far, Why::missed});
    }
    if (far_entry) stack[waiting++] = {far, *far_entry};
    if (near_entry) stack[waiting++] = {near, *near_entry};
  }
  return closest;
}

/// Whether the ray meets any of the primitives, for shadows and lines of sight: the first one found ends the search.
/// `hit` and the input checks are those of closest_hit, but only whether there is a t matters.
template <class S, int N, class Hit, class Trace = NoTrace>
bool any_hit(const Bvh<S, N>& bvh, const Ray<S, N>& ray, const Hit& hit, Trace&& trace = {}) {
  using namespace bvh_ray;
  using namespace bvh_ray::detail;
  const ray_aabb::Prepared<S, N> line = ray_aabb::prepare(ray);
  if (bvh.nodes.empty() || !(line.range.lo <= line.range.hi)) return false;

  std::array<int, bvh::detail::deepest + 1> stack;
  int waiting = 0;
  stack[waiting++] = 0;
  while (waiting > 0) {
    const int index = stack[--waiting];
    const BvhNode<S, N>& node = bvh.nodes[index];
    const std::optional<S> enters = entry(line, ray.range.hi, node.box);
    if (!enters) {
      trace(Pruned{index, Why::missed});
      continue;
    }
    trace(Visited<S>{index, *enters});

    if (!node.leaf()) {
      stack[waiting++] = node.first + 1;
      stack[waiting++] = node.first;
    }
    for (int i = node.first; i < node.first + node.count; ++i) {
      const std::optional<S> t = hit(bvh.primitives[i]);
      trace(Tested<S>{bvh.primitives[i], t});
      if (t) return true;
    }
  }
  return false;
}

/// Returns all hits of the ray among the primitives, the first of each, by rising t, and by index among those with one
/// t. `hit` and the input checks are those of closest_hit.
template <class S, int N, class Hit, class Trace = NoTrace>
std::vector<BvhHit<S>> all_hits(const Bvh<S, N>& bvh, const Ray<S, N>& ray, const Hit& hit, Trace&& trace = {}) {
  std::vector<BvhHit<S>> hits;
  const auto collect = [&](int primitive) -> std::optional<S> {
    if (const std::optional<S> t = hit(primitive)) hits.push_back({*t, primitive});
    return {};  // and go on
  };
  any_hit(bvh, ray, collect, trace);
  std::ranges::sort(
      hits, [](const BvhHit<S>& x, const BvhHit<S>& y) { return x.t != y.t ? x.t < y.t : x.primitive < y.primitive; });
  return hits;
}

}  // namespace isect
