#pragma once
// How the window lists and changes the objects of a scene that was made from a file, and saves one that has none.
// Whoever knows such files gives the functions (app/scene/editor.h); here nothing reads or writes one.

#include <functional>
#include <string>
#include <vector>

#include "viz/lesson.h"

namespace isect::viz {

/// An object of a scene.
struct SceneObject {
  std::string name;
  std::string shown;  ///< its name as markup
  std::string type;   ///< in words: "circle"
  bool hidden = false;
};

/// A type of objects that can be added.
struct SceneType {
  std::string id;
  std::string words;
};

/// A question that can be added, or that is asked.
struct SceneQuestion {
  std::string id;
  std::string words;  ///< plain text
};

/// A side of an outline whose corners can become more or fewer.
struct SceneSide {
  std::string object;  ///< its name
  int corner = 1;      ///< where it begins: counted from 1 through all outlines of the object
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();
  /// Returns what the handle of that corner moves: "P.3".
  std::string parameter() const { return object + "." + std::to_string(corner); }
};

/// A change that a reader asks for.
struct SceneEdit {
  enum class Kind { add, remove, rename, hide, show, ask, unask, add_corner, remove_corner };
  Kind kind = Kind::add;
  std::string what = {};       ///< the object's name; what is added or no longer asked: the id of a type, of a question
  std::string name = {};       ///< of the object that is added; the new one of an object that is renamed
  Vec3 middle = Vec3::Zero();  ///< where an object or a corner that is added stands
  double size = 1;             ///< and about how far it reaches from there
  int corner = 1;              ///< that is removed, or behind which one is added: as in SceneSide
};

struct SceneEditor {
  /// Returns the objects in their order; none if the lesson is no scene that can be changed. Null: no lesson can.
  std::function<std::vector<SceneObject>(const Lesson&)> objects = {};
  std::function<std::vector<SceneType>(const Lesson&)> types = {};
  /// Returns a name for a new object.
  std::function<std::string(const Lesson&)> free_name = {};
  /// Returns the questions about one object or about two. Those that are asked already are left out.
  std::function<std::vector<SceneQuestion>(const Lesson&, const std::vector<std::string>& names)> questions = {};
  /// Returns the questions that are asked about one object, or about both of two.
  std::function<std::vector<SceneQuestion>(const Lesson&, const std::vector<std::string>& names)> asked = {};
  /// Returns the sides of all objects whose corners can become more or fewer, with these numbers.
  std::function<std::vector<SceneSide>(const Lesson&, const Parameters&)> sides = {};
  /// Returns the scene with these numbers and one change, as long-lived as the one before. Throws BadInput, which says
  /// why the change is refused.
  std::function<const Lesson&(const Lesson&, const Parameters&, const SceneEdit&)> edited = {};
};

/// How a scene that has no file yet gets one: it came through a pipe, or in a figure.
struct NewSceneFile {
  /// Returns the scene's text with this setting for a file in this folder; null: the scene has a file, or can't be
  /// saved. Throws BadInput where a file that it names is not in that folder.
  std::function<std::string(const Lesson&, const Parameters&, const std::string& folder)> text = {};
  /// Takes the file that this text was written to as the scene's own, into which it is saved from then on.
  std::function<void(const Lesson&, const Parameters&, const std::string& path)> take = {};
};

}  // namespace isect::viz
