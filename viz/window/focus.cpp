#include "viz/window/focus.h"

#include <algorithm>
#include <utility>

namespace isect::viz {

bool Focus::offer(const std::string& name, int group, bool in_popup) {
  stops_.push_back({name, group, in_popup});
  return name == name_;
}

void Focus::end_frame() {
  const bool in_popup = std::ranges::any_of(stops_, &Stop::in_popup);
  if (in_popup) std::erase_if(stops_, [](const Stop& stop) { return !stop.in_popup; });
  std::ranges::stable_sort(stops_, {}, &Stop::group);
  if (in_popup && !in_popup_) before_popup_ = std::exchange(name_, {});
  if (!in_popup && in_popup_) name_ = std::exchange(before_popup_, {});
  in_popup_ = in_popup;
  known_ = std::exchange(stops_, {});
  known_begin_ = std::exchange(begin_, {});
  if (patience_ > 0) --patience_;
  if (patience_ == 0 && std::ranges::find(known_, name_, &Stop::name) == known_.end()) name_.clear();
  pressed_ = moved_ = false;
}

void Focus::move(int by) {
  if (known_.empty()) return;
  const int count = static_cast<int>(known_.size());
  const auto held = std::ranges::find(known_, name_.empty() ? known_begin_ : name_, &Stop::name);
  const int at = held != known_.end() ? static_cast<int>(held - known_.begin()) + by : by > 0 ? 0 : count - 1;
  name_ = known_[static_cast<std::size_t>((at + count) % count)].name;
  moved_ = true;
}

void Focus::next_group() {
  if (known_.empty()) return;
  const auto held = std::ranges::find(known_, name_, &Stop::name);
  const int group = held == known_.end() ? -1 : held->group;
  const auto next = std::ranges::find_if(known_, [group](const Stop& stop) { return stop.group > group; });
  name_ = next == known_.end() ? known_.front().name : next->name;
  moved_ = true;
}

}  // namespace isect::viz
