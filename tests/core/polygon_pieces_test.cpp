// The pieces of polygons by name, and against every pair of edges in rationals.

#include <isect/polygon_pieces.h>

#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <utility>

#include <isect/segment_segment.h>
#include "tests/catch.h"
#include "tests/core/growth.h"
#include "tests/core/point_location.h"
#include "tests/settings.h"

namespace polygon_pieces_test {
using namespace isect;

namespace {

PolygonPieces pieces(const tests::Rings<double>& rings) {
  return make_polygon_pieces(std::span<const Ring<double, 2>>(rings));
}
/// "low high times above", with the vertices as given.
std::vector<std::string> listed(const PolygonPieces& all) {
  std::vector<std::string> list;
  const auto name = [&](int v) {
    std::string text;
    for (const double x : all.vertex(v)) text += std::to_string(static_cast<int>(x)) + ' ';
    return text;
  };
  for (const PolygonPieces::Piece& s : all.pieces)
    list.push_back(name(s.low) + name(s.high) + std::to_string(s.times) + ' ' + std::to_string(s.above));
  return list;
}
using List = std::vector<std::string>;

}  // namespace

TEST_CASE("the pieces of a square are its edges, with the winding number above", "[polygon_pieces]") {
  const Ring<double, 2> square = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  CHECK(listed(pieces({square})) == List{"0 0 2 0 1 1", "0 0 0 2 -1 0", "0 2 2 2 -1 0", "2 0 2 2 1 1"});
  CHECK(listed(pieces({{square.rbegin(), square.rend()}})) ==
        List{"0 0 2 0 -1 -1", "0 0 0 2 1 0", "0 2 2 2 1 0", "2 0 2 2 -1 -1"});
}

TEST_CASE("vertices cut the edges that hold them, and what coincides is one piece", "[polygon_pieces]") {
  CHECK(listed(pieces({{{0, 0}, {4, 0}, {2, 0}}})) == List{"0 0 2 0 0 0", "2 0 4 0 0 0"});  // there and back
  CHECK(listed(pieces({{{0, 0}, {4, 0}, {4, 1}}, {{2, 0}}})) ==
        List{"0 0 2 0 1 1", "0 0 4 1 -1 0", "2 0 4 0 1 1", "4 0 4 1 1 1"});
  CHECK(listed(pieces({{{0, 0}, {2, 0}, {4, 0}, {3, 0}, {1, 0}}})) ==
        List{"0 0 1 0 0 0", "1 0 2 0 0 0", "2 0 3 0 0 0", "3 0 4 0 0 0"});
  CHECK(listed(pieces({{{0, 0}, {2, 0}, {0, 2}}, {{0, 0}, {2, 0}, {0, 2}}})) ==
        List{"0 0 2 0 2 2", "0 0 0 2 -2 0", "0 2 2 0 -2 0"});
  CHECK(listed(pieces({{{0, 0}, {2, 2}}, {{0, 2}, {2, 0}}, {{1, 1}}})).size() == 4);  // crossing at a vertex
}

TEST_CASE("what has no length is a vertex, and what is not finite is nothing", "[polygon_pieces]") {
  CHECK(pieces({}).vertices.empty());
  CHECK(pieces({{}, {}}).vertices.empty());
  const PolygonPieces points = pieces({{{1, 2}}, {{1, 2}, {1, 2}}, {{0.0, 5}, {-0.0, 5}}});
  CHECK(points.vertices.size() == 2);
  CHECK(points.pieces.empty());
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), infinite<double>.hi})
    CHECK(pieces({{{0, 0}, {1, 0}, {0, 1}}, {{0, bad}}}).vertices.empty());
}

TEST_CASE("edges that cross without a vertex are refused by name", "[polygon_pieces]") {
  const auto complaint = [](const tests::Rings<double>& rings) -> std::string {
    try {
      pieces(rings);
    } catch (const std::invalid_argument& e) {
      return e.what();
    }
    return "";
  };
  CHECK(complaint({{{0, 0}, {2, 2}, {2, 0}, {0, 2}}}) ==
        "edge 0 of ring 0 and edge 2 of ring 0 cross where there is no vertex");
  CHECK(complaint({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{1, 1}, {5, 1}, {5, 2}, {1, 2}}}).find("ring 1") !=
        std::string::npos);
  CHECK(complaint({{{0, 0}, {2, 2}, {2, 0}, {0, 2}}, {{1, 1}}}).empty());
  CHECK(complaint({{{0, 0}, {0x1p-1074, 1}, {0, 2}}, {{0x1p-1074, 0}, {0, 1}, {0x1p-1074, 2}}}) != "");
}

