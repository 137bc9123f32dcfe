#include "viz/text/names.h"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>

#include "viz/text/rich_text.h"
#include "viz/text/utf8.h"

namespace isect::viz {
namespace {

using Chars = std::string_view;

/// Whether it is a Latin or Greek letter; the sign of a sum is not.
bool is_name_letter(Chars c) {
  if (c.size() == 1) return (c[0] >= 'a' && c[0] <= 'z') || (c[0] >= 'A' && c[0] <= 'Z');
  const auto first = static_cast<unsigned char>(c[0]);
  return (first == 0xCE || first == 0xCF) && c != "Σ";
}

/// Returns a small letter or digit below the line as an ordinary one; empty for other characters.
Chars lowered(Chars c) {
  static const std::map<Chars, Chars> forms = {{"₀", "0"}, {"₁", "1"}, {"₂", "2"}, {"₃", "3"}, {"₄", "4"}, {"₅", "5"},
                                               {"₆", "6"}, {"₇", "7"}, {"₈", "8"}, {"₉", "9"}, {"ₐ", "a"}, {"ₑ", "e"},
                                               {"ₒ", "o"}, {"ₓ", "x"}, {"ₕ", "h"}, {"ₖ", "k"}, {"ₗ", "l"}, {"ₘ", "m"},
                                               {"ₙ", "n"}, {"ₚ", "p"}, {"ₛ", "s"}, {"ₜ", "t"}, {"ᵢ", "i"}, {"ᵣ", "r"},
                                               {"ᵤ", "u"}, {"ᵥ", "v"}, {"ⱼ", "j"}, {"₊", "+"}, {"₋", "−"}};
  const auto found = forms.find(c);
  return found == forms.end() ? Chars() : found->second;
}

/// Whether the letters may be a name: short words of a sentence or of pseudocode are none, nor are long ones.
bool may_be_a_name(Chars letters) {
  constexpr std::array words = {"as", "at", "by", "do", "go", "if", "in", "is",
                                "it", "no", "of", "on", "or", "so", "to"};
  std::size_t count = 0;
  for (std::size_t i = 0; i < letters.size(); i += character_at(letters, i).size()) ++count;
  return (count <= 2 || letters == "mid") && std::ranges::find(words, letters) == words.end();
}

/// Whether this is the article "a" before a word.
bool is_article(Chars text, std::size_t begin, std::size_t end) {
  if (text.substr(begin, end - begin) != "a" || end + 3 >= text.size() || text[end] != ' ') return false;
  return std::ranges::all_of(text.substr(end + 1, 3), [](char c) { return c >= 'a' && c <= 'z'; });
}

/// Returns the end of the letters that begin at i.
std::size_t end_of_letters(Chars text, std::size_t i) {
  while (i < text.size() && is_name_letter(character_at(text, i))) i += character_at(text, i).size();
  return i;
}

/// Reads a subscript after a name: small signs, or `_` with a word or a group. Moves `i` behind it.
std::string subscript(Chars text, std::size_t& i) {
  std::string below;
  for (Chars small; i < text.size() && !(small = lowered(character_at(text, i))).empty();
       i += character_at(text, i).size())
    below += small;
  if (!below.empty() || i >= text.size()) return below;
  if (text[i] == '_' && i + 1 < text.size()) {
    const bool group = text[i + 1] == '{';
    std::size_t end = i + 1;
    if (group)
      end = std::min(text.find('}', i), text.size() - 1) + 1;
    else
      while (end < text.size() && (is_name_letter(character_at(text, end)) || is_digit(character_at(text, end))))
        end += character_at(text, end).size();
    below = text.substr(i + 1 + group, end - i - 1 - 2 * group);
    i = end;
  } else {
    for (; i < text.size() && is_digit(character_at(text, i)); ++i) below += text[i];
  }
  return below;
}

std::string key_of(Chars letters, const std::string& below) {
  return below.empty() ? std::string(letters) : std::string(letters) + "_" + below;
}

}  // namespace

std::string value_in_words(const Setting& setting, bool flat) {
  if (const auto* word = std::get_if<std::string>(&setting)) return *word;
  if (const auto* number = std::get_if<double>(&setting)) return shown(*number);
  const Vec3& v = std::get<Vec3>(setting);
  const std::string xy = shown(v.x()) + ", " + shown(v.y());
  return "(" + xy + (flat ? ")" : ", " + shown(v.z()) + ")");
}

std::vector<Name> names_in(const std::string& markup) {
  std::vector<Name> names;
  const std::vector<Run> runs = parse_markup(markup);
  std::size_t at = 0;
  for (std::size_t r = 0; r < runs.size(); at += runs[r++].text.size()) {
    const Run& run = runs[r];
    if (run.script != Run::Script::base || !(run.italic || run.bold)) continue;
    const Chars text = run.text;
    for (std::size_t i = 0; i < text.size();) {
      const std::size_t end = end_of_letters(text, i);
      if (end == i) {
        i += character_at(text, i).size();
        continue;
      }
      Name name = {std::string(text.substr(i, end - i)), at + i, at + end, run.bold};
      std::string below;
      for (std::size_t k = r + 1; end == text.size() && k < runs.size() && runs[k].script == Run::Script::sub; ++k)
        below += runs[k].text, name.end += runs[k].text.size();
      if (may_be_a_name(name.key)) name.key = key_of(name.key, below), names.push_back(name);
      i = end;
    }
  }
  return names;
}

std::vector<Name> names_in_line(const std::string& text) {
  std::vector<Name> names = words_in_line(text);
  std::erase_if(names, [&](const Name& word) {
    const std::size_t end = end_of_letters(text, word.begin);
    return !may_be_a_name(Chars(text).substr(word.begin, end - word.begin)) || is_article(text, word.begin, word.end);
  });
  return names;
}

std::vector<Name> words_in_line(const std::string& text) {
  std::vector<Name> words;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t begin = i;
    i = end_of_letters(text, i);
    if (i == begin) {
      i += character_at(text, i).size();
      continue;
    }
    const std::string letters = text.substr(begin, i - begin);
    const std::string below = subscript(text, i);
    const std::size_t hyphen = i;
    while (i + 1 < text.size() && text[i] == '-' && end_of_letters(text, i + 1) > i + 1)
      i = end_of_letters(text, i + 1);
    if (i == hyphen) words.push_back({key_of(letters, below), begin, i});  // "p-vertex" is two words, and no name
  }
  return words;
}

