// Facts about rounding, roots and steps that stand in captions and in solutions of exercises. Each is computed here.

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include <fmt/format.h>

#include <isect/counted.h>
#include <isect/methods/aabb_aabb.h>
#include <isect/methods/interval_interval.h>
#include <isect/methods/motion.h>
#include <isect/methods/nearest_features.h>
#include <isect/methods/point_point.h>
#include <isect/methods/sphere_sphere.h>
#include <isect/ray_sphere.h>
#include "bench/random.h"
#include "bench/rational.h"
#include "lessons/moving_bodies/picture.h"
#include "lessons/rounding_bound/setup.h"
#include "lessons/shared/questions.h"
#include "tests/lessons/orders.h"
#include "tests/lessons/words.h"
#include "viz/text/rich_text.h"

namespace facts_of_numbers_words_test {
using namespace isect;
using namespace isect::viz;
using namespace isect::tests;
using isect::test::Contains;
using oracle::Rational;

TEST_CASE("squares that underflow let pass what is close, and nothing else", "[words]") {
  CHECK(told("points", "It holds for all points so close"));
  CHECK(told("sphere-sphere", "with ≤ all balls so small and close would seem to meet"));
  const double tolerance = 0x1p-600;
  for (const double distance : {0x1p-599, 0x1p-560, 0x1p-540, 0x1p-520, 1.0}) {
    const Point<double, 2> p(0, 0), q(distance, 0);
    const bool passes = distance <= 0x1p-540;
    CHECK(point_point::near_by_squares<double, 2>(p, q, tolerance) == passes);
    const Sphere<double, 2> a = {p, tolerance / 2}, b = {q, tolerance / 2};
    CHECK(sphere_sphere::closed_squared_distance(a, b) == passes);
    CHECK_FALSE(intersects(a, b));
  }
}

TEST_CASE("a number as read is shown as the number itself", "[words]") {
  bench::Random random = random_of("read");
  for (int k = 0; k < 2000; ++k) {
    const double x = random.uniform(-1, 1) * std::pow(10, k % 24 - 12);
    CAPTURE(x);
    CHECK(shown(lessons::as_read(x)) == shown(x));
  }
  for (const double x : {0.0, 1.0, -2.5, 99999.75, 123456.5, 1e300}) CHECK(shown(lessons::as_read(x)) == shown(x));
}

TEST_CASE("the rounding error is less than its bound where there is one", "[words]") {
  CHECK(told("rounding-bound", "the error is less than bound. So |det| ≥ bound is enough."));
  int rounded = 0;
  on_random_settings("rounding-bound", 50, [&](const Parameters& p, const Walk&) {
    const lessons::rounding_bound_lesson::Run run{lessons::rounding_bound_lesson::Setup(p)};
    if (run.overflows() || run.det.error == 0) return;
    ++rounded;
    CHECK(std::abs(run.det.error) < run.bound());
  });
  CHECK(rounded > 0);
}

TEST_CASE("a rounded height may reject a point that is not beyond the plane", "[words]") {
  CHECK(told("culling", "may reject what just touches a plane"));
  bench::Random random = random_of("heights");
  int rejected = 0;
  for (int k = 0; k < 2000; ++k) {
    const Vec3 n = random.in_box<3>(1), p = random.in_box<3>(10);
    const double d = -(n[2] * p[2] + n[1] * p[1] + n[0] * p[0]), height = n[0] * p[0] + n[1] * p[1] + n[2] * p[2] + d;
    const Rational truth = oracle::dot(oracle::rational<double, 3>(n), oracle::rational<double, 3>(p)) + Rational(d);
    rejected += height < 0 && truth >= 0;
  }
  CHECK(rejected > 0);
}

TEST_CASE("a ball's rounded radius may leave a vertex out", "[words]") {
  CHECK(solved_with("bounding-volumes", "Round such bounds outwards"));
  bench::Random random = random_of("radii");
  int left_out = 0;
  for (int k = 0; k < 200; ++k) {
    const Vec3 f = random.in_box<3>(1);
    const Rational radius(f.norm());
    const oracle::Coordinates<3> exact = oracle::rational<double, 3>(f);
    left_out += oracle::dot(exact, exact) > radius * radius;
  }
  CHECK(left_out > 0);
}

TEST_CASE("two segments take two divisions at most, and none by 0", "[words]") {
  using C = Counted<double>;
  CHECK_THAT(lesson("distance").closing->cost, Contains("Two segments: two at most"));
  CHECK_THAT(lesson("capsule-capsule").closing->cost, Contains("two divisions at most"));
  CHECK(solved_with("distance", "Lines 5 and 7 do not show what the code does then"));
  bench::Random random = random_of("divisions");
  int most = 0;
  for (int k = 0; k < 500; ++k) {
    const Segment<double, 3> a = {random.in_box<3>(1), random.in_box<3>(1)};
    const Segment<double, 3> b = {random.in_box<3>(1), random.in_box<3>(1)}, point = {b.p, b.p};
    tally() = {};
    nearest_features::places<C, 3>(cast<C>(a), cast<C>(b));
    most = std::max(most, tally().div);
    CHECK(nearest_features::places<double, 3>(a, point).t == 0);
    CHECK(nearest_features::places<double, 3>(point, a).s == 0);
  }
  CHECK(most == 2);
}

TEST_CASE("where balls almost touch, stable roots keep the digits", "[words]") {
  CHECK(told("moving-bodies", "Where the balls almost touch at first"));
  double usual = 0, stable = 0;
  for (int k = 1; k <= 50; ++k) {
    const double c = 1e-12 * k / 7, root = std::sqrt(1 - c);  // A = 1, B = -1
    const double truth = c / 2 + c * c / 8;                   // and terms in C^3
    usual = std::max(usual, std::abs(1 - root - truth) / truth);
    stable = std::max(stable, std::abs(c / (1 + root) - truth) / truth);
  }
  CHECK(usual > 1e-6);
  CHECK(stable < 1e-14);
}

TEST_CASE("between both roots the balls share points, and after the larger they part", "[words]") {
  CHECK(told("moving-bodies", "At the larger root it leaves, and the balls part."));
  const Vec2 f(4, 0.5), d(-2, 0.25);
  const double reach = 1.5, a = d.dot(d), b = f.dot(d), root = std::sqrt(b * b - a * (f.dot(f) - reach * reach));
  const double first = (-b - root) / a, second = (-b + root) / a;
  const auto distance = [&](double t) { return (f + t * d).norm(); };
  CHECK(distance(first) == Approx(reach));
  CHECK(distance(second) == Approx(reach));
  CHECK(distance((first + second) / 2) < reach);
  CHECK(distance(second + 0.01) > reach);
  const Walk graze = walk_of("moving-bodies", "graze");
  CHECK_FALSE(says(find(graze, "root")->caption, "the balls part"));  // there is one root alone
}

TEST_CASE("conservative steps come near a contact and do not reach it, unless they head for it", "[words]") {
  CHECK(told("moving-bodies", "0 is approached, and not reached"));
  const Moving<Sphere, double, 2> a = {{{0, 0}, 1}, {0, 0}}, aside = {{{10, 1.25}, 1}, {-4, 0}},
                                  straight = {{{10, 0}, 1}, {-4, 0}};
  for (const motion::Bound bound : {motion::Bound::speed, motion::Bound::along_centers}) {
    std::vector<int> steps;
    for (const double tolerance : {0.1, 1e-3, 1e-6}) {
      Record<motion::AdvancementEvent<double>> record;
      const auto found = advance_conservatively(a, aside, 5.0, tolerance, bound, 1000, record);
      CHECK(found.ending == motion::Ending::near);
      for (const auto& event : record.events)
        if (const auto* gap = std::get_if<motion::Gap<double>>(&event)) CHECK(gap->distance > 0);
      steps.push_back(found.steps);
    }
    CHECK(std::ranges::is_sorted(steps));
    CHECK(steps.back() > steps.front());
    CHECK(advance_conservatively(a, straight, 5.0, 0.0, bound, 1000).steps == 1);
  }
  int passing = 0;  // near, though they do not meet
  const auto look = [&](const Parameters& p, const Walk& walk) {
    const Step* const near = find(walk, "near");
    if (near == nullptr || lessons::moving_bodies_lesson::setup(p).first) return;
    ++passing;
    CHECK_FALSE(says(near->caption, "approached"));
  };
  for (const Preset& p : lesson("moving-bodies").presets) look(p.parameters, walk_of("moving-bodies", p.id));
  on_random_settings("moving-bodies", 300, look);
  CHECK(passing > 0);
}

TEST_CASE("a ray's tests grow as lg n, by twice as much a level", "[words]") {
  const Walk walk = walk_of("hierarchy", "growth");
  const Step& rays = *find(walk, "rays");
  CHECK_THAT(plain(rays.caption), Contains("about 1 + 2 lg n node tests"));
  CHECK_THAT(lesson("hierarchy").closing->cost, Contains("grow as lg *n*"));
  const double some = value(rays, "a ray, 1000 boxes"), most = value(rays, "a ray, 100 000 boxes");
  CHECK(most / some == Approx(std::log(1e5) / std::log(1e3)).epsilon(0.1));
  CHECK(some == Approx(1 + 2 * std::log2(1e3)).epsilon(0.3));
  CHECK(most == Approx(1 + 2 * std::log2(1e5)).epsilon(0.3));
}

TEST_CASE("what is subtracted in doubles keeps digits that floats far from the origin lose", "[words]") {
  CHECK(solved_with("robustness", "subtract in doubles, then round to floats"));
  const double camera = 1e6, at = camera + 0.01;
  CHECK(std::abs(static_cast<float>(at) - static_cast<float>(camera) - 0.01) > 0.005);
  CHECK(std::abs(static_cast<float>(at - camera) - 0.01) < 1e-8);
}

TEST_CASE("a value that differs from itself is no number", "[words]") {
  CHECK(told("points", "the one kind of value for which x ≠ x"));
  const auto equals_itself = [](double x) {  // x <= x holds
    return interval_interval::min_max(Interval<double>{x, x}, Interval<double>{x, x});
  };
  for (const double x : {0.0, -0.0, 1.0, double(INFINITY), double(-INFINITY)}) CHECK(equals_itself(x));
  CHECK_FALSE(equals_itself(NAN));
}

TEST_CASE("with a NaN no > holds, so the note's method takes boxes for ones that meet", "[words]") {
  CHECK(solved_with("aabb-aabb", "With a NaN no > holds"));
  using Box = Aabb<double, 2>;
  const Box usual = {{0, 0}, {1, 1}};
  for (const Box& box : {Box{{NAN, NAN}, {NAN, NAN}}, Box{{NAN, 0}, {NAN, 1}}, Box{{5, 0}, {NAN, 1}}}) {
    const bool beyond = box.lo.x() == 5;  // 5 > 1 holds
    CHECK(aabb_aabb::by_axis(usual, box) == !beyond);
    CHECK(aabb_aabb::by_axis(box, usual) == !beyond);
    CHECK_FALSE(intersects(usual, box));
  }
}

TEST_CASE("chained, a row of points merges into one, and by representatives it does not", "[words]") {
  CHECK(solved_with("points", "chained, all vertices of a curve would merge"));
  constexpr std::size_t many = 12;
  const auto are_near = [](std::size_t i, std::size_t j) {  // the tolerance is the spacing of the row
    const Point<double, 2> p(static_cast<double>(i), 0), q(static_cast<double>(j), 0);
    return point_point::near_by_squares<double, 2>(p, q, 1);
  };
  std::array<std::size_t, many> chain = {};  // of each point, a point of its chain
  std::iota(chain.begin(), chain.end(), std::size_t{0});
  std::vector<std::size_t> representatives;
  for (std::size_t i = 0; i < many; ++i) {
    for (std::size_t j = 0; j < i; ++j)
      if (are_near(i, j)) chain[i] = chain[j];
    if (std::ranges::none_of(representatives, [&](std::size_t r) { return are_near(i, r); }))
      representatives.push_back(i);
  }
  CHECK(std::ranges::all_of(chain, [](std::size_t of) { return of == 0; }));
  CHECK(representatives.size() == many / 2);
}

TEST_CASE("single quotients order two tests that depend on each other, and may mislead of three", "[words]") {
  CHECK(solved_with("rules-of-thumb", "So it holds for two tests that depend on each other, too."));
  CHECK(solved_with("rules-of-thumb", "single quotients may then mislead: measure whole orders"));
  bench::Random random = random_of("dependent");
  int misled = 0;
  for (int k = 0; k < 200; ++k)
    for (const std::size_t many : {2U, 3U}) {
      std::array<double, 8> weight = {};  // of the boxes that a set of tests rejects, one bit a test
      for (double& w : weight) w = random.uniform(0, 1);
      std::array<double, 3> cost = {}, rejected = {};
      for (std::size_t i = 0; i < many; ++i) cost[i] = random.uniform(1, 10);
      for (std::size_t set = 0; set < 8; ++set)
        for (std::size_t i = 0; i < many; ++i) rejected[i] += ((set >> i) & 1U) != 0 ? weight[set] : 0;
      std::vector<std::size_t> order(many);
      std::iota(order.begin(), order.end(), std::size_t{0});
      const auto expected = [&](const std::vector<std::size_t>& tests) {
        double sum = 0;
        for (std::size_t set = 0; set < 8; ++set)
          for (const std::size_t i : tests) {
            sum += weight[set] * cost[i];
            if (((set >> i) & 1U) != 0) break;
          }
        return sum;
      };
      const double least = least_of_all_orders(order, expected);
      std::ranges::sort(order, {}, [&](std::size_t i) { return cost[i] / rejected[i]; });
      if (many == 2)
        CHECK(expected(order) == Approx(least));
      else
        misled += expected(order) > 1.001 * least;
    }
  CHECK(misled > 0);
}

TEST_CASE("where a direction is not of length 1, a t is no length", "[words]") {
  CHECK(solved_with("ray-sphere", "ranges and offsets in t are no lengths"));
  const Sphere<double, 3> ball = {{0, 0, 0}, 1};
  const double distance = 5 - std::sqrt(0.75);
  for (const double length : {0.5, 1.0, 2.0, 3.0}) {
    const auto t = intersect(Ray<double, 3>{{-5, 0.5, 0}, {length, 0, 0}}, ball).surface;
    REQUIRE(t);
    CHECK(*t * length == Approx(distance));
    CHECK((*t == Approx(distance)) == (length == 1));
  }
}

TEST_CASE("a ray without direction is a point", "[words]") {
  CHECK(solved_with("ray-sphere", "ask whether o lies in the ball"));
  const Sphere<double, 3> ball = {{0, 0, 0}, 1};
  for (const Vec3& o : {Vec3(0.5, 0, 0), Vec3(0, 1, 0), Vec3(0, 1, 1)})
    CHECK(intersects(Ray<double, 3>{o, {0, 0, 0}}, ball) == (o.squaredNorm() <= 1));
}

TEST_CASE("where balls graze, steps get small, as the last one closes less of the distance than the first", "[words]") {
  const Walk walk = walk_of("moving-bodies", "steps-graze");
  const Step& last = ending(walk);
  const auto s = lessons::moving_bodies_lesson::setup(preset(lesson("moving-bodies"), "steps-graze").parameters);
  Record<motion::AdvancementEvent<double>> record;
  const auto found = advance_conservatively(s.ball_a(), s.ball_b(), s.duration, s.tolerance, s.bound, 1000, record);
  std::vector<double> distances;
  for (const auto& event : record.events)
    if (const auto* gap = std::get_if<motion::Gap<double>>(&event)) distances.push_back(gap->distance);
  const std::size_t n = distances.size();
  REQUIRE(n > 2);
  CHECK(found.steps == static_cast<int>(n) - 1);
  for (std::size_t i = 2; i < n; ++i) CHECK(distances[i - 1] - distances[i] < distances[i - 2] - distances[i - 1]);
  CHECK_THAT(plain(last.caption), Contains(fmt::format("{} steps led from", found.steps)));
  CHECK_THAT(plain(last.caption), Contains("The balls graze: as they pass, the distance shrinks ever more slowly"));
  CHECK_THAT(plain(last.caption),
             Contains(fmt::format("The first closed {} of it, the last {}.", shown(distances[0] - distances[1]),
                                  shown(distances[n - 2] - distances[n - 1]))));
}

}  // namespace facts_of_numbers_words_test
