#pragma once
// Where a picture differs from the one before it: only there it is drawn again.

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "viz/drawing.h"
#include "viz/gl/renderer.h"
#include "viz/gl/tessellate.h"

namespace isect::viz {

/// What a picture remembers of a shape that was drawn.
struct DrawnShape {
  std::uint64_t print;  ///< a hash of all that is seen of it
  Box box;              ///< it covers nothing outside, up to a pixel; in the drawing's units
};

/// Returns the drawing's shapes, in their order. `box_of` tells the box of a text.
std::vector<DrawnShape> drawn_shapes(const Drawing&, const std::function<Box(const Text&)>& box_of);

/// Returns a box outside of which both pictures look the same: one without area, `low` = `high`, if nothing changed.
/// Nothing if that is not known: shapes that both have come in another order, or a place is not finite.
std::optional<Box> changed(const std::vector<DrawnShape>& before, const std::vector<DrawnShape>& now);

bool meet(const Box&, const Box&);

/// What a target shows; nothing is known of it while the scale is 0.
struct LastPicture {
  PixelBox part = {};  ///< of the drawing, in pixels from its top left corner
  double scale = 0;    ///< pixels per unit of the drawing
  Colour background = {};
  std::vector<DrawnShape> shapes = {};
};

/// Returns the pixels of the part in which the picture may differ from the last one: none if nothing changed, all if
/// that is not known or if the last one had another part, scale or background.
PixelBox to_draw(const LastPicture& last, const LastPicture& now);

}  // namespace isect::viz
