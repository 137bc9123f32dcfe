// What a lesson calls cheapest, nearest, tightest or fewer is compared with all its rivals, those too that the method
// itself did not try.

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "lessons/capsule_capsule/picture.h"
#include "lessons/concave_polygon/picture.h"
#include "lessons/concave_polygon/triangles.h"
#include "lessons/hierarchy/tree.h"
#include "lessons/obb_obb/picture.h"
#include "lessons/sphere_aabb/picture.h"
#include "tests/lessons/words.h"
#include "viz/text/rich_text.h"

namespace rivals_test {
using namespace isect;
using namespace isect::viz;
using namespace isect::tests;
using isect::test::Contains;

namespace {

/// Looks at the presets, then at random settings.
template <class Check>
void on_all_settings(const std::string& id, int how_many, const Check& check) {
  for (const Preset& p : lesson(id).presets) {
    INFO(id << " " << p.id);
    check(p.parameters, lesson(id).walk(p.parameters));
  }
  on_random_settings(id, how_many, check);
}

// Hierarchies: splits of boxes in the plane.

namespace tree = lessons::hierarchy_lesson;
using Box = Aabb<double, 2>;

double centre(const Box& box, int axis) { return (box.lo[axis] + box.hi[axis]) / 2; }

/// Half the perimeter of what surrounds the boxes, times their number: what a part adds to the cost, in units of the
/// whole.
double weight(const tree::Boxes& boxes) {
  if (boxes.empty()) return std::numeric_limits<double>::infinity();
  Box all = boxes.front();
  for (const Box& b : boxes) all = {all.lo.cwiseMin(b.lo), all.hi.cwiseMax(b.hi)};
  return (all.hi - all.lo).sum() * static_cast<double>(boxes.size());
}

/// The cost of the split whose left part has the centres below `at`; infinite if a part is empty.
double cost(const tree::Boxes& boxes, int axis, double at) {
  tree::Boxes left, right;
  for (const Box& b : boxes) (centre(b, axis) < at ? left : right).push_back(b);
  const double whole = weight(boxes) / static_cast<double>(boxes.size());
  return tree::options.visit + (weight(left) + weight(right)) / whole;
}

struct Spread {
  double lo, hi;
};
Spread spread(const tree::Boxes& boxes, int axis) {
  Spread s = {centre(boxes[0], axis), centre(boxes[0], axis)};
  for (const Box& b : boxes) s = {std::min(s.lo, centre(b, axis)), std::max(s.hi, centre(b, axis))};
  return s;
}

double cheapest_tried(const tree::Boxes& boxes, int axis) {
  constexpr int bins = 16;  // of isect/parts/bvh_split.h
  const Spread s = spread(boxes, axis);
  double least = std::numeric_limits<double>::infinity();
  for (int k = 1; k < bins; ++k) least = std::min(least, cost(boxes, axis, s.lo + (s.hi - s.lo) * k / bins));
  return least;
}

double cheapest_of_all(const tree::Boxes& boxes) {
  double least = std::numeric_limits<double>::infinity();
  for (const int axis : {0, 1})
    for (const Box& b : boxes) least = std::min(least, cost(boxes, axis, centre(b, axis)));
  return least;
}

void said_of_splits(const Walk& walk, const tree::Boxes& boxes, int& untried) {
  const Step& first = *find(walk, "cut-1");
  const int axis = says(first.title, "*x*") ? 0 : 1;
  const Spread chosen = spread(boxes, axis), other = spread(boxes, 1 - axis);
  CHECK(chosen.hi - chosen.lo >= other.hi - other.lo);
  const double tried = cheapest_tried(boxes, axis), least = cheapest_of_all(boxes);
  INFO(first.caption << " " << first.formula << ", least " << least);
  CHECK(first.formula.ends_with(" = " + shown(tried)));
  CHECK_THAT(first.caption, Contains("Tried are 15 cuts along ") && Contains("The cheapest is taken: "));
  const Step* const cheaper = find(walk, "untried");
  CHECK((cheaper != nullptr) == (shown(least) != shown(tried)));
  if (!cheaper) return;
  ++untried;
  CHECK(least < tried);
  CHECK_THAT(cheaper->caption, Contains("would cost " + shown(least) + " in place of " + shown(tried)));
}

// Capsules and boxes: the nearest points.

double distance_to_segment(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 d = b - a;
  const double t = d.squaredNorm() > 0 ? std::clamp((p - a).dot(d) / d.squaredNorm(), 0.0, 1.0) : 0;
  return (p - a - t * d).norm();
}

/// The least distance of any of the four ends from the other segment.
double nearest_end(const lessons::capsule_capsule_lesson::Setup& s) {
  double least = std::numeric_limits<double>::infinity();
  for (const Vec2& end : {s.a.p, s.a.q}) least = std::min(least, distance_to_segment(end, s.b.p, s.b.q));
  for (const Vec2& end : {s.b.p, s.b.q}) least = std::min(least, distance_to_segment(end, s.a.p, s.a.q));
  return least;
}

/// The least distance between places on both segments, of a grid that has their ends.
double nearest_on_grid(const lessons::capsule_capsule_lesson::Setup& s) {
  constexpr int places = 16;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= places; ++i) {
    const Vec2 on_a = s.a.p + (s.a.q - s.a.p) * (i / double(places));
    least = std::min(least, distance_to_segment(on_a, s.b.p, s.b.q));
  }
  return least;
}

}  // namespace

