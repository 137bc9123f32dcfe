#include "app/scene/files/mesh_builder.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include <isect/orient.h>
#include <isect/polygon_triangles.h>

#include "app/scene/files/reading.h"
#include "app/scene/objects.h"
#include "viz/lang/message.h"

namespace isect::program::scene {

namespace {

using FaceOutline = Ring<double, 3>;

Point<double, 2> seen_along(int axis, const viz::Vec3& p) { return {p[(axis + 1) % 3], p[(axis + 2) % 3]}; }

bool on_one_line(const viz::Vec3& a, const viz::Vec3& b, const viz::Vec3& c) {
  for (int axis = 0; axis < 3; ++axis)
    if (orient2d(seen_along(axis, a), seen_along(axis, b), seen_along(axis, c)) != 0) return false;
  return true;
}

/// Returns the first three corners that are not collinear; none if all are.
std::optional<std::array<viz::Vec3, 3>> corners_of_plane(const FaceOutline& o) {
  const auto second = std::ranges::find_if(o, [&](const viz::Vec3& p) { return p != o.front(); });
  if (second == o.end()) return {};
  const auto third =
      std::find_if(second, o.end(), [&](const viz::Vec3& p) { return !on_one_line(o.front(), *second, p); });
  if (third == o.end()) return {};
  return std::array{o.front(), *second, *third};
}

/// Returns how far the corners lie off one plane: 0 if and only if they are exactly coplanar.
double off_one_plane(const FaceOutline& o, const std::array<viz::Vec3, 3>& plane) {
  const auto in_it = [&](const viz::Vec3& p) { return orient3d(plane[0], plane[1], plane[2], p) == 0; };
  if (std::ranges::all_of(o, in_it)) return 0;
  viz::Vec3 normal = viz::Vec3::Zero();  // Newell's
  for (std::size_t i = 1; i + 1 < o.size(); ++i) normal += (o[i] - o[0]).cross(o[i + 1] - o[0]);
  double off = 0;
  for (const viz::Vec3& p : o) off = std::max(off, std::abs(normal.dot(p - o[0])) / normal.norm());
  return off > 0 && std::isfinite(off) ? off : off_plane(o);  // this is slow
}

/// Whether a face of four corners, seen along the axis of its normal's largest component, turns to one side only.
bool is_convex(const FaceOutline& o) {
  if (o.size() != 4) return false;
  const viz::Vec3 normal = (o[2] - o[0]).cross(o[3] - o[1]).cwiseAbs();
  const int axis = normal.x() >= normal.y() && normal.x() >= normal.z() ? 0 : normal.y() >= normal.z() ? 1 : 2;
  std::array<Point<double, 2>, 4> seen;
  std::ranges::transform(o, seen.begin(), [axis](const viz::Vec3& p) { return seen_along(axis, p); });
  int turns = 0;
  for (std::size_t i = 0; i < 4; ++i) turns += orient2d(seen[i], seen[(i + 1) % 4], seen[(i + 2) % 4]);
  return std::abs(turns) == 4;
}

std::vector<std::array<int, 3>> fan(std::size_t corners) {
  std::vector<std::array<int, 3>> triangles;
  for (int i = 2; i < static_cast<int>(corners); ++i) triangles.push_back({0, i - 1, i});
  return triangles;
}

}  // namespace

void MeshBuilder::refuse(int place, const std::string& why) const {
  scene::refuse(file_, fmt::format("{} {}: {}", places_.of_face, place, why));
}

void MeshBuilder::add(const viz::Vec3& point, int place) {
  if (mesh_.points.size() == most_in_file) refuse(place, fmt::format("more than {} points", most_in_file));
  mesh_.points.push_back(point);
}

void MeshBuilder::begin_face(int place) {
  if (faces_.size() == most_in_file) refuse(place, fmt::format("more than {} faces", most_in_file));
  faces_.push_back({place, corners_.size()});
}

void MeshBuilder::corner(long point) {
  const Face& face = faces_.back();
  if (point < 0)
    refuse(face.place,
           fmt::format("vertex {}; they are counted from {}", point + places_.first_point, places_.first_point));
  if (point >= static_cast<long>(most_in_file))
    refuse(face.place, fmt::format("vertex {}; a file has {} at most", point + places_.first_point, most_in_file));
  if (corners_.size() - face.begin == most_corners)
    refuse(face.place, fmt::format("a face of more than {} vertices", most_corners));
  corners_.push_back(static_cast<int>(point));
}

void MeshBuilder::leave_out(int place) { left_out_.see(place); }

void MeshBuilder::keep(int a, int b, int c, int place) {
  if (mesh_.triangles.size() == most_in_file) refuse(place, fmt::format("more than {} triangles", most_in_file));
  mesh_.triangles.push_back({a, b, c});
}

ShapeFile MeshBuilder::made() {
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    const Face& face = faces_[i];
    const std::size_t count = (i + 1 < faces_.size() ? faces_[i + 1].begin : corners_.size()) - face.begin;
    const int* const corners = corners_.data() + face.begin;
    for (std::size_t k = 0; k < count; ++k)
      if (corners[k] >= static_cast<int>(mesh_.points.size()))
        refuse(face.place,
               fmt::format("vertex {}, and there are {}", corners[k] + places_.first_point, mesh_.points.size()));
    if (count < 3) refuse(face.place, "a face has three vertices at least");
    cut(face, corners, count);
    if (faces_.size() == 1) mesh_.only_face.assign(corners, corners + count);
  }
  add_notes();
  return std::move(mesh_);
}

