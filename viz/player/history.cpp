#include "viz/player/history.h"

#include <utility>

namespace isect::viz {
namespace {

constexpr std::size_t memories_kept = 100;

}  // namespace

void History::remember(const std::string& action, Memory now) {
  std::string name = action;  // what may throw comes first
  past_.push_back(std::move(now));
  if (past_.size() > memories_kept) past_.erase(past_.begin());
  undone_.clear();
  action_ = std::move(name);
}

Memory History::travel(std::vector<Memory>& from, std::vector<Memory>& to, Memory now) {
  Memory last = std::move(from.back());
  from.pop_back();
  now.with_step = last.with_step;
  to.push_back(std::move(now));
  action_.clear();
  return last;
}

}  // namespace isect::viz
