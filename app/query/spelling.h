#pragma once
// Names in messages: which one is meant, and which there are.

#include <string>
#include <vector>

#include "viz/spelling.h"

namespace isect::query {

/// "a, b or c"
inline std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 < names.size() ? ", " : " or ") + names[i];
  return text;
}

}  // namespace isect::query
