#include "lessons/speed_against_error/sketch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <isect/convex_hull.h>
#include "lessons/shared/flat.h"

namespace isect::lessons::speed_against_error_lesson {

namespace {

constexpr double sketch_width = 2.2, sketch_height = 1.4;

/// Sines and powers differ from machine to machine in their last digits.
double settled(double x) { return std::round(x * 0x1p20) * 0x1p-20; }

}  // namespace

void Sketch::ring(std::vector<viz::Vec2> corners, viz::Role role, bool dotted) {
  pieces_.push_back({Piece::Kind::ring, std::move(corners), role, viz::Pen::solid, 0, dotted});
}
void Sketch::line(const viz::Vec2& from, const viz::Vec2& to, viz::Role role, viz::Pen pen) {
  pieces_.push_back({Piece::Kind::line, {from, to}, role, pen});
}
void Sketch::arrow(const viz::Vec2& from, const viz::Vec2& to, viz::Role role) {
  pieces_.push_back({Piece::Kind::arrow, {from, to}, role});
}
void Sketch::circle(const viz::Vec2& center, double radius, viz::Role role) {
  pieces_.push_back({Piece::Kind::circle, {center}, role, viz::Pen::solid, radius});
}
void Sketch::dot(const viz::Vec2& at, viz::Role role) { pieces_.push_back({Piece::Kind::dot, {at}, role}); }

std::vector<viz::Item> Sketch::items() const {
  viz::Vec2 lo = viz::Vec2::Constant(INFINITY), hi = -lo;
  for (const Piece& piece : pieces_)
    for (const viz::Vec2& p : piece.points) {
      const viz::Vec2 reach = viz::Vec2::Constant(piece.radius);
      lo = lo.cwiseMin(p - reach), hi = hi.cwiseMax(p + reach);
    }
  const viz::Vec2 size = hi - lo, room = {sketch_width, sketch_height};
  const viz::Vec2 fit = room.cwiseQuotient(size.cwiseMax(1e-300));
  const viz::Vec2 scale = stretched_ ? fit : viz::Vec2(viz::Vec2::Constant(fit.minCoeff()));
  const auto at = [&](const viz::Vec2& p) -> viz::Vec3 {
    const viz::Vec2 q = (p - (lo + size / 2)).cwiseProduct(scale);
    return {settled(q.x()), settled(q.y()), 0};
  };

  std::vector<viz::Item> all;
  for (const Piece& piece : pieces_) {
    std::vector<viz::Vec3> points;
    for (const viz::Vec2& p : piece.points) points.push_back(at(p));
    switch (piece.kind) {
      case Piece::Kind::ring: {
        viz::Region region;
        region.rings = {points, {points[0], points[0], points[0]}};  // the second asks for the even-odd rule
        region.role = piece.role, region.corners = piece.dotted;
        all.emplace_back(region);
        break;
      }
      case Piece::Kind::line:
        all.emplace_back(viz::Line{points[0], points[1], piece.role, piece.pen});
        break;
      case Piece::Kind::arrow:
        all.emplace_back(viz::Arrow{points[0], points[1], piece.role});
        break;
      case Piece::Kind::circle:
        all.emplace_back(viz::Circle{points[0], settled(piece.radius * scale.x()), piece.role, viz::Pen::solid, true});
        break;
      case Piece::Kind::dot:
        all.emplace_back(viz::Dot{points[0], viz::Mark::disc, piece.role});
        break;
    }
  }
  return all;
}

namespace {

double of_two_digits(double x) { return std::stod(fmt::format("{:.1e}", x)); }

}  // namespace

std::string about(double x) {
  const double rounded = of_two_digits(x);
  return (rounded == x ? "" : "≈ ") + viz::shown(rounded);
}

std::string is_about(const std::string& name, double x, double y) {
  const double a = of_two_digits(x), b = of_two_digits(y);
  return name + (a == x && b == y ? " = " : " ≈ ") + viz::shown(a) + (x == y ? "" : " and " + viz::shown(b));
}

void Shadow::draw(Sketch& sketch, viz::Role role) const {
  sketch.ring(outline, role);
  for (const auto& [from, to] : edges) sketch.line(from, to, role, viz::Pen::hairline);
}

Shadow shadow(const std::array<viz::Vec2, 8>& corners) {
  Shadow seen;
  const Ring<double, 2> points(corners.begin(), corners.end());
  seen.outline = convex_hull(points);
  for (std::size_t i = 0; i < corners.size(); ++i)
    for (const std::size_t bit : {1u, 2u, 4u})
      if ((i & bit) == 0) seen.edges.push_back({corners[i], corners[i | bit]});
  return seen;
}

}  // namespace isect::lessons::speed_against_error_lesson
