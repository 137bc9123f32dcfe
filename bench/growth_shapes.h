#pragma once
// Shapes of any number of parts, for time against size.

#include <cmath>
#include <numbers>
#include <vector>

#include "bench/random.h"
#include "core/shapes.h"

namespace isect::bench {

enum class Outline { convex, smooth, spiky };

/// A polygon around the origin; a smooth one has five waves, a spiky one a random radius at each vertex.
inline Ring<double, 2> outline_of(Outline kind, int n) {
  Random random(stream(1, "outline"));
  Ring<double, 2> ring;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    double radius = 1;
    if (kind == Outline::smooth) radius = 0.7 + 0.3 * std::sin(5 * angle);
    if (kind == Outline::spiky) radius = random.uniform(0.1, 1);
    ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return ring;
}

/// In the square from -1 to 1.
inline Ring<double, 2> points_in_square(int count) {
  Random random(stream(1, "anywhere"));
  Ring<double, 2> points;
  for (int i = 0; i < count; ++i) points.push_back(random.in_box<2>(1));
  return points;
}

}  // namespace isect::bench
