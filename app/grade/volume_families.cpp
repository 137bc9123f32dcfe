// Intervals, boxes and balls.

#include <Eigen/Geometry>

#include "app/grade/drawing_numbers.h"
#include "bench/aabb_aabb/families.h"
#include "bench/ordinary_shapes.h"

namespace isect::grade {

namespace {

Numbers two_intervals(Random& random, Kind kind) {
  Draw draw(random, kind);
  draw.box(1), draw.box(1);
  return draw.x;
}
template <int most>
Numbers touching_intervals(Random& random) {
  const bench::Intervals<double> c = bench::interval_families::touching<double, most>(random);
  return {c.a.lo, c.a.hi, c.b.lo, c.b.hi};
}
Numbers intervals_of_one_number(Random& random) {
  Numbers x = two_intervals(random, random.one_in(2) ? Kind::grid : Kind::decimal);
  x[1] = x[0];
  if (random.one_in(2)) x[3] = x[2];
  if (random.one_in(2)) std::swap(x[0], x[2]), std::swap(x[1], x[3]);
  return x;
}

Numbers two_boxes(Random& random, Kind kind) {
  Draw draw(random, kind);
  draw.box(3), draw.box(3);
  return draw.x;
}
Numbers numbers_of(const bench::Boxes<double, 3>& c) {
  Numbers x;
  for (const auto* p : {&c.a.lo, &c.a.hi, &c.b.lo, &c.b.hi}) x.insert(x.end(), p->begin(), p->end());
  return x;
}
Numbers touching_faces(Random& random) {
  return numbers_of(
      bench::aabb_aabb_families::along_some<double, bench::interval_families::touching<double, 0>>(random));
}
Numbers nearly_touching_faces(Random& random) {
  return numbers_of(
      bench::aabb_aabb_families::along_some<double, bench::interval_families::touching<double, 2>>(random));
}
Numbers one_gap(Random& random) {  // overlapping along two axes, apart along one
  Numbers x = two_boxes(random, Kind::ordinary);
  const int gap = random.below(3);
  for (int i = 0; i < 3; ++i) {
    x[6 + i] = x[i] + (i == gap ? x[3 + i] - x[i] + random.uniform(0.1, 1) : random.uniform(-0.1, 0.1));
    x[9 + i] = x[6 + i] + random.uniform(0.2, 1);
  }
  return x;
}
Numbers flat_boxes(Random& random) {
  Numbers x = two_boxes(random, Kind::grid);
  const int flat = random.below(3);
  x[3 + flat] = x[flat];
  if (random.one_in(3))
    for (int i = 0; i < 3; ++i) x[9 + i] = x[6 + i];
  return x;
}

/// Whole numbers whose squares add up to a square: (a, b, c) of length d.
struct Whole {
  int legs[3], length;
};
Whole whole_vector(Random& random) {
  static constexpr Whole some[] = {{{3, 4, 0}, 5},  {{1, 2, 2}, 3}, {{2, 3, 6}, 7},   {{1, 4, 8}, 9},
                                   {{2, 6, 9}, 11}, {{4, 4, 7}, 9}, {{5, 12, 0}, 13}, {{0, 0, 5}, 5}};
  Whole v = some[random.below(8)];
  for (int i = 2; i > 0; --i) std::swap(v.legs[i], v.legs[random.below(i + 1)]);
  for (int& leg : v.legs) leg = random.one_in(2) ? leg : -leg;
  return v;
}

Numbers two_balls(Random& random, Kind kind) {
  Draw draw(random, kind);
  draw.ball(), draw.ball();
  return draw.x;
}
/// Balls that touch from outside, with `most` ulps more or less of a radius.
template <int most>
Numbers touching_balls(Random& random) {
  const Whole v = whole_vector(random);
  const int r = random.integer(0, v.length);
  Numbers x;
  for (int i = 0; i < 3; ++i) x.push_back(random.integer(-9, 9));
  x.push_back(r);
  for (int i = 0; i < 3; ++i) x.push_back(x[i] + v.legs[i]);
  x.push_back(bench::moved(static_cast<double>(v.length - r), most == 0 ? 0 : random.integer(-most, most)));
  if (x[7] < 0) x[7] = 0;
  return x;
}
Numbers one_ball_within(Random& random) {
  Numbers x = two_balls(random, Kind::ordinary);
  for (int i = 0; i < 3; ++i) x[4 + i] = x[i] + random.uniform(-0.1, 0.1);
  x[3] = random.uniform(1, 2), x[7] = random.uniform(0, 0.5);
  if (random.one_in(2)) std::swap_ranges(x.begin(), x.begin() + 4, x.begin() + 4);
  return x;
}
Numbers balls_of_radius_zero(Random& random) {
  Numbers x = two_balls(random, Kind::grid);
  x[3] = 0;
  if (random.one_in(2)) x[7] = 0;
  if (random.one_in(2)) std::copy_n(x.begin(), 3, x.begin() + 4);
  return x;
}

Numbers ball_and_box(Random& random, Kind kind) {
  Draw draw(random, kind);
  draw.ball(), draw.box(3);
  return draw.x;
}
/// The nearest point of the box is on a face, an edge or a corner, as many axes as the ball's centre is beyond.
template <int most>
Numbers ball_touching_box(Random& random) {
  Whole v = whole_vector(random);
  Numbers x(4), lo, hi;
  for (int i = 0; i < 3; ++i) {
    lo.push_back(random.integer(-9, 9)), hi.push_back(lo[i] + random.integer(0, 9));
    x[i] = v.legs[i] > 0   ? hi[i] + v.legs[i]
           : v.legs[i] < 0 ? lo[i] + v.legs[i]
                           : random.integer(int(lo[i]), int(hi[i]));
  }
  x[3] = bench::moved(static_cast<double>(v.length), most == 0 ? 0 : random.integer(-most, most));
  x.insert(x.end(), lo.begin(), lo.end()), x.insert(x.end(), hi.begin(), hi.end());
  return x;
}
Numbers ball_within_box(Random& random) {
  Numbers x = ball_and_box(random, Kind::ordinary);
  for (int i = 0; i < 3; ++i) x[i] = random.uniform(x[4 + i], x[7 + i]);
  x[3] = random.uniform(0, 0.1);
  return x;
}
Numbers point_or_flat_box(Random& random) {
  Numbers x = ball_and_box(random, Kind::grid);
  const int i = random.below(3);
  if (random.one_in(2)) x[3] = 0;
  x[7 + i] = x[4 + i];
  return x;
}

void put_obb(Numbers& x, const Point<double, 3>& c, const Eigen::Matrix3d& axes, const Numbers& half) {
  x.insert(x.end(), c.begin(), c.end());
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) x.push_back(axes(j, i));
  x.insert(x.end(), half.begin(), half.end());
}
/// The coordinate axes in some order, or turned by the angle of the triangle 3, 4, 5 about one of them.
Eigen::Matrix3d plain_axes(Random& random) {
  const int about = random.below(3), next = (about + 1) % 3, last = (about + 2) % 3;
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  if (random.one_in(2)) return axes;
  axes(next, next) = axes(last, last) = 0.6;
  axes(last, next) = 0.8, axes(next, last) = -0.8;
  return axes;
}
Numbers two_obbs(Random& random, Kind kind) {
  Numbers x;
  for (int box = 0; box < 2; ++box) {
    if (kind == Kind::ordinary) {
      const Obb<double, 3> b = bench::ordinary_obb<double>(random, 1);
      put_obb(x, b.center, b.axes, {b.half[0], b.half[1], b.half[2]});
      continue;
    }
    Draw draw(random, kind);
    draw.point(3);
    const Point<double, 3> center(draw.x[0], draw.x[1], draw.x[2]);
    const Eigen::Matrix3d axes = plain_axes(random);
    Numbers half;
    for (int i = 0; i < 3; ++i) half.push_back(draw.size());
    put_obb(x, center, axes, half);
  }
  return x;
}
/// Boxes of the same axes, a face at a face.
Numbers obbs_face_to_face(Random& random) {
  Numbers x;
  const Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  Point<double, 3> center;
  Numbers half, other;
  for (int i = 0; i < 3; ++i)
    center[i] = random.integer(-9, 9), half.push_back(random.integer(1, 5)), other.push_back(random.integer(1, 5));
  put_obb(x, center, axes, half);
  const int i = random.below(3);
  center[i] += half[i] + other[i];
  if (random.one_in(2)) center[i] = bench::moved(center[i], random.integer(-2, 2));
  put_obb(x, center, axes, other);
  return x;
}
/// Both boxes have one set of axes, so that cross products of edges vanish.
Numbers parallel_obbs(Random& random) {
  Numbers x = two_obbs(random, Kind::ordinary);
  std::copy_n(x.begin() + 3, 9, x.begin() + 18);
  return x;
}
/// Two bars, one across the other: only a cross product of edges separates them, or none does.
Numbers crossed_obbs(Random& random) {
  const double a = random.uniform(0, 1.5);
  Eigen::Matrix3d turn;
  turn = Eigen::AngleAxisd(a, Vector<double, 3>(random.heading<3>()));
  Numbers x;
  put_obb(x, {0, 0, 0}, turn, {3, 0.1, 0.1});
  put_obb(x, random.in_box<3>(0.4), turn * Eigen::AngleAxisd(random.uniform(0.5, 2.5), Eigen::Vector3d::UnitZ()),
          {3, 0.1, 0.1});
  return x;
}
Numbers flat_obbs(Random& random) {
  Numbers x = two_obbs(random, Kind::grid);
  x[12 + random.below(3)] = 0;
  if (random.one_in(2)) x[27] = x[28] = x[29] = 0;
  return x;
}

}  // namespace

