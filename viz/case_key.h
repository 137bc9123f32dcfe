#pragma once
// What explains the numbers that stand on a map of cases in place of names, where a small one on paper has no room for
// these.

#include <string>
#include <vector>

#include "viz/chart_parts.h"

namespace isect::viz {

class CaseKey {
 public:
  /// In rows of this width.
  CaseKey(const ChartInk&, const Cases&, double width);

  /// What is written on the map for each branch: its number; of one that is nowhere on the map, its name.
  const std::vector<std::string>& numbers() const { return numbers_; }
  double height(const ChartInk&) const;
  /// In centred rows, from `top` down.
  void draw(ChartInk&, double left, double right, double top) const;

 private:
  std::vector<std::string> numbers_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace isect::viz
