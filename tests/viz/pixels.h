#pragma once
// Helpers of tests that look at pictures.

#include <algorithm>
#include <cstdlib>

#include "viz/gl/offscreen.h"

namespace isect::viz {

constexpr Colour black{0, 0, 0, 1}, white{1, 1, 1, 1};

/// An OpenGL context shared by a program's tests.
inline Offscreen& offscreen() {
  static Offscreen one;
  return one;
}

inline Drawing drawing_of(std::vector<Shape> shapes, double width = 200, double height = 120) {
  return {width, height, white, std::move(shapes)};
}

inline int channel(const Picture& p, int x, int y, int c) {
  return p.rgba[4 * (static_cast<std::size_t>(y) * p.width + x) + c];
}

/// How dark a pixel is, from 0 (white) to 1 (black), by its green channel.
inline double ink(const Picture& p, int x, int y) { return (255 - channel(p, x, y, 1)) / 255.0; }

/// All the ink of a picture, in pixels.
inline double ink(const Picture& p) {
  double sum = 0;
  for (int y = 0; y < p.height; ++y)
    for (int x = 0; x < p.width; ++x) sum += ink(p, x, y);
  return sum;
}

/// The greatest difference in any channel of any pixel; 256 for pictures of different size.
inline int difference(const Picture& a, const Picture& b) {
  if (a.width != b.width || a.height != b.height) return 256;
  int most = 0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) most = std::max(most, std::abs(a.rgba[i] - b.rgba[i]));
  return most;
}

/// The box of all pixels with more than a trace of ink.
inline TextBox ink_box(const Picture& p) {
  TextBox box{1e9, 1e9, -1e9, -1e9};
  for (int y = 0; y < p.height; ++y)
    for (int x = 0; x < p.width; ++x)
      if (ink(p, x, y) > 0.05)
        box = {std::min<double>(box.left, x), std::min<double>(box.top, y), std::max<double>(box.right, x + 1),
               std::max<double>(box.bottom, y + 1)};
  return box;
}

/// One of everything: fills, strokes, dashes, a gradient, a hatch, translucent crossings and text.
inline Drawing one_of_everything(double width = 320, double height = 200) {
  const Vec2 u(width / 320, 0), v(0, height / 200);
  const auto at = [&](double x, double y) -> Vec2 { return x * u + y * v; };
  const Colour blue{0.04, 0.38, 0.78, 1}, orange{0.64, 0.3, 0, 1}, green{0, 0.38, 0.29, 1};
  const Colour translucent = green.with_alpha(0.4);
  Drawing d{width, height, white, {}};
  d.shapes = {Gradient{at(160, 100), 70 * u, 70 * v, at(140, 70), orange.with_alpha(0.02), orange.with_alpha(0.4)},
              Stroke{ellipse(at(160, 100), 70 * u, 26 * v), orange.with_alpha(0.6), 1, {4, 3}, false},
              Stroke{ellipse(at(160, 100), 70 * u, 70 * v), orange, 2},
              Stroke{polyline({at(20, 120), at(290, 70)}), blue, 2.5},
              Fill{polyline({at(300, 68), at(286, 75), at(289, 70), at(284, 66)}, true), blue},
              Stroke{polyline({at(20, 190), at(60, 140), at(90, 190), at(20, 150), at(90, 150)}), translucent, 8},
              Fill{polyline({at(30, 20), at(80, 20), at(40, 60), at(55, 5), at(70, 60)}, true), blue.with_alpha(0.3)},
              Fill{polyline({at(240, 130), at(300, 140), at(290, 190), at(245, 180)}, true), orange.with_alpha(0.15), 6,
                   0.8, black},
              Text{"*t*_1 ≤ **d**", at(160, 40), 18, black, 0.5, false, 3, white},
              Text{"Two roots", at(250, 30), 18, black, 0.5, true}};
  return d;
}

}  // namespace isect::viz
