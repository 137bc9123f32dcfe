// Pairs of oriented boxes, of k-DOPs, and a triangle with a box.

#include <string_view>

#include "bench/kdop_kdop/families.h"
#include "bench/obb_obb/families.h"
#include "bench/obb_obb/oracle.h"
#include "bench/triangle_aabb/oracle.h"
#include "tests/cases/shapes.h"
#include "tests/core/triangle_box_pairs.h"

namespace isect::cases {

namespace {

using oracle::dot, oracle::rational;

template <class S, int N>
Case obbs(const Obb<S, N>& a, const Obb<S, N>& b) {
  const Relation r = oracle::obb::by_projection(oracle::obb::Exactly<N>(a), oracle::obb::Exactly<N>(b));
  return {{{"a", json(a)}, {"b", json(b)}}, related(r), is_f32<S>};
}

/// Compares slabs as they are.
template <class S, int N>
Case kdops(const std::vector<Vector<S, N>>& normals, const std::vector<Interval<S>>& a,
           const std::vector<Interval<S>>& b) {
  Json slabs[2] = {{{"lo", Json::array()}, {"hi", Json::array()}}, {{"lo", Json::array()}, {"hi", Json::array()}}};
  bool apart = false;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    slabs[0]["lo"].push_back(json(a[i].lo)), slabs[0]["hi"].push_back(json(a[i].hi));
    slabs[1]["lo"].push_back(json(b[i].lo)), slabs[1]["hi"].push_back(json(b[i].hi));
    apart |= empty(a[i]) || empty(b[i]) || a[i].hi < b[i].lo || b[i].hi < a[i].lo;
  }
  return {{{"normals", json<S, N>(normals)}, {"a", slabs[0]}, {"b", slabs[1]}},
          {{"slabs", apart ? "disjoint" : "overlap"}},
          is_f32<S>};
}

/// The smallest slab with ends in S that holds the projections of the corners.
template <class S>
Interval<S> slab(const Vector<S, 3>& normal, const std::array<Point<S, 3>, 4>& corners) {
  constexpr S inf = std::numeric_limits<S>::infinity();
  Interval<S> result = {inf, -inf};
  for (const Point<S, 3>& p : corners) {
    const Rational x = dot(rational(normal), rational(p));
    S lo = static_cast<S>(nearest(x)), hi = lo;
    if (Rational(lo) > x) lo = std::nextafter(lo, -inf);
    if (Rational(hi) < x) hi = std::nextafter(hi, inf);
    result = {std::min(result.lo, lo), std::max(result.hi, hi)};
  }
  return result;
}

template <class S, int N>
Case triangle_and_box(const Triangle<S, N>& triangle, const Aabb<S, N>& box) {
  namespace clip = oracle::triangle_aabb;
  Json corners = Json::array();
  for (const Point<S, N>& v : triangle.vertices) corners.push_back(json<S, N>(v));
  const Relation r = empty(box) ? Relation::disjoint : clip::relation(triangle, box);
  return {both({{"tri", corners}}, fields(box)),
          {{"intersects", r != Relation::disjoint}, {"relation", word(r)}},
          is_f32<S>};
}

/// A triangle in a plane that touches the box at a corner, or with an edge that touches one of the box's, up to
/// rounding.
template <class S>
Case almost_touching(Random& random, bool edges) {
  const Aabb<S, 3> box = bench::ordinary_box<S>(random);
  Vector<double, 3> normal, touched;
  for (int i = 0; i < 3; ++i) {
    const double side = random.sign();
    touched[i] = side > 0 ? box.hi[i] : box.lo[i], normal[i] = side * random.uniform(0.1, 1);
  }
  if (edges) touched[2] = random.uniform(box.lo[2], box.hi[2]), normal[2] = 0;
  const Vector<double, 3> u = normal.cross(random.heading<3>()), v = normal.cross(u);
  const double turn = random.uniform(0, 1);
  std::array<Point<double, 3>, 3> corners = {touched + u + turn * v, touched - u, touched + u - 2 * v};
  if (edges) corners[1] = 2 * touched - corners[0], corners[2] = touched + normal + u;
  return triangle_and_box<S, 3>({{corners[0].cast<S>(), corners[1].cast<S>(), corners[2].cast<S>()}}, box);
}

}  // namespace

CaseFile obb_obb() {
  CaseFile file("obb_obb");
  const Eigen::Matrix2d aligned = Eigen::Matrix2d::Identity(), diagonal{{1, -1}, {1, 1}};
  const auto add = [&](const char* note, Obb<double, 2> a, Obb<double, 2> b) { file.add(note, obbs(a, b)); };
  add("a corner at a face, exactly", {{0, 0}, aligned, {1, 1}}, {{3, 0}, diagonal, {1, 1}});
  add("an ulp beside it", {{0, 0}, aligned, {1, 1}}, {{std::nextafter(3., 4.), 0}, diagonal, {1, 1}});
  add("an inner touch", {{0, 0}, aligned, {2, 2}}, {{0, 0}, diagonal, {1, 1}});
  add("equal, though the axes are in another order", {{0, 0}, aligned, {1, 2}},
      {{0, 0}, Eigen::Matrix2d{{0, -1}, {1, 0}}, {2, 1}});
  add("without thickness, crossing", {{0, 0}, aligned, {2, 0}}, {{0, 0}, diagonal, {0, 2}});
  add("points", {{.1, .1}, aligned, {0, 0}}, {{.1, .1}, diagonal, {0, 0}});
  add("axes of length 1e-150", {{0, 0}, 1e-150 * aligned, {1, 1}}, {{3e-150, 0}, 1e-150 * diagonal, {1, 1}});
  add("axes of length 1e150", {{0, 0}, 1e150 * aligned, {1, 1}}, {{3e150, 0}, 1e150 * diagonal, {1, 1}});
  const auto ask = [](const auto& c) { return obbs(c.a, c.b); };
  by_families(file, 3, bench::obb_obb_draws<double>, bench::obb_obb_draws<float>, ask);
  for (const auto& f : bench::obb_obb_draws<double>)
    if (std::string_view(f.name).find("-at-") != std::string_view::npos)
      file.family(std::string(f.name) + ", more of it", 4, [&](Random& r) { return ask(f.draw(r)); });
  by_numbers(file, 2, [&]<class S>(Random& random, Numbers numbers) -> std::optional<Case> {
    const Obb<S, 2> a = bench::obb<S, 2>(random, numbers), b = bench::obb<S, 2>(random, numbers);
    if (!finite(a) || !finite(b)) return {};
    return obbs(a, b);
  });
  return file;
}

