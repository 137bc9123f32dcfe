// The lessons of relations, bounding volumes and hierarchies: what they show against computations of their own.

#include <algorithm>

#include "core/convex_polygons.h"
#include "core/obb_obb.h"
#include "core/sphere_sphere.h"
#include "lessons/lessons.h"
#include "lessons/relation.h"
#include "lessons/relations/pair.h"
#include "tests/catch.h"
#include "viz/place.h"

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
        CHECK(relations::name(pair.truth) == s.title);
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
    const auto it =
        std::ranges::find_if(all, [&](const relations::Situation& s) { return s.relation == relation; });
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
    bool named = false;
    for (const relations::Kind kind : relations::kinds)
      for (const relations::Situation& s : relations::situations(kind))
        named =
            named || (p.title == relations::name(kind) + ": " + s.title &&
                      walk.steps.back().verdict.text == lessons::words(s.relation, relations::they(kind)));
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
  for (const Item& item : all.steps.front().scene.items)
    if (const auto* heading = std::get_if<viz::Heading>(&item))
      if (!heading->bold) notes.push_back(heading->text);
  REQUIRE(notes.size() == 4);
  CHECK(notes[0] == "they touch");
  CHECK(notes[1] == "they overlap");
}
