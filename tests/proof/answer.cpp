#include "tests/proof/answer.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>

namespace isect::proof {

namespace {

using Kind = Thing::Kind;

bool is(const Posed& x, const std::set<std::string>& types) { return types.contains(x.type()); }
const std::set<std::string> along_a_line = {"segment", "ray", "line"}, outlines = {"triangle", "polygon"},
                            asked_by_a_ball = {"box", "capsule", "cylinder", "cone"};

bool is_point_like(const Thing& line) { return is_zero(line.points[1]); }

Json number(double x) {
  if (std::isinf(x)) return x > 0 ? "inf" : "-inf";
  return x;
}
Json negative(const Json& x) {
  if (x.is_number()) return 0 - x.get<double>();  // 0 must not become -0
  return x == "inf" ? "-inf" : "inf";
}
/// The border that nearest_border finds or, for Times::left_out, any number.
Json border(Times times, const std::function<bool(const Rational&)>& holds) {
  return number(times == Times::nearest ? nearest_border(holds) : 0.5);
}
Json nearest_to(Times times, const Rational& x) {
  return border(times, [&](const Rational& t) { return t >= x; });
}

// Where things lie.

const char* location(const Vec& p, const Thing& t) {
  const int where = place(p, t);
  return where < 0 ? "in" : where == 0 ? "on" : "out";
}

/// The points of a cloud by their location, as lists of their indices.
Json located(const Thing& cloud, const Thing& other, bool has_inside) {
  Json result = has_inside ? Json{{"in", Json::array()}, {"on", Json::array()}, {"out", Json::array()}}
                           : Json{{"on", Json::array()}, {"out", Json::array()}};
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    const std::string where = location(cloud.points[i], other);
    result[!has_inside && where == "in" ? "on" : where].push_back(i);
  }
  return result;
}

Json of_point(const Posed& a, const Posed& b) {
  const Vec& p = a.thing.points[0];
  if (b.type() == "point") return {{"equal", p == b.thing.points[0]}};
  if (b.type() == "plane") return {{"side", sgn(Rational(dot(b.thing.normal, p) + b.thing.d))}};
  if (is(b, along_a_line)) {
    const bool on = place(p, b.thing) == 0;
    if (!b.thing.flat) return {{"on", on}};
    const int turn = side(p, b.thing);
    return {{"where", on ? "on" : turn > 0 ? "left" : turn < 0 ? "right" : "in line"}};
  }
  if (is(b, outlines) && b.thing.flat) return {{"evenodd", location(p, b.thing)}};
  if (is(b, outlines)) return {{"on", place(p, b.thing) <= 0}};
  return {{"location", location(p, b.thing)}};
}

// Planes.

/// The corners that define an object, each as often as it is named.
Points corners_named(const Posed& x) {
  Points all;
  if (x.type() == "mesh") {
    for (const Points& triangle : x.thing.triangles) all.insert(all.end(), triangle.begin(), triangle.end());
    return all;
  }
  const Json rings = x.json.contains("rings") ? x.json["rings"] : Json::array({x.json["points"]});
  for (const Json& ring : rings)
    for (const Json& p : ring) all.push_back(vec(p));
  return all;
}

Json of_plane(const Posed& a, const Posed& b) {
  const Thing& plane = a.thing;
  if (b.type() == "plane") {
    const bool parallel = is_zero(cross(plane.normal, b.thing.normal));
    return {{"relation", !parallel              ? plane.flat ? "a point in common" : "a line in common"
                         : meet(plane, b.thing) ? "equal"
                                                : "parallel"}};
  }
  if (is(b, {"triangle", "polygon", "hull", "mesh", "cloud"})) {
    std::array<int, 3> count = {};
    for (const Vec& p : corners_named(b)) ++count[1 + sgn(Rational(dot(plane.normal, p) + plane.d))];
    return {{"behind", count[0]}, {"on", count[1]}, {"before", count[2]}};
  }
  const auto [behind, on, before] = sides(plane, b.thing);
  return {{"relation", behind && before ? "overlap" : on ? "touch" : "disjoint"}};
}

// What runs along a line.

/// Whether the part of a line up to t, or from t on, meets the body.
bool meets_until(Thing line, const Thing& body, const Rational& t) {
  if (line.range.lo && t < *line.range.lo) return false;
  if (!line.range.hi || t < *line.range.hi) line.range.hi = t;
  return meet(line, body);
}
bool meets_from(Thing line, const Thing& body, const Rational& t) {
  if (line.range.hi && *line.range.hi < t) return false;
  if (!line.range.lo || *line.range.lo < t) line.range.lo = t;
  return meet(line, body);
}
Json first_t(Times times, const Thing& line, const Thing& other) {
  if (other.radius > 0 || other.kind == Kind::round)
    return border(times, [&](const Rational& t) { return meets_until(line, other, t); });
  const auto part = part_in(line, other);
  return part && part->lo ? nearest_to(times, *part->lo) : Json(nullptr);
}
Json last_t(Times times, const Thing& line, const Thing& other) {
  if (other.radius > 0 || other.kind == Kind::round)
    return negative(border(times, [&](const Rational& t) { return meets_from(line, other, -t); }));
  const auto part = part_in(line, other);
  return part && part->hi ? nearest_to(times, *part->hi) : Json(nullptr);
}

Json to_plane(Times times, const Thing& line, const Thing& plane) {
  const Rational fall = dot(plane.normal, line.points[1]), height = dot(plane.normal, line.points[0]) + plane.d;
  Json result = {{"parallel", fall == 0}, {"coplanar", fall == 0 && height == 0}, {"ray_hit", meet(line, plane)}};
  if (fall != 0) result["t"] = nearest_to(times, Rational(-height / fall));
  return result;
}

Json to_ball(Times times, const Thing& line, const Thing& ball) {
  const bool hit = meet(line, ball);
  Json result = {{"ray_hit", hit}};
  if (is_point_like(line)) return result;
  Thing whole = line;
  whole.range = {};
  result["line_roots"] = !meet(whole, ball) ? 0 : tangent(line, ball) ? 1 : 2;
  result["t_enter_solid"] = hit ? first_t(times, line, ball) : Json(nullptr);
  return result;
}

/// A triangle or a polygon in space.
Json to_outline(Times times, const Thing& line, const Thing& outline) {
  const bool hit = meet(line, outline);
  Vec normal = {};
  const Points& ring = outline.rings[0];
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) normal = normal + cross(ring[i] - ring[0], ring[i + 1] - ring[0]);
  if (is_zero(normal)) return {{"hit_without_area", hit}};
  if (in_plane_of(line, outline)) return {{"coplanar", true}, {"hit_in_plane", hit}};
  Json result = {{"coplanar", false}, {"hit", hit}};
  if (hit) {
    const auto part = part_in(line, outline);
    result["t"] = nearest_to(times, *part->lo);
    result["plane_point_location"] = on_outline(at(line, *part->lo), outline) ? "on" : "in";
  }
  return result;
}

