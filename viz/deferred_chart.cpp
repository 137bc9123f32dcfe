#include "viz/deferred_chart.h"

#include <mutex>

#include "viz/chart.h"

namespace isect::viz {

struct DeferredChart::Once {
  Once(std::shared_ptr<const Chart> chart, std::function<Chart()> how) : made(std::move(chart)), make(std::move(how)) {}

  std::shared_ptr<const Chart> made;
  std::function<Chart()> make;
  std::once_flag flag;
};

DeferredChart::DeferredChart(std::shared_ptr<const Chart> made) {
  if (made) once_ = std::make_shared<Once>(std::move(made), nullptr);
}

DeferredChart::DeferredChart(std::function<Chart()> make) : once_(std::make_shared<Once>(nullptr, std::move(make))) {}

const Chart& DeferredChart::operator*() const {
  std::call_once(once_->flag, [&] {
    if (!once_->made) once_->made = std::make_shared<const Chart>(once_->make());
  });
  return *once_->made;
}

}  // namespace isect::viz
