#include "viz/walk/branch.h"

#include <algorithm>

#include "viz/chart/case_map.h"
#include "viz/lang/message.h"
#include "viz/text/rich_text.h"
#include "viz/walk/closing.h"

namespace isect::viz {

bool has_condition(const std::string& line) {
  const std::string words = unindented(line);
  const bool begins = words.starts_with("if ") || words.starts_with("while ") || words.starts_with("else if ");
  const bool ends = !words.starts_with("return") && words.find(" if ") != words.npos;  // "DISJOINT if ..."
  return begins || ends || words.find(" until ") != words.npos;
}

std::optional<bool> taken(const Walk& walk, int step) {
  const auto at = static_cast<std::size_t>(step);
  const Step& here = walk.steps[at];
  if (here.line < 0 || !has_condition(walk.pseudocode[static_cast<std::size_t>(here.line)])) return {};
  const bool ends = here.slug == case_map_slug || here.slug == closing_slug;
  if (ends && at > 0 && walk.steps[at - 1].line == here.line) return taken(walk, step - 1);
  const auto refusals = [&](const Step& s) { return std::ranges::count(s.refused, here.line); };
  const bool refused = refusals(here) > 0 && at > 0 && refusals(here) > refusals(walk.steps[at - 1]);
  if (refused || (at + 1 < walk.steps.size() && refusals(walk.steps[at + 1]) > refusals(here))) return false;
  if (here.comparison) return here.comparison->holds;
  return here.decides ? std::optional(true) : std::nullopt;
}

std::string said_at_line(const std::optional<bool>& taken) { return !taken ? "" : *taken ? tr("yes") : tr("no"); }

}  // namespace isect::viz
