#pragma once
// A chart that is made at its first use: a walk is made far more often than its chart is shown.

#include <functional>
#include <memory>
#include <optional>

namespace isect::viz {

struct Chart;

/// Empty, ready, or made at the first access: once for all copies, and from any thread.
class DeferredChart {
 public:
  DeferredChart() = default;
  DeferredChart(std::shared_ptr<const Chart> made);
  /// Makes the chart in parts: each call of `part` does some of the work, and the last one returns the chart. It must
  /// own what it uses: it may run long after the walk was made.
  explicit DeferredChart(std::function<std::optional<Chart>()> part);

  explicit operator bool() const { return once_ != nullptr; }
  /// Does one of the remaining parts; returns false if none was left. There must be a chart.
  bool prepare() const;
  const Chart& operator*() const;
  const Chart* operator->() const { return &**this; }

 private:
  struct Once;
  std::shared_ptr<Once> once_;
};

}  // namespace isect::viz
