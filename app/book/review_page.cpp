#include "app/book/review_page.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/book/pictures.h"
#include "app/book/walk_section.h"
#include "app/figures/blocks.h"
#include "app/pages/html.h"
#include "viz/formats/svg_path.h"
#include "viz/text/rich_text.h"
#include "viz/walk/closing.h"
#include "viz/walk/step_text.h"

namespace isect::program::book {

namespace {

std::uint32_t chance(const viz::ReviewPrompt& p) { return viz::shuffled(p.lesson + "/" + p.question + "/" + p.preset); }

/// Returns each question once, in one of the settings in which it is asked.
std::vector<viz::ReviewPrompt> each_once(const std::vector<viz::ReviewPrompt>& all) {
  std::vector<viz::ReviewPrompt> once;
  for (const viz::ReviewPrompt& p : all) {
    const auto same = std::ranges::find(once, p.question, &viz::ReviewPrompt::question);
    if (same == once.end())
      once.push_back(p);
    else if (chance(p) < chance(*same))
      *same = p;
  }
  return once;
}

}  // namespace

std::string review_file(int number) { return fmt::format("review-{}.html", number); }
std::string review_title(int number) { return fmt::format("Review {}", number); }
std::string review_words() { return "Eight questions from these lessons; what was wrong returns first."; }

void ReviewPage::add(const viz::Lesson& lesson, const std::vector<Excerpt>& presets) {
  lessons_ += fmt::format("{}<a href=\"{}\">{}</a>", lessons_.empty() ? "" : ", ", file_of(lesson),
                          html_text(viz::short_title(lesson)));
  for (const viz::ReviewPrompt& p : each_once(viz::prompts_of(lesson))) {
    const auto preset = std::ranges::find(lesson.presets, p.preset, &viz::Preset::id);
    ask(presets[static_cast<std::size_t>(preset - lesson.presets.begin())], p);
  }
}

void ReviewPage::ask(const Excerpt& e, const viz::ReviewPrompt& p) {
  viz::QuestionText question = *viz::question_text(e.walk, p.step);
  question.number = ++count_;
  const WalkSection section({*e.lesson, e.parameters, e.walk}, p.preset, nullptr);
  const std::string step = fmt::format("{}#{}/{}", file_of(*e.lesson), p.preset, p.step + 1);
  const std::string name = viz::xml_escaped(section.asked_name(p.step));
  const std::string article = fmt::format(
      "<article class=\"ask\" id=\"question-{0}\" data-asked=\"{1}\" data-step=\"{2}\">\n"
      "<h2><span class=\"number\">Question {0}: </span><a href=\"{2}/question\">{3}</a></h2>\n{4}{5}</article>\n",
      count_, name, step, html_text(viz::short_title(*e.lesson)), Pictures(e, pictures_).asked(p.step),
      section.asked(question, p.step));
  questions_ += waiting(fmt::format("data-asked=\"{}\" data-preset=\"{}\"", name, p.preset), article);
  answers_ += program::html({program::answer(question, fmt::format("Question {}.", count_))});
}

Page ReviewPage::page(int number, const Neighbours& neighbours) const {
  Page page = {review_file(number), review_title(number), review_words(), {}, neighbours};
  page.body = fmt::format(
      "<div class=\"opening\">\n<h1>{}</h1>\n<p class=\"summary\">Eight questions from {}. What was wrong returns "
      "first.</p>\n</div>\n{}<div class=\"review\" data-review=\"{}\">\n{}</div>\n<div class=\"answers\">\n"
      "<h2>Answers</h2>\n{}</div>\n",
      review_title(number), lessons_, pictures_.shared(), number, questions_, answers_);
  return page;
}

}  // namespace isect::program::book
