// Convex polygons: what is one, and where a point lies, by name, by property and against half-planes in rationals.

#include <isect/methods/point_convex_polygon.h>
#include <isect/point_convex_polygon.h>

#include <limits>

#include <isect/counted.h>
#include "tests/catch.h"
#include "tests/core/hull_oracle.h"
#include "tests/settings.h"

namespace point_convex_polygon_test {
using namespace isect;
using bench::Numbers;
using oracle::Rational;

namespace {

template <class S>
Ring<S, 2> ring(std::initializer_list<std::array<double, 2>> vertices) {
  Ring<S, 2> r;
  for (const auto& [x, y] : vertices) r.push_back({static_cast<S>(x), static_cast<S>(y)});
  return r;
}
template <class S>
Point<S, 2> at(double x, double y) {
  return {static_cast<S>(x), static_cast<S>(y)};
}

/// Points (k, k^2): convex, and every wedge of its fans is a sliver.
Ring<double, 2> parabola(int n) {
  Ring<double, 2> r;
  for (double k = 0; k < n; ++k) r.push_back({k, k * k});
  return r;
}

/// The location of a point by all half-planes.
template <class S>
Location truth(const Point<S, 2>& p, const Ring<S, 2>& v) {
  bool on = false;
  for (std::size_t i = 0; i < v.size(); ++i) {
    const int turn = sign(oracle::area2(v[i], v[(i + 1) % v.size()], p));
    if (turn < 0) return Location::out;
    if (turn == 0) on = true;
  }
  return on ? Location::on : Location::in;
}

/// Whether a ring goes once around its own hull: except in one step, the places of its vertices along the boundary of
/// the hull only rise, or only fall.
template <class S>
bool goes_around(const Ring<S, 2>& r, const Ring<S, 2>& hull) {
  if (hull.size() < 3) return false;
  std::vector<Rational> places;
  for (const Point<S, 2>& p : r) {
    const std::size_t before = places.size();
    for (std::size_t i = 0; i < hull.size() && places.size() == before; ++i) {
      const Point<S, 2>&a = hull[i], &b = hull[(i + 1) % hull.size()];
      if (p == b || oracle::area2(a, b, p) != 0) continue;
      const int axis = a[0] != b[0] ? 0 : 1;
      places.push_back(Rational(i) + (Rational(p[axis]) - Rational(a[axis])) / (Rational(b[axis]) - Rational(a[axis])));
    }
    if (places.size() == before) return false;
  }
  int falls = 0, rises = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    falls += places[(i + 1) % places.size()] < places[i];
    rises += places[(i + 1) % places.size()] > places[i];
  }
  return falls == 1 || rises == 1;
}

template <class S>
std::vector<Point<S, 2>> random_points(bench::Random& random, Numbers numbers, int most) {
  std::vector<Point<S, 2>> points;
  for (int n = 3 + random.below(most); n > 0; --n) points.push_back(bench::vector<S, 2>(random, numbers));
  return points;
}

}  // namespace

TEMPLATE_TEST_CASE("a point lies in, on or out of a convex polygon", "[point_convex_polygon]", float, double) {
  using S = TestType;
  const auto square = make_convex(ring<S>({{0, 0}, {2, 0}, {2, 2}, {0, 2}}));
  REQUIRE(square);
  CHECK(locate(at<S>(1, 1), *square) == Location::in);
  for (const auto& [x, y] : {std::array{0., 0.}, {2., 0.}, {2., 2.}, {0., 2.}, {1., 0.}, {2., 1.}, {1., 2.}, {0., 1.}})
    CHECK(locate(at<S>(x, y), *square) == Location::on);
  for (const auto& [x, y] :
       {std::array{3., 0.}, {-1., 0.}, {0., 3.}, {0., -1.}, {3., 3.}, {-1., -1.}, {2., 3.}, {3., 2.}})
    CHECK(locate(at<S>(x, y), *square) == Location::out);
  CHECK(locate(at<S>(std::nextafter(S(2), S(3)), 1), *square) == Location::out);
  CHECK(locate(at<S>(std::nextafter(S(2), S(0)), 1), *square) == Location::in);
  CHECK(locate(at<S>(-0.0, -0.0), *square) == Location::on);
  for (const S bad : {std::numeric_limits<S>::quiet_NaN(), std::numeric_limits<S>::infinity()}) {
    CHECK(locate(Point<S, 2>(bad, 1), *square) == Location::out);
    CHECK(locate(Point<S, 2>(1, bad), *square) == Location::out);
  }
}

