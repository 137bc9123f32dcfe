// The prompts of all lessons as a whole: at most half are plain choices, and few can be read off the step before.

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "tests/catch.h"
#include "tests/lessons/asked_for.h"
#include "viz/text/rich_text.h"
#include "viz/walk/step_text.h"

namespace prompts_test {
using namespace isect;
using namespace isect::viz;

namespace {

/// What a question asks a reader to do.
std::string kind_of(const Question& question) {
  if (question.number) return question.number->digits == 0 ? "count" : "number";
  return question.line ? "line" : question.order ? "order" : "choice";
}

/// All that a step displays in words and numbers, each as plain text: its text, its values, its labels.
std::vector<std::string> displayed(const Lesson& lesson, const Walk& walk, int step) {
  const StepText text = step_text(lesson, walk, step);
  std::vector<std::string> all = {text.title, text.caption, text.formula, text.verdict.text};
  if (text.line) all.push_back(as_markup(text.line->code));
  for (const ValueText& value : text.values) all.push_back(value.name + " = " + value.digits);
  if (text.comparison) all.insert(all.end(), {text.comparison->question, text.comparison->why});
  for (const Item& item : walk.steps[static_cast<std::size_t>(step)].scene.items) {
    if (const Label* label = std::get_if<Label>(&item)) all.push_back(label->text);
    if (const Heading* heading = std::get_if<Heading>(&item)) all.push_back(heading->text);
  }
  for (std::string& part : all) {
    part = plain(part);
    for (const std::string quote : {"“", "”"})  // a quoted word is whole
      for (std::size_t at; (at = part.find(quote)) != std::string::npos;) part.replace(at, quote.size(), " ");
  }
  return all;
}

/// Whether the character at this place goes on with a word or a number: of "1.5" the 1 alone is none.
bool goes_on(const std::string& text, std::size_t at) {
  if (at >= text.size()) return false;
  const auto c = static_cast<unsigned char>(text[at]);
  if (c == '.') return at + 1 < text.size() && std::isdigit(static_cast<unsigned char>(text[at + 1]));
  return std::isalnum(c) || c == '_' || c >= 0x80;  // a minus sign, an index, an accent
}

/// Whether these words, or this number, stand in the text, and not as a part of others.
bool stands_in(const std::string& text, const std::string& words) {
  for (std::size_t at = text.find(words); at != std::string::npos; at = text.find(words, at + 1)) {
    const bool begins = at == 0 || (!goes_on(text, at - 1) && text[at - 1] != '.');
    if (begins && !goes_on(text, at + words.size())) return true;
  }
  return false;
}

/// Whether an answer stands somewhere on display. One of a single letter or digit says nothing: these stand everywhere.
bool is_displayed(const std::string& answer, const std::vector<std::string>& texts) {
  const std::string words = plain(answer);
  return words.size() > 1 &&
         std::ranges::any_of(texts, [&](const std::string& text) { return stands_in(text, words); });
}

/// Whether the step before a question displays its right answer, and no wrong one: then it can be copied.
bool can_be_read_off(const Lesson& lesson, const Walk& walk, int step) {
  const Question& question = *walk.steps[static_cast<std::size_t>(step)].question;
  const std::vector<std::string> texts = displayed(lesson, walk, step - 1);
  for (std::size_t i = 0; i < question.choices.size(); ++i)
    if (is_displayed(question.choices[i], texts) != (static_cast<int>(i) == question.answer)) return false;
  return true;
}

/// Calls see(lesson, preset, walk, step) at each question of the lessons asked for.
template <class See>
void at_each_question(const See& see) {
  for (const Lesson* lesson : those_asked_for())
    for (const Preset& preset : lesson->presets) {
      const Walk walk = lesson->walk(preset.parameters);
      for (int k = 1; k < static_cast<int>(walk.steps.size()); ++k)
        if (walk.steps[static_cast<std::size_t>(k)].question) see(*lesson, preset, walk, k);
    }
}

}  // namespace

TEST_CASE("an answer stands in a text as a whole word or number alone", "[words]") {
  CHECK((stands_in("t = 1.5, at once", "1.5") && stands_in("It is 1.5.", "1.5") && stands_in("1.5", "1.5")));
  CHECK_FALSE((stands_in("t = −1.5", "1.5") || stands_in("21.5", "1.5") || stands_in("1.55", "1.5")));
  CHECK_FALSE((stands_in("2.1.5", "1.5") || stands_in("d²", "d") || stands_in("1.25", "25")));
  CHECK((stands_in("The answer: DISJOINT.", "DISJOINT") && stands_in("(a miss)", "a miss")));
  CHECK_FALSE(is_displayed("1", {"1 and 2"}));
}

TEST_CASE("at most half of all prompts are plain choices", "[every lesson]") {
  std::map<std::string, int> kinds;
  int all = 0;
  at_each_question([&](const Lesson&, const Preset&, const Walk& walk, int k) {
    ++kinds[kind_of(*walk.steps[static_cast<std::size_t>(k)].question)];
    ++all;
  });
  if (those_asked_for().size() != lessons::all_lessons().size()) return;
  std::string told;
  for (const auto& [kind, count] : kinds) told += fmt::format("{}: {}, ", kind, count);
  INFO(told << "of " << all);
  CHECK(2 * kinds["choice"] <= all);
  for (const char* kind : {"number", "count", "line", "order"}) CHECK(kinds[kind] > 0);
}

TEST_CASE("at most one prompt in ten can be read off the step before", "[every lesson]") {
  int all = 0, copied = 0;
  std::string told;
  at_each_question([&](const Lesson& lesson, const Preset& preset, const Walk& walk, int k) {
    ++all;
    if (!can_be_read_off(lesson, walk, k)) return;
    ++copied;
    const Step& step = walk.steps[static_cast<std::size_t>(k)];
    told += fmt::format("{} {}, {}: {}\n", lesson.id, preset.id, step.slug, plain(step.question->prompt));
  });
  if (those_asked_for().size() != lessons::all_lessons().size()) return;
  INFO(told << copied << " of " << all);
  CHECK(10 * copied <= all);
}

}  // namespace prompts_test
