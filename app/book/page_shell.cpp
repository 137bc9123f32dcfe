#include "app/book/page_shell.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/pages/html.h"
#include "viz/formats/svg_path.h"

namespace isect::program::book {

namespace {

std::string link(const viz::Lesson* lesson, const char* relation, const char* arrow_before, const char* arrow_after) {
  if (!lesson) return {};
  return fmt::format("<a rel=\"{}\" href=\"{}\">{}{}{}</a>\n", relation, file_of(*lesson), arrow_before,
                     html_text(lesson->title), arrow_after);
}

/// `element`: "header" or "footer"; `name` tells the two apart; `more`: a link besides.
std::string course_links(const Page& page, const char* element, const char* name, const char* more = "") {
  const Neighbours& n = page.neighbours;
  if (n.alone || page.is_contents) return {};
  return fmt::format(
      "<{0}>\n<nav class=\"course\" aria-label=\"{1}\">\n{2}<a href=\"index.html\">Contents</a>\n{3}{4}</nav>\n"
      "</{0}>\n",
      element, name, link(n.before, "prev", "<span aria-hidden=\"true\">← </span>", ""), more,
      link(n.after, "next", "", "<span aria-hidden=\"true\"> →</span>"));
}

std::string attributes_of_body(const Page& page, bool lives) {
  if (page.is_contents) return " class=\"contents\"";
  if (page.lesson.empty()) return {};
  const std::string live =
      lives ? fmt::format(" data-live=\"{}\"", page.neighbours.alone ? "#live-code" : page.live) : "";
  const std::string scorm =
      page.reported
          ? fmt::format(" data-scorm=\"{}\"", viz::xml_escaped(fmt::format("{}", fmt::join(*page.reported, " "))))
          : "";
  return fmt::format(" data-lesson=\"{}\"{}{}", page.lesson, live, scorm);
}

/// A ray that enters a ball, as in the window's corner.
constexpr const char* icon =
    "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-16 -16 32 32\" fill=\"none\" stroke-linecap=\"round\">"
    "<circle r=\"10.5\" fill=\"#e07b1f\" fill-opacity=\".16\" stroke=\"#e07b1f\" stroke-width=\"2\"/>"
    "<path d=\"M-15 5L15-6\" stroke=\"#2f86ea\" stroke-width=\"2.2\"/>"
    "<path d=\"M-9.5 3L10-4.2\" stroke=\"#12a074\" stroke-width=\"3\"/></svg>";

/// Returns what search engines and previews of links show, and the icon.
std::string told_of(const Page& page) {
  const std::string title = viz::xml_escaped(page.title), summary = viz::xml_escaped(page.summary);
  return fmt::format(
      "<meta name=\"description\" content=\"{1}\">\n<meta property=\"og:title\" content=\"{0}\">\n"
      "<meta property=\"og:description\" content=\"{1}\">\n<meta property=\"og:type\" content=\"{2}\">\n"
      "<link rel=\"icon\" href=\"{3}\">\n",
      title, summary, page.is_contents ? "website" : "article", viz::svg_address(icon));
}

}  // namespace

std::string mark(const std::string& file) { return fmt::format("Made by isect book: {}.", file); }

std::string file_of(const viz::Lesson& lesson) { return lesson.id + ".html"; }

std::string html(const Page& page, const Looks& looks) {
  // If scripts run, one step is shown at a time from the beginning.
  const std::string scripted = "<script>document.documentElement.className = \"scripted\"</script>\n";
  const std::string looks_of_page =
      page.neighbours.alone
          ? fmt::format("<style id=\"letters\">\n{}</style>\n<style>\n{}</style>\n", looks.fonts, looks.style)
          : "<link rel=\"stylesheet\" href=\"fonts.css\">\n<link rel=\"stylesheet\" href=\"book.css\">\n";
  const std::string head = fmt::format("<meta name=\"color-scheme\" content=\"light dark\">\n{}{}{}", told_of(page),
                                       looks_of_page, scripted);
  const bool lives = !looks.live.empty() && !page.lesson.empty();
  const std::string inside =
      lives ? fmt::format("<script type=\"text/plain\" id=\"live-code\">{}</script>\n", looks.live) : "";
  const std::string script = page.neighbours.alone
                                 ? fmt::format("{}<script>\n{}</script>\n", inside, looks.script)
                                 : "<script src=\"book.js\" onerror=\"document.documentElement.className = ''; "
                                   "for (const waits of document.querySelectorAll('noscript')) "
                                   "waits.outerHTML = waits.textContent\"></script>\n";
  const std::string body =
      fmt::format("<a class=\"skip\" href=\"#main\">Skip to the text</a>\n{}<main id=\"main\">\n{}</main>\n{}{}",
                  course_links(page, "header", "Course"), page.body,
                  course_links(page, "footer", "Course, again", "<a href=\"glossary.html\">Terms</a>\n"), script);
  return html_page(page.title, head, body, attributes_of_body(page, lives));
}

}  // namespace isect::program::book
