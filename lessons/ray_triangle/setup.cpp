#include "lessons/ray_triangle/setup.h"

#include <isect/ray_polygon.h>
#include "lessons/shared/microscope.h"

namespace isect::lessons::ray_triangle_lesson {

using namespace viz;

namespace {

/// The exact tests of the triangle and of its plane, and the signs that they report.
void judge(Setup& s) {
  Record<ray_triangle::Event<double>> edges;
  s.truth = intersect(s.ray, s.triangle, edges);
  for (const auto& event : edges.events)
    if (const auto* e = std::get_if<ray_triangle::Volumes>(&event)) s.side = {e->a, e->b, e->c};

  const auto& [a, b, c] = s.triangle.vertices;
  Record<ray_polygon::Event<double>> plane;
  const RayPolygon<double> crossing = intersect(s.ray, Ring<double, 3>{a, b, c}, FillRule::even_odd, plane);
  for (const auto& event : plane.events)
    if (const auto* e = std::get_if<ray_polygon::Decision>(&event)) s.heading = e->heading;
  s.flat = crossing.flat, s.line = crossing.line;
}

}  // namespace

Place Setup::place() const {
  if (heading == 0) return Place::none;
  int negative = 0, zero = 0, below = 0, above = 0;  // below, above: the last vertex with such a weight
  for (int i = 0; i < 3; ++i) {
    if (weight(i) == 0) ++zero;
    if (weight(i) < 0) ++negative, below = i;
    if (weight(i) > 0) above = i;
  }
  if (negative == 0) return zero == 0 ? Place::inside : zero == 1 ? Place::edge : Place::vertex;
  const Place first = negative == 1 ? Place::beyond_bc : Place::beyond_a;
  return static_cast<Place>(static_cast<int>(first) + (negative == 1 ? below : above));
}

Setup setup(const Parameters& p) {
  const auto at = [&](const char* name) -> const Vec3& { return std::get<Vec3>(p.at(name)); };
  Setup s;
  s.method = std::get<std::string>(p.at("method"));
  s.given = at("d");
  s.ray = {at("o"), s.given};
  if (std::get<std::string>(p.at("extent")) == "segment") s.ray.range.hi = std::get<double>(p.at("t_max"));
  s.triangle = {{at("a"), at("b"), at("c")}};
  s.neighbour = {{at("c"), at("b"), at("q")}};
  s.selected = microscope::selected_of(p);
  if (s.seam())
    for (int i = 0; i < 2; ++i) s.ray.direction[i] = microscope::neighbour<double>(s.given[i], s.selected[i]);
  judge(s);
  return s;
}

}  // namespace isect::lessons::ray_triangle_lesson
