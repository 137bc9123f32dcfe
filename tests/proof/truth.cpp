#include "tests/proof/truth.h"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "bench/cylinder_half_spaces/oracle.h"
#include "bench/ray_cylinder/oracle.h"
#include "bench/sphere_cylinder/oracle.h"

namespace isect::proof {

Rational rational(double x) { return Rational(x); }

Vec at(const Thing& line, const Rational& t) { return line.points[0] + t * line.points[1]; }

Vec vec(const Json& list) {
  Vec v = {};
  for (std::size_t i = 0; i < list.size(); ++i) v[i] = rational(list[i].get<double>());
  return v;
}

namespace {

using Kind = Thing::Kind;

Points points_of(const Json& list) {
  Points all;
  for (const Json& p : list) all.push_back(vec(p));
  return all;
}

Rational number(const Json& object, const char* field) { return rational(object[field].get<double>()); }

void close_faces(Thing& body) { body.faces = faces_of(body.points, body.flat); }

/// Makes the box c + sum s_i u_i with |s_i| <= e_i.
void add_box(Thing& body, const Vec& c, const std::vector<Vec>& axes, const std::vector<Rational>& half) {
  body.points = {c};
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const Vec step = half[i] * axes[i];
    if (is_zero(step)) continue;
    Points both;
    for (const Vec& p : body.points) both.push_back(p - step), both.push_back(p + step);
    body.points = both;
  }
  close_faces(body);
}

Vec normal_of(const Points& ring) {
  Vec normal = {};
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) normal = normal + cross(ring[i] - ring[0], ring[i + 1] - ring[0]);
  return normal;
}

/// Whether a simple outline in space is convex.
bool is_convex(const Points& ring) {
  const Vec normal = normal_of(ring);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec &a = ring[i], &b = ring[(i + 1) % ring.size()], &c = ring[(i + 2) % ring.size()];
    if (dot(normal, cross(b - a, c - b)) < 0) return false;
  }
  return true;
}

/// Cuts a simple outline in space into triangles by its ears, by brute force.
std::vector<Points> ears(Points ring) {
  std::vector<Points> triangles;
  const Vec normal = normal_of(ring);
  const auto turn = [&](const Vec& a, const Vec& b, const Vec& c) { return sgn(dot(normal, cross(b - a, c - a))); };
  while (ring.size() >= 3) {
    bool cut = false;
    for (std::size_t i = 0; i < ring.size() && !cut; ++i) {
      const Vec &a = ring[(i + ring.size() - 1) % ring.size()], &b = ring[i], &c = ring[(i + 1) % ring.size()];
      if (turn(a, b, c) < 0) continue;
      const bool clear = std::ranges::none_of(ring, [&](const Vec& p) {
        return p != a && p != b && p != c && turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
      });
      if (turn(a, b, c) > 0 && !clear) continue;
      if (turn(a, b, c) > 0) triangles.push_back({a, b, c});
      ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(i));
      cut = true;
    }
    if (!cut) throw std::logic_error("an outline without ears");
  }
  return triangles;
}

}  // namespace

