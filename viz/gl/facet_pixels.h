#pragma once
// Facets -> pixels without OpenGL.

#include "viz/gl/renderer.h"

namespace isect::viz {

/// Draws facets pixel by pixel, without smooth edges or seams: thousands of facets of a few pixels each would take a
/// software renderer with four samples six times as long. `scale` is in pixels per unit of the drawing. Returns the
/// pixels that lie in `part`; an empty picture if none does. Facets with a corner that is not finite are left out.
Rastered raster(const Facets&, double scale, const PixelBox& part);

}  // namespace isect::viz
