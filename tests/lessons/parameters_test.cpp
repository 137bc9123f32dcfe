// What is said of when a parameter counts, held against the walks.

#include <set>

#include "lessons/lessons.h"
#include "tests/catch.h"
#include "tests/lessons/random_settings.h"
#include "viz/snapshot/snapshot.h"

namespace parameters_test {
using namespace isect;
using namespace isect::viz;

namespace {

/// All that a walk of this setting says and draws.
std::string told(const Lesson& lesson, const Parameters& setting) {
  return trace_json(lesson, "", lesson.presets.front().parameters, lesson.walk(setting), {}, {});
}

bool allowed(const Lesson& lesson, const Parameters& setting) {
  try {
    validate(lesson, setting);
    return true;
  } catch (const BadInput&) {
    return false;
  }
}

std::string choices_of(const Lesson& lesson, const Parameters& setting) {
  std::string all;
  for (const Parameter& p : lesson.parameters)
    if (!p.choices.empty()) all += p.name + " = " + std::get<std::string>(setting.at(p.name)) + ", ";
  return all;
}

}  // namespace

TEST_CASE("what is said not to count changes nothing", "[lessons]") {
  bench::Random random(61);
  int changed = 0;
  for (const Lesson* lesson : isect::lessons::all_lessons())
    for (int i = 0; i < 40; ++i) {
      const Parameters setting = tests::random_setting(*lesson, random);
      const bool any = std::ranges::any_of(lesson->parameters, [&](const Parameter& p) { return !counts(p, setting); });
      if (!any) continue;
      const std::string before = told(*lesson, setting);
      for (const Parameter& p : lesson->parameters) {
        Parameters other = setting;
        if (counts(p, setting)) continue;
        other[p.name] = tests::random_setting(p, random);  // an optional one may have been absent
        if (!allowed(*lesson, other)) continue;
        INFO(lesson->id << ": " << choices_of(*lesson, setting) << p.name);
        CHECK(told(*lesson, other) == before);
        ++changed;
      }
    }
  CHECK(changed > 200);
}

TEST_CASE("what never changes anything with the choices of a preset is said not to count", "[lessons]") {
  bench::Random random(62);
  for (const Lesson* lesson : isect::lessons::all_lessons()) {
    std::set<std::string> seen;
    for (const Preset& preset : lesson->presets) {
      if (!seen.insert(choices_of(*lesson, preset.parameters)).second) continue;
      for (const Parameter& p : lesson->parameters) {
        if (!preset.parameters.contains(p.name) || !counts(p, preset.parameters)) continue;
        bool changes = false;
        for (int i = 0; i < 60 && !changes; ++i) {
          Parameters one = preset.parameters;
          for (const Parameter& q : lesson->parameters)
            if (q.choices.empty() && i % 2 && one.contains(q.name)) one.at(q.name) = tests::random_setting(q, random);
          Parameters other = one;
          other.at(p.name) = tests::random_setting(p, random);
          changes = allowed(*lesson, one) && allowed(*lesson, other) && told(*lesson, one) != told(*lesson, other);
        }
        INFO(lesson->id << ": " << choices_of(*lesson, preset.parameters) << p.name);
        CHECK(changes);
      }
    }
  }
}

}  // namespace parameters_test
