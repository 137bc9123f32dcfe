// What the parameters say, and what is true of it: the core decides.

#include <cmath>
#include <limits>

#include <isect/interval_interval.h>
#include "lessons/moving_bodies/picture.h"
#include "lessons/shared/parameters.h"

namespace isect::lessons::moving_bodies_lesson {

using namespace viz;

namespace {

constexpr double no_end = std::numeric_limits<double>::infinity();

/// Whether boxes that meet do so with boundary points alone, as one slides along a face of the other.
bool slides(const Moving<Aabb, double, 2>& a, const Moving<Aabb, double, 2>& b) {
  for (int i = 0; i < 2; ++i)
    if (a.velocity[i] == b.velocity[i] && relate(a.shape.along(i), b.shape.along(i)) == Relation::touching) return true;
  return false;
}

void judge_boxes(Setup& s) {
  const Moving<Aabb, double, 2> a = s.box_a(), b = s.box_b();
  s.touching = relate(a.shape, b.shape) == Relation::touching;
  s.first = first_contact(a, b, s.duration);
  s.truth = intersects(a.shape, b.shape) ? Meeting::at_first
            : s.v_a == s.v_b             ? Meeting::rest
            : !s.first                   ? (s.without_end() ? Meeting::late : Meeting::past)
            : slides(a, b)               ? Meeting::grazing
                                         : Meeting::met;
}

void judge_balls(Setup& s) {
  const Moving<Sphere, double, 2> a = s.ball_a(), b = s.ball_b();
  Record<motion::Event<double, 2>> record;
  s.first = first_contact(a, b, s.duration, record);
  for (const auto& event : record.events)
    if (const auto* e = std::get_if<motion::Approach>(&event)) s.signs = *e;
  s.touching = s.signs.apart == 0;
  s.truth = s.signs.apart <= 0                                  ? Meeting::at_first
            : s.v_a == s.v_b                                    ? Meeting::rest
            : s.signs.receding >= 0 || s.signs.discriminant < 0 ? Meeting::past
            : !s.first                                          ? Meeting::late
            : s.signs.discriminant == 0                         ? Meeting::grazing
                                                                : Meeting::met;
}

}  // namespace

std::optional<Interval<double>> Setup::without_end() const { return contact(box_a(), box_b(), no_end); }

std::optional<double> Setup::first_without_end() const {
  return balls() ? first_contact(ball_a(), ball_b(), no_end) : first_contact(box_a(), box_b(), no_end);
}

Setup setup(const Parameters& p) {
  const auto number = [&](const char* name) { return std::get<double>(p.at(name)); };
  Setup s;
  s.method = std::get<std::string>(p.at("method"));
  s.a = flat_point(p, "a"), s.b = flat_point(p, "b");
  s.v_a = flat_point(p, "v_a"), s.v_b = flat_point(p, "v_b");
  s.r_a = number("r_a"), s.r_b = number("r_b"), s.duration = number("duration");
  s.tests = static_cast<int>(std::round(number("tests")));
  s.tolerance = number("tolerance");
  s.bound = std::get<std::string>(p.at("bound")) == "speed" ? motion::Bound::speed : motion::Bound::along_centers;
  if (s.balls())
    judge_balls(s);
  else
    judge_boxes(s);
  if (s.method == "discrete" && (s.truth == Meeting::met || s.truth == Meeting::grazing) &&
      discrete_hits(s.box_a(), s.box_b(), s.duration, s.tests).empty())
    s.truth = Meeting::unseen;
  return s;
}

}  // namespace isect::lessons::moving_bodies_lesson
