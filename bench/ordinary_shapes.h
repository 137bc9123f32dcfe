#pragma once
// Ordinary shapes: sizes and distances of the order of one, so that about as many of them meet as miss.

#include <Eigen/Geometry>
#include <numbers>

#include <isect/shapes.h>
#include "bench/random.h"

namespace isect::bench {

template <class A, class B>
struct Pair {
  A a;
  B b;
};

/// The relations to another shape that a radius is tuned to just reach.
enum class Way { touch, contain, fit_in, any };

template <class S>
Aabb<S, 3> ordinary_box(Random& random) {
  const Point<double, 3> center = random.in_box<3>(1), half = random.in_box<3>(0.3) + Vector<double, 3>::Constant(0.4);
  return {(center - half).cast<S>(), (center + half).cast<S>()};
}
template <class S>
Sphere<S, 3> ordinary_sphere(Random& random) {
  return {random.in_box<3>(1).template cast<S>(), static_cast<S>(random.uniform(0.2, 0.8))};
}
template <class S>
Capsule<S, 3> ordinary_capsule(Random& random) {
  const Point<double, 3> p = random.in_box<3>(1), q = random.in_box<3>(1);
  return {p.cast<S>(), q.cast<S>(), static_cast<S>(random.uniform(0.1, 0.5))};
}
template <class S>
Cylinder<S> ordinary_cylinder(Random& random) {
  const Capsule<S, 3> c = ordinary_capsule<S>(random);
  return {c.p, c.q, c.radius};
}
template <class S>
Cone<S> ordinary_cone(Random& random) {
  const Capsule<S, 3> c = ordinary_capsule<S>(random);
  return {c.p, c.q, 2 * c.radius};
}
template <class S>
Ray<S, 3> ordinary_ray(Random& random) {
  const Point<double, 3> from = 3 * random.heading<3>(), towards = random.in_box<3>(1);
  return {from.cast<S>(), (towards - from).cast<S>()};
}
/// A random box whose center is at most `spread` from the origin along each axis.
template <class S>
Obb<S, 3> ordinary_obb(Random& random, double spread) {
  const Vector<double, 3> axis = random.heading<3>();  // drawn in turn: arguments have no order
  const double angle = random.uniform(0, 2 * std::numbers::pi);
  const Eigen::Quaterniond turn = Eigen::AngleAxisd(angle, axis) * Eigen::Quaterniond::Identity();
  const Vector<double, 3> half = random.in_box<3>(0.4) + Vector<double, 3>::Constant(0.6);
  return {random.in_box<3>(spread).template cast<S>(), turn.toRotationMatrix().cast<S>(), half.cast<S>()};
}
template <class S>
Triangle<S, 3> ordinary_triangle(Random& random) {
  const auto corner = [&] { return Point<S, 3>(random.in_box<3>(1.5).template cast<S>()); };
  const Point<S, 3> a = corner(), b = corner();
  return {{a, b, corner()}};
}

}  // namespace isect::bench
