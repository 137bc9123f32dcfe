#include <isect/many/all_pairs.h>

#include <limits>

#include <isect/many/overlapping_pairs.h>
#include "bench/simple_shapes.h"
#include "tests/catch.h"
#include "tests/core/common.h"
#include "tests/core/heap.h"
#include "tests/settings.h"

using namespace isect;
using bench::Numbers;
using bench::Random;
using tests::inf, tests::not_a_number;

namespace {

template <class S, int N>
using Boxes = std::vector<Aabb<S, N>>;
using List = std::vector<IndexPair>;

/// All pairs by definition: no axis separates the two boxes, and both are finite and not empty.
template <class S, int N>
List truth(const Boxes<S, N>& boxes) {
  const auto real = [](const Aabb<S, N>& box) {
    for (int i = 0; i < N; ++i)
      if (!std::isfinite(box.lo[i]) || !std::isfinite(box.hi[i]) || box.lo[i] > box.hi[i]) return false;
    return true;
  };
  List pairs;
  for (int i = 0; i < static_cast<int>(boxes.size()); ++i) {
    if (!real(boxes[i])) continue;
    for (int j = i + 1; j < static_cast<int>(boxes.size()); ++j) {
      bool apart = false;
      for (int k = 0; k < N; ++k) apart |= boxes[i].hi[k] < boxes[j].lo[k] || boxes[j].hi[k] < boxes[i].lo[k];
      if (!apart && real(boxes[j])) pairs.push_back({i, j});
    }
  }
  return pairs;
}

enum Method { by_brute_force, by_sweep, by_grid, by_default, methods };

/// The pairs found, in order; a pair that is reported twice occurs twice.
template <class S, int N>
List found(const Boxes<S, N>& boxes, int method) {
  List pairs;
  const auto report = [&](int i, int j) { pairs.push_back({i, j}); };
  if (method == by_brute_force) all_pairs::brute_force(boxes, report);
  if (method == by_sweep) all_pairs::sweep_and_prune(boxes, report);
  if (method == by_grid) all_pairs::grid(boxes, report);
  if (method == by_default) pairs = overlapping_pairs(boxes);
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

/// Checks every method; returns the number of pairs.
template <class S, int N>
std::size_t check(const Boxes<S, N>& boxes) {
  const List pairs = truth(boxes);
  for (int method = 0; method < methods; ++method) {
    INFO("method " << method << ", " << boxes.size() << " boxes, " << pairs.size() << " pairs");
    if (found(boxes, method) != pairs) FAIL("not the same pairs");
  }
  return pairs.size();
}

template <class S, int N>
Aabb<S, N> cube(const Point<double, N>& center, double half) {
  const Vector<double, N> h = Vector<double, N>::Constant(half);
  return {(center - h).template cast<S>(), (center + h).template cast<S>()};
}

/// How boxes may be spread.
enum class Spread {
  even,
  clustered,
  heavy_tailed,
  all_sizes,
  lattice,
  plane,
  diagonal,
  sticks,
  points,
  outliers,
  count
};

template <class S, int N>
Boxes<S, N> draw(Random& random, Spread spread, int n) {
  const double side = std::pow(n, 1.0 / N);
  Boxes<S, N> boxes;
  for (int i = 0; i < n; ++i) {
    Point<double, N> center = random.in_box<N>(side / 2);
    double half = random.uniform(0.3, 0.6);
    switch (spread) {
      case Spread::clustered:
        center = std::round(random.unit()) * 50 * Point<double, N>::Ones() +
                 random.in_box<N>(std::pow(10, -random.integer(0, 3)));
        half *= 0.01;
        break;
      case Spread::heavy_tailed:
        half *= random.one_in(50) ? 20 : 1;
        break;
      case Spread::all_sizes:
        half = std::abs(random.magnitude(-3, std::log10(side)));
        break;
      case Spread::lattice:
        for (double& x : center) x = std::round(x);
        half = 0.5;
        break;
      case Spread::plane:
        center[N - 1] = 0.1 * center[0];
        center *= side;
        break;
      case Spread::diagonal:
        center = Point<double, N>::Constant(center[0] * n / 10);
        break;
      case Spread::points:
        for (double& x : center) x = std::round(x / 2);
        half = 0;
        break;
      case Spread::outliers:
        if (random.one_in(40)) center *= random.magnitude(0, 30);
        break;
      default:
        break;
    }
    boxes.push_back(cube<S, N>(center, half));
    if (spread == Spread::sticks) boxes.back().hi[random.below(N)] += S(side / 3);
    if (random.one_in(50)) boxes.push_back(boxes[random.below(i + 1)]);  // a duplicate
    const int axis = random.below(N);
    if (random.one_in(50)) boxes.back().hi[axis] = boxes.back().lo[axis] - S(random.below(2));  // flat, or empty
  }
  return boxes;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("none, one and two boxes", "[all_pairs]", FLOATS_AND_DIMENSIONS) {
  const Point<double, N> o = Point<double, N>::Zero(), x = Point<double, N>::Unit(0);
  CHECK(check<S, N>({}) == 0);
  CHECK(check<S, N>({cube<S, N>(o, 1)}) == 0);
  CHECK(check<S, N>({cube<S, N>(o, 1), cube<S, N>(x, 1)}) == 1);
  CHECK(check<S, N>({cube<S, N>(o, 1), cube<S, N>(2 * x, 1)}) == 1);  // touching
  CHECK(check<S, N>({cube<S, N>(o, 1), cube<S, N>(2.25 * x, 1)}) == 0);
  CHECK(check<S, N>({cube<S, N>(o, 0), cube<S, N>(-o, 0)}) == 1);
}

TEMPLATE_TEST_CASE_SIG("an ulp ends touching", "[all_pairs]", FLOATS_AND_DIMENSIONS) {
  for (int axis = 0; axis < N; ++axis) {
    Boxes<S, N> boxes = {cube<S, N>(Point<double, N>::Zero(), 1), cube<S, N>(2 * Point<double, N>::Unit(axis), 1)};
    CHECK(check(boxes) == 1);
    boxes[1].lo[axis] = std::nextafter(S(1), S(2));
    CHECK(check(boxes) == 0);
  }
}

TEMPLATE_TEST_CASE_SIG("boxes with NaN, infinite or inverted coordinates meet nothing", "[all_pairs]",
                       FLOATS_AND_DIMENSIONS) {
  Boxes<S, N> boxes(4, cube<S, N>(Point<double, N>::Zero(), 1));
  for (const double bad : {not_a_number, inf, -inf, 5.0})
    for (int axis = 0; axis < N; ++axis) {
      boxes.push_back(boxes[0]), boxes.back().lo[axis] = S(bad);
      boxes.push_back(boxes[0]), boxes.back().hi[axis] = S(-bad);
    }
  CHECK(check(boxes) == 6);
}

TEMPLATE_TEST_CASE_SIG("n equal boxes make n (n - 1) / 2 pairs", "[all_pairs]", FLOATS_AND_DIMENSIONS) {
  CHECK(check(Boxes<S, N>(100, cube<S, N>(Point<double, N>::Ones(), 0.5))) == 4950);
  CHECK(check(Boxes<S, N>(100, cube<S, N>(Point<double, N>::Ones(), 0))) == 4950);
}

TEMPLATE_TEST_CASE_SIG("a full lattice of touching boxes", "[all_pairs]", FLOATS_AND_DIMENSIONS) {
  const int side = N == 2 ? 20 : 8;
  Boxes<S, N> boxes;
  for (int k = 0; k < std::pow(side, N); ++k) {
    Point<double, N> center;
    for (int i = 0, rest = k; i < N; ++i, rest /= side) center[i] = rest % side;
    boxes.push_back(cube<S, N>(center, 0.5));
  }
  // each with its 3^N neighbours, itself too: (3 side - 2)^N ordered pairs
  const double ordered = std::pow(3 * side - 2, N), n = std::pow(side, N);
  CHECK(check(boxes) == static_cast<std::size_t>((ordered - n) / 2));
}

TEMPLATE_TEST_CASE_SIG("coordinates of any size", "[all_pairs]", FLOATS_AND_DIMENSIONS) {
  Random random(tests::seed());
  const Boxes<S, N> boxes = draw<S, N>(random, Spread::lattice, 200);
  const std::size_t pairs = check(boxes);
  const int most = std::numeric_limits<S>::max_exponent - 6;
  for (const int e : {-most, -most / 2, most / 2, most}) {
    Boxes<S, N> scaled = boxes;
    for (Aabb<S, N>& box : scaled)
      for (int i = 0; i < N; ++i) box.lo[i] = std::ldexp(box.lo[i], e), box.hi[i] = std::ldexp(box.hi[i], e);
    CHECK(check(scaled) == pairs);
  }
  const S top = std::numeric_limits<S>::max();
  Boxes<S, N> wide = boxes;
  wide.push_back({Point<S, N>::Constant(-top), Point<S, N>::Constant(top)});
  check(wide);
}

TEMPLATE_TEST_CASE_SIG("the cells around a cell have slots of their own in tables of any size", "[all_pairs]",
                       ((int N), N), 2, 3) {
  using namespace isect::detail::overlapping_pairs;
  for (const double cells : {4., 1e9})  // rows in order, or scattered
    for (int n = 1; n <= 1 << 29; n *= 2) {
      const Point<double, N> first = Point<double, N>::Zero(), last = Point<double, N>::Constant(cells);
      const Grid<N> grid = make_grid<N>(first, last, Vector<double, N>::Ones(), n);
      CHECK((grid.scattered == (cells > 4) || n < 256));
      std::vector<std::uint32_t> slots;
      for (int k = 0; k < std::pow(3, N); ++k) {
        CellOf<N> cell = {};
        for (int i = 0, rest = k; i < N; ++i, rest /= 3) cell[i] = rest % 3;
        slots.push_back(grid.slot(cell));
        CHECK(slots.back() <= grid.mask);
      }
      std::sort(slots.begin(), slots.end());
      CHECK(std::adjacent_find(slots.begin(), slots.end()) == slots.end());
    }
}

TEST_CASE("brute force tests n (n - 1) / 2 pairs, the others far fewer", "[all_pairs]") {
  Random random(tests::seed());
  const Boxes<double, 3> boxes = draw<double, 3>(random, Spread::even, 2000);
  const auto n = static_cast<std::int64_t>(boxes.size());
  const auto ignore = [](int, int) {};
  CHECK(all_pairs::brute_force(boxes, ignore) == n * (n - 1) / 2);
  CHECK(all_pairs::sweep_and_prune(boxes, ignore) < n * (n - 1) / 8);
  CHECK(all_pairs::grid(boxes, ignore) < n * (n - 1) / 100);
}

TEST_CASE("the events tell every test, and what the plane cuts", "[all_pairs]") {
  using namespace all_pairs;
  const Boxes<double, 2> boxes = {{{0, 0}, {2, 1}}, {{1, 0}, {4, 1}}, {{3, 2}, {5, 3}}};
  const auto ignore = [](int, int) {};

  Record<Event<2>> brute;
  brute_force(boxes, ignore, brute);
  REQUIRE(brute.events.size() == 3);
  CHECK((std::get<Tested>(brute.events[0]).overlap && !std::get<Tested>(brute.events[1]).overlap));

  Record<Event<2>> sweep;
  sweep_and_prune(boxes, ignore, sweep);
  REQUIRE(sweep.events.size() == 7);  // 1 enters, meets 0; 2 enters when 0 has left, is tested with 1
  CHECK(std::get<Axis>(sweep.events[0]).axis == 0);
  CHECK(std::get<Enters>(sweep.events[1]).box == 0);
  CHECK(std::get<Tested>(sweep.events[3]).overlap);
  CHECK(std::get<Leaves>(sweep.events[5]).box == 0);
  CHECK(std::get<Tested>(sweep.events[6]).i == 1);

  Record<Event<2>> cells;
  std::int64_t tested = 0;
  const std::int64_t tests = grid(boxes, ignore, cells);
  for (const Event<2>& e : cells.events) tested += std::holds_alternative<Tested>(e);
  CHECK(std::holds_alternative<Cell<2>>(cells.events.front()));
  CHECK(tested == tests);
}

TEMPLATE_TEST_CASE_SIG("every method finds the pairs of brute force, however the boxes are spread", "[all_pairs]",
                       FLOATS_AND_DIMENSIONS) {
  Random random(tests::seed());
  for (int spread = 0; spread < static_cast<int>(Spread::count); ++spread)
    for (int i = 0; i < tests::cases(6, 25); ++i) {
      const int n = random.integer(1, tests::cases(400, i == 0 ? 8000 : 1500));
      INFO("seed " << tests::seed() << ", spread " << spread << ", case " << i << ", n " << n);
      const Boxes<S, N> boxes = draw<S, N>(random, static_cast<Spread>(spread), n);
      const std::size_t pairs = check(boxes);
      if (n > 300) CHECK(pairs > 10);
    }
}

TEMPLATE_TEST_CASE_SIG("every method finds the pairs of brute force, whatever the numbers", "[all_pairs]",
                       FLOATS_AND_DIMENSIONS) {
  Random random(tests::seed());
  for (const Numbers numbers : bench::all_numbers)
    for (int i = 0; i < tests::cases(10, 400); ++i) {
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      Boxes<S, N> boxes;
      const int n = random.integer(2, 150);
      for (int k = 0; k < n; ++k) {
        boxes.push_back(bench::box<S, N>(random, numbers));
        if (random.one_in(3)) boxes.back().hi = boxes.back().lo + (boxes.back().hi - boxes.back().lo) / 16;
      }
      check(boxes);
    }
}

TEMPLATE_TEST_CASE_SIG("the default takes the memory that it states", "[all_pairs]", FLOATS_AND_DIMENSIONS) {
  Random random(tests::seed());
  const double stated = sizeof(S) == 4 ? 64 : 80;
  for (const Spread spread : {Spread::even, Spread::heavy_tailed, Spread::all_sizes, Spread::outliers, Spread::plane}) {
    const bool many_pairs = spread == Spread::heavy_tailed || spread == Spread::all_sizes;
    const int n = tests::cases(20000, many_pairs ? 20000 : 1000000);
    const Boxes<S, N> boxes = draw<S, N>(random, spread, n);
    long pairs = 0;
    const std::size_t before = heap::in_use;
    heap::most_in_use = heap::in_use;
    overlapping_pairs(boxes, [&](int, int) { ++pairs; });
    const double bytes = static_cast<double>(heap::most_in_use - before);
    INFO("spread " << static_cast<int>(spread) << ", " << bytes / static_cast<double>(boxes.size()) << " bytes a box");
    CHECK(pairs > 0);
    CHECK(bytes < 1.02 * stated * static_cast<double>(boxes.size()) + 100000);  // and what does not grow
  }
}
