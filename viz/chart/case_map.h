#pragma once
// The map of cases: the plane of a lesson's two natural parameters, in regions by the branch that the core takes.
//
// The regions are not known beforehand. The plane is swept in level lines. On each, bisection finds where the branch
// changes between two samples; where the sequence of branches changes from line to line, it finds that level, too.
// Between lines borders run straight; where they bend, lines are added until no bend shows or the lines lie closer than
// 1/128 of the pitch.

#include "viz/chart/chart.h"
#include "viz/lesson.h"

namespace isect::viz {

/// The slug of the step that shows it.
inline constexpr const char* case_map_slug = "cases";

/// Returns where this setting lies on the map, and its branch; none if it lies outside the map.
std::optional<Cases::Spot> spot_on(const CaseMap&, const Parameters& here);

/// Returns the map with the lesson's presets and this setting on it, made in some seventy parts. `lesson.map` must not
/// be null, and the lesson must outlive the map.
DeferredChart case_map(const Lesson& lesson, const Parameters& here);
/// The step that shows where `here` lies among all cases; what `before` has told stays. The lesson must outlive it.
Step map_step(const Lesson& lesson, const Parameters& here, const Cases::Spot& spot, const Step& before);

}  // namespace isect::viz
