#include "viz/gl/renderer.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "tests/catch.h"
#include "tests/viz/pixels.h"
#include "viz/gl/triangle_batch.h"

namespace renderer_test {
using namespace isect::viz;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

Picture window_frame(const Drawing& drawing, double scale = 1) {
  offscreen().renderer().draw(drawing, scale);
  return offscreen().renderer().read();
}

Picture render(std::vector<Shape> shapes) { return offscreen().render(drawing_of(std::move(shapes))); }

Picture sketch(std::vector<Shape> shapes, double scale = 1) {
  offscreen().renderer().sketch(drawing_of(std::move(shapes)), scale);
  return offscreen().renderer().read();
}

/// The colour of a pixel with 0..1 channels.
Colour colour_at(const Picture& p, int x, int y) {
  return {channel(p, x, y, 0) / 255.0, channel(p, x, y, 1) / 255.0, channel(p, x, y, 2) / 255.0};
}

}  // namespace

TEST_CASE("a disc has its area, in the window and off screen", "[renderer]") {
  const Fill disc{circle({100.3, 60.7}, 50), black};
  CHECK(ink(render({disc})) == Approx(pi * 50 * 50).epsilon(0.001));
  CHECK(ink(window_frame(drawing_of({disc}))) == Approx(pi * 50 * 50).epsilon(0.003));
  CHECK(ink(window_frame(drawing_of({disc}), 3)) == Approx(9 * pi * 50 * 50).epsilon(0.001));
}

TEST_CASE("a straight line has its width at every slope", "[renderer]") {
  for (const double width : {1.0, 2.5, 7.0})
    for (const Vec2& to : {Vec2(180, 60), Vec2(150, 10), Vec2(100, 110), Vec2(60, 115)}) {
      const Vec2 from(20.3, 20.6);
      const Picture p = render({Stroke{polyline({from, to}), black, width, {0, 0}, false}});
      CHECK(ink(p) / (to - from).norm() == Approx(width).epsilon(0.02));
    }
}

TEST_CASE("a line thinner than a pixel keeps its ink and has no gaps", "[renderer]") {
  const Stroke hairline{polyline({{10, 31.7}, {190, 47.3}}), black, 0.3, {0, 0}, false};
  for (const Picture& p : {render({hairline}), window_frame(drawing_of({hairline}))}) {
    CHECK(ink(p) == Approx(0.3 * std::hypot(180, 15.6)).epsilon(0.05));
    for (int x = 12; x < 188; ++x) {
      double column = 0;
      for (int y = 0; y < p.height; ++y) column += ink(p, x, y);
      CHECK(column == Approx(0.3).margin(0.15));
    }
  }
}

TEST_CASE("dashes are as long as asked", "[renderer]") {
  const Picture p = render({Stroke{polyline({{20, 60}, {180, 60}}), black, 4, {10, 6}, false}});
  for (int x = 0; x < p.width; ++x) {
    const bool on = x >= 20 && x < 180 && (x - 20) % 16 < 10;
    CHECK(ink(p, x, 60) == (on ? 1 : 0));
  }
}

TEST_CASE("a round cap lengthens a line by half its width", "[renderer]") {
  const TextBox round = ink_box(render({Stroke{polyline({{50, 60}, {150, 60}}), black, 20}}));
  CHECK(round.left == 40);
  CHECK(round.right == 160);
  const TextBox square = ink_box(render({Stroke{polyline({{50, 60}, {150, 60}}), black, 20, {0, 0}, false}}));
  CHECK(square.left == 50);
  CHECK(square.right == 150);
}

TEST_CASE("a translucent stroke that crosses itself is one sheet of ink", "[renderer]") {
  const Path loop = polyline({{20, 60}, {180, 60}, {180, 100}, {100, 100}, {100, 10}});
  const Picture p = render({Stroke{loop, black.with_alpha(0.4), 20}});
  CHECK(ink(p, 100, 60) == Approx(0.4).margin(0.003));  // where it crosses itself
  CHECK(ink(p, 50, 60) == ink(p, 100, 60));
  CHECK(ink(p, 179, 61) == ink(p, 100, 60));  // in a joint
  for (int y = 0; y < p.height; ++y)
    for (int x = 0; x < p.width; ++x) CHECK(ink(p, x, y) <= ink(p, 100, 60));
}

