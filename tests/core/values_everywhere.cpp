// Verdicts and values of the core on any machine, with no library but Eigen. Checks each value's promise by exact
// arithmetic, and prints two checksums of all bits, one of the verdicts and one of the values. values_everywhere.cmake
// compares the results of several compilers.

#include <isect/polygon.h>
#include <isect/ray_aabb.h>
#include <isect/ray_plane.h>
#include <isect/ray_polygon.h>
#include <isect/ray_sphere.h>
#include <isect/ray_triangle.h>
#include <isect/segment_segment.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <vector>

#include "bench/random.h"

namespace {
using namespace isect;
using bench::Random;

struct Sum {
  std::uint64_t bits = 0xcbf29ce484222325;
  void operator+=(std::uint64_t x) { bits = (bits ^ x) * 0x100000001b3; }
  void operator+=(double x) { *this += std::bit_cast<std::uint64_t>(x == 0 ? 0 : x); }
  void operator+=(float x) { *this += static_cast<double>(x); }
  void operator+=(bool x) { *this += std::uint64_t{x}; }
  void operator+=(int x) { *this += static_cast<std::uint64_t>(x); }
};
Sum verdicts, values;
int broken = 0, asked = 0;

void promise(bool kept, const char* what) {
  ++asked;
  if (!kept && ++broken <= 10) std::printf("broken: %s\n", what);
}

template <class S>
double ulp(S x) {
  const S size = std::abs(x), next = std::nextafter(size, std::numeric_limits<S>::infinity());
  return static_cast<double>(next - size);
}

/// Whether x lies within `ulps` of num / den.
template <class S>
bool near(S x, const Exact& num, const Exact& den, double ulps) {
  const Exact off = Exact(static_cast<double>(x)) * den - num, room = Exact(ulps * ulp(x)) * den;
  return (abs(off) - abs(room)).sign() <= 0;
}

enum class Kind { ordinary, short_steps, touching, scaled };

/// Numbers of one kind, made without a function of the mathematical library that could differ.
template <class S>
struct Draw {
  Random& random;
  Kind kind;

