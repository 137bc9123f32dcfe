#pragma once
// A line of JSON as a list of its values in the order of the text: eight bytes each, and without recursion, however
// deep or wide the line is.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace isect::query {

enum class Type : std::uint32_t { null, no, yes, number, text, list, object };

/// A container's entries come after it: an object's are key, value, key, value, ...
struct Value {
  Value(Type what, std::size_t length, std::size_t where)
      : type(what), size(static_cast<std::uint32_t>(length) & 0x1fffffff), at(static_cast<std::uint32_t>(where)) {}

  Type type : 3;
  std::uint32_t size : 29;  ///< bytes of a text or number; entries of a list or object
  std::uint32_t at;         ///< place of a text or number; the first value behind a list or object
};

/// The contents of a line. Numbers stay as they are written, so that each is rounded once, to the scalar asked for.
class Document {
 public:
  /// The most levels of nested lists and objects, the case itself included.
  static constexpr int most_levels = 64;
  /// The most bytes of a line: so its offsets fit into a Value.
  static constexpr std::size_t most_bytes = std::size_t{64} << 20;

  /// Takes O(n log n) time for n bytes, and memory for 8 n and a copy of the texts at most. Errors are stored in
  /// `error`. The line must outlive the document.
  explicit Document(std::string_view line);

  std::string error;        ///< the line is no JSON, nests too deep, or gives a field twice; else empty
  bool strict = false;      ///< a shape without points is an error, not an answer
  std::string id = "null";  ///< the field "id" as it is written; null without one, and for a line that is no JSON

  const Value& value(std::size_t i) const { return values_[i]; }
  std::string_view number(std::size_t i) const { return line_.substr(values_[i].at, values_[i].size); }
  std::string_view text(std::size_t i) const { return std::string_view(texts_).substr(values_[i].at, values_[i].size); }
  /// Returns the value behind this one and all that is within it.
  std::size_t next(std::size_t i) const {
    return values_[i].type == Type::list || values_[i].type == Type::object ? values_[i].at : i + 1;
  }
  /// Returns the name of a value: "a.u[1]"; nothing for the case itself.
  std::string path(std::size_t i) const;

 private:
  class Reader;

  std::string_view line_;
  std::vector<Value> values_;
  std::string texts_;
};

// Descriptions of what was given, for messages: in full up to a length that a line of text can hold.

constexpr std::size_t most_quoted = 40;
std::string described_text(std::string_view text);      ///< "newton", or: a text of 1000000 bytes
std::string described_number(std::string_view number);  ///< the number 1e99, or: a number of 5000 characters
std::string shortened(std::string_view name);

}  // namespace isect::query