std::vector<Family> volume_families(const std::string& task) {
  if (task == "interval")
    return with_own(of_all_numbers<two_intervals>(),
                    {{"touching", "intervals that share an end", touching_intervals<0>},
                     {"nearly touching", "the same, up to two ulps off", touching_intervals<2>},
                     {"degenerate", "intervals of one number", intervals_of_one_number}});
  if (task == "aabb")
    return with_own(of_all_numbers<two_boxes>(),
                    {{"touching faces", "boxes that share a face, an edge or a corner", touching_faces},
                     {"nearly touching faces", "the same, up to two ulps off", nearly_touching_faces},
                     {"a gap along one axis", "boxes apart along one axis, overlapping along two", one_gap},
                     {"degenerate", "flat boxes and points", flat_boxes}});
  if (task == "sphere-sphere")
    return with_own(of_all_numbers<two_balls>(),
                    {{"touching", "balls that touch from outside, of whole numbers", touching_balls<0>},
                     {"nearly touching", "the same, up to two ulps off", touching_balls<2>},
                     {"one within the other", "a small ball in a large one", one_ball_within},
                     {"degenerate", "balls of radius 0", balls_of_radius_zero}});
  if (task == "sphere-aabb")
    return with_own(of_all_numbers<ball_and_box>(),
                    {{"touching", "the ball touches a face, an edge or a corner", ball_touching_box<0>},
                     {"nearly touching", "the same, up to two ulps off", ball_touching_box<2>},
                     {"the ball within", "the centre lies in the box", ball_within_box},
                     {"degenerate", "radius 0, or a flat box", point_or_flat_box}});
  if (task == "obb-obb")
    return with_own(of_all_numbers<two_obbs>(),
                    {{"touching faces", "boxes of the same axes, face to face, or an ulp off", obbs_face_to_face},
                     {"parallel", "boxes of the same axes", parallel_obbs},
                     {"crossing bars", "long thin boxes, an edge towards an edge", crossed_obbs},
                     {"degenerate", "flat boxes and points", flat_obbs}});
  return {};
}

}  // namespace isect::grade
