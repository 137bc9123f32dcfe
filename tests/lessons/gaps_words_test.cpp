// What an exam found missing: fill rules, a bad order, what is not a number, one large box, updates against tests. Each
// claim is computed here in another way.

#include <algorithm>
#include <cmath>
#include <map>

#include "bench/orient2d/oracle.h"
#include "lessons/bounding_volumes/upkeep.h"
#include "lessons/clipping/picture.h"
#include "lessons/concave_polygon/depth.h"
#include "lessons/crossings/situations.h"
#include "lessons/hierarchy/large.h"
#include "lessons/hierarchy/splits.h"
#include "tests/lessons/words.h"
#include "viz/text/rich_text.h"

namespace gaps_words_test {
using namespace isect;
using namespace isect::viz;
using namespace isect::tests;
using isect::test::Contains;

namespace {

struct Turns {
  int crossings = 0, winding = 0;
};
/// What the ray to the right crosses, by signs in rationals; a vertex at the point's height counts as below.
Turns turns(const Point<double, 2>& p, const Polygon<double, 2>& polygon) {
  Turns t;
  for (const Ring<double, 2>& ring : polygon.rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point<double, 2>&a = ring[i], &b = ring[(i + 1) % ring.size()];
      if ((a.y() > p.y()) == (b.y() > p.y())) continue;
      const int up = b.y() > a.y() ? 1 : -1;
      if (oracle::orientation(a, b, p) == up) ++t.crossings, t.winding += up;
    }
  return t;
}

}  // namespace

TEST_CASE("what is said of both fill rules is so, and who fills by which", "[words]") {
  int apart = 0, clockwise = 0, both = 0;
  const auto look = [&](const Parameters& p, const Walk& walk) {
    const Step* const last = find(walk, "verdict");
    if (text(p, "rule") != "half-open" || last == nullptr) return;
    const lessons::crossings_lesson::Setup setup(p);
    const Turns t = turns(setup.p, setup.polygon);
    CHECK(value(*last, "winding number") == t.winding);
    CHECK(says(last->caption, "by the non-zero rule **p** lies inside") == (t.crossings % 2 == 0 && t.winding != 0));
    CHECK(says(last->caption, "Fonts are filled by the non-zero rule") == !setup.simple);
    if (setup.simple) return;
    CHECK(says(last->caption, "both rules say inside") == (t.crossings % 2 == 1));
    CHECK(says(last->caption, "winds clockwise") == (t.winding < 0));
    apart += t.crossings % 2 == 0 && t.winding != 0, clockwise += t.winding < 0, both += t.crossings % 2 == 1;
  };
  for (const Preset& p : lesson("crossings").presets) look(p.parameters, lesson("crossings").walk(p.parameters));
  on_random_settings("crossings", 300, look);
  for (const int seen : {apart, clockwise, both}) CHECK(seen > 0);

  const Step& eight = ending(walk_of("crossings", "figure-eight"));
  CHECK(value(eight, "winding number") == -1);
  CHECK(eight.verdict.kind == Verdict::Kind::yes);
  const Walk left = with("crossings", "figure-eight", {{"p", "-0.75,0.125,0"}});
  CHECK(value(ending(left), "winding number") == 1);
}

namespace {

/// The longest path from a node, every way tried.
int longest(const TrapezoidMap& map, int node) {
  const TrapezoidMap::Node& n = map.nodes[static_cast<std::size_t>(node)];
  if (n.ask == TrapezoidMap::Ask::nothing) return 0;
  return 1 + std::max(longest(map, n.first), longest(map, n.second));
}

}  // namespace

TEST_CASE("the longest path of a bad order is what it is said to be, and grows as n on spikes", "[words]") {
  namespace own = lessons::concave_polygon_lesson;
  const Preset& sorted = preset(lesson("concave-polygon"), "trapezoids-sorted");
  const own::Setup setup(sorted.parameters);
  Record<trapezoid_map::BuildEvent> built;
  const TrapezoidMap map = own::sorted_map(setup.ring, built);
  CHECK(depth(map) == longest(map, 0));
  CHECK(depth(map) == setup.size() + 2);
  for (std::size_t k = 0; k < built.events.size(); ++k)  // from left to right
    CHECK(std::get<trapezoid_map::Inserted>(built.events[k]).piece == static_cast<int>(k));

  const Walk walk = lesson("concave-polygon").walk(sorted.parameters);
  const Step& told = *find(walk, "depth");
  int least = 100, greatest = 0;
  for (std::uint64_t seed = 1; seed <= 32; ++seed) {
    const TrapezoidMap random = make_trapezoid_map(setup.ring, seed);
    CHECK(depth(random) == longest(random, 0));
    least = std::min(least, depth(random)), greatest = std::max(greatest, depth(random));
  }
  CHECK(value(told, "longest path") == depth(map));
  CHECK_THAT(told.caption, Contains("The longest path here asks " + std::to_string(depth(map)) + " questions") &&
                               Contains("asks " + std::to_string(least) + " to " + std::to_string(greatest) + ","));
  CHECK(depth(map) >= greatest);
  CHECK(value(ending(walk), "questions asked") == depth(map));  // the preset's point is found by the longest path
  for (int spikes = own::fewest_spikes; spikes <= own::most_spikes; spikes *= 2) {
    const own::Depths& d = own::depths_of(spikes);
    CHECK(d.sorted == d.n + 2);
    CHECK(d.random < 8 * std::log2(d.n + 1));
  }
  CHECK(answer(told) == "as *n*");
}

namespace {

/// std::min and std::max, as C++ defines them.
double least(double a, double b) { return b < a ? b : a; }
double most(double a, double b) { return a < b ? b : a; }

/// Whether slabs by reciprocals keep a part of the segment.
bool slabs_keep(const Aabb<double, 2>& box, const Vec3& p, const Vec3& q, bool range_first) {
  double in = 0, out = 1;
  for (int i = 0; i < 2; ++i) {
    const double inverse = 1 / (q[i] - p[i]), t1 = (box.lo[i] - p[i]) * inverse, t2 = (box.hi[i] - p[i]) * inverse;
    const double entry = least(t1, t2), exit = most(t1, t2);
    in = range_first ? most(in, entry) : most(entry, in);
    out = range_first ? least(out, exit) : least(exit, out);
  }
  return in <= out;
}

}  // namespace

TEST_CASE("slabs by reciprocals keep and lose what min and max as C++ defines them do", "[words]") {
  int wrong = 0, hidden = 0, passed_over = 0, forgotten = 0;
  const auto look = [&](const Parameters& p, const Walk& walk) {
    if (text(p, "shape") != "slabs") return;
    const Vec3 &from = std::get<Vec3>(p.at("p")), &to = std::get<Vec3>(p.at("q"));
    const bool range_first = text(p, "first") == "range";
    const Aabb<double, 2> box = lessons::clipping_lesson::box_of(p);
    const Step& last = ending(walk);
    INFO(last.caption << " " << last.verdict.text);
    CHECK((last.line == 4) == slabs_keep(box, from, to, range_first));
    const bool seen = says(last.caption, "With the arguments exchanged it would keep");
    if (seen) CHECK(says(last.caption, "would keep a part") == slabs_keep(box, from, to, !range_first));
    wrong += says(last.verdict.text, "loses it"), hidden += says(last.caption, "hidden");
    passed_over += says(last.caption, "passed over"), forgotten += says(last.caption, "forgotten");
    if (says(last.caption, "passed over")) CHECK(last.verdict.kind != Verdict::Kind::no);
    if (says(last.caption, "loses it")) CHECK((last.verdict.kind == Verdict::Kind::on && last.line == 5));
  };
  for (const Preset& p : lesson("clipping").presets) look(p.parameters, lesson("clipping").walk(p.parameters));
  on_random_settings("clipping", 600, look);
  for (const int seen : {wrong, hidden, passed_over, forgotten}) CHECK(seen > 0);

  const auto ends = [](const char* id) -> std::string { return ending(walk_of("clipping", id)).verdict.text; };
  CHECK_FALSE(says(ends("slabs-bottom"), "loses"));
  CHECK(says(ends("slabs-bottom-exchanged"), "loses it"));
  CHECK(says(ends("slabs-top"), "loses it"));
  CHECK(says(ends("slabs-left-exchanged"), "keeps more"));
}

TEST_CASE("a box nearly as large as all costs what its nodes' perimeters say", "[words]") {
  namespace own = lessons::hierarchy_lesson;
  const auto cost = [](const own::Boxes& boxes, double whole) {
    const Bvh<double, 2> bvh = build_bvh(boxes, own::options);
    double sum = 0;
    for (const auto& node : bvh.nodes) sum += own::half_perimeter(node.box) / whole * (node.leaf() ? node.count : 1);
    return sum;
  };
  int large = 0, gains = 0;
  const auto look = [&](const Parameters& p, const Walk& walk) {
    if (text(p, "walk") != "build") return;
    own::Boxes boxes = own::boxes_of(p);
    const own::Tree tree(boxes);
    const auto biggest = std::ranges::max_element(boxes, {}, own::half_perimeter);
    const double whole = own::half_perimeter(tree.node(0).box), share = own::half_perimeter(*biggest) / whole;
    const Step* const told = find(walk, "large");
    CHECK((told != nullptr) == (share >= 0.5));
    if (told == nullptr) return;
    ++large;
    const int number = static_cast<int>(biggest - boxes.begin());
    for (int i = 0; i < tree.size(); ++i)
      if (std::ranges::count(tree.below(i), number) > 0) CHECK(own::half_perimeter(tree.node(i).box) / whole >= share);
    const double with_it = cost(boxes, whole);
    boxes.erase(biggest);
    const double apart = 1 + cost(boxes, whole);
    CHECK(std::abs(value(*told, "expected cost") - with_it) < 1e-9);
    CHECK(std::abs(value(*told, "expected cost, box " + std::to_string(number) + " apart") - apart) < 1e-9);
    if (std::abs(apart - with_it) > 1e-9) {
      CHECK(says(told->caption, "So builders take such a box out") == (apart < with_it));
      CHECK(answer(*told) == (apart < with_it ? "it falls" : "it rises"));
    }
    gains += apart < with_it;
  };
  for (const Preset& p : lesson("hierarchy").presets) look(p.parameters, lesson("hierarchy").walk(p.parameters));
  on_random_settings("hierarchy", 300, look);
  CHECK((large > 0 && gains > 0));
  CHECK(answer(*find(walk_of("hierarchy", "large"), "large")) == "it falls");
}

TEST_CASE("a k-DOP costs less than an OBB from the tests on that are said, and not before", "[words]") {
  int told = 0;
  on_random_settings("bounding-volumes", 30, [&](const Parameters& p, const Walk& walk) {
    const Step* const step = find(walk, "upkeep");
    CHECK((step != nullptr) == (text(p, "walk") == "fit"));
    if (step == nullptr) return;
    ++told;
    std::map<std::string, double> given;
    for (const Value& v : step->question->given)
      given[v.name.starts_with("OBB") ? v.name : v.name.substr(v.name.find("DOP"))] = v.value;
    const auto dop = [&](double tests) { return given.at("DOP: update") + tests * given.at("DOP: test"); };
    const auto obb = [&](double tests) { return given.at("OBB: update") + tests * given.at("OBB: test"); };
    const int from = std::stoi(answer(*step));
    CHECK(dop(from) < obb(from));
    if (from > 1) CHECK(dop(from - 1) >= obb(from - 1));
    CHECK(says(step->caption, "from " + std::to_string(from) + (from == 1 ? " test" : " tests")));
    CHECK(given.at("OBB: update") == 60);  // four vectors turned: nine products and six sums each
  });
  CHECK(told > 5);
  namespace own = lessons::bounding_volumes_lesson;
  CHECK(own::tests_to_pay(60, 250, 60 + 236 * 3, 14) == 4);
  CHECK(own::tests_to_pay(60, 250, 10, 14) == 1);
}

TEST_CASE("the near plane is a sum of rows or a row alone, as the two conventions say", "[words]") {
  const std::string solution = plain(lesson("culling").closing->exercises[3].solution);
  CHECK_THAT(solution, Contains("OpenGL") && Contains("row 4 + row 3") && Contains("row 3 alone"));
  const double n = 0.5, f = 8;  // a point at depth z in front of the eye has the clip depth a z + b, and w = z
  const auto near_by = [&](double a, double b, bool sum) { return sum ? a * n + b + n : a * n + b; };
  CHECK(std::abs(near_by((f + n) / (f - n), -2 * f * n / (f - n), true)) <
        1e-12);                                                            // −w at the near plane, w at the far
  CHECK(std::abs(near_by(f / (f - n), -f * n / (f - n), false)) < 1e-12);  // 0 and w
}

TEST_CASE("hulls in output-sensitive time are named with those who found them", "[words]") {
  const Closing& closing = *lesson("convex-hull").closing;
  CHECK_THAT(plain(closing.cost), Contains("O(n lg h)"));
  CHECK_THAT(plain(closing.exercises[3].solution), Contains("Kirkpatrick") && Contains("Chan"));
  for (const char* author : {"Kirkpatrick", "Timothy Chan"})
    CHECK(std::ranges::any_of(closing.reading, [&](const std::string& r) { return says(r, author); }));
}

}  // namespace gaps_words_test
