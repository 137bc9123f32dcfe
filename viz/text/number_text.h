#pragma once
// Numbers as people type them. app/book/numbers.js reads them by the same rules, for pages where no C++ runs:
// tests/typed_numbers.json holds both to them.

#include <string>

namespace isect::viz {

/// Returns the number that a text denotes: "1.5", "1,5", "1e-3", "2.5·10^-3", "−2*pi", "1/3", "(1+2)*0.5", "2√3",
/// "sqrt(2)/2", "3²". A comma is a decimal point. Throws BadInput, which says what is wrong.
double number_from(const std::string& text);

}  // namespace isect::viz
