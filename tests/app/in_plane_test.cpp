// A ray in the plane of a polygon: held to the core's segments in the plane, and to exact multiples.

#include "app/scene/in_plane.h"

#include <isect/point_polygon.h>
#include <isect/ray_outline.h>
#include <isect/segment_segment.h>

#include <random>

#include "tests/app/poses.h"
#include "tests/catch.h"

namespace in_plane_test {
using namespace isect;
using isect::test::in_space;
using program::scene::off_plane;
using Vec3 = Vector<double, 3>;

namespace {

std::optional<double> first_in_plane(const Ray<double, 3>& ray, const Ring<double, 3>& outline) {
  return first_hit(ray, Polygon<double, 3>{{outline}});
}

}  // namespace

TEST_CASE("a ray in a polygon's plane meets it where the segment to its end does, for whole numbers", "[scene]") {
  std::mt19937 random(11);
  std::uniform_int_distribution<int> whole(-4, 4), count(3, 7);
  int hits = 0, starts = 0;
  for (int i = 0; i < 4000; ++i) {
    Ring<double, 2> flat(static_cast<std::size_t>(count(random)));
    for (Point<double, 2>& v : flat) v = {whole(random), whole(random)};
    double area = 0;
    for (std::size_t k = 0; k < flat.size(); ++k) {
      const auto &a = flat[k], &b = flat[(k + 1) % flat.size()];
      area += a.x() * b.y() - a.y() * b.x();
    }
    const Point<double, 2> o(whole(random), whole(random)), d(whole(random), whole(random));
    if (area == 0 || d.isZero(0)) continue;
    const int pose = i % 3;
    const double t_max = 1 + i % 4;
    Ring<double, 3> outline;
    for (const Point<double, 2>& v : flat) outline.push_back(in_space(v, pose));
    const Vec3 origin = in_space(o, pose), direction = in_space(d, pose) - in_space({0, 0}, pose);
    const auto t = first_in_plane({origin, direction, {0, t_max}}, outline);

    const bool inside = locate(o, flat) != Location::out;
    bool meets = inside;
    double first = inside ? 0 : t_max;
    for (std::size_t k = 0; k < flat.size(); ++k) {
      const auto shared =
          intersect(Segment<double, 2>{o, o + t_max * d}, Segment<double, 2>{flat[k], flat[(k + 1) % flat.size()]});
      if (shared.relation == segment_segment::Meeting::disjoint) continue;
      meets = true;
      const auto place = [&](const Point<double, 2>& p) { return (p - o).dot(d) / d.dot(d); };
      if (shared.point) first = std::min(first, place(*shared.point));
      if (shared.shared) first = std::min({first, place(shared.shared->p), place(shared.shared->q)});
    }
    INFO(i);
    REQUIRE(t.has_value() == meets);
    if (t) CHECK(*t == Approx(first).margin(1e-12));
    hits += meets, starts += inside;
    CHECK(off_plane(outline) == 0);
    if (t) CHECK(first_in_plane({origin, direction, {-HUGE_VAL, HUGE_VAL}}, outline).value() <= *t);
    if (meets) CHECK(first_in_plane({origin, direction, {t_max, HUGE_VAL}}, outline).value_or(t_max) >= t_max);
  }
  CHECK((hits > 500 && starts > 200));
}

TEST_CASE("ends of a range count exactly, and a range without numbers is empty", "[scene]") {
  const Ring<double, 3> square = {{1, 0, 0}, {3, 0, 0}, {3, 0, 2}, {1, 0, 2}};
  const Ray<double, 3> ray = {{0, 0, 1}, {1, 0, 0}, {0, 1}};
  CHECK(first_in_plane(ray, square) == 1.0);
  CHECK_FALSE(first_in_plane({ray.origin, ray.direction, {0, std::nextafter(1.0, 0.0)}}, square));
  CHECK(first_in_plane({ray.origin, ray.direction, {2, 9}}, square) == 2.0);  // from inside
  CHECK(first_in_plane({ray.origin, ray.direction, {3, 9}}, square) == 3.0);  // leaving it
  CHECK_FALSE(first_in_plane({ray.origin, ray.direction, {std::nextafter(3.0, 4.0), 9}}, square));
  CHECK_FALSE(first_in_plane({ray.origin, ray.direction, {2, 1}}, square));
  CHECK(first_in_plane({{0, 0, 2}, {1, 0, 0}, {0, HUGE_VAL}}, square) == 1.0);  // along a side
  CHECK(first_in_plane({{0, 0, 2}, {1, 0, 0}, {2.5, HUGE_VAL}}, square) == 2.5);
  CHECK(first_in_plane({{0, 0, -1}, {1, 0, 1}, {0, HUGE_VAL}}, square) == 1.0);  // at a corner
  // A third is no double: the hit is the one nearest to it.
  CHECK(first_in_plane({{0, 0, 1}, {3, 0, 0}, {0, HUGE_VAL}}, square) == 1.0 / 3);
}

TEST_CASE("how far corners lie off one plane is told, and 0 is said of none that does", "[scene]") {
  Ring<double, 3> square = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
  CHECK(off_plane(square) == 0);
  square[2].z() = 1e-300;
  CHECK(off_plane(square) > 0);
  square[2].z() = 0.25;
  CHECK(off_plane(square) == Approx(0.125).epsilon(0.01));                // the normal leans half way
  for (const int exponent : {-1060, -900, -570, -300, 300, 570, 1000}) {  // far beyond what squares can be
    Ring<double, 3> scaled = square;
    for (Vec3& v : scaled) v *= std::ldexp(1, exponent);
    INFO(exponent);
    CHECK(std::ldexp(off_plane(scaled), -exponent) ==
          Approx(off_plane(square)).epsilon(exponent < -1000 ? 0.1 : 1e-15));
  }
}

}  // namespace in_plane_test
