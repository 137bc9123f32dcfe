#include "app/book/contents_page.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/book/pictures.h"
#include "app/book/review_page.h"
#include "app/book/scene_page.h"
#include "app/pages/html.h"
#include "viz/formats/svg_path.h"
#include "viz/text/rich_text.h"
#include "viz/walk/closing.h"
#include "viz/walk/review.h"

namespace isect::program::book {

Page contents_page(const std::vector<Excerpt>& openings, const viz::Course& course, bool with_scene,
                   const std::string& links, viz::PageColours& colours) {
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
    parts +=
        fmt::format("<li><a href=\"{}\">{}<h3>{}</h3></a>\n<p>{}</p></li>\n", file_of(lesson),
                    Pictures(e, page).of(viz::outcome(e.walk)), html_text(lesson.title), html_text(lesson.summary));
    if (const int number = viz::review_after(lessons, lesson))
      parts += fmt::format("<li class=\"review-link\"><a href=\"{}\"><h3>{}</h3></a>\n<p>{}</p></li>\n",
                           review_file(number), review_title(number), review_words());
  }
  if (open) parts += "</ol>\n";
  Page contents = {"index.html", "Intersection detection, step by step", "Lessons of the course, in order.", {}, {},
                   true};
  contents.body =
      "<div class=\"opening\">\n<h1>Intersection detection, step by step</h1>\n"
      "<p class=\"summary\">Do two shapes meet, and where? Each lesson walks through a test as it runs, line by line, "
      "with its values and its picture. All verdicts are exact for the numbers given.</p>\n"
      "<p><a href=\"glossary.html\">The terms of the course</a></p>\n" +
      (with_scene ? fmt::format("<p><a href=\"{}\">A scene of your own</a></p>\n", scene_file) : "") + links +
      "</div>\n" + page.shared() + parts;
  return contents;
}

Page glossary_page(const viz::Course& course, const std::vector<const viz::Lesson*>& lessons) {
  Page page = {"glossary.html", "Terms", "The terms of the course, each in a sentence.", {}, {}};
  page.body = "<div class=\"opening\">\n<h1>Terms</h1>\n</div>\n<dl class=\"terms\">\n";
  for (const viz::Course::Term& term : course.terms) {
    page.body += fmt::format("<dt>{}</dt>\n<dd>{}", viz::xml_escaped(term.name), html_text(term.meaning));
    const auto lesson = std::ranges::find(lessons, term.lesson, &viz::Lesson::id);
    if (lesson != lessons.end())
      page.body += fmt::format(" <a href=\"{}\">{}</a>", file_of(**lesson), html_text((*lesson)->title));
    page.body += "</dd>\n";
  }
  page.body += "</dl>\n";
  return page;
}

}  // namespace isect::program::book
