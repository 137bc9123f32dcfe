#include "viz/compose/halos.h"

#include "tests/catch.h"
#include "viz/text/text.h"

namespace halos_test {
using namespace isect::viz;

namespace {

Fill square(double size, const Colour& colour) {
  return {polyline({{-size, -size}, {size, -size}, {size, size}, {-size, size}}, true), colour, 0, 0, {}};
}
Text word(const Colour& colour) { return {"word", {-20, 5}, 15, colour, 0, false, 0, {}}; }

}  // namespace

TEST_CASE("contrast is measured against what the fills below a text come to", "[halos]") {
  const Colour white = hex(0xFFFFFF), black = hex(0);
  CHECK(contrast_ratio(white, black) == Approx(21));
  CHECK(contrast_ratio(hex(0x777777), white) == Approx(4.48).margin(0.01));
  CHECK(contrast_of({word(black)}, 0, white) == Approx(21));
  CHECK(contrast_of({square(99, black), word(black)}, 1, white) == Approx(1));
  CHECK(contrast_of({square(99, black.with_alpha(0.5)), word(black)}, 1, white) == Approx(5.28).margin(0.05));
  CHECK(contrast_of({word(black), square(99, black)}, 0, white) == Approx(21));  // it lies above
  Fill holed = square(99, black);
  holed.more = {square(50, black).path};
  CHECK(contrast_of({holed, word(black)}, 1, white) == Approx(21));
  const Gradient ball = {{0, 0}, {99, 0}, {0, 99}, {0, 0}, white, black};
  CHECK(contrast_of({ball, word(black)}, 1, white) > 10);
  CHECK(contrast_of({ball, word(white)}, 1, white) == Approx(1).margin(0.3));
  const std::vector<Vec2> everywhere = {{-99, -99}, {299, -99}, {-99, 299}};
  Facets facets = {everywhere, {black}};
  CHECK(contrast_of({facets, word(black)}, 1, white) == Approx(1));
  facets.corners.insert(facets.corners.end(), everywhere.begin(), everywhere.end());
  facets.colours.push_back(white);  // over the first
  CHECK(contrast_of({facets, word(black)}, 1, white) == Approx(21));
  facets.corners = {{500, 500}, {600, 500}, {500, 600}};
  facets.colours = {black};
  CHECK(contrast_of({facets, word(black)}, 1, white) == Approx(21));
}

TEST_CASE("a text gets a halo where it would not stand out, and only there", "[halos]") {
  const Theme screen = theme(ThemeName::screen, 960, 600);
  const Colour brown = screen.ink(Role::second), blue = screen.ink(Role::first);
  std::vector<Shape> shapes = {word(brown), square(99, blue), word(brown), square(99, screen.background), word(brown)};
  add_halos(shapes, screen);
  CHECK(std::get<Text>(shapes[0]).halo == 0);
  CHECK(std::get<Text>(shapes[2]).halo > 0);
  CHECK(std::get<Text>(shapes[4]).halo == 0);
}

TEST_CASE("a text that a line runs through gets a halo, one beside a line none, which would cut into that", "[halos]") {
  const Theme screen = theme(ThemeName::screen, 960, 600);
  const auto halo = [&](const Shape& line, const Shape& text) {
    std::vector<Shape> shapes = {line, text};
    add_halos_over_lines(shapes, screen);
    return std::get<Text>(shapes[1]).halo;
  };
  const Text text = word(screen.ink(Role::second));
  const TextBox box = measure(text);
  const auto upright = [&](double x) {
    return Stroke{polyline({{x, -500}, {x, 500}}), screen.ink(Role::first), 2, {3, 3}, false};
  };
  CHECK(halo(upright((box.left + box.right) / 2), text) == screen.sizes.label_halo);
  CHECK(halo(upright(box.right + 0.5), text) > 0);
  CHECK(halo(upright(box.right + 1.5), text) == 0);
  CHECK(halo(Stroke{polyline({{box.left - 9, -500}, {box.right + 9, -500}, {0, 0}}, true), {}, 1}, text) > 0);
  CHECK(halo(square(99, screen.ink(Role::first)), text) == 0);  // no line
  const Colour pale = hex(0xF4F4F8);
  std::vector<Shape> shapes = {square(99, pale), upright(0), text};
  add_halos_over_lines(shapes, screen);
  CHECK(contrast_ratio(std::get<Text>(shapes[2]).halo_colour, pale) == Approx(1));
  shapes = {square(99, text.colour), upright(0), text};  // it would not be seen on its own colour
  add_halos_over_lines(shapes, screen);
  CHECK(contrast_ratio(std::get<Text>(shapes[2]).halo_colour, screen.background) == Approx(1));
  Text own = text;
  own.halo = 1;
  CHECK(halo(upright(0), own) == 1);
}

}  // namespace halos_test