TEST_CASE("edges along one line are cut as one, however many there are", "[polygon_pieces]") {
  bench::Random random(tests::seed());
  INFO("seed " << tests::seed());
  const int n = 60'000;  // edge by edge it would be 10^9 cuts
  Ring<double, 2> ring;
  for (int i = 0; i < n; ++i) ring.push_back({double(i), 3. * i});
  for (std::size_t i = ring.size() - 1; i > 0; --i) std::swap(ring[i], ring[random.below(static_cast<int>(i) + 1)]);

  PolygonPieces all;
  CHECK(tests::work([&] { all = pieces({ring}); }) < 500'000'000);
  CHECK(all.pieces.size() == static_cast<std::size_t>(n) - 1);
  CHECK(std::ranges::all_of(all.pieces, [](const auto& s) { return s.high == s.low + 1 && s.times == 0; }));

  // the way back from the last vertex to the first by another point: the line is left between their places
  ring.push_back({-1, 1});
  const PolygonPieces open = pieces({ring});
  int outward = 0;
  const auto [from, to] = std::minmax(ring.front()[0], ring[ring.size() - 2][0]);
  for (const PolygonPieces::Piece& s : open.pieces) {
    const double x = open.vertex(s.low)[0];
    if (open.vertex(s.low)[1] != 3 * x || open.vertex(s.high)[1] != 3 * open.vertex(s.high)[0]) continue;
    REQUIRE(std::abs(s.times) == (from <= x && x < to));
    outward += std::abs(s.times);
  }
  CHECK(outward == static_cast<int>(to - from));
}

TEST_CASE("the pieces of any polygon are fewer than 3 n, and take some n lg n", "[polygon_pieces]") {
  using P = Point<double, 2>;
  using Polygon = tests::Rings<double>;
  bench::Random random(tests::seed());
  INFO("seed " << tests::seed());
  const auto rings = [&](int n, const auto& ring) {
    Polygon all;
    for (int i = 0; i < n; ++i) all.push_back(ring(i));
    return all;
  };
  const auto one = [&](int n, const auto& at) {
    Ring<double, 2> ring;
    for (int i = 0; i < n; ++i) ring.push_back(at(i));
    return Polygon{ring};
  };
  const std::pair<std::string, std::function<Polygon(int)>> families[] = {
      {"star", [&](int n) -> Polygon { return {tests::star<double>(random, bench::Numbers::ordinary, n)}; }},
      {"monotone",
       [&](int n) -> Polygon { return {tests::monotone<double>(random, bench::Numbers::ordinary, n / 2)}; }},
      {"comb", [&](int n) { return one(n, [&](int i) { return i == 0 ? P(n, -1) : P(i, i % 4 / 2 * 5.); }); }},
      {"long teeth, one above the other",
       [&](int n) { return one(n, [&](int i) { return i == 0 ? P(-1, n) : P(i % 4 / 2 * 5., i); }); }},
      {"nested squares",
       [&](int n) {
         return rings(n / 4, [&](int i) {
           return Ring<double, 2>{P(-i, -i), P(i + 1, -i), P(i + 1, i + 1), P(-i, i + 1)};
         });
       }},
      {"all around one vertex",
       [&](int n) {
         return rings(n / 3, [&](int i) { return Ring<double, 2>{P(0, 0), P(n, 2. * i), P(n, 2. * i + 1)}; });
       }},
      {"one edge, n times", [&](int n) { return one(n, [&](int i) { return P(i % 2, 3 * (i % 2)); }); }},
      {"one edge, cut n times",
       [&](int n) {
         return rings(n, [&](int i) {
           return i == 0 ? Ring<double, 2>{P(0, 0), P(n, 3. * n)} : Ring<double, 2>{P(i, 3. * i)};
         });
       }},
      {"to and fro on one line",
       [&](int n) {
         return one(n, [&](int) {
           const double x = random.below(n);
           return P(x, 3 * x);
         });
       }},
      {"from one end, ever farther", [&](int n) { return one(n, [&](int i) { return i % 2 ? P(i, 0) : P(0, 0); }); }},
      {"to one end, from ever nearer",
       [&](int n) { return one(n, [&](int i) { return i % 2 ? P(-i, 0) : P(0, 0); }); }},
      {"up and down a vertical", [&](int n) { return one(n, [&](int) { return P(1, random.below(n)); }); }},
      {"cells that share their edges", [&](int n) {
         const int width = static_cast<int>(std::sqrt(n));
         return rings(n / 4, [&](int) {
           const double x = random.below(width), y = random.below(width);
           return Ring<double, 2>{P(x, y), P(x + 1, y), P(x + 1, y + 1), P(x, y + 1)};
         });
       }}};
  for (const auto& [name, polygon] : families) {
    const Polygon some = polygon(4000);
    CHECK(pieces(some).pieces.size() < 3 * pieces(some).vertices.size());
    const double exponent = tests::growth(4000, polygon, [](const Polygon& p) { return pieces(p); });
    INFO(name << ": n^" << exponent);
    CHECK(exponent < 1.5);
  }
}

