// What lessons say about shapes that have shrunk to a point, a segment or nothing, about a tolerance or a speed of 0,
// and about what is not a number, must be as true and as good English as elsewhere.

#include <regex>

#include "tests/lessons/words.h"
#include "viz/text/rich_text.h"

namespace degenerate_words_test {
using namespace isect;
using namespace isect::viz;
using namespace isect::tests;
using isect::test::Contains;

namespace {

/// All that the walk says in its steps, as plain text, a line each.
std::string told(const Walk& walk) {
  std::string all = walk.alt + "\n";
  for (const Step& s : walk.steps) {
    for (const std::string& text : {s.title, s.caption, s.formula, s.verdict.text}) all += plain(text) + "\n";
    if (!s.question) continue;
    all += plain(s.question->prompt) + "\n" + plain(s.question->because) + "\n";
    for (const std::string& choice : s.question->choices) all += plain(choice) + "\n";
  }
  return all;
}

/// Points of the hull lesson, those that are not given at the first.
Changes points_at(const std::string& first, const std::string& last) {
  Changes changes = {{"p", last}};
  for (int i = 0; i < 8; ++i) changes.emplace_back("v" + std::to_string(i), first);
  return changes;
}

}  // namespace

TEST_CASE("the hull of points that are all equal is a point with one vertex", "[words]") {
  const std::string one = told(with("convex-hull", "scattered", points_at("1,1,0", "1,1,0")));
  CHECK_THAT(one, Contains("Equal points are kept once: 1 is left.") && Contains("Here it is a point, of area 0.") &&
                      Contains("a hull of 1 vertex\n") && Contains("9 points and their convex hull of 1 vertex.") &&
                      !Contains("segment, of area 0") && !Contains("1 vertices"));
  const std::string two = told(with("convex-hull", "scattered", points_at("1,1,0", "2,1.5,0")));
  CHECK_THAT(two, Contains("2 are left") && Contains("Here it is a segment, of area 0.") &&
                      Contains("a hull of 2 vertices\n"));
}

TEST_CASE("a volume that keeps no fewer numbers than the hull is not said to keep fewer", "[words]") {
  static const std::regex kept("is kept in ([0-9]+) numbers, the hull in ([0-9]+)");
  int seen = 0;
  const auto check = [&](const Walk& walk) {
    for (const Step& s : walk.steps)
      if (std::smatch m; std::regex_search(s.caption, m, kept) && s.caption.find("is void") != std::string::npos) {
        ++seen;
        INFO(s.caption);
        CHECK(says(s.caption, "fewer numbers") == (std::stoi(m[1]) < std::stoi(m[2])));
      }
  };
  for (const Preset& p : lesson("convex-hull").presets) check(lesson("convex-hull").walk(p.parameters));
  check(with("convex-hull", "scattered", points_at("1,1,0", "2,1.5,0")));
  CHECK(seen > 10);
}

TEST_CASE("of a 6-DOP it is asked what is true of it: it is the AABB again", "[words]") {
  for (const char* from : {"tilted", "upright"}) {
    const Walk walk = with("bounding-volumes", from, {{"k", "6"}});
    CHECK_THAT(told(walk), !Contains("14-DOP have") && Contains("How much void does the 6-DOP have"));
    CHECK(answer(*find(walk, "k-dops")) == "just as much");
    const Question& least = *find(walk, "side-by-side")->question;
    REQUIRE(least.order);
    const auto rank = [&](const std::string& name) {
      const auto found = std::ranges::find(least.order->tiles, name);
      REQUIRE(found != least.order->tiles.end());
      return least.order->ranks.at(static_cast<std::size_t>(found - least.order->tiles.begin()));
    };
    CHECK(rank("AABB") == rank("6-DOP"));
    CHECK(rank("AABB") < rank("sphere"));
    CHECK(value(*find(walk, "side-by-side"), "AABB") == value(*find(walk, "side-by-side"), "6-DOP"));
  }
}

TEST_CASE("what is left of a polygon is told alike by words and verdict, be it flat or a point", "[words]") {
  const Walk flat =
      with("clipping", "cut", {{"p", "0.5,0.5,0"}, {"q", "0.5,0.5,0"}, {"r", "0.5,0.5,0"}, {"s", "-3,0.5,0"}});
  CHECK(plain(ending(flat).verdict.text) == "a segment is kept");
  CHECK_THAT(flat.alt, Contains("They share a segment."));
  const Walk point =
      with("clipping", "cut", {{"p", "0.5,0.5,0"}, {"q", "0.5,0.5,0"}, {"r", "0.5,0.5,0"}, {"s", "0.5,0.5,0"}});
  CHECK(plain(ending(point).verdict.text) == "one point is kept");
  CHECK_THAT(point.alt, Contains("They share one point."));

  static const std::regex number("kept: ([0-9]+) vertices");
  on_random_settings("clipping", 100, [](const Parameters& p, const Walk& walk) {
    if (text(p, "shape") != "polygon") return;
    const std::string verdict = plain(ending(walk).verdict.text);
    std::smatch m;
    const std::string share = verdict == "nothing is kept"     ? "No part of it lies in the box."
                              : verdict == "one point is kept" ? "They share one point."
                              : verdict == "a segment is kept" ? "They share a segment."
                              : std::regex_match(verdict, m, number)
                                  ? "The part in the box has " + m[1].str() + " vertices."
                                  : "no such verdict";
    CHECK_THAT(walk.alt, Contains(share));
  });
}

TEST_CASE("a segment whose ends are equal is told as a point", "[words]") {
  const auto at = [](const std::string& p) { return with("clipping", "both-ends-cut", {{"p", p}, {"q", p}}); };
  const Walk corner = at("2,1.25,0"), inside = at("1,1,0"), outside = at("3,1,0");
  for (const Walk& walk : {corner, inside}) {
    CHECK(plain(ending(walk).verdict.text) == "the point is kept");
    CHECK_THAT(told(walk), Contains("They share one point.") &&
                               Contains("p and q are equal, so the segment is a point") && !Contains("t from 0 to 1") &&
                               !Contains("lies in a side") && !Contains("0 ≤ t ≤ 1,  "));
  }
  CHECK(ending(corner).verdict.kind == Verdict::Kind::on);
  CHECK(ending(inside).verdict.kind == Verdict::Kind::yes);
  CHECK_THAT(told(corner), Contains("It lies on the boundary"));
  CHECK(plain(ending(outside).verdict.text) == "nothing is kept");
}

TEST_CASE("with tolerance 0 near means equal, and nobody is told to drag what can't be dragged", "[words]") {
  const Walk chain = with("points", "chain", {{"tolerance", "0"}, {"p", "1,1,0"}, {"q", "1,1,0"}, {"r", "1,1,0"}});
  CHECK_THAT(told(chain), Contains("near means equal, and equality is transitive") && !Contains("Drag r") &&
                              !Contains("at most twice the tolerance"));
  const Walk same = with("points", "cube", {{"tolerance", "0"}, {"p", "1,1,0"}, {"q", "1,1,0"}});
  CHECK_THAT(told(same), Contains("q equals p, and with tolerance 0 near means equal") && !Contains("on the sphere"));
  const Walk tiny = with("points", "cube", {{"tolerance", "0"}, {"unit", "tiny"}});
  CHECK_THAT(told(tiny), Contains("The squared distance underflows to 0") && !Contains("Both squares underflow"));
}

TEST_CASE("what is not a number has no sign", "[words]") {
  const Walk walk = with("points", "cube", {{"z", "NaN"}});
  CHECK_THAT(told(walk), Contains("Here that is not a number and has no sign") && !Contains("without rounding"));
}

TEST_CASE("a box at rest is not told to fly", "[words]") {
  const std::vector<std::string> places = {"-1.75,-0.5,0", "0.5,0,0", "3,0,0", "0.5,2,0", "0.5,5,0"};
  for (const std::string& p : places) {
    INFO(p);
    const std::string words = told(with("collision", "tunnelling", {{"speed", "0"}, {"p", p}}));
    CHECK_THAT(words, Contains("A small box rests") && Contains("A box at rest") && !Contains("flight") &&
                          !Contains("moves along an axis") && !Contains("though not when") && !Contains("tunnelled"));
    CHECK_THAT(words, Contains("The box stays where it is"));
  }
}

TEST_CASE("the radius that is asked for is the box's own, without what the test adds", "[words]") {
  Changes aligned = {{"a_u", "1,0,0"}, {"a_v", "0,1,0"}, {"b_u", "1,0,0"}, {"b_v", "0,1,0"}, {"b", "0,3,0"}};
  aligned.emplace_back("b_half", "1,0,1");
  const Walk flat = with("obb-obb", "edges", aligned), plain_one = walk_of("obb-obb", "edges");
  const Step &of_flat = *find(flat, "normals-a"), &of_plain = *find(plain_one, "normals-a");
  CHECK(value(of_flat, "*r*_b") > 0);  // as the test computes it
  CHECK(answer(of_flat) == "0");
  CHECK_THAT(plain(of_flat.question->prompt), Contains("What is r_b, before ε is added?"));
  CHECK(answer(of_plain) == shown(value(of_plain, "*r*_b")));
  CHECK_THAT(plain(of_plain.question->prompt), Contains("What is r_b?"));
}

TEST_CASE("a flat box on another shape shares no point that is interior to both, and one that pierces it does",
          "[words]") {
  const auto boxes = [](const char* bottom) {
    return told(with("aabb-aabb", "overlapping",
                     {{"a_min", "0,0,0"}, {"a_max", "1,0,1"}, {"b_min", bottom}, {"b_max", "0.5,1,2"}}));
  };
  const auto tilted = [](const char* above) {
    return told(with("obb-obb", "edges",
                     {{"a", above},
                      {"a_half", "2,0,2"},
                      {"a_u", "1,0,0"},
                      {"a_v", "0,1,0"},
                      {"b", "0,0,0"},
                      {"b_half", "1,1,1"},
                      {"b_u", "1,0,0"},
                      {"b_v", "0,1,0"}}));
  };
  const auto ball = [](const char* center) {
    return told(with("sphere-aabb", lesson("sphere-aabb").presets.front().id,
                     {{"b_min", "-2,0,-2"}, {"b_max", "2,0,2"}, {"c", center}, {"r", "1"}}));
  };
  for (const std::string& words : {boxes("0.25,0,0.25"), tilted("0.5,1,0.5"), ball("0,1,0")})
    CHECK_THAT(words, Contains("none is interior to both") && !Contains("boundary points, but no interior"));
  for (const std::string& words : {boxes("0.25,-1,0.25"), tilted("0.5,0,0.5"), ball("0,0.5,0")})
    CHECK_THAT(words, Contains("overlap") && !Contains("none is interior to both"));
  CHECK_THAT(told(walk_of("aabb-aabb", "touching-face")),
             Contains("They share boundary points, but no interior point."));
}

TEST_CASE("a distance of 0 may not be less still", "[words]") {
  const Walk walk =
      with("capsule-capsule", lesson("capsule-capsule").presets.front().id,
           {{"p_a", "0,0,0"}, {"q_a", "2,0,0"}, {"r_a", "0"}, {"p_b", "1,0,0"}, {"q_b", "1,2,0"}, {"r_b", "0.5"}});
  const Step& last = *find(walk, "relation");
  REQUIRE(last.comparison);
  CHECK(last.comparison->left == 0);
  CHECK(last.comparison->meaning == "they share a point");
  on_random_settings("capsule-capsule", 200, [](const Parameters&, const Walk& w) {
    const Step* const relation = find(w, "relation");
    if (relation && relation->comparison && says(relation->comparison->meaning, "less still"))
      CHECK(relation->comparison->left > 0);
  });
}

TEST_CASE("a capsule that touches another from within is exactly R away, and the formula says so", "[words]") {
  const Walk point =
      with("capsule-capsule", lesson("capsule-capsule").presets.front().id,
           {{"p_a", "0,0,0"}, {"q_a", "0,0,0"}, {"r_a", "0"}, {"p_b", "1,0,0"}, {"q_b", "1,0,0"}, {"r_b", "1"}});
  REQUIRE(plain(ending(point).verdict.text) == "a lies inside b");
  CHECK(plain(find(point, "relation")->formula) == "d = 1 = R");
  on_random_settings("capsule-capsule", 200, [](const Parameters&, const Walk& w) {
    const Step* const relation = find(w, "relation");
    if (!relation || !relation->comparison) return;
    const double d = relation->comparison->left, r = relation->comparison->right;
    CHECK((!says(relation->formula, "<") || d <= r));
    CHECK((!says(relation->formula, "> ") || d >= r));
  });
}

TEST_CASE("what the note returns for balls that touch is told alike in both steps", "[words]") {
  const auto first = [](const Walk& walk) { return find(walk, "yes-or-no")->caption; };
  const Walk touching = with("relations", "ball-overlapping", {{"size", "0.5"}, {"b", "1.21875,0,0.9140625"}});
  REQUIRE(ending(touching).verdict.kind == Verdict::Kind::on);
  CHECK_THAT(first(touching), Contains("returns DISJOINT") && !Contains("OVERLAP"));
  CHECK_THAT(told(touching), Contains("but touching spheres as DISJOINT"));
  CHECK_THAT(first(walk_of("relations", "ball-overlapping")), Contains("stops here and returns OVERLAP"));
  CHECK_THAT(first(walk_of("relations", "aabb-touching")), Contains("stops here and returns OVERLAP"));
}

TEST_CASE("a ball of radius 0 is a point: nothing touches it in one", "[words]") {
  for (const char* method : {"haines", "quadratic", "half-b"})
    for (const char* origin : {"-2,0,0", "0,0,0", "2,0,0"}) {
      const Walk walk =
          with("ray-sphere", "tangent",
               {{"method", method}, {"radius", "0"}, {"center", "0,0,0"}, {"direction", "1,0,0"}, {"origin", origin}});
      const std::string words = told(walk);
      INFO(method << " " << origin);
      CHECK_THAT(words,
                 !Contains("touches the ball") && !Contains("touches a ball") && !Contains("touches the sphere"));
      CHECK_THAT(walk.alt, Contains("point"));
    }
}

}  // namespace degenerate_words_test
