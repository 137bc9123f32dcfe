#include "app/scene/objects.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "viz/rich_text.h"
#include "viz/solids.h"

namespace isect::program::scene {

namespace {

using viz::Role;
using viz::Vec3;
using Kind = FieldSpec::Kind;
using Items = std::vector<viz::Item>;

constexpr int round_corners = 48;  ///< of a capsule's outline

Vec3 unit(const Vec3& v) { return v.stableNormalized(); }

/// A vector of length 1 across `v`.
Vec3 across(const Vec3& v, bool flat) {
  if (flat) return unit({-v.y(), v.x(), 0});
  int least = 0;
  v.cwiseAbs().minCoeff(&least);
  return unit(v.cross(Vec3::Unit(least)));
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
    if (!s.flat) {
      items.push_back(viz::Ball{p, r, role});
      items.push_back(viz::Ball{q, r, role});
      const Vec3 axis = q - p, u = axis.isZero(0) ? Vec3::UnitX() : across(axis, false), v = unit(axis).cross(u);
      for (const double angle : {0.0, 0.5, 1.0, 1.5}) {
        const Vec3 side = r * (std::cos(angle * std::numbers::pi) * u + std::sin(angle * std::numbers::pi) * v);
        items.push_back(viz::Line{p + side, q + side, role});
      }
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

  void polygon() {
    viz::Region region;
    region.rings = s.rings(o), region.role = role, region.hides = !s.flat;
    items.push_back(region);
    Vec3 middle = Vec3::Zero();
    for (const Vec3& p : region.rings.front()) middle += p / static_cast<double>(region.rings.front().size());
    name(middle);
  }
};

}  // namespace

const std::vector<TypeSpec>& types() {
  static const std::vector<TypeSpec> all = {
      {Type::point, "point", {{"at", Kind::point, "where it lies"}}},
      {Type::segment, "segment", {{"from", Kind::point, "one end"}, {"to", Kind::point, "the other end"}}},
      {Type::ray,
       "ray",
       {{"origin", Kind::point, "where t = 0"},
        {"dir", Kind::vector, "the direction, of any length but 0"},
        {"tmin", Kind::number, "where it begins; 0 if not given", true},
        {"tmax", Kind::number, "where it ends; nowhere if not given", true}}},
      {Type::line,
       "line",
       {{"origin", Kind::point, "where t = 0"}, {"dir", Kind::vector, "the direction, of any length but 0"}}},
      {Type::plane,
       "plane",
       {{"normal", Kind::vector, "the normal n, of any length but 0"}, {"d", Kind::number, "n . x + d = 0"}}},
      {Type::sphere,
       "sphere",
       {{"center", Kind::point, "the centre"}, {"radius", Kind::number, "the radius", false, 0}}},
      {Type::box, "box", {{"lo", Kind::point, "the lowest corner"}, {"hi", Kind::point, "the highest corner"}}},
      {Type::obb,
       "obb",
       {{"center", Kind::point, "the centre"},
        {"u", Kind::vector, "the first axis, of length 1"},
        {"v", Kind::vector, "the second axis, of length 1"},
        {"w", Kind::vector, "the third axis, of length 1; none in the plane", true},
        {"half", Kind::point, "the half-lengths along the axes"}}},
      {Type::capsule,
       "capsule",
       {{"p", Kind::point, "one end of its axis"},
        {"q", Kind::point, "the other end"},
        {"r", Kind::number, "the radius", false, 0}}},
      {Type::triangle, "triangle", {}},
      {Type::polygon, "polygon", {}},
  };
  return all;
}

const TypeSpec& spec(Type type) { return *std::ranges::find(types(), type, &TypeSpec::type); }

Vec3 Setting::point(const Object& o, const std::string& field) const {
  return std::get<Vec3>(parameters.at(o.name + "." + field));
}
double Setting::number(const Object& o, const std::string& field) const {
  return std::get<double>(parameters.at(o.name + "." + field));
}
bool Setting::has(const Object& o, const std::string& field) const { return parameters.contains(o.name + "." + field); }

std::vector<std::vector<Vec3>> Setting::rings(const Object& o) const {
  std::vector<std::vector<Vec3>> all;
  int vertex = 0;
  for (const int size : o.rings) {
    all.emplace_back();
    for (int i = 0; i < size; ++i) all.back().push_back(point(o, std::to_string(++vertex)));
  }
  return all;
}

std::vector<Vec3> Setting::extent(const Object& o) const {
  const auto around = [](const Vec3& c, double r) {
    return std::vector<Vec3>{c - Vec3::Constant(r), c + Vec3::Constant(r)};
  };
  switch (o.type) {
    case Type::point:
      return {point(o, "at")};
    case Type::segment:
      return {point(o, "from"), point(o, "to")};
    case Type::ray:
      return {point(o, "origin")};
    case Type::sphere:
      return around(point(o, "center"), number(o, "radius"));
    case Type::box:
      return {point(o, "lo"), point(o, "hi")};
    case Type::obb:
      return around(point(o, "center"), point(o, "half").norm());
    case Type::capsule: {
      std::vector<Vec3> all = around(point(o, "p"), number(o, "r"));
      std::ranges::copy(around(point(o, "q"), number(o, "r")), std::back_inserter(all));
      return all;
    }
    case Type::triangle:
    case Type::polygon: {
      std::vector<Vec3> all;
      for (const auto& ring : rings(o)) all.insert(all.end(), ring.begin(), ring.end());
      return all;
    }
    default:
      return {};
  }
}

Json Setting::list(const Vec3& p) const {
  Json all = {p.x(), p.y()};
  if (!flat) all.push_back(p.z());
  return all;
}

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
      d.polygon();
  }
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
    if (f.name == "dir") add(f.name, viz::Handle::Kind::vector, base + s.point(o, f.name), base);
    if (f.name == "radius")
      add(f.name, viz::Handle::Kind::length, s.point(o, "center") + Vec3(s.number(o, "radius"), 0, 0),
          s.point(o, "center"));
  }
  int vertex = 0;
  for (const auto& ring : s.rings(o))
    for (const Vec3& p : ring) add(std::to_string(++vertex), viz::Handle::Kind::point, p, Vec3::Zero());
  return all;
}

std::string shown_name(const std::string& name) {
  const std::size_t digits = name.find_last_not_of("0123456789") + 1;
  const std::string letters = "**" + viz::as_markup(name.substr(0, digits)) + "**";
  return digits == name.size() ? letters : letters + "_{" + name.substr(digits) + "}";
}

}  // namespace isect::program::scene
