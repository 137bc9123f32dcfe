// The report as a page: failures by cause, each with its pictures and what its tick accepts. report.js has the views,
// the keys and the ticks; without it everything stands there to read.

#include <fmt/format.h>

#include <algorithm>

#include "app/checks/causes.h"
#include "app/checks/check_report.h"
#include "app/checks/report_assets.h"
#include "app/checks/report_pictures.h"
#include "viz/formats/page_svg.h"

namespace isect::program {

namespace {

std::string figure_of(const char* type, const char* title, const std::string& source, const std::string& size) {
  const std::string content =
      source.empty() ? "<p class=\"none\">none</p>"
                     : fmt::format("<img alt=\"{}\" decoding=\"async\"{} src=\"{}\">", title, size, source);
  return fmt::format("<figure class=\"{}\"><figcaption>{}</figcaption>{}</figure>\n", type, title, content);
}

/// Returns old, new and difference; empty for what has no picture.
std::string views_of(const Failure& f, ReportPictures& pictures) {
  if (f.accepted_file.empty() && f.fresh_file.empty()) return {};
  if (f.baseline.ends_with(".tikz") || f.baseline.ends_with(".json")) return {};
  const auto shown = [&](const char* type, const char* title, const std::string& bytes) {
    return figure_of(type, title, pictures.source_of(f.baseline, bytes), size_attributes(bytes));
  };
  const std::string difference = f.difference_file.empty() ? "" : shown("difference", "Difference", f.difference_file);
  return "<div class=\"views\">\n" + shown("old", "Accepted", f.accepted_file) + shown("new", "New", f.fresh_file) +
         difference + "</div>\n";
}

/// Returns what is read besides: more differences, files, and the command for this preset.
std::string besides(const Report& r, const Failure& f) {
  std::string html;
  if (!f.more.empty()) {
    html += "<p>More differences:</p>\n<ul>\n";
    for (const std::string& more : f.more) html += fmt::format("<li>{}</li>\n", escaped(more));
    html += "</ul>\n";
  }
  for (const std::string& line : details(f)) html += fmt::format("<p class=\"path\">{}</p>\n", escaped(line));
  if (const std::string command = accept_command(r, f); !command.empty())
    html += fmt::format("<p>To accept: <code>{}</code></p>\n", escaped(command));
  if (html.empty()) return html;
  return fmt::format("<details><summary>{}</summary>\n{}</details>\n",
                     f.more.empty() ? "Files and command" : "More differences, files and command", html);
}

std::string article_of(const Report& r, const Failure& f, std::size_t number, ReportPictures& pictures) {
  const bool ticked = !f.accepted && may_be_accepted(f) && !f.reviewed.empty();
  std::string html = fmt::format("<article id=\"change-{}\" tabindex=\"-1\" data-preset=\"{}\"{}>\n", number,
                                 escaped(f.lesson + "/" + f.preset),
                                 ticked ? fmt::format(" data-accept=\"{}\"", escaped(reviewed_json(f.reviewed))) : "");
  html += fmt::format("<h3>{}</h3>\n<p><b>{}</b>: {}</p>\n", escaped(where(f)), name_of(f.kind), escaped(f.what));
  if (const std::string measure = viz::in_words(f.eye); !measure.empty())
    html += fmt::format("<p class=\"measure\">{}.</p>\n", escaped(measure));
  html += views_of(f, pictures) + besides(r, f);
  if (f.accepted)
    html += f.kind == Failure::Kind::orphan ? "<p>Removed in this run.</p>\n" : "<p>Accepted in this run.</p>\n";
  return html + "</article>\n";
}

/// Returns "50 pictures and 10 traces differ".
std::string headline(const Report& r) {
  std::vector<const Failure*> open;
  for (const Failure& f : r.failures)
    if (!f.accepted) open.push_back(&f);
  if (open.empty()) return r.failures.empty() ? "All is as accepted" : "All was accepted";
  return counted(open) + " to look at";
}

constexpr std::string_view report_page = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>isect check{}</title>
<style>
:root {{ color-scheme: light dark; {}}}
@media screen and (prefers-color-scheme: dark) {{ :root {{ {}}} }}
{}</style>
</head>
<body>
<a class="skip" href="#changes">Skip to the first change</a>
<header>
<h1>{}</h1>
{}</header>
<main id="changes" data-command="{}">
{}</main>
<script>
{}</script>
</body>
</html>
)";

/// Returns the list of causes, each a link.
std::string index_of(const std::vector<CauseGroup>& groups) {
  if (groups.empty()) return {};
  std::string html = "<nav aria-label=\"Causes\">\n<ol>\n";
  for (std::size_t i = 0; i < groups.size(); ++i)
    html += fmt::format("<li><a href=\"#cause-{}\">{}</a></li>\n", i + 1, escaped(heading(groups[i])));
  return html + "</ol>\n</nav>\n";
}

std::string sections_of(const Report& r, const std::vector<CauseGroup>& groups, ReportPictures& pictures) {
  std::string html;
  std::size_t number = 0;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    html += fmt::format("<section id=\"cause-{0}\" aria-labelledby=\"head-{0}\">\n<h2 id=\"head-{0}\">{1}</h2>\n",
                        i + 1, escaped(heading(groups[i])));
    for (const Failure* f : groups[i].failures) html += article_of(r, *f, ++number, pictures);
    html += "</section>\n";
  }
  std::string settled;
  for (const Failure& f : r.failures)
    if (f.accepted) settled += article_of(r, f, ++number, pictures);
  if (!settled.empty()) html += "<section>\n<h2>Accepted in this run</h2>\n" + settled + "</section>\n";
  return html;
}

}  // namespace

bool begins_html_report(const std::string& bytes) {
  return bytes.starts_with(report_page.substr(0, report_page.find("{}</title>")));
}

HtmlReport to_html(const Report& r, const std::string& file, std::size_t most_inside) {
  ReportPictures pictures(r, file, most_inside);
  const std::vector<CauseGroup> groups = by_cause(r);
  const std::string head = headline(r), sections = sections_of(r, groups, pictures);
  std::string top = fmt::format("<p>{}</p>\n", escaped(summary(r)));
  if (const std::string command = accept_command(r); !command.empty())
    top += fmt::format("<p>To accept all of it: <code>{}</code></p>\n", escaped(command));
  top += index_of(groups);
  for (const std::string& left : r.left_alone)
    top += fmt::format("<p class=\"path\">Left alone: {}.</p>\n", escaped(left_alone_text(left)));
  const viz::PageColours colours;
  HtmlReport made = pictures.take();
  made.page =
      fmt::format(report_page, ": " + escaped(head), colours.variables(false), colours.variables(true), report_style(),
                  escaped(head), top, escaped(accept_file_command(r)), sections, report_script());
  return made;
}

}  // namespace isect::program
