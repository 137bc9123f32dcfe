// How the objects of a scene are drawn, and what of them can be dragged.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <isect/point_polygon.h>
#include "app/scene/objects.h"
#include "app/scene/shapes.h"
#include "lessons/shared/parameters.h"

namespace isect::program::scene {

namespace {

using lessons::unit;
using viz::Role;
using viz::Vec3;
using Kind = FieldSpec::Kind;
using Items = std::vector<viz::Item>;

constexpr int round_corners = 48;  ///< of a capsule's outline

/// A vector of length 1 across `v`.
Vec3 across(const Vec3& v, bool flat) {
  if (flat) return unit({-v.y(), v.x(), 0});
  int least = 0;
  v.cwiseAbs().minCoeff(&least);
  return unit(v.cross(Vec3::Unit(least)));
}

Vec3 middle_of(const std::vector<Vec3>& points) {
  Vec3 middle = Vec3::Zero();
  for (const Vec3& p : points) middle += p / static_cast<double>(points.size());
  return middle;
}

Vec3 top_of(const std::vector<Vec3>& points) {
  return *std::ranges::max_element(points, {}, [](const Vec3& p) { return p.y(); });
}

/// Where an outline in the plane is widest, by the even-odd rule: beside its notches and holes.
Vec3 inside_of(const std::vector<std::vector<Vec3>>& rings) {
  const auto lower = [](const Vec3& a, const Vec3& b) { return a.y() < b.y(); };
  const auto [low, high] = std::minmax_element(rings.front().begin(), rings.front().end(), lower);
  Vec3 best = middle_of(rings.front());
  double widest = 0;
  for (const double share : {0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8, 0.1, 0.9}) {
    const double y = low->y() + share * (high->y() - low->y());
    std::vector<double> crossed;
    for (const std::vector<Vec3>& ring : rings)
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec3 &p = ring[i], &q = ring[i + 1 < ring.size() ? i + 1 : 0];
        if ((p.y() > y) != (q.y() > y)) crossed.push_back(p.x() + (y - p.y()) / (q.y() - p.y()) * (q.x() - p.x()));
      }
    std::ranges::sort(crossed);
    for (std::size_t i = 0; i + 1 < crossed.size(); i += 2)
      if (crossed[i + 1] - crossed[i] > 1.05 * widest)
        widest = crossed[i + 1] - crossed[i], best = Vec3((crossed[i] + crossed[i + 1]) / 2, y, 0);
  }
  return best;
}

/// Its middle, unless that lies in a notch or a hole.
Vec3 place_of_name(const std::vector<std::vector<Vec3>>& rings) {
  const Vec3 middle = middle_of(rings.front());
  Polygon<double, 2> polygon;
  for (const std::vector<Vec3>& ring : rings) polygon.rings.push_back(points_of<2>(ring));
  return locate(point_of<2>(middle), polygon) == Location::in ? middle : inside_of(rings);
}

struct Drawer {
  const Setting& s;
  const Object& o;
  const Room& room;
  Role role;
  Items items = {};

  Vec3 at(const char* field) const { return s.point(o, field); }
  void name(const Vec3& where) { items.push_back(viz::Label{where, shown_name(o.name), role}); }

  void dot(const Vec3& where) {
    items.push_back(viz::Dot{where, viz::Mark::disc, role});
    name(where);
  }

  void segment() {
    const Vec3 from = at("from"), to = at("to");
    items.push_back(viz::Line{from, to, role});
    items.push_back(viz::Dot{from, viz::Mark::disc, role});
    items.push_back(viz::Dot{to, viz::Mark::disc, role});
    items.push_back(viz::Label{from, shown_name(o.name), role, to});
  }

  /// From its origin, or from before the scene, to beyond it or to its end.
  void ray(bool whole_line) {
    const Vec3 origin = at("origin"), dir = at("dir");
    const double foot = (room.middle - origin).dot(dir) / dir.squaredNorm(), reach = 1.15 * room.reach / dir.norm();
    double from = whole_line ? foot - reach : 0, to = whole_line ? foot + reach : std::max(foot, 0.0) + reach;
    if (s.has(o, "tmin")) from = s.number(o, "tmin");
    const bool ends = s.has(o, "tmax");
    if (ends) to = s.number(o, "tmax");
    const Vec3 a = origin + from * dir, b = origin + to * dir;
    if (whole_line || ends)
      items.push_back(viz::Line{a, b, role});
    else
      items.push_back(viz::Arrow{a, b, role});
    if (whole_line) {
      items.push_back(viz::Label{a + 0.2 * (b - a), shown_name(o.name), role, a + 0.3 * (b - a)});
      return;
    }
    if (ends) items.push_back(viz::Dot{b, viz::Mark::disc, role});
    dot(a);
  }

