#pragma once
// Finds the name that a misspelt word may mean. Header-only, as the query library includes nothing else of viz.

#include <algorithm>
#include <cctype>
#include <numeric>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace isect::spelling {

inline bool same_letter(char a, char b) {
  return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
}

/// Returns how many edits turn `a` into `b`: insert, delete, replace, swap neighbours; case is ignored. Source: Wagner,
/// Lowrance, An extension of the string-to-string correction problem, J. ACM 22 (1975).
inline std::size_t edits(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before_last, last(b.size() + 1), row(b.size() + 1);
  std::iota(last.begin(), last.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + !same_letter(a[i - 1], b[j - 1])});
      if (i > 1 && j > 1 && same_letter(a[i - 1], b[j - 2]) && same_letter(a[i - 2], b[j - 1]))
        row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
    before_last = std::exchange(last, row);
  }
  return last[b.size()];
}

/// Whether the word may be a slip: it changes at most a third of the letters, a swap in "no" or a missing letter of
/// "eg" included; or it leaves out the end of a name.
inline bool is_near(std::string_view word, std::string_view name) {
  const std::size_t longer = std::max(word.size(), name.size());
  const bool begins =
      word.size() >= 3 && word.size() <= name.size() && std::equal(word.begin(), word.end(), name.begin(), same_letter);
  return begins || 3 * edits(word, name) <= longer + 1;
}

/// Returns the name with the fewest edits, if it is near; else nothing. Only the first letters of a word are compared,
/// as many as a name may have.
inline std::string nearest(std::string_view word, const std::vector<std::string>& names) {
  word = word.substr(0, 40);
  const auto rank = [&](const std::string& name) {
    // Among names at equal distance, the one with the same beginning is more likely.
    const auto [end, unused] = std::mismatch(word.begin(), word.end(), name.begin(), name.end());
    return std::tuple{!is_near(word, name), edits(word, name), word.end() - end};
  };
  const auto found = std::ranges::min_element(names, {}, rank);
  return found == names.end() || !is_near(word, *found) ? std::string() : *found;
}

/// Returns `; did you mean "grey"?`, or nothing if no name is near.
inline std::string did_you_mean(std::string_view word, const std::vector<std::string>& names) {
  const std::string name = nearest(word, names);
  return name.empty() ? name : "; did you mean \"" + name + "\"?";
}

/// Returns that and "allowed: print, grey", what there is: `; did you mean "grey"? Allowed: print, grey`.
inline std::string instead(std::string_view word, const std::vector<std::string>& names, std::string there_is) {
  const std::string question = did_you_mean(word, names);
  if (question.empty()) return "; " + there_is;
  there_is[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(there_is[0])));
  return question + " " + there_is;
}

/// Returns "a, b, c".
inline std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

}  // namespace isect::spelling