TEST_CASE("a translucent straight stroke is one sheet of ink, and many of them are drawn in one call", "[renderer]") {
  const auto darkest = [](bool round_cap, const std::array<double, 2>& dash) {
    Stroke stroke{polyline({{30, 20}, {170, 93}}), black.with_alpha(0.4), 20};
    stroke.round_cap = round_cap, stroke.dash = dash;
    const Picture p = render({stroke});
    double most = 0;
    for (int y = 0; y < p.height; ++y)
      for (int x = 0; x < p.width; ++x) most = std::max(most, ink(p, x, y));
    return most;
  };
  CHECK(darkest(false, {0, 0}) == Approx(0.4).margin(0.003));
  CHECK(darkest(true, {0, 0}) == Approx(0.4).margin(0.003));
  CHECK(darkest(false, {15, 5}) == Approx(0.4).margin(0.003));
  CHECK(darkest(true, {15, 5}) == Approx(0.4).margin(0.003));  // each cap reaches into the next dash

  TriangleBatch grid(1);
  for (int i = 0; i < 50; ++i) grid.add(Stroke{polyline({{2.0 * i, 0}, {2.0 * i, 90}}), black, 0.5});
  CHECK(grid.calls().size() == 1);
}

TEST_CASE("two translucent strokes blend where they cross", "[renderer]") {
  const Colour half = black.with_alpha(0.5);
  const Picture p =
      render({Stroke{polyline({{20, 60}, {180, 60}}), half, 20}, Stroke{polyline({{100, 10}, {100, 110}}), half, 20}});
  CHECK(ink(p, 40, 60) == Approx(0.5).margin(0.004));
  CHECK(ink(p, 100, 60) == Approx(0.75).margin(0.008));
}

TEST_CASE("a fill covers what its outline winds round, once", "[renderer]") {
  const Colour third = black.with_alpha(0.3);
  SECTION("a concave outline leaves its notch empty") {
    const Picture p = render({Fill{polyline({{20, 20}, {180, 60}, {20, 100}, {80, 60}}, true), third}});
    CHECK(ink(p, 50, 60) == 0);
    CHECK(ink(p, 120, 60) == Approx(0.3).margin(0.003));
  }
  SECTION("a five-pointed star's middle is as light as its points") {
    std::vector<Vec2> points;
    for (int i = 0; i < 5; ++i) {
      const double at = 4 * pi * i / 5;
      points.push_back({100 + 55 * std::sin(at), 60 - 55 * std::cos(at)});
    }
    const Picture p = render({Fill{polyline(points, true), third}});
    CHECK(ink(p, 100, 60) == Approx(0.3).margin(0.003));
    CHECK(ink(p, 100, 20) == ink(p, 100, 60));
  }
  SECTION("an inner outline wound the other way is a hole") {
    const Picture p = render({Fill{
        polyline(
            {{20, 10}, {180, 10}, {180, 110}, {20, 110}, {20, 10}, {60, 40}, {60, 80}, {140, 80}, {140, 40}, {60, 40}},
            true),
        third}});
    CHECK(ink(p, 100, 60) == 0);
    CHECK(ink(p, 40, 90) == Approx(0.3).margin(0.003));
  }
  SECTION("an inner outline wound the same way is not") {
    const Picture p = render({Fill{
        polyline(
            {{20, 10}, {180, 10}, {180, 110}, {20, 110}, {20, 10}, {60, 40}, {140, 40}, {140, 80}, {60, 80}, {60, 40}},
            true),
        third}});
    CHECK(ink(p, 100, 60) == Approx(0.3).margin(0.003));
  }
}

TEST_CASE("a gradient runs from its focus to its rim by the two-circle rule", "[renderer]") {
  const Vec2 center(100, 60), major(64, 24), minor(-15, 40), focus = center + 0.3 * major - 0.5 * minor;
  const Picture p = render({Gradient{center, major, minor, focus, black, {1, 0.5, 0, 1}}});
  CHECK(ink(p, static_cast<int>(focus.x()), static_cast<int>(focus.y())) > 0.95);
  for (int i = 0; i < 16; ++i) {
    const double angle = 2 * pi * i / 16;
    for (const double t : {0.2, 0.5, 0.8, 0.92}) {
      // The circle of radius t round (1 - t) focus, as an ellipse in the drawing, has colour t.
      const Vec2 at = t * (center + std::cos(angle) * major + std::sin(angle) * minor) + (1 - t) * focus;
      const Colour seen = colour_at(p, static_cast<int>(at.x()), static_cast<int>(at.y()));
      CHECK(seen.r == Approx(t).margin(0.03));
      CHECK(seen.g == Approx(t / 2).margin(0.02));
      CHECK(seen.b == 0);
    }
  }
  CHECK(ink(p) > 0);
  CHECK(ink(p, 5, 5) == 0);
}

