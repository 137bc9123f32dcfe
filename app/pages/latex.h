#pragma once
// Pages as LaTeX, for pdflatex and lualatex, in ASCII.

#include <string>

#include "app/figures/blocks.h"

namespace isect::program {

/// Returns the first line, by which isect knows a file as its own; `what` is "handout", "quiz" or "deck".
std::string latex_mark(const std::string& what);
std::string latex(const Blocks&);

}  // namespace isect::program
