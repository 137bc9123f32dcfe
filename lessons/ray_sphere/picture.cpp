#include "lessons/ray_sphere/picture.h"

#include <algorithm>
#include <cmath>

#include "lessons/shared/plane.h"
#include "viz/text/rich_text.h"

namespace isect::lessons::ray_sphere_lesson {

using namespace viz;

double Setup::foot() const {
  const Vec3 f = ray.origin - sphere.center;
  const double dd = ray.direction.squaredNorm();
  return dd > 0 ? -f.dot(ray.direction) / dd : 0;
}

std::string told(const Setup& s, double t) {
  return "*t* = " + shown(t) + (s.lengths ? " (a length)" : ", in lengths of **d**");
}

bool Setup::segment() const { return std::isfinite(ray.range.hi); }

Setup setup(const Parameters& parameters, bool unit_direction) {
  Setup s;
  s.ray.origin = std::get<Vec3>(parameters.at("origin"));
  s.ray.direction = std::get<Vec3>(parameters.at("direction"));
  s.sphere = {std::get<Vec3>(parameters.at("center")), std::get<double>(parameters.at("radius"))};
  if (std::get<std::string>(parameters.at("extent")) == "segment")
    s.ray.range.hi = std::get<double>(parameters.at("t_max"));

  s.truth = intersect(s.ray,
                      s.sphere);  // of the direction as given: a rounded unit vector may miss what it touches
  const double length = s.ray.direction.stableNorm();
  if (!unit_direction || !(length > 0)) return s;

  s.lengths = true;
  s.given = length;
  s.ray.direction /= length;
  s.ray.range.hi *= length;
  s.truth.roots = {s.truth.roots.lo * length, s.truth.roots.hi * length};
  if (s.truth.surface) *s.truth.surface *= length;
  if (s.truth.solid) s.truth.solid = {s.truth.solid->lo * length, s.truth.solid->hi * length};
  return s;
}

namespace {

class Painter {
 public:
  Painter(const Setup& setup, const Known& known) : s_(setup), k_(known) {
    const double r = s_.sphere.radius, speed = std::max(s_.ray.direction.norm(), 1e-12);
    const double beyond = std::max(s_.foot() + 2.0 * r / speed, 1.3 * r / speed);
    end_ = s_.segment() ? s_.ray.range.hi : std::max(beyond, 1.35);
    t_[0] = s_.truth.roots.lo, t_[1] = s_.truth.roots.hi;
    shown_roots_ = s_.truth.line_roots > 0 ? k_.roots : 0;
  }

  Scene paint() {
    add(Ball{s_.sphere.center, s_.sphere.radius, Role::second});
    line_outside_the_range();
    ray();
    center_line();
    foot();
    half_chord();
    points();
    handles();
    if (s_.ray.direction.squaredNorm() > 0) axis();
    return std::move(scene_);
  }

 private:
  Vec3 at(double t) const { return s_.ray.at(t); }
  void add(Item item) { scene_.items.push_back(std::move(item)); }
  bool focus(Focus f) const { return k_.focus == f; }

  /// The part of the line outside the ray, as far as something was found on it.
  void line_outside_the_range() {
    double lo = 0, hi = end_;
    if (k_.foot) lo = std::min(lo, s_.foot()), hi = std::max(hi, s_.foot());
    for (int i = 0; i < shown_roots_; ++i) lo = std::min(lo, t_[i]), hi = std::max(hi, t_[i]);
    const double margin = 0.12 * (end_ + 1);
    if (lo < 0) add(Line{at(0), at(lo - margin), Role::construction, Pen::construction});
    if (s_.segment() && hi > end_) add(Line{at(end_), at(hi + margin), Role::construction, Pen::construction});
  }

  void ray() {
    const Vec3 o = at(0), tip = at(end_);
    if (s_.segment()) {
      add(Line{o, tip, Role::first, Pen::solid});
    } else {
      add(Arrow{o, tip, Role::first, Pen::solid});
    }
    if (focus(Focus::direction)) add(Arrow{o, at(1), Role::highlight, Pen::highlight});
    if (k_.settled && s_.truth.solid) {
      const Vec3 in = at(s_.truth.solid->lo), out = at(std::min(s_.truth.solid->hi, end_));
      if (in != out) add(Line{in, out, Role::hit, Pen::thick});
    }
    add(Label{tip, s_.segment() ? "*t*_{max}" : "**d**", Role::first});
  }

  void center_line() {
    if (!k_.center_line) return;
    const Vec3 o = at(0), c = s_.sphere.center;
    const Pen pen = focus(Focus::center_line) ? Pen::highlight : Pen::construction;
    const Role role = focus(Focus::center_line) ? Role::highlight : Role::construction;
    add(k_.from_center ? Item(Arrow{c, o, role, pen}) : Item(Arrow{o, c, role, pen}));
    add(Label{o, k_.from_center ? "**f**" : "**l**", Role::text, c});
  }

  /// The foot of the perpendicular from the center, and how far the line passes from it.
  void foot() {
    if (!k_.foot) return;
    const Vec3 o = at(0), c = s_.sphere.center, foot = at(s_.foot());
    if (focus(Focus::along)) {
      add(Line{o, foot, Role::highlight, Pen::highlight});
      if (!k_.from_center) add(Label{o, "*s*", Role::highlight, foot});
    }
    if (!k_.passing && !focus(Focus::along)) return;
    if ((foot - c).norm() < 1e-9 * s_.sphere.radius) return;  // through the center: nothing to draw
    const bool lit = focus(Focus::passing);
    add(Line{foot, c, lit ? Role::highlight : Role::construction, lit ? Pen::highlight : Pen::construction});
    add(RightAngle{foot, c, foot - s_.ray.direction});
    if (k_.passing) add(Label{foot, "*m*", lit ? Role::highlight : Role::text, c});
  }

