#include "app/book/lesson_page.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "app/book/pictures.h"
#include "app/geometry.h"
#include "app/pages/html.h"
#include "app/told_setting.h"
#include "viz/alt_text.h"
#include "viz/closing.h"
#include "viz/rich_text.h"
#include "viz/svg_path.h"

namespace isect::program::book {

namespace {

using viz::xml_escaped;

std::string prose(const std::string& markup) { return html(Blocks{Prose{markup}}); }

/// Of the answer to a question, and of the solution of an exercise: unfolded by a click, never on paper.
std::string folded(const std::string& head, const std::string& markup) {
  return fmt::format("<details><summary>{}</summary>\n{}</details>\n", head, prose(markup));
}

std::string numbers(const std::vector<int>& lines) { return fmt::format("{}", fmt::join(lines, " ")); }

class WalkSection {
 public:
  WalkSection(const Excerpt& e, const viz::Preset& preset, bool first, viz::PagePictures& page)
      : e_(e), preset_(preset), first_(first), pictures_(e, page) {}

  std::string html() {
    const bool known = e_.walk.method.empty() || e_.walk.method == preset_.title;
    const std::string method = known ? "" : fmt::format(" <small>{}</small>", html_text(e_.walk.method));
    std::string out = fmt::format("<section class=\"walk{}\" id=\"{}\">\n<h2>{}{}</h2>\n", first_ ? " shown" : "",
                                  preset_.id, html_text(preset_.title), method) +
                      given() + algorithm() + "<div class=\"steps\">\n";
    for (int i = 0; i < static_cast<int>(e_.walk.steps.size()); ++i) {
      const viz::Step& s = e_.walk.steps[i];
      if (s.slug == viz::closing_slug) continue;  // stands on the page once
      if (s.question) out += ask(*s.question, i);
      out += step(s, i);
    }
    return out + "</div>\n" + opinions() + answers() + "</section>\n";
  }

 private:
  std::string given() const {
    std::vector<std::string> all;
    for (const viz::Parameter& p : e_.lesson->parameters)
      if (e_.parameters.contains(p.name) && p.name != e_.lesson->group_by)
        all.push_back(fmt::format("{} = {}", html_text(p.label.empty() ? p.name : p.label),
                                  xml_escaped(in_full(e_.parameters.at(p.name), e_.lesson->flat))));
    std::string out = fmt::format("<p class=\"given\"><b class=\"head\">Given</b> {}.", fmt::join(all, ", "));
    const viz::Scene& scene = e_.walk.steps.front().scene;
    if (!scene.chart)
      for (const std::string& object : geometry(scene, e_.parameters, e_.lesson->flat))
        out += " " + xml_escaped(object.ends_with(".") ? object : object + ".");
    return out + "</p>\n";
  }

  std::string algorithm() const {
    if (e_.walk.pseudocode.empty()) return {};
    std::string out =
        "<div class=\"algorithm\">\n<h3>Algorithm</h3>\n" + program::html(Blocks{Code{e_.walk.pseudocode}});
    for (const std::string& erratum : told_errata(e_))
      out += fmt::format("<p class=\"erratum\">{}</p>\n", xml_escaped(erratum));
    return out + "</div>\n";
  }

  std::string id(int step) const { return fmt::format("{}/{}", preset_.id, step + 1); }

  /// Before its step, whose title may be the answer.
  std::string ask(const viz::Question& q, int index) {
    std::string choices;
    for (std::size_t i = 0; i < q.choices.size(); ++i)
      choices +=
          fmt::format("<li{}>{}</li>\n", static_cast<int>(i) == q.answer ? " data-right" : "", html_text(q.choices[i]));
    answers_.push_back(answer(q));
    return fmt::format(
        "<article class=\"ask\" id=\"{}/question\">\n{}<h3>Question {}</h3>\n<div class=\"words\">\n{}<ol "
        "class=\"choices\">\n{}"
        "</ol>\n{}</div>\n</article>\n",
        id(index), index > 0 ? pictures_.asked(index) : "", answers_.size(), prose(q.prompt), choices,
        folded("Answer", answer(q)));
  }

