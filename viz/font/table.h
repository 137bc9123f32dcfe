#pragma once
// The measures of the figures' font as a table, for where there is no Pango: in a browser. viz/font/make_table.cpp
// writes it from the installed font; a test compares it with what Pango measures.

#include "viz/drawing.h"

namespace isect::viz {

/// Measures a text as measure(text) does, to a hundredth of the text's size. A character that the table lacks is half
/// as wide as the text is large, and has no ink.
TextBox measured_by_table(const Text&);
/// Whether the table has all characters of the text.
bool table_knows(const Text&);

}  // namespace isect::viz
