#include "viz/compose/raster.h"

#include <numeric>

#include "tests/catch.h"
#include "tests/viz/pixels.h"
#include "viz/compose/compose.h"
#include "viz/formats/files.h"

namespace raster_test {
using namespace isect::viz;

namespace {

/// Twice the signed area of all rings.
int area2(const std::vector<std::vector<Corner>>& rings) {
  int sum = 0;
  for (const std::vector<Corner>& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Corner &a = ring[i], &b = ring[(i + 1) % ring.size()];
      sum += a.x() * b.y() - a.y() * b.x();
    }
  return sum;
}

Scene with(const Raster& raster) { return {{raster}, {}, {}}; }

Camera straight_on() {
  Camera camera;
  camera.azimuth = camera.elevation = 0;
  return camera;
}

}  // namespace

TEST_CASE("equal cells that touch become one ring, holes another", "[raster]") {
  const std::vector<int> cells = {1, 1, 1, 1,  //
                                  1, 0, 0, 1,  //
                                  1, 1, 1, 1};
  const auto ones = outlines(cells, 4, 1);
  REQUIRE(ones.size() == 2);
  CHECK(ones[0].size() == 4);
  CHECK(ones[1].size() == 4);
  CHECK(area2(ones) == 2 * 10);
  CHECK(area2(outlines(cells, 4, 0)) == 2 * 2);
  CHECK(outlines(cells, 4, 7).empty());
}

TEST_CASE("cells that share a corner only stay apart", "[raster]") {
  const std::vector<int> cells = {1, 0,  //
                                  0, 1};
  CHECK(outlines(cells, 2, 1).size() == 2);
  CHECK(outlines(cells, 2, 0).size() == 2);
}

TEST_CASE("the rings of random cells enclose just as many cells, without a corner on a straight line", "[raster]") {
  unsigned state = 20261121;
  for (int round = 0; round < 50; ++round) {
    const int columns = 1 + round % 9, rows = 1 + round / 7;
    std::vector<int> cells;
    for (int i = 0; i < columns * rows; ++i) {
      state = state * 1664525u + 1013904223u;
      cells.push_back(static_cast<int>(state >> 30) % 3);
    }
    for (const int wanted : {0, 1, 2}) {
      const auto rings = outlines(cells, columns, wanted);
      CHECK(area2(rings) == 2 * std::count(cells.begin(), cells.end(), wanted));
      for (const std::vector<Corner>& ring : rings) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
          const Corner a = ring[(i + 1) % ring.size()] - ring[i];
          const Corner b = ring[(i + 2) % ring.size()] - ring[(i + 1) % ring.size()];
          CHECK((a.x() == 0) != (a.y() == 0));
          CHECK((a.x() == 0) != (b.x() == 0));
        }
      }
    }
  }
}

TEST_CASE("every cell of a raster shows its colour, from edge to edge", "[raster]") {
  Raster raster;
  raster.columns = 4;
  raster.corner = {0, 3, 0}, raster.across = {4, 0, 0}, raster.down = {0, -3, 0};
  const std::vector<Role> roles = {Role::hit, Role::miss, Role::highlight};
  for (int i = 0; i < 12; ++i) raster.cells.push_back({roles[static_cast<std::size_t>(i * i + i / 5) % 3]});
  const Scene scene = with(raster);
  const View view(frame(straight_on(), {&scene}, 1.6), 480, 300);
  const Theme style = theme(ThemeName::print, 480, 300);
  const Picture picture = offscreen().render({480, 300, style.background, compose(scene, view, style).shapes});
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      const Colour ink = style.ink(raster.cells[4 * row + column].role);
      for (const Vec2& inside : {Vec2(0.06, 0.06), Vec2(0.5, 0.5), Vec2(0.94, 0.94)}) {
        const Vec2 p = view.project({column + inside.x(), 3 - row - inside.y(), 0}).at;
        const int x = static_cast<int>(p.x()), y = static_cast<int>(p.y());
        INFO("row " << row << ", column " << column);
        CHECK(std::abs(channel(picture, x, y, 0) - 255 * ink.r) < 3);
        CHECK(std::abs(channel(picture, x, y, 1) - 255 * ink.g) < 3);
        CHECK(std::abs(channel(picture, x, y, 2) - 255 * ink.b) < 3);
      }
    }
  }
}

TEST_CASE("a microscope of 4096 cells stays a small file, and no two of its roles look alike in grey", "[raster]") {
  Raster raster;
  raster.columns = 64;
  raster.across = {1, 0, 0}, raster.down = {0, -1, 0};
  for (int i = 0; i < 64 * 64; ++i) {
    const int off = i / 64 - i % 64;
    const bool on = std::abs(off) < 6 && i % 3 == 0, wrong = std::abs(off) < 2 && i % 7 == 0;
    raster.cells.push_back({wrong ? Role::miss : on ? Role::highlight : off < 0 ? Role::first : Role::second});
  }
  const Scene scene = with(raster);
  const View view(frame(straight_on(), {&scene}, 1.6), 480, 300);
  for (const ThemeName name : {ThemeName::print, ThemeName::grey}) {
    const Theme style = theme(name, 480, 300);
    const Composed composed = compose(scene, view, style);
    CHECK(svg({480, 300, style.background, composed.shapes}).size() < 120'000);
    std::vector<const Fill*> fills;
    for (const Shape& shape : composed.shapes)
      if (const Fill* fill = std::get_if<Fill>(&shape)) fills.push_back(fill);
    for (std::size_t i = 1; i < fills.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const double apart = std::abs(fills[i]->colour.r - fills[j]->colour.r) +
                             std::abs(fills[i]->colour.g - fills[j]->colour.g) +
                             std::abs(fills[i]->colour.b - fills[j]->colour.b);
        CHECK((apart > 0.1 || (fills[i]->hatch_gap > 0) != (fills[j]->hatch_gap > 0)));
      }
  }
}

TEST_CASE("a raster of no cells, or of fewer than a row, draws nothing", "[raster]") {
  for (Raster raster : {Raster{}, Raster{.columns = 3, .cells = {{}, {}}}, Raster{.columns = 0, .cells = {{}}}}) {
    const Scene scene = with(raster);
    const Composed composed = compose(scene, View({}, 480, 300), theme(ThemeName::print, 480, 300));
    CHECK(composed.shapes.empty());
  }
}

}  // namespace raster_test
