#include <fmt/format.h>

#include <cmath>
#include <map>
#include <numbers>

#include "lessons/convex_polygon/picture.h"
#include "lessons/shared/flat.h"
#include "lessons/shared/plural.h"

namespace isect::lessons::convex_polygon_lesson {

using namespace viz;

namespace {

/// The lesson's polygon, cached as a million vertices take a while; for n = 4 the vertices lie on the axes exactly.
const ConvexPolygon<double>& polygon_of(int n) {
  static std::map<int, ConvexPolygon<double>> kept;
  ConvexPolygon<double>& polygon = kept[n];
  if (!polygon.vertices.empty()) return polygon;
  if (n == 4) {
    polygon.vertices = {{2.25, 0}, {0, 1.75}, {-2.25, 0}, {0, -1.75}};
    return polygon;
  }
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n - 0.4;
    polygon.vertices.push_back({2.25 * std::cos(angle), 1.75 * std::sin(angle)});
  }
  return polygon;
}

/// The vertices from `from` to `to`, at most `most`, as more would not be seen.
std::vector<Vec3> arc(const Setup& s, int from, int to) {
  constexpr int most = 180;
  std::vector<Vec3> points;
  const int step = std::max(1, (to - from) / most);
  for (int i = from; i < to; i += step) points.push_back(flat(s.vertex(i)));
  points.push_back(flat(s.vertex(to)));
  return points;
}

/// Draws lines from the apex to the vertices: to all of them at the start, then to those of the wedges left.
void rays(Scene& scene, const Setup& s, const Shown& shown) {
  const int from = shown.lo < 0 ? 0 : shown.lo, to = shown.lo < 0 ? s.size() - 1 : shown.hi;
  for (int i = from; i <= to; i += 1 + (to - from) / most_rays)
    if (s.vertex(i) != shown.apex)
      scene.items.emplace_back(Line{flat(shown.apex), flat(s.vertex(i)), Role::construction, Pen::hairline});
}

std::string name(int i) { return fmt::format("**v**_{{{}}}", i); }

}  // namespace

Setup::Setup(int n, const Point<double, 2>& the_point)
    : polygon(polygon_of(n)), p(the_point), truth(locate(p, polygon)) {}

Setup::Setup(ConvexPolygon<double> any, const Point<double, 2>& the_point)
    : own(std::make_shared<const ConvexPolygon<double>>(std::move(any))),
      polygon(*own),
      p(the_point),
      truth(locate(p, polygon)) {}

Scene picture(const Setup& s, const Shown& shown) {
  Scene scene;
  Region region;
  region.rings = {arc(s, 0, s.size() - 1)};
  region.corners = s.size() <= 64;
  scene.items.emplace_back(region);

  const Vec3 apex = flat(shown.apex), p = flat(s.p);
  rays(scene, s, shown);
  if (shown.lo >= 0) {
    Region wedge;
    wedge.role = Role::highlight, wedge.outlined = false;
    wedge.rings = {arc(s, shown.lo, shown.hi)};
    wedge.rings[0].push_back(apex);
    scene.items.emplace_back(wedge);
    for (const int i : {shown.lo, shown.hi})
      scene.items.emplace_back(Line{apex, flat(s.vertex(i)), Role::construction, Pen::construction});
    const bool apart = (flat(s.vertex(shown.lo)) - flat(s.vertex(shown.hi))).norm() > 0.35;
    const Point<double, 2> zero = s.vertex(0);
    const auto label = [&](int i) {
      if (s.vertex(i) != zero || shown.apex != zero)
        scene.items.emplace_back(Label{flat(s.vertex(i)), name(i % s.size()), Role::second});
    };
    label(shown.lo);
    if (apart && shown.hi % s.size() != shown.lo) label(shown.hi);
  }
  if (shown.mid >= 0) scene.items.emplace_back(Line{apex, flat(s.vertex(shown.mid)), Role::text, Pen::solid});
  if (shown.edge && shown.lo >= 0)
    scene.items.emplace_back(Line{flat(s.vertex(shown.lo)), flat(s.vertex(shown.hi)), Role::highlight, Pen::highlight});
  scene.items.emplace_back(Dot{apex, Mark::disc, Role::second});
  scene.items.emplace_back(Label{apex, shown.apex_name, Role::second});
  scene.items.emplace_back(shown.on ? Dot{p, Mark::diamond, Role::highlight} : Dot{p, Mark::disc, Role::first});
  scene.items.emplace_back(Label{p, "**p**", Role::first});
  scene.handles.push_back({"p", Handle::Kind::point, p, Vec3::Zero(), Role::first});
  return scene;
}

std::string alt_text(const Setup& s) {
  return fmt::format("A convex polygon of {} vertices and a point that lies {}.",
                     counted(static_cast<long long>(s.size())), lies(s.truth));
}

}  // namespace isect::lessons::convex_polygon_lesson
