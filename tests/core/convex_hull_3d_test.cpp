// Hulls in space by name, by property, and against Caratheodory's theorem in rationals.

#include <isect/convex_hull_3d.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <set>
#include <string>
#include <utility>

#include "bench/random_shapes.h"
#include "bench/rational.h"
#include "tests/catch.h"
#include "tests/core/growth.h"
#include "tests/settings.h"

namespace convex_hull_3d_test {
using namespace isect;
using bench::Numbers;
using oracle::Rational;
using oracle::operator-;

namespace {

template <class S>
using Points = std::vector<Point<S, 3>>;
using Exactly = std::vector<oracle::Coordinates<3>>;

/// A point is a strict vertex iff it is in no tetrahedron, triangle or segment of the others that has volume, area or
/// length, and equals none. The signs of all volumes are found once.
class Oracle {
 public:
  explicit Oracle(Exactly points) : p_(std::move(points)), signs_(p_.size() * p_.size() * p_.size() * p_.size(), 0) {
    const int n = static_cast<int>(p_.size());
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < a; ++b)
        for (int c = 0; c < b; ++c)
          for (int d = 0; d < c; ++d) {
            const auto normal = oracle::cross(p_[b] - p_[a], p_[c] - p_[a]);
            signs_[place(a, b, c, d)] = oracle::sign(oracle::dot(normal, p_[d] - p_[a]));
          }
  }

  bool vertex(int p) const {
    const int n = static_cast<int>(p_.size());
    for (int a = 0; a < n; ++a) {
      if (a == p) continue;
      if (p_[a] == p_[p]) return false;
      for (int b = 0; b < a; ++b) {
        if (b == p) continue;
        if (in_segment(p, a, b)) return false;
        for (int c = 0; c < b; ++c) {
          if (c == p) continue;
          if (in_triangle(p, a, b, c)) return false;
          for (int d = 0; d < c; ++d)
            if (d != p && in_tetrahedron(p, a, b, c, d)) return false;
        }
      }
    }
    return true;
  }

  /// The sign of the volume of four points in any order.
  int side(std::array<int, 4> i) const {
    int parity = 1;
    for (int k = 0; k < 4; ++k)
      for (int m = 0; m + 1 < 4; ++m)
        if (i[m] < i[m + 1]) std::swap(i[m], i[m + 1]), parity = -parity;
    return parity * signs_[place(i[0], i[1], i[2], i[3])];
  }

 private:
  std::size_t place(int a, int b, int c, int d) const {
    const std::size_t n = p_.size();
    return ((static_cast<std::size_t>(a) * n + static_cast<std::size_t>(b)) * n + static_cast<std::size_t>(c)) * n +
           static_cast<std::size_t>(d);
  }
  bool in_tetrahedron(int p, int a, int b, int c, int d) const {
    const int whole = side({a, b, c, d});
    return whole != 0 && side({p, b, c, d}) * whole >= 0 && side({a, p, c, d}) * whole >= 0 &&
           side({a, b, p, d}) * whole >= 0 && side({a, b, c, p}) * whole >= 0;
  }
  bool in_triangle(int p, int a, int b, int c) const {
    if (side({p, a, b, c}) != 0) return false;
    const auto normal = oracle::cross(p_[b] - p_[a], p_[c] - p_[a]);
    if (oracle::dot(normal, normal) == 0) return false;
    const auto beside = [&](int x, int y) {
      return oracle::dot(normal, oracle::cross(p_[y] - p_[x], p_[p] - p_[x])) >= 0;
    };
    return beside(a, b) && beside(b, c) && beside(c, a);
  }
  bool in_segment(int p, int a, int b) const {
    const auto turn = oracle::cross(p_[a] - p_[p], p_[b] - p_[p]);
    return oracle::dot(turn, turn) == 0 && oracle::dot(p_[a] - p_[p], p_[b] - p_[p]) <= 0;
  }

