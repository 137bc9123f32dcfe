// Measures text for the lessons' pictures without Pango.

#include "viz/font/table.h"
#include "viz/text/text.h"

namespace isect::viz {

TextBox measure(const Text& text) { return measured_by_table(text); }

}  // namespace isect::viz
