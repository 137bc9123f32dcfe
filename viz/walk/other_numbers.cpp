#include "viz/walk/other_numbers.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "viz/text/rich_text.h"
#include "viz/walk/question_scene.h"
#include "viz/walk/review.h"
#include "viz/walk/typed_answer.h"

namespace isect::viz {
namespace {

/// How many settings are tried.
constexpr int most_settings = 48;

/// Draws a number of the slider's range: a quarter, where that is fine enough, so that one can compute with it.
double drawn_number(const Parameter& p, std::mt19937& random) {
  const double lo = std::max(p.lo, p.drag_lo), hi = std::min(p.hi, p.drag_hi);
  const double grid = hi - lo >= 2 ? 0.25 : (hi - lo) / 16;
  const double x = lo + (hi - lo) * (static_cast<double>(random()) / 4294967296.0);
  return grid > 0 ? std::clamp(grid * std::round(x / grid), lo, hi) : lo;
}

/// Returns the setting with one parameter moved: a number, or one point in all its coordinates.
Parameters with_one_moved(const Lesson& lesson, Parameters setting, std::mt19937& random) {
  std::vector<const Parameter*> all;
  for (const Parameter& p : lesson.parameters)
    if (p.choices.empty() && !p.optional && counts(p, setting)) all.push_back(&p);
  if (all.empty()) return setting;
  const Parameter& p = *all[random() % all.size()];
  Setting& value = setting[p.name];
  if (std::holds_alternative<double>(value)) {
    value = drawn_number(p, random);
  } else if (Vec3* point = std::get_if<Vec3>(&value)) {
    for (int i = 0; i < 3; ++i) (*point)[i] = drawn_number(p, random);
    if (lesson.flat) point->z() = 0;
  }
  return setting;
}

std::vector<const Preset*> of_same_method(const Lesson& lesson, const Parameters& setting) {
  const auto method = setting.find(lesson.group_by);
  std::vector<const Preset*> all;
  for (const Preset& p : lesson.presets)
    if (method == setting.end() || p.group == std::get<std::string>(method->second)) all.push_back(&p);
  return all;
}

/// Returns the step whose question has this name, one of this slug if there is one; -1: none.
int asking_step_named(const Lesson& lesson, const Parameters& setting, const Walk& walk, const std::string& name,
                      const std::string& slug) {
  int found = -1;
  for (int i = static_cast<int>(walk.steps.size()) - 1; i > 0; --i) {
    const Step& step = walk.steps[i];
    if (!step.question || question_name(lesson, setting, step) != name) continue;
    if (step.slug == slug) return i;
    found = i;
  }
  return found;
}

}  // namespace

std::string numbers_of_question(const Walk& walk, int step) {
  const Question& q = *walk.steps[step].question;
  std::string all = q.prompt + "|" + q.choices[q.answer];
  for (const Value& v : known_values(walk, step)) all += "|" + v.name + " " + shown(v.value);
  if (q.number) all += "|" + shown(q.number->truth);
  if (q.order)
    for (const std::string& tile : q.order->tiles) all += "|" + tile;
  return all;
}

bool choices_differ(const Question& q) {
  std::set<std::string> read;
  for (const std::string& choice : q.choices) read.insert(plain(choice));
  if (read.size() != q.choices.size()) return false;
  return !q.number || std::ranges::none_of(q.number->wrong,
                                           [&](const WrongNumber& wrong) { return is_right(*q.number, wrong.value); });
}

std::optional<OtherSetting> other_numbers(const Lesson& lesson, const Parameters& now, int step, std::uint32_t seed) {
  const Walk walk = lesson.walk(now);
  const std::string name = question_name(lesson, now, walk.steps[step]), slug = walk.steps[step].slug;
  const std::string numbers = numbers_of_question(walk, step);
  const std::vector<const Preset*> presets = of_same_method(lesson, now);
  std::mt19937 random(seed);
  for (int i = 0; i < most_settings; ++i) {
    const bool as_preset = i % 2 == 0 && !presets.empty();
    OtherSetting other = {as_preset ? presets[random() % presets.size()]->parameters
                                    : with_one_moved(lesson, now, random)};
    try {
      validate(lesson, other.parameters);
      const Walk there = lesson.walk(other.parameters);
      other.step = asking_step_named(lesson, other.parameters, there, name, slug);
      if (other.step < 1 || !choices_differ(*there.steps[other.step].question)) continue;
      if (numbers_of_question(there, other.step) != numbers) return other;
    } catch (const BadInput&) {  // the lesson refuses this setting
    }
  }
  return {};
}

}  // namespace isect::viz
