// The culling lesson: it steps through the core's own events; and whether a box and the frustum have a common point,
// against linear programming in rationals.

#include <random>

#include "bench/rational.h"
#include "lessons/culling/picture.h"
#include "tests/catch.h"
#include "tests/settings.h"

namespace culling_test {
using namespace isect;
using lessons::culling_lesson::Box;
using lessons::culling_lesson::meet;
using oracle::Rational;

namespace {

/// n.x + d >= 0
struct HalfSpace {
  std::array<Rational, 3> n;
  Rational d;
};

std::vector<HalfSpace> half_spaces(const Box& box, const Frustum<double>& view) {
  std::vector<HalfSpace> all;
  for (int axis = 0; axis < 3; ++axis)
    for (const int side : {1, -1}) {
      HalfSpace h = {{0, 0, 0}, side > 0 ? Rational(-box.lo[axis]) : Rational(box.hi[axis])};
      h.n[axis] = side;
      all.push_back(h);
    }
  for (const Plane<double, 3>& plane : view.planes)
    all.push_back({oracle::rational<double, 3>(plane.normal), Rational(plane.d)});
  return all;
}

/// Half-spaces have no common point where some sum of multiples l >= 0 of four of them reads 0.x + d >= 0 with d < 0
/// (Farkas, Helly). The multiples are the minors of the four normals, so that the sum's normal is 0.
bool separated(const std::array<const HalfSpace*, 4>& four) {
  std::array<Rational, 4> minor;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto n = [&](std::size_t k) -> const std::array<Rational, 3>& { return four[k < i ? k : k + 1]->n; };
    const Rational det = oracle::dot(n(0), oracle::cross(n(1), n(2)));
    minor[i] = i % 2 == 0 ? det : -det;
  }
  for (const int side : {1, -1}) {
    bool none_negative = true;
    Rational d = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      none_negative = none_negative && side * minor[i] >= 0;
      d += side * minor[i] * four[i]->d;
    }
    if (none_negative && d < 0) return true;
  }
  return false;
}

bool truly_meet(const Box& box, const Frustum<double>& view) {
  const std::vector<HalfSpace> all = half_spaces(box, view);
  const std::size_t n = all.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j)
      for (std::size_t k = j + 1; k < n; ++k)
        for (std::size_t l = k + 1; l < n; ++l)
          if (separated({&all[i], &all[j], &all[k], &all[l]})) return false;
  return true;
}

Box around(const viz::Vec3& center, const viz::Vec3& half) { return {center - half, center + half}; }

/// The planes that the core tests, each with the name of its step and the line of pseudocode for the result.
template <class Event, class Shape>
std::vector<std::pair<std::string, int>> tested(const Shape& shape, const Frustum<double>& view) {
  Record<Event> record;
  isect::cull(shape, view, record);
  std::vector<std::pair<std::string, int>> planes;
  for (const Event& event : record.events)
    if (const auto* e = std::get_if<frustum_planes::Tested>(&event))
      planes.emplace_back(std::string("plane-") + lessons::culling_lesson::plane_names[e->plane],
                          e->side == Culling::outside    ? 2
                          : e->side == Culling::crossing ? 3
                                                         : 1);
  return planes;
}
std::vector<std::pair<std::string, int>> shown(const viz::Walk& walk) {
  std::vector<std::pair<std::string, int>> planes;
  for (const viz::Step& step : walk.steps)
    if (step.slug.starts_with("plane-")) planes.emplace_back(step.slug, step.line);
  return planes;
}

}  // namespace

TEST_CASE("the culling lesson steps through the planes that the core tests, and no others", "[culling lesson]") {
  using lessons::culling_lesson::one_volume;
  std::mt19937_64 random(tests::seed());
  std::uniform_real_distribution<double> unit(-1, 1);
  const viz::Vec3 eye(-4, 0, 0);
  const Frustum<double> view = lessons::culling_lesson::frustum(eye);
  std::array<int, 7> planes_asked{};
  for (int i = 0; i < tests::cases(200, 5000); ++i) {
    const viz::Vec3 center = 5 * viz::Vec3(unit(random), unit(random), unit(random));
    const double size = 0.25 + std::abs(unit(random));
    const Box box = around(center, viz::Vec3::Constant(size));
    const Sphere<double, 3> ball = {center, size};
    INFO("center " << center.transpose() << ", size " << size);
    const auto planes = tested<aabb_frustum::Event>(box, view);
    REQUIRE(shown(one_volume(view, eye, box)) == planes);
    REQUIRE(shown(one_volume(view, eye, ball)) == tested<sphere_frustum::Event>(ball, view));
    ++planes_asked[planes.size()];
  }
  CHECK(planes_asked[1] > 0);  // rejected by the first
  CHECK(planes_asked[6] > 0);
}

TEST_CASE("a box meets the frustum where rationals say so, also one step of its last digit off", "[culling lesson]") {
  std::mt19937_64 random(tests::seed());
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto draw = [&](double scale) {
    return viz::Vec3(scale * viz::Vec3(unit(random), unit(random), unit(random)));
  };
  int met = 0, missed = 0, in_vain = 0;
  for (int i = 0; i < tests::cases(150, 3000); ++i) {
    const viz::Vec3 eye = i % 2 == 0 ? viz::Vec3::Zero() : draw(3);
    const Frustum<double> view = lessons::culling_lesson::frustum(eye);
    const viz::Vec3 half = draw(1.5).cwiseAbs();
    const viz::Vec3 from = eye + viz::Vec3(4, 0, 0), way = draw(10).normalized();
    double in = 0, out = 16;  // steps along the way at which the box meets the frustum, and misses it
    const auto box = [&](double t) { return around(from + t * way, half); };
    while (in + (out - in) / 2 > in && in + (out - in) / 2 < out) {
      const double middle = in + (out - in) / 2;
      (meet(box(middle), view) ? in : out) = middle;
    }
    for (const double t : {in, out}) {
      const bool truth = truly_meet(box(t), view);
      INFO("eye " << eye.transpose() << ", half " << half.transpose() << ", way " << way.transpose() << ", t " << t);
      REQUIRE(meet(box(t), view) == truth);
      ++(truth ? met : missed);
      in_vain += !truth && isect::cull(box(t), view) == Culling::crossing;
    }
  }
  CHECK(met >= 150);
  CHECK(missed >= 150);
  CHECK(in_vain >= 10);
}

TEST_CASE("boxes that touch the frustum in one point meet it, and boxes inside and around it do", "[culling lesson]") {
  const Frustum<double> view = lessons::culling_lesson::frustum({0, 0, 0});
  const viz::Vec3 corner(7, 1.75, 2.625);  // far, top, right
  CHECK(meet({corner, corner + viz::Vec3(1, 1, 1)}, view));
  CHECK(meet({corner, corner}, view));
  CHECK_FALSE(meet({viz::Vec3(std::nextafter(7.0, 8.0), 1.75, 2.625), corner + viz::Vec3(1, 1, 1)}, view));
  CHECK_FALSE(meet({viz::Vec3(7, 1.75, std::nextafter(2.625, 3.0)), corner + viz::Vec3(1, 1, 1)}, view));
  CHECK(meet({{3, -0.5, -0.5}, {4, 0.5, 0.5}}, view));
  CHECK(meet({{-9, -9, -9}, {9, 9, 9}}, view));
  CHECK(meet({{-1e300, -1e300, -1e300}, {1e300, 1e300, 1e300}}, view));
  CHECK_FALSE(meet({{-9, -9, -9}, {1.25, 9, 9}}, view));
}

}  // namespace culling_test
