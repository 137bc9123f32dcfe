#include "lessons/robustness/settings.h"

#include <fmt/format.h>

#include <isect/methods/orient.h>
#include <isect/methods/point_polygon.h>
#include <isect/methods/ray_sphere.h>
#include <isect/methods/sphere_sphere.h>
#include <isect/point_polygon.h>
#include <isect/ray_sphere.h>
#include <isect/sphere_sphere.h>
#include "lessons/shared/digits.h"

namespace isect::lessons::robustness_lesson {

using namespace viz;

namespace {

int sign(double x) { return (x > 0) - (x < 0); }

template <class S>
Point<S, 2> neighbour(const Vec3& p, int i, int j) {
  return {microscope::neighbour<S>(p.x(), i), microscope::neighbour<S>(p.y(), j)};
}

/// "(0.1, 0.2)", as it is shown.
template <class S>
std::string written(const Vector<S, 2>& p) {
  return coordinates(Vec2(p.template cast<double>()));
}

template <class S>
Setting orientation(const Vec3& p) {
  Setting s;
  s.title = "On which side of a line?";
  s.naive = "(**b** − **a**) × (**c** − **a**), pivot **a**";
  s.cell = "one position of **a**";
  s.why =
      "The differences from **a** to the far points are rounded. The signs of a whole block of neighbours "
      "come out equal.";
  s.consequence = "A convex hull built on such signs loses a vertex, or turns back on itself.";
  s.measured = "orient2d", s.has_on = true;
  s.verdicts = {"right", "on the line", "left"};
  const Point<S, 2> b = {S(1.5), S(1.5)}, c = {S(3), S(3)};
  s.given = fmt::format("The line runs through **b** = {} and **c** = {}; the point is **a**.", written(b), written(c));
  s.answer = [=](int i, int j) {
    return sign(static_cast<double>(orient::pivoted<orient::Corner::a, S>(neighbour<S>(p, i, j), b, c)));
  };
  s.truth = [=](int i, int j) {
    return orient2d(neighbour<S>(p, i, j).template cast<double>(), b.template cast<double>(),
                    c.template cast<double>());
  };
  s.scene.items = {Line{{-0.25, -0.25, 0}, {3.25, 3.25, 0}, Role::second, Pen::solid},
                   Dot{{1.5, 1.5, 0}, Mark::disc, Role::second},
                   Label{{1.5, 1.5, 0}, "**b**", Role::second},
                   Dot{{3, 3, 0}, Mark::disc, Role::second},
                   Label{{3, 3, 0}, "**c**", Role::second},
                   Dot{p, Mark::disc, Role::first},
                   Label{p, "**a**", Role::first}};
  return s;
}

template <class S>
Setting crossings(const Vec3& p) {
  Setting s;
  s.title = "Inside the polygon?";
  s.naive = "count edges with *p*_x < *x*, by a division";
  s.cell = "one position of **p**";
  s.why = "The *x*-coordinate where the edge crosses is rounded, and the point lies within that error.";
  s.consequence = "A ray aimed at the common edge of two triangles may miss both: it leaks through.";
  s.measured = "point-polygon";
  s.verdicts = {"outside", "on the edge", "inside"};
  const Ring<S, 2> ring = {{S(-1.1), S(-0.9)}, {S(1.3), S(0.7)}, {S(-0.7), S(1.3)}};
  s.given = fmt::format("The polygon's vertices are {}, {} and {}. An edge reaches the height of **p** at *x*.",
                        written(ring[0]), written(ring[1]), written(ring[2]));
  s.answer = [=](int i, int j) { return point_polygon::crossings_naive(neighbour<S>(p, i, j), ring) ? 1 : -1; };
  s.truth = [=](int i, int j) {
    const Location l = locate(neighbour<S>(p, i, j), ring);
    return l == Location::in ? 1 : l == Location::on ? 0 : -1;
  };
  Region region;
  region.rings.emplace_back();
  for (const Point<S, 2>& v : ring)
    region.rings[0].push_back({static_cast<double>(v.x()), static_cast<double>(v.y()), 0});
  region.corners = true;
  s.scene.items = {region, Dot{p, Mark::disc, Role::first}, Label{p, "**p**", Role::first}};
  return s;
}

template <class S>
Setting tangent(const Vec3& p) {
  Setting s;
  s.title = "Does the ray hit the circle?";
  s.naive = "*B*^2 − 4 *A* *C* ≥ 0";
  s.cell = "one position of **o**";
  s.why = "*B*^2 and 4 *A* *C* are nearly equal: what is left of their difference is rounding.";
  s.consequence = "A ray tracer loses pixels at the outline of a ball, or adds some.";
  s.measured = "ray-sphere";
  s.verdicts = {"miss", "tangent", "hit"};
  const Sphere<S, 2> circle = {{S(0.1), S(0.2)}, S(1)};
  const Vector<S, 2> d = {S(2), S(1)};
  s.given = fmt::format(
      "The ray's direction is {}. The circle's centre is {}, its radius {}.\n"
      "*A*, *B* and *C* are the coefficients of the quadratic whose roots are the hits.",
      written(d), written(circle.center), shown(circle.radius));
  s.answer = [=](int i, int j) { return ray_sphere::quadratic(Ray<S, 2>{neighbour<S>(p, i, j), d}, circle) ? 1 : -1; };
  s.truth = [=](int i, int j) {
    const RaySphere<S> exact = intersect(Ray<S, 2>{neighbour<S>(p, i, j), d}, circle);
    return exact.line_roots == 0 ? -1 : exact.line_roots == 1 ? 0 : 1;
  };
  s.scene.items = {Circle{{0.1, 0.2, 0}, 1, Role::second, Pen::solid, true},
                   Arrow{p, p + Vec3(5, 2.5, 0), Role::first, Pen::solid}, Dot{p, Mark::disc, Role::first},
                   Label{p, "**o**", Role::first}};
  return s;
}

template <class S>
Setting spheres(const Vec3& p) {
  Setting s;
  s.title = "Do the circles meet?";
  s.naive = "distance^2 < (*r*_a + *r*_b)^2";
  s.cell = "one position of **c**";
  s.why = "The sum of the radii and both squares are rounded. Near tangency this decides.";
  s.consequence = "A contact begins a frame too late, or flickers while the bodies rest on each other.";
  s.measured = "sphere-sphere";
  s.verdicts = {"disjoint", "touching", "overlapping"};
  const Sphere<S, 2> a = {{S(0), S(0)}, S(0.7)};
  const S r = S(0.3);
  s.given =
      fmt::format("The fixed circle's centre is {}, its radius {}, *r*_a. The other circle has the radius {}, *r*_b.",
                  written(a.center), shown(a.radius), shown(r));
  s.answer = [=](int i, int j) {
    return sphere_sphere::squared_distance_naive(a, Sphere<S, 2>{neighbour<S>(p, i, j), r}) ? 1 : -1;
  };
  s.truth = [=](int i, int j) {
    const Relation relation = relate(a, Sphere<S, 2>{neighbour<S>(p, i, j), r});
    return relation == Relation::disjoint ? -1 : relation == Relation::touching ? 0 : 1;
  };
  s.scene.items = {Circle{{0, 0, 0}, 0.7, Role::second, Pen::solid, true},
                   Circle{p, 0.3, Role::first, Pen::solid, true}, Dot{p, Mark::disc, Role::first},
                   Label{p, "**c**", Role::first}};
  return s;
}

template <class S>
Setting of(const std::string& test, const Vec3& p) {
  if (test == "orientation") return orientation<S>(p);
  if (test == "crossings") return crossings<S>(p);
  if (test == "tangent") return tangent<S>(p);
  return spheres<S>(p);
}

}  // namespace

const std::vector<std::string>& tests() {
  static const std::vector<std::string> all = {"orientation", "crossings", "tangent", "spheres"};
  return all;
}

Vec3 standard_point(const std::string& test) {
  if (test == "orientation") return {0.0625, 0.0625, 0};
  if (test == "crossings") return {0.1, -0.1, 0};
  if (test == "tangent") return {-3.03, -0.2469660112501051, 0};
  return {0.6, 0.8, 0};
}

Setting setting(const std::string& test, const std::string& scalar, const Vec3& p) {
  Setting s = scalar == "float" ? of<float>(test, p) : of<double>(test, p);
  s.scene.handles.push_back({"p", Handle::Kind::point, p, Vec3::Zero(), Role::first});
  return s;
}

Fault fault(const Setting& s, int truth, int answer) {
  if (answer == truth || (truth == 0 && !s.has_on)) return Fault::none;
  return answer == 0 ? Fault::called_on : Fault::wrong_side;
}

}  // namespace isect::lessons::robustness_lesson
