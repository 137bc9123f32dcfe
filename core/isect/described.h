#pragma once
// The parts of each shape, listed once: its name, its fields in the order in which they are written, and what they must
// keep so that it has a point. Code that reads, writes, checks or explains shapes goes through these lists, whatever
// the format or the language:
//
//   each_field(ball, [](const auto& field, const auto& value) { print(field.name, value); });  // center, radius
//   if (const auto* need = broken_need(ball)) complain(need->field, need->otherwise);
//
// A triangle, a ring and a mesh are made of points alone, and have no fields.

#include <array>
#include <tuple>
#include <utility>

#include <isect/shapes.h>

namespace isect {

/// What a value means: a place; a vector of any length but 0; an axis of length 1; lengths along axes; a radius of at
/// least 0; a number; an end of a range, which may be infinite.
enum class Means { place, direction, axis, lengths, radius, number, end };

/// A field of a shape x: at(x) is its value, to be read or assigned.
template <class At>
struct FieldOf {
  const char* name;
  Means means;
  const char* help;
  At at;
  bool optional = false;  ///< if it is not given, the value of X{} stays
};
template <class At>
FieldOf(const char*, Means, const char*, At) -> FieldOf<At>;
template <class At>
FieldOf(const char*, Means, const char*, At, bool) -> FieldOf<At>;

/// The value of a field that is a member, or a member of one.
template <auto... path>
struct Member {
  auto& operator()(auto& x) const { return (x.*....*path); }
};

/// What a shape X must keep to have a point.
template <class X>
struct Need {
  const char* field;      ///< the one that breaks it
  const char* allowed;    ///< "a radius of at least 0"
  const char* otherwise;  ///< "the ball is empty: its radius is below 0"
  bool (*holds)(const X&);
};

/// Described<X>::name; fields, a tuple; needs, an array.
template <class X>
struct Described;

template <class X>
concept is_described = requires {
  Described<X>::name;
};

/// Calls see(field, value) for each field of x, in order.
template <class X, class See>
void each_field(X& x, const See& see) {
  std::apply([&](const auto&... field) { (see(field, field.at(x)), ...); }, Described<std::remove_const_t<X>>::fields);
}

/// The first need that x breaks; null if it has a point.
template <class X>
const Need<X>* broken_need(const X& x) {
  for (const Need<X>& need : Described<X>::needs)
    if (!need.holds(x)) return &need;
  return nullptr;
}

template <class S, int N>
struct Described<Segment<S, N>> {
  using X = Segment<S, N>;
  static constexpr const char* name = "segment";
  static constexpr std::tuple fields = {FieldOf{"from", Means::place, "one end", Member<&X::p>()},
                                        FieldOf{"to", Means::place, "the other end", Member<&X::q>()}};
  static constexpr std::array<Need<X>, 0> needs = {};
};

template <class S, int N>
struct Described<Ray<S, N>> {
  using X = Ray<S, N>;
  static constexpr const char* name = "ray";
  static constexpr std::tuple fields = {
      FieldOf{"origin", Means::place, "where t = 0", Member<&X::origin>()},
      FieldOf{"dir", Means::direction, "the direction, of any length but 0", Member<&X::direction>()},
      FieldOf{"tmin", Means::end, "where it begins; 0 if not given", Member<&X::range, &Interval<S>::lo>(), true},
      FieldOf{"tmax", Means::end, "where it ends; nowhere if not given", Member<&X::range, &Interval<S>::hi>(), true}};
  static constexpr std::array needs = {Need<X>{"tmax", "a tmax of at least tmin",
                                               "the ray is empty: its range ends before it begins",
                                               [](const X& x) { return !empty(x.range); }}};
};

template <class S, int N>
struct Described<Plane<S, N>> {
  using X = Plane<S, N>;
  static constexpr const char* name = "plane";
  static constexpr std::tuple fields = {
      FieldOf{"normal", Means::direction, "the normal n, of any length but 0", Member<&X::normal>()},
      FieldOf{"d", Means::number, "n . x + d = 0", Member<&X::d>()}};
  static constexpr std::array needs = {Need<X>{"normal", "a normal of any length but 0",
                                               "there is no such plane: its normal is 0",
                                               [](const X& x) { return !x.normal.isZero(0); }}};
};

template <class S, int N>
struct Described<Sphere<S, N>> {
  using X = Sphere<S, N>;
  static constexpr const char* name = "sphere";
  static constexpr std::tuple fields = {FieldOf{"center", Means::place, "the centre", Member<&X::center>()},
                                        FieldOf{"radius", Means::radius, "the radius", Member<&X::radius>()}};
  static constexpr std::array needs = {Need<X>{"radius", "a radius of at least 0",
                                               "the ball is empty: its radius is below 0",
                                               [](const X& x) { return x.radius >= 0; }}};
};

template <class S, int N>
struct Described<Capsule<S, N>> {
  using X = Capsule<S, N>;
  static constexpr const char* name = "capsule";
  static constexpr std::tuple fields = {FieldOf{"p", Means::place, "one end of its axis", Member<&X::p>()},
                                        FieldOf{"q", Means::place, "the other end", Member<&X::q>()},
                                        FieldOf{"r", Means::radius, "the radius", Member<&X::radius>()}};
  static constexpr std::array needs = {Need<X>{"r", "a radius of at least 0",
                                               "the capsule is empty: its radius is below 0",
                                               [](const X& x) { return x.radius >= 0; }}};
};

template <class S>
struct Described<Cylinder<S>> {
  using X = Cylinder<S>;
  static constexpr const char* name = "cylinder";
  static constexpr std::tuple fields = {FieldOf{"p", Means::place, "the middle of one end", Member<&X::p>()},
                                        FieldOf{"q", Means::place, "the middle of the other end", Member<&X::q>()},
                                        FieldOf{"r", Means::radius, "the radius", Member<&X::radius>()}};
  static constexpr std::array needs = {
      Need<X>{"r", "a radius of at least 0", "the cylinder is empty: its radius is below 0",
              [](const X& x) { return x.radius >= 0; }},
      Need<X>{"q", "a q other than p", "there is no such cylinder: its axis has no length",
              [](const X& x) { return x.p != x.q; }}};
};

template <class S>
struct Described<Cone<S>> {
  using X = Cone<S>;
  static constexpr const char* name = "cone";
  static constexpr std::tuple fields = {FieldOf{"apex", Means::place, "its tip", Member<&X::apex>()},
                                        FieldOf{"base", Means::place, "the middle of its base", Member<&X::base>()},
                                        FieldOf{"r", Means::radius, "the radius of its base", Member<&X::radius>()}};
  static constexpr std::array needs = {
      Need<X>{"r", "a radius of at least 0", "the cone is empty: its radius is below 0",
              [](const X& x) { return x.radius >= 0; }},
      Need<X>{"base", "a base other than the apex", "there is no such cone: its axis has no length",
              [](const X& x) { return x.apex != x.base; }}};
};

template <class S, int N>
struct Described<Aabb<S, N>> {
  using X = Aabb<S, N>;
  static constexpr const char* name = "box";
  static constexpr std::tuple fields = {FieldOf{"lo", Means::place, "the lowest corner", Member<&X::lo>()},
                                        FieldOf{"hi", Means::place, "the highest corner", Member<&X::hi>()}};
  static constexpr std::array needs = {Need<X>{"lo", "a lo with no coordinate above that of hi",
                                               "the box is empty: on some axis it lies above the box's other end",
                                               [](const X& x) { return !empty(x); }}};
};

template <class S, int N>
struct Described<Obb<S, N>> {
  using X = Obb<S, N>;
  template <int i>
  struct Axis {
    auto operator()(auto& x) const { return x.axes.col(i); }
  };
  static constexpr const char* name = "obb";
  static constexpr std::tuple fields = [] {
    constexpr FieldOf center = {"center", Means::place, "the centre", Member<&X::center>()};
    constexpr FieldOf u = {"u", Means::axis, "the first axis, of length 1", Axis<0>()};
    constexpr FieldOf v = {"v", Means::axis, "the second axis, of length 1", Axis<1>()};
    constexpr FieldOf half = {"half", Means::lengths, "the half-lengths along the axes", Member<&X::half>()};
    if constexpr (N == 3) {
      constexpr FieldOf w = {"w", Means::axis, "the third axis, of length 1", Axis<2>()};
      return std::tuple{center, u, v, w, half};
    } else {
      return std::tuple{center, u, v, half};
    }
  }();
  static constexpr std::array needs = {Need<X>{"half", "half-lengths of at least 0",
                                               "the box is empty: half an edge is below 0",
                                               [](const X& x) { return !empty(x); }}};
};

}  // namespace isect
