#pragma once
// Pages as HTML. A page contains all that it needs, except for pictures that it points to.

#include <string>

#include "app/figures/blocks.h"
#include "viz/text/rich_text.h"

namespace isect::program {

/// Returns the first line, by which isect knows a file as its own; `what` is "handout", "quiz" or "deck".
std::string html_mark(const std::string& what);
/// Converts markup to HTML, on one line.
std::string html_text(const std::string& markup);
std::string html_text(const viz::Run&);
std::string html(const Blocks&);
/// Returns a whole file below its first line. `title`: plain text; `head`: what follows it in the head.
std::string html_page(const std::string& title, const std::string& head, const std::string& body,
                      const std::string& attributes = {});

}  // namespace isect::program
