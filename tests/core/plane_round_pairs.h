#pragma once
// What the tests of a plane against a cylinder and against a cone share.

#include "bench/plane_cylinder/families.h"
#include "bench/plane_cylinder/oracle.h"
#include "tests/catch.h"
#include "tests/core/motion.h"
#include "tests/settings.h"

namespace isect::tests::plane_round_pairs {

using bench::Numbers, bench::Random;

/// The relation; all answers must agree with each other and with those for the reversed plane.
template <class S, class Solid>
Relation related(const Plane<S, 3>& plane, const Solid& solid) {
  const Relation r = relate(plane, solid);
  const Plane<S, 3> turned = {-plane.normal, -plane.d};
  REQUIRE(relate(turned, solid) == r);
  REQUIRE(intersects(plane, solid) == (r != Relation::disjoint));
  REQUIRE(side(turned, solid) == -side(plane, solid));
  if (r != Relation::disjoint) REQUIRE(side(plane, solid) == 0);
  return r;
}

/// Compares the core with the oracle on any numbers, and on the named families.
template <class S, template <class> class Solid, class Event, class Draws>
void check(const Draws& draws) {
  std::array<int, 6> seen = {};
  const auto ask = [&](const bench::PlaneAndSolid<S, Solid<S>>& c) {
    const Relation truth = oracle::relation(c.a, c.b);
    REQUIRE(related(c.a, c.b) == truth);
    Record<Event> record;
    REQUIRE(relate(c.a, c.b, record) == truth);
    ++seen[static_cast<std::size_t>(truth)];
    if (truth != Relation::disjoint || !finite(c.a) || c.a.normal.isZero(0) || !oracle::round_solid(c.b).exists) return;
    const auto n = oracle::rational(c.a.normal);
    REQUIRE(side(c.a, c.b) == oracle::sign(oracle::dot(n, oracle::round_solid(c.b).start) + oracle::Rational(c.a.d)));
  };
  for (const Numbers numbers : bench::all_numbers_and_ends) {
    Random random(tests::seed() + static_cast<int>(numbers));
    for (int i = 0; i < tests::cases(1500, 150000); ++i) {
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      const auto c = bench::plane_and_solid::of_any_numbers<S, Solid>(random, numbers);
      ask(c);
      if (numbers > Numbers::distant) continue;
      const tests::Motion<3> move = tests::motion<3>(random);
      REQUIRE(relate(move(c.a), move(c.b)) == relate(c.a, c.b));
    }
  }
  for (const auto& family : draws) {
    Random random(tests::seed());
    for (int i = 0; i < tests::cases(500, 50000); ++i) {
      INFO("seed " << tests::seed() << ", family " << family.name << ", case " << i);
      ask(family.draw(random));
    }
  }
  for (const Relation r : {Relation::disjoint, Relation::touching, Relation::overlapping})
    CHECK(seen[static_cast<std::size_t>(r)] > 400);
}

/// Compares a method with the oracle on ordinary planes.
template <class S, template <class> class Solid, class Method>
void check_method(const Method& method) {
  Random random(tests::seed());
  int hits = 0, wrong = 0;
  for (int i = 0; i < 2000; ++i) {
    const auto c = bench::plane_and_solid::ordinary<S, Solid>(random);
    const bool truth = oracle::relation(c.a, c.b) != Relation::disjoint;
    hits += truth, wrong += method(c.a, c.b) != truth;
  }
  CHECK(hits > 100);
  CHECK(wrong <= 2);
}

}  // namespace isect::tests::plane_round_pairs
