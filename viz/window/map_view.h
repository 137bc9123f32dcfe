#pragma once
// The map of cases beside the scene: where the setting lies now, and how it got there.

#include <deque>
#include <optional>
#include <string>

#include "viz/chart/case_map.h"
#include "viz/gl/renderer.h"
#include "viz/player/map_beside.h"
#include "viz/window/kept_picture.h"
#include "viz/window/window_session.h"

namespace isect::viz {

/// Whether the lesson has a map, and the setting a place on it or beyond it.
bool has_map(const Player&);
/// Whether the map stands beside this step: the reader wants it, there is one, and the step does not show it itself.
bool shows_map(const Player&, const Settings&);
/// Shows the map beside the scene, or hides it; a message says if the lesson has none.
void show_map(const Player&, Settings&, Toast&);

/// A drag over the plane of a map, which moves the setting.
class MapDrag {
 public:
  /// `plane`: where the map's plane lies. `hovered`: the pointer is at the picture.
  void follow(Player&, Toast&, const Cases&, const Box2& plane, bool hovered);

 private:
  bool held_ = false, snapping_ = false;
  const Lesson* held_in_ = nullptr;
  Vec2 start_ = Vec2::Zero();  ///< the place where the drag began
  Vec2 last_ = Vec2::Zero();   ///< the pointer in the frame before
};

class MapView {
 public:
  MapView(Renderer& renderer, double scale, bool drawing) : renderer_(renderer), scale_(scale), drawing_(drawing) {}

  /// Draws the map, and does what pointer and keys ask for.
  void show(Player&, Ui&, Toast&, const Rect&);
  void rescale(double scale) { scale_ = scale; }

 private:
  void leave_trail(const Player&);
  void draw(const Rect&, const Theme&, bool named);
  void draw_trail(Ui&, const Box2& plane) const;
  void keyboard(Player&, const Ui&, Toast&, const Box2& plane);
  void name_under_pointer(const Player&, const Ui&, const Box2& plane) const;

  Renderer& renderer_;
  double scale_;
  bool drawing_;
  KeptPicture picture_;
  std::string drawn_;  ///< what the picture shows, as one line

  MapBeside map_;
  const Lesson* trail_of_ = nullptr;  ///< the lesson that left it
  std::string trail_from_;            ///< the preset in the frame before
  std::deque<Cases::Spot> trail_;
  MapDrag drag_;
};

}  // namespace isect::viz
