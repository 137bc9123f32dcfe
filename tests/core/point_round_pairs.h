#pragma once
// What the tests of a point against a cylinder and against a cone share.

#include "bench/point_cylinder/families.h"
#include "bench/point_cylinder/oracle.h"
#include "tests/catch.h"
#include "tests/core/motion.h"
#include "tests/settings.h"

namespace isect::tests::point_round_pairs {

using bench::Numbers, bench::Random;

/// Compares each verdict with the oracle on any numbers, and on the named families.
template <class S, template <class> class Solid, class Event, class Draws>
void check(const Draws& draws) {
  std::array<int, 3> seen = {};
  const auto ask = [&](const bench::PointAndSolid<S, Solid<S>>& c) {
    const Location truth = oracle::locate(c.a, c.b);
    REQUIRE(locate(c.a, c.b) == truth);
    Record<Event> record;
    REQUIRE(locate(c.a, c.b, record) == truth);
    ++seen[static_cast<std::size_t>(truth)];
  };
  for (const Numbers numbers : bench::all_numbers_and_ends) {
    Random random(tests::seed() + static_cast<int>(numbers));
    for (int i = 0; i < tests::cases(1500, 150000); ++i) {
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      const auto c = bench::point_and_solid::of_any_numbers<S, Solid>(random, numbers);
      ask(c);
      if (numbers > Numbers::distant) continue;
      const tests::Motion<3> move = tests::motion<3>(random);
      REQUIRE(locate(move(c.a), move(c.b)) == locate(c.a, c.b));
    }
  }
  for (const auto& family : draws) {
    Random random(tests::seed());
    for (int i = 0; i < tests::cases(500, 50000); ++i) {
      INFO("seed " << tests::seed() << ", family " << family.name << ", case " << i);
      ask(family.draw(random));
    }
  }
  for (const int often : seen) CHECK(often > 500);
}

/// Compares a method with the oracle on ordinary points, which are well inside or well outside.
template <class S, template <class> class Solid, class Method>
void check_method(const Method& method) {
  Random random(tests::seed());
  int in = 0, wrong = 0;
  for (int i = 0; i < 2000; ++i) {
    const auto c = bench::point_and_solid::ordinary<S, Solid>(random);
    const bool truth = oracle::locate(c.a, c.b) != Location::out;
    in += truth, wrong += method(c.a, c.b) != truth;
  }
  CHECK(in > 50);
  CHECK(wrong <= 2);
}

}  // namespace isect::tests::point_round_pairs
