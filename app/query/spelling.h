#pragma once
// Names in messages: the one that is probably meant, and those that exist.

#include <string>
#include <vector>

#include "viz/text/spelling.h"

namespace isect::query {

/// Returns "a, b or c".
inline std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 < names.size() ? ", " : " or ") + names[i];
  return text;
}

}  // namespace isect::query
