#include "viz/compose/canvas.h"

#include <algorithm>
#include <cmath>

#include "viz/compose/locate_point.h"
#include "viz/compose/marks.h"
#include "viz/compose/paper.h"
#include "viz/text/rich_text.h"
#include "viz/text/text.h"

namespace isect::viz {

Colour mixed(const Colour& a, const Colour& b, double share) {
  return {a.r + share * (b.r - a.r), a.g + share * (b.g - a.g), a.b + share * (b.b - a.b), 1};
}

Canvas::Canvas(const Scene& s, const View& v, const Theme& t, bool grips)
    : scene(s), view(v), theme(t), handles(grips) {
  for (std::size_t i = 0; i < scene.items.size(); ++i) {
    const Item& item = scene.items[i];
    if (std::holds_alternative<Ball>(item)) ball_items.push_back(static_cast<int>(i));
    if (const Solid* solid = std::get_if<Solid>(&item)) occluders.solids.push_back(shell(*solid));
    if (const Region* region = std::get_if<Region>(&item); region && region->hides)
      occluders.screens.push_back({region->rings});
  }
  find_capsules();
  find_meshes();
  const auto ball = [&](int i) { return std::get<Ball>(scene.items[i]); };
  std::stable_sort(ball_items.begin(), ball_items.end(),
                   [&](int a, int b) { return depth(ball(a).center) > depth(ball(b).center); });
  for (const int i : ball_items) occluders.balls.push_back(ball(i));
}

void Canvas::find_meshes() {
  const auto asks = [](const Item& item) {
    const Line* line = std::get_if<Line>(&item);
    const Arrow* arrow = std::get_if<Arrow>(&item);
    return (line && !line->name.empty()) || (arrow && !arrow->name.empty()) || std::holds_alternative<Solid>(item);
  };
  if (!std::ranges::any_of(scene.items, asks)) return;
  for (const Item& item : scene.items)
    if (const Mesh* mesh = std::get_if<Mesh>(&item); mesh && !mesh->triangles.empty())
      meshes.push_back({mesh, facet_tree(*mesh)});
}

void Canvas::find_capsules() {
  for (std::size_t i = 0; i < scene.items.size(); ++i) {
    const Line* axis = std::get_if<Line>(&scene.items[i]);
    if (!axis || axis->pen != Pen::construction || axis->name.empty()) continue;
    const auto end = [&](const Vec3& at) {
      return std::ranges::find_if(ball_items, [&](int k) {
        const Ball& ball = std::get<Ball>(scene.items[k]);
        return ball.name == axis->name && ball.center == at;
      });
    };
    const auto p = end(axis->from), q = end(axis->to);
    if (p == q || p == ball_items.end() || q == ball_items.end()) continue;
    const double radius = std::get<Ball>(scene.items[*p]).radius;
    if (std::get<Ball>(scene.items[*q]).radius != radius) continue;
    occluders.capsules.push_back({axis->from, axis->to, radius});
    capsule_items.push_back(static_cast<int>(i));
    std::erase_if(ball_items, [ends = std::array{*p, *q}](int k) { return k == ends[0] || k == ends[1]; });
  }
}

namespace {

std::optional<Occluders> without_containers(const Canvas& c, const std::vector<Vec3>& points, Role role, Pen pen) {
  return role == Role::hit || pen != Pen::solid ? std::nullopt : around_contents(c.occluders, points);
}

}  // namespace

Occluders Canvas::around(const std::vector<Vec3>& points, Role role, Pen pen) const {
  return without_containers(*this, points, role, pen).value_or(occluders);
}

std::vector<Stretch> Canvas::seen(const std::vector<Vec3>& points, bool closed, Role role, Pen pen) const {
  const std::optional<Occluders> left = without_containers(*this, points, role, pen);
  return stretches(points, closed, view, left ? *left : occluders);
}

std::vector<Vec2> Canvas::projected(const std::vector<Vec3>& points) const {
  std::vector<Vec2> flat;
  flat.reserve(points.size());
  for (const Vec3& p : points) flat.push_back(at(p));
  return flat;
}

double Canvas::width(Pen pen, Role role) const {
  switch (pen) {
    case Pen::thick:
    case Pen::excluded:
      return sizes().shared;
    case Pen::highlight:
      return sizes().highlight;
    case Pen::construction:
      return sizes().construction;
    case Pen::hairline:
      return sizes().hairline;
    case Pen::solid:
      break;
  }
  return theme.like(role) == Role::first ? sizes().ray : sizes().outline;
}

void Canvas::block(const std::vector<Vec2>& points, double radius, bool firm) {
  for (std::size_t i = 1; i < points.size(); ++i) obstacles.push_back({points[i - 1], points[i], radius, firm});
}

void Canvas::curve(const std::vector<Stretch>& parts, const Colour& colour, double width, bool firm) {
  const bool bold = width >= sizes().shared;  // the shared part stays the boldest where it is hidden
  for (const Stretch& part : parts) {
    const std::vector<Vec2> points = projected(part.points);
    if (part.hidden) {
      std::array<double, 2> dash = sizes().hidden_dash;
      if (bold) dash = {1.3 * dash[0], 1.3 * dash[1]};
      hidden.emplace_back(Stroke{polyline(points), colour, bold ? 0.5 * width : sizes().hidden, dash, false});
    } else {
      lines.emplace_back(Stroke{polyline(points), colour, width, {0, 0}, true});
    }
    block(points, width / 2, firm && !part.hidden);
  }
}

void Canvas::plain_line(const std::vector<Vec2>& points, bool closed, Role role, Pen pen) {
  const double w = width(pen, role);
  const bool dashed = pen == Pen::construction || pen == Pen::excluded;
  if (pen == Pen::highlight && theme.name != ThemeName::dark)  // yellow on white needs an edge to be seen
    lines.emplace_back(Stroke{polyline(points, closed), theme.ink(Role::text), w + 2 * sizes().hairline, {0, 0}, true});
  std::array<double, 2> dash = {0, 0};
  if (pen == Pen::construction) dash = sizes().construction_dash;
  if (pen == Pen::excluded) {  // a gap in what lies below, mostly the ray
    dash = {1.5 * w, w};
    lines.emplace_back(Stroke{polyline(points, closed), theme.background, w + 2 * sizes().hairline, {0, 0}, false});
  }
  lines.emplace_back(Stroke{polyline(points, closed), theme.ink(role), w, dash, !dashed});
  std::vector<Vec2> chain = points;
  if (closed) chain.push_back(points.front());
  block(chain, w / 2, !dashed);
}

double Canvas::dot_radius(const Vec3& p) const {
  double radius = 0;
  for (const Item& other : scene.items)
    if (const Dot* dot = std::get_if<Dot>(&other); dot != nullptr && dot->at == p)
      radius = std::max(radius, mark_radius(dot->mark, sizes()) + sizes().halo);
  return radius;
}

Fill area(const Canvas& c, const Path& outline, Role role) {
  Fill fill = {outline, c.theme.tint(role), 0, 0, {}};
  if (c.theme.hatched(role))
    fill.hatch_gap = c.sizes().hatch_gap, fill.hatch_line = c.sizes().hatch_line, fill.hatch_colour = c.theme.ink(role);
  return fill;
}

void draw(Canvas& c, const Dot& it) {
  mark(c.marks, it.mark, c.at(it.at), it.role, c.theme);
  c.obstacles.push_back({c.at(it.at), c.at(it.at), mark_radius(it.mark, c.sizes()), true});
}

void draw(Canvas& c, const Label& it) {
  const Vec2 from = c.at(it.at), to = it.until ? c.at(*it.until) : from;
  const bool at_place = it.until && *it.until == it.at;
  const double keep_off = at_place       ? 0
                          : it.until     ? c.sizes().outline
                          : it.at_handle ? std::max(c.dot_radius(it.at), c.sizes().handle_ring)
                                         : c.dot_radius(it.at);
  c.labels.push_back({it.text, from, to, keep_off, edge_ink(it.role, c.theme)});
  c.labels.back().at_place = at_place;
}

void draw(Canvas& c, const Heading& it) {
  Text text = {
      it.text, c.at(it.at), it.bold ? c.sizes().title : c.sizes().label, c.theme.ink(it.role), it.lean, it.bold, 0, {}};
  TextBox box = measure(text);
  const double room = it.room * c.view.scale_at(it.at);
  if (room > 0 && !has_one_size(c.theme) && box.right - box.left > room) text.size *= room / (box.right - box.left);
  text.at.y() += 0.34 * text.size;  // half the height of capitals, so that headings side by side share a baseline
  box = measure(text);
  for (const Handle& handle : c.scene.handles)  // a handle would cover the heading: it moves aside
    if (c.handles && contains(grown(box, c.sizes().handle_ring), c.at(handle.at))) {
      c.labels.push_back({it.text, c.at(it.at), c.at(it.at), c.sizes().handle_ring, text.colour});
      return;
    }
  c.marks.emplace_back(text);
  const double height = (box.top + box.bottom) / 2;
  c.block({{box.left, height}, {box.right, height}}, (box.bottom - box.top) / 2, true);
  c.placed.push_back({plain(it.text), box});
}

namespace {

/// Whether a marker stands at the handle's place, so that the handle's own disc would cover what the marker says.
bool has_mark(const Canvas& c, const Handle& handle) {
  return std::ranges::any_of(c.scene.items, [&](const Item& item) {
    const Dot* dot = std::get_if<Dot>(&item);
    return dot && dot->at == handle.at && (dot->mark != Mark::disc || dot->role != handle.role);
  });
}

}  // namespace

void draw(Canvas& c, const Handle& handle) {
  const Vec2 p = c.at(handle.at);
  const Colour ink = c.theme.ink(handle.role);
  const Sizes& s = c.sizes();
  using enum Handle::Kind;
  const bool hangs = handle.kind == vector || handle.kind == length || handle.kind == along || handle.kind == turn;
  if (hangs) {  // on what it measures from
    c.marks.emplace_back(Stroke{polyline({c.at(handle.anchor), p}), ink, s.hairline, s.construction_dash, false});
    c.obstacles.push_back({c.at(handle.anchor), p, s.hairline, false});
  }
  c.marks.emplace_back(Fill{circle(p, s.handle_ring), ink.with_alpha(0.16), 0, 0, {}});
  c.marks.emplace_back(Stroke{circle(p, s.handle_ring), edge_ink(handle.role, c.theme), s.construction, {0, 0}, true});
  if (!has_mark(c, handle)) c.marks.emplace_back(Fill{circle(p, s.handle), ink, 0, 0, {}});
  c.obstacles.push_back({p, p, s.handle_ring, true});
}

}  // namespace isect::viz
