#include "viz/compose/halos.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>

#include "viz/compose/labels.h"
#include "viz/compose/locate_point.h"
#include "viz/text/text.h"

namespace isect::viz {
namespace {

/// Returns a box around a path: curves stay within their control points.
TextBox around(const Path& path) {
  TextBox b = {path.start.x(), path.start.y(), path.start.x(), path.start.y()};
  const auto grow = [&](const Vec2& p) {
    b = {std::min(b.left, p.x()), std::min(b.top, p.y()), std::max(b.right, p.x()), std::max(b.bottom, p.y())};
  };
  for (const Path::Segment& segment : path.segments) {
    if (const Vec2* to = std::get_if<Vec2>(&segment)) {
      grow(*to);
    } else {
      const auto& cubic = std::get<Path::Cubic>(segment);
      grow(cubic.control1), grow(cubic.control2), grow(cubic.to);
    }
  }
  return b;
}

/// Returns a box around all that a shape covers; texts and strokes are ignored.
TextBox around(const Shape& shape) {
  if (const Fill* fill = std::get_if<Fill>(&shape)) {
    TextBox b = around(fill->path);
    for (const Path& path : fill->more) {
      const TextBox hole = around(path);
      b = {std::min(b.left, hole.left), std::min(b.top, hole.top), std::max(b.right, hole.right),
           std::max(b.bottom, hole.bottom)};
    }
    return b;
  }
  if (const Gradient* ball = std::get_if<Gradient>(&shape)) {
    const Vec2 half = ball->major.cwiseAbs() + ball->minor.cwiseAbs();
    return box_around(ball->center, half);
  }
  return {INFINITY, INFINITY, -INFINITY, -INFINITY};
}

/// Returns how often the outline winds around the point.
int winding(const Path& path, const Vec2& p) {
  if (!contains(around(path), p)) return 0;
  const std::vector<Vec2> ring = flatten(path, 0.5);
  int turns = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
    const double side = (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
    if (a.y() <= p.y() && b.y() > p.y() && side > 0) ++turns;
    if (a.y() > p.y() && b.y() <= p.y() && side < 0) --turns;
  }
  return turns;
}

/// Returns the facets whose bounding boxes meet the box.
Facets within(const Facets& all, const TextBox& box) {
  Facets some;
  for (std::size_t i = 0; i < all.colours.size(); ++i) {
    const Vec2* const p = &all.corners[3 * i];
    const Vec2 lo = p[0].cwiseMin(p[1]).cwiseMin(p[2]), hi = p[0].cwiseMax(p[1]).cwiseMax(p[2]);
    if (!(lo.x() <= box.right && box.left <= hi.x() && lo.y() <= box.bottom && box.top <= hi.y())) continue;
    some.corners.insert(some.corners.end(), p, p + 3);
    some.colours.push_back(all.colours[i]);
  }
  return some;
}

/// Returns the colour at a point once `shape` is drawn on `below`.
Colour drawn_on(const Colour& below, const Shape& shape, const Vec2& p) {
  if (const Fill* fill = std::get_if<Fill>(&shape)) {
    int turns = winding(fill->path, p);
    for (const Path& path : fill->more) turns += winding(path, p);
    const bool inside = fill->more.empty() ? turns != 0 : turns % 2 != 0;
    return inside ? laid_over(below, fill->colour) : below;
  }
  if (const Gradient* ball = std::get_if<Gradient>(&shape)) {
    const Vec2 d = p - ball->center;
    const double r =
        std::hypot(d.dot(ball->major) / ball->major.squaredNorm(), d.dot(ball->minor) / ball->minor.squaredNorm());
    if (!(r <= 1)) return below;
    const Colour &in = ball->inner, &out = ball->outer;
    return laid_over(below, {in.r + r * (out.r - in.r), in.g + r * (out.g - in.g), in.b + r * (out.b - in.b),
                             in.a + r * (out.a - in.a)});
  }
  if (const Facets* facets = std::get_if<Facets>(&shape)) {
    for (std::size_t i = facets->colours.size(); i-- > 0;)
      if (const Vec2* t = &facets->corners[3 * i]; locate(t[0], t[1], t[2], p) != Location::out)
        return facets->colours[i];
  }
  return below;
}

}  // namespace

double contrast_of(const std::vector<Shape>& shapes, std::size_t text, const Colour& background) {
  const Text& t = std::get<Text>(shapes[text]);
  const TextBox box = measure(t);
  std::vector<const Shape*> below_it;
  std::deque<Shape> parts;  // of what has thousands
  for (std::size_t k = 0; k < text; ++k) {
    if (const Facets* facets = std::get_if<Facets>(&shapes[k])) {
      below_it.push_back(&parts.emplace_back(within(*facets, box)));
      continue;
    }
    const TextBox b = around(shapes[k]);
    if (b.left <= box.right && box.left <= b.right && b.top <= box.bottom && box.top <= b.bottom)
      below_it.push_back(&shapes[k]);
  }
  double least = 21;
  std::optional<Colour> last;  // most of what lies under a text is of one colour
  for (int i = 0; i < 9; ++i)
    for (int j = 0; j < 3; ++j) {
      const Vec2 p(box.left + (i + 0.5) / 9 * (box.right - box.left), box.top + (j + 0.5) / 3 * (box.bottom - box.top));
      Colour below = background;
      for (const Shape* shape : below_it) below = drawn_on(below, *shape, p);
      if (last != below) least = std::min(least, contrast_ratio(t.colour, below));
      last = below;
    }
  return least;
}

void add_halos(std::vector<Shape>& shapes, const Theme& theme) {
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    Text* text = std::get_if<Text>(&shapes[i]);
    if (!text || text->halo > 0 || contrast_of(shapes, i, theme.background) >= least_contrast) continue;
    text->halo = theme.sizes.label_halo, text->halo_colour = theme.background;
  }
}

