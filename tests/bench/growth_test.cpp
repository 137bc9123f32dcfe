// Time against size: which sizes, how often, and the exponent.

#include "bench/growth.h"

#include "tests/catch.h"

namespace growth_test {
using namespace isect::bench;

TEST_CASE("sizes are powers of ten, few of them in a quick run", "[growth]") {
  const Session quick(Effort::quick(), 1), full(Effort(), 1);
  CHECK(sizes(quick, 100) == std::vector{100, 1000, 10'000});
  CHECK(sizes(full, 1000) == std::vector{1000, 10'000, 100'000, 1'000'000});
  CHECK(sizes(full, 100, 5000) == std::vector{100, 1000});
  CHECK(sizes(quick, 100'000).empty());
}

TEST_CASE("a time is the least of several runs, of one in a quick run", "[growth]") {
  const Effort no_time = {1, 1, 1, 5, 0, false};
  const Session hurried(no_time, 1), full(Effort(), 1);
  int runs = 0;
  const auto count = [&] { return ++runs; };
  CHECK(least_time(hurried, count) >= 0);
  CHECK(runs == 1);
  runs = 0;
  least_time(full, count);
  CHECK(runs == full.effort.most_passes);  // it takes no time
}

TEST_CASE("a pass asks every case", "[growth]") {
  const Session hurried({1, 1, 1, 1, 0, false}, 1);
  int sum = 0;
  least_each(hurried, std::vector{1, 2, 3}, [&](int x) { return sum += x; });
  CHECK(sum == 6);
}

TEST_CASE("a curve enters the session with its exponent, and not without two points", "[growth]") {
  Session session(Effort::quick(), 1);
  Grown grown("hull", "chain", "set of points", "a peer");
  grown.add(10, 30);
  grown.report(session);
  CHECK(session.found.growths.empty());
  grown.add(100, 3000);
  grown.report(session);
  REQUIRE(session.found.growths.size() == 1);
  const Growth& g = session.found.growths[0];
  CHECK((g.test == "hull" && g.method == "chain" && g.unit == "set of points" && g.library == "a peer"));
  CHECK(g.exponent == Approx(2));
  CHECK((g.n == std::vector{10.0, 100.0} && g.ns == std::vector{30.0, 3000.0}));
}

}  // namespace growth_test
