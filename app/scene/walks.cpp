#include "app/scene/walks.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <iterator>
#include <string_view>

#include <isect/convex_hull.h>
#include <isect/polygon.h>
#include <isect/polygon_triangles.h>
#include "app/scene/pairs.h"
#include "app/scene/shapes.h"
#include "app/scene/types.h"
#include "lessons/clipping/picture.h"
#include "lessons/collision/telling.h"
#include "lessons/concave_polygon/picture.h"
#include "lessons/convex_hull/picture.h"
#include "lessons/convex_polygon/picture.h"
#include "lessons/crossings/telling.h"
#include "lessons/culling/picture.h"
#include "lessons/hierarchy/tree.h"
#include "lessons/lessons.h"
#include "lessons/obb_obb/telling.h"
#include "lessons/ray_polygon/telling.h"
#include "viz/lang/message.h"
#include "viz/player/reader_state.h"

namespace isect::program::scene {

namespace {

using viz::Parameters;
using viz::Vec3;
using Walk = viz::Walk (*)(const NamedValues&, const Object& a, const Object& b);

/// Walks through a lesson whose parameters define all of its objects.
viz::Walk of_lesson(const char* id, const Parameters& parameters) {
  const viz::Lesson& lesson = viz::lesson_named(lessons::all_lessons(), id);
  Parameters all = lesson.presets.front().parameters;
  for (const auto& [name, setting] : parameters) all.insert_or_assign(name, setting);
  viz::validate(lesson, all);
  return lesson.steps(all);
}

constexpr Walk two_points = [](const NamedValues& s, const Object& a, const Object& b) {
  return of_lesson("points", {{"question", "equal"}, {"p", s.point(a, "at")}, {"q", s.point(b, "at")}});
};

constexpr Walk balls = [](const NamedValues& s, const Object& a, const Object& b) {
  return of_lesson("sphere-sphere", {{"a", s.point(a, "center")},
                                     {"r_a", s.number(a, "radius")},
                                     {"b", s.point(b, "center")},
                                     {"r_b", s.number(b, "radius")}});
};

constexpr Walk boxes = [](const NamedValues& s, const Object& a, const Object& b) {
  return of_lesson("aabb-aabb", {{"a_min", s.point(a, "lo")},
                                 {"a_max", s.point(a, "hi")},
                                 {"b_min", s.point(b, "lo")},
                                 {"b_max", s.point(b, "hi")}});
};

constexpr Walk ball_and_box = [](const NamedValues& s, const Object& a, const Object& b) {
  return of_lesson("sphere-aabb", {{"c", s.point(a, "center")},
                                   {"r", s.number(a, "radius")},
                                   {"b_min", s.point(b, "lo")},
                                   {"b_max", s.point(b, "hi")}});
};

constexpr Walk capsules = [](const NamedValues& s, const Object& a, const Object& b) {
  return of_lesson("capsule-capsule", {{"p_a", s.point(a, "p")},
                                       {"q_a", s.point(a, "q")},
                                       {"r_a", s.number(a, "r")},
                                       {"p_b", s.point(b, "p")},
                                       {"q_b", s.point(b, "q")},
                                       {"r_b", s.number(b, "r")}});
};

constexpr Walk ray_and_ball = [](const NamedValues& s, const Object& a, const Object& b) {
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

// Walks of lessons that take any shapes.

constexpr Walk oriented_boxes = [](const NamedValues& s, const Object& a, const Object& b) {
  lessons::obb_obb_lesson::Setup setup;
  setup.a = made<Obb<double, 3>>(s, a), setup.b = made<Obb<double, 3>>(s, b);
  setup.a_u = s.point(a, "u"), setup.b_u = s.point(b, "u");
  setup.epsilon = 1e-9;
  setup.truth = relate(setup.a, setup.b);
  viz::Walk walk = lessons::obb_obb_lesson::Teller(setup).tell();
  walk.steps.front().caption += " The classical test adds *ε* = 10^{−9}.";
  return walk;
};

constexpr Walk ray_and_polygon = [](const NamedValues& s, const Object& a, const Object& b) {
  if (s.has(a, "tmin") || s.has(a, "tmax")) throw viz::BadInput("the lesson’s rays begin at t = 0 and have no end");
  lessons::ray_polygon_lesson::Setup setup;
  setup.ray = {s.point(a, "origin"), s.point(a, "dir")};
  setup.ring = s.rings(b).front();
  setup.truth = intersect(setup.ray, setup.ring);
  Vec3 normal = Vec3::Zero();  // the vectors that span the plane are only drawn
  for (std::size_t i = 2; i < setup.ring.size(); ++i)
    normal += (setup.ring[i - 1] - setup.ring[0]).cross(setup.ring[i] - setup.ring[0]);
  if (normal.isZero(0)) throw viz::BadInput(b.name + " has no area");
  const Vec3 side = setup.ring[1] - setup.ring[0];
  const double reach = 0.5 * std::sqrt(normal.norm());
  setup.across = reach * side.stableNormalized();
  setup.up = reach * normal.cross(side).stableNormalized();
  for (const Vec3& v : setup.ring) setup.center += v / static_cast<double>(setup.ring.size());
  return lessons::ray_polygon_lesson::tell(setup);
};

constexpr Walk clipped_segment = [](const NamedValues& s, const Object& a, const Object& b) {
  const Segment<double, 2> segment = {point_of<2>(s.point(a, "from")), point_of<2>(s.point(a, "to"))};
  return lessons::clipping_lesson::clip_a_segment(segment, made<Aabb<double, 2>>(s, b));
};

constexpr Walk clipped_polygon = [](const NamedValues& s, const Object& a, const Object& b) {
  if (s.rings(a).size() > 1) throw viz::BadInput(a.name + " has holes, and the lesson clips one outline");
  return lessons::clipping_lesson::clip_a_polygon(points_of<2>(s.rings(a).front()), made<Aabb<double, 2>>(s, b));
};

constexpr Walk culled_box = [](const NamedValues& s, const Object& a, const Object& b) {
  return lessons::culling_lesson::one_volume(frustum_of(s, a), s.point(a, "eye"), made<Aabb<double, 3>>(s, b));
};

constexpr Walk culled_ball = [](const NamedValues& s, const Object& a, const Object& b) {
  return lessons::culling_lesson::one_volume(frustum_of(s, a), s.point(a, "eye"), made<Sphere<double, 3>>(s, b));
};

/// Throws viz::BadInput if there are too many points: the lesson has a step or more for each.
template <class Points>
void need_few(const Object& o, const Points& points, std::size_t most = 100) {
  if (points.size() > most)
    throw viz::BadInput(fmt::format("{} has {} points, and the lesson has a step or more for each: {} are the most",
                                    o.name, points.size(), most));
}

constexpr Walk point_by_crossings = [](const NamedValues& s, const Object& a, const Object& b) {
  need_few(b, s.points(b));
  Polygon<double, 2> polygon;
  for (const auto& ring : s.rings(b)) polygon.rings.push_back(points_of<2>(ring));
  return lessons::crossings_lesson::half_open({point_of<2>(s.point(a, "at")), polygon});
};

constexpr Walk point_in_convex_polygon = [](const NamedValues& s, const Object& a, const Object& b) {
  Ring<double, 2> ring = points_of<2>(s.rings(b).front());
  const Ring<double, 2> hull = convex_hull(ring);
  for (int way = 0; way < 2; ++way) {
    const auto first = hull.empty() ? ring.end() : std::ranges::find(ring, hull.front());
    Ring<double, 2> turned = ring;
    std::rotate(turned.begin(), turned.begin() + (first - ring.begin()), turned.end());
    if (s.rings(b).size() == 1 && hull.size() >= 3 && turned == hull)
      return lessons::convex_polygon_lesson::fan({ConvexPolygon<double>{ring}, point_of<2>(s.point(a, "at"))});
    std::ranges::reverse(ring);
  }
  throw viz::BadInput(b.name + " is not convex, or three of its corners lie on one line");
};

/// Limits the corners, as what is stored for each corner is drawn beside the polygon.
constexpr Walk point_in_concave_polygon = [](const NamedValues& s, const Object& a, const Object& b) {
  need_few(b, s.points(b), 24);
  Ring<double, 2> ring = points_of<2>(s.rings(b).front());
  if (s.rings(b).size() > 1) throw viz::BadInput(b.name + " has holes, and the lesson prepares one outline");
  if (!is_simple(ring)) throw viz::BadInput("edges of " + b.name + " cross or touch, or it has no area");
  if (area(ring) < 0) std::ranges::reverse(ring);
  return lessons::concave_polygon_lesson::slabs({ring, point_of<2>(s.point(a, "at"))});
};

/// The most boxes of a walk that tells of all their pairs.
constexpr std::size_t most_boxes = 12;

template <viz::Walk (*Way)(const lessons::collision_lesson::Boxes&, const lessons::collision_lesson::Frame&)>
viz::Walk colliding(const NamedValues& s, const std::vector<const Object*>& all) {
  if (all.size() > most_boxes)
    throw viz::BadInput(fmt::format("they are {}, and the lesson tells of their pairs one by one: {} are the most",
                                    all.size(), most_boxes));
  lessons::collision_lesson::Boxes of_all;
  for (const Object* o : all) of_all.push_back(made<Aabb<double, 2>>(s, *o));
  return Way(of_all, lessons::collision_lesson::frame_of(of_all));
}

lessons::hierarchy_lesson::Boxes for_hierarchy(const NamedValues& s, const std::vector<const Object*>& some) {
  if (some.size() > most_boxes)
    throw viz::BadInput(
        fmt::format("they are {}, and the lesson draws their tree: {} are the most", some.size(), most_boxes));
  lessons::hierarchy_lesson::Boxes all;
  for (const Object* o : some) all.push_back(made<Aabb<double, 2>>(s, *o));
  const auto point = [&](const auto& box) { return box.lo == all[0].lo && box.hi == all[0].lo; };
  if (std::ranges::all_of(all, point)) throw viz::BadInput("all of them are one point");
  return all;
}

viz::Walk built(const NamedValues& s, const std::vector<const Object*>& all) {
  return lessons::hierarchy_lesson::build(for_hierarchy(s, all));
}

viz::Walk asked_by_ray(const NamedValues& s, const std::vector<const Object*>& all) {
  const Object& ray = *all.back();
  if (s.has(ray, "tmin") || s.has(ray, "tmax")) throw viz::BadInput("the lesson’s rays begin at t = 0 and have no end");
  return lessons::hierarchy_lesson::ray(for_hierarchy(s, {all.begin(), all.end() - 1}),
                                        {point_of<2>(s.point(ray, "origin")), point_of<2>(s.point(ray, "dir"))});
}

constexpr Walk hull_of_points = [](const NamedValues& s, const Object& a, const Object&) {
  const std::vector<Vec3> points = s.points(a);
  need_few(a, points);
  return lessons::convex_hull_lesson::tell(points_of<2>(points));
};

}  // namespace

const std::vector<LessonWalk>& walks() {
  using enum Type;
  static const std::vector<LessonWalk> table = {
      {"points", point, point, false, "**p**", "**q**", two_points},
      {"sphere-sphere", sphere, sphere, false, "a", "b", balls},
      {"aabb-aabb", box, box, false, "a", "b", boxes},
      {"sphere-aabb", sphere, box, false, "the ball", "the box", ball_and_box},
      {"ray-sphere", ray, sphere, false, "the ray", "the ball", ray_and_ball},
      {"ray-sphere", segment, sphere, false, "the segment", "the ball", ray_and_ball},
      {"obb-obb", obb, obb, false, "a", "b", oriented_boxes},
      {"ray-polygon", ray, polygon, false, "the ray", "the polygon", ray_and_polygon},
      {"ray-polygon", ray, triangle, false, "the ray", "the polygon", ray_and_polygon},
      {"culling", frustum, box, false, "the view frustum", "the box", culled_box},
      {"culling", frustum, sphere, false, "the view frustum", "the ball", culled_ball},
      {"capsule-capsule", capsule, capsule, true, "a", "b", capsules},
      {"clipping", segment, box, true, "the segment", "the box", clipped_segment},
      {"clipping", polygon, box, true, "the polygon", "the box", clipped_polygon},
      {"clipping", triangle, box, true, "the polygon", "the box", clipped_polygon},
      {"crossings", point, polygon, true, "**p**", "the polygon", point_by_crossings},
      {"crossings", point, triangle, true, "**p**", "the polygon", point_by_crossings},
      {"convex-polygon", point, polygon, true, "**p**", "the polygon", point_in_convex_polygon},
      {"convex-polygon", point, triangle, true, "**p**", "the polygon", point_in_convex_polygon},
      {"concave-polygon", point, polygon, true, "**p**", "the polygon", point_in_concave_polygon},
      {"concave-polygon", point, triangle, true, "**p**", "the polygon", point_in_concave_polygon},
      {"collision", box, box, true, "boxes", nullptr, nullptr, colliding<lessons::collision_lesson::double_loop>,
       "brute-force"},
      {"collision", box, box, true, "boxes", nullptr, nullptr, colliding<lessons::collision_lesson::sweep>, "sweep"},
      {"collision", box, box, true, "boxes", nullptr, nullptr, colliding<lessons::collision_lesson::hierarchy>,
       "hierarchy"},
      {"hierarchy", box, box, true, "boxes", nullptr, nullptr, built, "build"},
      {"hierarchy", box, box, true, "boxes", nullptr, nullptr, asked_by_ray, "ray", true},
      {"convex-hull", hull, hull, true, "the points", nullptr, hull_of_points},
      {"convex-hull", cloud, cloud, true, "the points", nullptr, hull_of_points},
  };
  return table;
}

const LessonWalk* walk_of(Type a, Type b, bool flat, bool one, const std::string& lesson) {
  const auto found = std::ranges::find_if(
      walks(), [&](const LessonWalk& w) { return w.takes(a, b, flat, one) && (lesson.empty() || lesson == w.lesson); });
  return found == walks().end() ? nullptr : &*found;
}

const LessonWalk* walk_of_many(const std::string& lesson, const std::string& method) {
  const auto found = std::ranges::find_if(walks(), [&](const LessonWalk& w) {
    return w.of_many() && lesson == w.lesson && (method.empty() || method == w.method);
  });
  return found == walks().end() ? nullptr : &*found;
}

std::vector<std::string> methods_for_many(const std::string& lesson) {
  std::vector<std::string> all;
  for (const LessonWalk& w : walks())
    if (w.of_many() && lesson == w.lesson) all.emplace_back(w.method);
  return all;
}

std::vector<std::string> walks_in_words(bool flat) {
  std::vector<std::string> words;
  for (const LessonWalk& w : walks()) {
    const std::string told = w.of_many()  ? fmt::format("2 to {} {} ({})", most_boxes, w.name_a, w.lesson)
                             : w.of_one() ? std::string(spec(w.a).name)
                                          : fmt::format("{} and {}", spec(w.a).name, spec(w.b).name);
    if (w.flat == flat && std::ranges::find(words, told) == words.end()) words.push_back(told);
  }
  return words;
}

std::vector<std::string> walking_lessons() {
  std::vector<std::string> all;
  for (const LessonWalk& w : walks())
    if (std::ranges::find(all, w.lesson) == all.end()) all.emplace_back(w.lesson);
  return all;
}

std::string name_in_lesson(const char* name) {
  using viz::message_as;
  static constexpr viz::Message words[] = {
      message_as("here A is", "the ball"),         message_as("here A is", "the box"),
      message_as("here A is", "the ray"),          message_as("here A is", "the segment"),
      message_as("here A is", "the polygon"),      message_as("here A is", "the points"),
      message_as("here A is", "the view frustum"),
  };
  const auto* const found = std::ranges::find(words, std::string_view(name), &viz::Message::english);
  return found == std::end(words) ? name : tr(*found);  // a letter is the same in all languages
}

viz::Walk walk(const LessonWalk& pair, const NamedValues& s, const Object& a, const Object& b) {
  try {
    return pair.steps(s, a, b);
  } catch (const viz::BadInput& e) {
    const std::string names = pair.of_one() ? a.name : a.name + " and " + b.name;
    throw viz::BadInput(fmt::format("{}, step by step: {}", names, e.what()));
  }
}

viz::Walk walk(const LessonWalk& way, const NamedValues& s, const std::vector<const Object*>& all) {
  try {
    return way.steps_of_many(s, all);
  } catch (const viz::BadInput& e) {
    throw viz::BadInput(fmt::format("{}, step by step: {}", way.name_a, e.what()));
  }
}

}  // namespace isect::program::scene
