#include "viz/lang/numbered.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <string_view>

namespace isect::viz {

namespace {

bool is_figure(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// Whether these bytes stand at this place.
bool stands_at(const std::string& text, std::size_t at, std::string_view bytes) {
  return text.compare(at, bytes.size(), bytes) == 0;
}

/// Returns where the power of ten ends that may follow a number, as `shown` writes it: "1.5 · 10⁻⁶".
std::size_t power_end(const std::string& text, std::size_t at) {
  constexpr std::string_view times = "\u2009·\u200910";
  if (!stands_at(text, at, times)) return at;
  for (at += times.size();;) {
    static constexpr std::string_view raised[] = {"⁻", "⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    const auto* const found =
        std::ranges::find_if(raised, [&](std::string_view digit) { return stands_at(text, at, digit); });
    if (found == std::end(raised)) return at;
    at += found->size();
  }
}

/// Returns where a number ends that begins at `at`, as `shown` writes it; `at` if none does. One beside a letter is a
/// part of a name.
std::size_t number_end(const std::string& text, std::size_t at) {
  constexpr std::string_view minus = "−", infinite = "∞", thin_space = "\u2009";
  std::size_t end = at + (stands_at(text, at, minus) ? minus.size() : 0);
  if (stands_at(text, end, infinite)) return end + infinite.size();
  const auto figure_at = [&](std::size_t i) { return i < text.size() && is_figure(text[i]); };
  if (!figure_at(end)) return at;
  while (figure_at(end) || (stands_at(text, end, thin_space) && figure_at(end + thin_space.size())))
    end += is_figure(text[end]) ? 1 : thin_space.size();
  if (stands_at(text, end, ".") && figure_at(end + 1))
    for (++end; figure_at(end);) ++end;
  end = power_end(text, end);
  const bool named = (at > 0 && is_letter(text[at - 1])) || (end < text.size() && is_letter(text[end]));
  return named ? at : end;
}

/// Returns where a script ends that begins at `at`: "^2", "_{10}"; `at` if none does.
std::size_t script_end(const std::string& text, std::size_t at) {
  if ((text[at] != '^' && text[at] != '_') || at + 1 >= text.size()) return at;
  if (text[at + 1] != '{') return at + 2;
  const std::size_t close = text.find('}', at);
  return close == text.npos ? at : close + 1;
}

}  // namespace

Numbered numbered(const std::string& text) {
  Numbered made;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t script = script_end(text, at), end = script > at ? at : number_end(text, at);
    const std::size_t next = std::max({at + 1, script, end});
    if (end > at) {
      made.numbers.push_back(text.substr(at, end - at));
      made.key += '{' + std::to_string(made.numbers.size()) + '}';
    } else {
      made.key += text.substr(at, next - at);
    }
    at = next;
  }
  return made;
}

std::string with_numbers(const std::string& text, const std::vector<std::string>& numbers) {
  std::string all;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t script = script_end(text, at);
    const std::size_t close = script == at && text[at] == '{' ? text.find('}', at) : text.npos;
    if (close == text.npos) {
      const std::size_t next = std::max(script, at + 1);
      all += text.substr(at, next - at), at = next;
      continue;
    }
    const std::string place = text.substr(at + 1, close - at - 1);
    const bool counts = !place.empty() && place.size() < 4 && std::ranges::all_of(place, is_figure);
    const std::size_t i = counts ? std::stoul(place) : 0;
    if (i < 1 || i > numbers.size()) throw std::logic_error("a translation names {" + place + "}, which is no number");
    all += numbers[i - 1], at = close + 1;
  }
  return all;
}

}  // namespace isect::viz
