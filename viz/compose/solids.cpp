// Solids: faces shaded by the light, edges solid or dashed; and opaque meshes.

#include <Eigen/Geometry>

#include <algorithm>
#include <numeric>
#include <tuple>

#include "viz/compose/canvas.h"

namespace isect::viz {
namespace {

/// Returns how directly the light, from the upper left in front, falls on a face: 0 (from behind) to 1.
double lit(const Vec3& normal) {
  static const Vec3 light = Vec3(-0.35, 0.85, 0.55).normalized();
  return std::clamp(normal.dot(light), 0.0, 1.0);
}

/// Returns the opacity: the lighter a face, the less ink. What two objects share is dense on all sides.
double alpha(const Theme& theme, Role role, double light) {
  if (role == Role::hit) return theme.overlap_alpha * (1.3 - 0.5 * light);
  return theme.fill_alpha * (1.9 - 1.45 * light);
}

Vec3 middle(const std::vector<Vec3>& points) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& p : points) sum += p;
  return sum / static_cast<double>(std::max<std::size_t>(points.size(), 1));
}

/// Whether the whole solid is seen against a mesh, whose shades may be as dark as the solid's edges.
bool is_seen_on_a_mesh(const Canvas& c, const Solid& solid) {
  const std::vector<Vec2> points = c.projected(solid.vertices);
  return std::ranges::any_of(c.meshes, [&](const SortedMesh& mesh) {
    return std::ranges::all_of(points, [&](const Vec2& p) { return !facet_over(mesh, c.view, p).facets.empty(); });
  });
}

void faces(Canvas& c, const Solid& solid, const Shell& shell) {
  const Colour ink = c.theme.ink(solid.role);
  const bool hatched = c.theme.hatched(solid.role), cut_out = is_seen_on_a_mesh(c, solid);
  for (std::size_t i = 0; i < solid.faces.size(); ++i) {
    const Vec3& n = shell.normals[i];
    std::vector<Vec3> corners;
    for (const int v : solid.faces[i]) corners.push_back(solid.vertices[v]);
    if (n.squaredNorm() == 0 || n.dot(c.view.towards_eye(middle(corners))) <= 0) continue;
    Fill face = {polyline(c.projected(corners), true), ink.with_alpha(alpha(c.theme, solid.role, lit(n))), 0, 0, {}};
    if (cut_out) {
      const Path outline = face.path;
      c.fronts.emplace_back(Fill{outline, c.theme.background, 0, 0, {}});
      c.fronts.emplace_back(Stroke{outline, c.theme.background, 2 * c.sizes().halo, {0, 0}, true});
    }
    if (hatched) {
      face.colour = ink.with_alpha(0.7 * face.colour.a);
      face.hatch_gap = c.sizes().hatch_gap, face.hatch_line = c.sizes().hatch_line, face.hatch_colour = ink;
    }
    c.fronts.emplace_back(face);
  }
}

/// Whether an edge counts as one: an edge between two coplanar faces does not.
bool is_edge(const Shell& shell, const Shell::Edge& edge) {
  if (edge.faces.size() != 2) return true;
  const Vec3 &a = shell.normals[edge.faces[0]], &b = shell.normals[edge.faces[1]];
  return !(a.dot(b) > 1 - 1e-12);
}
/// Whether the side of a round solid bends here: both faces beside the edge are sides, which turn by less than 41
/// degrees.
bool is_bend(const Shell& shell, const Shell::Edge& edge) {
  return edge.faces.size() == 2 && shell.normals[edge.faces[0]].dot(shell.normals[edge.faces[1]]) > 0.75;
}

/// Above this many edges a solid counts as round: only its silhouette is drawn strong, and its far side not at all.
constexpr std::size_t fine_from = 60;

bool is_silhouette(const Shell& shell, const Shell::Edge& edge, const View& view) {
  const Vec3 eye = view.towards_eye(edge.from);
  return edge.faces.size() != 2 || shell.normals[edge.faces[0]].dot(eye) * shell.normals[edge.faces[1]].dot(eye) <= 0;
}

/// Whether an edge of a convex solid is on its front or on its back, as the eye sees it.
enum class Side { front, back, unclear };
Side side_of(const Shell& shell, const Shell::Edge& edge, const View& view) {
  constexpr double least = 1e-9;
  const Vec3 eye = view.towards_eye(edge.from);
  bool back = edge.faces.size() == 2;
  for (const int face : edge.faces) {
    const double facing = shell.normals[face].dot(eye);
    if (facing > least) return Side::front;
    back = back && facing < -least;
  }
  return back ? Side::back : Side::unclear;
}

