#include "app/pages/blocks.h"

#include <fmt/format.h>

#include <map>
#include <set>

#include "viz/alt_text.h"
#include "viz/names.h"
#include "viz/rich_text.h"
#include "viz/snapshot.h"

namespace isect::program {

char choice_letter(std::size_t i) { return static_cast<char>('a' + i); }

std::vector<std::string> paragraphs(const std::string& markup) {
  std::vector<std::string> all;
  for (std::size_t from = 0; from < markup.size();) {
    const std::size_t end = std::min(markup.find('\n', from), markup.size());
    if (end > from) all.push_back(markup.substr(from, end - from));
    from = end + 1;
  }
  return all;
}

std::string prompt(const viz::Question& q) {
  return q.given.empty() ? q.prompt : fmt::format("{} Given: {}.", q.prompt, viz::listed(q.given));
}

Blocks question(const viz::Question& q, int number) {
  return {Prose{prompt(q), fmt::format("Question {}.", number)}, Choices{q.choices}};
}

std::string answer(const viz::Question& q) {
  const auto right = static_cast<std::size_t>(q.answer);
  return fmt::format("({}) {}. {}", choice_letter(right), q.choices.at(right), q.because);
}

Image image(const Excerpt& e, int step) {
  return {viz::file_stem(step, e.walk.steps[step]), {}, viz::alt_text(*e.lesson, e.parameters, e.walk, step)};
}

namespace {

/// The names of a lesson's texts, and which of them are bold there.
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

/// "t_max" as *t*_{max}
std::string name_as_markup(const std::string& name, bool bold) {
  const std::size_t end = std::min(name.find('_'), name.size());
  const std::string mark = bold ? "**" : "*", letters = mark + viz::as_markup(name.substr(0, end)) + mark;
  if (end == name.size()) return letters;
  const std::string index = viz::as_markup(name.substr(end + 1));
  const bool counts = index == "i" || index == "j" || index == "k";
  return letters + (counts ? "_{*" + index + "*}" : "_{" + index + "}");
}

}  // namespace

Code code(const Excerpt& e, int current) {
  const std::map<std::string, bool> bold = names_of_texts(*e.lesson, e.walk);
  std::set<std::string> known;
  for (const auto& [name, unused] : bold) known.insert(name);
  Code code = {{}, current};
  for (const std::string& line : e.walk.pseudocode) {
    std::string markup;
    std::size_t at = 0;
    for (const viz::Name& name : viz::names_in_line(line, known)) {
      markup += viz::as_markup(line.substr(at, name.begin - at));
      const bool squared = line.compare(name.end, 2, "²") == 0;  // a number then, of a vector too
      markup += name_as_markup(line.substr(name.begin, name.end - name.begin), bold.at(name.key) && !squared);
      at = name.end;
    }
    code.lines.push_back(markup + viz::as_markup(line.substr(at)));
  }
  return code;
}

}  // namespace isect::program
