// A recorded text finds the same values as the text itself, bit for bit, in every arithmetic.

#include <isect/numbers/recorded.h>

#include <bit>
#include <cstdint>
#include <vector>

#include <isect/numbers/predicate.h>
#include <isect/numbers/quotient.h>
#include "bench/random.h"
#include "tests/catch.h"
#include "tests/settings.h"

namespace recorded_test {
using namespace isect;

namespace {

/// A polynomial drawn by chance, the same each time that it runs.
struct Text {
  std::uint64_t seed;
  int depth;
  bool whole;

  template <class W>
  W operator()() const {
    bench::Random random(seed);
    return expression<W>(random, depth);
  }
  template <class W>
  W expression(bench::Random& random, int height) const {
    const auto number = [&] { return whole ? random.integer(-4, 4) : random.magnitude(-2, 2); };
    if (height == 0) {
      const double x = number(), y = number();
      return random.one_in(2) ? W(x) : difference<W>(x, y);
    }
    const W a = expression<W>(random, height - 1);
    const W b = random.one_in(8) ? a : expression<W>(random, random.below(height));
    switch (random.below(5)) {
      case 0:
        return a + b;
      case 1:
        return a - b;
      case 2:
        return -a;
      case 3:
        return abs(a);
      default:
        return a * b;
    }
  }
};

std::vector<Text> texts() {
  bench::Random random(bench::stream(tests::seed(), "recorded"));
  std::vector<Text> all;
  for (int i = 0; i < 2000; ++i) all.push_back({random.bits(), 1 + random.below(5), random.one_in(2)});
  return all;
}

std::uint64_t bits(double x) { return std::bit_cast<std::uint64_t>(x == 0 ? 0 : x); }

template <class W>
void same_as_compensated(const Text& text, const RecordedSum& steps) {
  const W x = text.operator()<W>(), y = steps.operator()<W>();
  REQUIRE(bits(x.hi) == bits(y.hi));
  REQUIRE(bits(x.lo) == bits(y.lo));
}

}  // namespace

TEST_CASE("a recorded text finds what the text finds", "[recorded]") {
  for (const Text& text : texts()) {
    INFO("ISECT_SEED=" << tests::seed() << ", text " << text.seed);
    const RecordedSum steps(text);
    REQUIRE(bits(text.operator()<Grid>().step()) == bits(steps.operator()<Grid>().step()));
    same_as_compensated<Compensated>(text, steps);
    same_as_compensated<Fused>(text, steps);
    REQUIRE(text.operator()<ShortExact>().sign() == steps.operator()<ShortExact>().sign());
    const auto doubled = text.operator()<Bounded<DoubleDouble>>(), run = steps.operator()<Bounded<DoubleDouble>>();
    REQUIRE(bits(doubled.value().hi) == bits(run.value().hi));
    REQUIRE(bits(doubled.value().lo) == bits(run.value().lo));
    REQUIRE(bits(doubled.error()) == bits(run.error()));
    REQUIRE((text.operator()<Exact>() - steps.operator()<Exact>()).sign() == 0);
  }
}

TEST_CASE("a long text settles the same sign as a short one", "[recorded]") {
  int settled = 0;
  for (const Text& text : texts()) {
    INFO("ISECT_SEED=" << tests::seed() << ", text " << text.seed);
    struct Listener {
      int count = 0;
      void operator()(const Fallback&) { ++count; }
    } listener;
    const int truth = text.operator()<Exact>().sign();
    REQUIRE(sign_of<long_text>(text, listener) == truth);
    REQUIRE(sign_of(text) == truth);
    settled += listener.count;
  }
  CHECK(settled > 50);
}

TEST_CASE("a recorded quotient is the quotient", "[recorded]") {
  for (const Text& text : texts()) {
    INFO("ISECT_SEED=" << tests::seed() << ", text " << text.seed);
    const auto ratio = [&]<class W>() -> Ratio<W> {
      const W x = text.operator()<W>();
      return {x, x * x + W(1)};
    };
    REQUIRE(bits(value_of<double>(ratio)) == bits(value_of<double>(RecordedRatio(ratio))));
    REQUIRE(bits(value_of<float>(ratio)) == bits(value_of<float>(RecordedRatio(ratio))));
  }
}

TEST_CASE("a recording within a recording leaves both whole", "[recorded]") {
  const auto inner = []<class W>() -> W { return W(2) * W(3); };
  const auto outer = [&]<class W>() -> W {
    const W five(5);
    REQUIRE(RecordedSum(inner).operator()<Exact>().sign() == 1);
    return five - W(5);
  };
  CHECK(RecordedSum(outer).operator()<Exact>().sign() == 0);
}

TEST_CASE("a recording that an exception ends leaves the one around it whole", "[recorded]") {
  const auto inner = []<class W>() -> W {
    const W two(2);
    if constexpr (std::is_same_v<W, Recorded>) throw std::bad_alloc();
    return two;
  };
  const auto outer = [&]<class W>() -> W {
    const W five(5);
    REQUIRE_THROWS_AS(RecordedSum(inner), std::bad_alloc);
    return five - W(7);
  };
  CHECK(RecordedSum(outer).operator()<Exact>().sign() == -1);
}

TEST_CASE("a long sum of exact numbers needs few places", "[recorded]") {
  struct Long {
    Recording steps = Recording([] {
      Recorded sum(0);
      for (int i = 1; i <= 10000; ++i) sum = sum + Recorded(i) * Recorded(1);
      return std::array{sum};
    });
  } text;
  CHECK(text.steps.places() <= 4);
  CHECK(text.steps.run<Exact>()[0].rounded() == 50005000);
}

}  // namespace recorded_test
