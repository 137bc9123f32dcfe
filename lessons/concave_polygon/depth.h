#pragma once
// How many questions a search of a trapezoidal map asks at most, in the order in which the edges were added.

#include <isect/many/trapezoid_map.h>
#include "lessons/concave_polygon/picture.h"
#include "lessons/shared/script.h"

namespace isect::lessons::concave_polygon_lesson {

/// The map whose edges are added from left to right, by their left ends.
TrapezoidMap sorted_map(const Ring<double, 2>&, Record<trapezoid_map::BuildEvent>&);

/// The longest paths of the maps of a polygon with this many spikes, in questions.
struct Depths {
  int n, sorted;
  double random;  ///< the mean over several random orders
};
inline constexpr int random_orders = 8;
const Depths& depths_of(int spikes);

/// Adds the step about the longest path of this map, beside those of random orders.
void tell_depth(Script&, const Ring<double, 2>&, const TrapezoidMap&);

}  // namespace isect::lessons::concave_polygon_lesson
