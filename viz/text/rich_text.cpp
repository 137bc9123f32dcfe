#include "viz/text/rich_text.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <string_view>

#include "viz/text/tex_math.h"
#include "viz/text/utf8.h"

namespace isect::viz {
namespace {

using Script = Run::Script;

bool is_escape(std::string_view text, std::size_t i) {
  return text[i] == '\\' && i + 1 < text.size() && std::string_view("*_^$\\").find(text[i + 1]) != text.npos;
}

/// Whether it is a Latin or Greek letter, which mathematics sets in italic. Digits, signs and brackets stay upright.
bool is_letter(std::string_view character) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(character[i]); };
  if (character.size() == 1) return (byte(0) | 32) >= 'a' && (byte(0) | 32) <= 'z';
  if (character.size() != 2) return false;
  const unsigned code = (byte(0) & 31u) << 6 | (byte(1) & 63u);
  return code >= 0xC0 && code <= 0x3FF && code != 0xD7 && code != 0xF7;
}

/// Splits text into runs. Emphasis may hold scripts and a script may hold emphasis.
class Parser {
 public:
  explicit Parser(std::string_view text) : text_(text) {}

  std::vector<Run> parse() {
    read(0, text_.size(), {});
    return std::move(runs_);
  }

 private:
  static constexpr std::size_t none = std::string_view::npos;

  void add(std::string_view character, Run style) {
    style.italic = style.italic && (is_letter(character) || character == " ");
    const bool same = !runs_.empty() && !runs_.back().math && runs_.back().italic == style.italic &&
                      runs_.back().bold == style.bold && runs_.back().script == style.script;
    if (!same) runs_.push_back(style);
    runs_.back().text += character;
  }

  void read(std::size_t i, std::size_t end, const Run& style) {
    while (i < end) {
      if (const std::size_t after = mark(i, end, style); after != none) {
        i = after;
        continue;
      }
      if (is_escape(text_, i)) ++i;
      const std::size_t n = character_at(text_, i).size();
      add(text_.substr(i, n), style);
      i += n;
    }
  }

  /// Reads the marked text that begins at i. Returns its end, or none if nothing is marked here.
  std::size_t mark(std::size_t i, std::size_t end, const Run& style) {
    if (text_[i] == '*') return emphasis(i, end, style);
    if (text_[i] == '$' && style.script == Script::base) return mathematics(i, end);
    if ((text_[i] == '_' || text_[i] == '^') && style.script == Script::base) return script(i, end, style);
    return none;
  }

  std::size_t mathematics(std::size_t i, std::size_t end) {
    const std::size_t after = end_of_tex_math(text_, i);
    if (after == none || after > end) return none;
    TexMath math = read_tex_math(text_.substr(i + 1, after - i - 2));
    if (!math.error.empty()) return none;
    std::ranges::move(math.runs, std::back_inserter(runs_));
    return after;
  }

  std::size_t emphasis(std::size_t i, std::size_t end, Run style) {
    const std::size_t stars = i + 1 < end && text_[i + 1] == '*' ? 2 : 1;
    const std::size_t close = closing_stars(i + stars, end, stars);
    if (close == none) return none;
    // A vector in a line of scalars stays upright.
    style.italic = stars == 1;
    style.bold = style.bold || stars == 2;
    read(i + stars, close, style);
    return close + stars;
  }

  /// Returns where the mark of one or two stars that opened before `i` closes. As in "2 * 3 * 4", a star beside a space
  /// on its inner side marks nothing.
  std::size_t closing_stars(std::size_t i, std::size_t end, std::size_t stars) const {
    if (i >= end || text_[i] == ' ') return none;
    const std::size_t begin = i;
    bool other_open = false;  // the other kind of mark; a row of three stars closes it first
    while (i < end) {
      if (text_[i] != '*') {
        const std::size_t after = text_[i] == '$' ? end_of_tex_math(text_, i) : none;
        i = after != none ? after : i + (is_escape(text_, i) ? 2 : 1);
        continue;
      }
      std::size_t row = 1;
      while (i + row < end && text_[i + row] == '*') ++row;
      const bool after_text = i > begin && text_[i - 1] != ' ';
      if (after_text && row == stars) return i;
      if (after_text && row >= 3) return other_open ? i + 3 - stars : i;
      if (row == 3 - stars) other_open = !other_open;
      i += row;
    }
    return none;
  }

  /// Reads a script: a group in braces, a marked text, or one character.
  std::size_t script(std::size_t i, std::size_t end, Run style) {
    style.script = text_[i] == '_' ? Script::sub : Script::super;
    ++i;
    if (i >= end || text_[i] == ' ') return none;
    if (text_[i] == '*') return emphasis(i, end, style);
    if (text_[i] == '{') {
      const std::size_t close = text_.find('}', i);
      if (close == none || close >= end) return none;
      read(i + 1, close, style);
      return close + 1;
    }
    if (is_escape(text_, i)) ++i;
    const std::size_t n = character_at(text_, i).size();
    add(text_.substr(i, n), style);
    return i + n;
  }

  std::string_view text_;
  std::vector<Run> runs_;
};

