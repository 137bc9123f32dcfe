#pragma once
// A baseline is what a walk said and drew (trace.json) and how its steps looked (PNG). The trace is compared first: it
// names in words what changed, whereas a picture only says how many pixels.

#include <string>
#include <vector>

#include "viz/drawing.h"
#include "viz/lesson.h"
#include "viz/text/text.h"

namespace isect::viz {

/// What pictures depend on besides the walk. Another renderer or font explains every other difference.
struct Stamp {
  std::string renderer, font, theme, size;
};

/// Whether a trace also contains what the lesson says of itself: exercises and errata, which the trace of its first
/// preset has.
enum class Tells { lesson, walk };

/// Returns one walk as JSON: all that its steps say, numbers to nine significant digits, and what their drawings show,
/// object by object (viz/snapshot/drawing_summary.h), where it is first drawn and where it changes. Same walk, same
/// bytes. `drawings`: one per step.
std::string trace_json(const Lesson&, const std::string& preset, const Parameters&, const Walk&,
                       const std::vector<Drawing>& drawings, const Stamp&, Tells = Tells::lesson);

/// One thing that differs, in words: "m² < r² became = r²", "the ball b moved 3 px".
struct Change {
  int step = -1;  ///< from 0; -1: not of one step
  std::string what;
  /// What changed, ordered by how much it explains: what the walk was made with, what its steps compute and decide, how
  /// they put it, what they show.
  enum class Of { setting, course, wording, drawing } of = Of::course;
  /// The change without the numbers that differ from step to step and from walk to walk: "the ball b moved". Equal for
  /// changes that probably have one cause; those of settings keep their values.
  std::string cause = {};
};
/// Returns what leads from the accepted trace to the new one: stamp and parameters, then steps in order, then
/// pseudocode and what belongs to no step. Empty if the traces say the same, though the numbers of a drawing may be
/// rounded differently. An accepted trace that is damaged or of another format is one change.
std::vector<Change> compare_traces(const std::string& accepted, const std::string& fresh);

/// Returns "03-foot": the name of a step's files.
std::string file_stem(int step, const Step&);
/// Whether the picture has one colour throughout: nothing was drawn.
bool blank(const Picture&);

}  // namespace isect::viz