TEST_CASE("a gradient's alpha and colour both run", "[renderer]") {
  const Picture p = render({Gradient{{100, 60}, {50, 0}, {0, 50}, {100, 60}, black.with_alpha(0), black}});
  for (const int r : {5, 20, 35, 48}) CHECK(ink(p, 100 + r, 60) == Approx((r + 0.5) / 50).margin(0.01));
}

TEST_CASE("a gradient without area or with its focus outside does no harm", "[renderer]") {
  CHECK(ink(render({Gradient{{100, 60}, {50, 0}, {0, 0}, {100, 60}, black, black}})) == 0);
  const Picture p = render({Gradient{{100, 60}, {50, 0}, {0, 50}, {300, 60}, black, black}});
  CHECK(ink(p) == Approx(pi * 50 * 50).epsilon(0.002));
}

TEST_CASE("a hatch is drawn inside its outline only, on the lines x + y = k gap sqrt 2", "[renderer]") {
  const double gap = 20 / std::numbers::sqrt2;  // every 20 px along a row
  const Path outline = polyline({{40, 20}, {160, 20}, {100, 60}, {160, 100}, {40, 100}}, true);
  const Picture p = render({Fill{outline, white, gap, 2, black}});
  for (int x = 41; x < 99; ++x) {
    const double off = std::abs(std::remainder(x + 0.5 + 60.5, 20)) / std::numbers::sqrt2;
    if (off < 0.2) CHECK(ink(p, x, 60) > 0.95);
    if (off > 1.8) CHECK(ink(p, x, 60) == 0);
  }
  for (int x = 104; x < 200; ++x) CHECK(ink(p, x, 60) == 0);  // in the notch
  for (int x = 0; x < 200; ++x) CHECK(ink(p, x, 10) + ink(p, x, 110) == 0);
}

TEST_CASE("text stands where measure() says", "[renderer]") {
  for (const double align : {0.0, 0.5, 1.0})
    for (const Vec2& at : {Vec2(100, 60), Vec2(97.4, 71.3)}) {
      const Text text{"*q*^2 = *H*", at, 24, black, align};
      const TextBox said = measure(text);
      for (const Picture& p : {render({text}), window_frame(drawing_of({text}))}) {
        const TextBox seen = ink_box(p);
        CHECK(seen.left == Approx(said.left).margin(1.5));
        CHECK(seen.top == Approx(said.top).margin(1.5));
        CHECK(seen.right == Approx(said.right).margin(1.5));
        CHECK(seen.bottom == Approx(said.bottom).margin(1.5));
      }
    }
}

TEST_CASE("a text's pixels do not depend on where it stood before", "[renderer]") {
  const auto text_at = [](double x, double y) { return drawing_of({Text{"**c** ∈ *A*", {x, y}, 20, black, 0.5}}); };
  Offscreen first;
  const Picture fresh = first.render(text_at(101.4, 60.2));
  Offscreen second;
  second.render(text_at(88.8, 51.9));
  CHECK(difference(second.render(text_at(101.4, 60.2)), fresh) == 0);
}

TEST_CASE("straight alpha: text on its own colour leaves no rim", "[renderer]") {
  const Colour blue{0.1, 0.4, 0.8, 1};
  Drawing d{200, 120, blue, {Text{"**O**", {100, 70}, 60, blue, 0.5, true, 6, blue}}};
  const Picture p = offscreen().render(d);
  d.shapes.clear();
  CHECK(difference(p, offscreen().render(d)) <= 1);
}

TEST_CASE("texts beyond the memory bound are forgotten and come back the same", "[renderer]") {
  const Drawing kept = drawing_of({Text{"kept", {100, 60}, 24, black, 0.5}});
  const Picture before = window_frame(kept);
  for (int i = 0; i < 40; ++i)  // each about 900 x 300 pixels: 11 million in all, the bound is 8
    window_frame(drawing_of({Text{"WW" + std::to_string(i), {0, 100}, 300, black}}));
  CHECK(difference(window_frame(kept), before) == 0);
}

