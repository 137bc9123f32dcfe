#include "viz/walk/walk_difference.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <tuple>
#include <utility>

#include "viz/text/rich_text.h"
#include "viz/walk/renamed_lines.h"

namespace isect::viz {
namespace {

/// Returns the first place where two lists differ, as indices; -1 where one has ended, or both agree to the end.
template <class T, class Same>
std::pair<int, int> first_apart(const std::vector<T>& a, const std::vector<T>& b, const Same& same) {
  const auto [at_a, at_b] = std::mismatch(a.begin(), a.end(), b.begin(), b.end(), same);
  return {at_a == a.end() ? -1 : static_cast<int>(at_a - a.begin()),
          at_b == b.end() ? -1 : static_cast<int>(at_b - b.begin())};
}

/// Returns the lines that a walk has run up to a step, in order, without steps that have none or stay at theirs.
std::vector<int> run(const Walk& walk, int at) {
  std::vector<int> lines;
  for (int i = 0; i <= at; ++i) {
    const int line = walk.steps[i].line;
    if (line >= 0 && (lines.empty() || lines.back() != line)) lines.push_back(line);
  }
  return lines;
}

bool same_value(const ComparedTexts& texts, const Value& a, const Value& b) {
  if (a.value != b.value && !(std::isnan(a.value) && std::isnan(b.value))) return false;
  return a.name == b.name || is_renamed(texts, plain(a.name), plain(b.name));
}

}  // namespace

WalkDifference walk_difference(const Walk& a, int at_a, const Walk& b, int at_b) {
  WalkDifference p;
  const ComparedTexts texts = compared_texts(a.pseudocode, b.pseudocode);
  p.renamed = texts.renamed;
  if (texts.parted >= 0) {
    const auto in = [&](const Walk& walk) {
      return texts.parted < static_cast<int>(walk.pseudocode.size()) ? texts.parted : -1;
    };
    p.line_a = in(a), p.line_b = in(b);
  } else {
    const std::vector<int> lines_a = run(a, at_a), lines_b = run(b, at_b);
    const auto [i, k] = first_apart(lines_a, lines_b, std::equal_to<>());
    if (i >= 0 && k >= 0) p.line_a = lines_a[i], p.line_b = lines_b[k];
  }
  std::tie(p.value_a, p.value_b) = first_apart(a.steps[at_a].values, b.steps[at_b].values,
                                               [&](const Value& x, const Value& y) { return same_value(texts, x, y); });
  return p;
}

}  // namespace isect::viz
