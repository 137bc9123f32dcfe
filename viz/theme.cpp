#include "viz/theme.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>

#include "viz/lesson.h"
#include "viz/text/spelling.h"

namespace isect::viz {
namespace {

/// One colour per role, in the order of Role: first, second, hit, miss, construction, highlight, text, muted,
/// grid.
struct Palette {
  std::array<unsigned, 9> inks;
  unsigned background, panel;
};

constexpr Palette print_palette = {
    {0x0B60C8, 0xA34E00, 0x00624A, 0x7B1E7A, 0x66707C, 0xFFD54A, 0x14181D, 0x545D69, 0xDFE4E9}, 0xFFFFFF, 0xF5F7F9};
constexpr Palette dark_palette = {
    {0x5FA8FF, 0xFF9A3D, 0x5CEBB0, 0xE3A6EE, 0x8C98A8, 0xFFDE59, 0xE9ECF0, 0xA3ADBA, 0x2B333E}, 0x11151B, 0x1A2029};
constexpr Palette grey_palette = {
    {0x111111, 0x5A5A5A, 0x000000, 0x111111, 0x6E6E6E, 0xE2E2E2, 0x111111, 0x555555, 0xDDDDDD}, 0xFFFFFF, 0xF4F4F4};

/// Sizes in points, for a figure of 227 x 142: 8 cm wide on paper.
constexpr Sizes paper_sizes = {.outline = 0.75,
                               .ray = 0.85,
                               .shared = 1.7,
                               .highlight = 2.3,
                               .hidden = 0.4,
                               .construction = 0.5,
                               .hairline = 0.4,
                               .hidden_dash = {1.3, 1.2},
                               .construction_dash = {1.5, 1.1},
                               .disc = 1.5,
                               .ring = 1.3,
                               .marker_line = 0.7,
                               .halo = 0.6,
                               .arrow = 3.6,
                               .handle = 1.5,
                               .handle_ring = 3.2,
                               .title = 6.8,
                               .label = 6.6,
                               .axis = 6.3,
                               .label_offset = 5,
                               .label_clear = 1.4,
                               .label_halo = 0.7,
                               .leader = 0.4,
                               .margin = 2,
                               .gutter = 4,
                               .hatch_gap = 2,
                               .hatch_line = 0.2};

/// Sizes in pixels at 1x, for a picture of 960 x 600.
constexpr Sizes in_pixels = {.outline = 2,
                             .ray = 2.5,
                             .shared = 3,
                             .highlight = 5,
                             .hidden = 1.2,
                             .construction = 1.5,
                             .hairline = 1,
                             .hidden_dash = {5, 5},
                             .construction_dash = {6, 5},
                             .disc = 5.5,
                             .ring = 5,
                             .marker_line = 2.5,
                             .halo = 2.5,
                             .arrow = 14,
                             .handle = 5.5,
                             .handle_ring = 12,
                             .title = 24,
                             .label = 22,
                             .axis = 18,
                             .label_offset = 25,
                             .label_clear = 6,
                             .label_halo = 3,
                             .leader = 1,
                             .margin = 8,
                             .gutter = 16,
                             .hatch_gap = 8,
                             .hatch_line = 0.8};

/// Scales all sizes: Sizes holds lengths and nothing else.
Sizes scaled(const Sizes& sizes, double by) {
  using Lengths = std::array<double, sizeof(Sizes) / sizeof(double)>;
  Lengths lengths = std::bit_cast<Lengths>(sizes);
  for (double& length : lengths) length *= by;
  return std::bit_cast<Sizes>(lengths);
}

const Palette& palette(ThemeName name) {
  switch (name) {
    case ThemeName::grey:
      return grey_palette;
    case ThemeName::dark:
      return dark_palette;
    case ThemeName::screen:
    case ThemeName::print:
      break;
  }
  return print_palette;
}

/// Returns the sizes with a theme's own line widths, which are in proportion to those of a figure on paper.
Sizes with_lines(Sizes sizes, const OwnTheme& own) {
  for (std::size_t i = 0; i < own.lines.size(); ++i)
    sizes.*named_lines()[i].width *= own.lines[i] / (paper_sizes.*named_lines()[i].width);
  return sizes;
}

Theme theme_with(const ThemeChoice& choice, const Sizes& sizes) {
  const OwnTheme values = choice.own() ? *choice.own() : values_of(choice.base());
  Theme theme;
  theme.name = choice.base();
  theme.background = values.colours[OwnTheme::background];
  theme.panel = values.colours[OwnTheme::panel];
  theme.fill_alpha = 0.14;
  theme.overlap_alpha = 0.30;
  theme.hatch_second = values.hatch;
  theme.floor_grid = theme.name == ThemeName::screen || theme.name == ThemeName::dark;
  theme.sizes = choice.own() ? with_lines(sizes, values) : sizes;
  theme.inks.fill(values.colours[static_cast<std::size_t>(Role::text)]);
  std::copy_n(values.colours.begin(), role_count, theme.inks.begin());
  return theme;
}

struct Named {
  ThemeName name;
  const char* text;
};
constexpr Named named_themes[] = {
    {ThemeName::screen, "screen"}, {ThemeName::print, "print"}, {ThemeName::grey, "grey"}, {ThemeName::dark, "dark"}};

}  // namespace

Colour hex(unsigned rgb) { return {(rgb >> 16 & 255) / 255.0, (rgb >> 8 & 255) / 255.0, (rgb & 255) / 255.0, 1}; }

std::string hex_of(const Colour& c) {
  return fmt::format("#{:02x}{:02x}{:02x}", std::lround(255 * c.r), std::lround(255 * c.g), std::lround(255 * c.b));
}

Colour Theme::ink(Role role) const { return inks[static_cast<std::size_t>(role)]; }

Colour Theme::tint(Role role) const {
  switch (like(role)) {
    case Role::hit:
    case Role::miss:
      return ink(role).with_alpha(overlap_alpha);
    case Role::highlight:
      return ink(role).with_alpha(0.55);
    case Role::grid:
      return ink(role).with_alpha(0.5);
    case Role::construction:
    case Role::text:
    case Role::muted:
      return ink(role).with_alpha(fill_alpha / 2);
    case Role::first:
    case Role::second:
      break;
  }
  return ink(role).with_alpha(hatched(role) ? fill_alpha / 2 : fill_alpha);
}

OwnTheme values_of(ThemeName name) {
  const Palette& colours = palette(name);
  OwnTheme values;
  values.name = name_of(name), values.based_on = name, values.hatch = name == ThemeName::grey;
  std::transform(colours.inks.begin(), colours.inks.end(), values.colours.begin(), hex);
  values.colours[OwnTheme::background] = hex(colours.background);
  values.colours[OwnTheme::panel] = hex(colours.panel);
  for (std::size_t i = 0; i < values.lines.size(); ++i) values.lines[i] = paper_sizes.*named_lines()[i].width;
  return values;
}

std::vector<std::string> colour_names() {
  std::vector<std::string> all;
  for (std::size_t i = 0; i < OwnTheme::background; ++i) all.push_back(name_of(static_cast<Role>(i)));
  all.insert(all.end(), {"background", "panel"});
  return all;
}

const std::array<NamedLine, 7>& named_lines() {
  static constexpr std::array<NamedLine, 7> all = {{{"outline", &Sizes::outline},
                                                    {"ray", &Sizes::ray},
                                                    {"shared", &Sizes::shared},
                                                    {"highlight", &Sizes::highlight},
                                                    {"hidden", &Sizes::hidden},
                                                    {"construction", &Sizes::construction},
                                                    {"hairline", &Sizes::hairline}}};
  return all;
}

Theme theme(const ThemeChoice& choice, double width, double height) {
  if (choice.base() == ThemeName::print || choice.base() == ThemeName::grey)
    return theme_with(choice, scaled(paper_sizes, std::min(width / 227, height / 142)));
  return theme_with(choice, scaled(in_pixels, std::min(width / 960, height / 600)));
}

Theme paper_theme(const ThemeChoice& choice, double text_size) {
  Sizes sizes = scaled(paper_sizes, text_size / usual_text_size);  // lines are as thin as they were designed
  const Sizes texts = scaled(paper_sizes, text_size / paper_sizes.label);
  sizes.title = sizes.label = sizes.axis = text_size;
  sizes.label_offset = texts.label_offset, sizes.label_clear = texts.label_clear, sizes.label_halo = texts.label_halo;
  return theme_with(choice, sizes);
}

Theme window_theme(ThemeName name, double scale) { return theme_with(name, scaled(in_pixels, scale)); }

std::string name_of(Role role) {
  if (role >= own_role(0)) return fmt::format("own {}", static_cast<std::size_t>(role) - role_count + 1);
  constexpr std::array roles = {"first", "second", "hit", "miss", "construction", "highlight", "text", "muted", "grid"};
  return roles.at(static_cast<std::size_t>(role));
}

std::vector<std::string> theme_names() {
  std::vector<std::string> all;
  for (const Named& named : named_themes) all.emplace_back(named.text);
  return all;
}

bool is_theme_name(const std::string& text) {
  return std::any_of(std::begin(named_themes), std::end(named_themes), [&](const Named& n) { return text == n.text; });
}

ThemeName theme_named(const std::string& text) {
  for (const Named& named : named_themes)
    if (text == named.text) return named.name;
  if (text.starts_with("gray") || text.starts_with("grey"))
    throw BadInput(fmt::format("theme: \"{}\" is unknown; did you mean \"grey\"? Allowed: {}", text,
                               spelling::listed(theme_names())));
  throw unknown("theme", text, theme_names());
}

std::string name_of(ThemeName name) {
  for (const Named& named : named_themes)
    if (name == named.name) return named.text;
  return {};
}

std::string name_of(const ThemeChoice& choice) { return choice.own() ? choice.own()->name : name_of(choice.base()); }

}  // namespace isect::viz
