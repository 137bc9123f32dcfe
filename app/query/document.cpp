#include "app/query/document.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

namespace isect::query {

namespace {

using Parser = nlohmann::ordered_json;

/// A character of the line that shows how far the parser has come.
class Place {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  Place(const char* at, const char*& reached) : at_(at), reached_(&reached) {}
  reference operator*() const { return *at_; }
  Place& operator++() {
    *reached_ = ++at_;
    return *this;
  }
  friend bool operator==(const Place& a, const Place& b) { return a.at_ == b.at_; }

 private:
  const char* at_;
  const char** reached_;
};

bool part_of_number(char c) {
  return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.' || c == 'e' || c == 'E';
}
bool blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

std::string out_of_place(std::size_t character, const char* what) {
  return "no JSON: character " + std::to_string(character) + what;
}

/// Returns the message if the parser stops at a character of a word that other programs write for numbers that are
/// none; empty for anything else.
std::string no_number(std::string_view line, std::size_t at) {
  std::size_t begin = std::min(at, line.size()), end = begin;
  while (begin > 0 && is_letter(line[begin - 1])) --begin;
  while (end < line.size() && is_letter(line[end])) ++end;
  const std::string_view word = line.substr(begin, end - begin);
  const auto stands = [&](std::string_view why) {
    return "no JSON: " + std::string(word) + " at character " + std::to_string(begin + 1) + " is no number" +
           std::string(why);
  };
  for (const std::string_view nan : {"NaN", "nan", "NAN"})
    if (word == nan) return stands("; a number is expected");
  for (const std::string_view infinite : {"Infinity", "inf", "Inf", "INF", "infinity"})
    if (word == infinite) return stands("; where a range ends, write \"inf\" or \"-inf\" in quotes");
  return {};
}

}  // namespace

/// Receives the parser's events, one value after the other.
class Document::Reader {
 public:
  Reader(Document& to) : to_(to), line_(to.line_), reached_(line_.data()) {
    // values stand only at the beginning and behind each of these
    to_.values_.reserve(1 + static_cast<std::size_t>(std::ranges::count_if(
                                line_, [](char c) { return c == ',' || c == ':' || c == '[' || c == '{'; })));
  }

  void read() {
    if (const std::size_t nul = line_.find('\0'); nul != std::string_view::npos) {
      to_.error = out_of_place(nul + 1, " is a NUL byte");
      return;
    }
    const char* unused = nullptr;
    const Place end(line_.data() + line_.size(), unused);
    if (Parser::sax_parse(Place(line_.data(), reached_), end, this)) to_.error = trouble_;
  }

  // The names are those that the library calls.
  bool null() { return add({Type::null, 0, 0}); }
  bool boolean(bool x) { return add({x ? Type::yes : Type::no, 0, 0}); }
  bool number_integer(std::int64_t) { return add_number(); }
  bool number_unsigned(std::uint64_t) { return add_number(); }
  bool number_float(double, const std::string&) { return add_number(); }
  bool string(const std::string& text) { return add(kept(text)); }
  bool binary(Parser::binary_t&) { return false; }  // JSON has none
  bool start_object(std::size_t) { return start(Type::object); }
  bool start_array(std::size_t) { return start(Type::list); }
  bool end_object() {
    if (shown()) find_key_given_twice(open_.back());
    return end();
  }
  bool end_array() { return end(); }

  bool key(const std::string& name) {
    if (shown()) to_.values_.push_back(kept(name));
    if (level_ == 1 && name == "id") id_behind_ = reached_;
    return true;
  }

  bool parse_error(std::size_t, const std::string&, const Parser::exception& e) {
    if (e.id == 406) {
      to_.error =
          "field \"" + to_.path(to_.values_.size()) + "\": " + described_number(number()) + " is too large for f64";
      return false;
    }
    to_.id = "null";
    const auto* parse = dynamic_cast<const Parser::parse_error*>(&e);
    if (parse && parse->byte > 0) to_.error = no_number(line_, parse->byte - 1);
    if (!to_.error.empty()) return false;
    to_.error = !parse                       ? "no JSON"
                : parse->byte > line_.size() ? "no JSON: the line ends too early"
                                             : out_of_place(parse->byte, " is out of place");
    return false;
  }

 private:
  /// Whether values are kept: not below the last level.
  bool shown() const { return level_ <= most_levels; }

