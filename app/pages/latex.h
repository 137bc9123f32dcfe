#pragma once
// Pages as LaTeX, for pdflatex and lualatex, in ASCII.

#include <string>

#include "app/pages/blocks.h"

namespace isect::program {

/// The first line, by which a file is known to be isect's; `what` is "handout" or "deck".
std::string latex_mark(const std::string& what);
std::string latex(const Blocks&);

}  // namespace isect::program
