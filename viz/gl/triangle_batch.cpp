#include "viz/gl/triangle_batch.h"

#include <algorithm>

namespace isect::viz {
namespace {

constexpr double tolerance_px = 0.08;

/// A pen. One thinner than a pixel would fall between the samples: it is made a pixel wide and as much fainter.
struct Nib {
  double width;
  Colour colour;
};
Nib visible(double width, const Colour& colour, double scale) {
  const double pixels = width * scale;
  if (!(pixels > 0 && pixels < 1)) return {width, colour};
  return {1 / scale, colour.with_alpha(colour.a * pixels)};
}

/// Flattens the path; of very many points it keeps those that can be told apart.
Polyline seen(const Path& path, double scale) {
  constexpr std::size_t many = 1000;
  const double tolerance = tolerance_px / scale;
  Polyline line = flat(path, tolerance);
  return line.points.size() > many ? thinned(line, tolerance) : line;
}

Pass pass_of(const Colour& colour) { return colour.a >= 1 ? Pass::opaque : Pass::paint; }

/// Whether no two triangles of a stroke overlap: those of a straight line, or those of its dashes if no round cap
/// reaches into the next dash.
bool apart(const std::vector<Polyline>& lines, bool round_cap) {
  return (lines.size() == 1 || !round_cap) &&
         std::ranges::all_of(lines, [](const Polyline& l) { return l.points.size() == 2 && !l.closed; });
}

Vertex vertex(const Vec2& p, const Vec2& uv, const Colour& c) {
  const auto f = [](double x) { return static_cast<float>(x); };
  return {f(p.x()), f(p.y()), f(uv.x()), f(uv.y()), f(c.r), f(c.g), f(c.b), f(c.a)};
}

/// Moves a focus off the rim, where the colour would be undefined.
Vec2 well_inside(const Vec2& focus) {
  constexpr double most = 0.99;
  if (!focus.allFinite()) return Vec2::Zero();
  return focus.norm() > most ? Vec2(focus * (most / focus.norm())) : focus;
}

}  // namespace

void TriangleBatch::add(const Fill& fill) {
  std::vector<Vec2> outline = seen(fill.path, scale_).points;
  if (outline.size() < 3) return;
  const Nib nib = visible(fill.hatch_line, fill.hatch_colour, scale_);
  Triangles triangles = triangulated(outline);
  const bool simple = fill.more.empty() && is_convex(outline);
  for (const Path& path : fill.more) {
    const std::vector<Vec2> ring = seen(path, scale_).points;
    if (ring.size() < 3) continue;
    const Triangles more = triangulated(ring);
    triangles.insert(triangles.end(), more.begin(), more.end());
    outline.insert(outline.end(), ring.begin(), ring.end());
  }
  const Box box = bounds(outline);
  const Triangles lines = hatch(box, fill.hatch_gap, nib.width);
  if (lines.empty() && simple) return add(pass_of(fill.colour), triangles, fill.colour);

  add(fill.more.empty() ? Pass::winding : Pass::parity, triangles, {});
  if (lines.empty()) return add(Pass::finish, cover(box), fill.colour);
  add(Pass::inside, cover(box), fill.colour);
  add(Pass::inside, lines, nib.colour);
  add(Pass::wipe, cover(box), {});
}

void TriangleBatch::add(const Stroke& s) {
  const double tolerance = tolerance_px / scale_;
  const Nib nib = visible(s.width, s.colour, scale_);
  const std::vector<Polyline> lines = dashes(seen(s.path, scale_), s.dash);
  Triangles triangles;
  for (const Polyline& line : lines) {
    const Triangles more = stroke(line, nib.width, s.round_cap, tolerance);
    triangles.insert(triangles.end(), more.begin(), more.end());
  }
  const bool blends_twice = nib.colour.a < 1 && !apart(lines, s.round_cap);
  add(blends_twice ? Pass::once : pass_of(nib.colour), triangles, nib.colour);
}

void TriangleBatch::add(const Gradient& gradient) {
  const double major = gradient.major.squaredNorm(), minor = gradient.minor.squaredNorm();
  if (!(major > 0 && minor > 0)) return;
  Eigen::Matrix2d to_circle;
  to_circle << gradient.major.transpose() / major, gradient.minor.transpose() / minor;
  const Path rim = ellipse(gradient.center, gradient.major, gradient.minor);
  const Triangles triangles = triangulated(flat(rim, tolerance_px / scale_).points);

  Call& here = call(Pass::gradient);
  here.radial = {well_inside(to_circle * (gradient.focus - gradient.center)), gradient.inner, gradient.outer};
  here.count = static_cast<int>(triangles.size());
  for (const Vec2& p : triangles) vertices_.push_back(vertex(p, to_circle * (p - gradient.center), {}));
}

void TriangleBatch::add(const Facets& facets) {
  if (facets.colours.empty()) return;
  call(Pass::opaque);
  vertices_.reserve(vertices_.size() + facets.corners.size());
  for (std::size_t i = 0; i < facets.colours.size(); ++i) {
    const Vec2* const p = &facets.corners[3 * i];
    if (!p[0].allFinite() || !p[1].allFinite() || !p[2].allFinite()) continue;
    for (int k = 0; k < 3; ++k) vertices_.push_back(vertex(p[k], Vec2::Zero(), facets.colours[i]));
    calls_.back().count += 3;
  }
}

void TriangleBatch::add_image(unsigned image, const Box& box) {
  Call& here = call(Pass::image);
  here.image = image;
  here.count = 6;
  const Vec2 size = box.high - box.low;
  for (const Vec2& p : cover(box)) vertices_.push_back(vertex(p, (p - box.low).cwiseQuotient(size), {}));
}

void TriangleBatch::add(Pass pass, const Triangles& triangles, const Colour& colour) {
  if (triangles.empty()) return;
  call(pass).count += static_cast<int>(triangles.size());
  for (const Vec2& p : triangles) vertices_.push_back(vertex(p, Vec2::Zero(), colour));
}

Call& TriangleBatch::call(Pass pass) {
  // `once` marks one shape; two shapes that overlap must blend twice.
  const bool joins = pass == Pass::paint || pass == Pass::opaque || pass == Pass::inside || pass == Pass::wipe;
  if (calls_.empty() || calls_.back().pass != pass || !joins)
    calls_.push_back({.pass = pass, .first = static_cast<int>(vertices_.size())});
  return calls_.back();
}

}  // namespace isect::viz
