#pragma once
// Pages as HTML. What a page needs is in it, but for pictures that it points to.

#include <string>

#include "app/pages/blocks.h"
#include "viz/rich_text.h"

namespace isect::program {

/// The first line, by which a file is known to be isect's; `what` is "handout" or "deck".
std::string html_mark(const std::string& what);
/// Markup as HTML, on one line.
std::string html_text(const std::string& markup);
std::string html_text(const viz::Run&);
std::string html(const Blocks&);
/// A whole file: the mark, the head with title and style, the body.
std::string html_page(const std::string& mark, const std::string& title, const std::string& style,
                      const std::string& body);

}  // namespace isect::program
