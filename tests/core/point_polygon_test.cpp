// Points in polygons by name, by property, and against a ray in a direction that meets no vertex, in rationals.

#include <isect/methods/point_polygon.h>
#include <isect/point_polygon.h>

#include <limits>
#include <string>

#include <isect/counted.h>
#include "bench/random_shapes.h"
#include "bench/rational.h"
#include "tests/catch.h"
#include "tests/settings.h"

namespace point_polygon_test {
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
std::string both(const Winding& w) {
  const auto name = [](Location l) { return l == Location::in ? "in" : l == Location::on ? "on" : "out"; };
  return std::string(name(w.even_odd)) + " " + name(w.nonzero) +
         (w.nonzero == Location::on ? "" : " " + std::to_string(w.winding));
}

/// The truth: a ray in a random direction that meets no vertex and is parallel to no edge, so that no rule is needed.
template <class S>
Winding truth(bench::Random& random, const Point<S, 2>& point, const std::vector<Ring<S, 2>>& rings) {
  using oracle::operator-;
  const auto p = oracle::rational(point);
  for (;;) {
    const std::array<Rational, 2> d = {random.integer(-1000, 1000), random.integer(-1000, 1000)};
    Winding w = {Location::out, Location::out, 0, 0};
    bool clear = d[0] != 0 || d[1] != 0;
    for (const Ring<S, 2>& r : rings)
      for (std::size_t i = 0; i < r.size() && clear; ++i) {
        const auto a = oracle::rational(r[i]) - p, b = oracle::rational(r[(i + 1) % r.size()]) - p, e = b - a;
        if (a[0] * b[1] == a[1] * b[0] && oracle::dot(a, b) <= 0) return {Location::on, Location::on, 0, 0};
        // t d = a + s e
        const Rational turn = d[0] * e[1] - d[1] * e[0];
        if (turn == 0) {
          clear = a[0] * d[1] != a[1] * d[0] || (oracle::dot(a, d) < 0 && oracle::dot(b, d) < 0);
          continue;
        }
        const Rational t = (a[0] * e[1] - a[1] * e[0]) / turn, s = (a[0] * d[1] - a[1] * d[0]) / turn;
        if (t < 0 || s < 0 || s > 1) continue;
        clear = s != 0 && s != 1;
        ++w.crossings, w.winding += sign(turn);
      }
    if (!clear) continue;
    if (w.crossings % 2 != 0) w.even_odd = Location::in;
    if (w.winding != 0) w.nonzero = Location::in;
    return w;
  }
}

/// A ring with repeated, collinear and spiky vertices, some at the height of `point`.
template <class S>
Ring<S, 2> random_ring(bench::Random& random, Numbers numbers, const Point<S, 2>& point) {
  Ring<S, 2> r;
  const int n = random.one_in(8) ? random.below(40) : random.below(7);
  for (int i = 0; i < n; ++i) {
    Point<S, 2> v = bench::vector<S, 2>(random, numbers);
    if (random.one_in(6)) v[1] = point[1];
    if (random.one_in(6)) v[0] = point[0];
    if (random.one_in(20)) v = point;
    if (i > 0 && random.one_in(8)) v = r[random.below(i)];
    r.push_back(v);
  }
  return r;
}

/// A point anywhere, or on an edge up to rounding, and moved by up to 2 ulp.
template <class S>
void bring_to_an_edge(bench::Random& random, Point<S, 2>& p, const Ring<S, 2>& r) {
  if (r.empty()) return;
  const std::size_t i = static_cast<std::size_t>(random.below(static_cast<int>(r.size())));
  const Point<S, 2>&a = r[i], &b = r[(i + 1) % r.size()];
  const S t = random.one_in(2) ? S(0.5) : static_cast<S>(random.unit());
  p = a * (S(1) - t) + b * t;
  for (int k = 0; k < 2; ++k) p[k] = bench::moved(p[k], random.integer(-2, 2));
}

}  // namespace

