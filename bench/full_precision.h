#pragma once
// Shapes in full precision, for the first case that a method judges wrongly.

#include <string>

#include <isect/described.h>

#include "bench/contest.h"
#include "bench/ordinary_shapes.h"

namespace isect {
template <class S>
struct Hull3;
template <class S>
struct TriangulatedPolygon;
}  // namespace isect

namespace isect::bench {

template <class S>
std::string full_precision(const Interval<S>& x) {
  return text("lo", x.lo, "hi", x.hi);
}
template <class S, int N>
std::string full_precision(const Point<S, N>& x) {
  return text("at", x);
}
template <class X>
requires is_described<X> std::string full_precision(const X& x) {
  std::string all;
  each_field(x, [&](const auto& field, const auto& value) {
    if (!all.empty()) all += ' ';
    all += text(field.name, value);
  });
  return all;
}
template <class S, int N>
std::string full_precision(const Triangle<S, N>& x) {
  return text("a", x.vertices[0], "b", x.vertices[1], "c", x.vertices[2]);
}
template <class S, int N>
std::string full_precision(const Ring<S, N>& x) {
  std::string all = "ring";
  for (const Point<S, N>& v : x) all += text(" vertex", v);
  return all;
}
template <class S, int N>
std::string full_precision(const Polygon<S, N>& x) {
  std::string all = "rings:";
  for (const Ring<S, N>& ring : x.rings) (all += ' ') += full_precision(ring);
  return all;
}
template <class S, int N>
std::string full_precision(const Kdop<S, N>& x) {
  std::string all = "slabs:";
  for (std::size_t i = 0; i < x.slabs.size(); ++i)
    all += text(" normal", x.normals[i]), (all += ' ') += full_precision(x.slabs[i]);
  return all;
}
template <class S>
std::string full_precision(const Frustum<S>& x) {
  std::string all = "planes:";
  for (const Plane<S, 3>& plane : x.planes) (all += ' ') += full_precision(plane);
  return all;
}
template <class S>
std::string full_precision(const Hull3<S>& x) {
  std::string all = "hull:";
  for (const Point<S, 3>& v : x.vertices) all += text(" vertex", v);
  return all;
}
template <class S>
std::string full_precision(const TriangulatedPolygon<S>& x) {
  return full_precision(x.outline);
}
template <class A, class B>
std::string full_precision(const Pair<A, B>& c) {
  return "a: " + full_precision(c.a) + "; b: " + full_precision(c.b);
}

}  // namespace isect::bench
