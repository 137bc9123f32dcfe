#include "lessons/picking/picture.h"

#include <cmath>

namespace isect::lessons::picking_lesson {

using namespace viz;
using namespace viewing;

Pointed::Pointed(const Vec3& the_pointer)
    : world(objects()),
      eye(48, 36),
      pointer(plane_x, the_pointer.y(), the_pointer.z()),
      ray(eye.through(pointer)),
      truth(world.closest(ray)) {
  for (const Object& o : world.objects) balls.push_back(bounding_ball(o.shape));
}

Mark Known::mark_of(int i) const { return tied() ? Mark::double_disc : i == kept ? Mark::disc : Mark::uncounted; }

namespace {

constexpr double far = 2.9;  ///< the end of the ray as drawn

/// The balls stand one on the other, so each has its name to the right.
void name_beside(const Object& o, Scene& scene) {
  const auto* ball = std::get_if<Sphere<double, 3>>(&o.shape);
  if (!ball) return add_name(o, scene);
  const View outside(from_outside(), 1, 1);
  scene.items.emplace_back(Label{ball->center + ball->radius * outside.right(), short_name(o), o.role});
}

void add_volume(const Pointed& s, int i, Scene& scene) {
  const Sphere<double, 3>& ball = s.balls[i];
  const View outside(from_outside(), 1, 1);  // its outline as seen from there
  scene.items.emplace_back(Circle{.center = ball.center,
                                  .radius = ball.radius,
                                  .role = s.met(i) ? Role::hit : Role::miss,
                                  .pen = s.met(i) ? Pen::solid : Pen::construction,
                                  .normal = outside.forward()});
}

Axis axis(const Pointed& s, const Known& known) {
  Axis axis;
  axis.lo = -0.25, axis.hi = far, axis.range_hi = INFINITY;
  axis.ticks.push_back({1, Mark::diamond, Role::highlight, "pointer"});
  for (const auto& [i, t] : known.hits) {
    if (known.tied() && i != known.kept) continue;
    const std::string label = known.tied() ? short_name(s.world.object(known.hits[0].first)) + ", " +
                                                 short_name(s.world.object(known.hits[1].first))
                                           : short_name(s.world.object(i));
    axis.ticks.push_back({t, known.mark_of(i), i == known.kept ? Role::hit : Role::construction, label});
  }
  return axis;
}

}  // namespace

Scene picture(const Pointed& s, const Known& known) {
  Scene scene;
  viewing::add(s.eye, scene);
  for (int i = 0; i < s.size(); ++i) viewing::add(s.world.object(i), scene, !known.volumes || s.met(i));
  for (const Object& o : s.world.objects) name_beside(o, scene);
  for (int i = 0; i < s.size(); ++i)
    if (known.volumes && std::holds_alternative<Triangles>(s.world.object(i).shape)) add_volume(s, i, scene);
  scene.items.emplace_back(Dot{s.pointer, Mark::diamond, Role::highlight});
  scene.items.emplace_back(Label{s.pointer, "pointer", Role::text});
  if (known.ray) {
    scene.items.emplace_back(Arrow{s.ray.origin, s.ray.at(far), Role::first});
    for (const auto& [i, t] : known.hits)
      if (!known.tied() || i == known.kept)
        scene.items.emplace_back(Dot{s.ray.at(t), known.mark_of(i), i == known.kept ? Role::hit : Role::construction});
  }
  scene.axis = axis(s, known);
  scene.handles = {{.parameter = "pointer",
                    .kind = Handle::Kind::on_plane,
                    .at = s.pointer,
                    .role = Role::highlight,
                    .direction = Vec3::UnitY(),
                    .across = Vec3::UnitZ()}};
  return scene;
}

/// The object that each pixel shows, or -1. Computed once, as neither eye nor objects move.
const std::vector<int>& objects_seen(const Pointed& s) {
  static const std::vector<int> seen = [&] {
    std::vector<int> objects;
    for (int y = 0; y < s.eye.rows; ++y)
      for (int x = 0; x < s.eye.columns; ++x) {
        const auto hit = s.world.closest(s.eye.through(s.eye.on_plane({x + 0.5, y + 0.5})));
        objects.push_back(hit ? hit->primitive : -1);
      }
    return objects;
  }();
  return seen;
}

Scene seen(const Pointed& s, const Known& known) {
  std::vector<Cell> cells;
  for (const int i : objects_seen(s)) {
    if (i < 0)
      cells.push_back({Role::grid, {}});
    else if (s.truth && i == s.truth->primitive)
      cells.push_back({Role::highlight, {}});
    else
      cells.push_back({s.world.object(i).role, 0.4 + 0.15 * i});  // apart in grey, too
  }
  Scene scene;
  const Raster raster = viewing::picture(s.eye, std::move(cells), Vec3::Zero(), 4.5);
  scene.items.emplace_back(raster);
  scene.items.emplace_back(Dot{on_picture(raster, s.eye, s.eye.pixel(s.pointer)), Mark::ring, Role::text});
  scene.axis = axis(s, known);
  return scene;
}

}  // namespace isect::lessons::picking_lesson
