// Moving bodies (N16, N25; the note has no two that move): subtract velocities, and one body moves.
//
// What is true stands in moving_bodies/setup, the picture in moving_bodies/picture, what the walks share in
// moving_bodies/telling, and each walk in a file of its own: boxes, balls, discrete, conservative.

#include "lessons/course.h"
#include "lessons/moving_bodies/telling.h"
#include "lessons/shared/parameters.h"

namespace isect::lessons::moving_bodies_lesson {
namespace {

using namespace viz;

struct Situation {
  const char* id;
  const char* title;
  const char* method;
  Vec2 a, b, v_a, v_b;
  double duration = 2, r_a = 0.75, r_b = 0.5;
  double tolerance = 0.01;
  const char* bound = "speed";
};

const Situation situations[] = {
    {"boxes-meet", "they meet", "boxes", {-2.25, -0.5}, {2.25, 1.25}, {1, 0.5}, {-1, -0.5}},
    {"head-on", "head-on", "boxes", {-2.25, -0.5}, {2.25, -0.25}, {1, 0}, {-1, 0}},
    {"pass", "they pass", "boxes", {-2.25, -1}, {0.75, 1.5}, {1, 0.25}, {-1, -0.25}, 3},
    {"slide", "sliding along", "boxes", {-2.25, -0.5}, {1.75, 0.75}, {1, 0.25}, {-1, 0.25}},
    {"at-rest", "no relative motion", "boxes", {-2.25, -0.5}, {0.75, 0.5}, {1, 0.5}, {1, 0.5}},
    {"overlapping", "overlapping at first", "boxes", {-0.5, -0.5}, {0.5, 0.25}, {-0.5, -0.5}, {0.5, 0.5}},
    {"touching", "touching, moving apart", "boxes", {-0.75, -0.25}, {0.5, 0.25}, {-1, 0}, {1, 0.5}},
    {"late", "too late", "boxes", {-2.25, -0.5}, {2.75, 0}, {1, 0.125}, {-1, -0.125}, 1.5},
    {"fast",
     "fast, rounded",
     "boxes",
     {-1.1, -0.4},
     {4.16, 0.72},
     {500000.1, 300000.1},
     {-899999.9, -499999.9},
     4e-6,
     0.7},

    {"balls-meet", "they meet", "balls", {-2, -0.5}, {1.75, 0.5}, {1, 0.25}, {-1, 0.25}},
    {"balls-head-on", "head-on", "balls", {-2.25, 0}, {2, 0}, {1, 0}, {-1, 0}},
    {"graze", "grazing", "balls", {-1.75, -0.5}, {1.25, 0.75}, {1, 0.25}, {-1, 0.25}},
    {"balls-pass", "they pass", "balls", {-1.75, -0.75}, {1.25, 0.75}, {1, 0}, {-1, 0}},
    {"balls-overlapping", "overlapping at first", "balls", {-0.25, 0}, {0.25, 0.25}, {-1, 0}, {1, 0.5}},
    {"balls-touching", "touching, moving apart", "balls", {-0.5, -0.5}, {0.25, 0.5}, {-1, -0.25}, {0.5, 0.25}},
    {"balls-apart", "moving apart", "balls", {-1, -0.5}, {1, 0.5}, {-0.5, 0}, {0.5, 0.25}},
    {"balls-late", "too late", "balls", {-2.25, -0.25}, {2, 0.25}, {1, 0}, {-1, 0}, 1.25},
    {"balls-fast", "fast, rounded", "balls", {-2.1, 0}, {1.2549, -1.25}, {769616.6, 0}, {-777559.2, 0}, 4e-6},

    {"tunnels", "tunnelling", "discrete", {-2.75, -0.25}, {2.5, 0}, {4, 0}, {-4, 0}, 1, 0.25, 0.25},
    {"seen", "slow enough", "discrete", {-2.25, -0.25}, {1, 0}, {2, 0}, {-2, 0}, 1, 0.25, 0.25},
    {"caught", "seen all the same", "discrete", {-2.25, -0.25}, {2, 0}, {4, 0}, {-4, 0}, 1, 0.25, 0.25},
    {"beside", "they pass", "discrete", {-2.75, -0.5}, {2.5, 0.25}, {4, 0}, {-4, 0}, 1, 0.25, 0.25},

    {"steps", "by the speed", "conservative", {-2, -0.5}, {1.75, 0.5}, {1, 0.25}, {-1, 0.25}},
    {"steps-along",
     "along the centres",
     "conservative",
     {-2, -0.5},
     {1.75, 0.5},
     {1, 0.25},
     {-1, 0.25},
     2,
     0.75,
     0.5,
     0.01,
     "centres"},
    {"steps-graze", "grazing", "conservative", {-1.75, -0.5}, {1.25, 0.75}, {1, 0.25}, {-1, 0.25}},
    {"steps-near",
     "near, no contact",
     "conservative",
     {-1.75, -0.5},
     {1.25, 0.78125},
     {1, 0.25},
     {-1, 0.25},
     2,
     0.75,
     0.5,
     0.0625,
     "centres"},
    {"steps-pass",
     "they pass",
     "conservative",
     {-1.75, -0.75},
     {1.25, 0.75},
     {1, 0},
     {-1, 0},
     2,
     0.75,
     0.5,
     0.01,
     "centres"},
    {"steps-late", "too late", "conservative", {-2.25, -0.25}, {2, 0.25}, {1, 0}, {-1, 0}, 1.25},
};

std::vector<Preset> presets() {
  std::vector<Preset> all;
  const auto space = [](const Vec2& p) { return Vec3(p.x(), p.y(), 0); };
  for (const Situation& s : situations)
    all.push_back({s.id,
                   s.title,
                   s.method,
                   {{"method", std::string(s.method)},
                    {"a", space(s.a)},
                    {"b", space(s.b)},
                    {"v_a", space(s.v_a)},
                    {"v_b", space(s.v_b)},
                    {"r_a", s.r_a},
                    {"r_b", s.r_b},
                    {"duration", s.duration},
                    {"tests", 4.0},
                    {"tolerance", s.tolerance},
                    {"bound", std::string(s.bound)}}});
  return all;
}

Walk walk(const Parameters& p) {
  const Setup s = setup(p);
  if (s.method == "boxes") return boxes(s);
  if (s.method == "balls") return balls(s);
  return s.method == "discrete" ? discrete(s) : conservative(s);
}

Parameter flat_vector(const char* name, const char* label, const char* help, const Vec3& initial) {
  return vector(name, label, std::string(help) + "; the third coordinate is not used.", initial);
}

std::vector<Parameter> parameters() {
  return {
      choice("method", "method", "Two boxes, two balls, boxes at discrete times, or balls by conservative steps.",
             {"boxes", "balls", "discrete", "conservative"}),
      flat_vector("a", "**a**", "Centre of the body a at t = 0, in world units", {-2.25, -0.5, 0}),
      flat_vector("b", "**b**", "Centre of the body b at t = 0, in world units", {2.25, 1.25, 0}),
      flat_vector("v_a", "**v**_a", "Velocity of a, in world units per second", {1, 0.5, 0}),
      flat_vector("v_b", "**v**_b", "Velocity of b, in world units per second", {-1, -0.5, 0}),
      {"r_a", "*r*_a", "Radius of the ball a, or half the side of the box a.", 0.75, 0, 1e6, 0.1, 2},
      {"r_b", "*r*_b", "Radius of the ball b, or half the side of the box b.", 0.5, 0, 1e6, 0.1, 2},
      {"duration", "duration", "How long the bodies move, in seconds.", 2.0, 0, 1e6, 0, 4},
      where("method", {"discrete"},
            {"tests", "tests", "How many tests follow that at t = 0, 1 to 40, rounded to an integer.", 4.0, 1, 40, 1,
             12}),
      where("method", {"conservative"},
            {"tolerance", "*ε*", "The distance at which the steps end, in world units.", 0.01, 1e-9, 1e6, 0.01, 0.5}),
      where("method", {"conservative"},
            choice("bound", "bound",
                   "How fast the distance falls at most: the relative speed, or its part along the centres.",
                   {"speed", "centres"}))};
}

}  // namespace

const Lesson& lesson() {
  static const Lesson lesson = {
      .id = "moving-bodies",
      .title = "Moving bodies",
      .rows = "N16, N25, beyond the note",
      .summary = "Whether two boxes or balls that move meet within a time, and when first.",
      .parameters = parameters(),
      .group_by = "method",
      .presets = presets(),
      .camera = {.azimuth = 0, .elevation = 0},
      .steps = walk,
      .flat = true,
      .opinions = opinions,
      .map = &cases(),
      .opening = opening(),
      .closing = &closing(),
      .after = {"aabb-aabb", "rays", "ray-sphere", "distance", "collision"},
      .ideas = {"Minkowski sum", "continuous collision detection", "slab", "conservative advancement"},
      .shared = shared_ideas,
      .query = R"({"kind": "ray_sphere", "origin": [3.75, 1, 0], "dir": [-2, 0, 0],
 "center": [0, 0, 0], "radius": 1.25})",
  };
  return lesson;
}

}  // namespace isect::lessons::moving_bodies_lesson
