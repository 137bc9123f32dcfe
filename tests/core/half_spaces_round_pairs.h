#pragma once
// What the tests of a cylinder and of a cone against half-spaces share.

#include "bench/cylinder_half_spaces/families.h"
#include "bench/cylinder_half_spaces/oracle.h"
#include "bench/plane_cylinder/families.h"
#include "bench/point_cylinder/families.h"
#include "bench/ray_cylinder/families.h"
#include "tests/catch.h"
#include "tests/settings.h"

namespace isect::tests::half_spaces_round_pairs {

using bench::Numbers, bench::Random;

/// Compares the core with the oracle on any numbers, and on the named families.
template <class S, template <class> class Solid, class Event>
void check() {
  std::array<int, 6> seen = {};
  const auto ask = [&](const bench::SolidAndKdop<S, Solid<S>>& c) {
    const HalfSpaces solid = half_spaces_of(c.b);
    const Relation truth = oracle::relation(c.a, c.b);
    REQUIRE(relate(c.a, solid) == truth);
    REQUIRE(intersects(c.a, solid) == (truth != Relation::disjoint));
    Record<Event> record;
    REQUIRE(relate(c.a, solid, record) == truth);
    ++seen[static_cast<std::size_t>(truth)];
  };
  for (const Numbers numbers : bench::all_numbers_and_ends) {
    const bool long_numbers = numbers >= Numbers::wide && std::is_same_v<S, double>;
    Random random(tests::seed() + static_cast<int>(numbers));
    for (int i = 0; i < (long_numbers ? tests::cases(40, 4000) : tests::cases(200, 20000)); ++i) {
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      ask(bench::solid_and_kdop::of_any_numbers<S, Solid>(random, numbers));
    }
  }
  for (const auto& family : bench::solid_and_kdop_draws<S, Solid>) {
    Random random(tests::seed());
    for (int i = 0; i < tests::cases(120, 12000); ++i) {
      INFO("seed " << tests::seed() << ", family " << family.name << ", case " << i);
      ask(family.draw(random));
    }
  }
  for (const Relation r :
       {Relation::disjoint, Relation::touching, Relation::overlapping, Relation::a_inside_b, Relation::b_inside_a})
    CHECK(seen[static_cast<std::size_t>(r)] > 20);
}

/// Checks boxes, oriented boxes, frusta and hulls of whole numbers, some of them flat, and some with a corner on the
/// axis.
template <class Solid>
void check_forms() {
  Random random(tests::seed());
  std::array<int, 6> seen = {};
  const auto vector = [&](int reach) {
    const auto number = [&] { return static_cast<double>(random.integer(-reach, reach)); };
    return Vector<double, 3>(number(), number(), number());
  };
  const auto ask = [&](const Solid& a, const auto& shape, const oracle::Sides& sides) {
    const HalfSpaces solid = half_spaces_of(shape);
    const Relation truth = oracle::relation(a, sides);
    REQUIRE(relate(a, solid) == truth);
    REQUIRE(intersects(a, solid) == (truth != Relation::disjoint));
    ++seen[static_cast<std::size_t>(truth)];
  };
  for (int i = 0; i < tests::cases(200, 20000); ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    Solid a = bench::solid<Solid>(random, Numbers::grid);
    const auto [p, q, narrow] = bench::axis_of(a);
    const Point<double, 3> x = random.one_in(2) ? vector(4) : random.one_in(2) ? p : q;
    const Point<double, 3> y = random.one_in(4) ? x : vector(4);
    const Aabb<double, 3> box = {x.cwiseMin(y), x.cwiseMax(y)};
    ask(a, box, oracle::sides(box));
    Obb<double, 3> obb = {vector(3), {}, vector(2).cwiseAbs()};
    do
      for (int k = 0; k < 3; ++k) obb.axes.col(k) = vector(1);
    while (obb.axes.determinant() == 0);
    ask(a, obb, oracle::sides(obb));
    const Vector<double, 3> eye = x - Vector<double, 3>(0, 0, random.integer(1, 3));
    const auto plane = [&](const Vector<double, 3>& n, double d) { return Plane<double, 3>{n, d - n.dot(eye)}; };
    const Frustum<double> frustum = {{plane({1, 0, 1}, 0), plane({-1, 0, 1}, 0), plane({0, 1, 2}, 0),
                                      plane({0, -1, 2}, 0), plane({0, 0, 1}, -1), plane({0, 0, -1}, 3)}};
    ask(a, frustum, oracle::sides(frustum));
    const Hull3<double> hull = convex_hull(std::vector{x, vector(4), vector(4), vector(4), vector(4)});
    if (hull.dimension == 3) ask(a, hull, oracle::sides(half_spaces_of(hull)));
  }
  for (const Relation r : {Relation::disjoint, Relation::touching, Relation::overlapping, Relation::b_inside_a})
    CHECK(seen[static_cast<std::size_t>(r)] > 5);
}

/// Checks that sums of a solid's faces change nothing, however many: most of them touch it in an edge or a corner.
template <class Solid>
void check_many_faces() {
  Random random(tests::seed());
  for (int i = 0; i < tests::cases(100, 10000); ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    const Solid a = bench::solid<Solid>(random, Numbers::grid);
    const Aabb<double, 3> box = bench::box<double, 3>(random, Numbers::grid);
    const HalfSpaces few = half_spaces_of(box);
    HalfSpaces many = few;
    for (int k = 0; k < 25 && !empty(box); ++k) {
      half_spaces::Level sum = {Vector<double, 3>::Zero(), random.one_in(4) ? 1.0 : 0.0};
      for (int term = 0; term < 3; ++term) {
        const auto& face = std::get<half_spaces::Level>(few.faces[static_cast<std::size_t>(random.below(6))].form);
        const double weight = random.below(3);
        sum.normal += weight * face.normal, sum.d += weight * face.d;
      }
      many.faces.insert(many.faces.begin() + random.below(static_cast<int>(many.faces.size()) + 1), {sum});
    }
    REQUIRE(relate(a, many) == relate(a, few));
  }
}

/// Compares a half-space with its plane, a segment with the test of the line, and a point with its location: solids
/// that are unbounded, and ones without a volume.
template <template <class> class Solid>
void check_thin_and_endless() {
  Random random(tests::seed());
  const auto ask_plane = [&](const Plane<double, 3>& plane, const Solid<double>& a) {
    const HalfSpaces half = {{{half_spaces::Level{plane.normal, plane.d}}}};
    const Relation by_plane = relate(plane, a);
    if (by_plane == Relation::disjoint && side(plane, a) == 0) return;  // no plane, or no solid
    const auto [p, q, narrow] = bench::axis_of(const_cast<Solid<double>&>(a));
    const bool before = side(plane, p) > 0 || side(plane, q) > 0 || (side(plane, p) == 0 && side(plane, q) == 0);
    const Relation apart = before ? Relation::a_inside_b : by_plane;
    REQUIRE(relate(a, half) == (by_plane == Relation::overlapping ? by_plane : apart));
  };
  const auto ask_segment = [](const Segment<double, 3>& segment, const Solid<double>& a) {
    REQUIRE(intersects(a, half_spaces_of(segment)) == intersects(segment, a));
  };
  const auto ask_point = [](const Point<double, 3>& p, const Solid<double>& a) {
    const bool out = locate(p, a) == Location::out;
    REQUIRE(relate(a, half_spaces_of(Aabb<double, 3>{p, p})) == (out ? Relation::disjoint : Relation::b_inside_a));
  };
  for (int i = 0; i < tests::cases(60, 6000); ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    for (const auto& family : bench::plane_and_solid_draws<double, Solid>) {
      const auto c = family.draw(random);
      ask_plane(c.a, c.b);
    }
    for (const auto& family : bench::ray_and_solid_draws<double, Solid>) {
      const auto c = family.draw(random);
      ask_segment({c.a.origin, c.a.at(1)}, c.b);
    }
    for (const auto& family : bench::point_and_solid_draws<double, Solid>) {
      const auto c = family.draw(random);
      ask_point(c.a, c.b);
    }
  }
}

/// Checks shapes that are empty, NaN or infinite.
template <class Solid>
void check_nothing(const Solid& some) {
  const HalfSpaces box = half_spaces_of(Aabb<double, 3>{{-1, -1, -1}, {1, 1, 1}});
  CHECK(relate(some, box) != Relation::disjoint);
  const auto nothing = [](const Solid& a, const HalfSpaces& b) {
    CHECK(relate(a, b) == Relation::disjoint);
    CHECK_FALSE(intersects(a, b));
  };
  nothing(some, half_spaces_of(Aabb<double, 3>{{1, -1, -1}, {-1, 1, 1}}));
  nothing(some, half_spaces_of(Aabb<double, 3>{{-HUGE_VAL, -1, -1}, {1, 1, 1}}));
  Random random(tests::seed());
  for (int i = 0; i < 50; ++i) {
    Solid spoiled = some;
    bench::spoil(random, spoiled);
    nothing(spoiled, box);
  }
}

}  // namespace isect::tests::half_spaces_round_pairs
