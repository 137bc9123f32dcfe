// Parts of objects in a box or beside a plane, and hierarchies over objects and meshes.

#include <algorithm>
#include <cmath>
#include <limits>

#include <isect/clip_polygon.h>
#include <isect/clip_segment.h>
#include <isect/convex_hull.h>
#include <isect/fit.h>
#include <isect/many/bvh.h>
#include <isect/numbers/exact.h>
#include <isect/numbers/quotient.h>

#include "app/query/reply.h"
#include "app/scene/answered.h"
#include "app/scene/fits.h"
#include "app/scene/pairs.h"
#include "app/scene/questions.h"
#include "app/scene/shapes.h"
#include "viz/lang/message.h"
#include "viz/text/rich_text.h"

namespace isect::program::scene {

namespace {

using viz::Role;
using viz::Vec3;
using viz::Verdict;

// Clipping.

template <int N>
std::optional<Interval<double>> part_of_line(const Shaped& line, const auto& to) {
  return line.type() == Type::segment ? clip(line.as<Segment, N>(), to) : clip(line.as<Ray, N>(), to);
}
template <int N>
std::optional<Interval<double>> part_of_line(const Shaped& line, const Shaped& to) {
  return to.type() == Type::plane ? part_of_line<N>(line, to.as<Plane, N>()) : part_of_line<N>(line, to.as<Aabb, N>());
}

/// Whether no more than a point is left of the line, given that some is: rounded, both its ends may be one number.
bool leaves_one_point(const NamedValues& s, const Object& o, const Object& to) {
  const bool segment = o.type == Type::segment;
  const Vec3 from = s.point(o, segment ? "from" : "origin");
  Ratio<Exact> first = {Exact(0.0), Exact(0.0)}, last = first;  // den 0: none yet
  const auto take = [](Ratio<Exact>& end, const Ratio<Exact>& t, int side) {
    if (end.den.sign() == 0 || (t.num * end.den - end.num * t.den).sign() * side > 0) end = t;
  };
  const auto limit = [&](const Exact& rate, const Exact& reach, int side) {  // t rate against reach
    const int way = rate.sign();
    const Ratio<Exact> t = way < 0 ? Ratio<Exact>{-reach, -rate} : Ratio<Exact>{reach, rate};
    if (way * side > 0) take(first, t, 1);
    if (way * side < 0) take(last, t, -1);
  };
  bool still = true;
  Exact climb = 0.0, height = 0.0;  // to a plane
  if (to.type == Type::plane) height = s.number(to, "d");
  for (int i = 0; i < 3; ++i) {
    const Exact rate = segment ? Exact(s.point(o, "to")[i]) - Exact(from[i]) : Exact(s.point(o, "dir")[i]);
    still &= rate.sign() == 0;
    if (i == 2 && s.flat) continue;
    if (to.type == Type::plane) {
      const Exact n = s.point(to, "normal")[i];
      climb = climb + n * rate, height = height + n * Exact(from[i]);
      continue;
    }
    const double lo = s.point(to, "lo")[i], hi = s.point(to, "hi")[i];
    limit(rate, Exact(lo) - Exact(from[i]), 1), limit(rate, Exact(hi) - Exact(from[i]), -1);
  }
  if (to.type == Type::plane) limit(climb, -height, 1);
  const auto end = [&](double t, int side) {
    if (std::isfinite(t)) limit(Exact(1.0), Exact(t), side);
  };
  end(s.has(o, "tmin") ? s.number(o, "tmin") : o.type == Type::line ? -HUGE_VAL : 0, 1);
  end(s.has(o, "tmax") ? s.number(o, "tmax") : segment ? 1 : HUGE_VAL, -1);
  const bool bounded = first.den.sign() != 0 && last.den.sign() != 0;
  return still || (bounded && (first.num * last.den - last.num * first.den).sign() == 0);
}

template <int N>
Ring<double, N> part_of_ring(const Ring<double, N>& ring, const NamedValues& s, const Object& to) {
  return to.type == Type::plane ? clip(ring, made<Plane<double, N>>(s, to)) : clip(ring, made<Aabb<double, N>>(s, to));
}

/// Returns what is left of each outline; nothing of one with holes that has no point there.
template <int N>
std::vector<std::vector<Vec3>> part_of_outline(const NamedValues& s, const Object& o, const Object& to) {
  const std::vector<std::vector<Vec3>> rings =
      o.type == Type::hull ? std::vector<std::vector<Vec3>>{outline_of(s, o)} : s.rings(o);
  std::vector<std::vector<Vec3>> all;
  const bool in_box = to.type == Type::box;
  if (rings.size() > 1 && in_box && ask(Shaped(s, o), Shaped(s, to)).verdict.kind == Verdict::Kind::no) return all;
  for (const std::vector<Vec3>& ring : rings) {
    std::vector<Vec3> kept;
    for (const Point<double, N>& p : part_of_ring<N>(points_of<N>(ring), s, to)) {
      kept.push_back(Vec3::Zero());
      kept.back().head<N>() = p;
    }
    if (!kept.empty()) all.push_back(std::move(kept));
  }
  return all;
}

/// Returns "in A", "where the normal of E points".
std::string where(const Context& c, const ClipAsked& asked) {
  const std::string name = c.name(asked.to);
  return c.object(asked.to).type == Type::plane ? viz::tr("where the normal of {a} points", {{"a", name}})
                                                : viz::tr("in {a}", {{"a", name}});
}

std::string nothing_there(const Context& c, const ClipAsked& asked) {
  return viz::tr("nothing of {a} lies {where}", {{"a", c.name(asked.what)}, {"where", where(c, asked)}});
}

/// Returns "the part from *t* = 1 to 2". Beside a plane it may have no end; in a box an infinite one is just too large.
std::string part_in_words(const Interval<double>& part, const Object& to) {
  const bool bounded = to.type == Type::box;
  const bool begins = bounded || std::isfinite(part.lo), ends = bounded || std::isfinite(part.hi);
  if (!begins && !ends) return viz::tr("all");
  if (!begins) return viz::tr("the part up to *t* = {t}", {{"t", viz::shown(part.hi)}});
  if (!ends) return viz::tr("the part from *t* = {t} on", {{"t", viz::shown(part.lo)}});
  const auto [lo, hi] = viz::shown_apart(part.lo, part.hi);
  return viz::tr("the part from *t* = {t} to {u}", {{"t", lo}, {"u", hi}});
}

void tell_line(const Context& c, const ClipAsked& asked, Answered& out) {
  const NamedValues& s = c.numbers;
  const Object &o = c.object(asked.what), &to = c.object(asked.to);
  const Shaped &line = c.shaped(asked.what), &other = c.shaped(asked.to);
  const auto part = s.flat ? part_of_line<2>(line, other) : part_of_line<3>(line, other);
  out.json["range"] = part ? Json{query::number(part->lo), query::number(part->hi)} : Json(nullptr);
  if (!part) {
    out.verdict = {Verdict::Kind::no, nothing_there(c, asked)};
    return;
  }
  const Vec3 from = o.type == Type::segment ? s.point(o, "from") : s.point(o, "origin");
  const Vec3 along = o.type == Type::segment ? Vec3(s.point(o, "to") - from) : s.point(o, "dir");
  const double foot = (c.room.middle - from).dot(along) / along.squaredNorm(), beyond = c.room.reach / along.norm();
  const double lo = std::isfinite(part->lo) ? part->lo : std::min(foot, part->hi) - beyond,
               hi = std::isfinite(part->hi) ? part->hi : std::max(foot, lo) + beyond;  // the end that is drawn
  const Vec3 a = from + lo * along, b = from + hi * along;
  out.items.push_back(viz::Line{a, b, Role::hit, viz::Pen::thick});
  for (const auto& [end, t] : {std::pair{a, part->lo}, {b, part->hi}})
    if (std::isfinite(t)) out.items.push_back(viz::Dot{end, viz::Mark::disc, Role::hit});
  for (const auto& [name, t] : {std::pair{"*t*_{in}", part->lo}, {"*t*_{out}", part->hi}})
    if (std::isfinite(t)) out.values.push_back({name, t, "t", Role::hit, true});
  out.verdict =
      leaves_one_point(s, o, to)
          ? Verdict{Verdict::Kind::on,
                    viz::tr("of {a} one point lies {where}: *t* = {t}",
                            {{"a", c.name(asked.what)}, {"where", where(c, asked)}, {"t", viz::shown(part->lo)}})}
          : Verdict{Verdict::Kind::yes, viz::tr("of {a} {part} lies {where}", {{"a", c.name(asked.what)},
                                                                               {"part", part_in_words(*part, to)},
                                                                               {"where", where(c, asked)}})};
}

void tell_outline(const Context& c, const ClipAsked& asked, Answered& out) {
  const Object &o = c.object(asked.what), &to = c.object(asked.to);
  const std::vector<std::vector<Vec3>> kept =
      c.file.flat ? part_of_outline<2>(c.numbers, o, to) : part_of_outline<3>(c.numbers, o, to);
  Json rings = Json::array();
  std::vector<std::size_t> corners;
  for (const std::vector<Vec3>& ring : kept) {
    rings.push_back(Json::array());
    for (const Vec3& p : ring) rings.back().push_back(c.numbers.list(p));
    corners.push_back(ring.size());
  }
  const bool holes = o.type == Type::polygon && c.numbers.rings(o).size() > 1;
  out.json[holes ? "rings" : "vertices"] = holes ? rings : kept.empty() ? Json::array() : rings[0];
  if (kept.empty()) {
    out.verdict = {Verdict::Kind::no, nothing_there(c, asked)};
    return;
  }
  viz::Region region;
  region.rings = kept, region.role = Role::hit, region.pen = viz::Pen::thick, region.corners = true;
  out.items.push_back(region);
  std::string counts = std::to_string(corners.front());
  for (std::size_t i = 1; i < corners.size(); ++i)
    counts = viz::tr("{a} and {b}", {{"a", counts}, {"b", std::to_string(corners[i])}});
  constexpr viz::Message one_outline =
      viz::message_count("the part of {a} {where} has {counts} corner", "the part of {a} {where} has {counts} corners");
  constexpr viz::Message several =
      viz::message_count("the part of {a} {where} has {outlines} outlines, of {counts} corner",
                         "the part of {a} {where} has {outlines} outlines, of {counts} corners");
  out.verdict = {Verdict::Kind::yes, tr_count(corners.back(), kept.size() > 1 ? several : one_outline,
                                              {{"a", c.name(asked.what)},
                                               {"where", where(c, asked)},
                                               {"outlines", std::to_string(kept.size())},
                                               {"counts", counts}})};
  if (holes)
    out.caption += " " + viz::tr("Each outline is cut by itself; what lies within an odd number of them is kept.");
  if (o.type != Type::polygon) return;
  out.caption += " ";
  out.caption += to.type == Type::plane
                     ? viz::tr("Of a polygon that is not convex, edges along the plane may join what is kept.")
                     : viz::tr("Of a polygon that is not convex, edges along the box may join what is kept.");
}

// Hierarchies.

/// Returns the box of an object, no smaller than the object.
Aabb<double, 3> box_around(const NamedValues& s, const Object& o) {
  Aabb<double, 3> box = fit_aabb(s.extent(o));
  constexpr Type rounded[] = {Type::sphere, Type::obb, Type::capsule, Type::cylinder, Type::cone};
  if (std::ranges::find(rounded, o.type) == std::end(rounded)) return box;
  for (int i = 0; i < 3; ++i) {  // sums are off by an ulp or two
    for (int k = 0; k < 4; ++k) {
      box.lo[i] = std::nextafter(box.lo[i], -std::numeric_limits<double>::infinity());
      box.hi[i] = std::nextafter(box.hi[i], std::numeric_limits<double>::infinity());
    }
    if (s.flat && i == 2) box.lo[i] = box.hi[i] = 0;
  }
  return box;
}

/// Draws boxes of the uppermost nodes: all of a small hierarchy.
void draw_nodes(const Bvh<double, 3>& bvh, bool flat, Answered& out) {
  constexpr std::size_t most_drawn = 31;
  for (std::size_t i = 0; i < std::min(bvh.nodes.size(), most_drawn); ++i) {
    const Aabb<double, 3>& b = bvh.nodes[i].box;
    const auto corner = [&](int k) {
      return Vec3(k & 1 ? b.hi.x() : b.lo.x(), k & 2 ? b.hi.y() : b.lo.y(), k & 4 ? b.hi.z() : b.lo.z());
    };
    for (int k = 0; k < (flat ? 4 : 8); ++k)
      for (const int axis : {1, 2, 4})
        if (!(k & axis) && !(flat && axis == 4))
          out.items.push_back(viz::Line{corner(k), corner(k | axis), i == 0 ? Role::text : Role::construction,
                                        i == 0 ? viz::Pen::solid : viz::Pen::construction});
  }
}

}  // namespace

bool has_box(Type t) {
  return !(t == Type::ray || t == Type::line || t == Type::plane || t == Type::frustum || t == Type::kdop);
}

Answered answered(const Context& c, const ClipAsked& asked) {
  const Object &o = c.object(asked.what), &to = c.object(asked.to);
  Answered out = {
      slug_of("clip-" + o.name + "-" + to.name),
      viz::tr("What of {a} lies {where}", {{"a", c.name(asked.what)}, {"where", where(c, asked)}}),
      to.type == Type::plane ? viz::tr("Cut at the plane.") : viz::tr("Cut at the box’s sides, one after the other."),
      {}};
  out.lit = {asked.what, asked.to};
  out.json = {{"clip", o.name}, {"to", to.name}};
  if (runs_along_a_line(o.type))
    tell_line(c, asked, out);
  else
    tell_outline(c, asked, out);
  out.json["verdict"] = viz::plain(out.verdict.text);
  return out;
}

Answered answered(const Context& c, const HierarchyAsked& asked) {
  const bool of_mesh = asked.objects.size() == 1;
  std::vector<Aabb<double, 3>> all;
  std::vector<std::string> names;
  if (of_mesh) all = boxes(mesh_of(c.numbers, c.object(asked.objects[0])));
  for (const std::size_t i : asked.objects) {
    if (!of_mesh) all.push_back(box_around(c.numbers, c.object(i)));
    names.push_back(c.object(i).name);
  }
  const Bvh<double, 3> bvh = build_bvh(all, {.largest_leaf = of_mesh ? 4 : 1});
  const BvhStatistics n = statistics(bvh);
  Answered out = {
      "hierarchy-" + (of_mesh ? slug_of(names[0]) : "of-objects"),
      of_mesh ? viz::tr("A hierarchy over the triangles of {a}", {{"a", c.name(asked.objects[0])}})
              : viz::tr("A hierarchy over the objects"),
      viz::tr(
          "Each node’s box holds those of its children. {boxes} boxes are in {leaves} leaves of at most {most}; the "
          "uppermost nodes are drawn.",
          {{"boxes", std::to_string(n.primitives)},
           {"leaves", std::to_string(n.leaves)},
           {"most", std::to_string(n.largest_leaf)}}),
      {Verdict::Kind::yes, viz::tr_count(static_cast<std::size_t>(n.nodes), "{n} node, depth {depth}",
                                         "{n} nodes, depth {depth}", {{"depth", std::to_string(n.depth)}})}};
  std::string left_out;
  const auto boxed = std::ranges::count_if(c.file.objects, [](const Object& o) { return has_box(o.type); });
  const bool of_all = !of_mesh && static_cast<std::size_t>(boxed) == asked.objects.size();
  for (std::size_t i = 0; i < c.file.objects.size() && of_all; ++i)
    if (const Type type = c.object(i).type; type == Type::kdop || type == Type::frustum)
      left_out += (left_out.empty() ? "" : ", ") + c.name(i);
  if (!left_out.empty())
    out.caption += " " + viz::tr("Without {names}, whose corners would be rounded.", {{"names", left_out}});
  out.lit = asked.objects;
  if (out.lit.size() == 2) out.lit.push_back(asked.objects[0]);  // a set of objects: no first and second role
  out.values = {{viz::tr("nodes"), static_cast<double>(n.nodes), "", Role::text, true},
                {viz::tr("leaves"), static_cast<double>(n.leaves), "", Role::text, true},
                {viz::tr("depth"), static_cast<double>(n.depth), "", Role::text, true},
                {viz::tr("expected cost of a ray"), n.cost, viz::tr("tests"), Role::text, true}};
  draw_nodes(bvh, c.file.flat, out);
  out.json = {{"hierarchy", names},
              {"verdict", viz::plain(out.verdict.text)},
              {"nodes", n.nodes},
              {"leaves", n.leaves},
              {"depth", n.depth},
              {"least_leaf", n.least_leaf},
              {"largest_leaf", n.largest_leaf},
              {"cost", n.cost}};
  return out;
}

}  // namespace isect::program::scene
