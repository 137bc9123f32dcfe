#pragma once
// What there is to know of each type of objects, once: reading, checking, drawing, dragging and the help go through
// this list. How the core asks an object stands in app/scene/shapes.h.

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

/// What an object's numbers must keep besides their own ranges.
struct ShapeRule {
  std::string field;    ///< the one to blame
  std::string allowed;  ///< "a tmax of at least tmin"
  bool (*holds)(const Setting&, const Object&);
};
struct Drawing;

/// A type of objects. The rows stand in app/scene/types/.
struct TypeSpec {
  Type type;
  std::string name;          ///< as files call it
  std::string words = name;  ///< as sentences do: "oriented box"
  std::string in_plane =
      words;  ///< in the plane, there files may say so, too: "circle"; empty: it exists in space only
  /// In files; none of what is made of points: they are called 1, 2, ...
  std::vector<FieldSpec> fields = {};
  std::string made_of = {};  ///< how files write what is not made of fields: "points (or file)"
  std::vector<ShapeRule> rules = {};

  /// The corners of what is finite of it: an end of a ray, opposite ends of a box. None: its points.
  std::vector<viz::Vec3> (*extent)(const Setting&, const Object&) = nullptr;
  void (*draw)(Drawing&) = nullptr;
  /// The fields that are dragged as the tip of a vector, each with the field where that begins.
  std::vector<std::pair<std::string, std::string>> vectors = {};
  /// Where its radius begins, and in which direction, of length 1, it is dragged.
  std::pair<viz::Vec3, viz::Vec3> (*radius_at)(const Setting&, const Object&) = nullptr;
};
const std::vector<TypeSpec>& types();
const TypeSpec& spec(Type);
/// What files may call it in the plane besides its name: "circle"; empty if nothing.
std::string other_name(const TypeSpec&);

}  // namespace isect::program::scene
