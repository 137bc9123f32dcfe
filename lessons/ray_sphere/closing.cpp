// What a reader takes along from a ray and a sphere, and what there is to do.

#include "lessons/ray_sphere/picture.h"

namespace isect::lessons::ray_sphere_lesson {

using namespace viz;

namespace {

/// The line meets the ball, and the ray does not.
bool line_only(const Parameters& p) {
  const Setup s = setup(p, false);
  return s.truth.line_roots == 2 && !s.truth.solid;
}

}  // namespace

const std::string& opening() {
  static const std::string text =
      "Where does a ray first meet a sphere? Ray tracers and pickers need this, and spheres bound other shapes.\n"
      "Substituting the ray into the sphere's equation gives a quadratic in *t*. The lecture note *Intersection "
      "Detection* solves it in three ways.";
  return text;
}

const Closing& closing() {
  static const Closing closing = {
      .result =
          "The closest hit is the smallest root of |**o** + *t* **d** − **c**|^2 = *r*^2 in the ray's closed range.",
      .cost =
          "Haines, given a unit direction: one square root, no division; neither for a ball behind. The quadratic: one "
          "square root, two divisions.",
      .choose =
          "Haines for unit directions. Stable roots for others: the root whose terms have equal signs, then the other "
          "by *t*_1 *t*_2 = *C* / *A* (see the quadratic presets). Far away also a robust discriminant, *A* (*r*^2 − "
          "*m*^2). Near the surface neither is better than *C*: there take the exact test.",
      .used =
          "Primary and shadow rays, picking, line of sight, sphere trees. A moving ball against a ball is a ray "
          "against their Minkowski sum.",
      .bug = "Taking any real root for a hit, even one behind the origin.",
      .bug_preset = "behind-quadratic",
      .reading = {"Eric Haines, in: Andrew Glassner (ed.), *An Introduction to Ray Tracing*, 1989, chapter 2.",
                  "Tomas Akenine-Möller and Eric Haines, *Real-Time Rendering*, 2nd edition, 2002, chapter 13.",
                  "Eric Haines, Johannes Günther and Tomas Akenine-Möller, Precision Improvements for Ray/Sphere "
                  "Intersection, in: *Ray Tracing Gems*, 2019, chapter 7.",
                  "William Press et al., *Numerical Recipes*, 3rd edition, 2007, section 5.6."},
      .exercises = {
          {"Drag **o** until the line meets the ball, but the ray does not.",
           "Both roots must be negative: **o** lies outside, past the ball. Real roots alone are no hit.",
           "two-roots",
           line_only,
           {{"origin", "2.3203125,0.46875,-1.984375"}}},
          {"Let **o** = (0, 0, 0), **d** = (1, 2, 2), **c** = (3, 3, 3) and *r* = 3. Find *A*, *B*, *C* and the first "
           "hit.",
           "**f** = (−3, −3, −3). So *A* = 9, *B* = 2 · (−15) = −30, *C* = 27 − 9 = 18 and *Δ* = 252. The first hit is "
           "*t*_1 = (30 − √252) / 18 ≈ 0.785. Beware of mixed forms, where *C* > 0: *B*^2 − *A* *C* with this *B* "
           "turns some misses into hits. *B*^2 − 4 *A* *C* with half of it turns some hits into misses."},
          {"When does the entry root lose digits, and what keeps them?",
           "Near the surface two differences cancel. Stable roots cure −*B* − √*Δ*: they compute *t*_2 first, then "
           "*t*_1 = *C* / (*A* *t*_2). They do not cure *C* = **f** · **f** − *r*^2, which must be had exactly, or "
           "with twice the digits. Far away, with *B* halved, *B*^2 − *A* *C* cancels; the robust discriminant *A* "
           "(*r*^2 − |**f** − (*B* / *A*) **d**|^2) does not.",
           "near-rounded-quadratic"},
          {"The direction is doubled in length. What happens to *A*, *B*, *C*, the roots and the points?",
           "*A* grows fourfold and *B* twofold; *C* is unchanged. The roots are halved; the points are unchanged. So "
           "where |**d**| ≠ 1, ranges and offsets in *t* are no lengths: divide lengths by |**d**|. "
           "Haines takes |**d**| = 1 for granted. If it is 1 + *ε*, a distance from outside errs by about *ε* *s* / "
           "*q*, relative to it: too small for *ε* > 0. With **d** = **0** the ray is the point **o**, and *A* = 0. Do "
           "not divide: ask whether **o** lies in the ball."},
          wrong_line(),
      }};
  return closing;
}

const std::vector<Erratum>& errata() {
  static const std::vector<Erratum> all = {
      {"if l² > r²", "if l² > r² or (l² = r² and s > 0)",
       "For a ray that starts on the surface and heads inwards, it would return the exit.", "surface-in"},
      {"A ← (d · d) t²", "A ← d · d", "A coefficient does not contain the unknown: the *t* is a misprint.",
       "two-roots-quadratic"},
      {"B ← 2 (f · d) t", "B ← 2 f · d", "The *t* is a misprint here, too: *B* is a constant.", "two-roots-quadratic"},
      {"if t₁ > 0", "if t_min ≤ t₁ ≤ t_max",
       "The smallest positive root misses *t* = 0 on the surface, and takes hits beyond a segment's end.",
       "surface-in-quadratic"},
  };
  return all;
}

}  // namespace isect::lessons::ray_sphere_lesson
