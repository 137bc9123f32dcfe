#include <isect/methods/interval_interval.h>

#include <limits>

#include "tests/catch.h"
#include "tests/core/common.h"

namespace interval_interval_methods_test {
using namespace isect;
using namespace isect::interval_interval;
using tests::not_a_number;

namespace {

bool all(const Interval<double>& a, const Interval<double>& b) {
  const bool meet = min_max(a, b);
  CHECK(by_middles(a, b) == meet);
  CHECK(ends(a, b) == meet);
  CHECK(min_max(b, a) == meet);
  return meet;
}

}  // namespace

TEST_CASE("the methods agree on small integers", "[interval_interval_methods]") {
  CHECK(all({0, 2}, {1, 3}));
  CHECK(all({0, 1}, {1, 3}));
  CHECK(all({0, 9}, {4, 5}));
  CHECK(all({4, 4}, {4, 4}));
  CHECK_FALSE(all({0, 1}, {2, 3}));
}

TEST_CASE("middles come apart where ends touch", "[interval_interval_methods]") {
  CHECK(min_max<double>({.1, .7}, {.7, .9}));
  CHECK_FALSE(by_middles<double>({.1, .7}, {.7, .9}));
}

TEST_CASE("the larger lower end shows an inverted interval, and may hide NaN", "[interval_interval_methods]") {
  CHECK_FALSE(min_max<double>({1, -1}, {-5, 5}));
  CHECK(ends<double>({1, -1}, {-5, 5}));
  CHECK(min_max<double>({0, 1}, {not_a_number, not_a_number}));
  CHECK_FALSE(min_max<double>({not_a_number, not_a_number}, {0, 1}));
}

TEST_CASE("the events tell the common part and the middles", "[interval_interval_methods]") {
  Record<MethodEvent<double>> record;
  min_max<double>({0, 2}, {1, 3}, record);
  by_middles<double>({0, 2}, {1, 3}, record);
  REQUIRE(record.events.size() == 2);
  CHECK(std::get<Common<double>>(record.events[0]).common == Interval<double>{1, 2});
  CHECK(std::get<Middles<double>>(record.events[1]).distance == 1);
  CHECK(std::get<Middles<double>>(record.events[1]).reach == 2);
}

}  // namespace interval_interval_methods_test
