#include "viz/player/history.h"

#include <utility>

namespace isect::viz {
namespace {

constexpr std::size_t memories_kept = 100;

}  // namespace

void History::remember(const std::string& action, Memory now) {
  std::string name = action;  // what may throw comes first
  past_.push_back(std::make_shared<const Memory>(std::move(now)));
  if (past_.size() > memories_kept) past_.erase(past_.begin());
  undone_.clear();
  action_ = std::move(name);
}

void History::loses_place() {
  if (action_.empty() || past_.empty() || past_.back()->with_step) return;
  Memory before = *past_.back();
  before.with_step = true;
  past_.back() = std::make_shared<const Memory>(std::move(before));
}

Memory History::travel(Memories& from, Memories& to, Memory now) {
  Memory last = *from.back();
  now.with_step = last.with_step;
  to.push_back(std::make_shared<const Memory>(std::move(now)));
  from.pop_back();
  return last;
}

}  // namespace isect::viz
