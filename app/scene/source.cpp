#include "app/scene/source.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "viz/text/spelling.h"

namespace isect::program::scene {

namespace {

/// Returns "objects[2].lo".
std::string told(const Path& path) {
  std::string text;
  for (const std::string& key : path) {
    const bool entry = key.find_first_not_of("0123456789") == key.npos;
    text += entry ? "[" + key + "]" : (text.empty() ? "" : ".") + key;
  }
  return text;
}

/// Returns the path of "/objects/2/lo".
Path path_of(const std::string& text) {
  Path path;
  for (std::size_t at = 1; at <= text.size();) {
    const std::size_t end = std::min(text.find('/', at), text.size());
    path.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return path;
}

/// Returns the last part of the parser's sentence.
std::string reason(const std::string& what) {
  const std::size_t dash = what.find(" - ");
  return dash == what.npos ? what.substr(what.find("] ") + 2) : what.substr(dash + 3);
}

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// Returns the word that contains a character.
std::string_view word_at(const std::string& text, std::size_t at) {
  std::size_t begin = at, end = at;
  while (begin > 0 && is_letter(text[begin - 1])) --begin;
  while (end < text.size() && is_letter(text[end])) ++end;
  return std::string_view(text).substr(begin, end - begin);
}

/// Returns a message on what people write by hand that is no JSON, by the character at which the parser stops; empty if
/// there is none.
std::string habit(const std::string& text, std::size_t at, const std::string& parsers) {
  if (at >= text.size()) return {};
  const char c = text[at], last = at > 0 ? text[at - 1] : ' ';
  const std::string_view word = word_at(text, at);
  const std::size_t gap = text.find_last_not_of(" \t\r\n", static_cast<std::size_t>(word.data() - text.data()) - 1);
  const char before = word.data() == text.data() || gap == text.npos ? ' ' : text[gap];
  if ((c == '}' || c == ']') && before == ',') return "the comma before it is one too many";
  if (c == '\'') return "names and texts stand in double quotes";
  if (c == '#') return "a comment begins with //";
  if (c == '.') return "a number begins with a digit: 0.5";
  if (c == '+') return "a number has no plus sign before it";
  if (c == '/' || last == '/') return "a number is written out: 0.25, not 1/4";
  if (parsers.find("number literal; expected string") != parsers.npos)
    return "a decimal point is expected, not a comma";
  for (const char* no_number : {"NaN", "nan", "Infinity", "Inf", "inf"})
    if (word == no_number) return "a number is finite; an end that a ray does not have is left out";
  if (!word.empty() && (before == '{' || before == ',')) return "names and texts stand in double quotes";
  const bool goes_on = c == '{' || c == '[' || c == '"';
  if (goes_on && parsers.starts_with("unexpected") && parsers.find("end of input") == parsers.npos)
    return "is a comma missing before it?";
  return {};
}

}  // namespace

Path below(Path path, const std::string& key) {
  path.push_back(key);
  return path;
}

Source::Source(const std::string& text) : text_(text), spans_(text) {
  if (const std::size_t at = spans_.too_deep(); at != text.npos)
    throw viz::BadInput(fmt::format("line {}: lists and objects nest deeper than the {} levels that are allowed",
                                    line_at(at), Spans::most_levels));
  json_ = parsed();
  if (!spans_.twice().empty()) refuse(path_of(spans_.twice().front()), "it is given twice");
}

Json Source::parsed() const try { return Json::parse(text_, nullptr, true, true); } catch (const Json::parse_error& e) {
  const std::size_t at = std::min(e.byte > 0 ? e.byte - 1 : 0, text_.size());
  if (text_.find_first_not_of(" \t\r\n") == text_.npos) throw viz::BadInput("the file is empty");
  const std::string why = reason(e.what()), told = habit(text_, at, why);
  const bool no_text = text_.find('\0') != text_.npos || why.find("UTF-8") != why.npos || text_[0] == '\xff' ||
                       text_[0] == '\xfe' || text_[0] == '\x89';
  throw viz::BadInput(fmt::format("line {}, column {}: no JSON; {}", line_at(at), column_at(at),
                                  no_text        ? "it is no text in UTF-8"
                                  : told.empty() ? why
                                                 : told));
} catch (const Json::out_of_range&) {
  for (const auto& [path, span] : spans_.all()) {
    const std::string number = text_.substr(span.begin, span.end - span.begin);
    const char first = number.empty() ? ' ' : number[0];
    if ((first == '-' || (first >= '0' && first <= '9')) && !std::isfinite(std::strtod(number.c_str(), nullptr)))
      refuse(path_of(path), number + " is too large for a floating-point number");
  }
  throw viz::BadInput("a number is too large for a floating-point number");
}

int Source::line_at(std::size_t byte) const {
  return 1 + static_cast<int>(std::count(
                 text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(std::min(byte, text_.size())), '\n'));
}

/// Returns the column, from 1, as in editors.
int Source::column_at(std::size_t byte) const {
  const std::size_t line = byte == 0 ? 0 : text_.rfind('\n', byte - 1) + 1;  // 0 after npos
  int column = 1;
  for (std::size_t i = line; i < std::min(byte, text_.size()); ++i)
    column += (static_cast<unsigned char>(text_[i]) & 0xC0) != 0x80;
  return column;
}

int Source::line_of(const Path& path) const {
  std::size_t line = 0;
  std::string to;
  for (const std::string& key : path) {
    const Spans::Span* span = spans_.at(to += "/" + key);
    if (!span) break;
    line = span->begin;
  }
  return line_at(line);
}

void Source::refuse(const Path& path, const std::string& why) const {
  throw viz::BadInput(fmt::format("{}: {}", place(path), why));
}

std::string Source::place(const Path& path) const {
  return fmt::format("line {}: {}", line_of(path), path.empty() ? "the file" : told(path));
}

void Source::only(const Json& object, const Path& path, const std::vector<std::string>& allowed,
                  const std::vector<std::string>& ignored) const {
  if (!object.is_object()) refuse(path, "an object in braces is expected");
  for (const auto& [key, value] : object.items())
    if (std::ranges::find(allowed, key) == allowed.end() && std::ranges::find(ignored, key) == ignored.end())
      refuse(below(path, key), "unknown" + spelling::instead(key, allowed, "allowed: " + spelling::listed(allowed)));
}

const Json& Source::member(const Json& object, const Path& path, const std::string& key) const {
  if (!object.contains(key)) refuse(path, fmt::format("\"{}\" is missing", key));
  return object[key];
}

std::string Source::text(const Json& value, const Path& path) const {
  if (!value.is_string()) refuse(path, "a text is expected");
  return value;
}

double Source::number(const Json& value, const Path& path) const {
  constexpr double most = 1e300;  // drawing adds and multiplies coordinates
  if (!value.is_number() || !std::isfinite(value.get<double>())) refuse(path, "a finite number is expected");
  if (std::abs(value.get<double>()) > most) refuse(path, value.dump() + " is too large; 1e300 is the most");
  return value;
}

const Json& Source::list(const Json& value, const Path& path, std::size_t least, std::size_t most,
                         const std::string& of) const {
  if (!value.is_array() || value.size() < least || value.size() > most)
    refuse(path, least == most ? fmt::format("{} {} {} expected", least, of, least == 1 ? "is" : "are")
                               : fmt::format("a list of {} to {} {} is expected", least, most, of));
  return value;
}

void Source::need_dimension(std::size_t coordinates, const Path& path) {
  if (dimension_ == 0) dimension_ = coordinates;
  if (dimension_ != coordinates)
    refuse(path, fmt::format("{} coordinates in a scene whose others have {}", coordinates, dimension_));
}

viz::Vec3 Source::vector(const Json& value, const Path& path) {
  const bool two = value.is_array() && value.size() == 2, three = value.is_array() && value.size() == 3;
  if (!two && !three) refuse(path, "two or three numbers are expected, as in [1, 2]");
  need_dimension(value.size(), path);
  viz::Vec3 v = viz::Vec3::Zero();
  for (std::size_t i = 0; i < value.size(); ++i)
    v[static_cast<int>(i)] = number(value[i], below(path, std::to_string(i)));
  return v;
}

}  // namespace isect::program::scene
