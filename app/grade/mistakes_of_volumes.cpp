// Wrong implementations of yes-or-no tests.

#include <algorithm>
#include <cmath>

#include "app/grade/mistakes.h"

namespace isect::grade {

namespace {

/// Two intervals by their ends.
using IntervalTest = bool (*)(double alo, double ahi, double blo, double bhi);

constexpr IntervalTest closed_ends = [](double alo, double ahi, double blo, double bhi) {
  return alo <= bhi && blo <= ahi;
};
constexpr IntervalTest open_ends = [](double alo, double ahi, double blo, double bhi) {
  return alo < bhi && blo < ahi;
};
constexpr IntervalTest half_open = [](double alo, double ahi, double blo, double bhi) {
  return alo < bhi && blo <= ahi;
};
constexpr IntervalTest other_half_open = [](double alo, double ahi, double blo, double bhi) {
  return alo <= bhi && blo < ahi;
};
constexpr IntervalTest one_side = [](double, double ahi, double blo, double) { return blo <= ahi; };
constexpr IntervalTest other_side = [](double alo, double, double, double bhi) { return alo <= bhi; };
constexpr IntervalTest ends_within = [](double alo, double ahi, double blo, double bhi) {
  return (alo <= blo && blo <= ahi) || (alo <= bhi && bhi <= ahi);
};
constexpr IntervalTest one_end_within = [](double alo, double ahi, double blo, double) {
  return alo <= blo && blo <= ahi;
};
constexpr IntervalTest with_tolerance = [](double alo, double ahi, double blo, double bhi) {
  return alo <= bhi + 1e-6 && blo <= ahi + 1e-6;
};
constexpr IntervalTest by_centers = [](double alo, double ahi, double blo, double bhi) {
  return std::abs((alo + ahi) / 2 - (blo + bhi) / 2) <= (ahi - alo) / 2 + (bhi - blo) / 2;
};
constexpr IntervalTest no_absolute_value = [](double alo, double ahi, double blo, double bhi) {
  return (blo + bhi) / 2 - (alo + ahi) / 2 <= (ahi - alo) / 2 + (bhi - blo) / 2;
};

template <const IntervalTest& test>
Truth of_intervals(const Numbers& x) {
  return {test(x[0], x[1], x[2], x[3])};
}
/// The test on each of the first `axes` axes.
template <const IntervalTest& test, int axes = 3>
Truth of_boxes(const Numbers& x) {
  bool all = true;
  for (int i = 0; i < axes; ++i) all = all && test(x[i], x[3 + i], x[6 + i], x[9 + i]);
  return {all};
}
Truth or_for_and(const Numbers& x) {
  bool any = false;
  for (int i = 0; i < 3; ++i) any = any || closed_ends(x[i], x[3 + i], x[6 + i], x[9 + i]);
  return {any};
}

double squared_distance(const double* a, const double* b) {
  double sum = 0;
  for (int i = 0; i < 3; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return sum;
}
/// Two balls by the squared distance and the radii.
using BallTest = bool (*)(double d2, double r1, double r2);
constexpr BallTest usual_balls = [](double d2, double r1, double r2) { return d2 <= (r1 + r2) * (r1 + r2); };
constexpr BallTest open_balls = [](double d2, double r1, double r2) { return d2 < (r1 + r2) * (r1 + r2); };
constexpr BallTest squared_apart = [](double d2, double r1, double r2) { return d2 <= r1 * r1 + r2 * r2; };
constexpr BallTest squared_once = [](double d2, double r1, double r2) { return d2 <= r1 + r2; };
constexpr BallTest rooted = [](double d2, double r1, double r2) { return std::sqrt(d2) <= r1 + r2; };
constexpr BallTest tolerant_balls = [](double d2, double r1, double r2) { return std::sqrt(d2) <= r1 + r2 + 1e-6; };
constexpr BallTest surfaces = [](double d2, double r1, double r2) {
  return d2 <= (r1 + r2) * (r1 + r2) && d2 >= (r1 - r2) * (r1 - r2);
};
constexpr BallTest one_radius = [](double d2, double r1, double) { return d2 <= r1 * r1; };
constexpr BallTest larger_radius = [](double d2, double r1, double r2) {
  return d2 <= std::max(r1, r2) * std::max(r1, r2);
};
template <const BallTest& test>
Truth of_balls(const Numbers& x) {
  return {test(squared_distance(x.data(), x.data() + 4), x[3], x[7])};
}
/// Index shifted: the last coordinate is left out.
Truth balls_in_the_plane(const Numbers& x) {
  const double dx = x[0] - x[4], dy = x[1] - x[5];
  return {usual_balls(dx * dx + dy * dy, x[3], x[7])};
}
Truth boxes_around_balls(const Numbers& x) {
  bool all = true;
  for (int i = 0; i < 3; ++i) all = all && std::abs(x[i] - x[4 + i]) <= x[3] + x[7];
  return {all};
}

/// The squared distance from the centre to the box; parts of it may be left out.
double to_box(const Numbers& x, bool below, bool above, int axes = 3) {
  double sum = 0;
  for (int i = 0; i < axes; ++i) {
    const double lo = x[4 + i], hi = x[7 + i], c = x[i];
    if (below && c < lo) sum += (lo - c) * (lo - c);
    if (above && c > hi) sum += (c - hi) * (c - hi);
  }
  return sum;
}
std::vector<Mistake> ball_and_box_mistakes() {
  return {
      {"sphere-aabb", "an open set for a closed one: < for <=",
       [](const Numbers& x) { return Truth{to_box(x, true, true) < x[3] * x[3]}; }},
      {"sphere-aabb", "the radius is not squared",
       [](const Numbers& x) { return Truth{to_box(x, true, true) <= x[3]}; }},
      {"sphere-aabb", "a centre below the box is not considered",
       [](const Numbers& x) { return Truth{to_box(x, false, true) <= x[3] * x[3]}; }},
      {"sphere-aabb", "a centre beyond the box is not considered",
       [](const Numbers& x) { return Truth{to_box(x, true, false) <= x[3] * x[3]}; }},
      {"sphere-aabb", "the last axis is left out",
       [](const Numbers& x) { return Truth{to_box(x, true, true, 2) <= x[3] * x[3]}; }},
      {"sphere-aabb", "an early return inside the loop: the first axis decides",
       [](const Numbers& x) { return Truth{to_box(x, true, true, 1) <= x[3] * x[3]}; }},
      {"sphere-aabb", "the box is grown by the radius, corners and all",
       [](const Numbers& x) {
         bool all = true;
         for (int i = 0; i < 3; ++i) all = all && x[4 + i] - x[3] <= x[i] && x[i] <= x[7 + i] + x[3];
         return Truth{all};
       }},
      {"sphere-aabb", "the centre in the box counts as a miss",
       [](const Numbers& x) {
         const double d2 = to_box(x, true, true);
         return Truth{d2 > 0 && d2 <= x[3] * x[3]};
       }},
      {"sphere-aabb", "only whether the centre is in the box",
       [](const Numbers& x) { return Truth{!(to_box(x, true, true) > 0)}; }},
      {"sphere-aabb", "a tolerance of 1e-6",
       [](const Numbers& x) { return Truth{std::sqrt(to_box(x, true, true)) <= x[3] + 1e-6}; }},
      {"sphere-aabb", "the usual formula in doubles: squares round, overflow or vanish",
       [](const Numbers& x) { return Truth{to_box(x, true, true) <= x[3] * x[3]}; }},
  };
}

}  // namespace

std::vector<Mistake> volume_mistakes() {
  std::vector<Mistake> all = {
      {"interval", "an open set for a closed one: < for <=", of_intervals<open_ends>},
      {"interval", "half-open: one < for <=, at the end of b", of_intervals<half_open>},
      {"interval", "half-open: one < for <=, at the end of a", of_intervals<other_half_open>},
      {"interval", "a gap is seen on one side only: b after a", of_intervals<one_side>},
      {"interval", "a gap is seen on one side only: a after b", of_intervals<other_side>},
      {"interval", "only ends of b within a are looked for: a within b is a miss", of_intervals<ends_within>},
      {"interval", "only the lower end of b is looked for", of_intervals<one_end_within>},
      {"interval", "a tolerance of 1e-6", of_intervals<with_tolerance>},
      {"interval", "a missing absolute value of the distance of the centres", of_intervals<no_absolute_value>},
      {"interval", "centres and half-lengths, which round", of_intervals<by_centers>},
      {"aabb", "an open set for a closed one: < for <=", of_boxes<open_ends>},
      {"aabb", "half-open: one < for <=, at the end of b", of_boxes<half_open>},
      {"aabb", "half-open: one < for <=, at the end of a", of_boxes<other_half_open>},
      {"aabb", "a gap is seen on one side only: b after a", of_boxes<one_side>},
      {"aabb", "a gap is seen on one side only: a after b", of_boxes<other_side>},
      {"aabb", "or for and: one axis on which they overlap suffices", or_for_and},
      {"aabb", "an early return inside the loop: the first axis decides", of_boxes<closed_ends, 1>},
      {"aabb", "the last axis is left out", of_boxes<closed_ends, 2>},
      {"aabb", "only ends of b within a are looked for", of_boxes<ends_within>},
      {"aabb", "only the lower corner of b is looked for", of_boxes<one_end_within>},
      {"aabb", "a tolerance of 1e-6", of_boxes<with_tolerance>},
      {"aabb", "a missing absolute value of the distance of the centres", of_boxes<no_absolute_value>},
      {"aabb", "centres and half-lengths, which round", of_boxes<by_centers>},
      {"sphere-sphere", "an open set for a closed one: < for <=", of_balls<open_balls>},
      {"sphere-sphere", "the radii are squared before they are added", of_balls<squared_apart>},
      {"sphere-sphere", "squared once: the squared distance is compared with the sum of the radii",
       of_balls<squared_once>},
      {"sphere-sphere", "surfaces for balls: one within the other is a miss", of_balls<surfaces>},
      {"sphere-sphere", "only one radius counts", of_balls<one_radius>},
      {"sphere-sphere", "only the larger radius counts", of_balls<larger_radius>},
      {"sphere-sphere", "the last coordinate is left out", balls_in_the_plane},
      {"sphere-sphere", "boxes around the balls are compared", boxes_around_balls},
      {"sphere-sphere", "a tolerance of 1e-6", of_balls<tolerant_balls>},
      {"sphere-sphere", "the usual formula in doubles: squares round, overflow or vanish", of_balls<usual_balls>},
      {"sphere-sphere", "the usual formula with a square root, in doubles", of_balls<rooted>},
  };
  for (Mistake& mistake : ball_and_box_mistakes()) all.push_back(std::move(mistake));
  return all;
}

}  // namespace isect::grade
