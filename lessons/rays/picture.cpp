#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lessons/rays/picture.h"

namespace isect::lessons::rays_lesson {

using namespace viz;
using Point2 = Point<double, 2>;

namespace {

/// The least part of the plane that is drawn.
const Aabb<double, 2> least_view = {{-3.5, -1.5}, {3.5, 1.75}};

/// The view with all that the text mentions: what defines the ray, and where the line meets the wall.
Aabb<double, 2> view_of(const Setup& s, bool hit) {
  Aabb<double, 2> view = least_view;
  const auto show = [&](const Point2& p) {
    constexpr double margin = 0.25;
    view.lo = view.lo.cwiseMin(p - Point2::Constant(margin)), view.hi = view.hi.cwiseMax(p + Point2::Constant(margin));
  };
  show(s.o.head<2>());
  const Vec3 tip = s.made == Made::points ? s.q : Vec3(s.o + s.d);
  show(tip.head<2>());
  if (hit && s.truth.line) show(s.ray.at(1.15 * *s.truth.line));  // and beyond
  return view;
}

/// The stretch of t in which the line runs through the view.
Interval<double> drawn(const Ray<double, 2>& ray, const Aabb<double, 2>& view) {
  const Ray<double, 2> line = {ray.origin, ray.direction, infinite<double>};
  const std::optional<Interval<double>> part = intersect(line, view);
  if (!part || !finite(*part)) return {0, 1};
  return {std::min(part->lo, 0.0), std::max(part->hi, 1.0)};
}

/// Draws small, labelled strokes across the line at every whole t.
void draw_marks(Scene& scene, const Ray<double, 2>& ray, const Interval<double>& t) {
  const double length = ray.direction.norm();
  if (!(length > 0.2)) return;  // too dense to draw
  const Vector<double, 2> across = 0.09 / length * Vector<double, 2>(-ray.direction.y(), ray.direction.x());
  const int first = static_cast<int>(std::ceil(std::max(t.lo, -40.0)));
  const int last = static_cast<int>(std::floor(std::min(t.hi, 40.0)));
  for (int i = first; i <= last; ++i) {
    const Point2 p = ray.at(i);
    scene.items.emplace_back(Line{flat(p - across), flat(p + across), Role::text, Pen::solid});
    scene.items.emplace_back(Label{flat(p), shown(i), Role::muted});
  }
}

class Painter {
 public:
  Painter(const Setup& s, const Shown& shown)
      : s_(s), k_(shown), view_(view_of(s, shown.hit)), line_(drawn(s.ray, view_)) {
    own_ = {std::max(line_.lo, s.ray.range.lo), std::min(line_.hi, s.ray.range.hi)};
  }

  Scene paint() {
    if (k_.wall) wall();
    if (k_.marks) line();
    if (k_.range) range();
    if (!k_.marks) given();
    if (k_.marks) draw_marks(scene_, s_.ray, line_);
    if (k_.hit && s_.truth.line) hit();
    points();
    handles();
    if (k_.range && s_.ray.direction != Point2::Zero()) axis();
    return std::move(scene_);
  }

 private:
  Vec3 at(double t) const { return flat(s_.ray.at(t)); }
  void add(Item item) { scene_.items.push_back(std::move(item)); }

  void wall() {
    add(Line{{s_.wall, view_.lo.y(), 0}, {s_.wall, view_.hi.y(), 0}, Role::second, Pen::thick});
    add(Label{Vec3(s_.wall, view_.lo.y() + 0.25, 0), "wall", Role::second});
  }

  /// Draws the line, without regard to its range.
  void line() { add(Line{at(line_.lo), at(line_.hi), Role::construction, Pen::construction}); }

  void range() {
    if (own_.lo > own_.hi) return;
    const Vec3 from = at(own_.lo), to = at(own_.hi);
    if (s_.extent == "segment") return add(Line{from, to, Role::first, Pen::thick});
    add(Arrow{s_.extent == "line" ? at(0) : from, to, Role::first, Pen::thick});
    if (s_.extent == "line") add(Arrow{at(0), from, Role::first, Pen::thick});
  }

