#include "app/figures/blocks.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

#include "app/figures/value_words.h"
#include "viz/lang/language.h"
#include "viz/lang/message.h"
#include "viz/text/names.h"
#include "viz/text/rich_text.h"
#include "viz/walk/scene_in_words.h"

namespace isect::program {

std::vector<std::string> paragraphs(const std::string& markup) {
  std::vector<std::string> all;
  for (std::size_t from = 0; from < markup.size();) {
    const std::size_t end = std::min(markup.find('\n', from), markup.size());
    if (end > from) all.push_back(markup.substr(from, end - from));
    from = end + 1;
  }
  return all;
}

std::string given(const viz::Lesson& lesson, const viz::Parameters& parameters, const viz::Walk& walk) {
  const viz::Speaking speaking(lesson.language);
  std::vector<std::string> all;
  bool rounded = false;
  for (const viz::Parameter& p : lesson.parameters) {
    if (!parameters.contains(p.name) || p.name == lesson.group_by || !viz::counts(p, parameters)) continue;
    const viz::Setting& setting = parameters.at(p.name);
    const bool known = std::ranges::any_of(lesson.presets, [&](const viz::Preset& preset) {
      const auto found = preset.parameters.find(p.name);
      return found != preset.parameters.end() && found->second == setting;
    });
    rounded = rounded || (!known && rounded_in_words(setting));
    std::string value = known ? in_words_and_full(setting, lesson.flat) : in_words(setting, lesson.flat);
    for (std::size_t at = 0; (at = value.find(' ', at)) != value.npos;) value.replace(at, 1, "\u00a0");  // no line ends
    all.push_back(
        fmt::format("{}\u00a0=\u00a0{}", p.label.empty() ? viz::as_markup(p.name) : p.label, viz::as_markup(value)));
  }
  std::string out = fmt::format("{}.", fmt::join(all, ", "));
  if (rounded) out += " " + viz::tr("Some numbers are rounded.");
  const viz::Scene& scene = walk.steps.front().scene;
  if (!scene.chart)
    for (const std::string& object : viz::scene_in_words(scene, parameters, lesson.flat))
      out += " " + viz::as_markup(viz::with_minus_signs(object.ends_with(".") ? object : object + "."));
  return out;
}

std::string prompt(const viz::Exercise& e) {
  return e.preset.empty() ? e.prompt : e.prompt + " " + viz::tr("(Preset {preset}.)", {{"preset", e.preset}});
}

Blocks question(const viz::QuestionText& q, const std::string& head) {
  const Prose asks = {q.whole_prompt, head};
  if (q.asked->line) return {asks, Blanks{viz::tr("Line"), 1}};
  if (const auto& order = q.asked->order)
    return {asks, Choices{order->tiles}, Blanks{viz::tr("Order"), static_cast<int>(order->tiles.size())}};
  return {asks, Choices{q.choices}};
}

Prose answer(const viz::QuestionText& q, const std::string& head) { return {q.answer + " " + q.because, head}; }

namespace {

/// Returns the names in a lesson's texts, and whether they are bold there.
std::map<std::string, bool> names_of_texts(const viz::Lesson& lesson, const viz::Walk& walk) {
  std::map<std::string, bool> bold;
  const auto add = [&](const std::string& markup) {
    for (const viz::Name& name : viz::names_in(markup)) bold.emplace(name.key, name.vector);
  };
  for (const viz::Parameter& parameter : lesson.parameters) add(parameter.label);
  for (const viz::Step& step : walk.steps) {
    for (const std::string& text : {step.title, step.caption, step.formula, step.verdict.text}) add(text);
    for (const viz::Value& value : step.values) add(value.name);
  }
  return bold;
}

/// Returns "t_max" as *t*_{max}.
std::string name_as_markup(const std::string& name, bool bold) {
  const std::size_t end = std::min(name.find('_'), name.size());
  const std::string mark = bold ? "**" : "*", letters = mark + viz::as_markup(name.substr(0, end)) + mark;
  if (end == name.size()) return letters;
  const std::string index = viz::as_markup(name.substr(end + 1));
  const bool counts = index == "i" || index == "j" || index == "k";
  return letters + (counts ? "_{*" + index + "*}" : "_{" + index + "}");
}

/// Returns pseudocode with its names set as in the texts of a lesson's walk.
Code code(const std::vector<std::string>& pseudocode, const viz::Lesson& lesson, const viz::Walk& walk) {
  const std::map<std::string, bool> bold = names_of_texts(lesson, walk);
  std::set<std::string> known;
  for (const auto& [name, unused] : bold) known.insert(name);
  Code code;
  for (const std::string& line : pseudocode) {
    std::string markup;
    std::size_t at = 0;
    for (const viz::Name& name : viz::names_in_line(line, known)) {
      markup += viz::as_markup(line.substr(at, name.begin - at));
      const bool squared = line.compare(name.end, 2, "²") == 0;  // then it is a number, even for a vector
      markup += name_as_markup(line.substr(name.begin, name.end - name.begin), bold.at(name.key) && !squared);
      at = name.end;
    }
    code.lines.push_back(markup + viz::as_markup(line.substr(at)));
  }
  return code;
}

}  // namespace

Code code(const Excerpt& e, const std::optional<viz::LineText>& lit) {
  Code all = code(e.walk.pseudocode, *e.lesson, e.walk);
  if (lit) all.current = lit->number - 1, all.said = lit->said;
  return all;
}

Code line_alone(const Excerpt& e, const viz::LineText& line) {
  Code alone = code({line.code}, *e.lesson, e.walk);
  alone.current = 0, alone.said = line.said, alone.first = line.number;
  return alone;
}

Blocks shown_program(const viz::Lesson& lesson, const viz::Exercise& e) {
  if (e.program.empty()) return {};
  return {code(e.program, lesson, lesson.walk(viz::preset(lesson, e.preset).parameters))};
}

Blocks exercise(const viz::Lesson& lesson, const viz::Exercise& e, const std::string& head) {
  Blocks all = shown_program(lesson, e);
  all.insert(all.begin(), Prose{prompt(e), head});
  return all;
}

Blocks algorithm(const Excerpt& e) {
  if (e.walk.pseudocode.empty()) return {};
  Blocks all = {code(e)};
  for (const viz::ErratumText& erratum : viz::errata_text(*e.lesson, e.walk))
    all.push_back(Prose{viz::with_preset(erratum, &viz::Preset::id)});
  return all;
}

}  // namespace isect::program
