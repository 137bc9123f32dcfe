#pragma once
// The walks of the lessons, on one or two of a scene's objects.

#include <string>
#include <vector>

#include "app/scene/objects.h"

namespace isect::program::scene {

struct LessonWalk {
  const char* lesson;           ///< its id
  Type a, b;                    ///< the same where it is of one object
  bool flat;                    ///< in the plane, or in space
  const char *name_a, *name_b;  ///< what the lesson calls them, as markup; of one object, the second is null
  viz::Walk (*steps)(const Setting&, const Object& a, const Object& b);

  bool of_one() const { return name_b == nullptr; }
  /// Whether it takes these types, in this order.
  bool takes(Type x, Type y, bool in_plane, bool one) const {
    return a == x && b == y && flat == in_plane && of_one() == one;
  }
};
/// All; of several lessons with the same types, the first is the usual one.
const std::vector<LessonWalk>& walks();
/// By what it takes; nullptr where no lesson does. `lesson`: of this one alone, where it is not empty.
const LessonWalk* walk_of(Type a, Type b, bool flat, bool one, const std::string& lesson);
/// "sphere and sphere", ...
std::vector<std::string> walks_in_words(bool flat);
/// The lessons that take a scene's objects.
std::vector<std::string> walking_lessons();

/// The steps of the lesson, on these numbers. Throws viz::BadInput where they are beyond what the lesson takes.
viz::Walk walk(const LessonWalk&, const Setting&, const Object& a, const Object& b);

}  // namespace isect::program::scene
