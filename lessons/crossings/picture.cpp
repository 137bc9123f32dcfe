#include "lessons/crossings/picture.h"

#include <fmt/format.h>

#include "lessons/shared/flat.h"
#include "lessons/shared/location.h"
#include "lessons/shared/vertices.h"

namespace isect::lessons::crossings_lesson {

using namespace viz;

namespace {

const char* word(Location l) { return l == Location::in ? "IN" : l == Location::on ? "ON" : "OUT"; }

/// The abscissa where the ray ends: right of everything, so that it leaves the picture last.
double end_of_ray(const Setup& s) {
  double end = s.p.x();
  for (const Ring<double, 2>& ring : s.polygon.rings)
    for (const Point<double, 2>& v : ring) end = std::max(end, v.x());
  return end + 0.75;
}

/// Draws the ray raised by at most half the way to the next vertex above it, and so little that it looks like one ray.
void add_raised(const Setup& s, Scene& scene) {
  double rise = 0.15;
  for (const Ring<double, 2>& ring : s.polygon.rings)
    for (const Point<double, 2>& v : ring)
      if (v.y() > s.p.y()) rise = std::min(rise, (v.y() - s.p.y()) / 2);
  const Vec3 up = {0, rise, 0}, from = flat(s.p) + up, to = Vec3(end_of_ray(s), s.p.y(), 0) + up;
  scene.items.emplace_back(Arrow{from, to, Role::text, Pen::construction});
  scene.items.emplace_back(Label{to, "raised by *ε*", Role::text});
}

void add_meetings(const Known& known, Scene& scene) {
  for (std::size_t i = 0; i < known.meetings.size(); ++i) {
    const Meeting& m = known.meetings[i];
    std::string numbers;
    int counted = 0;
    bool first = true;
    for (std::size_t k = 0; k < known.meetings.size(); ++k) {
      if (known.meetings[k].at != m.at) continue;
      first = first && k >= i;
      if (known.meetings[k].number == 0) continue;
      numbers += (counted++ > 0 ? ", " : "") + std::to_string(known.meetings[k].number);
    }
    if (!first) continue;  // drawn with the first at this place
    const Mark mark = counted == 0 ? Mark::uncounted : counted == 1 ? Mark::disc : Mark::double_disc;
    scene.items.emplace_back(Dot{flat(m.at), mark, counted == 0 ? Role::construction : Role::hit});
    if (counted > 0) scene.items.emplace_back(Label{flat(m.at), numbers, Role::hit});
  }
}

}  // namespace

std::array<Point<double, 2>, 2> ends(const Setup& s, const EdgeOf& e) {
  const Ring<double, 2>& ring = s.polygon.rings[e.ring];
  const std::size_t i = static_cast<std::size_t>(e.index);
  return {ring[i], ring[(i + 1) % ring.size()]};
}

Point<double, 2> meeting(const Setup& s, const EdgeOf& e) {
  const auto [a, b] = ends(s, e);
  if (a.y() == s.p.y()) return a;
  if (b.y() == s.p.y()) return b;
  return {a.x() + (b.x() - a.x()) * (s.p.y() - a.y()) / (b.y() - a.y()), s.p.y()};
}

Scene picture(const Setup& s, const Known& known) {
  Scene scene;
  Region region;
  for (const Ring<double, 2>& ring : s.polygon.rings) region.rings.push_back(flat(ring));
  region.corners = true;
  if (region.rings.size() == 1)  // several rings are filled by the even-odd rule: a second one, of no area, asks for it
    region.rings.push_back({region.rings[0][0], region.rings[0][0], region.rings[0][0]});
  scene.items.emplace_back(region);

  const Vec3 p = flat(s.p), end = {end_of_ray(s), s.p.y(), 0};
  if (known.on)
    scene.items.emplace_back(Arrow{p, end, Role::construction, Pen::construction});
  else if (known.ray)
    scene.items.emplace_back(Arrow{p, end, Role::first, Pen::solid});
  if (known.raised) add_raised(s, scene);
  for (const EdgeOf& e : known.along) {
    const auto [a, b] = ends(s, e);
    scene.items.emplace_back(Line{flat(a), flat(b), Role::construction, Pen::excluded});
  }
  if (known.edge) {
    const auto [a, b] = ends(s, *known.edge);
    scene.items.emplace_back(Line{flat(a), flat(b), Role::highlight, Pen::highlight});
    scene.items.emplace_back(Label{flat(a), "**a**", Role::second});
    scene.items.emplace_back(Label{flat(b), "**b**", Role::second});
  }
  add_meetings(known, scene);
  scene.items.emplace_back(known.on ? Dot{p, Mark::diamond, Role::highlight} : Dot{p, Mark::disc, Role::first});
  scene.items.emplace_back(Label{p, "**p**", Role::first});
  scene.handles.push_back({"p", Handle::Kind::point, p, Vec3::Zero(), Role::first});
  std::size_t first = 0;
  for (const Ring<double, 2>& ring : s.polygon.rings) {
    add_handles(scene, "v", ring, Role::second, "a corner", first);
    first += ring.size();
  }
  return scene;
}

std::string verdict_text(const Winding& w) {
  if (w.even_odd == Location::on) return "ON the boundary: no counting";
  const std::string odd = w.crossings % 2 != 0 ? "odd" : "even";
  std::string text =
      fmt::format("{} crossing{}: {}, {}", w.crossings, w.crossings == 1 ? "" : "s", odd, word(w.even_odd));
  if (w.nonzero != w.even_odd) text += fmt::format(" (winding number {}: {})", shown(w.winding), word(w.nonzero));
  return text;
}

std::string alt_text(const Setup& s) {
  const std::size_t rings = s.polygon.rings.size();
  return fmt::format("A point and a polygon{}, with a ray from the point to the right. {}",
                     rings > 1  ? " with a hole"
                     : s.simple ? ""
                                : " that meets itself",
                     s.truth.even_odd == Location::on
                         ? "The point lies on the boundary."
                         : fmt::format("The ray crosses {} edge{}: by the even-odd rule the point lies {}.",
                                       s.truth.crossings, s.truth.crossings == 1 ? "" : "s", lies(s.truth.even_odd)));
}

}  // namespace isect::lessons::crossings_lesson
