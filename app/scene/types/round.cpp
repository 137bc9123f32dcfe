// Balls, capsules, cylinders and cones.

#include <cmath>
#include <numbers>

#include "app/scene/types/rows.h"
#include "lessons/shared/parameters.h"

namespace isect::program::scene {

namespace {

using lessons::unit;
using viz::Vec3;

void draw_sphere(Drawing& d) {
  const Vec3 center = d.at("center");
  const double radius = d.s.number(d.o, "radius");
  if (d.s.flat)
    d.items.push_back(viz::Circle{center, radius, d.role, viz::Pen::solid, true});
  else
    d.items.push_back(viz::Ball{center, radius, d.role});
  d.named_dot(center);
}

/// Returns half a circle about q, then half a one about p.
std::vector<Vec3> outline_of_capsule(const Vec3& p, const Vec3& q, double radius) {
  constexpr int corners = 48;
  const Vec3 along = q.isApprox(p, 0) ? Vec3::UnitX() : unit(q - p);
  const double turn = std::atan2(along.y(), along.x());
  std::vector<Vec3> outline;
  for (int i = 0; i <= corners; ++i) {
    const bool at_q = i <= corners / 2;
    const double angle = turn + (2 * std::numbers::pi * (i - (at_q ? 0 : 1)) / (corners - 1)) - std::numbers::pi / 2;
    outline.push_back((at_q ? q : p) + radius * Vec3(std::cos(angle), std::sin(angle), 0));
  }
  return outline;
}

void draw_capsule(Drawing& d) {
  const Vec3 p = d.at("p"), q = d.at("q");
  const double r = d.s.number(d.o, "r");
  d.items.push_back(viz::Line{p, q, d.role, viz::Pen::construction});
  if (d.s.flat) {
    d.region(outline_of_capsule(p, q, r));
  } else {  // drawn as one body
    d.items.push_back(viz::Ball{p, r, d.role});
    if (p != q) d.items.push_back(viz::Ball{q, r, d.role});
  }
  d.name(p, q);
}

/// Returns corners of boxes around the end discs, whose reach along an axis is by the sine of the angle to their own.
std::vector<Vec3> around_discs(const Vec3& p, double at_p, const Vec3& q, double at_q) {
  constexpr double outwards = 1 + 0x1p-50;  // more than the rounding
  const Vec3 axis = (q - p).stableNormalized();
  const Vec3 reach =
      outwards * Vec3(std::hypot(axis.y(), axis.z()), std::hypot(axis.z(), axis.x()), std::hypot(axis.x(), axis.y()));
  return {p - at_p * reach, p + at_p * reach, q - at_q * reach, q + at_q * reach};
}

template <class X>
void draw_round(Drawing& d) {
  const viz::Solid solid = viz::solid(made<X>(d.s, d.o), d.role);
  d.items.push_back(viz::Line{solid.round->from, solid.round->to, d.role, viz::Pen::construction});
  d.items.push_back(solid);
  d.name((solid.round->from + solid.round->to) / 2);
}

}  // namespace

std::vector<TypeSpec> round_types() {
  TypeSpec sphere = row<Sphere<double, 3>>(Type::sphere);
  sphere.in_plane = "circle";
  sphere.extent = [](const NamedValues& s, const Object& o) {
    return around(s.point(o, "center"), s.number(o, "radius"));
  };
  sphere.draw = draw_sphere;
  sphere.radius_at = [](const NamedValues& s, const Object& o) {
    return std::pair<Vec3, Vec3>(s.point(o, "center"), Vec3::UnitX());
  };

  TypeSpec capsule = row<Capsule<double, 3>>(Type::capsule);
  capsule.extent = [](const NamedValues& s, const Object& o) {
    const std::vector<Vec3> p = around(s.point(o, "p"), s.number(o, "r")),
                            q = around(s.point(o, "q"), s.number(o, "r"));
    return std::vector{p[0], p[1], q[0], q[1]};
  };
  capsule.draw = draw_capsule;
  capsule.whole = {"p", "q"};
  capsule.radius_at = [](const NamedValues& s, const Object& o) {
    const Vec3 p = s.point(o, "p"), q = s.point(o, "q");
    return std::pair<Vec3, Vec3>(q, p == q ? Vec3::UnitY() : across(q - p, s.flat));
  };

  TypeSpec cylinder = row<Cylinder<double>>(Type::cylinder);
  cylinder.in_plane = "";
  cylinder.extent = [](const NamedValues& s, const Object& o) {
    const Cylinder<double> x = made<Cylinder<double>>(s, o);
    return around_discs(x.p, x.radius, x.q, x.radius);
  };
  cylinder.draw = draw_round<Cylinder<double>>;
  cylinder.whole = capsule.whole;
  cylinder.radius_at = capsule.radius_at;

  TypeSpec cone = row<Cone<double>>(Type::cone);
  cone.in_plane = "";
  cone.extent = [](const NamedValues& s, const Object& o) {
    const Cone<double> x = made<Cone<double>>(s, o);
    return around_discs(x.apex, 0, x.base, x.radius);
  };
  cone.draw = draw_round<Cone<double>>;
  cone.whole = {"apex", "base"};
  cone.radius_at = [](const NamedValues& s, const Object& o) {
    const Cone<double> x = made<Cone<double>>(s, o);
    return std::pair<Vec3, Vec3>(x.base, across(x.base - x.apex, false));
  };
  return {sphere, capsule, cylinder, cone};
}

}  // namespace isect::program::scene
