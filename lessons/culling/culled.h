#pragma once
// Boxes under a hierarchy against a frustum: which nodes are tested, and what is drawn.

#include <isect/many/bvh.h>
#include "lessons/culling/picture.h"

namespace isect::lessons::culling_lesson {

/// Four clusters of four boxes.
std::vector<Box> few();
/// Boxes around the eye, on every side; the same on every machine.
std::vector<Box> many(int n, const viz::Vec3& eye);

/// A node that was tested, and what became of the boxes below it.
struct Visit {
  int node;
  Answer answer;
  std::vector<std::pair<int, Answer>> tested;  ///< boxes of a leaf that crosses, each tested itself
};

/// What is drawn, in what order nodes are tested, and how many boxes were tested against the frustum.
struct Culled {
  std::vector<Visit> visits;
  std::vector<int> drawn;
  int tests = 0;
};
Culled culled(const Bvh<double, 3>&, const std::vector<Box>&, const Frustum<double>&);

}  // namespace isect::lessons::culling_lesson
