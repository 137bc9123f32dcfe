#include "viz/colour/shades.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace isect::viz {
namespace {

/// Returns the light of a colour, which leaves 0..1 where no screen shows it.
Vec3 light_of(const Oklch& c) {
  Eigen::Matrix3d to_cones, to_rgb;
  to_cones << 1, 0.3963377774, 0.2158037573, 1, -0.1055613458, -0.0638541728, 1, -0.0894841775, -1.2914855480;
  to_rgb << 4.0767416621, -3.3077115913, 0.2309699292, -1.2684380046, 2.6097574011, -0.3413193965, -0.0041960863,
      -0.7034186147, 1.7076147010;
  const Vec3 cones = to_cones * Vec3(c.lightness, c.chroma * std::cos(c.hue), c.chroma * std::sin(c.hue));
  return to_rgb *
         Vec3(cones.x() * cones.x() * cones.x(), cones.y() * cones.y() * cones.y(), cones.z() * cones.z() * cones.z());
}

bool can_be_shown(const Oklch& c) {
  constexpr double slack = 1e-4;  // far less than one level of 256
  const Vec3 light = light_of(c);
  return light.minCoeff() >= -slack && light.maxCoeff() <= 1 + slack;
}

void nearest_first(std::vector<Shade>& all) { std::ranges::stable_sort(all, std::less<>(), &Shade::away); }

}  // namespace

Oklch oklch(const Colour& c) {
  const Vec3 lab = oklab(c);
  return {lab.x(), std::hypot(lab.y(), lab.z()), std::atan2(lab.z(), lab.y())};
}

Colour from_oklch(Oklch c) {
  constexpr int halvings = 24;
  c.lightness = std::clamp(c.lightness, 0.0, 1.0);
  if (!can_be_shown(c)) {
    double shown = 0, hidden = c.chroma;
    for (int i = 0; i < halvings; ++i) {
      c.chroma = (shown + hidden) / 2;
      (can_be_shown(c) ? shown : hidden) = c.chroma;
    }
    c.chroma = shown;
  }
  const Colour exact = from_linear_rgb(light_of(c));
  const auto level = [](double x) { return std::round(255 * x) / 255; };
  return {level(exact.r), level(exact.g), level(exact.b), 1};
}

double oklab_distance(const Colour& a, const Colour& b) { return (oklab(a) - oklab(b)).norm(); }

std::vector<Shade> shades_of(const Colour& c) {
  constexpr int steps = 200;
  const Oklch own = oklch(c);
  std::vector<Shade> all = {{c.with_alpha(1), 0}};
  for (int i = 0; i <= steps; ++i) {
    const Colour shade = from_oklch({static_cast<double>(i) / steps, own.chroma, own.hue});
    all.push_back({shade, oklab_distance(shade, c)});
  }
  nearest_first(all);
  return all;
}

std::vector<Shade> greys_near(const Colour& c) {
  std::vector<Shade> all;
  for (unsigned level = 0; level < 256; ++level) {
    const Colour grey = hex(level * 0x010101);
    all.push_back({grey, oklab_distance(grey, c)});
  }
  nearest_first(all);
  return all;
}

std::vector<Shade> hues_near(const Colour& c) {
  constexpr int hues = 24, lights = 20;
  constexpr double least_chroma = 0.08;  // a grey has a hue, too, but nobody sees it
  const Oklch own = oklch(c);
  std::vector<Shade> all = {{c.with_alpha(1), 0}};
  for (int hue = 0; hue < hues; ++hue)
    for (int light = 0; light <= lights; ++light)
      for (const double share : {1.0, 0.7}) {
        const Colour near = from_oklch({static_cast<double>(light) / lights, share * std::max(own.chroma, least_chroma),
                                        own.hue + 2 * std::numbers::pi * hue / hues});
        all.push_back({near, oklab_distance(near, c)});
      }
  nearest_first(all);
  return all;
}

std::optional<Colour> nearest_that(const std::vector<Shade>& shades, const std::function<bool(const Colour&)>& passes) {
  const auto found = std::ranges::find_if(shades, [&](const Shade& shade) { return passes(shade.colour); });
  return found == shades.end() ? std::nullopt : std::optional(found->colour);
}

}  // namespace isect::viz
