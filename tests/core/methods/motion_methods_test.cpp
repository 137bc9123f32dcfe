// Moving objects by the times on each axis, by a quadratic, and by conservative steps: right where nothing is rounded.

#include <isect/methods/motion.h>

#include <cmath>

#include "bench/random.h"
#include "tests/catch.h"
#include "tests/core/common.h"
#include "tests/settings.h"

namespace motion_methods_test {
using namespace isect;
using bench::Random;
using motion::Bound;
using motion::Ending;
using tests::at;

namespace {

constexpr double odd = 0.3141592;  ///< added to durations: where one ends in a contact rounding decides

template <class S, int N>
Vector<S, N> whole_numbers(Random& random, int most) {
  Vector<S, N> v;
  for (int i = 0; i < N; ++i) v[i] = static_cast<S>(random.integer(-most, most));
  return v;
}
template <class S, int N>
Moving<Aabb, S, N> box(Random& random) {
  const Point<S, N> lo = whole_numbers<S, N>(random, 6);
  Vector<S, N> size;
  for (int i = 0; i < N; ++i) size[i] = static_cast<S>(random.below(5));
  return {{lo, lo + size}, whole_numbers<S, N>(random, 3)};
}
template <class S, int N>
Moving<Sphere, S, N> ball(Random& random) {
  return {{whole_numbers<S, N>(random, 6), static_cast<S>(random.below(4))}, whole_numbers<S, N>(random, 3)};
}

/// A ball of radius 3/4 at rest and one of radius 1/2: centers are 5/4 apart in contact.
template <class S, int N>
std::pair<Moving<Sphere, S, N>, Moving<Sphere, S, N>> balls(double x, double y, double speed) {
  return {{{at<S, N>(0), S(0.75)}, at<S, N>(0)}, {{at<S, N>(x, y), S(0.5)}, at<S, N>(-speed)}};
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("the trace tells the times of each axis, and what they leave", "[motion_methods]",
                       FLOATS_AND_DIMENSIONS) {
  const Vector<S, N> one = Vector<S, N>::Ones();
  const Moving<Aabb, S, N> a = {{-one, one}, at<S, N>(1)},
                           b = {{at<S, N>(5, 2), at<S, N>(6, 3) + one}, at<S, N>(-1, -1)};
  Record<motion::AxesEvent<S, N>> record;
  const std::optional<Interval<S>> times = contact_by_axes(a, b, S(4), record);
  REQUIRE(times);
  CHECK(*times == Interval<S>{S(2), S(4)});
  CHECK(std::get<motion::Relative<S, N>>(record.events[0]).d == at<S, N>(-2, -1));
  const auto x = std::get<motion::AxisTimes<S>>(record.events[1]), y = std::get<motion::AxisTimes<S>>(record.events[3]);
  CHECK((x.axis == 0 && x.begin == S(2) && x.end == S(4)));
  CHECK((y.axis == 1 && y.begin == S(1) && y.end == S(5)));
  CHECK(std::get<motion::Left<S>>(record.events[2]).holds);
  CHECK(record.events.size() == (N == 3 ? 6 : 5));
  if (N == 3) CHECK_FALSE(std::get<motion::Level>(record.events[5]).apart);
}

TEMPLATE_TEST_CASE_SIG("boxes and balls with small whole numbers meet when the exact tests say so", "[motion_methods]",
                       FLOATS_AND_DIMENSIONS) {
  Random random(bench::stream(tests::seed(), "whole numbers that move"));
  const S close = std::sqrt(std::numeric_limits<S>::epsilon());
  int boxes_meet = 0, boxes_miss = 0, balls_meet = 0, balls_miss = 0;
  for (int i = 0; i < tests::cases(2000, 50000); ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    const S duration = static_cast<S>(random.below(6)) + S(odd);
    const auto a = box<S, N>(random), b = box<S, N>(random);
    const std::optional<Interval<S>> times = contact_by_axes(a, b, duration), truth = contact(a, b, duration);
    if (times.has_value() != truth.has_value()) FAIL("boxes");
    if (times && (std::abs(times->lo - truth->lo) > close || std::abs(times->hi - truth->hi) > close)) FAIL("times");
    ++(times ? boxes_meet : boxes_miss);

    const auto c = ball<S, N>(random), d = ball<S, N>(random);
    const std::optional<S> first = first_contact(c, d, duration), found = contact_by_quadratic(c, d, duration);
    if (found.has_value() != first.has_value()) FAIL("balls");
    if (found && std::abs(*found - *first) > 10 * close) FAIL("time");
    ++(found ? balls_meet : balls_miss);
  }
  CHECK((boxes_meet > 100 && boxes_miss > 100 && balls_meet > 100 && balls_miss > 100));
}

TEST_CASE("at great speed rounding invents a contact of boxes, and loses one of balls", "[motion_methods]") {
  const Moving<Aabb, double, 2> a = {{{-1.1 - 0.7, -0.4 - 0.7}, {-1.1 + 0.7, -0.4 + 0.7}}, {500000.1, 300000.1}},
                                b = {{{4.16 - 0.5, 0.72 - 0.5}, {4.16 + 0.5, 0.72 + 0.5}}, {-899999.9, -499999.9}};
  CHECK(contact_by_axes(a, b, 4e-6));
  CHECK_FALSE(contact(a, b, 4e-6));
  const Moving<Sphere, double, 2> c = {{{-2.1, 0}, 0.75}, {769616.6, 0}}, d = {{{1.2549, 1.25}, 0.5}, {-777559.2, 0}};
  CHECK_FALSE(contact_by_quadratic(c, d, 4e-6));
  CHECK(first_contact(c, d, 4e-6));
}

TEMPLATE_TEST_CASE_SIG("the quadratic ends where its signs say, and tells them", "[motion_methods]",
                       FLOATS_AND_DIMENSIONS) {
  const auto events = [](double x, double y, double speed, double duration) {
    const auto [a, b] = balls<S, N>(x, y, speed);
    Record<motion::QuadraticEvent<S, N>> record;
    contact_by_quadratic(a, b, static_cast<S>(duration), record);
    return record.events;
  };
  CHECK(std::get<motion::Entry<S>>(events(3.75, 1, 2, 2).back()).t == S(1.5));
  CHECK(std::get<motion::Passing<S>>(events(3, 1.25, 2, 2).at(3)).discriminant == S(0));  // grazes
  CHECK(std::get<motion::Passing<S>>(events(3, 1.5, 2, 2).back()).discriminant < S(0));
  CHECK(std::get<motion::Receding<S>>(events(2, 1, -1, 2).back()).b == S(2));
  CHECK(std::get<motion::Offset<S, N>>(events(0.75, 1, -1, 2).back()).c == S(0));  // touches at first
  CHECK(std::get<motion::Entry<S>>(events(4.25, 0, 2, 1.25).back()).late);
}

TEMPLATE_TEST_CASE_SIG("conservative steps come within the tolerance, and end with no contact where there is none",
                       "[motion_methods]", FLOATS_AND_DIMENSIONS) {
  const auto run = [](double x, double y, double duration, Bound bound) {
    const auto [a, b] = balls<S, N>(x, y, 2);
    return advance_conservatively(a, b, static_cast<S>(duration), S(0.0625), bound, 1000);
  };
  for (const Bound bound : {Bound::speed, Bound::along_centers}) {
    const auto hit = run(3.75, 1, 2, bound);
    CHECK(hit.ending == Ending::near);
    CHECK((hit.time > S(1.4) && hit.time <= S(1.5)));
    CHECK(run(0.5, 0, 2, bound).time == S(0));
    CHECK(run(3, 1.28125, 2, bound).ending == Ending::near);  // they pass within the tolerance
    CHECK(run(3, 1.75, 3, bound).ending == Ending::none);
    CHECK(run(4.25, 0, 1.25, bound).ending == Ending::none);
  }
  const auto [a, b] = balls<S, N>(3, 1.5, 2);
  CHECK(advance_conservatively(a, b, S(2), S(0), Bound::speed, 3).ending == Ending::open);
}

TEMPLATE_TEST_CASE_SIG("no conservative step leads past a contact, and the sharper bound takes no more of them",
                       "[motion_methods]", FLOATS_AND_DIMENSIONS) {
  Random random(bench::stream(tests::seed(), "conservative steps"));
  const S tolerance = S(0.01), slack = 100 * std::sqrt(std::numeric_limits<S>::epsilon());
  int near = 0, none = 0;
  for (int i = 0; i < tests::cases(1000, 20000); ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    const auto a = ball<S, N>(random), b = ball<S, N>(random);
    const S duration = static_cast<S>(random.below(6)) + S(odd);
    const std::optional<S> first = first_contact(a, b, duration);
    int steps = 0;
    for (const Bound bound : {Bound::speed, Bound::along_centers}) {
      Record<motion::AdvancementEvent<S>> record;
      const auto found = advance_conservatively(a, b, duration, tolerance, bound, 100000, record);
      REQUIRE(found.ending != Ending::open);
      if (first && (found.ending != Ending::near || found.time > *first + slack)) FAIL("past the contact");
      const Vector<S, N> way = b.shape.center - a.shape.center + found.time * (b.velocity - a.velocity);
      const S distance = std::sqrt(way.dot(way)) - a.shape.radius - b.shape.radius;
      if (found.ending == Ending::near && distance > tolerance + slack) FAIL("not near");
      if (bound == Bound::along_centers && found.steps > steps) FAIL("more steps");
      steps = found.steps;
      ++(found.ending == Ending::near ? near : none);
      int advances = 0;
      for (const auto& event : record.events) advances += std::holds_alternative<motion::Advance<S>>(event);
      if (advances != found.steps) FAIL("the trace tells other steps");
    }
  }
  CHECK((near > 100 && none > 100));
}

}  // namespace motion_methods_test
