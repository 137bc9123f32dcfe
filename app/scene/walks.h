#pragma once
// The lessons that step through a pair of objects.

#include <optional>
#include <string>
#include <vector>

#include "app/scene/objects.h"

namespace isect::program::scene {

/// A lesson's parameters for two objects of a scene.
struct WalkOfPair {
  Type a, b;
  const char* lesson;
  viz::Parameters (*parameters)(const Setting&, const Object& a, const Object& b);
  const char *name_a, *name_b;  ///< what the lesson calls them, as markup
};
/// In this order, in the plane or in space; nullptr where no lesson has the pair.
const WalkOfPair* walk_of(Type a, Type b, bool flat);
/// "sphere and sphere", ...
std::vector<std::string> walks_in_words(bool flat);

/// The steps of the lesson, on these numbers. Throws viz::BadInput where they are beyond what the lesson takes.
viz::Walk walk(const WalkOfPair&, const Setting&, const Object& a, const Object& b);

}  // namespace isect::program::scene
