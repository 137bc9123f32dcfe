// What the program tells as text: list, explain, doctor, and the places show refuses.

#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/app/shell.h"
#include "tests/catch.h"

namespace tell_test {
using namespace isect::test;

namespace {

/// The number of characters in the longest line.
std::size_t widest(const std::string& text) {
  std::size_t most = 0;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    most = std::max(most,
                    static_cast<std::size_t>(std::ranges::count_if(line, [](char c) { return (c & 0xC0) != 0x80; })));
  return most;
}

/// The words of the text with one space between them, wherever its lines break.
std::string in_one_line(const std::string& text) {
  std::istringstream words(text);
  std::string line;
  for (std::string word; words >> word;) line += (line.empty() ? "" : " ") + word;
  return line;
}

}  // namespace

TEST_CASE("list names lessons in the order of the course, and presets", "[list]") {
  const Shell shell;
  const Ran r = shell("isect list");
  CHECK(r.status == 0);
  CHECK_THAT(r.out, Contains("ray-sphere") && Contains("33 presets") && Contains("surface-out-half-b") &&
                        Contains("after: relations, intervals"));
  CHECK_THAT(r.out, !Contains("N16"));  // row ids are for those who write lessons
  CHECK(r.out.find("sphere-sphere  ") < r.out.find("ray-sphere  "));
  CHECK(widest(r.out) <= 80);
}

TEST_CASE("list --json holds what a program needs", "[list]") {
  const Shell shell;
  const nlohmann::json all = nlohmann::json::parse(shell("isect list --json").out);
  REQUIRE(all.size() >= 1);
  const auto one = std::ranges::find_if(all, [](const auto& lesson) { return lesson["id"] == "ray-sphere"; });
  REQUIRE(one != all.end());
  REQUIRE((*one)["presets"].size() == 33);
  for (const auto& lesson : all)
    for (const auto& parameter : lesson["parameters"]) {
      CHECK(parameter.contains("help"));
      CHECK(parameter.contains("default"));
      CHECK(parameter.contains("choices") != parameter.contains("from"));
    }
}

TEST_CASE("list --glossary explains the terms of the course, each with its lesson", "[list]") {
  const Shell shell;
  const Ran r = shell("isect list --glossary");
  CHECK(r.status == 0);
  CHECK_THAT(in_one_line(r.out),
             Contains("separating axis") && Contains("(obb-obb; also intervals, aabb-aabb)") &&
                 Contains("Bold: the direction of a ray or a line, and so a relative velocity. Italic: a distance."));
  CHECK(widest(r.out) <= 80);
  const auto terms = nlohmann::json::parse(shell("isect list --glossary --json").out);
  CHECK(terms.size() > 40);
  for (const auto& term : terms) CHECK_FALSE(term["meaning"].get<std::string>().empty());
}

TEST_CASE("lessons that share an idea are told with each other", "[list]") {
  const Shell shell;
  CHECK_THAT(in_one_line(shell("isect list convex-polygon").out),
             Contains("shares: bisection (concave-polygon); orientation ("));
  CHECK_THAT(in_one_line(shell("isect explain convex-polygon").out),
             Contains("Same idea: Bisection: Point in concave polygon."));
  for (const auto& lesson : nlohmann::json::parse(shell("isect list --json").out)) CHECK_FALSE(lesson["ideas"].empty());
}

TEST_CASE("explain tells a floor with its name, and a pixel by numbers that can be read", "[explain]") {
  const std::string told = Shell()("isect explain ray-tracing").out;
  CHECK_THAT(told, Contains("polygon floor: (") || Contains("rectangle floor: ("));
  CHECK_THAT(told, Contains("-0.6875") && !Contains("0.68749"));
}

TEST_CASE("list walks no lesson, and so it is there at once", "[list]") {
  const Shell shell;
  // One second of processor time, where walking every preset takes more; at once is a few hundredths.
  CHECK(shell("ulimit -t 1; isect list").status == 0);
  CHECK(shell("ulimit -t 1; isect list --json").status == 0);
  for (const auto& lesson : nlohmann::json::parse(shell("isect list --json").out))
    for (const auto& preset : lesson["presets"]) CHECK_FALSE(preset.contains("steps"));
}

TEST_CASE("list of one lesson tells its parameters with range, unit, default and choices, and the presets' steps",
          "[list]") {
  const Shell shell;
  const Ran r = shell("isect list ray-sphere");
  CHECK(r.status == 0);
  CHECK(widest(r.out) <= 80);
  CHECK_THAT(r.out, Contains("method") && Contains("one of haines, quadratic, half-b. Default: haines") &&
                        Contains("in world units") && Contains("a number from 0 to 1") &&
                        Contains("Default: 1.56640625,0.234375") && Contains("Counts where extent is segment.") &&
                        Contains("two-roots") && Contains("12 steps") && !Contains("convex-polygon"));

  const auto one = nlohmann::json::parse(shell("isect list ray-sphere --json").out);
  CHECK(one["id"] == "ray-sphere");
  for (const auto& preset : one["presets"]) CHECK(preset["steps"] >= 2);
  REQUIRE(one["parameters"].size() == 7);
  CHECK(one["parameters"][0]["choices"].size() == 3);
  CHECK(one["parameters"][3]["condition"] == "a vector of any length but 0");
  CHECK(one["parameters"][6]["name"] == "radius");
  CHECK(one["parameters"][6]["from"] == 0);

  const Ran wrong = shell("isect list ray-spere");
  CHECK(wrong.status == 2);
  CHECK_THAT(wrong.err, Contains("lesson") && Contains("mean \"ray-sphere\""));
  for (const char* lesson : {"relations", "robustness", "obb-obb", "culling"}) {
    INFO(lesson);
    CHECK(widest(shell(std::string("isect list ") + lesson).out) <= 80);
  }
}

TEST_CASE("explain tells a step in eighty columns", "[explain]") {
  const Shell shell;
  const Ran r = shell("isect explain ray-sphere --step 8");
  CHECK(r.status == 0);
  CHECK(r.err.empty());
  CHECK_THAT(r.out, Contains("Which root comes first?") && Contains("10  if l² > r²") &&
                        Contains("▸ line 10:  if l² > r² or (l² = r² and s > 0)   (yes)") && Contains("q = 1.0837") &&
                        Contains("Setting:") &&
                        Contains("Question 5:"));  // its number in the whole walk, as in a handout
  CHECK(r.out.find("Answers\n") > r.out.find("Question 5:"));
  CHECK(widest(r.out) <= 80);
  CHECK_THAT(r.out, !Contains("**") && !Contains("_{"));  // no markup
}

TEST_CASE("explain tells every step of every preset", "[explain]") {
  const Shell shell;
  for (const std::string preset : {"two-roots", "tangent-quadratic", "miss-half-b", "surface-out"}) {
    INFO(preset);
    const Ran r = shell("isect explain ray-sphere --preset " + preset);
    CHECK(r.status == 0);
    CHECK_THAT(r.out, Contains("Step 1 of") && Contains("Verdict:"));
    CHECK(widest(r.out) <= 80);
  }
  CHECK_THAT(shell("isect explain ray-sphere --preset miss").out, !Contains("INTERSECT at"));
}

TEST_CASE("explain keeps answers for the end, or gives them at once, or tells in brief", "[explain]") {
  const Shell shell;
  const std::string whole = shell("isect explain sphere-sphere").out;
  const std::size_t answers = whole.find("\nAnswers\n");
  REQUIRE(answers != std::string::npos);
  for (std::size_t at = whole.find("Question 1:"); at != std::string::npos; at = whole.find("Answer: ", at + 1))
    CHECK(at < answers);
  CHECK_THAT(whole.substr(0, answers), !Contains("Answer:") && !Contains("Solution:"));
  CHECK_THAT(whole.substr(answers), Contains("Question 1: (c) overlapping.") && Contains("Exercise 1:"));
  CHECK_THAT(whole, Contains("Line 4 should read: if d² ≤ R²") && Contains("--preset touching"));

  const std::string open = shell("isect explain sphere-sphere --answers").out;
  CHECK_THAT(open, Contains("Answer: (c) overlapping.") && Contains("Solution:") && !Contains("\nAnswers\n"));
  const std::string brief = shell("isect explain sphere-sphere --brief").out;
  CHECK(3 * std::ranges::count(brief, '\n') < std::ranges::count(whole, '\n'));
  CHECK_THAT(in_one_line(brief), Contains("Verdict: the balls overlap") && !Contains("Question"));
  CHECK((brief.ends_with(".\n") && !brief.ends_with("\n\n")));
  std::istringstream lines(brief.substr(brief.find("Step 1 of")));
  for (std::string line; std::getline(lines, line);)  // after each title, what the step computes, decides or says
    if (line.starts_with("Step ")) CHECK_THAT(line, Catch::Matchers::Matches("Step [0-9]+ of [0-9]+: [^.?]+[.?] .+"));
  const std::string exercises = shell("isect explain sphere-sphere --exercises").out;
  CHECK_THAT(exercises, Contains("1. Drag b") && Contains("Solution:") && !Contains("Step 1"));
}

TEST_CASE("explain letters its choices, so that none that is a number is told with another one", "[explain]") {
  const Shell shell;
  const std::string told = shell("isect explain speed-against-error --preset sphere-sphere --answers").out;
  CHECK_THAT(told, Contains("\n    (a) 1\n    (b) 2\n    (c) 5\n") && Contains("Answer: (a) 1."));
  CHECK_THAT(told, !Contains("1. 1"));
}

TEST_CASE("explain gives each question the numbers that nothing above has told, and names what it asks of",
          "[explain]") {
  const Shell shell;
  const auto told = [&](const std::string& of) { return shell("COLUMNS=200 isect explain " + of).out; };
  CHECK_THAT(told("sphere-sphere"),
             Contains("How are the two balls related? Given: d = 2.0312, r_a = 1.5234, r_b = 1.0156."));
  CHECK_THAT(told("sphere-sphere --step compare"),
             Contains("How are the two balls related? Given: d² = 4.126, R² = 6.4468, d = 2.0312, r_a = 1.5234"));
  CHECK_THAT(told("ray-sphere --step passing-distance"), Contains("What is m²? Given: s = 4.472, l² = 21.146"));
  CHECK_THAT(told("culling --preset hierarchy"), Contains("The box of node 3 reaches from "));
}

TEST_CASE("explain tells the preset that an exercise starts from", "[explain]") {
  const Shell shell;
  CHECK_THAT(shell("COLUMNS=200 isect explain clipping --preset concave").out,
             Contains("but the outcodes do not show it. (Preset both-ends-cut.)"));
}

TEST_CASE("explain numbers the lines of a program with a wrong line, and corrects it among the answers", "[explain]") {
  const Shell shell;
  const std::string told = shell("COLUMNS=200 isect explain intervals").out;
  const std::size_t line = told.find("   3  if lo < hi: return OVERLAP\n"), answers = told.find("\nAnswers\n");
  REQUIRE((line != told.npos && answers != told.npos));
  CHECK(line < answers);
  CHECK(told.find("Line 3 should read: if lo ≤ hi: return OVERLAP.") > answers);
  CHECK_THAT(shell("COLUMNS=200 isect explain intervals --exercises").out,
             Contains("   3  if lo < hi: return OVERLAP\n") && Contains("Correction: Line 3 should read: if lo ≤ hi"));
}

TEST_CASE("explain obeys the terminal's width in its pseudocode, too", "[explain]") {
  const Shell shell;
  const std::string told = shell("COLUMNS=40 isect explain ray-polygon").out;
  const std::size_t begin = told.find("Algorithm:"), end = told.find("\n\n", begin);
  std::istringstream lines(told.substr(begin, end - begin));
  for (std::string line; std::getline(lines, line);)
    CHECK(std::ranges::count_if(line, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }) <= 40);
  CHECK_THAT(told, Contains("\n        largest |n_i|\n"));
}