Json to_line(Times times, const Thing& a, const Thing& b) {
  using Lines = Crossing::Lines;
  using Common = Crossing::Common;
  const Crossing c = crossing(a, b);
  if (a.flat && a.type == "segment" && b.type == "segment")
    return {{"relation", c.common == Common::nothing   ? "disjoint"
                         : c.common == Common::stretch ? "overlap"
                         : c.within_both               ? "cross"
                                                       : "touch"}};
  Json result = {{"meeting", c.lines == Lines::skew        ? "skew"
                             : c.lines == Lines::parallel  ? "parallel"
                             : c.common == Common::nothing ? "apart"
                             : c.common == Common::stretch ? "stretch"
                                                           : "point"}};
  if (c.common != Common::point || is_point_like(a)) return result;
  const Vec &u = a.points[1], &v = b.points[1], w = b.points[0] - a.points[0], n = cross(u, v);
  if (is_point_like(b)) result["t"] = nearest_to(times, Rational(dot(w, u) / dot(u, u)));
  if (!is_zero(n)) result["t"] = nearest_to(times, Rational(dot(cross(w, v), n) / dot(n, n)));
  return result;
}

Json of_line(Times times, const Posed& a, const Posed& b) {
  const Thing& line = a.thing;
  if (is(b, along_a_line)) return to_line(times, line, b.thing);
  if (b.type() == "plane") return to_plane(times, line, b.thing);
  if (b.type() == "sphere") return to_ball(times, line, b.thing);
  if (is(b, outlines) && !line.flat) return to_outline(times, line, b.thing);
  Json result = {{"hit", meet(line, b.thing)}};
  if (result["hit"] == false || is_point_like(line)) return result;
  const bool only_first = b.type() == "mesh" || (line.flat && (is(b, outlines) || b.type() == "hull"));
  result[only_first ? "t" : "t_in"] = first_t(times, line, b.thing);
  if (!only_first) result["t_out"] = last_t(times, line, b.thing);
  return result;
}

