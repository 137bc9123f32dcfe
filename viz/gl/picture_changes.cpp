#include "viz/gl/picture_changes.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <string_view>
#include <unordered_map>

namespace isect::viz {
namespace {

Box nothing() {
  const Vec2 far = Vec2::Constant(std::numeric_limits<double>::infinity());
  return {far, -far};
}

/// Gathers the hash and the box of one shape.
class Print {
 public:
  explicit Print(std::size_t kind) : hash_(kind + 1) {}

  void add(double x) { add_word(std::bit_cast<std::uint64_t>(x)); }
  void add(const Vec2& p) { add(p.x()), add(p.y()); }
  void add(const Colour& c) { add(c.r), add(c.g), add(c.b), add(c.a); }
  void add(std::string_view text) { add_word(std::hash<std::string_view>()(text)); }
  void add(const Path& path) {
    cover(path.start);
    for (const Path::Segment& segment : path.segments) {
      if (const Path::Cubic* cubic = std::get_if<Path::Cubic>(&segment))
        add(3.0), cover(cubic->control1), cover(cubic->control2), cover(cubic->to);
      else
        cover(std::get<Vec2>(segment));
    }
    add_word(2 * path.segments.size() + (path.closed ? 1 : 0));
  }
  /// Adds a point of the shape.
  void cover(const Vec2& p) {
    add(p);
    box_ = {box_.low.cwiseMin(p), box_.high.cwiseMax(p)};
    finite_ = finite_ && p.allFinite();
  }
  void cover(const Box& box) { cover(box.low), cover(box.high); }

  /// Returns the shape; it reaches `beyond` the points.
  DrawnShape shape(double beyond = 0) const {
    constexpr double far = std::numeric_limits<double>::infinity();
    if (!finite_ || !(beyond >= 0)) return {hash_, {Vec2::Constant(-far), Vec2::Constant(far)}};
    return {hash_, {box_.low - Vec2::Constant(beyond), box_.high + Vec2::Constant(beyond)}};
  }

 private:
  void add_word(std::uint64_t word) {
    hash_ = (hash_ ^ word) * 0x9e3779b97f4a7c15u;
    hash_ ^= hash_ >> 29;
  }

  std::uint64_t hash_;
  Box box_ = nothing();
  bool finite_ = true;
};

DrawnShape drawn(const Fill& s, const auto&) {
  Print print(0);
  print.add(s.path), print.add(s.colour), print.add(s.hatch_gap), print.add(s.hatch_line), print.add(s.hatch_colour);
  for (const Path& path : s.more) print.add(path);
  return print.shape();
}
DrawnShape drawn(const Stroke& s, const auto&) {
  Print print(1);
  print.add(s.path), print.add(s.colour), print.add(s.width), print.add(s.dash[0]), print.add(s.dash[1]);
  print.add(s.round_cap ? 1.0 : 0.0);
  return print.shape(s.width);
}
DrawnShape drawn(const Gradient& s, const auto&) {
  Print print(2);
  const Vec2 reach = s.major.cwiseAbs() + s.minor.cwiseAbs();
  print.add(s.major), print.add(s.minor), print.add(s.focus), print.add(s.inner), print.add(s.outer);
  print.cover(s.center), print.cover(Box{s.center - reach, s.center + reach});
  return print.shape();
}
DrawnShape drawn(const Text& s, const auto& box_of) {
  Print print(3);
  print.add(s.markup), print.add(s.at), print.add(s.size), print.add(s.colour), print.add(s.align);
  print.add(s.bold ? 1.0 : 0.0), print.add(s.halo), print.add(s.halo_colour), print.cover(box_of(s));
  return print.shape();
}
DrawnShape drawn(const Facets& s, const auto&) {
  Print print(4);
  for (const Vec2& p : s.corners) print.cover(p);
  for (const Colour& c : s.colours) print.add(c);
  print.add(s.seam);
  return print.shape(s.seam);
}

using Counts = std::unordered_map<std::uint64_t, int>;

Counts counts_of(const std::vector<DrawnShape>& shapes) {
  Counts counts;
  for (const DrawnShape& shape : shapes) ++counts[shape.print];
  return counts;
}

/// Returns the prints of the shapes of which the others have as many; the boxes of the rest go into `rest`.
std::vector<std::uint64_t> common(const std::vector<DrawnShape>& shapes, const Counts& own, const Counts& others,
                                  Box& rest) {
  std::vector<std::uint64_t> prints;
  for (const DrawnShape& shape : shapes) {
    const auto other = others.find(shape.print);
    if (other != others.end() && other->second == own.at(shape.print))
      prints.push_back(shape.print);
    else
      rest = {rest.low.cwiseMin(shape.box.low), rest.high.cwiseMax(shape.box.high)};
  }
  return prints;
}

}  // namespace

std::vector<DrawnShape> drawn_shapes(const Drawing& drawing, const std::function<Box(const Text&)>& box_of) {
  std::vector<DrawnShape> shapes;
  shapes.reserve(drawing.shapes.size());
  for (const Shape& shape : drawing.shapes)
    shapes.push_back(std::visit([&](const auto& s) { return drawn(s, box_of); }, shape));
  return shapes;
}

std::optional<Box> changed(const std::vector<DrawnShape>& before, const std::vector<DrawnShape>& now) {
  const Counts counts_before = counts_of(before), counts_now = counts_of(now);
  Box box = nothing();
  if (common(before, counts_before, counts_now, box) != common(now, counts_now, counts_before, box)) return {};
  if (!(box.low.x() <= box.high.x())) return Box{Vec2::Zero(), Vec2::Zero()};
  if (!box.low.allFinite() || !box.high.allFinite()) return {};
  return box;
}

bool meet(const Box& a, const Box& b) {
  return (a.low.array() <= b.high.array()).all() && (b.low.array() <= a.high.array()).all();
}

PixelBox to_draw(const LastPicture& last, const LastPicture& now) {
  if (last.scale != now.scale || last.part != now.part || last.background != now.background) return now.part;
  const std::optional<Box> box = changed(last.shapes, now.shapes);
  if (!box) return now.part;
  if (box->low == box->high) return {};
  constexpr double more = 2;  // smooth edges, and lines thinner than a pixel
  const Vec2 first(now.part.left, now.part.top), end = first + Vec2(now.part.width, now.part.height);
  const Vec2 low = (box->low * now.scale - Vec2::Constant(more)).cwiseMax(first).cwiseMin(end).array().floor();
  const Vec2 high = (box->high * now.scale + Vec2::Constant(more)).cwiseMin(end).cwiseMax(low).array().ceil();
  return {static_cast<int>(low.x()), static_cast<int>(low.y()), static_cast<int>(high.x() - low.x()),
          static_cast<int>(high.y() - low.y())};
}

}  // namespace isect::viz
