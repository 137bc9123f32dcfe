// What readers of the lessons' texts alone could not answer, or misread. Each claim that was added is computed here.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>
#include <vector>

#include <isect/aabb_aabb.h>
#include <isect/convex_hull.h>
#include <isect/fit.h>
#include <isect/many/bvh.h>
#include <isect/many/bvh_pairs.h>
#include <isect/sphere_aabb.h>
#include <isect/triangle_aabb.h>
#include "bench/orient2d/oracle.h"
#include "bench/random.h"
#include "lessons/bounding_volumes/object.h"
#include "lessons/glossary.h"
#include "tests/lessons/texts.h"
#include "tests/lessons/words.h"
#include "viz/text/rich_text.h"

namespace asked_words_test {
using namespace isect;
using namespace isect::viz;
using namespace isect::tests;
using isect::test::Contains;

TEST_CASE("a false positive and a false negative are explained where the course first names them", "[words]") {
  for (const std::string name : {"false negative", "false positive"}) {
    INFO(name);
    const auto term = std::ranges::find(lessons::glossary(), name, &lessons::Term::name);
    REQUIRE(term != lessons::glossary().end());
    for (const Lesson* l : lessons::all_lessons()) {
      const std::vector<std::string> all = texts(*l);
      const bool named = std::ranges::any_of(all, [&](const std::string& t) { return says(plain(t), name); });
      INFO(l->id);
      CHECK(named == (l->id == term->lesson));
      if (l->id == term->lesson) break;
    }
  }
  CHECK_THAT(lesson("sphere-aabb").closing->bug, Contains("accepts balls that miss: false positives"));
  CHECK(solved_with("bounding-volumes", "may reject what meets its object: a false negative"));
}

TEST_CASE("what misses a box around an object misses the object, and only void is a false positive", "[words]") {
  int rejected = 0, void_only = 0;
  for (const Preset& p : lesson("bounding-volumes").presets) {
    const Walk walk = lesson("bounding-volumes").walk(p.parameters);
    const Step *const first = find(walk, "volume-first"), *const last = find(walk, "verdict");
    INFO(p.id);
    if (first) CHECK(says(first->caption, "would be a false negative") == (first->line == 1));
    if (last) CHECK(says(last->caption, "a yes of the cheap test") == (last->title == "A false positive"));
    rejected += first && first->line == 1, void_only += last && last->title == "A false positive";
  }
  CHECK((rejected > 0 && void_only > 0));

  const auto mesh = lessons::bounding_volumes_lesson::object("pin", {0.5, 1.5, 0.25});
  const Aabb<double, 3> around = fit_aabb(mesh.vertices);
  bench::Random random = random_of("rejected boxes");
  for (int k = 0; k < 200; ++k) {
    const Vec3 middle = random.in_box<3>(2.5), half = Vec3::Constant(0.4);
    const Aabb<double, 3> box = {middle - half, middle + half};
    bool meets = false;
    for (const auto& t : mesh.triangles)
      meets = meets ||
              intersects(Triangle<double, 3>{{mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]}}, box);
    if (!intersects(around, box)) CHECK_FALSE(meets);
  }
  CHECK_THAT(lesson("bounding-volumes").closing->choose, Contains("Sphere for round bodies that rotate often"));
}

TEST_CASE("open intervals are disjoint where it is told", "[words]") {
  CHECK(solved_with("intervals", "if and only if a_min ≥ b_max or b_min ≥ a_max"));
  for (int a = 0; a < 5; ++a)
    for (int a_end = a + 1; a_end <= 5; ++a_end)
      for (int b = 0; b < 5; ++b)
        for (int b_end = b + 1; b_end <= 5; ++b_end) {
          bool common = false;  // the ends are whole, so a common open part contains half of an odd number
          for (double x = 0.5; x < 5; x += 1) common = common || (a < x && x < a_end && b < x && x < b_end);
          CHECK(common == !(a >= b_end || b >= a_end));
        }
}

