#pragma once
// Which of a seam's two triangles a ray meets, by each test.

#include <string>
#include <vector>

#include "lessons/ray_triangle/setup.h"

namespace isect::lessons::ray_triangle_lesson {

enum class Test { exact, moller_trumbore, volumes, shear };
inline constexpr Test rounded_tests[] = {Test::moller_trumbore, Test::volumes, Test::shear};

/// Whether a ray meets abc, and whether it meets its neighbour cbq.
struct Met {
  bool own = false, other = false;
  bool any() const { return own || other; }
  friend bool operator==(const Met&, const Met&) = default;
};
Met met(Test, const Ray3&, const Setup&);
/// "both", "abc alone", "cbq alone", "neither"
std::string words(const Met&);

/// The answers of all tests for one neighbour of the direction.
struct Answers {
  Met exact, rounded[3];

  /// Whether the ray slips through by that one of the rounded tests.
  bool hole(int test) const { return exact.any() && !rounded[test].any(); }
};
/// All neighbours, in the order of microscope::for_each_neighbour.
std::vector<Answers> neighbours(const Setup&);

}  // namespace isect::lessons::ray_triangle_lesson
