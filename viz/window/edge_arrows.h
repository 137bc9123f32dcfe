#pragma once
// Arrows at the edge of the scene, which point to the handles and to the lit items that are out of view.

#include <string>
#include <vector>

#include "viz/camera.h"
#include "viz/window/window_session.h"

namespace isect::viz {

/// Something out of view: where it would appear, what it is called (markup), and whether its name is lit.
struct OutOfView {
  Vec2 towards = Vec2::Zero();
  std::string name = {};
  bool lit = false;
};
/// An arrow for one or more of them, at a place on the rim.
struct EdgeArrow {
  Vec2 at = Vec2::Zero(), way = Vec2::Zero();  ///< `way` is one pixel long
  std::vector<std::string> names = {};
  bool lit = false;
  /// Returns the names if they are few, else the first and how many more there are; markup.
  std::string words() const;
};

/// Returns all that the scene shows beyond its rectangle: its handles, and the items with a lit name.
std::vector<OutOfView> out_of_view(const Player&, const Ui&, const View&, const Rect& scene);
/// Returns arrows on the rim of `room`; those that would stand close together are one.
std::vector<EdgeArrow> edge_arrows(const std::vector<OutOfView>&, const Rect& room);

/// Make the arrows buttons (before the scene's own) that bring all of the scene into view, and draw them over the
/// picture.
void press_edge_arrows(Player&, Ui&, const View&, const Rect& scene);
void draw_edge_arrows(const Player&, Ui&, const View&, const Rect& scene);

}  // namespace isect::viz