TEST_CASE("explain says where the ends of the edge in question lie", "[explain]") {
  CHECK_THAT(Shell()("isect explain crossings").out, Contains("a (−2, −1.5), b (0.75, −1.75)"));
}

TEST_CASE("explain prints the pseudocode once, and the line of each step", "[explain]") {
  const Shell shell;
  const std::string all = shell("isect explain sphere-sphere").out;
  const std::string told = all.substr(0, all.find("This program should tell"));  // an exercise's lines are others
  const auto count = [&](const std::string& text) {
    int n = 0;
    for (std::size_t at = told.find(text); at != std::string::npos; at = told.find(text, at + 1)) ++n;
    return n;
  };
  CHECK(count(" 2  d² ← l · l") == 1);
  CHECK(count("▸ line 2:  d² ← l · l") == 1);
}

TEST_CASE("explain tells the setting and what was changed, and a map in words", "[explain]") {
  const Shell shell;
  const std::string told = shell("isect explain sphere-sphere --set r_b=1.25").out;
  CHECK_THAT(told,
             Contains("Sphere and sphere: overlapping+r_b=1.25") && Contains("r_b = 1.25. Radius of the second ball"));
  CHECK_THAT(told, Contains("A map of all cases. Across:") && Contains("This setting: overlapping") &&
                       !Contains("dashed") && !Contains("rings"));
}

