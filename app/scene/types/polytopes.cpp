// k-DOPs, view volumes and convex hulls: given by planes or points, and drawn by their corners.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/scene/types/rows.h"

namespace isect::program::scene {

namespace {

using viz::Vec3;

void draw_polytope(Drawing& d) {
  if (d.s.flat)
    d.outline({outline_of(d.s, d.o)});
  else
    d.solid(solid_of(d.s, d.o));
}

void draw_frustum(Drawing& d) {
  viz::Solid shape = viz::solid(frustum_of(d.s, d.o), d.role);
  d.name(top_of(shape.vertices));
  d.items.push_back(std::move(shape));
}

/// Draws the points and their hull.
void draw_hull(Drawing& d) {
  draw_polytope(d);
  d.dots(d.s.points(d.o));
}

/// Adds the faces: each is moved along its normal, and stands where it touches the shape.
void grip_kdop(Grips& g) {
  const std::vector<Vec3> corners = g.s.extent(g.o);
  const Vec3 middle = middle_of(corners);
  const auto place = [&](const Vec3& n, double end) {
    std::vector<Vec3> touching;
    for (const Vec3& p : corners)
      if (std::abs(n.dot(p) - end) <= 1e-9 * (n.cwiseAbs().dot(p.cwiseAbs()) + std::abs(end))) touching.push_back(p);
    const Vec3 near = touching.empty() ? middle : middle_of(touching);
    return Vec3(near - (n.dot(near) - end) / n.squaredNorm() * n);
  };
  for (std::size_t i = 0; i < g.o.fixed.normals.size(); ++i) {
    const Vec3& n = g.o.fixed.normals[i];
    const std::string slab = std::to_string(i + 1);
    const double lo = g.s.number(g.o, "lo" + slab), hi = g.s.number(g.o, "hi" + slab);
    g.on_line("lo" + slab, place(n, lo), Vec3::Zero(), n).hi = hi;
    g.on_line("hi" + slab, place(n, hi), Vec3::Zero(), n).lo = lo;
  }
}

/// Adds the near and the far plane, the upper edge of the far one, which opens the angle, and its right edge.
void grip_frustum(Grips& g) {
  const Vec3 eye = g.at("eye"), f = g.at("forward").stableNormalized();
  const Vec3 right = f.cross(g.at("up")).stableNormalized(), up = right.cross(f);
  const double near = g.s.number(g.o, "near"), far = g.s.number(g.o, "far");
  const double tall = std::tan(g.s.number(g.o, "angle") * std::numbers::pi / 360);
  g.on_line("near", eye + near * f, eye, f).hi = far;
  g.on_line("far", eye + far * f, eye, f).lo = near;
  viz::Handle& angle = g.add("angle", viz::Handle::Kind::angle, eye + far * (f + tall * up), eye);
  angle.direction = f, angle.across = up, angle.scale = 2;
  if (!g.s.has(g.o, "aspect")) return;
  const Vec3 edge = eye + far * (f + g.s.number(g.o, "aspect") * tall * right);
  g.on_line("aspect", edge, eye + far * f, right / (tall * far));
}

/// Whether it has corners, all of them numbers.
bool has_corners(const NamedValues& s, const Object& o) {
  try {
    const std::vector<Vec3> corners = s.extent(o);
    return !corners.empty() && std::ranges::all_of(corners, [](const Vec3& p) { return p.allFinite(); });
  } catch (const viz::BadInput&) {
    return false;
  }
}

bool far_is_beyond_near(const NamedValues& s, const Object& o) { return s.number(o, "near") < s.number(o, "far"); }

bool has_volume(const NamedValues& s, const Object& o) { return s.flat || hull_of(s, o).dimension == 3; }

}  // namespace

std::vector<TypeSpec> polytope_types() {
  TypeSpec kdop = {Type::kdop, "kdop", "k-DOP"};
  kdop.made_of = "normals lo hi (lists)";
  kdop.extent = [](const NamedValues& s, const Object& o) {
    return s.flat ? outline_of(s, o) : solid_of(s, o).vertices;
  };
  kdop.draw = draw_polytope;
  kdop.grips = grip_kdop;
  kdop.drawable = {{"lo1", "slabs that have a point in common", has_corners}};

  TypeSpec frustum = {Type::frustum, "frustum"};
  frustum.in_plane = "";
  frustum.fields = {{"eye", Means::place, "where its planes would meet"},
                    {"forward", Means::direction, "where the eye looks, of any length but 0"},
                    {"up", Means::direction, "what is up there, not along forward"},
                    {"angle", Means::number, "from bottom to top, in degrees", false, 1, 170},
                    {"aspect", Means::number, "width to height; 1 if not given", true, 0.01, 100},
                    {"near", Means::number, "distance of the near plane", false, 0},
                    {"far", Means::number, "distance of the far plane", false, 0}};
  frustum.extent = [](const NamedValues& s, const Object& o) {
    return viz::solid(frustum_of(s, o), viz::Role::second).vertices;
  };
  frustum.draw = draw_frustum;
  frustum.vectors = {{"forward", "eye"}, {"up", "eye"}};
  frustum.grips = grip_frustum;
  frustum.drawable = {{"far", "a far of more than near", far_is_beyond_near},
                      {"up", "a forward and an up that are not along one line", has_corners}};

  TypeSpec hull = {Type::hull, "hull"};
  hull.made_of = "points (or file) [at]";
  hull.with_at = true;
  hull.draw = draw_hull;
  hull.drawable = {{"1", "points that do not all lie in one plane", has_volume}};
  return {kdop, frustum, hull};
}

}  // namespace isect::program::scene