TEMPLATE_TEST_CASE("points and segments have a boundary only", "[point_convex_polygon]", float, double) {
  using S = TestType;
  const ConvexPolygon<S> none = {}, point = {ring<S>({{1, 2}})}, segment = {ring<S>({{0, 0}, {2, 2}})};
  CHECK(locate(at<S>(0, 0), none) == Location::out);
  CHECK(locate(at<S>(1, 2), point) == Location::on);
  CHECK(locate(at<S>(1, 1), segment) == Location::on);
  CHECK(locate(at<S>(3, 3), segment) == Location::out);
}

TEMPLATE_TEST_CASE("a convex ring of either orientation is taken, cleaned and turned", "[point_convex_polygon]", float,
                   double) {
  using S = TestType;
  const Ring<S, 2> untidy = ring<S>({{1, 0}, {2, 0}, {2, 0}, {2, 1}, {2, 2}, {0, 2}, {0, 1}, {0, 0}, {0.5, 0}, {1, 0}});
  for (const Ring<S, 2>& r : {untidy, Ring<S, 2>(untidy.rbegin(), untidy.rend())}) {
    const auto c = make_convex(r);
    REQUIRE(c);
    CHECK(c->vertices ==
          (r == untidy ? ring<S>({{2, 0}, {2, 2}, {0, 2}, {0, 0}}) : ring<S>({{0, 0}, {2, 0}, {2, 2}, {0, 2}})));
    CHECK(locate(at<S>(1, 1), *c) == Location::in);
  }
}

TEMPLATE_TEST_CASE("other rings are not convex polygons", "[point_convex_polygon]", float, double) {
  using S = TestType;
  const double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(make_convex(Ring<S, 2>{}));
  CHECK_FALSE(make_convex(ring<S>({{1, 1}})));
  CHECK_FALSE(make_convex(ring<S>({{1, 1}, {1, 1}, {1, 1}})));
  CHECK_FALSE(make_convex(ring<S>({{0, 0}, {1, 1}})));
  CHECK_FALSE(make_convex(ring<S>({{0, 0}, {2, 2}, {1, 1}})));
  CHECK_FALSE(make_convex(ring<S>({{0, 0}, {3, 0}, {1, 1}, {0, 3}})));                  // a dent
  CHECK_FALSE(make_convex(ring<S>({{0, 0}, {2, 2}, {2, 0}, {0, 2}})));                  // a bow-tie
  CHECK_FALSE(make_convex(ring<S>({{0, 0}, {1, 0}, {0, 1}, {0, 0}, {1, 0}, {0, 1}})));  // twice around
  CHECK_FALSE(make_convex(ring<S>({{0, 3}, {-2, -3}, {3, 1}, {-3, 1}, {2, -3}})));      // a pentagram
  CHECK_FALSE(make_convex(ring<S>({{0, 0}, {2, 0}, {3, 0}, {2, 0}, {2, 2}, {0, 2}})));  // a spike
  CHECK_FALSE(make_convex(ring<S>({{0, 0}, {2, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}})));  // back and forth
  CHECK_FALSE(make_convex(ring<S>({{0, 0}, {1, nan}, {0, 1}})));
  CHECK_FALSE(make_convex(ring<S>({{0, 0}, {inf, 0}, {0, 1}})));
}

TEST_CASE("sliver fans and closing edges are right to the last ulp", "[point_convex_polygon]") {
  for (const int n : {3, 4, 5, 100, 10000}) {
    const auto c = make_convex(parabola(n));
    REQUIRE(c);
    REQUIRE(c->vertices.size() == static_cast<std::size_t>(n));
    const double last = n - 1, step = std::max(1.0, last / 50);
    for (double x = 0; x <= last; x += step) {
      const double k = std::floor(x), lower = k * k + (x - k) * (2 * k + 1);
      if (x == k) CHECK(locate(Point<double, 2>(x, lower), *c) == Location::on);
      CHECK(locate(Point<double, 2>(x, std::nextafter(lower, -1)), *c) == Location::out);
      if (x == 0 || x == last) continue;
      // the closing edge is y = last x
      const double upper = last * std::floor(x);
      CHECK(locate(Point<double, 2>(k, upper), *c) == Location::on);
      CHECK(locate(Point<double, 2>(k, std::nextafter(upper, 1e300)), *c) == Location::out);
      if (n > 3) CHECK(locate(Point<double, 2>(k, std::nextafter(upper, 0)), *c) == Location::in);
    }
  }
}

