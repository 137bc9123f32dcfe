#pragma once
// Questions about two objects: the core's exact answer, also as `isect query` writes it, in words and as marks in the
// picture.

#include <string>
#include <vector>

#include <isect/answer.h>

#include "app/scene/objects.h"
#include "app/scene/shapes.h"

namespace isect::program::scene {

struct Told {
  Answer answer = {};            ///< of the first object to the second; empty for a cloud
  Json query = {}, result = {};  ///< as in `isect query`; no query if it has no kind for the pair
  viz::Verdict verdict = {};
  std::string formula = {}, note = {};  ///< markup, may be empty; `note`: a remark on the input
  std::vector<viz::Value> values = {};
  std::vector<viz::Item> marks = {};  ///< where they meet
  bool open = false;                  ///< no test decides this pair; `verdict` says why
};

/// Thrown if no test decides the pair; the message says why, in words.
struct NotDecided : viz::BadInput {
  using BadInput::BadInput;
};

/// Whether there is a test for objects of these types, in either order.
bool is_decided(Type, Type, bool flat);
/// Asks about any two objects, in either order. Throws viz::BadInput if the core refuses the input, naming the objects.
Told ask(const Shaped& a, const Shaped& b);

}  // namespace isect::program::scene
