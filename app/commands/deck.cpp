// isect deck: a lesson or a playlist as slides, for LaTeX (beamer) and as one HTML file: one slide per step, with its
// question on the slide before.

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <utility>

#include "app/figures/question_figure.h"
#include "app/figures/theme_choice.h"
#include "app/pages/pages.h"
#include "app/pages/slides.h"
#include "viz/lang/language.h"
#include "viz/lang/message.h"
#include "viz/walk/closing.h"
#include "viz/walk/exercise_text.h"
#include "viz/walk/question_scene.h"

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

/// Whether a step's slide is one of those that overlays show in one frame: no map, no card.
bool can_be_overlaid(const viz::Step& s) { return !s.scene.chart && s.slug != viz::closing_slug; }

/// Slides, part after part.
class Slides {
 public:
  /// `overlays`: in LaTeX the steps of a part are one frame.
  Slides(const Paper& paper, const Picture& picture, bool overlays)
      : paper_(paper), picture_(picture), overlays_(overlays) {
    begin();
  }

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
    slide.overlaid = overlays_ && picture && can_be_overlaid(e.walk.steps[index]);
    all_.push_back(std::move(slide));
  }

  void show(const PaperPart& part, const viz::StepText& told, int index) {
    const viz::Step& s = part.e.walk.steps[index];
    Slide slide = {told.title, {picture_(part.e, index, false)}, {}, {}};
    if (told.line && !s.scene.chart) slide.right.push_back(code(part.e, told.line));
    // The opening has a slide of its own.
    slide.below.push_back(Prose{part.new_lesson ? told.own_caption : caption_on_paper(part, index)});
    slide.overlaid = overlays_ && can_be_overlaid(s);
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
  const bool overlays_;
  std::vector<Slide> all_;
  int questions_ = 0, exercises_ = 0;  ///< so far
};

struct DeckOptions : PageOptions {
  std::string beamer_theme;
  bool dark = false, overlays = false;
};

/// Returns the theme of the pictures by its name: white ones, or dark ones for dark slides. Throws viz::BadInput.
std::string theme_of_deck(const DeckOptions& options) {
  if (!options.dark) return theme_of_pages(options);
  if (options.theme == PageOptions().theme) return "dark";  // none is asked for
  if (const viz::ThemeChoice theme = theme_choice(options.theme); theme.base() != viz::ThemeName::dark)
    throw viz::BadInput(fmt::format(
        "theme: \"{}\" is not meant for dark slides; give dark, or a theme based on it, or leave out --dark",
        viz::name_of(theme)));
  return options.theme;
}

Style style_for(const DeckOptions& options, bool alone) {
  StyleOptions style;
  style.format = "tikz,svg", style.theme = theme_of_deck(options), style.text_size = label_size, style.no_title = true;
  style.width = alone ? alone_width : options.width, style.height = alone ? alone_height : beside_height;
  return style_of(style);
}

/// Returns the beamer theme, checked: LaTeX reads its name. Throws viz::BadInput.
const std::string& checked_beamer_theme(const std::string& name) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  if (!std::ranges::all_of(name, is_letter))
    throw viz::BadInput(fmt::format("beamer-theme: \"{}\" is not allowed; give letters only, such as Madrid", name));
  return name;
}

/// Returns how the slides around pictures of this theme look.
SlideLook look_of(const DeckOptions& options, const Style& style) {
  SlideLook look;
  look.beamer_theme = checked_beamer_theme(options.beamer_theme);
  if (!options.dark) return look;
  constexpr double share = 0.3;  // of the highlight in the ground of a lit line
  const viz::Theme theme = viz::paper_theme(style.theme);
  const viz::Colour &ground = theme.background, lit = theme.ink(viz::Role::highlight);
  const auto mixed = [&](double a, double b) { return a + share * (b - a); };
  const auto digits = [](const viz::Colour& c) { return viz::hex_of(c).substr(1); };
  look.ground = digits(ground), look.text = digits(theme.ink(viz::Role::text));
  look.lit = digits({mixed(ground.r, lit.r), mixed(ground.g, lit.g), mixed(ground.b, lit.b)});
  look.structure = digits(theme.ink(viz::Role::first));
  return look;
}

/// The pictures of a part that overlays show one after the other: all of one size, so that nothing jumps.
class OneSize {
 public:
  explicit OneSize(FigureMaker& maker) : maker_(maker) {}

