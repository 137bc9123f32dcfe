// Questions for a number: the right one is taken as it is shown, and each usual wrong one is told its mistake.

#include <cmath>
#include <set>
#include <sstream>

#include "tests/lessons/asked_for.h"
#include "tests/lessons/words.h"
#include "viz/text/number_text.h"
#include "viz/text/rich_text.h"
#include "viz/walk/typed_answer.h"

namespace typed_numbers_test {
using namespace isect;
using namespace isect::viz;
using namespace isect::tests;

namespace {

/// Returns how many words the longest sentence has.
int longest_sentence(const std::string& markup) {
  std::istringstream text(plain(markup));
  int words = 0, most = 0;
  for (std::string word; text >> word;) {
    most = std::max(most, ++words);
    if (word.ends_with('.') || word.ends_with(':')) words = 0;
  }
  return most;
}

void check(const Question& question) {
  const Numeric& number = *question.number;
  INFO(question.prompt << " " << shown(number.truth) << ", " << exactness(number));
  REQUIRE((number.digits == 0 || (number.digits >= 3 && number.digits <= 5)));
  CHECK(shown(number.truth) == question.choices.at(static_cast<std::size_t>(question.answer)));
  CHECK(is_right(number, number_from(shown(number.truth))));
  CHECK(choice_of(question, number.truth) == question.answer);
  if (number.digits == 0) CHECK(number.truth == std::round(number.truth));
  for (const WrongNumber& wrong : number.wrong) {
    INFO(shown(wrong.value) << ": " << wrong.reply);
    CHECK_FALSE(wrong.reply.empty());
    CHECK(longest_sentence(wrong.reply) <= 20);
    CHECK(std::isfinite(wrong.value));
    CHECK_FALSE(is_right(number, wrong.value));
    CHECK_FALSE(agree(number, number.truth, wrong.value));
    CHECK_FALSE(reply_to(number, wrong.value).empty());
    const bool plain_digits = wrong.value == 0 || (std::abs(wrong.value) >= 1e-4 && std::abs(wrong.value) < 1e7);
    if (plain_digits) CHECK_FALSE(is_right(number, number_from(shown(wrong.value))));
  }
}

/// Checks the numbers of a walk. Returns the prompts, without their numbers.
void check(const Walk& walk, std::set<std::string>& prompts) {
  for (const Step& step : walk.steps) {
    if (!step.question || !step.question->number) continue;
    check(*step.question);
    std::string prompt = plain(step.question->prompt);
    std::erase_if(prompt, [](char c) { return c >= '0' && c <= '9'; });
    prompts.insert(prompt.substr(0, 30));
  }
}

}  // namespace

TEST_CASE("a number asked for is taken as it is shown, and no usual wrong one is", "[every lesson]") {
  std::set<std::string> prompts;
  for (const Lesson* lesson : those_asked_for())
    for (const Preset& p : lesson->presets) {
      INFO(lesson->id << " " << p.id);
      check(lesson->walk(p.parameters), prompts);
    }
  if (those_asked_for().size() == lessons::all_lessons().size()) CHECK(prompts.size() > 25);
}

TEST_CASE("in any setting, too, no usual wrong number is taken for the right one", "[every lesson]") {
  std::set<std::string> prompts;
  for (const Lesson* lesson : those_asked_for())
    on_random_settings(lesson->id, 3, [&](const Parameters&, const Walk& walk) { check(walk, prompts); });
}

}  // namespace typed_numbers_test
