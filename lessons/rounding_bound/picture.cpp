#include "lessons/rounding_bound/picture.h"

#include <algorithm>
#include <cmath>

namespace isect::lessons::rounding_bound_lesson {

using namespace viz;

namespace {

constexpr double line_end = 4.5;    // of each number line
constexpr double half_width = 2.0;  // of an interval from bound to bound

Line number_line(double y) { return {{-line_end, y, 0}, {line_end, y, 0}, Role::muted, Pen::hairline}; }

/// A text above a line, from its left end or up to its right end.
Heading at_left(double y, const std::string& text) { return {{-line_end, y + 0.25, 0}, text, Role::text, 3, false, 0}; }
Heading at_right(double y, const std::string& text) { return {{line_end, y + 0.25, 0}, text, Role::text, 3, false, 1}; }
Heading centred(double x, double y, const std::string& text, Role role = Role::muted) {
  return {{x, y, 0}, text, role, 1.5, false, 0.5};
}

/// Adds a computed number, and the truth if it is known. `named`: says which is which.
void add_numbers(Scene& scene, double y, double truth, bool named) {
  const Vec3 computed(0, y, 0), at(half_width * truth, y, 0);
  const bool known = std::isfinite(truth), same = truth == 0;
  scene.items.emplace_back(Dot{computed, Mark::disc, Role::first});
  if (known) scene.items.emplace_back(Dot{at, Mark::diamond, Role::highlight});
  if (!named) return;
  scene.items.emplace_back(Label{computed, same ? "computed = truth" : "computed", Role::text});
  if (known && !same) scene.items.emplace_back(Label{at, "truth", Role::text});
}

void add_ends(Scene& scene, double y, const std::string& bound) {
  scene.items.emplace_back(centred(-half_width, y, "− " + bound));
  scene.items.emplace_back(centred(half_width, y, "+ " + bound));
}

}  // namespace

Scene points(const Setup& s) {
  const Vec3 along = 0.25 * (s.c - s.b);
  Scene scene;
  scene.items = {Line{s.b - along, s.c + along, Role::second, Pen::solid},
                 Dot{s.b, Mark::disc, Role::second},
                 Label{s.b, "**b**", Role::second},
                 Dot{s.c, Mark::disc, Role::second},
                 Label{s.c, "**c**", Role::second},
                 Dot{s.a, Mark::disc, Role::first},
                 Label{s.a, "**a**", Role::first}};
  scene.handles = {{"a", Handle::Kind::point, s.a, Vec3::Zero(), Role::first},
                   {"b", Handle::Kind::point, s.b, Vec3::Zero(), Role::second},
                   {"c", Handle::Kind::point, s.c, Vec3::Zero(), Role::second}};
  return scene;
}

Scene bounds(const std::vector<Row>& rows, const std::string& bound) {
  Scene scene;
  double y = 0.5 * (static_cast<double>(rows.size()) - 1);
  bool first = true;
  for (const Row& row : rows) {
    scene.items.emplace_back(number_line(y));
    scene.items.emplace_back(Span{{-half_width, y, 0}, {half_width, y, 0}, Role::first, Pen::thick});
    add_numbers(scene, y, row.truth, first);
    scene.items.emplace_back(at_left(y, row.name));
    scene.items.emplace_back(at_right(y, row.told));
    y -= 1, first = false;
  }
  add_ends(scene, y + 0.6, bound);
  return scene;
}

Scene decision(const Setup& s, const Run& run) {
  Scene scene;
  const double reach = half_width * s.factor, zero = -half_width * run.det.value / run.bound();
  scene.items.emplace_back(number_line(0));
  for (const double x : {-half_width, half_width})
    scene.items.emplace_back(Line{{x, -0.2, 0}, {x, 0.2, 0}, Role::construction, Pen::construction});
  if (reach > 0) scene.items.emplace_back(Span{{-reach, 0, 0}, {reach, 0, 0}, Role::first, Pen::thick});
  add_numbers(scene, 0, std::copysign(run.det.share, -run.det.error), true);
  add_ends(scene, -0.5, "*bound*");
  if (std::abs(zero) <= line_end) {
    scene.items.emplace_back(Line{{zero, -0.35, 0}, {zero, 0.75, 0}, Role::text, Pen::solid});
    scene.items.emplace_back(centred(zero, 1, "0", Role::text));
  } else if (std::isfinite(zero)) {
    const double way = zero > 0 ? 1 : -1;
    scene.items.emplace_back(Arrow{{way * 3.6, 0.4, 0}, {way * line_end, 0.4, 0}, Role::text, Pen::solid});
    scene.items.emplace_back(centred(way * 4, 0.75, "to 0", Role::text));
  }
  const Vec3 along = Vec3::UnitX() / half_width;
  scene.handles.push_back({"factor", Handle::Kind::along, {reach, 0, 0}, Vec3::Zero(), Role::first, along});
  return scene;
}

Scene ladder(const Run& run, std::size_t count) {
  constexpr double least = -320, right = 3.4, row = 0.8;  // powers of two from the left end to `right`
  const auto of_power = [](double power) { return std::min(right - power / least * (right + line_end), line_end); };
  const auto at = [&](double number) {
    const double power = std::log2(std::abs(number) / run.size());
    return power >= least ? of_power(power) : -line_end;  // also where nothing is known
  };
  Scene scene;
  const double top = 0.5 * row * (static_cast<double>(count) - 1), bottom = -top;
  double y = top;
  for (std::size_t i = 0; i < count; ++i, y -= row) {
    const Stage& stage = run.stages[i];
    const bool known = std::isfinite(stage.bound), rounds = !known || stage.bound > 0;
    scene.items.emplace_back(number_line(y));
    if (rounds)
      scene.items.emplace_back(
          Span{{-line_end, y, 0}, {known ? at(stage.bound) : line_end, y, 0}, Role::second, Pen::thick, true, !known});
    if (const double x = at(stage.step); stage.step > 0)
      scene.items.emplace_back(Line{{x, y - 0.2, 0}, {x, y + 0.2, 0}, Role::text, Pen::solid});
    scene.items.emplace_back(at_left(y, words_of(stage.kind).name));
    scene.items.emplace_back(at_right(y, stage.sign ? "certain" : "open"));
  }
  if (const double x = at(run.decided().value); run.truth != 0 && x > -line_end) {
    scene.items.emplace_back(Line{{x, top + 0.5, 0}, {x, bottom - 0.2, 0}, Role::first, Pen::construction});
    scene.items.emplace_back(centred(x, top + 0.75, "|truth|", Role::first));
  }
  for (const int power : {0, -100, -200, -300})
    scene.items.emplace_back(
        centred(of_power(power), bottom - 0.45, power == 0 ? "1" : "2^{−" + std::to_string(-power) + "}"));
  return scene;
}

}  // namespace isect::lessons::rounding_bound_lesson