Thing Thing::read(const Json& o, bool flat, const Faces& planes) {
  Thing t = {Kind::body, o.begin().key(), flat};
  const std::string& type = t.type;
  if (type == "point") {
    t.points = {vec(o["at"])};
    close_faces(t);
  } else if (type == "segment") {
    t.kind = Kind::line;
    t.points = {vec(o["from"]), vec(o["to"]) - vec(o["from"])};
    t.range = {0, 1};
  } else if (type == "ray" || type == "line") {
    t.kind = Kind::line;
    t.points = {vec(o["origin"]), vec(o["dir"])};
    if (type == "ray") t.range.lo = o.contains("tmin") ? number(o, "tmin") : Rational(0);
    if (o.contains("tmax")) t.range.hi = number(o, "tmax");
  } else if (type == "plane") {
    t.kind = Kind::plane;
    t.normal = vec(o["normal"]), t.d = number(o, "d");
  } else if (type == "sphere" || type == "circle") {
    t.type = "sphere";
    t.points = {vec(o["center"])}, t.radius = number(o, "radius");
    close_faces(t);
  } else if (type == "capsule") {
    t.points = {vec(o["p"]), vec(o["q"])}, t.radius = number(o, "r");
    close_faces(t);
  } else if (type == "cylinder" || type == "cone") {
    const auto at = [&](const char* field) { return Point<double, 3>(o[field][0], o[field][1], o[field][2]); };
    const double r = o["r"];
    t.points = {vec(o[type == "cone" ? "apex" : "p"]), vec(o[type == "cone" ? "base" : "q"])};
    if (r == 0) return close_faces(t), t;  // a segment
    t.kind = Kind::round;
    t.solid = type == "cone" ? oracle::round_solid(Cone<double>{at("apex"), at("base"), r})
                             : oracle::round_solid(Cylinder<double>{at("p"), at("q"), r});
  } else if (type == "box") {
    const Vec lo = vec(o["lo"]), hi = vec(o["hi"]);
    const Rational half = Rational(1, 2);
    const std::vector<Vec> axes = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    std::vector<Rational> widths;
    for (int i = 0; i < 3; ++i) widths.push_back(half * (hi[i] - lo[i]));
    add_box(t, half * (lo + hi), axes, widths);
  } else if (type == "obb") {
    std::vector<Vec> axes = {vec(o["u"]), vec(o["v"])};
    if (!flat) axes.push_back(vec(o["w"]));
    const Vec half = vec(o["half"]);
    add_box(t, vec(o["center"]), axes, {half.begin(), half.end()});
  } else if (type == "kdop" || type == "frustum") {
    Faces slabs = planes;
    if (type == "kdop")
      for (std::size_t i = 0; i < o["normals"].size(); ++i) {
        const Vec n = vec(o["normals"][i]);
        slabs.push_back({n, rational(o["hi"][i].get<double>())});
        slabs.push_back({Rational(-1) * n, -rational(o["lo"][i].get<double>())});
      }
    t.points = corners_of(slabs, flat);
    if (!t.points.empty()) close_faces(t);
  } else if (type == "hull" || (type == "triangle" && flat)) {
    t.points = points_of(o["points"]);
    close_faces(t);
  } else if (type == "triangle") {
    t.points = points_of(o["points"]);
    t.rings = {t.points};
    close_faces(t);
  } else if (type == "polygon" && flat) {
    t.kind = Kind::region;
    if (o.contains("rings"))
      for (const Json& ring : o["rings"]) t.rings.push_back(points_of(ring));
    else
      t.rings = {points_of(o["points"])};
  } else if (type == "polygon") {
    t.kind = Kind::surface;
    t.rings = {points_of(o["points"])};
    if (is_convex(t.rings[0]))
      t.points = t.rings[0], t.kind = Kind::body, close_faces(t);
    else
      t.triangles = ears(t.rings[0]);
  } else if (type == "mesh") {
    t.kind = Kind::surface;
    const Points points = points_of(o["points"]);
    std::map<std::pair<int, int>, int> edges;
    for (const Json& three : o["triangles"]) {
      t.triangles.push_back({});
      for (int i = 0; i < 3; ++i) {
        t.triangles.back().push_back(points[three[i].get<std::size_t>()]);
        ++edges[{three[i].get<int>(), three[(i + 1) % 3].get<int>()}];
      }
    }
    t.closed = std::ranges::all_of(edges, [&](const auto& edge) {
      const auto other = edges.find({edge.first.second, edge.first.first});
      return other != edges.end() && other->second == edge.second;
    });
  } else if (type == "cloud") {
    t.kind = Kind::cloud;
    t.points = points_of(o["points"]);
  } else {
    throw std::logic_error("an unknown type " + type);
  }
  return t;
}

namespace {

// Cylinders and cones.

oracle::Rational exact(const Rational& x) { return oracle::Rational(x.get_mpq_t()); }
oracle::Coordinates<3> exact(const Vec& x) { return {exact(x[0]), exact(x[1]), exact(x[2])}; }

int place_in_round(const Vec& p, const Thing& round) {
  const Location where = round.solid.locate(exact(p));
  return where == Location::in ? -1 : where == Location::on ? 0 : 1;
}

bool line_meets_round(const Thing& line, const Thing& round) {
  if (is_zero(line.points[1])) return place_in_round(line.points[0], round) <= 0;
  const oracle::LineInConvex part = oracle::line_in(exact(line.points[0]), exact(line.points[1]), round.solid);
  return part.meets() && (!line.range.hi || part.entered(exact(*line.range.hi))) &&
         (!line.range.lo || part.stays(exact(*line.range.lo)));
}

bool is_ball(const Thing& t) { return t.kind == Kind::body && t.points.size() == 1; }
Relation of_ball_and_round(const Thing& ball, const Thing& round) {
  const Vec& c = ball.points[0];
  if (ball.radius == 0)  // a point, which need not be one of doubles: the only corner of a frustum
    return place_in_round(c, round) > 0 ? Relation::disjoint : Relation::a_inside_b;
  return oracle::BallAndRoundSolid(Sphere<double, 3>{{c[0].get_d(), c[1].get_d(), c[2].get_d()}, ball.radius.get_d()},
                                   round.solid)
      .relation();
}

/// The relation of a round solid (A) to a body without a radius.
Relation of_round_and_body(const Thing& round, const Thing& body) {
  oracle::Sides sides;
  for (const Face& f : body.faces) {
    sides.push_back({exact(Rational(-1) * f.normal), exact(f.offset)});
    if (f.equation) sides.push_back({exact(f.normal), exact(-f.offset)});
  }
  if (body.flat || round.flat) throw std::logic_error("no round solid lies in the plane");
  return oracle::RoundAndSides(round.solid, sides).relation();
}
Relation of_round(const Thing& round, const Thing& body) {
  return body.points.size() == 1 ? reversed(of_ball_and_round(body, round)) : of_round_and_body(round, body);
}

/// Adds the sides of a plane on which a disc across the axis has points.
void add_sides(const Thing& plane, const oracle::Coordinates<3>& center, const oracle::Rational& radius,
               const oracle::Coordinates<3>& axis, std::array<bool, 3>& result) {
  const oracle::Coordinates<3> n = exact(plane.normal);
  const oracle::Rational height = oracle::dot(n, center) + exact(plane.d), along = oracle::dot(n, axis);
  // Its points reach as far as radius |n - (n.axis / axis.axis) axis| from that height
  const oracle::Rational reach2 = radius * radius * (oracle::dot(n, n) - along * along / oracle::dot(axis, axis)),
                         far2 = height * height;
  if (far2 <= reach2 || height == 0) result[1] = true;
  if (height < 0 || far2 < reach2) result[0] = true;
  if (height > 0 || far2 < reach2) result[2] = true;
}

int orientation(const Vec& a, const Vec& b, const Vec& c) {
  return sgn(Rational((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])));
}

