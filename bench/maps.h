#pragma once
// Where naive verdicts go wrong: 256 x 256 floating-point neighbours of a point, each tested by a naive method and by
// the exact one. Nothing is measured: the pictures are the same on every machine.

#include "bench/plots.h"

namespace isect::bench {

/// Which side of a line, by three ways of writing the same determinant on three lines. Source: Kettner, Mehlhorn, Pion,
/// Schirra, Yap, Classroom examples of robustness problems in geometric computations (ESA 2004).
Plotted orientation_map();
/// Points beside an edge of a triangle, by crossings and by winding.
Plotted polygon_map();
/// Rays that just touch or just miss a ball, by two of the note's methods and a stable one.
Plotted tangent_map();
/// Balls that just touch or just miss each other, near the origin and away from it.
Plotted touching_map();

/// Points on and beside the edges of random polygons: how often each method is wrong, by distance. Not a map, but made
/// of such neighbours, too. Source: S. Schirra, How reliable are practical point-in-polygon strategies? (ESA 2008).
Plotted near_edges_chart();

/// All of them, in the order of the report.
std::vector<Plotted> maps();

}  // namespace isect::bench
