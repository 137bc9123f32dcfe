// Numbers as people type them.

#include "viz/text/number_text.h"

#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/catch.h"
#include "viz/lesson.h"

namespace number_text_test {
using namespace isect;
using namespace isect::viz;

TEST_CASE("a number is read as people write it, and what is none is refused with its reason", "[number_text]") {
  std::ifstream file(ISECT_TYPED_NUMBERS);
  const nlohmann::json cases = nlohmann::json::parse(file);  // app/book/numbers.js is held to it, too
  REQUIRE(cases.size() > 80);
  for (const auto& one : cases) {
    const std::string text = one.at(0).get<std::string>();
    INFO("“" << text << "”");
    if (one.at(1).is_string()) {
      CHECK_THROWS_WITH(number_from(text), isect::test::Contains(one.at(1).get<std::string>()));
      CHECK_THROWS_AS(number_from(text), BadInput);
    } else {
      CHECK(number_from(text) == Approx(one.at(1).get<double>()).epsilon(1e-15).margin(0));
    }
  }
}

TEST_CASE("a number as it is shown is read as itself", "[number_text]") {
  for (const double x : {0.0, 1.0, -1.0, 0.5, -0.75, 1.0 / 3, 1234.0, 26654.0, 1234567.0, -99999.0, 0.00012345})
    CHECK(number_from(shown(x)) == Approx(x).epsilon(1e-4));
}

TEST_CASE("a text of any length is refused and no more", "[number_text]") {
  for (const char* part : {"-", "(", "sqrt", "2^", "√", "+"})
    for (const int times : {41, 1000, 100000}) {
      std::string text;
      for (int i = 0; i < times; ++i) text += part;
      CHECK_THROWS_AS(number_from(text + "1"), BadInput);
    }
  std::string sum = "1";
  for (int i = 1; i < 1000; ++i) sum += "+1";
  CHECK(number_from(sum) == 1000);
}

}  // namespace number_text_test
