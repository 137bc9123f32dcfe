// Claims of lessons that hold under a condition alone: each is told where its condition holds, and nowhere else.

#include <regex>

#include <isect/fit.h>
#include <isect/many/bvh_ray.h>
#include <isect/ray_aabb.h>
#include <isect/volume.h>
#include "lessons/bounding_volumes/object.h"
#include "lessons/collision/telling.h"
#include "lessons/concave_polygon/picture.h"
#include "lessons/glossary.h"
#include "lessons/hierarchy/tree.h"
#include "tests/lessons/texts.h"
#include "tests/lessons/words.h"
#include "viz/text/rich_text.h"

namespace claims_words_test {
using namespace isect;
using namespace isect::viz;
using namespace isect::tests;
using isect::test::Contains;

namespace {

const std::string& meaning(const std::string& term) {
  const auto found = std::ranges::find(lessons::glossary(), term, &lessons::Term::name);
  REQUIRE(found != lessons::glossary().end());
  return found->meaning;
}

}  // namespace

TEST_CASE("a sweep tests all whose intervals overlap, which may be every pair", "[words]") {
  CHECK_THAT(meaning("sweep and prune"), Contains("intervals there overlap") && !Contains("neighbour"));
  CHECK_THAT(lesson("collision").closing->result, Contains("Where few boxes overlap"));

  lessons::collision_lesson::Boxes slope;
  for (int i = 0; i < 5; ++i) slope.push_back({{1.0 * i, 0.5 * i}, {i + 100.0, 0.5 * i + 0.25}});
  const Walk all = lessons::collision_lesson::sweep(slope);
  CHECK(value(*find(all, "total"), "tests") == 10);
  CHECK_THAT(find(all, "total")->verdict.text, Contains("0 pairs"));
  CHECK_THAT(find(all, "total")->caption, Contains("every pair was tested") && !Contains("Only boxes"));

  on_random_settings("collision", 60, [](const Parameters& p, const Walk& walk) {
    if (text(p, "method") != "sweep") return;
    const Step& total = *find(walk, "total");
    const bool saved = value(total, "tests") < 15;  // six boxes
    CHECK(says(total.caption, "Only boxes whose intervals") == saved);
    CHECK(says(total.caption, "every pair was tested") == !saved);
  });
}

TEST_CASE("a box that touches the wall's end from beside does not tunnel", "[words]") {
  const auto told = [](const char* p) { return ending(with("collision", "tunnelling", {{"p", p}})).caption; };
  for (const char* p : {"-2.5,2,0", "-2.5,-2,0"})
    CHECK_THAT(told(p), Contains("missed it") && Contains("grazes the end of the wall") && !Contains("tunnelled"));
  CHECK_THAT(told("-2.5,1.984375,0"), Contains("tunnelled through") && !Contains("grazes"));

  const Exercise& e = lesson("collision").closing->exercises[1];  // to find a box that tunnels
  REQUIRE(e.found);
  Parameters setting = preset(lesson("collision"), "tunnelling").parameters;
  CHECK(e.found(setting));
  set(lesson("collision"), setting, "p", "-2.5,2,0");
  CHECK_FALSE(e.found(setting));
}

TEST_CASE("culling names the convention that its planes depend on, and what drawing too much costs", "[words]") {
  const std::string first = plain(walk_of("culling", "crossing").steps.front().caption);
  CHECK_THAT(first, Contains("−w ≤ z ≤ w") && Contains("0 ≤ z ≤ w") && Contains("Direct3D") && Contains("OpenGL"));
  const std::string drawn = ending(walk_of("culling", "beyond-an-edge")).caption;
  CHECK_THAT(drawn, Contains("False positive") && Contains("costs time"));
  for (const Lesson* l : lessons::all_lessons())
    for (const std::string& told : texts(*l)) CHECK_THAT(told, !Contains("harmless"));
}

TEST_CASE("a search that ends with the first hit would be wrong on the preset that shows that bug", "[words]") {
  const Closing& closing = *lesson("hierarchy").closing;
  CHECK_THAT(closing.bug, Contains("Returning the first hit"));
  CHECK_THAT(closing.result, Contains("Where boxes overlap little"));
  const Parameters& p = preset(lesson("hierarchy"), closing.bug_preset).parameters;
  const auto vector = [&](const char* name) { return std::get<Vec3>(p.at(name)); };
  const lessons::hierarchy_lesson::Tree tree(lessons::hierarchy_lesson::scattered(vector("p")));
  const Ray<double, 2> ray = {vector("o").head<2>(), vector("d").head<2>()};
  int first = -1;
  const auto hit = [&](int i) -> std::optional<double> {
    const std::optional<Interval<double>> part = intersect(ray, tree.box(i));
    if (!part) return {};
    if (first < 0) first = i;
    return part->lo;
  };
  const std::optional<BvhHit<double>> closest = closest_hit(tree.bvh, ray, hit);
  REQUIRE(closest);
  CHECK(first >= 0);
  CHECK(first != closest->primitive);
  CHECK_THAT(ending(lesson("hierarchy").walk(p)).verdict.text,
             Contains("box " + std::to_string(closest->primitive) + " at"));
}

TEST_CASE("the chance of a hit is proportional to the surface, and so P_L / P a chance", "[words]") {
  for (const char* id : {"build", "outlier"})
    CHECK_THAT(find(walk_of("hierarchy", id), "cut-1")->caption,
               Contains("is proportional to its surface") && !Contains("grows with"));
}

TEST_CASE("slabs without their lines would lose a point that is level with a vertex", "[words]") {
  const Closing& closing = *lesson("concave-polygon").closing;
  CHECK_THAT(closing.bug, Contains("level with a vertex") && !Contains("memory"));
  const lessons::concave_polygon_lesson::Setup s(preset(lesson("concave-polygon"), closing.bug_preset).parameters);
  CHECK(s.truth == Location::in);
  CHECK(std::ranges::any_of(s.ring, [&](const Point<double, 2>& v) { return v.y() == s.p.y(); }));
}

TEST_CASE("one count is not said to be an O: the reason of the bound stands beside it", "[words]") {
  static const std::regex count_as_bound("[0-9] (vertices|edges|tests|questions|steps|times as many)[^.]*: O\\(");
  for (const Lesson* l : lessons::all_lessons())
    for (const std::string& told : texts(*l)) {
      INFO(l->id << ": " << told);
      CHECK_FALSE(std::regex_search(plain(told), count_as_bound));
    }
  const std::string slabs = find(walk_of("concave-polygon", "slabs"), "verdict")->caption;
  CHECK_THAT(slabs, Contains("The part of the slab between") && Contains("Each comparison halves what is left"));
  CHECK_THAT(find(walk_of("concave-polygon", "trapezoids"), "verdict")->caption, Contains("The mean over all orders"));
}

TEST_CASE("that hulls need a sort is said of the worst case", "[words]") {
  for (const Exercise& e : lesson("convex-hull").closing->exercises)
    if (says(e.prompt, "than it sorts"))
      CHECK_THAT(e.prompt + " " + e.solution, Contains("every hull") && Contains("worst case"));
}

TEST_CASE("what a yes or no is worth on the boundary is told beside it, and only there", "[words]") {
  int on = 0;
  for (const char* id : {"crossings", "convex-polygon", "concave-polygon"})
    for (const Preset& p : lesson(id).presets) {
      const std::vector<Opinion> all = lesson(id).opinions(p.parameters);
      const bool boundary = all.front().says == "on the boundary";
      for (std::size_t i = 1; i < all.size(); ++i) {
        INFO(id << " " << p.id << ": " << all[i].method << ", " << all[i].says);
        CHECK(says(all[i].says, "the boundary belongs to the polygon") == boundary);
        if (boundary) CHECK(all[i].says.starts_with(all[i].agrees ? "inside, as" : "outside, though"));
        on += boundary;
      }
    }
  CHECK(on > 10);
}

TEST_CASE("with tolerance 0 no cube and no ball is spoken of as larger than a point", "[words]") {
  const Walk cube = with("points", "cube", {{"tolerance", "0"}});
  CHECK_THAT(find(cube, "coordinates")->caption, Contains("the cube is one point") && !Contains("√3"));
  const Walk chain = with("points", "chain", {{"tolerance", "0"}, {"p", "1,1,0"}, {"q", "1,1,0"}, {"r", "2,1,0"}});
  CHECK_THAT(find(chain, "p-q")->caption, Contains("equals") && Contains("near.") && !Contains("ball"));
  CHECK_THAT(find(chain, "q-r")->caption, Contains("does not equal") && Contains("far.") && !Contains("ball"));
  CHECK_THAT(find(walk_of("points", "chain"), "p-q")->caption, Contains("ball of tolerance"));
}

TEST_CASE("a segment that is one point is not said to have a line", "[words]") {
  const auto why = [](const Changes& changes) {
    const Walk walk = with("capsule-capsule", "side", changes);
    return find(walk, "crossing")->question->because;
  };
  CHECK_THAT(why({{"p_b", "1,1,0"}, {"q_b", "1,1,0"}}), Contains("one point has no line"));
  CHECK_THAT(why({}), !Contains("one point has no line") && Contains("orientations"));
}

TEST_CASE("the void that is told is the core's: what the object does not fill of the volume", "[words]") {
  for (const char* id : {"tilted", "upright", "bracket", "ball"}) {
    INFO(id);
    const Parameters& p = preset(lesson("bounding-volumes"), id).parameters;
    const auto mesh = lessons::bounding_volumes_lesson::object(text(p, "object"), std::get<Vec3>(p.at("tip")));
    const double object = volume(mesh.vertices, mesh.triangles);
    const Walk walk = lesson("bounding-volumes").walk(p);
    const Aabb<double, 3> box = fit_aabb(mesh.vertices);
    const double part = value(*find(walk, "aabb"), "empty share");
    CHECK(part == void_volume(box, object) / volume(box));
    CHECK(part == Approx(1 - object / value(*find(walk, "aabb"), "AABB")));

    const Step& sphere = *find(walk, "sphere");
    static const std::regex percent("of this sphere, ([0-9.]+) %");
    std::smatch told;
    const std::string caption = plain(sphere.caption);
    REQUIRE(std::regex_search(caption, told, percent));
    CHECK(std::stod(told[1]) == Approx(100 * value(sphere, "empty share")).margin(0.051));
    for (const char* other : {"slab", "side-by-side"})  // they are about no volume, or about all
      CHECK(std::ranges::none_of(find(walk, other)->values, [](const Value& v) { return v.name == "empty share"; }));
  }
}

}  // namespace claims_words_test
