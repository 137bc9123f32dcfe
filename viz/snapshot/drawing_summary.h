#pragma once
// A drawing's summary: what it shows, by its objects, in numbers that are the same on every machine.
//
//   {"order": ["floor grid", "ball b", "line t", "ball b", "label r"],
//    "objects": {"ball b": {"role": "second", "parts": [{"draws": "stroke", "box": [...], ...}, ...]}, ...}}
//
// `order` is the paint order. A part is a run of shapes in it of one object in one style. Places are in pixels to two
// decimals, texts stand at their anchors (their extents are the font's), and two summaries are compared with a
// tolerance, so a number on the edge between two roundings makes no difference.

#include <string>
#include <vector>

#include "viz/drawing.h"
#include "viz/snapshot/json.h"

namespace isect::viz::snap {

Json drawing_summary(const Drawing&);

/// Returns what leads from one summary to the next: objects that look different, null for those that are gone, the
/// order if it changed. `after` applies it; a damaged change can only give a wrong summary.
Json change(const Json& before, const Json& after);
Json after(Json before, const Json& change);

struct Sentence {
  std::string what;   ///< "the ball b and the label r moved by up to 14 px"
  std::string cause;  ///< the same of every drawing in which that happened: "the ball b and the label r moved"
};
/// Returns the differences in words, those that explain most first: what is gone or new, then what moved, then styles
/// and paint order. Empty if no eye sees a difference.
std::vector<Sentence> differences(const Json& was, const Json& is);

}  // namespace isect::viz::snap
