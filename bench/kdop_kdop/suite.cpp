// k-DOP against k-DOP: whether the slabs of two objects overlap, for k-DOPs made in three ways. The comparison is
// exact and the same for all; how the slabs were rounded decides.

#include <isect/kdop_kdop.h>

#include <isect/directions.h>
#include <isect/fit.h>
#include <isect/methods/kdop_kdop.h>
#include "bench/kdop_kdop/families.h"
#include "bench/pair_contest.h"
#include "bench/peer.h"
#include "bench/session.h"

namespace isect::bench::kdop_kdop_suite {
namespace {

template <class S>
using Case = Tetrahedra<S>;

template <class S>
Truth truth(const Case<S>& c) {
  static const std::vector<Vector<S, 3>> normals = directions<S, 3>(14);
  return {true_slabs_overlap(c, normals), {}};
}

/// Both k-DOPs are made before the clock starts.
template <class S, class Make>
Entrant<Case<S>>& enter(Contest<S, Case<S>>& contest, const char* method, const Make& make) {
  using Two = Pair<Kdop<S, 3>, Kdop<S, 3>>;
  return peers::enter(
      contest, "isect", method,
      [make](const Case<S>& c) -> Two {
        const auto of = [&](const std::array<Point<S, 3>, 4>& points) {
          return make(std::vector<Point<S, 3>>(points.begin(), points.end()));
        };
        return {of(c.a), of(c.b)};
      },
      [](const Two& c) { return may_intersect(c.a, c.b); });
}

/// Fitted slabs are rounded outwards: they overlap whenever the shapes touch, and may close a gap of an ulp.
template <class S>
void compete(Session& session, const NamedDraw<Case<S>>& drawn) {
  using Points = std::vector<Point<S, 3>>;
  const auto normals = directions<S, 3>(14), unit = kdop_kdop::unit_normals(normals);
  Contest<S, Case<S>> contest(session, family_of<S, Case<S>>("kdop-kdop", drawn, truth<S>, 1 << 14));
  enter(contest, "unit normals", [unit](const Points& p) { return kdop_kdop::rounded_kdop(p, unit); }).standard();
  enter(contest, "integer normals", [normals](const Points& p) { return kdop_kdop::rounded_kdop(p, normals); });
  enter(contest, "integer normals, outwards", [normals](const Points& p) { return fit_kdop(p, normals); });
  contest.run();
}

}  // namespace

void measure(Session& session) {
  for (const auto& drawn : kdop_kdop_draws<double>) compete<double>(session, drawn);
  for (const auto& drawn : kdop_kdop_draws<float>) compete<float>(session, drawn);
}

}  // namespace isect::bench::kdop_kdop_suite
