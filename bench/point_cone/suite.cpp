// Point against cone: whether it lies in it, by its height over the apex, and exactly.

#include <isect/point_cone.h>

#include <isect/methods/point_cone.h>
#include "bench/pair_contest.h"
#include "bench/point_cylinder/families.h"
#include "bench/point_cylinder/oracle.h"
#include "bench/session.h"

namespace isect::bench::point_cone_suite {
namespace {

template <class S>
using Case = PointAndSolid<S, Cone<S>>;

template <class S>
void compete(Session& session, const NamedDraw<Case<S>>& drawn) {
  namespace methods = point_cone;
  Contest<S, Case<S>> contest(session, family_of<S, Case<S>>("point-cone", drawn, [](const Case<S>& c) -> Truth {
                                return truth_of(oracle::locate(c.a, c.b));
                              }));
  contest.enter("by_height", [](const Case<S>& c) { return methods::by_height(c.a, c.b); }).standard();
  if constexpr (std::is_same_v<S, float>)
    contest.enter("by_height in double", [](const Case<S>& c) {
      return methods::by_height(Point<double, 3>(c.a.template cast<double>()), cast<double>(c.b));
    });
  contest.enter("exact", [](const Case<S>& c) { return locate(c.a, c.b); }).exact().fallback([](const Case<S>& c) {
    return fell_back([&](const auto& trace) { locate(c.a, c.b, trace); });
  });
  contest.run();
}

}  // namespace

void measure(Session& session) {
  session.aim({.work = "point-cone: wrong verdicts", .kind = Target::wrong, .test = "point-cone", .at_most = 0});
  for (const auto& drawn : point_cone_draws<double>) compete<double>(session, drawn);
  for (const auto& drawn : point_cone_draws<float>) compete<float>(session, drawn);
}

}  // namespace isect::bench::point_cone_suite
