#include <isect/described.h>

#include <algorithm>
#include <limits>
#include <set>
#include <string>
#include <utility>

#include "bench/random.h"
#include "tests/catch.h"
#include "tests/settings.h"

namespace described_test {

using namespace isect;
using bench::Random;

/// Gives every number of a field a value.
void fill(auto&& value, const auto& draw) {
  if constexpr (requires { value.size(); })
    for (int i = 0; i < static_cast<int>(value.size()); ++i) value[i] = draw();
  else
    value = draw();
}

/// Small integers, so that preconditions are kept, broken, and just kept.
template <class S, class X>
X drawn(Random& random) {
  X x = {};
  each_field(x, [&](const auto&, auto&& value) { fill(value, [&] { return static_cast<S>(random.integer(-1, 2)); }); });
  return x;
}

template <class S, int N>
bool has_none(const Plane<S, N>& x) {
  return x.normal.isZero(0);
}
template <class S, int N>
bool has_none(const Ray<S, N>& x) {
  return empty(x.range);
}
template <class S, int N>
bool has_none(const Segment<S, N>&) {
  return false;
}
template <class X>
bool has_none(const X& x) {
  return empty(x);
}

template <class S, class X>
void check() {
  INFO(Described<X>::name);
  Random random(tests::seed());
  std::set<std::string> names;
  std::size_t numbers = 0;
  X none = {};
  each_field(none, [&](const auto& field, auto&& value) {
    names.insert(field.name);
    CHECK(std::string(field.help) != "");
    fill(value, [&] { return ++numbers, S(0); });
  });
  X all = {};  // NaN, whatever the field, then no more: its fields are all that it is
  std::fill_n(reinterpret_cast<unsigned char*>(&all), sizeof(X), static_cast<unsigned char>(255));
  CHECK_FALSE(finite(std::as_const(all)));
  each_field(all, [&](const auto&, auto&& value) { fill(value, [] { return S(1); }); });
  CHECK(finite(std::as_const(all)));
  for (const Need<X>& need : Described<X>::needs) CHECK(names.count(need.field) == 1);

  int empties = 0, others = 0;
  for (int i = 0; i < 2000; ++i) {
    X x = drawn<S, X>(random);
    REQUIRE((broken_need(x) != nullptr) == has_none(x));
    ++(has_none(x) ? empties : others);
    const X& whole = x;
    REQUIRE(finite(whole));
    int which = random.below(static_cast<int>(numbers));  // any number of it counts
    each_field(x, [&](const auto&, auto&& value) {
      fill(value, [&] { return which-- == 0 ? std::numeric_limits<S>::quiet_NaN() : S(1); });
    });
    REQUIRE_FALSE(finite(whole));
  }
  if (!Described<X>::needs.empty()) CHECK(empties > 10);
  CHECK(others > 10);
}

TEMPLATE_TEST_CASE("a shape is its fields, and has a point where it keeps its needs", "[described]", float, double) {
  using S = TestType;
  check<S, Segment<S, 2>>();
  check<S, Segment<S, 3>>();
  check<S, Ray<S, 2>>();
  check<S, Ray<S, 3>>();
  check<S, Plane<S, 2>>();
  check<S, Plane<S, 3>>();
  check<S, Sphere<S, 2>>();
  check<S, Sphere<S, 3>>();
  check<S, Capsule<S, 2>>();
  check<S, Capsule<S, 3>>();
  check<S, Cylinder<S>>();
  check<S, Cone<S>>();
  check<S, Aabb<S, 2>>();
  check<S, Aabb<S, 3>>();
  check<S, Obb<S, 2>>();
  check<S, Obb<S, 3>>();
}

}  // namespace described_test
