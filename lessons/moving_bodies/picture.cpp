#include "lessons/moving_bodies/picture.h"

#include <algorithm>
#include <memory>

#include "lessons/shared/flat.h"

namespace isect::lessons::moving_bodies_lesson {

using namespace viz;

namespace {

class Painter {
 public:
  Painter(const Setup& s, const Known& k) : s_(s), k_(k) {
    all_ = Setup::around(s.a, s.r_a + s.r_b);
    hold(s.b, s.r_b);
    hold(s.a + s.duration * s.v_a, s.r_a);
    hold(s.b + s.duration * s.v_b, s.r_b);
    hold(s.b_at(s.duration), s.r_b);
    const Vec2 size = all_.hi - all_.lo;
    if (const double unit = std::max(size.x() / 8, size.y() / 5); unit > 0) unit_ = unit;
  }

  Scene paint() {
    body(a_now(), s_.r_a, Role::first);
    if (k_.expanded) outline(s_.a, s_.r_a + s_.r_b, Role::first);
    if (!k_.expanded) body(b_now(), s_.r_b, Role::second);
    if (k_.now) begun();
    for (const double t : k_.at) outline(s_.b_at(t), s_.r_b, Role::second);
    if (k_.settled && s_.first) meeting();
    if (k_.gap) gap(*k_.gap);
    ways();
    centres();
    if (k_.now) centres_now();
    if (k_.clock && s_.duration > 0) clock();
    if (!k_.clock && k_.from_a && s_.duration > 0 && s_.method != "boxes") axis();
    handles();
    return std::move(scene_);
  }

 private:
  void add(Item item) { scene_.items.push_back(std::move(item)); }
  void hold(const Point<double, 2>& c, double r) {
    const Aabb<double, 2> box = Setup::around(c, r);
    all_ = {all_.lo.cwiseMin(box.lo), all_.hi.cwiseMax(box.hi)};
  }

  void body(const Point<double, 2>& c, double r, Role role) {
    if (!(r > 0)) return;
    if (s_.balls()) return add(Circle{.center = flat(c), .radius = r, .role = role, .filled = true});
    add(Region{.rings = {corners(Setup::around(c, r))}, .role = role});
  }
  void outline(const Point<double, 2>& c, double r, Role role) {
    if (!(r > 0)) return;
    if (s_.balls()) return add(Circle{.center = flat(c), .radius = r, .role = role, .pen = Pen::construction});
    add(Chain{corners(Setup::around(c, r)), true, role, Pen::construction});
  }

  /// Where the centres are; seen from a, that one stays.
  Point<double, 2> a_now() const { return k_.now && !k_.from_a ? Point<double, 2>(s_.a + *k_.now * s_.v_a) : s_.a; }
  Point<double, 2> b_now() const {
    if (!k_.now) return s_.b;
    return k_.from_a ? s_.b_at(*k_.now) : Point<double, 2>(s_.b + *k_.now * s_.v_b);
  }
  /// Outlines the bodies at the start, once they have left it; of a body that is drawn as a point, where it is now.
  void begun() {
    if (a_now() != s_.a) outline(s_.a, s_.r_a, Role::first);
    if (k_.expanded) return outline(b_now(), s_.r_b, Role::second);
    if (b_now() != s_.b) outline(s_.b, s_.r_b, Role::second);
  }
  void centres_now() {
    if (a_now() != s_.a) add(Dot{flat(a_now()), Mark::disc, Role::first});
    if (b_now() != s_.b) add(Dot{flat(b_now()), Mark::disc, Role::second});
  }

  /// Draws b at first contact, seen from a.
  void meeting() {
    const Point<double, 2> there = s_.b_at(*s_.first);
    if (!k_.expanded && s_.r_b > 0) {
      if (s_.balls())
        add(Circle{.center = flat(there), .radius = s_.r_b, .role = Role::hit, .pen = Pen::thick});
      else
        add(Chain{corners(Setup::around(there, s_.r_b)), true, Role::hit, Pen::thick});
    }
    if (there == s_.b) return;
    add(Dot{flat(there), Mark::disc, Role::hit});
    add(Label{flat(there), "*t*", Role::hit});
  }

  /// Draws the line from one surface to the other, along the line of centres.
  void gap(double t) {
    const Vector<double, 2> l = s_.b_at(t) - s_.a;
    const double length = l.norm();
    if (!(length > s_.r_a + s_.r_b)) return;
    const Vector<double, 2> n = l / length;
    add(Line{flat(s_.a + s_.r_a * n), flat(s_.b_at(t) - s_.r_b * n), Role::highlight, Pen::highlight});
  }

  void way(const Point<double, 2>& from, const Vector<double, 2>& velocity, const char* name, Role role) {
    const Vec3 tip = flat(from + s_.duration * velocity);
    if (tip == flat(from)) return;
    add(Arrow{flat(from), tip, role, Pen::solid});
    add(Label{flat(from), name, role, tip});
  }
  void ways() {
    if (k_.from_a) return way(s_.b, s_.d(), "**d**", Role::second);
    way(s_.a, s_.v_a, "**v**_a", Role::first);
    way(s_.b, s_.v_b, "**v**_b", Role::second);
  }

