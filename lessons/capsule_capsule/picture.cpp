#include "lessons/capsule_capsule/picture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <isect/clip_polygon.h>
#include <isect/methods/capsule_capsule.h>
#include "lessons/shared/flat.h"
#include "lessons/shared/parameters.h"

namespace isect::lessons::capsule_capsule_lesson {

using namespace viz;

namespace {

constexpr int arc = 48;  ///< corners of the half-circle around an end

/// Counter-clockwise.
Ring<double, 2> outline(const Capsule2& c) {
  const Vec2 d = c.q - c.p;
  const double along = std::atan2(d.y(), d.x());
  Ring<double, 2> ring;
  for (int i = 0; i <= 2 * arc + 1; ++i) {
    const bool at_q = i <= arc;
    const double angle = along + std::numbers::pi * ((at_q ? i : i - 1) / double(arc) - 0.5);
    ring.push_back((at_q ? c.q : c.p) + c.radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  return ring;
}

/// What two convex outlines share.
Ring<double, 2> common(Ring<double, 2> ring, const Ring<double, 2>& other) {
  for (std::size_t i = 0; i < other.size() && !ring.empty(); ++i) {
    const Vec2 &p = other[i], &q = other[(i + 1) % other.size()];
    const Vec2 inwards(p.y() - q.y(), q.x() - p.x());
    if (p != q) ring = clip(ring, Plane<double, 2>{inwards, -inwards.dot(p)});
  }
  return ring;
}

void shape(Scene& scene, const Capsule2& c, Role role) {
  if (c.radius > 0) scene.items.push_back(Region{.rings = {flat(outline(c))}, .role = role});
}
void segment(Scene& scene, const Capsule2& c, Role role) {
  if (c.p != c.q) scene.items.push_back(Line{flat(c.p), flat(c.q), role, Pen::solid});
  scene.items.push_back(Dot{flat(c.p), Mark::disc, role});
  scene.items.push_back(Dot{flat(c.q), Mark::disc, role});
}

void names(Scene& scene, const Setup& s) {
  scene.items.push_back(Label{flat(s.a.p), "**p**_a", Role::first});
  scene.items.push_back(Label{flat(s.a.q), "**q**_a", Role::first});
  scene.items.push_back(Label{flat(s.b.p), "**p**_b", Role::second});
  scene.items.push_back(Label{flat(s.b.q), "**q**_b", Role::second});
}

/// Draws the radius from the middle of the segment to its left.
void radius(Scene& scene, const Capsule2& c, const char* name, Role role) {
  if (c.radius == 0) return;
  const Vec2 d = c.q - c.p, aside = d.norm() > 0 ? Vec2(Vec2(-d.y(), d.x()).normalized()) : Vec2(0, 1);
  const Vec2 middle = (c.p + c.q) / 2, rim = middle + c.radius * aside;
  scene.items.push_back(Line{flat(middle), flat(rim), role, Pen::thick});
  scene.items.push_back(Label{flat(middle), name, role, flat(rim)});
}

void ways(Scene& scene, const Setup& s, const std::vector<End>& ends, bool now) {
  for (const End& e : ends) {
    const auto [end, nearest] = s.way(e);
    if (end == nearest) continue;
    scene.items.push_back(Line{flat(end), flat(nearest), now ? Role::highlight : Role::construction,
                               now ? Pen::highlight : Pen::construction});
    if (now) scene.items.push_back(Dot{flat(nearest), Mark::ring, Role::highlight});
  }
}

void shortest(Scene& scene, const Setup& s) {
  const auto [on_a, on_b] = s.closest();
  if ((on_a - on_b).norm() < 1e-9) return;  // rounding at a crossing
  scene.items.push_back(Line{flat(on_a), flat(on_b), Role::construction, Pen::construction});
  if (s.truth == Relation::disjoint) scene.items.push_back(Label{flat(on_a), "*d*", Role::text, flat(on_b)});
}

/// The common points of surfaces that touch: one, or the stretch between two.
void contact(Scene& scene, const Setup& s, const std::vector<End>& ends) {
  Ring<double, 2> points;
  for (const End& e : ends) {
    const auto [end, nearest] = s.way(e);
    const double own = (e.end < 2 ? s.a : s.b).radius, sum = s.a.radius + s.b.radius;
    if (e.sign == 0) points.push_back(sum > 0 ? Vec2(end + own / sum * (nearest - end)) : end);
  }
  if (points.empty()) return;
  Vec2 far = points[0];
  for (const Vec2& p : points)
    if ((p - points[0]).norm() > (far - points[0]).norm()) far = p;
  const bool one = (far - points[0]).norm() < 1e-9;
  scene.items.push_back(one ? Item(Dot{flat(far), Mark::disc, Role::hit})
                            : Item(Line{flat(points[0]), flat(far), Role::hit, Pen::thick}));
}

Vec2 farthest_from(const Vec2& from, const Ring<double, 2>& points) {
  return *std::ranges::max_element(points, {}, [&](const Vec2& p) { return (p - from).norm(); });
}

/// The stretch that a segment shares with a capsule, or two segments on one line with each other.
void stretch(Scene& scene, const Setup& s, const std::vector<End>& ends) {
  if (s.segments()) return contact(scene, s, ends);
  const Capsule2 &thin = s.a.radius == 0 ? s.a : s.b, &thick = s.a.radius == 0 ? s.b : s.a;
  const Ring<double, 2> both = common(outline(thin), outline(thick));
  if (both.empty()) return;
  const Vec2 one = farthest_from(both[0], both), other = farthest_from(one, both);
  scene.items.push_back(Line{flat(one), flat(other), Role::hit, Pen::thick});
}

}  // namespace

std::pair<Vec2, Vec2> Setup::closest() const {
  Record<capsule_capsule::MethodEvent<double, 2>> record;
  capsule_capsule::clamped(a, b, record);
  const auto& found = std::get<capsule_capsule::Closest<double, 2>>(record.events.at(1));
  return {found.on_a, found.on_b};
}

std::pair<Vec2, Vec2> Setup::way(const End& e) const {
  const Capsule2 &own = e.end < 2 ? a : b, &other = e.end < 2 ? b : a;
  const Vec2 end = e.end % 2 == 0 ? own.p : own.q;
  if (e.nearest != capsule_capsule::Nearest::between)
    return {end, e.nearest == capsule_capsule::Nearest::p ? other.p : other.q};
  const Vec2 d = other.q - other.p;
  return {end, other.p + (end - other.p).dot(d) / d.squaredNorm() * d};
}

Setup setup(const Parameters& p) {
  Setup s = {{flat_point(p, "p_a"), flat_point(p, "q_a"), std::get<double>(p.at("r_a"))},
             {flat_point(p, "p_b"), flat_point(p, "q_b"), std::get<double>(p.at("r_b"))},
             {}};
  s.truth = relate(s.a, s.b);
  return s;
}

Scene picture(const Setup& s, const Shown& shown) {
  Scene scene;
  shape(scene, s.a, Role::first), shape(scene, s.b, Role::second);
  const bool overlap = shown.settled && s.truth == Relation::overlapping;
  if (overlap && !s.thin()) {  // of one inside the other it would cover the names
    const Ring<double, 2> both = common(outline(s.a), outline(s.b));
    if (both.size() > 2) scene.items.push_back(Region{.rings = {flat(both)}, .role = Role::hit});
  }
  segment(scene, s.a, Role::first), segment(scene, s.b, Role::second);
  if (shown.radii) radius(scene, s.a, "*r*_a", Role::first), radius(scene, s.b, "*r*_b", Role::second);
  if (!shown.settled) ways(scene, s, shown.earlier, false), ways(scene, s, shown.ways, true);
  if (shown.settled) shortest(scene, s);
  if (overlap && s.thin() && !(s.segments() && shown.crossing)) stretch(scene, s, shown.earlier);
  if (shown.crossing) scene.items.push_back(Dot{flat(s.closest().first), Mark::disc, Role::hit});
  if (shown.settled && s.truth == Relation::touching && !shown.crossing) contact(scene, s, shown.earlier);
  names(scene, s);

  const auto rim = [](const Capsule2& c) {
    const Vec2 d = c.p - c.q;
    return flat(c.p + c.radius * (d.norm() > 0 ? Vec2(d.normalized()) : Vec2(-1, 0)));
  };
  scene.handles = {{"p_a", Handle::Kind::point, flat(s.a.p), Vec3::Zero(), Role::first},
                   {"q_a", Handle::Kind::point, flat(s.a.q), Vec3::Zero(), Role::first},
                   {"r_a", Handle::Kind::length, rim(s.a), flat(s.a.p), Role::first},
                   {"p_b", Handle::Kind::point, flat(s.b.p), Vec3::Zero(), Role::second},
                   {"q_b", Handle::Kind::point, flat(s.b.q), Vec3::Zero(), Role::second},
                   {"r_b", Handle::Kind::length, rim(s.b), flat(s.b.p), Role::second}};
  return scene;
}

}  // namespace isect::lessons::capsule_capsule_lesson
