// What readers could not answer in three exams from the lessons' texts, or found false: each sentence about boxes,
// capsules and balls is computed here.

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Geometry>

#include <isect/aabb_aabb.h>
#include <isect/capsule_capsule.h>
#include <isect/interval_interval.h>
#include <isect/methods/nearest_features.h>
#include <isect/obb_obb.h>
#include <isect/sphere_aabb.h>
#include "bench/random.h"
#include "tests/lessons/words.h"

namespace taught_shapes_words_test {
using namespace isect;
using namespace isect::viz;
using namespace isect::tests;

TEST_CASE("boxes that are not flat touch where opposite ends are equal and no axis has a gap", "[words]") {
  CHECK(solved_with("aabb-aabb", "if no axis has a gap, and on one an end of a is the opposite end of b"));
  bench::Random random = random_of("touching boxes");
  int touching = 0;
  for (int k = 0; k < 2000; ++k) {
    Aabb<double, 3> a, b;
    bool gap = false, opposite = false;
    for (int i = 0; i < 3; ++i) {
      a.lo[i] = random.below(4), a.hi[i] = a.lo[i] + 1 + random.below(3);
      b.lo[i] = random.below(4), b.hi[i] = b.lo[i] + 1 + random.below(3);
      gap = gap || a.lo[i] > b.hi[i] || b.lo[i] > a.hi[i];
      opposite = opposite || a.lo[i] == b.hi[i] || b.lo[i] == a.hi[i];
    }
    CHECK((relate(a, b) == Relation::touching) == (!gap && opposite));
    touching += !gap && opposite;
    const bool nested = (a.lo.array() >= b.lo.array()).all() && (a.hi.array() <= b.hi.array()).all();
    if (nested) CHECK((!opposite && relate(a, b) != Relation::touching));
  }
  CHECK(touching > 0);
  CHECK(solved_with("relations", "So one inside another shares interior points with it, and does not just touch it."));
}

TEST_CASE("another endpoint may be nearer where it is said, as one is left out there", "[words]") {
  int left_out = 0;
  on_random_settings("capsule-capsule", 200, [&](const Parameters&, const Walk& walk) {
    for (const Step& s : walk.steps) {
      if (!says(s.caption, "no other endpoint is tested")) continue;
      const bool after_all = s.slug == "ends-b" && says(s.caption, "**q**_b:");
      CHECK(says(s.caption, "one may be nearer still") == !after_all);
      left_out += !after_all;
    }
  });
  CHECK(left_out > 0);
}

TEST_CASE("two capsules have the common point that is told, if d is at most R", "[words]") {
  CHECK(solved_with("capsule-capsule", "At most r_b is left, so that point lies in both."));
  bench::Random random = random_of("common points");
  int meet = 0;
  for (int k = 0; k < 500; ++k) {
    const Segment<double, 3> a = {random.in_box<3>(2), random.in_box<3>(2)},
                             b = {random.in_box<3>(2), random.in_box<3>(2)};
    const double r_a = random.uniform(0, 1), r_b = random.uniform(0, 1);
    const auto at = nearest_features::places<double, 3>(a, b);
    const Vec3 on_a = a.p + at.s * (a.q - a.p), on_b = b.p + at.t * (b.q - b.p);
    const double d = (on_b - on_a).norm();
    if (std::abs(d - r_a - r_b) < 1e-9 || d < 1e-9) continue;
    CHECK(intersects(Capsule<double, 3>{a.p, a.q, r_a}, Capsule<double, 3>{b.p, b.q, r_b}) == (d <= r_a + r_b));
    if (d > r_a + r_b) continue;
    const Vec3 x = on_a + std::min(r_a, d) / d * (on_b - on_a);
    CHECK(((x - on_a).norm() <= r_a + 1e-12 && (x - on_b).norm() <= r_b + 1e-12));
    ++meet;
  }
  CHECK(meet > 0);
}

TEST_CASE("a distance passes the checks that need no other program", "[words]") {
  CHECK(solved_with("distance", "If one moves by 0.01, it may change by 0.01 at most."));
  bench::Random random = random_of("checks");
  for (int k = 0; k < 300; ++k) {
    const Segment<double, 3> a = {random.in_box<3>(2), random.in_box<3>(2)},
                             b = {random.in_box<3>(2), random.in_box<3>(2)};
    const auto distance = [](const Segment<double, 3>& x, const Segment<double, 3>& y) {
      return std::sqrt(nearest_features::distance2<double, 3>(x, y));
    };
    const double d = distance(a, b);
    CHECK(distance(b, a) == Approx(d).margin(1e-9));
    const Vec3 by = 0.01 * random.in_box<3>(1).normalized();
    CHECK(std::abs(distance(a, {b.p + by, b.q + by}) - d) <= 0.01 + 1e-9);
    for (int i = 0; i < 20; ++i) {
      const Vec3 on_a = a.p + random.unit() * (a.q - a.p), on_b = b.p + random.unit() * (b.q - b.p);
      CHECK((on_a - on_b).norm() >= d - 1e-9);
    }
  }
}

TEST_CASE("a ball contains a box if it contains the corner that is told", "[words]") {
  CHECK(solved_with("sphere-aabb", "A ball contains the box if it contains the farthest corner."));
  bench::Random random = random_of("farthest corners");
  int inside = 0;
  for (int k = 0; k < 500; ++k) {
    const Aabb<double, 3> box = {{-1, -0.5, -0.25}, {1, 0.5, 0.25}};
    const Sphere<double, 3> ball = {random.in_box<3>(1), random.uniform(0.5, 2.5)};
    const Vec3 far = (ball.center - box.lo).cwiseAbs().cwiseMax((ball.center - box.hi).cwiseAbs());
    const Relation found = relate(ball, box);
    CHECK((found == Relation::b_inside_a) == (far.norm() <= ball.radius));
    CHECK(found != Relation::equal);
    inside += found == Relation::b_inside_a;
  }
  CHECK(inside > 0);
  CHECK(relate(Sphere<double, 3>{{1, 2, 3}, 0}, Aabb<double, 3>{{1, 2, 3}, {1, 2, 3}}) == Relation::equal);
}

TEST_CASE("boxes of one orientation meet if their AABBs in its frame do", "[words]") {
  CHECK(solved_with("obb-obb", "With all three in common 3 are left, in the plane 2"));
  Eigen::Matrix3d axes;  // orthogonal and exact, though not of unit length
  axes << 1, -2, 0, 2, 1, 0, 0, 0, 1;
  bench::Random random = random_of("one orientation");
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const Vec3 cross = Vec3(axes.col(i)).cross(Vec3(axes.col(j)));
      int along = cross.isZero(0);
      for (int l = 0; l < 3; ++l) along += !cross.isZero(0) && cross.cross(Vec3(axes.col(l))).isZero(0);
      CHECK(along == 1);
    }
  int meet = 0, apart = 0;
  for (int k = 0; k < 300; ++k) {
    const auto whole = [&](int most) {
      return Vec3(random.integer(0, most), random.integer(0, most), random.integer(0, most));
    };
    const Vec3 c_a = whole(4), c_b = whole(4), h_a = whole(2), h_b = whole(2);
    const bool expected = intersects(Aabb<double, 3>{c_a - h_a, c_a + h_a}, Aabb<double, 3>{c_b - h_b, c_b + h_b});
    CHECK(intersects(Obb<double, 3>{axes * c_a, axes, h_a}, Obb<double, 3>{axes * c_b, axes, h_b}) == expected);
    (expected ? meet : apart) += 1;
  }
  CHECK((meet > 0 && apart > 0));
}

