#pragma once
// Closed meshes as solids: whether a mesh bounds one, and how two of them lie to each other.
//
// Two surfaces that pass through each other do so along segments. Around each segment that they have in common, planes
// through it part space into sectors, each in or out of either solid: so the sectors there tell what the solids have in
// common and what each has alone. Where a triangle's inside crosses another's, all four kinds of sectors are there.
// Else the segment belongs to an edge of one, whose triangles are put in order about it, beside those of the other's
// edge or the two halves of the other's triangle. Every part of a surface between such segments borders on one; a part
// without one, single points aside, lies in or out of the other solid as a whole, and a ray tells which.
//
// All this is decided by signs of volumes and areas. Pairs of triangles come from hierarchies: O(n lg n) and the pairs,
// and n for each connected part of a surface.
// Source: for the sectors Requicha, Voelcker, Boolean operations in solid modeling, Proc. IEEE 73 (1985), 3.3.

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <isect/parts/mesh_surface.h>
#include <isect/parts/two_triangles.h>

namespace isect {

namespace mesh_mesh::detail {

using mesh_surface::Surface;

// One mesh.

/// Whether triangles i and j have more in common than corners and edges of both.
inline bool clash(const Surface& mesh, int i, int j) {
  const std::array<int, 3>&of_i = mesh.places[i], &of_j = mesh.places[j];
  int shared = 0, alone_i = 0, alone_j = 0, common_i = 0;  // sums of the indices of corners not shared, and shared
  for (int k = 0; k < 3; ++k) {
    if (std::ranges::find(of_j, of_i[k]) != of_j.end())
      ++shared, common_i += k;
    else
      alone_i += k;
    if (std::ranges::find(of_i, of_j[k]) == of_i.end()) alone_j += k;
  }
  const Corners &x = mesh.triangles[i], &y = mesh.triangles[j];
  if (shared == 3) return true;
  if (shared == 2) {  // they fold onto each other
    const Point3 &p = mesh.corner(i, alone_i + 1), &q = mesh.corner(i, alone_i + 2), &a = mesh.corner(i, alone_i),
                 &b = mesh.corner(j, alone_j);
    if (orient3d(p, q, a, b) != 0) return false;
    const int axis = axis_of(p, q, a);
    return turn(p, q, a, axis) == turn(p, q, b, axis);
  }
  if (shared == 0) {
    const Signs side_i = sides(y, x);
    return !beside(side_i) && !beside(sides(x, y)) && meet(x, side_i, y);
  }
  // what else they have in common reaches the side across from the corner
  const int common_j = 3 - alone_j;  // the corners are 0, 1, 2
  return meets(mesh.corner(i, common_i + 1), mesh.corner(i, common_i + 2), y) ||
         meets(mesh.corner(j, common_j + 1), mesh.corner(j, common_j + 2), x);
}

inline bool crosses_itself(const Surface& surface) {
  bool found = false;
  report_pairs(surface.tree, surface.boxes, [&](int i, int j) { found = found || clash(surface, i, j); });
  return found;
}

/// A mesh that bounds a solid, and on which side of each triangle that lies.
struct Solid {
  const Surface& surface;
  std::vector<int> part;           ///< the connected part of the surface that a triangle belongs to
  std::vector<int> first_of_part;  ///< a triangle of each
  std::vector<char> above;         ///< whether the solid lies on the side that sees the triangle counter-clockwise

  explicit Solid(const Surface& s) : surface(s), part(s.triangles.size(), -1), above(s.triangles.size()) {
    for (int t = 0; t < static_cast<int>(part.size()); ++t)
      if (part[t] < 0) spread(t);
  }

