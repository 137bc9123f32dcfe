#pragma once
// The bars beside values and conditions. Bars of one unit share a scale and a look, and the unit is named.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "viz/lesson.h"
#include "viz/window/widgets.h"

namespace isect::viz {

/// A bar scale that several values share: where zero lies and what fills the scale.
struct BarScale {
  double lo = 0, hi = 0;
  void take(double value) {
    if (!std::isfinite(value)) return;
    lo = std::min(lo, value);
    hi = std::max(hi, value);
  }
  /// Returns the position of a value between x0 and x1.
  float at(double value, float x0, float x1) const {
    if (!(hi > lo)) return x0;
    const double share = std::clamp((value - lo) / (hi - lo), 0.0, 1.0);
    return x0 + (x1 - x0) * static_cast<float>(share);
  }
};

/// How a bar is filled, so that bars of different units look different.
enum class BarFill { full, hatched, blocks, hollow };

/// The bars of one unit.
struct UnitBars {
  std::string unit;
  BarFill fill = BarFill::full;
  BarScale scale = {};
};

/// Returns the units of a step's bars in order; no two look alike, as long as there are looks.
std::vector<UnitBars> units_of(const Step&);
/// Returns the bars of the unit in which an inequality is measured: that of the value which is one of its sides; null
/// if none is.
const UnitBars* unit_of(const std::vector<UnitBars>&, const Step&, const Comparison&);

/// Names the units beside the heading, each with a piece of its bar, from the right end on.
void unit_key(Ui&, const std::vector<UnitBars>&, float left, float right, float y);
void value_bar(const Ui&, const UnitBars&, const Value&, float x0, float x1, float y);
/// Draws both sides on one scale: the left one as a bar, the right one as a tick. `unit`: of both, if it is known; its
/// name stands behind them.
void comparison_bar(const Ui&, const Comparison&, const UnitBars* unit, float x0, float x1, float y);

}  // namespace isect::viz
