// Answers in words, values and marks.

#include <fmt/format.h>

#include <cmath>

#include "app/scene/pairs.h"
#include "viz/lang/message.h"
#include "viz/text/rich_text.h"

namespace isect::program::scene {

using viz::Role;
using viz::tr;
using viz::tr_count;
using viz::Vec3;
using viz::Verdict;

namespace {

/// Two objects, by name, with their answer.
struct VerdictWriter {
  using Kind = Verdict::Kind;

  const Shaped &a, &b;
  Told& out;
  const Answer& answer = out.answer;
  std::string na = shown_name(a.object.name), nb = shown_name(b.object.name), both = both_names(a, b);

  void say(Kind kind, const std::string& text) const { out.verdict = {kind, text}; }
  /// Returns a text with the places {both}, {a} and {b}.
  std::string tr_names(std::string_view english) const { return tr(english, {{"both", both}, {"a", na}, {"b", nb}}); }

  // How two sets lie.

  void relation() const {
    if (!answer.relation)
      return answer.meet ? say(Kind::yes, tr_names("{both} have a common point"))
                         : say(Kind::no, tr_names("{both} are disjoint"));
    const bool within = answer.relation == Relation::a_inside_b || answer.relation == Relation::b_inside_a;
    if (within && answer.tangent) return say(Kind::on, tr_names("{both} touch, one inside the other"));
    switch (*answer.relation) {
      case Relation::disjoint:
        return say(Kind::no, tr_names("{both} are disjoint"));
      case Relation::touching:
        return say(Kind::on, tr_names("{both} touch"));
      case Relation::equal:
        return say(Kind::yes, tr_names("{both} are equal"));
      case Relation::b_inside_a:
        return say(Kind::yes, tr_names("{b} lies in {a}"));
      case Relation::a_inside_b:
        return say(Kind::yes, tr_names("{a} lies in {b}"));
      case Relation::overlapping:
        return say(Kind::yes, tr_names("{both} overlap"));
    }
  }

  // A point.

  void location() const {
    if (answer.location == Location::in) say(Kind::yes, tr_names("{a} lies inside {b}"));
    if (answer.location == Location::on) say(Kind::on, tr_names("{a} lies on the boundary of {b}"));
    if (answer.location == Location::out) say(Kind::no, tr_names("{a} lies outside {b}"));
  }
  void on_thin() const {
    answer.meet ? say(Kind::on, tr_names("{a} lies on {b}")) : say(Kind::no, tr_names("{a} does not lie on {b}"));
  }
  void beside_line() const {
    if (answer.meet) return on_thin();
    if (answer.side == 0) return say(Kind::no, tr_names("{a} lies in line with {b}, beyond its end"));
    say(Kind::no, answer.side > 0 ? tr_names("{a} lies left of {b}") : tr_names("{a} lies right of {b}"));
  }
  /// Says that something lies to one side of a plane, or in it.
  void beside_plane(const std::string& one, const std::string& plane) const {
    if (answer.coplanar) return say(Kind::on, tr("{a} lies in {plane}", {{"a", one}, {"plane", plane}}));
    say(Kind::no,
        answer.side > 0
            ? tr("{a} lies beside {plane}, where its normal points", {{"a", one}, {"plane", plane}})
            : tr("{a} lies beside {plane}, on the side that its normal leaves", {{"a", one}, {"plane", plane}}));
  }
  void point() const {
    switch (b.type()) {
      case Type::point:
        return answer.meet ? say(Kind::yes, tr_names("{both} coincide")) : say(Kind::no, tr_names("{both} differ"));
      case Type::plane:
        return beside_plane(na, nb);
      case Type::ray:
      case Type::line:
      case Type::segment:
        return a.flat() ? beside_line() : on_thin();
      case Type::triangle:
      case Type::polygon:
        return a.flat() ? location() : on_thin();
      default:
        return location();
    }
  }

  // A plane.