TEST_CASE("explain tells first where the objects lie that its questions ask about", "[explain]") {
  const Shell shell;
  const std::pair<const char*, const char*> all[] = {
      {"collision --preset tunnelling", "box wall: (0.4, -1.75) to (0.6, 1.75)"},
      {"collision --preset tunnelling", "box p: (-2.75, -0.25) to (-2.25, 0.25)"},
      {"crossings --preset inside", "polygon: ("},
      {"clipping --preset both-ends-cut", "box: (-2, -1.25) to (2, 1.25)"},
      {"concave-polygon --preset slabs", "polygon: (-3, -1), (-1.5, -1.75), (-0.875, -0.25), (0.25, -1.25), "},
      {"picking --preset behind", "box crate: (2.5, -1, -2) to (3.5, 1.5, -0.5625)"},
      {"picking --preset behind", "solid gem: (0.125, 0.25, -0.75), (1, 0.25, -1.625)"},
      {"culling --preset scene", "ball: centre (-0.25, 0.125, 0.5), radius 0.5"},
      {"culling --preset scene", "solid: (-2.5, -0.375, -0.5625), (-2.5, -0.375, 0.5625)"},
      {"relations --preset aabb-touching", "box b: (1, -0.6875, -0.3125) to (2.5, 0.4375, 0.8125)"},
      {"obb-obb --preset normal-of-b", "box a: (-2.25, -0.75, -0.75) to (-0.25, 0.75, 0.75)"},
      {"convex-hull --preset scattered", "points: (-2.25, -0.5), (-1.5, 1.25), (-1, -1.5), (-0.5, 0.25)"},
      {"rays --preset bullet", "box wall: (0.25, -1.5) to (0.5, 1.75)"}};
  for (const auto& [lesson, object] : all) {
    INFO(lesson);
    const std::string told = shell(std::string("COLUMNS=200 isect explain ") + lesson).out;
    const std::size_t first = std::min(told.find("\nQuestion 1"), told.find("\nStep 1"));
    CHECK_THAT(told.substr(0, first), Contains(std::string("\n  ") + object));
  }
  CHECK_THAT(shell("isect explain sphere-sphere").out, !Contains("\nObjects:"));  // its parameters tell all
}

