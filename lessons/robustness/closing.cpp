// What a reader takes along from the microscope, and what there is to do.

#include "lessons/robustness/settings.h"

namespace isect::lessons::robustness_lesson {

using namespace viz;

namespace {

Setting setting_of(const Parameters& p) {
  return setting(std::get<std::string>(p.at("test")), std::get<std::string>(p.at("scalar")), std::get<Vec3>(p.at("p")));
}

bool never_wrong(const Parameters& p) {
  const Setting s = setting_of(p);
  for (int i = -half; i <= half; ++i)
    for (int j = -half; j <= half; ++j)
      if (fault(s, s.truth(i, j), s.answer(i, j)) != Fault::none) return false;
  return true;
}

bool ringed_is_right(const Parameters& p) {
  const Setting s = setting_of(p);
  const auto [i, j] = microscope::selected_of(p);
  return s.truth(i, j) == 1 && fault(s, s.truth(i, j), s.answer(i, j)) == Fault::none;
}

}  // namespace

const std::string& opening() {
  static const std::string text =
      "What can one rounding error do? It can turn a yes into a no, and a program that trusts it may crash.\n"
      "The lecture note *Intersection Detection* puts 80 % of the work into robustness. A microscope shows why.";
  return text;
}

const Closing& closing() {
  static const Closing closing = {
      .result =
          "Near a border a rounded test is wrong in whole regions, not just at single points. An exact sign is "
          "correct in every cell.",
      .cost = "A filter decides almost all calls in nanoseconds; exact numbers, for the rest, take longer.",
      .choose =
          "Exact signs where others build on a verdict: hulls, meshes, maps. Rounded ones where an error is only a "
          "pixel.",
      .used = "Shewchuk's exact predicates in Triangle and TetGen, CGAL's exact kernels, watertight ray tests.",
      .bug = "Trusting a rounded sign: whole blocks of neighbours come out wrong. A tolerance only moves the block.",
      .bug_preset = "orientation",
      .reading = {"Lutz Kettner et al., Classroom Examples of Robustness Problems in Geometric Computations, "
                  "*Computational Geometry* 40, 2008, pages 61–78.",
                  "Jonathan Richard Shewchuk, Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric "
                  "Predicates, *Discrete & Computational Geometry* 18, 1997, pages 305–363.",
                  "Christer Ericson, *Real-Time Collision Detection*, 2005, chapter 11."},
      .exercises = {
          {"Drag **p** to a place where the naive orientation is correct in every cell.",
           "Well beside the line all signs survive: at (1, 2), for instance.",
           "orientation",
           never_wrong,
           {{"p", "1,2,0"}}},
          {"Ring a neighbour left of the line for which the naive test is correct.",
           "Up is left here. Far enough from the line, at 32 up and 32 to the left, the sign is correct.",
           "orientation",
           ringed_is_right,
           {{"right", "-32"}, {"up", "32"}}},
          {"How far apart are two neighbouring doubles just above 0.0625, and near 3?",
           "2^{−56} and 2^{−51}: a difference of the two drops the last 5 bits or so of the smaller one. Just below "
           "0.0625, a power of two, they are 2^{−57} apart."},
          {"Coordinates are near 10^6, with 53 bits. Which tolerance is the smallest that makes sense?",
           "Neighbouring doubles there are 2^{−33}, about 10^{−10}, apart. A tolerance must be several of these gaps; "
           "one of 10^{−12} is too small. Coordinates relative to the camera or the object are small, and keep more "
           "digits: subtract in doubles, then round to floats. Positions must be kept in doubles for that: what floats "
           "have lost stays lost."},
          {"Why does a tolerance not make the verdict “on the line” consistent? And what keeps a resting contact from "
           "flickering?",
           "**a** may be within it of **b**, and **b** of **c**, but **a** not of **c**. What follows from two "
           "verdicts may contradict the third.\n"
           "Two tolerances (hysteresis): a contact begins within the smaller one, and ends beyond the larger. Their "
           "difference must exceed what a resting body moves. Engines also keep contacts from frame to frame, and let "
           "bodies at rest sleep."},
      }};
  return closing;
}

}  // namespace isect::lessons::robustness_lesson
