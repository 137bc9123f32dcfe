#include "viz/window/light.h"

#include <algorithm>
#include <utility>

namespace isect::viz {
namespace {

constexpr double seconds_to_light = 0.120;

float area(const Rect& r) { return r.width() * r.height(); }

}  // namespace

void Light::take(Asked& asked, const std::vector<std::string>& names, const Rect& at, bool tells) {
  if (names.empty() || (!asked.names.empty() && area(asked.at) <= area(at))) return;
  asked = {names, at, tells};
}

void Light::end_frame(double seconds, bool at_once, bool pointer_moved, bool keyboard_moved) {
  if (pointer_moved) by_keyboard_ = false;
  if (keyboard_moved) by_keyboard_ = true;
  const Asked pointed = std::exchange(pointed_, {}), held = std::exchange(held_, {});
  wanted_ = by_keyboard_ ? held : pointed.names.empty() ? held : pointed;
  const bool others = !wanted_.names.empty() && wanted_.names != lit_;
  if (others) lit_ = wanted_.names, strength_ = 0;
  const double way = (wanted_.names.empty() ? -1 : 1) * (at_once ? 1 : seconds / seconds_to_light);
  const double before = std::exchange(strength_, std::clamp(strength_ + way, 0.0, 1.0));
  changing_ = others || strength_ != before;
}

double Light::of(const std::string& name) const { return std::ranges::find(lit_, name) == lit_.end() ? 0 : strength_; }

double Light::of(const std::vector<std::string>& names) const {
  return std::ranges::any_of(names, [&](const std::string& name) { return of(name) > 0; }) ? strength_ : 0;
}

}  // namespace isect::viz