TEST_CASE("the split that is called cheapest is so among the cuts that are said to be tried, and a cheaper one is told",
          "[words]") {
  int looked_at = 0, untried = 0;
  on_all_settings("hierarchy", 300, [&](const Parameters& p, const Walk& walk) {
    if (text(p, "walk") != "build" || !find(walk, "cut-1")) return;
    ++looked_at;
    said_of_splits(walk, tree::boxes_of(p), untried);
  });
  CHECK(looked_at > untried);
  CHECK(untried > 2);
  for (const char* id : {"build", "outlier"}) CHECK(find(walk_of("hierarchy", id), "untried") != nullptr);
}

TEST_CASE("boxes that have one centre are halved by number, and no cut is said to be tried", "[words]") {
  tree::Boxes boxes;
  for (int i = 1; i <= 6; ++i) boxes.push_back({{-0.25 * i, -0.125 * i}, {0.25 * i, 0.125 * i}});
  const Walk walk = tree::build(boxes);
  const Step& first = *find(walk, "cut-1");
  CHECK_THAT(first.caption, Contains("they are halved by number, 3 and 3.") && !Contains("cheapest"));
  CHECK(find(walk, "untried") == nullptr);
}

TEST_CASE("what is said of the edges at a polygon's vertices holds on each level, and the box's corners are apart",
          "[words]") {
  namespace own = lessons::concave_polygon_lesson;
  int levels = 0, corners_of_two = 0;
  on_all_settings("concave-polygon", 100, [&](const Parameters& p, const Walk& walk) {
    if (const Step* const told = find(walk, "coarsest"))
      CHECK_THAT(told->caption, Contains("Only the polygon's vertices are removed") &&
                                    Contains("at least 3 edges meet, and fewer than 6 on average"));
    const own::Setup s(p);
    const auto hierarchy = own::make_hierarchy(s.ring, {{s.frame.left, s.frame.low}, {s.frame.right, s.frame.high}});
    for (const own::Level& level : hierarchy.levels) {
      std::set<std::pair<int, int>> edges;
      for (const own::Triangle& t : level.triangles)
        for (std::size_t k = 0; k < 3; ++k) edges.insert(std::minmax(t.corners[k], t.corners[(k + 1) % 3]));
      std::map<int, int> ends;  // of edges, at each vertex
      for (const auto& [from, to] : edges) ++ends[from], ++ends[to];
      int vertices = 0, sum = 0, few = 0, at_corners = 0;
      for (const auto& [v, count] : ends) {
        if (v >= s.size()) {
          at_corners += count, corners_of_two += count == 2;
          continue;
        }
        ++vertices, sum += count, few += count <= 8;
        CHECK(count >= 3);
      }
      if (vertices == 0) continue;
      ++levels;
      CHECK(static_cast<int>(edges.size()) == 3 * vertices + 5);
      CHECK(at_corners >= 12);
      CHECK(sum < 6 * vertices);
      CHECK(2 * few >= vertices);
      CHECK(18 * static_cast<int>(level.removed.size()) >= vertices);
    }
  });
  CHECK(levels > 100);
  CHECK(corners_of_two > 0);  // why they are told apart
}

