#pragma once
// Reading a case: every complaint names the field as its path, what is allowed and what was found.

#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <isect/described.h>
#include <isect/obb_obb.h>
#include <isect/shapes.h>
#include "app/query/document.h"

namespace isect::query {

/// A case that can't be answered; the message names the field.
struct BadCase : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A value inside a case.
class Field {
 public:
  Field(const Document& document, std::size_t at) : document_(&document), at_(at) {}

  /// Returns the member `key` of an object. Throws BadCase if there is none.
  Field operator[](std::string_view key) const;
  std::optional<Field> find(std::string_view key) const;
  /// Throws BadCase that names a member that is not among these, and the nearest one.
  void only(const std::vector<std::string>& names) const;

  /// Returns how many entries the list has.
  std::size_t size() const;
  /// The entries of a list, to iterate over.
  class Entries;
  Entries list() const;
  /// Returns the entries of a list of exactly `count`.
  Entries list(std::size_t count) const;
  template <std::size_t Count>
  std::array<Field, Count> list_of() const;
  std::string text() const;
  bool boolean() const;

  /// Returns a finite number, rounded to S; it must be in the range of S.
  template <class S>
  S number() const;
  /// Returns such a number, or an infinite one for "inf" or "-inf".
  template <class S>
  S end() const;
  /// Whether it is "inf" or "-inf".
  bool infinite() const { return says("inf") || says("-inf"); }

  /// Whether a shape without a point is to be refused.
  bool strict() const { return document_->strict; }
  void need_points(bool has_none, const char* why) const {
    if (strict() && has_none) refuse(why);
  }

  std::string path() const { return document_->path(at_); }
  [[noreturn]] void complain(const std::string& what) const;  ///< what is expected
  [[noreturn]] void refuse(const std::string& why) const;

 private:
  Type type() const { return document_->value(at_).type; }
  bool says(std::string_view text) const { return type() == Type::text && document_->text(at_) == text; }
  std::string name() const;  ///< field "a.u[1]"

  const Document* document_;
  std::size_t at_;
};

class Field::Entries {
 public:
  class Iterator {
   public:
    Iterator(const Document& document, std::size_t at) : document_(&document), at_(at) {}
    Field operator*() const { return {*document_, at_}; }
    Iterator& operator++() {
      at_ = document_->next(at_);
      return *this;
    }
    friend bool operator==(const Iterator& a, const Iterator& b) { return a.at_ == b.at_; }

   private:
    const Document* document_;
    std::size_t at_;
  };

  Entries(const Document& document, std::size_t at) : document_(&document), at_(at) {}
  Iterator begin() const { return {*document_, at_ + 1}; }
  Iterator end() const { return {*document_, document_->next(at_)}; }
  std::size_t size() const { return document_->value(at_).size; }
  bool empty() const { return size() == 0; }
  Field front() const { return *begin(); }

