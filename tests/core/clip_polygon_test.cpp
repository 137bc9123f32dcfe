#include <isect/clip_polygon.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "bench/clip_polygon/oracle.h"
#include "bench/random_shapes.h"
#include "tests/catch.h"
#include "tests/core/common.h"
#include "tests/settings.h"

namespace clip_polygon_test {
using namespace isect;
using bench::Numbers;
using bench::Random;
using oracle::Rational;
using tests::at, tests::inf, tests::not_a_number;

namespace {

/// The square [0, 4]^2.
template <class S, int N>
Ring<S, N> square() {
  return {at<S, N>(0, 0), at<S, N>(4, 0), at<S, N>(4, 4), at<S, N>(0, 4)};
}

/// Any ring, convex or not: the promise for each vertex and edge holds for all. Often through the plane's points.
template <class S, int N>
Ring<S, N> ring(Random& random, Numbers numbers) {
  Ring<S, N> r;
  for (int i = random.integer(0, 6); i > 0; --i) r.push_back(bench::vector<S, N>(random, numbers));
  return r;
}
template <class S, int N>
Plane<S, N> plane(Random& random, Numbers numbers, const Ring<S, N>& r) {
  Plane<S, N> p = {bench::vector<S, N>(random, numbers), bench::number<S>(random, numbers)};
  if (random.one_in(3)) p.normal = at<S, N>(random.integer(-2, 2), random.integer(-2, 2));
  if (r.empty() || random.one_in(3)) return p;
  const S d = -p.normal.dot(r[random.below(static_cast<int>(r.size()))]);
  if (std::isfinite(d)) p.d = d;
  return p;
}

template <int N>
Rational area2(const std::vector<oracle::Coordinates<N>>& r) {
  Rational sum = 0;
  for (std::size_t i = 0; i < r.size(); ++i) {
    const auto &a = r[i], &b = r[(i + 1) % r.size()];
    sum += a[0] * b[1] - a[1] * b[0];
  }
  return sum;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("a plane cuts a square in two", "[clip_polygon]", FLOATS_AND_DIMENSIONS) {
  const Ring<S, N> right = clip(square<S, N>(), Plane<S, N>{at<S, N>(1), S(-1)});
  CHECK(right == Ring<S, N>{at<S, N>(1, 0), at<S, N>(4, 0), at<S, N>(4, 4), at<S, N>(1, 4)});
  const Ring<S, N> corner = clip(square<S, N>(), Plane<S, N>{at<S, N>(-1, -1), S(2)});
  CHECK(corner == Ring<S, N>{at<S, N>(0, 0), at<S, N>(2, 0), at<S, N>(0, 2)});
}

TEMPLATE_TEST_CASE_SIG("a plane beside a square keeps all or nothing", "[clip_polygon]", FLOATS_AND_DIMENSIONS) {
  CHECK(clip(square<S, N>(), Plane<S, N>{at<S, N>(1), S(1)}) == square<S, N>());
  CHECK(clip(square<S, N>(), Plane<S, N>{at<S, N>(-1), S(-1)}).empty());
  CHECK(clip(square<S, N>(), Plane<S, N>{at<S, N>(1), S(0)}) == square<S, N>());
}

TEMPLATE_TEST_CASE_SIG("touching keeps the touching vertices", "[clip_polygon]", FLOATS_AND_DIMENSIONS) {
  CHECK(clip(square<S, N>(), Plane<S, N>{at<S, N>(-1), S(0)}) == Ring<S, N>{at<S, N>(0, 0), at<S, N>(0, 4)});
  CHECK(clip(square<S, N>(), Plane<S, N>{at<S, N>(-1, -1), S(0)}) == Ring<S, N>{at<S, N>(0, 0)});
  const Aabb<S, N> beside = {at<S, N>(4, 1), at<S, N>(9, 3)};
  for (const Point<S, N>& v : clip(square<S, N>(), beside)) CHECK(v[0] == S(4));
  CHECK_FALSE(clip(square<S, N>(), beside).empty());
}

TEMPLATE_TEST_CASE_SIG("a box keeps what lies in it", "[clip_polygon]", FLOATS_AND_DIMENSIONS) {
  const Ring<S, N> kept = clip(square<S, N>(), Aabb<S, N>{at<S, N>(-1, 1), at<S, N>(3, 9)});
  CHECK(kept == Ring<S, N>{at<S, N>(3, 1), at<S, N>(3, 4), at<S, N>(0, 4), at<S, N>(0, 1)});
  CHECK(clip(square<S, N>(), Aabb<S, N>{at<S, N>(0, 0), at<S, N>(4, 4)}) == square<S, N>());
  CHECK(clip(square<S, N>(), Aabb<S, N>{at<S, N>(1, 1), at<S, N>(2, 2)}).size() == 4);
  CHECK(clip(square<S, N>(), Aabb<S, N>{at<S, N>(5, 1), at<S, N>(6, 2)}).empty());
  CHECK(clip(square<S, N>(), Aabb<S, N>{at<S, N>(5, 1), at<S, N>(2, 2)}).empty());
}

TEMPLATE_TEST_CASE_SIG("what a box's plane leaves nothing of stays nothing at the planes after it", "[clip_polygon]",
                       FLOATS_AND_DIMENSIONS) {
  using namespace clip_polygon;
  const Aabb<S, N> box = {at<S, N>(5, 0), at<S, N>(9, 2)};
  Record<Event<S, N>> record;
  CHECK(clip(square<S, N>(), box, record).empty());  // all of it lies beside the first plane
  int sides = 0;
  for (const auto& event : record.events)
    if (const Side* side = std::get_if<Side>(&event)) sides += side->sign == -1;
  CHECK(sides == 4);
  CHECK(record.events.size() == 4);  // an empty ring has no vertex to ask about

  // past the corner of the box: the planes of x leave a part, those of y nothing
  const Ring<S, N> past = {at<S, N>(4, 4), at<S, N>(6, 6), at<S, N>(4, 6)};
  CHECK_FALSE(clip(past, Plane<S, N>{at<S, N>(1), S(-5)}).empty());
  CHECK(clip(past, box).empty());
  // a vertex on the first plane survives it alone
  CHECK(clip(Ring<S, N>{at<S, N>(5, 4), at<S, N>(4, 6), at<S, N>(4, 3)}, box).empty());
  CHECK(clip(Ring<S, N>{at<S, N>(5, 1), at<S, N>(4, 6), at<S, N>(4, 3)}, box).size() == 1);
}

TEMPLATE_TEST_CASE_SIG("points and segments are polygons", "[clip_polygon]", FLOATS_AND_DIMENSIONS) {
  const Plane<S, N> right = {at<S, N>(1), S(-1)};
  CHECK(clip(Ring<S, N>{at<S, N>(1)}, right).size() == 1);
  CHECK(clip(Ring<S, N>{at<S, N>(0.5)}, right).empty());
  CHECK(clip(Ring<S, N>{}, right).empty());
  for (const Point<S, N>& v : clip(Ring<S, N>{at<S, N>(0), at<S, N>(4)}, right)) CHECK((v[0] == S(1) || v[0] == S(4)));
}

TEMPLATE_TEST_CASE_SIG("NaN, infinities and a zero normal keep nothing", "[clip_polygon]", FLOATS_AND_DIMENSIONS) {
  CHECK(clip(square<S, N>(), Plane<S, N>{at<S, N>(0), S(1)}).empty());
  for (const double bad : {not_a_number, inf, -inf}) {
    CHECK(clip(square<S, N>(), Plane<S, N>{at<S, N>(1, bad), S(1)}).empty());
    CHECK(clip(square<S, N>(), Plane<S, N>{at<S, N>(1), static_cast<S>(bad)}).empty());
    CHECK(clip(Ring<S, N>{at<S, N>(0, bad), at<S, N>(1)}, Plane<S, N>{at<S, N>(1), S(9)}).empty());
    CHECK(clip(square<S, N>(), Aabb<S, N>{at<S, N>(0), at<S, N>(1, bad)}).empty());
  }
}

TEST_CASE("polygons of any size are cut where they should be", "[clip_polygon]") {
  for (const double k : {1e-300, 1e-160, 1., 1e160, 1e300}) {
    const Ring<double, 2> r = {{0, 0}, {4 * k, 0}, {0, 4 * k}};
    const Ring<double, 2> kept = clip(r, Plane<double, 2>{{-k, 0}, 0});
    CHECK(kept.size() == 2);
    const Ring<double, 2> boxed = clip(r, Aabb<double, 2>{{k, 0}, {9 * k, 9 * k}});
    REQUIRE(boxed.size() == 3);
    CHECK(boxed[2][1] == Approx(3 * k).epsilon(1e-15));
  }
}

TEMPLATE_TEST_CASE_SIG("which vertices survive, and the new ones, are those of rational arithmetic",
                       "[clip_polygon][random]", FLOATS_AND_DIMENSIONS) {
  int kept = 0, lost = 0, on = 0, cut = 0;
  double worst = 0;
  const int count = tests::cases(300, 60000);
  for (const Numbers numbers : bench::all_numbers) {
    Random random(tests::seed() + static_cast<int>(numbers));
    for (int i = 0; i < count; ++i) {
      const Ring<S, N> r = ring<S, N>(random, numbers);
      const Plane<S, N> p = plane<S, N>(random, numbers, r);
      if (p.normal == Vector<S, N>::Zero()) continue;
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      const Ring<S, N> got = clip(r, p);
      const auto expected = oracle::clipped<S, N>(r, p);
      REQUIRE(got.size() == expected.size());
      for (std::size_t k = 0; k < got.size(); ++k)
        for (int j = 0; j < N; ++j) worst = std::max(worst, oracle::ulps(got[k][j], expected[k][j]));
      int above = 0, within = 0;
      for (const Point<S, N>& v : r) {
        const Rational height = oracle::height<S, N>(p, oracle::rational<S, N>(v));
        above += height >= 0, within += height == 0;
      }
      kept += above, lost += static_cast<int>(r.size()) - above, on += within,
          cut += static_cast<int>(got.size()) - above;

      Record<clip_polygon::Event<S, N>> record;
      REQUIRE(clip(r, p, record) == got);
    }
  }
  CHECK(worst <= 2);
  for (const int often : {kept, lost, on, cut}) CHECK(often > count);
}

TEMPLATE_TEST_CASE_SIG("both sides of a cut, and both polygons at an edge, get the same new vertices",
                       "[clip_polygon][property]", FLOATS_AND_DIMENSIONS) {
  int shared = 0;
  for (const Numbers numbers : bench::all_numbers) {
    Random random(tests::seed() + 100 + static_cast<int>(numbers));
    for (int i = 0; i < 300; ++i) {
      const Ring<S, N> r = ring<S, N>(random, numbers);
      const Plane<S, N> p = plane<S, N>(random, numbers, r);
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      const auto is_new = [&](const Point<S, N>& v) { return std::find(r.begin(), r.end(), v) == r.end(); };
      const auto holds = [](const Ring<S, N>& x, const Point<S, N>& v) {
        return std::find(x.begin(), x.end(), v) != x.end();
      };
      const Ring<S, N> above = clip(r, p), below = clip(r, Plane<S, N>{-p.normal, -p.d});
      const Ring<S, N> reversed = clip(Ring<S, N>(r.rbegin(), r.rend()), p);
      REQUIRE(reversed.size() == above.size());
      for (const Point<S, N>& v : above) {
        REQUIRE(holds(reversed, v));
        if (!is_new(v)) continue;
        REQUIRE(holds(below, v));
        ++shared;
      }
    }
  }
  CHECK(shared > 300);
}

TEMPLATE_TEST_CASE_SIG("what a box keeps lies in it, with every vertex that did", "[clip_polygon][random]",
                       FLOATS_AND_DIMENSIONS) {
  int kept = 0, gone = 0, survivors = 0;
  const int count = tests::cases(300, 60000);
  for (const Numbers numbers : bench::all_numbers) {
    Random random(tests::seed() + static_cast<int>(numbers));
    for (int i = 0; i < count; ++i) {
      const Ring<S, N> r = ring<S, N>(random, numbers);
      const Point<S, N> a = bench::vector<S, N>(random, numbers), b = bench::vector<S, N>(random, numbers);
      const Aabb<S, N> box = {a.cwiseMin(b), a.cwiseMax(b)};
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      const auto inside = [&](const Point<S, N>& v) {
        return (box.lo.array() <= v.array()).all() && (v.array() <= box.hi.array()).all();
      };
      const Ring<S, N> got = clip(r, box);
      for (const Point<S, N>& v : got) REQUIRE(inside(v));
      for (const Point<S, N>& v : r)
        if (inside(v)) {
          REQUIRE(std::find(got.begin(), got.end(), v) != got.end());
          ++survivors;
        }
      kept += !got.empty(), gone += got.empty();
    }
  }
  for (const int often : {kept, gone, survivors}) CHECK(often > count / 4);
}

TEST_CASE("a triangle and a box share the area that rational arithmetic gives", "[clip_polygon][random]") {
  Random random(tests::seed());
  int shared = 0;
  for (int i = 0; i < tests::cases(1000, 100000); ++i) {
    const Ring<double, 2> r = {random.in_box<2>(1), random.in_box<2>(1), random.in_box<2>(1)};
    const Point<double, 2> a = random.in_box<2>(1), b = random.in_box<2>(1);
    const Aabb<double, 2> box = {a.cwiseMin(b), a.cwiseMax(b)};
    std::vector<oracle::Coordinates<2>> exact;
    for (const auto& v : r) exact.push_back(oracle::rational<double, 2>(v));
    for (int axis = 0; axis < 2; ++axis)
      for (const int side : {1, -1}) {  // Sutherland and Hodgman's method, without rounding
        const Rational bound = Rational(side > 0 ? box.lo[axis] : box.hi[axis]);
        std::vector<oracle::Coordinates<2>> next;
        for (std::size_t k = 0; k < exact.size(); ++k) {
          const auto &x = exact[k], &y = exact[(k + 1) % exact.size()];
          const Rational from = side * (x[axis] - bound), to = side * (y[axis] - bound);
          if (from >= 0) next.push_back(x);
          using oracle::operator-;
          using oracle::operator+;
          using oracle::operator*;
          if ((from > 0 && to < 0) || (from < 0 && to > 0)) next.push_back(x + Rational(from / (from - to)) * (y - x));
        }
        exact = next;
      }
    std::vector<oracle::Coordinates<2>> rounded;
    for (const auto& v : clip(r, box)) rounded.push_back(oracle::rational<double, 2>(v));
    INFO("seed " << tests::seed() << ", case " << i);
    REQUIRE(std::abs(static_cast<double>(Rational(area2<2>(rounded) - area2<2>(exact)))) < 1e-14);
    shared += area2<2>(exact) != 0;
  }
  CHECK(shared > 300);
}

}  // namespace clip_polygon_test
