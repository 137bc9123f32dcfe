#include "viz/gl/picture_changes.h"

#include <limits>
#include <random>

#include "tests/catch.h"
#include "tests/viz/pixels.h"

namespace picture_changes_test {
using namespace isect::viz;

namespace {

using Random = std::mt19937;

double between(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}
Vec2 place(Random& random) { return {between(random, -20, 220), between(random, -20, 140)}; }
Colour colour(Random& random) {
  const auto one = [&] { return between(random, 0, 1); };
  return {one(), one(), one(), random() % 2 == 0 ? 1 : one()};
}

/// Returns a shape of any kind: some are cut by the picture's edge, and most lie over others.
Shape any_shape(Random& random) {
  const Vec2 at = place(random);
  const double r = between(random, 1, 25);
  switch (random() % 7) {
    case 0:
      return Fill{circle(at, r), colour(random)};
    case 1:
      return Fill{circle(at, r), colour(random), 4, 1, colour(random), {circle(at, r / 2)}};
    case 2:
      return Stroke{polyline({at, place(random), place(random)}), colour(random), between(random, 0.1, 6)};
    case 3:
      return Stroke{circle(at, r), colour(random), 2, {4, 3}, random() % 2 == 0};
    case 4:
      return Gradient{at, {r, 0}, {0, r / 2}, at + Vec2(r / 3, 0), colour(random), colour(random)};
    case 5: {
      Text text{"ab_1", at, 12, colour(random)};
      text.halo = 2, text.halo_colour = {1, 1, 1};
      return text;
    }
    default:
      return Facets{{at, at + Vec2(r, 0), at + Vec2(0, r)}, {colour(random)}};
  }
}

Drawing changed_a_little(Drawing drawing, Random& random) {
  std::vector<Shape>& shapes = drawing.shapes;
  const auto any = [&] { return static_cast<std::ptrdiff_t>(random() % shapes.size()); };
  for (int i = 0; i < 3; ++i) switch (random() % 5) {
      case 0:
        shapes.insert(shapes.begin() + any(), any_shape(random));
        break;
      case 1:
        shapes.erase(shapes.begin() + any());
        break;
      case 2:
        move(shapes[any()], {between(random, -3, 3), between(random, -3, 3)});
        break;
      case 3:
        shapes.push_back(shapes[any()]);
        break;  // there twice
      default:
        std::swap(shapes[any()], shapes[any()]);
    }
  return drawing;
}

std::vector<DrawnShape> drawn(const std::vector<Shape>& shapes) {
  return drawn_shapes(drawing_of(shapes), [](const Text& text) { return Box{text.at, text.at}; });
}

const Fill red{circle({20, 20}, 5), {1, 0, 0}}, green{circle({60, 20}, 5), {0, 1, 0}},
    blue{circle({100, 20}, 5), {0, 0, 1}};

}  // namespace

TEST_CASE("a picture drawn over the last one is that drawn on an empty sheet", "[picture_changes]") {
  Renderer& renderer = offscreen().renderer();
  Random random(7);
  for (const bool sketched : {false, true}) {
    Drawing drawing = drawing_of({});
    for (int i = 0; i < 40; ++i) drawing.shapes.push_back(any_shape(random));
    for (int i = 0; i < 150; ++i) {
      CAPTURE(sketched, i);
      const double scale = i / 50 + 1;  // from time to time the picture is another
      const auto draw = [&](const Drawing& d) { sketched ? renderer.sketch(d, scale) : renderer.draw(d, scale); };
      draw(drawing);
      drawing = changed_a_little(drawing, random);
      draw(drawing);
      const Picture over = renderer.read();
      draw(drawing_of({}, 30, 30));  // of another size: nothing is left of the last one
      draw(drawing);
      const Picture anew = renderer.read();
      REQUIRE(over.rgba == anew.rgba);
    }
  }
}

TEST_CASE("a picture changes where a shape came, went or moved, and nowhere else", "[picture_changes]") {
  const auto before = drawn({red, green, blue});
  const auto none = changed(before, before);
  REQUIRE(none);
  CHECK(none->low == none->high);

  const auto gone = changed(before, drawn({red, blue}));
  REQUIRE(gone);
  CHECK(gone->low.x() >= 54);
  CHECK(gone->high.x() <= 66);
  CHECK(meet(*gone, {{60, 20}, {60, 20}}));

  Shape moved = green;
  move(moved, {0, 40});
  const auto both = changed(before, drawn({red, moved, blue}));
  REQUIRE(both);
  CHECK(meet(*both, {{60, 20}, {60, 20}}));
  CHECK(meet(*both, {{60, 60}, {60, 60}}));
  CHECK_FALSE(meet(*both, {{20, 20}, {20, 20}}));

  Fill darker = green;
  darker.colour.g = 0.5;
  REQUIRE(changed(before, drawn({red, darker, blue})));
  CHECK(meet(*changed(before, drawn({red, darker, blue})), {{60, 20}, {60, 20}}));
}

TEST_CASE("where the order or a place is not known, all changes", "[picture_changes]") {
  CHECK_FALSE(changed(drawn({red, green, blue}), drawn({green, red, blue})));
  Fill nowhere = red;
  nowhere.path.start.x() = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(changed(drawn({green}), drawn({green, nowhere})));
}

TEST_CASE("only the pixels around a change are drawn again, within the part that is shown", "[picture_changes]") {
  const auto shown = [](const std::vector<Shape>& shapes, const PixelBox& part = {0, 0, 400, 240}) {
    return LastPicture{part, 2, white, drawn(shapes)};
  };
  const LastPicture now = shown({red, green});
  const PixelBox all = now.part;
  CHECK(to_draw(now, now) == PixelBox{});
  CHECK(to_draw(shown({red}), now) == PixelBox{108, 28, 24, 24});  // two pixels more on each side
  CHECK(to_draw(shown({red}, {120, 0, 100, 40}), shown({red, green}, {120, 0, 100, 40})) == PixelBox{120, 28, 12, 12});
  const PixelBox elsewhere = to_draw(shown({red}, {200, 0, 100, 40}), shown({red, green}, {200, 0, 100, 40}));
  CHECK(elsewhere.width * elsewhere.height == 0);

  CHECK(to_draw({}, now) == all);
  CHECK(to_draw(shown({green, red}), now) == all);
  LastPicture other = now;
  other.background = black;
  CHECK(to_draw(other, now) == all);
  other = now;
  other.scale = 1;
  CHECK(to_draw(other, now) == all);
  CHECK(to_draw(shown({red, green}, {0, 0, 200, 240}), now) == all);
}

}  // namespace picture_changes_test
