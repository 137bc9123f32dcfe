#include "app/scene/files/reading.h"

#include <charconv>
#include <cmath>
#include <cstdlib>

#include "viz/lang/message.h"
#include "viz/text/utf8.h"

namespace isect::program::scene {

namespace {

constexpr std::string_view blanks = " \t\v\f";

/// Whether a line of a text continues in the next one.
bool goes_on(std::string_view line) { return line.ends_with('\\') && line.find('#') == line.npos; }

}  // namespace

std::string shortened(std::string_view piece) {
  constexpr std::size_t most = 40;
  std::size_t end = std::min(piece.size(), most);
  while (end < piece.size() && end + 3 > most && viz::continues_character(piece[end])) --end;
  std::string text;
  for (const char c : piece.substr(0, end)) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < ' ' || byte == 0x7F)
      text += fmt::format("\\x{:02x}", byte);
    else
      text += c;
  }
  return text + (end < piece.size() ? "..." : "");
}

std::string in_quotes(std::string_view piece) { return '"' + shortened(piece) + '"'; }

std::string bytes_left_out(std::size_t count, std::string_view last) {
  if (last == "facet")
    return viz::tr_count(count, "{n} byte behind the last facet is left out.",
                         "{n} bytes behind the last facet are left out.");
  return viz::tr_count(count, "{n} byte behind the last element is left out.",
                       "{n} bytes behind the last element are left out.");
}

std::string lower(std::string_view text) {
  std::string small(text);
  for (char& c : small)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return small;
}

std::optional<double> decimal(std::string_view word) {
  if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (end != word.data() + word.size()) return {};
  if (error == std::errc::result_out_of_range) value = std::strtod(std::string(word).c_str(), nullptr);  // may be 0
  if ((error != std::errc() && error != std::errc::result_out_of_range) || !std::isfinite(value)) return {};
  return value;
}

std::string_view trimmed(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  return text.substr(0, text.find_last_not_of(blanks) + 1);
}

TextFile::TextFile(std::string_view bytes, const std::string& file) : bytes_(bytes), file_(file) {
  if (bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff"))
    scene::refuse(file, "line 1: a text in UTF-16; save it as UTF-8");
  if (bytes.starts_with("\xef\xbb\xbf")) at_ = 3;
}

bool TextFile::read_line(std::string_view& line) {
  if (at_ >= bytes_.size()) return false;
  std::size_t end = at_;
  while (end < bytes_.size() && bytes_[end] != '\n' && bytes_[end] != '\r') ++end;
  line = bytes_.substr(at_, end - at_);
  at_ = std::min(end + (bytes_.substr(end, 2) == "\r\n" ? 2 : 1), bytes_.size());
  ++lines_;
  return true;
}

bool TextFile::next() {
  number_ = lines_ + 1;
  if (!read_line(line_)) return false;
  rest_ = line_;
  return true;
}

bool TextFile::next_joined() {
  if (!next()) return false;
  if (!goes_on(line_)) return true;
  joined_ = line_;
  for (std::string_view more = line_; goes_on(more) && read_line(more); joined_ += more) joined_.back() = ' ';
  line_ = rest_ = joined_;
  return true;
}

std::string_view TextFile::word() {
  rest_.remove_prefix(std::min(rest_.find_first_not_of(blanks), rest_.size()));
  const std::size_t end = std::min(rest_.find_first_of(blanks), rest_.size());
  const std::string_view found = rest_.substr(0, end);
  rest_.remove_prefix(end);
  return found;
}

void TextFile::drop_comment(std::string_view mark) { rest_ = rest_.substr(0, rest_.find(mark)); }

double TextFile::real(std::string_view word) const {
  if (word.empty()) refuse("a number is missing");
  const std::optional<double> value = decimal(word);
  if (value) return *value;
  const bool minus_sign = word.find("\xe2\x88\x92") != word.npos;
  refuse(fmt::format("{} is no finite number{}", in_quotes(word), minus_sign ? "; a minus is written -" : ""));
}

long TextFile::whole(std::string_view word) const {
  long value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (word.empty()) refuse("a number is missing");
  if (error != std::errc() || end != word.data() + word.size())
    refuse(fmt::format("{} is no whole number", in_quotes(word)));
  return value;
}

viz::Vec3 TextFile::point() {
  viz::Vec3 p;
  for (int i = 0; i < 3; ++i) p[i] = real();
  return p;
}

void TextFile::end_line() {
  if (!ended()) refuse(fmt::format("{} is more than is expected on this line", in_quotes(word())));
}

void TextFile::refuse(const std::string& why) const {
  throw viz::BadInput(fmt::format("{}: line {}: {}", file_, number_, why));
}

}  // namespace isect::program::scene
