#include "viz/walk/step_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "viz/text/rich_text.h"
#include "viz/walk/alt_text.h"
#include "viz/walk/branch.h"
#include "viz/walk/closing.h"
#include "viz/walk/given_order.h"
#include "viz/walk/question_scene.h"

namespace isect::viz {
namespace {

std::optional<LineText> line_text(const Walk& walk, int step) {
  const int line = walk.steps[static_cast<std::size_t>(step)].line;
  if (line < 0) return {};
  return LineText{line + 1, unindented(walk.pseudocode.at(static_cast<std::size_t>(line))),
                  said_at_line(taken(walk, step))};
}

std::vector<ValueText> values_text(const std::vector<Value>& values, const std::string& formula) {
  std::vector<ValueText> all;
  const std::vector<std::string> digits = shown(values);
  const std::string told = plain(formula);
  for (std::size_t i = 0; i < digits.size(); ++i) {
    const Value& v = values[i];
    const bool in_formula = told.starts_with(plain(v.name) + " = ") && told.ends_with("= " + shown(v.value));
    all.push_back({v.name, as_markup(digits[i]), v.fresh, in_formula});
  }
  return all;
}

std::optional<ComparisonText> comparison_text(const std::optional<Comparison>& c) {
  if (!c) return {};
  return ComparisonText{fmt::format("Is {}?", c->text), c->holds, c->holds ? "Yes" : "No",
                        fmt::format("({}){}{}.", compared_numbers(*c), c->meaning.empty() ? "" : ": ", c->meaning)};
}

/// Returns the right answer, in the form in which it is asked for on paper.
std::string answer_text(const Walk& walk, const Question& q) {
  if (q.line)
    return fmt::format("Line {}: {}.", q.line->truth + 1,
                       as_markup(unindented(walk.pseudocode.at(static_cast<std::size_t>(q.line->truth)))));
  if (q.order) return right_order(*q.order) + ".";
  const auto right = static_cast<std::size_t>(q.answer);
  return fmt::format("({}) {}.", choice_letter(right), q.choices.at(right));
}

std::string with_given(const std::string& prompt, const std::vector<Value>& given) {
  return given.empty() ? prompt : prompt + " " + given_text(given);
}

}  // namespace

StepText step_text(const Lesson& lesson, const Walk& walk, int step) {
  const Step& s = walk.steps.at(static_cast<std::size_t>(step));
  return {s.title,
          s.caption,
          own_caption(lesson, s),
          s.formula,
          line_text(walk, step),
          values_text(s.values, s.formula),
          comparison_text(s.comparison),
          s.verdict,
          s.source,
          question_text(walk, step)};
}

std::optional<QuestionText> question_text(const Walk& walk, int step) {
  const auto asked = walk.steps.begin() + step;
  if (!asked->question) return {};
  const Question& q = *asked->question;
  std::vector<Value> known = known_values(walk, step);
  QuestionText text;
  text.number = 1 + static_cast<int>(
                        std::count_if(walk.steps.begin(), asked, [](const Step& s) { return s.question.has_value(); }));
  text.prompt = with_given(q.prompt, q.given);
  text.whole_prompt = with_given(q.prompt, known);
  known.resize(known.size() - q.given.size());
  text.known = values_text(known, {});
  text.choices = q.choices;
  text.right = static_cast<std::size_t>(q.answer);
  text.answer = answer_text(walk, q);
  text.because = q.because;
  text.asked = &q;
  return text;
}

std::vector<ErratumText> errata_text(const Lesson& lesson, const Walk& walk) {
  std::vector<ErratumText> all;
  for (const Erratum& e : lesson.errata) {
    const int line = line_of(e, walk);
    if (line < 0) continue;
    const bool published = walk.pseudocode[line] == e.published;
    const bool added = !published && std::ranges::count(walk.pseudocode, e.published) > 0;
    const std::string other = as_markup(unindented(published ? e.corrected : e.published));
    all.push_back(
        {line + 1,
         added ? fmt::format("Line {} is not in the note.", line + 1)
               : fmt::format("Line {} {}: {}.", line + 1, published ? "should read" : "was published as", other),
         e.why, &preset(lesson, e.preset)});
  }
  return all;
}

std::string with_preset(const ErratumText& e, std::string Preset::*name) {
  return fmt::format("{} {} (See the preset “{}”.)", e.says, e.why, e.shown_by->*name);
}

std::string compared_numbers(const Comparison& c) {
  std::string all;
  for (const Comparison& part : c.parts)
    all += fmt::format("{}{}: {}, {}", all.empty() ? "" : "; ", part.text, part.holds ? "yes" : "no",
                       compared_numbers(part));
  if (!all.empty()) return all;
  const auto [left, right] = shown_apart(c.left, c.right);
  return as_markup(fmt::format("{} against {}", left, right));
}

std::string verdict_text(const Verdict& v) {
  return v.text.empty() || v.exact.empty() ? v.text : fmt::format("{} (exactly: {})", v.text, v.exact);
}

char choice_letter(std::size_t i) { return static_cast<char>('a' + i); }

std::string given_text(const std::vector<Value>& values) { return fmt::format("Given: {}.", listed(values)); }

std::string figure_caption(const Lesson& lesson, const Step& step, const std::string& title) {
  std::string text = as_sentence(title.empty() ? step.title : title) + " " + own_caption(lesson, step);
  std::ranges::replace(text, '\n', ' ');
  return text;
}

}  // namespace isect::viz
