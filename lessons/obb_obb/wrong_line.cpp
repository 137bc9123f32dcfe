// A program for two oriented boxes with one wrong line: terms of a reach cancel.

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "lessons/obb_obb/picture.h"
#include "lessons/shared/opinions.h"
#include "lessons/shared/wrong_program.h"

namespace isect::lessons::obb_obb_lesson {

using namespace viz;

namespace {

/// The normals of both boxes and the cross products of their edges. Those of parallel edges are left out: they are 0,
/// or what rounding makes of it.
std::vector<Vec3> axes(const Obb<double, 3>& a, const Obb<double, 3>& b) {
  constexpr double parallel = 1e-6;
  std::vector<Vec3> all;
  for (int i = 0; i < 3; ++i) all.insert(all.end(), {Vec3(a.axes.col(i)), Vec3(b.axes.col(i))});
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const Vec3 n = a.axes.col(i).cross(b.axes.col(j));
      if (n.norm() > parallel) all.push_back(n);
    }
  return all;
}

std::string program(const Obb<double, 3>& a, const Obb<double, 3>& b) {
  const Vec3 l = b.center - a.center;
  for (const Vec3& n : axes(a, b)) {
    double r_a = 0, r_b = 0;
    for (int i = 0; i < 3; ++i) r_a += a.half[i] * std::abs(a.axes.col(i).dot(n));
    for (int j = 0; j < 3; ++j) r_b += b.half[j] * b.axes.col(j).dot(n);
    if (std::abs(n.dot(l)) > r_a + r_b) return "DISJOINT";
  }
  return "OVERLAP";
}

TwoVerdicts verdicts(const Parameters& p) {
  const Setup s = setup(p);
  return {program(s.a, s.b), says_overlap(s.truth)};
}

}  // namespace

Exercise wrong_line() {
  return wrong_program<verdicts>(
      "whether two oriented boxes meet",
      {"l ← b − a", "for each n of the 15 axes, but 0", "    r_a ← the sum of h_i |a_i · n|",
       "    r_b ← the sum of h_j (b_j · n)", "    if |n · l| > r_a + r_b: return DISJOINT", "return OVERLAP"},
      {4, "r_b ← the sum of h_j |b_j · n|",
       "The farthest corner takes each sign as needed, so no two terms may cancel. With *r*_b too small, axes separate "
       "boxes that meet."},
      "normal-of-a", {{"b", "0.5,0.5,-0.5"}});
}

}  // namespace isect::lessons::obb_obb_lesson
