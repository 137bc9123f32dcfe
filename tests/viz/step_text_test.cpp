// What a step says, in parts.

#include "viz/walk/step_text.h"

#include "tests/catch.h"
#include "tests/viz/sample_lesson.h"
#include "viz/chart/case_map.h"
#include "viz/text/rich_text.h"
#include "viz/walk/branch.h"
#include "viz/walk/closing.h"

namespace step_text_test {
using namespace isect::viz;

namespace {

const Lesson disc = sample::lesson();
const Walk inside = disc.walk(disc.presets[0].parameters);

}  // namespace

TEST_CASE("a step says its line, its values and its comparison", "[step_text]") {
  const StepText told = step_text(disc, inside, 2);
  CHECK(told.title == "Compare");
  REQUIRE(told.line);
  CHECK(told.line->number == 3);
  CHECK(told.line->code == "if l² > r²");
  CHECK(told.line->said == "no");
  REQUIRE(told.values.size() == 2);
  CHECK((told.values[0].name == "*l*^2" && told.values[0].digits == "0.5" && !told.values[0].fresh));
  CHECK((told.values[1].digits == "2.25" && told.values[1].fresh));
  REQUIRE(told.comparison);
  CHECK(told.comparison->question == "Is *l*^2 ≤ *r*^2?");
  CHECK(told.comparison->answer == "Yes");
  CHECK(told.comparison->why == "(0.5 against 2.25): the disc holds the point.");
}

TEST_CASE("the lit line says whether its condition is true, once it is decided, and still beneath a map and a card",
          "[step_text]") {
  const auto said = [](const Walk& walk, int step) { return step_text(disc, walk, step).line->said; };
  CHECK(said(inside, 0) == "");  // no condition
  CHECK(said(inside, 2) == "no");
  CHECK(said(inside, 4) == "");

  Walk outside = disc.walk(disc.presets[1].parameters);
  Comparison& compared = *outside.steps[2].comparison;
  compared.text = "*l*^2 > *r*^2", compared.holds = true;
  CHECK(said(outside, 2) == "yes");
  CHECK(said(outside, 3) == "");  // "return OUT"
  outside.steps[2].comparison.reset();
  CHECK(said(outside, 2) == "yes");  // it decides
  outside.steps[2].decides = false;
  CHECK(said(outside, 2) == "");

  Walk ends = inside;
  Step last = ends.steps[2];
  last.decides = false, last.comparison.reset(), last.question.reset();
  ends.steps.resize(3);
  for (const char* slug : {case_map_slug, closing_slug}) {
    last.slug = slug;
    ends.steps.push_back(last);
  }
  CHECK(said(ends, 3) == "no");
  CHECK(said(ends, 4) == "no");
  ends.steps[3].slug = "another";  // a step of its own, which decides nothing
  CHECK(said(ends, 3) == "");
  CHECK(said(ends, 4) == "");
  CHECK(said_at_line(taken(ends, 2)) == "no");
}

TEST_CASE("a line is told without its indentation, and a value that ends the formula as part of it", "[step_text]") {
  Walk walk = disc.walk(disc.presets[1].parameters);
  CHECK(step_text(disc, walk, 3).line->code == "return OUT");
  CHECK_FALSE(step_text(disc, walk, 1).values.front().in_formula);
  walk.steps[1].formula += " = " + shown(walk.steps[1].values.front().value);
  CHECK(step_text(disc, walk, 1).values.front().in_formula);
}

TEST_CASE("a condition that joins several tells the numbers of each, in full where they read alike", "[step_text]") {
  const Comparison first = {"*s* < 0", -1, 0, true, ""}, second = {"*l*_1 > *r*", 1, 1 + 1e-9, false, ""};
  CHECK(compared_numbers(first) == "−1 against 0");
  CHECK(plain(compared_numbers({"", 0, 0, false, "", {first, second}})) ==
        "s < 0: yes, −1 against 0; l₁ > r: no, 1 against 1.000000001");
}

TEST_CASE("a question has its number in the walk, the numbers that it is given, and its answer's letter",
          "[step_text]") {
  CHECK_FALSE(question_text(inside, 1));
  Walk walk = inside;
  Question& asked = *walk.steps[2].question;
  asked.given = {{"*r*", 1.5}};
  walk.steps[4].question = asked;
  const QuestionText q = *question_text(walk, 2);
  CHECK(q.number == 1);
  CHECK(q.prompt == "Where is **p**? Given: *r* = 1.5.");
  CHECK(q.whole_prompt == "Where is **p**? Given: *l*^2 = 0.5, *r* = 1.5.");
  REQUIRE(q.known.size() == 1);
  CHECK(q.known.front().name == "*l*^2");
  CHECK(q.answer == "(a) inside.");
  CHECK(q.because == "Its distance decides.");
  CHECK(question_text(walk, 4)->number == 2);
}

TEST_CASE("an erratum says what the line should read, was published as, or that the note lacks it", "[step_text]") {
  Lesson lesson = disc;
  lesson.errata = {{"  return OUT", "  return NOWHERE", "It is *nowhere*.", "squared-on"}};
  const auto told = [&] { return errata_text(lesson, inside); };
  REQUIRE(told().size() == 1);
  CHECK(told().front().line == 4);
  CHECK(with_preset(told().front(), &Preset::id) ==
        "Line 4 should read: return NOWHERE. It is *nowhere*. (See the preset “squared-on”.)");
  std::swap(lesson.errata.front().published, lesson.errata.front().corrected);
  CHECK(told().front().says == "Line 4 was published as: return NOWHERE.");
  lesson.errata.front().published = "return IN";
  CHECK(told().front().says == "Line 4 is not in the note.");
  lesson.errata.front() = {"return", "return", "", "squared-on"};
  CHECK(told().empty());  // another method's
}

TEST_CASE("the caption of a figure that stands alone is one line, without the lesson's opening", "[step_text]") {
  Lesson lesson = disc;
  lesson.opening = "Why ask?";
  Walk walk = lesson.walk(lesson.presets[0].parameters);
  CHECK(step_text(lesson, walk, 0).caption.starts_with("Why ask?\nFrom the point"));
  CHECK(step_text(lesson, walk, 0).own_caption.starts_with("From the point"));
  walk.steps[0].title = "Where?";
  CHECK(figure_caption(lesson, walk.steps[0]) ==
        "Where? From the point to the centre leads **l**. Its length *l* decides. Nothing else is needed.");
}

}  // namespace step_text_test
