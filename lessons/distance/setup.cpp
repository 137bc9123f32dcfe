// What the parameters say, and what is true of it: the core decides.

#include "lessons/distance/setup.h"

#include <algorithm>
#include <cmath>

#include <isect/aabb_aabb.h>
#include <isect/point_capsule.h>

namespace isect::lessons::distance_lesson {

using namespace viz;

namespace {

/// Where on the segment the point nearest to c lies, and whether it is c itself.
void locate_point(Setup& s) {
  Record<point_capsule::Event> record;
  s.meet = locate(s.c(), Capsule3{s.a.p, s.a.q, 0}, record) != Location::out;
  for (const auto& event : record.events)
    if (const auto* e = std::get_if<point_capsule::Distance>(&event)) s.pairs = {{e->nearest, Nearest::p}};
}

/// Whether a nearest point of a box is a corner; the box has one nearest point on each axis.
bool is_corner(const Box3& box, const Box3& part) {
  return (part.lo.array() == box.lo.array() || part.lo.array() == box.hi.array()).all();
}

}  // namespace

Vec3 foot(const Vec3& c, const Segment3& segment) {
  Record<nearest_features::PointEvent<double, 3>> record;
  nearest_features::distance2<double, 3>(c, segment, record);
  return std::get<nearest_features::Foot<double, 3>>(record.events.back()).at;
}

Kind Setup::kind() const {
  if (meet) return Kind::meeting;
  if (is("boxes")) {
    if (stretches() == 2) return Kind::rectangle;
    if (stretches() == 1) return Kind::interval;
    const int corners = is_corner(boxes[0], nearest_part(0)) + is_corner(boxes[1], nearest_part(1));
    return corners == 2 ? Kind::ends : corners == 1 ? Kind::end_and_interior : Kind::interiors;
  }
  if (pairs.size() > 1) return Kind::interval;
  const int interiors = (pairs.front().on_a == Nearest::between) + (pairs.front().on_b == Nearest::between);
  return interiors == 0 ? Kind::ends : interiors == 1 ? Kind::end_and_interior : Kind::interiors;
}

bool Setup::parallel() const {
  return sign_of([&]<class W>() -> W {
           const Components<W, 3> n = cross(difference<W, 3>(a.q, a.p), difference<W, 3>(b.q, b.p));
           return dot(n, n);
         }) == 0;
}

double Setup::distance2() const {
  return is("boxes") ? nearest_features::distance2(boxes[0], boxes[1]) : nearest_features::rounded_distance2(a, b);
}
double Setup::distance() const { return std::sqrt(distance2()); }

std::pair<Vec3, Vec3> Setup::points(const Pair& pair) const {
  const bool inside_a = pair.on_a == Nearest::between, inside_b = pair.on_b == Nearest::between;
  if (inside_a && inside_b) {
    Record<nearest_features::SegmentEvent<double, 3>> record;
    nearest_features::distance2<double, 3>(a, b, record);
    const auto& found = std::get<nearest_features::Closest<double, 3>>(record.events.back());
    return {found.on_a, found.on_b};
  }
  const Vec3 of_a = pair.on_a == Nearest::q ? a.q : a.p, of_b = pair.on_b == Nearest::q ? b.q : b.p;
  return {inside_a ? foot(of_b, a) : of_a, inside_b ? foot(of_a, b) : of_b};
}

Interval<double> Setup::shared(int axis) const {
  return {std::max(boxes[0].lo[axis], boxes[1].lo[axis]), std::min(boxes[0].hi[axis], boxes[1].hi[axis])};
}
int Setup::stretches() const {
  int count = 0;
  for (int axis = 0; axis < 3; ++axis) count += shared(axis).lo < shared(axis).hi;
  return count;
}
Box3 Setup::nearest_part(int which) const {
  Box3 part = boxes[static_cast<std::size_t>(which)];
  for (int axis = 0; axis < 3; ++axis) {
    const Interval<double> common = shared(axis);
    if (common.lo <= common.hi)
      part.lo[axis] = common.lo, part.hi[axis] = common.hi;
    else  // the ends beside the gap are common.hi and common.lo
      part.lo[axis] = part.hi[axis] = part.hi[axis] == common.hi ? common.hi : common.lo;
  }
  return part;
}
bool Setup::flat() const {
  return (boxes[0].lo.array() == boxes[0].hi.array()).any() || (boxes[1].lo.array() == boxes[1].hi.array()).any();
}

Setup setup(const Parameters& p) {
  const auto at = [&](const char* name) { return std::get<Vec3>(p.at(name)); };
  const auto number = [&](const char* name) { return std::get<double>(p.at(name)); };
  Setup s;
  s.objects = std::get<std::string>(p.at("objects"));
  s.boxes = {Box3{at("a_min"), at("a_max")}, Box3{at("b_min"), at("b_max")}};
  s.a = {at("p_a"), at("q_a")}, s.b = {at("p_b"), at("q_b")};
  if (s.is("boxes")) {
    s.meet = intersects(s.boxes[0], s.boxes[1]);
    return s;
  }
  if (s.is("point")) {
    s.b = {at("c"), at("c")};
    locate_point(s);
    return s;
  }
  s.pairs = nearest_features::nearest_pairs(s.a, s.b);
  if (s.is("capsules")) {
    s.r_a = number("r_a"), s.r_b = number("r_b"), s.clearance = number("clearance");
    s.meet = intersects(s.capsule(0), s.capsule(1));
    s.beyond = nearest_features::order(s.capsule(0), s.capsule(1), s.clearance);
  } else {
    s.meet = nearest_features::order(s.capsule(0), s.capsule(1), 0) <= 0;
  }
  return s;
}

}  // namespace isect::lessons::distance_lesson
