#include "app/figures/theme_swatch.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "viz/colour/theme_check.h"
#include "viz/compose/marks.h"
#include "viz/text/rich_text.h"
#include "viz/text/text.h"

namespace isect::program {

namespace {

using viz::Colour;
using viz::OwnTheme;
using viz::Role;
using viz::Vec2;
using viz::Vision;

const Colour& colour_of(const OwnTheme& theme, Role role) { return theme.colours[static_cast<std::size_t>(role)]; }

/// A contrast of a role, and to what.
struct Contrast {
  double ratio;
  std::string to;
};
/// Returns those that readers need of a role.
std::vector<Contrast> contrasts_of(const OwnTheme& theme, Role role) {
  const Colour &ink = colour_of(theme, role), &ground = theme.colours[OwnTheme::background];
  if (role == Role::grid) return {};
  if (role == Role::highlight) {
    const bool dark = theme.based_on == viz::ThemeName::dark;
    return {{contrast_ratio(ink, dark ? ground : colour_of(theme, Role::text)),
             dark ? "the background on it" : "the text on it"}};
  }
  std::vector<Contrast> all = {{contrast_ratio(ink, ground), "background"},
                               {contrast_ratio(ink, theme.colours[OwnTheme::panel]), "panel"}};
  if (role != Role::construction)  // no area has its tint
    all.push_back({contrast_ratio(ink, laid_over(ground, ink.with_alpha(viz::demands::tint))), "own tint"});
  return all;
}

/// Two roles, and how far apart they look.
struct Near {
  Role one, other;
  double distance;
};
/// Returns the two main roles that look nearest; on a grey print only the two objects are told apart by their colours,
/// and in a theme of greys in no other way.
std::optional<Near> nearest_roles(const OwnTheme& theme, Vision vision) {
  const bool objects_only = vision == Vision::grey;
  if (theme.based_on == viz::ThemeName::grey && !objects_only) return {};
  std::optional<Near> nearest;
  for (const Role one : viz::main_roles)
    for (const Role other : viz::main_roles) {
      if (!(one < other) || (objects_only && (one != Role::first || other != Role::second))) continue;
      const double distance = std::round(distance_seen(vision, colour_of(theme, one), colour_of(theme, other)));
      if (!nearest || distance < nearest->distance) nearest = {one, other, distance};
    }
  return nearest;
}

class Swatch {
 public:
  Swatch(const OwnTheme& theme, double width) : own_(theme), theme_(viz::paper_theme(viz::ThemeChoice(theme))) {
    drawing_.width = width;
    drawing_.background = theme_.background;
  }

  viz::Drawing draw() && {
    text(fmt::format("{}, based on {}", viz::as_markup(own_.name), viz::name_of(own_.based_on)), {margin, y_ + size()},
         Role::text, 0, true);
    fit_width(std::get<viz::Text>(drawing_.shapes.back()), drawing_.width - 2 * margin);
    y_ += 2.2 * size();
    for (const Vision vision : viz::all_visions)
      text(viz::name_of(vision), {middle(vision), y_ + size()}, Role::muted, 0.5);
    text("contrast", {drawing_.width - margin, y_ + size()}, Role::muted, 1);
    as_object("heads", {});
    y_ += 1.6 * size();
    for (std::size_t i = 0; i < OwnTheme::background; ++i) row(static_cast<Role>(i));
    distances();
    y_ += 0.8 * size();
    constexpr const char* notes =
        "Each sample: tint and outline on the background, letters on the panel. Contrast: to background, panel and own "
        "tint; that of highlight to what is written on it. Least apart: of first, second, hit and miss; on a grey "
        "print, of first and second.";
    for (const std::string& line : viz::wrapped(notes, size(), false, drawing_.width - 2 * margin))
      text(line, {margin, y_ += 1.3 * size()}, Role::muted, 0);
    as_object("notes", {});
    drawing_.height = y_ + margin;
    return std::move(drawing_);
  }

 private:
  static constexpr double margin = 6, names_width = 64, contrast_width = 62, pitch = 20;

  double size() const { return theme_.sizes.label; }
  double column() const {
    return (drawing_.width - 2 * margin - names_width - contrast_width) / viz::all_visions.size();
  }
  double middle(Vision vision) const { return margin + names_width + (static_cast<double>(vision) + 0.5) * column(); }

