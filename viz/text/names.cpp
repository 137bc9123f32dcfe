#include "viz/text/names.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string_view>

#include "viz/text/rich_text.h"
#include "viz/text/utf8.h"
#include "viz/walk/alt_text.h"

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

Chars trimmed(Chars text) {
  const std::size_t begin = std::min(text.find_first_not_of(' '), text.size());
  return text.substr(begin, text.find_last_not_of(' ') + 1 - begin);
}

/// An assignment in pseudocode: "s ← l · d".
struct Assignment {
  int line;
  std::string left, right;
};

std::vector<Assignment> assignments(const std::string& line, int number) {
  static const std::string arrow = "←";
  std::vector<Assignment> all;
  for (std::size_t at = 0; at < line.size();) {
    const std::size_t end = std::min(line.find(';', at), line.size());
    const std::string part = line.substr(at, end - at);
    at = end + 1;
    const std::size_t sign = part.find(arrow);
    if (sign == std::string::npos) continue;
    const std::size_t colon = part.rfind(": ", sign);
    const std::size_t begin = colon == std::string::npos ? 0 : colon + 2;
    all.push_back({number, std::string(trimmed(Chars(part).substr(begin, sign - begin))),
                   std::string(trimmed(Chars(part).substr(sign + arrow.size())))});
  }
  return all;
}

/// Returns how the walk has computed a name up to a step or, where it has not yet, how it will.
std::optional<Assignment> assignment_of(const Walk& walk, int step, const std::string& key) {
  std::optional<Assignment> found;
  for (int line = 0; line < static_cast<int>(walk.pseudocode.size()); ++line)
    for (const Assignment& a : assignments(walk.pseudocode[line], line)) {
      if (keys(names_in_line(a.left)) != std::vector{key}) continue;
      if (std::ranges::any_of(names_in_line(a.right), [&](const Name& n) { return n.key == key; })) continue;
      const bool run = std::ranges::any_of(walk.steps.begin(), walk.steps.begin() + step + 1,
                                           [&](const Step& s) { return s.line == line; });
      if (!found || run) found = a;
    }
  return found;
}

/// Describes a knob, or a point that the picture calls by this name.
std::string given(const Lesson& lesson, const Parameters& parameters, const Scene& scene, const std::string& key) {
  for (const Parameter& p : lesson.parameters)
    if (const auto value = parameters.find(p.name);
        value != parameters.end() && keys(names_in(p.label)) == std::vector{key})
      return fmt::format("{} = {}\n{}", plain(p.label), value_in_words(value->second, lesson.flat), p.help);
  for (const Item& item : scene.items) {
    const Label* label = std::get_if<Label>(&item);
    if (!label || label->until) continue;
    const std::vector<Name> names = names_in(label->text);
    const bool point = std::ranges::any_of(scene.items, [&](const Item& other) {
      const Dot* dot = std::get_if<Dot>(&other);
      return dot && dot->at == label->at;
    });
    if (point && names.size() == 1 && names[0].vector && names[0].key == key &&
        names[0].end == plain(label->text).size())
      return fmt::format("{} = {}", plain(label->text), value_in_words(label->at, lesson.flat));
  }
  return {};
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
  std::vector<Name> names;
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
    if (i > hyphen) continue;  // "p-vertex" is a word
    if (may_be_a_name(letters) && !is_article(text, begin, i)) names.push_back({key_of(letters, below), begin, i});
  }
  return names;
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

std::set<std::string> names_of(const Lesson& lesson, const Walk& walk) {
  std::set<std::string> all;
  const auto take = [&](const std::string& markup) {
    for (const Name& name : names_in(markup)) all.insert(name.key);
  };
  for (const Parameter& p : lesson.parameters) take(p.label);
  for (const Step& step : walk.steps) {
    take(step.caption), take(step.formula);
    for (const Value& v : step.values) take(v.name);
    if (step.comparison) take(step.comparison->text);
    for (const Item& item : step.scene.items)
      if (const Label* label = std::get_if<Label>(&item)) take(label->text);
  }
  return all;
}

std::vector<std::string> subject_of_line(const std::string& line, const std::set<std::string>& known) {
  std::vector<Name> left;
  for (const Assignment& a : assignments(line, 0))
    for (const Name& name : names_in_line(a.left, known)) left.push_back(name);
  return keys(left.empty() ? names_in_line(line, known) : left);
}

std::string sum_of(const Lesson& lesson, const Parameters& parameters, const Walk& walk, int step,
                   const std::string& key) {
  const Step& now = walk.steps[step];
  const std::optional<Assignment> computed = assignment_of(walk, step, key);
  const Value* value = nullptr;
  for (const Value& v : now.values) {
    const bool of_it = keys(names_in(v.name)) == std::vector{key} && v.name.find('|') == std::string::npos;
    if (of_it && (!value || (computed && plain(v.name) == computed->left))) value = &v;
  }
  const std::string digits = value ? shown(now.values)[static_cast<std::size_t>(value - now.values.data())] : "";
  const std::string told = given(lesson, parameters, now.scene, key);
  const std::string unit = value && !value->unit.empty() ? "\nunit: " + plain(value->unit) : "";
  if (!computed) return value ? fmt::format("{} = {}", plain(value->name), digits) + unit : told;
  std::string sum = fmt::format("{} = {}", computed->left, computed->right);
  if (value && plain(value->name) == computed->left)
    sum += " = " + digits;
  else if (value)
    sum += fmt::format("\n{} = {}", plain(value->name), digits);
  else if (!told.empty())
    return told;
  return sum + unit;
}

}  // namespace isect::viz
