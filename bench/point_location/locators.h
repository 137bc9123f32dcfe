#pragma once
// Point location in a prepared polygon by GEOS and CGAL.

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_hierarchy_2.h>
#include <geos/algorithm/locate/IndexedPointInAreaLocator.h>
#include <geos/geom/CoordinateArraySequence.h>
#include <geos/geom/GeometryFactory.h>
#include <geos/geom/LinearRing.h>
#include <geos/geom/Polygon.h>

#include <deque>
#include <memory>

#include <isect/shapes.h>

namespace isect::bench::peers {

struct Geos {
  std::unique_ptr<geos::geom::Polygon> polygon;
  std::unique_ptr<geos::algorithm::locate::IndexedPointInAreaLocator> locator;
};
/// It builds its index at the first query.
inline Geos make_geos(const Ring<double, 2>& ring) {
  const auto* factory = geos::geom::GeometryFactory::getDefaultInstance();
  std::vector<geos::geom::Coordinate> coordinates;
  for (const Point<double, 2>& v : ring) coordinates.emplace_back(v[0], v[1]);
  coordinates.push_back(coordinates[0]);
  auto sequence = std::make_unique<geos::geom::CoordinateArraySequence>(std::move(coordinates));
  Geos geos;
  geos.polygon = factory->createPolygon(factory->createLinearRing(std::move(sequence)));
  geos.locator = std::make_unique<geos::algorithm::locate::IndexedPointInAreaLocator>(*geos.polygon);
  const geos::geom::Coordinate first(ring[0][0], ring[0][1]);
  geos.locator->locate(&first);
  return geos;
}
inline bool geos_covers(const Geos& geos, const Point<double, 2>& p) {
  const geos::geom::Coordinate c(p[0], p[1]);
  return geos.locator->locate(&c) != geos::geom::Location::EXTERIOR;
}

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertices = CGAL::Triangulation_hierarchy_vertex_base_2<CGAL::Triangulation_vertex_base_2<Kernel>>;
using Faces =
    CGAL::Constrained_triangulation_face_base_2<Kernel, CGAL::Triangulation_face_base_with_info_2<int, Kernel>>;
using Triangulation = CGAL::Triangulation_hierarchy_2<CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<Vertices, Faces>, CGAL::No_constraint_intersection_tag>>;

/// A triangulation whose faces know how many edges part them from the outside.
inline std::unique_ptr<Triangulation> make_cgal(const Ring<double, 2>& ring) {
  auto t = std::make_unique<Triangulation>();
  std::vector<Kernel::Point_2> points;
  for (const Point<double, 2>& v : ring) points.emplace_back(v[0], v[1]);
  t->insert(points.begin(), points.end());             // in an order of its own, along a curve
  std::vector<Triangulation::Vertex_handle> vertices;  // by the hierarchy; from points a constraint would walk to them
  for (const Kernel::Point_2& p : points) vertices.push_back(t->insert(p));
  for (std::size_t i = 0; i < vertices.size(); ++i)
    t->insert_constraint(vertices[i], vertices[i + 1 < vertices.size() ? i + 1 : 0]);

  for (auto f = t->all_faces_begin(); f != t->all_faces_end(); ++f) f->info() = -1;
  std::deque<Triangulation::Face_handle> next = {t->infinite_face()};
  next.front()->info() = 0;
  while (!next.empty()) {
    const auto face = next.front();
    next.pop_front();
    for (int i = 0; i < 3; ++i) {
      const auto other = face->neighbor(i);
      if (other->info() >= 0) continue;
      const bool parted = face->is_constrained(i);
      other->info() = face->info() + parted;
      if (parted)
        next.push_back(other);
      else
        next.push_front(other);
    }
  }
  return t;
}
inline bool cgal_covers(const std::unique_ptr<Triangulation>& t, const Point<double, 2>& p) {
  Triangulation::Locate_type where;
  int index = 0;
  const auto face = t->locate(Kernel::Point_2(p[0], p[1]), where, index);
  if (where == Triangulation::VERTEX) return true;
  if (where == Triangulation::EDGE && face->is_constrained(index)) return true;
  return face != nullptr && !t->is_infinite(face) && face->info() % 2 != 0;
}

}  // namespace isect::bench::peers