  Exactly p_;
  std::vector<int> signs_;
};

template <class S>
using Key = std::array<S, 3>;
template <class S>
std::set<Key<S>> vertex_set(const Points<S>& points) {
  std::set<Key<S>> keys;
  for (const Point<S, 3>& p : points) keys.insert({p[0], p[1], p[2]});
  return keys;
}

/// Every edge has its two triangles, Euler's formula holds, and every vertex is in some triangle.
template <class S>
void check_closed(const Hull3<S>& hull) {
  if (hull.dimension < 2) {
    REQUIRE(hull.triangles.empty());
    REQUIRE(static_cast<int>(hull.vertices.size()) == hull.dimension + 1);
    return;
  }
  REQUIRE(hull.triangles.size() == 2 * hull.vertices.size() - 4);
  std::multiset<std::pair<int, int>> edges;
  std::set<int> used;
  for (const std::array<int, 3>& t : hull.triangles)
    for (int i = 0; i < 3; ++i) edges.insert({t[i], t[(i + 1) % 3]}), used.insert(t[i]);
  REQUIRE(used.size() == hull.vertices.size());
  for (const auto& [from, to] : edges) REQUIRE(edges.count({to, from}) == edges.count({from, to}));
  if (hull.dimension == 3)
    for (const auto& edge : edges) REQUIRE(edges.count(edge) == 1);
}

/// No point is above a triangle, and no triangle is without area; by orient3d, for many points.
template <class S>
void check_below(const Hull3<S>& hull, const Points<S>& points, std::size_t step = 1) {
  for (std::size_t t = 0; t < hull.triangles.size(); t += step) {
    const auto [a, b, c] = hull.triangles[t];
    const Point<double, 3> p = hull.vertices[a].template cast<double>(), q = hull.vertices[b].template cast<double>(),
                           r = hull.vertices[c].template cast<double>();
    REQUIRE(convex_hull_3d::detail::projection(p, q, r, NoTrace{}) >= 0);
    for (const Point<S, 3>& x : points) REQUIRE(orient3d(p, q, r, x.template cast<double>()) >= 0);
  }
}

enum class Cloud { family, line, plane, near_plane, sphere, cluster, box };

template <class S>
Points<S> cloud(bench::Random& random, Cloud kind, Numbers numbers, int n) {
  Points<S> r;
  const Point<S, 3> a = bench::vector<S, 3>(random, numbers), b = bench::vector<S, 3>(random, numbers),
                    c = bench::vector<S, 3>(random, numbers);
  const int flat = random.below(3);
  for (int i = 0; i < n; ++i) {
    const S t = static_cast<S>(random.integer(0, 8)) / 16, u = static_cast<S>(random.integer(0, 8)) / 16;
    Point<S, 3> p = bench::vector<S, 3>(random, numbers);
    if (kind == Cloud::line) p = a * (S(1) - t) + b * t;
    if (kind == Cloud::plane) p = a * (S(1) - t - u) + b * t + c * u;
    if (kind == Cloud::near_plane) {
      p = a * (S(1) - t - u) + b * t + c * u;
      p[random.below(3)] = bench::moved(p[random.below(3)], random.integer(-1, 1));
    }
    if (kind == Cloud::sphere) p = random.heading<3>().cast<S>();
    if (kind == Cloud::cluster)
      for (int k = 0; k < 3; ++k) p[k] = bench::moved(a[k], random.integer(-2, 2));
    if (kind == Cloud::box) p[flat] = random.one_in(2) ? a[flat] : b[flat];
    if (i > 0 && random.one_in(8)) p = r[random.below(i)];
    r.push_back(p);
  }
  return r;
}

constexpr Cloud clouds[] = {Cloud::family, Cloud::line,    Cloud::plane, Cloud::near_plane,
                            Cloud::sphere, Cloud::cluster, Cloud::box};

template <class S>
Points<S> grid(int n) {
  Points<S> points;
  for (int x = 0; x < n; ++x)
    for (int y = 0; y < n; ++y)
      for (int z = 0; z < n; ++z) points.push_back(Point<S, 3>(S(x), S(y), S(z)));
  return points;
}

template <class S>
void shuffle(Points<S>& points, bench::Random& random) {
  for (std::size_t k = points.size(); k > 1; --k) std::swap(points[k - 1], points[random.below(static_cast<int>(k))]);
}

}  // namespace

