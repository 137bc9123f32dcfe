#pragma once
// Pages to print, as LaTeX and as HTML: handouts and quizzes.

#include "app/pages/pages.h"

namespace isect::program {

/// Returns how pictures look on a page to print. Throws viz::BadInput.
Style printed_style(const PageOptions&);

/// Returns what a playlist's page begins with: the list of its stops, on a page of its own. Of a lesson: nothing.
Blocks printed_front(const Paper&);
/// Returns what stands before a part's steps: its head and note, what the lesson is about, what is given, and the
/// pseudocode, unless it stands in a part before.
Blocks printed_head(const PaperPart&);

/// Writes the page.
void finish_printed(PageFolder&, const Paper&, const Blocks&);

}  // namespace isect::program