TEST_CASE("a mesh of lines that cross at vertices is a planar graph", "[polygon_pieces]") {
  const int k = 120;
  tests::Rings<double> rings;
  for (int i = 0; i < k; ++i) {
    rings.push_back({{0, double(i)}, {k - 1., double(i)}});
    rings.push_back({{double(i), 0}, {double(i), k - 1.}});
    for (int j = 0; j < k; ++j) rings.push_back({{double(i), double(j)}});
  }
  CHECK(pieces(rings).pieces.size() == static_cast<std::size_t>(2 * k * (k - 1)));
  rings[7 * (k + 2) + 2 + 60] = {{0, 0}};  // without (7, 60)
  CHECK_THROWS_AS(pieces(rings), std::invalid_argument);
}

TEST_CASE("pieces meet in common ends only and add up to the edges", "[polygon_pieces]") {
  bench::Random random(tests::seed());
  int refused = 0, taken = 0, cut = 0;
  for (const bench::Numbers numbers : bench::all_numbers)
    for (int i = 0; i < tests::cases(150, 20000); ++i) {
      INFO("seed " << tests::seed() << ", family " << static_cast<int>(numbers) << ", case " << i);
      const tests::Rings<double> rings = tests::random_rings<double>(random, numbers);
      if (tests::cross_apart_from_vertices(rings)) {
        REQUIRE_THROWS_AS(pieces(rings), std::invalid_argument);
        ++refused;
        continue;
      }
      const PolygonPieces all = pieces(rings);
      ++taken;
      using segment_segment::Meeting;
      std::map<std::pair<int, int>, int> balance;  // of each vertex: pieces that begin there, less those that end
      for (std::size_t j = 0; j < all.pieces.size(); ++j) {
        const PolygonPieces::Piece& s = all.pieces[j];
        if (s.low >= s.high) REQUIRE(s.low < s.high);
        balance[{s.low, 0}] += s.times, balance[{s.high, 0}] -= s.times;
        for (std::size_t k = 0; k < j; ++k) {
          const PolygonPieces::Piece& t = all.pieces[k];
          const Meeting meeting = intersect(Segment<double, 2>{all.vertex(s.low), all.vertex(s.high)},
                                            Segment<double, 2>{all.vertex(t.low), all.vertex(t.high)})
                                      .relation;
          const bool share = s.low == t.low || s.low == t.high || s.high == t.low || s.high == t.high;
          if (meeting != (share ? Meeting::touch : Meeting::disjoint))
            REQUIRE(meeting == (share ? Meeting::touch : Meeting::disjoint));
        }
      }
      for (const auto& [vertex, sum] : balance) REQUIRE(sum == 0);  // as of closed rings

      // each piece lies on the edge that it names
      for (const PolygonPieces::Piece& s : all.pieces) {
        const Ring<double, 2>& r = rings[s.edge.ring];
        const std::size_t index = static_cast<std::size_t>(s.edge.index);
        const Ring<double, 2> edge = {r[index], r[(index + 1) % r.size()]};
        for (const int v : {s.low, s.high}) cut += all.vertex(v) != edge[0] && all.vertex(v) != edge[1];
        REQUIRE(locate(all.vertex(s.low), edge) == Location::on);
        REQUIRE(locate(all.vertex(s.high), edge) == Location::on);
      }
    }
  CHECK(refused > taken / 20);
  CHECK(taken > refused / 4);
  CHECK(cut > taken / 100);
}

}  // namespace polygon_pieces_test
