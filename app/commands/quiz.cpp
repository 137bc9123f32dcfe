// isect quiz: the questions of a lesson or of a playlist to print, as LaTeX and as HTML: each with the picture it
// needs, and at the end the answers, with what is said to usual wrong ones.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <utility>

#include "app/figures/question_figure.h"
#include "app/pages/printed.h"
#include "viz/walk/given_answer.h"
#include "viz/walk/given_order.h"

namespace isect::program {

namespace {

/// Returns "(b) for half of it: that is the diameter.", a paragraph for each wrong answer whose mistake is known.
std::string replies_on_paper(const viz::Walk& walk, int step, const viz::QuestionText& q) {
  std::string all;
  const auto add = [&](const std::string& given, const std::string& reply) {
    if (!reply.empty()) all += fmt::format("\n{}: {}", given, reply);
  };
  if (q.asked->line) {
    for (const viz::WrongLine& wrong : q.asked->line->wrong) add(fmt::format("Line {}", wrong.line + 1), wrong.reply);
  } else if (q.asked->order) {
    for (const viz::WrongOrder& wrong : q.asked->order->wrong) {
      std::string letters;
      for (const int tile : wrong.order)
        letters += fmt::format("{}({})", letters.empty() ? "" : ", ", viz::tile_letter(tile));
      add(letters, wrong.reply);
    }
  } else {
    for (std::size_t i = 0; i < q.choices.size(); ++i)
      if (i != q.right)
        add(fmt::format("({}) {}", viz::choice_letter(i), q.choices[i]),
            viz::reply_to(walk, step, viz::GivenAnswer{static_cast<int>(i)}));
  }
  return all;
}

/// A quiz, part after part; the answers begin a page.
class Quiz {
 public:
  Quiz(const Paper& paper, FigureMaker& maker, PageFolder& pages)
      : paper_(paper), maker_(maker), pages_(pages), all_(printed_front(paper)) {}

  void add(const PaperPart& part) {
    append(all_, printed_head(part));
    for (const int step : part.e.steps) ask(part.e, step);
  }

  Blocks made() && {
    all_.push_back(NewPage{});
    all_.push_back(Heading{"Answers"});
    append(all_, answers_);
    return std::move(all_);
  }

 private:
  void ask(const Excerpt& e, int step) {
    const viz::QuestionText q = *viz::question_text(e.walk, step);
    const std::string head = fmt::format("Question {}.", paper_.is_playlist() ? ++questions_ : q.number);
    if (has_picture(e.walk, step)) {
      const FigureInfo info = info_of_question(e, step);
      pages_.add(e, info, draw_question(maker_, e, step), maker_);
      all_.push_back(image_of(info, paper_));
    }
    append(all_, question(q, head));
    Prose told = program::answer(q, head);  // not that of a query
    told.text += replies_on_paper(e.walk, step, q);
    answers_.push_back(told);
  }

  const Paper& paper_;
  FigureMaker& maker_;
  PageFolder& pages_;
  Blocks all_, answers_;
  int questions_ = 0;  ///< so far
};

int quiz(const Program& program, const PageOptions& options) {
  const Style style = printed_style(options);
  const Paper paper = paper_of(program, options.asked, PaperSteps::asking);
  PageFolder pages(program, options, paper, "quiz", style.formats, PaperSteps::asking);
  FigureMaker maker(style, "auto");
  Quiz made(paper, maker, pages);
  for (const PaperPart& part : paper.parts) made.add(part);
  finish_printed(pages, paper, std::move(made).made());
  return done;
}

}  // namespace

void add_quiz(CLI::App& app, Program& program) {
  CLI::App& sub = *app.add_subcommand("quiz", "the questions of a lesson or a playlist to print, answers at the end");
  const auto options = std::make_shared<PageOptions>();
  options->width = "9cm";
  options->out = "quizzes";
  add_page_options(sub, program, *options, "quiz");
  sub.footer(
      "Each question has the picture and the numbers that it needs. The answers begin a page of their own, with what\n"
      "is said to usual wrong ones. A later question may give a number that an earlier one asks for.\n"
      "The files go to DIR/<lesson>/<preset>/, those of a playlist to DIR/<its name>/: quiz.tex, for pdflatex and\n"
      "lualatex run there, and quiz.html.\nExample: " +
      program.name + " quiz" + (program.only ? "" : " ray-sphere") + " --preset tangent");
  sub.callback([&program, options] { program.chosen = [&program, options] { return quiz(program, *options); }; });
}

}  // namespace isect::program
