#include <isect/many/motion.h>
#include <isect/methods/motion.h>

#include <limits>

#include "bench/rational.h"
#include "bench/simple_shapes.h"
#include "tests/catch.h"
#include "tests/core/common.h"
#include "tests/settings.h"

namespace motion_test {
using namespace isect;
using bench::Numbers;
using bench::Random;
using namespace isect::oracle;
using tests::at, tests::inf, tests::not_a_number;

namespace {

/// A cube of half side 1, or a ball of radius 1.
template <class S, int N>
Moving<Aabb, S, N> cube(const Point<S, N>& center, const Vector<S, N>& velocity) {
  const Vector<S, N> one = Vector<S, N>::Ones();
  return {{center - one, center + one}, velocity};
}
template <class S, int N>
Moving<Sphere, S, N> ball(const Point<S, N>& center, const Vector<S, N>& velocity) {
  return {{center, S(1)}, velocity};
}

/// The first contact. It must be the same in both orders, and the swept bounds must overlap wherever there is one.
template <template <class, int> class Shape, class S, int N>
std::optional<S> first(const Moving<Shape, S, N>& a, const Moving<Shape, S, N>& b, double duration) {
  const std::optional<S> t = first_contact(a, b, static_cast<S>(duration));
  if (first_contact(b, a, static_cast<S>(duration)) != t) FAIL("not the same from both sides");
  if (t && !may_collide(a, b, static_cast<S>(duration))) FAIL("the swept bounds miss");
  return t;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("a bullet tunnels through a wall at discrete times", "[motion]", FLOATS_AND_DIMENSIONS) {
  const Moving<Aabb, S, N> bullet = {{at<S, N>(-10), at<S, N>(-9.75, 0.25)}, at<S, N>(64)};
  Moving<Aabb, S, N> wall = {{at<S, N>(-0.5, -5), at<S, N>(0.5, 5)}, at<S, N>(0)};
  CHECK(discrete_hits(bullet, wall, S(1), 16).empty());  // every 4 units of length
  CHECK(discrete_hits(bullet, wall, S(1), 64).size() == 1);
  CHECK(may_collide(bullet, wall, S(1)));
  CHECK(first(bullet, wall, 1) == S(9.25 / 64));
  const std::optional<Interval<S>> times = contact(bullet, wall, S(1));
  REQUIRE(times);
  CHECK(times->hi == S(10.5 / 64));

  wall.velocity = bullet.velocity;  // flees as fast
  CHECK_FALSE(first(bullet, wall, 1));
  CHECK(may_collide(bullet, wall, S(1)));  // what both sweep overlaps
}

TEMPLATE_TEST_CASE_SIG("the trace tells each time, and what is swept", "[motion]", FLOATS_AND_DIMENSIONS) {
  const auto a = cube<S, N>(at<S, N>(0), at<S, N>(0)), b = cube<S, N>(at<S, N>(6), at<S, N>(-4));
  Record<motion::Event<S, N>> record;
  CHECK(discrete_hits(a, b, S(2), 4, record) == std::vector<S>{S(1), S(1.5), S(2)});
  REQUIRE(record.events.size() == 5);
  CHECK(std::get<motion::At<S>>(record.events[1]).time == S(0.5));
  CHECK_FALSE(std::get<motion::At<S>>(record.events[1]).meet);
  CHECK(std::get<motion::At<S>>(record.events[2]).meet);

  record.events.clear();
  CHECK(may_collide(a, b, S(2), record));
  const Aabb<S, N> swept = std::get<motion::Swept<S, N>>(record.events.at(0)).b;
  CHECK((swept.hi[0] == S(7) && swept.lo[0] <= S(-3) && swept.lo[0] > S(-3.001)));
  CHECK(swept.lo[1] == S(-1));

  record.events.clear();
  CHECK(first_contact(ball<S, N>(at<S, N>(0), at<S, N>(0)), ball<S, N>(at<S, N>(6), at<S, N>(-4)), S(2), record) ==
        S(1));
  CHECK(std::get<motion::Approach>(record.events.back()).discriminant == 1);
}

TEMPLATE_TEST_CASE_SIG("boxes and balls meet on their way, touch in passing, or pass", "[motion]",
                       FLOATS_AND_DIMENSIONS) {
  const auto check = [](const auto& make) {
    const auto still = make(at<S, N>(0), at<S, N>(0));
    CHECK(first(still, make(at<S, N>(6), at<S, N>(-4)), 5) == S(1));
    CHECK(first(still, make(at<S, N>(6), at<S, N>(-4)), 1) == S(1));  // at the very end
    CHECK_FALSE(first(still, make(at<S, N>(6), at<S, N>(-4)), std::nextafter(S(1), S(0))));
    CHECK(first(still, make(at<S, N>(6), at<S, N>(-4)), inf) == S(1));
    CHECK_FALSE(first(still, make(at<S, N>(6), at<S, N>(4)), 5));            // recedes
    CHECK(first(still, make(at<S, N>(1), at<S, N>(4)), 5) == S(0));          // meets already
    CHECK(first(still, make(at<S, N>(2), at<S, N>(4)), 5) == S(0));          // touches and leaves
    CHECK(first(still, make(at<S, N>(2), at<S, N>(0)), 0) == S(0));          // no time, no motion
    CHECK_FALSE(first(still, make(at<S, N>(3), at<S, N>(0)), inf));          // both still
    CHECK(first(still, make(at<S, N>(6, 2), at<S, N>(-4)), 5).has_value());  // grazes
    CHECK_FALSE(first(still, make(at<S, N>(6, std::nextafter(S(2), S(3))), at<S, N>(-4)), 5));
    CHECK_FALSE(first(still, make(at<S, N>(6), at<S, N>(-4)), -1));
    CHECK_FALSE(first(still, make(at<S, N>(6), at<S, N>(-4)), not_a_number));
    CHECK_FALSE(may_collide(still, make(at<S, N>(6), at<S, N>(-4)), S(not_a_number)));
    for (const double bad : {not_a_number, inf, -inf}) {
      CHECK_FALSE(first(still, make(at<S, N>(6), at<S, N>(bad)), 5));
      CHECK_FALSE(first(still, make(at<S, N>(bad), at<S, N>(-4)), 5));
    }
  };
  check([](const auto& center, const auto& velocity) { return cube<S, N>(center, velocity); });
  check([](const auto& center, const auto& velocity) { return ball<S, N>(center, velocity); });
  CHECK(first(ball<S, N>(at<S, N>(0), at<S, N>(0)), ball<S, N>(at<S, N>(6, 2), at<S, N>(-4)), 5) == S(1.5));
}

TEMPLATE_TEST_CASE_SIG("empty shapes meet nothing", "[motion]", FLOATS_AND_DIMENSIONS) {
  auto box = cube<S, N>(at<S, N>(0), at<S, N>(0));
  std::swap(box.shape.lo, box.shape.hi);
  CHECK_FALSE(first(box, cube<S, N>(at<S, N>(0), at<S, N>(0)), 1));
  auto none = ball<S, N>(at<S, N>(0), at<S, N>(0));
  none.shape.radius = -1;
  CHECK_FALSE(first(none, ball<S, N>(at<S, N>(0), at<S, N>(0)), 1));
  CHECK_FALSE(may_collide(none, ball<S, N>(at<S, N>(0), at<S, N>(0)), S(1)));
}

TEMPLATE_TEST_CASE_SIG("lengths of any size give the same times", "[motion]", FLOATS_AND_DIMENSIONS) {
  constexpr int most = std::numeric_limits<S>::max_exponent - 6;
  for (const int e : {-most, -most / 2, most / 2, most}) {
    const S k = std::ldexp(S(1), e);
    auto a = ball<S, N>(at<S, N>(0), at<S, N>(0)), b = ball<S, N>(at<S, N>(6, 1), at<S, N>(-4));
    const std::optional<S> t = first(a, b, 5);
    a.shape.radius *= k, b.shape.radius *= k, b.shape.center *= k, b.velocity *= k;
    CHECK(first(a, b, 5) == t);
    auto c = cube<S, N>(at<S, N>(0), at<S, N>(0)), d = cube<S, N>(at<S, N>(6, 1), at<S, N>(-4));
    c.shape = {c.shape.lo * k, c.shape.hi * k}, d.shape = {d.shape.lo * k, d.shape.hi * k}, d.velocity *= k;
    CHECK(first(c, d, 5) == S(1));
  }
}

namespace {

/// The duration, or a time after which nothing new happens: beyond all quotients of differences of numbers.
template <class S>
Rational rational_duration(S duration) {
  if (!std::isinf(duration)) return duration;
  const Rational most = std::numeric_limits<S>::max();
  return most * most * most;
}

/// The first time at which boxes meet, by dividing; nothing if they don't.
template <class S, int N>
std::optional<Rational> truth(const Moving<Aabb, S, N>& a, const Moving<Aabb, S, N>& b, S duration) {
  Rational in = 0, out = rational_duration(duration);
  for (int i = 0; i < N; ++i) {
    const Rational w = Rational(b.velocity[i]) - Rational(a.velocity[i]);
    const Rational lo = Rational(a.shape.lo[i]) - Rational(b.shape.hi[i]);
    const Rational hi = Rational(a.shape.hi[i]) - Rational(b.shape.lo[i]);
    if (w == 0 && (lo > 0 || hi < 0)) return {};
    if (w == 0) continue;
    const Rational t0 = (w > 0 ? lo : hi) / w, t1 = (w > 0 ? hi : lo) / w;
    if (t0 > in) in = t0;
    if (t1 < out) out = t1;
  }
  return in <= out ? std::optional(in) : std::nullopt;
}

/// The motion of one ball relative to the other.
template <class S, int N>
struct Distance {
  oracle::Coordinates<N> f, w;
  Rational reach;

  Distance(const Moving<Sphere, S, N>& a, const Moving<Sphere, S, N>& b)
      : f(oracle::rational(b.shape.center) - oracle::rational(a.shape.center)),
        w(oracle::rational(b.velocity) - oracle::rational(a.velocity)),
        reach(Rational(a.shape.radius) + Rational(b.shape.radius)) {}

  bool apart(const Rational& t) const {
    const auto g = f + t * w;
    return dot(g, g) > reach * reach;
  }
  /// The time from 0 to t at which they are nearest.
  Rational nearest(const Rational& t) const {
    const Rational w2 = dot(w, w);
    if (w2 == 0) return 0;
    const Rational closest = -dot(f, w) / w2;
    return closest < 0 ? Rational(0) : closest > t ? t : closest;
  }
};

/// Whether t is the first time, to 8 ulp, at which they are not apart; infinite only where that is beyond S.
template <class S, int N>
bool is_first(const Distance<S, N>& distance, S t) {
  constexpr S most = std::numeric_limits<S>::max();
  if (!distance.apart(0)) return t == 0;
  if (std::isinf(t)) return distance.apart(distance.nearest(Rational(most)));
  const S unit = t == most ? t - std::nextafter(t, S(0)) : std::nextafter(t, most) - t;
  const Rational before = Rational(t) - 8 * Rational(unit), after = Rational(t) + 8 * Rational(unit);
  return (before <= 0 || distance.apart(distance.nearest(before))) && !distance.apart(distance.nearest(after));
}

template <class S>
S a_duration(Random& random, Numbers numbers) {
  return random.one_in(8) ? S(0)
                          : std::abs(random.one_in(2) ? bench::number<S>(random, numbers) : S(random.integer(0, 9)));
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("boxes meet when rational arithmetic says so", "[motion]", FLOATS_AND_DIMENSIONS) {
  Random random(tests::seed());
  int hits = 0, misses = 0, later = 0;
  for (const Numbers numbers : bench::all_numbers)
    for (int i = 0; i < tests::cases(1000, 30000); ++i) {
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      const auto draw = [&] { return bench::vector<S, N>(random, numbers); };
      Moving<Aabb, S, N> a = {bench::box<S, N>(random, numbers), draw()},
                         b = {bench::box<S, N>(random, numbers), draw()};
      if (random.one_in(3)) a.velocity.setZero();
      if (random.one_in(4)) b.velocity[random.below(N)] = a.velocity[0];
      if (random.one_in(2))  // corner to corner, or along an edge
        for (int k = 0; k < N; ++k) {
          const S v = random.one_in(2) ? a.shape.hi[k] - b.shape.lo[k] : a.shape.lo[k] - b.shape.hi[k];
          if (std::isfinite(v)) b.velocity[k] = a.velocity[k] + (random.one_in(3) ? S(0) : v);
        }
      const S duration = a_duration<S>(random, numbers);
      if (!finite(b.velocity)) continue;

      const std::optional<Rational> t = empty(a.shape) || empty(b.shape) ? std::nullopt : truth(a, b, duration);
      const std::optional<S> found = first(a, b, double(duration));
      if (found.has_value() != t.has_value()) FAIL("wrong");
      if (found && oracle::ulps(*found, *t) > 4) FAIL("wrong time");
      Record<motion::Event<S, N>> record;
      if (first_contact(a, b, duration, record) != found) FAIL("traced differs");
      ++(found ? hits : misses);
      later += found && *found > 0;
    }
  CHECK((hits > 500 && misses > 500 && later > 200));
}

TEMPLATE_TEST_CASE_SIG("balls meet when rational arithmetic says so", "[motion]", FLOATS_AND_DIMENSIONS) {
  Random random(tests::seed());
  int hits = 0, misses = 0, later = 0;
  for (const Numbers numbers : bench::all_numbers)
    for (int i = 0; i < tests::cases(800, 12000); ++i) {
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      const auto draw = [&] { return bench::vector<S, N>(random, numbers); };
      Moving<Sphere, S, N> a = {bench::ball<S, N>(random, numbers), draw()},
                           b = {bench::ball<S, N>(random, numbers), draw()};
      if (random.one_in(3)) a.velocity.setZero();
      if (random.one_in(2)) {  // towards a place where b touches a, nearly, or passes by it
        const double reach = double(a.shape.radius) + double(b.shape.radius);
        const Vector<double, N> way =
            random.one_in(2) ? random.heading<N>() : Vector<double, N>::Unit(random.below(N)) * random.sign();
        const Vector<S, N> v = a.shape.center - b.shape.center + (way * reach).template cast<S>();
        if (finite(v)) b.velocity = a.velocity + v;
        if (random.one_in(3)) b.velocity = a.velocity, b.velocity[0] += v[0];
        if (random.one_in(3)) b.shape.center[N - 1] = a.shape.center[N - 1] + static_cast<S>(reach);
      }
      const S duration = a_duration<S>(random, numbers);
      if (!finite(b.velocity) || !finite(b.shape)) continue;

      const bool real = !empty(a.shape) && !empty(b.shape);
      const Distance<S, N> distance(a, b);
      const bool meet = real && !distance.apart(distance.nearest(rational_duration(duration)));
      const std::optional<S> found = first(a, b, double(duration));
      if (found.has_value() != meet) FAIL("wrong");
      if (found && (*found > duration || !is_first(distance, *found))) FAIL("wrong time");
      Record<motion::Event<S, N>> record;
      if (first_contact(a, b, duration, record) != found) FAIL("traced differs");
      ++(found ? hits : misses);
      later += found && *found > 0;
    }
  CHECK((hits > 500 && misses > 500 && later > 200));
}

// Up to the ends of the range: huge and subnormal speeds, gaps, radii and durations, and times near the largest and the
// least number of S.

TEST_CASE("balls meet at times near the largest double", "[motion]") {
  constexpr double most = std::numeric_limits<double>::max();
  const auto meet = [](double radius_a, double radius_b, double x, double speed, double duration) {
    return first<Sphere, double, 3>({{at<double, 3>(0), radius_a}, at<double, 3>(0)},
                                    {{at<double, 3>(x), radius_b}, at<double, 3>(speed)}, duration);
  };
  CHECK(meet(1e307, 1e307, 1.2e308, -0.6, most).value() == Approx(1e308 / 0.6).epsilon(1e-14));
  CHECK(meet(5e307, 5e307, 1.5e308, -0.3, inf).value() == Approx(5e307 / 0.3).epsilon(1e-14));
  CHECK(meet(0.9, 0, 1, -1e-309, inf).value() == Approx(1e308).epsilon(1e-14));
  CHECK(meet(0.9, 0, 1, -1e-309, 1.5e308).value() == Approx(1e308).epsilon(1e-14));
  CHECK_FALSE(meet(0.9, 0, 1, -1e-309, 0.99e308));
  CHECK(meet(0.9, 0, 1, -1e-310, inf) == inf);  // at 1e309
}

namespace {

/// A number of any size, or near the largest, the least normal or the least number of all.
template <class S>
S of_any_size(Random& random) {
  using Limits = std::numeric_limits<S>;
  switch (random.below(5)) {
    case 0:
      return static_cast<S>(random.sign()) * bench::moved(Limits::max(), -random.below(4));
    case 1:
      return static_cast<S>(random.sign()) * bench::moved(Limits::min(), random.integer(-3, 3));
    case 2:
      return static_cast<S>(random.integer(-4, 4)) * Limits::denorm_min();
    default:
      return static_cast<S>(
          std::ldexp(random.uniform(-1, 1), random.integer(Limits::min_exponent - 24, Limits::max_exponent)));
  }
}

/// Two ends of a gap that closes at a speed within a time near an end of the range, as far as S can represent it.
template <class S>
struct Race {
  S x = 0, speed = 0, duration = 0;

  explicit Race(Random& random) {
    using Limits = std::numeric_limits<S>;
    const int time = random.one_in(2)   ? Limits::max_exponent + random.integer(-2, 1)
                     : random.one_in(2) ? Limits::min_exponent - random.below(Limits::digits)
                                        : random.integer(Limits::min_exponent, Limits::max_exponent);
    const int rate = random.integer(std::max(Limits::min_exponent - 24, Limits::min_exponent - time),
                                    std::min(Limits::max_exponent, Limits::max_exponent - time));
    const double t = std::ldexp(random.uniform(0.5, 1), time), w = std::ldexp(random.uniform(0.5, 1), rate);
    x = static_cast<S>(std::min(t * w, double(Limits::max())));
    speed = -static_cast<S>(w);
    const S quotient = std::min(static_cast<S>(t), Limits::max());
    const S durations[] = {static_cast<S>(inf), Limits::max(), bench::moved(quotient, random.integer(-3, 3)),
                           std::abs(of_any_size<S>(random))};
    duration = std::abs(durations[random.below(4)]);
  }
};

}  // namespace

TEMPLATE_TEST_CASE_SIG("balls meet up to the ends of the range when rational arithmetic says so", "[motion]",
                       FLOATS_AND_DIMENSIONS) {
  Random random(bench::stream(tests::seed(), "balls at the ends"));
  int hits = 0, misses = 0, late = 0, early = 0, beyond = 0;
  for (int i = 0; i < tests::cases(2500, 100000); ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    const auto draw = [&] { return of_any_size<S>(random); };
    Moving<Sphere, S, N> a = {{at<S, N>(0), S(0)}, at<S, N>(0)}, b = a;
    const Race<S> race(random);
    if (random.one_in(4)) {
      for (int k = 0; k < N; ++k) a.shape.center[k] = draw(), b.shape.center[k] = draw(), b.velocity[k] = draw();
      a.shape.radius = std::abs(draw()), b.shape.radius = draw();
    } else {
      a.shape.radius = random.one_in(2) ? S(0) : race.x * static_cast<S>(random.uniform(0, 0.5));
      b.shape.radius = random.one_in(2) ? S(0) : std::abs(draw());
      b.shape.center[0] = race.x / 2, a.shape.center[0] = -(race.x / 2);
      b.velocity[0] = race.speed / 2, a.velocity[0] = -(race.speed / 2);
      if (random.one_in(2)) b.shape.center[1] = random.one_in(2) ? a.shape.radius : draw();
      if (random.one_in(4)) b.velocity[1] = draw();
    }
    if (!finite(b.velocity) || !finite(b.shape) || !finite(a.shape)) continue;

    const Distance<S, N> distance(a, b);
    const bool meet =
        !empty(a.shape) && !empty(b.shape) && !distance.apart(distance.nearest(rational_duration(race.duration)));
    const std::optional<S> found = first(a, b, double(race.duration));
    if (found.has_value() != meet) FAIL("wrong");
    if (found && (*found > race.duration || !is_first(distance, *found))) FAIL("wrong time");
    ++(found ? hits : misses);
    late += found && *found > std::numeric_limits<S>::max() / 4;
    early += found && *found > 0 && *found < std::numeric_limits<S>::min();
    beyond += found && std::isinf(*found);
  }
  CAPTURE(hits, misses, late, early, beyond);
  CHECK((hits > 200 && misses > 200 && late > 100 && early > 20 && beyond > 10));
}

TEMPLATE_TEST_CASE_SIG("boxes meet up to the ends of the range when rational arithmetic says so", "[motion]",
                       FLOATS_AND_DIMENSIONS) {
  Random random(bench::stream(tests::seed(), "boxes at the ends"));
  int hits = 0, misses = 0, late = 0, early = 0, beyond = 0;
  for (int i = 0; i < tests::cases(2500, 100000); ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    const auto draw = [&] { return of_any_size<S>(random); };
    const Race<S> race(random);
    Moving<Aabb, S, N> a = {{at<S, N>(0), at<S, N>(0)}, at<S, N>(0)}, b = a;
    for (int k = 0; k < N; ++k) {
      const bool raced = k == 0 ? !random.one_in(4) : random.one_in(3);
      const S lo = raced ? S(0) : draw(), hi = raced ? race.x : draw();
      a.shape.lo[k] = std::min(lo, draw()), a.shape.hi[k] = lo;
      b.shape.lo[k] = hi, b.shape.hi[k] = std::max(hi, draw());
      if (!raced && random.one_in(2)) b.shape.lo[k] = std::min(lo, hi), b.shape.hi[k] = std::max(lo, hi);
      b.velocity[k] = raced ? race.speed / 2 : random.one_in(2) ? S(0) : draw();
      a.velocity[k] = raced ? -(race.speed / 2) : random.one_in(2) ? S(0) : draw();
    }
    if (!finite(b.velocity) || !finite(a.velocity)) continue;

    const std::optional<Rational> t = empty(a.shape) || empty(b.shape) ? std::nullopt : truth(a, b, race.duration);
    const std::optional<S> found = first(a, b, double(race.duration));
    if (found.has_value() != t.has_value()) FAIL("wrong");
    if (found && oracle::ulps(*found, *t) > 4) FAIL("wrong time");
    ++(found ? hits : misses);
    late += found && *found > std::numeric_limits<S>::max() / 4;
    early += found && *found > 0 && *found < std::numeric_limits<S>::min();
    beyond += found && std::isinf(*found);
  }
  CAPTURE(hits, misses, late, early, beyond);
  CHECK((hits > 200 && misses > 200 && late > 30 && early > 20 && beyond > 0));
}

TEMPLATE_TEST_CASE_SIG("the swept box holds both ends of the way, and no more than an ulp beyond", "[motion]",
                       FLOATS_AND_DIMENSIONS) {
  Random random(tests::seed());
  for (const Numbers numbers : bench::all_numbers)
    for (int i = 0; i < tests::cases(1000, 20000); ++i) {
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      const Aabb<S, N> box = bench::box<S, N>(random, numbers);
      const Vector<S, N> way = bench::vector<S, N>(random, random.one_in(3) ? Numbers::wide : numbers);
      const Aabb<S, N> swept = swept_aabb(box, way);
      if (!finite(swept)) continue;
      for (int k = 0; k < N; ++k) {
        const Rational lo = box.lo[k], hi = box.hi[k], d = way[k];
        const Rational low = d < 0 ? Rational(lo + d) : lo, high = d > 0 ? Rational(hi + d) : hi;
        if (Rational(swept.lo[k]) > low || Rational(swept.hi[k]) < high) FAIL("does not hold it");
        if (oracle::ulps(swept.lo[k], low) > 2 || oracle::ulps(swept.hi[k], high) > 2) FAIL("too large");
      }
      if (way == Vector<S, N>::Zero() && !aabb_aabb::detail::same(swept, box)) FAIL("grown for nothing");
    }
}

}  // namespace motion_test
