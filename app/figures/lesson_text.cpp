#include "app/figures/lesson_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <vector>

#include "app/figures/blocks.h"
#include "app/figures/lesson_opening.h"
#include "app/shell/terminal.h"
#include "viz/chart/case_map.h"
#include "viz/chart/chart.h"
#include "viz/lang/language.h"
#include "viz/lang/lesson_texts.h"
#include "viz/lang/message.h"
#include "viz/text/rich_text.h"
#include "viz/text/utf8.h"
#include "viz/walk/alt_text.h"
#include "viz/walk/closing.h"
#include "viz/walk/exercise_text.h"
#include "viz/walk/step_text.h"

namespace isect::program {

namespace {

using viz::count_characters;
using viz::plain;

/// Returns "Title" over a line of `rule`.
std::string heading(const std::string& text, char rule, std::size_t width) {
  return inked(Ink::bold, wrapped(text, width, 0)) + std::string(std::min(count_characters(text), width), rule) + "\n";
}

/// Returns what is listed below a question: its choices, or the things to put in order.
std::vector<std::string> offered_by(const viz::QuestionText& q) {
  if (q.asked->line) return {};
  return q.asked->order ? q.asked->order->tiles : q.choices;
}

/// Who judges a reader's own program; its command as it is typed.
std::string judge_text(const viz::Lesson& lesson, std::size_t columns) {
  const std::optional<viz::Judge> own = viz::judge(lesson);
  if (!own) return {};
  std::string out = wrapped(plain(own->told), columns, 0);
  for (const std::string& line : own->command) out += "  " + line + "\n";
  return out;
}

class LessonWriter {
 public:
  LessonWriter(const Excerpt& e, const TextOptions& how) : e_(e), how_(how) {}

  std::string all() {
    std::string out = opening();
    for (const int step : e_.steps) out += how_.brief ? line_of(step) : whole(step);
    if (!answers_.empty()) out += heading(viz::tr("Answers"), '-', how_.columns) + answers_ + "\n";
    if (out.ends_with("\n\n")) out.pop_back();
    return out;
  }

 private:
  std::string paragraph(const std::string& text, std::size_t indent = 0) const {
    return wrapped(text, how_.columns, indent);
  }

  std::string opening() const {
    const viz::Lesson& lesson = *e_.lesson;
    std::string out =
        heading(fmt::format("{}: {}", plain(lesson.title), e_.folder), '=', how_.columns) + paragraph(lesson.summary);
    if (!e_.walk.method.empty()) out += paragraph(viz::tr("Method: {method}", {{"method", plain(e_.walk.method)}}));
    return out + "\n" + lesson_opening(e_, how_);
  }

  viz::StepText text_of(int index) const { return viz::step_text(*e_.lesson, e_.walk, index); }

  std::string title(int index) const {
    return viz::tr("Step {n} of {all}: {title}", {{"n", std::to_string(index + 1)},
                                                  {"all", std::to_string(e_.walk.steps.size())},
                                                  {"title", plain(e_.walk.steps[index].title)}});
  }

  static std::string first_sentence(const std::string& text) {
    const std::size_t line = std::min(text.find('\n'), text.size()), stop = text.find(". ");
    return text.substr(0, std::min(line, stop == std::string::npos ? line : stop + 1));
  }

  /// Returns what a step decides or computes; else the first sentence of its caption.
  std::string line_of(int index) const {
    const viz::Step& step = e_.walk.steps[index];
    const viz::StepText told = text_of(index);
    std::string out = viz::as_sentence(title(index)) + " ";
    if (step.slug == viz::closing_slug) return paragraph(out + plain(e_.lesson->closing->result));
    if (step.slug == viz::case_map_slug) return paragraph(out + viz::tr("This setting: {case}.", {{"case", branch()}}));
    const std::string formula = plain(step.formula);
    const bool decided = !step.verdict.text.empty();
    if (!formula.empty() && formula != plain(step.title)) out += viz::as_sentence(formula) + " ";
    if (told.comparison) out += in_words(*told.comparison);
    if (formula.empty() && !step.comparison && !decided) out += first_sentence(plain(step.caption));
    if (decided)
      out += " " + viz::tr("Verdict: {verdict}", {{"verdict", plain(viz::verdict_text(step.verdict))}}) + ".";
    return paragraph(out);
  }

