#include "viz/gl/facet_pixels.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace isect::viz {
namespace {

/// Fills the pixels whose middles lie in the facet; neighbouring facets share none, and leave none out.
void fill(Picture& picture, std::array<Vec2, 3> p, const std::array<std::uint8_t, 4>& colour) {
  std::ranges::sort(p, [](const Vec2& a, const Vec2& b) { return a.y() != b.y() ? a.y() < b.y() : a.x() < b.x(); });
  const auto first = [](double from, int count) {  // pixel whose middle is not before
    return static_cast<int>(std::clamp(std::ceil(from - 0.5), 0.0, static_cast<double>(count)));
  };
  const std::array<Vec2, 3> slope = {p[2] - p[0], p[1] - p[0], p[2] - p[1]};
  const auto at = [&](const Vec2& from, const Vec2& way, double y) {
    return from.x() + (y - from.y()) * (way.x() / way.y());
  };
  const int end = first(p[2].y(), picture.height);
  for (int row = first(p[0].y(), picture.height); row < end; ++row) {
    const double y = row + 0.5, one = at(p[0], slope[0], y);
    const double other = y < p[1].y() ? at(p[0], slope[1], y) : at(p[1], slope[2], y);
    const int right = first(std::max(one, other), picture.width);
    std::uint8_t* const pixels = &picture.rgba[4 * static_cast<std::size_t>(row) * picture.width];
    for (int x = first(std::min(one, other), picture.width); x < right; ++x) std::ranges::copy(colour, pixels + 4 * x);
  }
}

}  // namespace

Rastered raster(const Facets& facets, double scale, const PixelBox& part) {
  const auto finite = [&](std::size_t i) {
    return std::all_of(&facets.corners[3 * i], &facets.corners[3 * i] + 3, [](const Vec2& p) { return p.allFinite(); });
  };
  Vec2 lo(part.left + part.width, part.top + part.height), hi(part.left, part.top);
  for (const Vec2& p : facets.corners)
    if (p.allFinite()) lo = lo.cwiseMin(p * scale), hi = hi.cwiseMax(p * scale);
  lo = lo.cwiseMax(Vec2(part.left, part.top)).array().floor();
  hi = hi.cwiseMin(Vec2(part.left + part.width, part.top + part.height)).array().ceil();
  Rastered out{{}, lo / scale};
  if (!(lo.x() < hi.x() && lo.y() < hi.y())) return out;
  out.picture.width = static_cast<int>(hi.x() - lo.x()), out.picture.height = static_cast<int>(hi.y() - lo.y());
  out.picture.rgba.resize(4 * static_cast<std::size_t>(out.picture.width) * out.picture.height);
  const auto byte = [](double x) { return static_cast<std::uint8_t>(std::lround(255 * std::clamp(x, 0.0, 1.0))); };
  for (std::size_t i = 0; i < facets.colours.size(); ++i) {
    if (!finite(i)) continue;
    const Vec2* const p = &facets.corners[3 * i];
    const Colour& c = facets.colours[i];
    fill(out.picture, {p[0] * scale - lo, p[1] * scale - lo, p[2] * scale - lo},
         {byte(c.r), byte(c.g), byte(c.b), 255});
  }
  return out;
}

}  // namespace isect::viz
