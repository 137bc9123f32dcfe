// k-DOPs, view volumes and convex hulls: given by planes or points, and drawn by their corners.

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

}  // namespace

std::vector<TypeSpec> polytope_types() {
  TypeSpec kdop = {Type::kdop, "kdop", "k-DOP"};
  kdop.made_of = "normals lo hi (lists)";
  kdop.extent = [](const NamedValues& s, const Object& o) {
    return s.flat ? outline_of(s, o) : solid_of(s, o).vertices;
  };
  kdop.draw = draw_polytope;

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
  frustum.vectors = {{"forward", "eye"}};

  TypeSpec hull = {Type::hull, "hull"};
  hull.made_of = "points (or file)";
  hull.draw = draw_hull;
  return {kdop, frustum, hull};
}

}  // namespace isect::program::scene
