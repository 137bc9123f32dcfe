#pragma once
// What the page of a check's report brings along.

#include <string>

namespace isect::program {

/// Returns report.css with what it shares with the book's style; the colours come before it.
const std::string& report_style();
/// Returns report.js with what it shares with the book's scripts.
const std::string& report_script();

}  // namespace isect::program