TEMPLATE_TEST_CASE("what is convex agrees with the hull in rationals", "[point_convex_polygon]", float, double) {
  using S = TestType;
  bench::Random random(tests::seed());
  int yes = 0, all = 0;
  for (const Numbers numbers : bench::all_numbers)
    for (int i = 0; i < tests::cases(300, 20000); ++i) {
      INFO("seed " << tests::seed() << ", family " << static_cast<int>(numbers) << ", case " << i);
      Ring<S, 2> r = random_points<S>(random, numbers, 4);
      if (random.one_in(2)) r = oracle::hull(r);
      if (random.one_in(3)) std::reverse(r.begin(), r.end());
      for (int k = random.below(3); k > 0; --k) {  // a repeated vertex, or one near an edge
        const std::size_t j = static_cast<std::size_t>(random.below(static_cast<int>(r.size())));
        const Point<S, 2> middle = r[j] / S(2) + r[(j + 1) % r.size()] / S(2);
        r.insert(r.begin() + static_cast<std::ptrdiff_t>(j) + 1, random.one_in(2) ? r[j] : middle);
      }
      const Ring<S, 2> hull = oracle::hull(r);
      const auto c = make_convex(r);
      REQUIRE(c.has_value() == goes_around(r, hull));
      ++all;
      if (!c) continue;
      ++yes;
      Ring<S, 2> turned = c->vertices;
      std::rotate(turned.begin(), std::find(turned.begin(), turned.end(), hull.front()), turned.end());
      REQUIRE(turned == hull);
    }
  CHECK(yes > all / 5);
  CHECK(yes < all * 4 / 5);
}

TEMPLATE_TEST_CASE("locations agree with half-planes in rationals", "[point_convex_polygon]", float, double) {
  using S = TestType;
  bench::Random random(tests::seed());
  int counts[3] = {};
  for (const Numbers numbers : bench::all_numbers)
    for (int i = 0; i < tests::cases(60, 6000); ++i) {
      const auto c = make_convex(oracle::hull(random_points<S>(random, numbers, random.one_in(4) ? 40 : 5)));
      if (!c) continue;
      const Ring<S, 2>& v = c->vertices;
      for (int k = 0; k < 40; ++k) {
        INFO("seed " << tests::seed() << ", family " << static_cast<int>(numbers) << ", case " << i << ", point " << k);
        const auto any = [&] { return v[random.below(static_cast<int>(v.size()))]; };
        const S t = random.one_in(2) ? S(0.5) : static_cast<S>(random.unit());
        Point<S, 2> p = bench::vector<S, 2>(random, numbers);
        if (!random.one_in(4)) p = any() * (S(1) - t) + any() * t;
        if (random.one_in(2)) p[random.below(2)] = any()[random.below(2)];
        for (int axis = 0; axis < 2; ++axis) p[axis] = bench::moved(p[axis], random.integer(-1, 1));

        const Location l = locate(p, *c);
        REQUIRE(l == truth(p, v));
        ++counts[static_cast<int>(l)];
        Record<point_convex_polygon::Event> record;
        REQUIRE(locate(p, *c, record) == l);
        if (random.one_in(10)) REQUIRE(locate(p, v) == l);  // as any polygon

        ConvexPolygon<S> turned = *c;
        std::rotate(turned.vertices.begin(), std::find(turned.vertices.begin(), turned.vertices.end(), any()),
                    turned.vertices.end());
        REQUIRE(locate(p, turned) == l);
      }
    }
  const int all = counts[0] + counts[1] + counts[2];
  for (const int count : counts) CHECK(count > all / 40);
}

TEST_CASE("the events tell the fan, the wedges and the chords", "[point_convex_polygon]") {
  using namespace point_convex_polygon;
  const auto c = make_convex(parabola(5));
  Record<Event> record;
  CHECK(locate(Point<double, 2>(3, 9.5), *c, record) == Location::in);
  CHECK(std::get<Fan>(record.events.at(0)).first == 1);
  CHECK(std::get<Fan>(record.events.at(0)).last == -1);
  CHECK(std::get<Chord>(record.events.at(1)).turn == -1);
  const Wedge wedge = std::get<Wedge>(record.events.at(2));
  CHECK(wedge.lo == 2);
  CHECK(wedge.mid == 2);
  CHECK(wedge.hi == 4);
  CHECK(wedge.turn == 1);
  CHECK(std::get<Chord>(record.events.back()).turn == 1);
}

