#pragma once
// The same questions asked of installed libraries: rows of peer_speed, each beside the core's. Their answers are counted
// as hits, for comparison; CGAL's exact kernel is a second opinion on every one of ours.

#include <CGAL/Bbox_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/convex_hull_2.h>
#include <CGAL/intersections.h>

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <iterator>

#include "bench/measure.h"
#include "core/shapes.h"
#ifdef ISECT_HAS_BULLET
#include <BulletCollision/Gimpact/btBoxCollision.h>
#include <LinearMath/btAabbUtil2.h>
#endif
#ifdef ISECT_HAS_FCL
#include <fcl/math/bv/AABB.h>
#include <fcl/math/bv/OBB.h>
#endif

namespace isect::bench::peers {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

template <class S>
Kernel::Point_3 cgal(const Point<S, 3>& p) {
  return {p[0], p[1], p[2]};
}
template <class S>
Kernel::Sphere_3 cgal(const Sphere<S, 3>& s) {
  return {cgal(s.center), static_cast<double>(s.radius) * static_cast<double>(s.radius)};
}
inline Kernel::Point_2 cgal(const Point<double, 2>& p) { return {p[0], p[1]}; }

template <class Peer>
struct Two {
  Peer a, b;
};

/// The pairs in a peer's own types.
template <class Peer, class Cases, class Convert>
std::vector<Two<Peer>> converted(const Cases& cases, const Convert& convert) {
  std::vector<Two<Peer>> all;
  all.reserve(cases.size());
  for (const auto& c : cases) all.push_back({convert(c.a), convert(c.b)});
  return all;
}

#ifdef ISECT_HAS_BULLET
template <class V>
btVector3 bullet(const V& v) {
  return {static_cast<btScalar>(v[0]), static_cast<btScalar>(v[1]), static_cast<btScalar>(v[2])};
}
struct BulletBox {
  btVector3 lo, hi;
};
/// Bullet asks whether a box and one in another frame overlap.
struct BulletObb {
  btAABB box;
  btTransform frame;
};
#endif

template <class Cases>
void aabb_aabb(Table& table, const Cases& cases, int passes) {
  using Box = std::decay_t<decltype(cases[0].a)>;
  const auto bboxes = converted<CGAL::Bbox_3>(
      cases, [](const Box& b) { return CGAL::Bbox_3(b.lo[0], b.lo[1], b.lo[2], b.hi[0], b.hi[1], b.hi[2]); });
  table.row("CGAL Bbox_3", timed(bboxes, passes, [](const auto& c) { return CGAL::do_overlap(c.a, c.b); }));
#ifdef ISECT_HAS_BULLET
  const auto bullets = converted<BulletBox>(cases, [](const Box& b) {
    return BulletBox{bullet(b.lo), bullet(b.hi)};
  });
  table.row("Bullet (float)", timed(bullets, passes, [](const auto& c) {
              return TestAabbAgainstAabb2(c.a.lo, c.a.hi, c.b.lo, c.b.hi);
            }));
#endif
#ifdef ISECT_HAS_FCL
  const auto fcls = converted<fcl::AABB<double>>(cases, [](const Box& b) {
    return fcl::AABB<double>(b.lo.template cast<double>(), b.hi.template cast<double>());
  });
  table.row("FCL", timed(fcls, passes, [](const auto& c) { return c.a.overlap(c.b); }));
#endif
}

template <class Cases>
void sphere_sphere(Table& table, const Cases& cases, int passes) {
  using Ball = std::decay_t<decltype(cases[0].a)>;
  const auto balls = converted<Kernel::Sphere_3>(cases, [](const Ball& s) { return cgal(s); });
  table.row("CGAL (surfaces)",
            timed(balls, passes, [](const auto& c) { return CGAL::do_intersect(c.a, c.b); }));
}

template <class Cases>
void sphere_aabb(Table& table, const Cases& cases, int passes) {
  struct Cgal {
    Kernel::Sphere_3 ball;
    Kernel::Iso_cuboid_3 box;
  };
  struct Eigen3 {
    Eigen::AlignedBox<double, 3> box;
    Point<double, 3> center;
    double radius;
  };
  std::vector<Cgal> cgals;
  std::vector<Eigen3> eigens;
  for (const auto& c : cases) {
    cgals.push_back({cgal(c.a), {cgal(c.b.lo), cgal(c.b.hi)}});
    eigens.push_back({{c.b.lo.template cast<double>(), c.b.hi.template cast<double>()},
                      c.a.center.template cast<double>(),
                      static_cast<double>(c.a.radius)});
  }
  table.row("CGAL (surface)",
            timed(cgals, passes, [](const auto& c) { return CGAL::do_intersect(c.ball, c.box); }));
  table.row("Eigen AlignedBox distance", timed(eigens, passes, [](const auto& c) {
              return c.box.squaredExteriorDistance(c.center) <= c.radius * c.radius;
            }));
}

template <class Cases>
void obb_obb(Table& table, const Cases& cases, int passes) {
  using Box = std::decay_t<decltype(cases[0].a)>;
  (void)table, (void)cases, (void)passes;
#ifdef ISECT_HAS_BULLET
  const auto bullets = converted<BulletObb>(cases, [](const Box& b) {
    const btMatrix3x3 turn(b.axes(0, 0), b.axes(0, 1), b.axes(0, 2), b.axes(1, 0), b.axes(1, 1), b.axes(1, 2),
                           b.axes(2, 0), b.axes(2, 1), b.axes(2, 2));
    btAABB box;
    box.m_max = bullet(b.half), box.m_min = -box.m_max;
    return BulletObb{box, btTransform(turn, bullet(b.center))};
  });
  table.row("Bullet gimpact (float)", timed(bullets, passes, [](const auto& c) {
              BT_BOX_BOX_TRANSFORM_CACHE cache;
              cache.calc_from_homogenic(c.a.frame, c.b.frame);
              return c.a.box.overlapping_trans_cache(c.b.box, cache, true);
            }));
#endif
#ifdef ISECT_HAS_FCL
  const auto fcls = converted<fcl::OBB<double>>(cases, [](const Box& b) {
    return fcl::OBB<double>(b.axes.template cast<double>(), b.center.template cast<double>(),
                            b.half.template cast<double>());
  });
  table.row("FCL", timed(fcls, passes, [](const auto& c) { return c.a.overlap(c.b); }));
#endif
}

template <class Cases>
void orientation(Table& table, const Cases& cases, int passes) {
  struct Three {
    Kernel::Point_2 a, b, c;
  };
  std::vector<Three> all;
  for (const auto& t : cases) all.push_back({cgal(t.a), cgal(t.b), cgal(t.c)});
  table.row("CGAL", timed(all, passes, [](const Three& t) {
              return CGAL::orientation(t.a, t.b, t.c) == CGAL::LEFT_TURN;
            }));
}

inline void polygon(Table& table, const Ring<double, 2>& ring, const Ring<double, 2>& points, int passes) {
  namespace bg = boost::geometry;
  using BoostPoint = bg::model::d2::point_xy<double>;
  bg::model::polygon<BoostPoint, false> polygon;
  for (const Point<double, 2>& v : ring) polygon.outer().emplace_back(v[0], v[1]);
  polygon.outer().emplace_back(ring[0][0], ring[0][1]);
  const bg::strategy::within::crossings_multiply<BoostPoint> crossings;
  table.row("Boost crossings_multiply", timed(points, passes, [&](const auto& p) {
              return bg::within(BoostPoint(p[0], p[1]), polygon, crossings);
            }));
  table.row("Boost winding", timed(points, passes, [&](const auto& p) {
              return bg::covered_by(BoostPoint(p[0], p[1]), polygon);
            }));

  std::vector<Kernel::Point_2> vertices;
  for (const Point<double, 2>& v : ring) vertices.push_back(cgal(v));
  table.row("CGAL bounded_side_2", timed(points, passes, [&](const auto& p) {
              return CGAL::bounded_side_2(vertices.begin(), vertices.end(), cgal(p), Kernel()) !=
                     CGAL::ON_UNBOUNDED_SIDE;
            }));
}

inline void hull(Table& table, const std::vector<Ring<double, 2>>& sets) {
  std::vector<std::vector<Kernel::Point_2>> all(sets.size());
  for (std::size_t i = 0; i < sets.size(); ++i)
    for (const Point<double, 2>& p : sets[i]) all[i].push_back(cgal(p));
  table.row("CGAL convex_hull_2", timed(all, 3, [](const auto& points) {
              std::vector<Kernel::Point_2> hull;
              CGAL::convex_hull_2(points.begin(), points.end(), std::back_inserter(hull));
              return hull.size();
            }));
}

}  // namespace isect::bench::peers
