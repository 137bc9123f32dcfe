#include "app/book/lesson_page.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "app/book/pictures.h"
#include "app/book/review_page.h"
#include "app/book/walk_section.h"
#include "app/pages/html.h"
#include "viz/formats/svg_path.h"
#include "viz/text/rich_text.h"
#include "viz/walk/closing.h"
#include "viz/walk/exercise_text.h"
#include "viz/walk/review.h"

namespace isect::program::book {

namespace {

using viz::xml_escaped;

std::string prose(const std::string& markup) { return html(Blocks{Prose{markup}}); }

/// Returns links to the walks, a list for each method.
std::string settings(const std::vector<Excerpt>& presets, const viz::Lesson& lesson) {
  std::string out = "<nav class=\"settings\" aria-label=\"Settings\">\n", group;
  bool open = false;
  for (std::size_t i = 0; i < presets.size(); ++i) {
    const viz::Preset& p = lesson.presets[i];
    if (!open || p.group != group) {
      if (open) out += "</ul>\n";
      if (!p.group.empty())
        out +=
            fmt::format("<h2>{}</h2>\n", html_text(presets[i].walk.method.empty() ? p.group : presets[i].walk.method));
      out += "<ul>\n";
      group = p.group, open = true;
    }
    out += fmt::format("<li><a href=\"#{}\">{}</a></li>\n", p.id, html_text(p.title));
  }
  return out + (open ? "</ul>\n" : "") + "</nav>\n";
}

/// Returns the address of the step where an exercise begins: the first in which the point to be moved has a handle.
std::string start_of(const viz::Lesson& lesson, const viz::Exercise& e) {
  const std::vector<viz::Step> steps = lesson.walk(viz::preset(lesson, e.preset).parameters).steps;
  for (std::size_t i = 0; i < steps.size(); ++i)
    for (const viz::Handle& h : steps[i].scene.handles)
      if (std::ranges::count(e.by, h.parameter, &std::pair<std::string, std::string>::first) > 0)
        return i == 0 ? e.preset : fmt::format("{}/{}", e.preset, i + 1);
  return e.preset;
}

std::string exercises(const viz::Lesson& lesson) {
  const std::vector<viz::Exercise>& all = lesson.closing->exercises;
  if (all.empty()) return {};
  std::string out = "<section class=\"exercises\" id=\"exercises\">\n<h2>Exercises</h2>\n<ol>\n", solutions;
  int number = 0;
  for (const viz::Exercise& e : all) {
    out += "<li>\n" + prose(e.prompt) + html(shown_program(lesson, e));
    if (!e.preset.empty())
      out += fmt::format("<p class=\"start\">Start from <a href=\"#{}\">{}</a>.</p>\n", start_of(lesson, e),
                         html_text(viz::preset(lesson, e.preset).title));
    out += folded(viz::solution_head(e), prose(e.solution)) + "</li>\n";
    solutions += html(Blocks{Prose{e.solution, fmt::format("Exercise {}.", ++number)}});
  }
  out += "</ol>\n";
  if (const std::optional<viz::Judge> own = viz::judge(lesson))
    out += fmt::format("{}<pre class=\"judge\">{}</pre>\n", prose(own->told),
                       viz::xml_escaped(fmt::format("{}", fmt::join(own->command, "\n"))));
  return out + "<div class=\"answers\">\n<h3>Solutions</h3>\n" + solutions + "</div>\n</section>\n";
}

std::string link(const viz::Lesson& to, bool alone) {
  const std::string title = html_text(viz::short_title(to));
  return alone ? title : fmt::format("<a href=\"{}\">{}</a>", file_of(to), title);
}

/// Returns a row of the card: each of the lesson's ideas, with links to the lessons where it occurs again.
std::string same_ideas(const viz::Lesson& lesson, bool alone) {
  std::string out;
  for (const viz::SharedIdea& shared : viz::shared_ideas(lesson)) {
    std::vector<std::string> others;
    for (const viz::Lesson* other : shared.others) others.push_back(link(*other, alone));
    out += fmt::format("<dd>{}: {}.</dd>\n", html_text(viz::heading(shared)), fmt::join(others, ", "));
  }
  return out.empty() ? out : fmt::format("<dt>{}</dt>\n{}", viz::tr(viz::shared_head), out);
}

std::string closing(const viz::Lesson& lesson, bool alone) {
  if (!lesson.closing) return {};
  std::string out = "<section class=\"closing\" id=\"remember\">\n<h2>What to remember</h2>\n<dl>\n";
  for (const auto& [head, text] : viz::card_rows(*lesson.closing))
    out += fmt::format("<dt>{}</dt>\n<dd>{}</dd>\n", html_text(head), html_text(text));
  out += same_ideas(lesson, alone) + "</dl>\n";
  if (const std::string& bug = lesson.closing->bug_preset; !bug.empty())
    out += fmt::format("<p>Where it matters: <a href=\"#{}\">{}</a>.</p>\n", bug,
                       html_text(viz::preset(lesson, bug).title));
  out += "</section>\n" + exercises(lesson);
  if (lesson.closing->reading.empty()) return out;
  out += "<section class=\"reading-list\" id=\"reading\">\n<h2>To read</h2>\n<ul>\n";
  for (const std::string& source : lesson.closing->reading) out += fmt::format("<li>{}</li>\n", html_text(source));
  return out + "</ul>\n</section>\n";
}

/// Returns what stands at the end of every fifth lesson.
std::string review_of(const viz::Lesson& lesson, const std::vector<const viz::Lesson*>& course) {
  const int number = viz::review_after(course, lesson);
  if (number == 0) return {};
  return fmt::format(
      "<section class=\"next-review\" id=\"review\">\n<h2>{0}</h2>\n<p>{1} <a href=\"{2}\">{0}</a></p>\n"
      "</section>\n",
      review_title(number), review_words(), review_file(number));
}

std::string builds_on(const viz::Lesson& lesson, const std::vector<const viz::Lesson*>& course, bool alone) {
  std::vector<std::string> all;
  for (const viz::Lesson* other : course)
    if (std::ranges::count(lesson.after, other->id) > 0)
      all.push_back(alone ? html_text(other->title)
                          : fmt::format("<a href=\"{}\">{}</a>", file_of(*other), html_text(other->title)));
  return all.empty() ? "" : fmt::format("<p class=\"after\">Builds on {}.</p>\n", fmt::join(all, ", "));
}

}  // namespace

std::string walk_section(const Excerpt& e, const viz::Preset& as, bool first, viz::PagePictures& page,
                         const std::string& end) {
  Pictures pictures(e, page);
  const auto picture = [&](const Station& at) { return at.asks ? pictures.asked(at.step) : pictures.of(at.step); };
  const bool known = e.walk.method.empty() || e.walk.method == as.title;
  const std::string method = known ? "" : fmt::format(" <small>{}</small>", html_text(e.walk.method));
  const std::string section =
      fmt::format("<section class=\"walk{}{}\" id=\"{}\">\n<h2>{}{}</h2>\n{}{}</section>\n", first ? " shown" : "",
                  viz::has_time(e.walk) ? " moves" : "", as.id, html_text(as.title), method,
                  WalkSection({*e.lesson, e.parameters, e.walk}, as.id, picture).html(first), end);
  return first ? section : waiting(fmt::format("data-setting=\"{}\"", as.id), section);
}

Page lesson_page(const viz::Lesson& lesson, const std::vector<Excerpt>& presets,
                 const std::vector<const viz::Lesson*>& course, const Neighbours& neighbours,
                 viz::PageColours& colours) {
  viz::PagePictures pictures(colours);
  std::string walks;
  for (std::size_t i = 0; i < presets.size(); ++i)
    walks += walk_section(presets[i], lesson.presets[i], i == 0, pictures);
  Page page = {file_of(lesson), viz::plain(lesson.title), viz::plain(lesson.summary), {}, neighbours, false, lesson.id};
  page.body = fmt::format(
                  "<div class=\"opening\">\n<h1>{}</h1>\n<p class=\"summary\">{}</p>\n"
                  "<div class=\"about\">\n{}{}</div>\n</div>\n",
                  html_text(lesson.title), html_text(lesson.summary), prose(lesson.opening),
                  builds_on(lesson, course, neighbours.alone)) +
              pictures.shared() + settings(presets, lesson) + "<div id=\"walks\">\n" + walks + "</div>\n" +
              closing(lesson, neighbours.alone) + (neighbours.alone ? std::string() : review_of(lesson, course));
  return page;
}

}  // namespace isect::program::book
