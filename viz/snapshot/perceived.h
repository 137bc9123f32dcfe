#pragma once
// How much of the difference between two pictures an eye sees: distances of colours in OKLab, where equal steps look
// equal.
//
// Source: CSS Color 4, section 18.3, "deltaEOK": from black to white it is 1, and 0.02 is just noticed.

#include <cstddef>
#include <string>

#include "viz/text/text.h"

namespace isect::viz {

/// The distance of two colours in OKLab that an eye just notices.
inline constexpr double just_noticed = 0.02;

/// What an eye sees of the difference between two pictures.
struct Perceived {
  std::size_t pixels = 0;        ///< of the picture; 0: the sizes differ, and nothing was measured
  std::size_t changed = 0;       ///< pixels of another colour
  std::size_t seen = 0;          ///< those whose colours are at least `just_noticed` apart
  double largest = 0, mean = 0;  ///< distance over the changed pixels, in OKLab; 0 if there are none

  double share_seen() const { return pixels == 0 ? 0 : static_cast<double>(seen) / static_cast<double>(pixels); }
};
/// Compares pixel by pixel. A colour of `a` stands for all within `slack` of it in every channel, as in compare(): what
/// lies within is equal, and what lies beyond is measured from the nearest of them. See-through pixels are seen on
/// white.
Perceived perceived(const Picture& a, const Picture& b, int slack = 0);

/// Returns "1.2 % of the pixels changed visibly; colours differ by up to 0.31, by 0.12 on average (OKLab; 0.02 is just
/// noticed)".
std::string in_words(const Perceived&);

}  // namespace isect::viz
