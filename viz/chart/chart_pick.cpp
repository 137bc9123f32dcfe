#include "viz/chart/chart_pick.h"

#include <algorithm>

#include "viz/chart/chart_parts.h"
#include "viz/text/rich_text.h"

namespace isect::viz {

std::string told_of(const Scale& scale, double value) {
  std::string title = plain(scale.title);
  title.resize(std::min(title.find(". "), title.size()));  // an explanation may follow
  return (title.empty() ? "" : title + ": ") + shown(value);
}

std::vector<ChartMark> marks_of(const Chart& chart, Vec2 corner, double width, double height, const Theme& theme) {
  ChartInk ink(theme);
  const Bounds room = room_of(corner, width, height, theme);
  std::visit([&](const auto& kind) { draw(ink, kind, room); }, chart.kind);
  return ink.marks();
}

std::optional<ChartMark> mark_near(const std::vector<ChartMark>& marks, const Vec2& pixel, double reach) {
  constexpr double same_place = 2;  // px
  constexpr int most = 5;
  const ChartMark* nearest = nullptr;
  for (const ChartMark& mark : marks) {
    const double away = (mark.at - pixel).norm();
    if (away <= reach && (!nearest || away < (nearest->at - pixel).norm())) nearest = &mark;
  }
  if (!nearest) return std::nullopt;
  ChartMark told = *nearest;
  int others = 0;
  for (const ChartMark& mark : marks)
    if (&mark != nearest && (mark.at - nearest->at).norm() <= same_place && ++others <= most)
      told.words += "\n" + mark.words;
  if (others > most) told.words += "\nand " + std::to_string(others - most) + " more";
  return told;
}

}  // namespace isect::viz
