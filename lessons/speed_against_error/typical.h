#pragma once
// What the hard families are made of: one case of each as a small drawing, drawn at random as for the measurements.

#include <string>
#include <vector>

#include "lessons/speed_against_error/sketch.h"
#include "viz/compose/small_multiples.h"

namespace isect::lessons::speed_against_error_lesson {

/// A drawing of a case of each of these families, with its name; without those that the suite does not have any more.
std::vector<viz::Inset> typical(const std::string& test, const std::vector<std::string>& families);
/// From where the cases of a test are seen, as a sentence; empty for a test in the plane.
std::string seen_from(const std::string& test);

}  // namespace isect::lessons::speed_against_error_lesson
