#pragma once
// The objects that a scene file may contain: how each is written, asked about and drawn.
//
// An object's numbers are parameters called "name.field" ("A.center", "t.2"), so that a scene is a lesson like others:
// set by --set, dragged in the window, kept by figures. Many points, and those of a file, are kept as they are instead.

#include <algorithm>
#include <array>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "viz/lesson.h"

namespace isect::program::scene {

/// Cutting a polygon in space into triangles takes time in the square of its corners: these are the most.
inline constexpr std::size_t most_corners = 2'000;

using Json = nlohmann::ordered_json;

/// An object with more points than this has no knobs in the window; its points stay as they are.
inline constexpr std::size_t most_knobs = 40;

enum class Type {
  point,
  segment,
  ray,
  line,
  plane,
  sphere,
  box,
  obb,
  capsule,
  cylinder,
  cone,
  triangle,
  polygon,
  kdop,
  frustum,
  hull,
  mesh,
  cloud
};

/// Values that are not parameters.
struct Fixed {
  std::vector<viz::Vec3> points = {};
  std::vector<std::array<int, 3>> triangles = {};  ///< of a mesh
  std::vector<viz::Vec3> normals = {};             ///< of a k-DOP
};

/// The steps in which something is drawn, counted from 1.
struct StepRange {
  int first = 1, last = std::numeric_limits<int>::max();
  bool has(int step) const { return first <= step && step <= last; }
};

struct Object {
  Type type;
  std::string name;
  std::vector<std::string> fields = {};  ///< those in the file, without the object's name
  std::vector<int> rings = {};           ///< for objects made of points: how many each outline has
  Fixed fixed = {};
  /// Whether its points stay as they are, and what is dragged is "at", which a file need not have.
  bool is_fixed() const { return !fixed.points.empty(); }
  /// Whether its file lacks that "at".
  bool lacks_at() const { return is_fixed() && std::ranges::find(fields, "at") == fields.end(); }
  bool hidden = false;                  ///< left out of the picture, not out of the answers
  std::optional<viz::Role> role = {};   ///< chosen by the author, as the next one; none: the usual one
  std::optional<unsigned> colour = {};  ///< 0xrrggbb
  StepRange steps = {};                 ///< those that draw it, besides those that ask about it
  std::string note = {};                ///< what its file may mean differently than it is read, as plain sentences
};
/// Whether it is a ray, a line or a segment.
bool runs_along_a_line(Type);
/// Returns "a ray", "an obb".
std::string with_article(Type);
/// Returns "circle", "oriented box".
std::string in_words(Type, bool flat);

/// Objects with their numbers, in a plane or in space.
struct NamedValues {
  const viz::Parameters& parameters;
  bool flat = false;

  viz::Vec3 point(const Object&, const std::string& field) const;
  double number(const Object&, const std::string& field) const;
  bool has(const Object&, const std::string& field) const;
  /// Return the points or outlines of an object made of points (cloud, mesh, polygon, ...), moved by its "at", if any:
  /// rounded to doubles, for which all is decided.
  std::vector<viz::Vec3> points(const Object&) const;
  std::vector<std::vector<viz::Vec3>> rings(const Object&) const;
  /// Returns the corners of its finite part: an end of a ray, opposite ends of a box.
  std::vector<viz::Vec3> extent(const Object&) const;

  /// Returns coordinates as `isect query` reads them.
  Json list(const viz::Vec3&) const;
  Json list(const Object& o, const std::string& field) const { return list(point(o, field)); }
};

/// The middle of a scene, and its reach from there: rays and planes are drawn beyond it.
struct Room {
  viz::Vec3 middle = viz::Vec3::Zero();
  double reach = 1;
};

/// Returns the object and its name. Throws viz::BadInput if its numbers are no shape for the core.
std::vector<viz::Item> drawn(const NamedValues&, const Object&, const Room&, viz::Role);
/// Which of its handles an object has: in a crowded picture those that move it and its points, else one for each
/// number.
enum class HandlesOf { points, all };
std::vector<viz::Handle> handles(const NamedValues&, const Object&, const Room&, viz::Role, HandlesOf = HandlesOf::all);
/// Returns its name as markup: "r1" as bold r with index 1.
std::string shown_name(const std::string& name);

}  // namespace isect::program::scene
