#include "app/scene/exact_points.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "viz/lesson.h"

namespace isect::program::scene {

namespace {

bool equal(const Exact& x, const Exact& y) { return (x - y).sign() == 0; }

/// Returns origin w + dir t over w, for w > 0.
ExactPoint along(const ExactVector& origin, const ExactVector& dir, const Exact& t, const Exact& w) {
  ExactPoint p;
  for (std::size_t i = 0; i < 3; ++i) p.x[i] = origin[i] * w + dir[i] * t;
  p.w = w;
  return p;
}

/// Returns "0.75", or "5/3", if root / w is exactly that; else nothing. Both are positive.
std::optional<std::string> ratio_text(const Exact& root, const Exact& w) {
  constexpr std::size_t most_characters = 10;
  constexpr int most_below = 100;
  const double value = quotient(root, w);
  if (!std::isfinite(value)) return {};
  if (equal(Exact(value) * w, root)) {
    const std::string text = viz::to_text(value);
    return text.size() <= most_characters ? std::optional(text) : std::nullopt;
  }
  for (int below = 2; below <= most_below; ++below) {
    const double above = std::round(value * below);
    if (above < 1e6 && equal(Exact(static_cast<double>(below)) * root, Exact(above) * w))
      return viz::to_text(above) + "/" + std::to_string(below);
  }
  return {};
}

std::string about(double value) { return "≈ " + viz::shown(value); }

/// Returns the angle if it is a multiple of 30 or of 45 degrees. No other one has a rational cosine, or one whose
/// square is 1/2 or 3/4. Source: I. Niven, Irrational Numbers (1956), theorem 3.9.
std::optional<int> whole_degrees(const ExactVector& u, const ExactVector& v) {
  const Exact d = dot(u, v);
  if (d.sign() == 0) return 90;
  const Exact square = d * d, all = dot(u, u) * dot(v, v);
  struct Cosine {
    double times, of;
    int degrees;
  };
  for (const Cosine& one : {Cosine{1, 1, 0}, Cosine{4, 3, 30}, Cosine{2, 1, 45}, Cosine{4, 1, 60}})
    if (equal(Exact(one.times) * square, Exact(one.of) * all)) return d.sign() > 0 ? one.degrees : 180 - one.degrees;
  return {};
}

}  // namespace

ExactVector exact_vector(const viz::Vec3& p) { return {Exact(p.x()), Exact(p.y()), Exact(p.z())}; }

ExactPoint exact_point(const viz::Vec3& p) { return {exact_vector(p)}; }

viz::Vec3 nearest_doubles(const ExactPoint& p) {
  return {quotient(p.x[0], p.w), quotient(p.x[1], p.w), quotient(p.x[2], p.w)};
}

Exact dot(const ExactVector& u, const ExactVector& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }

ExactVector from_to(const ExactPoint& a, const ExactPoint& b) {
  ExactVector v;
  for (std::size_t i = 0; i < 3; ++i) v[i] = b.x[i] * a.w - a.x[i] * b.w;
  return v;
}

std::optional<ExactPoint> meeting(const ExactVector& origin, const ExactVector& dir, const ExactVector& n,
                                  const Exact& d) {
  const Exact rate = dot(n, dir), height = dot(n, origin) + d;
  if (rate.sign() == 0) return {};
  return rate.sign() > 0 ? along(origin, dir, -height, rate) : along(origin, dir, height, -rate);
}

ExactPoint foot_on_plane(const ExactPoint& p, const ExactVector& n, const Exact& d) {
  const Exact length2 = dot(n, n), height = dot(n, p.x) + d * p.w;
  ExactPoint foot;
  for (std::size_t i = 0; i < 3; ++i) foot.x[i] = p.x[i] * length2 - n[i] * height;
  foot.w = p.w * length2;
  return foot;
}

ExactPoint foot_on_line(const ExactPoint& p, const ExactVector& origin, const ExactVector& dir,
                        const std::optional<double>& least, const std::optional<double>& most) {
  const Exact length2 = dot(dir, dir);
  ExactVector to_p;  // times p.w
  for (std::size_t i = 0; i < 3; ++i) to_p[i] = p.x[i] - origin[i] * p.w;
  Exact t = dot(to_p, dir), w = p.w * length2;
  if (least && (t - Exact(*least) * w).sign() < 0) t = Exact(*least), w = Exact(1.0);
  if (most && (t - Exact(*most) * w).sign() > 0) t = Exact(*most), w = Exact(1.0);
  return along(origin, dir, t, w);
}

std::string length_text(const ExactPoint& a, const ExactPoint& b) {
  const ExactVector v = from_to(a, b);
  const Exact square = dot(v, v), w = a.w * b.w;
  if (square.sign() == 0) return "0";
  const Exact root = sqrt(square);
  if (equal(root * root, square))
    if (const std::optional<std::string> text = ratio_text(root, w)) return *text;
  return about(quotient(root, w));
}

bool is_right(const ExactVector& u, const ExactVector& v) { return dot(u, v).sign() == 0; }

std::string angle_text(const ExactVector& u, const ExactVector& v) {
  if (const std::optional<int> degrees = whole_degrees(u, v)) return std::to_string(*degrees) + "°";
  const Exact length_u = sqrt(dot(u, u)), length_v = sqrt(dot(v, v));
  viz::Vec3 a, b;
  for (int i = 0; i < 3; ++i)
    a[i] = quotient(u[static_cast<std::size_t>(i)], length_u),
    b[i] = quotient(v[static_cast<std::size_t>(i)], length_v);
  return about(std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / std::numbers::pi) + "°";
}

}  // namespace isect::program::scene
