#include "viz/deferred_chart.h"

#include <mutex>

#include "viz/chart/chart.h"

namespace isect::viz {

struct DeferredChart::Once {
  bool prepare() {
    const std::lock_guard lock(busy);
    if (made) return false;
    if (std::optional<Chart> chart = part()) {
      made = std::make_shared<const Chart>(std::move(*chart));
      part = nullptr;
    }
    return true;
  }

  std::mutex busy;
  std::shared_ptr<const Chart> made;
  std::function<std::optional<Chart>()> part;
};

DeferredChart::DeferredChart(std::shared_ptr<const Chart> made) {
  if (!made) return;
  once_ = std::make_shared<Once>();
  once_->made = std::move(made);
}

DeferredChart::DeferredChart(std::function<std::optional<Chart>()> part) : once_(std::make_shared<Once>()) {
  once_->part = std::move(part);
}

bool DeferredChart::prepare() const { return once_->prepare(); }

const Chart& DeferredChart::operator*() const {
  while (prepare()) {
  }
  return *once_->made;
}

}  // namespace isect::viz
