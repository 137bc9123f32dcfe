// isect explain: the lesson as text, for terminals and screen readers.

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "app/options.h"
#include "app/terminal.h"
#include "viz/rich_text.h"

namespace isect::program {

namespace {

constexpr std::size_t columns = 80;

std::string heading(const std::string& text, char line) {
  return fmt::format("{}\n{}\n", inked(Ink::bold, text), std::string(length(text), line));
}

bool contains(const std::vector<int>& lines, int line) { return std::ranges::find(lines, line) != lines.end(); }

/// The algorithm with the current line marked; what was not taken is dim, a condition that failed says "no".
std::string pseudocode(const viz::Walk& walk, const viz::Step& step) {
  std::string out;
  for (int i = 0; i < static_cast<int>(walk.pseudocode.size()); ++i) {
    const bool now = i == step.line;
    std::string text = fmt::format(" {} {:>2}  {}", now ? "▸" : " ", i + 1, walk.pseudocode[i]);
    if (contains(step.refused, i)) text += "   (no)";
    const Ink ink = now ? Ink::mark : contains(step.untaken, i) ? Ink::dim : Ink::plain;
    out += inked(ink, text) + "\n";
  }
  return out + "\n";
}

std::string values(const viz::Step& step) {
  std::size_t widest = 0;
  for (const viz::Value& v : step.values) widest = std::max(widest, length(viz::plain(v.name)));
  std::string out;
  for (const viz::Value& v : step.values) {
    const std::string name = viz::plain(v.name);
    out += fmt::format("     {}{} = {}{}\n", std::string(widest - length(name), ' '), name, viz::shown(v.value),
                       v.fresh ? "   (new)" : "");
  }
  return out.empty() ? out : out + "\n";
}

std::string comparison(const viz::Comparison& c) {
  const std::string meaning = c.meaning.empty() ? "" : ": " + viz::plain(c.meaning);
  return wrapped(fmt::format("Is {}? {} ({} and {}){}.", viz::plain(c.text), c.holds ? "Yes" : "No", viz::shown(c.left),
                             viz::shown(c.right), meaning),
                 columns, 0) +
         "\n";
}

std::string question(const viz::Question& q) {
  std::string out = wrapped("Question: " + viz::plain(q.prompt), columns, 0);
  for (std::size_t i = 0; i < q.choices.size(); ++i)
    out += wrapped(fmt::format("{}. {}", i + 1, viz::plain(q.choices[i])), columns, 4);
  const std::string answer = viz::plain(q.choices.at(static_cast<std::size_t>(q.answer)));
  return out + wrapped(fmt::format("Answer: {}. {}", answer, viz::plain(q.because)), columns, 0) + "\n";
}

/// What the methods say that should agree.
std::string side_by_side(const Excerpt& e) {
  const std::vector<viz::Opinion> opinions =
      e.lesson->opinions ? e.lesson->opinions(e.parameters) : std::vector<viz::Opinion>();
  if (opinions.empty()) return {};
  std::size_t widest = 0;
  for (const viz::Opinion& o : opinions) widest = std::max(widest, length(viz::plain(o.method)));
  std::string out = "Methods side by side:\n";
  for (const viz::Opinion& o : opinions) {
    const std::string method = viz::plain(o.method), says = viz::plain(o.says);
    const std::string line =
        fmt::format(" {} {}{}  {}", o.agrees ? "✓" : "✗", method, std::string(widest - length(method), ' '), says);
    out += (o.agrees ? line : inked(Ink::bold, line)) + "\n";
  }
  return out + "\n";
}

std::string told(const viz::Walk& walk, int index) {
  const viz::Step& step = walk.steps[index];
  std::string out =
      heading(fmt::format("Step {} of {}: {}", index + 1, walk.steps.size(), viz::plain(step.title)), '-');
  out += wrapped(viz::plain(step.caption), columns, 0) + "\n";
  if (!step.formula.empty()) out += fmt::format("     {}\n\n", viz::plain(step.formula));
  out += pseudocode(walk, step) + values(step);
  if (step.comparison) out += comparison(*step.comparison);
  if (step.verdict.kind != viz::Verdict::Kind::open)
    out += inked(Ink::bold, wrapped("Verdict: " + viz::plain(step.verdict.text), columns, 0)) + "\n";
  if (step.question) out += question(*step.question);
  if (!step.source.empty()) out += wrapped("Source: " + step.source, columns, 0) + "\n";
  return out;
}

int explain(const Program& program, const Selection& asked) {
  const Excerpt e = excerpt(program, asked);
  std::string out = heading(fmt::format("{} ({}), {}", e.lesson->title, e.lesson->rows, e.folder), '=');
  out += wrapped(e.lesson->summary, columns, 0) + "\n";
  if (!e.walk.method.empty()) out += wrapped("Method: " + viz::plain(e.walk.method), columns, 0) + "\n";
  out += wrapped("Picture: " + viz::plain(e.walk.alt), columns, 0) + "\n";
  out += side_by_side(e);
  for (const int step : e.steps) out += told(e.walk, step);
  out.pop_back();
  print(out);
  return done;
}

}  // namespace

void add_explain(CLI::App& app, Program& program) {
  CLI::App& sub = *app.add_subcommand("explain", "the lesson as text: captions, pseudocode, values");
  const auto asked = std::make_shared<Selection>();
  add_lesson(sub, program, *asked, Takes::one, "a lesson's id");
  add_preset(sub, *asked, Takes::one, "a preset, or a file with one (its step is honoured);\nthe first if not given");
  add_step(sub, *asked, Takes::many,
           "counted from 1: 3, 3-6, 3,5,7-9 or all; if not given, that of\nthe preset's file, or all");
  add_set(sub, *asked);
  sub.footer("Example: " + program.name + " explain" + (program.only ? "" : " ray-sphere") + " --step 3");
  sub.callback([&program, asked] { program.chosen = [&program, asked] { return explain(program, *asked); }; });
}

}  // namespace isect::program
