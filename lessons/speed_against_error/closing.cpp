// What a reader takes along from speed against error, and what there is to do.

#include "bench/rows.h"
#include "lessons/speed_against_error/results.h"
#include "lessons/speed_against_error/telling.h"

namespace isect::lessons::speed_against_error_lesson {

using namespace viz;

namespace {

/// Whether the exact call is faster than the naive method on ordinary cases, by more than the noise.
bool exact_is_faster(const Parameters& p) {
  const auto rows = bench::rows_of(results(), std::get<std::string>(p.at("test")), "double", "ordinary");
  const bench::Row *naive = bench::standard_of(rows), *exact = bench::exact_of(rows);
  return exact->ns * (1 + results().machine.noise) < naive->ns;
}

}  // namespace

const std::string& opening() {
  static const std::string text =
      "What does an exact verdict cost, and what does a rounded one? The lecture note *Intersection Detection* says to "
      "time "
      "and profile.\n"
      "So every method is timed, and judged by an exact oracle: on ordinary cases, and on hard ones.";
  return text;
}

const Closing& closing() {
  static const Closing closing = {
      .result =
          "On our ordinary cases all verdicts are right; times differ, and the last digits of values. On hard ones "
          "rounded methods fail; exact calls take longer.",
      .cost =
          "One comparison of a value with its error bound on ordinary cases; exact numbers only where it leaves the "
          "sign "
          "open.",
      .choose =
          "The exact call, unless a profile shows its time and every input is ordinary. For pictures a rounded method "
          "will do; for a ray and a sphere, stable roots, unless rays start close or far off.",
      .used =
          "CGAL's filtered kernels and Shewchuk's exact predicates work so; game engines mostly choose rounded tests "
          "and "
          "tolerances.",
      .bug = "Judging a method by ordinary cases alone: no wrong verdict shows up there.",
      .bug_preset = "sphere-sphere",
      .reading = {"Jonathan Richard Shewchuk, Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric "
                  "Predicates, *Discrete & Computational Geometry* 18, 1997, pages 305–363.",
                  "David Goldberg, What Every Computer Scientist Should Know About Floating-Point Arithmetic, *ACM "
                  "Computing Surveys* 23, 1991, pages 5–48.",
                  "Tomas Möller and Ben Trumbore, Fast, Minimum Storage Ray/Triangle Intersection, *Journal of "
                  "Graphics Tools* 2, 1997, pages 21–28.",
                  "Sven Woop, Carsten Benthin and Ingo Wald, Watertight Ray/Triangle Intersection, *Journal of "
                  "Computer Graphics Techniques* 2, 2013, pages 65–82."},
      .exercises = {
          {"Choose a test whose exact call is faster than the naive method, beyond the noise.",
           "Ball and box is one: the naive method branches on every axis, the exact call does not.",
           "ray-sphere",
           exact_is_faster,
           {{"test", "sphere-aabb"}}},
          {"Two methods take 14.5 and 14.6 ns on a machine whose noise is 50 %. Which is faster?",
           "That cannot be decided. Only ratios above 1.5 mean anything there."},
          {"A call takes 4 ns if the filter decides, else 400 ns. One call in 1000 needs the latter. What is the "
           "mean?",
           "0.999 · 4 + 0.001 · 400 = 4.4 ns, a tenth more."},
          {"Method A takes 2 ns and errs by 8 ulp, B 3 ns and 1 ulp, C 4 ns and 2 ulp. Which is dominated?",
           "C: B is faster and more accurate. A and B are on the front."},
          {"For orient2d “expanded” adds up **a** × **b** + **b** × **c** + **c** × **a**. Where does it fail? And "
           "which checks of a test need no oracle?",
           "Far from the origin, where large products nearly cancel. With **a** = (10^8, 10^8), **b** one to its right "
           "and **c** one above it, *det* is 1. Doubles near 10^{16} are 2 apart, so the sum comes out as 0. "
           "Differences first, then products, give 1.\n"
           "Exchange both arguments: a wrong answer for one order shows. Scale by a power of two: that rounds nothing, "
           "so a change shows an *ε*, overflow or underflow. Place a shape in another, or on a common point: "
           "“disjoint” is then wrong. A translation rounds anew, so near a touch it may change the answer."},
      }};
  return closing;
}

}  // namespace isect::lessons::speed_against_error_lesson