TEST_CASE("explain tells numbers that read alike in full, and no place in a drawing as a coordinate", "[explain]") {
  const Shell shell;
  CHECK_THAT(shell("isect explain points --preset ten-steps --step all").out, Contains("q_x = 0.9999999999999999\n"));
  const std::string projected = shell("isect explain ray-polygon --preset hit --step all").out;
  CHECK_THAT(projected, Contains("r′ = (−0.54688, −0.375)") && !Contains("r′ ("));
  CHECK_THAT(shell("isect explain convex-polygon --step all").out, !Contains("v₀ (2.07238"));
}

TEST_CASE("explain asks in titles without a full stop, and heads no table that is empty", "[explain]") {
  const Shell shell;
  for (const char* place :
       {"aabb-aabb", "points --preset nan", "hierarchy", "collision", "culling", "points --preset chain"}) {
    INFO(place);
    const std::string out = shell(std::string("isect explain ") + place + " --step all").out;
    CHECK_THAT(out, !Contains("?."));
    CHECK_THAT(out, !Contains("Methods side by side:\n\n"));
  }
}

TEST_CASE("explain tells the line that an erratum adds as one that the note lacks", "[explain]") {
  const Shell shell;
  CHECK_THAT(shell("isect explain rays").out, Contains("Line 4 is not in the note.") && !Contains("was published as"));
}

