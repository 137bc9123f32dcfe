// isect deck: a lesson or a playlist as slides, for LaTeX (beamer) and as one HTML file: one slide per step, with its
// question on the slide before.

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <utility>

#include "app/figures/question_figure.h"
#include "app/pages/pages.h"
#include "app/pages/slides.h"
#include "viz/lang/language.h"
#include "viz/lang/message.h"
#include "viz/walk/closing.h"
#include "viz/walk/exercise_text.h"

namespace isect::program {

namespace {

/// Sizes on a slide of 16 cm by 9: a picture beside text, and one alone.
constexpr const char* beside_width = "8.2cm";
constexpr const char* beside_height = "5.4cm";
constexpr const char* alone_width = "13cm";
constexpr const char* alone_height = "6.2cm";
/// LaTeX sets labels at 8 pt; its letters are as wide at 10 pt as ours at 11.
constexpr const char* label_size = "9pt";

/// How many stops one slide lists.
constexpr std::size_t stops_a_slide = 16;

/// The picture of a step, or of the question before it.
using Picture = std::function<Image(const Excerpt&, int step, bool asks)>;

/// Slides, part after part.
class Slides {
 public:
  Slides(const Paper& paper, const Picture& picture) : paper_(paper), picture_(picture) { begin(); }

  void add(const PaperPart& part) {
    open(part);
    for (const int index : part.e.steps) {
      const viz::StepText told = viz::step_text(*part.e.lesson, part.e.walk, index);
      if (told.question) ask(part.e, *told.question, index);
      if (part.e.walk.steps[index].slug == viz::closing_slug)
        close(part, told.title);
      else
        show(part, told, index);
    }
  }

  std::vector<Slide> made() && { return std::move(all_); }

 private:
  /// A playlist begins with its title and its stops.
  void begin() {
    if (!paper_.is_playlist()) return;
    const std::vector<Stops::Entry> stops = list_of_stops(paper_).all;
    for (std::size_t from = 0; from < stops.size(); from += stops_a_slide) {
      const std::size_t to = std::min(from + stops_a_slide, stops.size());
      const auto at = [&](std::size_t i) { return stops.begin() + static_cast<std::ptrdiff_t>(i); };
      all_.push_back({paper_.title, {Stops{{at(from), at(to)}}}, {}, {}});
    }
  }

  /// Adds what a part is about, and what is given.
  void open(const PaperPart& part) {
    const Excerpt& e = part.e;
    const viz::Lesson& lesson = *e.lesson;
    const Prose numbers = {given(lesson, e.parameters, e.walk)};
    if (part.stop > 0) {
      Slide slide = {part.head, {}, {}, {}};
      slide.note = part.note;
      if (part.new_lesson) slide.left.push_back(Prose{lesson.summary});
      slide.left.push_back(Prose{numbers.text, viz::tr("Given")});
      all_.push_back(std::move(slide));
    } else {
      all_.push_back({lesson.title, {Prose{lesson.summary}}, {}, {}, true});
    }
    const bool is_step = e.walk.steps.front().slug == viz::opening_slug;
    if (part.new_lesson && !lesson.opening.empty() && !is_step)
      all_.push_back({lesson.title, {Prose{lesson.opening}}, {}, {}});
    if (part.stop == 0) all_.push_back({viz::tr("What is given"), {numbers}, {}, {}});
    if (const Blocks code = algorithm(e); part.code_of == 0 && !code.empty())
      all_.push_back({viz::tr("Algorithm"), code, {}, {}});
  }

  /// Adds the question beside the picture for it, then the answer.
  void ask(const Excerpt& e, const viz::QuestionText& q, int index) {
    Slide slide = {
        viz::tr("Question {n}", {{"n", std::to_string(paper_.is_playlist() ? ++questions_ : q.number)}}), {}, {}, {}};
    const bool picture = has_picture(e.walk, index);
    if (picture) slide.left.push_back(picture_(e, index, true));
    Blocks& text = picture ? slide.right : slide.left;
    text = question(q);
    append(text, {Pause{}, answer(q)});
    if (q.asked->line) slide.below = std::exchange(text, {code(e)});  // the lines to name one of
    all_.push_back(std::move(slide));
  }

