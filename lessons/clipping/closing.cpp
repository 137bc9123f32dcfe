// What a reader takes along from clipping, and what there is to do.

#include <isect/clip_segment.h>
#include "lessons/clipping/picture.h"

namespace isect::lessons::clipping_lesson {

using namespace viz;

namespace {

/// No part is kept, and no side alone can tell.
bool passes_a_corner(const Parameters& p) {
  const Segment<double, 2> s = {std::get<Vec3>(p.at("p")).head<2>(), std::get<Vec3>(p.at("q")).head<2>()};
  const Box box = box_of(p);
  const int both = clip_segment::outcode(s.p, box) & clip_segment::outcode(s.q, box);
  return both == 0 && !isect::clip(s, box);
}

}  // namespace

const std::string& opening() {
  static const std::string text =
      "Which part of a segment or polygon lies in a box? Every renderer clips its lines and triangles at the image "
      "edges.\n"
      "A box is an intersection of half-spaces (in the plane: half-planes), so each side cuts in turn. In the lecture "
      "note *Intersection "
      "Detection*, clipping is the first use.";
  return text;
}

const Closing& closing() {
  static const Closing closing = {
      .result =
          "Outcodes accept or reject most. The others are cut side by side: a segment as a range of *t*, a "
          "polygon as a ring of vertices.",
      .cost =
          "Segment: eight comparisons for the outcodes, then at most four divisions. Polygon of *n* vertices: "
          "O(*n*) per side.",
      .choose =
          "Liang and Barsky for segments; Sutherland and Hodgman for convex windows. Weiler and Atherton, or "
          "sweeping, for windows that are not convex.",
      .used =
          "GPUs clip triangles at the near plane; within a guard band they leave the sides to the rasteriser. Maps, "
          "plotters, physics "
          "contacts (a face clipped by a face).",
      .bug = "Reciprocals of zero: 0 · ∞ is not a number, and a segment along a side is lost.",
      .bug_preset = "along-a-side",
      .reading = {"Timothy Kay and James Kajiya, Ray Tracing Complex Scenes, *SIGGRAPH*, 1986, pages 269–278.",
                  "You-Dong Liang and Brian Barsky, A New Concept and Method for Line Clipping, *ACM Transactions on "
                  "Graphics* 3, 1984, pages 1–22.",
                  "Ivan Sutherland and Gary Hodgman, Reentrant Polygon Clipping, *Communications of the ACM* 17, 1974, "
                  "pages 32–42.",
                  "James Foley et al., *Computer Graphics: Principles and Practice*, 2nd edition, 1990, chapter 3."},
      .exercises = {
          {"Drag **p** and **q** until nothing is kept, but the outcodes do not show it.",
           "The segment must pass a corner: **p** beyond one side and **q** beyond the next.",
           "both-ends-cut",
           passes_a_corner,
           {{"q", "-1.75,-2.25,0"}, {"p", "-3,-0.75,0"}}},
          {"The box is [0, 4] by [0, 2]. Clip the segment from (−2, 1) to (6, 3). And what if a crossing is rounded?",
           "**d** = (8, 2). Left: *t* ≥ 1/4. Right: *t* ≤ 3/4. Top: *t* ≤ 1/2. Bottom: *t* ≥ −1/2. Kept: 1/4 to 1/2, "
           "from (0, 1.5) to (2, 2). In space a third slab cuts the same range. A ray begins with [0, ∞) in place of "
           "[0, 1].\n"
           "A rounded crossing may lie a little beyond its side. It would be cut again, and later steps may count on "
           "the side. So set that coordinate to the side's own value."},
          {"How many vertices can a triangle have after four sides have cut it? What does each edge put out? And why "
           "do renderers clip at the near plane before they project?",
           "Seven: a cut of a convex polygon adds at most one vertex. A line crosses a convex outline twice at most, "
           "so a cut that adds two vertices removes at least one. A triangle can keep a part of each of its three "
           "sides, and of the box's four.\n"
           "Let no vertex lie on the side. An edge from in to in puts out its end; from in to out, the crossing. From "
           "out to in it puts out the crossing, then its end; from out to out, nothing.\n"
           "Projection divides by *w*, for an eye in perspective the depth in front of it. Points behind the eye, *w* "
           "< 0, would come out mirrored, and at *w* = 0 the division fails."},
          {"Why do slabs by reciprocals lose a segment along the top, but not along the bottom? And what do exchanged "
           "arguments change?",
           "*d* = 0 makes 1/*d* = ∞, and ∞ times the distance 0 is NaN. With NaN none of <, ≤, > and ≥ holds, so min "
           "and max return their first argument. Along the top that is *t*_1 = −∞, which hides the NaN. Along the "
           "bottom it is *t*_1 = NaN; there the range survives only as the first argument. Test for *d* = 0 first.\n"
           "Slabs by sign take no min and max of the two *t* of an axis. Where *d* ≥ 0 the lower plane is the near "
           "one, else the upper one. But 1/(−0) is −∞, though −0 ≥ 0 holds: then entry and exit are exchanged.",
           "slabs-bottom"},
          wrong_line(),
      }};
  return closing;
}

}  // namespace isect::lessons::clipping_lesson
