#include "viz/compose/own_colours.h"

#include <algorithm>

#include "viz/compose/halos.h"

namespace isect::viz {

Theme with_colours(Theme theme, const std::vector<OwnColour>& colours) {
  constexpr double readable = 4.5;
  constexpr int shares = 64;
  const Colour white = hex(0xFFFFFF), black = hex(0x000000);
  const Colour& far = contrast_ratio(white, theme.background) > contrast_ratio(black, theme.background) ? white : black;
  for (std::size_t i = 0; i < std::min(colours.size(), most_own_colours); ++i) {
    theme.likes[i] = colours[i].like;
    const Colour given = hex(colours[i].rgb);
    Colour ink = given;
    for (int k = 1; k <= shares && contrast_ratio(ink, theme.background) < readable; ++k) {
      const double share = static_cast<double>(k) / shares;
      ink = {given.r + share * (far.r - given.r), given.g + share * (far.g - given.g),
             given.b + share * (far.b - given.b)};
    }
    theme.inks[role_count + i] = theme.hatch_second ? theme.ink(colours[i].like) : ink;
  }
  return theme;
}

}  // namespace isect::viz
