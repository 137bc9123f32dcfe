#pragma once
// The parts of a test's section in the report, besides what to choose. `in_double` and `in_float` are the test's rows.

#include <string>

#include "bench/findings.h"

namespace isect::bench {

/// What the compared calls cost, as sentences.
std::string cost_sentences(const Measured&, const std::string& test, const Findings& in_double,
                           const Findings& in_float);
/// How often they are wrong, as sentences.
std::string verdict_sentences(const Findings& in_double, const Findings& in_float);
/// A row for each method, with times and errors, and another table beside other libraries.
std::string tables_text(const Measured&, const std::string& test, const Findings& in_double);

}  // namespace isect::bench
