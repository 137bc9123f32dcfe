#include "viz/chart/case_key.h"

#include <algorithm>

#include "viz/chart/case_names.h"

namespace isect::viz {
namespace {

constexpr double row_pitch = 1.35, between_entries = 1.4;  ///< in sizes of their text

bool is_on_map(const Cases& cases, int branch) {
  const auto here = [&](const Cases::Spot& spot) { return spot.branch == branch; };
  return !is_thin(cases, branch) || std::ranges::any_of(cases.presets, here) || (cases.here && here(*cases.here));
}

}  // namespace

CaseKey::CaseKey(const ChartInk& ink, const Cases& cases, double width) : numbers_(cases.branches) {
  const double size = ink.sizes().label;
  double used = 0;
  for (int i = 0, next = 1; i < static_cast<int>(cases.branches.size()); ++i) {
    if (!is_on_map(cases, i)) continue;
    numbers_[i] = std::to_string(next++);
    const std::string entry = "**" + numbers_[i] + "** " + cases.branches[i];
    const double own = ink.width(entry, size);
    if (rows_.empty() || used + between_entries * size + own > width)
      rows_.emplace_back(), used = -between_entries * size;
    rows_.back().push_back(entry);
    used += between_entries * size + own;
  }
}

double CaseKey::height(const ChartInk& ink) const {
  return (0.3 + row_pitch * static_cast<double>(rows_.size())) * ink.sizes().label;
}

void CaseKey::draw(ChartInk& ink, double left, double right, double top) const {
  const double size = ink.sizes().label;
  ink.part("chart", "key");
  double y = top + size;
  for (const std::vector<std::string>& row : rows_) {
    double width = between_entries * size * static_cast<double>(row.size() - 1);
    for (const std::string& entry : row) width += ink.width(entry, size);
    double x = (left + right - width) / 2;
    for (const std::string& entry : row) {
      ink.text(entry, {x, y}, {size});
      x += ink.width(entry, size) + between_entries * size;
    }
    y += row_pitch * size;
  }
}

}  // namespace isect::viz