TEST_CASE("later shapes cover earlier ones", "[renderer]") {
  const Path box = polyline({{50, 30}, {150, 30}, {150, 90}, {50, 90}}, true);
  const Text glyph{"█", {100, 80}, 60, black, 0.5};
  CHECK(ink(render({Fill{box, black}, Fill{box, white}})) == 0);
  CHECK(ink(render({glyph, Fill{polyline({{0, 0}, {200, 0}, {200, 120}, {0, 120}}, true), white}})) == 0);
  CHECK(ink(render({Fill{box, black}, Text{"█", {100, 80}, 60, white, 0.5}})) < ink(render({Fill{box, black}})));
}

TEST_CASE("facets leave no seam between neighbours, and a later one covers an earlier one", "[renderer]") {
  Facets fan;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> far(50, 55), near(-3, 3);
  const int count = 37;
  std::vector<Vec2> rim;
  for (int i = 0; i < count; ++i)
    rim.push_back(Vec2(100, 60) + far(random) * Vec2(std::cos(2 * pi * i / count), std::sin(2 * pi * i / count)));
  const Vec2 middle(100.3 + near(random), 60.7 + near(random));
  for (int i = 0; i < count; ++i) {
    for (const Vec2& p : {middle, rim[i], rim[(i + 1) % count]}) fan.corners.push_back(p);
    fan.colours.push_back(black);
  }
  for (const Picture& p : {render({fan}), window_frame(drawing_of({fan})), sketch({fan})})
    for (int y = 0; y < p.height; ++y)
      for (int x = 0; x < p.width; ++x)
        if (std::hypot(x - 100, y - 60) < 48) REQUIRE(ink(p, x, y) == 1);
  CHECK(ink(render({fan})) == Approx(ink(render({Fill{polyline(rim, true), black}}))).epsilon(1e-3));

  Facets twice = {{{0, 0}, {200, 0}, {0, 120}, {0, 0}, {200, 0}, {0, 120}}, {black, white}};
  CHECK(ink(render({twice})) == 0);
  CHECK(ink(sketch({twice})) == 0);
  std::swap(twice.colours[0], twice.colours[1]);
  CHECK(ink(render({twice})) == Approx(100 * 120).epsilon(1e-3));
  CHECK(ink(render({twice, Fill{polyline({{0, 0}, {200, 0}, {200, 120}, {0, 120}}, true), white.with_alpha(0.5)}})) ==
        Approx(50 * 120).epsilon(0.01));  // blending goes on after them
}

TEST_CASE("a sketch has a facet's pixels where their middles lie in it, at any scale and beyond the edge",
          "[renderer]") {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> x(-60, 260), y(-60, 180);
  for (int i = 0; i < 60; ++i) {
    const Facets facet = {{{x(random), y(random)}, {x(random), y(random)}, {x(random), y(random)}}, {black}};
    const double scale = i % 2 == 0 ? 1 : 1.7;
    const Picture sketched = sketch({facet}, scale);
    for (int row = 0; row < sketched.height; ++row)
      for (int column = 0; column < sketched.width; ++column) {
        const std::vector<Vec2>& p = facet.corners;
        const Vec2 middle = Vec2(column + 0.5, row + 0.5) / scale;
        // How far on the inner side of the nearest edge, twice: in either orientation.
        double left = 1e9, right = 1e9;
        for (int k = 0; k < 3; ++k) {
          const Vec2 edge = p[(k + 1) % 3] - p[k], to = middle - p[k];
          const double side = (edge.x() * to.y() - edge.y() * to.x()) / edge.norm();
          left = std::min(left, side), right = std::min(right, -side);
        }
        const double inside = std::max(left, right);
        if (std::abs(inside) < 1e-6) continue;
        INFO(i << ": " << column << ", " << row);
        REQUIRE((ink(sketched, column, row) == 1) == (inside > 0));
      }
  }
  const double inf = std::numeric_limits<double>::infinity();
  CHECK(ink(sketch({Facets{{{0, 0}, {inf, 0}, {0, 50}}, {black}}})) == 0);
  CHECK(ink(sketch({Facets{{{-90, -90}, {-10, -90}, {-90, -10}}, {black}}})) == 0);
}

