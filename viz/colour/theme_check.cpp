#include "viz/colour/theme_check.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "viz/colour/shades.h"

namespace isect::viz {
namespace {

constexpr std::size_t at_background = OwnTheme::background, at_panel = OwnTheme::panel;
constexpr std::size_t at_role(Role role) { return static_cast<std::size_t>(role); }

bool is_based_on(ThemeName name, const OwnTheme& theme) { return theme.based_on == name; }
bool is_main_role(std::size_t index) {
  return std::ranges::find(main_roles, static_cast<Role>(index)) != main_roles.end();
}

/// Returns a contrast with one decimal, never more than it is: 4.49 is "4.4".
std::string contrast_text(double contrast) { return fmt::format("{:.1f}", std::floor(10 * contrast) / 10); }

/// Who sees two colours so near each other.
std::string seen_words(Vision vision) {
  return vision == Vision::usual ? "to every reader" : "to readers with " + name_of(vision);
}

class ThemeChecker {
 public:
  explicit ThemeChecker(const OwnTheme& theme) : asked_(theme), base_(values_of(theme.based_on)) {
    out_.mended = theme;
  }

  ThemeCheck check() && {
    for (const std::size_t index : {at_background, at_panel, at_role(Role::text)}) settle(index);
    for (const bool own : {false, true})
      for (std::size_t index = 0; index < at_background; ++index)
        if (index != at_role(Role::text) && is_own(index) == own) settle(index);
    lines();
    return std::move(out_);
  }

 private:
  bool is_own(std::size_t index) const { return asked_.colours[index] != base_.colours[index]; }

  void settle(std::size_t index) {
    const Colour colour = out_.mended.colours[index];
    if (const std::vector<std::string> whys = against(index, colour); !whys.empty()) {
      ThemeFault fault = {
          ThemeFault::Of::colour, colour_names().at(index), fmt::format("{}", fmt::join(whys, "; ")), {}};
      fault.cure = cure(index, colour);
      out_.faults.push_back(std::move(fault));
    }
    settled_.push_back(index);
  }

  /// Returns all that speaks against a colour beside those that are settled.
  std::vector<std::string> against(std::size_t index, const Colour& colour) const {
    std::vector<std::string> whys;
    if (is_based_on(ThemeName::grey, asked_) && !(colour.r == colour.g && colour.g == colour.b))
      whys.push_back("it has a hue, and a theme based on grey has greys only");
    for (std::string& why : contrast_faults(out_.mended, index, colour)) whys.push_back(std::move(why));
    if (is_main_role(index))
      for (const std::size_t other : settled_)
        if (is_main_role(other)) near(index, colour, other, whys);
    return whys;
  }

  void near(std::size_t index, const Colour& colour, std::size_t other, std::vector<std::string>& whys) const {
    const Colour& beside = out_.mended.colours[other];
    const std::string name = colour_names().at(other);
    const bool objects =
        std::min(index, other) == at_role(Role::first) && std::max(index, other) == at_role(Role::second);
    if (is_based_on(ThemeName::grey, asked_)) {  // hit and miss are told by their marks
      if (const double contrast = contrast_ratio(colour, beside); objects && contrast < demands::greys)
        whys.push_back(fmt::format("{} to 1 against {} {}, and {:g} is wanted of greys", contrast_text(contrast), name,
                                   hex_of(beside), demands::greys));
      return;
    }
    if (const LeastApart least = least_apart(colour, beside); least.distance < demands::apart)
      whys.push_back(fmt::format("{:g} apart from {} {} {}, and {:g} is wanted", least.distance, name, hex_of(beside),
                                 seen_words(least.vision), demands::apart));
    const bool as_built_in = colour == base_.colours[index] && beside == base_.colours[other];
    if (const double grey = std::round(distance_seen(Vision::grey, colour, beside));
        objects && !asked_.hatch && !as_built_in && grey < demands::in_grey)
      whys.push_back(fmt::format("on a grey print {:g} apart from {} {}, and {:g} is wanted, or \"hatch\": true", grey,
                                 name, hex_of(beside), demands::in_grey));
  }

  /// Changes the colour to the nearest one against which nothing speaks, and says which.
  std::string cure(std::size_t index, const Colour& colour) {
    const auto passes = [&](const Colour& other) { return against(index, other).empty(); };
    Colour& mended = out_.mended.colours[index];
    if (is_based_on(ThemeName::grey, asked_)) {
      if (const std::optional<Colour> grey = nearest_that(greys_near(colour), passes))
        return fmt::format("{} would do, the nearest grey", hex_of(mended = *grey));
    } else if (const std::optional<Colour> shade = nearest_that(shades_of(colour), passes)) {
      return fmt::format("{} would do, the nearest of that hue", hex_of(mended = *shade));
    } else if (const std::optional<Colour> hue = nearest_that(hues_near(colour), passes)) {
      return fmt::format("{} would do; none of that hue does", hex_of(mended = *hue));
    }
    out_.is_mended = false;
    return "none does beside the others; change those first";
  }

