// Ray against cylinder: where the ray enters, by the side's quadratic, and exactly.

#include <isect/ray_cylinder.h>

#include <isect/methods/ray_cylinder.h>
#include "bench/pair_contest.h"
#include "bench/ray_cylinder/families.h"
#include "bench/ray_cylinder/oracle.h"
#include "bench/session.h"

namespace isect::bench::ray_cylinder_suite {
namespace {

template <class S>
using Case = RayAndSolid<S, Cylinder<S>>;

template <class S>
Truth truth(const Case<S>& c) {
  if (!oracle::meets(c.a, c.b)) return {};
  const double lo = c.a.range.lo;
  const oracle::LineInConvex line = oracle::line_in(c.a, c.b);
  return {1, oracle::Real{line.holds(oracle::Rational(lo)) ? lo : line.passes_at(false), 0}};
}

template <class S>
void compete(Session& session, const NamedDraw<Case<S>>& drawn) {
  namespace methods = ray_cylinder;
  Contest<S, Case<S>> contest(session, family_of<S, Case<S>>("ray-cylinder", drawn, truth<S>));
  contest.enter("quadratic", [](const Case<S>& c) { return methods::quadratic(c.a, c.b); }).standard();
  if constexpr (std::is_same_v<S, float>)
    contest.enter("quadratic in double", [](const Case<S>& c) {
      const std::optional<double> t = methods::quadratic(cast<double>(c.a), cast<double>(c.b));
      return t ? std::optional<S>(static_cast<S>(*t)) : std::nullopt;
    });
  contest.enter("exact", [](const Case<S>& c) { return first_hit(c.a, c.b); }).exact().fallback([](const Case<S>& c) {
    return fell_back([&](const auto& trace) { first_hit(c.a, c.b, trace); });
  });
  contest.enter("exact, yes or no", [](const Case<S>& c) { return intersects(c.a, c.b); }).exact();
  contest.run();
}

}  // namespace

void measure(Session& session) {
  session.aim({.work = "ray-cylinder: wrong verdicts", .kind = Target::wrong, .test = "ray-cylinder", .at_most = 0});
  for (const auto& drawn : ray_cylinder_draws<double>) compete<double>(session, drawn);
  for (const auto& drawn : ray_cylinder_draws<float>) compete<float>(session, drawn);
}

}  // namespace isect::bench::ray_cylinder_suite
