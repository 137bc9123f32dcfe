#pragma once
// The characters of UTF-8 text.

#include <algorithm>
#include <string>
#include <string_view>

namespace isect::viz {

/// Whether a byte belongs to a character that has begun before it.
constexpr bool continues_character(char byte) { return (static_cast<unsigned char>(byte) & 0xC0) == 0x80; }

/// Returns the bytes of the character that begins at text[i], which must exist.
constexpr std::string_view character_at(std::string_view text, std::size_t i) {
  std::size_t n = 1;
  while (i + n < text.size() && continues_character(text[i + n])) ++n;
  return text.substr(i, n);
}

/// Whether it is one of 0 to 9.
constexpr bool is_digit(std::string_view c) { return c.size() == 1 && c[0] >= '0' && c[0] <= '9'; }

/// Returns the number of characters.
constexpr std::size_t count_characters(std::string_view text) {
  return text.size() - static_cast<std::size_t>(std::ranges::count_if(text, continues_character));
}

/// Returns the code points of a text. In invalid UTF-8, each byte that begins no character gives some code point.
inline std::u32string code_points(std::string_view text) {
  std::u32string all;
  for (std::size_t i = 0; i < text.size();) {
    const std::string_view bytes = character_at(text, i);
    const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(bytes[k]); };
    char32_t code = bytes.size() == 1 ? byte(0) : byte(0) & (0x7Fu >> std::min<std::size_t>(bytes.size(), 7));
    for (std::size_t k = 1; k < bytes.size(); ++k) code = code << 6 | (byte(k) & 0x3Fu);
    all += code;
    i += bytes.size();
  }
  return all;
}

}  // namespace isect::viz
