#pragma once
// A baseline is what a walk said (trace.json) and how each step looked (PNG). The trace is compared first: it
// names what changed in words, where a picture only says how many pixels.

#include <string>
#include <vector>

#include "viz/lesson.h"
#include "viz/text.h"

namespace isect::viz {

/// What pictures depend on besides the walk. Another renderer or font explains every other difference.
struct Stamp {
  std::string renderer, font, theme, size;
};

/// One walk as JSON with one step on a line, numbers to nine significant digits: same walk, same bytes.
std::string trace_json(const Lesson&, const std::string& preset, const Parameters&, const Walk&,
                       const Stamp&);

/// One thing that differs, in words: "m² < r² became = r²".
struct Change {
  int step = -1;  ///< from 0; -1: not of one step
  std::string what;
};
/// What leads from the accepted trace to the new one, what explains most first: stamp, then steps in order,
/// then parameters and pseudocode. Empty if the traces are equal. An accepted trace that is damaged is a
/// change, too.
std::vector<Change> compare_traces(const std::string& accepted, const std::string& fresh);

/// "03-foot": the name of a step's files.
std::string file_stem(int step, const Step&);
/// One colour throughout: nothing was drawn.
bool blank(const Picture&);

}  // namespace isect::viz
