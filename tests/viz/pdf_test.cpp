#include <algorithm>
#include <cmath>

#include "tests/catch.h"
#include "viz/formats/files.h"

namespace pdf_test {
using namespace isect::viz;
using isect::test::Contains;

namespace {

constexpr Colour blue = {0, 0, 1, 1};

/// One of each kind of shape.
Drawing everything() {
  return {200,
          100,
          {1, 1, 1, 1},
          {Fill{circle({50, 50}, 30), blue.with_alpha(0.14), 2, 0.2, blue},
           Stroke{polyline({{0, 0}, {200, 100}}), blue, 0.5, {1.5, 1.1}, false},
           Gradient{{150, 50}, {30, 0}, {0, 20}, {140, 40}, blue, blue.with_alpha(0.2)},
           Text{.markup = "*t*_{1,2} = √2", .at = {100, 90}, .size = 6.6, .colour = blue, .halo = 0.6}}};
}

}  // namespace

TEST_CASE("a PDF has the size of its paper, and of its pixels where it has none", "[pdf]") {
  CHECK_THAT(pdf(everything()), Contains("/MediaBox [ 0 0 150 75 ]"));
  Imprint imprint;
  imprint.width_pt = 400;
  CHECK_THAT(pdf(everything(), {}, imprint), Contains("/MediaBox [ 0 0 400 200 ]"));
}

TEST_CASE("a PDF embeds its fonts, or has none where letters are outlines", "[pdf]") {
  CHECK_THAT(pdf(everything()), Contains("/FontFile"));
  Imprint imprint;
  imprint.letters = Imprint::Letters::outlines;
  CHECK_THAT(pdf(everything(), {}, imprint), !Contains("/Font "));
  CHECK_THAT(pdf(everything()), !Contains("/Subtype /Image"));  // nothing was given up and made pixels
}

TEST_CASE("a PDF carries its metadata, whatever stands in it", "[pdf]") {
  const Metadata metadata = {{"lesson", "ray_sphere"},
                             {"title", "q = √(r² − m²) & <more> \"quoted\" ) >> endobj /Keywords (isect:{}) \\"},
                             {"empty", ""},
                             {"control", "a\nb\tc\x01"}};
  CHECK(pdf_metadata(pdf(everything(), metadata)) == metadata);
  CHECK(pdf_metadata(pdf(everything(), {{"a", "b"}})) == Metadata{{"a", "b"}});
  CHECK(pdf_metadata(pdf(everything())).empty());
  CHECK(pdf_metadata("%PDF-1.4\n<< /Keywords (tax, 2026) >>").empty());
  CHECK(pdf_metadata("%PDF-1.4\n<< /Keywords").empty());
  CHECK_THROWS_AS(pdf_metadata("<svg/>"), FileError);
  CHECK_THROWS_AS(pdf_metadata("%PDF-1.4\n<< /Keywords (isect:{\"a\":) >>"), FileError);
}

TEST_CASE("a PDF tells its title and the picture in words", "[pdf]") {
  Imprint imprint;
  imprint.title = "Ray and sphere";
  imprint.alt = "A ray meets a ball";
  const std::string bytes = pdf(everything(), {}, imprint);
  CHECK_THAT(bytes, Contains("/Title (Ray and sphere)"));
  CHECK_THAT(bytes, Contains("/Subject (A ray meets a ball)"));
}

TEST_CASE("the same drawing gives the same PDF, with no date in it, whatever was drawn before", "[pdf]") {
  const Metadata metadata = {{"lesson", "x"}};
  const std::string first = pdf(everything(), metadata);
  pdf({50, 50, blue, {Text{.markup = "**other**", .at = {5, 5}, .size = 30, .colour = blue}}});
  CHECK(pdf(everything(), metadata) == first);
  CHECK_THAT(first, !Contains("Date"));
}

TEST_CASE("degenerate shapes leave the rest of a PDF whole, and a drawing without size is refused", "[pdf]") {
  const Drawing odd = {
      50,
      50,
      blue,
      {Gradient{{5, 5}, {0, 0}, {0, 0}, {5, 5}, blue, blue}, Fill{{}, blue, 2, 0.2, blue},
       Text{.markup = "", .at = {1, 1}, .colour = blue}, Text{.markup = "t", .at = {1, 1}, .size = 0, .colour = blue}}};
  CHECK_THAT(pdf(odd), Contains("%%EOF"));
  CHECK_THROWS_AS(pdf({}), FileError);
  CHECK_THROWS_AS(pdf({std::nan(""), 5, blue, {}}), FileError);
}

}  // namespace pdf_test
