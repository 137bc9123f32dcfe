// What is said to a number that a reader typed.

#include "viz/walk/typed_answer.h"

#include "tests/catch.h"
#include "viz/text/number_text.h"

namespace typed_answer_test {
using namespace isect;
using namespace isect::viz;

namespace {

const Numeric third = {1.0 / 3, 3, {{3, "Divide the other way round."}, {1, "That is not divided."}}};
const Numeric six = {6, 0, {{12, "Each pair is counted twice."}, {3, "Those are the boxes."}}};

Question asked() {
  Question question = {"*t*?", {"0.33333", "1", "3", "5"}, 0, "One over three."};
  question.number = third;
  return question;
}

}  // namespace

TEST_CASE("a number may be rounded or cut off after as many digits as are asked for", "[typed_answer]") {
  for (const char* right : {"1/3", "0.333", "0.3333", "0.334", "0,333", "333e-3", "3^-1", "1/√9"}) {
    INFO(right);
    CHECK(is_right(third, number_from(right)));
  }
  for (const char* wrong : {"0.33", "0.3", "0.336", "-1/3", "3", "0", "1"}) {
    INFO(wrong);
    CHECK_FALSE(is_right(third, number_from(wrong)));
  }
  const Numeric two_thirds = {2.0 / 3, 3, {}}, round = {4, 3, {}}, large = {123456, 3, {}};
  for (const double x : {0.666, 0.667, 0.6667}) CHECK(is_right(two_thirds, x));
  for (const double x : {4.0, 4.01, 3.99}) CHECK(is_right(round, x));
  for (const double x : {123000.0, 123456.0, 124000.0}) CHECK(is_right(large, x));
  for (const double x : {122000.0, 125000.0}) CHECK_FALSE(is_right(large, x));
  CHECK(exactness(third) == "to three digits");
}

TEST_CASE("a count is met exactly, in whatever form", "[typed_answer]") {
  for (const char* right : {"6", "6.0", "12/2", "2*3", "√36", "√6^2"}) {
    INFO(right);
    CHECK(is_right(six, number_from(right)));
  }
  for (const double wrong : {5.0, 7.0, 6.001, -6.0, 0.0}) CHECK_FALSE(is_right(six, wrong));
  CHECK(exactness(six) == "a whole number");
  CHECK(what_to_type(six) == "Type a whole number.");
  CHECK(what_to_type(third) == "Type a number to three digits; 1/3 and √2 will do.");
}

TEST_CASE("nothing but nothing is zero", "[typed_answer]") {
  for (const int digits : {0, 3}) {
    const Numeric zero = {0, digits, {{2, "That is *r*."}}};
    for (const char* right : {"0", "-0", "0.1+0.2-0.3", "1-1"}) CHECK(is_right(zero, number_from(right)));
    for (const double wrong : {1e-3, -1e-3, 1.0}) CHECK_FALSE(is_right(zero, wrong));
    CHECK(reply_to(zero, 2) == "That is *r*.");
    CHECK(reply_to(zero, 1).empty());
  }
}

TEST_CASE("every usual wrong number is answered with its mistake, others with a lost sign or lost digits",
          "[typed_answer]") {
  CHECK(reply_to(third, 3) == "Divide the other way round.");
  CHECK(reply_to(third, 3.001) == "Divide the other way round.");
  CHECK(reply_to(third, 1) == "That is not divided.");
  CHECK(reply_to(third, -0.333) == "The sign is the opposite.");
  CHECK(reply_to(third, 0.33) == "That is near. The answer is asked for to three digits.");
  CHECK(reply_to(third, 0.3333).empty());
  CHECK(reply_to(third, 17).empty());
  CHECK(reply_to(six, 12) == "Each pair is counted twice.");
  CHECK(reply_to(six, -6) == "The sign is the opposite.");
  CHECK(reply_to(six, 6.001).empty());
}

TEST_CASE("a typed number marks the choice that says it", "[typed_answer]") {
  const Question question = asked();
  CHECK(choice_of(question, 0.333) == 0);
  CHECK(choice_of(question, 3) == 2);
  CHECK(choice_of(question, 1) == 1);
  CHECK_FALSE(choice_of(question, 17));
  CHECK(reply_to_choice(question, 0).empty());
  CHECK(reply_to_choice(question, 2) == "Divide the other way round.");
  CHECK(reply_to_choice(question, 3).empty());
  CHECK(reply_to_choice(question, -1).empty());
}

TEST_CASE("what was typed is told with the number that it is read as", "[typed_answer]") {
  CHECK(typed_text("3/4", 0.75) == "3/4 = 0.75");
  CHECK(typed_text("0,75", 0.75) == "0,75 = 0.75");
  CHECK(typed_text("0.75", 0.75) == "0.75");
  CHECK(typed_text("-3", -3) == "−3");
}

}  // namespace typed_answer_test
