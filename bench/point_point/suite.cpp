// Point against point: whether they are the same, and whether they are near.

#include <isect/point_point.h>

#include <isect/methods/point_point.h>
#include "bench/pair_contest.h"
#include "bench/point_point/families.h"
#include "bench/rational.h"
#include "bench/session.h"

namespace isect::bench::point_point_suite {
namespace {

template <class S>
using Case = Points<S, 3>;

template <class S>
oracle::Rational distance2(const Case<S>& c) {
  using oracle::operator-;
  const auto f = oracle::rational<S, 3>(c.p) - oracle::rational<S, 3>(c.q);
  return oracle::dot(f, f);
}

/// A fixed tolerance, which many use to be on the safe side of rounding, is also entered: it calls points that differ
/// the same.
template <class S>
void same(Session& session, const NamedDraw<Case<S>>& drawn) {
  Contest<S, Case<S>> contest(session, family_of<S, Case<S>>("point-point", drawn, [](const Case<S>& c) -> Truth {
                                return {finite(c.p) && finite(c.q) && distance2(c) == 0, {}};
                              }));
  contest.enter("==", [](const Case<S>& c) { return c.p == c.q; }).standard();
  contest.enter("within 1e-6", [](const Case<S>& c) { return point_point::near_by_coordinates(c.p, c.q, S(1e-6)); });
  contest.enter("exact", [](const Case<S>& c) { return equal(c.p, c.q); }).exact();
  contest.run();
}

template <class S>
void near(Session& session, const NamedDraw<Case<S>>& drawn) {
  namespace methods = point_point;
  Contest<S, Case<S>> contest(
      session, family_of<S, Case<S>>("point-point, within a tolerance", drawn, [](const Case<S>& c) -> Truth {
        if (!finite(c.p) || !finite(c.q) || !(c.tolerance >= 0)) return {};
        return {
            std::isinf(c.tolerance) || distance2(c) <= oracle::Rational(c.tolerance) * oracle::Rational(c.tolerance),
            {}};
      }));
  contest.enter("squares", [](const Case<S>& c) { return methods::near_by_squares(c.p, c.q, c.tolerance); }).standard();
  contest.enter("root", [](const Case<S>& c) { return methods::near_by_distance(c.p, c.q, c.tolerance); });
  contest.enter("by coordinate", [](const Case<S>& c) { return methods::near_by_coordinates(c.p, c.q, c.tolerance); });
  contest.enter("exact", [](const Case<S>& c) { return nearly_equal(c.p, c.q, c.tolerance); })
      .exact()
      .fallback([](const Case<S>& c) {
        return fell_back([&](const auto& trace) { nearly_equal(c.p, c.q, c.tolerance, trace); });
      });
  contest.run();
}

template <class S>
void measure_all(Session& session) {
  for (const NamedDraw<Case<S>>& drawn : point_point_draws<S>) {
    const std::string_view name = drawn.name;
    if (name != "near-tolerance" && name != "scale") same<S>(session, drawn);
  }
  for (const NamedDraw<Case<S>>& drawn : point_point_draws<S>) {
    const std::string_view name = drawn.name;
    if (name != "ulp-apart") near<S>(session, drawn);
  }
}

}  // namespace

void measure(Session& session) {
  session.aim_on_hard_input("point-point");
  session.aim_on_hard_input("point-point, within a tolerance");
  measure_all<double>(session);
  measure_all<float>(session);
}

}  // namespace isect::bench::point_point_suite
