#include "lessons/concave_polygon/picture.h"

#include <fmt/format.h>

namespace isect::lessons::concave_polygon_lesson {

using namespace viz;

Ring<double, 2> spiky_polygon(int spikes) {
  const double apart = 3.75 / spikes, drop = 0.75 / spikes;
  Ring<double, 2> ring = {{-3, -1.875}, {0.90625, -1.75}};
  for (int i = 0; i < spikes; ++i) {
    ring.push_back({0.75 - apart * i, 1.75 - drop * i});
    if (i + 1 < spikes) ring.push_back({0.75 - apart * (i + 0.5), -1.5 + drop * i});
  }
  return ring;
}

Setup::Setup(const std::string& polygon, const Vec3& at)
    : spiky(polygon == "spiky"),
      ring(spiky ? spiky_polygon(4)
                 : Ring<double, 2>{{-3, -1},
                                   {-1.5, -1.75},
                                   {-0.875, -0.25},
                                   {0.25, -1.25},
                                   {0.875, 0.5},
                                   {-0.25, 0.25},
                                   {-0.5, 1.75},
                                   {-1.75, 0.75},
                                   {-2.5, 1.375}}),
      p(at.x(), at.y()),
      truth(locate(p, ring)) {}

Region polygon(const Setup& s, bool outlined) {
  Region region;
  region.rings = {flat(s.ring)};
  region.outlined = outlined;
  region.corners = outlined;
  return region;
}

Region filled(const std::vector<Vec3>& ring, Role role) {
  Region region;
  region.rings = {ring};
  region.role = role, region.outlined = false;
  return region;
}

void add_cell(Scene& scene, double x, double y, double size, Role role, bool thick) {
  const double h = size / 2;
  const std::vector<Vec3> ring = {{x - h, y - h, 0}, {x + h, y - h, 0}, {x + h, y + h, 0}, {x - h, y + h, 0}};
  scene.items.emplace_back(filled(ring, role));
  scene.items.emplace_back(
      Chain{ring, true, role == Role::highlight ? Role::text : role, thick ? Pen::thick : Pen::solid});
}

viz::Heading table_heading(const std::string& text) {
  return {{frame.table + frame.table_width / 2, frame.high, 0}, text, Role::text, frame.table_width};
}

void add_point(Scene& scene, const Setup& s, bool on) {
  scene.items.emplace_back(on ? Dot{flat(s.p), Mark::diamond, Role::highlight}
                              : Dot{flat(s.p), Mark::disc, Role::first});
  scene.items.emplace_back(Label{flat(s.p), "**p**", Role::first});
  scene.handles.push_back({"p", Handle::Kind::point, flat(s.p), Vec3::Zero(), Role::first});
}

std::string alt_text(const Setup& s, const std::string& prepared) {
  return fmt::format("A concave polygon of {} vertices, {}, and a point that lies {}.", s.size(), prepared,
                     lies(s.truth));
}

}  // namespace isect::lessons::concave_polygon_lesson
