// Hulls, normals and bounding volumes of points.

#include <Eigen/Geometry>
#include <numbers>

#include "tests/cases/shapes.h"
#include "tests/core/area_rings.h"
#include "tests/core/clouds.h"
#include "tests/core/hull_oracle.h"

namespace isect::cases {

namespace {

template <class S>
Case hull_of(const Ring<S, 2>& points) {
  return {{{"points", json<S, 2>(points)}}, {{"hull", json<S, 2>(oracle::hull(points))}}, is_f32<S>};
}

/// Computes normal and area from twice the area vector; there is no normal where that is 0.
template <class S>
Case normal_of(const Ring<S, 3>& ring) {
  const auto twice = tests::area_rings::truth(ring);
  const Rational length = tests::area_rings::root(oracle::dot(twice, twice));
  Json normal;
  if (length != 0)
    for (const Rational& x : twice) normal.push_back(nearest(Rational(x / length)));
  return {
      {{"polygon", json<S, 3>(ring)}}, {{"normal", normal}, {"area", json(nearest(Rational(length / 2)))}}, is_f32<S>};
}

/// Expects the aligned box, which is unique. Other volumes are checked by themselves: they must hold every point, and
/// be the least about their center and axes.
template <class S, int N>
Case fits(const std::vector<Point<S, N>>& points) {
  Point<S, N> lo = points[0], hi = lo;
  for (const Point<S, N>& p : points) lo = lo.cwiseMin(p), hi = hi.cwiseMax(p);
  return {{{"points", json<S, N>(points)}, {"volume", "aabb"}},
          {{"lo", json<S, N>(lo)}, {"hi", json<S, N>(hi)}},
          is_f32<S>};
}

/// The corners of a turned brick, and points within: its volume bounds that of the tightest box.
std::optional<Case> brick(Random& random) {
  const Vector<double, 3> half = random.in_box<3>(0.4) + Vector<double, 3>::Constant(0.6), axis = random.heading<3>();
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(random.uniform(0, std::numbers::pi), axis).toRotationMatrix();
  std::vector<Point<double, 3>> points;
  for (int corner = 0; corner < 8; ++corner) {
    const Vector<double, 3> sides(corner & 1 ? -1 : 1, corner & 2 ? -1 : 1, corner & 4 ? -1 : 1);
    points.push_back(turn * half.cwiseProduct(sides));
  }
  for (int i = 0; i < 4; ++i) points.push_back(turn * half.cwiseProduct(random.in_box<3>(0.9)));
  Case c = fits(points);
  c.expected["volume_upper_bound"] = 8 * half.prod(), c.expected["known_tight_obb"] = true;
  return c;
}

}  // namespace

CaseFile convex_hull2d() {
  CaseFile file("convex_hull2d");
  const auto add = [&](const char* note, Ring<double, 2> points) { file.add(note, hull_of(points)); };
  add("points within edges go", {{0, 0}, {2, 0}, {1, 0}, {2, 2}, {0, 2}, {1, 1}});
  add("a line", {{0, 0}, {2, 2}, {1, 1}, {3, 3}});
  add("a line as typed, not as rounded", {{.1, .3}, {.2, .6}, {.3, .9}, {0, 0}});
  add("all equal", {{.1, .7}, {.1, .7}, {.1, .7}});
  add("zeros of either sign", {{0, -0.}, {-0., 0}, {1, 0}, {0, 1}});
  add("the smallest numbers there are", {{0, 0}, {least, 0}, {0, least}, {least, least}});
  add("the largest numbers there are", {{-most, -most}, {most, most}, {0, 0}, {most, -most}, {0, least}});
  add("a small number decides beside a large one", {{0, 0}, {1e300, 0}, {5e299, -1e-300}});
  for (const auto& [name, kind] : {std::pair("near a line", tests::clouds::Cloud::near_line),
                                   std::pair("on a circle", tests::clouds::Cloud::circle),
                                   std::pair("within 2 ulp of a point", tests::clouds::Cloud::cluster),
                                   std::pair("on a line but for rounding", tests::clouds::Cloud::line)}) {
    const auto draw = [kind = kind]<class S>(Random& r) {
      return hull_of(tests::clouds::cloud<S>(r, kind, Numbers::decimal, 10));
    };
    file.family(name, 3, [&](Random& r) { return draw.template operator()<double>(r); });
    file.family(std::string(name) + ", in floats", 2, [&](Random& r) { return draw.template operator()<float>(r); });
  }
  by_numbers(file, 2, [&]<class S>(Random& random, Numbers numbers) -> std::optional<Case> {
    const Ring<S, 2> points = tests::clouds::cloud<S>(random, tests::clouds::Cloud::family, numbers, 9);
    return finite(points) ? std::optional(hull_of(points)) : std::nullopt;
  });
  return file;
}

CaseFile polygon_normal() {
  CaseFile file("polygon_normal");
  const auto add = [&](const char* note, Ring<double, 3> ring) { file.add(note, normal_of(ring)); };
  add("the first three vertices on a line", {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}});
  add("the first three nearly on a line", {{0, 0, 0}, {1, 0, 1e-7}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}});
  add("no area: a line", {{0, 0, 0}, {1, 1, 1}, {3, 3, 3}});
  add("a line as typed, not as rounded", {{.1, .1, .1}, {.2, .2, .2}, {.3, .3, .30000000000000004}});
  add("no area: there and back", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 0, 0}});
  add("no area: a bow-tie", {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}});
  add("two vertices", {{0, 0, 0}, {1, 2, 3}});
  add("no vertices", {});
  add("repeated vertices", {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  add("squares vanish", {{0, 0, 0}, {1e-300, 0, 0}, {0, 1e-300, 0}});
  add("squares vanish in floats", {{0, 0, 0}, {0x1p-76, 0, 0}, {0, 0x1p-76, 0}});
  add("squares overflow", {{0, 0, 0}, {1e300, 0, 0}, {0, 1e300, 0}});
  add("the smallest numbers there are", {{0, 0, 0}, {least, 0, 0}, {0, least, 0}});
  add("a small quad far away",
      {{1e4, 1e4, 1e4}, {1e4 + .1, 1e4, 1e4 + .05}, {1e4 + .1, 1e4 + .1, 1e4 + .1}, {1e4, 1e4 + .1, 1e4 + .05}});
  by_numbers(file, 4, [&]<class S>(Random& random, Numbers numbers) -> std::optional<Case> {
    const Ring<S, 3> ring = tests::area_rings::random_ring<S, 3>(random, numbers);
    return finite(ring) ? std::optional(normal_of(ring)) : std::nullopt;
  });
  return file;
}

CaseFile bounding_volume_fit() {
  CaseFile file("bounding_volume_fit");
  using P = Point<double, 3>;
  const auto add = [&](const char* note, std::vector<P> points) { file.add(note, fits(points)); };
  add("one point", {P{.1, .2, .3}});
  add("one point, many times", {P{.1, .2, .3}, P{.1, .2, .3}, P{.1, .2, .3}});
  add("two points", {P{.1, .2, .3}, P{.3, .2, .1}});
  add("a line as typed, not as rounded", {P{.1, .1, .1}, P{.2, .2, .2}, P{.7, .7, .7}});
  add("a square: principal axes are open", {P{1, 1, 0}, P{-1, 1, 0}, P{-1, -1, 0}, P{1, -1, 0}});
  add("zeros of either sign", {P{0, -0., 0}, P{-0., 0, -0.}});
  add("the smallest numbers there are", {P{0, 0, 0}, P{least, 0, 0}, P{0, least, 2 * least}});
  add("1e-300 beside 1e300", {P{1e-300, 1e-300, 0}, P{1e300, 0, 1e-300}, P{0, 1e300, 0}});
  file.family("a turned brick", 4, brick);
  by_numbers(file, 3, [&]<class S>(Random& random, Numbers numbers) -> std::optional<Case> {
    const auto draw = [&]<int N>() -> std::optional<Case> {
      const auto points = tests::clouds::cloud<S, N>(random, numbers);
      return finite(points) ? std::optional(fits(points)) : std::nullopt;
    };
    return random.one_in(3) ? draw.template operator()<2>() : draw.template operator()<3>();
  });
  return file;
}

}  // namespace isect::cases
