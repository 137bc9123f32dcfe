#pragma once
// Shared by the rows of the list of types.

#include "app/scene/shapes.h"
#include "app/scene/types.h"
#include "viz/solids.h"

namespace isect::program::scene {

// The rows, a file each; in files and lists they stand in this order.

std::vector<TypeSpec> straight_types();  ///< point, segment, ray, line, plane
std::vector<TypeSpec> round_types();     ///< sphere, capsule, cylinder, cone
std::vector<TypeSpec> box_types();       ///< box, obb
std::vector<TypeSpec> outline_types();   ///< triangle, polygon
std::vector<TypeSpec> polytope_types();  ///< kdop, frustum, hull
std::vector<TypeSpec> many_types();      ///< mesh, cloud

/// Returns the fields of a shape of the core.
template <class X>
std::vector<FieldSpec> fields_of() {
  std::vector<FieldSpec> all;
  each_field(static_cast<const X&>(X{}), [&](const auto& field, const auto&) {
    all.push_back({field.name, field.means, field.help, field.optional});
  });
  return all;
}

/// Returns the rules for a shape that the ranges of its fields do not express.
template <class X>
std::vector<ShapeRule> rules_of() {
  std::vector<ShapeRule> all;
  const auto add = [&](const Need<X>& need, auto holds) {
    for (const FieldSpec& field : fields_of<X>())
      if (field.name == need.field && field.means != Means::radius && field.means != Means::direction)
        all.push_back({need.field, need.allowed, holds});
  };
  constexpr std::size_t count = Described<X>::needs.size();
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    (add(Described<X>::needs[I],
         [](const NamedValues& s, const Object& o) { return Described<X>::needs[I].holds(made<X>(s, o)); }),
     ...);
  }
  (std::make_index_sequence<count>());
  return all;
}

/// Returns the row of a type whose objects are shapes of the core, field by field.
template <class X>
TypeSpec row(Type type) {
  TypeSpec row = {type, Described<X>::name};
  row.fields = fields_of<X>(), row.rules = rules_of<X>();
  return row;
}

/// The drawing of one object, with its items so far.
struct Drawing {
  const NamedValues& s;
  const Object& o;
  const Room& room;
  viz::Role role;
  std::vector<viz::Item> items = {};

  viz::Vec3 at(const char* field) const { return s.point(o, field); }
  void name(const viz::Vec3& where);
  /// Puts the name beside the way from `where` to `other`.
  void name(const viz::Vec3& where, const viz::Vec3& other);
  void dot(const viz::Vec3& where);
  /// Draws a dot with the name.
  void named_dot(const viz::Vec3& where);
  void dots(const std::vector<viz::Vec3>& points);
  void region(const std::vector<viz::Vec3>& corners);
  /// Draws an outline with the name inside it.
  void outline(const std::vector<std::vector<viz::Vec3>>& rings);
  void solid(viz::Solid);
};

/// The handles of one object so far. A field is changed as viz::Handle says of the kind.
struct Grips {
  const NamedValues& s;
  const Object& o;
  const Room& room;
  viz::Role role;
  std::vector<viz::Handle> all = {};

  viz::Vec3 at(const char* field) const { return s.point(o, field); }
  viz::Handle& add(const std::string& field, viz::Handle::Kind, const viz::Vec3& at,
                   const viz::Vec3& anchor = viz::Vec3::Zero());
  /// Adds one that keeps to the line through `at`: the field is (p - anchor) . direction.
  viz::Handle& on_line(const std::string& field, const viz::Vec3& at, const viz::Vec3& anchor,
                       const viz::Vec3& direction);
  /// Adds one for coordinate `axis` of a vector, which no other handle changes alone.
  viz::Handle& face(const std::string& field, int axis, const viz::Vec3& at, const viz::Vec3& anchor,
                    const viz::Vec3& direction);
  /// Adds one that turns a vector, drawn from the anchor, and with it others.
  void turn(const std::string& field, const std::vector<std::string>& with, const viz::Vec3& at,
            const viz::Vec3& anchor);
  /// Adds one that moves all of these places, unless another one stands where it would.
  void whole(const std::vector<std::string>& fields);
};

/// Returns the corners of a box around a ball.
std::vector<viz::Vec3> around(const viz::Vec3& center, double radius);
/// Returns a vector of length 1 perpendicular to `v`.
viz::Vec3 across(const viz::Vec3& v, bool flat);
viz::Vec3 middle_of(const std::vector<viz::Vec3>& points);
viz::Vec3 top_of(const std::vector<viz::Vec3>& points);

}  // namespace isect::program::scene
