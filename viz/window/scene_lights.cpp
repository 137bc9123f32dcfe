#include "viz/window/scene_lights.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "viz/names.h"
#include "viz/objects.h"

namespace isect::viz {
namespace {

constexpr double reach = 9;              ///< px from the pointer to what it is at
constexpr std::size_t most_items = 400;  ///< of more nobody knows the names

ImVec2 screen(const Vec2& p) { return {static_cast<float>(p.x()), static_cast<float>(p.y())}; }

Rect rect_of(const PlacedLabel& label, const Rect& scene) {
  const auto x = [&](double at) { return scene.left + static_cast<float>(at); };
  const auto y = [&](double at) { return scene.top + static_cast<float>(at); };
  return {x(label.box.left) - 2, y(label.box.top) - 2, x(label.box.right) + 2, y(label.box.bottom) + 2};
}

double distance(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 d = b - a;
  const double t = d.squaredNorm() > 0 ? std::clamp(d.dot(p - a) / d.squaredNorm(), 0.0, 1.0) : 0;
  return (a + t * d - p).norm();
}

/// From the pointer to an item with a name of its own, in px; points come before the lines that end in them.
struct Distance {
  const View& view;
  const Vec2 pointer;

  double operator()(const Dot& it) const { return (view.project(it.at).at - pointer).norm() - 3; }
  double operator()(const Line& it) const { return to(it.from, it.to); }
  double operator()(const Arrow& it) const { return to(it.from, it.to); }
  double operator()(const Span& it) const { return to(it.from, it.to); }
  double operator()(const Ball& it) const { return round(it.center, it.radius); }
  double operator()(const Circle& it) const { return round(it.center, it.radius); }
  double operator()(const auto&) const { return std::numeric_limits<double>::infinity(); }

 private:
  double to(const Vec3& a, const Vec3& b) const { return distance(pointer, view.project(a).at, view.project(b).at); }
  double round(const Vec3& center, double radius) const {
    return std::abs((view.project(center).at - pointer).norm() - radius * view.scale_at(center));
  }
};

/// Lights an item up with a broad, clear stroke.
struct Lit {
  const View& view;
  ImU32 ink;
  ImDrawList& list = *ImGui::GetWindowDrawList();

  void operator()(const Dot& it) const { list.AddCircle(screen(view.project(it.at).at), 9, ink, 24, 4); }
  void operator()(const Line& it) const { stroke(it.from, it.to); }
  void operator()(const Arrow& it) const { stroke(it.from, it.to); }
  void operator()(const Span& it) const { stroke(it.from, it.to); }
  void operator()(const Ball& it) const { round(it.center, it.radius); }
  void operator()(const Circle& it) const { round(it.center, it.radius); }
  void operator()(const auto&) const {}

 private:
  void stroke(const Vec3& a, const Vec3& b) const {
    list.AddLine(screen(view.project(a).at), screen(view.project(b).at), ink, 7);
  }
  void round(const Vec3& center, double radius) const {
    list.AddCircle(screen(view.project(center).at), static_cast<float>(radius * view.scale_at(center)), ink, 96, 5);
  }
};

/// The keys of an item's name.
std::vector<std::string> keys_of(const Object& object, const Ui& ui) {
  return object.kind == "label" || object.name.empty() ? std::vector<std::string>()
                                                       : keys(names_in_line(object.name, ui.names));
}

std::vector<std::string> keys_of(const Handle& handle, const Lesson& lesson) {
  for (const Parameter& p : lesson.parameters)
    if (p.name == handle.parameter) return keys(names_in(p.label));
  return {};
}

Rect around(const Vec2& p, float half) {
  const ImVec2 at = screen(p);
  return {at.x - half, at.y - half, at.x + half, at.y + half};
}

}  // namespace

void point_at_names(Session& s, const View& view, const Rect& scene, const std::vector<PlacedLabel>& labels,
                    const std::optional<Handle>& under) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const Vec2 pointer(mouse.x, mouse.y);
  for (const PlacedLabel& label : labels)
    if (const Rect r = rect_of(label, scene); r.contains(mouse.x, mouse.y))
      return s.ui.light.point(keys(names_in_line(label.text, s.ui.names)), r);
  if (under) return s.ui.light.point(keys_of(*under, s.player.lesson()), around(pointer, 1), false);
  const Scene& drawn = s.player.scene();
  if (drawn.chart || drawn.items.size() > most_items) return;
  const std::vector<Object> objects = objects_of(drawn);
  double least = reach;
  std::vector<std::string> nearest;
  for (std::size_t i = 0; i < drawn.items.size() && i < objects.size(); ++i) {
    const std::vector<std::string> names = keys_of(objects[i], s.ui);
    if (names.empty()) continue;
    const double away = std::visit(Distance{view, pointer}, drawn.items[i]);
    if (away < least) least = away, nearest = names;
  }
  s.ui.light.point(nearest, around(pointer, 8));
}

void light_names(Session& s, const View& view, const Rect& scene, const std::vector<PlacedLabel>& labels) {
  Ui& ui = s.ui;
  for (const Handle& h : s.player.scene().handles)
    if (ui.focus.name() == "handle " + h.parameter)
      ui.light.hold(keys_of(h, s.player.lesson()), around(view.project(h.at).at, 16));
  if (!ui.light.on()) return;
  for (const PlacedLabel& label : labels)
    if (const std::vector<std::string> names = keys(names_in_line(label.text, ui.names)); ui.light.of(names) > 0)
      lights(ui, names, rect_of(label, scene));
  const Scene& drawn = s.player.scene();
  if (drawn.chart || drawn.items.size() > most_items) return;
  const std::vector<Object> objects = objects_of(drawn);
  int lit = 0;
  for (std::size_t i = 0; i < drawn.items.size() && i < objects.size(); ++i)
    if (const double light = ui.light.of(keys_of(objects[i], ui)); light > 0) {
      std::visit(Lit{view, packed(ui.palette.fresh, 0.55 * light)}, drawn.items[i]);
      ui.rects["lit object " + std::to_string(++lit)] = scene;
    }
}

}  // namespace isect::viz
