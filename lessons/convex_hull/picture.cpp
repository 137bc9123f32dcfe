#include "lessons/convex_hull/picture.h"

#include <algorithm>

#include <isect/fit.h>
#include <isect/fit_tight.h>
#include <isect/volume.h>
#include "lessons/shared/vertices.h"

namespace isect::lessons::convex_hull_lesson {

using namespace viz;

namespace {

void add_bounding(const Ring<double, 2>& points, Bounding what, Scene& scene) {
  if (what == Bounding::ball) {
    const Sphere<double, 2> ball = fit_sphere_smallest(points);
    scene.items.emplace_back(Circle{flat(ball.center), ball.radius, Role::second, Pen::solid, true});
  }
  if (what == Bounding::aabb) {
    const Aabb<double, 2> box = fit_aabb(points);
    scene.items.emplace_back(Region{{corners(box)}});
  }
  if (what == Bounding::obb) {
    const Obb<double, 2> box = fit_obb_tight(points);
    Ring<double, 2> corners;
    for (const auto& [i, j] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
      corners.push_back(box.center + i * box.half[0] * box.axes.col(0) + j * box.half[1] * box.axes.col(1));
    scene.items.emplace_back(Region{{flat(corners)}});
  }
}

}  // namespace

Scene picture(const Drawn& d) {
  Scene scene;
  add_bounding(d.points, d.bounding, scene);
  if (!d.hull.empty()) {
    Region hull;
    hull.rings = {flat(d.hull)}, hull.role = Role::first;
    scene.items.emplace_back(hull);
  }
  for (const Ring<double, 2>& chain : d.done)
    scene.items.emplace_back(Chain{flat(chain), false, Role::first, Pen::solid});
  if (d.chain.size() > 1) {
    scene.items.emplace_back(Chain{flat(d.chain), false, Role::first, Pen::solid});
    scene.items.emplace_back(
        Line{flat(d.chain[d.chain.size() - 2]), flat(d.chain.back()), Role::highlight, Pen::highlight});
  }
  for (const Point<double, 2>& p : d.removed)
    if (!d.chain.empty()) scene.items.emplace_back(Line{flat(p), flat(d.chain.back()), Role::miss, Pen::construction});

  const auto among = [](const Ring<double, 2>& ring, const Point<double, 2>& p) {
    return std::ranges::find(ring, p) != ring.end();
  };
  for (const Point<double, 2>& p : d.points) {
    const bool kept = among(d.hull, p) || among(d.chain, p) ||
                      std::ranges::any_of(d.done, [&](const Ring<double, 2>& c) { return among(c, p); });
    const bool gone = among(d.removed, p);
    scene.items.emplace_back(Dot{flat(p),
                                 gone   ? Mark::no
                                 : kept ? Mark::disc
                                        : Mark::ring,
                                 gone   ? Role::miss
                                 : kept ? Role::first
                                        : Role::text});
  }
  if (!d.chain.empty() && d.chain.back() != d.points.back())
    scene.items.emplace_back(Label{flat(d.chain.back()), "**q**", Role::first});
  const bool in_turn = !d.chain.empty() && d.chain.back() == d.points.back();
  scene.items.emplace_back(Label{flat(d.points.back()), in_turn ? "**q** = **p**" : "**p**", Role::first});
  scene.handles.push_back({"p", Handle::Kind::point, flat(d.points.back()), Vec3::Zero(), Role::first});
  add_handles(scene, "v", {d.points.begin(), d.points.end() - 1}, Role::text, "a point");
  return scene;
}

double area(const Ring<double, 2>& convex) {
  double twice = 0;
  for (std::size_t i = 2; i < convex.size(); ++i) {
    const Vector<double, 2> a = convex[i - 1] - convex[0], b = convex[i] - convex[0];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return twice / 2;
}

Measured measured(const Ring<double, 2>& points, Bounding what) {
  if (what == Bounding::ball) {
    const Sphere<double, 2> ball = fit_sphere_smallest(points);
    return {"against-ball", "smallest circle", numbers_kept(ball), volume(ball)};
  }
  if (what == Bounding::aabb) {
    const Aabb<double, 2> box = fit_aabb(points);
    return {"against-aabb", "AABB", numbers_kept(box), volume(box)};
  }
  const Obb<double, 2> box = fit_obb_tight(points);
  return {"against-obb", "smallest OBB", numbers_kept(box), volume(box)};
}

}  // namespace isect::lessons::convex_hull_lesson
