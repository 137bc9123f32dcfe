#pragma once
// The map of cases beside the scene: its regions, kept while they stay, and a setting that is moved over it.

#include <string>

#include "viz/chart.h"
#include "viz/moving.h"

namespace isect::viz {

/// The map composed with the names of its cases, or without where they would meet or crowd.
Composed compose_map(const Cases&, const Vec2& corner, double width, double height, const Theme&);

/// From a pixel of the map's plane to its case, and back.
Vec2 case_at(const Cases&, const Box2& plane, const Vec2& pixel);
Vec2 pixel_of(const Cases&, const Box2& plane, const Vec2& at);

/// The map of a player's lesson, which must have one.
class MapBeside {
 public:
  /// The sweep over the plane is made anew only where its regions may have changed. `here` is this setting's place,
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

/// A drag over the map. With `snapping` only as far as where the case changes, next to the pointer.
Moved drag_on_map(Player&, const Vec2& start, const Vec2& to, bool snapping);

}  // namespace isect::viz
