#include <isect/trace.h>

#include <string>
#include <variant>

#include "tests/catch.h"

namespace trace_test {
using namespace isect;

namespace {

struct Sum {
  int value;
};
struct Done {};

/// A stand-in for any algorithm of the core.
template <class Trace = NoTrace>
constexpr int sum_to(int n, Trace&& trace = {}) {
  int sum = 0;
  for (int i = 1; i <= n; ++i) {
    sum += i;
    trace(Sum{sum});
  }
  trace(Done{});
  return sum;
}

}  // namespace

TEST_CASE("an algorithm without a listener runs at compile time", "[trace]") {
  static_assert(sum_to(4) == 10);
  static_assert(std::is_empty_v<NoTrace>);
  CHECK(sum_to(4) == 10);
}

TEST_CASE("a record keeps every event, in order, with its values", "[trace]") {
  Record<std::variant<Sum, Done>> record;
  CHECK(sum_to(3, record) == 6);

  REQUIRE(record.events.size() == 4);
  CHECK(std::get<Sum>(record.events[0]).value == 1);
  CHECK(std::get<Sum>(record.events[1]).value == 3);
  CHECK(std::get<Sum>(record.events[2]).value == 6);
  CHECK(std::holds_alternative<Done>(record.events[3]));
}

TEST_CASE("a record goes on where the last run ended", "[trace]") {
  Record<std::variant<Sum, Done>> record;
  sum_to(1, record);
  sum_to(1, record);
  CHECK(record.events.size() == 4);
}

TEST_CASE("any callable can listen, and choose its events by type", "[trace]") {
  std::string heard;
  const auto listener = [&heard](const auto& event) {
    if constexpr (std::is_same_v<std::decay_t<decltype(event)>, Sum>)
      heard += 's';
    else
      heard += '.';
  };
  CHECK(sum_to(2, listener) == 3);
  CHECK(heard == "ss.");
}

}  // namespace trace_test
