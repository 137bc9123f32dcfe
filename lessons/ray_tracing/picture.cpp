#include "lessons/ray_tracing/picture.h"

#include <algorithm>
#include <cmath>

namespace isect::lessons::ray_tracing_lesson {

using namespace viz;
using namespace viewing;

OnePixel::OnePixel(const Vec3& point, const Vec3& the_lamp, ShadowRay the_start)
    : world(scene_objects()),
      eye(columns, rows),
      start(the_start),
      lamp(the_lamp),
      handle(plane_x, point.y(), point.z()) {
  const Vec2 p = eye.pixel(point);
  column = static_cast<int>(std::clamp(std::floor(p.x()), 0.0, columns - 1.0));
  row = static_cast<int>(std::clamp(std::floor(p.y()), 0.0, rows - 1.0));
  aim = eye.on_plane({column + 0.5, row + 0.5});
  ray = eye.through(aim);
  Work work;
  traced = trace(world, ray, lamp, work);
  if (const Traced naive = trace(world, ray, lamp, work, start); naive.blocker && !traced.blocker)
    traced = naive, acne = true;
}

namespace {

/// The ray's own t-axis: the picture plane at 1, and what it meets.
Axis axis(const OnePixel& s, const Shown& shown) {
  Axis axis;
  axis.lo = -0.25, axis.hi = 4, axis.range_hi = INFINITY;
  axis.ticks.push_back({1, Mark::diamond, Role::highlight, "pixel"});
  for (int i = 0; shown.hits && i < static_cast<int>(s.world.objects.size()); ++i) {
    const std::optional<double> t = first_hit(s.ray, s.world.object(i).shape);
    if (!t || *t > axis.hi) continue;
    const bool closest = s.traced.hit->primitive == i;
    axis.ticks.push_back({*t, closest ? Mark::disc : Mark::uncounted, closest ? Role::hit : Role::construction,
                          short_name(s.world.object(i))});
  }
  return axis;
}

void add_pixel(const OnePixel& s, Scene& scene) {
  Region pixel;
  pixel.role = Role::highlight, pixel.pen = Pen::highlight;
  pixel.rings.emplace_back();
  for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
    pixel.rings[0].push_back(s.eye.on_plane({s.column + x, s.row + y}));
  scene.items.emplace_back(pixel);
  scene.items.emplace_back(Label{s.aim, "pixel", Role::text});
}

void add_ray(const OnePixel& s, const Shown& shown, Scene& scene) {
  const double far = 3.2;
  scene.items.emplace_back(shown.hits && s.traced.hit
                               ? Item(Line{s.ray.origin, s.traced.point, Role::first, Pen::thick})
                               : Item(Arrow{s.ray.origin, s.ray.at(far), Role::first}));
  if (!shown.hits) return;
  for (int i = 0; i < static_cast<int>(s.world.objects.size()); ++i) {
    const std::optional<double> t = first_hit(s.ray, s.world.object(i).shape);
    if (!t) continue;
    const bool closest = s.traced.hit->primitive == i;
    scene.items.emplace_back(
        Dot{s.ray.at(*t), closest ? Mark::disc : Mark::uncounted, closest ? Role::hit : Role::construction});
    if (!closest) scene.items.emplace_back(Line{s.traced.point, s.ray.at(*t), Role::construction, Pen::construction});
  }
}

}  // namespace

Scene picture(const OnePixel& s, const Shown& shown) {
  Scene scene;
  viewing::add(s.eye, scene);
  for (const Object& o : s.world.objects) viewing::add(o, scene);
  for (const Object& o : s.world.objects) add_name(o, scene);
  scene.items.emplace_back(Dot{s.lamp, Mark::diamond, Role::highlight});
  scene.items.emplace_back(Label{s.lamp, "light source", Role::text});
  add_pixel(s, scene);
  if (shown.ray) add_ray(s, shown, scene);
  if (shown.normal) {
    const Vec3 p = s.traced.point;
    scene.items.emplace_back(Arrow{p, p + 0.8 * s.traced.normal, Role::text, Pen::thick});
    scene.items.emplace_back(Label{p + 0.8 * s.traced.normal, "**n**", Role::text});
  }
  if (shown.shadow_ray)
    scene.items.emplace_back(Line{s.traced.point, s.lamp, s.traced.blocker ? Role::miss : Role::hit,
                                  s.traced.blocker ? Pen::excluded : Pen::thick});
  scene.axis = axis(s, shown);
  scene.handles = {{.parameter = "pixel",
                    .kind = Handle::Kind::on_plane,
                    .at = s.handle,
                    .direction = Vec3::UnitY(),
                    .across = Vec3::UnitZ()},
                   {"lamp", Handle::Kind::point, s.lamp, Vec3::Zero(), Role::highlight}};
  return scene;
}

Scene picture(const OnePixel& s, const Shown& shown, const Image& all) {
  Scene scene;
  std::vector<Cell> cells;
  for (const Traced& t : all.pixels) cells.push_back(cell_of(s.world, t));
  const Raster raster = viewing::picture(s.eye, std::move(cells), {0.25, 0, 0}, 5);
  std::vector<Vec3> pixel;
  for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
    pixel.push_back(on_picture(raster, s.eye, {s.column + x, s.row + y}));
  scene.axis = axis(s, shown);
  scene.items.emplace_back(raster);
  scene.items.emplace_back(Chain{pixel, true, Role::highlight, Pen::highlight});
  return scene;
}

}  // namespace isect::lessons::ray_tracing_lesson
