#include "app/scene/walks.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/scene/pairs.h"
#include "app/scene/shapes.h"
#include "lessons/clipping/picture.h"
#include "lessons/lessons.h"
#include "lessons/obb_obb/telling.h"
#include "lessons/ray_polygon/telling.h"
#include "viz/place.h"

namespace isect::program::scene {

namespace {

using viz::Parameters;
using viz::Vec3;
using Walk = viz::Walk (*)(const Setting&, const Object& a, const Object& b);

/// Of a lesson whose parameters say all of its objects.
viz::Walk of_lesson(const char* id, const Parameters& parameters) {
  const viz::Lesson& lesson = viz::lesson_named(lessons::all_lessons(), id);
  Parameters all = lesson.presets.front().parameters;
  for (const auto& [name, setting] : parameters) all.insert_or_assign(name, setting);
  viz::validate(lesson, all);
  return lesson.steps(all);
}

constexpr Walk balls = [](const Setting& s, const Object& a, const Object& b) {
  return of_lesson("sphere-sphere", {{"a", s.point(a, "center")},
                                     {"r1", s.number(a, "radius")},
                                     {"b", s.point(b, "center")},
                                     {"r2", s.number(b, "radius")}});
};

constexpr Walk boxes = [](const Setting& s, const Object& a, const Object& b) {
  return of_lesson("aabb-aabb", {{"a_min", s.point(a, "lo")},
                                 {"a_max", s.point(a, "hi")},
                                 {"b_min", s.point(b, "lo")},
                                 {"b_max", s.point(b, "hi")}});
};

constexpr Walk ball_and_box = [](const Setting& s, const Object& a, const Object& b) {
  return of_lesson("sphere-aabb", {{"c", s.point(a, "center")},
                                   {"r", s.number(a, "radius")},
                                   {"b_min", s.point(b, "lo")},
                                   {"b_max", s.point(b, "hi")}});
};

constexpr Walk capsules = [](const Setting& s, const Object& a, const Object& b) {
  return of_lesson("capsule-capsule", {{"p_a", s.point(a, "p")},
                                       {"q_a", s.point(a, "q")},
                                       {"r_a", s.number(a, "r")},
                                       {"p_b", s.point(b, "p")},
                                       {"q_b", s.point(b, "q")},
                                       {"r_b", s.number(b, "r")}});
};

constexpr Walk ray_and_ball = [](const Setting& s, const Object& a, const Object& b) {
  if (s.has(a, "tmin") && s.number(a, "tmin") != 0) throw viz::BadInput("the lesson’s rays begin at t = 0");
  const bool segment = a.type == Type::segment, ends = segment || s.has(a, "tmax");
  const Vec3 origin = s.point(a, segment ? "from" : "origin");
  return of_lesson("ray-sphere", {{"method", "quadratic"},
                                  {"extent", ends ? "segment" : "ray"},
                                  {"t_max", segment ? 1.0
                                            : ends  ? s.number(a, "tmax")
                                                    : 1.0},
                                  {"origin", origin},
                                  {"direction", direction_of(s, a)},
                                  {"center", s.point(b, "center")},
                                  {"radius", s.number(b, "radius")}});
};

// Of lessons that walk through any shapes.

constexpr Walk oriented_boxes = [](const Setting& s, const Object& a, const Object& b) {
  lessons::obb_obb_lesson::Setup setup;
  setup.a = obb_of<3>(s, a), setup.b = obb_of<3>(s, b);
  setup.a_u = s.point(a, "u"), setup.b_u = s.point(b, "u");
  setup.epsilon = 1e-9;
  setup.truth = relate(setup.a, setup.b);
  return lessons::obb_obb_lesson::Teller(setup).tell();
};

constexpr Walk ray_and_polygon = [](const Setting& s, const Object& a, const Object& b) {
  if (s.has(a, "tmin") || s.has(a, "tmax")) throw viz::BadInput("the lesson’s rays begin at t = 0 and have no end");
  lessons::ray_polygon_lesson::Setup setup;
  setup.ray = {s.point(a, "origin"), s.point(a, "dir")};
  setup.ring = s.rings(b).front();
  setup.truth = intersect(setup.ray, setup.ring);
  Vec3 normal = Vec3::Zero();  // what spans the plane is only drawn
  for (std::size_t i = 2; i < setup.ring.size(); ++i)
    normal += (setup.ring[i - 1] - setup.ring[0]).cross(setup.ring[i] - setup.ring[0]);
  if (normal.isZero(0)) throw viz::BadInput(b.name + " has no area");
  const Vec3 side = setup.ring[1] - setup.ring[0];
  const double reach = 0.5 * std::sqrt(normal.norm());
  setup.across = reach * side.stableNormalized();
  setup.up = reach * normal.cross(side).stableNormalized();
  return lessons::ray_polygon_lesson::tell(setup);
};

constexpr Walk clipped_segment = [](const Setting& s, const Object& a, const Object& b) {
  const Segment<double, 2> segment = {point_of<2>(s.point(a, "from")), point_of<2>(s.point(a, "to"))};
  return lessons::clipping_lesson::clip_a_segment(segment, box_of<2>(s, b));
};

constexpr Walk clipped_polygon = [](const Setting& s, const Object& a, const Object& b) {
  return lessons::clipping_lesson::clip_a_polygon(points_of<2>(s.rings(a).front()), box_of<2>(s, b));
};

const std::vector<WalkOfPair>& all() {
  using enum Type;
  static const std::vector<WalkOfPair> table = {
      {sphere, sphere, false, "a", "b", balls},
      {box, box, false, "a", "b", boxes},
      {sphere, box, false, "the ball", "the box", ball_and_box},
      {ray, sphere, false, "the ray", "the ball", ray_and_ball},
      {segment, sphere, false, "the segment", "the ball", ray_and_ball},
      {obb, obb, false, "a", "b", oriented_boxes},
      {ray, polygon, false, "the ray", "the polygon", ray_and_polygon},
      {ray, triangle, false, "the ray", "the polygon", ray_and_polygon},
      {capsule, capsule, true, "a", "b", capsules},
      {segment, box, true, "the segment", "the box", clipped_segment},
      {polygon, box, true, "the polygon", "the box", clipped_polygon},
      {triangle, box, true, "the polygon", "the box", clipped_polygon},
  };
  return table;
}

}  // namespace

const WalkOfPair* walk_of(Type a, Type b, bool flat) {
  const auto found =
      std::ranges::find_if(all(), [&](const WalkOfPair& w) { return w.a == a && w.b == b && w.flat == flat; });
  return found == all().end() ? nullptr : &*found;
}

std::vector<std::string> walks_in_words(bool flat) {
  std::vector<std::string> words;
  for (const WalkOfPair& w : all())
    if (w.flat == flat) words.push_back(fmt::format("{} and {}", spec(w.a).name, spec(w.b).name));
  return words;
}

viz::Walk walk(const WalkOfPair& pair, const Setting& s, const Object& a, const Object& b) {
  try {
    return pair.steps(s, a, b);
  } catch (const viz::BadInput& e) {
    throw viz::BadInput(fmt::format("{} and {}, step by step: {}", a.name, b.name, e.what()));
  }
}

}  // namespace isect::program::scene