TEMPLATE_TEST_CASE("a grid has the eight corners of its cube", "[convex_hull_3d]", float, double) {
  using S = TestType;
  bench::Random random(tests::seed());
  for (const int n : {2, 3, 5, 9}) {
    Points<S> points = grid<S>(n);
    shuffle(points, random);
    const Hull3<S> hull = convex_hull(points);
    REQUIRE(hull.vertices.size() == 8);
    CHECK(hull.triangles.size() == 12);
    check_closed(hull);
    check_below(hull, points);
    for (const Point<S, 3>& p : hull.vertices)
      for (int k = 0; k < 3; ++k) CHECK((p[k] == 0 || p[k] == S(n - 1)));
  }
}

TEMPLATE_TEST_CASE("points without volume give a polygon, two, one or no vertices", "[convex_hull_3d]", float, double) {
  using S = TestType;
  using P = Point<S, 3>;
  CHECK(convex_hull(Points<S>{}).dimension == -1);
  CHECK(convex_hull(Points<S>{P(1, 2, 3), P(1, 2, 3)}).vertices == Points<S>{P(1, 2, 3)});
  const Hull3<S> line = convex_hull(Points<S>{P(1, 1, 1), P(3, 3, 3), P(0, 0, 0), P(2, 2, 2)});
  CHECK(line.dimension == 1);
  CHECK(vertex_set(line.vertices) == vertex_set(Points<S>{P(0, 0, 0), P(3, 3, 3)}));

  for (int axis = 0; axis < 3; ++axis) {
    Points<S> square;
    for (const P& p : grid<S>(3))
      if (p[axis] == 1) square.push_back(p);
    const Hull3<S> hull = convex_hull(square);
    CHECK(hull.dimension == 2);
    CHECK(hull.vertices.size() == 4);
    CHECK(hull.triangles.size() == 4);
    check_closed(hull);
  }
  const S zero = S(0);
  CHECK(convex_hull(Points<S>{P(zero, -zero, zero), P(-zero, zero, zero)}).dimension == 0);
}

TEMPLATE_TEST_CASE("an ulp above a face makes a vertex of a point", "[convex_hull_3d]", float, double) {
  using S = TestType;
  using P = Point<S, 3>;
  const S third = S(1) / 4;
  const auto with = [&](S z) {
    return convex_hull(Points<S>{P(0, 0, 1), P(1, 0, 1), P(0, 1, 1), P(0, 0, 0), P(third, third, z)});
  };
  CHECK(with(1).vertices.size() == 4);
  CHECK(with(std::nextafter(S(1), S(0))).vertices.size() == 4);
  CHECK(with(std::nextafter(S(1), S(2))).vertices.size() == 5);
  for (const S size : {std::numeric_limits<S>::max(), std::numeric_limits<S>::denorm_min()}) {
    Points<S> octahedron = {P::Zero()};
    for (int k = 0; k < 3; ++k) octahedron.push_back(P::Unit(k) * size), octahedron.push_back(P::Unit(k) * -size);
    const Hull3<S> hull = convex_hull(octahedron);
    CHECK(hull.vertices.size() == 6);
    CHECK(hull.triangles.size() == 8);
    check_below(hull, octahedron);
  }
}

TEMPLATE_TEST_CASE("a NaN or infinite coordinate in space is refused by its number", "[convex_hull_3d]", float,
                   double) {
  using S = TestType;
  for (const S bad : {std::numeric_limits<S>::quiet_NaN(), std::numeric_limits<S>::infinity()}) {
    Points<S> points = grid<S>(2);
    points[2][1] = bad;
    CHECK_THROWS_WITH(convex_hull(points), isect::test::Contains("point 2"));
  }
}