void MeshBuilder::cut(const Face& face, const int* corners, std::size_t count) {
  if (count == 3) return keep(corners[0], corners[1], corners[2], face.place);
  FaceOutline outline;
  for (std::size_t i = 0; i < count; ++i) outline.push_back(mesh_.points[static_cast<std::size_t>(corners[i])]);
  const auto plane = corners_of_plane(outline);
  const double off = plane ? off_one_plane(outline, *plane) : 0;
  auto triangles = !plane || is_convex(outline) ? fan(count) : ears(outline);
  if (triangles.empty() && count == 4 && off > 0) triangles = fan(count);  // its edges are skew from any side
  if (triangles.empty()) refuse(face.place, "a face that crosses itself, as seen along its normal");
  for (const auto& [a, b, c] : triangles) keep(corners[a], corners[b], corners[c], face.place);
  if (off == 0) return;
  bent_.see(face.place);
  farthest_off_ = std::max(farthest_off_, off);
}

/// Returns "line 3".
static std::string place_in_words(const std::string& unit, int number) {
  const std::string n = std::to_string(number);
  if (unit == "facet") return viz::tr("facet {n}", {{"n", n}});
  if (unit == "face") return viz::tr("face {n}", {{"n", n}});
  return viz::tr("line {n}", {{"n", n}});
}

void MeshBuilder::add_notes() {
  if (bent_.count > 0)
    mesh_.note_of_faces = viz::tr_count(
        static_cast<std::size_t>(bent_.count),
        "The corners of a face (the first: {place}) lie up to {off} off one plane: it is read as the "
        "triangles that it is cut into.",
        "The corners of {n} faces (the first: {place}) lie up to {off} off one plane: they are read as "
        "the triangles that they are cut into.",
        {{"place", place_in_words(places_.of_face, bent_.first)}, {"off", fmt::format("{:.2g}", farthest_off_)}});
  if (left_out_.count > 0)
    mesh_.note = viz::tr_count(static_cast<std::size_t>(left_out_.count),
                               "A point or a line has no area, and is left out (the first: {place}).",
                               "{n} points and lines have no area, and are left out (the first: {place}).",
                               {{"place", place_in_words(places_.of_face, left_out_.first)}});
}

}  // namespace isect::program::scene
