// Rays and segments.

#include "core/ray_sphere.h"

#include "core/ray_sphere_methods.h"
#include "lessons/query/events.h"
#include "lessons/query/handlers.h"

namespace isect::query {

// clang-format off
template <> struct Told<ray_sphere::Verdict> : Says<"Verdict", "line_roots origin lo hi"> {};
template <> struct Told<ray_sphere::Decision> : Says<"Decision", "a discriminant c verdict"> {};
template <> struct Told<ray_sphere::Values> : Says<"Values", "roots"> {};
template <class S, int N> struct Told<ray_sphere::FromCenter<S, N>> : Says<"FromCenter", "f"> {};
template <class S> struct Told<ray_sphere::CoefficientA<S>> : Says<"CoefficientA", "a"> {};
template <class S> struct Told<ray_sphere::CoefficientB<S>> : Says<"CoefficientB", "b"> {};
template <class S> struct Told<ray_sphere::CoefficientC<S>> : Says<"CoefficientC", "c"> {};
template <class S> struct Told<ray_sphere::Discriminant<S>> : Says<"Discriminant", "d"> {};
template <class S> struct Told<ray_sphere::LineMisses<S>> : Says<"LineMisses", "d holds"> {};
template <class S> struct Told<ray_sphere::Root<S>> : Says<"Root", "index t"> {};
template <class S> struct Told<ray_sphere::RootInRange<S>> : Says<"RootInRange", "index t holds"> {};
template <class S> struct Told<ray_sphere::Hit<S>> : Says<"Hit", "t"> {};
template <> struct Told<ray_sphere::Miss> : Says<"Miss"> {};
template <class S, int N> struct Told<ray_sphere::ToCenter<S, N>> : Says<"ToCenter", "l"> {};
template <class S> struct Told<ray_sphere::AlongRay<S>> : Says<"AlongRay", "s"> {};
template <class S> struct Told<ray_sphere::CenterDistance<S>> : Says<"CenterDistance", "l2"> {};
template <class S> struct Told<ray_sphere::Behind<S>> : Says<"Behind", "s l2 r2 holds"> {};
template <class S> struct Told<ray_sphere::PassingDistance<S>> : Says<"PassingDistance", "m2"> {};
template <class S> struct Told<ray_sphere::PassesBy<S>> : Says<"PassesBy", "m2 r2 holds"> {};
template <class S> struct Told<ray_sphere::HalfChord<S>> : Says<"HalfChord", "q"> {};
template <class S> struct Told<ray_sphere::FromOutside<S>> : Says<"FromOutside", "l2 r2 holds"> {};
template <class S> struct Told<ray_sphere::Nearest<S>> : Says<"Nearest", "t"> {};
template <class S> struct Told<ray_sphere::TooFar<S>> : Says<"TooFar", "t limit holds"> {};
template <> struct Told<ray_sphere::Reject> : Says<"Reject"> {};
template <class S, int N> struct Told<ray_sphere::Intersect<S, N>> : Says<"Intersect", "t p"> {};
// clang-format on

namespace {

/// The note's methods know the first t on the surface, nothing else.
template <class S, int N>
Json ray_sphere_by(Job& job, const Ray<S, N>& r, const Sphere<S, N>& ball) {
  using Quadratic = ray_sphere::QuadraticEvent<S, N>;
  std::optional<S> t;
  if (job.variant == "quadratic")
    t = run<Quadratic>(job, [&](auto&& trace) { return ray_sphere::quadratic(r, ball, trace); });
  else if (job.variant == "half_b")
    t = run<Quadratic>(job, [&](auto&& trace) { return ray_sphere::half_b(r, ball, trace); });
  else
    t = run<ray_sphere::HainesEvent<S, N>>(job,
                                           [&](auto&& trace) { return ray_sphere::haines(r, ball, trace); });
  return {{"ray_hit", t.has_value()}, {"t_first_surface", number(t)}};
}

template <class S>
Json ray_sphere(Job& job) {
  return in_dimension(job.fields["origin"], [&]<int N>() -> Json {
    const Ray<S, N> r = ray<S, N>(job.fields);
    const Sphere<S, N> ball = sphere<S, N>(job.fields);
    if (job.variant != "exact" && job.variant != "robust") return ray_sphere_by(job, r, ball);

    const RaySphere<S> shared =
        run<ray_sphere::Event>(job, [&](auto&& trace) { return intersect(r, ball, trace); });
    const bool meets = shared.line_roots > 0;
    return {{"line_roots", shared.line_roots},
            {"t0", meets ? number(shared.roots.lo) : nullptr},
            {"t1", meets ? number(shared.roots.hi) : nullptr},
            {"ray_hit", shared.solid.has_value()},
            {"origin", name(shared.origin)},
            {"t_first_surface", number(shared.surface)},
            {"t_enter_solid", shared.solid ? number(shared.solid->lo) : nullptr}};
  });
}

}  // namespace

const std::vector<Handler>& ray_handlers() {
  static const std::vector<Handler> table = {
      ISECT_HANDLER(ray_sphere, {"exact", "robust", "quadratic", "half_b", "haines"}),
  };
  return table;
}

}  // namespace isect::query