/// Whether c, on the line of a and b, lies between them.
bool between(const Vec& a, const Vec& b, const Vec& c) {
  for (int i = 0; i < 2; ++i)
    if (c[i] < std::min(a[i], b[i]) || c[i] > std::max(a[i], b[i])) return false;
  return true;
}

bool segments_meet(const Vec& a, const Vec& b, const Vec& c, const Vec& d) {
  for (int i = 0; i < 2; ++i)
    if (std::max(a[i], b[i]) < std::min(c[i], d[i]) || std::max(c[i], d[i]) < std::min(a[i], b[i])) return false;
  return orientation(a, b, c) * orientation(a, b, d) <= 0 && orientation(c, d, a) * orientation(c, d, b) <= 0;
}

template <class Use>
bool any_edge(const std::vector<Points>& rings, const Use& use) {
  for (const Points& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i)
      if (use(ring[i], ring[(i + 1) % ring.size()])) return true;
  return false;
}

int place_in_region(const Vec& p, const std::vector<Points>& rings) {
  bool inside = false;
  const bool on = any_edge(rings, [&](const Vec& a, const Vec& b) {
    if (orientation(a, b, p) == 0 && between(a, b, p)) return true;
    if ((a[1] > p[1]) == (b[1] > p[1])) return false;
    const Rational x = a[0] + (b[0] - a[0]) * (p[1] - a[1]) / (b[1] - a[1]);
    inside ^= x > p[0];
    return false;
  });
  return on ? 0 : inside ? -1 : 1;
}

Rational distance2(const Points& a, const Points& b) { return nearest(a, b).distance2; }

Rational most_of(const Vec& x) { return std::max({Rational(abs(x[0])), Rational(abs(x[1])), Rational(abs(x[2]))}); }

