// How the objects of a scene are drawn.

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

#include <isect/point_polygon.h>
#include "app/scene/shapes.h"
#include "app/scene/types/rows.h"
#include "lessons/shared/parameters.h"

namespace isect::program::scene {

namespace {

using lessons::unit;
using viz::Role;
using viz::Vec3;

/// Returns the place where an outline in the plane is widest, by the even-odd rule: beside its notches and holes.
Vec3 inside_of(const std::vector<std::vector<Vec3>>& rings) {
  const auto lower = [](const Vec3& a, const Vec3& b) { return a.y() < b.y(); };
  const auto [low, high] = std::minmax_element(rings.front().begin(), rings.front().end(), lower);
  Vec3 best = middle_of(rings.front());
  double widest = 0;
  for (const double share : {0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8, 0.1, 0.9}) {
    const double y = low->y() + share * (high->y() - low->y());
    std::vector<double> crossed;
    for (const std::vector<Vec3>& ring : rings)
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec3 &p = ring[i], &q = ring[i + 1 < ring.size() ? i + 1 : 0];
        if ((p.y() > y) != (q.y() > y)) crossed.push_back(p.x() + (y - p.y()) / (q.y() - p.y()) * (q.x() - p.x()));
      }
    std::ranges::sort(crossed);
    for (std::size_t i = 0; i + 1 < crossed.size(); i += 2)
      if (crossed[i + 1] - crossed[i] > 1.05 * widest)
        widest = crossed[i + 1] - crossed[i], best = Vec3((crossed[i] + crossed[i + 1]) / 2, y, 0);
  }
  return best;
}

/// Returns the outline's middle, unless that lies in a notch or a hole.
Vec3 place_of_name(const std::vector<std::vector<Vec3>>& rings) {
  const Vec3 middle = middle_of(rings.front());
  Polygon<double, 2> polygon;
  for (const std::vector<Vec3>& ring : rings) polygon.rings.push_back(points_of<2>(ring));
  return locate(point_of<2>(middle), polygon) == Location::in ? middle : inside_of(rings);
}

}  // namespace

// Shared by the rows of the list of types.

std::vector<Vec3> around(const Vec3& center, double radius) {
  return {center - Vec3::Constant(radius), center + Vec3::Constant(radius)};
}

Vec3 across(const Vec3& v, bool flat) {
  if (flat) return unit({-v.y(), v.x(), 0});
  int least = 0;
  v.cwiseAbs().minCoeff(&least);
  return unit(v.cross(Vec3::Unit(least)));
}

Vec3 middle_of(const std::vector<Vec3>& points) {
  Vec3 middle = Vec3::Zero();
  for (const Vec3& p : points) middle += p / static_cast<double>(points.size());
  return middle;
}

Vec3 top_of(const std::vector<Vec3>& points) {
  return *std::ranges::max_element(points, {}, [](const Vec3& p) { return p.y(); });
}

void Drawing::name(const Vec3& where) { items.push_back(viz::Label{where, shown_name(o.name), role}); }
void Drawing::name(const Vec3& where, const Vec3& other) {
  items.push_back(viz::Label{where, shown_name(o.name), role, other});
}
void Drawing::dot(const Vec3& where) { items.push_back(viz::Dot{where, viz::Mark::disc, role}); }
void Drawing::named_dot(const Vec3& where) {
  dot(where);
  name(where);
}
void Drawing::dots(const std::vector<Vec3>& points) {
  for (const Vec3& p : points) dot(p);
}

void Drawing::region(const std::vector<Vec3>& corners) {
  viz::Region region;
  region.rings = {corners}, region.role = role;
  items.push_back(region);
}

void Drawing::outline(const std::vector<std::vector<Vec3>>& rings) {
  viz::Region region;
  region.rings = rings, region.role = role, region.hides = !s.flat;
  items.push_back(region);
  name(s.flat ? place_of_name(rings) : middle_of(rings.front()));
}

void Drawing::solid(viz::Solid shape) {
  shape.role = role;
  name(middle_of(shape.vertices));
  items.push_back(std::move(shape));
}

std::vector<viz::Item> drawn(const NamedValues& s, const Object& o, const Room& room, Role role) {
  Drawing drawing = {s, o, room, role};
  spec(o.type).draw(drawing);
  for (viz::Item& item : drawing.items)
    std::visit(
        [&](auto& part) {
          if constexpr (requires { part.name; }) part.name = shown_name(o.name);
        },
        item);
  return std::move(drawing.items);
}

}  // namespace isect::program::scene
