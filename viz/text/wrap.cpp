// Lines of words, measured by Pango, or by the table of a font if there is no Pango.

#include "viz/text/rich_text.h"
#include "viz/text/text.h"

namespace isect::viz {

std::vector<std::string> wrapped(const std::string& markup, double size, bool bold, double room) {
  const auto width = [&](const std::string& line) {
    const TextBox box = measure({.markup = line, .at = Vec2::Zero(), .size = size, .colour = {}, .bold = bold});
    return box.right - box.left;
  };
  std::vector<std::string> lines;
  for (const std::string& part : unbreakable(markup))
    if (!lines.empty() && width(lines.back() + ' ' + part) <= room)
      lines.back() += ' ' + part;
    else
      lines.push_back(part);
  return lines;
}

TextBox fit_width(Text& text, double most) {
  const TextBox box = measure(text);
  if (!(box.right - box.left > most)) return box;
  text.size *= most / (box.right - box.left);
  return measure(text);
}

}  // namespace isect::viz