  void two_planes() const {
    if (answer.relation == Relation::equal) return say(Kind::on, tr_names("{both} are the same"));
    if (answer.parallel) return say(Kind::no, tr_names("{both} are parallel"));
    say(Kind::yes, a.flat() ? tr_names("{both} meet in a point") : tr_names("{both} meet in a line"));
  }
  void plane() const {
    if (b.type() == Type::plane) return two_planes();
    const bool cut = answer.relation == Relation::overlapping;
    if (cut && b.type() == Type::cloud) return say(Kind::yes, tr_names("{b} has points on both sides of {a}"));
    if (cut) return say(Kind::yes, tr_names("{a} cuts {b}"));
    if (answer.side && (answer.coplanar || !answer.meet)) return beside_plane(nb, na);
    relation();
  }

  // Rays, lines and segments.

  void hit(const char* name, double t, viz::Mark mark) const {
    if (std::isinf(t)) return;
    const NamedValues& s = a.numbers;
    const bool segment = a.type() == Type::segment;
    const Vec3 from = s.point(a.object, segment ? "from" : "origin"),
               along = segment ? Vec3(s.point(a.object, "to") - from) : s.point(a.object, "dir"), at = from + t * along;
    out.values.push_back({name, t, "t", Role::hit, true});
    if (at.allFinite()) out.marks.push_back(viz::Dot{at, mark, Role::hit});
  }
  void hits() const {
    if (answer.part && !answer.tangent) {
      hit("*t*_{in}", answer.part->lo, viz::Mark::disc);
      hit("*t*_{out}", answer.part->hi, viz::Mark::ring);
    } else if (answer.t) {
      hit("*t*", *answer.t, viz::Mark::disc);
    }
    for (const viz::Value& v : out.values)
      out.formula += fmt::format("{}{} = {}", out.formula.empty() ? "" : ", ", v.name, viz::shown(v.value));
  }
  void two_lines() const {
    if (answer.meet)
      return say(Kind::yes,
                 answer.one_point ? tr_names("{both} have one point in common") : tr_names("{both} share a stretch"));
    if (!answer.coplanar) return say(Kind::no, tr_names("{both} are skew"));
    say(Kind::no, answer.parallel ? tr_names("{both} are parallel") : tr_names("{a} misses {b}"));
  }
  void line() const {
    hits();
    if (runs_along_a_line(b.type())) return two_lines();
    const bool outline = b.type() == Type::triangle || b.type() == Type::polygon;
    if (b.type() == Type::plane && answer.coplanar) return say(Kind::on, tr_names("{a} lies in {b}"));
    if (b.type() == Type::mesh && !answer.meet)
      return say(Kind::no, tr_names("{a} meets no triangle of {b}"));  // it may lie within
    if (answer.meet && answer.tangent) return say(Kind::on, tr_names("{a} meets {b} in one point"));
    if (answer.meet && answer.location == Location::on) return say(Kind::on, tr_names("{a} meets {b} on its boundary"));
    const bool in_plane = outline && answer.coplanar;
    if (answer.meet)
      return say(Kind::yes, in_plane ? tr_names("{a} meets {b}, in whose plane it lies") : tr_names("{a} meets {b}"));
    say(Kind::no, in_plane ? tr_names("{a} misses {b}, in whose plane it lies") : tr_names("{a} misses {b}"));
  }

