// Polygons in space.

#include <algorithm>

#include "app/query/reply.h"
#include "app/scene/pairs.h"
#include "viz/lang/message.h"
#include "viz/text/rich_text.h"

namespace isect::program::scene {

void tell_bent(const Shaped& o, Told& out) {
  const double off = o.off_plane();
  if (off == 0) return;
  out.result["off_plane"] = std::max(off, out.result.value("off_plane", 0.0));
  out.note += out.note.empty() ? "" : " ";
  out.note += viz::tr(
      "The corners of {a} lie up to {off} off one plane: what is tested are the triangles that its outline is cut "
      "into.",
      {{"a", shown_name(o.object.name)}, {"off", viz::shown(off)}});
}

namespace {

void mesh_and_polygon(const Shaped& a, const Shaped& b, Told& out) {
  out.answer = by_core(a, b);
  out.result = {{"triangles_met", *out.answer.triangles}};
}
void point_and_polygon(const Shaped& a, const Shaped& b, Told& out) {
  out.answer = by_core(a, b);
  out.result = {{"on", out.answer.meet}};
}
void cloud_and_polygon(const Shaped& a, const Shaped& b, Told& out) {
  std::vector<Location> where;
  for (const viz::Vec3& p : a.points()) where.push_back(lies_on(p, b) ? Location::on : Location::out);
  tell_cloud_on(a, b, where, out);
}

/// Refuses an outline that is no polygon, and notes one that is not flat.
template <void (*asked)(const Shaped&, const Shaped&, Told&)>
void polygon_asked(const Shaped& a, const Shaped& b, Told& out) {
  for (const Shaped* const x : {&a, &b})
    if (x->type() == Type::polygon) static_cast<void>(x->polygon());
  asked(a, b, out);
  tell_bent(a, out);
  tell_bent(b, out);
}

}  // namespace

std::vector<Pair> pairs_of_polygons() {
  using enum Type;
  const auto in = Pair::In::space;
  std::vector<Pair> table = {{point, polygon, nullptr, in, polygon_asked<point_and_polygon>},
                             {cloud, polygon, nullptr, in, polygon_asked<cloud_and_polygon>},
                             {mesh, polygon, nullptr, in, polygon_asked<mesh_and_polygon>}};
  for (const Type other : {sphere, box, obb, capsule, cylinder, cone, triangle, polygon, kdop, hull, frustum})
    table.push_back({polygon, other, nullptr, in, polygon_asked<relate>});
  return table;
}

}  // namespace isect::program::scene
