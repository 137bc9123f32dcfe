// Cylinders and cones against points, planes, balls, rays, segments and convex solids.

#include "bench/cylinder_half_spaces/families.h"
#include "bench/cylinder_half_spaces/oracle.h"
#include "bench/plane_cylinder/families.h"
#include "bench/plane_cylinder/oracle.h"
#include "bench/point_cylinder/families.h"
#include "bench/point_cylinder/oracle.h"
#include "bench/ray_cylinder/families.h"
#include "bench/ray_cylinder/oracle.h"
#include "bench/sphere_cylinder/families.h"
#include "bench/sphere_cylinder/oracle.h"
#include "tests/cases/shapes.h"

namespace isect::cases {

namespace {

template <class S, class Solid>
Case point_in(const Point<S, 3>& p, const Solid& solid) {
  const Json in = both({{"point", json<S, 3>(p)}}, fields(solid));
  if (!finite(p) || !finite(solid)) return policy(in, is_f32<S>);
  return {in, {{"location", word(oracle::locate(p, solid))}}, is_f32<S>};
}

/// Adds the families of bench, and any numbers.
template <template <class> class Solid>
void add_points(CaseFile& file) {
  const auto ask = [](const auto& c) { return point_in(c.a, c.b); };
  by_families(file, 2, bench::point_and_solid_draws<double, Solid>, bench::point_and_solid_draws<float, Solid>, ask);
  by_numbers(file, 2, [&]<class S>(Random& random, Numbers numbers) -> std::optional<Case> {
    const auto c = bench::point_and_solid::of_any_numbers<S, Solid>(random, numbers);
    if (!finite(c.a) || !finite(c.b)) return {};
    return ask(c);
  });
}

template <class S, class Solid>
Case ray_and_solid(const Ray<S, 3>& ray, const Solid& solid) {
  const Json in = both(fields(ray), fields(solid));
  if (!finite(ray) || !finite(solid)) return policy(in, is_f32<S>);
  if (!oracle::meets(ray, solid)) return {in, {{"hit", false}, {"t_in", nullptr}, {"t_out", nullptr}}, is_f32<S>};
  const auto end = [&](bool last) -> double {
    const double t = last ? ray.range.hi : ray.range.lo;
    if (ray.direction.isZero(0)) return t;
    const oracle::LineInConvex line = oracle::line_in(ray, solid);
    return std::isfinite(t) && line.holds(Rational(t)) ? t : line.passes_at(last);
  };
  return {in, {{"hit", true}, {"t_in", json(end(false))}, {"t_out", json(end(true))}}, is_f32<S>};
}
template <template <class> class Solid>
void add_rays(CaseFile& file) {
  const auto ask = [](const auto& c) { return ray_and_solid(c.a, c.b); };
  by_families(file, 2, bench::ray_and_solid_draws<double, Solid>, bench::ray_and_solid_draws<float, Solid>, ask);
  by_numbers(file, 2, [&]<class S>(Random& random, Numbers numbers) -> std::optional<Case> {
    const auto c = bench::ray_and_solid::of_any_numbers<S, Solid>(random, numbers);
    if (!finite(c.a) || !finite(c.b)) return {};
    return ask(c);
  });
}

template <class S, class Solid>
Case plane_and_solid(const Plane<S, 3>& plane, const Solid& solid) {
  const Json in = both(fields(plane), fields(solid));
  if (!finite(plane) || !finite(solid)) return policy(in, is_f32<S>);
  return {in, related(oracle::relation(plane, solid)), is_f32<S>};
}
template <template <class> class Solid>
void add_planes(CaseFile& file) {
  const auto ask = [](const auto& c) { return plane_and_solid(c.a, c.b); };
  by_families(file, 1, bench::plane_and_solid_draws<double, Solid>, bench::plane_and_solid_draws<float, Solid>, ask);
  by_numbers(file, 2, [&]<class S>(Random& random, Numbers numbers) -> std::optional<Case> {
    const auto c = bench::plane_and_solid::of_any_numbers<S, Solid>(random, numbers);
    if (!finite(c.a) || !finite(c.b) || c.a.normal.isZero(0)) return {};
    return ask(c);
  });
}

template <class S, class Solid>
Case ball_and_solid(const Sphere<S, 3>& ball, const Solid& solid, const std::string& name) {
  const Json in = both(fields(ball), fields(solid));
  if (!finite(ball) || !finite(solid)) return policy(in, is_f32<S>);
  const Relation r = oracle::relation(ball, solid);
  const std::string relation = r == Relation::a_inside_b   ? name + "_contains_sphere"
                               : r == Relation::b_inside_a ? "sphere_contains_" + name
                                                           : word(r);
  return {in, {{"intersects", r != Relation::disjoint}, {"relation", relation}}, is_f32<S>};
}
template <template <class> class Solid>
void add_balls(CaseFile& file, const std::string& name) {
  const auto ask = [&](const auto& c) { return ball_and_solid(c.a, c.b, name); };
  by_families(file, 2, bench::ball_and_solid_draws<double, Solid>, bench::ball_and_solid_draws<float, Solid>, ask);
  by_numbers(file, 2, [&]<class S>(Random& random, Numbers numbers) -> std::optional<Case> {
    const auto c = bench::ball_and_solid::of_any_numbers<S, Solid>(random, numbers);
    if (!finite(c.a) || !finite(c.b)) return {};
    return ask(c);
  });
}

/// Takes both ends of the segment as given.
template <class S, class Solid>
Case segment_and_solid(const Segment<S, 3>& segment, const Solid& solid) {
  const Json in = both({{"segment", {json<S, 3>(segment.p), json<S, 3>(segment.q)}}}, fields(solid));
  if (!finite(segment) || !finite(solid)) return policy(in, is_f32<S>);
  const bool point = segment.p == segment.q, exists = oracle::round_solid(solid).exists;
  const oracle::LineInConvex line = exists && !point ? oracle::line_in(segment, solid)
                                                     : oracle::LineInConvex([](const Rational&) { return false; }, {});
  const bool hit = point ? oracle::locate(segment.p, solid) != Location::out : line.meets({0, 1});
  if (!hit) return {in, {{"hit", false}, {"t_in", nullptr}, {"t_out", nullptr}}, is_f32<S>};
  const auto end = [&](int t) -> double { return point || line.holds(t) ? t : line.passes_at(t == 1); };
  return {in, {{"hit", true}, {"t_in", json(end(0))}, {"t_out", json(end(1))}}, is_f32<S>};
}
template <template <class> class Solid>
void add_segments(CaseFile& file) {
  const auto ask = [](const auto& c) {
    using S = typename std::decay_t<decltype(c.a.origin)>::Scalar;
    return segment_and_solid(Segment<S, 3>{c.a.origin, c.a.at(S(2))}, c.b);
  };
  by_families(file, 1, bench::ray_and_solid_draws<double, Solid>, bench::ray_and_solid_draws<float, Solid>, ask);
  by_numbers(file, 1, [&]<class S>(Random& random, Numbers numbers) -> std::optional<Case> {
    const auto c = bench::ray_and_solid::of_any_numbers<S, Solid>(random, numbers);
    const Segment<S, 3> segment = {c.a.origin, c.a.direction};
    if (!finite(segment) || !finite(c.b)) return {};
    return segment_and_solid(segment, c.b);
  });
}

template <class S>
Json fields(const Kdop<S, 3>& kdop) {
  Json lo = Json::array(), hi = Json::array();
  for (const Interval<S>& slab : kdop.slabs) lo.push_back(json(slab.lo)), hi.push_back(json(slab.hi));
  return {{"normals", json<S, 3>(kdop.normals)}, {"slabs", {{"lo", lo}, {"hi", hi}}}};
}
template <class S, class Solid>
Case solid_and_kdop(const Solid& solid, const Kdop<S, 3>& kdop, const std::string& name) {
  const Json in = both(cases::fields(solid), fields(kdop));
  if (!finite(solid) || !finite(kdop)) return policy(in, is_f32<S>);
  const Relation r = oracle::relation(solid, kdop);
  const std::string relation = r == Relation::a_inside_b   ? "solid_contains_" + name
                               : r == Relation::b_inside_a ? name + "_contains_solid"
                                                           : word(r);
  return {in, {{"intersects", r != Relation::disjoint}, {"relation", relation}}, is_f32<S>};
}
template <template <class> class Solid>
void add_solids(CaseFile& file, const std::string& name) {
  const auto ask = [&](const auto& c) { return solid_and_kdop(c.a, c.b, name); };
  by_families(file, 1, bench::solid_and_kdop_draws<double, Solid>, bench::solid_and_kdop_draws<float, Solid>, ask);
  by_numbers(file, 1, [&]<class S>(Random& random, Numbers numbers) -> std::optional<Case> {
    const auto c = bench::solid_and_kdop::of_any_numbers<S, Solid>(random, numbers);
    if (!finite(c.a) || !finite(c.b)) return {};
    return ask(c);
  });
}

Kdop<double, 3> box(const Point<double, 3>& lo, const Point<double, 3>& hi) {
  Kdop<double, 3> kdop;
  for (int i = 0; i < 3; ++i) {
    kdop.normals.push_back(Vector<double, 3>::Unit(i));
    kdop.slabs.push_back({lo[i], hi[i]});
  }
  return kdop;
}

}  // namespace

CaseFile point_cylinder() {
  CaseFile file("point_cylinder");
  const auto add = [&](const char* note, Point<double, 3> p, Cylinder<double> c) {
    file.add(note, point_in<double>(p, c));
  };
  const Cylinder<double> lying = {{-3, 0, 0}, {3, 0, 0}, 5}, thin = {{.1, .1, 0}, {.7, .7, 0}, 0};
  add("on the side, by 3, 4 and 5", {1, 3, 4}, lying);
  add("an ulp outside the side", {1, 3, std::nextafter(4., 5.)}, lying);
  add("an ulp inside the side", {1, 3, std::nextafter(4., 3.)}, lying);
  add("on an end", {3, 1, 1}, lying);
  add("an ulp beyond an end", {std::nextafter(3., 4.), 1, 1}, lying);
  add("on the rim", {-3, 4, -3}, lying);
  add("in the capsule, beyond the end", {6, 1, 0}, lying);
  add("on the axis of radius 0, which is on", {.3, .3, 0}, thin);
  add("beside the axis of radius 0 by the least", {.3, .3, least}, thin);
  add("an axis without length: empty", {0, 0, 0}, {{0, 0, 0}, {0, 0, 0}, 5});
  add("an axis of the least length", {0, 0, 0}, {{-least, 0, 0}, {least, 0, 0}, least});
  add("an empty cylinder", {0, 0, 0}, {{-3, 0, 0}, {3, 0, 0}, -1});
  add("sizes of 1e300", {1e300, 3e300, 4e300}, {{-3e300, 0, 0}, {3e300, 0, 0}, 5e300});
  add("sizes of 1e-300", {1e-300, 3e-300, 4e-300}, {{-3e-300, 0, 0}, {3e-300, 0, 0}, 5e-300});
  add("from end to end of the range", {0, most, 0}, {{-most, 0, 0}, {most, 0, 0}, most});
  add_points<Cylinder>(file);
  return file;
}

CaseFile point_cone() {
  CaseFile file("point_cone");
  const auto add = [&](const char* note, Point<double, 3> p, Cone<double> c) {
    file.add(note, point_in<double>(p, c));
  };
  const Cone<double> lying = {{0, 0, 0}, {6, 0, 0}, 10}, thin = {{.1, .1, 0}, {.7, .7, 0}, 0};
  add("on the side, by 3, 4 and 5", {3, 3, 4}, lying);
  add("an ulp outside the side", {3, 3, std::nextafter(4., 5.)}, lying);
  add("an ulp inside the side", {3, 3, std::nextafter(4., 3.)}, lying);
  add("on the apex", {0, 0, 0}, lying);
  add("beside the apex by the least", {0, least, 0}, lying);
  add("on the base", {6, 1, 1}, lying);
  add("an ulp beyond the base", {std::nextafter(6., 7.), 1, 1}, lying);
  add("on the rim", {6, 8, -6}, lying);
  add("in the other half of the double cone", {-3, 1, 1}, lying);
  add("on the axis of radius 0, which is on", {.3, .3, 0}, thin);
  add("beside the axis of radius 0 by the least", {.3, .3, least}, thin);
  add("an axis without length: empty", {0, 0, 0}, {{0, 0, 0}, {0, 0, 0}, 5});
  add("an axis of the least length", {least, least, 0}, {{0, 0, 0}, {least, 0, 0}, least});
  add("an empty cone", {1, 0, 0}, {{0, 0, 0}, {6, 0, 0}, -1});
  add("sizes of 1e300", {3e300, 3e300, 4e300}, {{0, 0, 0}, {6e300, 0, 0}, 1e301});
  add("sizes of 1e-300", {3e-300, 3e-300, 4e-300}, {{0, 0, 0}, {6e-300, 0, 0}, 1e-299});
  add("from end to end of the range", {0, most / 2, 0}, {{-most, 0, 0}, {most, 0, 0}, most});
  add_points<Cone>(file);
  return file;
}

CaseFile ray_cylinder() {
  CaseFile file("ray_cylinder");
  using P = Point<double, 3>;
  const auto add = [&](const char* note, P origin, P direction, Cylinder<double> cylinder,
                       Interval<double> range = semi_infinite<double>) {
    file.add(note, ray_and_solid<double>({origin, direction, range}, cylinder));
  };
  const Cylinder<double> lying = {{-3, 0, 0}, {3, 0, 0}, 5}, slanted = {{-8, -6, 0}, {12, 9, 0}, 5};
  const double less = std::nextafter(5., 0.);
  add("in by an end, out by the side", {-6, 0, 0}, {1, 1, 0}, lying);
  add("along the axis, through both ends", {-9, 0, 0}, {2, 0, 0}, lying);
  add("along the side, in touch", {-9, 3, 4}, {1, 0, 0}, lying);
  add("along the side, an ulp beside it", {-9, 3, 4}, {1, 0, 0}, {lying.p, lying.q, less});
  add("along the side of a slanted one", {-3, 4, 0}, {8, 6, 0}, slanted);
  add("along the side of a slanted one, an ulp beside it", {-3, 4, 0}, {8, 6, 0}, {slanted.p, slanted.q, less});
  add("across it, in touch with the side", {1, -9, 5}, {0, 2, 0}, lying);
  add("across it, an ulp above the side", {1, -9, 5}, {0, 2, 0}, {lying.p, lying.q, less});
  add("in the plane of an end", {3, -9, 3}, {0, 1, 0}, lying);
  add("in that plane, in touch with the rim", {3, -9, 5}, {0, 1, 0}, lying);
  add("an ulp beyond the plane of an end", {std::nextafter(3., 4.), -9, 3}, {0, 1, 0}, lying);
  add("at the rim in passing, on 3, 4 and 5", {-4, 3, 3}, {1, 0, 1}, lying);
  add("at the rim in passing, an ulp beside it", {-4, 3, 3}, {1, 0, 1}, {lying.p, lying.q, less});
  add("in the capsule, beyond the end", {6, -9, 0}, {0, 1, 0}, lying);
  add("nearly along a long one", {-1e8, -1e-8, 0}, {1, 1e-16, 0}, {{-1e8, 0, 0}, {1e8, 0, 0}, 1});
  add("nearly along the side of a long one, sinking in", {-1e8, 1.0000001, 0}, {1, -1e-15, 0},
      {{-1e8, 0, 0}, {1e8, 0, 0}, 1});
  add("a flat one far away", {0, 0, 0}, {.6, .8, 1e-9}, {{6e7, 8e7, 0}, {6e7, 8e7, 1e-8}, 1});
  add("an axis without length: empty", {-9, 0, 0}, {1, 0, 0}, {{1, 0, 0}, {1, 0, 0}, 5});
  add("radius 0: a segment, crossed", {.1, .1, -1}, {0, 0, .3}, {{-.1, -.1, 0}, {.3, .3, 0}, 0});
  add("radius 0: a segment, missed by the least", {.1, .1, -1}, {least, 0, .3}, {{-.1, -.1, 0}, {.3, .3, 0}, 0});
  add("radius 0: along the segment", {-1, -1, 0}, {.1, .1, 0}, {{-.1, -.1, 0}, {.3, .3, 0}, 0});
  add("no direction, on the side", {1, 3, 4}, {0, -0., 0}, lying, {-2, 7});
  add("no direction, an ulp outside", {1, 3, 4}, {0, 0, 0}, {lying.p, lying.q, less});
  add("behind", {9, 1, 0}, {1, 0, 0}, lying);
  add("a line, behind its origin", {9, 1, 0}, {1, 0, 0}, lying, {-inf, inf});
  add("a segment that ends on an end", {-9, 1, 0}, {6, 0, 0}, lying, {0, 1});
  add("a segment that ends an ulp before an end", {-9, 1, 0}, {6, 0, 0}, lying, {0, std::nextafter(1., 0.)});
  add("a segment within", {-1, 0, 0}, {2, 1, 0}, lying, {0, 1});
  add("an empty range", {1, -9, 0}, {0, 4, 0}, lying, {3, 2});
  add("an empty cylinder", {1, -9, 0}, {0, 4, 0}, {lying.p, lying.q, -1});
  add("a direction whose square vanishes", {1, -9, 0}, {0, 1e-300, 0}, lying);
  add("a direction whose square overflows", {1, -9, 0}, {0, 1e300, 0}, lying);
  add("sizes of 1e300", {1e300, -9e300, 0}, {0, 1, 0}, {{-3e300, 0, 0}, {3e300, 0, 0}, 5e300});
  add("sizes of 1e-300", {1e-300, -9e-300, 0}, {0, 1, 0}, {{-3e-300, 0, 0}, {3e-300, 0, 0}, 5e-300});
  add("1e-300 beside 1e300", {-1e300, 1e-300, 0}, {1e300, 0, 0}, {{0, 0, 0}, {1, 0, 0}, 1e-300});
  add("a radius that is not finite", {1, -9, 0}, {0, 4, 0}, {lying.p, lying.q, inf});
  add_rays<Cylinder>(file);
  return file;
}

CaseFile ray_cone() {
  CaseFile file("ray_cone");
  using P = Point<double, 3>;
  const auto add = [&](const char* note, P origin, P direction, Cone<double> cone,
                       Interval<double> range = semi_infinite<double>) {
    file.add(note, ray_and_solid<double>({origin, direction, range}, cone));
  };
  const Cone<double> lying = {{0, 0, 0}, {4, 0, 0}, 4}, wide = {{0, 0, 0}, {6, 0, 0}, 10};
  add("through both sides", {2, 5, 0}, {0, -1, 0}, lying);
  add("in by the side, out by the base", {-9, 1, 0}, {2, 0, 0}, lying);
  add("in by the base, out by the side", {13, 1, 0}, {-1, 0, 0}, lying);
  add("in by the apex, out by the base", {-9, 0, 0}, {1, 0, 0}, lying);
  add("across the apex", {0, -9, 0}, {0, 1, 0}, lying);
  add("beside the apex by the least", {-least, -9, 0}, {0, 1, 0}, lying);
  add("above the apex by the least", {0, -9, least}, {0, 1, 0}, lying);
  add("along a line of the side", {-1, -1, 0}, {1, 1, 0}, lying);
  add("along a line of the side, raised by an ulp", {-1, std::nextafter(-1., 0.), 0}, {1, 1, 0}, lying);
  add("along a line of the side, lowered by an ulp", {-1, std::nextafter(-1., -2.), 0}, {1, 1, 0}, lying);
  add("parallel to a line of the side, in by the other one", {0, -2, 0}, {1, 1, 0}, lying);
  add("nearly parallel to it", {0, -2, 0}, {1, std::nextafter(1., 2.), 0}, lying);
  add("nearly parallel to it, flatter", {0, -2, 0}, {1, std::nextafter(1., 0.), 0}, lying);
  add("parallel to it, outside", {0, 2, 0}, {1, 1, 0}, lying);
  add("in the plane that touches along it", {2, 2, -9}, {0, 0, 1}, lying);
  add("in that plane, raised by an ulp", {2, std::nextafter(2., 3.), -9}, {0, 0, 1}, lying);
  add("in touch with the side, by 3, 4 and 5", {3, 7, 1}, {0, -4, 3}, wide);
  add("in touch with the side, an ulp beside it", {3, 7, std::nextafter(1., 2.)}, {0, -4, 3}, wide);
  add("in the base", {4, -9, 0}, {0, 1, 0}, lying);
  add("in the plane of the base, in touch with the rim", {4, -9, 4}, {0, 1, 0}, lying);
  add("an ulp beyond the base", {std::nextafter(4., 5.), -9, 0}, {0, 1, 0}, lying);
  add("only through the other half of the double cone", {-2, -9, 0}, {0, 1, 0}, lying);
  add("through both halves", {-3, -4, 0}, {1, 1, 0}, lying);
  add("a needle, nearly along it", {-1e8, 0, 1e-9}, {1, 0, 0}, {{0, 0, 0}, {1e8, 0, 0}, 1e-8});
  add("a flat one", {.1, .2, 5}, {0, 0, -.1}, {{0, 0, 1e-9}, {0, 0, 0}, 1});
  add("an axis without length: empty", {-9, 0, 0}, {1, 0, 0}, {{1, 0, 0}, {1, 0, 0}, 5});
  add("radius 0: a segment, crossed", {.1, .1, -1}, {0, 0, .3}, {{-.1, -.1, 0}, {.3, .3, 0}, 0});
  add("radius 0: along the segment", {-1, -1, 0}, {.1, .1, 0}, {{-.1, -.1, 0}, {.3, .3, 0}, 0});
  add("no direction, on the side", {3, 3, 4}, {0, -0., 0}, wide, {-2, 7});
  add("no direction, an ulp outside", {3, 3, std::nextafter(4., 5.)}, {0, 0, 0}, wide);
  add("behind", {9, 1, 0}, {1, 0, 0}, lying);
  add("a line, behind its origin", {9, 1, 0}, {1, 0, 0}, lying, {-inf, inf});
  add("a segment that ends on the side", {2, -9, 0}, {0, 7, 0}, lying, {0, 1});
  add("a segment that ends an ulp before the side", {2, -9, 0}, {0, 7, 0}, lying, {0, std::nextafter(1., 0.)});
  add("a segment within", {2, 0, 0}, {1, 1, 0}, lying, {0, 1});
  add("an empty range", {2, -9, 0}, {0, 4, 0}, lying, {3, 2});
  add("an empty cone", {2, -9, 0}, {0, 4, 0}, {lying.apex, lying.base, -1});
  add("a direction whose square vanishes", {2, -9, 0}, {0, 1e-300, 0}, lying);
  add("a direction whose square overflows", {2, -9, 0}, {0, 1e300, 0}, lying);
  add("sizes of 1e300", {2e300, -9e300, 0}, {0, 1, 0}, {{0, 0, 0}, {4e300, 0, 0}, 4e300});
  add("sizes of 1e-300", {2e-300, -9e-300, 0}, {0, 1, 0}, {{0, 0, 0}, {4e-300, 0, 0}, 4e-300});
  add("1e-300 beside 1e300", {-1e300, 1e-300, 0}, {1e300, 0, 0}, {{0, 0, 0}, {1, 0, 0}, 1e-300});
  add("a radius that is not finite", {2, -9, 0}, {0, 4, 0}, {lying.apex, lying.base, inf});
  add_rays<Cone>(file);
  return file;
}

CaseFile segment_cylinder() {
  CaseFile file("segment_cylinder");
  using P = Point<double, 3>;
  const Cylinder<double> lying = {{-3, 0, 0}, {3, 0, 0}, 5}, thin = {{-.1, -.1, 0}, {.3, .3, 0}, 0};
  const auto add = [&](const char* note, P p, P q, const Cylinder<double>& c) {
    file.add(note, segment_and_solid<double>({p, q}, c));
  };
  add("through both sides", {1, -9, 0}, {1, 7, 0}, lying);
  add("ends on the side, by 3, 4 and 5", {1, 9, 8}, {1, 3, 4}, lying);
  add("ends an ulp before the side", {1, 9, 8}, {1, 3, std::nextafter(4., 5.)}, lying);
  add("ends on an end", {-9, 1, 0}, {-3, 1, 0}, lying);
  add("ends an ulp before an end", {-9, 1, 0}, {std::nextafter(-3., -4.), 1, 0}, lying);
  add("within", {-1, 0, 0}, {2, 1, 0}, lying);
  add("touches the rim in passing, on integers", {-4, 3, 3}, {-2, 3, 5}, lying);
  add("along the side", {-9, 3, 4}, {9, 3, 4}, lying);
  add("a point on the side", {1, 3, 4}, {1, 3, 4}, lying);
  add("a point an ulp outside", {1, 3, std::nextafter(4., 5.)}, {1, 3, std::nextafter(4., 5.)}, lying);
  add("whose direction is no vector of doubles", {.1, -1e16, 0}, {.1, 1e-3, 0}, lying);
  add("from end to end of the range", {-most, 0, 0}, {most, 0, 0}, lying);
  add("radius 0: a segment, crossed in tenths", {.1, .1, -1}, {.1, .1, .3}, thin);
  add("radius 0: a segment, missed by the least", {.1, .1, -1}, {.1, .1, -least}, thin);
  add_segments<Cylinder>(file);
  return file;
}

CaseFile segment_cone() {
  CaseFile file("segment_cone");
  using P = Point<double, 3>;
  const Cone<double> lying = {{0, 0, 0}, {4, 0, 0}, 4}, thin = {{-.1, -.1, 0}, {.3, .3, 0}, 0};
  const auto add = [&](const char* note, P p, P q, const Cone<double>& c) {
    file.add(note, segment_and_solid<double>({p, q}, c));
  };
  add("through both sides", {2, -9, 0}, {2, 7, 0}, lying);
  add("ends on the side", {2, -9, 0}, {2, -2, 0}, lying);
  add("ends an ulp before the side", {2, -9, 0}, {2, std::nextafter(-2., -3.), 0}, lying);
  add("ends at the apex", {-9, 4, 0}, {0, 0, 0}, lying);
  add("ends before the apex by the least", {-9, 4, 0}, {0, least, 0}, lying);
  add("ends on the base", {9, 1, 0}, {4, 1, 0}, lying);
  add("within", {2, 0, 0}, {3, 1, 0}, lying);
  add("along a line of the side", {-1, -1, 0}, {9, 9, 0}, lying);
  add("along a line of the side, raised by an ulp", {-1, std::nextafter(-1., 0.), 0}, {9, std::nextafter(9., 10.), 0},
      lying);
  add("only through the other half of the double cone", {-2, -9, 0}, {-2, 9, 0}, lying);
  add("a point on the rim", {4, 0, 4}, {4, 0, 4}, lying);
  add("whose direction is no vector of doubles", {2, -1e16, 0}, {2, 1e-3, 0}, lying);
  add("from end to end of the range", {-most, 0, 0}, {most, 0, 0}, lying);
  add("radius 0: a segment, crossed in tenths", {.1, .1, -1}, {.1, .1, .3}, thin);
  add_segments<Cone>(file);
  return file;
}

CaseFile cylinder_solid() {
  CaseFile file("cylinder_solid");
  const Cylinder<double> upright = {{0, 0, -3}, {0, 0, 3}, 5};
  const auto add = [&](const char* note, const Kdop<double, 3>& solid) {
    file.add(note, solid_and_kdop<double>(upright, solid, "cylinder"));
  };
  add("an edge along the side, by 3, 4 and 5", box({3, 4, -1}, {9, 9, 1}));
  add("an edge an ulp beside the side", box({3, std::nextafter(4., 5.), -1}, {9, 9, 1}));
  add("a corner on the rim", box({3, 4, 3}, {9, 9, 9}));
  add("a face on an end", box({-1, -1, 3}, {1, 1, 9}));
  add("a face an ulp beyond an end", box({-1, -1, std::nextafter(3., 4.)}, {1, 1, 9}));
  add("around it", box({-5, -5, -3}, {5, 5, 3}));
  add("around it, but for an ulp", box({-5, -5, -3}, {5, std::nextafter(5., 4.), 3}));
  add("in it, up to the rims", box({-3, -4, -3}, {3, 4, 3}));
  add("in it but for an ulp", box({-3, -4, -3}, {3, std::nextafter(4., 5.), 3}));
  add("a plate on an end", box({-9, -9, 3}, {9, 9, 3}));
  add("a line of the side, lengthened", box({5, 0, -9}, {5, 0, 9}));
  add("a point of the rim", box({3, 4, 3}, {3, 4, 3}));
  add_solids<Cylinder>(file, "cylinder");
  return file;
}

CaseFile cone_solid() {
  CaseFile file("cone_solid");
  const Cone<double> upright = {{0, 0, 2}, {0, 0, 0}, 10};
  const auto add = [&](const char* note, const Kdop<double, 3>& solid) {
    file.add(note, solid_and_kdop<double>(upright, solid, "cone"));
  };
  add("a corner on the side, by 3, 4 and 5", box({3, 4, 1}, {9, 9, 9}));
  add("a corner an ulp beside the side", box({3, std::nextafter(4., 5.), 1}, {9, 9, 9}));
  add("a face on the apex", box({-1, -1, 2}, {1, 1, 9}));
  add("a corner on the apex", box({0, 0, 2}, {1, 1, 9}));
  add("an edge below the base by the least", box({-1, -1, -9}, {1, 1, -least}));
  add("beyond the apex, in the other half of the double cone", box({-1, -1, 3}, {1, 1, 4}));
  add("around it", box({-10, -10, 0}, {10, 10, 2}));
  add("around it, but for an ulp", box({-10, -10, 0}, {10, 10, std::nextafter(2., 1.)}));
  add("in it", box({-3, -4, 0}, {3, 4, 1}));
  add("in it but for an ulp", box({-3, -4, 0}, {3, 4, std::nextafter(1., 2.)}));
  add("a segment through the apex, beside all else", box({-9, 0, 2}, {9, 0, 2}));
  add("a point of the rim", box({6, 8, 0}, {6, 8, 0}));
  add_solids<Cone>(file, "cone");
  return file;
}

CaseFile plane_cylinder() {
  CaseFile file("plane_cylinder");
  const auto add = [&](const char* note, Plane<double, 3> plane, Cylinder<double> c) {
    file.add(note, plane_and_solid<double>(plane, c));
  };
  const Cylinder<double> lying = {{-3, 0, 0}, {3, 0, 0}, 5}, thin = {{.1, .1, 0}, {.7, .7, 0}, 0};
  add("in an end", {{1, 0, 0}, -3}, lying);
  add("an ulp beyond an end", {{1, 0, 0}, std::nextafter(-3., -4.)}, lying);
  add("an ulp before an end", {{1, 0, 0}, std::nextafter(-3., 0.)}, lying);
  add("along the side, by 3, 4 and 5", {{0, 3, 4}, -25}, lying);
  add("an ulp outside the side", {{0, 3, 4}, std::nextafter(-25., -26.)}, lying);
  add("an ulp inside the side", {{0, 3, 4}, std::nextafter(-25., 0.)}, lying);
  add("at the rim", {{4, 3, 0}, -27}, lying);
  add("an ulp outside the rim", {{4, 3, 0}, std::nextafter(-27., -28.)}, lying);
  add("through the axis", {{0, 1, 1}, 0}, lying);
  add("across both ends", {{1, -1, 0}, 0}, lying);
  add("radius 0: through the segment's end", {{1, 0, 0}, -.1}, thin);
  add("radius 0: along the segment", {{1, -1, 0}, 0}, thin);
  add("an axis without length: empty", {{1, 0, 0}, 0}, {{0, 0, 0}, {0, 0, 0}, 5});
  add("an empty cylinder", {{1, 0, 0}, 0}, {{-3, 0, 0}, {3, 0, 0}, -1});
  add("sizes of 1e300", {{0, 3, 4}, -2.5e301}, {{-3e300, 0, 0}, {3e300, 0, 0}, 5e300});
  add("a normal of 1e-300", {{0, 3e-300, 4e-300}, -2.5e-299}, lying);
  add("from end to end of the range", {{1, 0, 0}, -most}, {{-most, 0, 0}, {most, 0, 0}, least});
  add_planes<Cylinder>(file);
  return file;
}

CaseFile plane_cone() {
  CaseFile file("plane_cone");
  const auto add = [&](const char* note, Plane<double, 3> plane, Cone<double> c) {
    file.add(note, plane_and_solid<double>(plane, c));
  };
  const Cone<double> lying = {{-3, 0, 0}, {3, 0, 0}, 5}, thin = {{.1, .1, 0}, {.7, .7, 0}, 0};
  add("in the base", {{1, 0, 0}, -3}, lying);
  add("an ulp beyond the base", {{1, 0, 0}, std::nextafter(-3., -4.)}, lying);
  add("at the apex", {{1, 0, 0}, 3}, lying);
  add("an ulp beyond the apex", {{1, 0, 0}, std::nextafter(3., 4.)}, lying);
  add("along the side", {{-5, 6, 0}, -15}, lying);
  add("an ulp outside the side", {{-5, 6, 0}, std::nextafter(-15., -16.)}, lying);
  add("an ulp inside the side", {{-5, 6, 0}, std::nextafter(-15., 0.)}, lying);
  add("at the rim", {{4, 3, 0}, -27}, lying);
  add("an ulp outside the rim", {{4, 3, 0}, std::nextafter(-27., -28.)}, lying);
  add("through the axis", {{0, 1, 1}, 0}, lying);
  add("through the apex alone", {{3, 1, 0}, 9}, lying);
  add("through the apex and the base", {{1, 3, 0}, 3}, lying);
  add("radius 0: through the segment's end", {{1, 0, 0}, -.1}, thin);
  add("radius 0: along the segment", {{1, -1, 0}, 0}, thin);
  add("an axis without length: empty", {{1, 0, 0}, 0}, {{0, 0, 0}, {0, 0, 0}, 5});
  add("an empty cone", {{1, 0, 0}, 0}, {{-3, 0, 0}, {3, 0, 0}, -1});
  add("sizes of 1e300", {{-5, 6, 0}, -1.5e301}, {{-3e300, 0, 0}, {3e300, 0, 0}, 5e300});
  add("a normal of 1e-300", {{-5e-300, 6e-300, 0}, -1.5e-299}, lying);
  add("from end to end of the range", {{1, 0, 0}, -most}, {{-most, 0, 0}, {most, 0, 0}, least});
  add_planes<Cone>(file);
  return file;
}

CaseFile sphere_cylinder() {
  CaseFile file("sphere_cylinder");
  const auto add = [&](const char* note, Sphere<double, 3> ball, Cylinder<double> c) {
    file.add(note, ball_and_solid<double>(ball, c, "cylinder"));
  };
  const Cylinder<double> lying = {{-3, 0, 0}, {3, 0, 0}, 5}, low = {{-3, 0, 0}, {3, 0, 0}, 4};
  const double less = std::nextafter(5., 0.), more = std::nextafter(5., 6.);
  add("in touch with the side", {{1, 6, 8}, 5}, lying);
  add("an ulp beside the side", {{1, 6, 8}, less}, lying);
  add("an ulp into the side", {{1, 6, 8}, more}, lying);
  add("in touch with an end", {{8, 1, 1}, 5}, lying);
  add("an ulp beyond an end", {{8, 1, 1}, less}, lying);
  add("in touch with the rim, by 3, 4 and 5", {{6, 0, 9}, 5}, lying);
  add("an ulp beside the rim", {{6, 0, 9}, less}, lying);
  add("an ulp into the rim", {{6, 0, 9}, more}, lying);
  add("in touch with the capsule, beside the cylinder", {{9, 7, 0}, 4}, lying);
  add("from end to end", {{0, 0, 0}, 3}, lying);
  add("from end to end, an ulp too large", {{0, 0, 0}, std::nextafter(3., 4.)}, lying);
  add("inside, in touch with the side", {{0, 0, 3}, 2}, lying);
  add("around it, in touch with both rims", {{0, 0, 0}, 5}, low);
  add("around it, an ulp too small", {{0, 0, 0}, less}, low);
  add("a point on the rim", {{3, 3, 4}, 0}, lying);
  add("a point an ulp beside the rim", {{std::nextafter(3., 4.), 3, 4}, 0}, lying);
  add("radius 0: a segment in touch", {{0, 4, 0}, 4}, {{-3, 0, 0}, {3, 0, 0}, 0});
  add("radius 0: a segment inside", {{0, 4, 0}, 5}, {{-3, 0, 0}, {3, 0, 0}, 0});
  add("an axis without length: empty", {{0, 0, 0}, 1}, {{0, 0, 0}, {0, 0, 0}, 5});
  add("an empty ball", {{0, 0, 0}, -1}, lying);
  add("an empty cylinder", {{0, 0, 0}, 9}, {{-3, 0, 0}, {3, 0, 0}, -1});
  add("sizes of 1e300", {{6e300, 0, 9e300}, 5e300}, {{-3e300, 0, 0}, {3e300, 0, 0}, 5e300});
  add("sizes of 1e-300", {{6e-300, 0, 9e-300}, 5e-300}, {{-3e-300, 0, 0}, {3e-300, 0, 0}, 5e-300});
  add("the smallest ball beside the longest cylinder", {{0, 2 * least, 0}, least},
      {{-most, 0, 0}, {most, 0, 0}, least});
  add_balls<Cylinder>(file, "cylinder");
  return file;
}

CaseFile sphere_cone() {
  CaseFile file("sphere_cone");
  const auto add = [&](const char* note, Sphere<double, 3> ball, Cone<double> c) {
    file.add(note, ball_and_solid<double>(ball, c, "cone"));
  };
  const Cone<double> lying = {{0, 0, 0}, {8, 0, 0}, 6};
  const double less = std::nextafter(5., 0.), more = std::nextafter(5., 6.);
  add("in touch with the side", {{1, 7, 0}, 5}, lying);
  add("an ulp beside the side", {{1, 7, 0}, less}, lying);
  add("an ulp into the side", {{1, 7, 0}, more}, lying);
  add("in touch with the side, over the apex", {{0, 0, 10}, 8}, lying);
  add("in touch with the base", {{13, 1, 1}, 5}, lying);
  add("an ulp beyond the base", {{13, 1, 1}, less}, lying);
  add("in touch with the rim, by 3, 4 and 5", {{12, 9, 0}, 5}, lying);
  add("an ulp beside the rim", {{12, 9, 0}, less}, lying);
  add("in touch with the rim, straight above the side", {{5, 10, 0}, 5}, lying);
  add("an ulp beside it", {{5, 10, 0}, less}, lying);
  add("in touch with the apex", {{-4, 0, 3}, 5}, lying);
  add("an ulp beside the apex", {{-4, 0, 3}, less}, lying);
  add("beside the apex, straight above the side", {{-3, 4, 0}, 5}, lying);
  add("inscribed", {{5, 0, 0}, 3}, lying);
  add("inscribed, an ulp too large", {{5, 0, 0}, std::nextafter(3., 4.)}, lying);
  add("inscribed, an ulp out of place", {{less, 0, 0}, 3}, lying);
  add("around it, in touch with the rim", {{0, 0, 0}, 10}, lying);
  add("around it, an ulp too small", {{0, 0, 0}, std::nextafter(10., 0.)}, lying);
  add("around it, in touch with the apex", {{8, 0, 0}, 8}, lying);
  add("a point on the apex", {{0, 0, 0}, 0}, lying);
  add("a point beside the apex by the least", {{0, least, 0}, 0}, lying);
  add("blunt, beside the apex", {{-1, 3, 0}, 2}, {{0, 0, 0}, {1, 0, 0}, 9});
  add("radius 0: a segment in touch", {{0, 4, 0}, 4}, {{-3, 0, 0}, {3, 0, 0}, 0});
  add("an axis without length: empty", {{0, 0, 0}, 1}, {{0, 0, 0}, {0, 0, 0}, 5});
  add("an empty ball", {{1, 0, 0}, -1}, lying);
  add("an empty cone", {{1, 0, 0}, 9}, {{0, 0, 0}, {8, 0, 0}, -1});
  add("sizes of 1e300", {{12e300, 9e300, 0}, 5e300}, {{0, 0, 0}, {8e300, 0, 0}, 6e300});
  add("sizes of 1e-300", {{12e-300, 9e-300, 0}, 5e-300}, {{0, 0, 0}, {8e-300, 0, 0}, 6e-300});
  add("the smallest ball beside the longest cone", {{0, 2 * least, 0}, least}, {{-most, 0, 0}, {most, 0, 0}, least});
  add_balls<Cone>(file, "cone");
  return file;
}

}  // namespace isect::cases
