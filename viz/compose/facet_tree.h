#pragma once
// A mesh's facets in the core's hierarchy of boxes: what hides a line, or lies under a place of the picture, is found
// among a few of them, however many there are.

#include <memory>
#include <vector>

#include <isect/many/bvh.h>
#include "viz/camera.h"
#include "viz/scene.h"

namespace isect::viz {

using FacetTree = Bvh<double, 3>;

/// Returns the hierarchy of the mesh's facets. Those built last are kept: a mesh with the same vertices and facets, as
/// in the next picture, has its own again.
std::shared_ptr<const FacetTree> facet_tree(const Mesh&);

/// A mesh of a scene, with its hierarchy.
struct SortedMesh {
  const Mesh* mesh;
  std::shared_ptr<const FacetTree> tree;
};

/// What a search found, and its work.
struct FacetsFound {
  std::vector<int> facets = {};  ///< indices of the mesh's triangles, ascending
  int boxes = 0, asked = 0;      ///< how many boxes of the hierarchy were looked at, how many facets
};

/// Returns the facets that the eye sees on both sides of the segment, or touching it, within the rectangle of the
/// picture that it spans: no other facet can hide any of it.
FacetsFound facets_across(const SortedMesh&, const View&, const Vec3& from, const Vec3& to);
/// Returns a facet that covers this place of the picture, not only by its boundary; none if there is none.
FacetsFound facet_over(const SortedMesh&, const View&, const Vec2& place);

}  // namespace isect::viz
