// Answers in words, values and marks.

#include <fmt/format.h>

#include <cmath>

#include "app/scene/pairs.h"
#include "viz/text/rich_text.h"

namespace isect::program::scene {

using viz::Role;
using viz::Vec3;
using viz::Verdict;

namespace {

/// Two objects, by name, with their answer.
struct VerdictWriter {
  using Kind = Verdict::Kind;

  const Shaped &a, &b;
  Told& out;
  const Answer& answer = out.answer;
  std::string na = shown_name(a.object.name), nb = shown_name(b.object.name), both = na + " and " + nb;

  void say(Kind kind, const std::string& text) const { out.verdict = {kind, text}; }

  // How two sets lie.

  void relation() const {
    if (!answer.relation)
      return answer.meet ? say(Kind::yes, both + " have a common point") : say(Kind::no, both + " are disjoint");
    const bool within = answer.relation == Relation::a_inside_b || answer.relation == Relation::b_inside_a;
    if (within && answer.tangent) return say(Kind::on, both + " touch, one inside the other");
    switch (*answer.relation) {
      case Relation::disjoint:
        return say(Kind::no, both + " are disjoint");
      case Relation::touching:
        return say(Kind::on, both + " touch");
      case Relation::equal:
        return say(Kind::yes, both + " are equal");
      case Relation::b_inside_a:
        return say(Kind::yes, nb + " lies in " + na);
      case Relation::a_inside_b:
        return say(Kind::yes, na + " lies in " + nb);
      case Relation::overlapping:
        return say(Kind::yes, both + " overlap");
    }
  }

  // A point.

  void location() const {
    if (answer.location == Location::in) say(Kind::yes, na + " lies inside " + nb);
    if (answer.location == Location::on) say(Kind::on, na + " lies on the boundary of " + nb);
    if (answer.location == Location::out) say(Kind::no, na + " lies outside " + nb);
  }
  void on_thin() const {
    answer.meet ? say(Kind::on, fmt::format("{} lies on {}", na, nb))
                : say(Kind::no, fmt::format("{} does not lie on {}", na, nb));
  }
  void beside_line() const {
    if (answer.meet) return on_thin();
    if (answer.side == 0) return say(Kind::no, fmt::format("{} lies in line with {}, beyond its end", na, nb));
    say(Kind::no, fmt::format("{} lies {} of {}", na, answer.side > 0 ? "left" : "right", nb));
  }
  /// Says that something lies to one side of a plane, or in it.
  void beside_plane(const std::string& one, const std::string& plane) const {
    if (answer.coplanar) return say(Kind::on, one + " lies in " + plane);
    say(Kind::no, fmt::format("{} lies beside {}, {}", one, plane,
                              answer.side > 0 ? "where its normal points" : "on the side that its normal leaves"));
  }
  void point() const {
    switch (b.type()) {
      case Type::point:
        return answer.meet ? say(Kind::yes, both + " coincide") : say(Kind::no, both + " differ");
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
    if (answer.relation == Relation::equal) return say(Kind::on, both + " are the same");
    if (answer.parallel) return say(Kind::no, both + " are parallel");
    say(Kind::yes, both + (a.flat() ? " meet in a point" : " meet in a line"));
  }
  void plane() const {
    if (b.type() == Type::plane) return two_planes();
    const bool cut = answer.relation == Relation::overlapping;
    if (cut && b.type() == Type::cloud) return say(Kind::yes, fmt::format("{} has points on both sides of {}", nb, na));
    if (cut) return say(Kind::yes, fmt::format("{} cuts {}", na, nb));
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
      return say(Kind::yes, both + (answer.one_point ? " have one point in common" : " share a stretch"));
    if (!answer.coplanar) return say(Kind::no, both + " are skew");
    say(Kind::no, answer.parallel ? both + " are parallel" : na + " misses " + nb);
  }
  void line() const {
    hits();
    if (runs_along_a_line(b.type())) return two_lines();
    const bool outline = b.type() == Type::triangle || b.type() == Type::polygon;
    const std::string met = na + (answer.meet ? " meets " : " misses ") + nb;
    if (b.type() == Type::plane && answer.coplanar) return say(Kind::on, na + " lies in " + nb);
    if (b.type() == Type::mesh && !answer.meet)
      return say(Kind::no, fmt::format("{} meets no triangle of {}", na, nb));  // it may lie within
    if (answer.meet && answer.tangent) return say(Kind::on, met + " in one point");
    if (answer.meet && answer.location == Location::on) return say(Kind::on, met + " on its boundary");
    say(answer.meet ? Kind::yes : Kind::no, met + (outline && answer.coplanar ? ", in whose plane it lies" : ""));
  }

  /// The solid that a mesh bounds counts where none of its triangles is met, and is noted beside them.
  void mesh() const {
    const int met = *answer.triangles;
    if (met == 0 && answer.relation) return relation();
    if (answer.relation == Relation::touching) out.note = "As solids they touch.";
    if (answer.relation == Relation::overlapping) out.note = "As solids they overlap.";
    if (answer.relation == Relation::equal) out.note = "As solids they are equal.";
    if (answer.relation == Relation::b_inside_a) out.note = fmt::format("{} lies in the solid that {} bounds.", nb, na);
    if (answer.relation == Relation::a_inside_b) out.note = fmt::format("The solid that {} bounds lies in {}.", na, nb);
    met > 0
        ? say(Kind::yes, fmt::format("{} meets {} of {} triangles of {}", nb, met, a.object.fixed.triangles.size(), na))
        : say(Kind::no, fmt::format("{} meets no triangle of {}", nb, na));
    out.values = {{"triangles met", static_cast<double>(met), "", Role::hit, true}};
  }
};

}  // namespace

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
  out.verdict = {in > 0   ? Verdict::Kind::yes
                 : on > 0 ? Verdict::Kind::on
                          : Verdict::Kind::no,
                 fmt::format("{} of {} points of {} {} inside {}", in, where.size(), shown_name(a.object.name),
                             in == 1 ? "lies" : "lie", shown_name(b.object.name))};
  if (on > 0) out.verdict.text += fmt::format(", {} on its boundary", on);
  out.values = {{"inside", static_cast<double>(in), "points", Role::hit, true},
                {"on the boundary", static_cast<double>(on), "points", Role::hit, true},
                {"outside", static_cast<double>(where.size() - in - on), "points", Role::miss, true}};
}

void tell_cloud_on(const Shaped& a, const Shaped& b, const std::vector<Location>& where, Told& out) {
  tell_cloud(a, b, where, out);
  out.result.erase("in");
  const std::size_t on = out.result["on"].size();
  const bool one = on == 1;
  const std::string place = b.type() == Type::point   ? one ? "is" : "are"
                            : b.type() == Type::cloud ? one ? "is also in" : "are also in"
                            : one                     ? "lies on"
                                                      : "lie on";
  out.verdict.text = fmt::format("{} of {} points of {} {} {}", on, where.size(), shown_name(a.object.name), place,
                                 shown_name(b.object.name));
  out.values = {{"on it", static_cast<double>(on), "points", Role::hit, true},
                {"beside it", static_cast<double>(where.size() - on), "points", Role::miss, true}};
}

}  // namespace isect::program::scene
