#include "viz/snapshot/perceived.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace isect::viz {

namespace {

/// Returns the light of an sRGB channel in 0..1.
double light_of(double channel) {
  return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

/// Returns a channel as it looks on white.
double on_white(std::uint8_t channel, std::uint8_t alpha) { return (channel * alpha + 255.0 * (255 - alpha)) / 255; }

/// Returns a share in percent; one that is not 0 is told from none.
std::string percent_of(double share) {
  if (share > 0 && share < 0.001) return "less than 0.1 %";
  const double percent = 100 * share;
  return fmt::format("{:.{}f} %", percent, percent < 10 ? 1 : 0);
}

}  // namespace

std::array<double, 3> oklab(double red, double green, double blue) {
  const double r = light_of(red), g = light_of(green), b = light_of(blue);
  const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
          1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
          0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

Perceived perceived(const Picture& a, const Picture& b, int slack) {
  Perceived found;
  if (a.width != b.width || a.height != b.height || a.rgba.size() != b.rgba.size()) return found;
  found.pixels = a.rgba.size() / 4;
  for (std::size_t i = 0; i + 3 < a.rgba.size(); i += 4) {
    if (std::equal(&a.rgba[i], &a.rgba[i] + 4, &b.rgba[i])) continue;
    std::array<double, 3> was{}, is{};
    for (std::size_t c = 0; c < 3; ++c) {
      is[c] = on_white(b.rgba[i + c], b.rgba[i + 3]);
      const double kept = on_white(a.rgba[i + c], a.rgba[i + 3]);
      was[c] = std::clamp(is[c], kept - slack, kept + slack);
    }
    if (was == is) continue;
    const auto p = oklab(was[0] / 255, was[1] / 255, was[2] / 255), q = oklab(is[0] / 255, is[1] / 255, is[2] / 255);
    const double distance = std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
    ++found.changed;
    found.seen += distance >= just_noticed;
    found.largest = std::max(found.largest, distance);
    found.mean += distance;
  }
  if (found.changed > 0) found.mean /= static_cast<double>(found.changed);
  return found;
}

std::string in_words(const Perceived& p) {
  if (p.pixels == 0) return {};
  if (p.changed == 0) return "no pixel has another colour";
  return fmt::format(
      "{} of the pixels changed visibly; colours differ by up to {:.2f}, by {:.2f} on average (OKLab; {:.2f} is just "
      "noticed)",
      p.seen == 0 ? "none" : percent_of(p.share_seen()), p.largest, p.mean, just_noticed);
}

}  // namespace isect::viz
