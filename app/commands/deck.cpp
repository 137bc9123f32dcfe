// isect deck: a lesson as slides, for LaTeX (beamer) and as one HTML file: one slide per step, with its question on the
// slide before.

#include <fmt/format.h>

#include <functional>
#include <memory>
#include <utility>

#include "app/figures/question_figure.h"
#include "app/pages/html.h"
#include "app/pages/latex.h"
#include "app/pages/pages.h"
#include "app/pages/slides.h"
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

/// The picture of a step, or of the question before it.
using Picture = std::function<Image(int step, bool asks)>;

class Slides {
 public:
  Slides(const Excerpt& e, const Picture& picture) : e_(e), picture_(picture) {}

  std::vector<Slide> made() {
    const viz::Lesson& lesson = *e_.lesson;
    all_.push_back({lesson.title, {Prose{lesson.summary}}, {}, {}, true});
    const bool is_step = e_.walk.steps.front().slug == viz::opening_slug;
    if (!lesson.opening.empty() && !is_step) all_.push_back({lesson.title, {Prose{lesson.opening}}, {}, {}});
    all_.push_back({"What is given", {Prose{given(lesson, e_.parameters, e_.walk)}}, {}, {}});
    if (const Blocks code = algorithm(e_); !code.empty()) all_.push_back({"Algorithm", code, {}, {}});
    for (const int index : e_.steps) {
      const viz::StepText told = viz::step_text(lesson, e_.walk, index);
      if (told.question) ask(*told.question, index);
      if (e_.walk.steps[index].slug == viz::closing_slug)
        close(told.title);
      else
        show(told, index);
    }
    return std::move(all_);
  }

 private:
  /// Adds the question beside the picture for it, then the answer.
  void ask(const viz::QuestionText& q, int index) {
    Slide slide = {fmt::format("Question {}", q.number), {}, {}, {}};
    const bool picture = has_picture(e_.walk, index);
    if (picture) slide.left.push_back(picture_(index, true));
    Blocks& text = picture ? slide.right : slide.left;
    text = question(q);
    text.insert(text.end(), {Pause{}, answer(q)});
    if (q.asked->line) slide.below = std::exchange(text, {code(e_)});  // the lines to name one of
    all_.push_back(std::move(slide));
  }

  void show(const viz::StepText& told, int index) {
    Slide slide = {told.title, {picture_(index, false)}, {}, {}};
    if (told.line && !e_.walk.steps[index].scene.chart) slide.right.push_back(code(e_, told.line));
    slide.below.push_back(Prose{told.own_caption});  // the opening has a slide of its own
    all_.push_back(std::move(slide));
  }

  /// Adds the card as text, one slide per exercise, and the solutions behind all of them.
  void close(const std::string& title) {
    Slide slide = {title, {}, {}, {}};
    for (const auto& [head, text] : viz::card_rows(*e_.lesson, viz::named_on_card))
      slide.left.push_back(Prose{text, head + "."});
    all_.push_back(std::move(slide));
    int exercises = 0, solutions = 0;
    for (const viz::Exercise& x : e_.lesson->closing->exercises)
      all_.push_back({fmt::format("Exercise {}", ++exercises), exercise(*e_.lesson, x), {}, {}});
    for (const viz::Exercise& x : e_.lesson->closing->exercises)
      all_.push_back(
          {fmt::format("{} of exercise {}", viz::solution_head(x), ++solutions), {Prose{x.solution}}, {}, {}});
  }

  const Excerpt& e_;
  const Picture& picture_;
  std::vector<Slide> all_;
};

Style style_for(const PageOptions& options, bool alone) {
  StyleOptions style;
  style.format = "tikz,svg", style.theme = theme_of_pages(options), style.text_size = label_size, style.no_title = true;
  style.width = alone ? alone_width : options.width, style.height = alone ? alone_height : beside_height;
  return style_of(style);
}

int deck(const Program& program, const PageOptions& options) {
  const Style beside = style_for(options, false), alone = style_for(options, true);
  const Excerpt e = excerpt(program, options.asked);
  PageFolder pages(program, options, e, "deck", {&viz::format_named("tikz")});
  FigureMaker small(beside, "auto"), large(alone, "auto");
  const Picture picture = [&](int step, bool asks) {
    const viz::Step& s = e.walk.steps[step];
    FigureMaker& maker = asks || (s.line >= 0 && !s.scene.chart) ? small : large;
    const FigureInfo info = asks ? info_of_question(e, step) : info_of(e, step);
    const Excerpt asked = asks ? asking(e, step) : Excerpt();
    const viz::Drawing drawing = asks ? maker.draw(asked, asked.steps.front()) : maker.draw(e, step);
    pages.add(info, drawing, maker);
    Image shown = image_of(info);
    shown.svg = maker.write(info, drawing, viz::format_named("svg"));
    shown.fits = true;
    return shown;
  };
  const std::vector<Slide> slides = Slides(e, picture).made();
  pages.finish(beamer(e.lesson->title, slides), html_slides(e.lesson->title, slides));
  return done;
}

}  // namespace

void add_deck(CLI::App& app, Program& program) {
  CLI::App& sub = *app.add_subcommand("deck", "a lesson as slides, for LaTeX (beamer) and as one HTML file");
  const auto options = std::make_shared<PageOptions>();
  options->width = beside_width;
  add_page_options(sub, program, *options, "deck");
  sub.footer(
      "The files go to DIR/<lesson>/<preset>/: deck.tex, for pdflatex and lualatex run there, beside its pictures,\n"
      "and deck.html, which needs nothing else: arrow keys, space or a click step through it.\nExample: " +
      program.name + " deck" + (program.only ? "" : " ray-sphere") + " --preset tangent");
  sub.callback([&program, options] { program.chosen = [&program, options] { return deck(program, *options); }; });
}

}  // namespace isect::program