/// The corners of a bounded thing.
Points corners(const Thing& t) {
  Points all = t.points;
  for (const auto* lists : {&t.rings, &t.triangles})  // some twice
    for (const Points& list : *lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

/// A part of the line that meets these points' hull iff the line does, and is as near to it.
Points near(const Thing& line, const Points& other) {
  if (is_zero(line.points[1])) return {line.points[0]};
  Rational reach = 1;
  for (const Vec& p : other) reach = std::max(reach, most_of(p - line.points[0]));
  const Vec& d = line.points[1];
  const Rational most = 3 * reach * most_of(d) / dot(d, d);  // by Cauchy's inequality, of maximum norms
  Rational lo = line.range.lo ? *line.range.lo : -most - 1, hi = line.range.hi ? *line.range.hi : most + 1;
  if (!line.range.lo) lo = std::min(lo, Rational(hi - 1));
  if (!line.range.hi) hi = std::max(hi, Rational(lo + 1));
  return {at(line, lo), at(line, hi)};
}

/// The corners of a convex thing; for a line, the ends of a part that is as near to the other.
Points as_points(const Thing& t, const Points& other) { return t.kind == Kind::line ? near(t, other) : t.points; }

bool near_enough(const Points& a, const Points& b, const Rational& radius) {
  return distance2(a, b) <= radius * radius;
}

bool cloud_meets(const Thing& cloud, const Thing& other) {
  return std::ranges::any_of(cloud.points, [&](const Vec& p) { return place(p, other) <= 0; });
}

bool triangle_meets(const Points& triangle, const Thing& other) {
  if (other.kind == Kind::surface)
    return std::ranges::any_of(other.triangles, [&](const Points& t) { return near_enough(triangle, t, 0); });
  if (other.kind == Kind::round) {
    Thing part = {Kind::body, "triangle", false, triangle};
    close_faces(part);
    return meet(part, other);
  }
  return near_enough(triangle, as_points(other, triangle), other.radius);
}

bool region_meets(const Thing& region, const Thing& other) {
  if (other.kind == Kind::region) {
    const auto crosses = [&](const Vec& a, const Vec& b) {
      return any_edge(other.rings, [&](const Vec& c, const Vec& d) { return segments_meet(a, b, c, d); });
    };
    const auto some_in = [](const Thing& in, const Thing& of) {
      return std::ranges::any_of(of.rings, [&](const Points& ring) { return place_in_region(ring[0], in.rings) <= 0; });
    };
    return any_edge(region.rings, crosses) || some_in(region, other) || some_in(other, region);
  }
  const Points all = as_points(other, corners(region));
  if (place_in_region(all[0], region.rings) <= 0) return true;
  return any_edge(region.rings, [&](const Vec& a, const Vec& b) { return near_enough({a, b}, all, other.radius); });
}

}  // namespace

int place(const Vec& p, const Thing& t) {
  switch (t.kind) {
    case Kind::body: {
      if (t.radius > 0) return sgn(Rational(distance2({p}, t.points) - t.radius * t.radius));
      int where = -1;
      for (const Face& f : t.faces) {
        if (!f.holds(p)) return 1;
        if (f.equation || f.beyond(p) == 0) where = 0;
      }
      return where;
    }
    case Kind::round:
      return place_in_round(p, t);
    case Kind::line:
      return distance2({p}, near(t, {p})) == 0 ? 0 : 1;
    case Kind::plane:
      return dot(t.normal, p) + t.d == 0 ? 0 : 1;
    case Kind::region:
      return place_in_region(p, t.rings);
    case Kind::cloud:
      return std::ranges::find(t.points, p) == t.points.end() ? 1 : 0;
    case Kind::surface:
      break;
  }
  for (const Points& x : t.triangles)
    if (distance2({p}, x) == 0) return 0;
  if (!t.closed) return 1;
  for (int attempt = 1;; ++attempt) {  // a direction that passes no edge
    const Vec d = {Rational(97 + attempt * attempt), Rational(61 * attempt + 7), Rational(29 - 5 * attempt)};
    bool clear = true, inside = false;
    for (const Points& x : t.triangles) {
      const Vec n = cross(x[1] - x[0], x[2] - x[0]);
      const Rational slope = dot(n, d);
      if (slope == 0) {  // or no triangle: no crossing unless the ray runs in it
        clear &= is_zero(n) || dot(n, p - x[0]) != 0;
        continue;
      }
      const Rational along = dot(n, x[0] - p) / slope;
      if (along < 0) continue;
      const Vec hit = p + along * d;
      std::array<int, 3> turns;
      for (int i = 0; i < 3; ++i) turns[i] = sgn(dot(n, cross(x[(i + 1) % 3] - x[i], hit - x[i])));
      const auto [least, most] = std::ranges::minmax(turns);
      if (least < 0) continue;
      clear &= least > 0;
      inside ^= most > 0;
    }
    if (clear) return inside ? -1 : 1;
  }
}

std::array<bool, 3> sides(const Thing& plane, const Thing& t) {
  std::array<bool, 3> result = {};
  const auto value = [&](const Vec& p) -> Rational { return dot(plane.normal, p) + plane.d; };
  if (t.kind == Kind::line) {
    const Rational slope = dot(plane.normal, t.points[1]);
    const int from = sgn(value(t.range.lo ? at(t, *t.range.lo) : t.range.hi ? at(t, *t.range.hi) : t.points[0]));
    result[1 + from] = true;
    if (!t.range.lo && slope != 0) result[1 - sgn(slope)] = true;
    if (!t.range.hi && slope != 0) result[1 + sgn(slope)] = true;
    if (t.range.lo && t.range.hi) result[1 + sgn(value(at(t, *t.range.hi)))] = true;
  } else if (t.kind == Kind::round) {
    const oracle::RoundSolid& s = t.solid;
    add_sides(plane, s.start, s.at_start, s.d, result);
    add_sides(plane, oracle::operator+(s.start, s.d), s.at_end, s.d, result);
  } else {
    const Rational n2 = dot(plane.normal, plane.normal);
    for (const Vec& p : corners(t)) {
      const Rational v = value(p);
      if (t.radius == 0) {
        result[1 + sgn(v)] = true;
        continue;
      }
      const int reach = sgn(Rational(v * v - t.radius * t.radius * n2));
      if (reach < 0) result = {true, true, true};
      if (reach >= 0) result[1 + sgn(v)] = true;
      if (reach == 0) result[1] = true;
    }
  }
  if (t.kind != Kind::cloud && result[0] && result[2]) result[1] = true;
  return result;
}

bool meet(const Thing& a, const Thing& b) {
  if (a.kind == Kind::cloud) return cloud_meets(a, b);
  if (b.kind == Kind::cloud) return cloud_meets(b, a);
  if (a.kind == Kind::plane && b.kind == Kind::plane) {
    if (!is_zero(cross(a.normal, b.normal))) return true;
    for (int i = 0; i < 3; ++i)
      if (a.normal[i] * b.d != b.normal[i] * a.d) return false;
    return true;
  }
  if (a.kind == Kind::plane) return sides(a, b)[1];
  if (b.kind == Kind::plane) return sides(b, a)[1];
  if (b.kind == Kind::round) return meet(b, a);
  if (a.kind == Kind::round) {
    if (b.kind == Kind::line) return line_meets_round(b, a);
    if (b.kind == Kind::surface) return triangles_met(b, a) > 0;
    return of_round(a, b) != Relation::disjoint;
  }
  if (a.kind == Kind::surface) return triangles_met(a, b) > 0;
  if (b.kind == Kind::surface) return triangles_met(b, a) > 0;
  if (a.kind == Kind::region) return region_meets(a, b);
  if (b.kind == Kind::region) return region_meets(b, a);
  if (a.kind == Kind::line && b.kind == Kind::line) return crossing(a, b).common != Crossing::Common::nothing;
  return near_enough(as_points(a, b.points), as_points(b, a.points), a.radius + b.radius);
}

int triangles_met(const Thing& surface, const Thing& other) {
  return static_cast<int>(
      std::ranges::count_if(surface.triangles, [&](const Points& t) { return triangle_meets(t, other); }));
}

namespace {

using Edges = std::vector<std::array<Vec, 2>>;

/// The edges of the boundary of a thing with corners, in the plane.
Edges edges_of(const Thing& t) {
  Edges edges;
  any_edge(t.rings, [&](const Vec& a, const Vec& b) {
    edges.push_back({a, b});
    return false;
  });
  if (t.kind != Kind::body) return edges;
  for (const Face& f : t.faces) {
    const Vec along = {-f.normal[1], f.normal[0], 0};
    Points on;
    for (const Vec& p : t.points)
      if (f.beyond(p) == 0) on.push_back(p);
    edges.push_back({on[farthest(on, along)], on[farthest(on, Rational(-1) * along)]});
  }
  return edges;
}

/// The places, from 0 to 1, where edges cut the edge from p to q, ends included.
std::vector<Rational> cuts_of(const Vec& p, const Vec& q, const Edges& all) {
  const Vec d = q - p;
  std::vector<Rational> cuts = {0, 1};
  for (const auto& [r, s] : all) {
    const Vec e = s - r;
    const Rational turn = d[0] * e[1] - d[1] * e[0];
    if (turn != 0) {
      const Vec w = r - p;
      cuts.push_back(Rational((w[0] * e[1] - w[1] * e[0]) / turn));
    } else if (!is_zero(d)) {
      for (const Vec& end : {r, s}) cuts.push_back(Rational(dot(end - p, d) / dot(d, d)));
    }
  }
  std::erase_if(cuts, [](const Rational& t) { return t < 0 || t > 1; });
  std::ranges::sort(cuts);
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  return cuts;
}
/// A point beside p, in the direction n, before the next edge.
Vec beside(const Vec& p, const Vec& n, const Edges& all) {
  Rational room = 1;
  for (const auto& [r, s] : all) {
    const Vec e = s - r, w = r - p;
    const Rational turn = n[0] * e[1] - n[1] * e[0];
    if (turn == 0) continue;
    const Rational t = (w[0] * e[1] - w[1] * e[0]) / turn, at = (w[0] * n[1] - w[1] * n[0]) / turn;
    if (t > 0 && at >= 0 && at <= 1) room = std::min(room, t);
  }
  return p + Rational(room / 2) * n;
}
/// Calls use(from, middle, to, points on both sides) for each piece of an edge that edges are cut into.
template <class Use>
void each_piece(const Edges& all, const Use& use) {
  for (const auto& [p, q] : all) {
    const Vec d = q - p;
    if (is_zero(d)) continue;
    const std::vector<Rational> cuts = cuts_of(p, q, all);
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      const Vec middle = p + Rational((cuts[i] + cuts[i + 1]) / 2) * d, right = {d[1], -d[0], 0};
      use(p + cuts[i] * d, middle, p + cuts[i + 1] * d,
          std::array{beside(middle, right, all), beside(middle, Rational(-1) * right, all)});
    }
  }
}

/// Two sets in the plane with the parts that their edges cut it into: each part, and each piece of an edge, lies in one
/// of the sets wholly or not at all.
struct Overlay {
  bool interiors_meet = false, a_in_b = true, b_in_a = true;

  Overlay(const Thing& a, const Thing& b) {
    Edges all = edges_of(a);
    for (const auto& edge : edges_of(b)) all.push_back(edge);
    for (const auto& [p, q] : all)
      for (const Vec& end : {p, q}) point(end, a, b);
    each_piece(all, [&](const Vec& from, const Vec& middle, const Vec& to, const std::array<Vec, 2>& both) {
      for (const Vec& p : {from, middle, to, both[0], both[1]}) point(p, a, b);
      for (const Vec& p : both) interiors_meet |= place(p, a) < 0 && place(p, b) < 0;
    });
  }

 private:
  void point(const Vec& p, const Thing& a, const Thing& b) {
    const bool in_a = place(p, a) <= 0, in_b = place(p, b) <= 0;
    a_in_b &= !in_a || in_b, b_in_a &= !in_b || in_a;
  }
};

/// A ball or a capsule beside a region: whether the region's border passes through its interior; if not, whether its
/// interior lies in the region.
struct BallInRegion {
  bool cut = false, holds = false;

  BallInRegion(const Thing& ball, const Thing& region) {
    const Edges edges = edges_of(region);
    const Rational reach = ball.radius * ball.radius;
    each_piece(edges, [&](const Vec& from, const Vec&, const Vec& to, const std::array<Vec, 2>& both) {
      const bool parts = (place(both[0], region) < 0) != (place(both[1], region) < 0);
      cut |= parts && distance2({from, to}, ball.points) < reach;
    });
    if (cut) return;
    for (int attempt = 0;; ++attempt) {  // near the center, on no edge
      const Vec way = {Rational(attempt), Rational(attempt * attempt), 0};
      const Vec p = ball.points[0] + Rational(ball.radius / (1 + 2 * attempt * attempt * attempt)) * way;
      const int where = attempt == 0 || distance2({p}, ball.points) < reach ? place(p, region) : 0;
      if (where == 0) continue;
      holds = where < 0;
      return;
    }
  }
};

/// The ends of the segment that a thing in the plane without an area is. A region only if it is one ring.
std::optional<Points> thin(const Thing& t) {
  if (t.radius > 0 || !t.flat || (t.kind != Kind::body && t.kind != Kind::region) || t.rings.size() > 1) return {};
  const Points all = corners(t);
  const Vec first = *std::ranges::min_element(all), last = *std::ranges::max_element(all);
  for (const Vec& p : all)
    if (orientation(first, last, p) != 0) return {};
  return Points{first, last};
}

/// Whether a segment has a point between its ends, or is one, that is interior to a region.
bool reaches_into(const Points& ends, const Thing& region) {
  if (ends[0] == ends[1]) return place(ends[0], region) < 0;
  const Vec d = ends[1] - ends[0];
  std::vector<Rational> cuts = {0, 1};
  for (const auto& [r, s] : edges_of(region)) {
    const Vec e = s - r, w = r - ends[0];
    const Rational turn = d[0] * e[1] - d[1] * e[0];
    if (turn != 0)
      cuts.push_back(Rational((w[0] * e[1] - w[1] * e[0]) / turn));
    else  // of an edge along the segment, as that of a slit, both ends
      for (const Vec& end : {r, s}) cuts.push_back(Rational(dot(end - ends[0], d) / dot(d, d)));
  }
  std::erase_if(cuts, [](const Rational& t) { return t < 0 || t > 1; });
  std::ranges::sort(cuts);
  for (std::size_t i = 1; i < cuts.size(); ++i)
    if (place(ends[0] + Rational((cuts[i - 1] + cuts[i]) / 2) * d, region) < 0) return true;
  return false;
}

bool is_region(const Thing& a, const Thing& b) { return a.kind == Kind::region || b.kind == Kind::region; }

// A polygon in space that is not convex, beside a thing without a volume: two sets of its plane if both lie there, else
// along the line of both planes.

bool is_polygon_in_space(const Thing& t) { return t.kind == Kind::surface && t.type == "polygon"; }
bool is_thin(const Thing& t) {
  return is_polygon_in_space(t) || (t.kind == Kind::body && t.radius == 0 &&
                                    (t.points.size() < 2 || std::ranges::any_of(t.faces, &Face::equation)));
}
bool are_thin(const Thing& a, const Thing& b) {
  return !a.flat && is_thin(a) && is_thin(b) && (is_polygon_in_space(a) || is_polygon_in_space(b));
}

struct Plane {
  Vec normal, at;

  explicit Plane(const Thing& polygon) : normal(normal_of(polygon.rings[0])), at(polygon.rings[0][0]) {
    if (std::ranges::any_of(polygon.rings[0], [&](const Vec& p) { return height(p) != 0; }))
      throw std::logic_error("the judge knows no polygon that is not flat");
  }
  Rational height(const Vec& p) const { return dot(normal, p - at); }
  bool holds(const Thing& t) const {
    return std::ranges::all_of(corners(t), [&](const Vec& p) { return height(p) == 0; });
  }
  /// The point without a coordinate in which the normal is not 0.
  Vec seen(const Vec& p) const {
    const std::size_t i = normal[0] != 0 ? 0 : normal[1] != 0 ? 1 : 2;
    return {p[(i + 1) % 3], p[(i + 2) % 3], 0};
  }
  Thing seen(const Thing& t) const {
    Thing flat = {is_polygon_in_space(t) ? Kind::region : Kind::body, "hull", true};
    const Points& of = is_polygon_in_space(t) ? t.rings[0] : t.points;
    Points all;
    for (const Vec& p : of) all.push_back(seen(p));
    if (flat.kind == Kind::region)
      flat.rings = {all};
    else
      flat.points = all, close_faces(flat);
    return flat;
  }
};

bool is_within(const Vec& p, const Thing& t) {
  if (is_polygon_in_space(t)) {
    const Plane plane(t);
    return plane.height(p) == 0 && place(plane.seen(p), plane.seen(t)) < 0;
  }
  return std::ranges::all_of(t.faces, [&](const Face& f) { return f.holds(p) && (f.equation || f.beyond(p) != 0); });
}

/// Whether a point on a line is within both: it is tested at the ends of what the line has in common with their edges
/// and faces, and between two of those.
bool within_both(const Vec& from, const Vec& along, const Thing& a, const Thing& b) {
  std::vector<Rational> cuts;
  const auto cut = [&](const Vec& normal, const Rational& offset) {
    const Rational slope = dot(normal, along);
    if (slope != 0) cuts.push_back(Rational((offset - dot(normal, from)) / slope));
  };
  for (const Thing* const t : {&a, &b}) {
    for (const Face& f : t->faces) cut(f.normal, f.offset);
    if (!is_polygon_in_space(*t)) continue;
    const Plane plane(*t);
    any_edge(t->rings, [&](const Vec& p, const Vec& q) {
      const Vec across = cross(plane.normal, q - p);
      cut(across, dot(across, p));
      return false;
    });
  }
  std::ranges::sort(cuts);
  for (std::size_t i = 0; i < cuts.size(); ++i)
    for (const Rational& t : {cuts[i], Rational((cuts[i] + cuts[i + 1 < cuts.size() ? i + 1 : i]) / 2)})
      if (const Vec p = from + t * along; is_within(p, a) && is_within(p, b)) return true;
  return false;
}

/// `polygon` must be a polygon in space; the other may be one.
bool thin_interiors_meet(const Thing& polygon, const Thing& other) {
  const Plane plane(polygon);
  if (plane.holds(other)) return interiors_meet(plane.seen(polygon), plane.seen(other));
  const Points all = corners(other);
  for (std::size_t i = 1; i < all.size(); ++i)  // what it spans meets the plane along a line, or at a point
    for (std::size_t j = 0; j < i; ++j) {
      const Rational h = plane.height(all[i]), k = plane.height(all[j]);
      if (h == k) continue;
      const Vec at = all[i] + Rational(h / (h - k)) * (all[j] - all[i]);
      for (const Vec& third : all) {
        const Vec along = cross(plane.normal, cross(all[j] - all[i], third - all[i]));
        if (!is_zero(along)) return within_both(at, along, polygon, other);
      }
      return is_within(at, polygon) && is_within(at, other);
    }
  return false;
}
bool thin_lies_in(const Thing& a, const Thing& b) {
  const Plane plane(is_polygon_in_space(b) ? b : a);
  return plane.holds(a) && plane.holds(b) && lies_in(plane.seen(a), plane.seen(b));
}

}  // namespace

