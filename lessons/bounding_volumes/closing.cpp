// What a reader takes along from bounding volumes, and what there is to do.

#include <isect/fit_tight.h>
#include <isect/volume.h>
#include "lessons/bounding_volumes/cheap_first.h"

namespace isect::lessons::bounding_volumes_lesson {

using namespace viz;

namespace {

TriangleMesh<double> mesh_of(const Parameters& p) {
  return object(std::get<std::string>(p.at("object")), std::get<Vec3>(p.at("tip")));
}

/// The AABB is at most a tenth larger than the OBB.
bool box_fits(const Parameters& p) {
  const std::vector<Vec3> vertices = mesh_of(p).vertices;
  return volume(fit_aabb(vertices)) <= 1.1 * volume(fit_obb_tight(vertices));
}

bool in_void(const Parameters& p) { return cases().branch(p) == 2; }

}  // namespace

const std::string& opening() {
  static const std::string text =
      "Can two complicated objects meet? Renderers and physics engines test millions of pairs.\n"
      "A simple volume around each object answers most of them: what misses the volume misses all its contents. The "
      "lecture note *Intersection Detection* names four kinds.";
  return text;
}

const Closing& closing() {
  static const Closing closing = {
      .result =
          "Volumes apart: reject. The volume of a wholly in the solid b: accept. Otherwise nothing is known yet, and "
          "the objects themselves are tested.",
      .cost =
          "A sphere keeps 4 numbers, an AABB 6, a *k*-DOP *k*, an OBB 15. A test that finds an overlap takes 11, 6, "
          "*k* and about 250 operations.",
      .choose =
          "AABB by default. Sphere for round bodies that rotate often; OBB or *k*-DOP for long or tilted bodies close "
          "to others.",
      .used =
          "Broad phase of physics engines, frustum and occlusion culling, nodes of hierarchies for ray tracing on "
          "the GPU.",
      .bug = "Testing surfaces only: a box wholly inside a solid object meets no triangle.",
      .bug_preset = "within",
      .reading = {"Christer Ericson, *Real-Time Collision Detection*, 2005, chapter 4.",
                  "Stefan Gottschalk, Ming Lin and Dinesh Manocha, OBBTree: A Hierarchical Structure for Rapid "
                  "Interference Detection, *SIGGRAPH*, 1996, pages 171–180.",
                  "James Klosowski et al., Efficient Collision Detection Using Bounding Volume Hierarchies of k-DOPs, "
                  "*IEEE TVCG* 4, 1998, pages 21–36."},
      .exercises = {
          {"Drag the tip until the AABB is at most a tenth larger than the OBB.",
           "Lay the long axis along a coordinate axis. Then the AABB fits as well as the OBB.",
           "tilted",
           box_fits,
           {{"tip", "0,1.625,0"}}},
          {"Drag b until only void meets it: a false positive.",
           "The AABB of the slanting pin has empty corners; b fits into one of them.",
           "overlap",
           in_void,
           {{"q", "1,-1,-0.25"}}},
          {"A box with half-lengths **h** is turned by a matrix *M*. Find the half-lengths of the AABB around it. "
           "And how are bounds of few bits rounded?",
           "On axis *i* it is the sum of |*M_{ij}*| *h_j* over *j*. That takes nine products. Around an object in the "
           "box it is looser than fitting the object's vertices again. Round such bounds outwards: a volume that "
           "rounding made too small may reject what meets its object: a false negative.\n"
           "On a grid of few bits, too, lower ends are rounded down and upper ends up. That saves memory, and adds "
           "void. Rounded to the closest step, a box may leave out a part of its object. So check that it contains "
           "each vertex."},
          {"An object is translated by **v**. What changes in its sphere, AABB, OBB and *k*-DOP? And which is the "
           "smallest circle around a triangle?",
           "The centre of the sphere and of the OBB moves by **v**, and so do both corners of the AABB. The bounds of "
           "slab *i* grow by **n**_i · **v**. Nothing is fitted again.\n"
           "Where an angle has 90° or more, the longest side is a diameter of that circle. Else all three vertices lie "
           "on it. A mean of the distances is no radius: it leaves a vertex out, unless all are equal."},
          {"An object with *n* vertices rotates every frame. What does it cost to update each volume? When does a "
           "*k*-DOP pay nevertheless?",
           "Sphere: one point. OBB: a centre and three axes. AABB and *k*-DOP: O(*n*) for a tight fit, or only the "
           "hull's vertices. A *k*-DOP pays where many tests follow each update, as each takes *k* comparisons and an "
           "OBB's about 250 operations; or where the object is only shifted.",
           "tilted"},
      }};
  return closing;
}

}  // namespace isect::lessons::bounding_volumes_lesson
