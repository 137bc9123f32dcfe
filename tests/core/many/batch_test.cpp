// Batches against the scalar exact tests, entry by entry, in every instruction set that the machine has.

#include <isect/many/batch.h>

#include <cstring>
#include <limits>

#include <isect/many/batch_aabb.h>
#include <isect/many/batch_point_polygon.h>
#include <isect/many/batch_ray_sphere.h>
#include "bench/random_shapes.h"
#include "bench/ray_sphere/families.h"
#include "tests/catch.h"
#include "tests/settings.h"

namespace batch_test {
using namespace isect;
using bench::Numbers;

namespace {

std::vector<InstructionSet> instruction_sets() {
  std::vector<InstructionSet> sets = {InstructionSet::any};
  if (widest() != InstructionSet::any) sets.push_back(InstructionSet::avx2);
  if (widest() == InstructionSet::avx512) sets.push_back(InstructionSet::avx512);
  return sets;
}

/// A column that starts `offset` numbers into its memory.
template <class S>
struct Column {
  std::vector<S> memory;
  std::size_t offset;

  std::span<const S> view() const { return std::span<const S>(memory).subspan(offset); }
};

/// Columns of different alignments.
template <class S, std::size_t K>
struct Columns {
  std::array<Column<S>, K> columns;

  explicit Columns(bench::Random& random) {
    for (Column<S>& c : columns) {
      c.offset = static_cast<std::size_t>(random.below(16));
      c.memory.resize(c.offset, std::numeric_limits<S>::quiet_NaN());
    }
  }
  template <int N>
  PointBatch<S, N> points(std::size_t first) const {
    PointBatch<S, N> batch;
    for (int k = 0; k < N; ++k) batch.coordinates[k] = columns[first + k].view();
    return batch;
  }
  template <class V>
  void append(std::size_t first, const V& v) {
    for (int k = 0; k < v.size(); ++k) columns[first + k].memory.push_back(v[k]);
  }
};

template <class S, int N>
struct Spheres : Columns<S, N + 1> {
  using Columns<S, N + 1>::Columns;

  void push(const Sphere<S, N>& s) {
    this->append(0, s.center);
    this->columns[N].memory.push_back(s.radius);
  }
  SphereBatch<S, N> batch() const { return {this->template points<N>(0), this->columns[N].view()}; }
};
template <class S, int N>
struct Boxes : Columns<S, 2 * N> {
  using Columns<S, 2 * N>::Columns;

