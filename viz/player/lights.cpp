#include "viz/player/lights.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "viz/compose/item_names.h"
#include "viz/text/names.h"

namespace isect::viz {
namespace {

constexpr double pointer_reach = 9;      ///< px from the pointer to the item that it is at
constexpr std::size_t most_items = 400;  ///< above this, names are not looked for

double distance(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 d = b - a;
  const double t = d.squaredNorm() > 0 ? std::clamp(d.dot(p - a) / d.squaredNorm(), 0.0, 1.0) : 0;
  return (a + t * d - p).norm();
}

/// The distance from a place to an item with its own name, in px; points come before the lines that end in them.
struct Distance {
  const View& view;
  const Vec2 from;

  double operator()(const Dot& it) const { return (view.project(it.at).at - from).norm() - 3; }
  double operator()(const Line& it) const { return to(it.from, it.to); }
  double operator()(const Arrow& it) const { return to(it.from, it.to); }
  double operator()(const Span& it) const { return to(it.from, it.to); }
  double operator()(const Ball& it) const { return round(it.center, it.radius); }
  double operator()(const Circle& it) const { return round(it.center, it.radius); }
  double operator()(const auto&) const { return std::numeric_limits<double>::infinity(); }

 private:
  double to(const Vec3& a, const Vec3& b) const { return distance(from, view.project(a).at, view.project(b).at); }
  double round(const Vec3& center, double radius) const {
    return std::abs((view.project(center).at - from).norm() - radius * view.scale_at(center));
  }
};

struct Stroked {
  const View& view;

  std::optional<LitStroke> operator()(const Dot& it) const { return ring(view.project(it.at).at, 9, 4); }
  std::optional<LitStroke> operator()(const Line& it) const { return line(it.from, it.to); }
  std::optional<LitStroke> operator()(const Arrow& it) const { return line(it.from, it.to); }
  std::optional<LitStroke> operator()(const Span& it) const { return line(it.from, it.to); }
  std::optional<LitStroke> operator()(const Ball& it) const { return round(it.center, it.radius); }
  std::optional<LitStroke> operator()(const Circle& it) const { return round(it.center, it.radius); }
  std::optional<LitStroke> operator()(const auto&) const { return {}; }

 private:
  static LitStroke ring(const Vec2& center, double radius, double width) { return {center, center, radius, width}; }
  LitStroke line(const Vec3& a, const Vec3& b) const { return {view.project(a).at, view.project(b).at, 0, 7}; }
  LitStroke round(const Vec3& center, double radius) const {
    return ring(view.project(center).at, radius * view.scale_at(center), 5);
  }
};

}  // namespace

std::vector<std::string> keys_of(const PlacedLabel& label, const std::set<std::string>& known) {
  return keys(names_in_line(label.text, known));
}

std::vector<std::string> keys_of(const Handle& handle, const Lesson& lesson) {
  for (const Parameter& p : lesson.parameters)
    if (p.name == handle.parameter) return keys(names_in(p.label));
  return {};
}

void each_named(const Scene& scene, const std::set<std::string>& known,
                const std::function<void(const Item&, const std::vector<std::string>&)>& each) {
  if (scene.chart || scene.items.size() > most_items) return;
  const std::vector<Object> objects = objects_of(scene);
  for (std::size_t i = 0; i < scene.items.size() && i < objects.size(); ++i) {
    if (objects[i].kind == "label" || objects[i].name.empty()) continue;
    if (const std::vector<std::string> names = keys(names_in_line(objects[i].name, known)); !names.empty())
      each(scene.items[i], names);
  }
}

std::vector<std::string> names_near(const Scene& scene, const View& view, const Vec2& at,
                                    const std::set<std::string>& known) {
  double least = pointer_reach;
  std::vector<std::string> nearest;
  each_named(scene, known, [&](const Item& item, const std::vector<std::string>& names) {
    const double away = std::visit(Distance{view, at}, item);
    if (away < least) least = away, nearest = names;
  });
  return nearest;
}

std::optional<LitStroke> lit_stroke(const Item& item, const View& view) { return std::visit(Stroked{view}, item); }

}  // namespace isect::viz