  void plane() {
    const Vec3 n = at("normal"), u = across(n, s.flat), v = unit(n.cross(u));
    const Vec3 p = room.middle - (n.dot(room.middle) + s.number(o, "d")) / n.squaredNorm() * n;
    const double r = 0.8 * room.reach;
    if (s.flat) {
      items.push_back(viz::Line{p - 1.2 * r * u, p + 1.2 * r * u, role});
      items.push_back(viz::Label{p - r * u, shown_name(o.name), role, p - 0.8 * r * u});
      return;
    }
    viz::Region square;
    square.rings = {{p - r * u - r * v, p + r * u - r * v, p + r * u + r * v, p - r * u + r * v}};
    square.role = role, square.hides = true;
    items.push_back(square);
    name(p - r * u - r * v);
  }

  void sphere() {
    if (s.flat)
      items.push_back(viz::Circle{at("center"), s.number(o, "radius"), role, viz::Pen::solid, true});
    else
      items.push_back(viz::Ball{at("center"), s.number(o, "radius"), role});
    dot(at("center"));
  }

  void flat_box(const std::vector<Vec3>& corners) {
    viz::Region region;
    region.rings = {corners}, region.role = role;
    items.push_back(region);
  }

  void box() {
    const Vec3 lo = at("lo"), hi = at("hi");
    if (s.flat)
      flat_box({lo, {hi.x(), lo.y(), 0}, hi, {lo.x(), hi.y(), 0}});
    else
      items.push_back(viz::solid(Aabb<double, 3>{lo, hi}, role));
    name((lo + hi) / 2);
  }

  void obb() {
    const Vec3 c = at("center"), e = at("half"), u = e.x() * at("u"), v = e.y() * at("v");
    if (s.flat) {
      flat_box({c - u - v, c + u - v, c + u + v, c - u + v});
    } else {
      Obb<double, 3> b;
      b.center = c, b.half = e;
      b.axes.col(0) = at("u"), b.axes.col(1) = at("v"), b.axes.col(2) = at("w");
      items.push_back(viz::solid(b, role));
    }
    name(c);
  }

  void capsule() {
    const Vec3 p = at("p"), q = at("q");
    const double r = s.number(o, "r");
    items.push_back(viz::Line{p, q, role, viz::Pen::construction});
    if (!s.flat) {  // drawn as one body
      items.push_back(viz::Ball{p, r, role});
      if (p != q) items.push_back(viz::Ball{q, r, role});
    } else {
      const Vec3 along = q.isApprox(p, 0) ? Vec3::UnitX() : unit(q - p);
      const double turn = std::atan2(along.y(), along.x());
      std::vector<Vec3> outline;
      for (int i = 0; i <= round_corners; ++i) {  // half a circle about q, then half a one about p
        const bool at_q = i <= round_corners / 2;
        const double angle =
            turn + (2 * std::numbers::pi * (i - (at_q ? 0 : 1)) / (round_corners - 1)) - std::numbers::pi / 2;
        outline.push_back((at_q ? q : p) + r * Vec3(std::cos(angle), std::sin(angle), 0));
      }
      flat_box(outline);
    }
    items.push_back(viz::Label{p, shown_name(o.name), role, q});
  }

  void outline(const std::vector<std::vector<Vec3>>& rings) {
    viz::Region region;
    region.rings = rings, region.role = role, region.hides = !s.flat;
    items.push_back(region);
    name(s.flat ? place_of_name(rings) : middle_of(rings.front()));
  }

  void solid(viz::Solid shape) {
    shape.role = role;
    name(middle_of(shape.vertices));
    items.push_back(std::move(shape));
  }

  void frustum() {
    viz::Solid shape = viz::solid(frustum_of(s, o), role);
    name(top_of(shape.vertices));
    items.push_back(std::move(shape));
  }

