#pragma once
// A chart that is drawn up when it is first looked at: a walk is made far more often than its chart is shown.

#include <functional>
#include <memory>
#include <optional>

namespace isect::viz {

struct Chart;

/// None, one that is there, or one that will be made at the first look, once for all copies and from any thread.
class DeferredChart {
 public:
  DeferredChart() = default;
  DeferredChart(std::shared_ptr<const Chart> made);
  /// Each call of `part` does some of the work, and the last one gives the chart. It keeps what it needs: it may run
  /// long after the walk was made.
  explicit DeferredChart(std::function<std::optional<Chart>()> part);

  explicit operator bool() const { return once_ != nullptr; }
  /// Does a part of what is left; false when nothing was. There must be a chart.
  bool prepare() const;
  const Chart& operator*() const;
  const Chart* operator->() const { return &**this; }

 private:
  struct Once;
  std::shared_ptr<Once> once_;
};

}  // namespace isect::viz
