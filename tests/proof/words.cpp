#include "tests/proof/words.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <map>
#include <stdexcept>

#include "app/query/relation_words.h"

namespace isect::proof {

namespace {

using Kind = Thing::Kind;
using Common = Crossing::Common;
using Lines = Crossing::Lines;

/// A verdict with X in place of the name that comes first and Y in place of the other.
struct Sentence {
  std::string text;
  const Thing *x, *y;
};
Sentence sentence(const std::string& verdict, const Named& a, const Named& b) {
  const auto place_of = [&](const std::string& name) {
    for (std::size_t i = verdict.find(name); i != std::string::npos; i = verdict.find(name, i + 1)) {
      const auto letter = [&](std::size_t k) { return k < verdict.size() && std::isalnum(verdict[k]); };
      if ((i == 0 || !letter(i - 1)) && !letter(i + name.size())) return i;
    }
    return std::string::npos;
  };
  const std::size_t of_a = place_of(a.name), of_b = place_of(b.name);
  Sentence s = {verdict, &a.thing, &b.thing};
  if (of_a != std::string::npos) s.text[of_a] = of_a < of_b ? 'X' : 'Y';
  if (of_b != std::string::npos) s.text[of_b] = of_b < of_a ? 'X' : 'Y';
  if (of_b < of_a) std::swap(s.x, s.y);
  return s;
}

bool contains(const Thing& outer, const Thing& inner) { return lies_in(inner, outer); }

bool touch(const Thing& x, const Thing& y) {
  if (x.kind == Kind::plane || y.kind == Kind::plane) {
    const auto [behind, on, before] = x.kind == Kind::plane ? sides(x, y) : sides(y, x);
    return on && !(behind && before);
  }
  if (x.kind == Kind::line && y.kind == Kind::line) {
    const Crossing c = crossing(x, y);
    return c.common == Common::point && !c.within_both;
  }
  return meet(x, y) && !interiors_meet(x, y) && !contains(x, y) && !contains(y, x);
}

/// How many points of a cloud lie within something, on its boundary and outside.
std::array<int, 3> counted(const Thing& cloud, const Thing& other) {
  std::array<int, 3> count = {};
  for (const Vec& p : cloud.points) ++count[1 + place(p, other)];
  return count;
}

using Says = bool (*)(const Thing& x, const Thing& y);
const std::map<std::string, Says>& sentences() {
  static const auto strictly_in = [](const Thing& x, const Thing& y) { return lies_in(x, y) && !lies_in(y, x); };
  static const auto only_side = [](const Thing& x, const Thing& y, int side) {
    const auto of = sides(y, x);
    return of[1 + side] && !of[1] && !of[1 - side];
  };
  static const auto cut = [](const Thing& plane, const Thing& y) {
    const auto of = sides(plane, y);
    return of[0] && of[2];
  };
  static const std::map<std::string, Says> all = {
      {"X and Y are disjoint",
       [](const Thing& x, const Thing& y) {
         const bool within = (y.kind == Kind::surface && lies_in(x, y)) || (x.kind == Kind::surface && lies_in(y, x));
         return !meet(x, y) && !within;
       }},
      {"X and Y have a common point", meet},
      {"X meets Y", meet},
      {"X misses Y", [](const Thing& x, const Thing& y) { return !meet(x, y); }},
      {"X and Y touch", touch},
      {"X and Y touch, one inside the other",
       [](const Thing& x, const Thing& y) {
         const Rational apart = x.radius - y.radius;
         return nearest(x.points, y.points).distance2 == apart * apart && apart != 0;
       }},
      {"X and Y are equal", [](const Thing& x, const Thing& y) { return lies_in(x, y) && lies_in(y, x); }},
      {"X lies in Y",
       [](const Thing& x, const Thing& y) { return y.kind == Kind::plane ? lies_in(x, y) : strictly_in(x, y); }},
      {"X and Y overlap",
       [](const Thing& x, const Thing& y) { return interiors_meet(x, y) && !lies_in(x, y) && !lies_in(y, x); }},
      // planes
      {"X cuts Y", cut},
      {"X has points on both sides of Y", [](const Thing& x, const Thing& y) { return cut(y, x); }},
      {"X lies beside Y, where its normal points", [](const Thing& x, const Thing& y) { return only_side(x, y, 1); }},
      {"X lies beside Y, on the side that its normal leaves",
       [](const Thing& x, const Thing& y) { return only_side(x, y, -1); }},
      {"X and Y are the same",
       [](const Thing& x, const Thing& y) { return is_zero(cross(x.normal, y.normal)) && meet(x, y); }},
      {"X and Y are parallel",
       [](const Thing& x, const Thing& y) {
         return x.kind == Kind::plane ? !meet(x, y) : crossing(x, y).lines == Lines::parallel;
       }},
      {"X and Y meet in a point", [](const Thing& x, const Thing& y) { return !is_zero(cross(x.normal, y.normal)); }},
      {"X and Y meet in a line", [](const Thing& x, const Thing& y) { return !is_zero(cross(x.normal, y.normal)); }},
      // points
      {"X lies inside Y", [](const Thing& x, const Thing& y) { return place(x.points[0], y) == -1; }},
      {"X lies on the boundary of Y", [](const Thing& x, const Thing& y) { return place(x.points[0], y) == 0; }},
      {"X lies outside Y", [](const Thing& x, const Thing& y) { return place(x.points[0], y) == 1; }},
      {"X lies on Y", [](const Thing& x, const Thing& y) { return place(x.points[0], y) <= 0; }},
      {"X does not lie on Y", [](const Thing& x, const Thing& y) { return place(x.points[0], y) == 1; }},
      {"X lies left of Y", [](const Thing& x, const Thing& y) { return side(x.points[0], y) == 1; }},
      {"X lies right of Y", [](const Thing& x, const Thing& y) { return side(x.points[0], y) == -1; }},
      {"X lies in line with Y, beyond its end",
       [](const Thing& x, const Thing& y) { return side(x.points[0], y) == 0 && place(x.points[0], y) == 1; }},
      {"X and Y coincide", [](const Thing& x, const Thing& y) { return x.points == y.points; }},
      {"X and Y differ", [](const Thing& x, const Thing& y) { return x.points != y.points; }},
      // lines
      {"X and Y cross", [](const Thing& x, const Thing& y) { return crossing(x, y).within_both; }},
      {"X and Y share a stretch",
       [](const Thing& x, const Thing& y) { return crossing(x, y).common == Common::stretch; }},
      {"X and Y have one point in common",
       [](const Thing& x, const Thing& y) { return crossing(x, y).common == Common::point; }},
      {"X and Y are skew", [](const Thing& x, const Thing& y) { return crossing(x, y).lines == Lines::skew; }},
      {"X meets Y in one point", [](const Thing& x, const Thing& y) { return meet(x, y) && tangent(x, y); }},
      {"X meets Y on its boundary",
       [](const Thing& x, const Thing& y) {
         const auto part = part_in(x, y);
         return part && part->lo && on_outline(at(x, *part->lo), y);
       }},
      {"X meets Y, in whose plane it lies",
       [](const Thing& x, const Thing& y) { return meet(x, y) && in_plane_of(x, y); }},
      {"X misses Y, in whose plane it lies",
       [](const Thing& x, const Thing& y) { return !meet(x, y) && in_plane_of(x, y); }},
      // many
      {"X meets no triangle of Y", [](const Thing& x, const Thing& y) { return triangles_met(y, x) == 0; }},
  };
  return all;
}

/// Whether a verdict with counts is true; nothing for other verdicts.
std::optional<bool> counts(const Sentence& s) {
  const Thing &x = *s.x, &y = *s.y;
  int some = 0, of = 0, on = 0, end = 0;
  const auto reads = [&](const char* form, auto*... to) {
    end = 0;
    return std::sscanf(s.text.c_str(), form, to..., &end) == sizeof...(to) && end == static_cast<int>(s.text.size());
  };
  if (reads("X meets %d of %d triangles of Y%n", &some, &of))
    return triangles_met(y, x) == some && of == static_cast<int>(y.triangles.size());
  for (const char* form : {"%d of %d points of X lie inside Y%n", "%d of %d points of X lies inside Y%n"})
    if (reads(form, &some, &of)) return counted(x, y) == std::array<int, 3>{some, 0, of - some};
  for (const char* form : {"%d of %d points of X lie inside Y, %d on its boundary%n",
                           "%d of %d points of X lies inside Y, %d on its boundary%n"})
    if (reads(form, &some, &of, &on)) return counted(x, y) == std::array<int, 3>{some, on, of - some - on};
  for (const char* form :
       {"%d of %d points of X lie on Y%n", "%d of %d points of X lies on Y%n", "%d of %d points of X are Y%n",
        "%d of %d points of X is Y%n", "%d of %d points of X are also in Y%n", "%d of %d points of X is also in Y%n"})
    if (reads(form, &some, &of)) {
      const auto [in, at_boundary, out] = counted(x, y);
      return in + at_boundary == some && out == of - some;
    }
  return {};
}

}  // namespace

Judged judge(const std::string& verdict, const Named& a, const Named& b) {
  if (verdict.find("not decided") != std::string::npos) return Judged::undecided;
  const Sentence s = sentence(verdict, a, b);
  std::optional<bool> is;
  if (const auto found = sentences().find(s.text); found != sentences().end())
    is = found->second(*s.x, *s.y);
  else
    is = counts(s);
  return !is ? Judged::unknown : *is ? Judged::right : Judged::wrong;
}

namespace {

/// The double `steps` doubles beyond x.
double stepped(double x, int steps) {
  for (int i = 0; i < std::abs(steps); ++i) x = std::nextafter(x, steps < 0 ? -HUGE_VAL : HUGE_VAL);
  return x;
}

bool near_to(double given, const Rational& exact) {
  if (std::isinf(given)) return abs(exact) >= Rational(std::numeric_limits<double>::max());
  const double low = stepped(given, -4), high = stepped(given, 4);
  return (std::isinf(low) || Rational(low) <= exact) && (std::isinf(high) || exact <= Rational(high));
}

/// Whether a line enters a body with a radius, or leaves it, within four doubles of t: near it they meet, and on the
/// way to it, or from it, they do not.
bool changes_near(const Thing& line, const Thing& body, double t, bool enters) {
  const auto part = [&](std::optional<double> from, std::optional<double> to) {
    Thing piece = line;
    if (from && std::isfinite(*from) && (!piece.range.lo || *piece.range.lo < Rational(*from)))
      piece.range.lo = Rational(*from);
    if (to && std::isfinite(*to) && (!piece.range.hi || Rational(*to) < *piece.range.hi))
      piece.range.hi = Rational(*to);
    const bool has_points = !piece.range.lo || !piece.range.hi || *piece.range.lo <= *piece.range.hi;
    return has_points && meet(piece, body);
  };
  if (std::isinf(t)) return enters ? !part({}, stepped(t, -1)) : !part(stepped(t, 1), {});
  const double low = stepped(t, -4), high = stepped(t, 4);
  return part(low, high) && !(enters ? part({}, stepped(low, -1)) : part(stepped(high, 1), {}));
}

/// What is wrong for a line and a ball or capsule: where the whole line, and where its part, enters and leaves.
std::string wrong_in_round(const Json& result, const Thing& line, const Thing& body) {
  Thing whole = line;
  whole.range = {};
  struct End {
    const char* name;
    const Thing* of;
    bool enters;
  };
  for (const End& end : {End{"t0", &whole, true}, End{"t1", &whole, false}, End{"t_enter_solid", &line, true},
                         End{"t_in", &line, true}, End{"t_out", &line, false}})
    if (result.contains(end.name) && result[end.name].is_number() &&
        !changes_near(*end.of, body, result[end.name].get<double>(), end.enters))
      return end.name;
  return "";
}

}  // namespace

std::string wrong_in_result(const Json& result, bool of_query, const Named& a, const Named& b) {
  const std::string relation = result.is_object() ? result.value("relation", "") : "";
  const auto bounded = [](const Thing& t) {
    return t.kind == Kind::body || t.kind == Kind::region || t.kind == Kind::round;
  };
  const bool bodies = bounded(a.thing) && bounded(b.thing) &&
                      (!of_query || a.thing.type == b.thing.type);  // else a query has its own order
  const auto says = [&](Relation r) { return bodies && relation.ends_with(query::name(r)); };
  if (says(Relation::b_inside_a) && !contains(a.thing, b.thing)) return "relation " + relation;
  if (says(Relation::a_inside_b) && !contains(b.thing, a.thing)) return "relation " + relation;
  const Named *line = &a, *other = &b;
  if (line->thing.kind != Kind::line) std::swap(line, other);
  if (line->thing.kind != Kind::line || other->thing.kind == Kind::line) return "";
  if (is_zero(line->thing.points[1])) return "";
  if (other->thing.radius > 0 || other->thing.kind == Kind::round)
    return result.is_object() ? wrong_in_round(result, line->thing, other->thing) : "";
  const bool t_is_of_line = result.is_object() && result.value("ray_hit", true) && result.value("hit", true);
  if (!t_is_of_line) return "";
  std::optional<Range> part;
  for (const char* name : {"t", "t_in", "t_out"}) {
    if (!result.contains(name) || !result[name].is_number()) continue;
    if (!part) part = part_in(line->thing, other->thing);
    if (!part) return std::string(name) + " of a miss";
    const auto& end = std::string(name) == "t_out" ? part->hi : part->lo;
    if (end && !near_to(result[name].get<double>(), *end))
      return std::string(name) + ", which is " + std::to_string(end->get_d());
  }
  return "";
}

std::string truth_of(const Named& a, const Named& b) {
  const Thing &x = a.thing, &y = b.thing;
  std::string told = meet(x, y) ? "they meet" : "they are disjoint";
  const auto say = [&](const std::string& more) { told += ", " + more; };
  const auto area = [](const Thing& t) { return (t.kind == Kind::body && t.radius == 0) || t.kind == Kind::region; };
  if ((x.kind == Kind::body && y.kind == Kind::body) || (area(x) && area(y))) {
    if (interiors_meet(x, y)) say("have a common interior point");
    if (lies_in(x, y)) say(a.name + " lies in " + b.name);
    if (lies_in(y, x)) say(b.name + " lies in " + a.name);
  }
  if (x.kind == Kind::line && y.kind == Kind::line && meet(x, y))
    say(crossing(x, y).common == Common::stretch ? "in a stretch" : "in a point");
  for (const auto& [p, of] : {std::pair{&a, &b}, {&b, &a}}) {
    const Thing& t = p->thing;
    if (t.kind == Kind::cloud && of->thing.kind != Kind::plane) {
      const auto [in, on, out] = counted(t, of->thing);
      say(std::to_string(in) + " points within, " + std::to_string(on) + " on the boundary, " + std::to_string(out) +
          " outside");
    }
    if (t.type == "point") {
      const int where = place(t.points[0], of->thing);
      say(where < 0 ? "the point within" : where == 0 ? "the point on the boundary" : "the point outside");
    }
    if (t.type == "mesh") say(std::to_string(triangles_met(t, of->thing)) + " triangles of " + p->name + " are met");
    if (t.kind == Kind::plane && of->thing.kind != Kind::plane) {
      const auto [behind, on, before] = sides(t, of->thing);
      say(std::string("points") + (behind ? " behind" : "") + (on ? " on" : "") + (before ? " before" : "") +
          " the plane");
    }
  }
  return told;
}

}  // namespace isect::proof
