#pragma once
// The machine that measures.

#include <string>

#include "bench/report.h"

namespace isect::bench {

/// Noise that the machine adds: how much more the slowest of twelve medians of a fixed loop's passes takes than the
/// fastest. A report compares medians, so their unrest counts. A tick of the system's clock, which may take 40 us of
/// each millisecond, slows all passes alike and is none. Takes 0.2 s.
double noise();

/// Name, family and model of the first processor in the text of /proc/cpuinfo: one name may be that of several.
std::string cpu_of(const std::string& cpuinfo);

/// This one, now; `flags` and `build` are those of the program that measures.
Machine this_machine(const std::string& flags, const std::string& build);

}  // namespace isect::bench
