#include "viz/gl/tessellate.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace isect::viz {
namespace {

constexpr double pi = std::numbers::pi;

/// More pieces than this in one shape cannot be told apart in any picture; they would only cost time.
constexpr double most_pieces = 20000;

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Returns `v` turned by a quarter turn, from +x towards +y.
Vec2 turned(const Vec2& v) { return {-v.y(), v.x()}; }

/// Returns the signed angle from direction `a` to direction `b`, in (-pi, pi].
double angle(const Vec2& a, const Vec2& b) { return std::atan2(cross(a, b), a.dot(b)); }

void add(Triangles& to, const Vec2& a, const Vec2& b, const Vec2& c) { to.insert(to.end(), {a, b, c}); }

void add_quad(Triangles& to, const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  add(to, a, b, c);
  add(to, a, c, d);
}

/// Adds the sector that `arm` sweeps about `center` when turned by `sweep`.
void add_sector(Triangles& to, const Vec2& center, const Vec2& arm, double sweep, double tolerance) {
  const double radius = arm.norm();
  const double step = 2 * std::acos(1 - std::min(0.5, tolerance / radius));
  const int count = std::max(1, static_cast<int>(std::ceil(std::abs(sweep) / step)));
  Vec2 from = center + arm;
  for (int i = 1; i <= count; ++i) {
    const double at = sweep * i / count;
    const Vec2 next = center + std::cos(at) * arm + std::sin(at) * turned(arm);
    add(to, center, from, next);
    from = next;
  }
}

/// Returns the length of the line up to each of its points, the closing edge included.
std::vector<double> arc_lengths(const Polyline& line) {
  std::vector<double> lengths = {0};
  const std::size_t n = line.points.size();
  for (std::size_t i = 1; i < n + (line.closed ? 1 : 0); ++i)
    lengths.push_back(lengths.back() + (line.points[i % n] - line.points[i - 1]).norm());
  return lengths;
}

/// Returns the piece of the line between two arc lengths, from <= to.
Polyline piece(const Polyline& line, const std::vector<double>& lengths, double from, double to) {
  const std::size_t n = line.points.size();
  const auto at = [&](double s, std::size_t edge) -> Vec2 {
    const Vec2& a = line.points[edge];
    const Vec2& b = line.points[(edge + 1) % n];
    const double share = (s - lengths[edge]) / (lengths[edge + 1] - lengths[edge]);
    return (1 - share) * a + share * b;
  };
  const auto edge_of = [&](double s) {
    const auto after = std::upper_bound(lengths.begin() + 1, lengths.end() - 1, s);
    return static_cast<std::size_t>(after - lengths.begin()) - 1;
  };
  const std::size_t first = edge_of(from), last = edge_of(to);
  Polyline out{{at(from, first)}, false};
  const auto append = [&](const Vec2& p) {
    if (p != out.points.back()) out.points.push_back(p);
  };
  for (std::size_t i = first + 1; i <= last; ++i) append(line.points[i % n]);
  append(at(to, last));
  return out;
}

}  // namespace

Polyline flat(const Path& path, double tolerance) {
  if (path.segments.empty()) return {};
  Polyline line{{}, path.closed};
  for (const Vec2& p : flatten(path, tolerance)) {
    if (!p.allFinite()) return {};
    if (line.points.empty() || p != line.points.back()) line.points.push_back(p);
  }
  while (line.closed && line.points.size() > 1 && line.points.front() == line.points.back()) line.points.pop_back();
  return line;
}

Polyline thinned(const Polyline& line, double tolerance) {
  if (line.points.size() < 3) return line;
  Polyline out{{line.points.front()}, line.closed};
  // From the point kept last, a chord in any of the directions between `right` and `left` passes all points since,
  // within the tolerance.
  Vec2 right, left;
  double far = 0;  // of the points since
  for (std::size_t i = 1; i < line.points.size(); ++i) {
    Vec2 way = line.points[i] - out.points.back();
    if (far > 0 && !(way.norm() >= far && cross(right, way) >= 0 && cross(way, left) >= 0)) {
      out.points.push_back(line.points[i - 1]);
      way = line.points[i] - line.points[i - 1];
      far = 0;
    }
    const double length = way.norm();
    if (length <= tolerance) continue;
    const Vec2 reach = std::sqrt(length * length - tolerance * tolerance) * way, aside = tolerance * turned(way);
    if (const Vec2 side = reach - aside; far == 0 || cross(right, side) > 0) right = side;
    if (const Vec2 side = reach + aside; far == 0 || cross(side, left) > 0) left = side;
    far = length;
  }
  if (out.points.back() != line.points.back()) out.points.push_back(line.points.back());
  return out;
}

bool is_convex(const std::vector<Vec2>& outline) {
  const std::size_t n = outline.size();
  if (n < 4) return true;
  double turns = 0, sign = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 in = outline[(i + 1) % n] - outline[i];
    const Vec2 out = outline[(i + 2) % n] - outline[(i + 1) % n];
    const double turn = angle(in, out);
    if (turn * sign < 0) return false;
    if (turn != 0) sign = turn;
    turns += turn;
  }
  return std::abs(std::abs(turns) - 2 * pi) < 0.1;  // a star that turns one way only goes round twice or more
}

