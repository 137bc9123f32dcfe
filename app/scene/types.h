#pragma once
// All properties of each type of objects, in one place: reading, checking, drawing, dragging and the help use this
// list. app/scene/shapes.h says how the core asks an object.

#include <string>
#include <utility>
#include <vector>

#include <isect/described.h>

#include "app/scene/objects.h"

namespace isect::program::scene {

/// A number, place or vector of an object, as it stands in the file.
struct FieldSpec {
  std::string name;
  Means means = Means::place;
  std::string help;
  bool optional = false;
  double lo = means == Means::radius ? 0 : -1e300, hi = 1e300;
};

/// A condition on an object's numbers besides their own ranges.
struct ShapeRule {
  std::string field;    ///< the one to blame
  std::string allowed;  ///< "a tmax of at least tmin"
  bool (*holds)(const NamedValues&, const Object&);
};
struct Drawing;
struct Grips;

/// A type of objects. The rows are in app/scene/types/.
struct TypeSpec {
  Type type;
  std::string name;          ///< as files call it
  std::string words = name;  ///< as sentences do: "oriented box"
  std::string in_plane =
      words;  ///< in the plane, where files may use it, too: "circle"; empty: it exists in space only
  /// The fields in files; none for objects made of points: these are called 1, 2, ...
  std::vector<FieldSpec> fields = {};
  std::string made_of = {};  ///< how files write objects that have no such fields: "points (or file)"
  std::vector<ShapeRule> rules = {};

  /// Returns the corners of its finite part: an end of a ray, opposite ends of a box. Null: its points.
  std::vector<viz::Vec3> (*extent)(const NamedValues&, const Object&) = nullptr;
  void (*draw)(Drawing&) = nullptr;
  /// The fields that are dragged as the tip of a vector, each with the field where the vector begins.
  std::vector<std::pair<std::string, std::string>> vectors = {};
  /// Returns where its radius begins, and in which direction, of length 1, it is dragged.
  std::pair<viz::Vec3, viz::Vec3> (*radius_at)(const NamedValues&, const Object&) = nullptr;
  /// The places that are dragged together. Objects made of points are moved as a whole, too.
  std::vector<std::string> whole = {};
  /// Adds the handles that no field tells of: of faces, of a frame that turns. Null: there are none.
  void (*grips)(Grips&) = nullptr;
  bool with_at = false;  ///< whether objects made of points may have a field "at", by which all of them are moved
  /// What its numbers together need to have corners. A drag stops there; a file's error is told by what draws it.
  std::vector<ShapeRule> drawable = {};
};
const std::vector<TypeSpec>& types();
const TypeSpec& spec(Type);
/// Returns what else files may call it in the plane: "circle"; empty if nothing.
std::string other_name(const TypeSpec&);

/// Where a new object stands, about how far it reaches from there, and whether it lies in the plane.
struct Start {
  viz::Vec3 middle = viz::Vec3::Zero();
  double size = 1;
  bool flat = false;
};
/// Returns a new object as files have it, in numbers that add up without rounding. (types/starts.cpp)
Json start_of(Type, const std::string& name, const Start&);

}  // namespace isect::program::scene
