// Solids that closed meshes bound, against balls, capsules, boxes, hulls, half-spaces, cylinders, cones and each other:
// whether they meet, by naive code (any triangle that meets it, or a point inside) and exactly.

#include <isect/mesh_convex.h>
#include <isect/mesh_mesh.h>
#include <isect/methods/point_cone.h>
#include <isect/methods/point_cylinder.h>

#include "bench/cylinder_half_spaces/oracle.h"
#include "bench/half_spaces/bodies.h"
#include "bench/naive_triangles.h"
#include "bench/pair_suite.h"
#include "bench/separating_axes.h"

namespace isect::bench::meshes_suite {
namespace {

using P = Point<double, 3>;
using Ball = Sphere<double, 3>;
using Rod = Capsule<double, 3>;
using Three = Triangle<double, 3>;
using Mesh = TriangleMesh<double>;
using oracle::Rational, oracle::rational;

/// Whether meet(triangle) holds of some triangle.
template <class Meet>
bool any_triangle(const Mesh& mesh, const Meet& meet) {
  for (int i = 0; i < static_cast<int>(mesh.triangles.size()); ++i)
    if (meet(triangle(mesh, i))) return true;
  return false;
}

/// A box by its corners, and its three directions.
struct Corners {
  std::vector<P> corners;
  std::vector<Vector<double, 3>> normals, edges;
};
Corners convex(const P& center, const Eigen::Matrix3d& axes, const Vector<double, 3>& half) {
  Corners made;
  for (int k = 0; k < 8; ++k)
    made.corners.push_back(center +
                           axes * half.cwiseProduct(Vector<double, 3>(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1)));
  for (int i = 0; i < 3; ++i) made.normals.push_back(axes.col(i));
  made.edges = made.normals;
  return made;
}
Corners convex(const Aabb<double, 3>& b) {
  return convex((b.lo + b.hi) / 2, Eigen::Matrix3d::Identity(), (b.hi - b.lo) / 2);
}
Corners convex(const Obb<double, 3>& b) { return convex(b.center, b.axes, b.half); }
Corners convex(const Hull3<double>& hull) {
  Corners made = {hull.vertices, {}, {}};
  for (const auto& [i, j, k] : hull.triangles) {
    const P &a = hull.vertices[i], &b = hull.vertices[j], &c = hull.vertices[k];
    made.normals.push_back((b - a).cross(c - a));
    for (const Vector<double, 3>& e : {Vector<double, 3>(b - a), Vector<double, 3>(c - b), Vector<double, 3>(a - c)})
      made.edges.push_back(e);
  }
  return made;
}
Corners convex(const Body& b) { return {b.corners, b.normals, b.edges}; }

/// Whether one of the two holds a corner of the other, or no axis separates some triangle from the shape.
template <class Shape>
bool by_axes(const Star& s, const Shape& shape) {
  const Corners other = convex(shape);
  return naive::inside(other.corners[0], s.mesh) ||
         any_triangle(s.mesh, [&](const Three& x) { return !separated(bench::convex(x), other); });
}

/// Whether meets(tetrahedron) holds for one of the tetrahedra that make up the solid.
template <class Meets>
bool any_part(const Star& s, const Meets& meets) {
  return std::ranges::any_of(tetrahedra_of(s), meets);
}
bool common_corner(const oracle::Sides& a, const oracle::Sides& b) {
  return !oracle::corners(oracle::both(a, b)).empty();
}

oracle::Sides sides(const Aabb<double, 3>& box) { return oracle::sides(box); }
oracle::Sides sides(const Obb<double, 3>& box) { return oracle::sides(box); }
oracle::Sides sides(const Hull3<double>& hull) { return sides_of(hull); }
oracle::Sides sides(const Body& body) { return sides_of(body); }

/// The form of a shape that the core takes.
template <class Shape>
const Shape& in_core(const Shape& x) {
  return x;
}
const HalfSpaces& in_core(const Body& x) { return x.core; }

// CGAL and FCL test whether surfaces meet: no peer answers this for solids.

template <class Shape>
void convex_solids(Session& session, const char* test) {
  const auto truly = [](const Star& s, const Shape& shape) {
    const oracle::Sides all = sides(shape);
    return any_part(s, [&](const oracle::Sides& part) { return common_corner(part, all); });
  };
  PairContest<Star, Shape>(session, test, 1 << 7)
      .only([](const Star&, const Shape& x) { return has_volume(in_core(x)); })
      .run(
          by_axes<Shape>,
          [](const Star& s, const Shape& x) { return relate(s.mesh, in_core(x)) != Relation::disjoint; }, truly);
}

bool naively_in(const P& p, const Cylinder<double>& c) { return point_cylinder::projected(p, c); }
bool naively_in(const P& p, const Cone<double>& c) { return point_cone::by_height(p, c); }

/// Decides by points: a corner of the mesh in the other, the axis through a triangle, an end of it in the solid.
template <class Solid>
void round_solids(Session& session, const char* test) {
  const auto naively = [](const Star& s, const Solid& x) {
    const auto& [p, q, radius] = x;
    const Vector<double, 3> along = q - p;
    return std::ranges::any_of(s.mesh.vertices, [&](const P& v) { return naively_in(v, x); }) ||
           any_triangle(s.mesh, [&](const Three& t) { return naive::crosses(p, along, 1, t); }) ||
           naive::inside(p, s.mesh);
  };
  const auto truly = [](const Star& s, const Solid& x) {
    return any_part(s, [&](const oracle::Sides& part) { return oracle::relation(x, part) != Relation::disjoint; });
  };
  PairContest<Star, Solid>(session, test, 1 << 6)
      .only([](const Star&, const Solid& x) { return has_volume(x); })
      .run(
          naively, [](const Star& s, const Solid& x) { return relate(s.mesh, x) != Relation::disjoint; }, truly);
}

void balls(Session& session) {
  const auto naively = [](const Star& s, const Ball& b) {
    return naive::inside(b.center, s.mesh) || any_triangle(s.mesh, [&](const Three& x) { return naive::meet(b, x); });
  };
  const auto truly = [](const Star& s, const Ball& b) {
    const Rational r = b.radius;
    return any_part(
        s, [&](const oracle::Sides& part) { return oracle::distance2(rational(b.center), part) <= Rational(r * r); });
  };
  PairContest<Star, Ball>(session, "mesh-sphere", 1 << 7)
      .run(
          naively, [](const Star& s, const Ball& b) { return relate(s.mesh, b) != Relation::disjoint; }, truly);
}

void capsules(Session& session) {
  const auto naively = [](const Star& s, const Rod& c) {
    return naive::inside(c.p, s.mesh) || any_triangle(s.mesh, [&](const Three& x) { return naive::meet(c, x); });
  };
  const auto truly = [](const Star& s, const Rod& c) {
    const Rational r = c.radius;
    return any_part(
        s, [&](const oracle::Sides& part) { return oracle::distance2(oracle::stretch(c), part) <= Rational(r * r); });
  };
  PairContest<Star, Rod>(session, "mesh-capsule", 1 << 6)
      .only([](const Star&, const Rod& c) { return has_volume(c); })
      .run(
          naively, [](const Star& s, const Rod& c) { return relate(s.mesh, c) != Relation::disjoint; }, truly);
}

void meshes(Session& session) {
  const auto naively = [](const Star& a, const Star& b) {
    if (naive::inside(a.mesh.vertices[0], b.mesh) || naive::inside(b.mesh.vertices[0], a.mesh)) return true;
    return any_triangle(a.mesh, [&](const Three& x) {
      return any_triangle(b.mesh, [&](const Three& y) { return !separated(bench::convex(x), bench::convex(y)); });
    });
  };
  const auto truly = [](const Star& a, const Star& b) {
    const std::vector<oracle::Sides> parts = tetrahedra_of(b);
    return any_part(a, [&](const oracle::Sides& x) {
      return std::ranges::any_of(parts, [&](const oracle::Sides& y) { return common_corner(x, y); });
    });
  };
  PairContest<Star, Star>(session, "mesh-mesh", 1 << 6)
      .run(
          naively, [](const Star& a, const Star& b) { return relate(a.mesh, b.mesh) != Relation::disjoint; }, truly);
}

}  // namespace

void measure(Session& session) {
  balls(session);
  capsules(session);
  convex_solids<Aabb<double, 3>>(session, "mesh-aabb");
  convex_solids<Obb<double, 3>>(session, "mesh-obb");
  convex_solids<Hull3<double>>(session, "mesh-hull");
  convex_solids<Body>(session, "mesh-half-spaces");
  round_solids<Cylinder<double>>(session, "mesh-cylinder");
  round_solids<Cone<double>>(session, "mesh-cone");
  meshes(session);
}

}  // namespace isect::bench::meshes_suite
