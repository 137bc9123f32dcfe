#include "app/scene/questions.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include <isect/line_triangle.h>

#include "app/query/query.h"
#include "app/query/reply.h"
#include "app/scene/pairs.h"
#include "app/scene/shapes.h"
#include "app/scene/triangulated.h"
#include "viz/rich_text.h"

namespace isect::program::scene {

using viz::Role;
using viz::Vec3;
using viz::Verdict;

namespace {

std::string names(const Object& a, const Object& b) { return shown_name(a.name) + " and " + shown_name(b.name); }

}  // namespace

Vec3 origin_of(const Setting& s, const Object& o) { return s.point(o, o.type == Type::segment ? "from" : "origin"); }

/// Of a segment the difference of its ends, which must be a floating-point vector: rounded, it would be another one.
Vec3 direction_of(const Setting& s, const Object& o) {
  if (o.type != Type::segment) return s.point(o, "dir");
  const Vec3 from = s.point(o, "from"), to = s.point(o, "to"), dir = to - from;
  for (int i = 0; i < 3; ++i) {
    const double back = dir[i] + from[i], error = (to[i] - back) + ((back - dir[i]) - from[i]);
    if (back != to[i] || error != 0)
      throw NotDecided("from one end of " + o.name +
                       " to the other is no vector of floating-point numbers, so the test would be "
                       "of another segment");
  }
  return dir;
}

Ray<double, 3> ray_in_space(const Setting& s, const Object& o) {
  Ray<double, 3> ray = {origin_of(s, o), direction_of(s, o)};
  if (o.type == Type::line) ray.range = infinite<double>;
  if (o.type == Type::segment) ray.range.hi = 1;
  if (s.has(o, "tmin")) ray.range.lo = s.number(o, "tmin");
  if (s.has(o, "tmax")) ray.range.hi = s.number(o, "tmax");
  return ray;
}

void refuse_outline(const Object& o) {
  throw NotDecided(fmt::format("the outline of {} has no area, crosses or touches itself", o.name));
}

void relate(const Setting& s, const Object& a, const Object& b, Answer& out) {
  if (out.result.contains("meet")) return tell_meeting(s, a, b, out);
  const std::string r = out.result.value("relation", "");
  const std::string na = shown_name(a.name), nb = shown_name(b.name);
  if (r == "disjoint")
    out.verdict = {Verdict::Kind::no, names(a, b) + " are disjoint"};
  else if (r == "touch" || r == "touch_outer")
    out.verdict = {Verdict::Kind::on, names(a, b) + " touch"};
  else if (r.starts_with("touch_inner"))
    out.verdict = {Verdict::Kind::on, names(a, b) + " touch, one inside the other"};
  else if (r == "equal")
    out.verdict = {Verdict::Kind::yes, names(a, b) + " are equal"};
  else if (r == "a_contains_b" || r.starts_with(spec(a.type).name + "_contains_"))
    out.verdict = {Verdict::Kind::yes, nb + " lies in " + na};
  else if (r == "b_contains_a" || r.starts_with(spec(b.type).name + "_contains_"))
    out.verdict = {Verdict::Kind::yes, na + " lies in " + nb};
  else
    out.verdict = {Verdict::Kind::yes, names(a, b) + " overlap"};
}

Segment<double, 3> segment_of(const Setting& s, const Object& o) { return {s.point(o, "from"), s.point(o, "to")}; }

void add_hit(const Setting& s, const Object& a, Answer& out, const char* name, const Json& t, viz::Mark mark) {
  if (t.is_null()) return;
  const double value = t.is_number() ? t.get<double>() : t == "inf" ? HUGE_VAL : -HUGE_VAL;
  if (!out.first_hit) out.first_hit = value;
  if (std::isinf(value)) return;
  const Vec3 from = origin_of(s, a),
             along = a.type == Type::segment ? Vec3(s.point(a, "to") - from) : s.point(a, "dir"),
             at = from + value * along;
  out.values.push_back({name, value, "t", Role::hit, true});
  if (at.allFinite()) out.marks.push_back(viz::Dot{at, mark, Role::hit});
}

/// The verdict of whatever runs along a line.
void meets(const Object& a, const Object& b, Answer& out, bool hit) {
  const std::string pair = shown_name(a.name) + (hit ? " meets " : " misses ") + shown_name(b.name);
  out.verdict = {hit ? Verdict::Kind::yes : Verdict::Kind::no, pair};
  for (const viz::Value& v : out.values)
    out.formula += fmt::format("{}{} = {}", out.formula.empty() ? "" : ", ", v.name, viz::shown(v.value));
}

void locate(const Object& a, const Object& b, Answer& out, const std::string& where) {
  const std::string na = shown_name(a.name), nb = shown_name(b.name);
  if (where == "in") out.verdict = {Verdict::Kind::yes, na + " lies inside " + nb};
  if (where == "on") out.verdict = {Verdict::Kind::on, na + " lies on the boundary of " + nb};
  if (where == "out") out.verdict = {Verdict::Kind::no, na + " lies outside " + nb};
}
namespace {

// How objects are written.

Json obb_of(const Setting& s, const Object& o) {
  Json axes = {s.list(o, "u"), s.list(o, "v")};
  if (!s.flat) axes.push_back(s.list(o, "w"));
  return {{"c", s.list(o, "center")}, {"u", axes}, {"e", s.list(o, "half")}};
}

Json capsule_of(const Setting& s, const Object& o) {
  return {{"p", s.list(o, "p")}, {"q", s.list(o, "q")}, {"r", s.number(o, "r")}};
}

Json ray_of(const Setting& s, const Object& o) {
  Json ray = {{"origin", s.list(origin_of(s, o))}, {"dir", s.list(direction_of(s, o))}};
  if (o.type == Type::line) ray["tmin"] = "-inf";
  if (o.type == Type::segment) ray["tmax"] = 1;
  for (const char* end : {"tmin", "tmax"})
    if (s.has(o, end)) ray[end] = s.number(o, end);
  return ray;
}

Json sphere_of(const Setting& s, const Object& o) {
  return {{"center", s.list(o, "center")}, {"radius", s.number(o, "radius")}};
}
Json box_of(const Setting& s, const Object& o) { return {{"lo", s.list(o, "lo")}, {"hi", s.list(o, "hi")}}; }
Json plane_of(const Setting& s, const Object& o) { return {{"normal", s.list(o, "normal")}, {"d", s.number(o, "d")}}; }
Json rings_of(const Setting& s, const Object& o) {
  Json rings = Json::array();
  for (const auto& ring : s.rings(o)) {
    rings.push_back(Json::array());
    for (const Vec3& p : ring) rings.back().push_back(s.list(p));
  }
  return rings;
}

Json merged(Json a, const Json& b) {
  a.update(b);
  return a;
}

template <Json (*A)(const Setting&, const Object&), Json (*B)(const Setting&, const Object&)>
Json both(const Setting& s, const Object& a, const Object& b) {
  return merged(A(s, a), B(s, b));
}

// How results are told.

void touch_of_plane(const Setting& s, const Object& a, const Object& b, Answer& out) {
  relate(s, a, b, out);
  if (out.verdict.kind == Verdict::Kind::yes)
    out.verdict.text = fmt::format("{} cuts {}", shown_name(a.name), shown_name(b.name));
}

void ray_meets_sphere(const Setting& s, const Object& a, const Object& b, Answer& out) {
  const bool hit = !out.result["t_enter_solid"].is_null();
  const bool tangent = out.result["line_roots"] == 1;
  add_hit(s, a, out, tangent ? "*t*" : "*t*_{in}", out.result["t_enter_solid"], viz::Mark::disc);
  if (hit && !tangent) {
    const double last = a.type == Type::segment ? 1 : s.has(a, "tmax") ? s.number(a, "tmax") : HUGE_VAL;
    const Json& t1 = out.result["t1"];  // none of what is a point, "inf" beyond the largest number
    add_hit(s, a, out, "*t*_{out}", query::number(t1.is_number() ? std::min(t1.get<double>(), last) : last),
            viz::Mark::ring);
  }
  meets(a, b, out, hit);
  if (tangent && hit) out.verdict = {Verdict::Kind::on, out.verdict.text + " in one point"};
}

void ray_meets_box(const Setting& s, const Object& a, const Object& b, Answer& out) {
  if (out.result["hit"] == true) {
    add_hit(s, a, out, "*t*_{in}", out.result["t_in"], viz::Mark::disc);
    add_hit(s, a, out, "*t*_{out}", out.result["t_out"], viz::Mark::ring);
  }
  meets(a, b, out, out.result["hit"] == true);
}

void ray_meets_plane(const Setting& s, const Object& a, const Object& b, Answer& out) {
  if (out.result["ray_hit"] == true) add_hit(s, a, out, "*t*", out.result["t"], viz::Mark::disc);
  meets(a, b, out, out.result["ray_hit"] == true);
  if (out.result["coplanar"] == true)
    out.verdict = {Verdict::Kind::on, shown_name(a.name) + " lies in " + shown_name(b.name)};
}

void ray_meets_polygon(const Setting& s, const Object& a, const Object& b, Answer& out) {
  const bool coplanar = out.result["coplanar"] == true;
  const Ring<double, 3> outline = points_of<3>(s.rings(b).front());
  const auto hit_by = [&](const auto& test) {
    return a.type == Type::segment ? test(segment_of(s, a)) : test(ray_in_space(s, a));
  };
  if (out.result["hit"].is_null() && !coplanar) {
    if (b.type != Type::triangle) refuse_outline(b);
    const auto t = hit_by([&](const auto& along) { return first_hit(along, triangle_of(s, b)); });
    out.result["hit_without_area"] = t.has_value();
    if (t) add_hit(s, a, out, "*t*", query::number(*t), viz::Mark::disc);
    return meets(a, b, out, t.has_value());
  }
  if (outline.size() <= most_corners && !is_simple(outline))
    out.note = shown_name(b.name) + " crosses or touches itself: what is inside is told by the even-odd rule.";
  if (coplanar) {
    const auto t = hit_by([&](const auto& along) { return first_hit(along, Polygon<double, 3>{{outline}}); });
    out.result["hit_in_plane"] = t.has_value();
    if (t) add_hit(s, a, out, "*t*", query::number(*t), viz::Mark::disc);
    meets(a, b, out, t.has_value());
    out.verdict.text += ", in whose plane it lies";
    return;
  }
  if (out.result["hit"] == true) add_hit(s, a, out, "*t*", out.result["t"], viz::Mark::disc);
  meets(a, b, out, out.result["hit"] == true);
  if (out.result["hit"] == true && out.result["plane_point_location"] == "on")
    out.verdict = {Verdict::Kind::on, out.verdict.text + " on its boundary"};
}

void point_location(const Setting&, const Object& a, const Object& b, Answer& out) {
  locate(a, b, out, out.result["location"]);
}
void point_in_polygon(const Setting&, const Object& a, const Object& b, Answer& out) {
  locate(a, b, out, out.result["evenodd"]);
  if (out.result["evenodd"] != out.result["nonzero"]) out.formula = "by the even-odd rule";
}
void same_point(const Setting&, const Object& a, const Object& b, Answer& out) {
  const bool equal = out.result["equal"] == true;
  out.verdict = {equal ? Verdict::Kind::yes : Verdict::Kind::no, names(a, b) + (equal ? " coincide" : " differ")};
}

void segments(const Setting& s, const Object& a, const Object& b, Answer& out) {
  const std::string r = out.result["relation"];
  const bool point = out.result.contains("point") && out.result["point"].is_array();
  if (point) {
    const Vec3 at(out.result["point"][0], out.result["point"][1], 0);
    out.marks.push_back(viz::Dot{at, r == "cross" ? viz::Mark::disc : viz::Mark::diamond, Role::hit});
    out.formula = fmt::format("at ({}, {})", viz::shown(at.x()), viz::shown(at.y()));
  }
  relate(s, a, b, out);
  if (r == "cross") out.verdict = {Verdict::Kind::yes, names(a, b) + " cross"};
  if (r == "overlap") out.verdict = {Verdict::Kind::yes, names(a, b) + " share a stretch"};
  if (r == "disjoint") return;
  const auto end = [&](const Object& o, const char* name) { return point_of<2>(s.point(o, name)); };
  const Segment<double, 2> of_a = {end(a, "from"), end(a, "to")};
  out.first_hit = first_hit(of_a, Polygon<double, 2>{{{end(b, "from"), end(b, "to")}}});
}

const std::vector<Pair>& pairs() {
  using enum Type;
  using In = Pair::In;
  static const std::vector<Pair> all = [] {
    std::vector<Pair> table = {
        {sphere, sphere, "sphere_sphere", In::both,
         [](const Setting& s, const Object& a, const Object& b) {
           return Json{{"c1", s.list(a, "center")},
                       {"r1", s.number(a, "radius")},
                       {"c2", s.list(b, "center")},
                       {"r2", s.number(b, "radius")}};
         },
         relate},
        {box, box, "box_box", In::both,
         [](const Setting& s, const Object& a, const Object& b) {
           return Json{
               {"alo", s.list(a, "lo")}, {"ahi", s.list(a, "hi")}, {"blo", s.list(b, "lo")}, {"bhi", s.list(b, "hi")}};
         },
         relate},
        {sphere, box, "sphere_box", In::both, both<sphere_of, box_of>, relate},
        {sphere, capsule, "sphere_capsule", In::both, both<sphere_of, capsule_of>, relate},
        {capsule, capsule, "capsule_capsule", In::both,
         [](const Setting& s, const Object& a, const Object& b) {
           return Json{{"a", capsule_of(s, a)}, {"b", capsule_of(s, b)}};
         },
         relate},
        {obb, obb, "obb_obb", In::both,
         [](const Setting& s, const Object& a, const Object& b) {
           return Json{{"a", obb_of(s, a)}, {"b", obb_of(s, b)}};
         },
         relate},
        {plane, sphere, "plane_sphere", In::both, both<plane_of, sphere_of>, touch_of_plane},
        {plane, box, "plane_box", In::both, both<plane_of, box_of>, touch_of_plane},
        {triangle, box, "triangle_box", In::both,
         [](const Setting& s, const Object& a, const Object& b) {
           return merged({{"tri", rings_of(s, a).front()}}, box_of(s, b));
         },
         relate},
        {segment, segment, "segment_segment", In::plane,
         [](const Setting& s, const Object& a, const Object& b) {
           return Json{{"a", {s.list(a, "from"), s.list(a, "to")}}, {"b", {s.list(b, "from"), s.list(b, "to")}}};
         },
         segments},
        {point, point, "point_point", In::both,
         [](const Setting& s, const Object& a, const Object& b) {
           return Json{{"a", s.list(a, "at")}, {"b", s.list(b, "at")}};
         },
         same_point},
    };
    const auto at_point = [&table](Type with, const char* kind, In in, auto written, auto tell) {
      table.push_back({point, with, kind, in, written, tell});
    };
    at_point(
        sphere, "point_sphere", In::both,
        [](const Setting& s, const Object& a, const Object& b) {
          return merged({{"point", s.list(a, "at")}}, sphere_of(s, b));
        },
        point_location);
    at_point(
        box, "point_box", In::both,
        [](const Setting& s, const Object& a, const Object& b) {
          return merged({{"point", s.list(a, "at")}}, box_of(s, b));
        },
        point_location);
    at_point(
        obb, "point_obb", In::both,
        [](const Setting& s, const Object& a, const Object& b) {
          return merged({{"point", s.list(a, "at")}}, obb_of(s, b));
        },
        point_location);
    for (const Type outline : {triangle, polygon})
      at_point(
          outline, "pip", In::plane,
          [](const Setting& s, const Object& a, const Object& b) {
            return Json{{"rings", rings_of(s, b)}, {"point", s.list(a, "at")}};
          },
          point_in_polygon);
    for (const Type along : {ray, line, segment}) {
      table.push_back({along, sphere, "ray_sphere", In::both, both<ray_of, sphere_of>, ray_meets_sphere});
      table.push_back({along, box, "ray_box", In::both, both<ray_of, box_of>, ray_meets_box});
      table.push_back({along, obb, "ray_obb", In::both, both<ray_of, obb_of>, ray_meets_box});
      table.push_back({along, plane, "ray_plane", In::both, both<ray_of, plane_of>, ray_meets_plane});
      for (const Type outline : {triangle, polygon})
        table.push_back({along, outline, "ray_polygon", In::space,
                         [](const Setting& s, const Object& a, const Object& b) {
                           return merged(ray_of(s, a), {{"polygon", rings_of(s, b).front()}});
                         },
                         ray_meets_polygon});
    }
    std::ranges::copy(pairs_of_many_numbers(), std::back_inserter(table));
    std::ranges::copy(pairs_in_plane(), std::back_inserter(table));
    std::ranges::copy(pairs_of_solids(), std::back_inserter(table));
    std::ranges::copy(pairs_of_polygons(), std::back_inserter(table));
    return table;
  }();
  return all;
}

const Pair* pair_of(Type a, Type b, bool flat) {
  const auto found = std::ranges::find_if(pairs(), [&](const Pair& p) { return p.a == a && p.b == b && p.fits(flat); });
  return found == pairs().end() ? nullptr : &*found;
}

Answer asked_in_order(const Setting& s, const Object& a, const Object& b, const Pair& pair) {
  if (b.type == Type::polygon && !s.flat && runs_along_a_line(a.type) && is_bent(s, b)) return along_surface(s, a, b);
  Answer out;
  try {
    Json result = pair.written(s, a, b);
    if (pair.kind) {
      out.query = merged({{"kind", pair.kind}}, result);
      const Json reply = Json::parse(query::answer(out.query.dump()).text);
      if (reply.contains("error"))
        throw viz::BadInput(fmt::format("{} and {}: {}", a.name, b.name, reply["error"].get<std::string>()));
      result = reply["result"];
    }
    out.result = std::move(result);
  } catch (const NotDecided&) {
    std::optional<Json> exact = a.type == Type::segment ? exact_of_segment(s, a, b) : std::nullopt;
    if (!exact) throw;
    out.result = std::move(*exact);
  }
  pair.tell(s, a, b, out);
  return out;
}

/// The result of the pair in the other order.
void turn_round(Json& result) {
  const auto found = result.find("relation");
  if (found == result.end()) return;
  if (*found == "a_contains_b")
    *found = "b_contains_a";
  else if (*found == "b_contains_a")
    *found = "a_contains_b";
}

}  // namespace

Answer ask(const Setting& s, const Object& a, const Object& b) {
  const Pair* pair = pair_of(a.type, b.type, s.flat);
  if (!pair && !pair_of(b.type, a.type, s.flat))
    throw std::logic_error(spec(a.type).name + " and " + spec(b.type).name + " have no test");
  if (!pair) {
    Answer out = ask(s, b, a);
    if (const std::string other = names(b, a); out.verdict.text.starts_with(other))
      out.verdict.text.replace(0, other.size(), names(a, b));  // in the order of the question
    if (out.query.is_null()) turn_round(out.result);           // what a query says is of its own fields
    return out;
  }
  try {
    return asked_in_order(s, a, b, *pair);
  } catch (const NotDecided& why) {
    Answer out;
    out.open = true;
    out.result = {{"not decided", why.what()}};
    out.verdict = {Verdict::Kind::open, fmt::format("{} and {}: not decided, as {}", shown_name(a.name),
                                                    shown_name(b.name), viz::as_markup(why.what()))};
    return out;
  }
}

}  // namespace isect::program::scene
