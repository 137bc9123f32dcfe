#include "app/scene/walks.h"

#include <fmt/format.h>

#include <algorithm>

#include "lessons/lessons.h"
#include "viz/place.h"

namespace isect::program::scene {

namespace {

using viz::Parameters;

struct Walked {
  WalkOfPair pair;
  bool flat;  ///< the lesson's scenes, and so those that it takes
};

const std::vector<Walked>& all() {
  using enum Type;
  static const auto along = [](const Setting& s, const Object& a, const Object& b) {
    const bool segment = a.type == Type::segment;
    const viz::Vec3 origin = s.point(a, segment ? "from" : "origin");
    Parameters p = {{"method", "quadratic"},
                    {"origin", origin},
                    {"direction", segment ? viz::Vec3(s.point(a, "to") - origin) : s.point(a, "dir")},
                    {"center", s.point(b, "center")},
                    {"radius", s.number(b, "radius")}};
    if (s.has(a, "tmin") && s.number(a, "tmin") != 0)
      throw viz::BadInput(a.name + ": the lesson’s rays begin at t = 0");
    if (segment || s.has(a, "tmax")) p["extent"] = "segment", p["t_max"] = segment ? 1.0 : s.number(a, "tmax");
    return p;
  };
  static const std::vector<Walked> table = {{{sphere, sphere, "sphere-sphere",
                                              [](const Setting& s, const Object& a, const Object& b) {
                                                return Parameters{{"a", s.point(a, "center")},
                                                                  {"r1", s.number(a, "radius")},
                                                                  {"b", s.point(b, "center")},
                                                                  {"r2", s.number(b, "radius")}};
                                              },
                                              "a", "b"},
                                             false},
                                            {{box, box, "aabb-aabb",
                                              [](const Setting& s, const Object& a, const Object& b) {
                                                return Parameters{{"a_min", s.point(a, "lo")},
                                                                  {"a_max", s.point(a, "hi")},
                                                                  {"b_min", s.point(b, "lo")},
                                                                  {"b_max", s.point(b, "hi")}};
                                              },
                                              "a", "b"},
                                             false},
                                            {{sphere, box, "sphere-aabb",
                                              [](const Setting& s, const Object& a, const Object& b) {
                                                return Parameters{{"c", s.point(a, "center")},
                                                                  {"r", s.number(a, "radius")},
                                                                  {"b_min", s.point(b, "lo")},
                                                                  {"b_max", s.point(b, "hi")}};
                                              },
                                              "the ball", "the box"},
                                             false},
                                            {{ray, sphere, "ray-sphere", along, "the ray", "the ball"}, false},
                                            {{segment, sphere, "ray-sphere", along, "the segment", "the ball"}, false},
                                            {{capsule, capsule, "capsule-capsule",
                                              [](const Setting& s, const Object& a, const Object& b) {
                                                return Parameters{{"p_a", s.point(a, "p")},  {"q_a", s.point(a, "q")},
                                                                  {"r_a", s.number(a, "r")}, {"p_b", s.point(b, "p")},
                                                                  {"q_b", s.point(b, "q")},  {"r_b", s.number(b, "r")}};
                                              },
                                              "a", "b"},
                                             true}};
  return table;
}

}  // namespace

const WalkOfPair* walk_of(Type a, Type b, bool flat) {
  const auto found =
      std::ranges::find_if(all(), [&](const Walked& w) { return w.pair.a == a && w.pair.b == b && w.flat == flat; });
  return found == all().end() ? nullptr : &found->pair;
}

std::vector<std::string> walks_in_words(bool flat) {
  std::vector<std::string> words;
  for (const Walked& w : all())
    if (w.flat == flat) words.push_back(fmt::format("{} and {}", spec(w.pair.a).name, spec(w.pair.b).name));
  return words;
}

viz::Walk walk(const WalkOfPair& pair, const Setting& s, const Object& a, const Object& b) {
  const viz::Lesson& lesson = viz::lesson_named(lessons::all_lessons(), pair.lesson);
  try {
    Parameters given = lesson.presets.front().parameters;
    for (const auto& [name, setting] : pair.parameters(s, a, b)) given.at(name) = setting;
    viz::validate(lesson, given);
    return lesson.steps(given);
  } catch (const viz::BadInput& e) {
    throw viz::BadInput(fmt::format("{} and {}, in the lesson {}: {}", a.name, b.name, pair.lesson, e.what()));
  }
}

}  // namespace isect::program::scene
