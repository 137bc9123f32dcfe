#include "lessons/ray_triangle/telling.h"

#include <Eigen/Geometry>
#include <cmath>

#include "lessons/shared/digits.h"
#include "lessons/shared/questions.h"
#include "viz/text/rich_text.h"

namespace isect::lessons::ray_triangle_lesson {

using namespace viz;

namespace {

/// What the vertices of the example carry.
constexpr double carried[] = {1, 2, 5};

Verdict::Kind kind_of(const Setup& s) {
  if (!s.truth.t) return Verdict::Kind::no;
  return s.truth.location == Location::on ? Verdict::Kind::on : Verdict::Kind::yes;
}

/// Whether the part of the line that meets the triangle lies beyond the end of the segment.
bool too_far(const Setup& s) { return s.segment() && s.line && *s.line > 0; }

/// Whether the direction rises above the plane by less than a thousandth of its length.
bool nearly_parallel(const Setup& s) {
  const Vec3 e1 = (s.vertex(1) - s.vertex(0)).stableNormalized(), e2 = (s.vertex(2) - s.vertex(0)).stableNormalized();
  const Vec3 n = e1.cross(e2).stableNormalized();
  return std::abs(n.dot(s.ray.direction.stableNormalized())) < 1e-3;
}

}  // namespace

std::string verdict_text(const Setup& s) {
  const std::string the = "the " + s.what();
  if (s.truth.t)
    return fmt::format("{} {} at *t* = {}", the,
                       s.place() == Place::edge     ? "meets an edge of the triangle"
                       : s.place() == Place::vertex ? "meets a vertex of the triangle"
                                                    : "hits the triangle",
                       shown(*s.truth.t));
  if (s.flat) return "the triangle has no area";
  if (s.truth.coplanar) return the + " lies in the triangle's plane";
  if (s.heading == 0) return the + " is parallel to the triangle's plane";
  if (s.truth.location == Location::out) return "the line passes beside the triangle";
  return too_far(s) ? "the segment ends before the triangle" : "the triangle lies behind the " + s.what();
}

Teller::Teller(const Setup& s, const std::string& title, const std::string& source, std::vector<std::string> pseudocode)
    : PictureTeller(s, {source, fmt::format("A {} and a triangle in space: {}.", s.what(), plain(verdict_text(s))),
                        std::move(pseudocode), title}) {}

std::string Teller::unless(bool as_exactly, const std::string& truth) const {
  return as_exactly ? std::string() : "\nRounding decides wrongly here: exactly, " + truth + ".";
}

void Teller::parallel(int line, const std::string& name, double value) {
  const bool zero = value == 0;
  Step& step =
      add("parallel", "Parallel to the plane?", line,
          (zero ? "It is 0. The line has no single point in common with the plane, or the triangle has no plane."
                : "It is not 0: the line crosses the plane in one point.") +
              unless(zero == (s_.heading == 0), s_.heading == 0 ? "it is 0" : "it is not 0"));
  Script::decide(step, {name + " = 0", value, 0, zero, zero ? "no single point" : "one point in the plane"});
  if (!zero) script_.refuse(line, {line + 1});
}

void Teller::range(int line, double t, bool holds) {
  known_.crossing = true;
  const bool exactly = s_.truth.location == Location::out || s_.truth.t.has_value() == holds;
  Step& step =
      add("range", fmt::format("On the {}?", s_.what()), line,
          (holds   ? fmt::format("*t* belongs to the range of the {}.", s_.what())
           : t < 0 ? std::string("*t* is negative, and the points before **o** do not belong to the ") + s_.what() + "."
                   : std::string("*t* is larger than *t*_{max}, where the segment ends.")) +
              unless(exactly, verdict_text(s_)));
  Comparison asked = {"*t* < 0", t, 0, t < 0, fmt::format("{} the {}", holds ? "on" : "not on", s_.what())};
  if (s_.segment()) {
    const Comparison below = {"*t* < 0", t, 0, t < 0, ""},
                     above = {"*t* > *t*_{max}", t, s_.ray.range.hi, t > s_.ray.range.hi, ""};
    asked.text = below.text + " or " + above.text, asked.holds = !holds, asked.parts = {below, above};
  }
  Script::decide(step, asked);
  if (holds) script_.refuse(line, {line + 1});
}

void Teller::end(int line) {
  known_.settled = known_.crossing = true;
  known_.edge = -1;
  script_.settle(kind_of(s_), verdict_text(s_));
  const bool right = found_.has_value() == s_.truth.t.has_value();
  const std::string told = right ? reason() : "Rounding misleads this method: exactly, " + verdict_text(s_) + ".";
  if (!found_) {
    script_.leave_early();
    add("miss", "No hit", script_.walk().steps.back().line + 1, told);
    return;
  }
  script_.value("*t*", found_->t.value, {}, Role::hit);
  script_.value("*u*", found_->u.value), script_.value("*v*", found_->v.value);
  const double t = found_->t.value;
  const bool digits_lost = right && std::abs(t - *s_.truth.t) > 1e-6 * std::abs(*s_.truth.t);
  add("hit", "The hit", line,
      told + (digits_lost ? fmt::format("\nRounding has cost *t* digits: exactly it is {}. {}, so small errors grow.",
                                        digits(*s_.truth.t, t),
                                        nearly_parallel(s_) ? "The line is nearly parallel to the plane"
                                                            : "The sums that make it nearly cancel")
                          : std::string()),
      "*t* = " + shown(t));
  if (right) interpolate(line);
}

void Teller::interpolate(int line) {
  const double u = found_->u.value, v = found_->v.value, w = 1 - u - v;
  const double mixed = w * carried[0] + u * carried[1] + v * carried[2];
  Step& step = add("weights", "What the weights are for", line,
                   "Renderers mix whatever the vertices carry by these weights: normals, colours, texture "
                   "coordinates.\nThe value varies linearly over the triangle. Neighbours with the same values at two "
                   "common vertices agree on the edge between them. A mixed normal must be normalised again.\n1 − *u* "
                   "− *v*, *u* and *v* are the barycentric coordinates of the point.",
                   fmt::format("(1 − *u* − *v*) · {} + *u* · {} + *v* · {} = {}", shown(carried[0]), shown(carried[1]),
                               shown(carried[2]), shown(mixed)));
  if (s_.place() == Place::vertex) return;  // no weights to mix
  step.question = which_value(fmt::format("A value is {} at **a**, {} at **b** and {} at **c**. What is it at the hit?",
                                          shown(carried[0]), shown(carried[1]), shown(carried[2])),
                              mixed,
                              {{(carried[0] + carried[1] + carried[2]) / 3,
                                "That gives all vertices one weight: it is the value at the centroid."},
                               {w * carried[0] + v * carried[1] + u * carried[2],
                                "That exchanges the weights: *u* belongs to **b**, and *v* to **c**."},
                               {u * carried[1] + v * carried[2], "That leaves out **a**, of weight 1 − *u* − *v*."}},
                              "*u* is the weight of **b**, *v* that of **c**, and what is left of 1 that of **a**.");
}

std::string Teller::reason() const {
  const Place place = s_.place();
  if (s_.truth.t)
    return place == Place::edge
               ? "The point lies on an edge. A triangle includes its edges, so this is a hit. The weight of the "
                 "vertex opposite is 0."
           : place == Place::vertex
               ? "The point is a vertex. A triangle includes its vertices, so this is a hit; two weights are 0."
               : "No weight is negative, so the point lies in the triangle; and *t* lies in the range.";
  if (s_.flat)
    return "The three vertices lie on one line. Such a triangle has no plane, and the exact test says: no hit.";
  if (s_.truth.coplanar)
    return "The line lies in the triangle's plane, so that no single *t* can be told.\n"
           "The exact test calls this coplanar, and no hit; for a whole plane the lesson on rays says HIT.\n"
           "Where the line crosses the triangle is a question in the plane.";
  if (s_.heading == 0) return "The line is parallel to the triangle's plane, and has no point in common with it.";
  if (place >= Place::beyond_bc && place <= Place::beyond_ab)
    return fmt::format("The weight of {} is negative: the line crosses the plane beyond the edge {}.",
                       vertex_names[static_cast<int>(place) - static_cast<int>(Place::beyond_bc)],
                       edge_names[static_cast<int>(place) - static_cast<int>(Place::beyond_bc)]);
  if (place >= Place::beyond_a && place <= Place::beyond_c)
    return fmt::format("Two weights are negative: the line crosses the plane beyond the vertex {}.",
                       vertex_names[static_cast<int>(place) - static_cast<int>(Place::beyond_a)]);
  return too_far(s_) ? "The line meets the triangle, but the segment ends before it."
                     : fmt::format("The line meets the triangle behind **o**, where the {} does not go.", s_.what());
}

}  // namespace isect::lessons::ray_triangle_lesson
