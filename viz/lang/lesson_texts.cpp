#include "viz/lang/lesson_texts.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "viz/lang/language.h"
#include "viz/lang/numbered.h"
#include "viz/text/rich_text.h"

namespace isect::viz {

namespace {

/// Returns the folder of a lesson: "sphere_sphere".
std::string subject_of(std::string lesson) {
  std::ranges::replace(lesson, '-', '_');
  return lesson;
}

/// Calls `each` with every text of a lesson that readers see.
class EachText {
 public:
  explicit EachText(std::function<void(std::string&)> each) : each_(std::move(each)) {}

  void of(Walk& walk) const {
    each_(walk.method), each_(walk.alt);
    for (Step& step : walk.steps) of(step);
  }
  void of(CaseMap& map) const {
    each_(map.x_title), each_(map.y_title), each_(map.told);
    for (std::string& branch : map.branches) each_(branch);
  }
  void of(Closing& closing) const {
    each_(closing.result), each_(closing.cost), each_(closing.choose), each_(closing.used), each_(closing.bug);
    for (std::string& source : closing.reading) each_(source);
    for (Exercise& exercise : closing.exercises) each_(exercise.prompt), each_(exercise.solution);
  }
  void of(Lesson& lesson) const {
    each_(lesson.title), each_(lesson.summary), each_(lesson.opening);
    for (Parameter& parameter : lesson.parameters) each_(parameter.label), each_(parameter.help);
    for (Preset& preset : lesson.presets) each_(preset.title);
    for (Condition& condition : lesson.conditions) each_(condition.allowed);
    for (Erratum& erratum : lesson.errata) each_(erratum.why);
  }

 private:
  void of(Step& step) const {
    each_(step.title), each_(step.caption), each_(step.formula), each_(step.source), each_(step.verdict.text);
    of(step.values);
    if (step.comparison) of(*step.comparison);
    if (step.question) of(*step.question);
    of(step.scene);
  }
  void of(std::vector<Value>& values) const {
    for (Value& value : values) each_(value.name), each_(value.unit);
  }
  void of(Comparison& comparison) const {
    each_(comparison.text), each_(comparison.meaning);
    for (Comparison& part : comparison.parts) of(part);
  }
  void of(Question& question) const {
    each_(question.prompt), each_(question.because);
    for (std::string& choice : question.choices) each_(choice);
    of(question.given);
    if (question.number)
      for (WrongNumber& wrong : question.number->wrong) each_(wrong.reply);
    if (question.line)
      for (WrongLine& wrong : question.line->wrong) each_(wrong.reply);
    if (question.order) {
      for (std::string& tile : question.order->tiles) each_(tile);
      for (WrongOrder& wrong : question.order->wrong) each_(wrong.reply);
    }
    if (question.over) of(*question.over);
  }
  void of(Scene& scene) const {
    each_(scene.said);
    for (Item& item : scene.items) {
      if (Label* const label = std::get_if<Label>(&item)) each_(label->text);
      if (Heading* const heading = std::get_if<Heading>(&item)) each_(heading->text);
    }
  }

  std::function<void(std::string&)> each_;
};

/// Returns the translation of a text: with its numbers as they are, else with any numbers.
std::optional<std::string> told_in(const std::string& subject, const std::string& language, const std::string& text) {
  if (const std::string* const whole = translation_in(subject, language, text)) return *whole;
  const Numbered any = numbered(text);
  if (any.numbers.empty()) return {};
  const std::string* const found = translation_in(subject, language, any.key);
  if (!found) return {};
  return with_numbers(*found, any.numbers);
}

/// Returns the lines of a text.
std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t end = std::min(text.find('\n', from), text.size());
    lines.push_back(text.substr(from, end - from));
    from = end + 1;
  }
  return lines;
}

/// Replaces a text by its translation: the whole, or line by line.
void translate(std::string& text, const std::string& subject, const std::string& language) {
  if (text.empty()) return;
  if (std::optional<std::string> whole = told_in(subject, language, text)) {
    text = std::move(*whole);
    return;
  }
  std::string all;
  for (const std::string& line : lines_of(text))
    all += (all.empty() ? "" : "\n") + told_in(subject, language, line).value_or(line);
  text = std::move(all);
}

EachText translating(const std::string& subject, const std::string& language) {
  return EachText([=](std::string& text) { translate(text, subject, language); });
}

/// A lesson with what it points to.
struct TranslatedLesson {
  Lesson lesson;
  Closing closing;
  CaseMap map;
};