  std::string step(const viz::Step& s, int index) {
    std::string attributes;
    if (s.line >= 0) attributes += fmt::format(" data-line=\"{}\"", s.line);
    if (!s.refused.empty()) attributes += fmt::format(" data-refused=\"{}\"", numbers(s.refused));
    if (!s.untaken.empty()) attributes += fmt::format(" data-untaken=\"{}\"", numbers(s.untaken));
    if (s.decides) attributes += " data-decides";
    std::string out =
        fmt::format("<article class=\"step{}\" id=\"{}\"{}>\n<h3><span>{}</span> {}</h3>\n",
                    first_ && index == 0 ? " shown" : "", id(index), attributes, index + 1, html_text(s.title));
    out += pictures_.of(index);
    out += "<div class=\"words\">\n" + prose(caption(s));
    if (!s.formula.empty()) out += fmt::format("<p class=\"formula\">{}</p>\n", html_text(s.formula));
    out += verdict(s.verdict) + source(s.source) + "</div>\n";
    const std::string counted = line(s) + values(s) + comparison(s);
    if (!counted.empty()) out += "<div class=\"numbers\">\n" + counted + "</div>\n";
    return out + "</article>\n";
  }

  /// The lesson's opening stands above all walks.
  std::string caption(const viz::Step& s) const {
    if (s.slug == viz::opening_slug) return "This is what is given.";
    return viz::own_caption(*e_.lesson, s);
  }

  static std::string verdict(const viz::Verdict& v) {
    using Kind = viz::Verdict::Kind;
    if (v.text.empty()) return {};
    const char* kind = v.kind == Kind::yes ? "yes" : v.kind == Kind::no ? "no" : v.kind == Kind::on ? "on" : "open";
    return fmt::format("<p class=\"verdict {}\">{}</p>\n", kind, html_text(v.text));
  }

  std::string source(const std::string& text) {
    if (text.empty() || text == source_) return {};
    source_ = text;
    return fmt::format("<p class=\"source\">{}</p>\n", html_text(text));
  }

  std::string line(const viz::Step& s) const {
    if (s.line < 0) return {};
    return fmt::format("<p class=\"line\">Line {} <code>{}</code>{}</p>\n", s.line + 1,
                       xml_escaped(viz::unindented(e_.walk.pseudocode.at(static_cast<std::size_t>(s.line)))),
                       std::ranges::count(s.refused, s.line) > 0 ? " <b class=\"refused\">no</b>" : "");
  }

  /// All that is known; on paper, and where there are no scripts, what is new.
  static std::string values(const viz::Step& s) {
    if (s.values.empty()) return {};
    const bool fresh = std::ranges::any_of(s.values, &viz::Value::fresh);
    std::string out = fmt::format("<table class=\"values{}\">\n<caption>Values</caption>\n", fresh ? "" : " known");
    for (const viz::Value& v : s.values)
      out += fmt::format("<tr{}><th scope=\"row\">{}</th><td>{}</td>{}</tr>\n", v.fresh ? " class=\"fresh\"" : "",
                         html_text(v.name), xml_escaped(viz::shown_among(s.values, v)),
                         v.fresh ? "<td>new</td>" : "<td></td>");
    return out + "</table>\n";
  }

  static std::string comparison(const viz::Step& s) {
    if (!s.comparison) return {};
    const viz::Comparison& c = *s.comparison;
    const auto [left, right] = viz::shown_apart(c.left, c.right);
    return fmt::format("<p class=\"comparison {}\">{}? <b>{}</b>, by {} and {}{}.</p>\n", c.holds ? "yes" : "no",
                       html_text(c.text), c.holds ? "Yes" : "No", xml_escaped(left), xml_escaped(right),
                       c.meaning.empty() ? "" : ": " + html_text(c.meaning));
  }

