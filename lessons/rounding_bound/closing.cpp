// What a reader takes along from the bound, and what there is to do.

#include <algorithm>

#include "lessons/rounding_bound/setup.h"

namespace isect::lessons::rounding_bound_lesson {

using namespace viz;

namespace {

/// Whether the ringed neighbour's sign is right in doubles, and yet stays open.
bool right_but_open(const Parameters& p) {
  const Run run{Setup(p)};
  return !passes(run.det.value, run.bound(), 1) && sign_of_double(run.det.value) == run.truth;
}
/// Whether a wrong sign gets through with a bound of at least two fifths.
bool wrong_with_two_fifths(const Parameters& p) {
  const Setup s(p);
  const std::vector<Neighbour> all = neighbours(s);
  return s.factor >= 0.4 && std::ranges::any_of(all, [&](const Neighbour& n) { return n.wrong(s.factor); });
}

}  // namespace

const std::string& opening() {
  static const std::string text =
      "This course speaks of exact tests, or exact predicates. How can they be exact, although doubles round?\n"
      "A bound on the rounding error tells when a sign is certain. We derive that bound, and try smaller ones.";
  return text;
}

const Closing& closing() {
  static const Closing closing = {
      .result =
          "Where |*det*| reaches its error bound, the sign in doubles is certain: that is a filter. Elsewhere finer "
          "stages find the sign.",
      .cost = "The bound takes one sum and one product more. Finer stages run only where it leaves the sign open.",
      .choose =
          "For every sign that a program branches on: hulls, triangulations, maps. A value that is only drawn needs "
          "no bound.",
      .used =
          "Shewchuk's predicates in Triangle and TetGen, CGAL's filtered kernels, and all exact tests of this course.",
      .bug = "A constant found by trial, or one epsilon for all sizes: wrong signs get through.",
      .bug_preset = "weak",
      .reading = {"Jonathan Richard Shewchuk, Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric "
                  "Predicates, *Discrete & Computational Geometry* 18, 1997, pages 305–363.",
                  "Nicholas J. Higham, *Accuracy and Stability of Numerical Algorithms*, 2nd edition, 2002, chapters 2 "
                  "and 3.",
                  "David Goldberg, What Every Computer Scientist Should Know About Floating-Point Arithmetic, *ACM "
                  "Computing Surveys* 23, 1991, pages 5–48."},
      .exercises = {
          {"Ring a neighbour whose sign is right in doubles, and yet stays open.",
           "Near the line, but not on it: 12 to the right and 12 down.",
           "certain",
           right_but_open,
           {{"right", "12"}, {"up", "-12"}}},
          {"Up to which factor does a wrong sign get through here? Find one of at least 0.4.",
           "Up to |*det*| / *bound*, about 0.435, of the neighbour 12 to the right and 12 up. Other points reach "
           "nearly "
           "0.6.",
           "weak",
           wrong_with_two_fifths,
           {{"factor", "0.43"}}},
          {"How many roundings touch each product of orient3d, and which constant follows by our rule? And which "
           "changes turn the sign of *det* for three points?",
           "A difference has 1, a product of two 3, the difference of two such 4. Times a third difference: 6. Two "
           "sums: 8. So it is 9 *u*. Of *a d* − *b c*, its entries taken as exact, each product has 2: 3 *u*.\n"
           "In full, such a value is (*a d* (1 + *δ*_1) − *b c* (1 + *δ*_2)) (1 + *δ*_3). It errs by (2 *u* + *u*^2) "
           "(|*a d*| + |*b c*|) at most. The rounded products may be a little smaller: 3 *u* makes up for that. A "
           "larger constant is safe, too, but leaves more signs open.\n"
           "Exchanging two of three points turns the sign; a cyclic exchange of all three does not: the point in "
           "question may stand first or last. A *y* that points "
           "down, as on screens, turns it, too: left and right are exchanged."},
          {"All coordinates are whole numbers of at most 2^{25} in size. How large can the error of *det* be? And what "
           "of integers of 64 bits?",
           "It is 0. Differences reach 2^{26} at most, products 2^{52}, *det* 2^{53}: all are doubles. From 0 to "
           "2^{26} − 1, without a sign, differences are less than 2^{26}, too.\n"
           "Signed integers of 64 bits hold *det* for coordinates from 0 to 2^{31} − 1. With 32 bits a product may "
           "pass 2^{63}. A double would round it; an integer overflows, and its sign may be wrong without notice."},
          {"Coordinates are floats, within a factor of two of each other. *det* is found in doubles. Which roundings "
           "are left? And what of errors that the coordinates bring along?",
           "Only the last one. Differences have 24 bits at most, products 48. So the sign of *det* is right.\n"
           "No exact test corrects such errors. Let *x* and *y* have relative errors of up to *ε*: that of *x* − *y* "
           "is up to *ε* (|*x*| + |*y*|) / |*x* − *y*|. For 1 and 0.999 that is 1999 *ε*, even where the subtraction "
           "itself is exact."},
      }};
  return closing;
}

}  // namespace isect::lessons::rounding_bound_lesson
