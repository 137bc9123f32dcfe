#include "lessons/triangle_triangle/picture.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include <isect/clip_polygon.h>

namespace isect::lessons::triangle_triangle_lesson {

using namespace viz;

namespace {

constexpr Role roles[] = {Role::first, Role::second};

Vec3 centroid(const Three& x) { return (x.vertices[0] + x.vertices[1] + x.vertices[2]) / 3; }
Vec3 unit_normal(const Three& x) {
  const Vec3 u = (x.vertices[1] - x.vertices[0]).stableNormalized(),
             v = (x.vertices[2] - x.vertices[0]).stableNormalized();
  return u.cross(v).stableNormalized();
}

class Painter {
 public:
  Painter(const Setup& s, const Known& k) : s_(s), k_(k) {}

  Scene paint() {
    for (const int which : {0, 1}) triangle(which);
    if (k_.plane >= 0 && s_.area[static_cast<std::size_t>(k_.plane)]) plane(k_.plane);
    if (k_.line) line();
    for (const Edge& e : k_.lit)
      add(Line{s_.corner(e.of, e.from), s_.corner(e.of, e.to), Role::highlight, Pen::highlight});
    if (k_.settled && s_.meet()) shared();
    corners();
    return std::move(scene_);
  }

 private:
  void add(Item item) { scene_.items.push_back(std::move(item)); }

  void triangle(int which) {
    const auto own = static_cast<std::size_t>(which);
    const auto& [p, q, r] = s_.triangles[own].vertices;
    if (s_.area[own]) return add(Region{.rings = {{p, q, r}}, .role = roles[which], .hides = true});
    for (const auto& [from, to] : {std::pair(p, q), std::pair(q, r), std::pair(r, p)})
      if (from != to) add(Line{from, to, roles[which], Pen::solid});
  }

  /// Draws the plane of a triangle as a rectangle around it, with its normal, and the other's heights above it.
  void plane(int which) {
    const Three& x = s_.triangles[static_cast<std::size_t>(which)];
    const Vec3 n = unit_normal(x), u = (x.vertices[1] - x.vertices[0]).stableNormalized(), v = n.cross(u);
    const Vec3 middle = centroid(x);
    Vec2 lo = Vec2::Zero(), hi = Vec2::Zero();
    for (const Vec3& p : x.vertices) {
      const Vec2 at((p - middle).dot(u), (p - middle).dot(v));
      lo = lo.cwiseMin(at), hi = hi.cwiseMax(at);
    }
    const Vec2 margin = Vec2::Constant(0.15 * (hi - lo).maxCoeff());
    lo -= margin, hi += margin;
    const auto at = [&](double along, double across) -> Vec3 { return middle + along * u + across * v; };
    add(Chain{{at(lo.x(), lo.y()), at(hi.x(), lo.y()), at(hi.x(), hi.y()), at(lo.x(), hi.y())},
              true,
              Role::construction,
              Pen::construction});
    const Vec3 tip = middle + n;
    add(Arrow{middle, tip, roles[which], Pen::solid});
    add(Label{tip, which == 0 ? "**n**_a" : "**n**_b", roles[which]});
    if (k_.heights)
      for (int i = 0; i < 3; ++i) {
        const Vec3& p = s_.corner(1 - which, i);
        const Vec3 foot = p - (p - middle).dot(n) * n;
        if ((p - foot).norm() > 1e-9) add(Line{p, foot, Role::highlight, Pen::highlight});
      }
  }

  /// Draws the line of both planes, and the parts of it in a and in b: side by side, as they may lie on each other.
  void line() {
    const auto a = s_.part(0), b = s_.part(1);
    if (!a || !b) return;
    const Vec3 d = unit_normal(s_.a()).cross(unit_normal(s_.b())).stableNormalized(), from = a->first;
    double lo = 0, hi = 0;
    for (const Vec3& p : {a->second, b->first, b->second})
      lo = std::min(lo, (p - from).dot(d)), hi = std::max(hi, (p - from).dot(d));
    add(Line{from + (lo - 0.5) * d, from + (hi + 0.5) * d, Role::construction, Pen::construction});
    const Vec3 aside = 0.07 * View(camera(), 1, 1).up();
    for (const int which : {0, 1}) {
      if (!k_.part[static_cast<std::size_t>(which)]) continue;
      const auto& [p, q] = which == 0 ? *a : *b;
      const Vec3 by = which == 0 ? aside : Vec3(-aside);
      if ((p - q).norm() > 1e-9)
        add(Span{.from = p + by, .to = q + by, .role = roles[which]});
      else
        add(Dot{p + by, Mark::disc, roles[which]});
    }
  }

  /// Draws what they have in common: a polygon in one plane, else a part of the line.
  void shared() {
    if (s_.one_plane()) {
      Ring<double, 3> ring(s_.a().vertices.begin(), s_.a().vertices.end());
      const Vec3 n = unit_normal(s_.b());
      for (std::size_t i = 0; i < 3 && !ring.empty(); ++i) {
        const Vec3 &p = s_.b().vertices[i], inward = n.cross(s_.b().vertices[(i + 1) % 3] - p);
        ring = clip(ring, Plane<double, 3>{inward, -inward.dot(p)});
      }
      if (ring.size() > 2) add(Region{.rings = {ring}, .role = Role::hit});
      return;
    }
    const auto a = s_.part(0), b = s_.part(1);
    if (!a || !b) return;
    const Vec3 d = unit_normal(s_.a()).cross(unit_normal(s_.b())).stableNormalized(), from = a->first;
    const auto t = [&](const Vec3& p) { return (p - from).dot(d); };
    const double lo = std::max(std::min(t(a->first), t(a->second)), std::min(t(b->first), t(b->second)));
    const double hi = std::min(std::max(t(a->first), t(a->second)), std::max(t(b->first), t(b->second)));
    if (hi - lo > 1e-9)
      add(Line{from + lo * d, from + hi * d, Role::hit, Pen::thick});
    else
      add(Dot{from + (lo + hi) / 2 * d, Mark::disc, Role::hit});
  }

  void corners() {
    for (const int which : {0, 1})
      for (int i = 0; i < 3; ++i) {
        const Vec3& p = s_.corner(which, i);
        add(Dot{p, Mark::disc, roles[which]});
        scene_.handles.push_back(
            {fmt::format("{}{}", "ab"[which], i), Handle::Kind::point, p, Vec3::Zero(), roles[which]});
      }
    std::vector<std::pair<Vec3, std::string>> names;  // one for each place
    for (const int which : {0, 1})
      for (int i = 0; i < 3; ++i) {
        const Vec3& p = s_.corner(which, i);
        const std::string name = fmt::format("**{}**_{}", "ab"[which], i);
        const auto found = std::ranges::find_if(names, [&](const auto& known) { return known.first == p; });
        if (found == names.end())
          names.emplace_back(p, name);
        else
          found->second += " = " + name;
      }
    for (const auto& [p, name] : names) add(Label{p, name, Role::text});
  }

  const Setup& s_;
  const Known& k_;
  Scene scene_;
};

}  // namespace

Camera camera() { return {.azimuth = 0.45, .elevation = 0.55}; }

Scene picture(const Setup& s, const Known& known) { return Painter(s, known).paint(); }

}  // namespace isect::lessons::triangle_triangle_lesson
