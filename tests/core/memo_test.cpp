// A value kept in an arithmetic is found there once, by each copy for itself, and anew where steps are recorded.

#include <isect/parts/memo.h>

#include <array>

#include "tests/catch.h"

namespace memo_test {
using namespace isect;

namespace {

template <class W>
using Pair = std::array<W, 2>;

/// x^2 and 2 x^2, and how often they were found.
struct Squares {
  double x;
  Memo<Pair> kept = {};
  mutable int found = 0;

  template <PolynomialScalar W>
  kept_t<W, Pair<W>> in() const {
    return kept.template in<W>([&]() -> Pair<W> {
      ++found;
      const W square = W(x) * W(x);
      return {square, square + square};
    });
  }
};

}  // namespace

TEST_CASE("a number is found once in each arithmetic", "[found once]") {
  const Squares squares = {3};
  CHECK(squares.in<Exact>()[0].rounded() == 9);
  CHECK(squares.in<Exact>()[1].rounded() == 18);
  CHECK(squares.found == 1);
  CHECK(squares.in<Bounded<double>>()[1].value() == 18);
  CHECK(squares.in<MediumExact>()[0].rounded() == 9);
  CHECK(squares.in<Bounded<double>>()[0].value() == 9);
  CHECK(squares.found == 3);
}

TEST_CASE("a copy finds anew, as it may be given other numbers", "[found once]") {
  const Squares squares = {3};
  CHECK(squares.in<ShortExact>()[0].rounded() == 9);
  Squares copy = squares;
  copy.x = 5;
  CHECK(copy.in<ShortExact>()[0].rounded() == 25);
  CHECK(squares.in<ShortExact>()[0].rounded() == 9);
}

TEST_CASE("recorded steps find anew, and give what other arithmetics find", "[found once]") {
  const Squares squares = {3};
  const RecordedSum text([&]<class W>() -> W { return squares.in<W>()[0] - squares.in<W>()[1]; });
  CHECK(squares.found == 2);
  CHECK(text.operator()<Exact>().rounded() == -9);
  CHECK(text.operator()<Bounded<double>>().value() == -9);
}

}  // namespace memo_test
