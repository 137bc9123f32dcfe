// The lessons of relations, bounding volumes and hierarchies: what they show against computations of their own.

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include <isect/aabb_aabb.h>
#include <isect/convex_polygons.h>
#include <isect/obb_obb.h>
#include <isect/point_aabb.h>
#include <isect/point_kdop.h>
#include <isect/point_obb.h>
#include <isect/point_sphere.h>
#include <isect/ray_aabb.h>
#include <isect/sphere_sphere.h>
#include <isect/triangle_aabb.h>
#include "lessons/bounding_volumes/object.h"
#include "lessons/hierarchy/tree.h"
#include "lessons/lessons.h"
#include "lessons/relations/picture.h"
#include "lessons/shared/relation.h"
#include "tests/catch.h"
#include "tests/lessons/words.h"
#include "viz/chart/chart.h"
#include "viz/player/reader_state.h"
#include "viz/walk/closing.h"

namespace volumes_test {
using namespace isect;
using namespace isect::viz;

namespace {

Walk walk_of(const std::string& lesson, const std::string& id) {
  const Lesson& l = lesson_named(lessons::all_lessons(), lesson);
  return l.walk(preset(l, id).parameters);
}

const Step& step_of(const Walk& walk, const std::string& slug) {
  return *std::ranges::find_if(walk.steps, [&](const Step& s) { return s.slug == slug; });
}

template <class T>
int count(const std::vector<Item>& items) {
  return static_cast<int>(
      std::ranges::count_if(items, [](const Item& item) { return std::holds_alternative<T>(item); }));
}

}  // namespace

namespace relations = isect::lessons::relations_lesson;

TEST_CASE("each situation of the relations lesson has the relation that it is named after", "[relations]") {
  for (const relations::Kind kind : relations::kinds) {
    std::vector<Relation> found;
    for (const relations::Situation& s : relations::situations(kind))
      for (const double scale : {1.0, 0.375, 0.21875}) {  // as large as in the grids
        INFO(relations::name(kind) << ", " << s.id << ", times " << scale);
        const relations::Pair pair(kind, s.pose, scale);
        CHECK(pair.truth == s.relation);
        CHECK(isect::lessons::relation_name(pair.truth) == s.title);
        CHECK(pair.meet == (s.relation != Relation::disjoint));
        found.push_back(pair.truth);
      }
    CHECK(found.size() == 18);
    for (int r = 0; r < 6; ++r) CHECK(std::ranges::count(found, static_cast<Relation>(r)) == 3);
  }
}

TEST_CASE("what two shapes share is drawn as what it is", "[relations]") {
  using relations::Kind;
  const auto shared = [](Kind kind, Relation relation) {
    const auto& all = relations::situations(kind);
    const auto it = std::ranges::find_if(all, [&](const relations::Situation& s) { return s.relation == relation; });
    return relations::shared(relations::Pair(kind, it->pose));
  };
  CHECK(count<Dot>(shared(Kind::balls, Relation::touching)) == 1);
  CHECK(count<Region>(shared(Kind::aabbs, Relation::touching)) == 1);  // a face
  CHECK(count<Dot>(shared(Kind::obbs, Relation::touching)) == 1);      // a corner in a face
  CHECK(count<Dot>(shared(Kind::polygons, Relation::touching)) == 1);  // a corner on an edge
  CHECK(count<Circle>(shared(Kind::balls, Relation::overlapping)) == 1);
  CHECK(count<Solid>(shared(Kind::aabbs, Relation::overlapping)) == 1);
  CHECK(count<Solid>(shared(Kind::obbs, Relation::overlapping)) == 1);
  CHECK(count<Region>(shared(Kind::polygons, Relation::overlapping)) == 1);
  for (const Kind kind : relations::kinds) CHECK(shared(kind, Relation::disjoint).empty());
}

TEST_CASE("a point is left over just where one does not contain the other", "[relations]") {
  for (const relations::Kind kind : relations::kinds)
    for (const relations::Situation& s : relations::situations(kind)) {
      INFO(relations::name(kind) << ", " << s.id);
      const relations::Pair pair(kind, s.pose);
      const bool a_in_b = s.relation == Relation::a_inside_b || s.relation == Relation::equal;
      const bool b_in_a = s.relation == Relation::b_inside_a || s.relation == Relation::equal;
      CHECK(relations::left_over(pair.a, pair.b).has_value() == !a_in_b);
      CHECK(relations::left_over(pair.b, pair.a).has_value() == !b_in_a);
    }
}

TEST_CASE("five of the six relations say yes, and the walks' verdicts name them", "[relations]") {
  const Lesson& lesson = lesson_named(lessons::all_lessons(), "relations");
  for (const Preset& p : lesson.presets) {
    if (p.id == "all-kinds") continue;
    INFO(p.id);
    const Walk walk = lesson.walk(p.parameters);
    bool named =  // a way of lying inside, not a seventh relation
        p.id == "ball-inner-touch" &&
        walk.steps.back().verdict.text == lessons::relation_words(Relation::b_inside_a, "the balls");
    for (const relations::Kind kind : relations::kinds)
      for (const relations::Situation& s : relations::situations(kind))
        named = named || (p.title == relations::name(kind) + ": " + s.title &&
                          walk.steps.back().verdict.text == lessons::relation_words(s.relation, relations::they(kind)));
    CHECK(named);
    if (p.id.find("disjoint") != std::string::npos) continue;
    const Step& grid = step_of(walk, "what-it-loses");
    REQUIRE(grid.values.size() == 1);
    CHECK(grid.values[0].value == 5);
    CHECK(std::ranges::count_if(grid.scene.items, [](const Item& item) {
            const auto* heading = std::get_if<viz::Heading>(&item);
            return heading != nullptr && heading->text == "yes" && heading->role == Role::hit;
          }) == 5);
  }
  // Same places, same sizes: the balls touch, the AABBs overlap.
  const Walk all = walk_of("relations", "all-kinds");
  std::vector<std::string> notes;
  for (const Item& item : tests::own_step(all, 0).scene.items)
    if (const auto* heading = std::get_if<viz::Heading>(&item))
      if (!heading->bold) notes.push_back(heading->text);
  REQUIRE(notes.size() == 4);
  CHECK(notes[0] == "they touch");
  CHECK(notes[1] == "they overlap");
}

namespace volumes = isect::lessons::bounding_volumes_lesson;

TEST_CASE("each bounding volume holds every vertex, and the hull is the tightest", "[bounding volumes]") {
  for (const std::string& name : volumes::objects)
    for (const Vec3& tip : {Vec3(0.875, 1.25, -0.625), Vec3(0, 1.5, 0), Vec3(0, 0, 0)}) {
      INFO(name << " to " << tip.transpose());
      const TriangleMesh<double> mesh = volumes::object(name, tip);
      REQUIRE(valid(mesh));
      const volumes::Fitted fitted(mesh, 14);
      for (const Vec3& p : mesh.vertices) {
        CHECK(locate(p, fitted.ball) != Location::out);
        CHECK(locate(p, fitted.aabb) != Location::out);
        CHECK(locate(p, fitted.obb) != Location::out);
        CHECK(locate(p, fitted.kdop) != Location::out);
      }
      CHECK(fitted.object > 0);  // turned outside out
      const std::vector<volumes::Measured> all =
          volumes::measured(fitted, volumes::measured(fitted.kdop, fitted.object));
      REQUIRE(all.size() == 5);
      for (const volumes::Measured& m : all) {
        CHECK(m.volume >= fitted.object * (1 - 1e-12));
        CHECK(m.volume >= all[4].volume * (1 - 1e-12));
      }
      CHECK(all[3].volume <= all[1].volume);  // a 14-DOP has the AABB's slabs and more
    }
}

TEST_CASE("the objects' surfaces are closed: each edge has its two triangles", "[bounding volumes]") {
  for (const std::string& name : volumes::objects) {
    INFO(name);
    std::map<std::pair<int, int>, int> edges;
    for (const auto& t : volumes::object(name, {0.875, 1.25, -0.625}).triangles)
      for (int i = 0; i < 3; ++i) ++edges[{t[i], t[(i + 1) % 3]}];
    for (const auto& [edge, times] : edges) {
      CHECK(times == 1);
      CHECK(edges.count({edge.second, edge.first}) == 1);
    }
  }
}

TEST_CASE("numbers kept and operations are those of the definitions", "[bounding volumes]") {
  const volumes::Fitted fitted(volumes::object("pin", {0.875, 1.25, -0.625}), 18);
  const std::vector<volumes::Measured> all = volumes::measured(fitted, volumes::measured(fitted.kdop, fitted.object));
  CHECK(all[0].numbers == 4);
  CHECK(all[1].numbers == 6);
  CHECK(all[2].numbers == 15);
  CHECK(all[3].numbers == 18);
  CHECK(all[0].tally == Tally{4, 6, 0, 0, 1});  // differences, dot product, sum of radii and its square
  CHECK(all[1].tally == Tally{0, 0, 0, 0, 6});  // two comparisons an axis
  CHECK(all[3].tally == Tally{0, 0, 0, 0, 18});
  CHECK(all[2].tally.compare >= 15);  // one for each axis, at least
  CHECK(all[2].operations() > 10 * all[0].operations());
}

TEST_CASE("a trivial answer asks no triangle, potential overlap asks them all", "[bounding volumes]") {
  const auto operations = [](const Step& s) {
    const Counters& c = s.counters;
    return c.mul + c.add + c.div + c.sqrt + c.compare;
  };
  const Lesson& lesson = lesson_named(lessons::all_lessons(), "bounding-volumes");
  for (const Preset& p : lesson.presets) {
    if (std::get<std::string>(p.parameters.at("walk")) != "test") continue;
    INFO(p.id);
    const Walk walk = lesson.walk(p.parameters);
    const TriangleMesh<double> mesh =
        volumes::object(std::get<std::string>(p.parameters.at("object")), std::get<Vec3>(p.parameters.at("tip")));
    const Vec3 q = std::get<Vec3>(p.parameters.at("q")),
               reach = Vec3::Constant(std::get<double>(p.parameters.at("reach")));
    const Aabb<double, 3> window = {q - reach, q + reach};
    int inside = 0, meet = 0;
    for (const Vec3& v : mesh.vertices) inside += locate(v, window) != Location::out ? 1 : 0;
    for (int i = 0; i < static_cast<int>(mesh.triangles.size()); ++i)
      meet += intersects(triangle(mesh, i), window) ? 1 : 0;

    const Step& last = walk.steps.back();
    const std::vector<std::string> branches = {"reject", "accept", "void", "overlap",
                                               "within"};  // as the presets are named
    CHECK(branches[lesson.map->branch(p.parameters)] == p.id);
    if (p.id == "reject" || p.id == "accept") {
      CHECK(operations(last) <= 18);  // two boxes disjoint, one in the other
      CHECK(last.counters.early_out);
      CHECK(inside == (p.id == "accept" ? static_cast<int>(mesh.vertices.size()) : 0));
      CHECK(last.verdict.kind == (p.id == "accept" ? Verdict::Kind::yes : Verdict::Kind::no));
    } else {
      CHECK(operations(last) > 1000);
      CHECK((meet > 0) == (p.id == "overlap"));
      CHECK((last.verdict.kind == Verdict::Kind::yes) == (p.id != "void"));
    }
  }
}

TEST_CASE("the best of the chart are beaten by none", "[bounding volumes]") {
  const Walk walk = walk_of("bounding-volumes", "tilted");
  const Plot& plot = std::get<Plot>(walk.steps[outcome(walk)].scene.chart->kind);
  REQUIRE(plot.panels.size() == 1);
  const std::vector<Spot>& spots = plot.panels[0].spots;
  CHECK(spots.size() == 6);
  for (const Spot& s : spots)
    CHECK(s.front == std::ranges::none_of(spots, [&](const Spot& other) {
            return other.x <= s.x && other.y <= s.y && (other.x < s.x || other.y < s.y);
          }));
}

namespace hierarchy = isect::lessons::hierarchy_lesson;

namespace {

double value_of(const Step& step, const std::string& name) {
  const auto it = std::ranges::find_if(step.values, [&](const Value& v) { return v.name == name; });
  REQUIRE(it != step.values.end());
  return it->value;
}

Vec3 vector(const Parameters& p, const char* name) { return std::get<Vec3>(p.at(name)); }

}  // namespace

TEST_CASE("the walk of a ray ends with the closest box of all, and each box is tested or ruled out", "[hierarchy]") {
  const Lesson& lesson = lesson_named(lessons::all_lessons(), "hierarchy");
  int hits = 0, pruned_beyond = 0;
  for (Preset p : lesson.presets) {
    if (p.group != "ray") continue;
    for (const double aside : {0.0, 0.25, -0.5, 1.25, 40.0}) {  // other rays, too
      p.parameters["o"] = Vec3(vector(p.parameters, "o") + Vec3(0, aside, 0));
      INFO(p.id << ", " << aside);
      const Vec3 o = vector(p.parameters, "o"), d = vector(p.parameters, "d");
      const hierarchy::Boxes boxes = hierarchy::scattered(vector(p.parameters, "p"));
      std::optional<std::pair<double, int>> closest;
      for (int i = 0; i < static_cast<int>(boxes.size()); ++i) {
        const auto part = intersect(Ray<double, 2>{o.head<2>(), d.head<2>()}, boxes[i]);
        if (part && (!closest || part->lo < closest->first)) closest = {part->lo, i};
      }
      const Walk walk = lesson.walk(p.parameters);
      const Step& last = walk.steps.back();
      CHECK((last.verdict.kind == Verdict::Kind::yes) == closest.has_value());
      if (closest)
        CHECK(last.verdict.text == "box " + std::to_string(closest->second) + " at *t* = " + shown(closest->first));
      CHECK(value_of(last, "box tests") + value_of(last, "ruled out") == 12);
      hits += closest ? 1 : 0;
      for (const Step& s : walk.steps) pruned_beyond += s.slug.starts_with("farther") ? 1 : 0;
    }
  }
  CHECK(hits >= 5);
  CHECK(pruned_beyond >= 2);
}

TEST_CASE("two hierarchies find the pairs that each with each finds, and account for all of them", "[hierarchy]") {
  const Lesson& lesson = lesson_named(lessons::all_lessons(), "hierarchy");
  Parameters parameters = preset(lesson, "pairs").parameters;
  for (const Vec3& q : {vector(parameters, "q"), Vec3(-2.5, 0.75, 0), Vec3(-1.5, -1.25, 0), Vec3(50, 0, 0)}) {
    INFO(q.transpose());
    parameters["q"] = q;
    const hierarchy::Boxes a = hierarchy::scattered(vector(parameters, "p")), b = hierarchy::cluster(q);
    int found = 0;
    for (const auto& x : a)
      for (const auto& y : b) found += intersects(x, y) ? 1 : 0;
    const Walk walk = lesson.walk(parameters);
    const Step& last = walk.steps.back();
    CHECK(value_of(last, "found") == found);
    CHECK((found == 0) == (last.verdict.kind == Verdict::Kind::no));
    const bool any_apart = std::ranges::any_of(walk.steps, [](const Step& s) { return s.slug.starts_with("apart"); });
    const double ruled_out = any_apart ? value_of(last, "pairs ruled out") : 0;
    CHECK(value_of(last, "box pairs") + ruled_out == static_cast<double>(a.size() * b.size()));
  }
}

TEST_CASE("nodes hold what is below them, and the walk of building ends with them all", "[hierarchy]") {
  const hierarchy::Tree tree(hierarchy::scattered({-3.5, 1.25, 0}));
  CHECK(tree.below(0).size() == 12);
  for (int i = 0; i < tree.size(); ++i)
    for (const int k : tree.below(i)) CHECK(relate(tree.box(k), tree.node(i).box) != Relation::overlapping);
  const Walk walk = walk_of("hierarchy", "build");
  CHECK(value_of(walk.steps.back(), "nodes") == tree.size());
  CHECK(value_of(walk.steps.back(), "depth") == tree.height(0));
}

TEST_CASE("a hierarchy's costs grow slowly with n", "[hierarchy]") {
  const std::vector<hierarchy::Cost>& costs = hierarchy::costs();
  for (const hierarchy::Cost& c : costs) {
    INFO("n = " << c.n);
    if (c.n >= 100) CHECK(c.ray < c.n / 3.0);
    if (c.n >= 100) CHECK(c.pairs < 0.1 * c.n * c.n);
    CHECK(c.pairs >= c.n - 1);  // no pair of siblings is forgotten
    CHECK(c.depth < 40 + std::log2(c.n));
  }
  const hierarchy::Cost &some = costs[4], &most = costs.back();
  REQUIRE((some.n == 1000 && most.n == 100000));
  CHECK(most.ray < 4 * some.ray);
  CHECK(most.pairs / most.n < 4 * some.pairs / some.n);
}

}  // namespace volumes_test
