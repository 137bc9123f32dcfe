#pragma once
// Texts whose names can be lit: each stands in a <span data-name="...">, by the key that viz/text/names.h gives it.

#include <set>
#include <string>

namespace isect::program::book {

/// Converts markup as html_text does; `known`: only these names.
std::string lit_text(const std::string& markup, const std::set<std::string>& known);
/// Converts plain text, such as a line of pseudocode.
std::string lit_line(const std::string& text, const std::set<std::string>& known);

}  // namespace isect::program::book
