#include "app/book/lit_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/pages/html.h"
#include "viz/formats/svg_path.h"
#include "viz/text/names.h"
#include "viz/text/rich_text.h"

namespace isect::program::book {

namespace {

std::string opened(const viz::Name& name) { return fmt::format("<span data-name=\"{}\">", viz::xml_escaped(name.key)); }

}  // namespace

std::string lit_text(const std::string& markup, const std::set<std::string>& known) {
  std::vector<viz::Name> names = viz::names_in(markup);
  std::erase_if(names, [&](const viz::Name& n) { return !known.contains(n.key); });
  std::string out;
  std::size_t at = 0, next = 0;  // bytes of the runs' text; the next or current name
  for (const viz::Run& run : viz::parse_markup(markup)) {
    const std::size_t run_end = at + run.text.size();
    for (std::size_t from = at; from < run_end;) {
      if (next < names.size() && names[next].begin == from) out += opened(names[next]);
      const bool inside = next < names.size() && names[next].begin <= from;
      const std::size_t border = next == names.size() ? run_end : inside ? names[next].end : names[next].begin;
      const std::size_t to = std::min(run_end, border);
      viz::Run piece = run;
      piece.text = run.text.substr(from - at, to - from);
      out += html_text(piece);
      if (inside && to == names[next].end) out += "</span>", ++next;
      from = to;
    }
    at = run_end;
  }
  return out;
}

std::string lit_line(const std::string& text, const std::set<std::string>& known) {
  std::string out;
  std::size_t at = 0;
  for (const viz::Name& name : viz::names_in_line(text, known)) {
    out += viz::xml_escaped(text.substr(at, name.begin - at)) + opened(name) +
           viz::xml_escaped(text.substr(name.begin, name.end - name.begin)) + "</span>";
    at = name.end;
  }
  return out + viz::xml_escaped(text.substr(at));
}

}  // namespace isect::program::book
