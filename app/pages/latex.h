#pragma once
// Pages as LaTeX, for pdflatex and lualatex, in ASCII except for pictures in words.

#include <string>

#include "app/figures/blocks.h"

namespace isect::program {

/// Returns the first line, by which isect knows a file as its own; `what` is "handout", "quiz" or "deck".
std::string latex_mark(const std::string& what);
std::string latex(const Blocks&);

/// A page makes no tags where this macro is defined before it.
constexpr const char* untagged_macro = "\\isectuntagged";
/// The line in LaTeX's log of a page with tags.
constexpr const char* tagged_note = "isect: tagged";
/// Returns what stands before \documentclass for a page with tags, where the LaTeX that reads it can make them:
/// lualatex with the package tagpdf.
std::string latex_metadata();
/// Returns the packages and macros of a page to print: pictures, the PDF's title and language, tags of pictures.
/// `packages`: further ones, ",amsmath".
std::string latex_preamble(const std::string& title, const std::string& packages = {});
/// Returns the lines that set the PDF's title, which is markup, and its language.
std::string pdf_properties(const std::string& title);

}  // namespace isect::program