TEST_CASE("a sketch is jagged, and no other drawing after it", "[renderer]") {
  const Facets facet = {{{20, 10}, {180, 15}, {25, 110}}, {black}};
  const Stroke line = {polyline({{190, 5}, {100, 115}}), black, 1.5};
  const auto greys = [](const Picture& p) {
    int count = 0;
    for (int y = 0; y < p.height; ++y)
      for (int x = 0; x < p.width; ++x) count += ink(p, x, y) > 0.01 && ink(p, x, y) < 0.99;
    return count;
  };
  for (const std::vector<Shape>& shapes : {std::vector<Shape>{facet}, {line}, {facet, line}}) {
    const Picture before = render(shapes), sketched = sketch(shapes), after = render(shapes);
    CHECK(greys(sketched) == 0);
    CHECK(greys(after) > 50);
    CHECK(difference(before, after) == 0);
    CHECK(ink(sketched) == Approx(ink(after)).epsilon(0.05));
  }
}

TEST_CASE("one frame leaves no trace in the next", "[renderer]") {
  const Picture before = window_frame(one_of_everything());
  window_frame(drawing_of({Stroke{polyline({{0, 0}, {300, 200}, {300, 0}, {0, 200}}), black.with_alpha(0.5), 60},
                           Fill{polyline({{0, 0}, {300, 200}, {300, 0}, {0, 200}}, true), black, 8, 2, white}}));
  CHECK(difference(window_frame(one_of_everything()), before) == 0);
}

TEST_CASE("a part of a picture is that part of the whole", "[renderer]") {
  const Drawing drawing = one_of_everything();
  const Picture whole = window_frame(drawing, 2);
  Renderer& renderer = offscreen().renderer();
  const PixelBox part{133, 57, 301, 202};
  renderer.draw(drawing, 2, part);
  const Picture seen = renderer.read();
  REQUIRE(seen.width == part.width);
  REQUIRE(seen.height == part.height);
  int most = 0;
  for (int y = 0; y < part.height; ++y)
    for (int x = 0; x < part.width; ++x)
      for (int c = 0; c < 3; ++c)
        most = std::max(most, std::abs(channel(seen, x, y, c) - channel(whole, part.left + x, part.top + y, c)));
  CHECK(most <= 64);  // one of four samples: the same geometry, rounded for another corner
}

TEST_CASE("shapes that are no numbers are left out and the others drawn", "[renderer]") {
  const double infinity = std::numeric_limits<double>::infinity();
  const Fill box{polyline({{50, 30}, {150, 30}, {150, 90}, {50, 90}}, true), black};
  const Picture p = render(
      {Fill{polyline({{not_a_number, 0}, {1, 1}, {0, 1}}, true), black},
       Stroke{polyline({{0, 0}, {infinity, 1}}), black, 2}, Stroke{polyline({{0, 0}, {10, 1}}), black, not_a_number},
       Facets{{{0, 0}, {not_a_number, 9}, {9, 9}}, {black}}, Stroke{Path{{5, 5}, {}, false}, black, 3},
       Gradient{{not_a_number, 0}, {1, 0}, {0, 1}, {0, 0}, black, black}, Text{"x", {not_a_number, 10}, 20, black},
       Text{"", {10, 10}, 20, black}, box});
  CHECK(ink(p) == Approx(100 * 60).epsilon(1e-6));
}

TEST_CASE("a drawing's size is rounded up to whole pixels", "[renderer]") {
  CHECK(pixels({226.77, 142, white, {}}, 1).width == 227);
  CHECK(pixels({226.77, 142, white, {}}, 2).width == 454);
  CHECK(pixels({0.1 + 0.2, 1, white, {}}, 10).width == 3);
  CHECK(offscreen().render(drawing_of({}, 226.77, 141.2)).height == 142);
}

TEST_CASE("a size no picture can have is refused and does not spoil the next", "[renderer]") {
  for (const double width : {0.0, -5.0, not_a_number, 1e12}) {
    CHECK_THROWS_AS(offscreen().render(drawing_of({}, width, 100)), std::runtime_error);
    CHECK_THROWS_AS(offscreen().renderer().draw(drawing_of({}, width, 100)), std::runtime_error);
  }
  CHECK_THROWS_WITH(offscreen().renderer().draw(drawing_of({}, 100'000, 10)), isect::test::Contains("100000 x 10"));
  CHECK(ink(render({Fill{circle({100, 60}, 10), black}})) == Approx(pi * 100).epsilon(0.01));
}

TEST_CASE("a picture is opaque", "[renderer]") {
  const Picture p = window_frame(one_of_everything());
  for (std::size_t i = 3; i < p.rgba.size(); i += 4) REQUIRE(p.rgba[i] == 255);
}

}  // namespace renderer_test
