// Point against cylinder: whether it lies in it, by its projection onto the axis, and exactly.

#include <isect/point_cylinder.h>

#include <isect/methods/point_cylinder.h>
#include "bench/pair_contest.h"
#include "bench/point_cylinder/families.h"
#include "bench/point_cylinder/oracle.h"
#include "bench/session.h"

namespace isect::bench::point_cylinder_suite {
namespace {

template <class S>
using Case = PointAndSolid<S, Cylinder<S>>;

template <class S>
void compete(Session& session, const NamedDraw<Case<S>>& drawn) {
  namespace methods = point_cylinder;
  Contest<S, Case<S>> contest(session, family_of<S, Case<S>>("point-cylinder", drawn, [](const Case<S>& c) -> Truth {
                                return truth_of(oracle::locate(c.a, c.b));
                              }));
  contest.enter("projected", [](const Case<S>& c) { return methods::projected(c.a, c.b); }).standard();
  if constexpr (std::is_same_v<S, float>)
    contest.enter("projected in double", [](const Case<S>& c) {
      return methods::projected(Point<double, 3>(c.a.template cast<double>()), cast<double>(c.b));
    });
  contest.enter("exact", [](const Case<S>& c) { return locate(c.a, c.b); }).exact().fallback([](const Case<S>& c) {
    return fell_back([&](const auto& trace) { locate(c.a, c.b, trace); });
  });
  contest.run();
}

}  // namespace

void measure(Session& session) {
  session.aim(
      {.work = "point-cylinder: wrong verdicts", .kind = Target::wrong, .test = "point-cylinder", .at_most = 0});
  for (const auto& drawn : point_cylinder_draws<double>) compete<double>(session, drawn);
  for (const auto& drawn : point_cylinder_draws<float>) compete<float>(session, drawn);
}

}  // namespace isect::bench::point_cylinder_suite
