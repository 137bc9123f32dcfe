#pragma once
// The pair that every search for pairs finds.

#include <compare>

namespace isect {

/// Two shapes by their numbers: i < j of one set, or i of a first set and j of a second.
struct IndexPair {
  int i, j;
  friend auto operator<=>(const IndexPair&, const IndexPair&) = default;
};

}  // namespace isect