TEST_CASE("a large box may contain what is seen, with no corner in it", "[words]") {
  CHECK(solved_with("culling", "A large box may contain the whole frustum, with no corner in it."));
  const Aabb<double, 3> seen = {{-1, -1, -1}, {1, 1, 1}}, box = {{-3, -3, -3}, {3, 3, 3}};
  CHECK(relate(seen, box) == Relation::a_inside_b);
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 at(corner & 1 ? 3 : -3, corner & 2 ? 3 : -3, corner & 4 ? 3 : -3);
    CHECK_FALSE(intersects(seen, Aabb<double, 3>{at, at}));
  }
}

TEST_CASE("a sweep that lets others begin before a box ends loses no pair, and the other way those that touch",
          "[words]") {
  CHECK(solved_with("collision", "let the other begin first: they touch. Else that pair is lost."));
  bench::Random random = random_of("ties");
  int lost = 0;
  for (int k = 0; k < 100; ++k) {
    std::vector<Interval<double>> all;
    for (int i = 0; i < 8; ++i) {
      const double lo = random.below(10);
      all.push_back({lo, lo + random.below(4)});
    }
    std::ranges::sort(all, {}, &Interval<double>::lo);
    for (std::size_t j = 0; j < all.size(); ++j)
      for (std::size_t i = 0; i < j; ++i) {
        const bool active = all[i].hi >= all[j].lo, ends_first = all[i].hi > all[j].lo;
        const Relation truth = relate(all[i], all[j]);
        CHECK(active == (truth != Relation::disjoint));
        lost += active && !ends_first;
      }
  }
  CHECK(lost > 0);
}

}  // namespace taught_shapes_words_test
