// Every hard family against big integers and 400-digit roots. ISECT_LONG=1 runs more than ten million rays.

#include <iostream>

#include "bench/ray_sphere/judge.h"
#include "tests/catch.h"
#include "tests/settings.h"

namespace ray_sphere_families_test {
using namespace isect;
using namespace isect::bench;

namespace {

struct Score {
  int hits = 0, wrong = 0;
  double ulps = 0;    ///< the largest error of any t
  std::string first;  ///< the first ray that is wrong, in full
};

template <class S, int N>
Score score(const RaySphereDraw<S, N>& family, int rays) {
  Random random(stream(tests::seed(), family.name));
  Score score;
  for (int i = 0; i < rays; ++i) {
    const RaySphereCase<S, N> c = family.draw(random);
    const oracle::RaySphere truth = oracle::ray_sphere(c.ray, c.sphere);
    Judgement judgement = judge(c.ray.range, intersect(c.ray, c.sphere), truth);
    if (intersects(c.ray, c.sphere) != truth.enter.has_value()) judgement.wrong = "intersects";
    score.hits += truth.enter.has_value();
    score.ulps = std::max(score.ulps, judgement.ulps);
    if (!judgement.wrong && judgement.ulps <= promised_ulps) continue;
    if (++score.wrong == 1) score.first = std::string(judgement.wrong ? judgement.wrong : "t") + ": " + text(c);
  }
  return score;
}

template <class S, int N>
std::string table_row(const RaySphereDraw<S, N>& family, int rays, const Score& score) {
  std::ostringstream row;
  row << (sizeof(S) == 4 ? "float  " : "double ") << N << "D  " << std::left << std::setw(18) << family.name
      << std::right << std::setw(9) << rays << " rays " << std::setw(9) << score.hits << " hits " << std::setw(6)
      << score.wrong << " wrong   max " << std::fixed << std::setprecision(3) << score.ulps << " ulp\n";
  return row.str();
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("every verdict and every t is right on the hard families", "[ray_sphere][families]",
                       ((class S, int N), S, N), (float, 2), (float, 3), (double, 2), (double, 3)) {
  const int rays = tests::long_run() ? 150000 : 4000;
  for (const RaySphereDraw<S, N>& family : ray_sphere_families<S, N>()) {
    const Score result = score(family, rays);
    if (tests::long_run()) std::cout << table_row(family, rays, result) << std::flush;
    INFO(family.name << " (" << family.note << "), ISECT_SEED=" << tests::seed() << ", off by up to " << result.ulps
                     << " ulp; first " << result.first);
    CHECK(result.wrong == 0);
    CHECK(result.hits > 0);
  }
}

TEMPLATE_TEST_CASE_SIG("the families are what they say", "[families]", ((class S, int N), S, N), (float, 2), (float, 3),
                       (double, 2), (double, 3)) {
  const auto count = [](const char* name, const auto& property) {
    Random random(stream(tests::seed(), name));
    int holds = 0;
    for (int i = 0; i < 500; ++i) {
      const RaySphereCase<S, N> c = ray_sphere_family<S, N>(name).draw(random);
      holds += property(c, oracle::ray_sphere(c.ray, c.sphere));
    }
    return holds;
  };
  using Case = RaySphereCase<S, N>;
  using Truth = oracle::RaySphere;
  CHECK(count("exact-tangent", [](const Case&, const Truth& t) { return t.line_roots == 1; }) == 500);
  CHECK(count("on-surface", [](const Case&, const Truth& t) { return t.origin == Location::on; }) == 500);
  CHECK(count("zero-radius", [](const Case& c, const Truth&) { return c.sphere.radius == 0; }) > 400);
  CHECK(count("range-ends", [](const Case& c, const Truth& t) {
          const auto on = [&](S end) { return end == S(t.t0.nearest) || end == S(t.t1.nearest); };
          return on(c.ray.range.lo) || on(c.ray.range.hi);
        }) > 100);
  for (const int roots : {0, 1, 2})
    CHECK(count("near-tangent", [&](const Case&, const Truth& t) { return t.line_roots == roots; }) > 20);
  for (const Location place : {Location::in, Location::on, Location::out})
    CHECK(count("near-surface", [&](const Case&, const Truth& t) { return t.origin == place; }) > 5);
  CHECK(count("ordinary", [](const Case&, const Truth& t) { return t.enter.has_value(); }) > 200);
}

TEST_CASE("a family draws the same rays from the same seed", "[families]") {
  for (const RaySphereDraw<double, 3>& family : ray_sphere_families<double, 3>()) {
    Random one(7), two(7), other(8);
    std::string first, second, third;
    for (int i = 0; i < 5; ++i)
      first += text(family.draw(one)), second += text(family.draw(two)), third += text(family.draw(other));
    CHECK(first == second);
    CHECK(first != third);
  }
}

TEST_CASE("random bits are those that the standard fixes", "[families]") {
  Random random(5489);
  CHECK(random.bits() == 14514284786278117030u);
}

}  // namespace ray_sphere_families_test
