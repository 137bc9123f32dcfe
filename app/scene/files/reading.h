#pragma once
// Shared by the readers of shape files: lines, words and numbers of a text, numbers of a binary file, and errors with
// their places.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>

#include "app/scene/files/shape_file.h"
#include "viz/lesson.h"

namespace isect::program::scene {

[[noreturn]] inline void refuse(const std::string& file, const std::string& why) {
  throw viz::BadInput(file + ": " + why);
}

/// Returns a piece of a file for a message: its first 40 bytes, or up to 3 fewer so that no character is cut, control
/// characters written out.
std::string shortened(std::string_view piece);
/// Returns the shortened piece in double quotes.
std::string in_quotes(std::string_view piece);
/// Converts ASCII letters to lower case.
std::string lower(std::string_view);
/// Returns the double nearest to a decimal number; none if it is no finite number.
std::optional<double> decimal(std::string_view);
/// Removes blanks and tabs at both ends.
std::string_view trimmed(std::string_view);

/// A text, line by line. Lines end by LF, CR LF or CR; a byte order mark is no part of the first.
class TextFile {
 public:
  /// Refuses UTF-16.
  TextFile(std::string_view bytes, const std::string& file);

  /// Goes to the next line; returns false if there is none.
  bool next();
  /// Goes to the next line, too; a line that ends in \ continues in the next one, unless that stands in a comment.
  bool next_joined();

  std::string_view line() const { return line_; }
  std::size_t offset() const { return at_; }  ///< of the byte after the line and its end; at most the text's size
  int number() const { return number_; }      ///< of the line, from 1

  /// Returns the next word of the line; empty if there is none.
  std::string_view word();
  bool ended() const { return trimmed(rest_).empty(); }
  /// Removes from the line all that follows `mark`.
  void drop_comment(std::string_view mark);

  double real(std::string_view word) const;
  double real() { return real(word()); }
  long whole(std::string_view word) const;
  viz::Vec3 point();
  /// Refuses a line of which anything is left.
  void end_line();

  [[noreturn]] void refuse(const std::string& why) const;

 private:
  bool read_line(std::string_view& line);

  std::string_view bytes_, line_, rest_;
  const std::string& file_;
  std::size_t at_ = 0;
  int number_ = 0, lines_ = 0;
  std::string joined_;
};

/// The numbers of a binary file, one after the other.
class Bytes {
 public:
  Bytes(const std::string& bytes, const std::string& file, std::size_t at, bool big_endian = false)
      : bytes_(bytes), file_(file), at_(at), swap_(big_endian != (std::endian::native == std::endian::big)) {}

  template <class T>
  T next() {
    std::array<char, sizeof(T)> raw = {};
    if (bytes_.size() - at_ < sizeof(T)) refuse(file_, fmt::format("it ends early, at byte {}", bytes_.size()));
    std::memcpy(raw.data(), bytes_.data() + at_, sizeof(T));
    if (swap_) std::ranges::reverse(raw);
    at_ += sizeof(T);
    return std::bit_cast<T>(raw);
  }
  void skip(std::size_t count) { at_ += std::min(count, bytes_.size() - at_); }
  std::size_t left() const { return bytes_.size() - at_; }

 private:
  const std::string& bytes_;
  const std::string& file_;
  std::size_t at_;
  bool swap_;
};

/// Returns a note on bytes after the last of what a file announces.
std::string bytes_left_out(std::size_t count, std::string_view last);

/// A reader takes a file's bytes, and its name for messages.
using Reader = ShapeFile (*)(const std::string& bytes, const std::string& file);
ShapeFile read_table(const std::string& bytes, const std::string& file);    ///< CSV and the like
ShapeFile read_xyz(const std::string& bytes, const std::string& file);      ///< a table of x, y, z and more
ShapeFile read_obj(const std::string& bytes, const std::string& file);      ///< Wavefront OBJ
ShapeFile read_stl(const std::string& bytes, const std::string& file);      ///< text or binary
ShapeFile read_ply(const std::string& bytes, const std::string& file);      ///< text or binary
ShapeFile read_off(const std::string& bytes, const std::string& file);      ///< text
ShapeFile read_geojson(const std::string& bytes, const std::string& file);  ///< RFC 7946
ShapeFile read_wkt(const std::string& bytes, const std::string& file);      ///< OGC 06-103r4, and with an SRID

}  // namespace isect::program::scene