  void half_chord() {
    if (!k_.half_chord || s_.truth.line_roots < 2) return;
    const double t = t_[1] == 0 ? t_[0] : t_[1];  // not the origin, where l is drawn
    const Vec3 c = s_.sphere.center, foot = at(s_.foot()), rim = at(t);
    const bool lit = focus(Focus::half_chord);
    if (lit) add(Line{foot, rim, Role::highlight, Pen::highlight});
    if (!k_.from_center) add(Label{foot, "*q*", lit ? Role::highlight : Role::text, rim});
    add(Line{c, rim, Role::construction, Pen::construction});
    add(Label{c, "*r*", Role::text, rim});
  }

  /// The marker of a root: entry, exit, double root or outside the range.
  Mark mark_of(int root) const {
    const bool in_range = s_.ray.range.contains(t_[root]);
    if (!in_range) return Mark::excluded;
    if (s_.truth.line_roots == 1) return Mark::double_disc;
    return s_.truth.surface == t_[root] ? Mark::disc : Mark::ring;
  }
  Role role_of(int root) const { return mark_of(root) == Mark::excluded ? Role::construction : Role::hit; }

  void points() {
    const Vec3 o = at(0), c = s_.sphere.center;
    add(Dot{c, Mark::disc, Role::second});
    const bool on = k_.settled && s_.truth.origin == Location::on;
    add(on ? Dot{o, Mark::diamond, Role::highlight} : Dot{o, Mark::disc, Role::first});
    if (s_.segment()) add(Dot{at(end_), Mark::disc, Role::first});
    const bool misses = k_.settled && s_.truth.line_roots == 0;
    if (misses) add(Dot{at(std::clamp(s_.foot(), 0.0, end_)), Mark::no, Role::miss});

    add(Label{o, "**o**", Role::first});
    add(Label{c, "**c**", Role::second});
    const bool twin = s_.truth.line_roots == 1;
    for (int i = 0; i < (twin ? std::min(shown_roots_, 1) : shown_roots_); ++i) {
      if (!(on && t_[i] == 0)) add(Dot{at(t_[i]), mark_of(i), role_of(i)});
      add(Label{at(t_[i]),
                twin     ? "*t*_{1,2}"
                : i == 0 ? "*t*_1"
                         : "*t*_2",
                role_of(i) == Role::hit ? Role::text : Role::muted});
    }
  }

  void handles() {
    const Vec3 o = at(0), c = s_.sphere.center;
    const Vec3 rim = c + s_.sphere.radius * (0.6 * across() - 0.8 * upwards()).normalized();
    scene_.handles = {{"origin", Handle::Kind::point, o, Vec3::Zero(), Role::first},
                      {"direction", Handle::Kind::vector, at(1), o, Role::first},
                      {"center", Handle::Kind::point, c, Vec3::Zero(), Role::second},
                      {"radius", Handle::Kind::length, rim, c, Role::second}};
    const Vec3& d = s_.ray.direction;
    const double dd = d.squaredNorm();
    if (s_.segment() && dd > 0)  // the parameter counts in lengths of the direction as given
      scene_.handles.push_back({"t_max", Handle::Kind::along, at(end_), o, Role::first, d / (dd * s_.given)});
  }

  void axis() {
    Axis axis;
    double lo = 0, hi = end_;  // with room for both roots from the start, so that the axis stands still
    if (s_.truth.line_roots > 0) lo = std::min(lo, t_[0]), hi = std::max(hi, t_[1]);
    const double margin = 0.1 * (hi - lo);
    axis.lo = lo - margin, axis.hi = hi + margin;
    axis.range_lo = s_.ray.range.lo, axis.range_hi = s_.ray.range.hi;
    if (k_.settled && s_.truth.solid) axis.shared = Vec2(s_.truth.solid->lo, std::min(s_.truth.solid->hi, axis.hi));
    const bool twin = s_.truth.line_roots == 1;
    for (int i = 0; i < (twin ? std::min(shown_roots_, 1) : shown_roots_); ++i)
      axis.ticks.push_back({t_[i], mark_of(i), role_of(i), twin ? "*t*_{1,2}" : i == 0 ? "*t*_1" : "*t*_2"});
    scene_.axis = axis;
  }

  const Setup& s_;
  const Known& k_;
  double end_;  ///< t where the drawn ray ends
  double t_[2];
  int shown_roots_;
  Scene scene_;
};

}  // namespace

Scene picture(const Setup& setup, const Known& known) { return Painter(setup, known).paint(); }

std::string alt_text(const Setup& s) {
  const std::string what = s.segment() ? "A segment" : "A ray";
  switch (s.truth.line_roots) {
    case 0:
      return what + " passes a ball without touching it.";
    case 1:
      if (s.is_a_point())
        return what + (!s.truth.surface                 ? "'s line passes through a point outside its range."
                       : s.truth.origin == Location::on ? " starts at a point, a ball of radius 0."
                                                        : " passes through a point, a ball of radius 0.");
      return what + (s.truth.surface ? " touches a ball in one point." : "'s line touches a ball outside its range.");
    default:
      break;
  }
  if (!s.truth.solid) return what + "'s line crosses a ball, but only outside its range, so it misses.";
  if (!s.truth.surface) return what + " lies wholly inside a ball and does not meet its surface.";
  const std::string where = plain(told(s, *s.truth.surface));
  if (s.truth.origin == Location::on) return what + " starts on the surface of a ball: its first hit is at t = 0.";
  if (s.truth.origin == Location::in) return what + " starts inside a ball and leaves it at " + where + ".";
  return what + " enters a ball at " + where + ".";
}

}  // namespace isect::lessons::ray_sphere_lesson
