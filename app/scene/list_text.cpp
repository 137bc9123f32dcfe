#include "app/scene/list_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "app/scene/spans.h"

namespace isect::program::scene {

std::size_t line_begin(const std::string& text, std::size_t at) {
  return at == 0 ? 0 : text.rfind('\n', at - 1) + 1;  // 0 after npos
}

namespace {

/// Returns where no blank and no comment stands, from `at` on; with `line`, at most the end of the line.
std::size_t past_blanks(const std::string& text, std::size_t at, bool line = false) {
  while (at < text.size()) {
    if (text.compare(at, 2, "//") == 0) {
      at = std::min(text.find('\n', at), text.size());
    } else if (const std::size_t end = text.find("*/", at); text.compare(at, 2, "/*") == 0 && end != text.npos) {
      if (line && text.find('\n', at) < end) return at;
      at = end + 2;
    } else if (std::isspace(static_cast<unsigned char>(text[at])) != 0 && !(line && text[at] == '\n')) {
      ++at;
    } else {
      break;
    }
  }
  return at;
}

/// Returns the blanks before what stands at `at`, if it is the first of its line.
std::optional<std::string> indent_at(const std::string& text, std::size_t at) {
  const std::size_t begin = line_begin(text, at);
  const std::string before = text.substr(begin, at - begin);
  if (begin == 0 || before.find_first_not_of(" \t") != before.npos) return {};
  return before;
}

/// Removes [from, to), and the line that it leaves blank.
void cut_out(std::string& text, std::size_t from, std::size_t to) {
  text.erase(from, to - from);
  const std::size_t begin = line_begin(text, from), end = std::min(text.find('\n', from), text.size());
  const bool blank = text.find_first_not_of(" \t\r", begin) >= end;
  if (blank && end < text.size() && begin > 0)
    text.erase(begin, end + 1 - begin);
  else
    while (from < text.size() && text[from] == ' ' && from > 0 && (text[from - 1] == ' ' || text[from - 1] == '['))
      text.erase(from, 1);
}

}  // namespace

void put_behind(std::string& text, std::size_t at, const std::optional<std::string>& indent, const std::string& what) {
  if (!indent) {
    text.insert(at, ", " + what);
    return;
  }
  const std::size_t comma = past_blanks(text, at);
  const bool more = comma < text.size() && text[comma] == ',';
  const std::size_t rest = past_blanks(text, more ? comma + 1 : at, true);
  const bool at_end = rest < text.size() && text[rest] == '\n';
  const std::string line = "\n" + *indent + what + (more ? "," : "");
  if (at_end) text.insert(rest, line);
  if (!at_end) text.insert(more ? comma + 1 : at, line);
  if (!more) text.insert(at, ",");
}

void remove_entry(std::string& text, const std::string& list, std::size_t i) {
  const Spans spans(text);
  const Spans::Span entry = *spans.at(fmt::format("{}/{}", list, i));
  const std::size_t comma = past_blanks(text, entry.end);
  if (comma < text.size() && text[comma] == ',') {
    text.erase(comma, 1);
    cut_out(text, entry.begin, entry.end);
    return;
  }
  cut_out(text, entry.begin, entry.end);
  if (i == 0) return;
  const std::size_t before = past_blanks(text, spans.at(fmt::format("{}/{}", list, i - 1))->end);
  if (before >= text.size() || text[before] != ',') return;
  text.erase(before, 1);
  while (before < text.size() && before > 0 && text[before] == ' ' && text[before - 1] == ' ') text.erase(before, 1);
  if (before + 1 < text.size() && text[before] == ' ' && text[before + 1] == ']') text.erase(before, 1);
}

void add_entry(std::string& text, const std::string& list, std::size_t count, const std::string& entry) {
  if (count == 0)
    text.insert(Spans(text).at(list)->begin + 1, entry);
  else
    add_entry_behind(text, list, count - 1, entry);
}

void add_entry_behind(std::string& text, const std::string& list, std::size_t i, const std::string& entry) {
  const Spans spans(text);
  const Spans::Span before = *spans.at(fmt::format("{}/{}", list, i));
  put_behind(text, before.end, indent_at(text, before.begin), entry);
}

}  // namespace isect::program::scene
