#include "app/scene/contact.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <functional>
#include <optional>

#include "app/scene/shapes.h"

namespace isect::program::scene {
namespace {

using viz::Role;
using viz::Vec3;

/// All points at most `radius` from a convex core, for which the nearest point to any other point is known.
struct Rounded {
  std::function<Vec3(const Vec3&)> nearest;
  double radius = 0;
};

Rounded around_point(const Vec3& p, double radius) {
  return {[p](const Vec3&) { return p; }, radius};
}

Rounded around_segment(const Vec3& p, const Vec3& q, double radius) {
  return {[p, q](const Vec3& x) -> Vec3 {
            const Vec3 d = q - p;
            const double length2 = d.squaredNorm();
            return length2 > 0 ? Vec3(p + std::clamp((x - p).dot(d) / length2, 0.0, 1.0) * d) : p;
          },
          radius};
}

std::optional<Rounded> rounded(const NamedValues& s, const Object& o) {
  switch (o.type) {
    case Type::point:
      return around_point(s.point(o, "at"), 0);
    case Type::sphere:
      return around_point(s.point(o, "center"), s.number(o, "radius"));
    case Type::segment:
      return around_segment(s.point(o, "from"), s.point(o, "to"), 0);
    case Type::capsule:
      return around_segment(s.point(o, "p"), s.point(o, "q"), s.number(o, "r"));
    case Type::box:
      return Rounded{[lo = s.point(o, "lo"), hi = s.point(o, "hi")](const Vec3& x) -> Vec3 {
        return x.cwiseMax(lo).cwiseMin(hi);
      }};
    case Type::obb:
      return Rounded{[box = made<Obb<double, 3>>(s, o)](const Vec3& x) -> Vec3 {
        const Vec3 local = box.axes.transpose() * (x - box.center);
        return box.center + box.axes * local.cwiseMax(-box.half).cwiseMin(box.half);
      }};
    default:
      return {};
  }
}

/// Finds the nearest points of both cores, by projecting alternately onto them. Returns a common point, rounded.
Vec3 common_point(const Rounded& a, const Rounded& b) {
  constexpr int enough = 500;
  Vec3 p = a.nearest(Vec3::Zero()), q = b.nearest(p);
  for (int i = 0; i < enough; ++i) {
    const Vec3 before = p;
    p = a.nearest(q), q = b.nearest(p);
    if (p == before) break;
  }
  const Vec3 way = q - p;
  return way.isZero(0) ? p : Vec3(p + a.radius * way.normalized());
}

/// Returns what two boxes share, if that is flat.
std::vector<viz::Item> shared(const NamedValues& s, const Object& a, const Object& b) {
  const Vec3 lo = s.point(a, "lo").cwiseMax(s.point(b, "lo")), hi = s.point(a, "hi").cwiseMin(s.point(b, "hi"));
  std::vector<int> wide;
  for (int i = 0; i < 3; ++i)
    if (lo[i] < hi[i]) wide.push_back(i);
  if (wide.empty()) return {viz::Dot{lo, viz::Mark::diamond, Role::hit}};
  if (wide.size() == 1) return {viz::Chain{{lo, hi}, false, Role::hit, viz::Pen::thick}};
  if (wide.size() == 3) return {};
  Vec3 second = lo, last = lo;
  second[wide[0]] = hi[wide[0]], last[wide[1]] = hi[wide[1]];
  return {viz::Region{.rings = {{lo, second, hi, last}}, .role = Role::hit, .pen = viz::Pen::thick}};
}

}  // namespace

std::vector<viz::Item> contact(const NamedValues& s, const Object& a, const Object& b, const Answer& answer) {
  if (!answer.relation || (answer.relation != Relation::touching && !answer.tangent)) return {};
  if (a.type == Type::box && b.type == Type::box) return shared(s, a, b);
  const std::optional<Rounded> one = rounded(s, a), other = rounded(s, b);
  if (!one || !other) return {};
  return {viz::Dot{common_point(*one, *other), viz::Mark::diamond, Role::hit}};
}

std::optional<Vec3> nearest_point(const NamedValues& s, const Object& o, const Vec3& p) {
  const std::optional<Rounded> shape = rounded(s, o);
  if (!shape) return {};
  const Vec3 q = shape->nearest(p), way = p - q;
  const double far = way.norm();
  return far <= shape->radius ? p : Vec3(q + shape->radius / far * way);
}

}  // namespace isect::program::scene