TEST_CASE("points within a tolerance lie in 27 cells at most", "[words]") {
  CHECK(solved_with("points", "3 · 3 · 3 = 27 cells"));
  constexpr double tolerance = 0.25;
  const auto cell = [](double x) { return static_cast<int>(std::floor(x / tolerance)); };
  bench::Random random = random_of("cells");
  std::set<std::array<int, 3>> seen;
  for (int k = 0; k < 20000; ++k) {
    const Vec3 p = random.in_box<3>(4), to = random.in_box<3>(tolerance);
    if (to.squaredNorm() > tolerance * tolerance) continue;
    std::array<int, 3> step = {};
    for (int i = 0; i < 3; ++i) step[i] = cell(p[i] + to[i]) - cell(p[i]);
    CHECK(std::ranges::all_of(step, [](int s) { return std::abs(s) <= 1; }));
    seen.insert(step);
  }
  CHECK(seen.size() == 27);
}

TEST_CASE("a line in the wall is a hit without a t", "[words]") {
  const Walk walk = walk_of("rays", "segment-in-wall");
  CHECK_THAT(find(walk, "parallel")->caption, Contains("HIT comes without one"));
  const Step last = ending(walk);
  CHECK(last.verdict.kind == Verdict::Kind::yes);
  CHECK(std::ranges::none_of(last.values, [](const Value& v) { return v.name == "*t*"; }));
}

TEST_CASE("a ball is pushed out of a box by the direction that is told", "[words]") {
  CHECK(solved_with("sphere-aabb", "the face nearest to c gives the direction"));
  const Aabb<double, 3> box = {{-1, -0.75, -0.5}, {1, 0.75, 0.5}};
  bench::Random random = random_of("pushes");
  int inside = 0, outside = 0;
  for (int k = 0; k < 300; ++k) {
    const Vec3 c = random.in_box<3>(1.25), p = c.cwiseMax(box.lo).cwiseMin(box.hi);
    constexpr double r = 0.5;
    Vec3 way = c - p;
    double needed = r - way.norm();
    if (way.norm() < 1e-3) {
      if (p != c) continue;
      double least = INFINITY;
      for (int i = 0; i < 3; ++i)
        for (const double side : {-1.0, 1.0}) {
          const double face = side < 0 ? c[i] - box.lo[i] : box.hi[i] - c[i];
          if (face < least) least = face, way = side * Vec3::Unit(i);
        }
      needed = least + r, ++inside;
    } else if (needed < 1e-3) {
      continue;
    } else {
      way.normalize(), ++outside;
    }
    CHECK_FALSE(intersects(Sphere<double, 3>{c + 1.001 * needed * way, r}, box));
    const Vec3 other = random.in_box<3>(1).normalized();  // none is shorter
    CHECK(intersects(Sphere<double, 3>{c + 0.999 * needed * other, r}, box));
  }
  CHECK((inside > 0 && outside > 0));
}

TEST_CASE("an expanded box errs along edges, too, by as much as is told", "[words]") {
  CHECK(solved_with("sphere-aabb", "r² (1 − π/4) for each unit of length"));
  CHECK_THAT(lesson("sphere-aabb").closing->bug, Contains("at edges and corners"));
  CHECK_THAT(lesson("sphere-aabb").map->told, Contains("its edges and corners are not round"));
  double outside = 0;
  constexpr int n = 10000;
  for (int i = 0; i < n; ++i) {
    const double x = (i + 0.5) / n;
    outside += (1 - std::sqrt(1 - x * x)) / n;
  }
  CHECK(outside == Approx(1 - std::numbers::pi / 4).margin(1e-5));
  const Walk inside = walk_of("sphere-aabb", "ball-inside");
  bool told = false;
  for (const Step& s : inside.steps)
    told = told || (s.question && says(s.question->because, "lies in the interval, at least *r* away from both ends"));
  CHECK(told);
}

namespace {

/// Answers comparisons of n things so that as many of their orders as can be stay possible.
struct Adversary {
  std::vector<std::vector<int>> ranks;  ///< of each order that is possible still
  int asked = 0;
  bool halves = true;  ///< each answer left at least half

