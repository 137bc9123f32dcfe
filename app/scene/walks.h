#pragma once
// The walks of the lessons, on one or two of a scene's objects, or on many of one type.

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
  viz::Walk (*steps_of_many)(const Setting&, const std::vector<const Object*>&) = nullptr;
  const char* method = "";  ///< of those that the lesson has for many
  bool with_ray = false;    ///< the last of the many is a ray

  bool of_many() const { return steps_of_many != nullptr; }
  bool of_one() const { return name_b == nullptr && !of_many(); }
  /// Whether it takes these types, in this order.
  bool takes(Type x, Type y, bool in_plane, bool one) const {
    return a == x && b == y && flat == in_plane && of_one() == one && !of_many();
  }
};
/// All; of several lessons with the same types, the first is the usual one.
const std::vector<LessonWalk>& walks();
/// By what it takes; nullptr where no lesson does. `lesson`: of this one alone, where it is not empty.
const LessonWalk* walk_of(Type a, Type b, bool flat, bool one, const std::string& lesson);
/// Of many objects, by the lesson's id and its method; empty: the first one. nullptr where there is none.
const LessonWalk* walk_of_many(const std::string& lesson, const std::string& method);
/// The methods that a lesson has for many objects.
std::vector<std::string> methods_for_many(const std::string& lesson);
/// "sphere and sphere", ...
std::vector<std::string> walks_in_words(bool flat);
/// The lessons that take a scene's objects.
std::vector<std::string> walking_lessons();

/// The steps of the lesson, on these numbers. Throws viz::BadInput where they are beyond what the lesson takes.
viz::Walk walk(const LessonWalk&, const Setting&, const Object& a, const Object& b);
viz::Walk walk(const LessonWalk&, const Setting&, const std::vector<const Object*>&);

}  // namespace isect::program::scene