  /// What the methods say that should agree.
  std::string opinions() const {
    if (!e_.lesson->opinions) return {};
    const std::vector<viz::Opinion> all = e_.lesson->opinions(e_.parameters);
    if (all.empty()) return {};
    std::string rows;
    for (const viz::Opinion& o : all)
      rows +=
          fmt::format("<tr class=\"{}\"><td>{}</td><th scope=\"row\">{}</th><td>{}</td></tr>\n",
                      o.agrees ? "agrees" : "differs", o.agrees ? "✓" : "✗", html_text(o.method), html_text(o.says));
    return fmt::format("<table class=\"opinions\">\n<caption>Methods side by side</caption>\n{}</table>\n", rows);
  }

  std::string answers() const {
    if (answers_.empty()) return {};
    std::string out = "<div class=\"answers\">\n<h3>Answers</h3>\n";
    for (std::size_t i = 0; i < answers_.size(); ++i)
      out += program::html(Blocks{Prose{answers_[i], fmt::format("Question {}.", i + 1)}});
    return out + "</div>\n";
  }

  const Excerpt& e_;
  const viz::Preset& preset_;
  const bool first_;
  Pictures pictures_;
  std::vector<std::string> answers_;
  std::string source_;  ///< the last one told
};

/// Links to the walks, a list for each method.
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

std::string exercises(const viz::Lesson& lesson) {
  const std::vector<viz::Exercise>& all = lesson.closing->exercises;
  if (all.empty()) return {};
  std::string out = "<section class=\"exercises\" id=\"exercises\">\n<h2>Exercises</h2>\n<ol>\n", solutions;
  int number = 0;
  for (const viz::Exercise& e : all) {
    out += "<li>\n" + prose(e.prompt);
    if (!e.preset.empty())
      out += fmt::format("<p class=\"start\">Start from <a href=\"#{}\">{}</a>.</p>\n", e.preset,
                         html_text(viz::preset(lesson, e.preset).title));
    out += folded("Solution", e.solution) + "</li>\n";
    solutions += html(Blocks{Prose{e.solution, fmt::format("Exercise {}.", ++number)}});
  }
  return out + "</ol>\n<div class=\"answers\">\n<h3>Solutions</h3>\n" + solutions + "</div>\n</section>\n";
}

std::string closing(const viz::Lesson& lesson) {
  if (!lesson.closing) return {};
  std::string out = "<section class=\"closing\" id=\"remember\">\n<h2>What to remember</h2>\n<dl>\n";
  for (const auto& [head, text] : viz::card_rows(*lesson.closing))
    out += fmt::format("<dt>{}</dt>\n<dd>{}</dd>\n", html_text(head), html_text(text));
  out += "</dl>\n";
  if (const std::string& bug = lesson.closing->bug_preset; !bug.empty())
    out += fmt::format("<p>See the bug: <a href=\"#{}\">{}</a>.</p>\n", bug, html_text(viz::preset(lesson, bug).title));
  out += "</section>\n" + exercises(lesson);
  if (lesson.closing->reading.empty()) return out;
  out += "<section class=\"reading-list\" id=\"reading\">\n<h2>To read</h2>\n<ul>\n";
  for (const std::string& source : lesson.closing->reading) out += fmt::format("<li>{}</li>\n", html_text(source));
  return out + "</ul>\n</section>\n";
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

Page lesson_page(const viz::Lesson& lesson, const std::vector<Excerpt>& presets,
                 const std::vector<const viz::Lesson*>& course, const Neighbours& neighbours,
                 viz::PageColours& colours) {
  viz::PagePictures pictures(colours);
  std::string walks;
  for (std::size_t i = 0; i < presets.size(); ++i)
    walks += WalkSection(presets[i], lesson.presets[i], i == 0, pictures).html();
  Page page = {file_of(lesson), viz::plain(lesson.title), viz::plain(lesson.summary), {}, neighbours};
  page.body = fmt::format("<div class=\"opening\">\n<h1>{}</h1>\n<p class=\"summary\">{}</p>\n{}{}</div>\n",
                          html_text(lesson.title), html_text(lesson.summary), prose(lesson.opening),
                          builds_on(lesson, course, neighbours.alone)) +
              pictures.shared() + settings(presets, lesson) + "<div id=\"walks\">\n" + walks + "</div>\n" +
              closing(lesson);
  return page;
}

}  // namespace isect::program::book
