#include "viz/window/layout.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <string_view>
#include <utility>

#include "viz/text/utf8.h"

namespace isect::viz {

namespace {
constexpr float bar = 48;
/// Returns the height of the transport: thinner where a window is low.
float buttons(float height) { return height < 700 ? 64 : 88; }
}  // namespace

WindowLayout window_layout(float width, float height) {
  // 304 and 344 of 1280 px. A smaller window takes a little from both, and most from the scene; in a very large one
  // lines would be too long to read.
  constexpr float most = 560;
  const float lesson = std::round(std::clamp(width * 0.2375f, 256.0f, most));
  const float code = std::round(std::clamp(width * 0.26875f, 304.0f, most));
  constexpr float least_scene = 400, scene_share = 0.56f;
  const float bottom = height - buttons(height), right = width - code;
  WindowLayout at{.top = {0, 0, width, bar},
                  .lesson = {0, bar, lesson, bottom},
                  .scene = {lesson, bar, right, bottom},
                  .code = {right, bar, width, bottom},
                  .transport = {0, bottom, width, height}};
  if (at.scene.width() >= least_scene) return at;
  const float middle = std::round(bar + scene_share * (bottom - bar));
  at.scene = {0, bar, right, middle};
  at.lesson = {0, middle, right, bottom};
  return at;
}

WindowLayout lecture_layout(float width, float height) {
  constexpr float share = 0.36f, most = 420;
  const float bottom = height - buttons(height), strip = std::round(std::min(share * (bottom - bar), most));
  return {.top = {0, 0, width, bar},
          .lesson = {0, bottom - strip, width, bottom},
          .scene = {0, bar, width, bottom - strip},
          .code = {width, bar, width, bottom},
          .transport = {0, bottom, width, height}};
}

LectureSizes lecture_sizes(float strip) {
  constexpr double rows = 14, least = 15, most = 26, least_large = 20, larger = 3;
  const double words = std::clamp(std::floor(strip / rows), least, most);
  return {words, std::max(least_large, words + larger)};
}

Halves halves(const Rect& r, float share) {
  Halves h{r, r};
  if (r.width() > 1.25f * r.height())
    h.first.right = h.second.left = std::round(r.right - share * r.width());
  else
    h.first.bottom = h.second.top = std::round(r.bottom - share * r.height());
  return h;
}

PanesLayout panes_layout(const WindowLayout& whole, bool panels, bool asks) {
  constexpr float head = 40, least_pane = 400;
  Rect all = whole.between_bars(), lesson = all;
  const bool beside =
      panels && whole.lesson.top == whole.scene.top && all.width() - whole.lesson.width() >= 2 * least_pane;
  lesson.right = all.left = beside ? whole.lesson.right : all.left;
  const float middle = std::round(all.middle_x()), top = all.top + head;
  const float below = std::clamp(0.53f * (all.bottom - top), 200.0f, 430.0f);
  const float code = panels ? std::round(all.bottom - below) : whole.lesson.top;
  PanesLayout at = {.lesson = lesson,
                    .heads = {all.left, all.top, all.right, top},
                    .first_scene = {all.left, top, middle, code},
                    .second_scene = {middle, top, all.right, code},
                    .first_code = {all.left, code, middle, all.bottom},
                    .second_code = {middle, code, all.right, all.bottom},
                    .strip = {}};
  if (panels && (beside || !asks)) return at;
  at.first_code = at.second_code = {};
  at.strip = {all.left, code, all.right, all.bottom};
  return at;
}

namespace {

int letters(std::string_view words) { return static_cast<int>(count_characters(words)); }

/// Returns the spaces at which a row may end so that it fits, the longest row first.
std::vector<std::size_t> ends_of(const std::string& row, std::size_t indent, int columns) {
  std::vector<std::size_t> ends;
  for (std::size_t end = row.rfind(' '); end != std::string::npos && end > indent; end = row.rfind(' ', end - 1))
    if (letters({row.data(), end}) <= columns) ends.push_back(end);
  return ends;
}

int least_rows(std::string row, const std::string& indent, int columns) {
  int rows = 1;
  for (; letters(row) > columns; ++rows) {
    const std::vector<std::size_t> ends = ends_of(row, indent.size(), columns);
    if (ends.empty()) break;  // one long word
    row = indent + row.substr(ends.front() + 1);
  }
  return rows;
}

/// Returns how much it disturbs a reader that a row ends here.
int harm(const std::string& row, std::size_t end) {
  static const std::set<std::string> signs = {"+", "−", "·", "×", "/", "=", "≠", "<", ">", "≤", "≥", "∈", "⊆", "←"};
  static const std::set<std::string> comparisons = {"=", "≠", "<", ">", "≤", "≥", "∈", "⊆"};
  static const std::set<std::string> begin_a_part = {"and",   "or",   "return", "else", "then", "where", "with",
                                                     "until", "that", "if",     "as",   "for",  "of",    "in"};
  static const std::set<std::string> never_last = {"a", "an", "the", "if", "is", "of", "and", "or", "not", "in", "no"};
  const std::size_t begin = row.rfind(' ', end - 1) + 1;
  const std::string before = row.substr(begin, end - begin);
  const std::string after = row.substr(end + 1, row.find(' ', end + 1) - end - 1);
  const auto brackets = [&](const char* these) {
    return std::count_if(row.begin(), row.begin() + static_cast<std::ptrdiff_t>(end),
                         [&](char c) { return c == these[0] || c == these[1]; });
  };
  const bool within = brackets("([") > brackets(")]") || brackets("||") % 2 == 1;
  if (comparisons.contains(after) && !within) return 3;
  if (signs.contains(before) || signs.contains(after)) return within ? 6 : 4;
  if (within) return 3;
  const bool of_names = (after == "and" || after == "or") && letters(before) == 1;  // "a and b" is one
  if (of_names) return 3;
  if (before.ends_with(':') || before.ends_with(';') || before.ends_with(',') || begin_a_part.contains(after)) return 0;
  return never_last.contains(before) ? 2 : 1;
}

/// Returns a small harm for a last row of one word.
int lone_word(const std::string& row, std::size_t indent) { return row.find(' ', indent) == std::string::npos ? 1 : 0; }

struct Broken {
  std::vector<std::string> rows;
  int harm = 0;
};

/// Breaks a row into `count` rows, which must be enough; a row is as long as possible where that does no harm.
Broken least_harm(const std::string& row, const std::string& indent, int columns, int count) {
  Broken best{{row}, lone_word(row, indent.size())};
  if (count == 1) return best;
  best.harm = std::numeric_limits<int>::max();
  for (const std::size_t end : ends_of(row, indent.size(), columns)) {
    const std::string rest = indent + row.substr(end + 1);
    if (least_rows(rest, indent, columns) >= count) break;
    Broken broken = least_harm(rest, indent, columns, count - 1);
    broken.harm += harm(row, end);
    if (broken.harm >= best.harm) continue;
    broken.rows.insert(broken.rows.begin(), row.substr(0, end));
    best = std::move(broken);
  }
  return best;
}

}  // namespace

std::vector<std::string> code_rows(const std::string& line, int columns) {
  const std::string indent(std::min(line.find_first_not_of(' '), line.size()) + 4, ' ');
  return least_harm(line, indent, columns, least_rows(line, indent, columns)).rows;
}

std::vector<float> chip_widths(const std::vector<float>& wide, float narrow, float gap, float width, int chosen) {
  std::vector<float> widths = wide;
  const float gaps = gap * static_cast<float>(std::max<std::size_t>(wide.size(), 1) - 1);
  const auto total = [&] { return std::accumulate(widths.begin(), widths.end(), gaps); };
  for (int i = static_cast<int>(widths.size()) - 1; i >= 0 && total() > width; --i)
    if (i != chosen) widths[i] = std::min(widths[i], narrow);
  return widths;
}

}  // namespace isect::viz
