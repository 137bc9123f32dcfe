#pragma once
// What may be asked of two objects: the exact answer of `isect query`, in words and as marks in the picture.

#include <optional>
#include <string>
#include <vector>

#include "app/scene/objects.h"

namespace isect::program::scene {

struct Answer {
  Json query = {}, result = {};  ///< as `isect query` has them; no query where it has no kind for the pair
  viz::Verdict verdict;
  std::string formula = {}, note = {};  ///< markup, may be empty; `note`: what more is to be said of the input
  std::vector<viz::Value> values = {};
  std::vector<viz::Item> marks = {};     ///< where they meet
  std::optional<double> first_hit = {};  ///< of a ray, a line or a segment: the parameter of its first point there
  bool open = false;                     ///< no test decides this pair; `verdict` says why
};

/// The test would be of other numbers than these: why, in words.
struct NotDecided : viz::BadInput {
  using BadInput::BadInput;
};

/// Of any two objects, in either order. Throws viz::BadInput where the core refuses the input, naming the objects.
Answer ask(const Setting&, const Object& a, const Object& b);

}  // namespace isect::program::scene