TEST_CASE("no double is nearer to the largest coordinate than the gap that is shown", "[words]") {
  int powers = 0, others = 0;
  on_all_settings("points", 300, [&](const Parameters& p, const Walk& walk) {
    const Step* const told = find(walk, "spacing");
    if (!told) return;
    const std::string unit = text(p, "unit");
    const double in_unit =
        std::max(std::get<Vec3>(p.at("p")).cwiseAbs().maxCoeff(), std::get<Vec3>(p.at("q")).cwiseAbs().maxCoeff());
    const double largest = in_unit * (unit == "huge" ? 0x1p600 : unit == "tiny" ? 0x1p-600 : 1);
    const double infinity = std::numeric_limits<double>::infinity();
    const double gap =
        std::min(std::nextafter(largest, infinity) - largest, largest - std::nextafter(largest, -infinity));
    int exponent = 0;
    const bool power = std::frexp(largest, &exponent) == 0.5;
    INFO(told->caption << " " << told->formula);
    CHECK(told->formula.ends_with(" " + shown(gap)));
    CHECK(says(told->caption, "power of two") == power);
    CHECK(says(told->formula, "before") == power);
    CHECK_THAT(told->caption, Contains("any smaller tolerance means equality") && !Contains("half"));
    ++(power ? powers : others);
  });
  CHECK((powers > 0 && others > 0));
}

TEST_CASE("the least distance of capsules is that of the nearest end, unless it may be less still", "[words]") {
  int least = 0, perhaps = 0;
  on_all_settings("capsule-capsule", 500, [&](const Parameters& p, const Walk& walk) {
    const auto s = lessons::capsule_capsule_lesson::setup(p);
    const Step& last = *find(walk, "relation");
    if (!last.comparison) return;
    const double told = last.comparison->left, scale = 1 + (s.a.p - s.b.p).norm();
    const bool crossing = says(find(walk, "crossing")->caption, "They cross"),
               less = says(last.comparison->meaning, "less still");
    const double truth = crossing ? 0 : nearest_end(s);
    CAPTURE(told, truth, last.comparison->meaning);
    CHECK(truth <= nearest_on_grid(s) + 1e-9 * scale);
    CHECK(told >= truth - 1e-9 * scale);
    if (!less) CHECK(told <= truth + 1e-9 * scale);
    ++(less ? perhaps : least);
  });
  CHECK((least > 20 && perhaps > 0));
}

TEST_CASE("the axis that is called tightest has the least common part among all of its group", "[words]") {
  namespace own = lessons::obb_obb_lesson;
  using obb_obb::Kind;
  int seen = 0;
  on_all_settings("obb-obb", 200, [&](const Parameters& p, const Walk& walk) {
    const own::Setup s = own::setup(p);
    for (const auto& [slug, kind] : std::initializer_list<std::pair<const char*, Kind>>{
             {"normals-a", Kind::face_of_a}, {"normals-b", Kind::face_of_b}, {"edges", Kind::edges}}) {
      const Step* const told = find(walk, slug);
      if (!told || !says(told->caption, "The tightest one is drawn: ")) continue;
      ++seen;
      constexpr double rounding = 1e-13;
      double least = std::numeric_limits<double>::infinity(), drawn = -least;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < (kind == Kind::edges ? 3 : 1); ++j) {
          const obb_obb::Axis axis = {kind, i, j};
          const obb_obb::Tested<3> on = own::projections(s, axis);
          const double length = on.l.norm();
          if (!(length > 1e-9)) continue;
          const double common = on.radius_a + on.radius_b - on.distance;
          const double widened = 2 * s.epsilon * (s.a.half.sum() + s.b.half.sum());  // at most, by the test
          least = std::min(least, (common + widened + rounding) / length);
          if (says(told->caption, "drawn: " + own::name_of(axis) + ".")) drawn = (common - rounding) / length;
        }
      CAPTURE(told->caption, least, drawn);
      CHECK(drawn <= least);
    }
  });
  CHECK(seen > 100);
}

TEST_CASE("no place of a box is nearer to the centre than the one that is called nearest", "[words]") {
  on_all_settings("sphere-aabb", 200, [&](const Parameters& p, const Walk&) {
    const auto s = lessons::sphere_aabb_lesson::setup(p);
    if (empty(s.box)) return;
    const double told = (s.nearest() - s.ball.center).norm();
    for (int i = 0; i < 125; ++i) {
      const Vec3 share(i % 5 / 4.0, i / 5 % 5 / 4.0, i / 25 / 4.0);
      const Vec3 place = s.box.lo + share.cwiseProduct(s.box.hi - s.box.lo);
      CHECK((place - s.ball.center).norm() >= told - 1e-9);
    }
  });
}

}  // namespace rivals_test