bool interiors_meet(const Thing& a, const Thing& b) {
  if (are_thin(a, b)) return is_polygon_in_space(a) ? thin_interiors_meet(a, b) : thin_interiors_meet(b, a);
  if (b.kind == Kind::round && a.kind != Kind::surface) return interiors_meet(b, a);
  if (a.kind == Kind::round && b.kind != Kind::surface) {
    const Relation r = of_round(a, b);
    if (r != Relation::b_inside_a) return r != Relation::disjoint && r != Relation::touching;
    Vec middle = {};  // a body within it lies on its border as a whole if its middle does
    for (const Vec& p : b.points) middle = middle + Rational(1, static_cast<long>(b.points.size())) * p;
    return b.radius > 0 || place_in_round(middle, a) < 0;
  }
  if (is_region(a, b)) {
    const std::optional<Points> thin_a = thin(a), thin_b = thin(b);
    if (a.radius > 0) return interiors_meet(b, a);
    if (b.radius > 0 && thin_a) return distance2(*thin_a, b.points) < b.radius * b.radius;
    if (b.radius > 0) {
      const BallInRegion found(b, a);
      return found.cut || found.holds;
    }
    if (thin_a && thin_b) {
      const auto along = [](const Points& ends) {
        Thing part = {Kind::body, "segment", true, ends};
        close_faces(part);
        return part;
      };
      return interiors_meet(along(*thin_a), along(*thin_b));
    }
    if (thin_a) return reaches_into(*thin_a, b);
    if (thin_b) return reaches_into(*thin_b, a);
    return Overlay(a, b).interiors_meet;
  }
  if (b.kind == Kind::surface) return interiors_meet(b, a);
  if (a.kind == Kind::surface)
    return std::ranges::any_of(a.triangles, [&](const Points& triangle) {
      Thing part = {Kind::body, "triangle", false, triangle};
      close_faces(part);
      return interiors_meet(part, b);
    });
  const Rational radius = a.radius + b.radius;
  const Nearest found = nearest(a.points, b.points);
  if (radius > 0) return found.distance2 < radius * radius;
  return found.distance2 == 0 && interiors_meet(a.faces, b.faces, found.point);
}

