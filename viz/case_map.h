#pragma once
// The map of cases: the plane of a lesson's two natural parameters, in regions by the branch that the core takes.
//
// Nothing of a region is known beforehand. The plane is swept in level lines; on each, a change of branch between two
// samples is found by bisection, and where the sequence of branches changes from line to line, so is the level. Between
// lines borders run straight; where they turn, there are more lines, until that is seen nowhere or they lie closer than
// 1/128 of the pitch.

#include "viz/chart.h"
#include "viz/lesson.h"

namespace isect::viz {

/// The slug of the step that shows it.
inline constexpr const char* case_map_slug = "cases";

/// Where this setting lies on the map, and its branch; none where the map does not reach.
std::optional<Cases::Spot> spot_on(const CaseMap&, const Parameters& here);

/// The map with the lesson's presets and this setting on it, made in some seventy parts. `lesson.map` must be there,
/// and the lesson must outlive it.
DeferredChart case_map(const Lesson& lesson, const Parameters& here);
/// The step that shows where `here` lies among all cases; what `before` has told stays. The lesson must outlive it.
Step map_step(const Lesson& lesson, const Parameters& here, const Cases::Spot& spot, const Step& before);

}  // namespace isect::viz
