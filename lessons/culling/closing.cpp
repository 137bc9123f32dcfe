// What a reader takes along from culling, and what there is to do.

#include "lessons/culling/picture.h"

namespace isect::lessons::culling_lesson {

using namespace viz;

namespace {

bool is_inside(const Parameters& p) { return cases().branches[cases().branch(p)] == "inside"; }
bool is_false_positive(const Parameters& p) { return cases().branches[cases().branch(p)] == "false positive"; }

}  // namespace

const std::string& opening() {
  static const std::string text =
      "Which objects can the camera see? Every renderer checks before drawing, as most of a large world is out of "
      "view.\n"
      "The lecture note *Intersection Detection* calls it view-volume culling: test each object's bounding volume "
      "against "
      "the planes of the frustum.";
  return text;
}

const Closing& closing() {
  static const Closing closing = {
      .result =
          "A volume beyond one plane is outside. One within all six is inside. Any other may be visible, and is "
          "drawn.",
      .cost =
          "Box: one corner per plane to reject, two to accept. A bounding volume hierarchy settles whole groups with "
          "one test.",
      .choose =
          "Spheres or AABBs with a hierarchy. Occlusion culling is another step: it removes what is hidden behind "
          "walls.",
      .used =
          "Every engine's visible set, on the CPU or in a compute shader on the GPU; shadow maps (the light's "
          "frustum), portals, level of detail.",
      .bug = "Taking CROSSING for visible: beyond an edge, no single plane rejects a box.",
      .bug_preset = "beyond-an-edge",
      .reading = {"Ulf Assarsson and Tomas Möller, Optimized View Frustum Culling Algorithms for Bounding Boxes, "
                  "*Journal of Graphics Tools* 5, 2000, pages 9–22.",
                  "Gil Gribb and Klaus Hartmann, *Fast Extraction of Viewing Frustum Planes from the "
                  "World-View-Projection Matrix*, 2001.",
                  "Tomas Akenine-Möller and Eric Haines, *Real-Time Rendering*, 2nd edition, 2002, chapters 9 and 13."},
      .exercises = {
          {"Drag the box until the frustum contains all of it. And why is it not enough to look for its corners there?",
           "Bring it to the middle, away from the sides. All six n-vertices must be on the inner side.\n"
           "A large box may contain the whole frustum, with no corner in it. To keep boxes by their corners alone "
           "may lose what is seen.",
           "crossing",
           is_inside,
           {{"p", "1.75,0,0.5"}}},
          {"Find a false positive: crossing, though no point of the box is in the frustum.",
           "Near an edge of the frustum each plane leaves a part of the box, and no part is left by all.",
           "outside",
           is_false_positive,
           {{"p", "3.25,-2.375,3.375"}, {"size", "0.5"}}},
          wrong_line(),
          {"The clip coordinates of **x** are the dot products of the matrix's rows with (**x**, 1). Find the left "
           "plane, and the near plane by both conventions.",
           "Inside means −*w* ≤ *x*, so row 4 + row 1 gives the left plane's coefficients. With −*w* ≤ *z* (OpenGL) "
           "the near plane is row 4 + row 3; with 0 ≤ *z* (Direct3D, Metal, Vulkan) it is row 3 alone. Such normals "
           "need not have length 1: divide a plane by that length before a radius is compared."},
          {"The camera turns a little. Which answer of the last frame should be tried first?",
           "The plane that rejected the object last time: it probably will again. That is temporal coherence."},
      }};
  return closing;
}

}  // namespace isect::lessons::culling_lesson
