#pragma once
// The machine that measures.

#include <string>

#include "bench/report.h"

namespace isect::bench {

/// How much slower than its least the 95th percentile of a fixed loop is: what the machine adds by itself.
double noise();

/// This one, now; `flags` and `build` are those of the program that measures.
Machine this_machine(const std::string& flags, const std::string& build);

}  // namespace isect::bench
