#pragma once
// Roles get their colours here and nowhere else. Blue meets orange; green is where they meet.

#include <array>
#include <string>
#include <vector>

#include "viz/scene.h"

namespace isect::viz {

/// sRGB in 0..1, not premultiplied.
struct Colour {
  double r = 0, g = 0, b = 0, a = 1;
  Colour with_alpha(double alpha) const { return {r, g, b, alpha}; }
  bool operator==(const Colour&) const = default;
};
Colour hex(unsigned rgb);

/// `screen`: light, with floor grid. `print`: for paper. `grey`: for grey print. `dark`: the window's own.
enum class ThemeName { screen, print, grey, dark };

/// Lengths in units of the drawing (see `theme`).
struct Sizes {
  double outline, ray, shared, highlight, hidden, construction, hairline;
  std::array<double, 2> hidden_dash, construction_dash;
  double disc, ring, marker_line, halo, arrow;  ///< radii, line width, halo width, arrow length
  double handle, handle_ring;
  double title, label, axis;  ///< font sizes
  double label_offset, label_clear, label_halo, leader;
  double margin, gutter;
  double hatch_gap, hatch_line;
};

struct Theme {
  ThemeName name;
  Colour ink(Role) const;
  /// Returns the fill of a flat area: translucent, densest where objects overlap.
  Colour tint(Role) const;
  /// Whether an area of this role carries the 45 degree hatch.
  bool hatched(Role role) const { return hatch_second && like(role) == Role::second; }
  /// Returns the part that items of this role play, which own colours are of a scene.
  Role like(Role role) const { return role < own_role(0) ? role : likes[static_cast<std::size_t>(role) - role_count]; }
  Colour background, panel;
  double fill_alpha, overlap_alpha;
  bool hatch_second;  ///< grey: the second object carries a 45 degree hatch
  bool floor_grid;    ///< screen and dark: fading floor grid, drop lines, contact shadow
  Sizes sizes;
  std::array<Colour, role_count + most_own_colours> inks;
  std::array<Role, most_own_colours> likes = {};
};

/// The size of labels on paper, in points: it reads well beside a text of ten points.
constexpr double usual_text_size = 9;

/// Returns the theme with all lengths for a drawing of the given size. print and grey are designed at 227 x 142 pt,
/// screen and dark at 960 x 600 px, and scale with the smaller ratio.
Theme theme(ThemeName, double width, double height);
/// Returns a theme for paper: lengths in points, and texts of one size, however large the figure.
Theme paper_theme(ThemeName, double text_size = usual_text_size);
/// Returns a theme for the window: px sizes at 1x, whatever the size of the scene, times `scale`.
Theme window_theme(ThemeName, double scale = 1);

std::vector<std::string> theme_names();
/// Returns the theme with this name. Throws BadInput naming the nearest one.
ThemeName theme_named(const std::string&);
std::string name_of(ThemeName);
std::string name_of(Role);

}  // namespace isect::viz
