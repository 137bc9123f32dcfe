#pragma once
// The walks of lessons through one or two of a scene's objects, or through many of one type.

#include <string>
#include <vector>

#include "app/scene/objects.h"

namespace isect::program::scene {

struct LessonWalk {
  const char* lesson;           ///< its id
  Type a, b;                    ///< equal for a walk of one object
  bool flat;                    ///< in the plane, or in space
  const char *name_a, *name_b;  ///< their names in the lesson, as markup; for one object the second is null
  viz::Walk (*steps)(const NamedValues&, const Object& a, const Object& b);
  viz::Walk (*steps_of_many)(const NamedValues&, const std::vector<const Object*>&) = nullptr;
  const char* method = "";  ///< one of the lesson's methods for many
  bool with_ray = false;    ///< the last of the many is a ray

  bool of_many() const { return steps_of_many != nullptr; }
  bool of_one() const { return name_b == nullptr && !of_many(); }
  /// Whether it takes these types, in this order.
  bool takes(Type x, Type y, bool in_plane, bool one) const {
    return a == x && b == y && flat == in_plane && of_one() == one && !of_many();
  }
};
/// Returns all walks; of several lessons with the same types, the first is the usual one.
const std::vector<LessonWalk>& walks();
/// Finds a walk by the types that it takes; nullptr if no lesson does. `lesson`: only this one, if it is not empty.
const LessonWalk* walk_of(Type a, Type b, bool flat, bool one, const std::string& lesson);
/// Finds a walk through many objects, by lesson id and method; empty: the first one. nullptr if there is none.
const LessonWalk* walk_of_many(const std::string& lesson, const std::string& method);
/// Returns the methods that a lesson has for many objects.
std::vector<std::string> methods_for_many(const std::string& lesson);
/// Returns "sphere and sphere", ...
std::vector<std::string> walks_in_words(bool flat);
/// Returns the lessons that take a scene's objects.
std::vector<std::string> walking_lessons();

/// Returns one of the names in a lesson in the language that is spoken: "the ball".
std::string name_in_lesson(const char* name);
/// Return the steps of the lesson, on these numbers. Throw viz::BadInput if they are beyond what the lesson takes.
viz::Walk walk(const LessonWalk&, const NamedValues&, const Object& a, const Object& b);
viz::Walk walk(const LessonWalk&, const NamedValues&, const std::vector<const Object*>&);

}  // namespace isect::program::scene
