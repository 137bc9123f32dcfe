#pragma once
// Names in the picture: which one the pointer is at, and the light on items with a lit name.

#include "viz/compose/compose.h"
#include "viz/window/window_session.h"

namespace isect::viz {

/// Asks for the names of the handle or the named point or line nearest to the pointer, or of the label under it.
void point_at_names(const Player&, Ui&, const View&, const Rect& scene, const std::vector<PlacedLabel>&,
                    const std::optional<Handle>& under);
/// Draws the light over labels and objects: a lit label is near-black on the highlight, and beside it stands the number
/// that its name has at this step.
void light_names(const Player&, Ui&, const View&, const Rect& scene, const std::vector<PlacedLabel>&);

}  // namespace isect::viz
