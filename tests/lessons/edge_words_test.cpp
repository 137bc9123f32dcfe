// What lessons say of points on a boundary, of flat boxes and of segments: each against what counting, points or the
// core find there.

#include <algorithm>
#include <cmath>
#include <set>

#include <isect/methods/point_polygon.h>
#include <isect/orient.h>
#include "lessons/capsule_capsule/picture.h"
#include "lessons/crossings/picture.h"
#include "lessons/glossary.h"
#include "tests/lessons/words.h"
#include "viz/text/rich_text.h"

namespace edge_words_test {
using namespace isect;
using namespace isect::viz;
using namespace isect::tests;
using isect::test::Contains;

namespace {

namespace counting = lessons::crossings_lesson;

/// Whether a point near this one lies inside by the even-odd rule: right of it, and far less above it.
bool inside_beside(const counting::Setup& s) {
  const Point<double, 2> beside = s.p + Vec2(0x1p-20, 0x1p-40);
  return winding(beside, s.polygon).even_odd == Location::in;
}

/// How many edges at a vertex of the height of a point left of it count as crossed on the right.
int counted_at(const Ring<double, 2>& ring, std::size_t i) {
  const std::size_t n = ring.size();
  const auto above = [&](std::size_t k) { return ring[k % n].y() > ring[i].y(); };
  return (above(i) != above(i + 1) ? 1 : 0) + (above(i + n - 1) != above(i) ? 1 : 0);
}

int drawn_as_hit(const Step& step) {
  return static_cast<int>(std::ranges::count_if(step.scene.items, [](const Item& item) {
    if (const auto* line = std::get_if<Line>(&item)) return line->role == Role::hit;
    if (const auto* dot = std::get_if<Dot>(&item)) return dot->role == Role::hit;
    const auto* region = std::get_if<Region>(&item);
    return region && region->role == Role::hit;
  }));
}

}  // namespace

TEST_CASE("counting says of a point on the boundary what it says of the place beside it, and the step tells which",
          "[words]") {
  int in = 0, out = 0;
  const auto check = [&](const Parameters& p, const Walk& walk) {
    if (text(p, "rule") != "half-open") return;
    const Step* const on = find(walk, "on");
    const counting::Setup s(p);
    CHECK((on != nullptr) == (s.truth.even_odd == Location::on));
    if (!on) return;
    INFO(on->caption);
    const bool inside = inside_beside(s);
    CHECK(says(on->caption, "Counting alone would say IN, ") == inside);
    CHECK(says(on->caption, "Counting alone would say OUT, ") == !inside);
    ++(inside ? in : out);
  };
  for (const Preset& p : lesson("crossings").presets) check(p.parameters, lesson("crossings").walk(p.parameters));
  for (const auto& situation : counting::situations())  // on each vertex, and in the middle of each edge
    for (const Ring<double, 2>& ring : situation.polygon.rings)
      for (std::size_t i = 0; i < ring.size(); ++i)
        for (const Vec2& at : {Vec2(ring[i]), Vec2((ring[i] + ring[(i + 1) % ring.size()]) / 2)}) {
          const Parameters p = {{"rule", std::string("half-open")},
                                {"polygon", std::string(situation.id)},
                                {"p", Vec3(at.x(), at.y(), 0)}};
          check(p, lesson("crossings").walk(p));
        }
  CHECK((in > 20 && out > 20));
}

TEST_CASE("an edge along the ray counts by no rule", "[words]") {
  for (const char* id : {"edge-along-z", "edge-along-u", "edge-along-z-closed", "edge-along-u-closed"}) {
    INFO(id);
    int along = 0;
    for (const Step& s : walk_of("crossings", id).steps)
      if (says(s.title, "along the ray")) {
        ++along;
        CHECK_FALSE(s.decides);
        CHECK((says(s.caption, "never counts") || says(s.caption, "so the edge does not count")));
      }
    CHECK(along == 1);
  }
}

TEST_CASE("by the half-open rule a vertex counts once where the outline passes it, else twice or not at all",
          "[words]") {
  const auto term = std::ranges::find(lessons::glossary(), std::string("half-open rule"), &lessons::Term::name);
  REQUIRE(term != lessons::glossary().end());
  CHECK_THAT(term->meaning, Contains("once where the outline passes it") && Contains("twice or not at all"));
  std::set<int> seen;
  for (const auto& situation : counting::situations())
    for (const Ring<double, 2>& ring : situation.polygon.rings)
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const std::size_t n = ring.size();
        const double y = ring[i].y(), before = ring[(i + n - 1) % n].y(), after = ring[(i + 1) % n].y();
        if (before == y || after == y) continue;  // along the ray
        const int counted = counted_at(ring, i);
        CHECK((counted == 1) == ((before < y) != (after < y)));
        seen.insert(counted);
      }
  CHECK(seen == std::set<int>{0, 1, 2});
}

