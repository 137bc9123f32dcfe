#include "viz/compose/crop.h"

#include "tests/catch.h"
#include "viz/formats/files.h"

namespace crop_test {
using namespace isect::viz;

namespace {

constexpr Colour blue = {0, 0, 1, 1};

}  // namespace

TEST_CASE("a cropped drawing is its ink and a margin, within the frame", "[crop]") {
  const Drawing d = {200, 100, {1, 1, 1, 1}, {Stroke{polyline({{50, 40}, {90, 60}}), blue, 2}}};
  const Drawing part = cropped(d, 3);
  CHECK(part.width == Approx(48));  // 40 long, 1 of the pen and 3 of margin at both ends
  CHECK(part.height == Approx(28));
  CHECK((std::get<Stroke>(part.shapes[0]).path.start - Vec2(4, 4)).norm() < 1e-12);

  const Drawing over = {200, 100, blue, {Fill{circle({0, 50}, 30), blue}}};  // half of it lies outside
  CHECK(cropped(over, 5).width == Approx(35).epsilon(1e-3));
  CHECK(cropped({200, 100, blue, {}}, 5).width == 200);
  const Drawing facet = {200, 100, {1, 1, 1, 1}, {Facets{{{50, 40}, {90, 40}, {50, 60}}, {blue}}}};
  CHECK(cropped(facet, 3).width == Approx(46));
  CHECK(cropped(facet, 3).height == Approx(26));
}

TEST_CASE("a picture without a ground is found from how it looks on black and on white", "[crop]") {
  // Half-covered blue, nothing, and full white.
  const Picture on_black = {3, 1, {0, 0, 128, 255, 0, 0, 0, 255, 255, 255, 255, 255}};
  const Picture on_white = {3, 1, {127, 127, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255}};
  const Picture p = see_through(on_black, on_white);
  CHECK(p.rgba == std::vector<std::uint8_t>{0, 0, 255, 128, 0, 0, 0, 0, 255, 255, 255, 255});
}

TEST_CASE("a PNG has the pixels an inch that it is told, and tells title and picture", "[crop]") {
  const Picture picture = {1, 1, {1, 2, 3, 255}};
  const auto density = [&](const Imprint& imprint) {
    const std::string bytes = png(picture, {}, imprint);
    const std::size_t at = bytes.find("pHYs");
    REQUIRE(at != bytes.npos);
    return (static_cast<unsigned char>(bytes[at + 6]) << 8) + static_cast<unsigned char>(bytes[at + 7]);
  };
  Imprint imprint;
  CHECK(density(imprint) == 3780);  // 96 an inch
  imprint.dpi = 300;
  CHECK(density(imprint) == 11811);
  imprint.title = "Ray";
  imprint.alt = "A ray.";
  const std::string bytes = png(picture, {{"lesson", "x"}}, imprint);
  CHECK(bytes.find(std::string("iTXtTitle\0\0\0\0\0Ray", 17)) != bytes.npos);
  CHECK(bytes.find(std::string("iTXtDescription\0\0\0\0\0A ray.", 26)) != bytes.npos);
  CHECK(png_metadata(bytes) == Metadata{{"lesson", "x"}});
}

}  // namespace crop_test
