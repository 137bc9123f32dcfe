// Questions for a line of the pseudocode and for an order, in the window.

#include "tests/catch.h"
#include "tests/viz/at_question.h"
#include "tests/viz/sample_lesson.h"

namespace lines_and_orders_test {
using namespace isect;
using namespace isect::viz;

namespace {

const Lesson line = sample::asking_for_a_line(), order = sample::asking_for_an_order();

struct Asked : AtQuestion {
  explicit Asked(const Lesson& lesson) : AtQuestion({&lesson}) {}
};

}  // namespace

TEST_CASE("a line that is clicked is the answer", "[window]") {
  Asked right(line);
  REQUIRE(right.window.has("line 3"));
  CHECK_FALSE(right.window.has("choice 0"));
  right.window.click("line 3");
  right.window.frames(2);
  CHECK(right.answered().right());
  CHECK(right.window.player().index() == 2);
  CHECK((right.window.has("what was typed") && !right.window.has("reply")));

  Asked wrong(line);
  wrong.window.click("line 5");
  wrong.window.frames(2);
  CHECK_FALSE(wrong.answered().right());
  CHECK(wrong.answered().reply == "That line returns.");
  CHECK(wrong.window.has("reply"));
  CHECK(wrong.window.player().index() == 2);  // and not at the step of line 5

  Asked other(line);
  other.window.click("line 4");
  other.window.frames(2);
  CHECK(other.answered().reply == "Line 4 stands in a branch that was not taken.");
}

TEST_CASE("a line's number is typed, and a number beyond the lines is refused", "[window]") {
  Asked at(line);
  at.type("9");
  at.enter();
  CHECK(at.window.player().quiz().wants_line());
  CHECK(at.window.has("unread answer"));
  Asked again(line);
  again.type("3");
  again.enter();
  CHECK(again.answered().right());
}

TEST_CASE("with the panels hidden the lines to point at stand beside the question", "[window]") {
  Asked at(line);
  at.window.key(key::tab);
  at.window.frames(3);
  REQUIRE(at.window.has("point 3"));
  CHECK(at.window.rect("point 3").left > at.window.rect("answer").right);
  at.window.click("point 3");
  at.window.frames(2);
  CHECK(at.answered().right());
}

TEST_CASE("tiles that are clicked one after the other are the order, and a click takes one back", "[window]") {
  Asked at(order);
  REQUIRE((at.window.has("tile 0") && at.window.has("tile 2")));
  for (const char* tile : {"tile 1", "tile 0", "tile 1", "tile 2", "tile 1"}) {
    at.window.click(tile);
    at.window.frames(1);
  }
  CHECK(at.window.player().quiz().wants_order());
  at.window.click("give answer");
  at.window.frames(2);
  CHECK(at.answered().typed == "acb");
  CHECK(at.answered().right());
  CHECK(at.answered().told == "Your order was: near, middle, far.");
}

TEST_CASE("an order is typed by its letters, after tiles that were clicked, too", "[window]") {
  Asked typed(order);
  typed.type("bca");
  typed.enter();
  CHECK(typed.answered().reply == "That begins with the farthest.");
  CHECK(typed.window.has("reply"));

  Asked both(order);
  both.window.click("tile 0");
  both.window.frames(2);
  both.type("cb");
  both.enter();
  CHECK(both.answered().right());
}

TEST_CASE("an order without all its tiles is refused, and the tiles that were taken stay so", "[window]") {
  Asked at(order);
  at.window.click("tile 0");
  at.window.frames(1);
  at.window.click("give answer");
  at.window.frames(3);
  CHECK(at.window.player().quiz().wants_order());
  REQUIRE(at.window.has("unread answer"));
  at.type("cb");
  at.enter();
  CHECK(at.answered().typed == "acb");
}

TEST_CASE("the choices of a line and of an order are a hint", "[window]") {
  for (const Lesson* lesson : {&line, &order}) {
    Asked at(*lesson);
    at.window.click("show choices");
    at.window.frames(2);
    REQUIRE(at.window.has("choice 2"));
    CHECK_FALSE(at.window.has("tile 0"));
    at.window.click("choice 2");
    at.window.frames(2);
    CHECK_FALSE(at.answered().right());
    CHECK_FALSE(at.answered().reply.empty());
  }
}

}  // namespace lines_and_orders_test