  void given() {
    const Vec3 tip = s_.made == Made::points ? s_.q : Vec3(s_.o + s_.d);
    add(Arrow{s_.o, tip, Role::first, Pen::solid});
    add(s_.made == Made::points ? Label{s_.o, "**d**", Role::first, tip} : Label{tip, "**d**", Role::first});
    if (s_.made != Made::unit) return;
    add(Arrow{s_.o, at(1), Role::highlight, Pen::highlight});
    add(Label{at(1), "**u**", Role::text});
  }

  /// Draws the hit: as a plain point until it is settled whether it counts.
  void hit() {
    const double t = *s_.truth.line;
    const bool counts = s_.ray.range.contains(t);
    add(Dot{at(t), met_mark(counts), met_role(counts)});
    add(Label{at(t), "**r**(*t*)", !k_.settled ? Role::text : counts ? Role::hit : Role::muted});
  }
  Mark met_mark(bool counts) const { return k_.settled && !counts ? Mark::excluded : Mark::disc; }
  Role met_role(bool counts) const { return !k_.settled ? Role::text : counts ? Role::hit : Role::construction; }

  void points() {
    const bool two = s_.made == Made::points;
    add(Dot{s_.o, Mark::disc, Role::first});
    add(Label{s_.o, two ? "**p**_1" : "**o**", Role::first});
    if (!two) return;
    if (!(k_.settled && s_.truth.t == 1.0)) add(Dot{s_.q, Mark::disc, Role::first});
    add(Label{s_.q, "**p**_2", Role::first});
  }

  void handles() {
    scene_.handles = {{"o", Handle::Kind::point, s_.o, Vec3::Zero(), Role::first}};
    if (s_.made == Made::points)
      scene_.handles.push_back({"q", Handle::Kind::point, s_.q, Vec3::Zero(), Role::first});
    else
      scene_.handles.push_back({"d", Handle::Kind::vector, s_.o + s_.d, s_.o, Role::first});
    if (!k_.wall) return;
    const Vec3 foot = {0, view_.lo.y(), 0};
    scene_.handles.push_back({"wall", Handle::Kind::along, foot + s_.wall * Vec3::UnitX(), foot, Role::second});
  }

  void axis() {
    Axis axis;
    axis.lo = line_.lo, axis.hi = line_.hi;
    axis.range_lo = s_.ray.range.lo, axis.range_hi = s_.ray.range.hi;
    if (k_.hit && s_.truth.line) {
      const bool counts = s_.ray.range.contains(*s_.truth.line);
      axis.ticks.push_back({*s_.truth.line, met_mark(counts), met_role(counts), "*t*"});
    }
    scene_.axis = axis;
  }

  const Setup& s_;
  const Shown& k_;
  Aabb<double, 2> view_;
  Interval<double> line_, own_;  ///< as far as drawn: the line, and the range
  Scene scene_;
};

}  // namespace

Setup setup(const Parameters& p) {
  Setup s;
  const std::string& made = std::get<std::string>(p.at("made"));
  s.made = made == "unit" ? Made::unit : made == "points" ? Made::points : Made::direction;
  s.extent = std::get<std::string>(p.at("extent"));
  s.o = std::get<Vec3>(p.at("o")), s.d = std::get<Vec3>(p.at("d")), s.q = std::get<Vec3>(p.at("q"));
  s.wall = std::get<double>(p.at("wall"));
  s.o.z() = s.d.z() = s.q.z() = 0;

  const Point2 o = s.o.head<2>(), q = s.q.head<2>();
  const Vector<double, 2> d = s.d.head<2>();
  s.ray = s.made == Made::points ? segment(o, q) : Ray<double, 2>{o, d, {0, 1}};
  const double length = std::sqrt(d.dot(d));
  if (s.made == Made::unit && length > 0) s.ray.direction = d / length, s.ray.range.hi = length;
  if (s.extent != "segment") s.ray.range.hi = infinite<double>.hi;
  if (s.extent == "line") s.ray.range.lo = infinite<double>.lo;

  s.plane = {{1, 0}, -s.wall};
  s.truth = intersect(s.ray, s.plane);
  return s;
}

Scene picture(const Setup& s, const Shown& shown) { return Painter(s, shown).paint(); }

}  // namespace isect::lessons::rays_lesson
