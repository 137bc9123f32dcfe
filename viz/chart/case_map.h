#pragma once
// The map of cases: the plane of a lesson's two natural parameters, in regions by the branch that the core takes.
//
// The regions are not known beforehand. The plane is swept in level lines. On each, bisection finds where the branch
// changes between two samples; where the sequence of branches changes from line to line, it finds that level, too.
// Between lines borders run straight; where they bend, lines are added until no bend shows or the lines lie closer than
// 1/128 of the pitch.

#include <functional>
#include <optional>

#include "viz/chart/chart.h"
#include "viz/lesson.h"

namespace isect::viz {

/// The slug of the step that shows it.
inline constexpr const char* case_map_slug = "cases";

/// Returns where this setting lies on the map, and its branch; none if it lies outside the map.
std::optional<Cases::Spot> spot_on(const CaseMap&, const Parameters& here);

/// Returns the map with the lesson's presets and this setting on it. `lesson.map` must not be null.
Chart case_map(const Lesson& lesson, const Parameters& here);
/// Returns what makes the map in some seventy parts, one at each call; the last call returns the map. The lesson must
/// outlive it.
std::function<std::optional<Chart>()> case_map_in_parts(const Lesson&, const Parameters& here);
/// Returns the step that shows where `here` lies among all cases, on a map without regions; what `before` has told
/// stays.
Step map_step(const Lesson&, const Parameters& here, const Cases::Spot&, const Step& before);

/// Sweeps the regions of the walk's map, if it has one.
void sweep_map(Walk&, const Lesson&, const Parameters& here);
/// Returns the lesson's walk with the regions of its map.
Walk walk_with_map(const Lesson&, const Parameters& here);

}  // namespace isect::viz
