#pragma once
// What the tests of a ray against a cylinder and against a cone share.

#include "bench/ray_cylinder/families.h"
#include "bench/ray_cylinder/oracle.h"
#include "tests/catch.h"
#include "tests/core/motion.h"
#include "tests/settings.h"

namespace isect::tests::ray_round_pairs {

using bench::Numbers, bench::Random;

/// How often each outcome occurred.
struct Seen {
  int hits = 0, misses = 0, from_within = 0, by_side = 0, by_end = 0, touches = 0;
};

/// Compares all calls with the oracle: t within 0.6 ulp by the side, within 2 by an end. The direction must not be 0.
template <class Event, class S, class Line, class Solid>
void ask(const Line& line, const Interval<S>& range, const Solid& solid, Seen& seen) {
  const auto part = intersect(line, solid);
  REQUIRE(first_hit(line, solid) == (part ? std::optional(part->lo) : std::nullopt));
  REQUIRE(intersects(line, solid) == part.has_value());
  Record<Event> record;
  REQUIRE(intersect(line, solid, record) == part);
  const bool possible = finite(line) && ray_range::has_points(range) && oracle::round_solid(solid).exists;
  if (!possible) REQUIRE_FALSE(part);
  if (!possible) return;
  const oracle::LineInConvex truth = oracle::line_in(line, solid);
  REQUIRE(part.has_value() == truth.meets(cast<double>(range)));
  (part ? seen.hits : seen.misses) += 1;
  if (!part) return;
  REQUIRE((range.lo <= part->lo && part->lo <= part->hi && part->hi <= range.hi));
  for (const bool last : {false, true}) {
    const S end = last ? range.hi : range.lo, t = last ? part->hi : part->lo;
    bool by_end = false;
    for (const auto& event : record.events)
      if (const auto* stop = std::get_if<ray_round::Stop>(&event))
        if (stop->ends == last) by_end = stop->inside && stop->at != ray_round::Limit::range;
    const bool within = std::isfinite(end) && truth.holds(oracle::Rational(end));
    if (within)
      REQUIRE(t == end);
    else
      REQUIRE(truth.is_within(t, last, by_end ? 2 : 0.6));
    (within ? seen.from_within : by_end ? seen.by_end : seen.by_side) += 1;
  }
  seen.touches += part->lo == part->hi && range.lo < range.hi;
}

/// Compares the core with the oracle on any numbers, and on the named families.
template <class S, template <class> class Solid, class Event, class Draws>
void check(const Draws& draws) {
  Seen seen;
  for (const Numbers numbers : bench::all_numbers_and_ends) {
    Random random(tests::seed() + static_cast<int>(numbers));
    for (int i = 0; i < tests::cases(700, 70000); ++i) {
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      const auto c = bench::ray_and_solid::of_any_numbers<S, Solid>(random, numbers);
      if (c.a.direction.isZero(0)) {
        const bool inside = oracle::meets(c.a, c.b);
        REQUIRE(intersects(c.a, c.b) == inside);
        REQUIRE(intersect(c.a, c.b) == (inside ? std::optional(c.a.range) : std::nullopt));
        continue;
      }
      ask<Event>(c.a, c.a.range, c.b, seen);
      const Segment<S, 3> segment = {c.a.origin, random.one_in(4) ? c.a.at(1) : Point<S, 3>(c.a.direction)};
      if (segment.p != segment.q) ask<Event>(segment, Interval<S>{0, 1}, c.b, seen);
      if (numbers > Numbers::distant) continue;
      const tests::Motion<3> move = tests::motion<3>(random);
      const Ray<S, 3> moved = {move(c.a.origin), move(Point<S, 3>(c.a.direction)), c.a.range};
      REQUIRE(intersects(moved, move(c.b)) == intersects(c.a, c.b));
    }
  }
  for (const auto& family : draws) {
    Random random(tests::seed());
    for (int i = 0; i < tests::cases(300, 30000); ++i) {
      INFO("seed " << tests::seed() << ", family " << family.name << ", case " << i);
      const auto c = family.draw(random);
      ask<Event>(c.a, c.a.range, c.b, seen);
    }
  }
  for (const int often : {seen.hits, seen.misses, seen.by_side, seen.by_end}) CHECK(often > 1000);
  for (const int often : {seen.from_within, seen.touches}) CHECK(often > 200);
}

/// Compares a method with the oracle on ordinary rays.
template <class S, template <class> class Solid, class Method>
void check_method(const Method& method) {
  Random random(tests::seed());
  int hits = 0, wrong = 0;
  for (int i = 0; i < 2000; ++i) {
    const auto c = bench::ray_and_solid::ordinary<S, Solid>(random);
    const auto truth = first_hit(c.a, c.b);
    const std::optional<S> told = method(c.a, c.b);
    hits += truth.has_value();
    wrong += told.has_value() != truth.has_value() || (truth && std::abs(*told - *truth) > S(1e-2) * *truth);
  }
  CHECK(hits > 100);
  CHECK(wrong <= 4);
}

}  // namespace isect::tests::ray_round_pairs