CaseFile kdop_kdop() {
  CaseFile file("kdop_kdop");
  const auto normals = std::vector<Vector<double, 2>>{{1, 0}, {0, 1}, {1, 1}};
  using Slabs = std::vector<Interval<double>>;
  const auto add = [&](const char* note, Slabs a, Slabs b) { file.add(note, kdops<double, 2>(normals, a, b)); };
  add("the diagonal alone parts them", {{0, 1}, {0, 1}, {0, 1}}, {{.5, 2}, {.5, 2}, {1.5, 4}});
  add("the diagonals touch", {{0, 1}, {0, 1}, {0, 1.5}}, {{.5, 2}, {.5, 2}, {1.5, 4}});
  add("an ulp between the diagonals", {{0, 1}, {0, 1}, {0, std::nextafter(1.5, 0.)}}, {{.5, 2}, {.5, 2}, {1.5, 4}});
  add("an empty slab", {{0, 1}, {0, 1}, {1, 0}}, {{0, 1}, {0, 1}, {0, 1}});
  add("zeros of either sign touch", {{-1, -0.}, {0, 1}, {-1, 1}}, {{0, 1}, {0, 1}, {0, 1}});
  add("the largest numbers there are", {{-most, most}, {0, 0}, {-most, most}}, {{most, most}, {0, 0}, {most, most}});
  const auto tetrahedra = [](const auto& c) {
    using S = typename std::decay_t<decltype(c.a[0])>::Scalar;
    const std::vector<Vector<S, 3>> all = directions<S, 3>(14);
    std::vector<Interval<S>> a, b;
    for (const Vector<S, 3>& n : all) a.push_back(slab(n, c.a)), b.push_back(slab(n, c.b));
    return kdops<S, 3>(all, a, b);
  };
  by_families(file, 6, bench::kdop_kdop_draws<double>, bench::kdop_kdop_draws<float>, tetrahedra);
  return file;
}

CaseFile triangle_box() {
  CaseFile file("triangle_box");
  const auto add = [&](const char* note, Triangle<double, 3> t, Aabb<double, 3> box) {
    file.add(note, triangle_and_box(t, box));
  };
  const Aabb<double, 3> cube = {{-1, -1, -1}, {1, 1, 1}};
  using P = Point<double, 3>;
  add("the plane touches a corner", {{P{3, 0, 0}, P{0, 3, 0}, P{0, 0, 3}}}, cube);
  add("a face of the box holds it", {{P{0, 0, 1}, P{1, 0, 1}, P{0, 1, 1}}}, cube);
  add("an edge touches an edge", {{P{2, 0, 0}, P{0, 2, 0}, P{2, 2, 9}}}, cube);
  add("a segment through a corner", {{P{2, 0, 1}, P{0, 2, 1}, P{2, 0, 1}}}, cube);
  add("a point on a face", {{P{1, .5, .5}, P{1, .5, .5}, P{1, .5, .5}}}, cube);
  add("around the box without touching it", {{P{9, -9, 0}, P{-9, -9, 0}, P{0, -9, 9}}}, cube);
  add("through the middle, all vertices outside", {{P{-9, -9, .5}, P{9, -9, .5}, P{0, 9, .5}}}, cube);
  add("an inverted box is empty", {{P{0, 0, 0}, P{1, 0, 0}, P{0, 1, 0}}}, {{1, 1, 1}, {-1, -1, -1}});
  const double before = std::nextafter(.7, 0);
  add("half an ulp beside a box whose center is no double", {{P{.7, 0, 0}, P{.7, 1, 0}, P{.7, 0, 1}}},
      {{-.3, 0, 0}, {before, 1, 1}});
  for (const bool edges : {false, true}) {
    const std::string note = edges ? "an edge at an edge, but for rounding" : "the plane at a corner, but for rounding";
    file.family(note, 6, [&](Random& r) { return almost_touching<double>(r, edges); });
    file.family(note + ", in floats", 3, [&](Random& r) { return almost_touching<float>(r, edges); });
  }
  by_numbers(file, 3, [&]<class S>(Random& random, Numbers numbers) -> std::optional<Case> {
    const auto [triangle, box] = tests::triangle_box_pairs::pair<S, 3>(random, numbers);
    if (!finite(triangle) || !finite(box)) return {};
    return triangle_and_box(triangle, box);
  });
  return file;
}

}  // namespace isect::cases
