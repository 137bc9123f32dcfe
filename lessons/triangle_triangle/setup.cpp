// What the parameters say, and what is true of it: the core decides.

#include <algorithm>

#include <isect/mesh_mesh.h>
#include <isect/methods/triangle_triangle.h>
#include <isect/orient.h>
#include <isect/triangle_half_spaces.h>
#include "lessons/triangle_triangle/picture.h"

namespace isect::lessons::triangle_triangle_lesson {

using namespace viz;
using triangle_triangle::Signs;

namespace {

/// On which side of the plane each corner lies; all are 0 if there is no plane.
Signs sides(const Three& plane, const Three& x) {
  const auto& [p, q, r] = plane.vertices;
  return {-orient3d(p, q, r, x.vertices[0]), -orient3d(p, q, r, x.vertices[1]), -orient3d(p, q, r, x.vertices[2])};
}
bool on_one_side(const Signs& s) { return s[0] != 0 && s[0] == s[1] && s[0] == s[2]; }

bool has_area(const Three& x) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto seen = [&](std::size_t i) -> Point<double, 2> {
      return {x.vertices[i][(axis + 1) % 3], x.vertices[i][(axis + 2) % 3]};
    };
    if (orient2d(seen(0), seen(1), seen(2)) != 0) return true;
  }
  return false;
}

/// The same set as half-spaces. A triangle without area is the segment from its first corner to its last, in the order
/// of coordinates.
HalfSpaces as_half_spaces(const Three& x) {
  if (has_area(x)) return half_spaces_of(x);
  const auto [first, last] =
      std::minmax_element(x.vertices.begin(), x.vertices.end(), [](const Vec3& p, const Vec3& q) {
        return std::lexicographical_compare(p.begin(), p.end(), q.begin(), q.end());
      });
  return half_spaces_of(Segment<double, 3>{*first, *last});
}

bool on_both_sides(const Signs& s) { return std::ranges::find(s, 1) != s.end() && std::ranges::find(s, -1) != s.end(); }

/// How the triangles are related if neither lies on one side of the other's plane. Signs decide where both have an area
/// and lie in different planes: half-spaces tell the same, but take far longer, and a map asks thousands of times.
Relation exact_relation(const Setup& s) {
  const bool in_one_plane = std::ranges::count(s.of[0], 0) == 3;
  if (!s.area[0] || !s.area[1] || in_one_plane) return relate(s.a(), as_half_spaces(s.b()));
  Record<triangle_triangle::SignsEvent> record;
  if (!triangle_triangle::by_signs(s.a(), s.b(), record)) return Relation::disjoint;
  // A triangle that does not reach beyond the plane has no inner point in it.
  if (!on_both_sides(s.of[0]) || !on_both_sides(s.of[1])) return Relation::touching;
  const bool at_an_end = std::ranges::any_of(record.events, [](const auto& event) {
    const auto* ends = std::get_if<triangle_triangle::Ends>(&event);
    return ends && ends->sign == 0;
  });
  return at_an_end ? Relation::touching : Relation::overlapping;
}

}  // namespace

Lie Setup::lie() const {
  switch (truth) {
    case Relation::disjoint:
      return on_one_side(of[0]) || on_one_side(of[1]) ? Lie::beside : Lie::apart;
    case Relation::touching:
      return Lie::touching;
    case Relation::overlapping:
      return Lie::overlapping;
    case Relation::equal:
    case Relation::a_inside_b:
    case Relation::b_inside_a:
      break;
  }
  return Lie::contained;
}

int Setup::shared_corners() const {
  int count = 0;
  for (const Vec3& p : a().vertices)
    count += std::any_of(b().vertices.begin(), b().vertices.end(), [&](const Vec3& q) { return p == q; });
  return count;
}

bool Setup::clash() const {
  TriangleMesh<double> mesh;
  for (const Three& x : triangles) mesh.vertices.insert(mesh.vertices.end(), x.vertices.begin(), x.vertices.end());
  mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
  return crosses_itself(mesh);
}

std::optional<std::pair<Vec3, Vec3>> Setup::part(int which) const {
  const auto own = static_cast<std::size_t>(which);
  const Signs& s = of[own];
  if (!both_have_area() || on_one_side(s) || s == Signs{0, 0, 0}) return {};
  const Three &x = triangles[own], &plane = triangles[1 - own];
  const Vec3 n = triangle_triangle::detail::normal(plane);
  const auto height = [&](std::size_t i) { return n.dot(x.vertices[i] - plane.vertices[0]); };
  std::vector<Vec3> ends;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if (s[i] == 0) ends.push_back(x.vertices[i]);
    if (s[i] * s[j] < 0)
      ends.push_back(x.vertices[i] + height(i) / (height(i) - height(j)) * (x.vertices[j] - x.vertices[i]));
  }
  return std::pair(ends.front(), ends.back());
}

Setup setup(const Parameters& p) {
  const auto at = [&](const char* name) { return std::get<Vec3>(p.at(name)); };
  Setup s;
  s.method = std::get<std::string>(p.at("method"));
  s.triangles = {Three{{at("a0"), at("a1"), at("a2")}}, Three{{at("b0"), at("b1"), at("b2")}}};
  s.of = {sides(s.b(), s.a()), sides(s.a(), s.b())};
  s.area = {has_area(s.a()), has_area(s.b())};
  if (!on_one_side(s.of[0]) && !on_one_side(s.of[1])) s.truth = exact_relation(s);
  return s;
}

}  // namespace isect::lessons::triangle_triangle_lesson
