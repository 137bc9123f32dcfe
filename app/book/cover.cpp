#include "app/book/cover.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/book/pictures.h"
#include "app/book/scene_page.h"
#include "app/book/walk_section.h"
#include "app/pages/html.h"
#include "viz/formats/svg_path.h"
#include "viz/text/rich_text.h"
#include "viz/walk/closing.h"

namespace isect::program::book {

namespace {

/// The lesson whose picture invites; where a book lacks it, its first.
constexpr const char* inviting = "ray-sphere";
constexpr double seconds_a_station = 20;

/// Returns the picture of a lesson's outcome and its verdict. hero.js makes it one that can be dragged.
std::string hero(const Excerpt& e, const Compiled& compiled, viz::PagePictures& pictures) {
  const viz::Lesson& lesson = *e.lesson;
  const int step = viz::outcome(e.walk);
  const WalkSection section({lesson, e.parameters, e.walk}, e.preset, nullptr);
  const std::string code = compiled.lessons ? fmt::format(" data-code=\"{}\"", live_file) : "";
  return fmt::format(
      "<div class=\"hero\" data-shows=\"{}\" data-preset=\"{}\" data-step=\"{}\"{}>\n{}<div "
      "class=\"outcome\">\n{}</div>\n"
      "<p class=\"hint\"><span>{}</span> <a href=\"{}\">{}</a></p>\n</div>\n",
      lesson.id, viz::xml_escaped(e.preset), step, code, Pictures(e, pictures).of(step), section.outcome(),
      html_text(lesson.summary), file_of(lesson), html_text(viz::short_title(lesson)));
}

}  // namespace

std::string cover(const std::vector<Excerpt>& openings, const Compiled& compiled, viz::PagePictures& pictures) {
  if (openings.empty()) return {};
  const auto is_inviting = [](const Excerpt& e) { return e.lesson->id == inviting; };
  const auto found = std::ranges::find_if(openings, is_inviting);
  const Excerpt& shown = found == openings.end() ? openings.front() : *found;
  const viz::Lesson& first = *openings.front().lesson;
  int minutes = 0;
  for (const Excerpt& e : openings) minutes += minutes_of(e.walk);
  const std::string scenes =
      compiled.scenes ? fmt::format("<li><a href=\"{}\">A scene of your own</a></li>\n", scene_file) : "";
  return fmt::format(
      "<section class=\"cover\" aria-label=\"Begin\">\n{}<div class=\"go\">\n"
      "<p><a class=\"begin\" href=\"{}\">Begin with “{}”</a></p>\n"
      "<p class=\"facts\">{} lessons in order, about {} in all.</p>\n"
      "<ul class=\"links\">\n<li><a href=\"glossary.html\">The terms of the course</a></li>\n{}</ul>\n"
      "</div>\n</section>\n",
      hero(shown, compiled, pictures), file_of(first), html_text(viz::short_title(first)), openings.size(),
      duration(minutes), scenes);
}

std::string terms_to_find(const viz::Course& course) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const viz::Course::Term& term : course.terms)
    all.push_back({term.name, viz::plain(term.meaning), term_id(term)});
  std::string text = all.dump();
  for (std::size_t at = text.find('<'); at != text.npos; at = text.find('<', at)) text.replace(at, 1, "\\u003c");
  return fmt::format("<script type=\"application/json\" id=\"terms\">{}</script>\n", text);
}

int minutes_of(const viz::Walk& walk) {
  const double seconds = seconds_a_station * static_cast<double>(stations(walk).size());
  return std::max(1, static_cast<int>(std::lround(seconds / 60)));
}

std::string duration(int minutes) {
  const bool hours = minutes >= 60;
  const long count = hours ? std::lround(minutes / 60.0) : minutes;
  return fmt::format("{} {}{}", count, hours ? "hour" : "minute", count == 1 ? "" : "s");
}

std::string term_id(const viz::Course::Term& term) {
  std::string name = term.name;
  std::ranges::replace(name, ' ', '-');
  return "term-" + name;
}

}  // namespace isect::program::book