TEMPLATE_TEST_CASE("a point lies in, on or out of a square of either orientation", "[point_polygon]", float, double) {
  using S = TestType;
  const Ring<S, 2> square = ring<S>({{0, 0}, {2, 0}, {2, 2}, {0, 2}}), turned(square.rbegin(), square.rend());
  CHECK(both(winding(at<S>(1, 1), square)) == "in in 1");
  CHECK(both(winding(at<S>(1, 1), turned)) == "in in -1");
  CHECK(both(winding(at<S>(3, 1), square)) == "out out 0");
  CHECK(both(winding(at<S>(-1, 1), square)) == "out out 0");
  for (const auto& [x, y] :
       {std::array{0., 0.}, {2., 0.}, {2., 2.}, {0., 2.}, {1., 0.}, {2., 1.}, {1., 2.}, {0., 1.}}) {
    CHECK(both(winding(at<S>(x, y), square)) == "on on");
    CHECK(both(winding(at<S>(x, y), turned)) == "on on");
  }
  CHECK(locate(at<S>(std::nextafter(S(2), S(3)), 1), square) == Location::out);
  CHECK(locate(at<S>(std::nextafter(S(2), S(0)), 1), square) == Location::in);
  for (const double y : {0., 2.}) CHECK(locate(at<S>(-1, y), square) == Location::out);  // in line with an edge
}

TEMPLATE_TEST_CASE("a ray through vertices counts each passage once", "[point_polygon]", float, double) {
  using S = TestType;
  const Ring<S, 2> diamond = ring<S>({{1, 0}, {0, 1}, {-1, 0}, {0, -1}});
  CHECK(both(winding(at<S>(0, 0), diamond)) == "in in 1");
  CHECK(winding(at<S>(0, 0), diamond).crossings == 1);
  CHECK(locate(at<S>(-2, 0), diamond) == Location::out);
  CHECK(locate(at<S>(-2, 1), diamond) == Location::out);

  // the closed form, min <= y <= max, counts the vertex on the ray with both of its edges
  int crossings = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Point<S, 2>&a = diamond[i], &b = diamond[(i + 1) % 4];
    const bool spans = std::min(a[1], b[1]) <= 0 && 0 <= std::max(a[1], b[1]);
    if (spans && a[0] + b[0] > 0) ++crossings;
  }
  CHECK(crossings % 2 == 0);  // it calls the centre outside
}

TEMPLATE_TEST_CASE("edges along the ray, steps and spikes are right", "[point_polygon]", float, double) {
  using S = TestType;
  const Ring<S, 2> steps = ring<S>({{0, 0}, {4, 0}, {4, 1}, {3, 1}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 3}, {0, 3}});
  CHECK(both(winding(at<S>(0.5, 1), steps)) == "in in 1");
  CHECK(both(winding(at<S>(2.5, 1), steps)) == "in in 1");
  CHECK(both(winding(at<S>(1.5, 1), steps)) == "on on");
  CHECK(both(winding(at<S>(-1, 1), steps)) == "out out 0");
  CHECK(both(winding(at<S>(5, 1), steps)) == "out out 0");

  const Ring<S, 2> spiked = ring<S>({{0, 0}, {2, 0}, {2, 1}, {5, 1}, {2, 1}, {2, 2}, {0, 2}});
  CHECK(both(winding(at<S>(1, 1), spiked)) == "in in 1");
  CHECK(both(winding(at<S>(4, 1), spiked)) == "on on");
  CHECK(both(winding(at<S>(6, 1), spiked)) == "out out 0");
  CHECK(both(winding(at<S>(3, 0.5), spiked)) == "out out 0");
}