  /// Each line is wider than the one before it, on paper and, where the theme has sizes in pixels, on a screen.
  void lines() {
    constexpr std::array by_width = {&Sizes::hidden, &Sizes::construction, &Sizes::outline,
                                     &Sizes::ray,    &Sizes::shared,       &Sizes::highlight};
    const bool on_screen = is_based_on(ThemeName::screen, asked_) || is_based_on(ThemeName::dark, asked_);
    const Sizes points = paper_theme(ThemeName::print).sizes, pixels = theme(ThemeName::screen, 960, 600).sizes;
    const auto index_of = [](double Sizes::*width) {
      const auto found = std::ranges::find(named_lines(), width, &NamedLine::width);
      return static_cast<std::size_t>(found - named_lines().begin());
    };
    for (std::size_t i = 1; i < by_width.size(); ++i) {
      double Sizes::*const thin = by_width[i - 1], Sizes::*const line = by_width[i];
      const double pixels_a_point = pixels.*line / (points.*line);
      double least = out_.mended.lines[index_of(thin)];
      if (on_screen) least = std::max(least, least * (pixels.*thin / (points.*thin)) / pixels_a_point);
      double& width = out_.mended.lines[index_of(line)];
      if (width > least) continue;
      const std::string why = fmt::format("{:g} pt, and at {:.3g} pt or less it is no wider than {}", width, least,
                                          named_lines()[index_of(thin)].name);
      const double wider = std::ceil(110 * least) / 100;
      const bool can_be = wider <= widest_line;
      if (can_be) width = wider;
      out_.is_mended = out_.is_mended && can_be;
      const std::string cure = can_be ? fmt::format("{:g} would do", wider)
                                      : fmt::format("make {} thinner", named_lines()[index_of(thin)].name);
      out_.faults.push_back({ThemeFault::Of::line, named_lines()[index_of(line)].name, why, cure});
    }
  }

  const OwnTheme& asked_;
  const OwnTheme base_;
  ThemeCheck out_;
  std::vector<std::size_t> settled_;
};

}  // namespace

std::vector<std::string> contrast_faults(const OwnTheme& theme, std::size_t index, const Colour& colour) {
  const bool is_dark = is_based_on(ThemeName::dark, theme);
  std::vector<std::string> whys;
  const auto demand = [&](const Colour& on, double least, const std::string& what) {
    if (const double contrast = contrast_ratio(colour, on); contrast < least)
      whys.push_back(fmt::format("{} to 1 against {}, and {:g} is wanted", contrast_text(contrast), what, least));
  };
  const auto on_grounds = [&](double least) {
    for (const std::size_t on : {at_background, at_panel})
      demand(theme.colours[on], least, fmt::format("{} {}", colour_names().at(on), hex_of(theme.colours[on])));
  };
  if (index == at_background || index == at_panel) {
    demand(hex(is_dark ? 0xFFFFFF : 0), demands::ground,
           fmt::format("{}, as {} has {} grounds and {} one is based on {}", is_dark ? "white" : "black",
                       name_of(theme.based_on), is_dark ? "dark" : "light", is_dark ? "a light" : "a dark",
                       is_dark ? "print" : "dark"));
    return whys;
  }
  switch (static_cast<Role>(index)) {
    case Role::grid:  // it never carries meaning
      break;
    case Role::highlight: {
      const std::size_t on_it = is_dark ? at_background : at_role(Role::text);
      demand(theme.colours[on_it], demands::text, fmt::format("the {} on it", colour_names().at(on_it)));
      break;
    }
    case Role::text:
      on_grounds(demands::text);
      break;
    case Role::construction:  // dashes and labels only: no area has its tint
      on_grounds(demands::label);
      break;
    case Role::first:
    case Role::second:
    case Role::hit:
    case Role::miss:
    case Role::muted:
      on_grounds(demands::label);
      demand(laid_over(theme.colours[at_background], colour.with_alpha(demands::tint)), demands::label, "its own tint");
      break;
  }
  return whys;
}

LeastApart least_apart(const Colour& a, const Colour& b) {
  LeastApart least = {1e9, Vision::usual};
  for (const Vision vision : all_visions)
    if (const double distance = std::round(distance_seen(vision, a, b));
        vision != Vision::grey && distance < least.distance)
      least = {distance, vision};
  return least;
}

ThemeCheck check_theme(const OwnTheme& theme) { return ThemeChecker(theme).check(); }

}  // namespace isect::viz
