#pragma once
// The machine that measures.

#include <string>

#include "bench/report.h"

namespace isect::bench {

/// How much slower than its fastest run the 95th percentile of a fixed loop is: noise that the machine adds.
double noise();

/// Name, family and model of the first processor in the text of /proc/cpuinfo: one name may be that of several.
std::string cpu_of(const std::string& cpuinfo);

/// This one, now; `flags` and `build` are those of the program that measures.
Machine this_machine(const std::string& flags, const std::string& build);

}  // namespace isect::bench
