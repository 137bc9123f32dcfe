#pragma once
// Names in messages: which one is meant, and which there are.

#include <algorithm>
#include <cctype>
#include <numeric>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace isect::query {

/// How many letters, large or small, have to be put in, left out or exchanged to make one name of the other. Source:
/// Wagner, Fischer, The string-to-string correction problem, J. ACM 21 (1974).
inline std::size_t edits(std::string_view from, std::string_view to) {
  const auto same = [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
  };
  std::vector<std::size_t> row(to.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 0; i < from.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t k = 0; k < to.size(); ++k)
      diagonal = std::exchange(row[k + 1], std::min({row[k] + 1, row[k + 1] + 1, diagonal + !same(from[i], to[k])}));
  }
  return row.back();
}

/// The most alike of the names: a word is compared by its first letters, as many as a name may have.
inline std::string nearest(std::string_view word, const std::vector<std::string>& names) {
  const auto away = [&](const std::string& name) { return edits(word.substr(0, 40), name); };
  return names.empty() ? std::string() : *std::ranges::min_element(names, {}, away);
}

/// "a, b or c"
inline std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 < names.size() ? ", " : " or ") + names[i];
  return text;
}

}  // namespace isect::query
