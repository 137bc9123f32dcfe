#include "app/pages/html.h"

#include <fmt/format.h>

#include <utility>

#include "viz/formats/svg_path.h"
#include "viz/lang/language.h"
#include "viz/text/rich_text.h"

namespace isect::program {

namespace {

struct AsHtml {
  std::string operator()(const Heading& h) const {
    const std::string id = h.id.empty() ? "" : fmt::format(" id=\"{}\"", h.id);
    return fmt::format("<h{0}{1}>{2}</h{0}>\n", h.level, id, html_text(h.text));
  }
  std::string operator()(const Prose& p) const {
    std::string out, head = p.head.empty() ? "" : fmt::format("<b>{}</b> ", html_text(p.head));
    for (const std::string& paragraph : paragraphs(p.text))
      out += fmt::format("<p>{}{}</p>\n", std::exchange(head, {}), html_text(paragraph));
    return out;
  }
  std::string operator()(const Code& c) const {
    std::string out = fmt::format("<ol class=\"code\"{}>\n", c.first == 1 ? "" : fmt::format(" start=\"{}\"", c.first));
    for (std::size_t i = 0; i < c.lines.size(); ++i) {
      const bool lit = static_cast<int>(i) == c.current;
      out += fmt::format("<li{}>{}{}</li>\n", lit ? " class=\"current\"" : "", html_text(c.lines[i]),
                         lit && !c.said.empty() ? fmt::format("  <b>{}</b>", c.said) : "");
    }
    return out + "</ol>\n";
  }
  std::string operator()(const Image& image) const {
    return fmt::format("<figure><img src=\"{}\" alt=\"{}\"></figure>\n",
                       image.svg.empty() ? image.stem + ".svg" : viz::svg_address(image.svg),
                       viz::xml_escaped(image.alt));
  }
  std::string operator()(const Choices& choices) const {
    std::string out = "<ol class=\"choices\">\n";
    for (const std::string& choice : choices.all) out += fmt::format("<li>{}</li>\n", html_text(choice));
    return out + "</ol>\n";
  }
  std::string operator()(const Blanks& blanks) const {
    std::string out = html_text(blanks.head) + ":";
    for (int i = 0; i < blanks.count; ++i) out += " ____";
    return "<p>" + out + "</p>\n";
  }
  std::string operator()(const Stops& stops) const {
    std::string out = "<ol class=\"stops\">\n";
    for (const auto& [number, text] : stops.all)
      out += stops.linked
                 ? fmt::format("<li value=\"{0}\"><a href=\"#stop-{0}\">{1}</a></li>\n", number, html_text(text))
                 : fmt::format("<li value=\"{}\">{}</li>\n", number, html_text(text));
    return out + "</ol>\n";
  }
  std::string operator()(const NewPage&) const { return "<div class=\"page\"></div>\n"; }
  std::string operator()(const Pause&) const { return "<div class=\"later\">\n"; }
};

}  // namespace

std::string html_mark(const std::string& what) { return fmt::format("<!-- Made by isect {}. -->", what); }

std::string html_text(const viz::Run& run) {
  std::string text = viz::xml_escaped(run.text);
  if (run.bold) text = fmt::format("<b>{}</b>", text);
  if (run.italic) text = fmt::format("<i>{}</i>", text);
  if (run.script == viz::Run::Script::sub) text = fmt::format("<sub>{}</sub>", text);
  if (run.script == viz::Run::Script::super) text = fmt::format("<sup>{}</sup>", text);
  return text;
}

std::string html_text(const std::string& markup) {
  std::string out;
  for (const viz::Run& run : viz::parse_markup(markup)) out += html_text(run);
  return out;
}

std::string html(const Blocks& blocks) {
  std::string out;
  std::string end;  // what comes after
  for (const Block& block : blocks) {
    out += std::visit(AsHtml(), block);
    if (std::holds_alternative<Pause>(block)) end += "</div>\n";
  }
  return out + end;
}

std::string html_page(const std::string& title, const std::string& head, const std::string& body,
                      const std::string& attributes) {
  return fmt::format(
      "\n<!DOCTYPE html>\n<html lang=\"{}\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{}</title>\n{}</head>\n"
      "<body{}>\n{}</body>\n</html>\n",
      viz::spoken(), viz::xml_escaped(title), head, attributes, body);
}

}  // namespace isect::program
