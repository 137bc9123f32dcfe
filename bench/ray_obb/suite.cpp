// Ray against oriented box: where the ray enters, by projections onto the axes, and exactly.

#include <isect/methods/ray_obb.h>
#include <isect/ray_obb.h>

#include "bench/pair_contest.h"
#include "bench/ray_obb/families.h"
#include "bench/ray_obb/oracle.h"
#include "bench/session.h"

namespace isect::bench::ray_obb_suite {
namespace {

template <class S>
using Case = RayAndObb<S>;

/// t is a difference over u.d: a relative error of the input moves it by the sizes of the terms, over that.
template <class S>
Truth truth(const Case<S>& c) {
  const auto ends = oracle::ray_obb(c.a, c.b);
  if (!ends) return {};
  const oracle::Real t = oracle::real(ends->first);
  const double along = std::abs(t.nearest) * c.a.direction.template cast<double>().stableNorm();
  const double sizes = static_cast<double>(c.a.origin.stableNorm()) + static_cast<double>(c.b.center.stableNorm()) +
                       static_cast<double>(c.b.half.stableNorm());
  return {1, t, 1 + 2 * sizes / along};
}

/// Where the ray enters.
template <class S>
std::optional<S> entry(const std::optional<Interval<S>>& part) {
  return part ? std::optional<S>(part->lo) : std::nullopt;
}

template <class S>
void compete(Session& session, const NamedDraw<Case<S>>& drawn) {
  namespace methods = ray_obb;
  Contest<S, Case<S>> contest(session, family_of<S, Case<S>>("ray-obb", drawn, truth<S>));
  contest.enter("projections", [](const Case<S>& c) { return entry(methods::projections(c.a, c.b)); }).standard();
  if constexpr (std::is_same_v<S, float>)
    contest.enter("projections in double",
                  [](const Case<S>& c) { return entry(methods::projections(cast<double>(c.a), cast<double>(c.b))); });
  contest.enter("exact", [](const Case<S>& c) { return entry(intersect(c.a, c.b)); })
      .exact()
      .fallback([](const Case<S>& c) { return fell_back([&](const auto& trace) { intersect(c.a, c.b, trace); }); });
  contest.enter("exact, yes or no", [](const Case<S>& c) { return intersects(c.a, c.b); }).exact();
  contest.run();
}

}  // namespace

void measure(Session& session) {
  session.aim_on_hard_input("ray-obb",
                            "A determinant of two axes and a difference, and t to 2 ulp, go up the ladder: two "
                            "doubles, three, 255 bits. No function takes a tenth of the time. The naive test leaves "
                            "at the first slab that the ray misses.");
  for (const auto& drawn : ray_obb_draws<double>) compete<double>(session, drawn);
  for (const auto& drawn : ray_obb_draws<float>) compete<float>(session, drawn);
}

}  // namespace isect::bench::ray_obb_suite