 private:
  /// Settles the triangles that are connected with `first` by edges of two triangles.
  void spread(int first) {
    above[first] = solid_above(first);
    part[first] = static_cast<int>(first_of_part.size());
    first_of_part.push_back(first);
    std::vector<int> open = {first};
    while (!open.empty()) {
      const int t = open.back();
      open.pop_back();
      for (int side = 0; side < 3; ++side) {
        const std::span<const Surface::Side> both = surface.at_edge(t, side);
        if (both.size() != 2) continue;
        const Surface::Side& other = both[both[0].triangle == t ? 1 : 0];
        if (part[other.triangle] >= 0) continue;
        const bool opposed = surface.places[t][side] != surface.places[other.triangle][other.side];
        above[other.triangle] = opposed ? above[t] : !above[t];
        part[other.triangle] = part[t];
        open.push_back(other.triangle);
      }
    }
  }

  bool solid_above(int t) const {
    const Corners& x = surface.triangles[t];
    const Point3 &a = x.vertices[0], &b = x.vertices[1], &c = x.vertices[2];
    for (int k = 3;; ++k) {
      const Vector<double, 3> along = mesh_surface::direction(k);
      const int upwards = sign_of([&]<class W>() -> W {
        return dot(exactly<W>(along), isect::cross(difference<W>(b, a), difference<W>(c, a)));
      });
      if (upwards == 0) continue;
      if (const std::optional<Location> where =
              mesh_surface::located(mesh_surface::Mean{x.vertices}, along, surface, t))
        return (*where == Location::in) == (upwards > 0);
    }
  }
};

// Two solids.

/// One half of a plane that the axis bounds, and whether a solid lies next to it, counter-clockwise about the axis.
struct HalfPlane {
  Point3 at;  ///< any point of it off the axis
  bool of_first, solid;
};

/// What has been found: a point of both solids' insides, one of the first alone, one of the second alone.
struct Common {
  bool both = false, first = false, second = false, touch = false;

  bool all() const { return both && first && second; }

