#pragma once
// Settings of a lesson that nobody chose: drawn at random, and brought to the borders of its map of cases.

#include <cmath>
#include <optional>

#include "bench/random.h"
#include "tests/settings.h"
#include "viz/lesson.h"

namespace isect::tests {

/// A number of the slider's range, every other time rounded to a quarter, where equalities happen.
inline double random_number(const viz::Parameter& p, bench::Random& random) {
  const double lo = std::max(p.lo, p.drag_lo), hi = std::min(p.hi, p.drag_hi), x = random.uniform(lo, hi);
  return random.one_in(2) ? x : std::clamp(std::round(4 * x) / 4, p.lo, p.hi);
}

inline viz::Setting random_setting(const viz::Parameter& p, bench::Random& random) {
  if (!p.choices.empty()) return p.choices[static_cast<std::size_t>(random.below(static_cast<int>(p.choices.size())))];
  if (std::holds_alternative<double>(p.initial)) return random_number(p, random);
  return viz::Vec3(random_number(p, random), random_number(p, random), random_number(p, random));
}

/// A preset with each parameter drawn anew one time in two, and an optional one one time in twelve. A setting that the
/// lesson refuses is drawn again.
inline viz::Parameters random_setting(const viz::Lesson& lesson, bench::Random& random) {
  for (;;) {
    viz::Parameters setting =
        lesson.presets[static_cast<std::size_t>(random.below(static_cast<int>(lesson.presets.size())))].parameters;
    for (const viz::Parameter& p : lesson.parameters)
      if (random.one_in(p.optional ? 12 : 2)) setting[p.name] = random_setting(p, random);
    for (auto& [name, value] : setting)  // a point of a flat lesson stays in its plane
      if (viz::Vec3* v = std::get_if<viz::Vec3>(&value); v && lesson.flat) v->z() = 0;
    try {
      validate(lesson, setting);
      return setting;
    } catch (const viz::BadInput&) {
    }
  }
}

/// Two neighbouring settings on the map between `from` and `to`, one on either side of a border; nothing if both ends
/// have the same branch.
inline std::optional<std::pair<viz::Parameters, viz::Parameters>> beside_a_border(const viz::Lesson& lesson,
                                                                                  const viz::Parameters& setting,
                                                                                  viz::Vec2 from, viz::Vec2 to) {
  const viz::CaseMap& map = *lesson.map;
  const auto at = [&](const viz::Vec2& place) { return map.moved(setting, place); };
  const int first = map.branch(at(from));
  if (map.branch(at(to)) == first) return {};
  for (int i = 0; i < 60; ++i) {
    const viz::Vec2 middle = (from + to) / 2;
    (map.branch(at(middle)) == first ? from : to) = middle;
  }
  return std::pair{at(from), at(to)};
}

/// How many settings to draw; a lesson about measurements has few.
inline int settings_to_draw(const viz::Lesson& lesson, int few) {
  return lesson.parameters.size() < 2 ? 10 : cases(few, 10 * few);
}

/// Calls look(setting) with the settings of all presets, with settings drawn at random, and with those on either side
/// of borders of the map, between two places drawn at random. They are the same in each test.
template <class Look>
void at_any_settings(const viz::Lesson& lesson, const Look& look) {
  bench::Random random(bench::stream(seed(), lesson.id.c_str()));
  for (const viz::Preset& p : lesson.presets) look(p.parameters);
  for (int i = 0; i < settings_to_draw(lesson, 1000); ++i) look(random_setting(lesson, random));
  const auto place = [&] {
    return viz::Vec2(random.uniform(lesson.map->lo.x(), lesson.map->hi.x()),
                     random.uniform(lesson.map->lo.y(), lesson.map->hi.y()));
  };
  for (int i = 0; lesson.map && i < settings_to_draw(lesson, 200); ++i) {
    const viz::Vec2 from = place(), to = place();
    const viz::Preset& start = lesson.presets[static_cast<std::size_t>(i) % lesson.presets.size()];
    if (const auto pair = beside_a_border(lesson, start.parameters, from, to)) look(pair->first), look(pair->second);
  }
}

}  // namespace isect::tests