  void push(const Aabb<S, N>& b) { this->append(0, b.lo), this->append(N, b.hi); }
  BoxBatch<S, N> batch() const { return {this->template points<N>(0), this->template points<N>(N)}; }
};

/// A number that a shape may have by mistake.
template <class S>
S bad(bench::Random& random) {
  constexpr S inf = std::numeric_limits<S>::infinity();
  constexpr S all[] = {std::numeric_limits<S>::quiet_NaN(), inf, -inf, std::numeric_limits<S>::max(),
                       -std::numeric_limits<S>::max()};
  return all[random.below(5)];
}

int length(bench::Random& random) { return random.one_in(4) ? random.below(300) : random.below(41); }

/// Checks both queries on all spheres; returns the number of hits.
template <class S, int N>
std::size_t check(const Ray<S, N>& ray, const SphereBatch<S, N>& batch) {
  std::vector<std::size_t> truth;
  std::optional<FirstHit<S>> first;
  for (std::size_t i = 0; i < batch.size(); ++i) {
    const std::optional<S> t = intersect(ray, batch[i]).surface;
    if (!t) continue;
    truth.push_back(i);
    if (!first || *t < first->t) first = {*t, i};
  }
  for (const InstructionSet set : instruction_sets()) {
    INFO("instruction set " << static_cast<int>(set) << ", " << batch.size() << " spheres");
    const Mask mask = hits(ray, batch, set);
    REQUIRE(mask.indices() == truth);
    REQUIRE(mask.count() == truth.size());
    REQUIRE(first_hit(ray, batch, set) == first);
  }
  return truth.size();
}

}  // namespace

TEST_CASE("a mask lists its bits", "[batch]") {
  Mask mask(130);
  CHECK(mask.size() == 130);
  CHECK(mask.count() == 0);
  mask.words()[0] = 1, mask.words()[2] = 2;
  CHECK(mask.indices() == std::vector<std::size_t>{0, 129});
  CHECK((mask[0] && mask[129] && !mask[1] && !mask[128]));
  CHECK(Mask(0).indices().empty());
}

TEST_CASE("the first of several spheres is found with its place", "[batch]") {
  bench::Random random(1);
  Spheres<double, 3> s(random);
  for (const double x : {9., 5., 5., -3., 7.}) s.push({{x, 0, 0}, 1});
  const Ray<double, 3> ray = {{0, 0, 0}, {1, 0, 0}};
  CHECK(hits(ray, s.batch()).indices() == std::vector<std::size_t>{0, 1, 2, 4});
  CHECK(first_hit(ray, s.batch()) == FirstHit<double>{4, 1});
  CHECK(first_hit(Ray<double, 3>{{0, 0, 0}, {0, 1, 0}}, s.batch()) == std::nullopt);
  CHECK(first_hit(Ray<double, 3>{{0, 0, 0}, {2, 0, 0}, infinite<double>}, s.batch()) == FirstHit<double>{-2, 3});
  CHECK(first_hit(Ray<double, 3>{{0, 0, 0}, {1, 0, 0}, {4.5, 100}}, s.batch()) == FirstHit<double>{6, 1});
  CHECK(hits(Ray<double, 3>{{0, 0, 0}, {1, 0, 0}, {4.5, 5.5}}, s.batch()).count() == 0);  // within two, short of two
  CHECK(first_hit(ray, SphereBatch<double, 3>{}) == std::nullopt);
}

TEMPLATE_TEST_CASE_SIG("rays hit the spheres of a batch that they hit one by one", "[batch]", FLOATS_AND_DIMENSIONS) {
  bench::Random random(tests::seed());
  std::size_t hit = 0;
  for (const auto& family : bench::ray_sphere_families<S, N>())
    for (int i = 0; i < tests::cases(4, 160); ++i) {
      INFO("seed " << tests::seed() << ", family " << family.name << ", case " << i);
      const int n = length(random);
      const auto own = family.draw(random);
      Ray<S, N> ray = own.ray;
      if (random.one_in(4)) ray.range = infinite<S>;
      if (random.one_in(8)) ray.range.lo = -infinite<S>.hi;
      if (random.one_in(8)) ray.range.lo = static_cast<S>(random.magnitude(-2, 2));
      if (random.one_in(4)) ray.range.hi = static_cast<S>(random.magnitude(-2, 2));
      if (random.one_in(40)) ray.origin[0] = bad<S>(random);
      Spheres<S, N> spheres(random);
      for (int k = 0; k < n; ++k) {
        Sphere<S, N> s = random.one_in(2) ? own.sphere : family.draw(random).sphere;
        for (int j = 0; j < N; ++j) s.center[j] = bench::moved(s.center[j], random.integer(-2, 2));
        if (random.one_in(30)) s.center[random.below(N)] = bad<S>(random);
        if (random.one_in(30)) s.radius = random.one_in(2) ? -s.radius : bad<S>(random);
        spheres.push(s);
      }
      hit += check(ray, spheres.batch());
    }
  CHECK(hit > 150);
}

TEMPLATE_TEST_CASE_SIG("rays and spheres of all numbers agree with one by one", "[batch]", FLOATS_AND_DIMENSIONS) {
  bench::Random random(tests::seed());
  std::size_t hit = 0;
  for (const Numbers numbers : bench::all_numbers)
    for (int i = 0; i < tests::cases(10, 400); ++i) {
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      const auto draw = [&] { return bench::number<S>(random, numbers); };
      Ray<S, N> ray = {bench::vector<S, N>(random, numbers), bench::vector<S, N>(random, numbers)};
      if (random.one_in(2)) ray.direction = bench::vector<S, N>(random, Numbers::grid);
      if (random.one_in(3)) ray.range.lo = random.one_in(2) ? -infinite<S>.hi : draw();
      if (random.one_in(3)) ray.range.hi = draw();
      Spheres<S, N> spheres(random);
      for (int k = length(random); k > 0; --k)
        spheres.push({bench::vector<S, N>(random, numbers), random.one_in(9) ? draw() : std::abs(draw())});
      hit += check(ray, spheres.batch());
    }
  CHECK(hit > 300);
}

TEMPLATE_TEST_CASE_SIG("a box meets the boxes of a batch that it meets one by one", "[batch]", FLOATS_AND_DIMENSIONS) {
  bench::Random random(tests::seed());
  std::size_t met = 0, all = 0;
  for (const Numbers numbers : bench::all_numbers)
    for (int i = 0; i < tests::cases(40, 1600); ++i) {
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      const auto draw = [&] {
        const Point<S, N> p = bench::vector<S, N>(random, numbers), q = bench::vector<S, N>(random, numbers);
        Aabb<S, N> b = {p.cwiseMin(q), p.cwiseMax(q)};
        if (random.one_in(20)) std::swap(b.lo, b.hi);
        if (random.one_in(20)) (random.one_in(2) ? b.lo : b.hi)[random.below(N)] = bad<S>(random);
        if (random.one_in(20)) (random.one_in(2) ? b.lo : b.hi)[random.below(N)] = bad<S>(random);
        return b;
      };
      const Aabb<S, N> box = draw();
      Boxes<S, N> boxes(random);
      for (int k = length(random); k > 0; --k) boxes.push(draw());

      const BoxBatch<S, N> batch = boxes.batch();
      std::vector<std::size_t> truth;
      for (std::size_t k = 0; k < batch.size(); ++k)
        if (intersects(box, batch[k])) truth.push_back(k);
      for (const InstructionSet set : instruction_sets()) {
        INFO("instruction set " << static_cast<int>(set));
        REQUIRE(intersects(box, batch, set).indices() == truth);
      }
      met += truth.size(), all += batch.size();
    }
  CHECK(met > all / 10);
  CHECK(met < all * 9 / 10);
}

TEMPLATE_TEST_CASE("points of a batch lie where they lie one by one", "[batch]", float, double) {
  using S = TestType;
  bench::Random random(tests::seed());
  int counts[3] = {};
  for (const Numbers numbers : bench::all_numbers)
    for (int i = 0; i < tests::cases(40, 1600); ++i) {
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      Polygon<S, 2> polygon;
      do {
        Ring<S, 2> ring;
        for (int k = length(random); k > 0; --k) ring.push_back(bench::vector<S, 2>(random, numbers));
        polygon.rings.push_back(ring);
      } while (random.one_in(4));
      Ring<S, 2>& some = polygon.rings[random.below(static_cast<int>(polygon.rings.size()))];
      if (random.one_in(40) && !some.empty())
        some[random.below(static_cast<int>(some.size()))][random.below(2)] = bad<S>(random);

      Columns<S, 2> points(random);
      for (int k = length(random); k > 0; --k) {
        Point<S, 2> p = bench::vector<S, 2>(random, numbers);
        if (random.one_in(4) && !some.empty()) {  // near an edge
          const std::size_t a = static_cast<std::size_t>(random.below(static_cast<int>(some.size())));
          p = some[a] * S(0.5) + some[(a + 1) % some.size()] * S(0.5);
        }
        if (random.one_in(30)) p[random.below(2)] = bad<S>(random);
        points.append(0, p);
      }
      const PointBatch<S, 2> batch = points.template points<2>(0);
      for (const FillRule rule : {FillRule::even_odd, FillRule::nonzero}) {
        std::vector<Location> truth;
        for (std::size_t k = 0; k < batch.size(); ++k) truth.push_back(locate(batch[k], polygon, rule));
        for (const InstructionSet set : instruction_sets()) {
          INFO("instruction set " << static_cast<int>(set));
          REQUIRE(locate(batch, polygon, rule, set) == truth);
        }
        for (const Location l : truth) ++counts[static_cast<int>(l)];
      }
    }
  for (const int count : counts) CHECK(count > (counts[0] + counts[1] + counts[2]) / 50);
}

}  // namespace batch_test