 private:
  const Document* document_;
  std::size_t at_;
};

template <std::size_t Count>
std::array<Field, Count> Field::list_of() const {
  auto entry = list(Count).begin();
  return [&]<std::size_t... I>(std::index_sequence<I...>) {
    return std::array<Field, Count>{((void)(I > 0 ? ++entry : entry), *entry)...};
  }
  (std::make_index_sequence<Count>());
}

/// Returns 2 or 3: how many numbers the list has.
int dimension(const Field&);

template <class S, int N>
Vector<S, N> vector(const Field& field) {
  Vector<S, N> v;
  int i = 0;
  for (const Field entry : field.list(N)) v[i++] = entry.number<S>();
  return v;
}
template <class S, int N>
Vector<S, N> vector_of_ends(const Field& field) {
  Vector<S, N> v;
  int i = 0;
  for (const Field entry : field.list(N)) v[i++] = entry.end<S>();
  return v;
}
template <class S>
Interval<S> interval(const Field& field) {
  const auto [lo, hi] = field.list_of<2>();
  const Interval<S> ends = {lo.end<S>(), hi.end<S>()};
  field.need_points(empty(ends), "the interval is empty: it ends before it begins");
  return ends;
}
template <class S, int N>
Ring<S, N> ring(const Field& field) {
  Ring<S, N> points;
  points.reserve(field.size());
  for (const Field entry : field.list()) points.push_back(vector<S, N>(entry));
  return points;
}

template <class S, int N = 2>
Segment<S, N> segment(const Field& field) {
  const auto [p, q] = field.list_of<2>();
  return {vector<S, N>(p), vector<S, N>(q)};
}

/// Names of a shape's fields in their order; none: those of isect/described.h.
using FieldNames = std::initializer_list<std::string_view>;

/// Throws BadCase, which names the field, if the shape has no point and the request is strict.
template <class X>
void need_points(const Field& request, const X& x, FieldNames names = {}) {
  if (!request.strict()) return;
  const Need<X>* need = broken_need(x);
  if (!need) return;
  const std::string_view* other = names.begin();
  std::optional<Field> blamed;  // if the field is not given, the one before
  bool reached = false;
  each_field(x, [&](const auto& field, const auto&) {
    const std::string_view name = names.size() == 0 ? field.name : *other++;
    if (const auto given = request.find(name); given && !reached) blamed = given;
    reached |= std::string_view(field.name) == need->field;
  });
  blamed->refuse(need->otherwise);
}

/// Reads a shape from its fields.
template <class X>
X shape(const Field& request, FieldNames names = {}) {
  X x = {};
  const std::string_view* other = names.begin();
  each_field(x, [&](const auto& field, auto&& value) {
    const std::string_view name = names.size() == 0 ? field.name : *other++;
    if (field.optional && !request.find(name)) return;
    using T = std::remove_cvref_t<decltype(value)>;
    if constexpr (!std::is_floating_point_v<T>)
      value = vector<typename T::Scalar, T::RowsAtCompileTime>(request[name]);
    else if (field.means == Means::end)
      value = request[name].template end<T>();
    else
      value = request[name].template number<T>();
  });
  need_points(request, x, names);
  return x;
}

template <class S, int N>
Ray<S, N> ray(const Field& request) {
  return shape<Ray<S, N>>(request);
}
template <class S, int N>
Sphere<S, N> sphere(const Field& request, const char* center = "center", const char* radius = "radius") {
  return shape<Sphere<S, N>>(request, {center, radius});
}
template <class S, int N>
Capsule<S, N> capsule(const Field& request) {
  return shape<Capsule<S, N>>(request);
}
template <class S>
Cylinder<S> cylinder(const Field& request) {
  return shape<Cylinder<S>>(request);
}
template <class S>
Cone<S> cone(const Field& request) {
  return shape<Cone<S>>(request);
}
template <class S, int N>
Plane<S, N> plane(const Field& request) {
  return shape<Plane<S, N>>(request);
}

/// Throws BadCase for a box that has points: names the first of its ends that is infinite.
void need_finite_ends(const Field& lo, const Field& hi);
/// Reads a box. Its ends may be infinite only if the box is empty.
template <class S, int N>
Aabb<S, N> box(const Field& request, const char* lo = "lo", const char* hi = "hi") {
  const Aabb<S, N> b = {vector_of_ends<S, N>(request[lo]), vector_of_ends<S, N>(request[hi])};
  if (!empty(b)) need_finite_ends(request[lo], request[hi]);
  need_points(request, b, {lo, hi});
  return b;
}

inline const std::vector<std::string> obb_fields = {"c", "u", "e"}, slab_fields = {"lo", "hi"},
                                      capsule_fields = {"p", "q", "r"};
/// Reads c, u: N rows, e, as public suites write them.
template <class S, int N>
Obb<S, N> obb(const Field& request) {
  Obb<S, N> b;
  b.center = vector<S, N>(request["c"]);
  int i = 0;
  for (const Field row : request["u"].list(N)) b.axes.col(i++) = vector<S, N>(row);
  b.half = vector<S, N>(request["e"]);
  request["e"].need_points(empty(b), Described<Obb<S, N>>::needs[0].otherwise);
  request["u"].need_points(!has_points(b), "there is no such box: its axes depend on each other");
  return b;
}
/// Reads normals, and {lo, hi} lists of as many ends.
template <class S, int N>
Kdop<S, N> kdop(const Field& normals, const Field& slabs) {
  slabs.only(slab_fields);
  Kdop<S, N> k = {ring<S, N>(normals), {}};
  const auto hi = slabs["hi"].list(k.normals.size());
  auto end = hi.begin();
  for (const Field lo : slabs["lo"].list(k.normals.size())) {
    k.slabs.push_back({lo.number<S>(), (*end).template number<S>()});
    lo.need_points(empty(k.slabs.back()), "the k-DOP is empty: this slab ends before it begins");
    ++end;
  }
  return k;
}

/// Calls what.operator()<N>() with the dimension that the list shows.
template <class What>
auto in_dimension(const Field& list, const What& what) {
  return dimension(list) == 2 ? what.template operator()<2>() : what.template operator()<3>();
}

}  // namespace isect::query
