// Which features are nearest as one shape is moved, and the methods side by side.

#include <algorithm>
#include <cmath>

#include "lessons/distance/picture.h"
#include "lessons/shared/opinions.h"

namespace isect::lessons::distance_lesson {

using namespace viz;

namespace {

int branch(const Parameters& p) { return static_cast<int>(setup(p).kind()); }

Vec3 middle(const Segment3& x) { return (x.p + x.q) / 2; }
Vec3 middle(const Box3& x) { return (x.lo + x.hi) / 2; }

/// From the middle of a to the point, or to the middle of b, seen along z.
Vec2 place(const Parameters& p) {
  const Setup s = setup(p);
  const Vec3 way = s.is("boxes") ? Vec3(middle(s.boxes[1]) - middle(s.boxes[0])) : Vec3(middle(s.b) - middle(s.a));
  return way.head<2>();
}
Parameters moved(const Parameters& p, const Vec2& to) {
  const Vec2 by = to - place(p);
  const std::string& objects = std::get<std::string>(p.at("objects"));
  std::vector<const char*> names = {"p_b", "q_b"};
  if (objects == "point") names = {"c"};
  if (objects == "boxes") names = {"b_min", "b_max"};
  Parameters there = p;
  for (const char* name : names) {
    const Vec3 at = std::get<Vec3>(p.at(name));
    there[name] = Vec3(at.x() + by.x(), at.y() + by.y(), at.z());
  }
  return there;
}

}  // namespace

const CaseMap& cases() {
  static const CaseMap map = {
      "*x* from the middle of a",
      "*y* from the middle of a",
      {-5, -3},
      {5, 3},
      {"two ends", "end, interior", "two interiors", "an interval", "a rectangle", "they meet"},
      branch,
      place,
      moved,
      "The point, or the middle of b, moves over *x* and *y*, without rotation. Its *z* is fixed.\n"
      "Ends (or corners) and interiors: where the two nearest points lie, if one pair alone is nearest.\n"
      "An interval, a rectangle: so many pairs are nearest.",
      true,
      true};
  return map;
}

namespace {

using nearest_features::Closest;

std::string says(double d) { return "*d* = " + shown(d); }

/// Adds methods that find a distance. They are right up to rounding.
class Distances {
 public:
  explicit Distances(double truth) : truth_(truth), all_(says(truth)) {}
  void add(const char* method, double d) {
    all_.add(method, says(d), std::abs(d - truth_) <= 1e-6 * truth_ + 1e-7);  // a root of what rounding left
  }
  std::vector<Opinion> take() { return all_.take(); }

 private:
  double truth_;
  Opinions all_;
};

std::vector<Opinion> of_point(const Setup& s) {
  Distances all(s.distance());
  const Vec3 d = s.a.q - s.a.p, w = s.c() - s.a.p;
  all.add("clamped *t* (Ericson)", std::sqrt(nearest_features::distance2<double, 3>(s.c(), s.a)));
  all.add("the line, not clamped", d.isZero(0) ? w.norm() : w.cross(d).norm() / d.norm());
  all.add("the nearer end alone", std::min(w.norm(), (s.c() - s.a.q).norm()));
  return all.take();
}

std::vector<Opinion> of_segments(const Setup& s) {
  Distances all(s.distance());
  const auto to = [](const Vec3& end, const Segment3& x) { return nearest_features::distance2<double, 3>(end, x); };
  all.add("clamped, and once more (Ericson)", std::sqrt(nearest_features::distance2<double, 3>(s.a, s.b)));
  all.add("each place clamped once", std::sqrt(nearest_features::distance2_clamped_once<double, 3>(s.a, s.b)));
  all.add("the four ends alone", std::sqrt(std::min({to(s.a.p, s.b), to(s.a.q, s.b), to(s.b.p, s.a), to(s.b.q, s.a)})));
  return all.take();
}

std::vector<Opinion> of_boxes(const Setup& s) {
  Distances all(s.distance());
  double largest = 0;
  for (int axis = 0; axis < 3; ++axis) largest = std::max(largest, s.shared(axis).lo - s.shared(axis).hi);
  all.add("squares of the gaps (Ericson)", std::sqrt(nearest_features::distance2(s.boxes[0], s.boxes[1])));
  all.add("the largest gap alone", largest);
  all.add("from centre to centre", (middle(s.boxes[1]) - middle(s.boxes[0])).norm());
  return all.take();
}

std::vector<Opinion> of_capsules(const Setup& s) {
  const auto words = [](bool near) { return std::string(near ? "near" : "far"); };
  const Capsule3 a = s.capsule(0), b = s.capsule(1);
  Opinions all(words(s.beyond <= 0));
  all.add("sign of the bound, then squares (Ericson)", words(nearest_features::within(a, b, s.clearance)));
  all.add("squares alone", words(nearest_features::within_by_squares(a, b, s.clearance)));
  const double sum = s.r_a * s.r_a + s.r_b * s.r_b + s.clearance * s.clearance;
  all.add("*d*^2 against the sum of squares", words(s.distance2() <= sum));
  return all.take();
}

}  // namespace

std::vector<Opinion> opinions(const Parameters& p) {
  const Setup s = setup(p);
  if (s.is("point")) return of_point(s);
  if (s.is("segments")) return of_segments(s);
  return s.is("boxes") ? of_boxes(s) : of_capsules(s);
}

}  // namespace isect::lessons::distance_lesson
