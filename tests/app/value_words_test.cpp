// A setting's numbers in a sentence.

#include "app/figures/value_words.h"

#include "tests/catch.h"

namespace value_words_test {
using namespace isect::program;
using isect::viz::Setting;
using isect::viz::Vec3;

TEST_CASE("numbers in a sentence have all their digits where these are few, or where fewer would hide what is next",
          "[told]") {
  const auto [number, told, rounded] =
      GENERATE(table<double, std::string, bool>({{-1.25, "−1.25", false},
                                                 {0, "0", false},
                                                 {-0.0, "−0", false},
                                                 {1e-9, "1\u2009·\u200910⁻⁹", false},
                                                 {0.73728139481, "0.73728", true},
                                                 {-123456.789, "−123456.789", false},
                                                 {-0.962890625, "−0.962890625", false},
                                                 {-123456.78912345, "−123\u2009457", true},
                                                 {1 + 0x1p-52, "1.0000000000000002", false},
                                                 {-0.1 - 0x1p-56, "−0.10000000000000002", false},
                                                 {1e-9 * (1 + 0x1p-50), "1.0000000000000009e−09", false}}));
  INFO(number);
  CHECK(in_words(Setting(number), false) == told);
  CHECK(rounded_in_words(Setting(number)) == rounded);
  if (!rounded) CHECK(in_words_and_full(Setting(number), false) == told);
}

TEST_CASE("points in a sentence are flat in a flat lesson, and choices are words", "[told]") {
  CHECK(in_words(Setting(Vec3(-1, 0.5, 2)), true) == "(−1, 0.5)");
  CHECK(in_words(Setting(Vec3(-1, 0.5, 2)), false) == "(−1, 0.5, 2)");
  CHECK(rounded_in_words(Setting(Vec3(0, 0, 1.0 / 3))));
  CHECK_FALSE(rounded_in_words(Setting(Vec3(0, -0.0, 0.125))));
  CHECK(in_words(Setting(std::string("k-dop")), false) == "k-dop");
  CHECK_FALSE(rounded_in_words(Setting(std::string("k-dop"))));
  CHECK(in_words_and_full(Setting(Vec3(-0.73728139481, 1e-9, 0)), true) == "(−0.73728139481, 1\u2009·\u200910⁻⁹)");
  CHECK(in_full(Setting(Vec3(-1, 1e-9, 0)), false) == "(-1, 1e-09, 0)");
}

}  // namespace value_words_test
