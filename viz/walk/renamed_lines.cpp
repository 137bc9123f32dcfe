#include "viz/walk/renamed_lines.h"

#include <algorithm>
#include <map>
#include <set>
#include <string_view>

#include "viz/text/names.h"

namespace isect::viz {
namespace {

using Chars = std::string_view;
constexpr Chars arrow = "←", prime = "′";

/// Returns a line's words; a prime belongs to its word.
std::vector<Name> primed_words(const std::string& line) {
  std::vector<Name> words = words_in_line(line);
  for (Name& word : words)
    for (; Chars(line).substr(word.end).starts_with(prime); word.end += prime.size()) word.key += prime;
  return words;
}

Chars between(Chars line, std::size_t begin, std::size_t end) { return line.substr(begin, end - begin); }

/// Whether nothing but these characters stands there.
bool only(Chars text, Chars characters) { return text.find_first_not_of(characters) == Chars::npos; }

/// Adds what is assigned in a line: the names before each arrow, "t_in" and "t_out" in "[t_in, t_out] ← [0, 1]".
void add_assigned(const std::string& line, const std::vector<Name>& words, std::set<std::string>& given) {
  for (std::size_t at = line.find(arrow); at != std::string::npos; at = line.find(arrow, at + 1)) {
    std::size_t right = at;
    for (auto word = words.rbegin(); word != words.rend(); ++word) {
      if (word->end > at) continue;
      const Chars gap = between(line, word->end, right);
      if (right == at ? !only(gap, " ]²") : gap != ", ") break;
      given.insert(word->key), right = word->begin;
    }
  }
}

/// Adds a loop's variables: "i" in "for each axis i of x, y, z", "a" and "b" in "for two nodes a, b".
void add_of_loop(const std::string& line, const std::vector<Name>& words, std::set<std::string>& given) {
  if (words.size() < 2 || words[0].key != "for" || (words[1].key != "each" && words[1].key != "two")) return;
  const std::size_t end = std::min(line.find(':'), line.size());
  const std::vector<Name> names = names_in_line(line);
  if (names.empty() || names[0].begin >= end) return;
  const auto first = std::ranges::find(words, names[0].begin, &Name::begin);
  if (std::prev(first)->key == "of" || std::prev(first)->key == "in") return;  // it stood before the loop
  for (auto name = names.begin(); name != names.end() && name->end <= end; ++name) {
    if (name != names.begin()) {
      const Chars gap = between(line, std::prev(name)->end, name->begin);
      if (gap != " " && gap != ", ") break;
    }
    given.insert(name->key);
  }
}

/// Adds the name and the parameters of a function that begins here: "cull(node):".
void add_of_head(const std::string& line, const std::vector<Name>& words, std::set<std::string>& given) {
  const std::size_t close = line.find("):");
  if (words.empty() || close == std::string::npos || words[0].end >= line.size() || line[words[0].end] != '(') return;
  if (!only(between(line, 0, words[0].begin), " ")) return;
  for (const Name& word : words)
    if (word.end <= close) given.insert(word.key);
}

/// Returns the names that a text gives.
std::set<std::string> given_in(const std::vector<std::string>& text) {
  std::set<std::string> given;
  for (const std::string& line : text) {
    const std::vector<Name> words = primed_words(line);
    add_assigned(line, words, given);
    add_of_loop(line, words, given);
    add_of_head(line, words, given);
  }
  for (const char* word : {"if", "else", "for", "each", "while", "return"}) given.erase(word);
  return given;
}

/// Whether two lines are alike but for words that `pairs` takes for each other.
template <class Pairs>
bool alike(const std::string& a, const std::string& b, const Pairs& pairs) {
  const std::vector<Name> words_a = primed_words(a), words_b = primed_words(b);
  if (words_a.size() != words_b.size()) return false;
  std::size_t at_a = 0, at_b = 0;
  for (std::size_t i = 0; i < words_a.size(); ++i) {
    const Name &x = words_a[i], &y = words_b[i];
    if (between(a, at_a, x.begin) != between(b, at_b, y.begin) || !pairs(x.key, y.key)) return false;
    at_a = x.end, at_b = y.end;
  }
  return Chars(a).substr(at_a) == Chars(b).substr(at_b);
}

}  // namespace

ComparedTexts compared_texts(const std::vector<std::string>& a, const std::vector<std::string>& b) {
  ComparedTexts compared;
  if (a == b) return compared;
  const std::set<std::string> given_a = given_in(a), given_b = given_in(b);
  std::map<std::string, std::string> to, from;
  const auto pairs = [&](const std::string& x, const std::string& y) {
    if (x != y && !(given_a.contains(x) && given_b.contains(y))) return false;
    return to.try_emplace(x, y).first->second == y && from.try_emplace(y, x).first->second == x;
  };
  const int both = static_cast<int>(std::min(a.size(), b.size()));
  int line = 0;
  for (; line < both; ++line) {
    compared.names = to;
    if (!alike(a[line], b[line], pairs)) break;
    if (a[line] != b[line]) compared.renamed.push_back(line);
  }
  if (line < both || a.size() != b.size())
    compared.parted = line;
  else
    compared.names = std::move(to);
  return compared;
}

bool is_renamed(const ComparedTexts& texts, const std::string& a, const std::string& b) {
  return alike(a, b, [&](const std::string& x, const std::string& y) {
    const auto found = texts.names.find(x);
    return found == texts.names.end() ? x == y : found->second == y;
  });
}

}  // namespace isect::viz
