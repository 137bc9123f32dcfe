#pragma once
// A chart that is drawn up when it is first looked at: a walk is made far more often than its chart is shown.

#include <functional>
#include <memory>

namespace isect::viz {

struct Chart;

/// None, one that is there, or one that will be made at the first look, once for all copies and from any thread.
class DeferredChart {
 public:
  DeferredChart() = default;
  DeferredChart(std::shared_ptr<const Chart> made);
  /// `make` keeps what it needs: it may run long after the walk was made.
  explicit DeferredChart(std::function<Chart()> make);

  explicit operator bool() const { return once_ != nullptr; }
  const Chart& operator*() const;
  const Chart* operator->() const { return &**this; }

 private:
  struct Once;
  std::shared_ptr<Once> once_;
};

}  // namespace isect::viz