TEMPLATE_TEST_CASE("the two rules differ where a polygon covers itself", "[point_polygon]", float, double) {
  using S = TestType;
  const Ring<S, 2> bow_tie = ring<S>({{0, 0}, {2, 2}, {2, 0}, {0, 2}});
  CHECK(both(winding(at<S>(0.5, 1), bow_tie)) == "in in 1");
  CHECK(both(winding(at<S>(1.5, 1), bow_tie)) == "in in -1");
  CHECK(both(winding(at<S>(1, 1), bow_tie)) == "on on");
  CHECK(both(winding(at<S>(1, 0.5), bow_tie)) == "out out 0");

  const Ring<S, 2> twice = ring<S>({{0, 0}, {3, 0}, {3, 3}, {0, 3}, {0, 0}, {3, 0}, {3, 3}, {0, 3}});
  CHECK(both(winding(at<S>(1, 1), twice)) == "out in 2");
  CHECK(locate(at<S>(1, 1), twice, FillRule::nonzero) == Location::in);
  CHECK(locate(at<S>(1, 1), twice) == Location::out);

  const Ring<S, 2> outer = ring<S>({{0, 0}, {9, 0}, {9, 9}, {0, 9}}), hole = ring<S>({{3, 3}, {6, 3}, {6, 6}, {3, 6}});
  CHECK(both(winding(at<S>(4, 4), Polygon<S, 2>{{outer, hole}})) == "out in 2");
  CHECK(both(winding(at<S>(4, 4), Polygon<S, 2>{{outer, {hole.rbegin(), hole.rend()}}})) == "out out 0");
  CHECK(both(winding(at<S>(4, 3), Polygon<S, 2>{{outer, hole}})) == "on on");
  CHECK(both(winding(at<S>(1, 4), Polygon<S, 2>{{outer, hole}})) == "in in 1");
}

TEMPLATE_TEST_CASE("rings without area have a boundary only", "[point_polygon]", float, double) {
  using S = TestType;
  CHECK(both(winding(at<S>(0, 0), Polygon<S, 2>{})) == "out out 0");
  CHECK(both(winding(at<S>(0, 0), Ring<S, 2>{})) == "out out 0");
  CHECK(both(winding(at<S>(1, 2), ring<S>({{1, 2}}))) == "on on");
  CHECK(both(winding(at<S>(0, 2), ring<S>({{1, 2}}))) == "out out 0");
  CHECK(both(winding(at<S>(1, 2), ring<S>({{1, 2}, {1, 2}, {1, 2}}))) == "on on");
  for (const auto& [x, y] : {std::array{0., 0.}, {1., 1.}, {2., 2.}})
    CHECK(both(winding(at<S>(x, y), ring<S>({{0, 0}, {2, 2}}))) == "on on");
  CHECK(both(winding(at<S>(1, 0.5), ring<S>({{0, 0}, {2, 2}}))) == "out out 0");
  CHECK(both(winding(at<S>(-1, 0), ring<S>({{0, 0}, {2, 0}, {1, 0}}))) == "out out 0");
  CHECK(both(winding(at<S>(-0.0, 0.0), ring<S>({{0.0, -0.0}}))) == "on on");
}

TEMPLATE_TEST_CASE("NaN and infinite coordinates meet nothing, wherever they stand", "[point_polygon]", float, double) {
  using S = TestType;
  const S inf = std::numeric_limits<S>::infinity(), nan = std::numeric_limits<S>::quiet_NaN();
  const Ring<S, 2> square = ring<S>({{0, 0}, {2, 0}, {2, 2}, {0, 2}});
  for (const S bad : {nan, inf, -inf})
    for (int axis = 0; axis < 2; ++axis) {
      Point<S, 2> p = at<S>(1, 1);
      p[axis] = bad;
      CHECK(both(winding(p, square)) == "out out 0");
      for (std::size_t n : {4, 30})
        for (std::size_t i = 0; i < n; ++i) {
          Ring<S, 2> broken = square;
          while (broken.size() < n) broken.push_back(at<S>(0, 1));
          broken[i][axis] = bad;
          CHECK(both(winding(at<S>(1, 1), broken)) == "out out 0");
          CHECK(both(winding(at<S>(1, 0), broken)) == "out out 0");  // on the first edge
          CHECK(both(winding(at<S>(1, 1), Polygon<S, 2>{{square, broken}})) == "out out 0");
          CHECK(both(winding(at<S>(1, 0), Polygon<S, 2>{{square, broken}})) == "out out 0");
        }
    }
}

TEMPLATE_TEST_CASE("the largest and the smallest numbers are as good as others", "[point_polygon]", float, double) {
  using S = TestType;
  for (const S k :
       {std::numeric_limits<S>::max(), std::numeric_limits<S>::min(), std::numeric_limits<S>::denorm_min()}) {
    const Ring<S, 2> diamond = {{k, 0}, {0, k}, {-k, 0}, {0, -k}};
    CHECK(both(winding(at<S>(0, 0), diamond)) == "in in 1");
    CHECK(both(winding(Point<S, 2>(k, k), diamond)) == "out out 0");
    CHECK(both(winding(Point<S, 2>(k, 0), diamond)) == "on on");
  }
  Ring<S, 2> many;  // the sum of a run overflows, though each coordinate is finite
  const S most = std::numeric_limits<S>::max();
  for (int i = 0; i < 20; ++i) many.push_back({most, i % 2 == 0 ? most : most / 2});
  many.push_back({-most, -most});
  CHECK(locate(at<S>(0, 0), many) == Location::on);
}

