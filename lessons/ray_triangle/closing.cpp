// What a reader takes along from a ray and a triangle, and what there is to do.

#include "lessons/ray_triangle/seam.h"

namespace isect::lessons::ray_triangle_lesson {

using namespace viz;

namespace {

bool beyond_b(const Parameters& p) { return setup(p).place() == Place::beyond_b; }

/// Whether the ringed ray slips through by the test of Möller and Trumbore.
bool slips_through(const Parameters& p) {
  const Setup s = setup(p);
  return met(Test::exact, s.ray, s).any() && !met(Test::moller_trumbore, s.ray, s).any();
}

}  // namespace

const std::string& opening() {
  static const std::string text =
      "Where does a ray meet a triangle? Many scenes are meshes of triangles, so ray tracers and picking ask this "
      "often.\n"
      "In a mesh, nearly right is not enough: no ray may slip between two neighbours.";
  return text;
}

const Closing& closing() {
  static const Closing closing = {
      .result =
          "Let a line cross the plane in one point: it meets the triangle if no two of three signed volumes have "
          "opposite signs. Divided by their sum they are the barycentric coordinates.",
      .cost =
          "O(1): a few dozen sums and products, and no square root. Möller and Trumbore store nothing but the "
          "vertices.",
      .choose =
          "For one triangle, or where a lost pixel does no harm: Möller and Trumbore. For closed meshes: a watertight "
          "test. Polygons with many vertices: ray and polygon.",
      .used = "Möller and Trumbore's test in many ray tracers and in picking. Watertight tests in Embree and pbrt.",
      .bug =
          "An epsilon on the weights: rays hit beside the mesh, or two triangles at once. Or *det* > 0 instead of "
          "*det* ≠ 0: back faces vanish.",
      .bug_preset = "back-face",
      .reading =
          {"Tomas Möller and Ben Trumbore, Fast, Minimum Storage Ray/Triangle Intersection, *Journal of Graphics "
           "Tools* 2, 1997, pages 21–28.",
           "Sven Woop, Carsten Benthin and Ingo Wald, Watertight Ray/Triangle Intersection, *Journal of Computer "
           "Graphics Techniques* 2, 2013, pages 65–82.",
           "John Amanatides and Kin Choi, Ray Tracing Triangular Meshes, *Western Computer Graphics Symposium*, "
           "1997.",
           "Christer Ericson, *Real-Time Collision Detection*, 2005, sections 5.3.4 and 5.3.6.",
           "Tomas Akenine-Möller and Eric Haines, *Real-Time Rendering*, 2nd edition, 2002, chapter 13."},
      .exercises = {
          {"Drag **o** until the line crosses the plane beyond the vertex **b**.",
           "There the weights of **a** and **c** are negative. At *u* = 1.375 and *v* = −0.25, for instance.",
           "face",
           beyond_b,
           {{"o", "-0.2109375,-0.6875,2.04296875"}}},
          {"Ring a ray that slips through by the test of Möller and Trumbore.",
           "The middle one, 0 to the right and 0 up, passes through the edge itself: it should meet both.",
           "seam-beside",
           slips_through,
           {{"right", "0"}, {"up", "0"}}},
          {"A texture coordinate is 10 at **a**, 20 at **b** and 40 at **c**. What is it where *u* = 0.3 and *v* = "
           "0.5?",
           "The weight of **a** is 1 − 0.3 − 0.5 = 0.2. So it is 0.2 · 10 + 0.3 · 20 + 0.5 · 40 = 28."},
          {"A program accepts weights down to −*ε*. Why does that not make a mesh watertight? And what becomes of "
           "a count of crossings, which is odd where a ray starts inside a closed mesh?",
           "It makes each triangle larger: near an edge a ray then meets both, and past the outline it meets the "
           "mesh, too. Which *ε* suffices depends on all sizes, as the rounding errors do. Such a count may then "
           "be even where it should be odd. With exact tests, too, a ray through an edge or a vertex meets several "
           "triangles. Count by a half-open rule. Another ray may meet an edge, too. If it is random, the answer "
           "cannot be repeated."},
          wrong_line(),
      }};
  return closing;
}

}  // namespace isect::lessons::ray_triangle_lesson
