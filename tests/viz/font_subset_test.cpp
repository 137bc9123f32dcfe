// A few letters of the figures' font, as a font of another name.

#include "viz/font/subset.h"

#include "tests/catch.h"

namespace font_subset_test {
using isect::test::Contains;
using namespace isect::viz;

TEST_CASE("a subset of the font is small, keeps its notices and not its name", "[font]") {
  for (const Face face : {Face::upright, Face::italic, Face::bold}) {
    const auto few = font_subset(face, "abt=−²"), more = font_subset(face, "abcdefghijklmnopqrstuvwxyz0123456789=−²αβ");
    REQUIRE((few && more));
    const std::string& font = few->bytes;
    CHECK(font.substr(0, 4) == "OTTO");
    CHECK(font.size() < 20'000);
    CHECK(font.size() < more->bytes.size());
    CHECK_THAT(font, !Contains("STIXGeneral"));
    CHECK_THAT(few->notice, Contains("Copyright (c)") && Contains("trademark"));
  }
}

TEST_CASE("what is no UTF-8 makes no font", "[font]") { CHECK(!font_subset(Face::upright, "\xff\xfe")); }

}  // namespace font_subset_test
