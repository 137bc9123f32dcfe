#include "viz/compose.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

#include "viz/labels.h"
#include "viz/marks.h"
#include "viz/visibility.h"

namespace isect::viz {
namespace {

Colour mixed(const Colour& a, const Colour& b, double share) {
  return {a.r + share * (b.r - a.r), a.g + share * (b.g - a.g), a.b + share * (b.b - a.b), 1};
}

/// Collects the shapes of a scene in painter's order: floor, fills, hidden lines, visible lines, marks, labels.
class Composer {
 public:
  Composer(const Scene& scene, const View& view, const Theme& theme)
      : scene_(scene), view_(view), theme_(theme) {
    for (const Item& item : scene.items)
      if (const Ball* ball = std::get_if<Ball>(&item)) balls_.push_back(*ball);
    std::sort(balls_.begin(), balls_.end(), [&](const Ball& a, const Ball& b) {
      return view_.project(a.center).depth > view_.project(b.center).depth;
    });
  }

  Composed run(bool handles) {
    if (theme_.floor_grid && view_.camera().elevation > 0.05) floor();
    for (int i = 0; i < static_cast<int>(balls_.size()); ++i) ball(i);
    for (const Item& item : scene_.items) std::visit([&](const auto& it) { add(it); }, item);
    if (handles)
      for (const Handle& handle : scene_.handles) grip(handle);

    Composed result;
    for (std::vector<Shape>* layer : {&ground_, &fills_, &hidden_, &lines_, &marks_})
      result.shapes.insert(result.shapes.end(), layer->begin(), layer->end());
    const Vec2 corner = view_.corner();
    const Bounds bounds = {corner.x() + sizes().margin, corner.y() + sizes().margin,
                           corner.x() + view_.width() - sizes().margin,
                           corner.y() + view_.height() - sizes().margin};
    result.labels = place_labels(labels_, obstacles_, bounds, theme_, result.shapes);
    return result;
  }

 private:
  const Sizes& sizes() const { return theme_.sizes; }
  Vec2 at(const Vec3& p) const { return view_.project(p).at; }

  void block(const std::vector<Vec2>& points, double radius, bool firm) {
    for (std::size_t i = 1; i < points.size(); ++i)
      obstacles_.push_back({points[i - 1], points[i], radius, firm});
  }

  std::vector<Vec2> projected(const std::vector<Vec3>& points) const {
    std::vector<Vec2> flat;
    for (const Vec3& p : points) flat.push_back(at(p));
    return flat;
  }

