#include "app/book/contents_page.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/book/pictures.h"
#include "app/book/review_page.h"
#include "app/pages/html.h"
#include "viz/formats/svg_path.h"
#include "viz/text/rich_text.h"
#include "viz/walk/closing.h"
#include "viz/walk/review.h"

namespace isect::program::book {

namespace {

/// Returns which lessons of the book one builds on.
std::string built_on(const viz::Lesson& lesson, const std::vector<const viz::Lesson*>& lessons) {
  std::string all;
  for (const viz::Lesson* other : lessons)
    if (std::ranges::count(lesson.after, other->id) > 0)
      all += fmt::format("{}<a href=\"{}\">{}</a>", all.empty() ? "" : ", ", file_of(*other),
                         html_text(viz::short_title(*other)));
  return all.empty() ? all : fmt::format("<p class=\"after\">Builds on {}.</p>\n", all);
}

/// Returns a lesson in the list; cover.js adds what its reader has done.
std::string card(const Excerpt& e, const std::vector<const viz::Lesson*>& lessons, viz::PagePictures& pictures) {
  const viz::Lesson& lesson = *e.lesson;
  const auto number = std::ranges::find(lessons, &lesson) - lessons.begin() + 1;
  return fmt::format(
      "<li data-of=\"{}\" data-exercises=\"{}\"><a href=\"{}\">{}<h3><span>{}</span> {}</h3></a>\n<p>{}</p>\n{}"
      "<p class=\"facts\">About {}</p></li>\n",
      lesson.id, lesson.closing ? lesson.closing->exercises.size() : 0, file_of(lesson),
      Pictures(e, pictures).of(viz::outcome(e.walk)), number, html_text(lesson.title), html_text(lesson.summary),
      built_on(lesson, lessons), duration(minutes_of(e.walk)));
}

}  // namespace

Page contents_page(const std::vector<Excerpt>& openings, const viz::Course& course, const Compiled& compiled,
                   const std::string& playlists, viz::PageColours& colours) {
  viz::PagePictures page(colours);
  std::string parts;
  bool open = false;
  std::vector<const viz::Lesson*> lessons;
  for (const Excerpt& e : openings) lessons.push_back(e.lesson);
  for (const Excerpt& e : openings) {
    const viz::Lesson& lesson = *e.lesson;
    const auto part = std::ranges::find(course.parts, lesson.id, &viz::Course::Part::first);
    if (!open || part != course.parts.end()) {
      if (open) parts += "</ol>\n";
      if (part != course.parts.end()) parts += fmt::format("<h2>{}</h2>\n", viz::xml_escaped(part->title));
      parts += "<ol class=\"lessons\">\n";
      open = true;
    }
    parts += card(e, lessons, page);
    if (const int number = viz::review_after(lessons, lesson))
      parts += fmt::format(
          "<li class=\"review-link\" data-review=\"{}\"><a href=\"{}\"><h3>{}</h3></a>\n<p>{}</p>\n"
          "<p class=\"facts\"></p></li>\n",
          number, review_file(number), review_title(number), review_words());
  }
  if (open) parts += "</ol>\n";
  const std::string top = cover(openings, compiled, page);
  const std::string hours =
      playlists.empty()
          ? ""
          : fmt::format("<section class=\"playlists\">\n<h2>Playlists</h2>\n<ul>\n{}</ul>\n</section>\n", playlists);
  Page contents = {"index.html",
                   "Intersection detection, step by step",
                   fmt::format("{} lessons on whether shapes meet, and where: each walks through a test line by line, "
                               "with pictures, questions, exercises and exact verdicts.",
                               lessons.size()),
                   {},
                   {},
                   true};
  contents.body =
      "<div class=\"opening\">\n<h1>Intersection detection, step by step</h1>\n"
      "<p class=\"summary\">Do two shapes meet, and where? Each lesson walks through a test as it runs, line by line, "
      "with its values and its picture. All verdicts are exact for the numbers given.</p>\n</div>\n" +
      page.shared() + top + hours + parts + terms_to_find(course);
  return contents;
}

Page glossary_page(const viz::Course& course, const std::vector<const viz::Lesson*>& lessons) {
  Page page = {"glossary.html", "Terms", "The terms of the course, each in a sentence.", {}, {}};
  page.body = "<div class=\"opening\">\n<h1>Terms</h1>\n</div>\n<dl class=\"terms\">\n";
  for (const viz::Course::Term& term : course.terms) {
    page.body += fmt::format("<dt id=\"{}\">{}</dt>\n<dd>{}", viz::xml_escaped(term_id(term)),
                             viz::xml_escaped(term.name), html_text(term.meaning));
    const auto lesson = std::ranges::find(lessons, term.lesson, &viz::Lesson::id);
    if (lesson != lessons.end())
      page.body += fmt::format(" <a href=\"{}\">{}</a>", file_of(**lesson), html_text((*lesson)->title));
    page.body += "</dd>\n";
  }
  page.body += "</dl>\n";
  return page;
}

}  // namespace isect::program::book
