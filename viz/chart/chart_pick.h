#pragma once
// What a pointer is told at a marker of a chart, or at a point of its curves: the numbers that stand there.

#include <optional>
#include <string>
#include <vector>

#include "viz/chart/chart.h"

namespace isect::viz {

/// A place in a composed chart, and what is told there: plain text, on several lines.
struct ChartMark {
  Vec2 at = Vec2::Zero();
  std::string words = {};
};

/// Returns all such places of a chart, for the same rectangle and theme as compose.
std::vector<ChartMark> marks_of(const Chart&, Vec2 corner, double width, double height, const Theme&);
/// Returns the mark nearest to a pixel, within reach of it; what stands at the same place is told with it.
std::optional<ChartMark> mark_near(const std::vector<ChartMark>&, const Vec2& pixel, double reach = 12);

}  // namespace isect::viz