  /// The floor touches the lowest thing in the scene. Its grid fades into the background, so it needs no edge.
  void floor() {
    double lowest = INFINITY, reach = 1;
    Vec3 middle = view_.camera().target;
    for (const Ball& b : balls_) lowest = std::min(lowest, b.center.y() - b.radius);
    for (const Item& item : scene_.items)
      if (const Dot* dot = std::get_if<Dot>(&item)) lowest = std::min(lowest, dot->at.y());
    if (!std::isfinite(lowest)) return;
    reach = 2.2 * view_.camera().half_height;

    const double spacing = std::pow(2.0, std::round(std::log2(view_.camera().half_height / 3)));
    const auto fade = [&](const Vec3& p) {
      return std::clamp(Vec2(p.x() - middle.x(), p.z() - middle.z()).norm() / reach, 0.0, 1.0);
    };
    const int count = static_cast<int>(std::ceil(reach / spacing));
    const double x0 = spacing * std::round(middle.x() / spacing),
                 z0 = spacing * std::round(middle.z() / spacing);
    for (int i = -count; i <= count; ++i) {
      for (int k = -count; k < count; ++k) {
        const double a = i * spacing, b0 = k * spacing, b1 = (k + 1) * spacing;
        const Vec3 ends[2][2] = {{{x0 + a, lowest, z0 + b0}, {x0 + a, lowest, z0 + b1}},
                                 {{x0 + b0, lowest, z0 + a}, {x0 + b1, lowest, z0 + a}}};
        for (const auto& [from, to] : ends) {
          const double share = fade((from + to) / 2);
          if (share >= 1) continue;
          const Colour colour = mixed(theme_.ink(Role::grid), theme_.background, share);
          ground_.emplace_back(Stroke{polyline({at(from), at(to)}), colour, sizes().hairline, {0, 0}, false});
        }
      }
    }

    for (const Ball& b : balls_) {
      const Vec3 below = {b.center.x(), lowest, b.center.z()};
      const double scale = view_.scale_at(below) * b.radius;
      const Colour dark = theme_.name == ThemeName::dark ? hex(0x000000) : theme_.ink(Role::text);
      ground_.emplace_back(Gradient{at(below),
                                    {scale, 0},
                                    {0, scale * std::sin(view_.camera().elevation)},
                                    at(below),
                                    dark.with_alpha(theme_.name == ThemeName::dark ? 0.55 : 0.16),
                                    dark.with_alpha(0)});
    }
    for (const Item& item : scene_.items) {
      const Dot* dot = std::get_if<Dot>(&item);
      if (dot == nullptr || dot->role != Role::first || dot->at.y() - lowest < 1e-3 * reach) continue;
      const Vec3 foot = {dot->at.x(), lowest, dot->at.z()};
      const double w = sizes().hairline;
      ground_.emplace_back(Stroke{
          polyline({at(dot->at), at(foot)}), theme_.ink(Role::construction), w, {1.2 * w, 3.2 * w}, false});
      ground_.emplace_back(Fill{circle(at(foot), 2.2 * w), theme_.ink(Role::construction), 0, 0, {}});
      block({at(dot->at), at(foot)}, w, false);
    }
  }

  void ball(int index) {
    const Ball& b = balls_[index];
    const Outline edge = outline(b, view_);
    const Colour ink = theme_.ink(b.role);
    const Path rim = ellipse(edge.center, edge.major, edge.minor);
    if (theme_.hatch_second && b.role == Role::second) {
      fills_.emplace_back(Fill{rim, ink.with_alpha(0.07), sizes().hatch_gap, sizes().hatch_line, ink});
    } else {
      const double radius = edge.major.norm();
      const Vec2 lit = edge.center + 0.42 * radius * Vec2(-0.35, -0.55);  // towards the light, upper left
      fills_.emplace_back(Gradient{edge.center, edge.major, edge.minor, lit,
                                   ink.with_alpha(0.3 * theme_.fill_alpha),
                                   ink.with_alpha(1.9 * theme_.fill_alpha)});
    }

    const Vec3 u = b.radius * Vec3::UnitX(), v = b.radius * Vec3::UnitZ();
    for (const Stretch& part : stretches(b.center, u, v, view_, balls_, index)) {
      curve(part, ink.with_alpha(0.75), sizes().hidden * (part.hidden ? 1 : 1.1), false);
    }
    if (balls_.size() == 1) {
      lines_.emplace_back(Stroke{rim, ink, sizes().outline, {0, 0}, true});
    } else {
      for (const Stretch& part : silhouette(index)) curve(part, ink, sizes().outline, false);
    }
    std::vector<Vec2> points = flatten(rim, 0.5);
    points.push_back(points.front());
    block(points, sizes().outline / 2, true);
  }

  /// The circle in space whose picture is the ball's outline.
  std::vector<Stretch> silhouette(int index) const {
    const Ball& b = balls_[index];
    const Vec3 n = view_.towards_eye(b.center);
    Vec3 middle = b.center;
    double radius = b.radius;
    if (view_.camera().perspective) {
      const double share = b.radius / (view_.eye() - b.center).norm();
      middle += share * b.radius * n;
      radius *= std::sqrt(1 - share * share);
    }
    const Vec3 u = n.cross(view_.up()).normalized(), v = n.cross(u);
    std::vector<Stretch> parts;
    std::vector<Ball> others = balls_;
    others.erase(others.begin() + index);
    return stretches(middle, radius * u, radius * v, view_, others, -1);
  }

