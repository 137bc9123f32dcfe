#pragma once
// The key to the numbers that stand for the names of cases on a map: a small map on paper has no room for the names
// themselves.

#include <string>
#include <vector>

#include "viz/chart/chart_parts.h"

namespace isect::viz {

class CaseKey {
 public:
  /// Arranges the key in rows of this width.
  CaseKey(const ChartInk&, const Cases&, double width);

  /// What is written on the map for each branch: its number, or its name if the branch is nowhere on the map.
  const std::vector<std::string>& numbers() const { return numbers_; }
  double height(const ChartInk&) const;
  /// Draws the key in centred rows, from `top` down.
  void draw(ChartInk&, double left, double right, double top) const;

 private:
  std::vector<std::string> numbers_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace isect::viz
