// In the plane: outlines with outlines, and rays, lines and segments with outlines. Points and corners beside a line or
// a plane.

#include <algorithm>
#include <array>

#include <isect/ask.h>
#include <isect/orient.h>
#include <isect/ray_outline.h>

#include "app/scene/pairs.h"
#include "viz/lang/message.h"

namespace isect::program::scene {

namespace {

using Ring2 = Ring<double, 2>;

void along_outline(const Shaped& a, const Shaped& b, Told& out) {
  tell_first(
      a.type() == Type::segment ? first_hit(a.as<Segment, 2>(), b.outline()) : first_hit(a.as<Ray, 2>(), b.outline()),
      out);
}

/// Asks how they lie, by the even-odd rule; one without area counts as a segment.
void two_outlines(const Shaped& a, const Shaped& b, Told& out) {
  give(ask_pairs::outlines(a.outline(), b.outline()), out);
}

// A point beside a line or a plane.

void beside_plane(const Shaped& a, const Shaped& b, Told& out) {
  out.answer = by_core(a, b);
  out.result = {{"side", *out.answer.side}};
}

/// Returns its corners, or its points.
std::vector<viz::Vec3> all_corners(const Shaped& x) {
  if (x.type() != Type::mesh) return x.points();
  std::vector<viz::Vec3> all;  // those of its triangles
  for (const std::array<int, 3>& triangle : x.object.fixed.triangles)
    for (const int i : triangle) all.push_back(x.points()[static_cast<std::size_t>(i)]);
  return all;
}

void plane_and_corners(const Shaped& a, const Shaped& b, Told& out) {
  const Sides count = ask_pairs::corners<double, 3>(a.as<Plane, 3>(), all_corners(b));
  out.answer = answer(count);
  out.result = {{"behind", count.behind}, {"on", count.on}, {"before", count.before}};
  if (b.type() == Type::mesh) return;  // its triangles share corners
  const std::string unit = b.type() == Type::cloud || b.type() == Type::hull ? viz::tr("points") : viz::tr("corners");
  using viz::Role;
  out.values = {{viz::tr("where the normal points"), static_cast<double>(count.before), unit, Role::text, true},
                {a.flat() ? viz::tr("on the line") : viz::tr("in the plane"), static_cast<double>(count.on), unit,
                 Role::hit, true},
                {viz::tr("on the other side"), static_cast<double>(count.behind), unit, Role::text, true}};
}

/// Asks whether a point is left of it, right of it, on it, or in line with it and beyond an end.
void beside_line(const Shaped& a, const Shaped& b, Told& out) {
  out.answer = by_core(a, b);
  const int side = *out.answer.side;
  out.result = {{"where", out.answer.meet ? "on" : side > 0 ? "left" : side < 0 ? "right" : "in line"}};
}

}  // namespace

std::vector<Pair> pairs_in_plane() {
  using enum Type;
  using In = Pair::In;
  std::vector<Pair> table = {{point, plane, nullptr, In::both, beside_plane}};
  for (const Type with_corners : {triangle, polygon, hull, mesh, cloud})
    table.push_back({plane, with_corners, nullptr, with_corners == mesh ? In::space : In::both, plane_and_corners});
  for (const Type along : {segment, ray, line}) {
    table.push_back({point, along, nullptr, In::plane, beside_line});
    for (const Type outline : {triangle, polygon, hull})
      table.push_back({along, outline, nullptr, In::plane, along_outline});
  }
  for (const Type a : {triangle, polygon, hull, box})  // in both orders, so that they are named as they are asked about
    for (const Type b : {triangle, polygon, hull, box}) {
      const bool has_query = (a == box && b == box) || (a == box && b == triangle) || (a == triangle && b == box);
      if (!has_query) table.push_back({a, b, nullptr, In::plane, two_outlines});
    }
  return table;
}

}  // namespace isect::program::scene