namespace {

/// Whether a line drawn before the text comes nearer to it than this.
bool has_line_near(const std::vector<Shape>& shapes, std::size_t text, double near) {
  const TextBox box = grown(measure(std::get<Text>(shapes[text])), near);
  const auto meets = [&](const Stroke& stroke) {
    const TextBox wide = grown(box, stroke.width / 2), all = grown(around(stroke.path), stroke.width / 2);
    if (!(all.left <= box.right && box.left <= all.right && all.top <= box.bottom && box.top <= all.bottom))
      return false;
    std::vector<Vec2> line = flatten(stroke.path, 0.5);
    if (stroke.path.closed) line.push_back(line.front());
    for (std::size_t i = 1; i < line.size(); ++i)
      if (length_inside(line[i - 1], line[i], wide) > 0) return true;
    return false;
  };
  return std::any_of(shapes.begin(), shapes.begin() + static_cast<std::ptrdiff_t>(text), [&](const Shape& s) {
    const Stroke* stroke = std::get_if<Stroke>(&s);
    return stroke && meets(*stroke);
  });
}

}  // namespace

bool stands_on_line(const std::vector<Shape>& shapes, std::size_t text, const Theme& theme) {
  return has_line_near(shapes, text, theme.sizes.label_halo);
}

void add_halos_over_lines(std::vector<Shape>& shapes, const Theme& theme) {
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    Text* text = std::get_if<Text>(&shapes[i]);
    if (!text || text->halo > 0 || !has_line_near(shapes, i, 0)) continue;
    const TextBox box = measure(*text);
    const Vec2 middle((box.left + box.right) / 2, (box.top + box.bottom) / 2);
    Colour below = theme.background;
    for (std::size_t k = 0; k < i; ++k) below = drawn_on(below, shapes[k], middle);
    if (contrast_ratio(text->colour, below) < least_contrast) below = theme.background;
    text->halo = theme.sizes.label_halo, text->halo_colour = below;
  }
}

}  // namespace isect::viz