std::vector<Name> names_in_line(const std::string& text, const std::set<std::string>& known) {
  std::vector<Name> names = names_in_line(text);
  std::erase_if(names, [&](const Name& name) { return !known.contains(name.key); });
  return names;
}

std::vector<std::string> keys(const std::vector<Name>& names) {
  std::vector<std::string> all;
  for (const Name& name : names)
    if (std::ranges::find(all, name.key) == all.end()) all.push_back(name.key);
  return all;
}

std::set<std::string> names_of(const Lesson& lesson) {
  std::set<std::string> all;
  for (const Parameter& p : lesson.parameters)
    for (const Name& name : names_in(p.label)) all.insert(name.key);
  return all;
}

std::set<std::string> names_of(const Lesson& lesson, const Walk& walk) {
  std::set<std::string> all = names_of(lesson);
  all.merge(names_of(walk));
  return all;
}

std::set<std::string> names_of(const Walk& walk) {
  std::set<std::string> all;
  const auto take = [&](const std::string& markup) {
    for (const Name& name : names_in(markup)) all.insert(name.key);
  };
  for (const Step& step : walk.steps) {
    take(step.caption), take(step.formula);
    for (const Value& v : step.values) take(v.name);
    if (step.comparison) take(step.comparison->text);
    for (const Item& item : step.scene.items)
      if (const Label* label = std::get_if<Label>(&item)) take(label->text);
  }
  return all;
}

}  // namespace isect::viz
