// A place is written %%ISECT:body%%: a comment to LaTeX, so that a template compiles as it is.

#include "app/pages/template.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "app/shell/named_file.h"
#include "viz/lesson.h"

namespace isect::program {

namespace {

constexpr std::string_view place_begin = "%%ISECT:", place_end = "%%";
constexpr std::string_view document_class = "\\documentclass", document_begin = "\\begin{document}";

/// A place that templates may have.
struct TemplatePlace {
  const char* name;
  std::string PageParts::*part;
  bool needed, once;
  std::string_view before = {}, after = {};  ///< between what of LaTeX it belongs
};
const std::array<TemplatePlace, 4> template_places = {{
    {"metadata", &PageParts::metadata, false, true, document_class},
    {"title", &PageParts::title, false, false},
    {"preamble", &PageParts::preamble, true, true, document_begin, document_class},
    {"body", &PageParts::body, true, true, {}, document_begin},
}};

std::string place_written(const TemplatePlace& place) {
  return fmt::format("{}{}{}", place_begin, place.name, place_end);
}

/// A place as it stands in a template.
struct FoundPlace {
  std::string name;
  std::size_t begin = 0, end = 0;
};

/// Returns the first place from `from` on; one without an end ends with its line and has no name.
FoundPlace next_place(const std::string& text, std::size_t from) {
  FoundPlace found;
  found.begin = text.find(place_begin, from);
  if (found.begin == text.npos) return found;
  const std::size_t name = found.begin + place_begin.size(), stop = text.find(place_end, name);
  const std::size_t line_end = std::min(text.find('\n', name), text.size());
  if (stop < line_end) found.name = text.substr(name, stop - name);
  found.end = stop < line_end ? stop + place_end.size() : line_end;
  return found;
}

std::size_t line_at(const std::string& text, std::size_t at) {
  return 1 + static_cast<std::size_t>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

/// Returns ", after \begin{document} (line 12)" where the template has that.
std::string where_it_belongs(const std::string& text, const TemplatePlace& place) {
  std::string out;
  for (const auto& [word, what] : {std::pair{"after", place.after}, std::pair{"before", place.before}})
    if (const std::size_t at = what.empty() ? text.npos : text.find(what); at != text.npos)
      out += fmt::format("{}{} {} (line {})", out.empty() ? "" : " and ", word, what, line_at(text, at));
  return out;
}

/// Throws viz::BadInput for a place that can't stand where it does; `where` is "template: mine.tex: ".
void need_right_place(const std::string& text, const FoundPlace& found, const std::string& where) {
  const std::string line = fmt::format("{}line {}", where, line_at(text, found.begin));
  std::vector<std::string> allowed;
  for (const TemplatePlace& place : template_places) allowed.emplace_back(place.name);
  if (found.name.empty())
    throw viz::BadInput(
        fmt::format("{}: a place has no end; write it as {}", line, place_written(template_places.back())));
  const auto place =
      std::ranges::find(template_places, found.name, [](const TemplatePlace& p) { return std::string(p.name); });
  if (place == template_places.end()) throw viz::unknown(line, found.name, allowed);
  if (const std::size_t first = text.find(place_written(*place)); place->once && first != found.begin)
    throw viz::BadInput(
        fmt::format("{}: {} stands in line {} already", line, place_written(*place), line_at(text, first)));
  const bool too_early = !place->after.empty() && found.begin < text.find(place->after);
  const bool too_late = !place->before.empty() && found.begin > text.find(place->before);
  if (too_early || too_late)
    throw viz::BadInput(fmt::format("{}: {} belongs {}", line, place_written(*place), where_it_belongs(text, *place)));
}

}  // namespace

std::string built_in_template(const std::string& kind) {
  if (kind == "deck")
    return "%%ISECT:metadata%%\n\\documentclass[aspectratio=169,10pt]{beamer}\n%%ISECT:preamble%%\n"
           "\\usefonttheme{serif}\n\\setbeamertemplate{navigation symbols}{}\n"
           "\\setbeamertemplate{footline}[frame number]\n\\setlength{\\parskip}{4pt plus 1pt}\n"
           "\\title{%%ISECT:title%%}\n\\begin{document}\n%%ISECT:body%%\n\\end{document}\n";
  return "%%ISECT:metadata%%\n\\documentclass[10pt]{article}\n%%ISECT:preamble%%\n"
         "\\usepackage[margin=25mm]{geometry}\n\\setlength{\\parindent}{0pt}\n"
         "\\setlength{\\parskip}{4pt plus 1pt}\n\\begin{document}\n\\section*{%%ISECT:title%%}\n%%ISECT:body%%\n"
         "\\end{document}\n";
}

std::string read_template(const std::string& path) {
  const std::string text = read_named_file(path), where = fmt::format("template: {}: ", path);
  for (const std::string_view what : {document_class, document_begin})
    if (text.find(what) == text.npos)
      throw viz::BadInput(fmt::format("{}it has no {}; --print-template writes one to start from", where, what));
  for (FoundPlace found = next_place(text, 0); found.begin != text.npos; found = next_place(text, found.end))
    need_right_place(text, found, where);
  for (const TemplatePlace& place : template_places)
    if (place.needed && text.find(place_written(place)) == text.npos)
      throw viz::BadInput(
          fmt::format("{}{} is missing; it belongs {}", where, place_written(place), where_it_belongs(text, place)));
  return text;
}

std::string filled(const std::string& page_template, const PageParts& parts) {
  std::string out;
  std::size_t from = 0;
  for (FoundPlace found = next_place(page_template, 0); found.begin != page_template.npos;
       found = next_place(page_template, found.end)) {
    out += page_template.substr(from, found.begin - from);
    from = found.end;
    const auto place =
        std::ranges::find(template_places, found.name, [](const TemplatePlace& p) { return std::string(p.name); });
    if (place == template_places.end()) continue;  // read_template refuses such a one
    const std::string& part = parts.*(place->part);
    out += part.ends_with('\n') ? part.substr(0, part.size() - 1) : part;  // the place has its own line end
    // An empty part leaves no empty line.
    if (part.empty() && (out.empty() || out.back() == '\n') && from < page_template.size() &&
        page_template[from] == '\n')
      ++from;
  }
  return out + page_template.substr(from);
}

}  // namespace isect::program