  explicit Adversary(int n) {
    std::vector<int> order(static_cast<std::size_t>(n));
    std::iota(order.begin(), order.end(), 0);
    do ranks.push_back(order);
    while (std::ranges::next_permutation(order).found);
  }
  bool less(std::size_t i, std::size_t j) {
    if (i == j) return false;
    const auto before = [&](const std::vector<int>& rank) { return rank[i] < rank[j]; };
    const auto all = static_cast<std::ptrdiff_t>(ranks.size()), yes = std::ranges::count_if(ranks, before);
    const bool answer = 2 * yes >= all;
    std::erase_if(ranks, [&](const std::vector<int>& rank) { return before(rank) != answer; });
    halves = halves && 2 * static_cast<std::ptrdiff_t>(ranks.size()) >= all;
    ++asked;
    return answer;
  }
};

}  // namespace

TEST_CASE("sorting takes as many comparisons at worst as the hull's exercise tells", "[words]") {
  CHECK(solved_with("convex-hull", "takes lg(n!) comparisons or more: of order n lg n"));
  for (int n = 2; n <= 6; ++n)
    for (const bool heap : {false, true}) {
      Adversary adversary(n);
      const double at_least = std::log2(static_cast<double>(adversary.ranks.size()));
      std::vector<std::size_t> things(static_cast<std::size_t>(n));
      std::iota(things.begin(), things.end(), std::size_t{0});
      const auto less = [&](std::size_t i, std::size_t j) { return adversary.less(i, j); };
      if (heap) {
        std::make_heap(things.begin(), things.end(), less);
        std::sort_heap(things.begin(), things.end(), less);
      } else {
        std::stable_sort(things.begin(), things.end(), less);
      }
      INFO(n << (heap ? ", by a heap" : ", by merging"));
      CHECK(adversary.halves);
      CHECK(adversary.ranks.size() == 1);
      CHECK(adversary.asked >= at_least);
    }
  for (const double n : {4.0, 100.0, 1e6, 1e9}) {
    const double lg = std::lgamma(n + 1) / std::numbers::ln2, order = n * std::log2(n);
    CHECK((order / 2 <= lg && lg <= order));
  }
}

TEST_CASE("a hull that has an area turns left at every vertex", "[words]") {
  CHECK_THAT(lesson("convex-hull").closing->result, Contains("Where it has an area"));
  bench::Random random = random_of("turns");
  int with_area = 0, without = 0;
  for (int k = 0; k < 200; ++k) {
    Ring<double, 2> points;
    for (int i = 0; i < 4; ++i) {
      const int place = random.below(9);
      points.push_back(Point<double, 2>(place % 3, place / 3));
    }
    const Ring<double, 2> hull = isect::convex_hull(points);
    (hull.size() > 2 ? with_area : without) += 1;
    for (std::size_t i = 0; hull.size() > 2 && i < hull.size(); ++i)
      CHECK(oracle::orientation(hull[i], hull[(i + 1) % hull.size()], hull[(i + 2) % hull.size()]) == 1);
  }
  CHECK((with_area > 0 && without > 0));
}

TEST_CASE("the two dot products divide to the place on the line, and a point needs no division", "[words]") {
  CHECK_THAT(find(walk_of("distance", "interior"), "dot")->caption, Contains("it is the *t* of the nearest point"));
  const Walk point = with("distance", "interior", {{"q_a", "-2,-1,0"}});
  CHECK_THAT(find(point, "dot")->caption, Contains("Line 2 then takes *t* = 0"));
  CHECK(says(point.pseudocode[1], "t ← 0"));
  CHECK(ending(point).counters.div == 0);
  CHECK(told("distance", "the code would take t_b = 0, and not divide by 0"));
  bench::Random random = random_of("feet");
  for (int k = 0; k < 100; ++k) {
    const Vec3 c = random.in_box<3>(2), p = random.in_box<3>(2), d = random.in_box<3>(2);
    const double t = (c - p).dot(d) / d.dot(d);
    const auto squared = [&](double at) { return (c - p - at * d).squaredNorm(); };
    CHECK((squared(t) <= squared(t - 0.01) && squared(t) <= squared(t + 0.01)));
  }
}