bool has_test(const Thing& a, const Thing& b) {
  constexpr std::size_t most_faces = 16;  // their cube is the time that the truth of them takes
  const auto is_round = [](const Thing& t) { return t.type == "cylinder" || t.type == "cone"; };
  const auto has = [&](const Thing& other) {
    return !is_round(other) && other.type != "capsule" && other.faces.size() <= most_faces;
  };
  return is_round(a) ? has(b) : !is_round(b) || has(a);
}

bool has_relation(const Thing& a, const Thing& b) {
  const auto open = [](const Thing& region, const Thing& solid) {
    return region.kind == Kind::region && !thin(region) && (solid.type == "obb" || solid.type == "kdop") &&
           (solid.faces.empty() || std::ranges::any_of(solid.faces, &Face::equation));
  };
  return !open(a, b) && !open(b, a);
}

bool lies_in(const Thing& a, const Thing& b) {
  if (are_thin(a, b)) return thin_lies_in(a, b);
  if (a.kind == Kind::round && b.kind == Kind::plane) return sides(b, a) == std::array{false, true, false};
  if (a.kind == Kind::round && b.kind == Kind::body) return of_round(a, b) == Relation::a_inside_b;
  if (b.kind == Kind::round && is_ball(a)) return of_round(b, a) == Relation::b_inside_a;
  const Points all = corners(a);
  if (b.kind == Kind::round) return std::ranges::all_of(all, [&](const Vec& p) { return place_in_round(p, b) <= 0; });
  if (b.kind == Kind::plane) {
    if (a.kind == Kind::line) return place(a.points[0], b) == 0 && dot(a.points[1], b.normal) == 0;
    return a.radius == 0 && std::ranges::all_of(all, [&](const Vec& p) { return place(p, b) == 0; });
  }
  if (b.kind == Kind::region && a.radius > 0) return BallInRegion(a, b).holds;
  if (is_region(a, b) && b.radius == 0) return Overlay(a, b).a_in_b;
  if (b.kind == Kind::surface)  // asked of what meets no triangle
    return b.closed && triangles_met(b, a) == 0 && place(all[0], b) < 0;
  if (b.radius > 0) {
    if (a.radius > b.radius) return false;
    const Rational room = b.radius - a.radius;
    return std::ranges::all_of(all, [&](const Vec& p) { return distance2({p}, b.points) <= room * room; });
  }
  return std::ranges::all_of(b.faces, [&](const Face& f) {
    if (f.equation && a.radius > 0) return false;
    return std::ranges::all_of(all, [&](const Vec& p) {
      if (!f.holds(p)) return false;
      const Rational room = f.beyond(p);
      return a.radius == 0 || room * room >= a.radius * a.radius * dot(f.normal, f.normal);
    });
  });
}