  std::string whole(int index) {
    const viz::Step& step = e_.walk.steps[index];
    const viz::StepText told = text_of(index);
    std::string out = told.question ? question(*told.question, index) : "";  // a title may tell the answer
    if (told_ && goes_on(*std::exchange(told_, &step), step)) return out + again(told, index);
    told_ = &step;
    out += heading(title(index), '-', how_.columns);
    if (step.slug == viz::closing_slug) return out + closing();
    out += paragraph(step.slug == viz::case_map_slug ? map_in_words() : plain(told.caption)) + "\n";
    if (told.line) out += line(*told.line);
    if (!told.formula.empty()) out += paragraph(plain(told.formula), 5) + "\n";
    out += values(told.values, index == e_.steps.front()) + points(step) + rows(step);
    if (told.comparison) out += paragraph(in_words(*told.comparison)) + "\n";
    if (!told.verdict.text.empty())
      out += inked(Ink::bold,
                   paragraph(viz::tr("Verdict: {verdict}", {{"verdict", plain(viz::verdict_text(told.verdict))}}))) +
             "\n";
    if (index == viz::outcome(e_.walk))
      out += paragraph(viz::tr("Picture: {alt}", {{"alt", plain(e_.walk.alt)}})) + "\n" + side_by_side();
    return out + source(told);
  }

  /// Returns the source if it differs from the one before.
  std::string source(const viz::StepText& told) {
    if (told.source.empty() || told.source == source_) return {};
    source_ = told.source;
    return paragraph(viz::tr("Source: {source}", {{"source", source_}})) + "\n";
  }

  /// Whether a step does the same at the same line as the one before, with other numbers.
  static bool goes_on(const viz::Step& before, const viz::Step& step) {
    return step.line >= 0 && step.line == before.line &&
           without_numbers(step.caption) == without_numbers(before.caption) && step.verdict.text == before.verdict.text;
  }
  static std::string without_numbers(std::string text) {
    std::erase_if(text, [](char c) { return (c >= '0' && c <= '9') || c == '.' || c == ','; });
    return text;
  }

  /// Returns such a step in one paragraph: what is new.
  std::string again(const viz::StepText& told, int index) {
    const viz::Step &step = e_.walk.steps[index], &before = e_.walk.steps[index - 1];
    std::string out = viz::as_sentence(title(index));
    if (step.caption != before.caption) out += " " + plain(told.caption);
    if (!told.formula.empty()) out += " " + plain(told.formula) + ".";
    for (const viz::ValueText& v : told.values)
      if (const std::string value = plain(v.name + " = " + v.digits);
          v.fresh && !v.in_formula && plain(told.title) != value)
        out += " " + value + ".";
    if (told.comparison)
      out += " " + in_words(*told.comparison);
    else if (told.line && !told.line->said.empty())
      out += " " + viz::tr("Line {n}: {line}.", {{"n", std::to_string(told.line->number)}, {"line", told.line->said}});
    std::ranges::replace(out, '\n', ' ');
    return paragraph(out) + "\n" + points(step);
  }

  static std::string line(const viz::LineText& line) {
    const std::string said = line.said.empty() ? "" : fmt::format("   ({})", line.said);
    return inked(Ink::mark, fmt::format("  ▸ {}:  {}{}", viz::tr("line {n}", {{"n", std::to_string(line.number)}}),
                                        line.code, said)) +
           "\n\n";
  }

  /// Returns the values that a step computes, or `all`: known ones were told before, so only the first step told has
  /// them.
  static std::string values(std::vector<viz::ValueText> told, bool all) {
    std::erase_if(told, [&](const viz::ValueText& v) { return v.in_formula || !(v.fresh || all); });
    std::size_t widest = 0;
    for (const viz::ValueText& v : told) widest = std::max(widest, count_characters(plain(v.name)));
    std::string out;
    for (const viz::ValueText& v : told) {
      const std::string name = plain(v.name);
      out += fmt::format("     {}{} = {}\n", std::string(widest - count_characters(name), ' '), name, plain(v.digits));
    }
    return out.empty() ? out : out + "\n";
  }