TEST_CASE("point and polygon: the published hard cases are decided rightly", "[point_polygon]") {
  const Ring<double, 2> triangle = {{0, 0}, {0, 172}, {100, 0}};
  CHECK(locate(Point<double, 2>(25.374625374625374, 128.35564435564436), triangle) == Location::out);
}

TEST_CASE("points of Kettner's grids lie on their true side of an edge", "[point_polygon]") {
  bench::Random random(tests::seed());
  using Case = std::pair<Point<double, 2>, Ring<double, 2>>;
  const Case cases[] = {
      {{.5, .5}, {{-24, -24}, {24, 24}, {24, -24}}},
      {{.5, .5}, {{-17.300000000000001, -17.300000000000001}, {24.00000000000005, 24.0000000000000517765}, {24, -30}}},
      {{.5, .5}, {{-8.8000000000000007, -8.8000000000000007}, {12.1, 12.1}, {12, -12}}}};
  for (const auto& [corner, triangle] : cases) {
    int counts[3] = {};
    for (int i = 0; i < 64; ++i)
      for (int j = 0; j < 64; ++j) {
        const Point<double, 2> p = {corner[0] + i * 0x1p-53, corner[1] + j * 0x1p-53};
        const Location l = locate(p, triangle);
        REQUIRE(l == truth<double>(random, p, {triangle}).even_odd);
        ++counts[static_cast<int>(l)];
      }
    CHECK(std::min(counts[0], counts[2]) > 0);
  }
}

TEMPLATE_TEST_CASE("locations agree with rational arithmetic", "[point_polygon]", float, double) {
  using S = TestType;
  bench::Random random(tests::seed());
  int counts[3] = {}, differ = 0;
  for (const Numbers numbers : bench::all_numbers)
    for (int i = 0; i < tests::cases(1200, 250000); ++i) {
      INFO("seed " << tests::seed() << ", family " << static_cast<int>(numbers) << ", case " << i);
      Point<S, 2> p = bench::vector<S, 2>(random, numbers);
      std::vector<Ring<S, 2>> rings;
      do rings.push_back(random_ring(random, numbers, p));
      while (random.one_in(4));
      if (random.one_in(2)) bring_to_an_edge(random, p, rings[0]);
      const Winding w = winding(p, Polygon<S, 2>{rings}), expected = truth(random, p, rings);
      if (both(w) != both(expected)) REQUIRE(both(w) == both(expected));
      ++counts[static_cast<int>(w.even_odd)];
      differ += w.even_odd != w.nonzero;
    }
  const int all = counts[0] + counts[1] + counts[2];
  for (const int count : counts) CHECK(count > all / 20);
  CHECK(differ > all / 200);
}

TEMPLATE_TEST_CASE("answers do not depend on how a ring is written down", "[point_polygon]", float, double) {
  using S = TestType;
  bench::Random random(tests::seed());
  for (const Numbers numbers : bench::all_numbers)
    for (int i = 0; i < tests::cases(300, 100000); ++i) {
      INFO("seed " << tests::seed() << ", family " << static_cast<int>(numbers) << ", case " << i);
      Point<S, 2> p = bench::vector<S, 2>(random, numbers);
      Ring<S, 2> r = random_ring(random, numbers, p);
      if (random.one_in(2)) bring_to_an_edge(random, p, r);
      const Winding w = winding(p, r);

      Record<point_polygon::Event> record;
      const Winding traced = winding(p, r, record);
      if (both(traced) != both(w) || traced.crossings != w.crossings) REQUIRE(both(traced) == both(w));

      Ring<S, 2> turned = r;
      if (!r.empty())
        std::rotate(turned.begin(), turned.begin() + random.below(static_cast<int>(r.size())), turned.end());
      if (both(winding(p, turned)) != both(w)) REQUIRE(both(winding(p, turned)) == both(w));

      const Winding reversed_ring = winding(p, Ring<S, 2>(r.rbegin(), r.rend()));
      REQUIRE(reversed_ring.winding == -w.winding);
      REQUIRE(reversed_ring.even_odd == w.even_odd);

      Ring<S, 2> swapped = r;
      for (Point<S, 2>& v : swapped) std::swap(v[0], v[1]);
      const Winding mirrored = winding(Point<S, 2>(p[1], p[0]), swapped);
      REQUIRE(mirrored.winding == -w.winding);
      REQUIRE(mirrored.even_odd == w.even_odd);

      Ring<S, 2> doubled;  // every vertex twice, and every edge there and back and there
      for (std::size_t k = 0; k < r.size(); ++k)
        for (const std::size_t j : {k, k, (k + 1) % r.size(), k}) doubled.push_back(r[j]);
      if (both(winding(p, doubled)) != both(w)) REQUIRE(both(winding(p, doubled)) == both(w));
    }
}

