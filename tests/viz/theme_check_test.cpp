// What readers can read and tell apart, and the colours that are suggested or derived: each passes itself.

#include "viz/colour/theme_check.h"

#include <cmath>
#include <numbers>
#include <random>

#include "tests/catch.h"
#include "tests/settings.h"
#include "viz/colour/shades.h"
#include "viz/colour/two_colours.h"
#include "viz/lesson.h"

namespace theme_check_test {
using namespace isect::viz;
using isect::test::Contains;

namespace {

constexpr ThemeName all_themes[] = {ThemeName::screen, ThemeName::print, ThemeName::grey, ThemeName::dark};
constexpr ThemeName coloured_themes[] = {ThemeName::screen, ThemeName::print, ThemeName::dark};

std::size_t at(Role role) { return static_cast<std::size_t>(role); }

OwnTheme with(ThemeName base, Role role, unsigned colour) {
  OwnTheme theme = values_of(base);
  theme.colours[at(role)] = hex(colour);
  return theme;
}

/// The only fault of a theme.
ThemeFault fault_of(const OwnTheme& theme) {
  const ThemeCheck check = check_theme(theme);
  REQUIRE(check.faults.size() == 1);
  return check.faults.front();
}

double turn(double a, double b) { return std::abs(std::remainder(a - b, 2 * std::numbers::pi)); }

std::mt19937_64 generator() { return std::mt19937_64(isect::tests::seed()); }
Colour any_colour(std::mt19937_64& random) { return hex(static_cast<unsigned>(random() & 0xFFFFFF)); }

}  // namespace

TEST_CASE("the yardsticks measure known colours", "[colour]") {
  CHECK(contrast_ratio(hex(0x000000), hex(0xFFFFFF)) == Approx(21));
  CHECK(contrast_ratio(hex(0x777777), hex(0xFFFFFF)) == Approx(4.48).margin(0.01));
  CHECK(cie_lab(hex(0xFFFFFF)).x() == Approx(100).margin(0.01));
  CHECK((cie_lab(hex(0xFF0000)) - Vec3(53.24, 80.09, 67.20)).norm() < 0.05);
  CHECK(laid_over(hex(0xFFFFFF), hex(0x000000).with_alpha(0.25)) == Colour{0.75, 0.75, 0.75, 1});
  // Red and green at full severity: far apart for most eyes, near for deutans; in grey equal where equally light.
  CHECK(distance_seen(Vision::deutan, hex(0xB04040), hex(0x7A6A20)) <
        0.5 * distance_seen(Vision::usual, hex(0xB04040), hex(0x7A6A20)));
  CHECK(distance_seen(Vision::grey, hex(0xB04040), hex(0x7A6A20)) < 5);
  for (const Vision vision : all_visions) {  // what has no hue looks the same to all
    INFO(name_of(vision));
    CHECK(hex_of(seen_by(vision, hex(0x777777))) == "#777777");
  }
  const Colour grey = seen_by(Vision::grey, hex(0x00549F));
  CHECK((grey.r == grey.g && grey.g == grey.b));
  CHECK(relative_luminance(grey) == Approx(relative_luminance(hex(0x00549F))));
}

TEST_CASE("OKLCH is read and written back, and what no screen shows loses chroma alone", "[colour]") {
  CHECK(oklch(hex(0xFFFFFF)).lightness == Approx(1).margin(1e-6));
  CHECK(oklch(hex(0xFF0000)).lightness == Approx(0.6279).margin(1e-3));
  CHECK(oklch(hex(0xFF0000)).chroma == Approx(0.2577).margin(1e-3));
  CHECK(oklch(hex(0xFF0000)).hue == Approx(0.5102).margin(1e-3));
  CHECK(oklab_distance(hex(0), hex(0xFFFFFF)) == Approx(1).margin(1e-6));
  std::mt19937_64 random = generator();
  for (int i = 0; i < 300; ++i) {
    const Colour c = any_colour(random);
    INFO(hex_of(c));
    CHECK(hex_of(from_oklch(oklch(c))) == hex_of(c));
  }
  const Oklch vivid = oklch(from_oklch({0.3, 0.4, 1}));
  CHECK(vivid.lightness == Approx(0.3).margin(0.01));
  CHECK(turn(vivid.hue, 1) < 0.05);
  CHECK(vivid.chroma < 0.2);
}

TEST_CASE("other colours near one begin with itself, and lie ever farther away", "[colour]") {
  const Colour c = hex(0x00549F);
  for (const std::vector<Shade>& all : {shades_of(c), hues_near(c), greys_near(hex(0x808080))}) {
    REQUIRE(all.size() > 100);
    CHECK(all.front().away < 1e-9);
    for (std::size_t i = 1; i < all.size(); ++i) CHECK(all[i - 1].away <= all[i].away);
  }
  for (const Shade& shade : shades_of(c))
    if (oklch(shade.colour).chroma > 0.05) CHECK(turn(oklch(shade.colour).hue, oklch(c).hue) < 0.1);
  CHECK_FALSE(nearest_that(shades_of(c), [](const Colour&) { return false; }));
}

TEST_CASE("the built-in themes pass", "[theme check]") {
  for (const ThemeName name : all_themes) {
    INFO(name_of(name));
    CHECK(check_theme(values_of(name)).faults.empty());
  }
}

TEST_CASE("a colour that some can't read, or take for another, is named with what it lacks", "[theme check]") {
  const ThemeFault light = fault_of(with(ThemeName::print, Role::muted, 0xA0A0A0));
  CHECK(light.name == "muted");
  CHECK_THAT(light.why, Contains("2.6 to 1 against background #ffffff, and 4.5 is wanted") && Contains("own tint"));
  CHECK_THAT(light.cure, Contains(" would do, the nearest of that hue"));

  CHECK_THAT(check_theme(with(ThemeName::print, Role::text, 0x6A6A6A)).faults.front().why, Contains("and 7 is wanted"));
  CHECK_THAT(fault_of(with(ThemeName::print, Role::highlight, 0x00549F)).why, Contains("against the text on it"));
  CHECK_THAT(fault_of(with(ThemeName::dark, Role::highlight, 0x404000)).why, Contains("against the background on it"));
  CHECK_THAT(fault_of(with(ThemeName::print, Role::miss, 0x0B60C8)).why,
             Contains("0 apart from first #0b60c8 to every reader, and 14 is wanted"));
  CHECK_THAT(fault_of(with(ThemeName::grey, Role::hit, 0x400000)).why,
             Contains("a theme based on grey has greys only"));
  CHECK_THAT(fault_of(with(ThemeName::grey, Role::second, 0x222222)).why, Contains("2.5 is wanted of greys"));
  CHECK(check_theme(with(ThemeName::print, Role::grid, 0xFFFFFF)).faults.empty());  // it carries no meaning

  OwnTheme night = values_of(ThemeName::print);
  night.colours[OwnTheme::background] = hex(0x202020);
  CHECK_THAT(check_theme(night).faults.front().why,
             Contains("against black") && Contains("a dark one is based on dark"));
}

TEST_CASE("red and green alike to some are refused, whatever most readers see", "[theme check]") {
  OwnTheme theme = with(ThemeName::print, Role::first, 0xA33A3A);
  theme.colours[at(Role::second)] = hex(0x5C5A14);
  theme.hatch = true;  // so that only colours speak
  CHECK(distance_seen(Vision::usual, hex(0xA33A3A), hex(0x5C5A14)) > 40);
  const ThemeCheck check = check_theme(theme);
  REQUIRE_FALSE(check.faults.empty());
  CHECK_THAT(check.faults.back().why, Contains("to readers with") && Contains("14 is wanted"));
  CHECK(check.is_mended);
}

TEST_CASE("the two objects differ on a grey print, or the second is hatched", "[theme check]") {
  OwnTheme theme = with(ThemeName::print, Role::second, 0x8A5A00);  // as light as the first
  CHECK_THAT(fault_of(theme).why, Contains("on a grey print") && Contains("\"hatch\": true"));
  theme.hatch = true;
  CHECK(check_theme(theme).faults.empty());
}

TEST_CASE("lines keep their order, on a screen, too", "[theme check]") {
  OwnTheme theme = values_of(ThemeName::print);
  theme.lines[0] = 1.2;  // outline
  const ThemeFault ray = fault_of(theme);
  CHECK(ray.of == ThemeFault::Of::line);
  CHECK(ray.name == "ray");
  CHECK_THAT(ray.why, Contains("no wider than outline"));
  CHECK(ray.cure == "1.32 would do");
  CHECK(check_theme(check_theme(theme).mended).faults.empty());

  theme = values_of(ThemeName::print);
  theme.lines[2] = 1;  // shared: wider than a ray on paper, and thinner on a screen
  CHECK(check_theme(theme).faults.empty());
  theme.based_on = ThemeName::screen;
  CHECK(fault_of(theme).name == "shared");
  const Sizes mended = isect::viz::theme(ThemeChoice(check_theme(theme).mended), 960, 600).sizes;
  CHECK(mended.shared > mended.ray);
}

TEST_CASE("random themes pass, or do so with the colours that are suggested", "[theme check]") {
  std::mt19937_64 random = generator();
  for (const ThemeName base : all_themes)
    for (int i = 0; i < isect::tests::cases(40, 1000); ++i) {
      OwnTheme theme = values_of(base);
      for (Colour& c : theme.colours)
        if (random() % 5 < 2) c = any_colour(random);
      theme.hatch = random() % 2 == 0;
      const ThemeCheck check = check_theme(theme);
      INFO(name_of(base) << " " << i << ", ISECT_SEED=" << isect::tests::seed());
      for (const ThemeFault& fault : check.faults) {
        CHECK_FALSE(fault.why.empty());
        CHECK_THAT(fault.cure, Contains(" would do") || Contains("change those first"));
      }
      if (check.faults.empty()) CHECK(check.mended == theme);
      if (check.is_mended) CHECK(check_theme(check.mended).faults.empty());
    }
}

TEST_CASE("a theme of two colours passes and keeps their hues and order, or is refused with two that do",
          "[theme check]") {
  std::mt19937_64 random = generator();
  for (const ThemeName base : coloured_themes) {
    int made = 0;
    for (int i = 0; i < isect::tests::cases(200, 2000); ++i) {
      const Colour first = any_colour(random), second = any_colour(random);
      INFO(name_of(base) << " " << hex_of(first) << " " << hex_of(second));
      OwnTheme theme = values_of(base);
      try {
        derive_from(theme, first, second);
      } catch (const BadInput& e) {
        const std::string why = e.what();
        REQUIRE_THAT(why, Contains("; with #"));
        const std::string other = why.substr(why.find("; with #") + 8, 6);
        OwnTheme again = values_of(base);
        derive_from(again, first, hex(static_cast<unsigned>(std::stoul(other, nullptr, 16))));
        CHECK(check_theme(again).faults.empty());
        continue;
      }
      ++made;
      CHECK(check_theme(theme).faults.empty());
      const Colour asked[] = {first, second};
      for (std::size_t k = 0; k < 2; ++k) {
        const Oklch from = oklch(asked[k]), to = oklch(theme.colours[k]);
        if (from.chroma > 0.05 && to.chroma > 0.05) CHECK(turn(from.hue, to.hue) < 0.15);
      }
      const double rise = relative_luminance(second) - relative_luminance(first);
      if (std::abs(rise) > 1e-3)
        CHECK((relative_luminance(theme.colours[1]) > relative_luminance(theme.colours[0])) == (rise > 0));
      const OwnTheme base_values = values_of(base);
      for (std::size_t k = 4; k < theme.colours.size(); ++k) CHECK(theme.colours[k] == base_values.colours[k]);
    }
    CHECK(made > 150);
  }
}

TEST_CASE("two colours that are one, or for a theme of greys, are refused with the reason", "[theme check]") {
  const auto why = [](ThemeName base, unsigned first, unsigned second) -> std::string {
    OwnTheme theme = values_of(base);
    try {
      derive_from(theme, hex(first), hex(second));
    } catch (const BadInput& e) {
      CHECK(theme == values_of(base));
      return e.what();
    }
    return {};
  };
  CHECK_THAT(why(ThemeName::print, 0x00549F, 0x00549F), Contains("look alike, 0.0 apart") && Contains("; with #"));
  CHECK_THAT(why(ThemeName::grey, 0x00549F, 0xF6A800), Contains("based on grey"));
  CHECK(why(ThemeName::print, 0x00549F, 0xF6A800).empty());
  CHECK(why(ThemeName::print, 0x000000, 0xFFFFFF).empty());
  CHECK(why(ThemeName::dark, 0x000000, 0xFFFFFF).empty());
}

}  // namespace theme_check_test