  void text(const std::string& markup, const Vec2& at, Role role, double align, bool bold = false) {
    drawing_.shapes.emplace_back(viz::Text{markup, at, size(), edge_ink(role, theme_), align, bold});
  }
  void box(const Vec2& middle, const Vec2& half, viz::Fill fill) {
    const Vec2 across(half.x(), 0), down(0, half.y());
    fill.path = viz::polyline(
        {middle - across - down, middle + across - down, middle + across + down, middle - across + down}, true);
    drawing_.shapes.emplace_back(std::move(fill));
  }
  void as_object(const std::string& kind, const std::string& name, Role role = Role::text) {
    viz::assign(drawing_.shapes, assigned_, viz::add_object(drawing_.objects, {kind, name, role}));
    assigned_ = drawing_.shapes.size();
  }

  void row(Role role) {
    const double baseline = y_ + pitch / 2 + 0.35 * size();
    text(viz::name_of(role), {margin, baseline}, Role::text, 0);
    for (const Vision vision : viz::all_visions) sample(role, vision);
    std::string numbers;
    for (const Contrast& c : contrasts_of(own_, role))
      numbers += fmt::format("{}{:.1f}", numbers.empty() ? "" : "  ", std::floor(10 * c.ratio) / 10);
    if (!numbers.empty()) text(numbers, {drawing_.width - margin, baseline}, Role::text, 1);
    y_ += pitch;
    as_object("role", viz::name_of(role), role);
  }

  /// Draws the role as these eyes see it.
  void sample(Role role, Vision vision) {
    const auto seen = [&](const Colour& c) { return seen_by(vision, c); };
    const Vec2 center(middle(vision), y_ + pitch / 2);
    const Colour ink = seen(edge_ink(role, theme_));
    box(center, {column() / 2, pitch / 2}, {{}, seen(theme_.background)});
    const double half = 0.2 * column();
    const Vec2 left = center - Vec2(half, 0), right = center + Vec2(half, 0);
    const Colour inside = role == Role::highlight ? theme_.ink(role) : laid_over(theme_.background, theme_.tint(role));
    viz::Fill fill = {{}, seen(inside)};
    if (theme_.hatched(role))
      fill.hatch_gap = theme_.sizes.hatch_gap, fill.hatch_line = theme_.sizes.hatch_line, fill.hatch_colour = ink;
    box(left, {0.8 * half, 0.32 * pitch}, fill);
    const viz::Path rim = std::get<viz::Fill>(drawing_.shapes.back()).path;
    const bool dashed = role == Role::construction;
    const std::array<double, 2> dash = dashed ? theme_.sizes.construction_dash : std::array<double, 2>{0, 0};
    drawing_.shapes.emplace_back(viz::Stroke{rim, ink, theme_.sizes.outline, dash, !dashed});
    if (role == Role::grid) return;  // it colours no text
    box(right, {0.8 * half, 0.45 * pitch}, {{}, seen(theme_.panel)});
    drawing_.shapes.emplace_back(viz::Text{"Aa", right + Vec2(0, 0.35 * size()), size(), ink, 0.5});
  }

  void distances() {
    const double baseline = y_ + pitch / 2 + 0.35 * size();
    text("least apart", {margin, baseline}, Role::text, 0);
    for (const Vision vision : viz::all_visions)
      if (const std::optional<Near> near = nearest_roles(own_, vision))
        text(fmt::format("{:g}", near->distance), {middle(vision), baseline}, Role::text, 0.5);
    y_ += pitch;
    as_object("distances", {});
  }

  const OwnTheme& own_;
  const viz::Theme theme_;
  viz::Drawing drawing_;
  double y_ = margin;         ///< where the next row begins
  std::size_t assigned_ = 0;  ///< this many shapes have their object
};

}  // namespace

std::string theme_table(const OwnTheme& theme) {
  std::string all = fmt::format("{}, based on {}\n", theme.name, viz::name_of(theme.based_on));
  const std::vector<std::string> names = viz::colour_names();
  for (std::size_t i = 0; i < names.size(); ++i) {
    std::string told;
    if (i < OwnTheme::background)
      for (const Contrast& c : contrasts_of(theme, static_cast<Role>(i)))
        told += fmt::format("{}{:.1f} to {}", told.empty() ? "  " : ", ", std::floor(10 * c.ratio) / 10, c.to);
    all += fmt::format("  {:<13} {}{}\n", names[i], viz::hex_of(theme.colours[i]), told);
  }
  all += "How far apart the nearest two main roles look:\n";
  for (const Vision vision : viz::all_visions)
    if (const std::optional<Near> near = nearest_roles(theme, vision))
      all += fmt::format("  {:<13} {:g}, {} and {}\n", viz::name_of(vision), near->distance, viz::name_of(near->one),
                         viz::name_of(near->other));
  return all;
}

viz::Drawing theme_swatch(const OwnTheme& theme, double width) { return Swatch(theme, width).draw(); }

}  // namespace isect::program
