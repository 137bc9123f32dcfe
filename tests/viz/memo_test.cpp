#include "viz/memo.h"

#include <string>

#include "tests/catch.h"

namespace memo_test {
using namespace isect::viz;

TEST_CASE("a memo makes each result once, until many others were asked for", "[memo]") {
  int made = 0;
  Memo<std::string> memo(10);
  const auto ask = [&](double x) {
    return memo({x, 1}, [&] {
      ++made;
      return std::to_string(x);
    });
  };
  CHECK(ask(1) == std::to_string(1.0));
  CHECK(ask(1) == std::to_string(1.0));
  CHECK(made == 1);
  for (int x = 2; x <= 4; ++x) ask(x);
  CHECK(made == 4);
  CHECK(ask(1) == std::to_string(1.0));
  CHECK(made == 4);
  for (int x = 100; x < 120; ++x) ask(x);
  CHECK(made == 24);
  CHECK(ask(1) == std::to_string(1.0));
  CHECK(made == 25);  // it was dropped
}

TEST_CASE("what is asked for again and again stays, whatever comes between", "[memo]") {
  int made = 0;
  Memo<int> memo(8);
  for (int round = 0; round < 100; ++round) {
    CHECK(memo({7, 7}, [&] { return ++made; }) == 1);
    memo({1.0 * round}, [] { return 0; });
  }
  CHECK(made == 1);
}

}  // namespace memo_test