  void centres() {
    add(Dot{flat(s_.a), Mark::disc, Role::first});
    add(Dot{flat(s_.b), Mark::disc, Role::second});
    if (s_.a == s_.b) return add(Label{flat(s_.a), "**a** = **b**", Role::text});
    add(Label{flat(s_.a), "**a**", Role::first});
    add(Label{flat(s_.b), "**b**", Role::second});
  }

  /// Draws the duration as a line below the bodies, and the rows of times above it.
  void clock() {
    const double width = std::max(all_.hi.x() - all_.lo.x(), 5 * unit_), step = 0.5 * unit_;
    const double left = (all_.lo.x() + all_.hi.x() - width) / 2, top = all_.lo.y() - 0.7 * unit_;
    const double bottom = top - 2 * step;  // room for two rows from the start, so that nothing moves
    const auto x = [&](double t) { return left + t / s_.duration * width; };
    add(Line{{left, bottom, 0}, {left + width, bottom, 0}, Role::muted, Pen::hairline});
    add(Heading{{left - 0.25 * unit_, bottom, 0}, "*t* = 0", Role::muted, 0, false, 1});
    add(Heading{{left + width + 0.25 * unit_, bottom, 0}, shown(s_.duration), Role::muted, 0, false, 0});
    for (std::size_t i = 0; i < k_.rows.size(); ++i) {
      const Row& row = k_.rows[i];
      const double y = row.role == Role::hit ? bottom : top - step * static_cast<double>(i);
      const double margin = 0.08 * s_.duration;
      const Interval<double> seen = {std::max(row.times.lo, -margin), std::min(row.times.hi, s_.duration + margin)};
      if (!row.name.empty()) add(Heading{{x(-margin) - 0.25 * unit_, y, 0}, row.name, Role::text, 0, false, 1});
      if (!(seen.lo <= seen.hi)) continue;
      if (seen.lo == seen.hi) {
        add(Dot{{x(seen.lo), y, 0}, Mark::disc, row.role});
        continue;
      }
      add(Span{.from = {x(seen.lo), y, 0},
               .to = {x(seen.hi), y, 0},
               .role = row.role,
               .open_from = row.times.lo<seen.lo, .open_to = row.times.hi> seen.hi});
    }
    if (!k_.now) return;
    const double now = x(*k_.now), beyond = 0.25 * unit_;
    add(Line{{now, bottom - beyond, 0}, {now, top + beyond, 0}, Role::highlight, Pen::solid});
  }

  void axis() {
    Axis axis;
    axis.lo = -0.1 * s_.duration, axis.hi = 1.1 * s_.duration;
    axis.range_lo = 0, axis.range_hi = s_.duration;
    axis.ticks = k_.ticks;
    if (k_.now) axis.ticks.push_back({*k_.now, Mark::uncounted, Role::highlight, ""});
    if (k_.shared) axis.shared = Vec2(k_.shared->lo, k_.shared->hi);
    scene_.axis = axis;
  }

  void handles() {
    const Vec3 a = flat(s_.a), b = flat(s_.b);
    scene_.handles = {{"a", Handle::Kind::point, a, Vec3::Zero(), Role::first},
                      {"b", Handle::Kind::point, b, Vec3::Zero(), Role::second},
                      {"r_a", Handle::Kind::length, a - s_.r_a * Vec3::UnitY(), a, Role::first}};
    if (!k_.expanded)  // else b is a point
      scene_.handles.push_back({"r_b", Handle::Kind::length, b - s_.r_b * Vec3::UnitY(), b, Role::second});
    if (!(s_.duration > 0)) return;
    const auto velocity = [&](const char* name, const Vec3& anchor, const Vec3& tip, Role role) {
      Handle handle = {name, Handle::Kind::vector, tip, anchor, role};
      handle.scale = s_.duration;
      scene_.handles.push_back(handle);
    };
    if (k_.from_a)  // at the tip of d, from where b would start if a were at rest
      return velocity("v_b", b - s_.duration * flat(s_.v_a), flat(s_.b_at(s_.duration)), Role::second);
    velocity("v_a", a, flat(s_.a + s_.duration * s_.v_a), Role::first);
    velocity("v_b", b, flat(s_.b + s_.duration * s_.v_b), Role::second);
  }

  const Setup& s_;
  const Known& k_;
  Aabb<double, 2> all_;
  double unit_ = 1;
  Scene scene_;
};

}  // namespace

Scene picture(const Setup& s, const Known& known) {
  Scene scene = Painter(s, known).paint();
  if (!(s.duration > 0)) return scene;
  const auto at = [s, known](double t) {
    Known then = known;
    then.now = t;
    return Painter(s, then).paint();
  };
  const std::optional<double> contact = known.found || known.settled ? s.first : std::nullopt;
  scene.time = std::make_shared<const Scene::Time>(Scene::Time{0, s.duration, 0, contact, at});
  return scene;
}

}  // namespace isect::lessons::moving_bodies_lesson
