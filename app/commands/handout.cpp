// isect handout: a lesson to print, as LaTeX and as HTML: pictures, captions, pseudocode, questions and exercises, the
// answers at the end.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <set>

#include "app/figures/question_figure.h"
#include "app/pages/html.h"
#include "app/pages/latex.h"
#include "app/pages/pages.h"
#include "viz/text/rich_text.h"
#include "viz/text/tex.h"
#include "viz/walk/closing.h"

namespace isect::program {

namespace {

constexpr const char* latex_head =
    "\n\\documentclass[10pt]{{article}}\n\\usepackage{{tikz}}\n\\usepackage[margin=25mm]{{geometry}}\n"
    "\\setlength{{\\parindent}}{{0pt}}\n\\setlength{{\\parskip}}{{4pt plus 1pt}}\n"
    "\\begin{{document}}\n\\section*{{{}}}\n";
constexpr const char* html_style =
    "<style>\nbody { max-width: 42em; margin: 2em auto; padding: 0 1em; font: 11pt/1.45 serif; }\n"
    "h1, h2 { line-height: 1.2; } h2 { margin-top: 2em; break-after: avoid; }\n"
    "figure { margin: 1em 0; text-align: center; break-inside: avoid; } img { max-width: 100%; }\n"
    "ol.code { font: 10pt/1.35 monospace; } ol.code li { white-space: pre-wrap; padding-left: 2em; text-indent: -2em; "
    "}\n"
    "ol.code .current { background: #ffef9e; }\n"
    "ol.choices { list-style: lower-alpha; }\n</style>\n";

/// Returns the steps in order; a step's question stands before its picture, which shows the answer. `drawn`: the
/// questions with a picture of their own.
Blocks contents(const Excerpt& e, const std::set<int>& drawn) {
  Blocks all = {Prose{e.lesson->summary}, Prose{given(*e.lesson, e.parameters, e.walk), "Given"}};
  const auto add = [](Blocks& to, const Blocks& more) { to.insert(to.end(), more.begin(), more.end()); };
  add(all, algorithm(e));
  Blocks answers;
  for (const int index : e.steps) {
    const viz::StepText told = viz::step_text(*e.lesson, e.walk, index);
    if (const auto& q = told.question) {
      const std::string head = fmt::format("Question {}.", q->number);
      if (drawn.contains(index)) all.push_back(image_of(info_of_question(e, index)));
      add(all, question(*q, head));
      answers.push_back(answer(*q, head));
    }
    all.push_back(Heading{fmt::format("{}. {}", index + 1, told.title)});  // a title may tell the answer
    all.push_back(image_of(info_of(e, index)));
    all.push_back(Prose{told.caption});
    if (told.line && !told.line->said.empty() && !e.walk.steps[index].scene.chart)
      all.push_back(line_alone(e, *told.line));
    if (e.walk.steps[index].slug != viz::closing_slug) continue;
    int exercises = 0;
    for (const viz::Exercise& x : e.lesson->closing->exercises) {
      add(all, exercise(*e.lesson, x, fmt::format("Exercise {}.", ++exercises)));
      answers.push_back(Prose{x.solution, fmt::format("Exercise {}.", exercises)});
    }
    if (const std::optional<viz::Judge> own = viz::judge(*e.lesson)) {
      all.push_back(Prose{own->told});
      Code command;
      for (const std::string& line : own->command) command.lines.push_back(viz::as_markup(line));
      all.push_back(command);
    }
  }
  if (!answers.empty()) all.push_back(Heading{"Answers"});
  add(all, answers);
  return all;
}

/// Draws a step's picture without words, to compare with that of its question.
viz::Drawing bare(FigureMaker& maker, Excerpt e, int step) {
  viz::Step& s = e.walk.steps[step];
  s.formula.clear(), s.verdict = {};
  return maker.draw(e, step);
}

int handout(const Program& program, const PageOptions& options) {
  StyleOptions style_options;
  style_options.format = "tikz,svg", style_options.theme = theme_of_pages(options), style_options.width = options.width;
  style_options.text_size = "11pt", style_options.no_title = true;
  const Style style = style_of(style_options);
  const Excerpt e = excerpt(program, options.asked);
  PageFolder pages(program, options, e, "handout", style.formats);
  FigureMaker maker(style, "auto");
  std::set<int> drawn;
  for (const int step : e.steps) {
    if (e.walk.steps[step].question && has_picture(e.walk, step)) {
      const Excerpt asked = asking(e, step);
      const FigureInfo info = info_of_question(e, step);
      const viz::Drawing drawing = maker.draw(asked, asked.steps.front());
      const auto text = [&](const viz::Drawing& d) { return maker.write(info, d, *style.formats.back()); };
      if (step == 0 || text(drawing) != text(bare(maker, e, step - 1)))
        drawn.insert(step), pages.add(info, drawing, maker);
    }
    pages.add(info_of(e, step), maker.draw(e, step), maker);
  }
  const Blocks blocks = contents(e, drawn);
  pages.finish(fmt::format(latex_head, viz::tex(e.lesson->title)) + latex(blocks) + "\\end{document}\n",
               html_page(viz::plain(e.lesson->title), html_style,
                         fmt::format("<h1>{}</h1>\n", html_text(e.lesson->title)) + html(blocks)));
  return done;
}

}  // namespace

void add_handout(CLI::App& app, Program& program) {
  CLI::App& sub = *app.add_subcommand("handout", "a lesson to print, as LaTeX and as HTML, answers at the end");
  const auto options = std::make_shared<PageOptions>();
  options->width = "9cm";
  add_page_options(sub, program, *options, "handout");
  sub.footer(
      "The files go to DIR/<lesson>/<preset>/, beside the pictures: handout.tex, for pdflatex and lualatex run\n"
      "there, and handout.html.\nExample: " +
      program.name + " handout" + (program.only ? "" : " ray-sphere") + " --preset tangent");
  sub.callback([&program, options] { program.chosen = [&program, options] { return handout(program, *options); }; });
}

}  // namespace isect::program
