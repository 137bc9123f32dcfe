#pragma once
// What the readers of shape files share: words of a line, numbers of a binary file, and what is wrong told by its
// place.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "app/scene/shape_file.h"
#include "viz/lesson.h"

namespace isect::program::scene {

[[noreturn]] inline void refuse(const std::string& file, const std::string& why) {
  throw viz::BadInput(file + ": " + why);
}

/// A face as a fan of triangles.
inline void add_face(ShapeFile& to, const std::vector<int>& corners) {
  for (std::size_t i = 2; i < corners.size(); ++i) to.triangles.push_back({corners[0], corners[i - 1], corners[i]});
}

/// The words of one line of a text, with what is wrong told by name and line.
class Line {
 public:
  Line(std::string_view text, const std::string& file, int number) : rest_(text), file_(file), number_(number) {}

  std::string_view word(std::string_view separators = " \t\r") {
    rest_.remove_prefix(std::min(rest_.find_first_not_of(separators), rest_.size()));
    const std::size_t end = std::min(rest_.find_first_of(separators), rest_.size());
    const std::string_view found = rest_.substr(0, end);
    rest_.remove_prefix(end);
    return found;
  }
  bool ended(std::string_view separators = " \t\r") const { return rest_.find_first_not_of(separators) == rest_.npos; }

  double number(std::string_view word) const {
    double value = 0;
    const auto [end, error] = std::from_chars(word.data() + word.starts_with('+'), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value))
      refuse(fmt::format("\"{}\" is no finite number", word));
    return value;
  }
  long whole(std::string_view word) const {
    long value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size())
      refuse(fmt::format("\"{}\" is no whole number", word));
    return value;
  }
  viz::Vec3 point() {
    viz::Vec3 p;
    for (int i = 0; i < 3; ++i) p[i] = number(word());
    return p;
  }

  [[noreturn]] void refuse(const std::string& why) const {
    throw viz::BadInput(fmt::format("{}: line {}: {}", file_, number_, why));
  }

 private:
  std::string_view rest_;
  const std::string& file_;
  int number_;
};

template <class Each>
void each_line(const std::string& bytes, const std::string& file, const Each& each) {
  int number = 0;
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t end = std::min(bytes.find('\n', at), bytes.size());
    Line line(std::string_view(bytes).substr(at, end - at), file, ++number);
    if (!line.ended()) each(line);
    at = end + 1;
  }
}

/// Numbers of a binary file, one after the other.
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

 private:
  const std::string& bytes_;
  const std::string& file_;
  std::size_t at_;
  bool swap_;
};

/// A PLY file, text or binary.
ShapeFile ply(const std::string& bytes, const std::string& file);

}  // namespace isect::program::scene
