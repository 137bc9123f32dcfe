#include "viz/drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace isect::viz {
namespace {

/// Returns how many chords are needed so that none is further than `tolerance` from the cubic: second differences bound
/// the second derivative, and a chord over 1/n of the curve misses it by at most 3/4 of their length over n^2. Source:
/// G. Wang, "The subdivision method for finding the intersection between two Bezier curves or surfaces", Zhejiang
/// University Journal (1984).
int chords(const Vec2& from, const Path::Cubic& cubic, double tolerance) {
  const Vec2 first = from - 2 * cubic.control1 + cubic.control2;
  const Vec2 second = cubic.control1 - 2 * cubic.control2 + cubic.to;
  const double bend = std::max(first.norm(), second.norm());
  const double count = std::ceil(std::sqrt(0.75 * bend / tolerance));
  constexpr double most = 4096;
  if (!(count >= 1)) return 1;  // a straight cubic, or NaN
  return static_cast<int>(std::min(count, most));
}

Vec2 point_on(const Vec2& from, const Path::Cubic& cubic, double u) {
  const double v = 1 - u;
  return v * v * v * from + 3 * v * v * u * cubic.control1 + 3 * v * u * u * cubic.control2 + u * u * u * cubic.to;
}

void move(Path& path, const Vec2& by) {
  path.start += by;
  for (Path::Segment& segment : path.segments) {
    if (Vec2* to = std::get_if<Vec2>(&segment)) {
      *to += by;
    } else {
      Path::Cubic& cubic = std::get<Path::Cubic>(segment);
      cubic.control1 += by, cubic.control2 += by, cubic.to += by;
    }
  }
}

struct Shift {
  Vec2 by;
  void operator()(Fill& fill) const {
    move(fill.path, by);
    for (Path& path : fill.more) move(path, by);
  }
  void operator()(Stroke& stroke) const { move(stroke.path, by); }
  void operator()(Gradient& g) const { g.center += by, g.focus += by; }
  void operator()(Text& text) const { text.at += by; }
  void operator()(Facets& facets) const {
    for (Vec2& p : facets.corners) p += by;
  }
};

}  // namespace

std::string full_name(const Object& o) {
  const std::string name = o.name.empty() ? fmt::format("({})", name_of(o.role)) : o.name;
  return o.kind + ' ' + name + (o.number > 1 ? fmt::format("{}{}", o.name.empty() ? " " : " #", o.number) : "");
}

std::vector<Shape> expanded(const Facets& facets) {
  std::vector<Shape> shapes;
  shapes.reserve(2 * facets.colours.size());
  for (std::size_t i = 0; i < facets.colours.size(); ++i) {
    const Vec2* const p = &facets.corners[3 * i];
    const Path outline = polyline({p[0], p[1], p[2]}, true);
    shapes.emplace_back(Fill{.path = outline, .colour = facets.colours[i], .object = facets.object});
    if (facets.seam > 0)
      shapes.emplace_back(
          Stroke{.path = outline, .colour = facets.colours[i], .width = facets.seam, .object = facets.object});
  }
  return shapes;
}

std::vector<Shape> expanded(const std::vector<Shape>& shapes) {
  std::vector<Shape> all;
  for (const Shape& shape : shapes)
    if (const Facets* facets = std::get_if<Facets>(&shape))
      std::ranges::move(expanded(*facets), std::back_inserter(all));
    else
      all.push_back(shape);
  return all;
}

int object_of(const Shape& shape) {
  return std::visit([](const auto& s) { return s.object; }, shape);
}

void assign(std::vector<Shape>& shapes, std::size_t first, int object) {
  for (std::size_t i = first; i < shapes.size(); ++i)
    std::visit([object](auto& s) { s.object = s.object == no_object ? object : s.object; }, shapes[i]);
}

int add_object(std::vector<Object>& objects, Object object) {
  const auto alike = [&](const Object& o) {
    return o.kind == object.kind && o.name == object.name && (!o.name.empty() || o.role == object.role);
  };
  object.number = 1 + static_cast<int>(std::ranges::count_if(objects, alike));
  objects.push_back(std::move(object));
  return static_cast<int>(objects.size()) - 1;
}

Path polyline(const std::vector<Vec2>& points, bool closed) {
  Path path;
  if (points.empty()) return path;
  path.start = points.front();
  path.segments.assign(points.begin() + 1, points.end());
  path.closed = closed;
  return path;
}

Path ellipse(Vec2 center, Vec2 major, Vec2 minor) {
  // A quarter circle's control points lie this far along its end tangents, so that its middle lies on the
  // circle.
  const double reach = 4.0 / 3.0 * (std::sqrt(2.0) - 1);
  Path path{center + major, {}, true};
  Vec2 x = major, y = minor;
  for (int quarter = 0; quarter < 4; ++quarter) {
    path.segments.push_back(Path::Cubic{center + x + reach * y, center + y + reach * x, center + y});
    const Vec2 back = -x;
    x = y;
    y = back;
  }
  return path;
}

Path circle(Vec2 center, double radius) { return ellipse(center, {radius, 0}, {0, radius}); }

void move(Shape& shape, const Vec2& by) { std::visit(Shift{by}, shape); }

std::vector<Vec2> flatten(const Path& path, double tolerance) {
  std::vector<Vec2> points = {path.start};
  const auto go_to = [&points](const Vec2& p) {
    if (p != points.back()) points.push_back(p);
  };
  for (const Path::Segment& segment : path.segments) {
    if (const Vec2* to = std::get_if<Vec2>(&segment)) {
      go_to(*to);
      continue;
    }
    const Path::Cubic& cubic = std::get<Path::Cubic>(segment);
    const Vec2 from = points.back();
    const int count = chords(from, cubic, tolerance);
    for (int i = 1; i < count; ++i) go_to(point_on(from, cubic, static_cast<double>(i) / count));
    go_to(cubic.to);
  }
  if (path.closed && points.size() > 1 && points.back() == points.front()) points.pop_back();
  return points;
}

}  // namespace isect::viz
