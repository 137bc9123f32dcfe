// Each question can be asked again with other numbers, whose answer the core decides.

#include "viz/walk/other_numbers.h"

#include "tests/catch.h"
#include "tests/lessons/words.h"
#include "viz/walk/review.h"

namespace other_numbers_test {
using namespace isect;
using namespace isect::tests;
using namespace isect::viz;

TEST_CASE("a question is asked again with another right answer or other numbers", "[every lesson]") {
  int asked = 0, found = 0;
  for (const Lesson* lesson : lessons::all_lessons()) {
    const Parameters& setting = lesson->presets.front().parameters;
    const Walk walk = lesson->walk(setting);
    for (int i = 1; i < static_cast<int>(walk.steps.size()); ++i) {
      if (!walk.steps[i].question) continue;
      INFO(lesson->id << ", " << walk.steps[i].slug);
      ++asked;
      const auto other = other_numbers(*lesson, setting, i, static_cast<std::uint32_t>(seed()));
      if (!other) continue;
      ++found;
      validate(*lesson, other->parameters);
      const Walk there = lesson->walk(other->parameters);
      REQUIRE(there.steps.at(static_cast<std::size_t>(other->step)).question);
      CHECK(question_name(*lesson, other->parameters, there.steps[other->step]) ==
            question_name(*lesson, setting, walk.steps[i]));
      CHECK(numbers_of_question(there, other->step) != numbers_of_question(walk, i));
      CHECK(choices_differ(*there.steps[other->step].question));
      CHECK(other_numbers(*lesson, setting, i, static_cast<std::uint32_t>(seed()))->parameters == other->parameters);
    }
  }
  CHECK(asked > 80);
  CHECK(found * 10 > asked * 8);
}

TEST_CASE("choices that read alike, or a wrong number that is right, are told apart from good ones", "[words]") {
  Question q = {"*t*?", {"1", "2", "3"}, 0, "One."};
  CHECK(choices_differ(q));
  q.number = Numeric{1, 3, {{2, "Twice."}}};
  CHECK(choices_differ(q));
  q.number->wrong.push_back({1.001, "Near."});
  CHECK_FALSE(choices_differ(q));
  q.number.reset();
  q.choices = {"*a*", "a", "b"};
  CHECK_FALSE(choices_differ(q));
}

}  // namespace other_numbers_test
