#pragma once
// Families of cases by name, in the order of their rows.

#include <string_view>

#include "bench/random.h"

namespace isect::bench {

/// "ordinary" is the only family that is not hard.
template <class Case>
struct NamedDraw {
  const char* name;
  Case (*draw)(Random&);

  bool hard() const { return std::string_view(name) != "ordinary"; }
};

}  // namespace isect::bench
