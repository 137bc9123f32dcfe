#pragma once
// Markup as LaTeX, in ASCII wherever that can be: mathematics between dollars, everything that TeX would misread
// escaped.

#include <string>

namespace isect::viz {

/// For running text. Needs no package.
std::string tex(const std::string& markup);
/// The same of plain Unicode text, such as a line of pseudocode: nothing in it is a mark, and leading spaces stay.
std::string tex_plain(const std::string& text);
/// The same of an alternative text, which is read out and not set: without mathematics, other Unicode as it stands.
std::string tex_said(const std::string& text);

}  // namespace isect::viz
