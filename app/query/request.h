#pragma once
// Reading a case: every complaint names the field as its path, what is allowed and what was found.

#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

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

  /// The member `key` of an object. Throws BadCase when there is none.
  Field operator[](std::string_view key) const;
  std::optional<Field> find(std::string_view key) const;
  /// Throws BadCase that names a member that is not among these, and the nearest one.
  void only(const std::vector<std::string>& names) const;

  /// How many entries the list has.
  std::size_t size() const;
  /// The entries of a list, to be gone through.
  class Entries;
  Entries list() const;
  /// Those of a list of exactly `count`.
  Entries list(std::size_t count) const;
  template <std::size_t Count>
  std::array<Field, Count> list_of() const;
  std::string text() const;
  bool boolean() const;

  /// A finite number, rounded to S, in whose range it must be.
  template <class S>
  S number() const;
  /// The same, or "inf" or "-inf".
  template <class S>
  S end() const;
  /// Whether it is one of those two.
  bool infinite() const { return says("inf") || says("-inf"); }

  /// Under --strict, throws BadCase that names the field, where the shape has no point.
  void need_points(bool has_none, const char* why) const {
    if (document_->strict && has_none) refuse(why);
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

/// 2 or 3: how many numbers the list has.
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

/// origin, dir, tmin = 0, tmax = inf
template <class S, int N>
Ray<S, N> ray(const Field& request) {
  const auto lo = request.find("tmin"), hi = request.find("tmax");
  const Ray<S, N> r = {vector<S, N>(request["origin"]),
                       vector<S, N>(request["dir"]),
                       {lo ? lo->end<S>() : semi_infinite<S>.lo, hi ? hi->end<S>() : semi_infinite<S>.hi}};
  if (hi || lo) (hi ? *hi : *lo).need_points(empty(r.range), "the ray is empty: its range ends before it begins");
  return r;
}
template <class S, int N>
Sphere<S, N> sphere(const Field& request, const char* center = "center", const char* radius = "radius") {
  const Sphere<S, N> ball = {vector<S, N>(request[center]), request[radius].number<S>()};
  request[radius].need_points(empty(ball), "the ball is empty: its radius is below 0");
  return ball;
}
/// Of a box that has points: names the first of its ends that is infinite.
void need_finite_ends(const Field& lo, const Field& hi);
/// lo, hi: infinite only where the box is empty
template <class S, int N>
Aabb<S, N> box(const Field& request, const char* lo = "lo", const char* hi = "hi") {
  const Aabb<S, N> b = {vector_of_ends<S, N>(request[lo]), vector_of_ends<S, N>(request[hi])};
  if (!empty(b)) need_finite_ends(request[lo], request[hi]);
  request[lo].need_points(empty(b), "the box is empty: on some axis it lies above the box's other end");
  return b;
}
inline const std::vector<std::string> obb_fields = {"c", "u", "e"}, slab_fields = {"lo", "hi"},
                                      capsule_fields = {"p", "q", "r"};
/// p, q, r
template <class S, int N>
Capsule<S, N> capsule(const Field& request) {
  const Capsule<S, N> c = {vector<S, N>(request["p"]), vector<S, N>(request["q"]), request["r"].number<S>()};
  request["r"].need_points(empty(c), "the capsule is empty: its radius is below 0");
  return c;
}
/// p, q, r
template <class S>
Cylinder<S> cylinder(const Field& request) {
  const Cylinder<S> c = {vector<S, 3>(request["p"]), vector<S, 3>(request["q"]), request["r"].number<S>()};
  request["r"].need_points(!(c.radius >= 0), "the cylinder is empty: its radius is below 0");
  request["q"].need_points(empty(c), "there is no such cylinder: its axis has no length");
  return c;
}
/// apex, base, r
template <class S>
Cone<S> cone(const Field& request) {
  const Cone<S> c = {vector<S, 3>(request["apex"]), vector<S, 3>(request["base"]), request["r"].number<S>()};
  request["r"].need_points(!(c.radius >= 0), "the cone is empty: its radius is below 0");
  request["base"].need_points(empty(c), "there is no such cone: its axis has no length");
  return c;
}
/// c, u: N rows, e
template <class S, int N>
Obb<S, N> obb(const Field& request) {
  Obb<S, N> b;
  b.center = vector<S, N>(request["c"]);
  int i = 0;
  for (const Field row : request["u"].list(N)) b.axes.col(i++) = vector<S, N>(row);
  b.half = vector<S, N>(request["e"]);
  request["e"].need_points(empty(b), "the box is empty: half an edge is below 0");
  request["u"].need_points(!obb_obb::detail::exists(b, NoTrace()),
                           "there is no such box: its axes depend on each other");
  return b;
}
/// normal, d
template <class S, int N>
Plane<S, N> plane(const Field& request) {
  const Plane<S, N> p = {vector<S, N>(request["normal"]), request["d"].number<S>()};
  request["normal"].need_points(p.normal.isZero(0), "there is no such plane: its normal is 0");
  return p;
}
/// normals, and {lo, hi} lists of as many ends
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