/// Draws faces and edges of number `index` of the scene's solids.
void draw_solid(Canvas& c, const Solid& solid, int index) {
  const Shell& shell = c.occluders.solids[index];
  faces(c, solid, shell);
  const double width = solid.role == Role::hit ? c.sizes().shared : c.sizes().outline;
  const bool shared = solid.role == Role::hit, fine = shell.edges.size() > fine_from;
  const Occluders around = shared ? c.occluders : around_solid(c.occluders, index, solid.vertices, true, &c.view);
  const Occluders others =
      fine && !shared ? around_solid(c.occluders, index, solid.vertices, false, &c.view) : Occluders{};
  for (const Shell::Edge& edge : shell.edges) {
    if (!is_edge(shell, edge)) continue;
    if (solid.round && is_bend(shell, edge) && !is_silhouette(shell, edge, c.view)) continue;
    const Side side = fine && !shared ? side_of(shell, edge, c.view) : Side::unclear;
    if (side == Side::back) continue;
    std::vector<Stretch> parts = stretches(edge.from, edge.to, c.view, side == Side::front ? others : around);
    if (fine) std::erase_if(parts, [](const Stretch& part) { return part.hidden; });
    c.curve(parts, c.theme.ink(solid.role), fine && !is_silhouette(shell, edge, c.view) ? c.sizes().hidden : width,
            !fine);
  }
}

}  // namespace

void draw_solids(Canvas& c) {
  std::vector<const Solid*> solids;
  std::vector<int> items;  // the place of each among the scene's
  for (std::size_t i = 0; i < c.scene.items.size(); ++i)
    if (const Solid* solid = std::get_if<Solid>(&c.scene.items[i]))
      solids.push_back(solid), items.push_back(static_cast<int>(i));
  std::vector<std::size_t> order(solids.size());  // of the scene, and so of the shells
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto depth = [&](std::size_t i) { return c.depth(middle(solids[i]->vertices)); };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return depth(a) > depth(b); });

  for (const std::size_t i : order) c.own(items[i], [&] { draw_solid(c, *solids[i], static_cast<int>(i)); });
}

void draw(Canvas& c, const Mesh& it) {
  struct Facing {
    double depth;
    std::size_t triangle;
  };
  std::vector<Facing> facing;
  facing.reserve(it.triangles.size());
  const auto corners = [&](std::size_t i) {
    const std::array<int, 3>& t = it.triangles[i];
    return std::tie(it.vertices[t[0]], it.vertices[t[1]], it.vertices[t[2]]);
  };
  for (std::size_t i = 0; i < it.triangles.size(); ++i) {
    const auto& [p, q, r] = corners(i);
    if (!((q - p).cross(r - p).dot(c.view.towards_eye(p)) > 0)) continue;
    facing.push_back({c.depth((p + q + r) / 3), i});
  }
  std::ranges::stable_sort(facing, std::ranges::greater{}, &Facing::depth);

  const std::vector<Vec2> seen = c.projected(it.vertices);
  const Colour ink = c.theme.ink(it.role);
  if (c.theme.name == ThemeName::grey) {  // its light parts are as light as the ground
    std::vector<std::pair<int, int>> edges;
    for (const Facing& f : facing)
      for (int k = 0; k < 3; ++k)
        edges.emplace_back(it.triangles[f.triangle][k], it.triangles[f.triangle][(k + 1) % 3]);
    std::ranges::sort(edges);
    for (const auto& [from, to] : edges)  // the outline; later the facets hide what of it lies before others
      if (!std::ranges::binary_search(edges, std::pair(to, from)))
        c.contents.emplace_back(Stroke{.path = polyline({seen[from], seen[to]}),
                                       .colour = ink,
                                       .width = 2 * c.sizes().outline,
                                       .round_cap = true});
  }
  const double darkest = c.theme.name == ThemeName::grey ? 0.5 : 0.08;  // without colours only light tells lines on it
  Facets facets = {.seam = 0.3 * c.sizes().hairline};
  facets.corners.reserve(3 * facing.size()), facets.colours.reserve(facing.size());
  for (const Facing& f : facing) {
    for (const int corner : it.triangles[f.triangle]) facets.corners.push_back(seen[corner]);
    const auto& [p, q, r] = corners(f.triangle);
    const Vec3 n = (q - p).cross(r - p).normalized();
    facets.colours.push_back(mixed(ink, c.theme.background, darkest + 0.45 * lit(n)));
  }
  c.contents.emplace_back(std::move(facets));
}

}  // namespace isect::viz