TEMPLATE_TEST_CASE("rings of any length get the same answers in the widest vectors", "[point_polygon]", float, double) {
  using S = TestType;
  bench::Random random(tests::seed());
  int counts[3] = {}, certain = 0, open = 0;
  for (const Numbers numbers : bench::all_numbers)
    for (int i = 0; i < tests::cases(25, 5000); ++i) {
      INFO("seed " << tests::seed() << ", family " << static_cast<int>(numbers) << ", case " << i);
      Point<S, 2> p = bench::vector<S, 2>(random, numbers);
      Ring<S, 2> r;
      const std::size_t least = static_cast<std::size_t>(random.one_in(8) ? 2100 : 1 + random.below(100));
      while (r.size() < least || !random.one_in(40)) {
        const Point<S, 2> around = bench::vector<S, 2>(random, numbers);
        for (int k = random.below(30); k >= 0; --k) r.push_back(random.one_in(200) ? p : around);
        for (Point<S, 2>* v = &r.back(); v > &r.front() && random.one_in(2); --v)
          (*v)[random.below(2)] = bench::number<S>(random, numbers);
      }
      const std::size_t some = static_cast<std::size_t>(random.below(static_cast<int>(r.size())));
      const S inf = std::numeric_limits<S>::infinity();
      if (random.one_in(8)) r[some][random.below(2)] = random.one_in(2) ? inf : inf - inf;
      if (random.one_in(2)) {  // then p is not a vertex
        for (Point<S, 2>& v : r)
          if (v == p) v[0] = bench::moved(v[0], random.one_in(2) ? 1 : -1);
      }
      Record<point_polygon::Event> record;
      const Winding w = winding(p, r), all = winding(p, r, record);
      REQUIRE(both(w) == both(all));
      REQUIRE(w.crossings == all.crossings);
      ++counts[static_cast<int>(w.even_odd)];
      if (w.even_odd == Location::on || r.size() < point_polygon::detail::Scan<S>::few) continue;

      for (int set = 0; set <= static_cast<int>(widest()); ++set) {
        int crossings = 0, turns = 0;
        bool every_finite = true;
        for (std::size_t first = 0; first < r.size();) {
          const std::size_t most = std::min(point_polygon::detail::Scan<S>::most, r.size() - first),
                            last = first + 1 + static_cast<std::size_t>(random.below(static_cast<int>(most)));
          point_polygon::detail::Scanned scanned;
          const Point<S, 2>& before = first > 0 ? r[first - 1] : r.back();
          simd::run(static_cast<InstructionSet>(set),
                    point_polygon::detail::Scan<S>{p, r, before, first, last, scanned});
          every_finite &= scanned.finite;
          crossings += scanned.crossings, turns += scanned.winding, certain += scanned.crossings;
          for (std::size_t k = 0; k < scanned.words; ++k)
            for (std::size_t bit = 0; bit < 64; ++bit) {
              if (!(scanned.open[k].bits >> bit & 1)) continue;
              const std::size_t end = scanned.open[k].first + bit / 2;
              REQUIRE((bit % 2 == 0 && first <= end && end < last));
              const Point<S, 2>&a = end > 0 ? r[end - 1] : r.back(), &b = r[end];
              ++open;
              if ((a[1] > p[1]) == (b[1] > p[1]) || !finite(a) || !finite(b)) continue;
              const int up = b[1] > p[1] ? 1 : -1;
              const bool counts_too =
                  up == orient2d(a.template cast<double>(), b.template cast<double>(), p.template cast<double>());
              crossings += counts_too, turns += counts_too ? up : 0;
            }
          first = last;
        }
        REQUIRE(every_finite == finite(r));
        if (!every_finite) continue;
        REQUIRE(crossings == all.crossings);
        REQUIRE(turns == all.winding);
      }
    }
  for (const int count : counts) CHECK(count > 5);
  CHECK(certain > 1000);
  CHECK(open > 1000);
}

