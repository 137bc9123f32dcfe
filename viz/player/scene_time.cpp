#include "viz/player/scene_time.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "viz/walk/question_scene.h"

namespace isect::viz {
namespace {

/// Returns the time with as many digits as tell a thousand times of the motion apart.
std::string told_time(const Scene::Time& time, double t) {
  const double digit = std::pow(10, std::floor(std::log10((time.hi - time.lo) / 300)));
  const double rounded = std::round(t / digit) * digit;
  return shown(std::isfinite(rounded) ? rounded : t);
}

}  // namespace

double time_after(const Scene::Time& time, double from, double seconds) {
  const double length = time.hi - time.lo, pace = length / seconds_of_motion, reach = slow_share * length;
  const double contact = time.contact.value_or(time.hi + reach);
  const std::array<std::pair<double, double>, 3> parts = {
      {{contact - reach, pace}, {contact + reach, pace / slower}, {time.hi, pace}}};
  double t = time_near(time, from);
  for (const auto& [end, rate] : parts) {
    const double until = std::min(end, time.hi);
    if (!(t < until)) continue;
    const double needed = (until - t) / rate;
    if (seconds < needed) return std::min(t + seconds * rate, until);
    seconds -= needed;
    t = until;
  }
  return time.hi;
}

double time_near(const Scene::Time& time, double t, double reach) {
  if (time.contact && std::abs(t - *time.contact) <= reach) return *time.contact;
  return t >= time.lo ? std::min(t, time.hi) : time.lo;  // NaN is the begin
}

double time_beside(const Scene::Time& time, double now, int way) {
  const double to = time_near(time, now + way * (time.hi - time.lo) / 40);
  if (time.contact && (now - *time.contact) * (to - *time.contact) < 0) return *time.contact;
  return to;
}

double next_still(const Scene::Time& time, double now) {
  std::vector<double> stills;
  for (int i = 0; i <= 4; ++i) stills.push_back(time.lo + i * (time.hi - time.lo) / 4);
  stills.back() = time.hi;
  if (time.contact) stills.push_back(*time.contact);
  std::ranges::sort(stills);
  const auto next = std::upper_bound(stills.begin(), stills.end(), now);
  return next == stills.end() ? time.lo : *next;
}

std::string time_words(const Scene::Time& time, double now, bool brief) {
  if (!time.contact || brief) return fmt::format("*t* = {}", told_time(time, now));
  const std::string contact = shown(*time.contact);
  if (now == *time.contact) return fmt::format("*t* = {} (contact)", contact);
  return fmt::format("*t* = {} (contact at *t* = {})", told_time(time, now), contact);
}

Walk at_time(Walk walk, int step, double t) {
  Step& posed = walk.steps.at(static_cast<std::size_t>(step));
  if (!posed.scene.time) return walk;
  for (int i = step; i <= step + 1 && i < static_cast<int>(walk.steps.size()); ++i)
    if (std::optional<Question>& question = walk.steps[static_cast<std::size_t>(i)].question; question)
      question->over = question_scene(walk, i);  // made of both scenes

  Scene::Time time = *posed.scene.time;
  time.now = time_near(time, t);
  posed.caption +=
      fmt::format("{}The picture shows {}.", posed.caption.empty() ? "" : " ", time_words(time, time.now, true));
  posed.scene = time.at(time.now);
  posed.scene.time = std::make_shared<const Scene::Time>(std::move(time));
  return walk;
}

}  // namespace isect::viz