namespace {

/// The common part of two ranges.
std::optional<Range> common(const Range& a, const Range& b) {
  Range both = a;
  if (b.lo && (!both.lo || *b.lo > *both.lo)) both.lo = b.lo;
  if (b.hi && (!both.hi || *b.hi < *both.hi)) both.hi = b.hi;
  if (both.lo && both.hi && *both.lo > *both.hi) return {};
  return both;
}

bool in(const Range& r, const Rational& t) { return (!r.lo || *r.lo <= t) && (!r.hi || t <= *r.hi); }
bool within(const Range& r, const Rational& t) { return in(r, t) && (!r.lo || *r.lo != t) && (!r.hi || *r.hi != t); }

std::optional<Range> part_in(const Thing& line, const Faces& faces) {
  Range part = line.range;
  for (const Face& f : faces) {
    const Rational speed = dot(f.normal, line.points[1]), start = f.beyond(line.points[0]);
    Range here;
    if (speed == 0 && !f.holds(line.points[0])) return {};
    if (speed != 0) {
      const Rational t = -start / speed;
      if (speed > 0 || f.equation) here.hi = t;
      if (speed < 0 || f.equation) here.lo = t;
    }
    const auto both = common(part, here);
    if (!both) return {};
    part = *both;
  }
  return part;
}

void take_first(std::optional<Range>& best, const std::optional<Range>& other) {
  if (!other) return;
  if (!best || !other->lo || (best->lo && *other->lo < *best->lo)) best = other;
}

}  // namespace

