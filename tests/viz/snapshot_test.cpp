// Traces: stable text, and differences in words.

#include "viz/snapshot.h"

#include "tests/catch.h"
#include "tests/viz/toy_lesson.h"
#include "viz/place.h"

namespace snapshot_test {
using namespace isect::viz;
using Catch::Matchers::Contains;
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
  return trace_json(toy(), "near", p, toy().walk(p), s);
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
  CHECK(lines == Lines{"step 1: d² was 0.25, is 1", "step 2: d² < r² became = r²",
                       "step 2: d² was 0.25, is 1", "step 3: d² was 0.25, is 1",
                       "parameter origin was [0.5,0.0,0.0], is [1.0,0.0,0.0]"});
}

TEST_CASE("another branch is told as verdict and step", "[snapshot]") {
  const Lines lines = differences(trace(at(0.5)), trace(at(2)));
  CHECK_THAT(lines, Catch::Matchers::VectorContains(std::string("step 2: d² < r² became > r²")));
  CHECK_THAT(lines, Catch::Matchers::VectorContains(
                        std::string("step 2: the comparison of d² with r² was true, is false")));
  CHECK_THAT(lines, Catch::Matchers::VectorContains(std::string("step 3: inside became outside")));
}

TEST_CASE("a radius larger by a thousandth is seen in the first step", "[snapshot]") {
  const std::vector<Change> changes = compare_traces(trace(at(0.5)), trace(at(0.5, 1.001)));
  REQUIRE_FALSE(changes.empty());
  CHECK(changes[0].step == 0);
  CHECK(changes[0].what == "r² was 1, is 1.002001");
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
    return differences(trace(p), trace_json(toy(), "near", p, walk, stamp));
  };
  CHECK(changed([](Walk& w) { w.steps[2].verdict.text = "deep inside"; }) ==
        Lines{"step 3: verdict was yes: inside, is yes: deep inside"});
  CHECK(changed([](Walk& w) { w.steps[2].line = 3; }) == Lines{"step 3: pseudocode line was 3, is 4"});
  CHECK(changed([](Walk& w) { w.steps[1].counters.mul = 5; }) == Lines{"step 2: count of mul was 4, is 5"});
  CHECK(changed([](Walk& w) { w.steps[1].comparison.reset(); }) ==
        Lines{"step 2: compares nothing any more"});
  CHECK(changed([](Walk& w) { w.pseudocode[3] = "return NO"; }) ==
        Lines{"pseudocode line 4 was return OUTSIDE, is return NO"});
  CHECK(changed([](Walk& w) { w.steps.pop_back(); }) == Lines{"3 steps became 2"});
  CHECK(changed([](Walk& w) { w.steps[0].values.pop_back(); }) == Lines{"step 1: r² was 1, is absent"});
  CHECK(changed([](Walk& w) {
          w.steps[0].question = Question{"Where?", {"inside", "outside"}, 1, ""};
        }) == Lines{"step 1: answer was absent, is outside"});
}

TEST_CASE("a damaged trace is a difference, not a crash", "[snapshot]") {
  const std::string now = trace(at(0.5));
  for (const std::string was :
       {"", "{", "[]", "7", "{}", R"({"steps": 3})", R"({"steps": [1, {}, null]})",
        R"({"format": 1, "steps": [1, {"values": [[]], "comparison": 3}, null]})",
        R"({"format": 1, "steps": [], "made with": 1, "parameters": [], "pseudocode": {}})"}) {
    INFO(was);
    CHECK_FALSE(compare_traces(was, now).empty());
  }
  for (std::size_t cut = 0; cut < now.size(); cut += 97)
    CHECK_FALSE(compare_traces(now.substr(0, cut), now).empty());
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