  /// Returns where the points lie that the picture names and that are no parameters, when they first appear.
  std::string points(const viz::Step& step) {
    const auto five_digits = [&](const viz::Vec3& p) {
      const std::string xy = viz::shown(p.x()) + ", " + viz::shown(p.y());
      return "(" + xy + (e_.lesson->flat ? ")" : ", " + viz::shown(p.z()) + ")");
    };
    std::string list;
    for (const viz::Item& item : step.scene.items) {
      const auto* label = std::get_if<viz::Label>(&item);
      if (!label || label->until || !label->text.starts_with("**") || !is_marked(step.scene, label->at)) continue;
      const std::string told = plain(label->text) + " " + five_digits(label->at);
      if (label->text.ends_with("′")) continue;  // an image: where it is drawn is not where it lies
      if (is_parameter(label->at) || !placed_.insert(told).second) continue;
      list += (list.empty() ? "" : ", ") + told;
    }
    return list.empty() ? list : paragraph(viz::tr("In the picture: {list}.", {{"list", list}})) + "\n";
  }

  /// Returns the rows of a card.
  std::string rows(const viz::Step& step) const {
    std::string out;
    if (viz::is_card(step.scene))
      for (const viz::Card::Row& row : std::get<viz::Card>(step.scene.chart->kind).rows)
        out += paragraph(plain(row.head) + ": " + plain(row.text), 5);
    return out.empty() ? out : out + "\n";
  }

  bool is_parameter(const viz::Vec3& p) const {
    return std::ranges::any_of(e_.parameters, [&](const auto& given) { return given.second == viz::Setting(p); });
  }

  static bool is_marked(const viz::Scene& scene, const viz::Vec3& at) {
    return std::ranges::any_of(scene.items, [&](const viz::Item& item) {
      const auto* dot = std::get_if<viz::Dot>(&item);
      const auto* edge = std::get_if<viz::Line>(&item);  // the edge asked for
      return (dot && dot->at == at) ||
             (edge && edge->pen == viz::Pen::highlight && (edge->from == at || edge->to == at));
    });
  }

  static std::string in_words(const viz::ComparisonText& c) {
    return plain(fmt::format("{} {} {}", c.question, c.answer, c.why));
  }

  std::string map_in_words() const {
    const viz::CaseMap& map = *e_.lesson->map;
    std::string regions;
    for (const std::string& branch : map.branches) regions += (regions.empty() ? "" : "; ") + plain(branch);
    return viz::tr("A map of all cases. Across: {x}. Up: {y}.",
                   {{"x", plain(map.x_title)}, {"y", plain(map.y_title)}}) +
           "\n" + plain(map.told) + "\n" + viz::tr("The lesson's cases: {cases}.", {{"cases", regions}}) + "\n" +
           viz::tr("This setting: {case}.", {{"case", branch()}});
  }
  /// Returns where this setting lies on the lesson's map.
  std::string branch() const {
    const viz::CaseMap& map = *e_.lesson->map;
    return plain(map.branches.at(static_cast<std::size_t>(map.branch(e_.parameters))));
  }

  /// Returns what the methods say that should agree.
  std::string side_by_side() const {
    if (!e_.lesson->opinions) return {};
    std::vector<viz::Opinion> opinions = e_.lesson->opinions(e_.parameters);
    for (viz::Opinion& o : opinions)
      o.method = viz::spoken_text(*e_.lesson, o.method), o.says = viz::spoken_text(*e_.lesson, o.says);
    if (opinions.empty()) return {};
    std::size_t widest = 0;
    for (const viz::Opinion& o : opinions) widest = std::max(widest, count_characters(plain(o.method)));
    std::string out = viz::tr("Methods side by side:") + "\n";
    for (const viz::Opinion& o : opinions) {
      const std::string method = plain(o.method);
      std::string row = fmt::format(" {} {}{}  {}", o.agrees ? "✓" : "✗", method,
                                    std::string(widest - count_characters(method), ' '), plain(o.says));
      if (count_characters(row) > how_.columns)
        row = fmt::format(" {} {}:\n", o.agrees ? "✓" : "✗", method) + paragraph(plain(o.says), 5);
      else
        row += "\n";
      out += o.agrees ? row : inked(Ink::bold, row);
    }
    return out + "\n";
  }

