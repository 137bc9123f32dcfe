// Traces: stable text, and differences in words.

#include "viz/snapshot/snapshot.h"

#include "tests/catch.h"
#include "tests/viz/toy_lesson.h"
#include "viz/compose/compose.h"
#include "viz/player/reader_state.h"

namespace snapshot_test {
using namespace isect::viz;
using isect::test::Contains;
using isect::test::toy;

namespace {

const Stamp stamp = {"llvmpipe", "STIXGeneral, DejaVu Sans", "screen", "960x600"};

Parameters at(double x, double radius = 1) {
  Parameters p = toy().presets[0].parameters;
  p["origin"] = Vec3(x, 0, 0);
  p["radius"] = radius;
  return p;
}

std::string trace(const Parameters& p, const Stamp& s = stamp) {
  return trace_json(toy(), "near", p, toy().walk(p), {}, s);
}

std::vector<std::string> told(const std::vector<Change>& changes) {
  std::vector<std::string> lines;
  for (const Change& c : changes)
    lines.push_back((c.step < 0 ? "" : "step " + std::to_string(c.step + 1) + ": ") + c.what);
  return lines;
}

std::vector<std::string> differences(const std::string& was, const std::string& is) {
  return told(compare_traces(was, is));
}

using Lines = std::vector<std::string>;

}  // namespace

TEST_CASE("the same walk gives the same trace", "[snapshot]") {
  CHECK(trace(at(0.5)) == trace(at(0.5)));
  CHECK(compare_traces(trace(at(0.5)), trace(at(0.5))).empty());
}

TEST_CASE("a relation that turns is told as a relation", "[snapshot]") {
  const Lines lines = differences(trace(at(0.5)), trace(at(1)));
  CHECK(lines == Lines{"parameter origin was [0.5,0.0,0.0], is [1.0,0.0,0.0]", "step 1: d² was 0.25, is 1",
                       "step 2: d² < r² became = r²", "step 2: d² was 0.25, is 1", "step 3: d² was 0.25, is 1"});
}

TEST_CASE("another branch is told as verdict and step", "[snapshot]") {
  const Lines lines = differences(trace(at(0.5)), trace(at(2)));
  CHECK_THAT(lines, Catch::Matchers::VectorContains(std::string("step 2: d² < r² became > r²")));
  CHECK_THAT(lines,
             Catch::Matchers::VectorContains(std::string("step 2: the comparison of d² with r² was true, is false")));
  CHECK_THAT(lines, Catch::Matchers::VectorContains(std::string("step 3: inside became outside")));
}

TEST_CASE("a radius larger by a thousandth is seen in the first step", "[snapshot]") {
  const std::vector<Change> changes = compare_traces(trace(at(0.5)), trace(at(0.5, 1.001)));
  REQUIRE(changes.size() > 2);
  CHECK(changes[0].step == -1);
  CHECK(changes[0].what == "parameter radius was 1.0, is 1.001");
  CHECK(changes[1].step == 0);
  CHECK(changes[1].what == "r² was 1, is 1.002001");
}

TEST_CASE("values count to nine significant digits", "[snapshot]") {
  const auto steps_only = [](const std::string& text) { return text.substr(text.find("\"steps\"")); };
  CHECK(steps_only(trace(at(0.5))) == steps_only(trace(at(0.5, 1 + 1e-12))));
  CHECK_FALSE(steps_only(trace(at(0.5))) == steps_only(trace(at(0.5, 1 + 1e-8))));
}

TEST_CASE("another renderer or font is told first", "[snapshot]") {
  Stamp other = stamp;
  other.renderer = "softpipe";
  CHECK(differences(trace(at(0.5), other), trace(at(1)))[0] == "renderer was softpipe, is llvmpipe");
  other = stamp;
  other.font = "Latin Modern";
  CHECK_THAT(differences(trace(at(0.5), other), trace(at(0.5)))[0], Contains("font was Latin Modern"));
}

TEST_CASE("verdicts, lines, counts, questions and pseudocode are compared", "[snapshot]") {
  const Parameters p = at(0.5);
  const auto changed = [&](const auto& change) {
    Walk walk = toy().walk(p);
    change(walk);
    return differences(trace(p), trace_json(toy(), "near", p, walk, {}, stamp));
  };
  CHECK(changed([](Walk& w) { w.steps[2].verdict.text = "deep inside"; }) ==
        Lines{"step 3: verdict was yes: inside, is yes: deep inside"});
  CHECK(changed([](Walk& w) { w.steps[2].line = 3; }) == Lines{"step 3: pseudocode line was 3, is 4"});
  CHECK(changed([](Walk& w) { w.steps[1].counters.mul = 5; }) == Lines{"step 2: count of mul was 4, is 5"});
  CHECK(changed([](Walk& w) { w.steps[1].comparison.reset(); }) == Lines{"step 2: compares nothing any more"});
  CHECK(changed([](Walk& w) { w.pseudocode[3] = "return NO"; }) ==
        Lines{"pseudocode line 4 was return OUTSIDE, is return NO"});
  CHECK(changed([](Walk& w) { w.steps.pop_back(); }) == Lines{"3 steps became 2"});
  CHECK(changed([](Walk& w) { w.steps[0].values.pop_back(); }) == Lines{"step 1: r² was 1, is absent"});
  CHECK(changed([](Walk& w) {
          w.steps[0].question = Question{"Where?", {"inside", "outside"}, 1, ""};
        }) == Lines{"step 1: asks “Where?” now"});
}

TEST_CASE("each thing that a step says is compared and told in words", "[snapshot]") {
  const Parameters p = at(0.5);
  Walk walk = toy().walk(p);
  walk.alt = "A ray that hits a ball.";
  walk.method = "quick";
  Step& step = walk.steps[1];
  step.caption = "The line meets the ball twice.\nSo the ray *hits* it.";
  step.formula = "*d*^2 ≤ *r*^2";
  step.source = "N19";
  step.untaken = {3};
  step.refused = {1};
  step.question = Question{"How many *roots*?", {"one", "two"}, 1, "The sign is positive."};
  step.values[0].unit = "length²";
  const std::string before = trace_json(toy(), "near", p, walk, {}, stamp);
  const auto changed = [&](const auto& change) {
    Walk other = walk;
    change(other, other.steps[1]);
    return differences(before, trace_json(toy(), "near", p, other, {}, stamp));
  };
  CHECK(changed([](Walk&, Step&) {}).empty());
  CHECK(changed([](Walk&, Step& s) { s.title = "Compare"; }) == Lines{"step 2: title was Comparison, is Compare"});
  CHECK(changed([](Walk&, Step& s) { s.caption.replace(s.caption.find("*hits*"), 6, "*misses*"); }) ==
        Lines{"step 2: caption was … the ray hits it., is … the ray misses it."});
  CHECK(changed([](Walk&, Step& s) { s.caption.replace(s.caption.find("*hits*"), 6, "hits"); }).size() == 1);
  CHECK(changed([](Walk&, Step& s) { s.formula = "*d*^2 < *r*^2"; }) ==
        Lines{"step 2: formula was d² ≤ r², is d² < r²"});
  CHECK(changed([](Walk&, Step& s) { s.source = "N91"; }) == Lines{"step 2: source was N19, is N91"});
  CHECK(changed([](Walk&, Step& s) { s.untaken.clear(); }) == Lines{"step 2: untaken lines was [4], is absent"});
  CHECK(changed([](Walk&, Step& s) { s.refused = {2}; }) == Lines{"step 2: refused lines was [2], is [3]"});
  CHECK(changed([](Walk&, Step& s) { s.decides = true; }) == Lines{"step 2: decides was false, is true"});
  CHECK(changed([](Walk&, Step& s) { s.comparison->meaning = "outside"; }) ==
        Lines{"step 2: meaning of the comparison was the origin is inside, is outside"});
  CHECK(changed([](Walk&, Step& s) { s.values[0].unit = "length"; }) ==
        Lines{"step 2: unit of d² was length², is length"});
  CHECK(changed([](Walk&, Step& s) { s.values[0].role = Role::hit; }) == Lines{"step 2: role of d² was first, is hit"});
  CHECK(changed([](Walk&, Step& s) { s.values[1].fresh = false; }) == Lines{"step 2: light of r² was fresh, is none"});
  CHECK(changed([](Walk&, Step& s) { std::swap(s.values[0], s.values[1]); }).size() == 1);
  CHECK(changed([](Walk&, Step& s) { s.question->prompt = "How many?"; }) ==
        Lines{"step 2: question was How many roots?, is How many?"});
  CHECK(changed([](Walk&, Step& s) { std::swap(s.question->choices[0], s.question->choices[1]); }) ==
        Lines{"step 2: answer was two, is one", R"(step 2: choices was ["one","two"], is ["two","one"])"});
  CHECK(changed([](Walk&, Step& s) { s.question->answer = 0; }) == Lines{"step 2: answer was two, is one"});
  CHECK(changed([](Walk&, Step& s) { s.question->because = "The sign is negative."; }) ==
        Lines{"step 2: reason of the answer was … sign is positive., is … sign is negative."});
  CHECK(changed([](Walk& w, Step&) { w.alt = "A ray that misses a ball."; }) ==
        Lines{"alt text was … ray that hits a ball., is … ray that misses a ball."});
  CHECK(changed([](Walk& w, Step&) { w.method = "exact"; }) == Lines{"method was quick, is exact"});
}

TEST_CASE("opinions of other methods are kept and compared", "[snapshot]") {
  Lesson with = toy();
  with.opinions = [](const Parameters& p) {
    const bool near = std::get<Vec3>(p.at("origin")).x() < 1;
    return std::vector<Opinion>{{"exact", "inside", true}, {"quick", near ? "inside" : "outside", near}};
  };
  const Parameters near = at(0.5);
  const auto told_by = [&](const Lesson& lesson) {
    return trace_json(lesson, "near", near, toy().walk(near), {}, stamp);
  };
  Lesson other = with;
  other.opinions = [](const Parameters&) {
    return std::vector<Opinion>{{"exact", "inside", true}, {"quick", "outside", false}};
  };
  CHECK(differences(told_by(with), told_by(other)) ==
        Lines{"opinion of the quick was inside, is outside", "opinion of the quick agrees: was true, is false"});
  CHECK(differences(told_by(toy()), told_by(with)) == Lines{"other methods are asked side by side"});
}

TEST_CASE("a trace of an earlier format is one difference that says what to do", "[snapshot]") {
  std::string earlier = trace(at(2));
  earlier.replace(earlier.find("\"format\": 3"), 11, "\"format\": 2");
  const Lines lines = differences(earlier, trace(at(0.5)));
  REQUIRE(lines.size() == 1);
  CHECK_THAT(lines[0], Contains("format 2") && Contains("format 3") && Contains("accept it anew"));
}

namespace {

const View straight({}, 640, 400);

/// Three objects: a ball with its name and a line with its own, drawn as in a figure.
Scene ball_and_line() {
  Scene scene;
  scene.items = {Ball{{0, 0, 0}, 1, Role::second}, Line{{-1.5, -1.5, 0}, {1.5, -1.5, 0}, Role::first},
                 Label{{0, 0, 0}, "*b*"}, Label{{-1.5, -1.5, 0}, "*t*", Role::text, Vec3(1.5, -1.5, 0)}};
  return scene;
}

Drawing drawn(const Scene& scene, const View& view = straight) {
  const Theme style = theme(ThemeName::print, 640, 400);
  Composed composed = compose(scene, view, style);
  return {640, 400, style.background, std::move(composed.shapes), std::move(composed.objects)};
}

/// The reported changes of the drawings of three steps if the second one is another.
Lines told_of(const Drawing& was, const Drawing& is) {
  const Parameters p = at(0.5);
  const auto with = [&](const Drawing& second) {
    return trace_json(toy(), "near", p, toy().walk(p), {was, second, was}, stamp);
  };
  Lines lines;
  for (const Change& c : compare_traces(with(was), with(is))) {
    CHECK(c.of == Change::Of::drawing);
    CHECK(c.step == 1);
    lines.push_back(c.what);
  }
  return lines;
}

Lines told_of(const Scene& changed) { return told_of(drawn(ball_and_line()), drawn(changed)); }

template <class S>
S& of_object(Drawing& d, const std::string& name) {
  for (Shape& shape : d.shapes)
    if (std::holds_alternative<S>(shape) && full_name(d.objects.at(static_cast<std::size_t>(object_of(shape)))) == name)
      return std::get<S>(shape);
  throw std::runtime_error("nothing drawn of " + name);
}

}  // namespace

TEST_CASE("an object that is gone, new or moved is told by its name", "[snapshot]") {
  Scene scene = ball_and_line();
  scene.items.pop_back();
  CHECK(told_of(scene)[0] == "the line t and the label t are gone");  // the line's name was its label's
  scene = ball_and_line();
  scene.items.push_back(Dot{{1, 1, 0}, Mark::disc, Role::hit});
  CHECK(told_of(scene) == Lines{"the point (hit) is new"});
  Drawing drawing = drawn(ball_and_line());
  of_object<Text>(drawing, "label b").at += Vec2(0.3, 0.4);
  CHECK(told_of(drawn(ball_and_line()), drawing) == Lines{"the label b moved 0.5 px"});
}

TEST_CASE("drawings in which the same happened have one cause, however far and in whatever order", "[snapshot]") {
  const auto causes = [](const Drawing& is) {
    const Parameters p = at(0.5);
    const Drawing was = drawn(ball_and_line());
    std::vector<std::string> found;
    for (const Change& c : compare_traces(trace_json(toy(), "near", p, toy().walk(p), {was}, stamp),
                                          trace_json(toy(), "near", p, toy().walk(p), {is}, stamp)))
      if (c.step == 0) found.push_back(c.cause);
    return found;
  };
  const auto labels_moved = [&](double b, double t) {
    Drawing is = drawn(ball_and_line());
    of_object<Text>(is, "label b").at.x() += b;
    of_object<Text>(is, "label t").at.x() += t;
    return causes(is);
  };
  CHECK(labels_moved(3, 0) == Lines{"the label b moved"});
  CHECK(labels_moved(7.5, 0) == labels_moved(3, 0));
  CHECK(labels_moved(1, 2) == Lines{"the label b and the label t moved"});
  CHECK(labels_moved(9, 2) == labels_moved(1, 2));  // told the other way round
  const auto larger = [&](double times) {
    Scene scene = ball_and_line();
    std::get<Ball>(scene.items[0]).radius *= times;
    return causes(drawn(scene));
  };
  CHECK(larger(1.001) == Lines{"the ball b is larger"});
  CHECK(larger(1.002) == larger(1.001));
  CHECK(larger(0.999) == Lines{"the ball b is smaller"});
  Drawing other = drawn(ball_and_line());
  of_object<Text>(other, "label b").markup = "*c*";
  CHECK(causes(other) == Lines{"the text of the label b changed"});

  // The values of settings belong to the cause, what is computed from them does not.
  const std::vector<Change> moved = compare_traces(trace(at(0.5)), trace(at(1)));
  REQUIRE_FALSE(moved.empty());
  CHECK(moved[0].cause == moved[0].what);
  const auto computed = std::ranges::find(moved, Change::Of::course, &Change::of);
  REQUIRE(computed != moved.end());
  CHECK_THAT(computed->what, Contains(" was ") || Contains(" became "));
  CHECK_THAT(computed->cause, !Contains(" was "));
}

TEST_CASE("a ball larger by a thousandth is told as larger", "[snapshot]") {
  Scene scene = ball_and_line();
  std::get<Ball>(scene.items[0]).radius *= 1.001;
  CHECK(told_of(scene) == Lines{"the ball b is 1.001 times as large"});
}

TEST_CASE("a camera turned by 0.002 rad or widened by a thousandth is seen by the drawing's numbers alone",
          "[snapshot]") {
  Camera camera;
  CHECK_FALSE(told_of(drawn(ball_and_line()), drawn(ball_and_line(), View({}, 640, 400))).size() > 0);
  for (double Camera::*member : {&Camera::azimuth, &Camera::elevation}) {
    Camera turned;
    turned.*member += 0.002;
    CHECK_FALSE(told_of(drawn(ball_and_line()), drawn(ball_and_line(), View(turned, 640, 400))).empty());
  }
  Camera near, nearer;
  near.perspective = nearer.perspective = true;
  nearer.field_of_view *= 1.005;
  CHECK_FALSE(
      told_of(drawn(ball_and_line(), View(near, 640, 400)), drawn(ball_and_line(), View(nearer, 640, 400))).empty());
}

TEST_CASE("pen, dash, colour, text and order of an object are told", "[snapshot]") {
  const Drawing was = drawn(ball_and_line());
  const auto changed = [&](const auto& change) {
    Drawing is = was;
    change(is);
    return told_of(was, is);
  };
  using D = Drawing;
  CHECK_THAT(changed([](D& d) { of_object<Stroke>(d, "line t").width += 0.1; })[0],
             Contains("the width of the line t was ") && Contains(" px, is "));
  CHECK(changed([](D& d) { of_object<Stroke>(d, "line t").dash = {4, 3}; })[0] == "the line t is dashed now");
  CHECK_THAT(changed([](D& d) { of_object<Stroke>(d, "line t").colour.g += 1 / 255.0; })[0],
             Contains("the colour of the line t was #") && Contains(", is #"));
  CHECK(changed([](D& d) { of_object<Text>(d, "label b").markup = "**b**"; })[0] ==
        "the markup of the label b was \"*b*\", is \"**b**\"");
  CHECK(changed([](D& d) { of_object<Text>(d, "label b").markup = "*c*"; })[0] ==
        "the text of the label b was “b”, is “c”");
  CHECK_THAT(changed([](D& d) { of_object<Text>(d, "label b").size += 0.1; })[0],
             Contains("the size of the label b was"));
  CHECK_THAT(changed([](D& d) { d.objects[0].role = Role::hit; })[0],
             Contains("the role of the ball b was second, is hit"));
  CHECK_THAT(changed([](D& d) {
               d.background = Colour{0, 0, 0, 1};
             })[0],
             Contains("the colour of the page was") && Contains(", is #000000"));
  CHECK(changed([](D& d) {
          std::swap(of_object<Text>(d, "label b").at.x(), of_object<Text>(d, "label b").at.y());
        }).size() == 1);
  CHECK_FALSE(changed([](D& d) { std::ranges::reverse(d.shapes); }).empty());
}

TEST_CASE("one tint of a hundred that is a level off is told of what is shaded", "[snapshot]") {
  Scene scene;
  Raster cells = {{-1, 1, 0}, {2, 0, 0}, {0, -2, 0}, 17, {}, true};
  for (const Role role : {Role::first, Role::second, Role::hit, Role::miss, Role::text, Role::muted})
    for (int light = 0; light <= 16; ++light) cells.cells.push_back({role, light / 16.0});
  scene.items = {cells};
  const Drawing was = drawn(scene);
  for (std::size_t i = 0; i < was.shapes.size(); ++i) {
    Drawing is = was;
    Fill* fill = std::get_if<Fill>(&is.shapes[i]);
    if (fill == nullptr) continue;
    fill->colour.r += 1 / 255.0;
    INFO("fill " << i);
    const Lines lines = told_of(was, is);
    REQUIRE(lines.size() == 1);
    CHECK_THAT(lines[0], Contains("the mean colour of the raster (text) was rgb("));
  }
}

TEST_CASE("numbers that differ by less than an eye sees are no difference", "[snapshot]") {
  const Drawing was = drawn(ball_and_line());
  for (const double by : {1e-12, 1e-3, 0.01}) {
    Drawing is = was;
    for (Shape& shape : is.shapes)
      if (Text* text = std::get_if<Text>(&shape)) text->at += Vec2(by, -by);
    INFO(by);
    CHECK(told_of(was, is).empty());
  }
  for (int i = 0; i < 400; ++i) {  // on and beside every edge between two roundings
    Drawing is = was, next = was;
    of_object<Text>(is, "label b").at.x() += i / 2000.0 - 1e-9;
    of_object<Text>(next, "label b").at.x() += i / 2000.0 + 1e-9;
    CHECK(told_of(is, next).empty());
  }
}

TEST_CASE("a damaged trace is a difference, not a crash", "[snapshot]") {
  const std::string now = trace(at(0.5)), deep = std::string(300'000, '[') + std::string(300'000, ']');
  for (const std::string& part :
       {R"("format": )" + deep + R"(, "steps": [])", R"("format": 3, "steps": [)" + deep + "]",
        R"("format": 3, "steps": [], "made with": {"font": )" + deep + "}"})
    CHECK(compare_traces("{" + part + "}", now).size() == 1);
  for (const std::string was :
       {"", "{", "[]", "7", "{}", R"({"steps": 3})", R"({"steps": [1, {}, null]})",
        R"({"format": 3, "steps": [1, {"values": [[]], "comparison": 3, "question": 1, "drawing": 2}, null]})",
        R"({"format": 3, "steps": [{"drawing": {"order": [1, []], "objects": {"a": 1, "b": {"parts": [1, {}]}}}}]})",
        R"({"format": 3, "steps": [], "made with": 1, "parameters": [], "pseudocode": {}, "opinions": 1})"}) {
    INFO(was);
    CHECK_FALSE(compare_traces(was, now).empty());
  }
  for (std::size_t cut = 0; cut < now.size(); cut += 97) CHECK_FALSE(compare_traces(now.substr(0, cut), now).empty());
}

TEST_CASE("a picture of one colour is blank", "[snapshot]") {
  Picture picture{3, 2, std::vector<std::uint8_t>(24, 200)};
  CHECK(blank(picture));
  picture.rgba[23] = 199;
  CHECK_FALSE(blank(picture));
  CHECK(blank({}));
}

TEST_CASE("files are named by number and slug", "[snapshot]") {
  CHECK(file_stem(2, toy().walk(at(0)).steps[2]) == "03-inside");
}

}  // namespace snapshot_test
