#pragma once
// The walks of the lessons, on a pair of a scene's objects.

#include <string>
#include <vector>

#include "app/scene/objects.h"

namespace isect::program::scene {

struct WalkOfPair {
  Type a, b;
  bool flat;                    ///< in the plane, or in space
  const char *name_a, *name_b;  ///< what the lesson calls them, as markup
  viz::Walk (*steps)(const Setting&, const Object& a, const Object& b);
};
/// In this order; nullptr where no lesson has the pair.
const WalkOfPair* walk_of(Type a, Type b, bool flat);
/// "sphere and sphere", ...
std::vector<std::string> walks_in_words(bool flat);

/// The steps of the lesson, on these numbers. Throws viz::BadInput where they are beyond what the lesson takes.
viz::Walk walk(const WalkOfPair&, const Setting&, const Object& a, const Object& b);

}  // namespace isect::program::scene
