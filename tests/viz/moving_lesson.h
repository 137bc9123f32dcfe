#pragma once
// A small lesson of the tests' own whose dot moves: three steps with a time, a question before the third, which alone
// knows the contact; then one in which nothing moves.

#include <memory>

#include "viz/lesson.h"

namespace isect::viz::moving {

inline Scene scene(double x) {
  Scene scene;
  scene.items = {Dot{{x, 0, 0}, Mark::disc, Role::first}, Circle{{0.25, 0.5, 0}, 0.25}};
  scene.handles = {{"speed", Handle::Kind::along, {0, 1, 0}}};
  return scene;
}
inline Scene at(double t) { return scene(t); }

inline Walk walk(const Parameters& values) {
  const double speed = std::get<double>(values.at("speed")), duration = std::get<double>(values.at("duration"));
  Walk w;
  w.pseudocode = {"move", "return when they meet"};
  w.alt = "A dot that moves.";
  const auto add = [&](const char* slug, bool moves, std::optional<double> contact) {
    Step step;
    step.slug = step.title = slug;
    step.caption = "A dot moves to the right.";
    step.line = moves ? 0 : 1;
    step.scene = scene(0);
    const auto then = [speed](double t) { return scene(speed * t); };
    if (moves) step.scene.time = std::make_shared<const Scene::Time>(Scene::Time{0, duration, 0, contact, then});
    w.steps.push_back(step);
  };
  add("one", true, {});
  add("two", true, {});
  add("three", true, 0.5 * duration / 2);
  add("four", false, {});
  w.steps[2].question = Question{"When do they meet?", {"at 0.5", "never"}, 0, "The dot moves."};
  w.steps[2].verdict = w.steps[3].verdict = {Verdict::Kind::yes, "they meet"};
  return w;
}

inline Lesson lesson() {
  Lesson l;
  l.id = "dot-moves";
  l.title = "A dot that moves";
  l.rows = "N00";
  l.summary = "When does it meet the circle?";
  l.parameters = {{"speed", "speed", "how fast", 1.0, 0, 100, 0, 5},
                  {"duration", "duration", "how long", 2.0, 0.125, 100, 0, 5}};
  l.presets = {{"usual", "usual", "", {{"speed", 1.0}, {"duration", 2.0}}}};
  l.camera = {.azimuth = 0, .elevation = 0};
  l.steps = walk;
  l.flat = true;
  return l;
}

}  // namespace isect::viz::moving
