#pragma once
// The map of cases beside the scene: its regions are kept while they do not change, and a setting can be moved over it.

#include <string>

#include "viz/chart/chart.h"
#include "viz/player/dragging.h"

namespace isect::viz {

/// Returns the map with the names of its cases, or without them where they would meet or crowd.
Composed compose_map(const Cases&, const Vec2& corner, double width, double height, const Theme&);

/// Return the case at a pixel of the map's plane, and the pixel of a case.
Vec2 case_at(const Cases&, const Box2& plane, const Vec2& pixel);
Vec2 pixel_of(const Cases&, const Box2& plane, const Vec2& at);

/// Whether a question up to the outcome is still to be passed: until then the map does not say in which case the
/// setting lies.
bool waits_for_answer(const Player&);

/// The map of a player's lesson, which must have one.
class MapBeside {
 public:
  /// Returns the map. The plane is swept anew only where its regions may have changed. `here` is this setting's place,
  /// unless a question waits.
  const Cases& find(const Player&);
  const Cases& cases() const { return cases_; }
  const Lesson* lesson() const { return lesson_; }
  unsigned found() const { return found_; }  ///< grows with every new set of regions

 private:
  const Lesson* lesson_ = nullptr;
  Parameters elsewhere_;  ///< the setting brought to the middle of the map: what the regions depend on
  Cases cases_;
  unsigned found_ = 0;
};

/// Drags over the map. With `snapping` only to where the case changes, next to the pointer.
Moved drag_on_map(Player&, const Vec2& start, const Vec2& to, bool snapping);

}  // namespace isect::viz