TEST_CASE("a tree has one inner node less than leaves, and loses what moved if it is not refitted", "[words]") {
  CHECK_THAT(find(walk_of("hierarchy", "build"), "done")->question->because, Contains("has two children"));
  CHECK(solved_with("hierarchy", "a query that misses its old box may lose a hit"));
  bench::Random random = random_of("trees");
  for (int n = 1; n < 40; ++n) {
    std::vector<Aabb<double, 2>> boxes;
    for (int i = 0; i < n; ++i) {
      const Vec2 at = random.in_box<2>(4);
      boxes.push_back({at, at + Vec2(0.25, 0.25)});
    }
    const Bvh<double, 2> tree = build_bvh(boxes);
    const auto leaves = std::ranges::count_if(tree.nodes, [](const auto& node) { return node.leaf(); });
    CHECK(static_cast<std::ptrdiff_t>(tree.nodes.size()) == 2 * leaves - 1);
    std::set<int> children;
    for (const auto& node : tree.nodes)
      if (!node.leaf()) children.insert({node.first, node.first + 1});
    CHECK(children.size() + 1 == tree.nodes.size());
    const Aabb<double, 2> there = {{9, 9}, {10, 10}};
    boxes.front() = there;
    const std::vector<Aabb<double, 2>> query = {there};
    const Bvh<double, 2> of_query = build_bvh(query);
    CHECK(overlapping_pairs(tree, boxes, of_query, query).empty());
    CHECK(overlapping_pairs(build_bvh(boxes), boxes, of_query, query).size() == 1);
  }
}

namespace {

/// What counting says of p, by exact signs: whether an odd number of edges right of it counts.
bool counted_in(const Point<double, 2>& p, const Ring<double, 2>& ring) {
  bool odd = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point<double, 2>&a = ring[i], &b = ring[(i + 1) % ring.size()];
    if ((a.y() > p.y()) != (b.y() > p.y()) && oracle::orientation(a, b, p) == (b.y() > a.y() ? 1 : -1)) odd = !odd;
  }
  return odd;
}

}  // namespace

TEST_CASE("of polygons around a point that leave no gap just one gets it by counting", "[words]") {
  CHECK(told("crossings", "counting by exact signs gives it to just one"));
  CHECK_THAT(lesson("crossings").closing->result, Contains("Off the boundary"));
  const Point<double, 2> p(0, 0);
  for (int m = 2; m <= 5; ++m)
    for (int turn = 0; turn < 48; ++turn) {
      Ring<double, 2> outline;  // symmetric about p, in whole numbers
      for (int i = 0; i < m; ++i) {
        const double angle = std::numbers::pi * (i / static_cast<double>(m) + turn / 24.0);
        outline.emplace_back(std::round(100 * std::cos(angle)), std::round(100 * std::sin(angle)));
      }
      for (int i = 0; i < m; ++i) outline.push_back(-outline[static_cast<std::size_t>(i)]);
      const std::size_t n = outline.size();
      const auto corner = [&](std::size_t i) { return Ring<double, 2>{p, outline[i], outline[(i + 1) % n]}; };
      int of_corners = 0, beside_an_edge = 0;
      for (std::size_t i = 0; i < n; ++i) of_corners += counted_in(p, corner(i));
      Ring<double, 2> half(outline.begin(), outline.begin() + m + 1);  // p lies within an edge of it
      beside_an_edge += counted_in(p, half);
      for (std::size_t i = static_cast<std::size_t>(m); i < n; ++i) beside_an_edge += counted_in(p, corner(i));
      INFO(m << ", " << turn);
      CHECK(of_corners == 1);
      CHECK(beside_an_edge == 1);
    }
}

TEST_CASE("interior points of flat sets and of segments are told to be within their plane or line", "[words]") {
  const auto term = std::ranges::find(lessons::glossary(), std::string("interior"), &lessons::Term::name);
  REQUIRE(term != lessons::glossary().end());
  CHECK_THAT(term->meaning, Contains("within its line") && Contains("within its plane"));
  CHECK_THAT(find(walk_of("relations", "aabb-touching"), "interiors")->question->because, Contains("Of a flat set"));
  const Walk segments = with("capsule-capsule", "crossing", {{"r_a", "0"}, {"r_b", "0"}});
  CHECK(std::ranges::any_of(segments.steps, [](const Step& s) { return says(s.caption, "taken along it"); }));
  CHECK_THAT(lesson("capsule-capsule").closing->cost, Contains("In the plane: four orientations"));
}

}  // namespace asked_words_test