TEST_CASE("explain, handout, deck and book say the same of a comparison, an erratum and a question",
          "[explain][handout][book]") {
  const Shell shell;
  const std::string of = " sphere-sphere --preset overlapping";
  const std::string explain = shell("COLUMNS=400 isect explain" + of).out;
  for (const char* command : {"isect handout", "isect deck"}) REQUIRE(shell(command + of).status == 0);
  REQUIRE(shell("isect book sphere-sphere --single").status == 0);
  const std::string handout = contents(shell.work() / "handouts/sphere-sphere/overlapping/handout.html");
  const std::string deck = contents(shell.work() / "decks/sphere-sphere/overlapping/deck.html");
  const std::string book = contents(shell.work() / "book/sphere-sphere.html");

  CHECK_THAT(explain, Contains("Is d² < R²? Yes (4.126 against 6.4468): the note returns OVERLAP."));
  CHECK_THAT(handout, Contains("Is d² &lt; R²? Yes (4.126 against 6.4468): the note returns OVERLAP."));
  CHECK_THAT(book, Contains("Is <i>d</i><sup>2</sup> &lt; <i>R</i><sup>2</sup>? <b>Yes</b> (4.126 against 6.4468): the "
                            "note returns OVERLAP."));
  for (const std::string& text : {explain, handout, deck, book})
    CHECK_THAT(text, Contains("Line 4 should read: if d² ≤ R². Balls that touch have a common point;"));

  CHECK_THAT(shell("COLUMNS=400 isect explain sphere-sphere --step compare").out, Contains("Question 1: (c) overlap"));
  CHECK_THAT(handout, Contains("<b>Question 1.</b> (c) overlapping."));
}

TEST_CASE("explain tells a verdict that is open", "[explain]") {
  const Shell shell;
  write(shell.work() / "open.json", R"({"objects": [
      {"ray": "r", "origin": [2.1, 1.5, -2], "dir": [0, 0, 1]},
      {"polygon": "P", "points": [[-1,-1,0], [1,1,0], [1,-1,0], [-1,1,0]]}], "ask": [["r", "P"]]})");
  CHECK_THAT(shell("COLUMNS=200 isect explain open.json").out, Contains("Verdict: r and P: not decided, as "));
}

TEST_CASE("explain tells what must be set together in one line", "[explain]") {
  const Shell shell;
  CHECK_THAT(shell("isect explain points --exercises").out,
             Contains("One way: --set question=chain --set q=0.75,0,0 --set r=1.5,0,0"));
}

TEST_CASE("explain is as wide as the terminal", "[explain]") {
  const Shell shell;
  CHECK(widest(shell("COLUMNS=60 isect explain sphere-sphere").out) <= 60);
  const std::size_t wide = widest(shell("COLUMNS=120 isect explain sphere-sphere").out);
  CHECK((wide > 80 && wide <= 120));
}

