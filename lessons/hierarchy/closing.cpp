// What a reader takes along from bounding volume hierarchies, and what there is to do.

#include <algorithm>

#include <isect/many/bvh_pairs.h>
#include <isect/ray_aabb.h>
#include "lessons/hierarchy/tree.h"

namespace isect::lessons::hierarchy_lesson {

using namespace viz;

namespace {

/// The ray misses the outermost box.
bool misses_all(const Parameters& p) {
  const Tree tree(boxes_of(p));
  const Vec3 &o = std::get<Vec3>(p.at("o")), &d = std::get<Vec3>(p.at("d"));
  return !intersects(Ray<double, 2>{o.head<2>(), d.head<2>()}, tree.node(0).box);
}

/// Whether both objects are apart already at their roots.
bool one_test(const Parameters& p) {
  const Tree a(boxes_of(p)), b(cluster(std::get<Vec3>(p.at("q"))));
  bvh_pairs::Counts counts;
  report_pairs(
      b.bvh, b.boxes, a.bvh, a.boxes, [](int, int) {}, counts);
  return counts.visited == 0 && counts.pruned == 1;
}

}  // namespace

const std::string& opening() {
  static const std::string text =
      "How can thousands of boxes be searched without testing each? Ray tracers and collision engines do it every "
      "frame.\n"
      "Put boxes into boxes: what misses the outer one misses all within. The lecture note *Intersection Detection* "
      "calls this a bounding volume hierarchy.";
  return text;
}

const Closing& closing() {
  static const Closing closing = {
      .result =
          "One test of a node rules out all that lies below it. Where boxes overlap little, most objects are never "
          "tested.",
      .cost =
          "Binned construction takes O(*n*) per level. A ray's node tests then grow as lg *n* where boxes overlap "
          "little; at worst, all.",
      .choose =
          "For many objects and many queries. For moving objects refit the boxes; rebuild when they have become "
          "too loose. A grid suits objects of one size.",
      .used =
          "Ray tracing on the CPU and in the GPU's own hardware, broad and mid phase of physics engines, culling, "
          "picking.",
      .bug =
          "Returning the first hit that is found: the same leaf, or a node still to be opened, may hold a closer one. "
          "A rounded test that rejects a node wrongly loses all below it.",
      .bug_preset = "ray-back",
      .reading = {"Timothy Kay and James Kajiya, Ray Tracing Complex Scenes, *SIGGRAPH*, 1986, pages 269–278.",
                  "Jeffrey Goldsmith and John Salmon, Automatic Creation of Object Hierarchies for Ray Tracing, *IEEE "
                  "CG&A* 7, 1987, pages 14–20.",
                  "Stefan Gottschalk, Ming Lin and Dinesh Manocha, OBBTree: A Hierarchical Structure for Rapid "
                  "Interference Detection, *SIGGRAPH*, 1996, pages 171–180.",
                  "Ingo Wald, On Fast Construction of SAH-based Bounding Volume Hierarchies, *IEEE Symposium on "
                  "Interactive Ray Tracing*, 2007, pages 33–40.",
                  "Martin Stich, Heiko Friedrich and Andreas Dietrich, Spatial Splits in Bounding Volume Hierarchies, "
                  "*High Performance Graphics*, 2009, pages 7–13.",
                  "Christer Ericson, *Real-Time Collision Detection*, 2005, chapter 6."},
      .exercises = {
          {"Drag the ray until one test settles it.",
           "It must miss the outermost box: then it misses all boxes.",
           "ray",
           misses_all,
           {{"o", "-4.25,2.5,0"}, {"d", "1,0,0"}}},
          {"Drag **q** until a single test shows that the two objects are apart. And how does a tree find the object "
           "nearest to a point?",
           "The boxes of both roots must share no point. Then no pair below them meets.\n"
           "Open the node whose box is nearest first, and keep the nearest object so far. A box farther off than that "
           "holds nothing nearer: prune it. Squared distances have the same order. One that is rounded up may prune "
           "the nearest object: compare with all objects, now and then.",
           "pairs",
           one_test,
           {{"q", "3,-3,0"}}},
          {"All boxes have the same centre, but different sizes. What does a hierarchy gain? And what does one large "
           "box do to a tree of small ones, or to a uniform grid?",
           "Nothing for rays through the centre: all nodes overlap there, so no node is ruled out by its box alone. "
           "One large box makes each node that holds it as large. Test it by itself, or cut it in two. Equal centres "
           "leave no cut: a build must then split by count, or make a leaf, to end. A grid lists each box in all "
           "cells that it meets, and its cells are about as large as a typical box. In small cells a large box is "
           "listed "
           "very often. Cells as large as it list many small boxes each, and all their pairs are tested.",
           "large"},
          {"A box of the tree moves. How is the tree updated without a rebuild?",
           "Refit: from its leaf upwards each node takes the box around its children. That is O(depth), but the nodes "
           "may come to overlap. Not refitted, a node need not contain what has moved: a query that misses its old box "
           "may lose a hit. If all boxes move, it takes each node once, children first: O(*n*)."},
          {"A node has perimeter 10. Its parts have perimeters 4 and 8, with 6 and 2 boxes; a visit costs 2. Split or "
           "leaf?",
           "The split costs 2 + (4 · 6 + 8 · 2) / 10 = 6, and a leaf 8 tests. Split. A whole query costs *N*_v *C*_v + "
           "*N*_p *C*_p: so many volumes, then so many pairs of objects, are tested at these costs. Moving objects add "
           "*N*_u *C*_u, for so many updates."},
      }};
  return closing;
}

}  // namespace isect::lessons::hierarchy_lesson
