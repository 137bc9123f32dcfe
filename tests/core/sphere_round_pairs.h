#pragma once
// What the tests of a ball against a cylinder and against a cone share.

#include "bench/sphere_cylinder/families.h"
#include "bench/sphere_cylinder/oracle.h"
#include "tests/catch.h"
#include "tests/core/motion.h"
#include "tests/settings.h"

namespace isect::tests::sphere_round_pairs {

using bench::Numbers, bench::Random;

/// Compares the core with the oracle on any numbers and named families; the nearest point has `places` possible places.
template <class S, template <class> class Solid, class Event, class Reach, std::size_t places, class Draws>
void check(const Draws& draws) {
  std::array<int, 6> seen = {};
  std::array<int, places> nearest = {}, touched = {};
  const auto ask = [&](const bench::BallAndSolid<S, Solid<S>>& c) {
    const Relation truth = oracle::relation(c.a, c.b);
    REQUIRE(relate(c.a, c.b) == truth);
    REQUIRE(intersects(c.a, c.b) == (truth != Relation::disjoint));
    Record<Event> record;
    REQUIRE(relate(c.a, c.b, record) == truth);
    ++seen[static_cast<std::size_t>(truth)];
    for (const auto& event : record.events)
      if (const auto* reach = std::get_if<Reach>(&event))
        ++(reach->sign == 0 ? touched : nearest)[static_cast<std::size_t>(reach->nearest)];
  };
  for (const Numbers numbers : bench::all_numbers_and_ends) {
    const bool long_numbers = numbers >= Numbers::wide && std::is_same_v<S, double>;
    Random random(tests::seed() + static_cast<int>(numbers));
    for (int i = 0; i < (long_numbers ? tests::cases(150, 15000) : tests::cases(1000, 100000)); ++i) {
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      const auto c = bench::ball_and_solid::of_any_numbers<S, Solid>(random, numbers);
      ask(c);
      if (numbers > Numbers::distant) continue;
      const tests::Motion<3> move = tests::motion<3>(random);
      REQUIRE(relate(move(c.a), move(c.b)) == relate(c.a, c.b));
    }
  }
  for (const auto& family : draws) {
    Random random(tests::seed());
    for (int i = 0; i < tests::cases(300, 30000); ++i) {
      INFO("seed " << tests::seed() << ", family " << family.name << ", case " << i);
      ask(family.draw(random));
    }
  }
  for (const Relation r :
       {Relation::disjoint, Relation::touching, Relation::overlapping, Relation::a_inside_b, Relation::b_inside_a})
    CHECK(seen[static_cast<std::size_t>(r)] > 200);
  for (const int often : nearest) CHECK(often > 100);
  for (std::size_t i = 1; i < places; ++i) CHECK(touched[i] > 5);  // by a point inside only a point touches
}

/// Compares a method with the oracle on ordinary balls.
template <class S, template <class> class Solid, class Method>
void check_method(const Method& method) {
  Random random(tests::seed());
  int hits = 0, wrong = 0;
  for (int i = 0; i < 2000; ++i) {
    const auto c = bench::ball_and_solid::ordinary<S, Solid>(random);
    const bool truth = oracle::relation(c.a, c.b) != Relation::disjoint;
    hits += truth, wrong += method(c.a, c.b) != truth;
  }
  CHECK(hits > 100);
  CHECK(wrong <= 2);
}

}  // namespace isect::tests::sphere_round_pairs
