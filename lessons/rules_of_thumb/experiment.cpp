#include "lessons/rules_of_thumb/experiment.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lessons/shared/questions.h"
#include "lessons/shared/script.h"

namespace isect::lessons::rules_of_thumb_lesson {

using namespace viz;

namespace {

/// A count as a bar beside the scene.
void add_bar(Scene& scene, const std::string& name, double count, double most, const std::string& unit, double y,
             Role role) {
  const double left = 1.7, width = 2.5, height = 0.22;
  const double right = left + width * (most > 0 ? count / most : 0);
  scene.items.emplace_back(text({left + width / 2, y + 0.36}, name, Role::text));
  if (count > 0)
    scene.items.emplace_back(region(
        {{left, y - height / 2}, {right, y - height / 2}, {right, y + height / 2}, {left, y + height / 2}}, role));
  scene.items.emplace_back(line({left, y - 0.2}, {left, y + 0.2}, Role::muted, Pen::hairline));
  scene.items.emplace_back(viz::Heading{{left + width / 2, y - 0.36, 0}, number_of(count, unit), role, 3, false});
}

/// The question of how much of the count is left.
Question question(const Experiment& e) {
  const double left = e.before > 0 ? e.after / e.before : 1;
  return {"How much of the count is left with the rule?",
          {"less than a quarter", "a quarter to a half", "a half to all", "all of it, or more"},
          left < 0.25  ? 0
          : left < 0.5 ? 1
          : left < 1   ? 2
                       : 3,
          left < 1 ? e.saving : "Here the rule finds nothing to save."};
}

}  // namespace

Region region(const std::vector<Flat>& ring, Role role) {
  Region r;
  r.rings = {flat(ring)};
  r.role = role;
  return r;
}
Chain outline(const std::vector<Flat>& ring, Role role, Pen pen) { return {flat(ring), true, role, pen}; }
Circle circle(const Flat& center, double radius, Role role, Pen pen, bool filled) {
  return {flat(center), radius, role, pen, filled};
}
Line line(const Flat& from, const Flat& to, Role role, Pen pen) { return {flat(from), flat(to), role, pen}; }
viz::Heading text(const Flat& at, const std::string& what, Role role) { return {flat(at), what, role, 0, false}; }

std::string number_of(double count, const std::string& unit) {
  const std::string digits = shown(std::round(count));
  if (unit.empty()) return digits;
  if (std::round(count) != 1) return digits + " " + unit;
  return digits + " " + (unit == "axes tested" ? "axis tested" : unit.substr(0, unit.size() - 1));
}

Walk tell(const Experiment& e, const Flat& p) {
  Script script({e.source, e.alt, e.pseudocode, e.title});
  const char* const slugs[] = {"rule", "before", "how", "after"};
  const double most = std::max(e.before, e.after);
  for (std::size_t k = 0; k < 4; ++k) {
    if (k == 1) script.value("without the rule", e.before, e.unit, Role::second);
    if (k == 3) {
      script.value("with the rule", e.after, e.unit, Role::first);
      for (const auto& [name, count] : e.details) script.value(name, count);
      script.settle(e.after < e.before ? Verdict::Kind::yes : Verdict::Kind::no,
                    e.after < e.before
                        ? fmt::format("{} instead of {}", number_of(e.after, e.unit), number_of(e.before, ""))
                        : "the rule saves nothing here");
    }
    Step& step = script.add(slugs[k], e.parts[k].title, static_cast<int>(k), e.parts[k].caption, e.parts[k].formula);
    step.scene.items = e.parts[k].items;
    step.scene.items.emplace_back(Dot{flat(p), Mark::disc, Role::first});
    step.scene.items.emplace_back(Label{flat(p), "**p**", Role::first});
    if (k > 0) add_bar(step.scene, "without the rule", e.before, most, e.unit, 0.9, Role::second);
    if (k == 3) {
      add_bar(step.scene, "with the rule", e.after, most, e.unit, -0.7, Role::first);
      step.decides = true;
      step.question = question(e);
      keep_picture(script.walk());
    }
    step.scene.handles.push_back({"p", Handle::Kind::point, flat(p), Vec3::Zero(), Role::first});
  }
  return std::move(script.walk());
}

}  // namespace isect::lessons::rules_of_thumb_lesson
