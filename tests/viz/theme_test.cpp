#include "viz/theme.h"

#include <algorithm>

#include "tests/catch.h"
#include "tests/viz/drawn.h"
#include "viz/colour/theme_check.h"
#include "viz/compose/marks.h"
#include "viz/compose/own_colours.h"
#include "viz/lesson.h"

namespace theme_test {
using namespace isect::viz;

namespace {

constexpr ThemeName all_themes[] = {ThemeName::screen, ThemeName::print, ThemeName::grey, ThemeName::dark};
constexpr ThemeName coloured_themes[] = {ThemeName::screen, ThemeName::print, ThemeName::dark};
constexpr Role text_roles[] = {Role::first,        Role::second, Role::hit,  Role::miss,
                               Role::construction, Role::text,   Role::muted};

/// `ink` at `alpha` over `ground`.
Colour tint(const Colour& ink, double alpha, const Colour& ground) { return laid_over(ground, ink.with_alpha(alpha)); }

double least_distance(const Theme& theme) {
  double least = 1e9;
  for (const Role a : main_roles)
    for (const Role b : main_roles)
      if (a < b) least = std::min(least, least_apart(theme.ink(a), theme.ink(b)).distance);
  return least;
}

}  // namespace

TEST_CASE("every role that colours text can be read on background, panel and its own tint", "[theme]") {
  for (const ThemeName name : all_themes) {
    const Theme t = window_theme(name);
    for (const Role role : text_roles) {
      INFO(name_of(name) << " role " << static_cast<int>(role));
      CHECK(contrast_ratio(t.ink(role), t.background) >= 4.6);
      CHECK(contrast_ratio(t.ink(role), t.panel) >= 4.6);
      const bool fills = role != Role::construction;  // dashes and labels only: no area has its tint
      if (fills) CHECK(contrast_ratio(t.ink(role), tint(t.ink(role), 0.16, t.background)) >= 4.5);
    }
  }
}

TEST_CASE("plain text has strong contrast, also near-black on highlight", "[theme]") {
  for (const ThemeName name : all_themes) {
    const Theme t = window_theme(name);
    INFO(name_of(name));
    CHECK(contrast_ratio(t.ink(Role::text), t.background) >= 13.8);
    CHECK(contrast_ratio(t.ink(Role::text), t.panel) >= 13.8);
    const Colour near_black = name == ThemeName::dark ? t.background : t.ink(Role::text);
    CHECK(contrast_ratio(near_black, t.ink(Role::highlight)) >= 12.6);
  }
}

TEST_CASE("the four main roles stay apart for colour-blind readers", "[theme]") {
  CHECK(least_distance(window_theme(ThemeName::print)) >= 18);
  CHECK(least_distance(window_theme(ThemeName::screen)) >= 18);
  CHECK(least_distance(window_theme(ThemeName::dark)) >= 14);
}

TEST_CASE("grey has no hue, and a hatch where a coloured theme has a second colour", "[theme]") {
  const Theme grey = window_theme(ThemeName::grey);
  for (const Colour& c : grey.inks) CHECK((c.r == c.g && c.g == c.b));
  CHECK(grey.hatch_second);
  CHECK(contrast_ratio(grey.ink(Role::first), grey.ink(Role::second)) > 2.5);
  for (const ThemeName name : coloured_themes) CHECK_FALSE(window_theme(name).hatch_second);
}

TEST_CASE("only screen and dark have a floor grid", "[theme]") {
  CHECK(window_theme(ThemeName::screen).floor_grid);
  CHECK(window_theme(ThemeName::dark).floor_grid);
  CHECK_FALSE(window_theme(ThemeName::print).floor_grid);
  CHECK_FALSE(window_theme(ThemeName::grey).floor_grid);
}

TEST_CASE("lengths are the designed ones at the designed size and scale with the smaller ratio", "[theme]") {
  const Sizes print = theme(ThemeName::print, 227, 142).sizes;
  CHECK(print.outline == 0.75);
  CHECK(print.title == 6.8);
  CHECK(print.axis >= 6);
  CHECK(print.construction_dash == std::array<double, 2>{1.5, 1.1});

  const Sizes screen = theme(ThemeName::screen, 960, 600).sizes;
  CHECK(screen.outline == 2);
  CHECK(screen.label == 22);
  CHECK(screen.arrow == 14);

  const Sizes twice = theme(ThemeName::grey, 454, 900).sizes, half = theme(ThemeName::dark, 5000, 300).sizes;
  CHECK(twice.outline == Approx(1.5));
  CHECK(twice.hidden_dash[1] == Approx(2.4));
  CHECK(twice.hatch_line == Approx(0.4));
  CHECK(half.handle_ring == Approx(6));
  CHECK(window_theme(ThemeName::dark, 1.5).sizes.label == Approx(33));
}

TEST_CASE("among lines, the shared part is drawn thicker and hidden edges thinner than an outline", "[theme]") {
  for (const ThemeName name : all_themes) {
    const Sizes s = theme(name, 960, 600).sizes;
    CHECK(s.highlight > s.shared);
    CHECK(s.shared > s.ray);
    CHECK(s.ray > s.outline);
    CHECK(s.outline > s.construction);
    CHECK(s.construction > s.hidden);
  }
}

TEST_CASE("every mark stands out from paper, in every role and theme", "[theme]") {
  for (const ThemeName name : all_themes) {
    const Theme style = theme(name, 960, 600);
    for (const Mark kind : {Mark::disc, Mark::ring, Mark::diamond})
      for (const Role role : {Role::first, Role::second, Role::hit, Role::miss, Role::highlight, Role::text}) {
        std::vector<Shape> shapes;
        mark(shapes, kind, {0, 0}, role, style);
        double best = 1;
        for (const Fill& f : all<Fill>(shapes)) best = std::max(best, contrast_ratio(f.colour, style.background));
        for (const Stroke& s : all<Stroke>(shapes)) best = std::max(best, contrast_ratio(s.colour, style.background));
        INFO(name_of(name) << " " << static_cast<int>(kind) << " " << name_of(role));
        CHECK(best >= 3);  // Source: WCAG 2.1, "non-text contrast"
      }
  }
}

TEST_CASE("a theme of one's own has its colours and lines, and is otherwise as the one it is based on", "[theme]") {
  for (const ThemeName name : all_themes) {
    INFO(name_of(name));
    OwnTheme own = values_of(name);
    own.name = "mine";
    const ThemeChoice same(own);
    CHECK(name_of(same) == "mine");
    CHECK(name_of(ThemeChoice(name)) == name_of(name));
    const Theme built_in = theme(name, 960, 600), as_built_in = theme(same, 960, 600);
    CHECK(as_built_in.inks == built_in.inks);
    CHECK(as_built_in.background == built_in.background);
    CHECK(as_built_in.panel == built_in.panel);
    CHECK(as_built_in.hatch_second == built_in.hatch_second);
    for (const NamedLine& line : named_lines()) CHECK(as_built_in.sizes.*line.width == built_in.sizes.*line.width);

    own.colours[0] = hex(0x123456), own.colours[OwnTheme::panel] = hex(0x654321);
    own.lines[0] *= 3, own.hatch = !own.hatch;
    const Theme drawn = theme(ThemeChoice(own), 960, 600), on_paper = paper_theme(ThemeChoice(own), 9);
    CHECK(drawn.name == name);
    CHECK(drawn.ink(Role::first) == hex(0x123456));
    CHECK(drawn.ink(Role::second) == built_in.ink(Role::second));
    CHECK(drawn.panel == hex(0x654321));
    CHECK(drawn.hatch_second != built_in.hatch_second);
    CHECK(drawn.floor_grid == built_in.floor_grid);
    CHECK(drawn.sizes.outline == Approx(3 * built_in.sizes.outline));
    CHECK(drawn.sizes.ray == built_in.sizes.ray);
    CHECK(drawn.sizes.label == built_in.sizes.label);
    CHECK(on_paper.sizes.outline == Approx(2.25));
  }
}

TEST_CASE("themes are found by name, and a wrong name is told the nearest", "[theme]") {
  for (const ThemeName name : all_themes) CHECK(theme_named(name_of(name)) == name);
  CHECK(theme_names() == std::vector<std::string>{"screen", "print", "grey", "dark"});
  try {
    theme_named("gray");
    FAIL("'gray' was taken for a theme");
  } catch (const BadInput& e) {
    CHECK(std::string(e.what()).find("did you mean \"grey\"") != std::string::npos);
  }
}

TEST_CASE("colours of one's own can be read on every ground, and grey print has its own look", "[theme]") {
  const std::vector<OwnColour> own = {{0xFFFF00, Role::first}, {0x000033, Role::second}, {0x1F77B4, Role::first}};
  for (const ThemeName name : all_themes) {
    const Theme plain = theme(name, 960, 600), t = with_colours(plain, own);
    for (std::size_t i = 0; i < own.size(); ++i) {
      INFO(name_of(name) << " " << i);
      CHECK(t.like(own_role(i)) == own[i].like);
      CHECK(contrast_ratio(t.ink(own_role(i)), t.background) >= 4.5);
      CHECK(t.hatched(own_role(i)) == plain.hatched(own[i].like));
      CHECK(t.tint(own_role(i)).a == plain.tint(own[i].like).a);
      if (name == ThemeName::grey) CHECK(t.ink(own_role(i)) == plain.ink(own[i].like));
    }
    CHECK(t.ink(Role::first) == plain.ink(Role::first));
  }
  const Theme print = with_colours(theme(ThemeName::print, 227, 142), own),
              dark = with_colours(theme(ThemeName::dark, 960, 600), own);
  CHECK(print.ink(own_role(1)) == hex(0x000033));  // it stands out as it is
  CHECK(dark.ink(own_role(0)) == hex(0xFFFF00));
  CHECK(print.ink(own_role(0)).b < 0.01);  // still yellow, but darker
  CHECK(print.ink(own_role(0)).r == print.ink(own_role(0)).g);
  CHECK(name_of(own_role(2)) == "own 3");
}

}  // namespace theme_test
