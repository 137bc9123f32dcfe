#pragma once
// Places on the surface of a cylinder or a cone, for whatever is to touch it there: of an ordinary one, up to
// rounding; of one made of integers, exactly.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>

#include "bench/named_draw.h"
#include "bench/ordinary_shapes.h"
#include "bench/random_shapes.h"
#include "bench/simple_shapes.h"

namespace isect::bench {

/// A part of the surface: the side, an end, or the circle where these meet (for a cone sometimes its apex).
enum class Patch { side, end, rim };
inline constexpr Patch all_patches[] = {Patch::side, Patch::end, Patch::rim};

/// A point of the surface, and a normal of a plane that touches the solid there, away from it.
struct Spot {
  Point<double, 3> at;
  Vector<double, 3> normal;
};

template <class S>
Cylinder<S> ordinary_solid(Random& random, const Cylinder<S>*) {
  return ordinary_cylinder<S>(random);
}
template <class S>
Cone<S> ordinary_solid(Random& random, const Cone<S>*) {
  return ordinary_cone<S>(random);
}
template <class Solid>
Solid ordinary_solid(Random& random) {
  return ordinary_solid(random, static_cast<const Solid*>(nullptr));
}
template <class S>
Cylinder<S> solid(Random& random, Numbers numbers, const Cylinder<S>*) {
  return cylinder<S>(random, numbers);
}
template <class S>
Cone<S> solid(Random& random, Numbers numbers, const Cone<S>*) {
  return cone<S>(random, numbers);
}
/// A random solid from any family of numbers.
template <class Solid>
Solid solid(Random& random, Numbers numbers) {
  return solid(random, numbers, static_cast<const Solid*>(nullptr));
}

/// Where the axis begins and ends, and how wide the solid is at the beginning.
template <class S>
struct AxisOf {
  Point<S, 3>&p, &q;
  S narrow;
};
template <class S>
AxisOf<S> axis_of(Cylinder<S>& c) {
  return {c.p, c.q, c.radius};
}
template <class S>
AxisOf<S> axis_of(Cone<S>& c) {
  return {c.apex, c.base, S(0)};
}

/// A rounded spot on that patch of the solid.
template <class Solid>
Spot spot(Random& random, Solid solid, Patch patch) {
  const auto [p, q, narrow] = axis_of(solid);
  const double r = solid.radius, length = (q - p).stableNorm();
  const Vector<double, 3> along = (q - p) / length, across = along.unitOrthogonal(), third = along.cross(across);
  const double angle = random.uniform(0, 2 * std::numbers::pi);
  const Vector<double, 3> radial = std::cos(angle) * across + std::sin(angle) * third;
  const Vector<double, 3> slant = (length * radial - (r - narrow) * along).normalized();
  const bool first = random.one_in(2);
  const double h = patch == Patch::side ? random.uniform(0.05, 0.95) : first ? 0 : 1;
  const double wide = narrow + h * (r - narrow);
  const Vector<double, 3> outwards = first ? Vector<double, 3>(-along) : along;
  switch (patch) {
    case Patch::side:
      return {p + h * (q - p) + wide * radial, slant};
    case Patch::end:
      return {p + h * (q - p) + random.uniform(0, 1) * wide * radial, outwards};
    default:
      return {p + h * (q - p) + wide * radial, (slant + random.uniform(0.1, 3) * outwards).normalized()};
  }
}

/// A solid of whole numbers, and a place on its side, its end, its apex or its rim that is whole, as is the normal: in
/// a frame of three vectors of length 3 like (1, 2, 2), with a side of lengths 3, 4, 5.
template <class Solid>
struct WholeSolid {
  Solid solid;
  Point<double, 3> at;
  Vector<double, 3> normal, tangent;  ///< the normal is 75 long
};
template <class Solid>
WholeSolid<Solid> whole_solid(Random& random, Patch patch) {
  using V = Vector<double, 3>;
  std::array<V, 3> frame = {V(1, 2, 2), V(2, 1, -2), V(2, -2, 1)};
  for (V& v : frame) v *= random.sign();
  std::swap(frame[0], frame[static_cast<std::size_t>(random.below(3))]);
  const V along = frame[0], radial = 3 * frame[1] + 4 * frame[2], tangent = 4 * frame[1] - 3 * frame[2];
  const int s = random.integer(1, 20), i = random.integer(1, s);
  WholeSolid<Solid> c;
  auto [p, q, narrow] = axis_of(c.solid);
  p = Point<double, 3>(random.integer(-99, 99), random.integer(-99, 99), random.integer(-99, 99));
  q = p + 20 * s * along;  // 60 s long
  c.solid.radius = 45 * s;
  c.tangent = tangent;
  constexpr bool is_cone = std::is_same_v<Solid, Cone<double>>;
  const double part = patch == Patch::side ? i : s;  // how far up; radial is 15 long
  c.at = p + 20 * part * along + 3 * (is_cone ? part : s) * radial;
  const V slant = is_cone ? V(4 * radial - 15 * along) : V(5 * radial);
  switch (patch) {
    case Patch::side:
      c.normal = slant;
      break;
    case Patch::end:
      if (is_cone && random.one_in(2)) {
        c.at = p;
        c.normal = random.one_in(2) ? V(-25 * along) : V(3 * radial - 20 * along);
      } else {
        c.at = q + random.integer(0, 3 * s) * radial;
        c.normal = 25 * along;
      }
      break;
    default:
      c.normal = random.one_in(2) ? slant : is_cone ? V(25 * along) : V(3 * radial + 20 * along);
  }
  if (!is_cone && random.one_in(2)) std::swap(p, q);
  return c;
}

/// A number that is NaN or infinite, a radius below 0, or no axis.
template <class Solid>
void spoil(Random& random, Solid& solid) {
  using S = decltype(solid.radius);
  using Limits = std::numeric_limits<S>;
  const S bad = random.one_in(2) ? Limits::quiet_NaN() : Limits::infinity();
  auto [p, q, narrow] = axis_of(solid);
  switch (random.below(5)) {
    case 0:
      p[random.below(3)] = bad;
      break;
    case 1:
      q[random.below(3)] = -bad;
      break;
    case 2:
      solid.radius = bad;
      break;
    case 3:
      q = p;
      break;
    default:
      solid.radius = -1;
  }
}

/// Lengths times 2^exponent.
template <class S>
void scale_solid(int exponent, Cylinder<S>& c) {
  scale(exponent, c.p, c.q, c.radius);
}
template <class S>
void scale_solid(int exponent, Cone<S>& c) {
  scale(exponent, c.apex, c.base, c.radius);
}

}  // namespace isect::bench
