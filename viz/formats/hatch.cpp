#include "viz/formats/hatch.h"

#include <cmath>

namespace isect::viz {

std::vector<std::array<Vec2, 2>> hatch_lines(const Fill& fill) {
  Vec2 lo = Vec2::Constant(INFINITY), hi = Vec2::Constant(-INFINITY);
  const auto grow = [&](const Path& path) {
    for (const Vec2& p : flatten(path)) lo = lo.cwiseMin(p), hi = hi.cwiseMax(p);
  };
  grow(fill.path);
  for (const Path& path : fill.more) grow(path);
  std::vector<std::array<Vec2, 2>> lines;
  const double step = fill.hatch_gap * std::sqrt(2.0);
  if (!(step > 0 && hi.x() > lo.x() && hi.y() > lo.y())) return lines;
  for (double k = std::ceil((lo.x() + lo.y()) / step); k * step <= hi.x() + hi.y(); ++k)
    lines.push_back({Vec2(lo.x(), k * step - lo.x()), Vec2(hi.x(), k * step - hi.x())});
  return lines;
}

}  // namespace isect::viz
