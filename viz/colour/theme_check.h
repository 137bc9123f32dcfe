#pragma once
// Whether readers can read a theme's colours and tell them apart, and what to change if not.

#include <string>
#include <vector>

#include "viz/colour/measures.h"

namespace isect::viz {

/// What every theme must do; the built-in ones do more, as their test says.
namespace demands {
constexpr double label = least_contrast;  ///< contrast of what may colour texts
constexpr double text = 7;                ///< contrast of plain text, also on a highlight. Source: WCAG 2.1, 1.4.6
constexpr double ground = 13;             ///< contrast of black to a light ground, of white to a dark one
constexpr double tint = 0.16;             ///< how dense a role's own tint is below its labels
constexpr double apart = 14;    ///< distance of two main roles in CIE L*a*b*, rounded, for each vision in colour
constexpr double in_grey = 10;  ///< distance in lightness of the first and the second object on a grey print, rounded
constexpr double greys = 2.5;   ///< contrast of these two in a theme of greys
}  // namespace demands

/// What the width of a line may be, in points.
constexpr double thinnest_line = 0.1, widest_line = 6;

/// The roles that a reader must tell apart by their colours.
inline constexpr std::array main_roles = {Role::first, Role::second, Role::hit, Role::miss};

/// Returns why a colour can't be read as the colour with this index of a theme; empty if it can.
std::vector<std::string> contrast_faults(const OwnTheme&, std::size_t index, const Colour&);
/// Returns how far apart two colours look, rounded, to those readers in colour who see the least difference.
struct LeastApart {
  double distance = 0;
  Vision vision = Vision::usual;
};
LeastApart least_apart(const Colour&, const Colour&);

/// A colour or a line that a theme can't have.
struct ThemeFault {
  enum class Of { colour, line } of = Of::colour;
  std::string name;  ///< "second", "ray"
  std::string why;   ///< "2.1 to 1 against background #ffffff, and 4.5 is wanted"
  std::string cure;  ///< "#8c5e00 would do, the nearest of that hue"
};
struct ThemeCheck {
  std::vector<ThemeFault> faults;
  OwnTheme mended;        ///< with what the cures name
  bool is_mended = true;  ///< whether each fault has a cure: then `mended` has no fault
};
/// Checks all colours and lines. Colours are checked in this order, each beside those before it as their cures leave
/// them: background, panel, text, what is as in the theme it is based on, and the rest in the order of Role.
ThemeCheck check_theme(const OwnTheme&);

}  // namespace isect::viz
