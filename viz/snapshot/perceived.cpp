#include "viz/snapshot/perceived.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "viz/colour/measures.h"

namespace isect::viz {

namespace {

/// Returns a channel as it looks on white.
double on_white(std::uint8_t channel, std::uint8_t alpha) { return (channel * alpha + 255.0 * (255 - alpha)) / 255; }

/// Returns the place in OKLab of a colour whose channels go up to 255.
Vec3 place_of(const Vec3& rgb) { return oklab({rgb[0] / 255, rgb[1] / 255, rgb[2] / 255}); }

/// Returns a share in percent; one that is not 0 is told from none.
std::string percent_of(double share) {
  if (share > 0 && share < 0.001) return "less than 0.1 %";
  const double percent = 100 * share;
  return fmt::format("{:.{}f} %", percent, percent < 10 ? 1 : 0);
}

}  // namespace

Perceived perceived(const Picture& a, const Picture& b, int slack) {
  Perceived found;
  if (a.width != b.width || a.height != b.height || a.rgba.size() != b.rgba.size()) return found;
  found.pixels = a.rgba.size() / 4;
  for (std::size_t i = 0; i + 3 < a.rgba.size(); i += 4) {
    if (std::equal(&a.rgba[i], &a.rgba[i] + 4, &b.rgba[i])) continue;
    Vec3 was, is;
    for (int c = 0; c < 3; ++c) {
      is[c] = on_white(b.rgba[i + c], b.rgba[i + 3]);
      const double kept = on_white(a.rgba[i + c], a.rgba[i + 3]);
      was[c] = std::clamp(is[c], kept - slack, kept + slack);
    }
    if (was == is) continue;
    const double distance = (place_of(was) - place_of(is)).norm();
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
