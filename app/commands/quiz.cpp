// isect quiz: the questions of a lesson or of a playlist, each with the picture it needs: to print, as LaTeX and as
// HTML, with the answers and what is said to usual wrong ones at the end; or for learning platforms.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <utility>

#include "app/figures/question_figure.h"
#include "app/pages/printed.h"
#include "app/platforms/quiz_sheet.h"
#include "app/shell/environment.h"
#include "app/shell/terminal.h"
#include "viz/lang/language.h"
#include "viz/lang/message.h"
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
    for (const viz::WrongLine& wrong : q.asked->line->wrong)
      add(viz::tr("Line {n}", {{"n", std::to_string(wrong.line + 1)}}), wrong.reply);
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
    all_.push_back(Heading{viz::tr("Answers")});
    append(all_, answers_);
    return std::move(all_);
  }

 private:
  void ask(const Excerpt& e, int step) {
    const viz::QuestionText q = *viz::question_text(e.walk, step);
    const std::string head =
        viz::tr("Question {n}.", {{"n", std::to_string(paper_.is_playlist() ? ++questions_ : q.number)}});
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

using QuizOptions = PageOptions;

/// Writes the pages to print.
void print_quiz(const Program& program, const PageOptions& options, const PageFormats& formats, const Paper& paper) {
  const Style style = printed_style(options);
  PageFolder pages(program, options, formats, paper, "quiz", style.formats, PaperSteps::asking);
  FigureMaker maker(style, "auto");
  Quiz made(paper, maker, pages);
  for (const PaperPart& part : paper.parts) made.add(part);
  finish_printed(pages, paper, std::move(made).made());
}

/// Writes a file for each format, unless someone has edited the one that is there.
void pack_quiz(const Program& program, const QuizOptions& options, const Paper& paper,
               const std::vector<const platforms::QuizFormat*>& formats) {
  const Style style = platforms::sheet_style(theme_of_pages(options), options.width);
  FigureFolder folder(options.out, program);
  need_environment(program);
  FigureMaker maker(style, "auto");
  const platforms::QuizSheet sheet = platforms::sheet_of(paper, maker);
  for (const platforms::QuizFormat* format : formats)
    print(folder.add_page(paper.folder + "/" + format->file, format->write(sheet, format->mark)));
  folder.list();
  folder.say_left_alone();
}

int quiz(const Program& program, const QuizOptions& options) {
  if (options.print_template) return print_template("quiz");
  const platforms::AskedFormats formats = platforms::asked_formats(options.format);
  const bool every = options.asked.preset == "all", printed = formats.paper || formats.pdf;
  if (every && printed)
    throw viz::BadInput("preset: \"all\" is not for paper; name one, or give --format moodle, gift, qti or h5p");
  const Paper paper =
      every ? paper_of_presets(program, options.asked) : paper_of(program, options.asked, PaperSteps::asking);
  const viz::Speaking speaking(paper.language());
  std::vector<PageFile> files;
  for (const platforms::QuizFormat* format : formats.platforms)
    files.push_back({format->file, format->mark, format->packed});
  need_own((std::filesystem::path(options.out) / paper.folder).string() + "/", files);
  if (printed) print_quiz(program, options, {formats.paper, formats.paper, formats.pdf}, paper);
  if (!formats.platforms.empty()) pack_quiz(program, options, paper, formats.platforms);
  return done;
}

}  // namespace

void add_quiz(CLI::App& app, Program& program) {
  CLI::App& sub =
      *app.add_subcommand("quiz", "the questions of a lesson or a playlist: to print, or for learning platforms");
  const auto options = std::make_shared<QuizOptions>();
  options->width = "9cm";
  options->out = "quizzes";
  options->format = "paper";
  add_page_options(sub, program, *options, "quiz");
  sub.get_option("--preset")
      ->description("a preset, or a file with one; the first if not given; all for\nlearning platforms");
  sub.add_option("--format", options->format,
                 "paper (if not given), pdf, moodle, gift, qti, h5p; several are\njoined by commas")
      ->type_name("FORMAT");
  const std::string called = program.name, lesson = program.only ? "" : " ray-sphere";
  sub.footer(
      "Each question has the picture and the numbers that it needs. A later question may give a number that an\n"
      "earlier one asks for. The files go to DIR/<lesson>/<preset>/, those of all presets to DIR/<lesson>/, those of\n"
      "a playlist to DIR/<its name>/.\n"
      "paper: quiz.tex, for pdflatex and lualatex run there, and quiz.html. The answers begin a page of their own,\n"
      "with what is said to usual wrong ones.\n"
      "pdf: quiz.pdf, the same by LaTeX, if it is installed.\n"
      "moodle: quiz.moodle.xml. Choices and lines are multiple choice, numbers are numerical with a tolerance, orders\n"
      "are short answers whose letters are typed. Wrong answers have their replies, pictures their alt text.\n"
      "gift: quiz.gift.txt, the same as text. Pictures are data in it, which programs other than Moodle may drop.\n"
      "qti: quiz.qti.zip, QTI 2.1, an item for each question and a test of all. A platform that knows only the\n"
      "templates of the standard takes choices, lines, and orders of which nothing is equal; it shows no replies.\n"
      "h5p: quiz.h5p, a Question Set (1.20) of Multiple Choice (1.16); the platform must have both. H5P knows no\n"
      "tolerances and no orders: numbers and orders become the choices that the lesson offers, and what is said to\n"
      "other wrong numbers is left out.\n"
      "Same input, same bytes; each question keeps its id, which is made of lesson, preset and step. By that id a\n"
      "platform replaces QTI items that it has; H5P content is replaced as a whole. Moodle always adds what it\n"
      "imports: delete its category isect/<lesson>/<preset> first, or it has all questions twice.\n"
      "For a lesson's page as a SCORM package: " +
      called + " book" + lesson + " --scorm\nExample: " + called + " quiz" + lesson +
      " --preset tangent --format moodle,qti");
  sub.callback([&program, options] { program.chosen = [&program, options] { return quiz(program, *options); }; });
}

}  // namespace isect::program