std::optional<Range> part_in(const Thing& line, const Thing& other) {
  if (other.kind == Kind::body) return part_in(line, other.faces);
  std::optional<Range> first;
  if (other.kind == Kind::plane) return part_in(line, Faces{{other.normal, -other.d, true}});
  for (const Points& t : other.triangles) take_first(first, part_in(line, faces_of(t, other.flat)));
  if (other.kind == Kind::line) return part_in(line, faces_of(near(other, near(line, {other.points[0]})), other.flat));
  if (other.kind == Kind::surface) return first;
  any_edge(other.rings, [&](const Vec& a, const Vec& b) {
    take_first(first, part_in(line, faces_of({a, b}, true)));
    return false;
  });
  if (line.range.lo && place_in_region(at(line, *line.range.lo), other.rings) <= 0) first = Range{line.range.lo, {}};
  return first;
}

bool tangent(const Thing& line, const Thing& ball) {
  Thing whole = line;
  whole.range = {};
  return distance2(near(whole, ball.points), ball.points) == ball.radius * ball.radius;
}

bool on_outline(const Vec& p, const Thing& t) {
  return any_edge(t.rings, [&](const Vec& a, const Vec& b) { return distance2({p}, {a, b}) == 0; });
}

bool in_plane_of(const Thing& line, const Thing& t) {
  const Points& ring = t.rings[0];
  const Vec normal = normal_of(ring);
  return dot(normal, line.points[1]) == 0 && dot(normal, line.points[0] - ring[0]) == 0;
}

int side(const Vec& p, const Thing& line) { return sgn(cross(line.points[1], p - line.points[0])[2]); }

Crossing crossing(const Thing& a, const Thing& b) {
  using Lines = Crossing::Lines;
  using Common = Crossing::Common;
  const Vec &u = a.points[1], &v = b.points[1], w = b.points[0] - a.points[0];
  if (is_zero(u) || is_zero(v)) {
    const Thing &point = is_zero(u) ? a : b, &other = is_zero(u) ? b : a;
    return {Lines::other, place(point.points[0], other) == 0 ? Common::point : Common::nothing};
  }
  const Vec n = cross(u, v);
  if (is_zero(n)) {
    if (!is_zero(cross(w, u))) return {Lines::parallel, Common::nothing};
    const Rational offset = dot(w, u) / dot(u, u), scale = dot(v, u) / dot(u, u);
    Range other;
    if (b.range.lo) (scale > 0 ? other.lo : other.hi) = offset + scale * *b.range.lo;
    if (b.range.hi) (scale > 0 ? other.hi : other.lo) = offset + scale * *b.range.hi;
    const auto both = common(a.range, other);
    if (!both) return {Lines::other, Common::nothing};
    const bool point = both->lo && both->hi && *both->lo == *both->hi;
    return {Lines::other, point ? Common::point : Common::stretch};
  }
  if (dot(w, n) != 0) return {Lines::skew, Common::nothing};
  const Rational n2 = dot(n, n), t = dot(cross(w, v), n) / n2, s = dot(cross(w, u), n) / n2;
  if (!in(a.range, t) || !in(b.range, s)) return {Lines::other, Common::nothing};
  return {Lines::other, Common::point, within(a.range, t) && within(b.range, s)};
}

}  // namespace isect::proof
