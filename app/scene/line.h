#pragma once
// A whole scene as a line of `isect query`: {"id": 7, "objects": [...], "ask": [["A", "B"]]}.

#include <optional>
#include <string>

#include "app/query/query.h"

namespace isect::program::scene {

/// Returns {"id", "result"}, the result as `isect scene --json` prints it, or {"id", "error"}; nothing for a line that
/// is no scene: JSON with "objects" and no "kind". Like query::answer, it never throws and keeps no state. It reads
/// files below `folder` only, and none without a folder. All pairs of n objects are n (n - 1) / 2 answers, so time and
/// memory grow with them.
std::optional<query::Answer> answer_line(const std::string& line, std::size_t number,
                                         const std::optional<std::string>& folder = {});

}  // namespace isect::program::scene
