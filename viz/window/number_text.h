#pragma once
// Numbers as people type them.

#include <string>

namespace isect::viz {

/// "1.5", "1,5", "1e-3", "−2*pi", "1/3", "(1+2)*0.5". Throws BadInput, which says what is wrong.
double number_from(const std::string& text);

}  // namespace isect::viz
