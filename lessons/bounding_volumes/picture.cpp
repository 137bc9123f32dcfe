#include "lessons/bounding_volumes/picture.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "viz/compose/compose.h"
#include "viz/compose/small_multiples.h"

namespace isect::lessons::bounding_volumes_lesson {

using namespace viz;
using Items = std::vector<Item>;

Item drawn(const TriangleMesh<double>& mesh, Role role) { return Mesh{mesh.vertices, mesh.triangles, role}; }

namespace {

/// The view's own axes, with the origin in the middle.
Vec3 in_view(double x, double y) {
  static const View view(camera, 1, 1);
  return x * view.right() + y * view.up();
}

}  // namespace

std::string void_of(const Measured& m, double object) {
  const double times = std::max(m.void_volume / object, 0.0);  // of rounded volumes
  return times < 0.995 ? fmt::format("{:.2f} ×", times) : fmt::format("{:.1f} ×", times);
}

Item below(const Items& items, const std::string& text) {
  const Box2 box = extent(items, camera);
  return viz::Heading{in_view((box.lo.x() + box.hi.x()) / 2, box.lo.y() - 0.3), text, Role::text, 3, false};
}

namespace {

/// A name at `beside` with a line to the point p, which lies amid the drawing.
Items named(const Vec3& p, const Vec3& beside, const char* name, bool dot) {
  Items items = {Line{p, beside, Role::construction, Pen::construction}, Label{beside, name, Role::second}};
  if (dot) items.push_back(Dot{p, Mark::disc, Role::second});
  return items;
}

void append(Items& items, const Items& more) { items.insert(items.end(), more.begin(), more.end()); }

}  // namespace

Items corners(const Aabb<double, 3>& box) {
  const double width = 0.5 * (box.hi - box.lo).norm();
  Items items = named(box.lo, box.lo + in_view(-width, -0.1 * width), "**a**_{min}", true);
  append(items, named(box.hi, box.hi + in_view(width, 0.1 * width), "**a**_{max}", true));
  return items;
}

Vec3 farthest(const TriangleMesh<double>& mesh, const Sphere<double, 3>& ball) {
  const Vec3 forward = View(camera, 1, 1).forward();
  Vec3 best = ball.center;
  float longest = -1;  // a float, so that lengths equal up to rounding compare equal
  for (const Vec3& p : mesh.vertices) {
    const Vec3 d = p - ball.center;
    const auto seen = static_cast<float>(d.cross(forward).norm());
    if (d.norm() >= (1 - 1e-9) * ball.radius && seen > longest) best = p, longest = seen;
  }
  return best;
}

Items radius(const Sphere<double, 3>& ball, const Vec3& farthest) {
  Items items = {Line{ball.center, farthest, Role::highlight, Pen::highlight}, Dot{farthest, Mark::disc, Role::hit}};
  append(items, named(ball.center, ball.center + in_view(-1.2 * ball.radius, 0.1), "**c**", true));
  const Vec3 middle = (ball.center + farthest) / 2;
  append(items, named(middle, middle + in_view(1.1 * ball.radius, 0.1), "*r*", false));
  return items;
}

Items axes(const Obb<double, 3>& box) {
  const char* const names[] = {"*h_u*", "*h_v*", "*h_w*"};
  Items items;
  for (int i = 0; i < 3; ++i) {
    const Vec3 tip = box.center + box.half[i] * box.axes.col(i);
    items.push_back(Arrow{box.center, tip, Role::second, Pen::thick});
    items.push_back(Label{tip, names[i], Role::second});
  }
  items.push_back(Dot{box.center, Mark::disc, Role::second});
  return items;
}

Items slab(const Kdop<double, 3>& kdop, std::size_t i) {
  const Vec3 n = kdop.normals[i], u = n.unitOrthogonal(), v = n.normalized().cross(u);
  const auto on = [&](double d) -> Vec3 { return d / n.squaredNorm() * n; };
  const double half = 1;
  Items items;
  const auto plane = [&](double d, const char* name) {
    std::vector<Vec3> ring;
    for (const auto& [a, b] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
      ring.emplace_back(on(d) + half * (a * u + b * v));
    const auto leftmost =
        std::ranges::min_element(ring, {}, [](const Vec3& p) { return p.x() - 0.5 * p.z() + 0.25 * p.y(); });
    items.push_back(Label{*leftmost, name, Role::second});
    items.push_back(Region{.rings = {ring}, .role = Role::second});
  };
  plane(kdop.slabs[i].lo, "*lo*");
  plane(kdop.slabs[i].hi, "*hi*");
  items.push_back(Arrow{on(kdop.slabs[i].hi), on(kdop.slabs[i].hi) + 0.6 * n.normalized(), Role::text, Pen::thick});
  items.push_back(Label{on(kdop.slabs[i].hi) + 0.6 * n.normalized(), "**n**", Role::text});
  return items;
}

std::size_t seen_best(const Kdop<double, 3>& kdop) {
  const View view(camera, 1, 1);
  const auto slant = [&](const Vec3& n) { return std::abs(std::abs(n.normalized().dot(view.forward())) - 0.4); };
  const std::size_t axes = 3;
  std::size_t best = kdop.normals.size() > axes ? axes : 0;
  for (std::size_t i = best; i < kdop.normals.size(); ++i)
    if (slant(kdop.normals[i]) < slant(kdop.normals[best])) best = i;
  return best;
}

namespace {

/// A page's own axes, right and up, with the origin in its middle.
class Page {
 public:
  Items items;

  static Vec3 at(double x, double y) { return in_view(x, y); }

  /// Adds a text that has a column to itself, so that neighbours never touch, however small the picture is.
  void text(double x, double y, const std::string& what, bool bold = false) {
    items.push_back(viz::Heading{at(x, y), what, Role::text, 0.8 * pitch, bold});
  }
  /// Adds a text over a bar or cells that begin at x.
  void number(double x, double y, const std::string& what) {
    items.push_back(viz::Heading{at(x, y), what, Role::text, 0.8 * pitch, false, 0});
  }
  /// Adds a heading over all `columns`.
  void over(double y, const std::string& what, std::size_t columns) {
    items.push_back(viz::Heading{at(0, y), what, Role::muted, pitch * static_cast<double>(columns), false});
  }
  void box(double x, double y, double width, double height, Role role) {
    items.push_back(
        Region{.rings = {{at(x, y), at(x + width, y), at(x + width, y + height), at(x, y + height)}}, .role = role});
  }
  /// Adds a box hatched at 45 degrees in its own colour.
  void hatched(double x, double y, double width, double height, Role role) {
    box(x, y, width, height, role);
    for (double s = 0.05 - height; s < width; s += 0.07) {
      const double from = std::max(s, 0.0), to = std::min(s + height, width);
      if (from < to) items.push_back(Line{at(x + from, y + from - s), at(x + to, y + to - s), role, Pen::hairline});
    }
  }
  /// Adds small cells in rows, as many as fit.
  void cells(double x, double top, std::size_t count) {
    constexpr std::size_t columns = 11, rows = 3;
    constexpr double side = 0.085, step = 0.125;
    Region all = {.rings = {}, .role = Role::muted};
    for (std::size_t i = 0; i < std::min(count, columns * rows); ++i) {
      const double left = x + step * static_cast<double>(i % columns),
                   y = top - step * static_cast<double>(i / columns);
      all.rings.push_back({at(left, y), at(left + side, y), at(left + side, y - side), at(left, y - side)});
    }
    items.push_back(all);
  }

  static constexpr double pitch = 1.75;
};

Item scaled(Item item, double k) {
  if (auto* ball = std::get_if<Ball>(&item)) ball->center *= k, ball->radius *= k;
  if (auto* solid = std::get_if<Solid>(&item))
    for (Vec3& p : solid->vertices) p *= k;
  if (auto* mesh = std::get_if<Mesh>(&item))
    for (Vec3& p : mesh->vertices) p *= k;
  return item;
}

}  // namespace

Items side_by_side(const TriangleMesh<double>& mesh, double object, const std::vector<Measured>& all) {
  Page page;
  constexpr double room = 1.5;
  double largest = 0, most = 0, tallest = 0;
  const Item inner = drawn(mesh, Role::first);
  const Box2 own = extent({inner}, camera);
  std::vector<Box2> extents;
  for (const Measured& m : all) {
    largest = std::max(largest, m.volume);
    most = std::max<double>(most, m.operations());
    const Box2 outer = extent({m.drawn}, camera);
    extents.push_back({own.lo.cwiseMin(outer.lo), own.hi.cwiseMax(outer.hi)});
    const Vec2 size = extents.back().hi - extents.back().lo;
    tallest = std::max(tallest, size.maxCoeff());
  }
  const double k = room / tallest;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Measured& m = all[i];
    const double x = Page::pitch * (static_cast<double>(i) - 0.5 * static_cast<double>(all.size() - 1));
    const double left = x - room / 2, unit = room / largest;
    page.text(x, 1.8, m.name, true);
    const Vec2 middle = k * (extents[i].lo + extents[i].hi) / 2;
    const Items both = {scaled(inner, k), scaled(m.drawn, k)};
    for (const Item& item : moved(both, page.at(x - middle.x(), 0.8 - middle.y()))) page.items.push_back(item);

    page.number(left, -0.62, void_of(m, object));
    page.box(left, -0.98, unit * object, 0.13, Role::first);
    page.hatched(left + unit * object, -0.98, unit * m.void_volume, 0.13, Role::second);
    page.number(left, -1.65, std::to_string(m.numbers));
    page.cells(left, -1.87, m.numbers);
    if (m.operations() == 0) continue;
    page.number(left, -2.87, std::to_string(m.operations()));
    page.box(left, -3.23, room / most * m.operations(), 0.13, Role::muted);
  }
  page.over(-0.25, "void, in volumes of the object", all.size());
  page.over(-1.28, "stored numbers", all.size());
  page.over(-2.5, "operations of a test that finds an overlap", all.size());
  return page.items;
}

}  // namespace isect::lessons::bounding_volumes_lesson
