#pragma once
// Shapes, verdicts and true values as `isect query` writes them.

#include <algorithm>
#include <array>

#include <isect/described.h>

#include "app/query/relation_words.h"
#include "tests/cases/case_file.h"

namespace isect::cases {

inline constexpr double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min(),
                        inf = std::numeric_limits<double>::infinity();

template <class S>
constexpr bool is_f32 = std::is_same_v<S, float>;

template <class S>
Json json(S x) {
  if (std::isnan(x)) return "nan";
  if (std::isinf(x)) return x > 0 ? "inf" : "-inf";
  return static_cast<double>(x);
}
template <class S, int N>
Json json(const Vector<S, N>& v) {
  Json list = Json::array();
  for (int i = 0; i < N; ++i) list.push_back(json(v[i]));
  return list;
}
template <class S, int N>
Json json(const Ring<S, N>& points) {
  Json list = Json::array();
  for (const Point<S, N>& p : points) list.push_back(json<S, N>(p));
  return list;
}
template <class S>
Json json(const Interval<S>& x) {
  return {json(x.lo), json(x.hi)};
}
template <class S, int N>
Json json(const Obb<S, N>& box) {
  Json rows = Json::array();
  for (int i = 0; i < N; ++i) rows.push_back(json<S, N>(box.axes.col(i)));
  return {{"c", json<S, N>(box.center)}, {"u", rows}, {"e", json<S, N>(box.half)}};
}

/// The fields of a shape; a ray's range unless it is from 0 to inf.
template <class X>
Json fields(const X& x) {
  Json all;
  each_field(x, [&](const auto& field, const auto& value) {
    using Value = std::remove_cvref_t<decltype(value)>;
    if constexpr (std::is_floating_point_v<Value>)
      all[field.name] = json(value);
    else
      all[field.name] = json<typename Value::Scalar, Value::RowsAtCompileTime>(value);
  });
  if constexpr (requires { x.range; })
    if (x.range == semi_infinite<decltype(x.range.lo)>) all.erase("tmin"), all.erase("tmax");
  return all;
}
template <class S, int N>
Json fields(const Aabb<S, N>& box, const char* lo, const char* hi) {
  return {{lo, json<S, N>(box.lo)}, {hi, json<S, N>(box.hi)}};
}
template <class S, int N>
Json fields(const Sphere<S, N>& ball, const char* center, const char* radius) {
  return {{center, json<S, N>(ball.center)}, {radius, json(ball.radius)}};
}
/// The fields of two shapes in one case.
inline Json both(Json a, const Json& b) {
  a.update(b);
  return a;
}

inline Json word(Location l) { return l == Location::in ? "in" : l == Location::on ? "on" : "out"; }
inline std::string word(Relation r) { return query::name(r); }
inline Json related(Relation r) { return {{"intersects", r != Relation::disjoint}, {"relation", word(r)}}; }

/// The double nearest to x; infinite beyond the largest.
inline double nearest(const Rational& x) {
  if (abs(x) >= Rational(most) + Rational(std::ldexp(1.0, 970))) return x > 0 ? inf : -inf;
  const double near = std::clamp(static_cast<double>(x), -most, most);
  double best = near;
  for (const double y : {std::nextafter(near, -inf), std::nextafter(near, inf)})
    if (std::isfinite(y) && abs(Rational(y) - x) < abs(Rational(best) - x)) best = y;
  return best;
}

/// How the numbers of a family are made, in words.
inline std::string note_of(Numbers numbers) {
  constexpr const char* words[] = {"sizes near 1",
                                   "small integers, which touch and align",
                                   "small integers, up to 2 ulp off",
                                   "multiples of 0.1",
                                   "1e8 away from the origin",
                                   "sizes from the smallest to the largest, mixed",
                                   "so small that squares vanish",
                                   "so large that squares overflow"};
  return words[static_cast<int>(numbers)];
}

/// Adds draws of every family of numbers, in doubles and, half as many, in floats: draw<S>(random, numbers).
template <class Draw>
void by_numbers(CaseFile& file, int count, const Draw& draw) {
  for (const Numbers numbers : bench::all_numbers) {
    const auto drawn_in_doubles = [&](Random& r) { return draw.template operator()<double>(r, numbers); };
    const auto in_floats = [&](Random& r) { return draw.template operator()<float>(r, numbers); };
    file.family(note_of(numbers), count, drawn_in_doubles);
    file.family(note_of(numbers) + ", in floats", (count + 1) / 2, in_floats);
  }
}

/// Adds draws of named families, each a list with `name` and `draw(random)`; ask(shapes) finds the truth.
template <class Doubles, class Floats, class Ask>
void by_families(CaseFile& file, int count, const Doubles& doubles, const Floats& floats, const Ask& ask) {
  for (const auto& f : doubles) file.family(f.name, count, [&](Random& r) { return ask(f.draw(r)); });
  for (const auto& f : floats)
    file.family(std::string(f.name) + ", in floats", (count + 1) / 2, [&](Random& r) { return ask(f.draw(r)); });
}

}  // namespace isect::cases