  const viz::Drawing& draw(const Excerpt& e, int step, bool asks) {
    std::map<std::pair<int, bool>, viz::Drawing>& known = drawn_[&e];
    if (known.empty()) draw_all(e, known);
    return known.at({step, asks});
  }

 private:
  void draw_all(const Excerpt& e, std::map<std::pair<int, bool>, viz::Drawing>& to) {
    Excerpt all = e;  // with the steps that ask at the end of its walk
    std::vector<std::pair<int, bool>> which;
    all.steps.clear();
    for (const int step : e.steps) {
      if (!can_be_overlaid(e.walk.steps[step])) continue;
      which.emplace_back(step, false), all.steps.push_back(step);
      if (!e.walk.steps[step].question || !has_picture(e.walk, step)) continue;
      which.emplace_back(step, true), all.steps.push_back(static_cast<int>(all.walk.steps.size()));
      all.walk.steps.push_back(viz::asking_step(e.walk, step));
    }
    std::vector<viz::Drawing> drawings = maker_.draw(all, all.steps);
    for (std::size_t i = 0; i < which.size(); ++i) to.emplace(which[i], std::move(drawings[i]));
  }

  FigureMaker& maker_;
  std::map<const Excerpt*, std::map<std::pair<int, bool>, viz::Drawing>> drawn_;
};

int deck(const Program& program, const DeckOptions& options) {
  if (options.print_template) return print_template("deck");
  const PageFormats formats = page_formats(options.format);
  const Style beside = style_for(options, false), alone = style_for(options, true);
  const SlideLook look = look_of(options, beside);
  const Paper paper = paper_of(program, options.asked);
  PageFolder pages(program, options, formats, paper, "deck", {&viz::format_named("tikz")});
  const viz::Speaking speaking(paper.language());
  FigureMaker small(beside, "auto"), large(alone, "auto");
  OneSize one_size(small);
  const Picture picture = [&](const Excerpt& e, int step, bool asks) {
    const viz::Step& s = e.walk.steps[step];
    const bool overlaid = options.overlays && can_be_overlaid(s);
    FigureMaker& maker = overlaid || asks || (s.line >= 0 && !s.scene.chart) ? small : large;
    const FigureInfo info = asks ? info_of_question(e, step) : info_of(e, step);
    const viz::Drawing drawing = overlaid ? one_size.draw(e, step, asks)
                                 : asks   ? draw_question(maker, e, step)
                                          : maker.draw(e, step);
    pages.add(e, info, drawing, maker);
    Image shown = image_of(info, paper);
    if (formats.html) shown.svg = maker.write(info, drawing, viz::format_named("svg"));
    shown.fits = true;
    return shown;
  };
  Slides made(paper, picture, options.overlays);
  for (const PaperPart& part : paper.parts) made.add(part);
  const std::vector<Slide> slides = std::move(made).made();
  pages.finish(beamer(paper.title, slides, look), html_slides(paper.title, slides, look));
  return done;
}

}  // namespace

void add_deck(CLI::App& app, Program& program) {
  CLI::App& sub = *app.add_subcommand("deck", "a lesson or a playlist as slides: LaTeX (beamer), one HTML file");
  const auto options = std::make_shared<DeckOptions>();
  options->width = beside_width;
  add_page_options(sub, program, *options, "deck");
  sub.add_option("--beamer-theme", options->beamer_theme,
                 "of LaTeX's slides: Madrid, Berlin, ...; its default if not given")
      ->type_name("NAME")
      ->check(not_empty());
  sub.add_flag("--dark", options->dark, "dark slides with dark pictures; --theme may then be one based on dark");
  sub.add_flag("--overlays", options->overlays,
               "in LaTeX the steps of a preset are one frame, whose pictures have\none size and stand in one place");
  sub.footer(
      "The files go to DIR/<lesson>/<preset>/: deck.tex, for pdflatex and lualatex run there, beside its pictures,\n"
      "and deck.html, which needs nothing else: arrow keys, space or a click step through it. A playlist's go to\n"
      "DIR/<its name>/. The notes of its stops are the speaker's: N shows them in deck.html, and deck.tex says how\n"
      "beamer does. pdf: deck.pdf alone, by lualatex or else pdflatex; beamer makes no tags for screen readers.\n"
      "Example: " +
      program.name + " deck" + (program.only ? "" : " ray-sphere") + " --preset tangent");
  sub.callback([&program, options] { program.chosen = [&program, options] { return deck(program, *options); }; });
}

}  // namespace isect::program