  /// Notes what the sectors about the axis from p to q hold.
  void look_around(const Point3& p, const Point3& q, std::vector<HalfPlane>& halves) {
    const Point3 start = halves.front().at;
    const auto turned = [&](const Point3& x, const Point3& y) { return orient3d(q, x, y, p); };
    const int axis = axis_of(p, q, start), sense = turn(p, q, start, axis);
    const auto quarter = [&](const Point3& x) {  // 0 along the start, 1 up to half a turn, 2 opposite, 3 beyond
      const int side = turned(start, x);
      return side > 0 ? 1 : side < 0 ? 3 : turn(p, q, x, axis) == sense ? 0 : 2;
    };
    const auto before = [&](const HalfPlane& x, const HalfPlane& y) {
      const int of_x = quarter(x.at), of_y = quarter(y.at);
      return of_x != of_y ? of_x < of_y : of_x % 2 == 1 && turned(x.at, y.at) > 0;
    };
    std::ranges::sort(halves, before);
    bool in_first = false, in_second = false;
    for (const HalfPlane& half : halves) (half.of_first ? in_first : in_second) = half.solid;  // before the start
    for (std::size_t i = 0; i < halves.size(); ++i) {
      (halves[i].of_first ? in_first : in_second) = halves[i].solid;
      if (i + 1 < halves.size() && !before(halves[i], halves[i + 1])) continue;  // the next lies along it
      both |= in_first && in_second;
      first |= in_first && !in_second;
      second |= in_second && !in_first;
    }
  }
};

/// Adds the half-planes of the triangles at an edge from p to q.
inline void add_edge(const Solid& solid, int t, int side, const Point3& p, const Point3& q, bool of_first,
                     std::vector<HalfPlane>& halves) {
  int axis = 0;
  while (p[axis] == q[axis]) ++axis;
  for (const Surface::Side& s : solid.surface.at_edge(t, side)) {
    const Point3 &from = solid.surface.corner(s.triangle, s.side), &to = solid.surface.corner(s.triangle, s.side + 1);
    const bool along = (from[axis] < to[axis]) == (p[axis] < q[axis]);
    halves.push_back({solid.surface.corner(s.triangle, s.side + 2), of_first, along == bool(solid.above[s.triangle])});
  }
}
/// Adds the two halves of a triangle inside which the axis runs.
inline void add_halves(const Solid& solid, int t, const Point3& p, const Point3& q, bool of_first,
                       std::vector<HalfPlane>& halves) {
  const auto& v = solid.surface.triangles[t].vertices;
  const int axis = axis_of(v[0], v[1], v[2]), sense = turn(v[0], v[1], v[2], axis);
  bool found[2] = {};
  for (const Point3& x : v)
    if (const int side = turn(p, q, x, axis); side != 0 && !std::exchange(found[side > 0], true))
      halves.push_back({x, of_first, (side == sense) == bool(solid.above[t])});
}

/// Finds what triangle i of the first surface and j of the second have in common.
inline void compare(const Solid& a, int i, const Solid& b, int j, std::vector<char>& bordered_a,
                    std::vector<char>& bordered_b, Common& common) {
  const Corners &x = a.surface.triangles[i], &y = b.surface.triangles[j];
  const Signs of_x = sides(y, x);
  if (beside(of_x)) return;
  const Signs of_y = sides(x, y);
  if (beside(of_y)) return;
  if (cross(x, of_x, y, of_y)) {
    common = {true, true, true, true};
    return;
  }
  std::vector<HalfPlane> halves;
  const auto look = [&](const Point3& p, const Point3& q) {
    common.touch = true;
    bordered_a[a.part[i]] = bordered_b[b.part[j]] = true;
    common.look_around(p, q, halves);
    halves.clear();
  };
  const auto in_plane = [](const Signs& s, int side) { return s[side] == 0 && s[(side + 1) % 3] == 0; };
  for (int k = 0; k < 3; ++k) {
    if (!in_plane(of_x, k)) continue;
    const Point3 &p = a.surface.corner(i, k), &q = a.surface.corner(i, k + 1);
    if (within(p, q, y)) {
      add_edge(a, i, k, p, q, true, halves);
      add_halves(b, j, p, q, false, halves);
      look(p, q);
    }
    for (int l = 0; l < 3; ++l) {
      if (!in_plane(of_y, l) || !share_stretch(p, q, b.surface.corner(j, l), b.surface.corner(j, l + 1))) continue;
      add_edge(a, i, k, p, q, true, halves);
      add_edge(b, j, l, p, q, false, halves);
      look(p, q);
    }
  }
  for (int l = 0; l < 3; ++l) {
    const Point3 &p = b.surface.corner(j, l), &q = b.surface.corner(j, l + 1);
    if (!in_plane(of_y, l) || !within(p, q, x)) continue;
    add_halves(a, i, p, q, true, halves);
    add_edge(b, j, l, p, q, false, halves);
    look(p, q);
  }
  if (!common.touch) common.touch = meet(x, of_x, y);
}

/// Places the parts of a surface that have no stretch in common with the other: each wholly in or out of its solid.
inline void place_parts(const Solid& a, const std::vector<char>& bordered, const Solid& b, bool& inside,
                        bool& outside) {
  for (std::size_t part = 0; part < bordered.size(); ++part) {
    if (bordered[part]) continue;
    const auto& [p, q, r] = a.surface.triangles[a.first_of_part[part]].vertices;
    std::vector<Point3> points = {p, q, r};
    Location where = mesh_surface::locate(mesh_surface::Mean{points}, b.surface);
    while (where == Location::on) {  // in one of the single points that they may have in common: another mean
      points.push_back(points.size() % 2 == 0 ? p : q);
      where = mesh_surface::locate(mesh_surface::Mean{points}, b.surface);
    }
    (where == Location::in ? inside : outside) = true;
  }
}

inline bool apart(const Surface& a, const Surface& b) {
  return a.triangles.empty() || b.triangles.empty() || !intersects(a.tree.nodes[0].box, b.tree.nodes[0].box);
}

inline Relation relation(const Surface& a, const Surface& b) {
  if (apart(a, b)) return Relation::disjoint;
  const Solid first(a), second(b);
  std::vector<char> bordered_a(first.first_of_part.size()), bordered_b(second.first_of_part.size());
  Common common;
  report_pairs(a.tree, a.boxes, b.tree, b.boxes, [&](int i, int j) {
    if (!common.all()) compare(first, i, second, j, bordered_a, bordered_b, common);
  });
  if (!common.all()) {
    // a surface inside the other solid has both its sides in there
    bool inside = false;
    place_parts(first, bordered_a, second, inside, common.first);
    common.both |= inside, common.second |= inside;
    inside = false;
    place_parts(second, bordered_b, first, inside, common.second);
    common.both |= inside, common.first |= inside;
  }
  if (!common.both) return common.touch ? Relation::touching : Relation::disjoint;
  return common.first    ? common.second ? Relation::overlapping : Relation::b_inside_a
         : common.second ? Relation::a_inside_b
                         : Relation::equal;
}

/// Whether the mesh has valid indices and finite vertices.
template <class S>
bool meaningful(const TriangleMesh<S>& mesh) {
  return valid(mesh) && std::ranges::all_of(mesh.vertices, [](const Point<S, 3>& v) { return finite(v); });
}

/// Whether every triangle has an area, and every edge belongs to an even number of them.
inline bool encloses(const Surface& surface) {
  const std::vector<int>& first = surface.first_side;
  for (std::size_t edge = 0; edge + 1 < first.size(); ++edge)
    if ((first[edge + 1] - first[edge]) % 2 != 0) return false;
  return std::ranges::all_of(surface.triangles,
                             [](const Corners& x) { return axis_of(x.vertices[0], x.vertices[1], x.vertices[2]) < 3; });
}

}  // namespace mesh_mesh::detail

/// Whether a triangle of the mesh meets another in more than corners and edges of both, or two lie on each other.
/// Exact; corners in the same place count as one. The indices are valid and all is finite.
template <class S>
bool crosses_itself(const TriangleMesh<S>& mesh) {
  const mesh_surface::Surface surface(mesh);
  return mesh_mesh::detail::crosses_itself(surface);
}

/// Whether the mesh bounds a solid: its indices are valid and all is finite; every triangle has an area; every edge
/// belongs to an even number of triangles; and it does not cross itself. Exact.
template <class S>
bool bounds_solid(const TriangleMesh<S>& mesh) {
  using namespace mesh_mesh::detail;
  if (!meaningful(mesh)) return false;
  const Surface surface(mesh);
  return encloses(surface) && !crosses_itself(surface);
}

/// How the solids lie that two meshes bound (see bounds_solid), by even-odd, however their triangles turn. Exact. A
/// mesh without triangles is empty.
template <class S>
Relation relate(const TriangleMesh<S>& a, const TriangleMesh<S>& b) {
  return mesh_mesh::detail::relation(mesh_surface::Surface(a), mesh_surface::Surface(b));
}

/// Returns what relate does, but nothing where one of the meshes bounds no solid. Closed meshes whose boxes are apart
/// are disjoint; whether they cross themselves is not checked.
template <class S>
std::optional<Relation> relate_solids(const TriangleMesh<S>& a, const TriangleMesh<S>& b) {
  using namespace mesh_mesh::detail;
  if (!meaningful(a) || !meaningful(b)) return {};
  const Surface x(a), y(b);
  if (!encloses(x) || !encloses(y)) return {};
  if (apart(x, y)) return Relation::disjoint;
  if (crosses_itself(x)) return {};
  if (a.vertices == b.vertices && a.triangles == b.triangles) return Relation::equal;
  if (crosses_itself(y)) return {};
  return relation(x, y);
}

}  // namespace isect