  /// The solid that a mesh bounds counts where none of its triangles is met, and is noted beside them.
  void mesh() const {
    const int met = *answer.triangles;
    if (met == 0 && answer.relation) return relation();
    if (answer.relation == Relation::touching) out.note = tr("As solids they touch.");
    if (answer.relation == Relation::overlapping) out.note = tr("As solids they overlap.");
    if (answer.relation == Relation::equal) out.note = tr("As solids they are equal.");
    if (answer.relation == Relation::b_inside_a) out.note = tr_names("{b} lies in the solid that {a} bounds.");
    if (answer.relation == Relation::a_inside_b) out.note = tr_names("The solid that {a} bounds lies in {b}.");
    met > 0 ? say(Kind::yes, tr_count(a.object.fixed.triangles.size(), "{b} meets {met} of {n} triangles of {a}",
                                      "{b} meets {met} of {n} triangles of {a}",
                                      {{"a", na}, {"b", nb}, {"met", std::to_string(met)}}))
            : say(Kind::no, tr_names("{b} meets no triangle of {a}"));
    out.values = {{tr("triangles met"), static_cast<double>(met), "", Role::hit, true}};
  }
};

}  // namespace

std::string both_names(const Shaped& a, const Shaped& b) {
  return tr("{a} and {b}", {{"a", shown_name(a.object.name)}, {"b", shown_name(b.object.name)}});
}

void tell(const Shaped& a, const Shaped& b, Told& out) {
  if (!out.verdict.text.empty()) return;
  const VerdictWriter told = {a, b, out};
  if (a.type() == Type::point) return told.point();
  if (a.type() == Type::plane) return told.plane();
  if (runs_along_a_line(a.type())) return told.line();
  if (a.type() == Type::mesh) return told.mesh();
  told.relation();
}

void tell_cloud(const Shaped& a, const Shaped& b, const std::vector<Location>& where, Told& out) {
  /// Marks of points: filled inside, diamonds on the boundary, rings outside.
  struct Place {
    Location at;
    const char* word;
    viz::Mark mark;
    Role role;
  };
  constexpr Place places[] = {{Location::out, "out", viz::Mark::ring, Role::miss},
                              {Location::in, "in", viz::Mark::disc, Role::hit},
                              {Location::on, "on", viz::Mark::diamond, Role::hit}};
  out.result = {{"in", Json::array()}, {"on", Json::array()}, {"out", Json::array()}};
  for (const Place& place : places)
    for (std::size_t i = 0; i < where.size(); ++i)
      if (where[i] == place.at) {
        out.result[place.word].push_back(static_cast<int>(i));
        out.marks.push_back(viz::Dot{a.points()[i], place.mark, place.role});
      }
  const std::size_t in = out.result["in"].size(), on = out.result["on"].size();
  out.verdict = {
      in > 0   ? Verdict::Kind::yes
      : on > 0 ? Verdict::Kind::on
               : Verdict::Kind::no,
      tr_count(
          in, "{n} of {all} points of {a} lies inside {b}", "{n} of {all} points of {a} lie inside {b}",
          {{"all", std::to_string(where.size())}, {"a", shown_name(a.object.name)}, {"b", shown_name(b.object.name)}})};
  if (on > 0) out.verdict.text += tr_count(on, ", {n} on its boundary", ", {n} on its boundary");
  const std::string unit = tr("points");
  out.values = {{tr("inside"), static_cast<double>(in), unit, Role::hit, true},
                {tr("on the boundary"), static_cast<double>(on), unit, Role::hit, true},
                {tr("outside"), static_cast<double>(where.size() - in - on), unit, Role::miss, true}};
}

void tell_cloud_on(const Shaped& a, const Shaped& b, const std::vector<Location>& where, Told& out) {
  tell_cloud(a, b, where, out);
  out.result.erase("in");
  const std::size_t on = out.result["on"].size();
  constexpr viz::Message at_point =
      viz::message_count("{n} of {all} points of {a} is {b}", "{n} of {all} points of {a} are {b}");
  constexpr viz::Message in_cloud =
      viz::message_count("{n} of {all} points of {a} is also in {b}", "{n} of {all} points of {a} are also in {b}");
  constexpr viz::Message on_thing =
      viz::message_count("{n} of {all} points of {a} lies on {b}", "{n} of {all} points of {a} lie on {b}");
  out.verdict.text = tr_count(
      on,
      b.type() == Type::point   ? at_point
      : b.type() == Type::cloud ? in_cloud
                                : on_thing,
      {{"all", std::to_string(where.size())}, {"a", shown_name(a.object.name)}, {"b", shown_name(b.object.name)}});
  out.values = {{tr("on it"), static_cast<double>(on), tr("points"), Role::hit, true},
                {tr("beside it"), static_cast<double>(where.size() - on), tr("points"), Role::miss, true}};
}

}  // namespace isect::program::scene
