#pragma once
// The colours of a theme from two that somebody has, such as a university's.

#include "viz/colour/measures.h"

namespace isect::viz {

/// Gives the theme colours for the first and the second object, hit and miss; its grounds and texts stay. The two
/// objects keep the hues of the two colours. Their lightness in OKLCH changes where their labels could not be read
/// otherwise, or where a grey print could not tell them apart; the darker one of the two stays the darker one. Hit and
/// miss stay as near as possible to those of the theme while no reader takes two of the four for each other. Throws
/// BadInput that says why it can't be done, and with which second colour it could: the two look alike, or the theme is
/// one of greys.
void derive_from(OwnTheme&, const Colour& first, const Colour& second);

}  // namespace isect::viz
