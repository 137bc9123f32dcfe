#include "viz/walk/step_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "viz/lang/language.h"
#include "viz/lang/message.h"
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
  return ComparisonText{tr("Is {condition}?", {{"condition", c->text}}), c->holds, c->holds ? tr("Yes") : tr("No"),
                        fmt::format("({}){}{}.", compared_numbers(*c), c->meaning.empty() ? "" : ": ", c->meaning)};
}

/// Returns the right answer, in the form in which it is asked for on paper.
std::string answer_text(const Walk& walk, const Question& q) {
  if (q.line)
    return tr("Line {n}: {line}.",
              {{"n", std::to_string(q.line->truth + 1)},
               {"line", as_markup(unindented(walk.pseudocode.at(static_cast<std::size_t>(q.line->truth))))}});
  if (q.order) return right_order(*q.order) + ".";
  const auto right = static_cast<std::size_t>(q.answer);
  return fmt::format("({}) {}.", choice_letter(right), q.choices.at(right));
}

std::string with_given(const std::string& prompt, const std::vector<Value>& given) {
  return given.empty() ? prompt : prompt + " " + given_text(given);
}

}  // namespace

StepText step_text(const Lesson& lesson, const Walk& walk, int step) {
  const Speaking speaking(lesson.language);
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
  const Speaking speaking(lesson.language);
  std::vector<ErratumText> all;
  for (const Erratum& e : lesson.errata) {
    const int line = line_of(e, walk);
    if (line < 0) continue;
    const bool published = walk.pseudocode[line] == e.published;
    const bool added = !published && std::ranges::count(walk.pseudocode, e.published) > 0;
    const std::string other = as_markup(unindented(published ? e.corrected : e.published));
    const std::string n = std::to_string(line + 1);
    all.push_back({line + 1,
                   added       ? tr("Line {n} is not in the note.", {{"n", n}})
                   : published ? tr("Line {n} should read: {line}.", {{"n", n}, {"line", other}})
                               : tr("Line {n} was published as: {line}.", {{"n", n}, {"line", other}}),
                   e.why, &preset(lesson, e.preset)});
  }
  return all;
}

std::string with_preset(const ErratumText& e, std::string Preset::*name) {
  return e.says + " " + e.why + " " + tr("(See the preset “{preset}”.)", {{"preset", e.shown_by->*name}});
}

std::string compared_numbers(const Comparison& c) {
  std::string all;
  for (const Comparison& part : c.parts)
    all += fmt::format("{}{}: {}, {}", all.empty() ? "" : "; ", part.text, part.holds ? tr("yes") : tr("no"),
                       compared_numbers(part));
  if (!all.empty()) return all;
  const auto [left, right] = shown_apart(c.left, c.right);
  return as_markup(tr("{p} against {q}", {{"p", left}, {"q", right}}));
}

std::string verdict_text(const Verdict& v) {
  return v.text.empty() || v.exact.empty()
             ? v.text
             : tr("{verdict} (exactly: {exact})", {{"verdict", v.text}, {"exact", v.exact}});
}

char choice_letter(std::size_t i) { return static_cast<char>('a' + i); }

std::string given_text(const std::vector<Value>& values) {
  return tr("Given: {numbers}.", {{"numbers", listed(values)}});
}

std::string figure_caption(const Lesson& lesson, const Step& step, const std::string& title) {
  std::string text = as_sentence(title.empty() ? step.title : title) + " " + own_caption(lesson, step);
  std::ranges::replace(text, '\n', ' ');
  return text;
}

}  // namespace isect::viz