Triangles triangulated(std::vector<Vec2> outline) {
  // Cut off every second corner until three are left: rounder than a fan's triangles, so quicker to draw.
  Triangles out;
  while (outline.size() >= 3) {
    std::vector<Vec2> rest;
    for (std::size_t i = 0; i < outline.size(); i += 2) {
      rest.push_back(outline[i]);
      if (i + 1 < outline.size()) add(out, outline[i], outline[i + 1], outline[(i + 2) % outline.size()]);
    }
    outline = std::move(rest);
  }
  return out;
}

std::vector<Polyline> dashes(const Polyline& line, const std::array<double, 2>& dash) {
  const auto [on, off] = dash;
  if (!(on > 0 && off > 0 && std::isfinite(off)) || line.points.size() < 2) return {line};
  const std::vector<double> lengths = arc_lengths(line);
  const double total = lengths.back(), period = on + off;
  if (on >= total || !(total / period < most_pieces)) return {line};

  std::vector<Polyline> pieces;
  for (int i = 0; i * period < total; ++i) {
    const double from = i * period, to = std::min(from + on, total);
    pieces.push_back(piece(line, lengths, from, to));
  }

  const double last_end = (static_cast<double>(pieces.size()) - 1) * period + on;
  if (line.closed && last_end >= total && pieces.size() > 1) {
    std::vector<Vec2>& last = pieces.back().points;
    const std::vector<Vec2>& first = pieces.front().points;
    last.insert(last.end(), first.begin() + (last.back() == first.front() ? 1 : 0), first.end());
    pieces.erase(pieces.begin());
  }
  return pieces;
}

Triangles stroke(const Polyline& line, double width, bool round_cap, double tolerance) {
  Triangles out;
  const double half = width / 2;
  const std::vector<Vec2>& points = line.points;
  const std::size_t n = points.size();
  if (!(half > 0) || n == 0) return out;
  if (n == 1) {
    if (round_cap) add_sector(out, points[0], {half, 0}, 2 * pi, tolerance);
    return out;
  }

  // An arm reaches from the line to its border, half a width to the side.
  const std::size_t edges = line.closed ? n : n - 1;
  std::vector<Vec2> arms, starts, ends;
  for (std::size_t i = 0; i < edges; ++i) arms.push_back(half * turned((points[(i + 1) % n] - points[i]).normalized()));
  starts = ends = arms;

  for (std::size_t i = 0; i < (line.closed ? n : n - 2); ++i) {
    const std::size_t next = (i + 1) % n;
    const Vec2 &at = points[next], &in = arms[i], &out_of = arms[next];
    const double turn = angle(in, out_of);
    const double shorter = std::min((at - points[i]).norm(), (points[(next + 1) % n] - at).norm());
    if (half / std::cos(turn / 2) - half < tolerance && half * std::tan(std::abs(turn) / 2) < shorter)
      ends[i] = starts[next] = (in + out_of) / (1 + std::cos(turn));  // a mitre can't be told from an arc
    else
      add_sector(out, at, turn > 0 ? Vec2(-in) : in, turn, tolerance);  // the gap opens on the outside
  }
  for (std::size_t i = 0; i < edges; ++i) {
    const Vec2 &a = points[i], &b = points[(i + 1) % n];
    add_quad(out, a - starts[i], b - ends[i], b + ends[i], a + starts[i]);
  }
  if (!line.closed && round_cap) {
    add_sector(out, points.front(), arms.front(), pi, tolerance);
    add_sector(out, points.back(), -arms.back(), pi, tolerance);
  }
  return out;
}

Box bounds(const std::vector<Vec2>& points) {
  Box box{points.front(), points.front()};
  for (const Vec2& p : points) box = {box.low.cwiseMin(p), box.high.cwiseMax(p)};
  return box;
}

Triangles cover(const Box& box) {
  Triangles out;
  add_quad(out, box.low, {box.high.x(), box.low.y()}, box.high, {box.low.x(), box.high.y()});
  return out;
}

Triangles hatch(const Box& box, double gap, double width) {
  Triangles out;
  const double step = gap * std::numbers::sqrt2;
  const double low = box.low.sum() - width, high = box.high.sum() + width;
  if (!(gap > 0 && width > 0) || !((high - low) / step < most_pieces)) return out;

  const Vec2 arm = Vec2(width, width) / (2 * std::numbers::sqrt2);
  for (double k = std::ceil(low / step); k * step <= high; ++k) {
    const double sum = k * step;
    const double left = std::max(box.low.x(), sum - box.high.y()) - width;
    const double right = std::min(box.high.x(), sum - box.low.y()) + width;
    const Vec2 a(left, sum - left), b(right, sum - right);
    add_quad(out, a - arm, b - arm, b + arm, a + arm);
  }
  return out;
}

}  // namespace isect::viz
