#include <algorithm>
#include <cstdlib>

#include "viz/formats/files.h"

namespace isect::viz {

Difference compare(const Picture& a, const Picture& b, int slack) {
  Difference difference;
  if (a.width != b.width || a.height != b.height || a.rgba.size() != b.rgba.size()) {
    difference.same_size = false;
    return difference;
  }
  if (a.rgba == b.rgba) return difference;
  for (std::size_t i = 0; i + 3 < a.rgba.size(); i += 4) {
    int most = 0;
    for (std::size_t c = i; c < i + 4; ++c) most = std::max(most, std::abs(a.rgba[c] - b.rgba[c]));
    difference.over_8 += most > slack + 8;
    difference.over_1 += most > slack + 1;
  }
  return difference;
}

Picture see_through(const Picture& on_black, const Picture& on_white) {
  Picture out = on_black;
  for (std::size_t i = 0; i + 4 <= out.rgba.size(); i += 4) {
    int ground = 255;  // the share of the ground that shows through, the same in each channel up to rounding
    for (std::size_t c = i; c < i + 3; ++c) ground = std::min(ground, on_white.rgba[c] - on_black.rgba[c]);
    const int alpha = 255 - std::max(ground, 0);
    for (std::size_t c = i; c < i + 3; ++c)
      out.rgba[c] = alpha == 0 ? std::uint8_t{0}
                               : static_cast<std::uint8_t>(std::min(255, (255 * on_black.rgba[c] + alpha / 2) / alpha));
    out.rgba[i + 3] = static_cast<std::uint8_t>(alpha);
  }
  return out;
}

Picture difference_picture(const Picture& a, const Picture& b, int slack) {
  Picture out{std::max(a.width, b.width), std::max(a.height, b.height), {}};
  const auto pixel = [](const Picture& p, int x, int y) {
    const bool inside = x < p.width && y < p.height;
    return inside ? &p.rgba[4 * (static_cast<std::size_t>(y) * p.width + x)] : nullptr;
  };
  for (int y = 0; y < out.height; ++y) {
    for (int x = 0; x < out.width; ++x) {
      const std::uint8_t* p = pixel(a, x, y);
      const std::uint8_t* q = pixel(b, x, y);
      int most = p && q ? 0 : 255;
      for (int c = 0; p && q && c < 4; ++c) most = std::max(most, std::abs(p[c] - q[c]));
      const std::uint8_t* shown = p ? p : q;
      const int light = shown ? (299 * shown[0] + 587 * shown[1] + 114 * shown[2]) / 1000 : 255;
      const auto pale = static_cast<std::uint8_t>(170 + light / 5);  // the picture's ghost, for orientation
      if (most > slack + 8)
        out.rgba.insert(out.rgba.end(), {200, 0, 120, 255});
      else if (most > slack)
        out.rgba.insert(out.rgba.end(), {255, 150, 40, 255});
      else
        out.rgba.insert(out.rgba.end(), {pale, pale, pale, 255});
    }
  }
  return out;
}

}  // namespace isect::viz
