#include "viz/compose/facet_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>

#include "viz/compose/locate_point.h"

namespace isect::viz {
namespace {

struct KeptTree {
  std::vector<Vec3> vertices;
  std::vector<std::array<int, 3>> triangles;
  std::shared_ptr<const FacetTree> tree;
};

std::shared_ptr<const FacetTree> built(const Mesh& mesh) {
  std::vector<Aabb<double, 3>> boxes;
  boxes.reserve(mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3 &p = mesh.vertices[a], &q = mesh.vertices[b], &r = mesh.vertices[c];
    boxes.push_back({p.cwiseMin(q).cwiseMin(r), p.cwiseMax(q).cwiseMax(r)});
  }
  return std::make_shared<const FacetTree>(build_bvh(boxes));
}

/// Where the eye sees a box: within the hull of its corners, but for a rounding.
struct SeenBox {
  SeenBox(const Aabb<double, 3>& box, const View& view) {
    const bool perspective = view.camera().perspective;
    double nearest = HUGE_VAL, reach = 0, size = view.width() + view.height();
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Vec3 corner((k & 1 ? box.hi : box.lo).x(), (k & 2 ? box.hi : box.lo).y(), (k & 4 ? box.hi : box.lo).z());
      const Projected seen = view.project(corner);
      corners[k] = seen.at;
      least = least.cwiseMin(seen.at), most = most.cwiseMax(seen.at);
      nearest = std::min(nearest, seen.depth);
      reach = std::max(reach, (corner - view.eye()).norm());
      size = std::max(size, view.scale_at(corner) * (corner - view.camera().target).norm());
    }
    anywhere = perspective && !(nearest > 1e-4 * reach);
    rounding = 1e-9 * (size + least.norm() + most.norm());
  }

  std::array<Vec2, 8> corners;
  Vec2 least = Vec2::Constant(HUGE_VAL), most = Vec2::Constant(-HUGE_VAL);  ///< the rectangle around them
  double rounding = 0;                                                      ///< more than that of any place in the box
  bool anywhere = false;  ///< a part may lie beside or behind the eye, and so be seen in any place
};

/// Asks `may` of boxes from the root down, and `ask` of each facet in the boxes of which it is true; `work` keeps the
/// facets of which that is true.
template <class May, class Ask>
void search(const SortedMesh& all, const View& view, FacetsFound& work, const May& may, const Ask& ask) {
  const FacetTree& tree = *all.tree;
  if (tree.nodes.empty()) return;
  std::vector<int> waiting = {0};
  while (!waiting.empty()) {
    const BvhNode<double, 3>& node = tree.nodes[static_cast<std::size_t>(waiting.back())];
    waiting.pop_back();
    ++work.boxes;
    if (const SeenBox box(node.box, view); !box.anywhere && !may(box)) continue;
    if (!node.leaf()) {
      waiting.insert(waiting.end(), {node.first, node.first + 1});
      continue;
    }
    for (int i = node.first; i < node.first + node.count; ++i) {
      const int facet = tree.primitives[static_cast<std::size_t>(i)];
      const auto& [a, b, c] = all.mesh->triangles[static_cast<std::size_t>(facet)];
      const auto at = [&](int vertex) { return view.project(all.mesh->vertices[static_cast<std::size_t>(vertex)]).at; };
      ++work.asked;
      if (ask(std::array<Vec2, 3>{at(a), at(b), at(c)})) work.facets.push_back(facet);
    }
  }
  std::ranges::sort(work.facets);
}

}  // namespace

std::shared_ptr<const FacetTree> facet_tree(const Mesh& mesh) {
  constexpr std::size_t most_kept = 500'000;  // facets, with 200 bytes each; the last one is kept anyway
  thread_local std::deque<KeptTree> kept;     // the latest first
  const auto found = std::ranges::find_if(
      kept, [&](const KeptTree& k) { return k.vertices == mesh.vertices && k.triangles == mesh.triangles; });
  if (found != kept.end()) {
    std::rotate(kept.begin(), found, found + 1);
    return kept.front().tree;
  }
  kept.push_front({mesh.vertices, mesh.triangles, built(mesh)});
  std::size_t facets = 0;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    facets += kept[i].triangles.size();
    if (i > 0 && facets > most_kept) kept.resize(i);
  }
  return kept.front().tree;
}

FacetsFound facets_across(const SortedMesh& all, const View& view, const Vec3& from, const Vec3& to) {
  const Vec2 p = view.project(from).at, q = view.project(to).at, lo = p.cwiseMin(q), hi = p.cwiseMax(q);
  const auto side = [&](const Vec2& x) { return (q - p).x() * (x - p).y() - (q - p).y() * (x - p).x(); };
  const auto may = [&](const SeenBox& box) {
    const double rounding = box.rounding + 1e-9 * (p.norm() + q.norm()), doubt = 2 * rounding * (q - p).norm();
    if (((box.most - lo).array() < -rounding).any() || ((hi - box.least).array() < -rounding).any()) return false;
    double left = side(box.corners[0]), right = left;
    for (const Vec2& corner : box.corners) left = std::min(left, side(corner)), right = std::max(right, side(corner));
    return !(left > doubt || right < -doubt);
  };
  FacetsFound found;
  search(all, view, found, may, [&](const std::array<Vec2, 3>& x) {
    const Vec2 least = x[0].cwiseMin(x[1]).cwiseMin(x[2]), most = x[0].cwiseMax(x[1]).cwiseMax(x[2]);
    if ((most.array() < lo.array()).any() || (hi.array() < least.array()).any()) return false;
    const auto [left, right] = std::minmax({side(x[0]), side(x[1]), side(x[2])});
    return left <= 0 && right >= 0;
  });
  return found;
}

FacetsFound facet_over(const SortedMesh& all, const View& view, const Vec2& place) {
  FacetsFound found;
  const auto may = [&](const SeenBox& box) {
    return found.facets.empty() && !((box.most - place).array() < -box.rounding).any() &&
           !((place - box.least).array() < -box.rounding).any();
  };
  search(all, view, found, may, [&](const std::array<Vec2, 3>& x) {
    return found.facets.empty() && locate(x[0], x[1], x[2], place) == Location::in;
  });
  return found;
}

}  // namespace isect::viz
