#pragma once
// Whether the suites' targets were met.

#include <optional>
#include <string>

#include "bench/report.h"

namespace isect::bench {

/// The number that a target is about, or nothing where the report lacks a row for it.
std::optional<double> measured(const Target&, const Report&);
/// The measured number as text, a ratio with its interval; empty where there is none.
std::string told(const Target&, const Report&);
/// "at most 2 x naive", "0", "at most 60 ns".
std::string wanted(const Target&);
bool met(const Target&, double measured);

}  // namespace isect::bench