std::unique_ptr<TranslatedLesson> translated(const Lesson& lesson, const std::string& language) {
  const EachText each = translating(subject_of(lesson.id), language);
  auto made = std::make_unique<TranslatedLesson>(TranslatedLesson{lesson, {}, {}});
  Lesson& now = made->lesson;
  now.language = language;
  each.of(now);
  now.steps = [&lesson](const Parameters& here) { return spoken_walk(lesson.id, [&] { return lesson.steps(here); }); };
  if (lesson.closing) made->closing = *lesson.closing, each.of(made->closing), now.closing = &made->closing;
  if (lesson.map) made->map = *lesson.map, each.of(made->map), now.map = &made->map;
  return made;
}

/// Whether a text has a word: three letters without a mark between them. Those of formulas have one or two.
bool has_words(const std::string& markup) {
  int letters = 0;
  for (const char c : plain(markup)) {
    letters = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ? letters + 1 : 0;
    if (letters == 3) return true;
  }
  return false;
}

/// Texts with words, in order, each once.
struct TextSet {
  std::vector<std::string> texts;
  std::set<std::string> known = {};
  void add(const std::string& text) {
    if (has_words(text) && known.insert(text).second) texts.push_back(text);
  }
};

/// Whether a language has all words of a text.
bool is_told(const std::string& subject, const std::string& language, const std::string& text) {
  if (!has_words(text) || told_in(subject, language, text)) return true;
  const std::vector<std::string> lines = lines_of(text);
  return lines.size() > 1 && std::ranges::all_of(lines, [&](const std::string& line) {
           return !has_words(line) || told_in(subject, language, line);
         });
}

/// Returns the texts with words that a lesson has in every setting, each once.
std::vector<std::string> own_texts(const Lesson& lesson) {
  TextSet all;
  const EachText each([&](std::string& text) { all.add(text); });
  Lesson own = lesson;
  each.of(own);
  if (Closing closing; lesson.closing) closing = *lesson.closing, each.of(closing);
  if (CaseMap map; lesson.map) map = *lesson.map, each.of(map);
  return std::move(all.texts);
}

/// Returns those of its walks with these settings, in English.
std::vector<std::string> texts_of_walks(const Lesson& lesson, const std::vector<Parameters>& settings) {
  const Speaking english("en");
  TextSet all;
  const EachText each([&](std::string& text) { all.add(text); });
  for (const Parameters& here : settings) {
    Walk walk = lesson.steps(here);
    each.of(walk);
  }
  return std::move(all.texts);
}

std::vector<Parameters> presets_of(const Lesson& lesson) {
  std::vector<Parameters> all;
  for (const Preset& preset : lesson.presets) all.push_back(preset.parameters);
  return all;
}

}  // namespace

const Lesson& lesson_in(const Lesson& lesson, const std::string& language) {
  if (language == "en" || !speaks(subject_of(lesson.id), language)) return lesson;
  static std::map<std::pair<const Lesson*, std::string>, std::unique_ptr<TranslatedLesson>> kept;
  static std::mutex busy;
  const std::lock_guard lock(busy);
  std::unique_ptr<TranslatedLesson>& made = kept[{&lesson, language}];
  if (!made) made = translated(lesson, language);
  return made->lesson;
}

std::string spoken_text(const Lesson& lesson, const std::string& text) {
  std::string told = text;
  if (!lesson.language.empty() && lesson.made_from.empty()) translate(told, subject_of(lesson.id), lesson.language);
  return told;
}

Walk spoken_walk(const std::string& lesson, const std::function<Walk()>& steps) {
  const std::string language = spoken(), subject = subject_of(lesson);
  if (language == "en" || !speaks(subject, language)) {
    const Speaking english("en");
    return steps();
  }
  Walk walk = steps();
  translating(subject, language).of(walk);
  return walk;
}

std::vector<std::string> untranslated(const Lesson& lesson, const std::string& language,
                                      const std::vector<Parameters>& settings) {
  std::vector<std::string> left;
  for (const std::vector<std::string>& some : {own_texts(lesson), texts_of_walks(lesson, settings)})
    std::ranges::copy_if(some, std::back_inserter(left),
                         [&](const std::string& text) { return !is_told(subject_of(lesson.id), language, text); });
  return left;
}

Coverage coverage(const Lesson& lesson, const std::string& language) {
  const std::vector<Parameters> settings = presets_of(lesson);
  const std::size_t all = own_texts(lesson).size() + texts_of_walks(lesson, settings).size();
  return {language == "en" ? all : all - untranslated(lesson, language, settings).size(), all};
}

std::vector<std::string> text_keys(const Lesson& lesson) {
  TextSet keys;
  for (const std::string& text : own_texts(lesson)) keys.add(text);
  for (const std::string& text : texts_of_walks(lesson, presets_of(lesson))) keys.add(numbered(text).key);
  return std::move(keys.texts);
}

}  // namespace isect::viz