TEMPLATE_TEST_CASE("hulls in space agree with Caratheodory in rationals", "[convex_hull_3d]", float, double) {
  using S = TestType;
  bench::Random random(tests::seed());
  int dimensions[4] = {};
  for (const Numbers numbers : bench::all_numbers)
    for (const Cloud kind : clouds)
      for (int i = 0; i < tests::cases(3, 350); ++i) {
        INFO("seed " << tests::seed() << ", family " << static_cast<int>(numbers) << ", cloud "
                     << static_cast<int>(kind) << ", case " << i);
        Points<S> points = cloud<S>(random, kind, numbers, 1 + random.below(8));
        const Hull3<S> hull = convex_hull(points);
        check_closed(hull);
        ++dimensions[hull.dimension];

        const std::set<Key<S>> once = vertex_set(points);
        Exactly exact;
        for (const Key<S>& p : once) exact.push_back({Rational(p[0]), Rational(p[1]), Rational(p[2])});
        const Oracle truth(exact);
        const std::set<Key<S>> found = vertex_set(hull.vertices);
        REQUIRE(found.size() == hull.vertices.size());
        int index = 0;
        for (const Key<S>& p : once) REQUIRE(truth.vertex(index++) == (found.count(p) == 1));
        const auto at = [&](int v) {
          const Key<S> key = {hull.vertices[v][0], hull.vertices[v][1], hull.vertices[v][2]};
          return static_cast<int>(std::distance(once.begin(), once.find(key)));
        };
        for (const auto& [a, b, c] : hull.triangles)
          for (int p = 0; p < static_cast<int>(once.size()); ++p)
            if (p != at(a) && p != at(b) && p != at(c)) REQUIRE(truth.side({at(a), at(b), at(c), p}) <= 0);

        shuffle(points, random);
        Record<convex_hull_3d::Event> record;
        REQUIRE(vertex_set(convex_hull(points, record).vertices) == found);
        for (Point<S, 3>& p : points) p = Point<S, 3>(-p[1], p[2], -p[0]);  // a rotation
        const Hull3<S> turned = convex_hull(points);
        REQUIRE(turned.vertices.size() == found.size());
        check_below(turned, points);
      }
  for (const int count : dimensions) CHECK(count > 0);
}

TEST_CASE("a point that the hull passed through is dropped, and told of", "[convex_hull_3d]") {
  bench::Random random(tests::seed());
  int dropped = 0;
  for (int i = 0; i < 1000; ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    Points<double> points(12);
    for (Point<double, 3>& p : points) p = bench::vector<double, 3>(random, Numbers::grid);
    Record<convex_hull_3d::Event> record;
    const std::set<Key<double>> found = vertex_set(convex_hull(points, record).vertices);
    for (const auto& event : record.events)
      if (const auto* e = std::get_if<convex_hull_3d::Dropped>(&event)) {
        const Point<double, 3>& p = points[e->point];
        CHECK(found.count({p[0], p[1], p[2]}) == 0);
        ++dropped;
      }
  }
  CHECK(dropped > 2);
}

TEMPLATE_TEST_CASE("larger hulls are closed, convex, and the same in any order and size", "[convex_hull_3d]", float,
                   double) {
  using S = TestType;
  bench::Random random(tests::seed());
  for (const Numbers numbers : bench::all_numbers)
    for (const Cloud kind : clouds)
      for (int i = 0; i < tests::cases(1, 10); ++i) {
        INFO("seed " << tests::seed() << ", family " << static_cast<int>(numbers) << ", cloud "
                     << static_cast<int>(kind) << ", case " << i);
        Points<S> points = cloud<S>(random, kind, numbers, tests::cases(60, 200));
        const Hull3<S> hull = convex_hull(points);
        check_closed(hull);
        check_below(hull, points, tests::long_run() ? 1 : 7);
        if (hull.dimension == 3)  // strict: its own hull keeps every vertex
          REQUIRE(convex_hull(hull.vertices).vertices == hull.vertices);
        shuffle(points, random);
        REQUIRE(vertex_set(convex_hull(points).vertices) == vertex_set(hull.vertices));
        if (numbers == Numbers::grid || numbers == Numbers::ordinary) {
          for (Point<S, 3>& p : points) p *= S(4);  // no smaller: some are subnormal
          REQUIRE(convex_hull(points).vertices.size() == hull.vertices.size());
        }
      }
}

