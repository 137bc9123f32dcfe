#pragma once
// A lesson of three steps for tests that need any lesson at all: is the origin inside the ball around zero?

#include "viz/lesson.h"

namespace isect::test {

inline viz::Walk toy_walk(const viz::Parameters& parameters) {
  const double r = std::get<double>(parameters.at("radius"));
  const double d2 = std::get<viz::Vec3>(parameters.at("origin")).squaredNorm();
  viz::Walk walk;
  walk.pseudocode = {"d² ← o · o", "if d² <= r²", "    return INSIDE", "return OUTSIDE"};
  viz::Step step;
  step.slug = "square", step.title = "Distance", step.line = 0;
  step.values = {{"*d*^2", d2, {}, {}, true}, {"*r*^2", r * r, {}, {}, true}};
  step.counters.mul = 4;
  walk.steps.push_back(step);
  step.slug = "compare", step.title = "Comparison", step.line = 1;
  step.comparison = viz::Comparison{"*d*^2 ≤ *r*^2", d2, r * r, d2 <= r * r, "the origin is inside"};
  walk.steps.push_back(step);
  step.comparison.reset();
  step.slug = d2 <= r * r ? "inside" : "outside", step.title = "Answer", step.line = d2 <= r * r ? 2 : 3;
  step.verdict = {d2 <= r * r ? viz::Verdict::Kind::yes : viz::Verdict::Kind::no, step.slug};
  walk.steps.push_back(step);
  return walk;
}

inline const viz::Lesson& toy() {
  using viz::Setting, viz::Vec3;
  const auto parameters = [](double x) {
    return viz::Parameters{{"radius", 1.0}, {"origin", Vec3(x, 0, 0)}, {"method", std::string("quick")}};
  };
  static const viz::Lesson lesson = {
      .id = "toy",
      .title = "A toy",
      .rows = "N00",
      .summary = "Whether a point is inside a ball.",
      .parameters =
          {{.name = "radius", .label = "*r*", .help = "Radius.", .initial = 1.0, .lo = 0, .hi = 100},
           {.name = "origin", .label = "**o**", .help = "Point.", .initial = Vec3(0, 0, 0), .lo = -50, .hi = 50},
           {.name = "method",
            .label = "method",
            .help = "Which one.",
            .initial = std::string("quick"),
            .choices = {"quick", "exact"}}},
      .group_by = "",
      .presets = {{"near", "near by", "", parameters(0.5)}, {"far", "far away", "", parameters(2)}},
      .camera = {},
      .steps = toy_walk};
  return lesson;
}

}  // namespace isect::test