namespace {

/// How many orientations it took to locate the point.
int orientations(const Point<double, 2>& p, const ConvexPolygon<double>& polygon) {
  using namespace point_convex_polygon;
  Record<Event> record;
  locate(p, polygon, record);
  int count = 0;
  for (const Event& event : record.events)
    count += std::holds_alternative<Fan>(event) ? 2 : !std::holds_alternative<Fallback>(event);
  return count;
}

}  // namespace

TEST_CASE("n vertices take 3 + 3 lg (n - 2) orientations at most, lg rounded up, and some points do take them",
          "[point_convex_polygon]") {
  bench::Random random(tests::seed());
  INFO("seed " << tests::seed());
  std::vector<int> sizes = {100, 127, 128, 130, 131, 1000, 4098, 4099, 50'000};
  for (int n = 3; n < 70; ++n) sizes.push_back(n);
  std::size_t reached = 0;
  for (const int n : sizes) {
    const ConvexPolygon<double> polygon = {parabola(n)};
    int lg = 0, most = 0;
    while (1 << lg < n - 2) ++lg;
    const auto ask = [&](const Point<double, 2>& p) { most = std::max(most, orientations(p, polygon)); };
    for (int i = 0; i < std::min(n, 300); ++i) {
      const double k = n <= 300 ? i : random.below(n), x = k + 0.5;
      ask({k, k * k}), ask({x, k * k + k + 0.5});  // a vertex, and the middle of an edge
      for (const int ulps : {-1, 1}) ask({x, bench::moved(k * k + k + 0.5, ulps)}), ask({k, bench::moved(k * k, ulps)});
      ask({k, k * (n - 1)}), ask({k, random.uniform(0, 1. * n * n)});  // the closing edge, and anywhere
      ask({random.uniform(-1, n), random.uniform(-1, 1. * n * n)});
    }
    INFO(n << " vertices");
    CHECK(most <= 3 + 3 * lg);
    reached += most == 3 + 3 * lg;
  }
  CHECK(reached > sizes.size() * 9 / 10);
}

TEST_CASE("points away from the boundary of a round polygon take a few steps, however many vertices it has",
          "[point_convex_polygon]") {
  bench::Random random(tests::seed());
  for (const int n : {1000, 1'000'000}) {
    ConvexPolygon<double> round;
    for (int k = 0; k < n; ++k)
      round.vertices.push_back({std::cos(k * 6.283185307179586 / n), std::sin(k * 6.283185307179586 / n)});
    double steps = 0;
    for (int i = 0; i < 2000; ++i) steps += (orientations(random.in_box<2>(1.2), round) - 3) / 3.;
    INFO(n << " vertices, " << steps / 2000 << " steps on average");
    CHECK(steps / 2000 < 3);
  }
}

TEST_CASE("the naive wedges are right in plump polygons, and wrong in slivers", "[point_convex_polygon]") {
  bench::Random random(tests::seed());
  Ring<double, 2> round;
  for (int k = 0; k < 64; ++k) round.push_back({std::cos(k * 0.098174770424681), std::sin(k * 0.098174770424681)});
  const auto c = make_convex(round);
  REQUIRE(c);
  int wrong = 0;
  for (int i = 0; i < 2000; ++i) {
    const Point<double, 2> p = random.in_box<2>(1.2);
    CHECK(point_convex_polygon::wedge_naive(p, *c) == (locate(p, *c) != Location::out));

    const double x = random.uniform(1, 2), y = x + random.integer(1, 3) * 0x1p-50;
    const auto sliver = make_convex(Ring<double, 2>{{0, 0}, {3, 3}, {x, y}});
    if (!sliver) continue;
    const double t = random.unit();
    const Point<double, 2> q = {t * x + (1 - t) * 3, t * y + (1 - t) * 3};
    wrong += point_convex_polygon::wedge_naive(q, *sliver) != (locate(q, *sliver) != Location::out);
  }
  CHECK(wrong > 100);

  using S = Counted<double>;
  const ConvexPolygon<S> square = {{{S(0), S(0)}, {S(2), S(0)}, {S(2), S(2)}, {S(0), S(2)}}};
  tally() = {};
  Record<point_convex_polygon::NaiveEvent<S>> record;
  CHECK(point_convex_polygon::wedge_naive(Point<S, 2>(S(1.5), S(1)), square, record));
  CHECK(tally().div == 2);
  CHECK(record.events.size() == 4);
}

}  // namespace point_convex_polygon_test
