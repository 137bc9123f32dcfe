#include "viz/lang/lesson_texts.h"

#include <algorithm>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <utility>
#include <vector>

#include "viz/lang/language.h"
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

/// Replaces a text by its translation: the whole, or line by line.
void translate(std::string& text, const std::string& subject, const std::string& language) {
  if (text.empty()) return;
  if (const std::string* const whole = translation_in(subject, language, text)) {
    text = *whole;
    return;
  }
  if (text.find('\n') == text.npos) return;
  std::string all;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t end = std::min(text.find('\n', from), text.size());
    const std::string line = text.substr(from, end - from);
    const std::string* const told = translation_in(subject, language, line);
    all += (from == 0 ? "" : "\n") + (told ? *told : line);
    from = end + 1;
  }
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

/// Returns all texts of a lesson, in an order that is the same in every language.
std::vector<std::string> texts_of(const Lesson& lesson) {
  std::vector<std::string> all;
  const EachText each([&](std::string& text) { all.push_back(text); });
  Lesson own = lesson;
  each.of(own);
  if (Closing closing; lesson.closing) closing = *lesson.closing, each.of(closing);
  if (CaseMap map; lesson.map) map = *lesson.map, each.of(map);
  for (const Preset& preset : lesson.presets) {
    Walk walk = lesson.steps(preset.parameters);
    each.of(walk);
  }
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

Coverage coverage(const Lesson& lesson, const std::string& language) {
  const std::vector<std::string> english = texts_of(lesson);
  std::set<std::string> all, left;
  const Lesson& other = lesson_in(lesson, language);
  const bool same = &other == &lesson;
  std::vector<std::string> told = english;
  if (!same) {
    const Speaking speaking(language);
    told = texts_of(other);
  }
  for (std::size_t i = 0; i < english.size(); ++i) {
    if (!has_words(english[i])) continue;
    all.insert(english[i]);
    if (language != "en" && told[i] == english[i] && !translation_in(subject_of(lesson.id), language, english[i]))
      left.insert(english[i]);
  }
  return {all.size() - left.size(), all.size()};
}

}  // namespace isect::viz
