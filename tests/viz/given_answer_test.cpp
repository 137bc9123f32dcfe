// What is said to a line that a reader pointed at, and to an order that a reader gave.

#include "viz/walk/given_answer.h"

#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/catch.h"
#include "tests/viz/sample_lesson.h"
#include "viz/player/player.h"
#include "viz/walk/given_order.h"
#include "viz/walk/pointed_line.h"
#include "viz/walk/step_text.h"

namespace given_answer_test {
using namespace isect;
using namespace isect::viz;
using isect::test::Contains;
using nlohmann::json;

namespace {

json cases() {
  std::ifstream file(ISECT_TYPED_ANSWERS);
  return json::parse(file);  // app/book/answers.js is held to it, too
}

OrderAsked asked_by(const json& one) {
  OrderAsked asked;
  asked.tiles = one.at("tiles").get<std::vector<std::string>>();
  asked.ranks = one.at("ranks").get<std::vector<int>>();
  const int tiles = static_cast<int>(asked.tiles.size());
  for (const json& wrong : one.at("wrong"))
    asked.wrong.push_back({order_from(wrong.at(0).get<std::string>(), tiles), wrong.at(1).get<std::string>()});
  return asked;
}

Walk walk_of(const Lesson& lesson) { return lesson.steps(lesson.presets.front().parameters); }

/// The answer that was given to the sample lesson's question.
GivenAnswer typed(const Lesson& lesson, const std::string& text) { return answer_from(walk_of(lesson), 2, text); }

}  // namespace

TEST_CASE("a line's number is read as people write it, and what is none is refused with its reason", "[given_answer]") {
  for (const json& one : cases().at("lines")) {
    const std::string text = one.at(0).get<std::string>();
    const int lines = one.at(1).get<int>();
    INFO("“" << text << "”");
    if (one.at(2).is_string()) {
      CHECK_THROWS_WITH(line_from(text, lines), Contains(one.at(2).get<std::string>()));
      CHECK_THROWS_AS(line_from(text, lines), BadInput);
    } else {
      CHECK(line_from(text, lines) == one.at(2).get<int>());
    }
  }
}

TEST_CASE("the letters of an order are read, each once, and what is none is refused with its reason",
          "[given_answer]") {
  for (const json& one : cases().at("orders")) {
    const std::string text = one.at(0).get<std::string>(), wanted = one.at(2).get<std::string>();
    const int tiles = one.at(1).get<int>();
    INFO("“" << text << "”");
    if (wanted.find(' ') != std::string::npos) {
      CHECK_THROWS_WITH(order_from(text, tiles), Contains(wanted));
      CHECK_THROWS_AS(order_from(text, tiles), BadInput);
    } else {
      CHECK(letters_of(order_from(text, tiles)) == wanted);
    }
  }
}

TEST_CASE("an order is right up to ties, a usual wrong one has its mistake, others their first wrong tile",
          "[given_answer]") {
  for (const json& one : cases().at("said")) {
    const OrderAsked asked = asked_by(one);
    const std::vector<int> order = order_from(one.at("order").get<std::string>(), static_cast<int>(asked.tiles.size()));
    INFO(letters_of(order));
    CHECK(reply_to(asked, order) == one.at("said").get<std::string>());
    CHECK((first_wrong(asked, order) < 0) == one.at("said").get<std::string>().empty());
  }
}

TEST_CASE("the right order is told with all that may change places", "[given_answer]") {
  CHECK(right_order({{"*x*", "*y*", "*z*"}, {1, 2, 0}, {}, {}}) == "(c) *z*, then (a) *x*, then (b) *y*");
  CHECK(right_order({{"1", "2", "3"}, {1, 0, 1}, {}, {}}) == "(b) 2, then (a) 1 and (c) 3 in any order");
  CHECK_THAT(how_to_order({{"1", "2", "3"}, {1, 0, 1}, {}, {}}), Contains("any may come first"));
  CHECK_THAT(how_to_order({{"1", "2", "3"}, {1, 0, 2}, {}, {}}), !Contains("any may come first"));
}

TEST_CASE("a line is right, or told its mistake, or what it does up to this step", "[given_answer]") {
  const Lesson lesson = sample::asking_for_a_line();
  const Walk walk = walk_of(lesson);
  const std::vector<std::string> said = line_replies(walk, 2);
  REQUIRE(said.size() == walk.pseudocode.size());
  CHECK(said[0] == "Line 1 was told at an earlier step. It is not the one that is told next.");
  CHECK(said[2].empty());
  CHECK(said[3] == "Line 4 stands in a branch that was not taken.");
  CHECK(said[4] == "That line returns.");
  CHECK(typed(lesson, "3").choice == walk.steps[2].question->answer);
  CHECK((typed(lesson, "line 2").choice == 0 && typed(lesson, "5").choice == 2 && typed(lesson, "4").choice == -1));
  CHECK(reply_to(walk, 2, typed(lesson, "5")) == said[4]);
  CHECK(reply_to(walk, 2, pointed_at(*walk.steps[2].question, 3)) == said[3]);
  CHECK(reply_to(walk, 2, GivenAnswer{2}) == said[4]);  // the choice
  CHECK(told_of(*walk.steps[2].question, typed(lesson, "5")) == "You pointed at line 5.");
  CHECK(question_text(walk, 2)->answer == "Line 3: if l² > r².");
}

TEST_CASE("an order marks the choice that says it", "[given_answer]") {
  const Lesson lesson = sample::asking_for_an_order();
  const Walk walk = walk_of(lesson);
  CHECK(typed(lesson, "acb").choice == 0);
  CHECK((typed(lesson, "abc").choice == 1 && typed(lesson, "bca").choice == 2 && typed(lesson, "cab").choice == -1));
  CHECK(reply_to(walk, 2, typed(lesson, "bca")) == "That begins with the farthest.");
  CHECK(reply_to(walk, 2, GivenAnswer{2}) == "That begins with the farthest.");
  CHECK(reply_to(walk, 2, typed(lesson, "abc")) == "The first is right. The next is not far.");
  CHECK(reply_to(walk, 2, typed(lesson, "acb")).empty());
  CHECK(told_of(*walk.steps[2].question, typed(lesson, "cab")) == "Your order was: middle, near, far.");
  CHECK(question_text(walk, 2)->answer == "(a) near, then (c) middle, then (b) far.");
}

TEST_CASE("a player takes a line and an order, and what can't be read leaves the question open", "[given_answer]") {
  const Lesson lines = sample::asking_for_a_line(), orders = sample::asking_for_an_order();
  for (const Lesson* lesson : {&lines, &orders}) {
    Player player({lesson});
    player.go_to(1);
    player.next();
    REQUIRE(player.quiz().asks_more());
    CHECK_THROWS_AS(player.answer_typed("0"), BadInput);
    CHECK((player.index() == 1 && player.quiz().asks_more()));
    player.answer_typed(lesson == &lines ? "3" : "acb");
    REQUIRE(player.quiz().answered());
    CHECK((player.index() == 2 && player.quiz().answered()->right() && player.quiz().answered()->reply.empty()));
    player.ask_again(2);
    player.show_choices();
    CHECK_FALSE(player.quiz().asks_more());
    player.answer_line(2);  // now it is a choice
    CHECK(player.quiz().asked());
    player.answer(2);
    REQUIRE(player.quiz().answered());
    CHECK_FALSE(player.quiz().answered()->reply.empty());
  }
}

}  // namespace given_answer_test