// Bodies, outlines and surfaces.

std::string relation(const Thing& a, const Thing& b) {
  if (!meet(a, b)) return "disjoint";
  const bool a_in_b = lies_in(a, b), b_in_a = lies_in(b, a);
  return a_in_b && b_in_a       ? "equal"
         : a_in_b               ? "b_contains_a"
         : b_in_a               ? "a_contains_b"
         : interiors_meet(a, b) ? "overlap"
                                : "touch";
}

/// The relation of two balls, which distinguishes both kinds of tangency.
std::string relation_of_balls(const Thing& a, const Thing& b) {
  const std::string r = relation(a, b);
  if (r == "touch") return "touch_outer";
  const Rational apart = a.radius - b.radius;
  if (!r.ends_with("contains_a") && !r.ends_with("contains_b")) return r;
  if (nearest(a.points, b.points).distance2 != apart * apart) return r;
  return a.radius == 0 || b.radius == 0 ? "touch_inner" : "touch_inner_" + r;
}

Json of_sets(const Posed& a, const Posed& b) {
  if (a.type() == "sphere" && b.type() == "sphere") return {{"relation", relation_of_balls(a.thing, b.thing)}};
  if (a.thing.flat && !has_relation(a.thing, b.thing)) return {{"meet", meet(a.thing, b.thing)}};
  std::string r = relation(a.thing, b.thing);
  if (a.type() == "sphere" && is(b, asked_by_a_ball))
    r = r == "a_contains_b" ? "sphere_contains_" + b.type() : r == "b_contains_a" ? b.type() + "_contains_sphere" : r;
  return {{"relation", r}};
}

}  // namespace

bool in_order(const std::string& a, const std::string& b) {
  return !(b == "sphere" && asked_by_a_ball.contains(a)) && !(b == "triangle" && a == "box");
}

std::optional<Json> answer(const Posed& a, const Posed& b, Times times) {
  const auto either = [&](const char* type) { return a.type() == type || b.type() == type; };
  const auto open = [](const Posed& x) { return x.type() == "mesh" && !x.thing.closed; };
  if (!has_test(a.thing, b.thing)) return {};
  if ((open(a) || open(b)) && (either("point") || either("cloud"))) return {};
  if (a.type() == "cloud" || (b.type() == "cloud" && !either("plane"))) {
    const Posed &cloud = a.type() == "cloud" ? a : b, &other = a.type() == "cloud" ? b : a;
    if (other.type() == "plane") return of_plane(other, cloud);
    const bool thin = is(other, {"point", "segment", "ray", "line", "cloud"});
    return located(cloud.thing, other.thing, !thin && (other.thing.flat || !is(other, outlines)));
  }
  if (either("point")) return a.type() == "point" ? of_point(a, b) : of_point(b, a);
  if (is(a, along_a_line)) return of_line(times, a, b);
  if (is(b, along_a_line)) return of_line(times, b, a);
  if (either("plane")) return a.type() == "plane" ? of_plane(a, b) : of_plane(b, a);
  if (a.type() == "mesh") return Json{{"triangles_met", triangles_met(a.thing, b.thing)}};
  if (b.type() == "mesh") return Json{{"triangles_met", triangles_met(b.thing, a.thing)}};
  return of_sets(a, b);
}

double nearest_border(const std::function<bool(const Rational&)>& holds) {
  using Limits = std::numeric_limits<double>;
  // Doubles in their order, as whole numbers.
  const auto ordered = [](double x) {
    const auto bits = std::bit_cast<std::int64_t>(x);
    return bits < 0 ? std::numeric_limits<std::int64_t>::min() - bits : bits;
  };
  const auto value = [](std::int64_t i) {
    return std::bit_cast<double>(i < 0 ? std::numeric_limits<std::int64_t>::min() - i : i);
  };
  if (!holds(Rational(Limits::max()))) return Limits::infinity();
  if (holds(Rational(Limits::lowest()))) return -Limits::infinity();
  std::int64_t no = ordered(Limits::lowest()), yes = ordered(Limits::max());
  while (yes - 1 > no) {
    const std::int64_t middle = no / 2 + yes / 2 + (no % 2 + yes % 2) / 2;
    (holds(Rational(value(middle))) ? yes : no) = middle;
  }
  const Rational halfway = (Rational(value(no)) + Rational(value(yes))) / 2;
  return value(holds(halfway) ? no : yes);
}

}  // namespace isect::proof
