#include "app/pages/printed.h"

#include <fmt/format.h>

#include "app/pages/html.h"
#include "app/pages/latex.h"
#include "viz/lang/message.h"
#include "viz/text/rich_text.h"
#include "viz/text/tex.h"
#include "viz/text/tex_math.h"

namespace isect::program {

namespace {

constexpr const char* printed_html =
    "<style>\nbody { max-width: 42em; margin: 2em auto; padding: 0 1em; font: 11pt/1.45 serif; }\n"
    "h1, h2, h3 { line-height: 1.2; } h2, h3 { margin-top: 2em; break-after: avoid; }\n"
    "figure { margin: 1em 0; text-align: center; break-inside: avoid; } img { max-width: 100%; }\n"
    "ol.code { font: 10pt/1.35 monospace; } ol.code li { white-space: pre-wrap; padding-left: 2em; text-indent: -2em; "
    "}\n"
    "ol.code .current { background: #ffef9e; }\n"
    "ol.choices { list-style: lower-alpha; }\n"
    ".page { break-after: page; }\n</style>\n";

/// Returns the packages that mathematics in it needs, in the words and in the pictures beside it: ",amsmath", or "".
std::string more_packages(const Paper& paper, const std::string& body) {
  std::string all = body;
  for (const PaperPart& part : paper.parts) all += part.e.lesson->made_from;
  const std::string packages = viz::tex_packages(all);
  return packages.empty() ? "" : "," + packages;
}

}  // namespace

Style printed_style(const PageOptions& options) {
  StyleOptions style;
  style.format = "tikz,svg", style.theme = theme_of_pages(options), style.width = options.width;
  style.text_size = "11pt", style.no_title = true;
  return style_of(style);
}

Blocks printed_front(const Paper& paper) {
  if (!paper.is_playlist()) return {};
  Stops stops = list_of_stops(paper);
  stops.linked = true;
  return {stops, NewPage{}};
}

Blocks printed_head(const PaperPart& part) {
  const Excerpt& e = part.e;
  Blocks all;
  if (part.stop > 0) all.push_back(Heading{part.head, 2, fmt::format("stop-{}", part.stop)});
  if (!part.note.empty()) all.push_back(Prose{part.note});
  if (part.new_lesson) all.push_back(Prose{e.lesson->summary});
  all.push_back(Prose{given(*e.lesson, e.parameters, e.walk), viz::tr("Given")});
  if (part.code_of > 0)
    all.push_back(Prose{viz::tr("The algorithm is that of stop {n}.", {{"n", std::to_string(part.code_of)}})});
  else
    append(all, algorithm(e));
  return all;
}

void finish_printed(PageFolder& pages, const Paper& paper, const Blocks& blocks) {
  const std::string body = latex(blocks);
  pages.finish({latex_metadata(), viz::tex(paper.title), latex_preamble(paper.title, more_packages(paper, body)), body},
               html_page(viz::plain(paper.title), printed_html,
                         fmt::format("<h1>{}</h1>\n", html_text(paper.title)) + html(blocks)));
}

}  // namespace isect::program