TEST_CASE("the events tell every edge", "[point_polygon]") {
  using point_polygon::Edge, point_polygon::Passage;
  const Polygon<double, 2> polygon = {{{{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 1}, {0, 1}}, {{0, 9}}}};
  const auto passages = [&](double x, double y) {
    Record<point_polygon::Event> record;
    winding(Point<double, 2>(x, y), polygon, record);
    std::vector<Passage> list;
    for (const auto& event : record.events)
      if (const Edge* edge = std::get_if<Edge>(&event)) list.push_back(edge->passage);
    return list;
  };
  using enum Passage;
  CHECK(passages(3, 1) == std::vector{below, crossed_right, above, crossed_left, horizontal, below, above});
  CHECK(passages(-1, 2) == std::vector{below, below, horizontal, below, below, below, above});
  CHECK(passages(1, 1) == std::vector{below, crossed_right, above, crossed_right, on});
  CHECK(passages(4, 1) == std::vector{below, on});

  Record<point_polygon::Event> record;
  winding(Point<double, 2>(3, 1), polygon, record);
  CHECK(std::get<Edge>(record.events[1]).turn == 1);
  CHECK(std::get<Edge>(record.events[1]).index == 1);
  CHECK(std::get<Edge>(record.events.back()).ring == 1);
}

TEST_CASE("the text serves vertices of any type", "[point_polygon]") {
  // the corners of a square by number, and a point in its middle
  const std::array<int, 4> corners = {0, 1, 2, 3};
  const int xs[] = {-1, 1, 1, -1}, ys[] = {-1, -1, 1, 1};
  const point_polygon::Crossings met = point_polygon::wind(
      std::span<const int>(corners), [&](int v) { return ys[v]; }, [&](int v) { return xs[v]; },
      [&](int a, int b) { return xs[a] * ys[b] - xs[b] * ys[a] > 0 ? 1 : -1; });
  CHECK(met.crossings == 1);
  CHECK(met.winding == 1);
  CHECK_FALSE(met.on);
}

TEST_CASE("the naive methods are right away from edges, and wrong next to them", "[point_polygon]") {
  bench::Random random(tests::seed());
  int wrong = 0;
  const int count = 5000;
  for (int i = 0; i < count; ++i) {
    Point<double, 2> p = random.in_box<2>(1);
    Ring<double, 2> r;
    for (int k = 0; k < 5; ++k) r.push_back(random.in_box<2>(1));
    CHECK(point_polygon::crossings_naive(p, r) == (winding(p, r).even_odd == Location::in));
    CHECK(point_polygon::winding_naive(p, r) == winding(p, r).winding);

    bring_to_an_edge(random, p, r);
    const Winding w = winding(p, r);
    if (w.even_odd == Location::on) continue;
    wrong += point_polygon::crossings_naive(p, r) != (w.even_odd == Location::in);
  }
  CHECK(wrong > count / 100);

  using S = Counted<double>;
  const Ring<S, 2> square = {{S(0), S(0)}, {S(2), S(0)}, {S(2), S(2)}, {S(0), S(2)}};
  tally() = {};
  CHECK(point_polygon::crossings_naive(Point<S, 2>(S(1), S(1)), square));
  CHECK(tally().div == 2);
  Record<point_polygon::NaiveEvent<S>> record;
  CHECK(point_polygon::winding_naive(Point<S, 2>(S(1), S(1)), square, record) == 1);
  CHECK(record.events.size() == 6);
}

}  // namespace point_polygon_test
