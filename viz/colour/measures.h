#pragma once
// How well eyes tell colours apart: contrast, distance, and what colour-blind readers and grey print make of a colour.

#include <array>
#include <string>

#include "viz/theme.h"

namespace isect::viz {

/// Returns red, green and blue in proportion to light, 0..1; alpha is ignored. Source: IEC 61966-2-1 (sRGB).
Vec3 linear_rgb(const Colour&);
/// Returns the opaque colour of such light; what a screen cannot show is clipped to 0..1.
Colour from_linear_rgb(const Vec3&);
/// Returns the colour's light as eyes weigh it, 0 for black to 1 for white. Source: WCAG 2.1, "relative luminance".
double relative_luminance(const Colour&);
/// Returns the contrast of two opaque colours, from 1 to 21. Source: WCAG 2.1, "contrast ratio".
double contrast_ratio(const Colour&, const Colour&);
/// The least contrast of a text to what lies under it. Source: WCAG 2.1, success criterion 1.4.3.
constexpr double least_contrast = 4.5;
/// Returns the opaque colour of `ink`, as dense as its alpha says, on an opaque ground: mixed channel by channel, as
/// screens do.
Colour laid_over(const Colour& ground, const Colour& ink);

/// CIE 1976 L*a*b* under D65: L* from 0 for black to 100 for white. A step of about 2 is just seen.
Vec3 cie_lab(const Colour&);

/// Returns lightness, 0 for black to 1 for white, and the two opponent colours, green to red and blue to yellow, of an
/// opaque colour: equal steps look about equally large. Source: B. Ottosson, "A perceptual color space for image
/// processing" (2020).
Vec3 oklab(const Colour&);

/// Who looks: readers who see three colours, those without one kind of cone, and all of them on a grey print.
enum class Vision { usual, protan, deutan, tritan, grey };
inline constexpr std::array all_visions = {Vision::usual, Vision::protan, Vision::deutan, Vision::tritan, Vision::grey};
/// Returns "protanopia", for a head.
std::string name_of(Vision);
/// Returns the opaque colour that looks to usual eyes as `colour` does to these. Grey print keeps the luminance. The
/// others at full severity: G. Machado, M. Oliveira, L. Fernandes, "A physiologically-based model for simulation of
/// color vision deficiency", IEEE TVCG 15 (2009), table 1.
Colour seen_by(Vision, const Colour&);
/// Returns how far apart two colours look: their distance in CIE L*a*b* as they are seen; in grey, that of lightness.
double distance_seen(Vision, const Colour&, const Colour&);

}  // namespace isect::viz
