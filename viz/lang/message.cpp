#include "viz/lang/message.h"

#include <algorithm>

#include "viz/lang/catalogue.h"
#include "viz/lang/language.h"

namespace isect::viz {

std::string filled_in(std::string_view text, Filling filling) {
  std::string all;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t open = text.find('{', at), close = open == text.npos ? open : text.find('}', open);
    if (close == text.npos) return all.append(text.substr(at));
    const std::string_view name = text.substr(open + 1, close - open - 1);
    const bool markup = open > 0 && (text[open - 1] == '_' || text[open - 1] == '^');
    const auto* const found = std::ranges::find(filling, name, &std::pair<std::string_view, std::string>::first);
    if (markup || found == filling.end()) {
      all.append(text.substr(at, open + 1 - at)), at = open + 1;
    } else {
      all.append(text.substr(at, open - at)).append(found->second), at = close + 1;
    }
  }
  return all;
}

std::string tr(const Message& m, Filling filling) {
  const std::string* const told = translation(spoken(), m);
  return filled_in(told ? std::string_view(*told) : m.english, filling);
}

std::string tr(std::string_view english, Filling filling) { return tr(message(english), filling); }

std::string tr_as(std::string_view context, std::string_view english, Filling filling) {
  return tr(message_as(context, english), filling);
}

std::string tr_count(std::size_t n, const Message& m, Filling filling) {
  const std::string* const told = translation(spoken(), m, n);
  const std::string text = filled_in(told ? std::string_view(*told) : n == 1 ? m.english : m.other, filling);
  return filled_in(text, {{"n", std::to_string(n)}});
}

std::string tr_count(std::size_t n, std::string_view one, std::string_view other, Filling filling) {
  return tr_count(n, message_count(one, other), filling);
}

}  // namespace isect::viz