TEST_CASE("all of many points on a sphere are vertices where none is in a plane of others", "[convex_hull_3d]") {
  bench::Random random(tests::seed());
  Points<double> points;
  for (int i = 0; i < 20000; ++i) points.push_back(random.heading<3>());
  const Hull3<double> hull = convex_hull(points);
  CHECK(hull.vertices == points);
  check_closed(hull);
  Points<double> ball = points;
  for (Point<double, 3>& p : ball) p *= std::cbrt(random.unit());
  const Hull3<double> inner = convex_hull(ball);
  check_closed(inner);
  check_below(inner, inner.vertices, 10);
}

TEST_CASE("the hull in space grows like n lg n on clouds, on surfaces, and where whole planes are full of points",
          "[convex_hull_3d]") {
  bench::Random random(tests::seed());
  INFO("seed " << tests::seed());
  using P = Point<double, 3>;
  const auto sheet = [&](double z) { return P(random.uniform(-1, 1), random.uniform(-1, 1), z); };
  const std::pair<std::string, std::function<P(int)>> families[] = {
      {"ball", [&](int) -> P { return random.heading<3>() * std::cbrt(random.unit()); }},
      {"cube", [&](int) { return random.in_box<3>(1); }},
      {"sphere", [&](int) { return random.heading<3>(); }},
      {"float sphere", [&](int) -> P { return random.heading<3>().cast<float>().cast<double>(); }},
      {"faces of a cube",
       [&](int i) {
         const P p = sheet(i % 2 ? -1 : 1);
         return P(p[i % 3], p[(i + 1) % 3], p[(i + 2) % 3]);
       }},
      {"grid", [&](int) { return P(random.below(40), random.below(40), random.below(40)); }},
      {"cylinder",
       [&](int i) {
         const Point<double, 2> p = random.heading<2>();
         return P(p[0], p[1], i % 2);
       }},
      {"two circles",
       [&](int i) {
         const double angle = 1e-4 * i;
         return P(std::cos(angle), std::sin(angle), i % 2);
       }},
      {"cone",
       [&](int i) {
         const Point<double, 2> p = random.heading<2>();
         return i == 0 ? P(0, 0, 1) : P(p[0], p[1], 0);
       }},
      {"edges of a cube",
       [&](int i) {
         P p(i & 1, i & 2 ? 1 : 0, 0);
         p[2] = random.unit();
         return P(p[i % 3], p[(i + 1) % 3], p[(i + 2) % 3]);
       }},
      {"two parabolas",
       [&](int i) {
         const double x = random.uniform(-1, 1);
         return i % 2 ? P(x, 0, x * x) : P(0, x, -1 - x * x);
       }},
      {"moment curve", [&](int i) { return P(i * 1e-4, i * i * 1e-8, i * 1e-4 * i * i * 1e-8); }},
      {"two lines", [&](int i) { return i % 2 ? P(i, 0, 0) : P(0, i, 1); }},
      {"one far away", [&](int i) -> P { return i == 0 ? P(1e9, 1e8, 1e7) : random.in_box<3>(1); }},
      {"sizes of all kinds", [&](int) -> P { return random.heading<3>() * random.magnitude(-30, 30); }},
      {"all in one place but four", [&](int i) -> P { return i < 4 ? random.in_box<3>(1) : P(0, 0, 0); }}};
  for (const auto& [name, draw] : families) {
    const auto cloud = [&, &draw = draw](int n) {  // clang before 16 captures no binding by itself
      Points<double> points;
      for (int i = 0; i < n; ++i) points.push_back(draw(i));
      shuffle(points, random);
      return points;
    };
    const double exponent = tests::growth(2000, cloud, [](const Points<double>& p) { return convex_hull(p); });
    INFO(name << ": n^" << exponent);
    CHECK(exponent < 1.5);
  }
}

}  // namespace convex_hull_3d_test
