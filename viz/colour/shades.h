#pragma once
// Other colours near a given one, the nearest first: of the same hue, then of all hues.
//
// Nearness is measured in OKLab, where equal steps look about equally large.

#include <functional>
#include <optional>
#include <vector>

#include "viz/colour/measures.h"

namespace isect::viz {

/// Lightness 0..1, chroma 0 (grey) to about 0.37, hue in radians.
struct Oklch {
  double lightness = 0, chroma = 0, hue = 0;
};
Oklch oklch(const Colour&);
/// Returns the opaque colour, in the 256 levels a channel that "#rrggbb" can say; with as much of the chroma as a
/// screen can show.
Colour from_oklch(Oklch);
/// Returns the distance of two colours in OKLab: 1 from black to white.
double oklab_distance(const Colour&, const Colour&);

/// A colour, and how far it lies from the one that is wanted.
struct Shade {
  Colour colour;
  double away = 0;
};
/// Returns the colour itself, and those of its hue and chroma in all lightnesses, the nearest first.
std::vector<Shade> shades_of(const Colour&);
/// Returns the 256 greys, the nearest first.
std::vector<Shade> greys_near(const Colour&);
/// Returns the colour itself, and those of 24 hues in all lightnesses and two chromas, the nearest first.
std::vector<Shade> hues_near(const Colour&);
/// Returns the nearest shade that passes; nothing if none does.
std::optional<Colour> nearest_that(const std::vector<Shade>&, const std::function<bool(const Colour&)>& passes);

}  // namespace isect::viz
