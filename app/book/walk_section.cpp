#include "app/book/walk_section.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/book/lit_text.h"
#include "app/pages/html.h"
#include "viz/formats/svg_path.h"
#include "viz/lang/language.h"
#include "viz/text/rich_text.h"
#include "viz/walk/branch.h"
#include "viz/walk/closing.h"
#include "viz/walk/given_answer.h"
#include "viz/walk/given_order.h"
#include "viz/walk/pointed_line.h"
#include "viz/walk/question_scene.h"
#include "viz/walk/review.h"
#include "viz/walk/typed_answer.h"

namespace isect::program::book {

namespace {

using viz::xml_escaped;

std::string listed(const std::vector<int>& lines) { return fmt::format("{}", fmt::join(lines, " ")); }

std::string in_numbers(const std::string& html) {
  return html.empty() ? html : "<div class=\"numbers\">\n" + html + "</div>\n";
}

}  // namespace

std::vector<Station> stations(const viz::Walk& walk) {
  std::vector<Station> all;
  for (int i = 0; i < static_cast<int>(walk.steps.size()); ++i) {
    if (walk.steps[i].slug == viz::closing_slug) continue;
    if (walk.steps[i].question) all.push_back({i, true});
    all.push_back({i, false});
  }
  return all;
}

std::string folded(const std::string& head, const std::string& prose) {
  return fmt::format("<details><summary>{}</summary>\n{}</details>\n", head, prose);
}

std::string waiting(const std::string& attributes, const std::string& elements) {
  return fmt::format("<noscript {}>\n{}</noscript>\n", attributes, elements);
}

std::string WalkSection::html(bool first_is_shown) const {
  const std::vector<Station> all = stations(walk_);
  const std::string first = article(all.front(), first_is_shown);  // before the rest, which refers to what it has drawn
  std::string rest;
  for (std::size_t i = 1; i < all.size(); ++i) rest += article(all[i], false);
  if (first_is_shown && !rest.empty())
    rest = waiting(fmt::format("data-stations=\"{}\" data-steps=\"{}\"", all.size(),
                               std::ranges::count(all, false, &Station::asks)),
                   rest);
  return given() + "<div class=\"steps\">\n" + algorithm() + first + rest + "</div>\n" + opinions() + answers();
}

std::string WalkSection::text(const std::string& markup) const {
  return names_.empty() ? html_text(markup) : lit_text(markup, names_);
}

std::string WalkSection::in_its_language(const viz::Message& words, int n) const {
  const viz::Speaking speaking(lesson_.language);
  return viz::tr(words, {{"n", std::to_string(n)}});
}

std::string WalkSection::prose(const std::string& markup) const {
  std::string out;
  for (const std::string& paragraph : paragraphs(markup)) out += fmt::format("<p>{}</p>\n", text(paragraph));
  return out;
}

std::string WalkSection::given() const {
  return fmt::format("<p class=\"given\"><b class=\"head\">{}</b> {}</p>\n", in_its_language(viz::message("Given")),
                     text(program::given(lesson_, parameters_, walk_)));
}

std::string WalkSection::code(const std::string& line) const {
  return names_.empty() ? xml_escaped(line) : lit_line(line, names_);
}

std::string WalkSection::algorithm() const {
  if (walk_.pseudocode.empty()) return {};
  std::string out = "<div class=\"algorithm\">\n<h3>Algorithm</h3>\n<ol class=\"code\">\n";
  for (const std::string& line : walk_.pseudocode) {
    const std::size_t in = line.size() - viz::unindented(line).size();
    out += fmt::format("<li{}>{}</li>\n", in > 0 ? fmt::format(" style=\"--in: {}ch\"", in) : "", code(line));
  }
  out += "</ol>\n";
  for (const viz::ErratumText& erratum : viz::errata_text(lesson_, walk_))
    out += fmt::format("<p class=\"erratum\">{}</p>\n", text(viz::with_preset(erratum, &viz::Preset::title)));
  return out + "</div>\n";
}

std::string WalkSection::id(const Station& at) const {
  return fmt::format("{}/{}{}", id_, at.step + 1, at.asks ? "/question" : "");
}

std::string WalkSection::attributes(const Station& at) const {
  const viz::Step asked = at.asks ? viz::asking_step(walk_, at.step) : viz::Step();
  const viz::Step& s = at.asks ? asked : walk_.steps[at.step];
  std::string out;
  if (s.line >= 0) out += fmt::format(" data-line=\"{}\"", s.line);
  if (const std::string yes_or_no = said(at); !yes_or_no.empty()) out += fmt::format(" data-said=\"{}\"", yes_or_no);
  if (!s.refused.empty()) out += fmt::format(" data-refused=\"{}\"", listed(s.refused));
  if (!s.untaken.empty()) out += fmt::format(" data-untaken=\"{}\"", listed(s.untaken));
  if (s.decides) out += " data-decides";
  if (const std::string name = at.asks ? asked_name(at.step) : ""; !name.empty())
    out += fmt::format(" data-asked=\"{}\"", xml_escaped(name));
  return out;
}

std::string WalkSection::said(const Station& at) const {
  return at.asks ? std::string() : viz::said_at_line(viz::taken(walk_, at.step));
}

std::string WalkSection::asked_name(int step) const {
  if (!lesson_.made_from.empty()) return {};
  return lesson_.id + " " + viz::question_name(lesson_, parameters_, walk_.steps[step]);
}

std::string WalkSection::article(const Station& at, bool shown) const {
  const std::string picture = at.asks && at.step == 0 ? std::string() : picture_(at);
  return fmt::format("<article class=\"{}{}\" id=\"{}\"{}>\n{}{}{}</article>\n", at.asks ? "ask" : "step",
                     shown ? " shown" : "", id(at), attributes(at), above(at), picture, below(at));
}

/// Returns what stands above a picture. A question stands before its step, whose title may be the answer.
std::string WalkSection::above(const Station& at) const {
  if (at.asks) return {};
  return fmt::format("<h3><span>{}</span> {}</h3>\n", at.step + 1, text(walk_.steps[at.step].title));
}

std::string WalkSection::below(const Station& at) const {
  const viz::StepText told = viz::step_text(lesson_, walk_, at.step);
  return at.asks ? question(*told.question, at.step) : words(told, at.step) + numbers(told);
}

/// Returns the question and all that is known before it is answered.
std::string WalkSection::question(const viz::QuestionText& q, int step) const {
  return fmt::format("<h3>{}</h3>\n", in_its_language(viz::message("Question {n}"), q.number)) + asked(q, step);
}

std::string WalkSection::asked(const viz::QuestionText& q, int step) const {
  std::string tiles, choices;
  if (q.asked->order)
    for (const std::string& tile : q.asked->order->tiles) tiles += fmt::format("<li>{}</li>\n", text(tile));
  if (!tiles.empty()) tiles = fmt::format("<ol class=\"tiles\">\n{}</ol>\n", tiles);
  for (std::size_t i = 0; i < q.choices.size(); ++i) {
    const std::string reply = i == q.right ? "" : viz::reply_to(walk_, step, viz::GivenAnswer{static_cast<int>(i)});
    choices += fmt::format("<li{}{}>{}</li>\n", i == q.right ? " data-right" : "",
                           reply.empty() ? "" : fmt::format(" data-reply=\"{}\"", xml_escaped(html_text(reply))),
                           text(q.choices[i]));
  }
  return fmt::format("<div class=\"words\">\n{}{}<ol class=\"choices{}\"{}>\n{}</ol>\n{}</div>\n{}", prose(q.prompt),
                     tiles, q.asked->line || q.asked->order ? " hint" : "", asked_for(*q.asked, step), choices,
                     folded("Answer", prose(q.answer + " " + q.because)), in_numbers(values(q.known)));
}

/// Returns, as an attribute, what book.js needs to judge what is given as the answer; empty where that is a choice.
std::string WalkSection::asked_for(const viz::Question& q, int step) const {
  if (!viz::wants_more(q)) return {};
  nlohmann::json all = {{"choice", q.answer}, {"asks", viz::how_to_answer(q)}, {"wrong", nlohmann::json::array()}};
  const auto attribute = [&](const char* name) {
    return fmt::format(" data-{}=\"{}\"", name, xml_escaped(all.dump()));
  };
  if (q.line) {
    all["offered"] = q.line->offered, all["replies"] = nlohmann::json::array();
    for (const std::string& reply : viz::line_replies(walk_, step)) all["replies"].push_back(html_text(reply));
    return attribute("pointed");
  }
  if (q.order) {
    all["ranks"] = q.order->ranks, all["tiles"] = all["offered"] = nlohmann::json::array();
    for (const std::string& tile : q.order->tiles) all["tiles"].push_back(html_text(tile));
    for (const std::vector<int>& order : q.order->offered) all["offered"].push_back(viz::letters_of(order));
    for (const viz::WrongOrder& wrong : q.order->wrong)
      all["wrong"].push_back(nlohmann::json::array({viz::letters_of(wrong.order), html_text(wrong.reply)}));
    return attribute("order");
  }
  const viz::Numeric& number = *q.number;
  all["right"] = {number.truth, viz::tolerance(number, number.truth)};
  for (const viz::Reply& reply : viz::replies(number)) {
    const bool right = viz::is_right(number, reply.value);  // it has too few digits
    const int choice = right ? -1 : viz::choice_of(q, reply.value).value_or(-1);
    all["wrong"].push_back({reply.value, reply.tolerance, html_text(reply.text), choice});
  }
  return attribute("number");
}

std::string WalkSection::words(const viz::StepText& told, int step) const {
  const bool opens = walk_.steps[step].slug == viz::opening_slug;  // the opening stands above all walks
  std::string out = "<div class=\"words\">\n" +
                    prose(opens ? in_its_language(viz::message("This is what is given.")) : told.own_caption);
  if (!told.formula.empty()) out += fmt::format("<p class=\"formula\">{}</p>\n", text(told.formula));
  return out + verdict(told.verdict) + source(step) + "</div>\n";
}

std::string WalkSection::numbers(const viz::StepText& told) const {
  std::string out;
  if (const auto& line = told.line)
    out +=
        fmt::format("<p class=\"line\">{} <code>{}</code>{}</p>\n",
                    in_its_language(viz::message("Line {n}"), line->number), code(line->code),
                    line->said.empty()
                        ? ""
                        : fmt::format(" <b class=\"said {}\">{}</b>",
                                      line->said == in_its_language(viz::message("yes")) ? "yes" : "no", line->said));
  out += values(told.values);
  if (const auto& c = told.comparison)
    out += fmt::format("<p class=\"comparison {}\">{} <b>{}</b> {}</p>\n", c->holds ? "yes" : "no", text(c->question),
                       c->answer, text(c->why));
  return in_numbers(out);
}

std::string WalkSection::verdict(const viz::Verdict& v) const {
  using Kind = viz::Verdict::Kind;
  if (v.text.empty()) return {};
  const char* kind = v.kind == Kind::yes ? "yes" : v.kind == Kind::no ? "no" : v.kind == Kind::on ? "on" : "open";
  return fmt::format("<p class=\"verdict {}\">{}</p>\n", kind, text(v.text));
}

/// Returns the source, if it differs from the one told before.
std::string WalkSection::source(int step) const {
  const std::string& source = walk_.steps[step].source;
  int before = step - 1;
  while (before >= 0 && walk_.steps[before].source.empty()) --before;
  if (source.empty() || (before >= 0 && walk_.steps[before].source == source)) return {};
  return fmt::format("<p class=\"source\">{}</p>\n", html_text(source));
}

/// Returns all known values; on paper, and without scripts, only new ones are shown.
std::string WalkSection::values(const std::vector<viz::ValueText>& all) const {
  if (all.empty()) return {};
  const bool fresh = std::ranges::any_of(all, &viz::ValueText::fresh);
  std::string out = fmt::format("<table class=\"values{}\">\n<caption>{}</caption>\n", fresh ? "" : " known",
                                in_its_language(viz::message("Values")));
  for (const viz::ValueText& v : all)
    out += fmt::format("<tr{}><th scope=\"row\">{}</th><td>{}</td>{}</tr>\n", v.fresh ? " class=\"fresh\"" : "",
                       text(v.name), html_text(v.digits), v.fresh ? "<td>new</td>" : "<td></td>");
  return out + "</table>\n";
}

std::string WalkSection::opinions() const {
  if (!lesson_.opinions) return {};
  const std::vector<viz::Opinion> all = lesson_.opinions(parameters_);
  if (all.empty()) return {};
  std::string rows;
  for (const viz::Opinion& o : all)
    rows += fmt::format("<tr class=\"{}\"><td>{}</td><th scope=\"row\">{}</th><td>{}</td></tr>\n",
                        o.agrees ? "agrees" : "differs", o.agrees ? "✓" : "✗", html_text(o.method), html_text(o.says));
  return fmt::format("<table class=\"opinions\">\n<caption>Methods side by side</caption>\n{}</table>\n", rows);
}

std::string WalkSection::outcome() const {
  const std::string told = verdict(walk_.steps[viz::outcome(walk_)].verdict);
  if (told.empty() || !lesson_.opinions) return told;
  const std::vector<viz::Opinion> all = lesson_.opinions(parameters_);
  const auto differ = std::ranges::count(all, false, &viz::Opinion::agrees);
  if (differ == 0) return told;
  return told + fmt::format("<p class=\"differ\">✗ {} of {} methods {}</p>\n", differ, all.size(),
                            differ == 1 ? "differs" : "differ");
}

std::string WalkSection::answers() const {
  std::string out;
  for (int i = 0; i < static_cast<int>(walk_.steps.size()); ++i)
    if (const auto q = viz::question_text(walk_, i))
      out += program::html({program::answer(*q, in_its_language(viz::message("Question {n}."), q->number))});
  return out.empty() ? out
                     : "<div class=\"answers\">\n<h3>" + in_its_language(viz::message("Answers")) + "</h3>\n" + out +
                           "</div>\n";
}

}  // namespace isect::program::book