TEST_CASE("explain follows changed parameters", "[explain]") {
  const Shell shell;
  CHECK_THAT(shell("isect explain ray-sphere --set radius=0.25 --step 3").out, Contains("r² = 0.0625"));
}

TEST_CASE("explain tells of a corner only where it was moved, and refuses one that may not stand there", "[explain]") {
  const Shell shell;
  CHECK_THAT(shell("isect explain crossings --step 1").out, !Contains("v2"));
  CHECK_THAT(shell("isect explain crossings --step 1 --set v2=1,1,0").out, Contains("v₂ = (1, 1)"));
  const Ran refused = shell("isect explain concave-polygon --set v2=-2,1.25,0");
  CHECK(refused.status == 2);
  CHECK_THAT(refused.err, Contains("v2") && Contains("no two edges cross"));
}

TEST_CASE("explain and show refuse what does not exist", "[explain][show]") {
  const Shell shell;
  for (const std::string sub : {"explain", "show"}) {
    const std::string isect = "isect " + sub;
    CHECK_THAT(shell(isect + " ray-spere").err, Contains("lesson") && Contains("mean \"ray-sphere\""));
    CHECK_THAT(shell(isect + " ray-sphere --preset tangnt").err, Contains("preset") && Contains("mean \"tangent\""));
    for (const std::string step : {"0", "14", "-14", "x", "1.5"}) {
      INFO(step);
      const Ran r = shell(isect + " ray-sphere --step " + step);
      CHECK(r.status == 2);
      CHECK_THAT(r.err, Contains("step") && Contains("1 to 13"));
    }
    CHECK_THAT(shell(isect + " ray-sphere --step ''").err, Contains("--step: empty"));
    CHECK(shell(isect + " ray-sphere ray-sphere").status == 2);
    CHECK(shell(isect + " ray-sphere --preset all").status == 2);
  }
  CHECK(shell("isect show ray-sphere --step all").status == 2);
  CHECK(shell("isect explain").status == 2);
}

TEST_CASE("show opens a figure only if isect made it", "[show]") {
  const Shell shell;
  shell("isect render ray-sphere --preset tangent --step 3 --format png,svg,pdf,tikz --set radius=2 --out f");
  // Nothing is refused but the missing display: the figure's place was understood.
  CHECK(shell("isect show f/ray-sphere/tangent+radius=2/03-distance.png").status == 77);
  CHECK(shell("isect show f/ray-sphere/tangent+radius=2/03-distance.svg").status == 77);
  CHECK(shell("isect show f/ray-sphere/tangent+radius=2/03-distance.pdf").status == 77);
  CHECK(shell("isect show f/ray-sphere/tangent+radius=2/03-distance.tikz").status == 77);

  CHECK(shell("isect show nowhere.png").status == 4);
  const Ran rubbish = shell("echo rubbish >r.png && isect show r.png");
  CHECK((rubbish.status == 4 || rubbish.status == 2));
  CHECK_THAT(rubbish.err, Contains("r.png"));
  const Ran other = shell("echo '<svg xmlns=\"http://www.w3.org/2000/svg\"/>' >o.svg && isect show o.svg");
  CHECK(other.status == 2);
  CHECK_THAT(other.err, Contains("o.svg") && Contains("no isect metadata") && Contains("LESSON --preset P --step N"));
}

TEST_CASE("doctor tries each back end and names versions and fonts", "[doctor]") {
  const Shell shell;
  const Ran r = shell("isect doctor");
  CHECK(r.status == 0);
  CHECK_THAT(r.out, Contains("llvmpipe") && Contains("Mesa") && Contains("Eigen 3.") && Contains("DejaVu Sans") &&
                        Contains("no window"));
  CHECK_THAT(shell("DISPLAY=:7 isect doctor").out, Contains("DISPLAY=:7"));
}

}  // namespace tell_test
