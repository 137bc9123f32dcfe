#include "viz/colour/measures.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace isect::viz {
namespace {

Eigen::Matrix3d cone_loss(Vision vision) {
  Eigen::Matrix3d m = Eigen::Matrix3d::Identity();
  if (vision == Vision::protan)
    m << 0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116, 1.051998;
  if (vision == Vision::deutan)
    m << 0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940, 0.968881;
  if (vision == Vision::tritan)
    m << 1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367, 0.303900;
  return m;
}

}  // namespace

Vec3 linear_rgb(const Colour& c) {
  const auto linear = [](double x) { return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4); };
  return {linear(c.r), linear(c.g), linear(c.b)};
}

Colour from_linear_rgb(const Vec3& light) {
  const auto channel = [](double x) {
    x = std::clamp(x, 0.0, 1.0);
    return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
  };
  return {channel(light.x()), channel(light.y()), channel(light.z()), 1};
}

double relative_luminance(const Colour& c) {
  const Vec3 light = linear_rgb(c);
  return 0.2126 * light.x() + 0.7152 * light.y() + 0.0722 * light.z();
}

double contrast_ratio(const Colour& a, const Colour& b) {
  const double x = relative_luminance(a), y = relative_luminance(b);
  return (std::max(x, y) + 0.05) / (std::min(x, y) + 0.05);
}

Colour laid_over(const Colour& ground, const Colour& ink) {
  return {ground.r + ink.a * (ink.r - ground.r), ground.g + ink.a * (ink.g - ground.g),
          ground.b + ink.a * (ink.b - ground.b), 1};
}

Vec3 cie_lab(const Colour& c) {
  Eigen::Matrix3d to_xyz;
  to_xyz << 0.4124564, 0.3575761, 0.1804375, 0.2126729, 0.7151522, 0.0721750, 0.0193339, 0.1191920, 0.9503041;
  const Vec3 white(0.95047, 1, 1.08883);
  const Vec3 xyz = to_xyz * linear_rgb(c);
  const auto f = [](double t) { return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116; };
  const Vec3 v(f(xyz.x() / white.x()), f(xyz.y() / white.y()), f(xyz.z() / white.z()));
  return {116 * v.y() - 16, 500 * (v.x() - v.y()), 200 * (v.y() - v.z())};
}

std::string name_of(Vision vision) {
  constexpr std::array names = {"all cones", "protanopia", "deuteranopia", "tritanopia", "grey print"};
  return names.at(static_cast<std::size_t>(vision));
}

Colour seen_by(Vision vision, const Colour& c) {
  if (vision == Vision::usual) return c.with_alpha(1);
  if (vision == Vision::grey) return from_linear_rgb(Vec3::Constant(relative_luminance(c)));
  return from_linear_rgb(cone_loss(vision) * linear_rgb(c));
}

double distance_seen(Vision vision, const Colour& a, const Colour& b) {
  return (cie_lab(seen_by(vision, a)) - cie_lab(seen_by(vision, b))).norm();
}

Vec3 oklab(const Colour& c) {
  Eigen::Matrix3d to_cones, to_lab;
  to_cones << 0.4122214708, 0.5363325363, 0.0514459929, 0.2119034982, 0.6806995451, 0.1073969566, 0.0883024619,
      0.2817188376, 0.6299787005;
  to_lab << 0.2104542553, 0.7936177850, -0.0040720468, 1.9779984951, -2.4285922050, 0.4505937099, 0.0259040371,
      0.7827717662, -0.8086757660;
  const Vec3 cones = to_cones * linear_rgb(c);
  return to_lab * Vec3(std::cbrt(cones.x()), std::cbrt(cones.y()), std::cbrt(cones.z()));
}

}  // namespace isect::viz
