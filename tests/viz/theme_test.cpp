#include "viz/theme.h"

#include <Eigen/Dense>
#include <cmath>

#include "tests/catch.h"
#include "tests/viz/drawn.h"
#include "viz/compose/marks.h"
#include "viz/compose/own_colours.h"
#include "viz/lesson.h"

namespace theme_test {
using namespace isect::viz;

namespace {

constexpr ThemeName all_themes[] = {ThemeName::screen, ThemeName::print, ThemeName::grey, ThemeName::dark};
constexpr ThemeName coloured_themes[] = {ThemeName::screen, ThemeName::print, ThemeName::dark};
constexpr Role main_roles[] = {Role::first, Role::second, Role::hit, Role::miss};
constexpr Role text_roles[] = {Role::first,        Role::second, Role::hit,  Role::miss,
                               Role::construction, Role::text,   Role::muted};

Vec3 linear(const Colour& c) {
  const auto channel = [](double s) { return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4); };
  return {channel(c.r), channel(c.g), channel(c.b)};
}

/// Source: WCAG 2.1, "contrast ratio".
double contrast(const Colour& a, const Colour& b) {
  const Vec3 weights(0.2126, 0.7152, 0.0722);
  const double x = linear(a).dot(weights), y = linear(b).dot(weights);
  return (std::max(x, y) + 0.05) / (std::min(x, y) + 0.05);
}

/// `ink` at `alpha` over `ground`, mixed as screens do.
Colour tint(const Colour& ink, double alpha, const Colour& ground) {
  const auto mix = [alpha](double a, double b) { return alpha * a + (1 - alpha) * b; };
  return {mix(ink.r, ground.r), mix(ink.g, ground.g), mix(ink.b, ground.b), 1};
}

/// CIE 1976 L*a*b* under D65 of linear sRGB, clipped to what a screen can show.
Vec3 lab(const Vec3& rgb) {
  Eigen::Matrix3d to_xyz;
  to_xyz << 0.4124564, 0.3575761, 0.1804375, 0.2126729, 0.7151522, 0.0721750, 0.0193339, 0.1191920, 0.9503041;
  const Vec3 white(0.95047, 1, 1.08883);
  const Vec3 xyz = to_xyz * rgb.cwiseMax(0).cwiseMin(1);
  const auto f = [](double t) { return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116; };
  const Vec3 v(f(xyz.x() / white.x()), f(xyz.y() / white.y()), f(xyz.z() / white.z()));
  return {116 * v.y() - 16, 500 * (v.x() - v.y()), 200 * (v.y() - v.z())};
}

/// Full severity. Source: G. Machado, M. Oliveira, L. Fernandes, "A physiologically-based model for
/// simulation of color vision deficiency", IEEE TVCG 15 (2009), table 1.
enum class Vision { normal, protan, deutan, tritan };
Vec3 seen(Vision vision, const Vec3& rgb) {
  Eigen::Matrix3d m = Eigen::Matrix3d::Identity();
  if (vision == Vision::protan)
    m << 0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116, 1.051998;
  if (vision == Vision::deutan)
    m << 0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940, 0.968881;
  if (vision == Vision::tritan)
    m << 1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367, 0.303900;
  return m * rgb;
}

double distance(Vision vision, const Colour& a, const Colour& b) {
  return (lab(seen(vision, linear(a))) - lab(seen(vision, linear(b)))).norm();
}

double least_distance(const Theme& theme) {
  double least = 1e9;
  for (const Vision vision : {Vision::normal, Vision::protan, Vision::deutan, Vision::tritan})
    for (const Role a : main_roles)
      for (const Role b : main_roles)
        if (a < b) least = std::min(least, distance(vision, theme.ink(a), theme.ink(b)));
  return least;
}

}  // namespace

TEST_CASE("the yardsticks measure known colours", "[theme]") {
  CHECK(contrast(hex(0x000000), hex(0xFFFFFF)) == Approx(21));
  CHECK(contrast(hex(0x777777), hex(0xFFFFFF)) == Approx(4.48).margin(0.01));
  CHECK(lab(linear(hex(0xFFFFFF))).x() == Approx(100).margin(0.01));
  CHECK((lab(linear(hex(0xFF0000))) - Vec3(53.24, 80.09, 67.20)).norm() < 0.05);
  // Red and green at full severity: far apart for most eyes, near for deutans.
  CHECK(distance(Vision::deutan, hex(0xB04040), hex(0x7A6A20)) <
        0.5 * distance(Vision::normal, hex(0xB04040), hex(0x7A6A20)));
}

TEST_CASE("every role that colours text can be read on background, panel and its own tint", "[theme]") {
  for (const ThemeName name : all_themes) {
    const Theme t = window_theme(name);
    for (const Role role : text_roles) {
      INFO(name_of(name) << " role " << static_cast<int>(role));
      CHECK(contrast(t.ink(role), t.background) >= 4.6);
      CHECK(contrast(t.ink(role), t.panel) >= 4.6);
      const bool fills = role != Role::construction;  // dashes and labels only: no area has its tint
      if (fills) CHECK(contrast(t.ink(role), tint(t.ink(role), 0.16, t.background)) >= 4.5);
    }
  }
}

TEST_CASE("plain text has strong contrast, also near-black on highlight", "[theme]") {
  for (const ThemeName name : all_themes) {
    const Theme t = window_theme(name);
    INFO(name_of(name));
    CHECK(contrast(t.ink(Role::text), t.background) >= 13.8);
    CHECK(contrast(t.ink(Role::text), t.panel) >= 13.8);
    const Colour near_black = name == ThemeName::dark ? t.background : t.ink(Role::text);
    CHECK(contrast(near_black, t.ink(Role::highlight)) >= 12.6);
  }
}

TEST_CASE("the four main roles stay apart for colour-blind readers", "[theme]") {
  CHECK(std::round(least_distance(window_theme(ThemeName::print))) >= 18);
  CHECK(std::round(least_distance(window_theme(ThemeName::screen))) >= 18);
  CHECK(std::round(least_distance(window_theme(ThemeName::dark))) >= 14);
}

TEST_CASE("grey has no hue, and a hatch where a coloured theme has a second colour", "[theme]") {
  const Theme grey = window_theme(ThemeName::grey);
  for (const Colour& c : grey.inks) CHECK((c.r == c.g && c.g == c.b));
  CHECK(grey.hatch_second);
  CHECK(contrast(grey.ink(Role::first), grey.ink(Role::second)) > 2.5);
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
        for (const Fill& f : all<Fill>(shapes)) best = std::max(best, contrast(f.colour, style.background));
        for (const Stroke& s : all<Stroke>(shapes)) best = std::max(best, contrast(s.colour, style.background));
        INFO(name_of(name) << " " << static_cast<int>(kind) << " " << name_of(role));
        CHECK(best >= 3);  // Source: WCAG 2.1, "non-text contrast"
      }
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
      CHECK(contrast(t.ink(own_role(i)), t.background) >= 4.5);
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
