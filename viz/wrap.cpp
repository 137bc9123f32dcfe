// Lines of words, by whatever measures texts: Pango, or the table of a font where there is none.

#include <algorithm>
#include <set>

#include "viz/rich_text.h"
#include "viz/text.h"

namespace isect::viz {

std::vector<std::string> wrapped(const std::string& markup, double size, bool bold, double room) {
  const auto width = [&](const std::string& line) {
    const TextBox box = measure({.markup = line, .at = Vec2::Zero(), .size = size, .colour = {}, .bold = bold});
    return box.right - box.left;
  };
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < markup.size();) {
    std::size_t end = std::min(markup.find(' ', at), markup.size());
    const auto splits_mark = [&] {  // a mark that opened before and closes behind is no mark any more
      return plain(markup.substr(at, end - at)) + plain(markup.substr(end)) != plain(markup.substr(at));
    };
    const auto relation_follows = [&] {  // which ends a line rather than begins one, as in print
      static const std::set<std::string> relations = {"=", "≠", "<", ">", "≤", "≥", "≈"};
      return relations.contains(markup.substr(end + 1, markup.find(' ', end + 1) - end - 1));
    };
    while (end < markup.size() && (splits_mark() || relation_follows()))
      end = std::min(markup.find(' ', end + 1), markup.size());
    const std::string word = markup.substr(at, end - at);
    if (!lines.empty() && width(lines.back() + ' ' + word) <= room)
      lines.back() += ' ' + word;
    else
      lines.push_back(word);
    at = end + 1;
  }
  return lines;
}

}  // namespace isect::viz
