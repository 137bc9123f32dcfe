// The bodies that contain something: it is drawn as if they were not there.

#include <algorithm>
#include <type_traits>

#include <isect/sphere_sphere.h>
#include "viz/compose/visibility.h"

namespace isect::viz {

namespace {

// Whether the ball lies in the body, up to a rounding.
bool contains(const Shell& solid, const Vec3& center, double radius) {
  return !solid.inside.empty() && std::all_of(solid.inside.begin(), solid.inside.end(), [&](const Plane<double, 3>& p) {
    return p.normal.dot(center) + p.d >= radius - 2 * drawn_in * solid.size;
  });
}
bool contains(const Ball& ball, const Vec3& center, double radius) {
  return (center - ball.center).norm() + radius <= (1 + drawn_in) * ball.radius;
}
bool contains(const Capsule<double, 3>& capsule, const Vec3& center, double radius) {
  const Vec3 axis = capsule.q - capsule.p;
  const double along = axis.isZero(0) ? 0 : std::clamp(axis.dot(center - capsule.p) / axis.squaredNorm(), 0.0, 1.0);
  return (center - capsule.p - along * axis).norm() + radius <= (1 + drawn_in) * capsule.radius;
}

Vec3 middle_of_body(const Shell& solid) { return solid.middle; }
Vec3 middle_of_body(const Ball& ball) { return ball.center; }
Vec3 middle_of_body(const Capsule<double, 3>& capsule) { return (capsule.p + capsule.q) / 2; }
double reach_of_body(const Shell& solid) { return solid.size; }
double reach_of_body(const Ball& ball) { return ball.radius; }
double reach_of_body(const Capsule<double, 3>& capsule) { return (capsule.q - capsule.p).norm() / 2 + capsule.radius; }

double size_of(const Shell& solid) { return solid.size; }
double size_of(const Ball& ball) { return ball.radius; }
double size_of(const Capsule<double, 3>& capsule) { return capsule.radius; }

/// Returns all bodies except those that `holds`, and the solid and the capsule with these numbers; -1: none.
Occluders without(const Occluders& all, const auto& holds, int solid = -1, int capsule = -1) {
  Occluders left = {{}, {}, all.screens, {}};
  const auto keep = [&](const auto& bodies, int but, auto& to) {
    for (int i = 0; i < static_cast<int>(bodies.size()); ++i)
      if (i != but && !holds(bodies[i])) to.push_back(bodies[i]);
  };
  keep(all.balls, -1, left.balls), keep(all.solids, solid, left.solids);
  keep(all.capsules, capsule, left.capsules);
  return left;
}

}  // namespace

Occluders around_ball(const Occluders& all, int index, const View* view) {
  const Ball& own = all.balls[index];
  const auto holds = [&](const auto& body) {
    if (view && seen_apart(*view, own.center, own.radius, middle_of_body(body), reach_of_body(body))) return true;
    if constexpr (std::is_same_v<decltype(body), const Ball&>)  // an equal ball does not contain it
      return relate(Sphere<double, 3>{own.center, own.radius}, Sphere<double, 3>{body.center, body.radius}) ==
             Relation::a_inside_b;
    else
      return contains(body, own.center, own.radius);
  };
  return without(all, holds);
}

Occluders around_solid(const Occluders& all, int index, const std::vector<Vec3>& vertices, bool itself,
                       const View* view) {
  const Shell& own = all.solids[index];
  const auto holds = [&](const auto& body) {
    if (&body == static_cast<const void*>(&own)) return false;
    if (view && seen_apart(*view, own.middle, own.size, middle_of_body(body), reach_of_body(body))) return true;
    return std::ranges::all_of(vertices, [&](const Vec3& p) { return contains(body, p, 0); });
  };
  return without(all, holds, itself ? -1 : index);
}

Occluders around_capsule(const Occluders& all, int index, bool itself) {
  const Capsule<double, 3>& own = all.capsules[index];
  const auto holds = [&](const auto& body) {
    return &body != static_cast<const void*>(&own) && contains(body, own.p, own.radius) &&
           contains(body, own.q, own.radius);
  };
  return without(all, holds, -1, itself ? -1 : index);
}

std::optional<Occluders> around_contents(const Occluders& all, const std::vector<Vec3>& points) {
  constexpr double off = 0x1p-20;  // of the body's size
  const auto holds = [&](const auto& body) {
    return std::ranges::all_of(points, [&](const Vec3& p) { return contains(body, p, off * size_of(body)); });
  };
  if (std::ranges::none_of(all.balls, holds) && std::ranges::none_of(all.solids, holds) &&
      std::ranges::none_of(all.capsules, holds))
    return {};
  return without(all, holds);
}

}  // namespace isect::viz
