#pragma once
// Roles get their colours here and nowhere else. Blue meets orange; green is where they meet.

#include <array>
#include <memory>
#include <string>
#include <utility>
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
/// Returns "#rrggbb"; alpha is ignored.
std::string hex_of(const Colour&);

/// `screen`: light, with floor grid. `print`: for paper. `grey`: for grey print. `dark`: the window's own.
enum class ThemeName { screen, print, grey, dark };

/// A theme of one's own: what the built-in theme on which it is based leaves open, that is colours and line widths. In
/// all else, such as the light on a ball, it is as that theme.
struct OwnTheme {
  static constexpr std::size_t background = 9, panel = 10;  ///< their colours, after those of the nine roles

  std::string name;
  ThemeName based_on = ThemeName::print;
  std::array<Colour, 11> colours = {};  ///< named by colour_names(); opaque
  std::array<double, 7> lines = {};     ///< widths in points of a figure 8 cm wide, as named_lines() lists them
  bool hatch = false;                   ///< the second object carries a 45 degree hatch
  std::string font = {};                ///< the family of all letters, for whoever draws to set; empty: the usual one
  bool operator==(const OwnTheme&) const = default;
};
/// Returns the names of the roles, in the order of Role, then "background" and "panel".
std::vector<std::string> colour_names();
/// Returns the values of a built-in theme, under its own name.
OwnTheme values_of(ThemeName);

/// The theme that a figure is drawn in: a built-in one, or one's own.
class ThemeChoice {
 public:
  ThemeChoice(ThemeName name = ThemeName::screen) : base_(name) {}  // NOLINT: a name is a choice
  explicit ThemeChoice(OwnTheme own) : base_(own.based_on), own_(std::make_shared<const OwnTheme>(std::move(own))) {}

  /// Returns the built-in theme, or the one that one's own is based on.
  ThemeName base() const { return base_; }
  /// Returns the values of one's own theme; null for a built-in one.
  const OwnTheme* own() const { return own_.get(); }

 private:
  ThemeName base_;
  std::shared_ptr<const OwnTheme> own_;  // values do not change
};

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

/// A line whose width a theme of one's own may set.
struct NamedLine {
  const char* name;  ///< "outline"
  double Sizes::*width;
};
const std::array<NamedLine, 7>& named_lines();

struct Theme {
  ThemeName name;  ///< the built-in one, or the one on which it is based
  Colour ink(Role) const;
  /// Returns the fill of a flat area: translucent, densest where objects overlap.
  Colour tint(Role) const;
  /// Whether an area of this role carries the 45 degree hatch.
  bool hatched(Role role) const { return hatch_second && like(role) == Role::second; }
  /// Returns the part that items of this role play, which own colours are of a scene.
  Role like(Role role) const { return role < own_role(0) ? role : likes[static_cast<std::size_t>(role) - role_count]; }
  Colour background, panel;
  double fill_alpha, overlap_alpha;
  bool hatch_second;  ///< grey: the second object carries a 45 degree hatch; others if they say so
  bool floor_grid;    ///< screen and dark: fading floor grid, drop lines, contact shadow
  Sizes sizes;
  std::array<Colour, role_count + most_own_colours> inks;
  std::array<Role, most_own_colours> likes = {};
};

/// The size of labels on paper, in points: it reads well beside a text of ten points.
constexpr double usual_text_size = 9;

/// Returns the theme with all lengths for a drawing of the given size. print and grey are designed at 227 x 142 pt,
/// screen and dark at 960 x 600 px, and scale with the smaller ratio.
Theme theme(const ThemeChoice&, double width, double height);
/// Returns a theme for paper: lengths in points, and texts of one size, however large the figure.
Theme paper_theme(const ThemeChoice&, double text_size = usual_text_size);
/// Returns a theme for the window: px sizes at 1x, whatever the size of the scene, times `scale`.
Theme window_theme(ThemeName, double scale = 1);

std::vector<std::string> theme_names();
/// Whether a built-in theme has this name.
bool is_theme_name(const std::string&);
/// Returns the theme with this name. Throws BadInput naming the nearest one.
ThemeName theme_named(const std::string&);
std::string name_of(ThemeName);
std::string name_of(const ThemeChoice&);
std::string name_of(Role);

}  // namespace isect::viz