TEST_CASE("why boxes overlap is true of flat ones that pierce, too", "[words]") {
  const Walk flat = with("aabb-aabb", "overlapping",
                         {{"a_min", "0,0,0"}, {"a_max", "1,0,1"}, {"b_min", "0.25,-1,0.25"}, {"b_max", "0.5,1,0.5"}});
  const Step& relation = *find(flat, "relation");
  CHECK(answer(relation) == "overlapping");
  CHECK_THAT(relation.question->because, Contains("a point is interior to both") && !Contains("share a length"));
  const Walk tilted = with("obb-obb", "edges",
                           {{"a", "0.5,0,0.5"},
                            {"a_half", "2,0,2"},
                            {"a_u", "1,0,0"},
                            {"a_v", "0,1,0"},
                            {"b", "0,0,0"},
                            {"b_half", "1,1,1"},
                            {"b_u", "1,0,0"},
                            {"b_v", "0,1,0"}});
  const std::string& because = find(tilted, "relation")->question->because;
  CHECK_THAT(because, Contains("a point is interior to both") && !Contains("more than a number"));

  on_random_settings("aabb-aabb", 300, [](const Parameters& p, const Walk& walk) {
    const Step* const last = find(walk, "relation");
    if (!last->question || !says(last->question->because, "On every axis they share a length")) return;
    const auto at = [&](const char* name) { return std::get<Vec3>(p.at(name)); };
    const Vec3 lo = at("a_min").cwiseMax(at("b_min")), hi = at("a_max").cwiseMin(at("b_max"));
    CHECK((lo.array() < hi.array()).all());
  });
}

TEST_CASE("what a segment shares with a capsule is marked, and lies in both", "[words]") {
  const std::string first = lesson("capsule-capsule").presets.front().id;
  const Walk through =
      with("capsule-capsule", first,
           {{"p_a", "0,0,0"}, {"q_a", "2,0,0"}, {"r_a", "0"}, {"p_b", "1,0,0"}, {"q_b", "1,2,0"}, {"r_b", "0.5"}});
  const Step& last = *find(through, "relation");
  CHECK(plain(last.verdict.text) == "the capsules overlap");
  CHECK_THAT(last.caption, Contains("What they share is marked."));
  const auto marked = std::ranges::find_if(last.scene.items, [](const Item& item) {
    const auto* line = std::get_if<Line>(&item);
    return line && line->role == Role::hit;
  });
  REQUIRE(marked != last.scene.items.end());
  const Line& line = std::get<Line>(*marked);
  CHECK(std::min(line.from.x(), line.to.x()) == Approx(0.5).margin(1e-3));
  CHECK(std::max(line.from.x(), line.to.x()) == Approx(1.5).margin(1e-3));

  const Walk along =
      with("capsule-capsule", first,
           {{"p_a", "0,0,0"}, {"q_a", "2,0,0"}, {"r_a", "0"}, {"p_b", "1,0,0"}, {"q_b", "3,0,0"}, {"r_b", "0"}});
  CHECK(drawn_as_hit(*find(along, "relation")) > 0);

  int thin = 0;
  on_random_settings("capsule-capsule", 200, [&](Parameters p, const Walk&) {
    p["r_a"] = 0.0;
    const Walk walk = lesson("capsule-capsule").walk(p);
    const Step& end = *find(walk, "relation");
    if (plain(end.verdict.text) != "the capsules overlap") return;
    ++thin;
    INFO(end.caption);
    CHECK(drawn_as_hit(end) > 0);
  });
  CHECK(thin > 0);
}

}  // namespace edge_words_test
