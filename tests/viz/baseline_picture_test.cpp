// Pictures as baselines keep them: lighter, and still a gate.

#include "viz/snapshot/baseline_picture.h"

#include <algorithm>
#include <array>

#include "tests/catch.h"
#include "viz/formats/colour_table.h"

namespace baseline_picture_test {
using namespace isect::viz;

namespace {

/// A ground of one colour; on it an edge that is softened and a gradient in all directions of colour.
Picture shaded() {
  Picture picture{128, 128, {}};
  for (int y = 0; y < 128; ++y)
    for (int x = 0; x < 128; ++x) {
      const bool ground = y < 80;
      const int blend = std::clamp(20 * (x - 100 - y), 0, 245);
      const std::array<int, 4> pixel =
          ground ? std::array{255 - blend, 245, 255 - blend / 2, 255} : std::array{2 * x, 2 * y, (x * y) & 255, 255};
      picture.rgba.insert(picture.rgba.end(), pixel.begin(), pixel.end());
    }
  return picture;
}

int farthest(const Picture& a, const Picture& b) {
  int most = 0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) most = std::max(most, std::abs(a.rgba[i] - b.rgba[i]));
  return most;
}

}  // namespace

TEST_CASE("with fewer colours no channel is off by more than the slack, and what covers most stays",
          "[baseline_picture]") {
  const Picture all = shaded();
  CHECK(with_fewer_colours(all, 0).rgba == all.rgba);
  for (const int slack : {8, 30}) {
    const Picture few = with_fewer_colours(all, slack);
    CHECK(farthest(all, few) <= slack);
    CHECK(farthest(all, few) > slack / 2);
    CHECK(std::equal(all.rgba.begin(), all.rgba.begin() + 4, few.rgba.begin()));
    CHECK(with_fewer_colours(few, slack).rgba == few.rgba);
  }
}

TEST_CASE("a kept picture has a table of colours, says by how much they are off, and passes as what it is of",
          "[baseline_picture]") {
  const Picture all = shaded();
  const std::string bytes = baseline_png(all, {{"step", "3"}});
  const BaselinePicture kept = read_baseline_png(bytes);
  CHECK(own_colours(kept.picture));
  CHECK(kept.slack > 10);  // 256 colours are too few for 10
  CHECK(farthest(all, kept.picture) == kept.slack);
  CHECK(compare(kept.picture, all, kept.slack).over_1 == 0);
  CHECK(png_metadata(bytes).at("step") == "3");
  CHECK(baseline_png(all, {{"step", "3"}}) == bytes);

  Picture dot = all;  // five pixels wide: found in spite of the slack
  for (int pixel = 0; pixel < 25; ++pixel) dot.rgba[4 * (128 * (40 + pixel / 5) + 40 + pixel % 5)] = 190;
  CHECK_FALSE(compare(kept.picture, dot, kept.slack).passes());
}

TEST_CASE("a picture kept with all its colours has no slack, one that lost its metadata the usual one",
          "[baseline_picture]") {
  CHECK(read_baseline_png(png(shaded())).slack == 0);
  CHECK(read_baseline_png(png(shaded(), {{"slack", "much"}})).slack == 0);
  const Picture kept = with_fewer_colours(shaded(), 40);
  for (const Metadata& lost : {Metadata(), Metadata{{"slack", "much"}}})
    CHECK(read_baseline_png(png(kept, lost)).slack == 10);
  CHECK_THROWS_AS(read_baseline_png("no picture"), FileError);
}

}  // namespace baseline_picture_test
