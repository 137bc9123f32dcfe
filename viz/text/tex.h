#pragma once
// Markup as LaTeX, in ASCII wherever possible: mathematics between dollars, everything that TeX would misread
// escaped.

#include <string>

namespace isect::viz {

/// Converts markup for running text. Needs no package.
std::string tex(const std::string& markup);
/// Converts plain Unicode text, such as a line of pseudocode: nothing in it is a mark, and leading spaces stay.
std::string tex_plain(const std::string& text);
/// Converts an alternative text, which is read out and not set: without mathematics, other Unicode stays as it is.
std::string tex_said(const std::string& text);

}  // namespace isect::viz
