// Rays against balls, boxes and capsules.

#include "bench/oracle.h"
#include "bench/ray_aabb/families.h"
#include "bench/ray_aabb/oracle.h"
#include "bench/ray_capsule/oracle.h"
#include "bench/ray_obb/oracle.h"
#include "bench/ray_sphere/families.h"
#include "tests/cases/shapes.h"
#include "tests/core/ray_capsule_pairs.h"
#include "tests/core/ray_obb_pairs.h"

namespace isect::cases {

namespace {

Json value(const std::optional<oracle::Real>& x) { return x ? json(x->nearest) : Json(nullptr); }

template <class S, int N>
Case ray_and_ball(const Ray<S, N>& ray, const Sphere<S, N>& ball) {
  const Json in = both(fields(ray), fields(ball));
  if (!finite(ray) || !finite(ball)) return policy(in, is_f32<S>);
  const oracle::RaySphere truth = oracle::ray_sphere(ray, ball);
  const bool meets = truth.line_roots > 0;
  const Json expected = {{"line_roots", truth.line_roots},
                         {"t0", meets ? json(truth.t0.nearest) : Json(nullptr)},
                         {"t1", meets ? json(truth.t1.nearest) : Json(nullptr)},
                         {"ray_hit", truth.enter.has_value()},
                         {"origin", word(truth.origin)},
                         {"t_first_surface", value(truth.surface)},
                         {"t_enter_solid", value(truth.enter)}};
  return {in, expected, is_f32<S>};
}

/// The part of the range inside, from its true ends; a ray without direction stays where it is, over its whole range.
template <class S, int N>
Json stretch(const Ray<S, N>& ray, const std::optional<std::pair<Rational, Rational>>& ends) {
  if (!ends || empty(ray.range)) return {{"hit", false}, {"t_in", nullptr}, {"t_out", nullptr}};
  if (ray.direction.isZero(0)) return {{"hit", true}, {"t_in", json(ray.range.lo)}, {"t_out", json(ray.range.hi)}};
  return {{"hit", true}, {"t_in", json(nearest(ends->first))}, {"t_out", json(nearest(ends->second))}};
}
template <class S, int N>
Case ray_and_box(const Ray<S, N>& ray, const Aabb<S, N>& box) {
  const Json in = both(fields(ray), fields(box));
  if (!finite(ray) || !finite(box)) return policy(in, is_f32<S>);
  return {in, stretch(ray, oracle::ray_aabb(ray, box)), is_f32<S>};
}
template <class S, int N>
Case ray_and_obb(const tests::ray_obb_pairs::Case<S, N>& c) {
  return {both(fields(c.ray), json(c.box)), stretch(c.ray, oracle::ray_obb(c.ray, c.box)), is_f32<S>};
}
template <class S, int N>
Case ray_and_capsule(const Ray<S, N>& ray, const Capsule<S, N>& capsule) {
  const Json in = both(fields(ray), fields(capsule));
  if (!finite(ray) || !finite(capsule)) return policy(in, is_f32<S>);
  const Json none = {{"hit", false}, {"t_in", nullptr}, {"t_out", nullptr}};
  if (empty(ray.range) || empty(capsule)) return {in, none, is_f32<S>};
  if (ray.direction.isZero(0)) {
    const Rational d2 = oracle::distance2<N>(oracle::rational(ray.origin), oracle::stretch(capsule));
    if (!oracle::at_most(d2, Rational(capsule.radius))) return {in, none, is_f32<S>};
    return {in, {{"hit", true}, {"t_in", json(ray.range.lo)}, {"t_out", json(ray.range.hi)}}, is_f32<S>};
  }
  const oracle::LineInConvex line = oracle::line_in_capsule(ray, capsule);
  if (!line.meets(cast<double>(ray.range))) return {in, none, is_f32<S>};
  const auto end = [&](bool last) -> double {
    const double t = last ? ray.range.hi : ray.range.lo;
    return std::isfinite(t) && line.holds(Rational(t)) ? t : line.passes_at(last);
  };
  return {in, {{"hit", true}, {"t_in", json(end(false))}, {"t_out", json(end(true))}}, is_f32<S>};
}

}  // namespace

CaseFile ray_sphere() {
  CaseFile file("ray_sphere");
  using P = Point<double, 3>;
  const auto add = [&](const char* note, P origin, P direction, P center, double radius,
                       Interval<double> range = semi_infinite<double>) {
    file.add(note, ray_and_ball<double, 3>({origin, direction, range}, {center, radius}));
  };
  add("a miss that floats hit: 1.5 beside a unit ball, 5000 away", {0, 0, 0}, {0, 0, 1}, {1.5, 0, 5000}, 1);
  add("a miss that doubles hit, 1e8 away", {0, 0, 0}, {0, 0, 1}, {1.5, 0, 1e8}, 1);
  add("4100 away, where floats lose the whole half-chord", {0, 0, 0}, {0, 0, 1}, {.5, 0, 4100}, 1);
  add("above a planet", {1000, 2, 3000}, {.6F, -.0078125, .8F}, {0, -6371000, 0}, 6371000);
  add("tangent: Haines misses it in floats", {.1F, 0, -10}, {0, 0, 1}, {0, 0, 0}, .1F);
  add("beside the tangent by an ulp", {std::nextafter(.1, 1), 0, -10}, {0, 0, 1}, {0, 0, 0}, .1);
  add("a direction whose square overflows in floats", {0, 0, -5}, {0, 0, 1e20}, {0, 0, 0}, 1);
  add("a direction whose square vanishes in floats", {0, 0, -5}, {0, 0, 0x1p-76}, {0, 0, 0}, 1);
  add("a direction whose square overflows", {0, 0, -5}, {0, 0, 1e300}, {0, 0, 0}, 1);
  add("a direction whose square vanishes", {0, 0, -5}, {0, 0, 1e-300}, {0, 0, 0}, 1);
  add("a ball of size 1e300", {0, 0, -5e300}, {0, 0, 1}, {0, 0, 0}, 1e300);
  add("a ball of size 1e-300", {0, 0, -5e-300}, {0, 0, 1}, {0, 0, 0}, 1e-300);
  add("1e-300 beside 1e300", {0, 0, 0}, {0, 0, 1}, {0, 0, 1e300}, 1e-300);
  add("from the surface, outwards", {0, 0, 1}, {0, 0, 1}, {0, 0, 0}, 1);
  add("from the surface, along it", {0, 0, 1}, {1, 0, 0}, {0, 0, 0}, 1);
  add("from the surface, inwards", {0, 0, 1}, {0, 0, -1}, {0, 0, 0}, 1);
  add("from inside", {0, 0, 0}, {0, 0, 1}, {0, 0, .5}, 1);
  add("behind", {0, 0, 5}, {0, 0, 1}, {0, 0, 0}, 1);
  add("a segment that ends on the ball", {0, 0, -3}, {0, 0, 2}, {0, 0, 0}, 1, {0, 1});
  add("a segment that ends an ulp before the ball", {0, 0, -3}, {0, 0, 2}, {0, 0, 0}, 1, {0, std::nextafter(1., 0.)});
  add("a segment within the ball meets the solid, not its surface", {0, 0, -.5}, {0, 0, 1}, {0, 0, 0}, 1, {0, 1});
  add("a line to both sides", {0, 0, 5}, {0, 0, 1}, {0, 0, 0}, 1, {-inf, inf});
  add("an empty range", {0, 0, -5}, {0, 0, 1}, {0, 0, 0}, 1, {9, 0});
  add("a ball of radius 0 on the ray", {0, 0, -5}, {0, 0, 1}, {0, 0, 0}, 0);
  add("no direction, on the surface", {0, 0, 1}, {0, -0., 0}, {0, 0, 0}, 1);
  add("an empty ball", {0, 0, -5}, {0, 0, 1}, {0, 0, 0}, -1);
  const auto ask = [](const auto& c) { return ray_and_ball(c.ray, c.sphere); };
  by_families(file, 2, bench::ray_sphere_families<double, 3>(), bench::ray_sphere_families<float, 3>(), ask);
  for (const auto& f : bench::ray_sphere_families<double, 2>())
    file.family(std::string(f.name) + ", in the plane", 1, [&](Random& r) { return ask(f.draw(r)); });
  return file;
}

CaseFile ray_box() {
  CaseFile file("ray_box");
  using P = Point<double, 2>;
  const auto add = [&](const char* note, P origin, P direction, Aabb<double, 2> box,
                       Interval<double> range = semi_infinite<double>) {
    file.add(note, ray_and_box<double, 2>({origin, direction, range}, box));
  };
  const Aabb<double, 2> unit = {{0, 0}, {1, 1}};
  add("along a face, where 0 / 0 is NaN", {1, -1}, {0, 1}, unit);
  add("along a face, with -0", {0, 2}, {-0., -1}, unit);
  add("inside, with -0", {.5, .5}, {-0., 1}, unit);
  add("an ulp beside a face", {std::nextafter(1., 2.), -1}, {0, 1}, unit);
  add("through a corner", {-1, 2}, {1, -1}, unit);
  add("beside a corner by an ulp", {-1, std::nextafter(0., -1.)}, {1, -1}, unit);
  add("a segment that ends on the box", {-1, .5}, {1, 0}, unit, {0, 1});
  add("a segment that ends an ulp before the box", {-1, .5}, {1, 0}, unit, {0, std::nextafter(1., 0.)});
  add("a line, behind the origin", {5, .5}, {1, 0}, unit, {-inf, inf});
  add("no direction, at a corner", {1, 1}, {0, -0.}, unit);
  add("no direction, outside", {1, std::nextafter(1., 2.)}, {0, 0}, unit);
  add("an empty range", {-1, .5}, {1, 0}, unit, {3, 2});
  add("an inverted box is empty", {-1, .5}, {1, 0}, {{1, 0}, {0, 1}});
  add("a box that is a point", {.1, .1}, {.2, .2}, {{.3, .3}, {.3, .3}});
  add("a reciprocal that overflows", {-1, .5}, {least, 0}, unit);
  add("a direction of the largest size", {-1, .5}, {most, 0}, unit);
  add("differences that overflow", {-most, 0}, {most, 0}, {{most / 2, -1}, {most, 1}});
  add("1e-300 beside 1e300", {-1e300, 1e-300}, {1e300, 0}, {{0, 0}, {1, 1e-300}});
  const auto ask = [](const auto& c) { return ray_and_box(c.a, c.b); };
  by_families(file, 4, bench::ray_aabb_draws<double>, bench::ray_aabb_draws<float>, ask);
  return file;
}

CaseFile ray_obb() {
  CaseFile file("ray_obb");
  const Eigen::Matrix2d diagonal{{1, -1}, {1, 1}}, turned{{.6, -.8}, {.8, .6}}, skew{{1, 1}, {0, 1}};
  using P = Point<double, 2>;
  const auto add = [&](const char* note, P origin, P direction, Obb<double, 2> box) {
    file.add(note, ray_and_obb<double, 2>({{origin, direction}, box}));
  };
  add("a corner of a diamond", {-3, 2}, {1, 0}, {{0, 0}, diagonal, {1, 1}});
  add("beside that corner by an ulp", {-3, std::nextafter(2., 3.)}, {1, 0}, {{0, 0}, diagonal, {1, 1}});
  add("along a face of a diamond", {2, 0}, {-1, 1}, {{0, 0}, diagonal, {1, 1}});
  add("along a face of a box turned by .6 and .8, as rounded", {.6, .8}, {-.8, .6}, {{0, 0}, turned, {1, 1}});
  add("axes that are not orthogonal", {-5, 1}, {1, 0}, {{0, 0}, skew, {1, 1}});
  add("without thickness", {-3, 1}, {1, 0}, {{0, 0}, diagonal, {0, 1}});
  add("an axis that is no direction", {-3, 0}, {1, 0}, {{0, 0}, Eigen::Matrix2d{{1, 0}, {0, 0}}, {1, 1}});
  add("no direction, at a corner", {2, 0}, {0, 0}, {{0, 0}, diagonal, {1, 1}});
  add("axes of length 1e-200", {-3, 2}, {1, 0}, {{0, 0}, 1e-200 * diagonal, {1e200, 1e200}});
  add("an empty box", {-3, 0}, {1, 0}, {{0, 0}, diagonal, {-1, 1}});
  by_numbers(file, 4, [&]<class S>(Random& random, Numbers numbers) -> std::optional<Case> {
    const auto c = tests::ray_obb_pairs::draw<S, 3>(random, numbers);
    if (!finite(c.ray) || !finite(c.box)) return {};
    return ray_and_obb(c);
  });
  return file;
}

CaseFile ray_capsule() {
  CaseFile file("ray_capsule");
  using P = Point<double, 3>;
  const auto add = [&](const char* note, P origin, P direction, Capsule<double, 3> capsule,
                       Interval<double> range = semi_infinite<double>) {
    file.add(note, ray_and_capsule<double, 3>({origin, direction, range}, capsule));
  };
  const Capsule<double, 3> lying = {{-3, 0, 0}, {3, 0, 0}, 5}, slanted = {{-8, -6, 0}, {12, 9, 0}, 5};
  const double less = std::nextafter(5., 0.);
  add("in by an end, on 3, 4 and 5, and out by the side", {-8, -4, 0}, {1, 1, 0}, lying);
  add("along the axis, through both ends", {-9, 0, 0}, {1, 0, 0}, lying);
  add("along the axis, from within", {0, 0, 0}, {-2, 0, 0}, lying);
  add("along the side, in touch", {-9, 3, 4}, {1, 0, 0}, lying);
  add("along the side, an ulp beside it", {-9, 3, 4}, {1, 0, 0}, {lying.p, lying.q, less});
  add("along the side of a slanted one", {-3, 4, 0}, {8, 6, 0}, slanted);
  add("along the side of a slanted one, an ulp beside it", {-3, 4, 0}, {8, 6, 0}, {slanted.p, slanted.q, less});
  add("across it, in touch with the side", {1, -9, 5}, {0, 2, 0}, lying);
  add("across it, an ulp above the side", {1, -9, 5}, {0, 2, 0}, {lying.p, lying.q, less});
  add("in touch with an end, on 3, 4 and 5", {6, 4, -9}, {0, 0, 1}, lying);
  add("an ulp beside an end", {6, 4, -9}, {0, 0, 1}, {lying.p, lying.q, less});
  add("where the side meets an end", {3, -9, 0}, {0, 1, 0}, lying);
  add("in by the side just before it ends, out by the end", {0, 9, 0}, {1, -1, 0}, lying);
  add("from an end to the other but beside the axis", {-9, 4, 1}, {4, -1, 0}, lying);
  add("nearly along a long one", {-1e8, -1e-8, 0}, {1, 1e-16, 0}, {{-1e8, 0, 0}, {1e8, 0, 0}, 1});
  add("nearly along the side of a long one, sinking in", {-1e8, 1.0000001, 0}, {1, -1e-15, 0},
      {{-1e8, 0, 0}, {1e8, 0, 0}, 1});
  add("a thin one far away", {0, 0, 0}, {.6, .8, 1e-9}, {{6e7, 8e7, -1}, {6e7, 8e7, 1}, 1e-8});
  add("an axis without length", {-9, 4, 0}, {1, 0, 0}, {{1, 1, 0}, {1, 1, 0}, 5});
  add("radius 0: a segment, crossed", {.1, .1, -1}, {0, 0, .3}, {{-.1, -.1, 0}, {.3, .3, 0}, 0});
  add("radius 0: a segment, missed by the least", {.1, .1, -1}, {least, 0, .3}, {{-.1, -.1, 0}, {.3, .3, 0}, 0});
  add("radius 0: along the segment", {-1, -1, 0}, {.1, .1, 0}, {{-.1, -.1, 0}, {.3, .3, 0}, 0});
  add("a point on the ray", {-1, 0, 0}, {.1, 0, 0}, {{2, 0, 0}, {2, 0, 0}, 0});
  add("no direction, on the side", {1, 3, 4}, {0, -0., 0}, lying, {-2, 7});
  add("no direction, an ulp outside", {1, 3, 4}, {0, 0, 0}, {lying.p, lying.q, less});
  add("behind", {9, 1, 0}, {1, 0, 0}, lying);
  add("a line, behind its origin", {9, 1, 0}, {1, 0, 0}, lying, {-inf, inf});
  add("a segment that ends on the side", {1, -9, 0}, {0, 4, 0}, lying, {0, 1});
  add("a segment that ends an ulp before the side", {1, -9, 0}, {0, 4, 0}, lying, {0, std::nextafter(1., 0.)});
  add("a segment within", {-1, 0, 0}, {2, 1, 0}, lying, {0, 1});
  add("an empty range", {1, -9, 0}, {0, 4, 0}, lying, {3, 2});
  add("an empty capsule", {1, -9, 0}, {0, 4, 0}, {lying.p, lying.q, -1});
  add("a direction whose square vanishes", {1, -9, 0}, {0, 1e-300, 0}, lying);
  add("a direction whose square overflows", {1, -9, 0}, {0, 1e300, 0}, lying);
  add("sizes of 1e300", {1e300, -9e300, 0}, {0, 1, 0}, {{-3e300, 0, 0}, {3e300, 0, 0}, 5e300});
  add("sizes of 1e-300", {1e-300, -9e-300, 0}, {0, 1, 0}, {{-3e-300, 0, 0}, {3e-300, 0, 0}, 5e-300});
  add("1e-300 beside 1e300", {-1e300, 1e-300, 0}, {1e300, 0, 0}, {{0, 0, 0}, {1, 0, 0}, 1e-300});
  add("a radius that is not finite", {1, -9, 0}, {0, 4, 0}, {lying.p, lying.q, inf});
  by_numbers(file, 4, [&]<class S>(Random& random, Numbers numbers) -> std::optional<Case> {
    const bool flat = random.one_in(3);
    const auto ask = [&]<int N>() -> std::optional<Case> {
      const auto c = tests::ray_capsule_pairs::draw<S, N>(random, numbers, random.one_in(2));
      if (!finite(c.ray) || !finite(c.capsule)) return {};
      return ray_and_capsule(c.ray, c.capsule);
    };
    return flat ? ask.template operator()<2>() : ask.template operator()<3>();
  });
  return file;
}

}  // namespace isect::cases
