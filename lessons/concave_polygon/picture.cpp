#include "lessons/concave_polygon/picture.h"

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <algorithm>

#include <isect/orient.h>
#include <isect/polygon.h>
#include <isect/polygon_triangles.h>
#include "lessons/shared/parameters.h"
#include "lessons/shared/vertices.h"

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

namespace {

const Ring<double, 2>& given(bool spiky) {
  static const Ring<double, 2> spikes = spiky_polygon(4);
  static const Ring<double, 2> notches = {{-3, -1},      {-1.5, -1.75}, {-0.875, -0.25}, {0.25, -1.25}, {0.875, 0.5},
                                          {-0.25, 0.25}, {-0.5, 1.75},  {-1.75, 0.75},   {-2.5, 1.375}};
  return spiky ? spikes : notches;
}

bool is_spiky(const Parameters& values) { return std::get<std::string>(values.at("polygon")) == "spiky"; }

bool is_sorted(const Parameters& values) {
  const auto order = values.find("order");
  return order != values.end() && std::get<std::string>(order->second) == "sorted";
}

Ring<double, 2> ring_of(const Parameters& values) {
  Ring<double, 2> ring = given(is_spiky(values));
  move_vertices(values, "v", ring);
  return ring;
}

bool turns_right(const Ring<double, 2>& ring) {
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i)
    if (orient2d(ring[i], ring[(i + 1) % n], ring[(i + 2) % n]) < 0) return true;
  return false;
}

/// A frame of the lesson's own proportions, centred at this polygon, with room for 1.15 times its size.
Frame frame_of(const Ring<double, 2>& ring) {
  constexpr Frame usual;
  Eigen::AlignedBox2d box;
  for (const Point<double, 2>& v : ring) box.extend(v);
  const double width = usual.right - usual.left, height = usual.high - usual.low;
  Frame frame;
  frame.unit = 1.15 * std::max(box.sizes().x() / width, box.sizes().y() / height);
  const Point<double, 2> middle = box.center();
  frame.left = middle.x() - frame.unit * width / 2, frame.right = middle.x() + frame.unit * width / 2;
  frame.low = middle.y() - frame.unit * height / 2, frame.high = middle.y() + frame.unit * height / 2;
  return frame;
}

}  // namespace

int most_corners() { return static_cast<int>(std::max(given(false).size(), given(true).size())); }

bool can_be_prepared(const Parameters& values) {
  const Ring<double, 2> ring = ring_of(values);
  const bool framed = std::ranges::all_of(ring, [frame = Frame()](const Point<double, 2>& v) {
    return v.x() > frame.left && v.x() < frame.right && v.y() > frame.low && v.y() < frame.high;
  });
  return framed && is_simple(ring) && area(ring) > 0;
}

Setup::Setup(const Parameters& values)
    : spiky(is_spiky(values)),
      sorted(is_sorted(values)),
      ring(ring_of(values)),
      p(flat_point(values, "p")),
      truth(locate(p, ring)) {}

Setup::Setup(const Ring<double, 2>& of, const Point<double, 2>& at)
    : frame(frame_of(of)), spiky(false), ring(of), p(at), truth(locate(p, ring)) {}

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

viz::Heading table_heading(const Frame& frame, const std::string& text) {
  return {{frame.table(table_width / 2), frame.high, 0}, text, Role::text, frame.unit * table_width};
}

void add_point(Scene& scene, const Setup& s, bool on) {
  scene.items.emplace_back(on ? Dot{flat(s.p), Mark::diamond, Role::highlight}
                              : Dot{flat(s.p), Mark::disc, Role::first});
  scene.items.emplace_back(Label{flat(s.p), "**p**", Role::first});
  scene.handles.push_back({"p", Handle::Kind::point, flat(s.p), Vec3::Zero(), Role::first});
  add_handles(scene, "v", s.ring, Role::second, "a corner");
}

std::string alt_text(const Setup& s, const std::string& prepared) {
  return fmt::format("A {} polygon of {} vertices, {}, and a point that lies {}.",
                     turns_right(s.ring) ? "concave" : "convex", s.size(), prepared, lies(s.truth));
}

}  // namespace isect::lessons::concave_polygon_lesson
