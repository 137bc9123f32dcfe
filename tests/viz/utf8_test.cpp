#include "viz/text/utf8.h"

#include "tests/catch.h"

namespace utf8_test {
using namespace isect::viz;

TEST_CASE("characters of UTF-8 are counted and taken apart", "[utf8]") {
  const std::string text = "r₁ ≤ π·😀";
  CHECK(count_characters(text) == 8);
  CHECK(character_at(text, 0) == "r");
  CHECK(character_at(text, 1) == "₁");
  CHECK(code_points(text) == U"r₁ ≤ π·😀");
  CHECK(count_characters("") == 0);
  CHECK(code_points("").empty());
}

TEST_CASE("bytes that are no UTF-8 are taken apart all the same", "[utf8]") {
  for (const std::string text : {"\x80", "\xff\xfe", "\xe2\x82", "a\xe2", "\xc3\xa9\x80\x80\x80\x80\x80\x80\x80\x80"}) {
    std::size_t bytes = 0;
    for (std::size_t i = 0; i < text.size(); i += character_at(text, i).size()) bytes += character_at(text, i).size();
    CHECK(bytes == text.size());
    CHECK(!code_points(text).empty());
  }
}

}  // namespace utf8_test
