#pragma once
// Outlines and pen strokes as triangles. Pure geometry: every length is in the caller's own unit.

#include <array>
#include <vector>

#include "viz/drawing.h"

namespace isect::viz {

/// Three corners per triangle. Triangles of one shape may overlap.
using Triangles = std::vector<Vec2>;

/// A flattened path: no two neighbours are equal, and a closed one does not repeat its first point.
struct Polyline {
  std::vector<Vec2> points;
  bool closed = false;
};

/// Flattens a path. Empty if the path has no segment or a coordinate that is not finite.
Polyline flat(const Path&, double tolerance);

/// Returns the line with fewer of its points, no point of it moved by more than the tolerance; ends and reversals stay.
/// A line with thousands of corners, several per pixel, is then drawn as quickly as one with hundreds.
Polyline thinned(const Polyline&, double tolerance);

/// Whether the closed outline turns one way only, and goes round once.
bool is_convex(const std::vector<Vec2>& outline);

/// Triangles between the corners whose signed areas add up to the winding number at every point. Where the
/// outline is convex, no two overlap.
Triangles triangulated(std::vector<Vec2> outline);

/// Returns the pieces of a line that the pen draws: `dash[0]` on, `dash[1]` off, measured along the line from its
/// start. On a closed line, a dash that runs over the start is one piece. Returns the line itself unless both are
/// positive and finite, or if they are too short to be seen.
std::vector<Polyline> dashes(const Polyline&, const std::array<double, 2>& dash);

/// A line of constant width with round joins; open ends are round or cut off square. A single point is a disc
/// with round caps, nothing without.
Triangles stroke(const Polyline&, double width, bool round_cap, double tolerance);

struct Box {
  Vec2 low, high;
};
/// Returns the smallest box around at least one point.
Box bounds(const std::vector<Vec2>& points);
Triangles cover(const Box&);

/// Lines at 45 degrees that rise to the right (y down), `gap` apart, across the box: x + y = k gap sqrt(2)
/// for whole k, so that neighbouring shapes share one pattern. Empty unless `gap` and `width` are positive.
Triangles hatch(const Box&, double gap, double width);

}  // namespace isect::viz
