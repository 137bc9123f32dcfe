// What a reader takes along from two balls, and what there is to do.

#include <fmt/format.h>

#include <algorithm>

#include "bench/rows.h"
#include "lessons/speed_against_error/results.h"
#include "lessons/sphere_sphere/picture.h"

namespace isect::lessons::sphere_sphere_lesson {

using namespace viz;

namespace {

/// " Measured: 1.1 ns by squares, ..."; nothing where one of them was not.
std::string measured() {
  const auto rows = bench::rows_of(speed_against_error_lesson::results(), "sphere-sphere", "double", "ordinary");
  std::string told;
  for (const char* method : {"squares", "root", "hypot"}) {
    const auto row =
        std::ranges::find_if(rows, [&](const bench::Row* r) { return r->library == "isect" && r->method == method; });
    if (row == rows.end()) return {};
    told += fmt::format("{}{} ns by {}", told.empty() ? " Measured: " : ", ", shown((*row)->ns), method);
  }
  return told + ".";
}

bool touching_outside(const Parameters& p) { return setup(p).truth == Relation::touching; }

}  // namespace

const std::string& opening() {
  static const std::string text =
      "Do two balls have a point in common? Engines test this first for any two bodies, as few tests are cheaper.\n"
      "Two balls meet if and only if their centres are at most *r*_a + *r*_b apart. Both sides may be squared, so the "
      "lecture note *Intersection Detection* takes no square root.";
  return text;
}

const Closing& closing() {
  static const Closing closing = {
      .result =
          "Balls meet if and only if *d*^2 ≤ (*r*_a + *r*_b)^2. The smaller lies in the other if and only if "
          "*d*^2 ≤ (*r*_a − *r*_b)^2.",
      .cost =
          "Four products, six sums and one comparison. A square root, once a routine in software, is one instruction "
          "now; yet it takes as long as several products." +
          measured(),
      .choose =
          "For round bodies, and before any costlier test. A point against the Minkowski sum, a ball of radius *R* = "
          "*r*_a + *r*_b, asks the same. Long, thin bodies leave much of a ball empty: use boxes.",
      .used = "Broad phase of physics engines, nodes of sphere trees, particles, triggers in games.",
      .bug = "A strict < answers DISJOINT for balls that touch.",
      .bug_preset = "touching",
      .reading = {"Lecture note *Intersection Detection*, sphere and sphere.",
                  "Christer Ericson, *Real-Time Collision Detection*, 2005, section 4.3.1.",
                  "Tomas Akenine-Möller and Eric Haines, *Real-Time Rendering*, 2nd edition, 2002, chapter 13."},
      .exercises = {
          {"Drag **b** until the balls touch from outside.",
           "They touch where *d* = *r*_a + *r*_b. The radii add up to 2.5390625, so the centres must be that far "
           "apart.",
           "overlapping",
           touching_outside,
           {{"b", "1.21875,0,-0.9140625"}}},
          {"Two balls have radii 3 and 4, and their centres are 5 apart. Do their surfaces meet?",
           "Yes: 5 lies between 4 − 3 = 1 and 4 + 3 = 7. The surfaces share a circle. As neither contains the other, "
           "the smallest ball around both has the radius (5 + 3 + 4) / 2 = 6. Else it is the larger ball."},
          {"Why may both sides of *d* ≤ *r*_a + *r*_b be squared?",
           "Neither is negative, and squaring keeps the order of such numbers. With a negative radius it would not."},
          {"Lengths are stored in 32-bit floats. Beyond which distance does *d*^2 overflow? And how is that noticed?",
           "The largest float is about 3.4 · 10^{38}. Its square root is about 1.8 · 10^{19}. Where *R*^2 overflows, "
           "too, ∞ ≤ ∞ holds, and balls far apart seem to meet. Distances below 10^{−23} have a square of 0, and seem "
           "to be 0.\n"
           "The same balls in doubles, or scaled by a power of two, then give another answer."},
          wrong_line(),
      }};
  return closing;
}

}  // namespace isect::lessons::sphere_sphere_lesson