  S number() const {
    switch (kind) {
      case Kind::ordinary:
        return static_cast<S>(random.uniform(-2, 2));
      case Kind::short_steps:
        return static_cast<S>(random.integer(-30, 30) / 10.);
      case Kind::touching:
        return static_cast<S>(random.integer(-4, 4));
      case Kind::scaled: {
        const double x = random.uniform(-2, 2);  // in a statement of its own: arguments have no order
        return static_cast<S>(std::ldexp(x, random.integer(-30, 30)));
      }
    }
    return 0;
  }
  Vector<S, 3> vector() const {
    const S x = number(), y = number();
    return {x, y, number()};
  }
  Vector<S, 3> heading() const {
    for (;;)
      if (const Vector<S, 3> v = vector(); v != Vector<S, 3>::Zero()) return v;
  }
  Ray<S, 3> ray() const {
    const Vector<S, 3> origin = vector();
    return {origin, heading()};
  }
};

template <class S>
Components<Exact, 3> exact(const Vector<S, 3>& v) {
  return exactly<Exact, 3>(Vector<double, 3>(v.template cast<double>()));
}
template <class S>
Components<Exact, 3> between(const Vector<S, 3>& from, const Vector<S, 3>& to) {
  const Components<Exact, 3> p = exact(from), q = exact(to);
  return {q[0] - p[0], q[1] - p[1], q[2] - p[2]};
}

template <class S>
void planes(const Draw<S>& d) {
  const Ray<S, 3> ray = d.ray();
  const Vector<S, 3> normal = d.heading();
  const Plane<S, 3> plane = {normal, d.number()};
  const RayPlane<S> meeting = intersect(ray, plane);
  verdicts += meeting.parallel, verdicts += meeting.meets;
  if (!meeting.line) return;
  const Exact num = dot(exact(normal), exact(ray.origin)) + Exact(static_cast<double>(plane.d));
  const Exact den = dot(exact(normal), exact(ray.direction));
  promise(near(*meeting.line, -num, den, 2), "t of a ray and a plane");
  values += *meeting.line;
}

template <class S>
void spheres(const Draw<S>& d) {
  const Ray<S, 3> ray = d.ray();
  const Vector<S, 3> center = d.vector();
  const Sphere<S, 3> sphere = {center, std::abs(d.number())};
  const RaySphere<S> meeting = intersect(ray, sphere);
  verdicts += meeting.line_roots, verdicts += bool(meeting), verdicts += static_cast<int>(meeting.origin);
  if (meeting.line_roots < 2) return;
  const Components<Exact, 3> f = between(center, ray.origin), along = exact(ray.direction);
  const Exact r(static_cast<double>(sphere.radius)), a = dot(along, along), b = dot(f, along), c = dot(f, f) - r * r;
  const auto beyond = [&](S t, int side) -> int {  // the polynomial's sign 2.5 ulp before or after t
    const Exact e = Exact(static_cast<double>(t)) + Exact(side * 2.5 * ulp(t));
    return (a * e * e + Exact(2.) * b * e + c).sign();
  };
  const Interval<S> t = meeting.roots;
  promise(beyond(t.lo, -1) >= 0 && beyond(t.hi, 1) >= 0, "roots of a ray and a sphere, outwards");
  const bool apart = t.hi - t.lo > 8 * ulp(std::max(std::abs(t.lo), std::abs(t.hi)));
  promise(!apart || (beyond(t.lo, 1) <= 0 && beyond(t.hi, -1) <= 0), "roots of a ray and a sphere, inwards");
  values += t.lo, values += t.hi;
}

template <class S>
void triangles(const Draw<S>& d) {
  Ray<S, 3> ray = d.ray();
  const Vector<S, 3> a = d.vector(), b = d.vector(), c = d.vector();
  if (d.random.one_in(2)) ray.direction = (a + b + c) / S(3) - ray.origin;
  const RayTriangle<S> meeting = intersect(ray, Triangle<S, 3>{{a, b, c}});
  verdicts += meeting.coplanar, verdicts += static_cast<int>(meeting.location), verdicts += bool(meeting);
  if (!meeting.t) return;
  const Components<Exact, 3> n = cross(between(a, b), between(a, c));
  promise(near(*meeting.t, dot(n, between(ray.origin, a)), dot(n, exact(ray.direction)), 2), "t of a triangle");
  values += *meeting.t, values += meeting.u, values += meeting.v;
}

template <class S>
void boxes(const Draw<S>& d) {
  const Ray<S, 3> ray = d.ray();
  const Vector<S, 3> p = d.vector(), q = d.vector();
  const auto part = intersect(ray, Aabb<S, 3>{p.cwiseMin(q), p.cwiseMax(q)});
  verdicts += part.has_value();
  if (!part) return;
  values += part->lo, values += part->hi;
}

template <class S>
void segments(const Draw<S>& d) {
  const auto point = [&] { return Point<S, 2>(d.vector().template head<2>()); };
  const Point<S, 2> a = point(), b = point(), c = point(), e = point();
  verdicts += intersects(Segment<S, 2>{a, b}, Segment<S, 2>{c, e});
}

template <class S>
void polygons(const Draw<S>& d) {
  const int n = d.random.integer(3, 12);
  Ring<S, 3> ring;
  for (int i = 0; i < n; ++i) ring.push_back(d.vector());
  const std::optional<Vector<S, 3>> normal = isect::normal(ring);
  verdicts += normal.has_value();
  if (!normal) return;
  Components<Exact, 3> area = {Exact(0.), Exact(0.), Exact(0.)};
  for (int i = 1; i + 1 < n; ++i) {
    const Components<Exact, 3> term = cross(between(ring[0], ring[i]), between(ring[0], ring[i + 1]));
    for (int k = 0; k < 3; ++k) area[k] = area[k] + term[k];
  }
  const Exact square = dot(area, area);
  const auto order = [&](const Exact& x, const Exact& bound) -> int {  // of x |area| and `bound`
    if (x.sign() != bound.sign()) return x.sign() < bound.sign() ? -1 : 1;
    return x.sign() * (x * x * square - bound * bound).sign();
  };
  const Exact eps(std::numeric_limits<S>::epsilon());
  for (int k = 0; k < 3; ++k) {
    const Exact x(static_cast<double>((*normal)[k]));
    promise(order(x - eps, area[k]) <= 0 && order(x + eps, area[k]) >= 0, "normal of a polygon");
    values += (*normal)[k];
  }
  const S size = isect::area(ring);
  const Exact twice(2 * static_cast<double>(size)), room(6 * ulp(size)), low = twice - room, high = twice + room;
  promise((low * low - square).sign() <= 0 && (high * high - square).sign() >= 0, "area of a polygon");
  values += size;

  Ray<S, 3> ray = d.ray();
  if (d.random.one_in(2)) ray.direction = (ring[0] + ring[1] + ring[2]) / S(3) - ray.origin;
  const RayPolygon<S> meeting = intersect(ray, ring);
  verdicts += static_cast<int>(meeting.location), verdicts += bool(meeting), verdicts += meeting.coplanar;
  if (!meeting.line) return;
  promise(near(*meeting.line, dot(area, between(ray.origin, ring[0])), dot(area, exact(ray.direction)), 2),
          "t of a ray and a polygon");
  values += *meeting.line;
}

template <class S>
void all(int cases) {
  Random random(1);
  for (const Kind kind : {Kind::ordinary, Kind::short_steps, Kind::touching, Kind::scaled})
    for (int i = 0; i < cases; ++i) {
      const Draw<S> d{random, kind};
      planes(d), spheres(d), triangles(d), boxes(d), segments(d), polygons(d);
    }
}

}  // namespace

int main() {
  all<double>(3000);
  all<float>(3000);
  std::printf("values asked: %d, promises broken: %d\nverdicts %016llx\nvalues %016llx\n", asked, broken,
              static_cast<unsigned long long>(verdicts.bits), static_cast<unsigned long long>(values.bits));
  return broken != 0;
}