/// Returns Unicode's small digits and signs. A comma has no small form; the full-size one is near enough.
const std::map<std::string_view, const char*>& small_forms(Script script) {
  static const std::map<std::string_view, const char*> sub = {
      {"0", "₀"}, {"1", "₁"}, {"2", "₂"}, {"3", "₃"}, {"4", "₄"}, {"5", "₅"}, {"6", "₆"}, {"7", "₇"}, {"8", "₈"},
      {"9", "₉"}, {"+", "₊"}, {"-", "₋"}, {"−", "₋"}, {"=", "₌"}, {"(", "₍"}, {")", "₎"}, {",", ","}};
  static const std::map<std::string_view, const char*> super = {
      {"0", "⁰"}, {"1", "¹"}, {"2", "²"}, {"3", "³"}, {"4", "⁴"}, {"5", "⁵"}, {"6", "⁶"}, {"7", "⁷"},
      {"8", "⁸"}, {"9", "⁹"}, {"+", "⁺"}, {"-", "⁻"}, {"−", "⁻"}, {"=", "⁼"}, {"(", "⁽"}, {")", "⁾"}};
  return script == Script::sub ? sub : super;
}

/// Returns `text` in small forms, or as "_text" and "^text" where one is missing.
std::string plain_script(const std::string& text, Script script) {
  if (const std::optional<std::string> small = small_form(text, script)) return *small;
  if (script == Script::sub) return "_" + text;
  return count_characters(text) > 1 ? "^(" + text + ")" : "^" + text;
}

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else
      out += c;
  }
  return out;
}

/// Returns a whole number: Pango reads percentages by the locale's decimal point.
std::string whole(double value) { return std::to_string(std::lround(value)); }

}  // namespace

std::vector<Run> parse_markup(const std::string& markup) { return Parser(markup).parse(); }

std::optional<std::string> small_form(const std::string& text, Run::Script script) {
  const auto& forms = small_forms(script);
  std::string small;
  for (std::size_t i = 0, n = 0; i < text.size(); i += n) {
    n = character_at(text, i).size();
    const auto form = forms.find(std::string_view(text).substr(i, n));
    if (form == forms.end()) return std::nullopt;
    small += form->second;
  }
  return small;
}

std::string as_markup(const std::string& text) {
  std::string markup;
  for (const char c : text) {
    if (c == '*' || c == '_' || c == '^' || c == '$' || c == '\\') markup += '\\';
    markup += c;
  }
  return markup;
}

std::string unindented(const std::string& line) {
  return line.substr(std::min(line.find_first_not_of(' '), line.size()));
}

std::string with_minus_signs(std::string text) {
  const auto digit = [&](std::size_t i) { return i < text.size() && text[i] >= '0' && text[i] <= '9'; };
  for (std::size_t at = text.find('-'); at != text.npos; at = text.find('-', at + 1)) {
    const bool first = at == 0 || text[at - 1] == ' ' || text[at - 1] == '(';
    const bool exponent = at > 1 && text[at - 1] == 'e' && digit(at - 2);
    if (digit(at + 1) && (first || exponent)) text.replace(at, 1, "−");
  }
  return text;
}

std::string plain(const std::string& markup) {
  const std::vector<Run> runs = parse_markup(markup);
  std::string out;
  for (std::size_t i = 0; i < runs.size();) {
    if (runs[i].script == Script::base) {
      out += runs[i++].text;
      continue;
    }
    const Script script = runs[i].script;
    std::string text;
    for (; i < runs.size() && runs[i].script == script; ++i) text += runs[i].text;
    out += plain_script(text, script);
  }
  return out;
}

std::vector<std::string> unbreakable(const std::string& markup) {
  static const std::set<std::string> relations = {"=", "≠", "<", ">", "≤", "≥", "≈"};
  std::vector<std::string> parts;
  for (std::size_t at = 0; at < markup.size();) {
    std::size_t end = std::min(markup.find(' ', at), markup.size());
    const auto splits_mark = [&] {  // whether the end of a line here would break a mark
      return plain(markup.substr(at, end - at)) + plain(markup.substr(end)) != plain(markup.substr(at));
    };
    const auto relation_follows = [&] {
      return relations.contains(markup.substr(end + 1, markup.find(' ', end + 1) - end - 1));
    };
    while (end < markup.size() && (splits_mark() || relation_follows()))
      end = std::min(markup.find(' ', end + 1), markup.size());
    parts.push_back(markup.substr(at, end - at));
    at = end + 1;
  }
  return parts;
}

std::string pango(const std::string& markup, const std::string& math_font, double math_scale, double em) {
  constexpr double pango_units = 1024;
  std::string out;
  for (const Run& run : parse_markup(markup)) {
    const bool base = run.script == Script::base;
    const bool math = !math_font.empty() && (!base || run.italic || run.bold);
    const double size = (math ? math_scale : 1) * (base ? 1 : script_size);
    std::string attributes;
    if (math) attributes += " font_family=\"" + escaped(math_font) + "\"";
    if (run.italic) attributes += " style=\"italic\"";
    if (run.bold) attributes += " weight=\"bold\"";
    if (size != 1) attributes += " size=\"" + whole(100 * size) + "%\"";
    if (!base) {
      const double rise = run.script == Script::sub ? sub_rise : super_rise;
      attributes += " rise=\"" + whole(rise * (math ? math_scale : 1) * em * pango_units) + "\"";
    }
    out += attributes.empty() ? escaped(run.text) : "<span" + attributes + ">" + escaped(run.text) + "</span>";
  }
  return out;
}

}  // namespace isect::viz
