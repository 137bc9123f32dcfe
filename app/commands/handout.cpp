// isect handout: a lesson or a playlist to print, as LaTeX and as HTML: pictures, captions, pseudocode, questions and
// exercises, the answers at the end.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <set>
#include <utility>

#include "app/figures/question_figure.h"
#include "app/pages/printed.h"
#include "viz/lang/language.h"
#include "viz/lang/message.h"
#include "viz/text/rich_text.h"
#include "viz/walk/closing.h"

namespace isect::program {

namespace {

/// A handout, part after part. A step's question stands before its picture, which shows the answer.
class Handout {
 public:
  explicit Handout(const Paper& paper) : paper_(paper), all_(printed_front(paper)) {}

  /// `drawn`: the questions with a picture of their own.
  void add(const PaperPart& part, const std::set<int>& drawn) {
    append(all_, printed_head(part));
    for (const int index : part.e.steps) {
      const viz::StepText told = viz::step_text(*part.e.lesson, part.e.walk, index);
      if (told.question) ask(part.e, *told.question, index, drawn);
      show(part, told, index);
      if (part.e.walk.steps[index].slug == viz::closing_slug && part.new_card) close(*part.e.lesson);
    }
  }

  Blocks made() && {
    if (!answers_.empty()) all_.push_back(Heading{viz::tr("Answers")});
    append(all_, answers_);
    return std::move(all_);
  }

 private:
  void ask(const Excerpt& e, const viz::QuestionText& q, int index, const std::set<int>& drawn) {
    const std::string head =
        viz::tr("Question {n}.", {{"n", std::to_string(paper_.is_playlist() ? ++questions_ : q.number)}});
    if (drawn.contains(index)) all_.push_back(image_of(info_of_question(e, index), paper_));
    append(all_, question(q, head));
    answers_.push_back(answer(q, head));
  }

  void show(const PaperPart& part, const viz::StepText& told, int index) {
    const Excerpt& e = part.e;
    all_.push_back(Heading{fmt::format("{}. {}", index + 1, told.title), paper_.is_playlist() ? 3 : 2});
    all_.push_back(image_of(info_of(e, index), paper_));
    all_.push_back(Prose{caption_on_paper(part, index)});
    if (told.line && !told.line->said.empty() && !e.walk.steps[index].scene.chart)
      all_.push_back(line_alone(e, *told.line));
  }

  void close(const viz::Lesson& lesson) {
    for (const viz::Exercise& x : lesson.closing->exercises) {
      const std::string head = viz::tr("Exercise {n}.", {{"n", std::to_string(++exercises_)}});
      append(all_, exercise(lesson, x, head));
      answers_.push_back(Prose{x.solution, head});
    }
    if (const std::optional<viz::Judge> own = viz::judge(lesson)) {
      all_.push_back(Prose{own->told});
      Code command;
      for (const std::string& line : own->command) command.lines.push_back(viz::as_markup(line));
      all_.push_back(command);
    }
  }

  const Paper& paper_;
  Blocks all_, answers_;
  int questions_ = 0, exercises_ = 0;  ///< so far
};

/// Draws a step's picture without words, to compare with that of its question.
viz::Drawing bare(FigureMaker& maker, Excerpt e, int step) {
  viz::Step& s = e.walk.steps[step];
  s.formula.clear(), s.verdict = {};
  return maker.draw(e, step);
}

/// Draws the pictures of a part. Returns the questions that have one of their own: it differs from the picture above.
std::set<int> draw_handout(const Excerpt& e, FigureMaker& maker, PageFolder& pages) {
  std::set<int> drawn;
  int above = -1;  // the step whose picture that is
  for (const int step : e.steps) {
    if (e.walk.steps[step].question && has_picture(e.walk, step)) {
      const FigureInfo info = info_of_question(e, step);
      const viz::Drawing drawing = draw_question(maker, e, step);
      const auto text = [&](const viz::Drawing& d) { return maker.write(info, d, *maker.style().formats.back()); };
      if (above < 0 || above != step - 1 || text(drawing) != text(bare(maker, e, above)))
        drawn.insert(step), pages.add(e, info, drawing, maker);
    }
    above = step;
    pages.add(e, info_of(e, step), maker.draw(e, step), maker);
  }
  return drawn;
}

int handout(const Program& program, const PageOptions& options) {
  if (options.print_template) return print_template("handout");
  const PageFormats formats = page_formats(options.format);
  const Style style = printed_style(options);
  const Paper paper = paper_of(program, options.asked);
  const viz::Speaking speaking(paper.language());
  PageFolder pages(program, options, formats, paper, "handout", style.formats);
  FigureMaker maker(style, "auto");
  Handout made(paper);
  for (const PaperPart& part : paper.parts) made.add(part, draw_handout(part.e, maker, pages));
  finish_printed(pages, paper, std::move(made).made());
  return done;
}

}  // namespace

void add_handout(CLI::App& app, Program& program) {
  CLI::App& sub = *app.add_subcommand("handout", "a lesson or a playlist to print, as LaTeX and as HTML");
  const auto options = std::make_shared<PageOptions>();
  options->width = "9cm";
  add_page_options(sub, program, *options, "handout");
  sub.footer(
      "The files go to DIR/<lesson>/<preset>/, beside the pictures: handout.tex, for pdflatex and lualatex run\n"
      "there, and handout.html. A playlist's go to DIR/<its name>/: first the list of its stops, then stop after "
      "stop.\n"
      "pdf: handout.pdf alone, by lualatex or else pdflatex, in a folder of its own and without a shell. It has tags\n"
      "for screen readers, with every picture in words, where lualatex has the package tagpdf.\n"
      "Example: " +
      program.name + " handout" + (program.only ? "" : " ray-sphere") + " --preset tangent");
  sub.callback([&program, options] { program.chosen = [&program, options] { return handout(program, *options); }; });
}

}  // namespace isect::program
