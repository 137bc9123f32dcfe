#include "app/checks/text_difference.h"

#include <fmt/format.h>

#include <algorithm>

namespace isect::program {

namespace {

constexpr std::size_t letters_before = 24, letters_after = 36;

bool continues_letter(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

/// Returns the line around a place in it.
std::string line_around(const std::string& text, std::size_t begin, std::size_t at) {
  const std::size_t end = std::min(text.find('\n', begin), text.size());
  std::size_t from = std::min(at, end), to = from;
  for (std::size_t n = 0; n < letters_before && from > begin; ++n) do
      --from;
    while (from > begin && continues_letter(text[from]));
  for (std::size_t n = 0; n < letters_after && to < end; ++n) do
      ++to;
    while (to < end && continues_letter(text[to]));
  return (from > begin ? "…" : "") + text.substr(from, to - from) + (to < end ? "…" : "");
}

std::string said_of_line(const std::optional<std::string>& line) {
  return line ? fmt::format("“{}”", *line) : "beyond the end";
}

}  // namespace

TextDifference first_difference(const std::string& was, const std::string& is) {
  if (was == is) return {};
  const auto both = static_cast<std::ptrdiff_t>(std::min(was.size(), is.size()));
  std::size_t at =
      static_cast<std::size_t>(std::mismatch(was.begin(), was.begin() + both, is.begin()).first - was.begin());
  while (at > 0 && at < was.size() && continues_letter(was[at])) --at;
  const std::size_t begin = at == 0 ? 0 : was.rfind('\n', at - 1) + 1;  // npos + 1 is 0
  TextDifference found;
  found.line = 1 + static_cast<int>(std::count(was.begin(), was.begin() + static_cast<std::ptrdiff_t>(begin), '\n'));
  if (begin < was.size()) found.was = line_around(was, begin, at);
  if (begin < is.size()) found.is = line_around(is, begin, at);
  return found;
}

std::string in_words(const TextDifference& d) {
  if (d.line == 0) return {};
  if (d.was == d.is) return fmt::format("line {} ends in another way", d.line);
  return fmt::format("line {} was {}, is {}", d.line, said_of_line(d.was), said_of_line(d.is));
}

}  // namespace isect::program