  Value kept(const std::string& text) {
    const std::size_t at = to_.texts_.size();
    if (shown()) to_.texts_ += text;
    return {Type::text, text.size(), at};
  }

  /// Returns the number just read. Its end shows only in the character behind it.
  std::string_view number() const {
    const char* end = reached_;
    if (!part_of_number(end[-1])) --end;
    const char* begin = end;
    while (begin != line_.data() && part_of_number(begin[-1])) --begin;
    return {begin, static_cast<std::size_t>(end - begin)};
  }
  bool add_number() {
    const std::string_view text = number();
    if (shown()) put({Type::number, text.size(), static_cast<std::size_t>(text.data() - line_.data())});
    return ended(text.data() + text.size());
  }

  void put(const Value& value) {
    if (!open_.empty()) ++to_.values_[open_.back()].size;
    to_.values_.push_back(value);
  }
  bool add(const Value& value) {
    if (shown()) put(value);
    return ended(reached_);
  }

  bool start(Type type) {
    ++level_;
    if (shown()) {
      put({type, 0, std::numeric_limits<std::uint32_t>::max()});  // its end is unknown while it is open
      open_.push_back(to_.values_.size() - 1);
    } else {
      complain(open_[1],
               "lists and objects nest deeper than the " + std::to_string(most_levels) + " levels that are allowed");
      id_behind_ = nullptr;  // an id of that depth would crash its reader, if not us
    }
    return true;
  }
  bool end() {
    if (shown()) {
      to_.values_[open_.back()].at = static_cast<std::uint32_t>(to_.values_.size());
      open_.pop_back();
    }
    --level_;
    return ended(reached_);
  }

  /// Called where a value ends.
  bool ended(const char* there) {
    if (level_ == 1 && id_behind_) {
      const char* begin = std::find(id_behind_, there, ':') + 1;
      begin = std::find_if_not(begin, there, blank);
      to_.id.assign(begin, there);
      std::ranges::replace_if(
          to_.id, [](char c) { return c == '\r' || c == '\n'; }, ' ');  // an answer is one line
      id_behind_ = nullptr;
    }
    return true;
  }

  void find_key_given_twice(std::size_t object) {
    std::vector<std::pair<std::string_view, std::size_t>> keys;
    keys.reserve(to_.values_[object].size);
    for (std::size_t i = object + 1; i < to_.values_.size(); i = to_.next(i + 1)) keys.emplace_back(to_.text(i), i);
    std::ranges::sort(keys);
    const auto same = [](const auto& a, const auto& b) { return a.first == b.first; };
    const auto twice = std::ranges::adjacent_find(keys, same);
    if (twice == keys.end()) return;
    complain(twice->second + 1, "it is given twice");
  }

  /// Keeps the first complaint only: a path takes time in proportion to the text before it.
  void complain(std::size_t value, const std::string& what) {
    if (trouble_.empty()) trouble_ = "field \"" + to_.path(value) + "\": " + what;
  }

  Document& to_;
  const std::string_view line_;
  const char* reached_;              ///< behind the last character that the parser took
  int level_ = 0;                    ///< how many lists and objects are open
  std::vector<std::size_t> open_;    ///< those of them that are kept
  const char* id_behind_ = nullptr;  ///< the end of the key, while the value of "id" is being read
  std::string trouble_;
};

Document::Document(std::string_view line) : line_(line) { Reader(*this).read(); }

std::string Document::path(std::size_t i) const {
  std::string path;
  for (std::size_t holder = 0; holder != i;) {
    const bool object = values_[holder].type == Type::object;
    std::size_t entry = holder + 1, number = 0, key = 0;
    for (;; entry = next(entry), ++number) {
      if (object) key = entry++;
      if (entry == i || next(entry) > i) break;
    }
    if (object)
      path += (path.empty() ? "" : ".") + shortened(text(key));
    else
      path += "[" + std::to_string(number) + "]";
    holder = entry;
  }
  return path;
}

std::string described_text(std::string_view text) {
  return text.size() <= most_quoted ? '"' + std::string(text) + '"'
                                    : "a text of " + std::to_string(text.size()) + " bytes";
}

std::string described_number(std::string_view number) {
  return number.size() <= most_quoted ? "the number " + std::string(number)
                                      : "a number of " + std::to_string(number.size()) + " characters";
}

std::string shortened(std::string_view name) {
  return std::string(name.substr(0, most_quoted)) + (name.size() > most_quoted ? "..." : "");
}

}  // namespace isect::query