  void show(const PaperPart& part, const viz::StepText& told, int index) {
    const viz::Step& s = part.e.walk.steps[index];
    Slide slide = {told.title, {picture_(part.e, index, false)}, {}, {}};
    if (told.line && !s.scene.chart) slide.right.push_back(code(part.e, told.line));
    // The opening has a slide of its own.
    slide.below.push_back(Prose{part.new_lesson ? told.own_caption : caption_on_paper(part, index)});
    all_.push_back(std::move(slide));
  }

  /// Adds the card as text, one slide per exercise, and the solutions behind all of them.
  void close(const PaperPart& part, const std::string& title) {
    const viz::Lesson& lesson = *part.e.lesson;
    Slide slide = {title, {}, {}, {}};
    for (const auto& [head, text] : viz::card_rows(lesson, viz::named_on_card))
      slide.left.push_back(Prose{text, head + "."});
    all_.push_back(std::move(slide));
    if (!part.new_card) return;
    int solutions = exercises_;
    for (const viz::Exercise& x : lesson.closing->exercises)
      all_.push_back({viz::tr("Exercise {n}", {{"n", std::to_string(++exercises_)}}), exercise(lesson, x), {}, {}});
    for (const viz::Exercise& x : lesson.closing->exercises)
      all_.push_back({viz::tr("{solution} of exercise {n}",
                              {{"solution", viz::solution_head(x)}, {"n", std::to_string(++solutions)}}),
                      {Prose{x.solution}},
                      {},
                      {}});
  }

  const Paper& paper_;
  const Picture& picture_;
  std::vector<Slide> all_;
  int questions_ = 0, exercises_ = 0;  ///< so far
};

Style style_for(const PageOptions& options, bool alone) {
  StyleOptions style;
  style.format = "tikz,svg", style.theme = theme_of_pages(options), style.text_size = label_size, style.no_title = true;
  style.width = alone ? alone_width : options.width, style.height = alone ? alone_height : beside_height;
  return style_of(style);
}

int deck(const Program& program, const PageOptions& options) {
  const Style beside = style_for(options, false), alone = style_for(options, true);
  const Paper paper = paper_of(program, options.asked);
  PageFolder pages(program, options, paper, "deck", {&viz::format_named("tikz")});
  const viz::Speaking speaking(paper.language());
  FigureMaker small(beside, "auto"), large(alone, "auto");
  const Picture picture = [&](const Excerpt& e, int step, bool asks) {
    const viz::Step& s = e.walk.steps[step];
    FigureMaker& maker = asks || (s.line >= 0 && !s.scene.chart) ? small : large;
    const FigureInfo info = asks ? info_of_question(e, step) : info_of(e, step);
    const viz::Drawing drawing = asks ? draw_question(maker, e, step) : maker.draw(e, step);
    pages.add(e, info, drawing, maker);
    Image shown = image_of(info, paper);
    shown.svg = maker.write(info, drawing, viz::format_named("svg"));
    shown.fits = true;
    return shown;
  };
  Slides made(paper, picture);
  for (const PaperPart& part : paper.parts) made.add(part);
  const std::vector<Slide> slides = std::move(made).made();
  pages.finish(beamer(paper.title, slides), html_slides(paper.title, slides));
  return done;
}

}  // namespace

void add_deck(CLI::App& app, Program& program) {
  CLI::App& sub = *app.add_subcommand("deck", "a lesson or a playlist as slides: LaTeX (beamer), one HTML file");
  const auto options = std::make_shared<PageOptions>();
  options->width = beside_width;
  add_page_options(sub, program, *options, "deck");
  sub.footer(
      "The files go to DIR/<lesson>/<preset>/: deck.tex, for pdflatex and lualatex run there, beside its pictures,\n"
      "and deck.html, which needs nothing else: arrow keys, space or a click step through it. A playlist's go to\n"
      "DIR/<its name>/. The notes of its stops are the speaker's: N shows them in deck.html, and deck.tex says how\n"
      "beamer does.\nExample: " +
      program.name + " deck" + (program.only ? "" : " ray-sphere") + " --preset tangent");
  sub.callback([&program, options] { program.chosen = [&program, options] { return deck(program, *options); }; });
}

}  // namespace isect::program
