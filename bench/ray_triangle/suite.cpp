// Ray against triangle: where the ray meets it, and whether it slips between two triangles that share an edge.

#include <isect/ray_triangle.h>

#include <isect/methods/ray_triangle.h>
#include "bench/pair_contest.h"
#include "bench/ray_triangle/families.h"
#include "bench/ray_triangle/oracle.h"
#include "bench/ray_triangle/shared_edges.h"
#include "bench/session.h"
#ifdef ISECT_PEERS
#include "bench/ray_triangle/peers.h"
#endif

namespace isect::bench::ray_triangle_suite {
namespace {

template <class S>
using Case = RayAndTriangle<S>;

/// t = n.(a - o) / n.d: each sum magnifies an error by the sizes of its terms over its own.
template <class S>
Truth truth(const Case<S>& c) {
  const oracle::RayTriangle meeting = oracle::ray_triangle(c.a, c.b);
  if (!meeting.hit) return {};
  const oracle::Real t = oracle::real(meeting.t);
  const Triangle<double, 3> x = cast<double>(c.b);
  const Vector<double, 3> n = (x.vertices[1] - x.vertices[0]).cross(x.vertices[2] - x.vertices[0]),
                          d = c.a.direction.template cast<double>();
  const double along = std::abs(n.dot(d)), sizes = n.norm() * (x.vertices[0].norm() + c.a.origin.norm());
  return {1, t, sizes / (std::abs(t.nearest) * along) + n.norm() * d.norm() / along};
}

template <class S>
std::optional<S> t_of(const std::optional<ray_triangle::Hit<S>>& hit) {
  return hit ? std::optional<S>(hit->t) : std::nullopt;
}

template <class S>
void compete(Session& session, const NamedDraw<Case<S>>& drawn) {
  namespace methods = ray_triangle;
  CaseFamily<Case<S>> family = family_of<S, Case<S>>("ray-triangle", drawn, truth<S>);
  family.residual = [](const Case<S>& c, double t) { return oracle::off_plane(c.a, c.b, t); };
  Contest<S, Case<S>> contest(session, family);
  contest.enter("Möller, Trumbore", [](const Case<S>& c) { return t_of(methods::moller_trumbore(c.a, c.b)); })
      .standard();
  contest.enter("signed volumes", [](const Case<S>& c) { return t_of(methods::signed_volumes(c.a, c.b)); });
  contest.enter("Woop", [](const Case<S>& c) { return t_of(methods::woop(c.a, c.b)); });
  contest.enter("exact", [](const Case<S>& c) { return intersect(c.a, c.b).t; }).exact().fallback([](const Case<S>& c) {
    return fell_back([&](const auto& trace) { intersect(c.a, c.b, trace); });
  });
#ifdef ISECT_PEERS
  peers::ray_triangle<S>(contest, drawn.name);
#endif
  contest.run();
}

/// A no is a ray that slipped between the two.
template <class S>
void shared_edge(Session& session) {
  using Two = SharedEdge<S>;
  namespace methods = ray_triangle;
  const NamedDraw<Two> drawn = {"edge-aimed", ray_triangle_families::shared_edge<S>,
                                "rays towards the edge: a no slips between the two."};
  CaseFamily<Two> family = family_of<S, Two>("ray-triangle, two with one edge", drawn, [](const Two& c) -> Truth {
    return {oracle::ray_triangle(c.ray, c.left).hit || oracle::ray_triangle(c.ray, c.right).hit, {}};
  });
  Contest<S, Two> contest(session, family);
  const auto either = [](const auto& meets) {
    return [meets](const Two& c) -> bool { return meets(c.ray, c.left) || meets(c.ray, c.right); };
  };
  contest
      .enter("Möller, Trumbore",
             either([](const auto& ray, const auto& x) { return methods::moller_trumbore(ray, x).has_value(); }))
      .standard();
  contest.enter("signed volumes",
                either([](const auto& ray, const auto& x) { return methods::signed_volumes(ray, x).has_value(); }));
  contest.enter("Woop", either([](const auto& ray, const auto& x) { return methods::woop(ray, x).has_value(); }));
  contest.enter("exact", either([](const auto& ray, const auto& x) { return intersects(ray, x); })).exact();
  contest.run();
}

}  // namespace

void measure(Session& session) {
  session.aim({.work = "ray-triangle with t", .test = "ray-triangle", .theirs = "naive", .at_most = 1.3});
  session.aim_on_hard_input("ray-triangle");
  for (const auto& drawn : ray_triangle_draws<double>) compete<double>(session, drawn);
  for (const auto& drawn : ray_triangle_draws<float>) compete<float>(session, drawn);
  shared_edge<double>(session);
  shared_edge<float>(session);
}

}  // namespace isect::bench::ray_triangle_suite
