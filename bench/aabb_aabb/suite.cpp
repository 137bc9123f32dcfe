// Axis-aligned box against box, one pair at a time and one against many.

#include <isect/aabb_aabb.h>

#include <isect/many/batch_aabb.h>
#include <isect/methods/aabb_aabb.h>
#include "bench/aabb_aabb/families.h"
#include "bench/aabb_aabb/oracle.h"
#include "bench/pair_contest.h"
#include "bench/session.h"
#ifdef ISECT_PEERS
#include "bench/aabb_aabb/peers.h"
#endif

namespace isect::bench::aabb_aabb_suite {
namespace {

template <class S>
using Case = Boxes<S, 3>;

template <class S>
Truth truth(const Case<S>& c) {
  return {finite(c.a) && finite(c.b) && oracle::by_points(c.a, c.b) != Relation::disjoint, {}};
}

template <class S>
void compete(Session& session, const NamedDraw<Case<S>>& drawn) {
  namespace methods = aabb_aabb;
  Contest<S, Case<S>> contest(session, family_of<S, Case<S>>("aabb-aabb", drawn, truth<S>));
  contest.enter("axis by axis", [](const Case<S>& c) { return methods::by_axis(c.a, c.b); }).standard();
  contest.enter("min, max", [](const Case<S>& c) { return methods::min_max(c.a, c.b); });
  contest.enter("centers", [](const Case<S>& c) { return methods::by_centers(c.a, c.b); });
  enter_exact(contest);
#ifdef ISECT_PEERS
  peers::aabb_aabb<S>(contest);
#endif
  contest.run();
}

/// One box against 65,536 around it.
template <class S>
void one_box(Session& session) {
  const Aabb<S, 3> box = {{S(-0.4), S(-0.5), S(-0.3)}, {S(0.5), S(0.3), S(0.4)}};
  const NamedDraw<Case<S>> drawn = {
      "ordinary", [](Random& random) -> Case<S> {
        return {{{S(-0.4), S(-0.5), S(-0.3)}, {S(0.5), S(0.3), S(0.4)}}, ordinary_box<S>(random)};
      }};
  Contest<S, Case<S>> contest(session, family_of<S, Case<S>>("aabb-aabb, one box", drawn, truth<S>));
  contest.enter("axis by axis", [box](const Case<S>& c) { return aabb_aabb::by_axis(box, c.b); }).standard();
  contest.enter("exact", [box](const Case<S>& c) { return intersects(box, c.b); }).exact();

  std::array<std::vector<S>, 6> columns;
  for (const Case<S>& c : contest.cases())
    for (int k = 0; k < 3; ++k) columns[k].push_back(c.b.lo[k]), columns[3 + k].push_back(c.b.hi[k]);
  const BoxBatch<S, 3> batch = {{{columns[0], columns[1], columns[2]}}, {{columns[3], columns[4], columns[5]}}};
  const Mask answers = intersects(box, batch);
  contest
      .enter_pass(
          "batch",
          [&] {
            const Mask mask = intersects(box, batch);
            asm volatile("" : : "r"(&mask) : "memory");
          },
          [&](std::size_t i) { return said(answers[i]); })
      .exact();
#ifdef ISECT_PEERS
  peers::eigen_aabb_aabb<S>(contest);
#endif
  contest.run();
}

}  // namespace

void measure(Session& session) {
  session.aim({.work = "aabb-aabb", .test = "aabb-aabb", .theirs = "Eigen", .at_most = 0.4});
  session.aim(
      {.work = "aabb-aabb, float",
       .test = "aabb-aabb",
       .theirs = "Eigen",
       .scalar = "float",
       .at_most = 0.4,
       .limit = "Minima and maxima alone take half of it, 0.2 × Eigen; that no box is inverted, the other half."});
  session.aim({.work = "one AABB, many AABBs",
               .test = "aabb-aabb, one box",
               .ours = "batch",
               .theirs = "Eigen",
               .at_most = 0.06,
               .limit = "A box is 48 bytes. To read those alone, from beyond the cache of the second level, would be "
                        "some 0.09 × Eigen."});
  session.aim_on_hard_input("aabb-aabb");
  for (const auto& drawn : aabb_aabb_draws<double>) compete<double>(session, drawn);
  for (const auto& drawn : aabb_aabb_draws<float>) compete<float>(session, drawn);
  one_box<double>(session);
  one_box<float>(session);
}

}  // namespace isect::bench::aabb_aabb_suite