  /// Returns the question. What is known was told before it; if the step before was not, it comes with the question.
  std::string question(const viz::QuestionText& q, int index) {
    const bool known = index == 0 || told_ == &e_.walk.steps[index - 1];
    const std::vector<std::string> offered = offered_by(q);
    const bool again = !offered.empty() && question_ && offered_by(*question_) == offered;
    const bool same_reason = again && question_->because == q.because;
    question_ = q;
    const std::string head = viz::tr("Question {n}:", {{"n", std::to_string(q.number)}}) + " ";
    std::string out = paragraph(head + plain(known ? q.prompt : q.whole_prompt) +
                                (again ? " " + viz::tr("(The same choices.)") : ""));
    for (std::size_t i = 0; i < offered.size() && !again; ++i)
      out += paragraph(fmt::format("({}) {}", viz::choice_letter(i), plain(offered[i])), 4);
    if (q.asked->line) out += paragraph(viz::tr("Name a line of the algorithm."), 4);
    if (q.asked->order) out += paragraph(viz::tr("Put them in order."), 4);
    const std::string answer = plain(q.answer + (same_reason ? "" : " " + q.because));
    if (how_.answers) return out + paragraph(viz::tr("Answer: {answer}", {{"answer", answer}})) + "\n";
    answers_ += paragraph(head + answer);
    return out + "\n";
  }

  std::string closing() {
    const viz::Closing& c = *e_.lesson->closing;
    std::string out;
    for (const auto& [head, text] : viz::card_rows(*e_.lesson)) out += paragraph(head + ": " + plain(text));
    out += paragraph(viz::tr("See it: {option}", {{"option", "--preset " + c.bug_preset}}), 2) + "\n" +
           viz::tr("To read:") + "\n";
    for (const std::string& source : c.reading) out += paragraph(plain(source), 2);
    out += "\n";
    for (std::size_t i = 0; i < c.exercises.size(); ++i) {
      const viz::Exercise& e = c.exercises[i];
      out += paragraph(viz::tr("Exercise {n}: {text}", {{"n", std::to_string(i + 1)}, {"text", plain(prompt(e))}})) +
             numbered(e.program, how_.columns);
      const std::string solution = plain(e.solution);
      if (how_.answers)
        out += paragraph(viz::solution_head(e) + ": " + solution) + "\n";
      else
        answers_ += paragraph(viz::tr("Exercise {n}: {text}", {{"n", std::to_string(i + 1)}, {"text", solution}}));
    }
    out += judge_text(*e_.lesson, how_.columns);
    return out + (how_.answers ? "" : "\n");
  }

  const Excerpt& e_;
  const TextOptions how_;
  const viz::Step* told_ = nullptr;  ///< the step told last
  std::string source_;
  std::optional<viz::QuestionText> question_;  ///< the question told last
  std::string answers_;                        ///< to the questions so far
  std::set<std::string> placed_;               ///< points told
};

}  // namespace

std::string lesson_text(const Excerpt& e, const TextOptions& how) {
  const viz::Speaking speaking(e.lesson->language);
  return LessonWriter(e, how).all();
}

std::string exercises_text(const viz::Lesson& lesson, const TextOptions& how) {
  const viz::Speaking speaking(lesson.language);
  std::string out = heading(viz::tr("{lesson}: exercises", {{"lesson", plain(lesson.title)}}), '=', how.columns);
  if (!lesson.closing) return out;
  int number = 0;
  for (const viz::Exercise& e : lesson.closing->exercises) {
    out += wrapped(fmt::format("{}. {}", ++number, plain(e.prompt)), how.columns, 0) + numbered(e.program, how.columns);
    if (!e.preset.empty())
      out += wrapped(viz::tr("Start: {option}", {{"option", "--preset " + e.preset}}), how.columns, 3);
    std::string way;  // the whole way
    for (const auto& [name, value] : e.by) way += fmt::format(" --set {}={}", name, value);
    if (!way.empty()) out += wrapped(viz::tr("One way:") + way, how.columns, 3);
    out += wrapped(viz::solution_head(e) + ": " + plain(e.solution), how.columns, 3) + "\n";
  }
  const std::string judge = judge_text(lesson, how.columns);
  if (judge.empty()) out.pop_back();
  return out + judge;
}

}  // namespace isect::program
