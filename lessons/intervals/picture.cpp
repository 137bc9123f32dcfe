#include <algorithm>

#include "lessons/intervals/picture.h"

namespace isect::lessons::intervals_lesson {

using namespace viz;

namespace {

constexpr double a_height = 2, b_height = 1;

}  // namespace

Setup setup(const Parameters& p) {
  const auto number = [&](const char* name) { return std::get<double>(p.at(name)); };
  Setup s = {{number("a_min"), number("a_max")}, {number("b_min"), number("b_max")}, {}};
  s.truth = relate(s.a, s.b);
  return s;
}

Scene picture(const Setup& s, const std::optional<Vec2>& looked_at, bool settled) {
  Scene scene;
  std::vector<Item>& items = scene.items;
  const double lo = std::min(s.a.lo, s.b.lo), hi = std::max(s.a.hi, s.b.hi), margin = 0.12 * (hi - lo) + 0.5;
  items.push_back(Arrow{{lo - margin, 0, 0}, {hi + margin, 0, 0}, Role::muted, Pen::hairline});
  items.push_back(Label{{hi + margin, 0, 0}, "*x*", Role::muted});

  const auto interval = [&](const Interval<double>& i, double y, Role role, const std::string& name) {
    for (const double x : {i.lo, i.hi})
      items.push_back(Line{{x, y, 0}, {x, 0, 0}, Role::construction, Pen::construction});
    const bool reversed = i.lo > i.hi,
               point = i.lo == i.hi;  // of a reversed one both ends are shown, and nothing between
    if (i.lo < i.hi) items.push_back(Span{{i.lo, y, 0}, {i.hi, y, 0}, role, Pen::thick});
    items.push_back(Dot{{i.lo, y, 0}, reversed ? Mark::excluded : Mark::disc, role});
    items.push_back(Label{{i.lo, y, 0}, point ? name : name + "_{min}", role});
    if (point) return;
    items.push_back(Dot{{i.hi, y, 0}, reversed ? Mark::excluded : Mark::disc, role});
    items.push_back(Label{{i.hi, y, 0}, name + "_{max}", role});
  };
  interval(s.a, a_height, Role::first, "*a*");
  interval(s.b, b_height, Role::second, "*b*");

  if (looked_at && looked_at->x() != looked_at->y())
    items.push_back(Line{{looked_at->x(), 0, 0}, {looked_at->y(), 0, 0}, Role::highlight, Pen::highlight});
  const Interval<double> common = {std::max(s.a.lo, s.b.lo), std::min(s.a.hi, s.b.hi)};
  if (empty(s.a) || empty(s.b)) settled = false;
  if (settled && common.lo < common.hi)
    items.push_back(Span{{common.lo, 0, 0}, {common.hi, 0, 0}, Role::hit, Pen::thick});
  if (settled && common.lo == common.hi) items.push_back(Dot{{common.lo, 0, 0}, Mark::disc, Role::hit});
  if (settled && common.lo > common.hi)
    items.push_back(Line{{common.hi, 0, 0}, {common.lo, 0, 0}, Role::miss, Pen::excluded});

  const auto handle = [&](const char* name, double x, double y, Role role) {
    scene.handles.push_back({name, Handle::Kind::along, {x, y, 0}, {0, y, 0}, role, Vec3::UnitX()});
  };
  handle("a_min", s.a.lo, a_height, Role::first);
  handle("a_max", s.a.hi, a_height, Role::first);
  handle("b_min", s.b.lo, b_height, Role::second);
  handle("b_max", s.b.hi, b_height, Role::second);
  return scene;
}

}  // namespace isect::lessons::intervals_lesson
