#include <isect/counted.h>

#include <isect/methods/ray_sphere.h>
#include "tests/catch.h"

namespace counted_test {
using namespace isect;
using C = Counted<double>;

namespace {

template <class F>
Tally counted(const F& run) {
  tally() = {};
  run();
  return tally();
}

Ray<C, 3> ray(double y, double range_hi = std::numeric_limits<double>::infinity()) {
  return {{C(-3), C(y), C(0)}, {C(1), C(0), C(0)}, {C(0), C(range_hi)}};
}
const Sphere<C, 3> unit_sphere = {{C(0), C(0), C(0)}, C(1)};

}  // namespace

TEST_CASE("each operation is counted once, under its own name", "[counted]") {
  const C x = 9, y = 2;
  CHECK(counted([&] { CHECK((x + y).value == 11); }) == Tally{.add = 1});
  CHECK(counted([&] { CHECK((x - y).value == 7); }) == Tally{.add = 1});
  CHECK(counted([&] { CHECK((x * y).value == 18); }) == Tally{.mul = 1});
  CHECK(counted([&] { CHECK((x / y).value == 4.5); }) == Tally{.div = 1});
  CHECK(counted([&] { CHECK(sqrt(x).value == 3); }) == Tally{.sqrt = 1});
  CHECK(counted([&] { CHECK((-x).value == -9); }) == Tally{});
}

TEST_CASE("each comparison is counted once", "[counted]") {
  const C x = 9, y = 2;
  CHECK(counted([&] { CHECK_FALSE(x < y); }) == Tally{.compare = 1});
  CHECK(counted([&] { CHECK_FALSE(x <= y); }) == Tally{.compare = 1});
  CHECK(counted([&] { CHECK((x > y)); }) == Tally{.compare = 1});
  CHECK(counted([&] { CHECK((x >= y)); }) == Tally{.compare = 1});
  CHECK(counted([&] { CHECK_FALSE(x == y); }) == Tally{.compare = 1});
}

TEST_CASE("an inner product of n terms is n multiplications and n - 1 additions", "[counted]") {
  const Vector<C, 3> a = {C(1), C(2), C(3)};
  const Tally t = counted([&] { CHECK(a.dot(a).value == 14); });
  CHECK(t == Tally{.mul = 3, .add = 2});
  const Vector<C, 2> b = {C(1), C(2)};
  CHECK(counted([&] { CHECK(b.dot(b).value == 5); }) == Tally{.mul = 2, .add = 1});
}

TEST_CASE("halving B saves three multiplications and nothing else", "[counted][ray_sphere_methods]") {
  const Tally full = counted([] { CHECK(ray_sphere::quadratic(ray(0), unit_sphere)->value == 2); });
  const Tally half = counted([] { CHECK(ray_sphere::half_b(ray(0), unit_sphere)->value == 2); });
  CHECK(full.mul - half.mul == 3);
  CHECK(full.add == half.add);
  CHECK(full.div == half.div);
  CHECK(full.sqrt == half.sqrt);
  CHECK(full.compare == half.compare);
}

TEST_CASE("a miss costs the quadratic neither a root nor a division", "[counted][ray_sphere_methods]") {
  const Tally hit = counted([] { ray_sphere::quadratic(ray(0), unit_sphere); });
  const Tally miss = counted([] { ray_sphere::quadratic(ray(2), unit_sphere); });
  CHECK(hit.sqrt == 1);
  CHECK(hit.div == 2);
  CHECK(miss.sqrt == 0);
  CHECK(miss.div == 0);
}

TEST_CASE("Haines' method never divides, and rejects a sphere behind at once", "[counted][ray_sphere_methods]") {
  const Tally hit = counted([] { CHECK(ray_sphere::haines(ray(0), unit_sphere)->value == 2); });
  CHECK(hit.div == 0);
  CHECK(hit.sqrt == 1);

  Ray<C, 3> away = ray(0);
  away.direction = {C(-1), C(0), C(0)};
  const Tally behind = counted([&] { CHECK_FALSE(ray_sphere::haines(away, unit_sphere)); });
  CHECK(behind.sqrt == 0);
  CHECK(behind.mul == 7);  // s = l.d, l.l, r^2
}

TEST_CASE("counting changes no result", "[counted][ray_sphere_methods]") {
  const Ray<double, 3> plain = {{-3, 0.25, 0}, {1, 0, 0}};
  const Sphere<double, 3> ball = {{0, 0, 0}, 1};
  CHECK(ray_sphere::quadratic(ray(0.25), unit_sphere)->value == *ray_sphere::quadratic(plain, ball));
  CHECK(ray_sphere::half_b(ray(0.25), unit_sphere)->value == *ray_sphere::half_b(plain, ball));
  CHECK(ray_sphere::haines(ray(0.25), unit_sphere)->value == *ray_sphere::haines(plain, ball));
}

}  // namespace counted_test
