// Slabs, trapezoids and hierarchy of the concave-polygon lesson, against the exact crossings and by counting anew.

#include <algorithm>
#include <cmath>
#include <set>

#include <isect/many/trapezoid_map.h>
#include "lessons/concave_polygon/map_picture.h"
#include "lessons/concave_polygon/triangles.h"
#include "lessons/lessons.h"
#include "tests/catch.h"
#include "viz/chart/chart.h"

namespace concave_polygon_test {
using namespace isect;
using namespace isect::viz;
using namespace isect::lessons::concave_polygon_lesson;

namespace {

const Lesson& lesson() {
  for (const Lesson* l : lessons::all_lessons())
    if (l->id == "concave-polygon") return *l;
  throw std::runtime_error("no such lesson");
}

Walk walk_of(const std::string& id) { return lesson().walk(preset(lesson(), id).parameters); }

Setup of(const std::string& polygon) { return Setup({{"polygon", polygon}, {"p", Vec3(0, 0, 0)}}); }

double value(const Step& step, const std::string& name) {
  for (const Value& v : step.values)
    if (v.name == name) return v.value;
  throw std::runtime_error("no value " + name);
}

bool has(const Walk& walk, const std::string& slug) {
  return std::ranges::any_of(walk.steps, [&](const Step& s) { return s.slug == slug; });
}

double area(const Ring<double, 2>& r) {
  double twice = 0;
  for (std::size_t i = 0; i < r.size(); ++i) {
    const Point<double, 2>&a = r[i], &b = r[(i + 1) % r.size()];
    twice += a.x() * b.y() - b.x() * a.y();
  }
  return twice / 2;
}

}  // namespace

TEST_CASE("each way ends with the exact location, wherever the point is dragged", "[concave-polygon lesson]") {
  int in = 0, on = 0, out = 0;
  for (const Preset& p : lesson().presets) {
    INFO(p.id);
    Parameters parameters = p.parameters;
    const Setup setup(parameters);
    for (double x = -3.5; x <= 1.25; x += 0.25)
      for (double y = -2.25; y <= 2.25; y += 0.25) {
        parameters["p"] = Vec3(x, y, 0);
        const Location truth = locate(Point<double, 2>(x, y), setup.ring);
        ++(truth == Location::in ? in : truth == Location::on ? on : out);
        CHECK(lesson().opinions(parameters).front().says == (truth == Location::in   ? "inside"
                                                             : truth == Location::on ? "on the boundary"
                                                                                     : "outside"));
        for (const Opinion& o : lesson().opinions(parameters))  // of points so round; a boundary belongs to the polygon
          CHECK(o.agrees == !(truth == Location::on && o.says.starts_with("outside")));
        const Verdict verdict = lesson().walk(parameters).steps.back().verdict;
        CHECK(verdict.kind == (truth == Location::in   ? Verdict::Kind::yes
                               : truth == Location::on ? Verdict::Kind::on
                                                       : Verdict::Kind::no));
      }
  }
  CHECK((in > 0 && on > 0 && out > 0));
}

TEST_CASE("the lesson visits a line of a slab, an edge, and both sides of vertices and edges",
          "[concave-polygon lesson]") {
  CHECK(has(walk_of("slabs-level"), "line"));
  CHECK_FALSE(has(walk_of("slabs"), "line"));
  std::set<std::string> titles;
  for (const Preset& p : lesson().presets)
    for (const Step& s : lesson().walk(p.parameters).steps)
      titles.insert(s.title.substr(s.title.starts_with("Comparison") ? s.title.find(": ") + 2 : 0));
  for (const char* title : {"left of the edge", "right of the edge", "on the edge", "Left of the vertex",
                            "Right of the vertex", "Below the edge", "Above the edge"})
    CHECK(titles.count(title) == 1);
}

TEST_CASE("slabs store an edge in each slab that it crosses", "[concave-polygon lesson]") {
  for (const char* polygon : {"concave", "spiky"}) {
    const Setup setup = of(polygon);
    std::set<double> heights;
    for (const auto& v : setup.ring) heights.insert(v.y());
    CHECK(heights.size() == setup.ring.size());  // no two vertices are level
    int stored = 0;
    for (std::size_t i = 0; i < setup.ring.size(); ++i) {
      const double a = setup.ring[i].y(), b = setup.ring[(i + 1) % setup.ring.size()].y();
      stored += static_cast<int>(
          std::abs(std::distance(heights.find(a), heights.end()) - std::distance(heights.find(b), heights.end())));
    }
    const Walk walk = walk_of(std::string("slabs") + (setup.spiky ? "-spiky" : ""));
    CHECK(value(walk.steps[1], "edges in slabs") == stored);
  }
}

TEST_CASE("on spikes slabs grow as the square of n, the map as n", "[concave-polygon lesson]") {
  const Kept few = kept(128), many = kept(512);
  const double times = std::log(static_cast<double>(many.n) / few.n);
  CHECK(std::log(many.slab_entries / few.slab_entries) / times == Approx(2.0).margin(0.05));
  CHECK(std::log(many.map_nodes / few.map_nodes) / times == Approx(1.0).margin(0.1));
  const Chart chart = growth();
  const auto& plot = std::get<Plot>(chart.kind);
  CHECK(plot.panels.front().curves.front().points.back() == Vec2(many.n, many.slab_entries));
}

TEST_CASE("the map told edge by edge is the core's own", "[concave-polygon lesson]") {
  const Setup setup = of("concave");
  const Walk walk = walk_of("trapezoids");
  const TrapezoidMap map = make_trapezoid_map(setup.ring);
  CHECK(sizes(map).trapezoids == 2 * setup.size() + 1);
  for (const Step& s : walk.steps)
    if (s.slug == "map") {
      CHECK(value(s, "trapezoids") == sizes(map).trapezoids);
      CHECK(value(s, "questions") == sizes(map).questions);
    }
  CHECK(value(walk.steps[1], "trapezoids") == 4);
  CHECK(value(walk.steps[1], "questions") == 3);
  for (const int t : reachable(map, 0)) CHECK(t < static_cast<int>(map.trapezoids.size()));
}

TEST_CASE("every level of the hierarchy tiles the box, and links tell what shares area", "[concave-polygon lesson]") {
  const Setup setup = of("concave");
  const Hierarchy h = make_hierarchy(setup.ring, {{-3.5, -2}, {1.5, 2}});
  REQUIRE(h.levels.size() > 2);
  for (std::size_t l = 0; l < h.levels.size(); ++l) {
    double all = 0, inside = 0;
    for (const auto& t : h.levels[l].triangles) {
      CHECK(area(h.triangle(t)) > 0);
      all += area(h.triangle(t));
      inside += t.inside ? area(h.triangle(t)) : 0;
      if (l > 0) CHECK_FALSE(t.links.empty());
    }
    CHECK(all == Approx(20.0));
    if (l == 0) CHECK(inside == Approx(area(setup.ring)));
  }
  CHECK(h.levels.back().triangles.size() == 2);
  for (double x = -3.4375; x < 1.5; x += 0.3125)
    for (double y = -1.9375; y < 2; y += 0.3125) {
      const Point<double, 2> p(x, y);
      const Location truth = locate(p, setup.ring);
      const std::vector<int> path = descend(h, p);
      REQUIRE(path.size() == h.levels.size());
      const auto& finest = h.levels[0].triangles[path.back()];
      if (truth != Location::on) CHECK(finest.inside == (truth == Location::in));
    }
  CHECK(descend(h, {5, 0}).empty());
}

}  // namespace concave_polygon_test