  /// A stretch as a line, dashed and thinner where hidden.
  void curve(const Stretch& part, const Colour& colour, double width, bool firm) {
    const std::vector<Vec2> points = projected(part.points);
    if (part.hidden)
      hidden_.emplace_back(Stroke{polyline(points), colour, sizes().hidden, sizes().hidden_dash, false});
    else
      lines_.emplace_back(Stroke{polyline(points), colour, width, {0, 0}, true});
    block(points, width / 2, firm && !part.hidden);
  }

  double width(Pen pen, Role role) const {
    switch (pen) {
      case Pen::thick:
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
    return role == Role::first ? sizes().ray : sizes().outline;
  }

  void line(const Vec3& from, const Vec3& to, Role role, Pen pen) {
    const Colour colour = theme_.ink(role);
    const double w = width(pen, role);
    if (pen == Pen::solid) {
      for (const Stretch& part : stretches(from, to, view_, balls_)) curve(part, colour, w, true);
      return;
    }
    const std::vector<Vec2> ends = {at(from), at(to)};
    const bool dashed = pen == Pen::construction;
    if (pen == Pen::highlight && theme_.name != ThemeName::dark)  // yellow on white needs an edge to be seen
      lines_.emplace_back(
          Stroke{polyline(ends), theme_.ink(Role::text), w + 2 * sizes().hairline, {0, 0}, true});
    lines_.emplace_back(Stroke{polyline(ends), colour, w,
                               dashed ? sizes().construction_dash : std::array<double, 2>{0, 0}, !dashed});
    block(ends, w / 2, !dashed);
  }

  void add(const Ball&) {}  // drawn far to near before the other items

  void add(const Line& it) { line(it.from, it.to, it.role, it.pen); }

  void add(const Arrow& it) {
    const double length = (at(it.to) - at(it.from)).norm(), keep_off = dot_radius(it.to);
    const bool room = length > 1.2 * sizes().arrow + keep_off;  // an arrow towards the eye shows no head
    const auto before_end = [&](double pixels) -> Vec3 {
      return it.to + (pixels / length) * (it.from - it.to);
    };
    line(it.from, room ? before_end(keep_off + 0.8 * sizes().arrow) : it.to, it.role, it.pen);
    if (!room) return;
    const Vec2 tip = at(before_end(keep_off));
    lines_.emplace_back(arrow_head(tip, (at(it.to) - at(it.from)) / length, theme_.ink(it.role), sizes()));
    obstacles_.push_back({tip, tip, 0.5 * sizes().arrow, true});
  }

  /// The radius to keep off the marker at `p`, 0 where there is none.
  double dot_radius(const Vec3& p) const {
    double radius = 0;
    for (const Item& item : scene_.items)
      if (const Dot* dot = std::get_if<Dot>(&item); dot != nullptr && dot->at == p)
        radius = std::max(radius, mark_radius(dot->mark, sizes()) + sizes().halo);
    return radius;
  }

  void add(const RightAngle& it) {
    const double side = 1.9 * sizes().disc / view_.scale_at(it.at);
    const Vec3 u = side * (it.a - it.at).normalized(), v = side * (it.b - it.at).normalized();
    const std::vector<Vec2> points = projected({it.at + u, it.at + u + v, it.at + v});
    lines_.emplace_back(
        Stroke{polyline(points), theme_.ink(Role::construction), sizes().construction, {0, 0}, true});
    block(points, sizes().construction, false);
  }

  void add(const Dot& it) {
    mark(marks_, it.mark, at(it.at), it.role, theme_);
    obstacles_.push_back({at(it.at), at(it.at), mark_radius(it.mark, sizes()), true});
  }

  void add(const Label& it) {
    const Vec2 from = at(it.at), to = it.until ? at(*it.until) : from;
    double keep_off = it.until ? sizes().outline : dot_radius(it.at);
    for (const Handle& handle : scene_.handles)
      if (!it.until && handle.at == it.at && has_grips_) keep_off = sizes().handle_ring;
    const Role role = it.role == Role::highlight && theme_.name != ThemeName::dark ? Role::text : it.role;
    labels_.push_back({it.text, from, to, keep_off, theme_.ink(role)});
  }

  void grip(const Handle& handle) {
    const Vec2 p = at(handle.at);
    const Colour ink = theme_.ink(handle.role);
    marks_.emplace_back(Fill{circle(p, sizes().handle_ring), ink.with_alpha(0.16), 0, 0, {}});
    marks_.emplace_back(Stroke{circle(p, sizes().handle_ring), ink, sizes().construction, {0, 0}, true});
    marks_.emplace_back(Fill{circle(p, sizes().handle), ink, 0, 0, {}});
    obstacles_.push_back({p, p, sizes().handle_ring, true});
  }

 public:
  bool has_grips_ = false;  ///< labels keep off the grips

 private:
  const Scene& scene_;
  const View& view_;
  const Theme& theme_;
  std::vector<Ball> balls_;  ///< far to near
  std::vector<Shape> ground_, fills_, hidden_, lines_, marks_;
  std::vector<Wanted> labels_;
  std::vector<Obstacle> obstacles_;
};

}  // namespace

Composed compose(const Scene& scene, const View& view, const Theme& theme, bool handles) {
  Composer composer(scene, view, theme);
  composer.has_grips_ = handles;
  return composer.run(handles);
}

Camera frame(const Camera& camera, const std::vector<const Scene*>& scenes, double aspect, double margin) {
  const View view(camera, 1, 1);  // for its axes only
  Vec3 lo = Vec3::Constant(INFINITY), hi = Vec3::Constant(-INFINITY);
  const auto include = [&](const Vec3& p, double radius = 0) {
    const Vec3 q = {p.dot(view.right()), p.dot(view.up()), p.dot(view.forward())};
    lo = lo.cwiseMin(q - Vec3::Constant(radius));
    hi = hi.cwiseMax(q + Vec3::Constant(radius));
  };
  struct Extent {
    const decltype(include)& grow;
    void operator()(const Ball& it) const { grow(it.center, it.radius); }
    void operator()(const Line& it) const { grow(it.from), grow(it.to); }
    void operator()(const Arrow& it) const { grow(it.from), grow(it.to); }
    void operator()(const RightAngle& it) const { grow(it.at); }
    void operator()(const Dot& it) const { grow(it.at); }
    void operator()(const Label& it) const { grow(it.at); }
  };
  for (const Scene* scene : scenes)
    for (const Item& item : scene->items) std::visit(Extent{include}, item);
  if (!(lo.x() <= hi.x())) return camera;

  Camera framed = camera;
  const Vec3 middle = (lo + hi) / 2;
  framed.target = middle.x() * view.right() + middle.y() * view.up() + middle.z() * view.forward();
  const double half = std::max({(hi.y() - lo.y()) / 2, (hi.x() - lo.x()) / 2 / aspect, 1e-6});
  framed.half_height = half / (1 - 2 * margin);
  if (camera.perspective)  // what stands nearer looks larger
    framed.half_height += (hi.z() - lo.z()) / 2 * std::tan(camera.field_of_view / 2);
  return framed;
}

Camera frame_alike(const Camera& camera, const Walk& walk, const std::vector<Walk>& all, double aspect) {
  const auto framed = [&](const Walk& w) {
    std::vector<const Scene*> scenes;
    for (const Step& s : w.steps) scenes.push_back(&s.scene);
    return frame(camera, scenes, aspect);
  };
  Camera result = framed(walk);
  for (const Walk& other : all) result.half_height = std::max(result.half_height, framed(other).half_height);
  return result;
}

}  // namespace isect::viz
