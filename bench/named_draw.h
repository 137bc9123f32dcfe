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
  const char* note = "";  ///< what the cases are made of, as a sentence of the report without its capital letter

  bool hard() const { return std::string_view(name) != "ordinary"; }
};

}  // namespace isect::bench
