// k-DOPs as polytopes, by name and against all choices of planes solved in rationals; the usual directions.

#include <isect/kdop_polytope.h>

#include <Eigen/Geometry>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include <isect/directions.h>
#include <isect/fit.h>
#include "bench/random_shapes.h"
#include "bench/rational.h"
#include "tests/catch.h"
#include "tests/settings.h"

namespace kdop_polytope_test {
using namespace isect;
using bench::Numbers;
using oracle::Rational;

namespace {

/// Gauss elimination of N rows of N + 1; nothing when there is not one solution.
template <int N>
std::optional<oracle::Coordinates<N>> solved(std::array<std::array<Rational, N + 1>, N> rows) {
  for (int column = 0; column < N; ++column) {
    int pivot = column;
    while (pivot < N && rows[pivot][column] == 0) ++pivot;
    if (pivot == N) return {};
    std::swap(rows[column], rows[pivot]);
    for (int r = 0; r < N; ++r) {
      if (r == column) continue;
      const Rational factor = rows[r][column] / rows[column][column];
      for (int i = column; i <= N; ++i) rows[r][i] -= factor * rows[column][i];
    }
  }
  oracle::Coordinates<N> x;
  for (int i = 0; i < N; ++i) x[i] = rows[i][N] / rows[i][i];
  return x;
}

template <class S, int N>
std::set<oracle::Coordinates<N>> true_vertices(const Kdop<S, N>& kdop) {
  std::set<oracle::Coordinates<N>> found;
  const int k = static_cast<int>(kdop.slabs.size());
  const auto inside = [&](const oracle::Coordinates<N>& x) {
    for (int i = 0; i < k; ++i) {
      const Rational along = oracle::dot(oracle::rational<S, N>(kdop.normals[i]), x);
      if (along < Rational(kdop.slabs[i].lo) || along > Rational(kdop.slabs[i].hi)) return false;
    }
    return true;
  };
  std::array<std::array<Rational, N + 1>, N> rows;
  const auto choose = [&](const auto& self, int row, int first) -> void {
    if (row == N) {
      if (const auto x = solved<N>(rows); x && inside(*x)) found.insert(*x);
      return;
    }
    for (int i = first; i < k; ++i)
      for (const S end : {kdop.slabs[i].lo, kdop.slabs[i].hi}) {
        const auto n = oracle::rational<S, N>(kdop.normals[i]);
        for (int j = 0; j < N; ++j) rows[row][j] = n[j];
        rows[row][N] = Rational(end);
        self(self, row + 1, i + 1);
      }
  };
  choose(choose, 0, 0);
  return found;
}

/// Checks that each edge of a face is the reverse of an edge of another face, and that Euler's formula holds.
template <class S>
void check_closed(const Polytope<S, 3>& polytope) {
  if (polytope.vertices.size() < 3) {
    REQUIRE(polytope.faces.empty());
    return;
  }
  std::map<std::pair<int, int>, int> edges;
  int count = 0;
  for (const std::vector<int>& ring : polytope.faces)
    for (std::size_t i = 0; i < ring.size(); ++i) ++edges[{ring[i], ring[(i + 1) % ring.size()]}], ++count;
  for (const auto& [edge, times] : edges) REQUIRE((times == 1 && edges.count({edge.second, edge.first}) == 1));
  REQUIRE(static_cast<int>(polytope.vertices.size() + polytope.faces.size()) - count / 2 == 2);
}

template <class S, int N>
Kdop<S, N> usual(int k) {
  Kdop<S, N> kdop = {directions<S, N>(k), {}};
  for (const Vector<S, N>& n : kdop.normals) {
    const S norm = static_cast<S>(n.squaredNorm());  // the ball's slabs, but a little wider or not
    kdop.slabs.push_back({-norm, norm});
  }
  return kdop;
}

template <class S, int N>
Kdop<S, N> random_kdop(bench::Random& random, Numbers numbers) {
  Kdop<S, N> kdop;
  if (random.one_in(2)) {
    constexpr int sets[2][4] = {{4, 8, 4, 8}, {6, 14, 18, 14}};
    kdop.normals = directions<S, N>(sets[N - 2][random.below(4)]);
  } else {
    for (int i = 0; i < N; ++i) kdop.normals.push_back(Vector<S, N>::Unit(i));
    for (int i = random.below(4); i > 0; --i) kdop.normals.push_back(bench::vector<S, N>(random, numbers));
  }
  if (random.one_in(4)) kdop.normals.push_back(kdop.normals[0]);
  if (random.one_in(3)) {
    std::vector<Point<S, N>> points(1 + random.below(6));
    for (Point<S, N>& p : points) p = bench::vector<S, N>(random, numbers);
    return fit_kdop(points, kdop.normals);
  }
  for (std::size_t i = 0; i < kdop.normals.size(); ++i) {
    const S a = bench::number<S>(random, numbers), b = random.one_in(8) ? a : bench::number<S>(random, numbers);
    kdop.slabs.push_back({std::min(a, b), std::max(a, b)});
  }
  return kdop;
}

}  // namespace

TEST_CASE("the usual directions are so many, and none twice", "[directions]") {
  for (const int k : {4, 8}) CHECK(static_cast<int>(directions<double, 2>(k).size()) == k / 2);
  for (const int k : {6, 14, 18, 26}) {
    const auto normals = directions<float, 3>(k);
    CHECK(static_cast<int>(normals.size()) == k / 2);
    for (const auto& n : normals)
      for (const auto& m : normals) CHECK((&n == &m || !(n.cross(m).isZero(0))));
  }
  CHECK_THROWS_WITH((directions<double, 3>(8)), isect::test::Contains("8 planes"));
  CHECK_THROWS_AS((directions<double, 2>(6)), std::invalid_argument);
}

TEMPLATE_TEST_CASE("solids of the usual directions have their faces", "[kdop_polytope]", float, double) {
  using S = TestType;
  CHECK(polytope(usual<S, 2>(4)).vertices == std::vector<Point<S, 2>>{{1, 1}, {-1, 1}, {-1, -1}, {1, -1}});
  const Polytope<S, 3> cube = polytope(usual<S, 3>(6));
  CHECK(cube.vertices.size() == 8);
  CHECK(cube.faces.size() == 6);
  check_closed(cube);

  Kdop<S, 3> cut = usual<S, 3>(14);  // |x| + |y| + |z| <= 2 and the cube: a cuboctahedron
  for (std::size_t i = 3; i < 7; ++i) cut.slabs[i] = {S(-2), S(2)};
  const Polytope<S, 3> cuboctahedron = polytope(cut);
  CHECK(cuboctahedron.vertices.size() == 12);
  CHECK(cuboctahedron.faces.size() == 14);
  check_closed(cuboctahedron);
  Kdop<S, 3> octahedron = cut;
  for (std::size_t i = 3; i < 7; ++i) octahedron.slabs[i] = {S(-1), S(1)};  // the cube touches its vertices
  CHECK(polytope(octahedron).vertices.size() == 6);
  CHECK(polytope(octahedron).faces.size() == 8);
}

TEMPLATE_TEST_CASE("slabs that contradict each other are empty, an ulp earlier they are not", "[kdop_polytope]", float,
                   double) {
  using S = TestType;
  Kdop<S, 2> kdop = {{{S(1), S(0)}, {S(0), S(1)}, {S(1), S(1)}}, {{0, 1}, {0, 1}, {2, 3}}};
  CHECK(polytope(kdop).vertices == std::vector<Point<S, 2>>{{1, 1}});
  kdop.slabs[2].lo = std::nextafter(S(2), S(3));
  CHECK(polytope(kdop).vertices.empty());
  kdop.slabs[2].lo = std::nextafter(S(2), S(1));
  CHECK(polytope(kdop).vertices.size() == 3);
}

TEMPLATE_TEST_CASE("flat, thin and unusable k-DOPs have answers", "[kdop_polytope]", float, double) {
  using S = TestType;
  constexpr S inf = std::numeric_limits<S>::infinity();
  Kdop<S, 3> kdop = usual<S, 3>(6);
  kdop.slabs[2] = {0, 0};
  CHECK(polytope(kdop).vertices.size() == 4);
  CHECK(polytope(kdop).faces.size() == 2);
  check_closed(polytope(kdop));
  kdop.slabs[1] = {0, 0};
  CHECK(polytope(kdop).vertices.size() == 2);
  CHECK(polytope(kdop).faces.empty());
  kdop.slabs[0] = {0, 0};
  CHECK(polytope(kdop).vertices.size() == 1);
  kdop.slabs[0] = {1, 0};
  CHECK(polytope(kdop).vertices.empty());
  kdop.slabs[0] = {0, inf};
  CHECK(polytope(kdop).vertices.empty());
  kdop.slabs[0] = {0, std::numeric_limits<S>::quiet_NaN()};
  CHECK(polytope(kdop).vertices.empty());

  kdop = usual<S, 3>(6);
  kdop.normals.push_back(Vector<S, 3>::Zero());
  kdop.slabs.push_back({-1, 1});
  CHECK(polytope(kdop).faces.size() == 6);
  kdop.slabs.back() = {1, 2};
  CHECK(polytope(kdop).vertices.empty());
  kdop.normals.resize(2), kdop.slabs.resize(2);
  CHECK_THROWS_WITH(polytope(kdop), isect::test::Contains("unbounded"));
}

TEMPLATE_TEST_CASE_SIG("vertices are those of all choices of planes in rationals", "[kdop_polytope]",
                       FLOATS_AND_DIMENSIONS) {
  bench::Random random(tests::seed());
  int none = 0, few = 0, many = 0;
  for (const Numbers numbers : bench::all_numbers)
    for (int i = 0; i < tests::cases(N == 2 ? 25 : 6, N == 2 ? 5000 : 600); ++i) {
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      const Kdop<S, N> kdop = random_kdop<S, N>(random, numbers);
      if (!finite(kdop)) continue;
      const auto truth = true_vertices(kdop);
      Record<kdop_polytope::Event<S, N>> record;
      const Polytope<S, N> found = polytope(kdop, record);
      REQUIRE(found.vertices.size() == truth.size());
      REQUIRE(polytope(kdop).vertices == found.vertices);
      (truth.empty() ? none : truth.size() <= N ? few : many) += 1;

      std::set<oracle::Coordinates<N>> left = truth;  // each is the rounding of one, where its planes meet
      std::size_t index = 0;
      for (const auto& event : record.events) {
        const auto* vertex = std::get_if<kdop_polytope::Vertex<S, N>>(&event);
        if (!vertex) continue;
        REQUIRE(vertex->at == found.vertices[index++]);
        const auto x = std::find_if(left.begin(), left.end(), [&](const auto& y) {
          return std::all_of(vertex->planes.begin(), vertex->planes.end(), [&](int plane) {
            const Interval<S>& slab = kdop.slabs[plane / 2];
            const Rational along = oracle::dot(oracle::rational<S, N>(kdop.normals[plane / 2]), y);
            return along == Rational(plane % 2 == 0 ? slab.hi : slab.lo);
          });
        });
        REQUIRE(x != left.end());
        for (int j = 0; j < N; ++j) REQUIRE(oracle::ulps(vertex->at[j], (*x)[j]) <= 2);
        left.erase(x);
      }
      REQUIRE(left.empty());
      if constexpr (N == 3)
        check_closed(found);
      else
        REQUIRE(found.faces.empty());
    }
  CHECK(none > 0);
  CHECK(few > 0);
  CHECK(many > 0);
}

TEST_CASE("normals that are all but dependent span space, whether or not doubles hold their determinant",
          "[kdop_polytope]") {
  for (const double n : {0x1p4, 0x1p16 - 1, 0x1p16, 0x1p26, 0x1p26 + 0.5}) {
    INFO(n);
    const Vector<double, 3> a(n, n - 1, 0), b(n - 1, n - 2, 0), up(0, 0, 1);  // of determinant -1
    const Kdop<double, 3> kdop = {{a, b, up}, {{0, 1}, {0, 1}, {0, 1}}};
    CHECK(polytope(kdop).vertices.size() == 8);
    CHECK(polytope(kdop).faces.size() == 6);
    CHECK_THROWS_WITH(polytope(Kdop<double, 3>{{a, 2 * a, up}, kdop.slabs}), isect::test::Contains("unbounded"));
  }
}

TEMPLATE_TEST_CASE("rings turn counter-clockwise seen from outside", "[kdop_polytope]", float, double) {
  using S = TestType;
  bench::Random random(tests::seed());
  for (int i = 0; i < 20; ++i) {
    std::vector<Point<S, 3>> points(30);
    for (Point<S, 3>& p : points) p = random.heading<3>().template cast<S>();
    const Polytope<S, 3> solid = polytope(fit_kdop(points, directions<S, 3>(i % 2 ? 26 : 18)));
    check_closed(solid);
    for (const std::vector<int>& ring : solid.faces) {
      Vector<double, 3> area = Vector<double, 3>::Zero();  // Newell's normal
      for (std::size_t k = 0; k < ring.size(); ++k)
        area += solid.vertices[ring[k]].template cast<double>().cross(
            solid.vertices[ring[(k + 1) % ring.size()]].template cast<double>());
      CHECK(area.dot(solid.vertices[ring[0]].template cast<double>()) > 0);  // the origin is inside
    }
    std::vector<Point<S, 2>> flat(20);
    for (Point<S, 2>& p : flat) p = random.heading<2>().template cast<S>();
    const auto polygon = polytope(fit_kdop(flat, directions<S, 2>(8))).vertices;
    for (std::size_t k = 2; k < polygon.size(); ++k) {
      const Vector<S, 2> u = polygon[k - 1] - polygon[0], v = polygon[k] - polygon[0];
      CHECK(u[0] * v[1] - u[1] * v[0] > 0);
    }
  }
}

}  // namespace kdop_polytope_test
