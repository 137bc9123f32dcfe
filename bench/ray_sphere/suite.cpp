// Ray against sphere: the first hit on the surface, by the note's methods, the stable ones, the exact default and the
// batch.

#include <isect/ray_sphere.h>

#include <span>

#include <isect/many/batch_ray_sphere.h>
#include <isect/methods/ray_sphere.h>
#include <isect/methods/ray_sphere_stable.h>
#include "bench/contest.h"
#include "bench/rational.h"
#include "bench/ray_sphere/families.h"
#include "bench/session.h"
#ifdef ISECT_PEERS
#include "bench/ray_sphere/peers.h"
#endif

namespace isect::bench::ray_sphere_suite {
namespace {

template <class S>
using Case = RaySphereCase<S, 3>;

/// What rounding the input may do to the first hit: with the point p relative to the center, |p| = r, an error e of the
/// input moves t by p.e / p.d, and A times the half chord in t is |p.d|.
template <class S>
double condition(const Case<S>& c, const oracle::RaySphere& truth) {
  const double t = std::abs(truth.surface->nearest), length = c.ray.direction.template cast<double>().norm();
  const double half_chord =
      ((truth.t1.nearest - truth.t0.nearest) + (truth.t1.rest - truth.t0.rest)) / 2 * length * length;
  const double size = static_cast<double>(c.ray.origin.norm()) + static_cast<double>(c.sphere.center.norm()) +
                      t * length + static_cast<double>(c.sphere.radius);
  return static_cast<double>(c.sphere.radius) * size / (half_chord * t);
}

template <class S>
Truth truth(const Case<S>& c) {
  const oracle::RaySphere t = oracle::ray_sphere(c.ray, c.sphere);
  if (!t.surface) return {};
  return {1, t.surface, condition(c, t)};
}

/// (|p|^2 - r^2) / 2 r^2 for the point p at t, relative to the center, rounded once.
template <class S>
double residual(const Case<S>& c, double t) {
  using oracle::Rational, oracle::operator+, oracle::operator-, oracle::operator*;
  if (c.sphere.radius == 0) return 0;
  if (!std::isfinite(t)) return std::numeric_limits<double>::infinity();
  const auto p = oracle::rational<S, 3>(c.ray.origin) + Rational(t) * oracle::rational<S, 3>(c.ray.direction) -
                 oracle::rational<S, 3>(c.sphere.center);
  const Rational r2 = Rational(c.sphere.radius) * Rational(c.sphere.radius);
  return std::abs(static_cast<double>(Rational((oracle::dot(p, p) - r2) / (2 * r2))));
}

template <class S>
std::string full_precision(const Case<S>& c) {
  return text("origin", c.ray.origin, "direction", c.ray.direction, "range", std::array{c.ray.range.lo, c.ray.range.hi},
              "center", c.sphere.center, "radius", c.sphere.radius);
}

/// Haines' method needs a unit direction, so it is given one: that is part of its cost and of its error.
template <class S>
std::optional<S> haines(const Case<S>& c) {
  const S length = c.ray.direction.norm();
  const Ray<S, 3> unit = {c.ray.origin, c.ray.direction / length, {S(0), c.ray.range.hi * length}};
  const std::optional<S> along = ray_sphere::haines(unit, c.sphere);
  return along ? std::optional<S>(*along / length) : std::nullopt;
}

template <class S>
void compete(Session& session, const CaseFamily<Case<S>>& family) {
  Contest<S, Case<S>> contest(session, family);
  contest.enter("quadratic", [](const Case<S>& c) { return ray_sphere::quadratic(c.ray, c.sphere); }).standard();
  contest.enter("half-B", [](const Case<S>& c) { return ray_sphere::half_b(c.ray, c.sphere); });
  contest.enter("stable roots", [](const Case<S>& c) { return ray_sphere::stable_roots(c.ray, c.sphere); });
  contest.enter("Haines", haines<S>);
  contest.enter("robust", [](const Case<S>& c) { return ray_sphere::robust(c.ray, c.sphere); });
  contest.enter("exact", [](const Case<S>& c) { return intersect(c.ray, c.sphere).surface; })
      .exact()
      .fallback(
          [](const Case<S>& c) { return fell_back([&](const auto& trace) { intersect(c.ray, c.sphere, trace); }); });
#ifdef ISECT_PEERS
  peers::ray_sphere<S>(contest);
#endif
  contest.run();
}

template <class S>
void compete(Session& session, const char* name) {
  const RaySphereDraw<S, 3>& drawn = ray_sphere_family<S, 3>(name);
  compete<S>(session, {"ray-sphere", scalar_name<S>, drawn.name, drawn.note, drawn.hard(), drawn.draw, truth<S>,
                       full_precision<S>, residual<S>});
}

/// Ordinary rays, of which this percentage hit: a sign shows a miss, a hit costs a root.
template <class S>
void compete(Session& session, int hits) {
  const auto draw = [hits, any = ray_sphere_family<S, 3>("ordinary").draw](Random& random) -> Case<S> {
    const bool wanted = random.below(100) < hits;
    for (;;) {
      const Case<S> c = any(random);
      if (intersect(c.ray, c.sphere).surface.has_value() == wanted) return c;
    }
  };
  compete<S>(session, {"ray-sphere, " + (hits == 100 ? "all" : std::to_string(hits) + " %") + " hit", scalar_name<S>,
                       "ordinary", "", false, draw, truth<S>, full_precision<S>, residual<S>});
}

/// Ordinary rays, of which this percentage hit: yes or no alone.
template <class S>
void yes_or_no(Session& session, int hits) {
  const auto draw = [hits, any = ray_sphere_family<S, 3>("ordinary").draw](Random& random) -> Case<S> {
    const bool wanted = random.below(100) < hits;
    for (;;) {
      const Case<S> c = any(random);
      if (c.ray.range == semi_infinite<S> && intersects(c.ray, c.sphere) == wanted) return c;
    }
  };
  const auto truth = [](const Case<S>& c) -> Truth {
    return {oracle::ray_sphere(c.ray, c.sphere).enter.has_value(), {}};
  };
  Contest<S, Case<S>> contest(session,
                              {"ray-sphere, yes or no, " + (hits == 100 ? "all" : std::to_string(hits) + " %") + " hit",
                               scalar_name<S>, "ordinary", "", false, draw, truth, full_precision<S>});
  contest.enter("discriminant", [](const Case<S>& c) { return ray_sphere::by_discriminant(c.ray, c.sphere); })
      .standard();
  contest.enter("exact", [](const Case<S>& c) { return intersects(c.ray, c.sphere); }).exact();
  contest.run();
}

/// One ray against 65,536 spheres around it: which are hit.
template <class S>
void one_ray(Session& session) {
  const Ray<S, 3> ray = {{S(-3), S(0.1), S(0.2)}, {S(1), S(0.05), S(-0.1)}};
  const auto draw = [ray](Random& random) -> Case<S> {
    return {ray, {random.in_box<3>(1).template cast<S>(), static_cast<S>(random.uniform(0.2, 0.8))}};
  };
  const auto yes_no = [](const Case<S>& c) -> Truth {
    return {oracle::ray_sphere(c.ray, c.sphere).surface.has_value(), {}};
  };
  Contest<S, Case<S>> contest(
      session, {"ray-sphere, one ray", scalar_name<S>, "ordinary", "", false, draw, yes_no, full_precision<S>});
  contest.enter("quadratic", [ray](const Case<S>& c) { return ray_sphere::quadratic(ray, c.sphere).has_value(); })
      .standard();
  contest.enter("exact", [ray](const Case<S>& c) { return intersect(ray, c.sphere).surface.has_value(); }).exact();

  std::array<std::vector<S>, 4> columns;
  for (const Case<S>& c : contest.cases()) {
    for (int k = 0; k < 3; ++k) columns[k].push_back(c.sphere.center[k]);
    columns[3].push_back(c.sphere.radius);
  }
  const SphereBatch<S, 3> batch = {{{columns[0], columns[1], columns[2]}}, columns[3]};
  const Mask answers = hits(ray, batch);
  contest
      .enter_pass(
          "batch",
          [&] {
            const Mask mask = hits(ray, batch);
            asm volatile("" : : "r"(&mask) : "memory");
          },
          [&](std::size_t i) { return said(answers[i]); })
      .exact();
  contest.run();
}

}  // namespace

void measure(Session& session) {
  const std::string refined =
      "Doubles alone promise no t: the bounds of B and of the discriminant, 5 u and 32 u, are beyond 4 ulp by "
      "themselves. A step of Newton with C(t) in two doubles makes good for it, in some 90 operations.";
  session.aim({.work = "ray-sphere with t, ordinary rays",
               .test = "ray-sphere",
               .theirs = "naive",
               .at_most = 1.5,
               .limit = refined});
  session.aim({.work = "ray-sphere with t, 5 % hit",
               .test = "ray-sphere, 5 % hit",
               .theirs = "naive",
               .at_most = 1.5,
               .limit = "95 of 100 rays miss. The naive discriminant takes 24 operations; Lagrange's, which does not "
                        "cancel, takes 45 with its bound. Compiled for this machine the loop here takes half as long "
                        "again; why was not found: a loop of this call alone does not."});
  session.aim({.work = "ray-sphere with t, all hit",
               .test = "ray-sphere, all hit",
               .theirs = "naive",
               .at_most = 3,
               .limit = refined});
  session.aim({.work = "ray-sphere with t, ordinary rays, float",
               .test = "ray-sphere",
               .theirs = "naive",
               .scalar = "float",
               .at_most = 1.2,
               .limit =
                   "245 instructions, and 74 in the naive test: floats become doubles, Lagrange's discriminant gets "
                   "its bound, and t is divided in double."});
  for (const char* hits : {"5 %", "50 %", "all"})
    session.aim({.work = std::string("ray-sphere, yes or no, ") + hits + " hit",
                 .test = std::string("ray-sphere, yes or no, ") + hits + " hit",
                 .theirs = "naive",
                 .at_most = 1.3,
                 .limit = "80 instructions, 45 in the naive test: both bounds, the sizes and the range's ends are "
                          "asked without a branch that a processor could guess wrongly."});
  session.aim({.work = "ray-sphere: wrong verdicts", .kind = Target::wrong, .test = "ray-sphere", .at_most = 0});
  session.aim({.work = "ray-sphere: error of t", .kind = Target::ulps, .test = "ray-sphere", .at_most = 4});
  session.aim(
      {.work = "one ray, many spheres",
       .test = "ray-sphere, one ray",
       .ours = "batch",
       .theirs = "naive",
       .at_most = 0.04,
       .limit =
           "Spheres in the first cache take nearly as long, by vectors as wide as the machine has them. A sphere is 32 "
           "bytes; to read those alone, from beyond the cache of the second level, would be some 0.06 × naive."});
  session.aim_on_hard_input(
      "ray-sphere", {}, "In float an ordinary call takes two thirds of its time in double, a tangent seven eighths.");
  for (const char* name : {"ordinary", "far-small", "planet", "near-tangent", "exact-tangent", "on-surface",
                           "direction-length", "zero-radius"}) {
    compete<double>(session, name);
    compete<float>(session, name);
  }
  for (const int hits : {5, 100}) {
    compete<double>(session, hits);
    compete<float>(session, hits);
  }
  for (const int hits : {5, 50, 100}) {
    yes_or_no<double>(session, hits);
    yes_or_no<float>(session, hits);
  }
  one_ray<double>(session);
  one_ray<float>(session);
}

}  // namespace isect::bench::ray_sphere_suite
