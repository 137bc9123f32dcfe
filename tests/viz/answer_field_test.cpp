// The field for a number that a question asks for.

#include "tests/catch.h"
#include "tests/viz/at_question.h"
#include "tests/viz/sample_lesson.h"

namespace answer_field_test {
using namespace isect;
using namespace isect::viz;

namespace {

const Lesson number = sample::asking_for_a_number(), plain_choice = sample::other_lesson();
const std::vector<const Lesson*> both = {&number, &plain_choice};

struct Asked : AtQuestion {
  explicit Asked(float height = 800) : AtQuestion(both, height) { REQUIRE(window.player().quiz().wants_number()); }
};

}  // namespace

TEST_CASE("a number is typed at once, and Enter answers with it", "[answer_field]") {
  Asked at;
  REQUIRE((at.window.has("answer") && at.window.has("give answer") && at.window.has("show choices")));
  CHECK_FALSE(at.window.has("choice 0"));
  at.type("3/4");
  CHECK(at.window.player().quiz().wants_number());
  at.enter();
  REQUIRE(at.window.player().quiz().answered());
  CHECK(at.window.player().quiz().answered()->right());
  CHECK(at.window.player().quiz().answered()->typed == "3/4");
  CHECK((at.window.has("what was typed") && at.window.has("choice 1") && !at.window.has("reply")));
}

TEST_CASE("all that is typed at once arrives in order", "[answer_field]") {
  for (const char* text : {"0.75", "−4/3", "√9", "(1+2)/4"}) {
    INFO(text);
    Asked at;
    at.window.type(text);
    at.window.frames(4);
    at.enter();
    REQUIRE(at.window.player().quiz().answered());
    CHECK(at.window.player().quiz().answered()->typed == text);
  }
}

TEST_CASE("digits, signs and letters typed into the answer are no commands", "[answer_field]") {
  Asked at;
  const std::string preset = at.window.player().played().preset_id();
  at.type("2*pi-1e5");
  CHECK(at.window.player().played().preset_id() == preset);
  CHECK(at.window.player().quiz().wants_number());
  at.window.key(key::right);  // moves the cursor
  CHECK(at.window.player().quiz().asked());
  at.enter();
  REQUIRE(at.window.player().quiz().answered());
  CHECK(at.window.player().quiz().answered()->typed == "2*pi-1e5");
}

TEST_CASE("a usual wrong number is answered with its mistake", "[answer_field]") {
  Asked at;
  at.type("1.333");
  at.enter();
  REQUIRE(at.window.player().quiz().answered());
  CHECK_FALSE(at.window.player().quiz().answered()->right());
  CHECK(at.window.player().quiz().answered()->reply == "You divided the other way round.");
  REQUIRE((at.window.has("reply") && at.window.has("what was typed")));
  CHECK(at.window.rect("reply").bottom <= at.window.rect("choice 0").top);
}

TEST_CASE("what is no number is refused below the field, which stays open", "[answer_field]") {
  Asked at;
  at.type("1/0");
  at.enter();
  CHECK(at.window.player().quiz().wants_number());
  REQUIRE(at.window.has("unread answer"));
  CHECK(at.window.rect("unread answer").top >= at.window.rect("answer").bottom);
  at.window.frames(4);
  at.type("+3/4");
  at.enter();
  CHECK(at.window.player().quiz().wants_number());  // 1/0+3/4
  CHECK(at.window.has("unread answer"));
}

TEST_CASE("the field opens by click and by keyboard, and a button answers, too", "[answer_field]") {
  Asked at;
  at.window.click("answer");
  at.window.frames(4);
  at.type("0,75");
  at.window.click("give answer");
  at.window.frames(2);
  REQUIRE(at.window.player().quiz().answered());
  CHECK(at.window.player().quiz().answered()->right());

  Asked again;
  for (int i = 0; i < 60 && again.window.ui.focus() != "answer"; ++i) again.window.key(key::down);
  REQUIRE(again.window.ui.focus() == "answer");
  again.enter();
  again.type("abc");
  again.enter();
  CHECK(again.window.has("unread answer"));
}

TEST_CASE("a button or a letter shows the choices, which then are answered as before", "[answer_field]") {
  Asked at;
  at.window.click("show choices");
  at.window.frames(2);
  REQUIRE(at.window.has("choice 0"));
  CHECK_FALSE(at.window.has("answer"));
  at.window.click("choice 2");
  REQUIRE(at.window.player().quiz().answered());
  CHECK(at.window.player().quiz().answered()->reply == "You divided the other way round.");

  Asked by_letter;
  by_letter.window.type("b");
  REQUIRE(by_letter.window.player().quiz().asked());
  CHECK_FALSE(by_letter.window.player().quiz().wants_number());
  by_letter.window.type("b");
  REQUIRE(by_letter.window.player().quiz().answered());
  CHECK(by_letter.window.player().quiz().answered()->right());
}

TEST_CASE("Right steps past a question for a number that nobody answers", "[answer_field]") {
  Asked at;
  at.window.key(key::right);
  CHECK(at.window.player().index() == 2);
  CHECK_FALSE(at.window.player().quiz().answered());
}

TEST_CASE("what was typed for one question does not stand in the field of another", "[answer_field]") {
  Asked at;
  at.type("5");
  at.window.key(key::escape);
  at.window.frames(2);
  at.window.player().ask_again(2);
  at.window.player().edit("r", 2.0);
  at.window.frames(2);
  at.type("3/4");
  at.enter();
  REQUIRE(at.window.player().quiz().answered());
  CHECK(at.window.player().quiz().answered()->typed == "3/4");
}

TEST_CASE("with the panels hidden the number is typed below the scene", "[answer_field]") {
  Asked at(600);
  at.window.key(key::tab);
  at.window.frames(3);
  const Rect words = at.window.rect("told words"), field = at.window.rect("answer");
  CHECK((field.top > words.top && field.bottom < words.bottom && field.right < words.right));
  at.type("0.75");
  at.enter();
  REQUIRE(at.window.player().quiz().answered());
  CHECK(at.window.player().quiz().answered()->right());
}

}  // namespace answer_field_test