  void kdop() {
    if (s.flat)
      outline({outline_of(s, o)});
    else
      solid(solid_of(s, o));
  }

  /// The points and their hull.
  void hull() {
    const std::vector<Vec3> points = s.points(o);
    if (s.flat)
      outline({outline_of(s, o)});
    else
      solid(solid_of(s, o));
    dots(points);
  }

  void mesh() {
    items.push_back(viz::Mesh{o.fixed.points, o.fixed.triangles, role});
    name(top_of(o.fixed.points));
  }

  void cloud() {
    const std::vector<Vec3> points = s.points(o);
    dots(points);
    name(top_of(points));
  }

  void dots(const std::vector<Vec3>& points) {
    for (const Vec3& p : points) items.push_back(viz::Dot{p, viz::Mark::disc, role});
  }
};

}  // namespace

Room room(const Setting& s, const std::vector<Object>& objects) {
  Vec3 lo = Vec3::Constant(INFINITY), hi = -lo;
  for (const Object& o : objects)
    for (const Vec3& p : s.extent(o)) lo = lo.cwiseMin(p), hi = hi.cwiseMax(p);
  if (!(lo.array() <= hi.array()).all()) return {};
  const double reach = (hi - lo).norm() / 2;
  return {(lo + hi) / 2, reach > 0 ? reach : 1};
}

Items drawn(const Setting& s, const Object& o, const Room& room, Role role) {
  Drawer d{s, o, room, role};
  switch (o.type) {
    case Type::point:
      d.dot(s.point(o, "at"));
      break;
    case Type::segment:
      d.segment();
      break;
    case Type::ray:
    case Type::line:
      d.ray(o.type == Type::line);
      break;
    case Type::plane:
      d.plane();
      break;
    case Type::sphere:
      d.sphere();
      break;
    case Type::box:
      d.box();
      break;
    case Type::obb:
      d.obb();
      break;
    case Type::capsule:
      d.capsule();
      break;
    case Type::triangle:
    case Type::polygon:
      d.outline(s.rings(o));
      break;
    case Type::kdop:
      d.kdop();
      break;
    case Type::frustum:
      d.frustum();
      break;
    case Type::hull:
      d.hull();
      break;
    case Type::mesh:
      d.mesh();
      break;
    case Type::cloud:
      d.cloud();
      break;
  }
  for (viz::Item& item : d.items)
    std::visit(
        [&](auto& part) {
          if constexpr (requires { part.name; }) part.name = shown_name(o.name);
        },
        item);
  return std::move(d.items);
}

std::vector<viz::Handle> handles(const Setting& s, const Object& o, Role role) {
  std::vector<viz::Handle> all;
  const auto add = [&](const std::string& field, viz::Handle::Kind kind, const Vec3& at, const Vec3& anchor) {
    all.push_back({o.name + "." + field, kind, at, anchor, role});
  };
  const TypeSpec& type = spec(o.type);
  const Vec3 base = o.type == Type::ray || o.type == Type::line ? s.point(o, "origin") : Vec3::Zero();
  for (const FieldSpec& f : type.fields) {
    if (f.kind == Kind::point && f.name != "half")
      add(f.name, viz::Handle::Kind::point, s.point(o, f.name), Vec3::Zero());
    if (f.name == "forward") {
      const Vec3 eye = s.point(o, "eye");
      add(f.name, viz::Handle::Kind::vector, eye + s.point(o, "forward"), eye);
    }
    if (f.name == "dir") add(f.name, viz::Handle::Kind::vector, base + s.point(o, f.name), base);
    if (f.name == "radius")
      add(f.name, viz::Handle::Kind::length, s.point(o, "center") + Vec3(s.number(o, "radius"), 0, 0),
          s.point(o, "center"));
    if (o.type == Type::capsule && f.name == "r") {  // beside its end q
      const Vec3 p = s.point(o, "p"), q = s.point(o, "q");
      const Vec3 aside = p == q ? Vec3::UnitY() : across(q - p, s.flat);
      add(f.name, viz::Handle::Kind::length, q + s.number(o, "r") * aside, q);
    }
  }
  if (!o.fixed.points.empty()) return all;
  int vertex = 0;
  for (const Vec3& p : s.points(o)) add(std::to_string(++vertex), viz::Handle::Kind::point, p, Vec3::Zero());
  return all;
}

}  // namespace isect::program::scene
